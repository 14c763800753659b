#include "x3d_export/prototypes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "city_db/steady_hash.hpp"
#include "city_db/tree_shape.hpp"
#include "x3d_export/colours.hpp"

namespace vicus {
namespace {

constexpr Colour kIron{52, 58, 58}, kWood{136, 100, 66}, kStone{182, 176, 164}, kBronze{82, 98, 88},
    kWater{128, 166, 184}, kRed{182, 52, 42}, kYellow{228, 188, 46}, kGlass{232, 226, 204}, kGlow{255, 232, 160},
    kPoster{204, 184, 148}, kTrunk{92, 74, 58}, kPale{226, 224, 218};

/// Faces around the foot of an object; x east, y north, z up in metres.
class ModelMaker {
 public:
  void spindle(double x, double y, int sides, double low_r, double high_r, double low, double high, Colour c) {
    FaceList list({0, 0});
    list.add_spindle({lattice_mm(x), lattice_mm(y)}, sides, low_r, high_r, low, high, c);
    for (auto& face : list.take()) faces.push_back(face);
  }
  /// Five sides of a box: nobody sees its underside.
  void box(double x, double y, double wide, double deep, double low, double high, Colour c) {
    const double x0 = x - wide / 2, x1 = x + wide / 2, y0 = y - deep / 2, y1 = y + deep / 2;
    quad({x0, y0, low}, {x1, y0, low}, {x1, y0, high}, {x0, y0, high}, c);
    quad({x1, y0, low}, {x1, y1, low}, {x1, y1, high}, {x1, y0, high}, c);
    quad({x1, y1, low}, {x0, y1, low}, {x0, y1, high}, {x1, y1, high}, c);
    quad({x0, y1, low}, {x0, y0, low}, {x0, y0, high}, {x0, y1, high}, c);
    quad({x0, y0, high}, {x1, y0, high}, {x1, y1, high}, {x0, y1, high}, c);
  }
  /// Leaves: an uneven ball, darker below.
  void leaves(double x, double y, double z, double r, double tall, Colour c, std::uint64_t seed) {
    constexpr int kSides = 6;
    const auto uneven = [&](int ring, int i) {
      return 0.88 + 0.24 * static_cast<double>((seed >> ((ring * 7 + (i % kSides) * 5) % 48)) % 16) / 15;
    };
    const auto at = [&](int ring, int i) {
      const double turn = 2 * std::numbers::pi * (i + 0.5 * ring) / kSides,
                   k = uneven(ring, i) * (ring == 0 ? 0.86 : 0.8);
      return Point{x + r * k * std::cos(turn), y + r * k * std::sin(turn), z + tall * (ring == 0 ? -0.22 : 0.42)};
    };
    const Point bottom{x, y, z - 0.75 * tall}, top{x, y, z + tall};
    for (int i = 0; i < kSides; ++i) {
      triangle(bottom, at(0, i + 1), at(0, i), shaded(c, 0.72));
      triangle(at(0, i), at(0, i + 1), at(1, i), shaded(c, 0.92));
      triangle(at(1, i), at(0, i + 1), at(1, i + 1), shaded(c, 0.98));
      triangle(at(1, i), at(1, i + 1), top, shaded(c, 1.12));
    }
  }

  std::vector<Face> faces;

