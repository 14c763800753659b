#include "sectorgen/sectors/tours/tell_tour.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "city_db/terrain.hpp"
#include "sectorgen/sectors/tours/round_bends.hpp"

namespace vicus {
namespace {

constexpr double kUnsaid_m = 15;                 // ground passed without a word
constexpr double kLookBack_m = 20, kNear_m = 5;  // a turn is measured between these before and after
constexpr double kSlight_deg = 25, kTurn_deg = 60, kSharp_deg = 125, kBack_deg = 165;
constexpr double kPassesView_m = 8;  // a viewpoint so near is on the way
constexpr double kSide_m = 0.5;      // what one looks at from farther off is on a side

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

class Teller {
 public:
  Teller(const TourCity& city, std::vector<TourPlace> stops, const std::vector<Walk>& walks)
      : city_(city), walks_(walks) {
    tour_.stops = std::move(stops);
  }

  Tour tell() {
    for (std::size_t i = 0; i < walks_.size(); ++i) add_walk(i);
    tour_.name = tour_.stops.front().name + " – " + tour_.stops.back().name;
    tour_.length_m = tour_.points.back().walked_m;
    tour_.duration_s = tour_.length_m / kWalkingSpeed_m_s;
    add_step(TourTurn::arrive, arrival(), "", tour_.length_m);
    for (std::size_t i = 0; i + 1 < tour_.steps.size(); ++i)
      tour_.steps[i].length_m = tour_.steps[i + 1].walked_m - tour_.steps[i].walked_m;
    add_viewpoints();
    return std::move(tour_);
  }

 private:
  void add_walk(std::size_t number) {
    const Walk& walk = walks_[number];
    const auto rounded = round_bends(walk);
    const double begin_m = tour_.points.empty() ? 0 : tour_.points.back().walked_m;
    for (std::size_t i = 0; i < rounded.size(); ++i) {
      if (number > 0 && i == 0) continue;  // the last one's end
      TourPoint point;
      point.at = {static_cast<std::int32_t>(std::lround(rounded[i].east_mm)),
                  static_cast<std::int32_t>(std::lround(rounded[i].north_mm))};
      point.ground_m = height_m(city_.terrain, point.at);
      point.walked_m = begin_m + rounded[i].walked_mm / kMmPerMetre;
      tour_.points.push_back(point);
    }
    // Where sectors are entered, along the rounded way.
    std::vector<TourSector> entered;
    std::vector<const Sector*> sectors;
    for (const auto& e : walk.sectors) {
      const auto after = std::upper_bound(rounded.begin(), rounded.end(), e.at_mm,
                                          [](double mm, const RoundedPoint& p) { return mm < p.straight_mm; });
      double mm = rounded.back().walked_mm;
      if (after != rounded.end() && after != rounded.begin()) {
        const auto &a = *(after - 1), &b = *after;
        mm = std::lerp(a.walked_mm, b.walked_mm, (e.at_mm - a.straight_mm) / (b.straight_mm - a.straight_mm));
      }
      const Sector& sector = city_.sectors[e.sector];
      entered.push_back({sector.id, sector.name, begin_m + mm / kMmPerMetre});
      sectors.push_back(&sector);
    }
    tell_walk(number, entered, sectors, begin_m);
    for (auto& e : entered)
      if (tour_.sectors.empty() || tour_.sectors.back().id != e.id) tour_.sectors.push_back(std::move(e));
  }

