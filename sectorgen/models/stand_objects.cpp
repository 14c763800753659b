#include "sectorgen/models/stand_objects.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

#include "city_db/boxes.hpp"
#include "city_db/segment.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"

namespace vicus {
namespace {

constexpr double kSignReach_m = 12, kSignHeight_m = 3.15, kSignOut_m = 0.06, kSignApart_m = 4.5, kLeastTop_m = 2.9;
constexpr double kRideStep_m = 3, kLeastRide_m = 60;

bool has_sign(const StandaloneObject& object) {
  static const std::set<std::string> kKinds{"shop",     "cafe",        "restaurant", "bar",       "pub",     "bank",
                                            "pharmacy", "museum",      "hotel",      "gallery",   "theatre", "cinema",
                                            "library",  "post_office", "fast_food",  "attraction"};
  return !object.name.empty() && kKinds.contains(object.kind);
}

bool has_front(const StandaloneObject& object) {
  static const std::set<std::string> kKinds{"bench", "clock", "post_box", "waste_basket", "statue", "memorial"};
  return kKinds.contains(object.kind);
}

double heading_of(double east, double north) {
  const double degrees = std::atan2(east, north) * 180 / std::numbers::pi;
  return std::round(std::fmod(degrees + 360, 360) * 10) / 10;
}

/// Away from the nearest wall of its sector.
void turn_fronts(City& city) {
  std::unordered_map<std::string, std::vector<const Border*>> walls;
  for (const Border& b : city.borders) walls[b.sector_id].push_back(&b);
  for (StandaloneObject& object : city.objects) {
    if (!has_front(object)) continue;
    double least_mm = 30'000;
    for (const Border* border : walls[object.sector_id])
      for (std::size_t i = 1; i < border->line.size(); ++i) {
        const PlanPoint a = border->line[i - 1], b = border->line[i];
        if (a == b) continue;
        if (const double d = distance_to_segment_mm(object.at, a, b); d < least_mm) {
          least_mm = d;
          object.heading_deg = heading_of(-(double(b.y) - a.y), double(b.x) - a.x);  // the ground is on the left
        }
      }
  }
}

class SignHanger {
 public:
  explicit SignHanger(City& city) : city_(city) {
    for (const Facade& f : city.facades) facades_[f.sector_id].push_back(&f);
  }

  void run() {
    std::vector<StandaloneObject> signs;
    for (const StandaloneObject& object : city_.objects)
      if (has_sign(object))
        if (auto sign = sign_for(object)) signs.push_back(std::move(*sign));
    std::move(signs.begin(), signs.end(), std::back_inserter(city_.objects));
  }

 private:
  std::optional<StandaloneObject> sign_for(const StandaloneObject& object) {
    const Facade* best = nullptr;
    double least_mm = kSignReach_m * kMmPerMetre;
    for (const Facade* f : facades_[object.sector_id])
      if (const double d = distance_to_segment_mm(object.at, f->a, f->b);
          d < least_mm && f->top_m > kLeastTop_m && f->bottom_m <= 0) {
        least_mm = d;
        best = f;
      }
    if (!best) return std::nullopt;
    const double dx = metres(best->b.x - best->a.x), dy = metres(best->b.y - best->a.y), length = std::hypot(dx, dy);
    const double along = (metres(object.at.x - best->a.x) * dx + metres(object.at.y - best->a.y) * dy) / length;
    const double end = std::min(kSignApart_m / 2, length / 2), at = std::clamp(along, end, length - end);
    for (const double taken : taken_[best])
      if (std::abs(taken - at) < kSignApart_m) return std::nullopt;
    taken_[best].push_back(at);
    StandaloneObject sign;
    sign.id = "sign-" + object.id;
    sign.sector_id = object.sector_id;
    sign.kind = "sign";
    sign.name = object.name;
    const double ux = dx / length, uy = dy / length;
    sign.at = {best->a.x + lattice_mm(ux * at - uy * kSignOut_m), best->a.y + lattice_mm(uy * at + ux * kSignOut_m)};
    sign.heading_deg = heading_of(-uy, ux);
    sign.height_m = std::min(kSignHeight_m, best->top_m - 0.4);
    sign.url = address_of(object);
    return sign;
  }

  std::string address_of(const StandaloneObject& object) {
    for (const char* key : {"website", "contact:website", "url"}) {
      const auto tag = object.tags.find(key);
      if (tag == object.tags.end()) continue;
      if (const auto address = web_address(tag->second)) return *address;
      city_.issues.push_back({IssueCode::unknown_attribute_value,
                              std::string(key) + "=" + tag->second + " is no web address; the sign has none.",
                              object.id, object.at});
    }
    return {};
  }

