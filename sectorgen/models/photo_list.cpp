#include "sectorgen/models/photo_list.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "city_db/facade_layout.hpp"
#include "city_db/issues.hpp"
#include "sectorgen/geo/csv_fields.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {
namespace {

std::array<double, 8> corners_of(const std::string& text, const std::string& where) {
  std::array<double, 8> out{};
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string word; in >> word; ++count) {
    const auto value = parse_number(word);
    if (!value || count >= out.size()) throw CityError(where + "corners: expected eight numbers: x y x y x y x y", 4);
    out[count] = *value;
  }
  if (count != out.size()) throw CityError(where + "corners: expected eight numbers: x y x y x y x y", 4);
  // Bottom left, bottom right, top right, top left turn one way, or the picture would be folded. y goes down.
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = [&](std::size_t k) { return std::pair(out[2 * (k % 4)], out[2 * (k % 4) + 1]); };
    const auto [ax, ay] = at(i);
    const auto [bx, by] = at(i + 1);
    const auto [cx, cy] = at(i + 2);
    if ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) >= 0)
      throw CityError(
          where + "corners: expected bottom left, bottom right, top right, top left, in pixels from the top left", 4);
  }
  return out;
}

}  // namespace

std::vector<FacadePhoto> read_photo_list(const std::filesystem::path& list) {
  std::ifstream in(list);
  if (!in) throw CityError(list.string() + ": cannot be opened", 4);
  std::vector<FacadePhoto> photos;
  std::map<std::string, std::size_t> columns;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
    const std::string where = list.string() + ", line " + std::to_string(number) + ": ";
    const auto fields = csv_fields(line);
    if (!fields) throw CityError(where + "its quotation marks do not match", 4);
    const auto& cells = *fields;
    if (columns.empty()) {
      for (std::size_t i = 0; i < cells.size(); ++i) columns[lower_case(cells[i])] = i;
      for (const auto& [name, at] : columns)
        if (name != "house" && name != "file" && name != "heading" && name != "corners" && name != "bays" &&
            name != "floors")
          throw CityError(
              where + "no column is called " + name + "; there are house, file, heading, corners, bays and floors", 4);
      if (!columns.contains("house") || !columns.contains("file"))
        throw CityError(where + "expected the names of the columns, house and file among them", 4);
      continue;
    }
    const auto cell = [&](const char* name) -> std::string {
      const auto at = columns.find(name);
      return at == columns.end() || at->second >= cells.size() ? "" : cells[at->second];
    };
    const auto count = [&](const char* name, int most) -> std::optional<int> {
      if (cell(name).empty()) return std::nullopt;
      const auto value = parse_number(cell(name));
      if (!value || *value < 1 || *value > most || *value != static_cast<int>(*value))
        throw CityError(where + name + ": " + cell(name) + " is no number from 1 to " + std::to_string(most), 4);
      return static_cast<int>(*value);
    };
    FacadePhoto photo;
    photo.house = cell("house");
    if (photo.house.empty() || cell("file").empty()) throw CityError(where + "house or file is empty", 4);
    photo.file = list.parent_path() / cell("file");
    if (!std::filesystem::exists(photo.file)) throw CityError(where + photo.file.string() + ": no such file", 4);
    if (!cell("heading").empty()) {
      photo.heading_deg = parse_number(cell("heading"));
      if (!photo.heading_deg) throw CityError(where + "heading: " + cell("heading") + " is no number of degrees", 4);
    }
    if (!cell("corners").empty()) photo.corners = corners_of(cell("corners"), where);
    photo.bays = count("bays", kMostBays);
    photo.floors = count("floors", kMostFloors);
    photo.source_id = list.filename().string() + "#" + std::to_string(number);
    photos.push_back(std::move(photo));
  }
  if (photos.empty()) throw CityError(list.string() + ": expected a table of photos, found none", 4);
  return photos;
}

}  // namespace vicus
