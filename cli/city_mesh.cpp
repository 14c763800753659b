#include "cli/city_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <span>

#include "city_db/issues.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/object_nodes.hpp"

namespace vicus {
namespace {

constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255};

class CityMeshBuilder {
 public:
  CityMeshBuilder(const CityIndex& index, const ImageSource& image, const CityMeshOptions& options)
      : index_(index), image_(image), options_(options) {}

  RenderMesh run() {
    PlanBox box;
    for (const Sector& s : index_.city().sectors)
      if (is_wanted(s))
        for (const PlanPoint& p : s.ground.outer) box.add(p);
    if (!box.is_empty())
      mesh_.origin = {metres((std::int64_t{box.min.x} + box.max.x) / 2),
                      metres((std::int64_t{box.min.y} + box.max.y) / 2), 0};
    for (const Sector& s : index_.city().sectors)
      if (is_wanted(s)) add_sector(s);
    return std::move(mesh_);
  }

 private:
  bool is_wanted(const Sector& s) const { return options_.sectors.empty() || options_.sectors.contains(s.id); }

  void add_sector(const Sector& s) {
    sector_ = &s;
    for (const Layer& layer : sector_layers(index_, s, Detail::near))
      if (layer.shading != Shading::backdrop || options_.has_city_ends)
        for (const Face& face : layer.faces) add(face, layer.shading, kBlack);
    for (const Face& face : object_faces(index_, s)) add(face, Shading::solid, kBlack);
    const int level = options_.is_as_sent ? std::min(options_.level, finest_level(index_, s)) : options_.level;
    const LevelFaces facades = sector_facades(index_, s, level);
    for (const Face& face : facades.solid) add(face, Shading::solid, kWhite);
    for (const TexturedFace& face : facades.atlas) add(face, index_.city().meta.at("atlas"));
    for (const auto& [id, face] : facades.own_images) add(face, id);
  }

  std::uint32_t add(const X3dPoint& p) {
    const PlanPoint at = plan_from_x3d(p, sector_->origin);
    return mesh_.add_point({metres(at.x), metres(at.y), metres(p.y)});
  }

  void add_corners(std::span<const X3dPoint> corners, RenderTriangle triangle) {
    std::array<std::uint32_t, 4> points{};
    for (std::size_t k = 0; k < corners.size(); ++k) points[k] = add(corners[k]);
    for (std::size_t k = 2; k < corners.size(); ++k) {
      triangle.corners = {points[0], points[k - 1], points[k]};
      mesh_.triangles.push_back(triangle);
      if (triangle.image != kNoImage) ++triangle.places;
    }
  }

  void add(const Face& face, Shading shading, Colour mark) {
    RenderTriangle triangle;
    triangle.colour = options_.marks_facades ? mark : face.colour;
    triangle.is_two_sided = shading == Shading::two_sided;
    triangle.is_lit = shading != Shading::backdrop && !options_.marks_facades;
    add_corners({face.corners.data(), static_cast<std::size_t>(face.count)}, triangle);
  }

  void add(const TexturedFace& face, const std::string& image) {
    RenderTriangle triangle;
    if (options_.marks_facades) {
      triangle.colour = kWhite;
      triangle.is_lit = false;
    } else {
      triangle.image = number_of(image);
      triangle.places = static_cast<std::uint32_t>(mesh_.places.size());
      const auto place = [&](std::size_t k) {
        return std::array{static_cast<float>(face.uv[k][0]), static_cast<float>(face.uv[k][1])};
      };
      mesh_.places.push_back({place(0), place(1), place(2)});
      mesh_.places.push_back({place(0), place(2), place(3)});
    }
    add_corners(face.corners, triangle);
  }

  std::uint32_t number_of(const std::string& image) {
    const auto [at, is_new] = images_.emplace(image, static_cast<std::uint32_t>(mesh_.images.size()));
    if (is_new) mesh_.images.emplace_back(read_png(image_(image)));
    return at->second;
  }

  const CityIndex& index_;
  const ImageSource& image_;
  const CityMeshOptions& options_;
  const Sector* sector_ = nullptr;
  RenderMesh mesh_;
  std::map<std::string, std::uint32_t> images_;
};

}  // namespace

RenderMesh city_mesh(const CityIndex& index, const ImageSource& image, const CityMeshOptions& options) {
  assert(options.level >= 1 && options.level <= 4);
  return CityMeshBuilder(index, image, options).run();
}

ImageSource textures_of(const City& city) {
  auto by_id = std::make_shared<std::map<std::string, const std::string*>>();
  for (const Texture& t : city.textures) by_id->emplace(t.id, &t.png);
  return [by_id](const std::string& id) {
    const auto at = by_id->find(id);
    if (at == by_id->end()) throw CityError("the city lacks the image textures/" + id + ".png: build it again");
    return *at->second;
  };
}

}  // namespace vicus
