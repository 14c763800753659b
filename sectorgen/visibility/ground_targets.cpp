#include "sectorgen/visibility/ground_targets.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/terrain.hpp"
#include "sectorgen/visibility/spot_box.hpp"

namespace vicus {
namespace {

constexpr double kPieceRise_m = 1.5;  // steeper pieces are halved
constexpr double kLeastPiece_m = 6;   // down to this length

struct Piece {
  Spot corner[3];
};

class GroundPieces {
 public:
  GroundPieces(const Terrain& terrain, SegmentTree& tree) : terrain_(terrain), tree_(tree) {}

  void add(const Piece& piece) {
    const auto [least_m, most_m] = height_range(terrain_, box_of(piece));
    const double rise_m = most_m - least_m;
    int longest = 0;
    for (int k = 1; k < 3; ++k)
      if (length_m(piece, k) > length_m(piece, longest)) longest = k;
    if (rise_m <= kPieceRise_m || length_m(piece, longest) <= kLeastPiece_m) {
      for (int k = 0; k < 3; ++k)
        tree_.segments.push_back({piece.corner[k], piece.corner[(k + 1) % 3], most_m, most_m});
      return;
    }
    const Spot a = piece.corner[longest], b = piece.corner[(longest + 1) % 3], c = piece.corner[(longest + 2) % 3];
    const Spot middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    add({{a, middle, c}});
    add({{middle, b, c}});
  }

 private:
  static double length_m(const Piece& piece, int k) {
    const Spot a = piece.corner[k], b = piece.corner[(k + 1) % 3];
    return std::hypot(b.x - a.x, b.y - a.y);
  }
  static PlanBox box_of(const Piece& piece) {
    const auto [west, east] = std::minmax({piece.corner[0].x, piece.corner[1].x, piece.corner[2].x});
    const auto [south, north] = std::minmax({piece.corner[0].y, piece.corner[1].y, piece.corner[2].y});
    return box_around({west, south}, {east, north});
  }

  const Terrain& terrain_;
  SegmentTree& tree_;
};

}  // namespace

void add_ground_targets(const City& city, std::uint32_t first_house, RoofTargets& targets,
                        std::vector<std::uint32_t>& roots) {
  if (city.terrain.height_mm.empty()) return;
  GroundPieces pieces(city.terrain, targets.tree);
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) {
    const Sector& sector = city.sectors[s];
    std::vector<PlanPoint> points = sector.ground.outer;
    for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
    const auto first = static_cast<std::uint32_t>(targets.tree.segments.size());
    const auto& t = sector.ground_triangles;
    for (std::size_t i = 0; i + 2 < t.size(); i += 3)
      pieces.add({{spot_of(points[t[i]]), spot_of(points[t[i + 1]]), spot_of(points[t[i + 2]])}});
    const auto last = static_cast<std::uint32_t>(targets.tree.segments.size());
    if (first == last) continue;
    targets.showing.resize(last, static_cast<std::uint32_t>(targets.showings.size()));
    targets.is_wall.resize(last, false);
    targets.showings.push_back({s, first_house + s, false});
    roots.push_back(add_chain(targets.tree, first, last, first_house + s));
  }
}

}  // namespace vicus