  void tell_walk(std::size_t number, const std::vector<TourSector>& entered, const std::vector<const Sector*>& sectors,
                 double begin_m) {
    const double end_m = tour_.points.back().walked_m;
    const auto bears = [](const Sector& s, const std::string& name) {
      return s.name == name || std::find(s.names.begin(), s.names.end(), name) != s.names.end();
    };
    const auto last = sectors.size() - 1;
    const auto is_passed = [&](std::size_t i) {
      const double to = i == last ? end_m : entered[i + 1].walked_m;
      return to - entered[i].walked_m < kUnsaid_m && i != last &&
             (sectors[i]->kind == SectorKind::crossroads || sectors[i]->name.empty());
    };
    std::size_t first = 0;
    while (first < last && is_passed(first)) ++first;
    std::string street = sectors[first]->name;
    const Sector* told = sectors[first];
    const std::string along =
        std::string(compass_word(heading_deg(begin_m + 1, begin_m + kLookBack_m))) + along_text(*told);
    const auto& stop = tour_.stops[number];
    if (number == 0)
      add_step(TourTurn::start, "Start at " + stop.name + " and go " + along + ".", street, begin_m);
    else
      add_step(TourTurn::via, "This is " + stop.name + ". Go on " + along + ".", street, begin_m);
    for (std::size_t i = first + 1; i < sectors.size(); ++i) {
      const Sector& s = *sectors[i];
      if (street.empty() ? s.name.empty() && s.kind == told->kind : bears(s, street)) continue;
      if (is_passed(i)) continue;
      if (s.kind == SectorKind::crossroads && i < last && bears(*sectors[i + 1], street) && !street.empty()) continue;
      street = s.name;
      told = &s;
      const double at_m = entered[i].walked_m;
      const double turn = turn_deg(at_m, begin_m, end_m);
      add_step(kind_of_turn(turn), turn_text(kind_of_turn(turn), s), street, at_m);
    }
  }

  static std::string along_text(const Sector& s) {
    switch (s.kind) {
      case SectorKind::square:
        return s.name.empty() ? " over the square" : " over " + s.name;
      case SectorKind::yard:
        return s.name.empty() ? " through the yard" : " through " + s.name;
      case SectorKind::passage:
        return s.name.empty() ? " through the passage" : " through " + s.name;
      case SectorKind::open:
        return s.name.empty() ? " over open ground" : " through " + s.name;
      default:
        return s.name.empty() ? "" : " along " + s.name;
    }
  }

  static std::string ground_text(const Sector& s) {
    if (!s.name.empty()) return s.name;
    switch (s.kind) {
      case SectorKind::square:
        return "a square";
      case SectorKind::yard:
        return "a yard";
      case SectorKind::passage:
        return "a passage";
      case SectorKind::open:
        return "open ground";
      default:
        return "a street without a name";
    }
  }

  static TourTurn kind_of_turn(double turn) {
    const double size = std::abs(turn);
    const bool is_left = turn < 0;
    if (size < kSlight_deg) return TourTurn::straight;
    if (size > kBack_deg) return TourTurn::back;
    if (size < kTurn_deg) return is_left ? TourTurn::slight_left : TourTurn::slight_right;
    if (size < kSharp_deg) return is_left ? TourTurn::left : TourTurn::right;
    return is_left ? TourTurn::sharp_left : TourTurn::sharp_right;
  }

  static std::string turn_text(TourTurn turn, const Sector& s) {
    const std::string into = " into " + ground_text(s) + ".";
    switch (turn) {
      case TourTurn::slight_left:
        return "Keep left" + into;
      case TourTurn::left:
        return "Turn left" + into;
      case TourTurn::sharp_left:
        return "Turn sharply left" + into;
      case TourTurn::slight_right:
        return "Keep right" + into;
      case TourTurn::right:
        return "Turn right" + into;
      case TourTurn::sharp_right:
        return "Turn sharply right" + into;
      case TourTurn::back:
        return "Turn round" + into;
      default:
        return "Go on" + into;
    }
  }

  std::string arrival() const {
    const TourPlace& stop = tour_.stops.back();
    std::string text = "You are at " + std::string(stop.kind == "room" ? "the door to " : "") + stop.name + ".";
    const double dx = metres(std::int64_t{stop.look.x} - stop.at.x), dy = metres(std::int64_t{stop.look.y} - stop.at.y);
    if (std::hypot(dx, dy) < kSide_m || tour_.length_m < 2) return text;
    const double off =
        std::remainder(degrees(std::atan2(dx, dy)) - heading_deg(tour_.length_m - 4, tour_.length_m), 360);
    if (std::abs(off) < kSlight_deg) return text + " It is before you.";
    if (std::abs(off) > 180 - kSlight_deg) return text + " It is behind you.";
    return text + (off < 0 ? " It is on your left." : " It is on your right.");
  }

