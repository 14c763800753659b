#include "sectorgen/sectors/tours/guide.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>

#include "city_db/store.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/geo/plan_frame.hpp"
#include "sectorgen/sectors/tours/corner_caps.hpp"
#include "sectorgen/sectors/tours/gazetteer.hpp"
#include "sectorgen/sectors/tours/named_places.hpp"
#include "sectorgen/sectors/tours/sights.hpp"
#include "sectorgen/sectors/tours/tell_tour.hpp"

namespace vicus {
namespace {

constexpr double kStepBack_mm = 4000;  // one stands so far from a thing to look at it
constexpr std::size_t kSuggestions = 4;

using Kind = TourProblem::Kind;

/// "LAT,LON"; nullopt: it is no pair of numbers.
std::optional<LatLon> degrees_from(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto number = [](std::string_view part) -> std::optional<double> {
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    double value = 0;
    const auto [rest, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || rest != part.data() + part.size() || !std::isfinite(value)) return std::nullopt;
    return value;
  };
  const auto lat = number(std::string_view(text).substr(0, comma)),
             lon = number(std::string_view(text).substr(comma + 1));
  if (!lat || !lon) return std::nullopt;
  return LatLon{*lat, *lon};
}

bool has_control(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  });
}

}  // namespace

struct Guide::Impl {
  explicit Impl(City city)
      : frame(city.origin),
        names(named_places(city)),
        rooms(interior_places(city)),
        gazetteer(names),
        walk(make_clear_walk_mesh(city.sectors, city.gates, kWalkClearance_mm)),
        places(walk),
        graph(make_sight_graph(walk)) {
    told.viewpoints = std::move(city.viewpoints);
    told.terrain = std::move(city.terrain);
    for (auto& s : city.sectors) {
      middles.push_back(middle_of(s));
      s.ground = {};
      s.ground_triangles = {};
    }
    told.sectors = std::move(city.sectors);
    for (std::uint32_t i = 0; i < told.sectors.size(); ++i) sector_index.emplace(told.sectors[i].id, i);
  }

  /// Puts a place on the ground. false: none is near.
  bool stand(TourPlace& place, double within_m) const {
    const auto standing = places.nearest(place.at, within_m * kMmPerMetre);
    if (!standing) return false;
    const bool is_on_ground = standing->at == place.at;
    place.at = standing->at;
    std::uint32_t triangle = standing->triangle;
    const bool is_thing =
        place.kind != "street" && place.kind != "square" && place.kind != "sector" && place.kind != "place";
    if (is_on_ground && is_thing && place.look == place.at) step_back(place, triangle);
    place.sector_id = told.sectors[walk.sector[triangle]].id;
    place.ground_m = height_m(told.terrain, place.at);
    place.degrees = frame.latlon_from_plan(place.at);
    return true;
  }

  /// Off a thing that stands on the ground, where there is room for it: who stands in it does not see it.
  void step_back(TourPlace& place, std::uint32_t& triangle) const {
    for (int i = 0; i < 8; ++i) {
      const double angle = (i % 2 == 0 ? i : 8 - i) * std::numbers::pi / 4;
      const PlanPoint back{place.look.x + static_cast<std::int32_t>(std::lround(kStepBack_mm * std::sin(angle))),
                           place.look.y - static_cast<std::int32_t>(std::lround(kStepBack_mm * std::cos(angle)))};
      const auto standing = places.standing_at(back);
      if (standing.empty() || walk.part[standing.front()] != walk.part[triangle]) continue;
      place.at = back;
      triangle = standing.front();
      return;
    }
  }

  std::variant<TourPlace, TourProblem> find_place(const std::string& text) const {
    if (text.empty()) return TourProblem{Kind::nonsense, "A stop is empty: give a sector's id, a name or LAT,LON."};
    if (text.size() > kLongestName || has_control(text))
      return TourProblem{Kind::nonsense, "A stop is no name: give a sector's id, a name or LAT,LON, in at most " +
                                             std::to_string(kLongestName) + " bytes."};
    TourPlace place;
    if (const auto degrees = degrees_from(text)) {
      if (std::abs(degrees->lat_deg) > 90 || std::abs(degrees->lon_deg) > 180)
        return TourProblem{Kind::nonsense, text + " is no place on earth: LAT is at most 90, LON at most 180."};
      place.kind = "place";
      place.name = text;
      const auto at = frame.plan_from_latlon(*degrees);
      if (at) place.at = place.look = *at;
      if (!at || !stand(place, kBesideGround_m))
        return TourProblem{Kind::unknown_place, text + " is not in this city: no ground to walk on is within " +
                                                    std::to_string(static_cast<int>(kBesideGround_m)) + " m."};
      if (const auto& s = told.sectors[sector_index.at(place.sector_id)]; !s.name.empty()) place.detail = s.name;
      return place;
    }
    if (const auto sector = sector_index.find(text); sector != sector_index.end()) {
      const Sector& s = told.sectors[sector->second];
      place.kind = "sector";
      place.name = s.name.empty() ? s.id : s.name;
      place.at = place.look = middles[sector->second];
      if (stand(place, kBesideGround_m)) return place;
    }
    if (const auto room = rooms.find(text); room != rooms.end()) {
      place = room->second;
      if (stand(place, kBesideGround_m)) return place;
    }
    const auto found = gazetteer.find(text, kSuggestions);
    for (const auto& f : found) {
      if (!f.is_whole) break;
      place = names[f.index].place;
      if (stand(place, kBesideGround_m)) return place;
    }
    std::string detail = "There is no place '" + text + "' in this city.";
    const char* separator = " Did you mean ";
    for (const auto& f : found) {
      detail += separator + names[f.index].place.name;
      separator = ", ";
    }
    return TourProblem{Kind::unknown_place, detail + (found.empty() ? " Ask /search?q= for what there is." : "?")};
  }