  City& city_;
  std::unordered_map<std::string, std::vector<const Facade*>> facades_;
  std::map<const Facade*, std::vector<double>> taken_;
};

/// Rails that meet end to end with nothing else there, as long as they go.
std::vector<std::vector<PlanPoint>> rail_chains(const SourceMap& map) {
  std::vector<const Track*> rails;
  for (const Track& t : map.tracks)
    if (t.kind == SurfaceKind::rail) rails.push_back(&t);
  std::map<PlanPoint, std::vector<std::size_t>> ends;
  for (std::size_t i = 0; i < rails.size(); ++i) {
    ends[rails[i]->line.front()].push_back(i);
    ends[rails[i]->line.back()].push_back(i);
  }
  std::vector<char> is_used(rails.size(), 0);
  std::vector<std::vector<PlanPoint>> chains;
  const auto grow = [&](std::vector<PlanPoint>& chain) {
    for (;;) {
      std::size_t next = rails.size();
      for (const std::size_t i : ends[chain.back()])
        if (!is_used[i]) next = std::min(next, i);
      if (next == rails.size()) return;
      is_used[next] = 1;
      auto line = rails[next]->line;
      if (line.front() != chain.back()) std::reverse(line.begin(), line.end());
      chain.insert(chain.end(), line.begin() + 1, line.end());
    }
  };
  for (std::size_t i = 0; i < rails.size(); ++i) {
    if (is_used[i]) continue;
    is_used[i] = 1;
    auto chain = rails[i]->line;
    grow(chain);
    std::reverse(chain.begin(), chain.end());
    grow(chain);
    std::reverse(chain.begin(), chain.end());
    chains.push_back(std::move(chain));
  }
  return chains;
}

/// Each chain's tram, cut into rides by the sectors it passes.
void add_rides(const SourceMap& map, City& city) {
  std::vector<PlanBox> boxes;
  for (const auto& s : city.sectors) boxes.push_back(box_of(s.ground));
  const BoxIndex index(std::move(boxes));
  const auto sector_at = [&](PlanPoint p) {
    PlanBox box;
    box.add(p);
    for (const std::uint32_t i : index.meeting(box))
      if (locate(city.sectors[i].ground, p) != Side::outside) return static_cast<int>(i);
    return -1;
  };
  for (const auto& chain : rail_chains(map)) {
    double length = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
      length += std::sqrt(static_cast<double>(distance2(chain[i - 1], chain[i]))) / kMmPerMetre;
    if (length < kLeastRide_m) continue;
    const double cycle_s = std::ceil(length / kTram_m_per_s + kTramPause_s);
    Ride ride;
    int inside = -1;
    const auto end_ride = [&] {
      if (inside >= 0 && ride.points.size() >= 2) city.rides.push_back(ride);
      ride = {};
    };
    double before = 0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double size = std::sqrt(static_cast<double>(distance2(chain[i - 1], chain[i]))) / kMmPerMetre;
      const int steps = std::max(1, static_cast<int>(size / kRideStep_m));
      for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        const PlanPoint p{chain[i - 1].x + static_cast<std::int32_t>((chain[i].x - chain[i - 1].x) * share),
                          chain[i - 1].y + static_cast<std::int32_t>((chain[i].y - chain[i - 1].y) * share)};
        const int sector = sector_at(p);
        if (sector != inside) {
          end_ride();
          inside = sector;
        }
        if (sector < 0) continue;
        ride.sector_id = city.sectors[static_cast<std::size_t>(sector)].id;
        ride.kind = "tram";
        ride.cycle_s = cycle_s;
        const double time_s = std::round((before + size * share) / kTram_m_per_s * 1000) / 1000;
        // Straight stretches need their ends alone.
        const bool is_between = k > 1 && ride.points.size() >= 2 && city.terrain.height_mm.empty();
        if (is_between) ride.points.pop_back();
        if (ride.points.empty() || ride.points.back().time_s < time_s)
          ride.points.push_back({p, metres(lattice_mm(height_m(city.terrain, p))), time_s});
      }
      before += size;
    }
    end_ride();
  }
  std::stable_sort(city.rides.begin(), city.rides.end(),
                   [](const Ride& a, const Ride& b) { return a.sector_id < b.sector_id; });
}

}  // namespace

std::optional<std::string> web_address(const std::string& text) {
  std::string address = text;
  const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!address.empty() && is_blank(static_cast<unsigned char>(address.back()))) address.pop_back();
  address.erase(address.begin(), std::find_if_not(address.begin(), address.end(), is_blank));
  if (address.find("://") == std::string::npos) address = "https://" + address;
  const std::size_t host = address.starts_with("https://") ? 8 : address.starts_with("http://") ? 7 : 0;
  if (host == 0 || address.size() > 2000) return std::nullopt;
  for (const unsigned char c : address)
    if (c <= ' ' || c == '"' || c == '\\' || c == '<' || c == '>' || c == '`' || c == '\'' || c == 0x7f)
      return std::nullopt;
  const std::string name = address.substr(host, address.find_first_of("/?#", host) - host);
  const auto dot = name.find('.');
  if (dot == std::string::npos || dot == 0 || name.back() == '.' || name.find("..") != std::string::npos)
    return std::nullopt;
  if (name.find('@') != std::string::npos) return std::nullopt;
  return address;
}

void stand_objects(const SourceMap& map, City& city) {
  turn_fronts(city);
  SignHanger(city).run();
  add_rides(map, city);
}

}  // namespace vicus
