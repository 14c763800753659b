#include "x3d_export/facade_levels.hpp"

#include <algorithm>
#include <cmath>

#include "x3d_export/colours.hpp"
#include "x3d_export/wall_frame.hpp"
#include "x3d_export/wall_pieces.hpp"

namespace vicus {
namespace {

constexpr int kDeepFloors = 10;
constexpr std::size_t kBalconyTriangles = 10, kSillTriangles = 6;
// In shadow: along a street the reveals hide the panes, and a facade that got lighter by it would differ from its
// image.
constexpr double kReveal = 0.6, kSoffit = 0.5;

class FacadeBuilder {
 public:
  FacadeBuilder(const Facade& facade, Colour wall, double ground_m, PlanPoint origin)
      : facade_(facade),
        frame_(facade.a, facade.b, origin, ground_m),
        wall_(wall),
        stone_(shaded(wall, 1.05)),
        openings_(openings_of(facade)) {
    for (Opening& o : openings_) {
      o.z0 += facade.bottom_m;
      o.z1 += facade.bottom_m;
    }
  }

  void silhouette(LevelFaces& level, Colour colour) const {
    front(level, 0, frame_.length_m(), facade_.bottom_m, facade_.top_m, 0, colour);
  }

  void quads(LevelFaces& level, int first_floor) const {
    for (const Opening& o : openings_)
      if (o.floor >= first_floor) level.atlas.push_back(image_face(o, kQuadOffset_m));
  }

  void textured(LevelFaces& level) const { under_image(level, 0, frame_.length_m(), facade_.bottom_m, facade_.top_m); }

  /// One image serves houses with different doors: they stand in front of it. Own ones are in the image.
  void doors(LevelFaces& level) const {
    if (!facade_.openings.empty()) return;
    for (const Opening& o : openings_)
      if (is_door(o)) level.atlas.push_back(image_face(o, kQuadOffset_m));
  }

  /// Balconies and sills up to about the triangles of level 2's quads.
  void relief(LevelFaces& level, std::size_t taken) const {
    const auto doors = std::count_if(openings_.begin(), openings_.end(), is_door);
    const std::size_t quads = 2 * (openings_.size() - static_cast<std::size_t>(doors));
    std::size_t budget = quads - std::min(quads, taken);
    for (const Opening& o : openings_)
      if (has_balcony(o) && budget >= kBalconyTriangles) {
        balcony(level, o);
        budget -= kBalconyTriangles;
      }
    for (const Opening& o : openings_)
      if (o.z0 > facade_.bottom_m + 0.2 && !has_balcony(o) && budget >= kSillTriangles) {
        sill(level, o);
        budget -= kSillTriangles;
      }
  }

  /// The wall under its image as bands and piers round the openings, and the openings behind it.
  void deep(LevelFaces& level) const {
    if (!facade_.openings.empty()) return deep_anywhere(level);
    double band = facade_.bottom_m;
    for (std::size_t i = 0; i < openings_.size();) {
      const int floor = openings_[i].floor;
      if (floor >= kDeepFloors) break;
      std::size_t end = i;
      double low = facade_.top_m, high = facade_.bottom_m;
      for (; end < openings_.size() && openings_[end].floor == floor; ++end) {
        low = std::min(low, openings_[end].z0);
        high = std::max(high, openings_[end].z1);
      }
      under_image(level, 0, frame_.length_m(), band, low);
      double x = 0;
      for (; i < end; ++i) {
        const Opening& o = openings_[i];
        under_image(level, x, o.x0, low, high);
        under_image(level, o.x0, o.x1, low, o.z0);
        under_image(level, o.x0, o.x1, o.z1, high);
        recess(level, o);
        x = o.x1;
      }
      under_image(level, x, frame_.length_m(), low, high);
      band = high;
    }
    under_image(level, 0, frame_.length_m(), band, facade_.top_m);
  }

  /// The same with openings that stand in no rows.
  void deep_anywhere(LevelFaces& level) const {
    std::vector<Opening> deep;
    for (const Opening& o : openings_)
      if (o.floor < kDeepFloors) deep.push_back(o);
    for (const WallRectangle& p : wall_pieces(frame_.length_m(), facade_.bottom_m, facade_.top_m, deep))
      under_image(level, p.x0, p.x1, p.z0, p.z1);
    for (const Opening& o : deep) recess(level, o);
  }

