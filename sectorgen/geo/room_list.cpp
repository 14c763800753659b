#include "sectorgen/geo/room_list.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <set>

#include "sectorgen/geo/csv_fields.hpp"
#include "sectorgen/geo/plan_frame.hpp"
#include "sectorgen/geo/repair.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {
namespace {

const std::set<std::string> kColumns{"house", "outline", "doors", "name", "height"};

/// Lists of places of a WKT geometry: one for each innermost pair of brackets. nullopt: it is none of `type`.
std::optional<std::vector<std::vector<LatLon>>> places_of(const std::string& wkt, const std::string& type) {
  const auto open = wkt.find('(');
  if (open == wkt.npos || lower_case(trimmed(wkt.substr(0, open))) != type) return std::nullopt;
  std::vector<std::vector<LatLon>> lists;
  std::vector<LatLon> list;
  std::vector<double> numbers;
  const auto end_place = [&] {
    if (numbers.size() < 2 || numbers.size() > 3) return numbers.empty();
    list.push_back({numbers[1], numbers[0]});
    numbers.clear();
    return true;
  };
  int depth = 0;
  for (const char* at = wkt.data() + open; at < wkt.data() + wkt.size();) {
    if (*at == '(') {
      ++depth, ++at;
    } else if (*at == ',' || *at == ')') {
      if (depth == 0 || !end_place()) return std::nullopt;
      if (*at == ')' && --depth >= 0 && !list.empty()) lists.push_back(std::move(list)), list.clear();
      ++at;
    } else if (*at == ' ') {
      ++at;
    } else {
      double value = 0;
      const auto [next, error] = std::from_chars(at, wkt.data() + wkt.size(), value);
      if (error != std::errc() || !(std::abs(value) <= 180)) return std::nullopt;
      numbers.push_back(value);
      at = next;
    }
  }
  return depth == 0 && !lists.empty() ? std::optional(lists) : std::nullopt;
}

class RoomReader {
 public:
  RoomReader(const PlanFrame& frame, std::string where) : frame_(frame), where_(std::move(where)) {}

  Polygon outline(const std::string& wkt) const {
    if (wkt.empty()) return {};
    const auto lists = places_of(wkt, "polygon");
    if (!lists) throw CityError(where_ + "outline: expected WKT, POLYGON ((LON LAT, LON LAT, ...))", 4);
    std::vector<Ring> rings;
    for (const auto& list : *lists) {
      Ring ring = placed(list);
      if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      rings.push_back(std::move(ring));
    }
    auto repaired = repaired_polygons(std::move(rings));
    if (repaired.polygons.size() != 1) throw CityError(where_ + "outline: its rings make no single polygon", 4);
    return std::move(repaired.polygons.front());
  }

  std::vector<PlanPoint> doors(const std::string& wkt) const {
    std::vector<PlanPoint> doors;
    if (wkt.empty()) return doors;
    auto lists = places_of(wkt, "point");
    if (!lists) lists = places_of(wkt, "multipoint");
    if (!lists) throw CityError(where_ + "doors: expected WKT, POINT (LON LAT) or MULTIPOINT ((LON LAT), ...)", 4);
    for (const auto& list : *lists)
      for (const PlanPoint p : placed(list)) doors.push_back(p);
    return doors;
  }

  double height(const std::string& text) const {
    if (text.empty()) return 0;
    const auto height_m = parse_metres(text);
    if (!height_m || !(*height_m > 0)) throw CityError(where_ + "height: " + text + " is no height in metres", 4);
    return *height_m;
  }

 private:
  std::vector<PlanPoint> placed(const std::vector<LatLon>& places) const {
    std::vector<PlanPoint> out;
    for (const LatLon& place : places) {
      const auto at = frame_.plan_from_latlon(place);
      if (!at) throw CityError(where_ + "a place is too far from the city: is it longitude, then latitude?", 4);
      out.push_back(*at);
    }
    return out;
  }

  const PlanFrame& frame_;
  std::string where_;
};

}  // namespace

void read_room_list(const std::filesystem::path& list, SourceMap& map) {
  std::ifstream in(list);
  if (!in || std::filesystem::is_directory(list)) throw CityError(list.string() + ": cannot be opened", 4);
  const PlanFrame frame(map.origin);
  std::vector<std::string> columns;
  std::size_t number = 0, count = 0;
  for (std::string line; std::getline(in, line);) {
    if (++number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // as spreadsheets write
    if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
    const std::string where = list.string() + ", line " + std::to_string(number) + ": ";
    auto cells = csv_fields(line);
    if (!cells) throw CityError(where + "its quotation marks do not match", 4);
    if (columns.empty()) {
      for (const auto& cell : *cells) {
        columns.push_back(lower_case(cell));
        if (!kColumns.contains(columns.back()))
          throw CityError(where + "no column is called " + cell + "; there are house, outline, doors, name and height",
                          4);
      }
      continue;
    }
    const auto cell = [&](const char* name) -> std::string {
      const auto at = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
      return at < cells->size() ? (*cells)[at] : "";
    };
    const RoomReader reader(frame, where);
    Room room;
    room.source_id = list.filename().string() + "#" + std::to_string(number);
    room.name = cell("name");
    room.house = cell("house");
    room.area = reader.outline(cell("outline"));
    room.doors = reader.doors(cell("doors"));
    room.height_m = reader.height(cell("height"));
    if (room.house.empty() && room.area.outer.empty()) throw CityError(where + "expected a house or an outline", 4);
    map.rooms.push_back(std::move(room));
    ++count;
  }
  if (count == 0) throw CityError(list.string() + ": expected a table of rooms, found none", 4);
}

}  // namespace vicus
