#include "cli/measure_prism_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include "city_db/issues.hpp"
#include "cli/measure_memory.hpp"
#include "sectorgen/bake/facade_sums.hpp"
#include "sectorgen/geom/triangulation.hpp"

namespace vicus::measure {
namespace {

/// What the shader paints, as images: one for each colour of wall.
class WindowImages {
 public:
  explicit WindowImages(RenderMesh& mesh) : mesh_(mesh) {}

  std::uint32_t on(Colour wall) {
    const auto [known, is_new] = number_.emplace(wall, static_cast<std::uint32_t>(mesh_.images.size()));
    if (is_new) mesh_.images.push_back(painted(wall));
    return known->second;
  }
  double memory_bytes() const { return double(number_.size()) * kPixel_bytes * kTexels * kTexels; }

 private:
  static constexpr int kTexels = 32;

  /// Share of texel i that is window along one axis, from the left or from below.
  static double covered(int i, std::size_t axis) {
    const double low = std::max(kWindowLow[axis] * kTexels, double(i)),
                 high = std::min(kWindowHigh[axis] * kTexels, i + 1.0);
    return std::max(0.0, high - low);
  }

  static std::shared_ptr<const RepeatedImage> painted(Colour wall) {
    Picture picture(kTexels, kTexels);
    const std::array<double, 3> own{wall.r / 255.0, wall.g / 255.0, wall.b / 255.0};
    for (int row = 0; row < kTexels; ++row)
      for (int column = 0; column < kTexels; ++column) {
        const double share = kOpaque * covered(column, 0) * covered(kTexels - 1 - row, 1);
        for (std::size_t k = 0; k < 3; ++k)
          picture.at(column, row)[k] = static_cast<float>(own[k] + share * (kGlass[k] - own[k]));
      }
    return std::make_shared<RepeatedImage>(opaque(picture));
  }

  RenderMesh& mesh_;
  std::map<Colour, std::uint32_t> number_;
};

struct HouseMesh {
  RenderMesh& mesh;
  WindowImages& windows;
  const PrismTile& tile;
  const PrismHouse& house;
  double ground_m, eave_m, top_m;
  RenderTriangle wall{}, roof{};

  std::uint32_t at(double x, double y, double up) const {
    const double step = metres(tile.step_mm);
    return mesh.add_point({metres(tile.corner.x) + step * x, metres(tile.corner.y) + step * y, up});
  }
  void add(RenderTriangle look, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    look.corners = {a, b, c};
    mesh.triangles.push_back(look);
  }

  void add_walls() const {
    const double top = house.kind == PrismKind::flat ? top_m : eave_m, height = top - ground_m;
    const auto storeys = static_cast<float>(std::max(1.0, std::round(height / kStorey_m)));
    for (const auto& ring : house.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PlanPoint p = ring[i], q = ring[(i + 1) % ring.size()];
        const auto a = at(p.x, p.y, ground_m), b = at(q.x, q.y, ground_m), c = at(q.x, q.y, top), d = at(p.x, p.y, top);
        const double wide = metres(tile.step_mm) * std::hypot(double(q.x) - p.x, double(q.y) - p.y);
        RenderTriangle lower = wall, upper = wall;
        if (wide >= kBlind_m && height >= kBlind_m) {
          const auto bays = static_cast<float>(std::max(1.0, std::round(wide / kWindowWidth_m)));
          lower.image = upper.image = windows.on(wall.colour);
          lower.places = static_cast<std::uint32_t>(mesh.places.size()), upper.places = lower.places + 1;
          mesh.places.push_back({{{0, 0}, {bays, 0}, {bays, storeys}}});
          mesh.places.push_back({{{0, 0}, {bays, storeys}, {0, storeys}}});
        }
        add(lower, a, b, c);
        add(upper, a, c, d);
      }
  }

