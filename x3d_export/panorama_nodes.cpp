#include "x3d_export/panorama_nodes.hpp"

#include "city_db/panorama_sides.hpp"
#include "x3d_export/frames.hpp"

namespace vicus {

std::string panorama_path(const std::string& sector_id) { return "panoramas/" + sector_id + ".png"; }

std::vector<Node> panorama_nodes(const CityIndex& index, const Sector& sector) {
  const Panorama* panorama = index.panorama_of(sector.id);
  if (panorama == nullptr) return {};
  std::vector<double> points, places;
  std::vector<std::int32_t> corners;
  const auto add = [&](PlanPoint at, double up_m, double u, double v) {
    const X3dPoint p = x3d_from_plan(at, height_mm(up_m), sector.origin);
    points.insert(points.end(), {metres(p.x), metres(p.y), metres(p.z)});
    places.insert(places.end(), {u, v});
    corners.push_back(static_cast<std::int32_t>(points.size() / 3 - 1));
  };
  for (const PanoramaSide& side : sides_of(*panorama)) {
    add(side.left, panorama->bottom_m, side.u_left, 0);
    add(side.right, panorama->bottom_m, side.u_right, 0);
    add(side.right, panorama->top_m, side.u_right, 1);
    add(side.left, panorama->top_m, side.u_left, 1);
    corners.push_back(-1);
  }
  Node texture("ImageTexture"), material("UnlitMaterial"), appearance("Appearance"), coordinate("Coordinate"),
      place("TextureCoordinate"), geometry("IndexedFaceSet"), shape("Shape"), group("Group", "PANORAMA");
  texture.set("repeatS", false).set("repeatT", false).set("load", false);
  texture.set("url", std::vector<std::string>{"../" + panorama_path(sector.id)});
  material.set("emissiveColor", std::vector<double>{1, 1, 1});
  appearance.add("material", std::move(material)).add("texture", std::move(texture));
  geometry.set("coordIndex", std::move(corners));
  geometry.add("coord", coordinate.set("point", std::move(points)));
  geometry.add("texCoord", place.set("point", std::move(places)));
  shape.add("appearance", std::move(appearance)).add("geometry", std::move(geometry));
  group.set("visible", false);
  return {group.add(std::move(shape))};
}

}  // namespace vicus