  void add_step(TourTurn turn, std::string text, std::string street, double walked_m) {
    tour_.steps.push_back({turn, std::move(text), std::move(street), walked_m, 0});
  }

  PlanPoint at(double walked_m) const {
    const auto after = std::upper_bound(tour_.points.begin(), tour_.points.end(), walked_m,
                                        [](double m, const TourPoint& p) { return m < p.walked_m; });
    if (after == tour_.points.begin()) return tour_.points.front().at;
    if (after == tour_.points.end()) return tour_.points.back().at;
    const auto &a = *(after - 1), &b = *after;
    const double share = (walked_m - a.walked_m) / (b.walked_m - a.walked_m);
    return {static_cast<std::int32_t>(std::lround(std::lerp(double(a.at.x), double(b.at.x), share))),
            static_cast<std::int32_t>(std::lround(std::lerp(double(a.at.y), double(b.at.y), share)))};
  }

  /// From one place of the way to another.
  double heading_deg(double from_m, double to_m) const {
    const PlanPoint a = at(from_m), b = at(to_m);
    return degrees(std::atan2(double(b.x) - a.x, double(b.y) - a.y));
  }

  /// To the right is positive.
  double turn_deg(double at_m, double begin_m, double end_m) const {
    const double before = heading_deg(std::max(begin_m, at_m - kLookBack_m), std::max(begin_m, at_m - kNear_m)),
                 after = heading_deg(std::min(end_m, at_m + kNear_m), std::min(end_m, at_m + kLookBack_m));
    if (at_m - begin_m < kNear_m || end_m - at_m < kNear_m) return 0;
    return std::remainder(after - before, 360);
  }

  void add_viewpoints() {
    for (const auto& v : city_.viewpoints) {
      const bool is_on_way = std::any_of(tour_.sectors.begin(), tour_.sectors.end(),
                                         [&](const TourSector& s) { return s.id == v.sector_id; });
      if (!is_on_way) continue;
      double nearest = kPassesView_m * kMmPerMetre, walked_m = -1;
      for (std::size_t i = 0; i + 1 < tour_.points.size(); ++i) {
        const auto &a = tour_.points[i], &b = tour_.points[i + 1];
        const double dx = double(b.at.x) - a.at.x, dy = double(b.at.y) - a.at.y, length2 = dx * dx + dy * dy;
        const double share =
            length2 > 0
                ? std::clamp(((double(v.at.x) - a.at.x) * dx + (double(v.at.y) - a.at.y) * dy) / length2, 0.0, 1.0)
                : 0;
        const double mm = std::hypot(a.at.x + share * dx - v.at.x, a.at.y + share * dy - v.at.y);
        if (mm >= nearest) continue;
        nearest = mm;
        walked_m = std::lerp(a.walked_m, b.walked_m, share);
      }
      if (walked_m < 0) continue;
      tour_.viewpoints.push_back({v.id, v.sector_id, v.name, v.at, v.ground_m, v.eye_m, v.heading_deg, walked_m});
    }
    std::stable_sort(tour_.viewpoints.begin(), tour_.viewpoints.end(),
                     [](const TourViewpoint& a, const TourViewpoint& b) { return a.walked_m < b.walked_m; });
  }

  const TourCity& city_;
  const std::vector<Walk>& walks_;
  Tour tour_;
};

}  // namespace

Tour tell_tour(const TourCity& city, std::vector<TourPlace> stops, const std::vector<Walk>& walks) {
  assert(!walks.empty() && stops.size() == walks.size() + 1);
  return Teller(city, std::move(stops), walks).tell();
}

const char* compass_word(double heading_deg) {
  static const char* const kWords[] = {"north", "north-east", "east", "south-east",
                                       "south", "south-west", "west", "north-west"};
  const auto eighth = static_cast<int>(std::lround(heading_deg / 45));
  return kWords[((eighth % 8) + 8) % 8];
}

}  // namespace vicus