  /// Triangles of the rings: those with an odd number of edges around them.
  void add_flat() const {
    std::vector<PlanPoint> points;
    std::vector<Edge> edges;
    for (const auto& ring : house.rings) {
      const auto first = static_cast<std::uint32_t>(points.size()), n = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < n; ++i) edges.push_back({first + i, first + (i + 1) % n});
      points.insert(points.end(), ring.begin(), ring.end());
    }
    Mesh flat;
    try {
      flat = triangulate_edges(points, edges);
    } catch (const CityError&) {  // rounding let a footprint's edges cross: a fan is as good
      const auto& ring = house.rings[0];
      for (std::size_t i = 2; i < ring.size(); ++i)
        add(roof, at(ring[0].x, ring[0].y, top_m), at(ring[i - 1].x, ring[i - 1].y, top_m),
            at(ring[i].x, ring[i].y, top_m));
      return;
    }
    const auto inside = flood_from_hull(flat, false, [&](bool value, std::uint32_t t, int k) {
      return value != (flat.triangles[t].edge[static_cast<std::size_t>(k)] != kNone);
    });
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t) {
      if (!inside[t]) continue;
      std::array<std::uint32_t, 3> c{};
      for (int k = 0; k < 3; ++k) {
        const PlanPoint p = flat.points[flat.corner(t, k)];
        c[static_cast<std::size_t>(k)] = at(p.x, p.y, top_m);
      }
      add(roof, c[0], c[1], c[2]);
    }
  }

  void add_tent() const {
    const auto& ring = house.rings[0];
    double x = 0, y = 0;
    for (const PlanPoint p : ring) x += p.x, y += p.y;
    const auto top = at(x / static_cast<double>(ring.size()), y / static_cast<double>(ring.size()), top_m);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint p = ring[i], q = ring[(i + 1) % ring.size()];
      add(roof, at(p.x, p.y, eave_m), at(q.x, q.y, eave_m), top);
    }
  }

  void add_own_roof() const {
    std::vector<std::uint32_t> corners;
    for (const auto& ring : house.rings)
      for (const PlanPoint p : ring) corners.push_back(at(p.x, p.y, eave_m));
    for (const PrismPoint& p : house.points)
      corners.push_back(at(p.at.x, p.at.y, eave_m + metres(tile.up_step_mm) * p.up));
    for (const PrismFacet& facet : house.facets)
      for (std::size_t k = 2; k < facet.corners.size(); ++k)
        add(facet.is_gable ? wall : roof, corners[facet.corners[0]], corners[facet.corners[k - 1]],
            corners[facet.corners[k]]);
  }

  /// A ridge between the middles of the shorter sides, drawn in by `share` of half their length.
  void add_ridged(bool is_hipped) const {
    const auto& ring = house.rings[0];
    const auto length = [&](std::size_t i) {
      return std::hypot(double(ring[(i + 1) % 4].x) - ring[i % 4].x, double(ring[(i + 1) % 4].y) - ring[i % 4].y);
    };
    const std::size_t first = length(0) + length(2) >= length(1) + length(3) ? 0 : 1;  // a longer side
    const auto corner = [&](std::size_t i) { return ring[(first + i) % 4]; };
    const auto middle = [](PlanPoint a, PlanPoint b) {
      return std::array{(double(a.x) + b.x) / 2, (double(a.y) + b.y) / 2};
    };
    auto one = middle(corner(1), corner(2)), other = middle(corner(3), corner(0));
    if (is_hipped) {
      const double dx = other[0] - one[0], dy = other[1] - one[1], ridge = std::max(1e-9, std::hypot(dx, dy));
      const double in = std::min(0.5, (length(first + 1) + length(first + 3)) / 4 / ridge);
      one = {one[0] + in * dx, one[1] + in * dy};
      other = {other[0] - in * dx, other[1] - in * dy};
    }
    const auto p = [&](std::size_t i) { return at(corner(i).x, corner(i).y, eave_m); };
    const auto r = at(one[0], one[1], top_m), s = at(other[0], other[1], top_m);
    for (const std::size_t side : {std::size_t{0}, std::size_t{2}}) {
      add(roof, p(side), p(side + 1), side == 0 ? r : s);
      add(roof, p(side), side == 0 ? r : s, side == 0 ? s : r);
    }
    const RenderTriangle& end = is_hipped ? roof : wall;
    add(end, p(1), p(2), r);
    add(end, p(3), p(0), s);
  }
};

