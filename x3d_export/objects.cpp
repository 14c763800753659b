#include "x3d_export/objects.hpp"

#include <algorithm>

#include "city_db/tree_shape.hpp"

namespace vicus {
namespace {

constexpr double kLamp_m = 4.5;  // typical, where the map names no height
/// What a visitor steps over, and what passes above his head.
constexpr double kShin_m = 0.3, kHead_m = 1.95;

std::vector<Spindle> tree(const StandaloneObject& object) {
  constexpr Colour kTrunk{94, 74, 56};
  const TreeShape shape = shape_of_tree(object);
  const double h = shape.height_m;
  return {{3, 0.02 * h, 0.02 * h, 0, 0.4 * h, kTrunk},
          {5, 0, shape.crown_m, 0.28 * h, 0.55 * h, shape.leaves},
          {5, shape.crown_m, 0, 0.55 * h, h, shape.leaves}};
}

std::vector<Spindle> lamp(const StandaloneObject& object) {
  constexpr Colour kPost{60, 66, 62}, kGlass{236, 228, 200};
  const double h = object.height_m > 0 ? object.height_m : kLamp_m;
  return {
      {3, 0.08, 0.05, 0, h - 0.6, kPost}, {4, 0.06, 0.2, h - 0.6, h - 0.2, kGlass}, {4, 0.22, 0, h - 0.2, h, kPost}};
}

/// The widest the spindle is between two heights; 0 where it does not reach there.
double widest_m(const Spindle& s, double from_m, double to_m) {
  const double low = std::max(s.low_m, from_m), high = std::min(s.high_m, to_m);
  if (low >= high) return 0;
  const auto radius_at = [&](double up_m) {
    return s.radius_low_m + (s.radius_high_m - s.radius_low_m) * (up_m - s.low_m) / (s.high_m - s.low_m);
  };
  return std::max(radius_at(low), radius_at(high));
}

}  // namespace

std::vector<Spindle> spindles_of(const StandaloneObject& object) {
  constexpr Colour kStone{176, 170, 158}, kWater{122, 158, 176}, kBronze{86, 96, 86}, kWood{128, 98, 68};
  constexpr Colour kIron{58, 64, 62}, kYellow{226, 186, 44}, kRed{178, 52, 42}, kPoster{196, 176, 140};
  if (object.kind == "tree") return tree(object);
  if (object.kind == "street_lamp") return lamp(object);
  if (object.kind == "fountain")
    return {{8, 1.6, 1.6, 0, 0.5, kStone}, {8, 1.6, 0, 0.5, 0.51, kWater}, {6, 0.2, 0, 0.4, 2.2, kStone}};
  if (object.kind == "bench") return {{4, 0.5, 0.5, 0, 0.45, kWood}, {4, 0.5, 0, 0.45, 0.46, kWood}};
  if (object.kind == "statue" || object.kind == "monument" || object.kind == "memorial")
    return {{4, 0.7, 0.6, 0, 1.4, kStone}, {4, 0.6, 0, 1.4, 1.41, kStone}, {6, 0.35, 0, 1.4, 3.4, kBronze}};
  if (object.kind == "bollard") return {{5, 0.09, 0.08, 0, 0.8, kIron}, {5, 0.08, 0, 0.8, 0.88, kIron}};
  if (object.kind == "waste_basket") return {{6, 0.2, 0.24, 0.15, 0.95, kIron}, {6, 0.24, 0, 0.95, 1.0, kIron}};
  if (object.kind == "post_box") return {{4, 0.3, 0.3, 0.4, 1.4, kYellow}, {4, 0.3, 0, 1.4, 1.5, kYellow}};
  if (object.kind == "clock") return {{4, 0.08, 0.06, 0, 3, kIron}, {8, 0.4, 0.4, 3, 3.2, kStone}};
  if (object.kind == "drinking_water") return {{6, 0.16, 0.13, 0, 0.95, kIron}, {6, 0.2, 0, 0.95, 1.05, kIron}};
  if (object.kind == "fire_hydrant") return {{6, 0.12, 0.1, 0, 0.6, kRed}, {6, 0.1, 0, 0.6, 0.72, kRed}};
  if (object.kind == "column")
    return {{8, 0.65, 0.65, 0, 2.9, kPoster}, {8, 0.75, 0.7, 2.9, 3.1, kIron}, {8, 0.7, 0, 3.1, 3.6, kIron}};
  return {};
}

std::vector<Spindle> far_spindles_of(const StandaloneObject& object) {
  constexpr double kLeast_m = 4;
  if (object.kind != "tree") return {};
  auto parts = tree(object);
  if (parts.back().high_m < kLeast_m) return {};
  for (auto& s : parts) s.sides = 3;
  parts[1].radius_low_m = 0.45 * parts[1].radius_high_m;  // a steep side gets light, an underside none
  return parts;
}

double body_radius_m(const StandaloneObject& object) {
  double radius_m = 0;
  for (const auto& s : spindles_of(object)) radius_m = std::max(radius_m, widest_m(s, kShin_m, kHead_m));
  return radius_m;
}

}  // namespace vicus
