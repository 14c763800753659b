#include "sectorgen/bake/impostors/impostor_mesh.hpp"

#include "city_db/panorama_sides.hpp"
#include "sectorgen/bake/picture/png.hpp"

namespace vicus {
namespace {

struct UprightPicture {
  PlanPoint left, right;
  double bottom_m = 0, top_m = 0;
  float u_left = 0, u_right = 1;
};

void add_picture(RenderMesh& mesh, std::uint32_t image, const UprightPicture& p) {
  RenderTriangle look;
  look.image = image;
  look.is_lit = false;
  look.places = static_cast<std::uint32_t>(mesh.places.size());
  mesh.places.push_back({{{p.u_left, 0}, {p.u_right, 0}, {p.u_right, 1}}});
  mesh.places.push_back({{{p.u_left, 0}, {p.u_right, 1}, {p.u_left, 1}}});
  const auto at = [&](PlanPoint q, double up) { return mesh.add_point({metres(q.x), metres(q.y), up}); };
  const std::uint32_t a = at(p.left, p.bottom_m), b = at(p.right, p.bottom_m), c = at(p.right, p.top_m),
                      d = at(p.left, p.top_m);
  look.corners = {a, b, c};
  mesh.triangles.push_back(look);
  look.corners = {a, c, d};
  ++look.places;
  mesh.triangles.push_back(look);
}

std::uint32_t add_image(RenderMesh& mesh, const std::string& png) {
  mesh.images.push_back(std::make_shared<RepeatedImage>(read_png(png)));
  return static_cast<std::uint32_t>(mesh.images.size() - 1);
}

}  // namespace

void add_impostor(RenderMesh& mesh, const GateImpostor& i) {
  add_picture(mesh, add_image(mesh, i.png), {i.left, i.right, i.bottom_m, i.top_m});
}

void add_panorama(RenderMesh& mesh, const Panorama& p) {
  const std::uint32_t image = add_image(mesh, p.png);
  for (const PanoramaSide& side : sides_of(p))
    add_picture(mesh, image,
                {side.left, side.right, p.bottom_m, p.top_m, static_cast<float>(side.u_left),
                 static_cast<float>(side.u_right)});
}

}  // namespace vicus
