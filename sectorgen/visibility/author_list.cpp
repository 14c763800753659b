#include "sectorgen/visibility/author_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/csv_fields.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_on_earth(const LatLon& p) { return std::abs(p.lat_deg) <= 90 && std::abs(p.lon_deg) <= 180; }

/// Empty: the entry is read; else what is wrong.
std::string read_csv(const std::string& line, AuthorEntry& entry) {
  auto fields = csv_fields(line);
  if (!fields) return "its quotation marks do not match";
  std::size_t used = 1;
  const auto lat = number_in(fields->front());
  const auto lon = fields->size() > 1 ? number_in((*fields)[1]) : std::nullopt;
  if (lat && lon) {
    entry.at = LatLon{*lat, *lon};
    used = 2;
  } else {
    entry.place = fields->front();
  }
  if (fields->size() > used + 1) return "it has too many fields";
  if (fields->size() == used + 1 && !fields->back().empty()) {
    const auto vicinity = number_in(fields->back());
    if (!vicinity) return "'" + fields->back() + "' is no number of metres";
    entry.vicinity_m = *vicinity;
  }
  return "";
}

std::string read_json(const std::string& line, AuthorEntry& entry) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return "it is no JSON object";
  const auto number = [&](const char* key) {
    const auto at = json.find(key);
    return at != json.end() && at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
  };
  if (const auto place = json.find("place"); place != json.end() && place->is_string())
    entry.place = place->get<std::string>();
  if (number("lat") && number("lon")) entry.at = LatLon{*number("lat"), *number("lon")};
  if (json.contains("vicinity_m")) {
    if (!number("vicinity_m")) return "its vicinity_m is no number";
    entry.vicinity_m = *number("vicinity_m");
  }
  return entry.place.empty() == !entry.at ? "it needs either place, or lat and lon" : "";
}

std::string read_line(const std::string& line, AuthorEntry& entry) {
  const auto wrong = line[0] == '{' ? read_json(line, entry) : read_csv(line, entry);
  if (!wrong.empty()) return wrong;
  if (entry.place.empty() && !entry.at) return "it names no place";
  if (entry.at && !is_on_earth(*entry.at)) return "it is no place on earth: expected LAT,LON in degrees";
  if (!(entry.vicinity_m >= 0 && entry.vicinity_m <= kMostVicinity_m))
    return "its vicinity is not between 0 and " + std::to_string(static_cast<int>(kMostVicinity_m)) + " m";
  return "";
}

bool equal_ignoring_case(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

template <class Matches>
std::vector<Sector*> sectors_where(City& city, Matches matches) {
  std::vector<Sector*> found;
  for (auto& s : city.sectors)
    if (matches(s)) found.push_back(&s);
  return found;
}

std::vector<Sector*> sectors_named(City& city, const std::string& place) {
  auto found = sectors_where(city, [&](const Sector& s) { return s.id == place; });
  const auto bears = [](const Sector& s, const auto& is_it) {
    return is_it(s.name) || std::any_of(s.names.begin(), s.names.end(), is_it);
  };
  if (found.empty())
    found = sectors_where(city, [&](const Sector& s) { return bears(s, [&](auto& name) { return name == place; }); });
  if (found.empty())
    found = sectors_where(
        city, [&](const Sector& s) { return bears(s, [&](auto& name) { return equal_ignoring_case(name, place); }); });
  return found;
}

double distance_mm(PlanPoint p, PlanPoint a, PlanPoint b) {
  const double length2 = static_cast<double>(distance2(a, b));
  const double along = length2 > 0 ? std::clamp(static_cast<double>(dot(a, b, p)) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - (a.x + along * (double(b.x) - a.x)), p.y - (a.y + along * (double(b.y) - a.y)));
}

/// The sector whose ground holds the point, on a common edge the first; for a point in a house the nearest one within
/// kNearPlace_m.
std::vector<Sector*> sectors_at(City& city, PlanPoint at) {
  for (auto& s : city.sectors)
    if (box_of(s.ground).contains(at) && locate(s.ground, at) != Side::outside) return {&s};
  Sector* nearest = nullptr;
  double least_mm = kNearPlace_m * kMmPerMetre;
  const auto look_at = [&](Sector& s, const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (const double mm = distance_mm(at, ring[i], ring[(i + 1) % ring.size()]); mm < least_mm) {
        least_mm = mm;
        nearest = &s;
      }
  };
  for (auto& s : city.sectors) {
    look_at(s, s.ground.outer);
    for (const auto& hole : s.ground.holes) look_at(s, hole);
  }
  return nearest ? std::vector<Sector*>{nearest} : std::vector<Sector*>{};
}

}  // namespace

std::vector<AuthorEntry> read_author_list(const std::filesystem::path& path, std::vector<Issue>& issues) {
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw CityError("cannot read the list of important sectors " + path.string() + ": is it there, may it be read?");
  std::vector<AuthorEntry> list;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // a byte order mark, as spreadsheets write
    line = trimmed(line);
    if (line.empty() || line[0] == '#' || (number == 1 && equal_ignoring_case(line.substr(0, 5), "place"))) continue;
    AuthorEntry entry;
    entry.source_id = path.filename().string() + "#" + std::to_string(number);
    if (const auto wrong = read_line(line, entry); !wrong.empty())
      issues.push_back({IssueCode::unreadable_feature,
                        "line " + std::to_string(number) + " of the list of important sectors was left out: " + wrong,
                        entry.source_id,
                        {}});
    else
      list.push_back(std::move(entry));
  }
  return list;
}

void mark_author_list(City& city, const std::vector<AuthorEntry>& list, const PlanOf& plan_of,
                      std::vector<Issue>& issues) {
  for (const auto& entry : list) {
    const auto at = entry.at ? plan_of(*entry.at) : std::nullopt;
    const auto found = at         ? sectors_at(city, *at)
                       : entry.at ? std::vector<Sector*>{}
                                  : sectors_named(city, entry.place);
    if (found.empty())
      issues.push_back(
          {IssueCode::unknown_place,
           (entry.at ? "the place " + std::to_string(entry.at->lat_deg) + "," + std::to_string(entry.at->lon_deg) +
                           " lies in no sector, and in no house beside one"
                     : "no sector has the id or name '" + entry.place + "'") +
               ", so nothing was marked important; see the ids and names in the map of vicus export "
               "--format svg --labels",
           entry.source_id, at.value_or(PlanPoint{})});
    for (Sector* sector : found) {
      sector->importance = entry.vicinity_m > 0 ? Importance::author : Importance::none;
      sector->vicinity_m = entry.vicinity_m;
    }
  }
}

}  // namespace vicus