/// Of a crown, from the top down: shares of the height, the radius and the leaves' light
/// (client_scripts/core/treeMesh.js).
struct CrownRing {
  double up, wide, light;
};
std::span<const CrownRing> crown_of(TreeForm form) {
  static constexpr CrownRing kRound[] = {{1, 0, 1.1}, {0.78, 0.82, 1.02}, {0.44, 1, 0.85}, {0.24, 0, 0.65}};
  static constexpr CrownRing kSlim[] = {{1, 0, 1.1}, {0.6, 0.9, 1}, {0.2, 1, 0.75}, {0.12, 0, 0.6}};
  static constexpr CrownRing kConifer[] = {{1, 0, 1.1}, {0.16, 1, 0.8}, {0.14, 0, 0.6}};
  return form == TreeForm::round  ? std::span<const CrownRing>(kRound)
         : form == TreeForm::slim ? std::span<const CrownRing>(kSlim)
                                  : std::span<const CrownRing>(kConifer);
}

/// Differs   light by face, its trunk is left out.
void add_tree(RenderMesh& mesh, const PrismTile& tile, const PrismTree& tree) {
  constexpr std::uint32_t kSides = 6;
  const double step = metres(tile.step_mm), up = metres(tile.up_step_mm);
  const double x = metres(tile.corner.x) + step * (tree.at.x + 0.5),
               y = metres(tile.corner.y) + step * (tree.at.y + 0.5);
  const double ground = metres(tile.base_mm) + up * tree.ground;
  const auto rings = crown_of(tree.form);
  std::uint32_t above = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double turn = 2 * std::numbers::pi * (i + 0.5 * double(r)) / kSides,
                   reach = up * tree.crown * rings[r].wide;
      mesh.add_point({x + reach * std::cos(turn), y + reach * std::sin(turn), ground + up * tree.height * rings[r].up});
    }
    RenderTriangle leaf{};
    if (r > 0) leaf.colour = rounded(mean_of(tile.palette[tree.leaves]) * ((rings[r - 1].light + rings[r].light) / 2));
    for (std::uint32_t i = 0; r > 0 && i < kSides; ++i) {
      const std::uint32_t next = (i + 1) % kSides;
      leaf.corners = {first + i, above + next, above + i};
      if (rings[r - 1].wide > 0) mesh.triangles.push_back(leaf);
      leaf.corners = {first + i, first + next, above + next};
      if (rings[r].wide > 0) mesh.triangles.push_back(leaf);
    }
    above = first;
  }
}

}  // namespace

double add_prisms(RenderMesh& mesh, const PrismTile& tile, bool all) {
  WindowImages windows(mesh);
  const double up = metres(tile.up_step_mm);
  for (const PrismHouse& house : tile.houses) {
    if (!house.is_owned && !all) continue;
    const double ground = metres(tile.base_mm) + up * house.ground, eave = ground + up * house.eave;
    HouseMesh h{mesh, windows, tile, house, ground, eave, eave + up * house.rise};
    h.wall.colour = tile.palette[house.wall];
    h.roof.colour = tile.palette[house.roof];
    h.add_walls();
    if (house.kind == PrismKind::flat)
      h.add_flat();
    else if (house.kind == PrismKind::tent)
      h.add_tent();
    else if (house.kind == PrismKind::faceted)
      h.add_own_roof();
    else
      h.add_ridged(house.kind == PrismKind::hipped);
  }
  for (const PrismTree& tree : tile.trees) add_tree(mesh, tile, tree);
  return windows.memory_bytes();
}

}  // namespace vicus::measure
