#include "cli/city_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <span>

#include "city_db/issues.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "x3d_export/far_windows.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/object_nodes.hpp"

namespace vicus {
namespace {

constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255};

Vec3 middle_of(const CityIndex& index, const std::set<std::string>& wanted) {
  PlanBox box;
  for (const Sector& s : index.city().sectors)
    if (wanted.empty() || wanted.contains(s.id))
      for (const PlanPoint& p : s.ground.outer) box.add(p);
  if (box.is_empty()) return {};
  return {metres((std::int64_t{box.min.x} + box.max.x) / 2), metres((std::int64_t{box.min.y} + box.max.y) / 2), 0};
}

class CityMeshBuilder {
 public:
  CityMeshBuilder(const CityIndex& index, const ReadyImages& image, const CityMeshOptions& options)
      : index_(index), image_(image), options_(options) {
    mesh_.origin = middle_of(index, options.sectors);
  }

  RenderMesh whole() {
    for (const Sector& s : index_.city().sectors)
      if (options_.sectors.empty() || options_.sectors.contains(s.id)) {
        add_body(s, Detail::near);
        const int level = options_.is_as_sent ? std::min(options_.level, finest_level(index_, s)) : options_.level;
        add_facades(sector_facades(index_, s, level));
      }
    return std::move(mesh_);
  }

  RenderMesh of(const std::vector<SectorPart>& parts, std::vector<std::uint32_t>& first_triangles) {
    for (const SectorPart& part : parts) {
      first_triangles.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
      add_body(*part.sector, part.detail);
      if (part.detail != Detail::near) continue;
      const int finest = finest_level(index_, *part.sector);
      const auto pieces = sector_pieces(index_, *part.sector);
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const int level = i < part.levels.size() ? part.levels[i] : part.level;
        add_facades(pieces[i].levels[std::min(level, finest) - 1]);
      }
    }
    first_triangles.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
    return std::move(mesh_);
  }

 private:
  void add_body(const Sector& s, Detail detail) {
    sector_ = &s;
    for (const Layer& layer : sector_layers(index_, s, detail))
      if (layer.shading != Shading::backdrop || options_.has_city_ends)
        for (const Face& face : layer.faces) add(face, layer.shading, kBlack);
    if (detail != Detail::near) return;
    for (const Face& face : object_faces(index_, s)) add(face, Shading::solid, kBlack);
  }

  void add_facades(const LevelFaces& facades) {
    for (const Face& face : facades.solid) add(face, Shading::solid, kWhite);
    for (const TexturedFace& face : facades.atlas) add(face, index_.city().meta.at("atlas"));
    for (const auto& [id, list] : facades.own_images)
      for (const TexturedFace& face : list) add(face, id);
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
    if (face.bays > 0 && !options_.marks_facades) {
      triangle.image = number_of_windows(face.colour);
      const auto u = static_cast<float>(face.bays), v = static_cast<float>(face.floors);
      add_places({{{0, 0}, {u, 0}, {u, v}, {0, v}}}, triangle);
    }
    add_corners({face.corners.data(), static_cast<std::size_t>(face.count)}, triangle);
  }

  void add(const TexturedFace& face, const std::string& image) {
    RenderTriangle triangle;
    if (options_.marks_facades) {
      triangle.colour = kWhite;
      triangle.is_lit = false;
    } else {
      triangle.image = number_of(image);
      std::array<std::array<float, 2>, 4> places{};
      for (std::size_t k = 0; k < 4; ++k)
        places[k] = {static_cast<float>(face.uv[k][0]), static_cast<float>(face.uv[k][1])};
      add_places(places, triangle);
    }
    add_corners(face.corners, triangle);
  }

  void add_places(const std::array<std::array<float, 2>, 4>& places, RenderTriangle& triangle) {
    triangle.places = static_cast<std::uint32_t>(mesh_.places.size());
    mesh_.places.push_back({places[0], places[1], places[2]});
    mesh_.places.push_back({places[0], places[2], places[3]});
  }

  /// The pattern of far windows (x3d_export/far_windows.hpp) over a wall of this colour.
  std::uint32_t number_of_windows(Colour wall) {
    const auto [at, is_new] = windows_.emplace(wall, static_cast<std::uint32_t>(mesh_.images.size()));
    if (!is_new) return at->second;
    const auto pattern = window_pattern();
    const Colour colour = under_windows(wall);
    CutOut picture(kWindowTexels, kWindowTexels);
    for (int row = 0; row < kWindowTexels; ++row)
      for (int column = 0; column < kWindowTexels; ++column) {
        const auto light = static_cast<float>(pattern[static_cast<std::size_t>(row * kWindowTexels + column)]) / 255;
        const auto channel = [&](std::uint8_t value) { return light * static_cast<float>(value) / 255; };
        picture.at(column, kWindowTexels - 1 - row) = {channel(colour.r), channel(colour.g), channel(colour.b), 1};
      }
    mesh_.images.push_back(std::make_shared<RepeatedImage>(picture));
    return at->second;
  }

  std::uint32_t number_of(const std::string& image) {
    const auto [at, is_new] = images_.emplace(image, static_cast<std::uint32_t>(mesh_.images.size()));
    if (is_new) mesh_.images.push_back(image_(image));
    return at->second;
  }

  const CityIndex& index_;
  const ReadyImages image_;
  const CityMeshOptions options_;
  const Sector* sector_ = nullptr;
  RenderMesh mesh_;
  std::map<std::string, std::uint32_t> images_;
  std::map<Colour, std::uint32_t> windows_;
};

}  // namespace

RenderMesh city_mesh(const CityIndex& index, const ImageSource& image, const CityMeshOptions& options) {
  return city_mesh(index, cached(image), options);
}

RenderMesh city_mesh(const CityIndex& index, const ReadyImages& images, const CityMeshOptions& options) {
  assert(options.level >= 1 && options.level <= 4);
  return CityMeshBuilder(index, images, options).whole();
}

RenderMesh parts_mesh(const CityIndex& index, const ReadyImages& images, const std::vector<SectorPart>& parts,
                      bool has_city_ends, std::vector<std::uint32_t>* first_triangles) {
  CityMeshOptions options;
  options.has_city_ends = has_city_ends;
  std::vector<std::uint32_t> first;
  RenderMesh mesh = CityMeshBuilder(index, images, options).of(parts, first);
  if (first_triangles != nullptr) *first_triangles = std::move(first);
  return mesh;
}

ReadyImages cached(ImageSource image) {
  using Known = std::map<std::string, std::shared_ptr<const RepeatedImage>>;
  return [image = std::move(image), known = std::make_shared<Known>()](const std::string& id) {
    auto& made = (*known)[id];
    if (!made) made = std::make_shared<RepeatedImage>(read_png(image(id)));
    return made;
  };
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
