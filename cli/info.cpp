#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>

#include "city_db/store.hpp"
#include "cli/command.hpp"

namespace vicus::cli {
namespace {

using Counts = std::map<std::string, std::size_t>;

template <class Record, class KindOf>
Counts count_by(const std::vector<Record>& list, KindOf kind_of) {
  Counts counts;
  for (const auto& record : list) ++counts[kind_of(record)];
  return counts;
}

/// One list of the city: its size, and its kinds where it has some.
struct Listing {
  std::string name;
  std::size_t total = 0;
  Counts kinds;
};

std::vector<Listing> listings_of(const City& city) {
  const auto kind = [](const auto& record) { return std::string(name_of(record.kind)); };
  const auto plain_kind = [](const auto& record) { return record.kind; };
  std::vector<Sector> important;
  std::copy_if(city.sectors.begin(), city.sectors.end(), std::back_inserter(important),
               [](const Sector& s) { return s.importance != Importance::none; });
  return {{"sectors", city.sectors.size(), count_by(city.sectors, kind)},
          {"important", important.size(),
           count_by(important, [](const Sector& s) { return std::string(name_of(s.importance)); })},
          {"gates", city.gates.size(), count_by(city.gates, kind)},
          {"borders", city.borders.size(), count_by(city.borders, kind)},
          {"buildings", city.buildings.size(),
           count_by(city.buildings, [](const Building& b) { return std::string(name_of(b.height_source)); })},
          {"obstacles", city.obstacles.size(), count_by(city.obstacles, kind)},
          {"streets", city.streets.size(), count_by(city.streets, plain_kind)},
          {"objects", city.objects.size(), count_by(city.objects, plain_kind)},
          {"viewpoints", city.viewpoints.size(), count_by(city.viewpoints, plain_kind)},
          {"interiors", city.interiors.size(), {}},
          {"door sides", city.doors.size(), {}},
          {"visible", city.visible.size(),
           count_by(city.visible, [](const Visible& v) { return std::string(name_of(v.reason)); })},
          {"unresolved",
           static_cast<std::size_t>(
               std::count_if(city.visible.begin(), city.visible.end(), [](const Visible& v) { return !v.is_proven; })),
           {}},
          {"terrain nodes", city.terrain.height_mm.size(), {}},
          {"issues", city.issues.size(),
           count_by(city.issues, [](const Issue& i) { return std::string(name_of(i.code)); })}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Keys of meta that hold a list, one item per line (FORMAT.md).
bool is_list_key(const std::string& key) { return key == "sources" || key == "licences"; }

nlohmann::json object_from(const std::filesystem::path& path, const City& city,
                           const std::vector<ArtefactTotal>& totals) {
  nlohmann::json object = {{"path", path.string()},
                           {"file_bytes", std::filesystem::file_size(path)},
                           {"origin", {{"lat", city.origin.lat_deg}, {"lon", city.origin.lon_deg}}},
                           {"artefacts", nlohmann::json::array()}};
  for (const auto& listing : listings_of(city)) {
    object["counts"][listing.name] = listing.total;
    object["kinds"][listing.name] = listing.kinds;
  }
  for (const auto& [media_type, coding, count, bytes] : totals)
    object["artefacts"].push_back({{"media_type", media_type}, {"coding", coding}, {"count", count}, {"bytes", bytes}});
  object["meta"] = nlohmann::json::object();
  for (const auto& [key, value] : city.meta) {
    auto& shown = object["meta"][key];
    if (is_list_key(key)) {
      shown = lines_of(value);
    } else {
      shown = key == "options" ? nlohmann::json::parse(value, nullptr, false) : nlohmann::json(value);
      if (shown.is_discarded()) shown = value;
    }
  }
  return object;
}

std::string bytes_text(std::uint64_t bytes) {
  char text[32];
  if (bytes < 10'000)
    std::snprintf(text, sizeof text, "%llu B", static_cast<unsigned long long>(bytes));
  else if (bytes < 10'000'000)
    std::snprintf(text, sizeof text, "%.1f kB", static_cast<double>(bytes) / 1e3);
  else
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
  return text;
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text + ' ';
}

constexpr std::size_t kLabelWidth = 15;

std::string text_from(const std::filesystem::path& path, const City& city, const std::vector<ArtefactTotal>& totals) {
  std::ostringstream out;
  out << padded(path.string() + ":", kLabelWidth) << bytes_text(std::filesystem::file_size(path)) << '\n';
  char origin[64];
  std::snprintf(origin, sizeof origin, "%.7f, %.7f", city.origin.lat_deg, city.origin.lon_deg);
  out << padded("origin", kLabelWidth) << origin << '\n';
  for (const auto& [key, value] : city.meta)
    for (const auto& line : lines_of(value)) out << padded(key, kLabelWidth) << line << '\n';
  for (const auto& listing : listings_of(city)) {
    out << padded(listing.name, kLabelWidth) << listing.total;
    const char* separator = " (";
    for (const auto& [kind, count] : listing.kinds) {
      out << separator << count << ' ' << kind;
      separator = ", ";
    }
    out << (listing.kinds.empty() ? "\n" : ")\n");
  }
  for (const auto& [media_type, coding, count, bytes] : totals)
    out << padded("artefacts", kLabelWidth) << count << ' ' << media_type << ", " << coding << ", " << bytes_text(bytes)
        << '\n';
  return out.str();
}

}  // namespace

void add_info(CLI::App& app, Context& context) {
  auto* command = new_command(app, context, "info", "what a city file holds: counts, sources, licences, sizes",
                              "vicus info city.gpkg");
  const auto path = std::make_shared<std::string>();
  command->add_option("CITY", *path, "a city made by vicus build")->required();
  command->callback([&context, path] {
    const City city = read_city(*path);
    const auto totals = CityReader(*path).artefact_totals();
    print_result(context, text_from(*path, city, totals), object_from(*path, city, totals));
  });
}

}  // namespace vicus::cli