  /// Openings floor by floor, from the left.
  void sort_by_floor() {
    std::stable_sort(openings_.begin(), openings_.end(), [](const Opening& a, const Opening& b) {
      return std::pair(a.floor, a.x0) < std::pair(b.floor, b.x0);
    });
  }

 private:
  static bool is_door(const Opening& o) {
    return o.kind == OpeningKind::house_door || o.kind == OpeningKind::church_door;
  }
  void add(LevelFaces& level, X3dPoint p, X3dPoint q, X3dPoint r, X3dPoint s, Colour colour) const {
    level.solid.push_back({{p, q, r, s}, 4, colour});
  }
  void front(LevelFaces& level, double x0, double x1, double z0, double z1, double out, Colour colour) const {
    if (height_mm(z0) >= height_mm(z1) || height_mm(x0) >= height_mm(x1)) return;
    add(level, frame_.at(x0, z0, out), frame_.at(x1, z0, out), frame_.at(x1, z1, out), frame_.at(x0, z1, out), colour);
  }
  /// A piece of the wall under the part of the facade's image that lies there.
  void under_image(LevelFaces& level, double x0, double x1, double z0, double z1) const {
    if (height_mm(z0) >= height_mm(z1) || height_mm(x0) >= height_mm(x1)) return;
    const auto u = [&](double x) { return x / frame_.length_m() * facade_.repeats; };
    const auto v = [&](double z) { return (z - facade_.bottom_m) / (facade_.top_m - facade_.bottom_m); };
    level.own_images[facade_.texture].push_back(
        {{frame_.at(x0, z0, 0), frame_.at(x1, z0, 0), frame_.at(x1, z1, 0), frame_.at(x0, z1, 0)},
         {{{u(x0), v(z0)}, {u(x1), v(z0)}, {u(x1), v(z1)}, {u(x0), v(z1)}}}});
  }
  void upper_side(LevelFaces& level, double x0, double x1, double z, double back, double out, Colour colour) const {
    add(level, frame_.at(x0, z, back), frame_.at(x0, z, out), frame_.at(x1, z, out), frame_.at(x1, z, back), colour);
  }
  void under_side(LevelFaces& level, double x0, double x1, double z, double back, double out, Colour colour) const {
    add(level, frame_.at(x0, z, back), frame_.at(x1, z, back), frame_.at(x1, z, out), frame_.at(x0, z, out), colour);
  }
  /// Seen by who looks towards larger x (is_left), or smaller.
  void cheek(LevelFaces& level, double x, double z0, double z1, double back, double out, bool is_left,
             Colour colour) const {
    if (is_left)
      add(level, frame_.at(x, z0, back), frame_.at(x, z0, out), frame_.at(x, z1, out), frame_.at(x, z1, back), colour);
    else
      add(level, frame_.at(x, z0, back), frame_.at(x, z1, back), frame_.at(x, z1, out), frame_.at(x, z0, out), colour);
  }

  TexturedFace image_face(const Opening& o, double out) const {
    const AtlasTile t = atlas_tile(o.kind);
    return {{frame_.at(o.x0, o.z0, out), frame_.at(o.x1, o.z0, out), frame_.at(o.x1, o.z1, out),
             frame_.at(o.x0, o.z1, out)},
            {{{t.u0, t.v0}, {t.u1, t.v0}, {t.u1, t.v1}, {t.u0, t.v1}}}};
  }

  void recess(LevelFaces& level, const Opening& o) const {
    const double depth = o.depth;
    const Colour side = shaded(wall_, kReveal), top = shaded(wall_, kSoffit);
    cheek(level, o.x0, o.z0, o.z1, -depth, 0, false, side);
    cheek(level, o.x1, o.z0, o.z1, -depth, 0, true, side);
    upper_side(level, o.x0, o.x1, o.z0, -depth, 0, stone_);
    under_side(level, o.x0, o.x1, o.z1, -depth, 0, top);
    level.atlas.push_back(image_face(o, -depth));
  }

  /// Old stone houses have them on the second and the last floor, others now and then.
  bool has_balcony(const Opening& o) const {
    const bool is_window = o.kind == OpeningKind::tall_window || o.kind == OpeningKind::wide_window;
    if (!is_window || o.floor < 1) return false;
    if (facade_.style == FacadeStyle::stone) return o.floor == 2 || o.floor == facade_.floors - 1;
    return facade_.style == FacadeStyle::modern && o.bay % 3 == 1;
  }

