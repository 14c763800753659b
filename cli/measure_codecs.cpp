#include "cli/measure_codecs.hpp"

#include <algorithm>
#include <map>

#include "city_db/surroundings.hpp"
#include "cli/measure_glb_mesh.hpp"
#include "cli/measure_sector_parts.hpp"
#include "cli/measure_tile_codecs.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "x3d_export/coding.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus::measure {
namespace {

constexpr std::uint32_t kSteps_mm[] = {1, 3, 10, 30, 100, 300, 1000};
constexpr double kPlaces[] = {0.2, 0.5, 0.8};  // of the path
constexpr int kLevel = 3, kBrotli = 6;

/// The near sectors of one view, and what they look like not coded.
struct StreetView {
  Camera camera;
  std::vector<const Sector*> sectors;
  Picture truth;
};

class StreetCodecs {
 public:
  StreetCodecs(SharedCity& city, const RunOptions& options) : city_(city), options_(options) {}

  void add_view(const Pose& pose) {
    const PictureSize& size = options_.sizes.front();
    StreetView view{camera_at(pose.eye, pose.look, kFieldOfView, size.width, size.height), {}, {}};
    std::vector<SectorPart> parts;
    for (const auto& [sector, reason] : city_.seen_from(pose.sector_id))
      if (reason == VisibleReason::self || reason == VisibleReason::gate) {
        view.sectors.push_back(sector);
        parts.push_back({sector, Detail::near, kLevel});
      }
    view.truth = look(*scene_of(city_, parts).tracer, view.camera);
    views_.push_back(std::move(view));
  }

  std::vector<CodecRow> run() {
    std::vector<CodecRow> rows;
    CodecRow x3d{kStreet, "X3D, brotli", "1 mm", 0, 0, static_cast<int>(views_.size())};
    for (const StreetView& view : views_)
      for (const Sector* sector : view.sectors)
        for (const ExportFile& file :
             sector_files(city_.index(), *sector, Detail::near, SceneFormat::x3d, kFileLimit_bytes, kLevel))
          x3d.bytes += static_cast<double>(brotli(file.text, kBrotli).size()) / static_cast<double>(views_.size());
    rows.push_back(x3d);
    for (const GlbCoding coding : {GlbCoding::draco, GlbCoding::meshopt})
      for (const std::uint32_t step : kSteps_mm) rows.push_back(glb(coding, step));
    return rows;
  }

 private:
  static constexpr const char* kStreet = "street geometry";

  CodecRow glb(GlbCoding coding, std::uint32_t step_mm) {
    CodecRow row{kStreet,
                 coding == GlbCoding::draco ? "GLB, Draco" : "GLB, meshopt",
                 std::to_string(step_mm) + " mm",
                 0,
                 0,
                 static_cast<int>(views_.size())};
    const auto n = static_cast<double>(views_.size());
    for (const StreetView& view : views_) {
      RenderMesh mesh;
      mesh.origin = view.camera.eye;
      for (const Sector* sector : view.sectors) {
        const GlbOptions options{coding, step_mm};
        const std::string bare = sector_glb(
            city_.index(), *sector, Detail::near, [](const std::string&) { return std::string(); }, options);
        row.bytes += static_cast<double>(std::min(bare.size(), brotli(bare, kBrotli).size())) / n;
        add_glb(mesh, sector_glb(city_.index(), *sector, Detail::near, city_.pngs(), options), sector->origin, images_);
      }
      city_.add_sheet(mesh);
      row.flip += flip_mean(view.truth, look(MeshTracer(std::move(mesh)), view.camera)) / n;
    }
    return row;
  }

  Picture look(const Tracer& tracer, const Camera& camera) const {
    const PictureSize& size = options_.sizes.front();
    return render(tracer, camera, {size.width, size.height, options_.samples, 0.05, options_.threads}).colour;
  }

  SharedCity& city_;
  const RunOptions& options_;
  std::vector<StreetView> views_;
  PngImages images_;
};

}  // namespace

std::vector<CodecRow> compare_codecs(SharedCity& city, const Course& course, const RunOptions& options) {
  StreetCodecs street(city, options);
  std::vector<Pose> flown;
  const FlyPath fly(city.city());
  for (const double share : kPlaces) {
    street.add_view(walk_pose(course.tour(), share * course.tour().length_m));
    flown.push_back(fly.at(share * kFly_m));
  }
  auto rows = street.run();
  for (CodecRow& row : compare_tile_codecs(city, flown, options)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace vicus::measure
