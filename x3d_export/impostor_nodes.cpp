#include "x3d_export/impostor_nodes.hpp"

#include <cmath>

#include "x3d_export/frames.hpp"

namespace vicus {
namespace {

/// At an end of the city the picture stands before the wall that closes it.
constexpr double kBeforeWall_m = 0.1;

std::vector<double> corners_of(const GateImpostor& i, PlanPoint origin) {
  const double dx = i.right.x - i.left.x, dy = i.right.y - i.left.y, width = std::hypot(dx, dy);
  const double out = i.is_solid && width > 0 ? kBeforeWall_m * kMmPerMetre / width : 0;
  // Towards the eye is on the right of left -> right.
  const auto moved = [&](PlanPoint p) {
    return PlanPoint{p.x + static_cast<std::int32_t>(std::lround(out * dy)),
                     p.y - static_cast<std::int32_t>(std::lround(out * dx))};
  };
  std::vector<double> points;
  const auto add = [&](PlanPoint p, double up_m) {
    const X3dPoint q = x3d_from_plan(moved(p), height_mm(up_m), origin);
    points.insert(points.end(), {metres(q.x), metres(q.y), metres(q.z)});
  };
  add(i.left, i.bottom_m);
  add(i.right, i.bottom_m);
  add(i.right, i.top_m);
  add(i.left, i.top_m);
  return points;
}

}  // namespace

std::string impostor_path(const std::string& gate_id) { return "impostors/" + gate_id + ".png"; }

std::vector<Node> impostor_nodes(const CityIndex& index, const Sector& sector) {
  std::vector<Node> nodes;
  for (const GateImpostor* impostor : index.impostors_of(sector.id)) {
    Node texture("ImageTexture"), material("UnlitMaterial"), appearance("Appearance"), coordinate("Coordinate"),
        places("TextureCoordinate"), geometry("IndexedFaceSet"), shape("Shape"),
        group("Group", "IMPOSTOR-" + impostor->gate_id);
    texture.set("repeatS", false).set("repeatT", false);
    texture.set("url", std::vector<std::string>{"../" + impostor_path(impostor->gate_id)});
    if (!impostor->is_solid) {
      texture.set("load", false);
      group.set("visible", false);
    }
    material.set("emissiveColor", std::vector<double>{1, 1, 1});
    appearance.add("material", std::move(material)).add("texture", std::move(texture));
    geometry.set("coordIndex", std::vector<std::int32_t>{0, 1, 2, 3, -1});
    geometry.add("coord", coordinate.set("point", corners_of(*impostor, sector.origin)));
    geometry.add("texCoord", places.set("point", std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1}));
    shape.add("appearance", std::move(appearance)).add("geometry", std::move(geometry));
    nodes.push_back(group.add(std::move(shape)));
  }
  return nodes;
}

}  // namespace vicus