  void balcony(LevelFaces& level, const Opening& o) const {
    const double x0 = o.x0 - 0.25, x1 = o.x1 + 0.25, z0 = o.z0 - 0.14, z1 = o.z0 - 0.02, out = 0.5;
    front(level, x0, x1, z0, z1, out, stone_);
    upper_side(level, x0, x1, z1, 0, out, stone_);
    under_side(level, x0, x1, z0, 0, out, shaded(wall_, 0.7));
    cheek(level, x0, z0, z1, 0, out, true, stone_);
    cheek(level, x1, z0, z1, 0, out, false, stone_);
  }

  void sill(LevelFaces& level, const Opening& o) const {
    const double x0 = o.x0 - 0.08, x1 = o.x1 + 0.08, z0 = o.z0 - 0.1, out = 0.1;
    front(level, x0, x1, z0, o.z0, out, stone_);
    upper_side(level, x0, x1, o.z0, 0, out, stone_);
    under_side(level, x0, x1, z0, 0, out, shaded(wall_, 0.7));
  }

  const Facade& facade_;
  WallFrame frame_;
  Colour wall_, stone_;
  std::vector<Opening> openings_;
};

}  // namespace

std::size_t LevelFaces::triangles() const {
  std::size_t count = 2 * atlas.size();
  for (const auto& [texture, faces] : own_images) count += 2 * faces.size();
  for (const Face& face : solid) count += static_cast<std::size_t>(face.count) - 2;
  return count;
}

Colour opening_colour(OpeningKind kind) {
  constexpr Colour kColours[kOpeningKinds] = {{120, 126, 130}, {130, 136, 140}, {123, 130, 136}, {121, 129, 135},
                                              {61, 55, 48},    {71, 44, 29},    {86, 86, 79},    {71, 63, 65}};
  return kColours[static_cast<std::size_t>(kind)];
}

Colour mean_colour(const Facade& facade, Colour wall) {
  const double whole = length_m(facade) * (facade.top_m - facade.bottom_m);
  if (whole <= 0) return wall;
  double rest = whole, r = 0, g = 0, b = 0;
  const auto add = [&](double area, Colour c) {
    r += area * c.r;
    g += area * c.g;
    b += area * c.b;
  };
  for (const Opening& o : openings_of(facade)) {
    const double area = (o.x1 - o.x0) * (o.z1 - o.z0);
    add(area, opening_colour(o.kind));
    rest -= area;
  }
  add(std::max(0.0, rest), wall);
  const auto channel = [&](double sum) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(sum / whole, 0.0, 255.0)));
  };
  return {channel(r), channel(g), channel(b)};
}

void add_facade(const Facade& facade, Colour wall, double ground_m, PlanPoint origin, std::size_t taken,
                LevelFaces (&levels)[4]) {
  FacadeBuilder builder(facade, wall, ground_m, origin);
  builder.sort_by_floor();
  builder.silhouette(levels[0], mean_colour(facade, wall));
  builder.silhouette(levels[1], wall);
  builder.quads(levels[1], 0);
  builder.textured(levels[2]);
  builder.doors(levels[2]);
  builder.relief(levels[2], taken);
  builder.deep(levels[3]);
  builder.quads(levels[3], kDeepFloors);
  builder.relief(levels[3], taken);
}

std::vector<Facade> split_facade(const Facade& facade, int most) {
  const int each = std::max(1, most / std::max(1, facade.bays * facade.floors));
  const int pieces = (facade.repeats + each - 1) / each;
  std::vector<Facade> out;
  const auto cut = [&](int repeat) {
    const double t = static_cast<double>(repeat) / facade.repeats;
    return PlanPoint{facade.b.x + static_cast<std::int32_t>(std::lround(t * (facade.a.x - facade.b.x))),
                     facade.b.y + static_cast<std::int32_t>(std::lround(t * (facade.a.y - facade.b.y)))};
  };
  for (int i = 0; i < pieces; ++i) {
    const int first = facade.repeats * i / pieces, last = facade.repeats * (i + 1) / pieces;
    Facade piece = facade;
    piece.b = cut(first);
    piece.a = cut(last);
    piece.repeats = last - first;
    out.push_back(std::move(piece));
  }
  return out;
}

}  // namespace vicus
