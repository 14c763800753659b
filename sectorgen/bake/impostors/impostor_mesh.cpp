#include "sectorgen/bake/impostors/impostor_mesh.hpp"

#include "sectorgen/bake/picture/png.hpp"

namespace vicus {

void add_impostor(RenderMesh& mesh, const GateImpostor& i) {
  mesh.images.push_back(std::make_shared<RepeatedImage>(read_png(i.png)));
  RenderTriangle look;
  look.image = static_cast<std::uint32_t>(mesh.images.size() - 1);
  look.is_lit = false;
  look.places = static_cast<std::uint32_t>(mesh.places.size());
  mesh.places.push_back({{{0, 0}, {1, 0}, {1, 1}}});
  mesh.places.push_back({{{0, 0}, {1, 1}, {0, 1}}});
  const auto at = [&](PlanPoint p, double up) { return mesh.add_point({metres(p.x), metres(p.y), up}); };
  const std::uint32_t a = at(i.left, i.bottom_m), b = at(i.right, i.bottom_m), c = at(i.right, i.top_m),
                      d = at(i.left, i.top_m);
  look.corners = {a, b, c};
  mesh.triangles.push_back(look);
  look.corners = {a, c, d};
  ++look.places;
  mesh.triangles.push_back(look);
}

}  // namespace vicus