  std::optional<Walk> walk_between(const TourPlace& from, const TourPlace& to) const {
    std::unique_ptr<ShortestWalk> finder;
    {
      const std::lock_guard lock(mutex);
      if (!idle.empty()) {
        finder = std::move(idle.back());
        idle.pop_back();
      }
    }
    if (!finder) finder = std::make_unique<ShortestWalk>(walk, places, graph);
    auto found = finder->find(from.at, to.at);
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(finder));
    return found;
  }

  TourAnswer tour_of(std::vector<TourPlace> stops) const {
    std::vector<Walk> walks;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      auto found = walk_between(stops[i], stops[i + 1]);
      if (!found) return not_connected(stops[i], stops[i + 1]);
      walks.push_back(*std::move(found));
    }
    return tell_tour(told, std::move(stops), walks);
  }

  TourProblem not_connected(const TourPlace& from, const TourPlace& to) const {
    const auto part_text = [&](const TourPlace& place) {
      const auto standing = places.standing_at(place.at);
      std::set<std::uint32_t> sectors;
      for (std::uint32_t t = 0; t < walk.part.size(); ++t)
        if (!standing.empty() && walk.part[t] == walk.part[standing.front()]) sectors.insert(walk.sector[t]);
      return place.name + " (sector " + place.sector_id + ") is in a part of " + std::to_string(sectors.size()) +
             (sectors.size() == 1 ? " sector" : " sectors");
    };
    return {Kind::not_connected, "No way leads from " + from.name + " to " + to.name + ": " + part_text(from) + ", " +
                                     part_text(to) + ", and no gates join the two. Choose places in one of them."};
  }

  PlanFrame frame;
  std::vector<NamedPlace> names;
  std::map<std::string, TourPlace> rooms;  // by interior
  Gazetteer gazetteer;
  WalkMesh walk;
  WalkPlaces places;
  SightGraph graph;
  TourCity told;
  std::vector<PlanPoint> middles;  // per sector
  std::unordered_map<std::string, std::uint32_t> sector_index;
  mutable std::mutex mutex;
  mutable std::vector<std::unique_ptr<ShortestWalk>> idle;
  mutable std::once_flag proposed;
  mutable std::vector<TourProposal> proposals;
};

Guide::Guide(const std::filesystem::path& city)
    : impl_(std::make_unique<Impl>(read_city(city, {"sector", "gate", "border", "facade", "building", "object",
                                                    "viewpoint", "terrain", "interior", "door"}))) {}
Guide::~Guide() = default;

TourAnswer Guide::tour(const TourQuery& query) const {
  if (!query.tour.empty()) {
    std::string ids;
    for (const auto& proposal : proposals()) {
      if (proposal.id == query.tour) {
        auto answer = impl_->tour_of(proposal.stops);
        if (auto* tour = std::get_if<Tour>(&answer)) tour->name = proposal.name;
        return answer;
      }
      ids += (ids.empty() ? " There are " : ", ") + proposal.id;
    }
    return TourProblem{Kind::unknown_place,
                       "There is no ready-made tour of that id." + (ids.empty() ? " This city has none." : ids + ".")};
  }
  if (query.via.size() + 2 > kMostStops)
    return TourProblem{Kind::nonsense, "A tour has at most " + std::to_string(kMostStops) + " stops."};
  std::vector<std::string> texts{query.from};
  texts.insert(texts.end(), query.via.begin(), query.via.end());
  if (!query.to.empty() || !query.is_round) texts.push_back(query.to);
  std::vector<TourPlace> stops;
  for (const auto& text : texts) {
    auto place = impl_->find_place(text);
    if (auto* problem = std::get_if<TourProblem>(&place)) return *problem;
    stops.push_back(std::get<TourPlace>(std::move(place)));
  }
  if (stops.size() < 2)
    return TourProblem{Kind::nonsense, "A round trip needs a stop besides its start: give to= or via=."};
  if (query.is_round) stops.push_back(stops.front());
  return impl_->tour_of(std::move(stops));
}

std::vector<TourPlace> Guide::search(std::string_view typed, std::size_t limit) const {
  std::vector<TourPlace> places;
  for (const auto& found : impl_->gazetteer.find(typed, limit)) {
    TourPlace place = impl_->names[found.index].place;
    if (impl_->stand(place, kBesideGround_m)) places.push_back(std::move(place));
  }
  return places;
}

const std::vector<TourProposal>& Guide::proposals() const {
  std::call_once(impl_->proposed, [this] {
    std::vector<TourPlace> sights;
    for (const auto& named : impl_->names)
      if (TourPlace place = named.place; named.is_sight && impl_->stand(place, kBesideGround_m))
        sights.push_back(place);
    impl_->proposals = propose_tours(sights, [this](const TourPlace& a, const TourPlace& b) {
      const auto walk = impl_->walk_between(a, b);
      return walk ? walk->length_mm / kMmPerMetre : -1;
    });
  });
  return impl_->proposals;
}

}  // namespace vicus
