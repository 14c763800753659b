#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "city_db/store.hpp"
#include "cli/city_mesh.hpp"
#include "cli/measure_representation.hpp"
#include "sectorgen/bake/bake_scene.hpp"
#include "sectorgen/sectors/tours/guide.hpp"

/// One city, read once, for all that is measured.
namespace vicus::measure {

class SharedCity {
 public:
  /// Fails   CityError as read_city and Guide.
  explicit SharedCity(const std::filesystem::path& path);

  const City& city() const { return city_; }
  const CityIndex& index() const { return *index_; }
  const CityReader& reader() const { return reader_; }
  const Guide& guide() const { return guide_; }
  const ImageSource& pngs() const { return pngs_; }
  const ReadyImages& images() const { return images_; }
  /// Made when first asked for.
  const BakeScene& bake_scene();
  /// Bytes of an artefact as it is stored; nullopt: there is none.
  std::optional<std::uint64_t> stored_bytes(const std::string& path);
  /// Sectors of L_1 (paper 004 §5.1) of a sector and why, its own first; without lists of visible sectors those behind
  /// its gates.
  std::vector<std::pair<const Sector*, VisibleReason>> seen_from(const std::string& sector_id) const;
  /// The ground that nobody sends: a plain sheet 3 m below the terrain under all of the city, seen beyond its edge.
  /// Every representation stands on it.
  void add_sheet(RenderMesh& mesh) const;

 private:
  City city_;
  CityReader reader_;
  Guide guide_;
  std::unique_ptr<CityIndex> index_;
  ImageSource pngs_;
  ReadyImages images_;
  std::unique_ptr<BakeScene> bake_scene_;
  std::map<std::string, std::optional<std::uint64_t>> bytes_;
};

/// A mesh and a tracer over it.
class MeshTracer : public Tracer {
 public:
  explicit MeshTracer(RenderMesh mesh) : scene_(std::move(mesh)), tracer_(scene_) {}
  std::optional<Met> meet(const Vec3& from, const RaySample& sample, double least) const override {
    return tracer_.meet(from, sample, least);
  }
  std::optional<double> distance(const Vec3& from, const Vec3& way, double least) const override {
    return tracer_.distance(from, way, least);
  }

 private:
  RayScene scene_;
  SceneTracer tracer_;
};

}  // namespace vicus::measure
