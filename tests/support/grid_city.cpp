#include "tests/support/grid_city.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace vicus::test {
namespace {

constexpr std::int32_t kNicheDepth_mm = 700;

class Grid {
 public:
  explicit Grid(const GridOptions& o) : o_(o), random_(o.seed) {
    const std::int32_t half = o.width_mm / 2;
    for (std::int32_t j = 0; j < o.side; ++j)
      for (std::int32_t i = 0; i < o.side; ++i) {
        const std::int32_t x = i * o.pitch_mm + jitter(), y = j * o.pitch_mm + jitter();
        for (int corner = 0; corner < 4; ++corner)
          corners_.push_back({x + (corner == 1 || corner == 2 ? half : -half), y + (corner >= 2 ? half : -half)});
      }
  }

  /// South-west, south-east, north-east, north-west.
  PlanPoint corner(std::int32_t i, std::int32_t j, int which) const {
    return corners_[static_cast<std::size_t>(4 * (j * o_.side + i) + which)];
  }

  /// A front from a to b, ground on the left, its niches pressed into the house on the right; without b.
  Ring front(PlanPoint a, PlanPoint b) const {
    Ring ring{a};
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    for (std::int32_t n = 0; n < o_.niches; ++n)
      for (int k = 1; k <= 4; ++k) {
        const double at = (n + 0.2 * k) / o_.niches, depth = k == 2 || k == 3 ? kNicheDepth_mm / length : 0;
        ring.push_back({static_cast<std::int32_t>(std::lround(a.x + at * dx + depth * dy)),
                        static_cast<std::int32_t>(std::lround(a.y + at * dy - depth * dx))});
      }
    return ring;
  }

 private:
  std::int32_t jitter() {
    return o_.jitter_mm == 0
               ? 0
               : static_cast<std::int32_t>(random_() % static_cast<std::uint64_t>(o_.jitter_mm)) - o_.jitter_mm / 2;
  }
  const GridOptions& o_;
  std::mt19937_64 random_;
  std::vector<PlanPoint> corners_;
};

void append(Ring& ring, const Ring& part) { ring.insert(ring.end(), part.begin(), part.end()); }
/// The same points, as the house behind sees them: from b to a, without a.
Ring behind(Ring front, PlanPoint b) {
  front.push_back(b);
  std::reverse(front.begin(), front.end());
  front.pop_back();
  return front;
}

}  // namespace

City grid_city(const GridOptions& o) {
  const Grid grid(o);
  City city;
  const auto add = [&](SectorKind kind, Ring ring) {
    Sector sector;
    sector.id = "s" + std::to_string(city.sectors.size());
    sector.kind = kind;
    sector.origin = ring.front();
    sector.ground.outer = std::move(ring);
    city.sectors.push_back(std::move(sector));
  };
  for (std::int32_t j = 0; j < o.side; ++j)
    for (std::int32_t i = 0; i < o.side; ++i)
      add(SectorKind::crossroads,
          {grid.corner(i, j, 0), grid.corner(i, j, 1), grid.corner(i, j, 2), grid.corner(i, j, 3)});
  for (std::int32_t j = 0; j < o.side; ++j)
    for (std::int32_t i = 0; i + 1 < o.side; ++i) {
      Ring ring = grid.front(grid.corner(i, j, 1), grid.corner(i + 1, j, 0));
      ring.push_back(grid.corner(i + 1, j, 0));
      append(ring, grid.front(grid.corner(i + 1, j, 3), grid.corner(i, j, 2)));
      ring.push_back(grid.corner(i, j, 2));
      add(SectorKind::street, std::move(ring));
    }
  for (std::int32_t j = 0; j + 1 < o.side; ++j)
    for (std::int32_t i = 0; i < o.side; ++i) {
      Ring ring = grid.front(grid.corner(i, j + 1, 0), grid.corner(i, j, 3));
      ring.push_back(grid.corner(i, j, 3));
      append(ring, grid.front(grid.corner(i, j, 2), grid.corner(i, j + 1, 1)));
      ring.push_back(grid.corner(i, j + 1, 1));
      add(SectorKind::street, std::move(ring));
    }
  for (std::int32_t j = 0; j + 1 < o.side; ++j)
    for (std::int32_t i = 0; i + 1 < o.side; ++i) {
      const PlanPoint sw = grid.corner(i, j, 2), se = grid.corner(i + 1, j, 3), ne = grid.corner(i + 1, j + 1, 0),
                      nw = grid.corner(i, j + 1, 1);
      Building house;
      house.id = "h" + std::to_string(city.buildings.size());
      house.height_m = house.eave_m = o.height_m;
      append(house.footprint.outer, behind(grid.front(se, sw), sw));
      append(house.footprint.outer, behind(grid.front(ne, se), se));
      append(house.footprint.outer, behind(grid.front(nw, ne), ne));
      append(house.footprint.outer, behind(grid.front(sw, nw), nw));
      city.buildings.push_back(std::move(house));
    }
  return city;
}

}  // namespace vicus::test
