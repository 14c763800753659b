#include "tests/support/street_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <unordered_map>

namespace vicus::test {
namespace {

struct Place {
  double x = 0, y = 0;
};
Place middle_of(PlanPoint a, PlanPoint b) {
  return {metres(std::int64_t{a.x} + b.x) / 2, metres(std::int64_t{a.y} + b.y) / 2};
}

/// The triangles of one sector's ground, joined at their sides.
class Ground {
 public:
  explicit Ground(const Sector& sector) : corners_(sector.ground_triangles) {
    points_ = sector.ground.outer;
    for (const auto& hole : sector.ground.holes) points_.insert(points_.end(), hole.begin(), hole.end());
    for (std::uint32_t t = 0; 3 * t + 2 < corners_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) by_side_[side(t, k)].push_back(t);
  }

  /// Through the middles of sides from one of the sector's edges to another, both ends in it; empty: they are not
  /// joined.
  std::vector<Place> way(PlanPoint a0, PlanPoint b0, PlanPoint a1, PlanPoint b1) const {
    const auto from = by_side_.find(std::minmax(a0, b0)), to = by_side_.find(std::minmax(a1, b1));
    if (from == by_side_.end() || to == by_side_.end()) return {};
    const std::uint32_t first = from->second.front(), last = to->second.front();
    std::vector<std::uint32_t> before(corners_.size() / 3, kNone), queue{last};
    std::vector<Side> entered(before.size());
    before[last] = last;
    for (std::size_t i = 0; i < queue.size() && before[first] == kNone; ++i)
      for (std::uint32_t k = 0; k < 3; ++k)
        for (const std::uint32_t t : by_side_.at(side(queue[i], k)))
          if (before[t] == kNone) before[t] = queue[i], entered[t] = side(queue[i], k), queue.push_back(t);
    if (before[first] == kNone) return {};
    std::vector<Place> way{middle_of(a0, b0)};
    for (std::uint32_t t = first; t != last; t = before[t])
      way.push_back(middle_of(entered[t].first, entered[t].second));
    way.push_back(middle_of(a1, b1));
    return way;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  using Side = std::pair<PlanPoint, PlanPoint>;
  Side side(std::uint32_t t, std::uint32_t k) const {
    return std::minmax(points_[corners_[3 * t + k]], points_[corners_[3 * t + (k + 1) % 3]]);
  }
  const Triangles& corners_;
  std::vector<PlanPoint> points_;
  std::map<Side, std::vector<std::uint32_t>> by_side_;
};

/// One edge of a gate that leads to another sector: the middle one.
struct Door {
  PlanPoint a, b;
  std::uint32_t to = 0;
};

std::vector<std::vector<Door>> doors_of(const City& city) {
  std::unordered_map<std::string, std::uint32_t> sectors;
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) sectors.emplace(city.sectors[s].id, s);
  std::vector<std::vector<Door>> doors(city.sectors.size());
  for (const auto& gate : city.gates) {
    if (gate.to_sector_id.empty() || gate.line.size() < 2) continue;
    const std::size_t i = (gate.line.size() - 2) / 2;
    doors[sectors.at(gate.sector_id)].push_back({gate.line[i], gate.line[i + 1], sectors.at(gate.to_sector_id)});
  }
  return doors;
}

/// Puts a place on the way at every step.
class Pacer {
 public:
  Pacer(double length_m, double step_m) : length_m_(length_m), step_m_(step_m) {}
  void follow(const std::vector<Place>& way, std::uint32_t sector) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const double dx = way[i + 1].x - way[i].x, dy = way[i + 1].y - way[i].y, length = std::hypot(dx, dy);
      for (; next_m_ < done_m_ + length && !is_done(); next_m_ += step_m_) {
        const double share = (next_m_ - done_m_) / length;
        places.push_back({sector, way[i].x + share * dx, way[i].y + share * dy});
      }
      done_m_ += length;
    }
  }
  bool is_done() const { return next_m_ >= length_m_; }
  std::vector<WalkPlace> places;

 private:
  double length_m_, step_m_, done_m_ = 0, next_m_ = 0;
};

}  // namespace

std::vector<WalkPlace> walk_streets(const City& city, double length_m, double step_m, std::uint64_t seed) {
  const auto doors = doors_of(city);
  std::uint32_t here = 0;
  const auto worth = [&](std::uint32_t s) {
    return std::pair(city.sectors[s].kind == SectorKind::street && !city.sectors[s].name.empty(), doors[s].size());
  };
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s)
    if (worth(s) > worth(here)) here = s;
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> entered(city.sectors.size(), 0);
  Pacer pacer(length_m, step_m);
  if (doors.empty() || doors[here].empty()) return {};
  Door in = doors[here].front();  // the side by which the sector was entered
  while (!pacer.is_done()) {
    ++entered[here];
    const Ground ground(city.sectors[here]);
    std::vector<std::pair<std::uint64_t, std::size_t>> choice;
    for (std::size_t i = 0; i < doors[here].size(); ++i)
      choice.push_back({std::uint64_t{entered[doors[here][i].to]} << 32 | (random() & 0xffffffff), i});
    std::sort(choice.begin(), choice.end());
    std::vector<Place> way;
    Door out{};
    for (const auto& [rank, i] : choice) {
      out = doors[here][i];
      if (std::minmax(out.a, out.b) == std::minmax(in.a, in.b) && choice.size() > 1) continue;
      way = ground.way(in.a, in.b, out.a, out.b);
      if (!way.empty()) break;
    }
    if (way.empty()) break;
    pacer.follow(way, here);
    here = out.to;
    in = out;
  }
  return pacer.places;
}

}  // namespace vicus::test