 private:
  struct Point {
    double x, y, z;
  };
  static X3dPoint corner(Point p) { return x3d_from_plan({lattice_mm(p.x), lattice_mm(p.y)}, height_mm(p.z), {0, 0}); }
  void quad(Point a, Point b, Point c, Point d, Colour colour) {
    faces.push_back({{corner(a), corner(b), corner(c), corner(d)}, 4, colour});
  }
  void triangle(Point a, Point b, Point c, Colour colour) {
    faces.push_back({{corner(a), corner(b), corner(c), {}}, 3, colour});
  }
};

/// 8 m high; three looks of the round form.
ObjectModel tree_model(const StandaloneObject& object) {
  ModelMaker m;
  const TreeForm form = form_of_tree(object);
  const std::size_t look = look_of_tree(object);
  const Colour leaf = leaf_colour(form, look);
  if (form == TreeForm::conifer) {
    m.spindle(0, 0, 5, 0.16, 0.12, 0, 1.4, kTrunk);
    for (int i = 0; i < 3; ++i) {
      const double low = 1.1 + 1.9 * i, r = 1.9 - 0.5 * i;
      m.spindle(0, 0, 7, 0.3, r, low - 0.25, low, shaded(leaf, 0.7));
      m.spindle(0, 0, 7, r, 0, low, low + 3.1, shaded(leaf, 0.9 + 0.1 * i));
    }
    return {"TREE-CONIFER", m.faces, kTypicalTree_m, typical_crown_m(form), false};
  }
  if (form == TreeForm::slim) {
    m.spindle(0, 0, 5, 0.15, 0.12, 0, 1.2, kTrunk);
    m.leaves(0, 0, 3.0, 0.9, 2.6, leaf, 0x9E3779B97F4A7C15u);
    m.leaves(0.05, 0, 5.4, 0.7, 2.6, shaded(leaf, 1.07), 0xC2B2AE3D27D4EB4Fu);
    return {"TREE-SLIM", m.faces, kTypicalTree_m, typical_crown_m(form), true};
  }
  const std::uint64_t seed = steady_hash(std::to_string(look + 11));
  m.spindle(0, 0, 6, 0.19, 0.11, 0, 3.4, kTrunk);
  const double turn = 0.9 * static_cast<double>(look);
  for (int i = 0; i < 3; ++i) {
    const double a = turn + i * 2 * std::numbers::pi / 3, r = 1.05;
    m.leaves(r * std::cos(a), r * std::sin(a), 3.9 + 0.35 * i, 1.75, 1.55, shaded(leaf, 0.94 + 0.04 * i),
             seed >> (5 * i));
  }
  m.leaves(0.1, 0, 5.9, 1.7, 2.1, leaf, seed >> 3);
  return {"TREE-ROUND-" + std::to_string(look), m.faces, kTypicalTree_m, typical_crown_m(form), true};
}

/// 4.5 m: foot, post, lantern with a hat.
ObjectModel lamp_model() {
  ModelMaker m;
  m.spindle(0, 0, 6, 0.16, 0.1, 0, 0.7, kIron);
  m.spindle(0, 0, 5, 0.06, 0.045, 0.7, 3.7, kIron);
  m.spindle(0, 0, 4, 0.1, 0.22, 3.7, 4.2, kGlass);
  m.spindle(0, 0, 4, 0.27, 0, 4.2, 4.5, kIron);
  return {"LAMP", m.faces, 4.5, 1, false};
}

ObjectModel fountain_model() {
  ModelMaker m;
  m.spindle(0, 0, 10, 1.75, 1.7, 0, 0.55, kStone);
  m.spindle(0, 0, 10, 1.7, 1.45, 0.55, 0.56, shaded(kStone, 1.1));
  m.spindle(0, 0, 10, 1.45, 0, 0.45, 0.46, kWater);
  m.spindle(0, 0, 6, 0.32, 0.22, 0.4, 1.4, kStone);
  m.spindle(0, 0, 8, 0.25, 0.75, 1.4, 1.62, kStone);
  m.spindle(0, 0, 8, 0.75, 0, 1.62, 1.66, kWater);
  return {"FOUNTAIN", m.faces, 2.2, 3.5, false};
}

ObjectModel bench_model() {
  ModelMaker m;
  for (const double x : {-0.75, 0.75}) {
    m.box(x, 0.02, 0.07, 0.42, 0, 0.4, kIron);
    m.box(x, 0.24, 0.07, 0.06, 0.4, 0.8, kIron);
  }
  for (const double y : {-0.16, 0.02}) m.box(0, y, 1.8, 0.15, 0.4, 0.45, kWood);
  for (const double z : {0.55, 0.72}) m.box(0, 0.2, 1.8, 0.04, z, z + 0.12, kWood);
  return {"BENCH", m.faces, 0.85, 1.8, false};
}

ObjectModel statue_model() {
  ModelMaker m;
  m.box(0, 0, 1.8, 1.8, 0, 0.3, kStone);
  m.box(0, 0, 1.2, 1.2, 0.3, 1.7, kStone);
  m.box(0, 0, 1.4, 1.4, 1.7, 1.85, shaded(kStone, 1.06));
  m.spindle(0, 0, 6, 0.34, 0.22, 1.85, 2.7, kBronze);
  m.spindle(0, 0, 6, 0.3, 0.26, 2.7, 3.3, kBronze);
  m.spindle(0, 0, 6, 0.26, 0.08, 3.3, 3.42, kBronze);
  m.spindle(0, 0, 6, 0.08, 0.15, 3.4, 3.58, kBronze);
  m.spindle(0, 0, 6, 0.15, 0, 3.58, 3.75, kBronze);
  return {"STATUE", m.faces, 3.75, 1.8, false};
}

ObjectModel small_model(const std::string& kind) {
  ModelMaker m;
  if (kind == "bollard") {
    m.spindle(0, 0, 6, 0.09, 0.07, 0, 0.75, kIron);
    m.spindle(0, 0, 6, 0.1, 0, 0.75, 0.9, kPale);
    return {"BOLLARD", m.faces, 0.9, 0.2, false};
  }
  if (kind == "waste_basket") {
    m.box(0, 0.2, 0.06, 0.06, 0, 0.95, kIron);
    m.spindle(0, 0, 7, 0.17, 0.22, 0.3, 0.9, {62, 92, 66});
    m.spindle(0, 0, 7, 0.22, 0, 0.86, 0.87, shaded(kIron, 0.6));
    return {"BASKET", m.faces, 0.95, 0.5, false};
  }
  if (kind == "post_box") {
    m.box(0, 0, 0.12, 0.12, 0, 0.5, kIron);
    m.box(0, 0, 0.5, 0.35, 0.5, 1.35, kYellow);
    m.box(0, 0, 0.54, 0.39, 1.35, 1.42, shaded(kYellow, 0.8));
    return {"POST-BOX", m.faces, 1.42, 0.5, false};
  }
  if (kind == "clock") {
    m.spindle(0, 0, 6, 0.12, 0.07, 0, 3, kIron);
    m.box(0, 0, 0.9, 0.3, 3, 3.9, kIron);
    m.box(0, -0.16, 0.76, 0.02, 3.07, 3.83, kPale);
    m.box(0.0, -0.18, 0.04, 0.02, 3.45, 3.75, kIron);
    m.box(0.11, -0.18, 0.22, 0.02, 3.43, 3.47, kIron);
    return {"CLOCK", m.faces, 3.9, 0.9, false};
  }
  if (kind == "drinking_water") {
    m.spindle(0, 0, 8, 0.2, 0.14, 0, 0.85, kStone);
    m.spindle(0, 0, 8, 0.14, 0.27, 0.85, 0.95, kStone);
    m.spindle(0, 0, 8, 0.27, 0, 0.95, 0.96, kWater);
    return {"TAP", m.faces, 0.95, 0.5, false};
  }
  if (kind == "fire_hydrant") {
    m.spindle(0, 0, 6, 0.13, 0.1, 0, 0.6, kRed);
    m.spindle(0, 0, 6, 0.13, 0, 0.6, 0.75, kRed);
    m.box(0, 0, 0.34, 0.1, 0.38, 0.48, kRed);
    return {"HYDRANT", m.faces, 0.75, 0.3, false};
  }
  if (kind == "column") {
    m.spindle(0, 0, 10, 0.65, 0.65, 0, 2.8, kPoster);
    m.spindle(0, 0, 10, 0.78, 0.72, 2.8, 3.05, {64, 88, 72});
    m.spindle(0, 0, 10, 0.72, 0, 3.05, 3.7, {74, 100, 82});
    return {"COLUMN", m.faces, 3.7, 1.3, false};
  }
  return {};
}

ObjectModel authors_model(const Prototype& p) {
  ObjectModel model;
  model.name = "MODEL-" + p.kind;
  std::int32_t high = 1, wide = 1;
  for (const auto& point : p.points) {
    high = std::max(high, point.up_mm);
    wide = std::max({wide, 2 * std::abs(point.at.x), 2 * std::abs(point.at.y)});
  }
  model.height_m = metres(high);
  model.width_m = metres(wide);
  for (std::size_t i = 0; 3 * i + 2 < p.triangles.size(); ++i) {
    Face face{{}, 3, p.colours[i]};
    for (std::size_t k = 0; k < 3; ++k) {
      const GroundPoint& g = p.points.at(p.triangles[3 * i + k]);
      face.corners[k] = x3d_from_plan(g.at, g.up_mm, {0, 0});
    }
    model.faces.push_back(face);
  }
  return model;
}

}  // namespace

ObjectModel model_of(const CityIndex& index, const StandaloneObject& object) {
  if (const Prototype* p = index.prototype(object.kind)) return authors_model(*p);
  if (object.kind == "tree") return tree_model(object);
  if (object.kind == "street_lamp") return lamp_model();
  if (object.kind == "fountain") return fountain_model();
  if (object.kind == "bench") return bench_model();
  if (object.kind == "tram") return tram();
  if (object.kind == "statue" || object.kind == "monument" || object.kind == "memorial") return statue_model();
  return small_model(object.kind);
}

ObjectModel lamp_glow(const ObjectModel& lamp) {
  ModelMaker m;
  m.spindle(0, 0, 4, 0.11, 0.23, lamp.height_m - 0.81, lamp.height_m - 0.29, kGlow);
  m.spindle(0, 0, 10, 3.2, 0, 0.03, 0.031, kGlow);
  return {"GLOW", m.faces, lamp.height_m, 1, false};
}

ObjectModel fountain_jets() {
  ModelMaker m;
  m.spindle(0, 0, 4, 0.05, 0.02, 0, 0.75, kPale);
  m.spindle(0, 0, 4, 0.02, 0, 0.75, 0.9, kPale);
  for (int i = 0; i < 6; ++i) {
    const double a = i * std::numbers::pi / 3, c = std::cos(a), s = std::sin(a);
    m.spindle(0.74 * c, 0.74 * s, 3, 0.03, 0.05, -1.2, 0.02, kPale);
  }
  return {"JETS", m.faces, 1, 1, false};
}

ObjectModel tram() {
  ModelMaker m;
  for (const double y : {-6.2, 0.0, 6.2}) {
    m.box(0, y, 2.3, 5.9, 0.25, 1.25, kRed);
    m.box(0, y, 2.26, 5.8, 1.25, 2.5, {54, 70, 84});
    m.box(0, y, 2.3, 5.9, 2.5, 3.1, kPale);
  }
  for (const double y : {-3.1, 3.1}) m.box(0, y, 2.0, 0.5, 0.4, 2.9, {60, 62, 64});
  return {"TRAM", m.faces, 3.1, 2.3, false};
}

std::pair<double, double> scale_of(const ObjectModel& model, const StandaloneObject& object) {
  constexpr double kLeast = 0.25, kMost = 4;
  if (object.kind == "tree") return tree_scale(object, model.height_m);
  if (object.height_m <= 0) return {1, 1};
  const double up = std::clamp(object.height_m / model.height_m, kLeast, kMost);
  return {object.kind == "street_lamp" || object.kind == "clock" ? 1 : up, up};
}

}  // namespace vicus
