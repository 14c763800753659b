#include "cli/measure_glb_forms.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/boxes.hpp"
#include "cli/measure_glb_mesh.hpp"
#include "cli/measure_memory.hpp"
#include "cli/measure_sector_parts.hpp"
#include "x3d_export/coding.hpp"

namespace vicus::measure {
namespace {

constexpr double kFarError_m = 2.5;  // as tileset.json states it
constexpr double kNearest_m = 1;
constexpr int kBrotli = 6;

/// A file's bytes, kept; what is sent is their brotli where that is less.
struct GlbFile {
  std::string bytes;
  std::uint64_t sent = 0;
};

class GlbFiles : public Representation {
 public:
  GlbFiles(SharedCity& city, GlbCoding coding, double tau_px) : city_(city), coding_(coding) {
    char text[32];
    std::snprintf(text, sizeof text, "tau %g px", tau_px);
    name_ = {coding == GlbCoding::draco ? "GLB, Draco" : "GLB, meshopt", text, tau_px};
  }

  const FormName& name() const override { return name_; }
  bool shows(Path) const override { return true; }

  Parts choose(const Pose& pose, double pixels_per_radian, const Parts&) override {
    Parts out;
    const auto add = [&](const Sector& s) {
      const double error_px = kFarError_m * pixels_per_radian / std::max(kNearest_m, away_m(s, pose.eye));
      out.push_back(part_text({&s, error_px > name_.tau_px ? Detail::near : Detail::far, 3}));
    };
    if (pose.path == Path::walk)
      for (const auto& [sector, reason] : city_.seen_from(pose.sector_id)) add(*sector);
    else
      for (const Sector& sector : city_.city().sectors) add(sector);
    return out;
  }

  Shown show(const Parts& parts) override {
    if (shown_.tracer && parts == parts_) return shown_;
    shown_ = {};
    RenderMesh mesh;
    if (!parts.empty()) {
      const PlanPoint origin = part_of(city_, parts.front()).sector->origin;
      mesh.origin = {metres(origin.x), metres(origin.y), 0};
    }
    for (const std::string& text : parts) {
      const SectorPart part = part_of(city_, text);
      const GlbFile& file = file_of(part, text);
      shown_.files.push_back({text, file.sent});
      shown_.decode_cpu_ms += add_glb(mesh, file.bytes, part.sector->origin, images_);
    }
    shown_.memory_bytes = memory_of(mesh);
    city_.add_sheet(mesh);
    shown_.tracer = std::make_shared<MeshTracer>(std::move(mesh));
    parts_ = parts;
    return shown_;
  }

 private:
  double away_m(const Sector& s, const Enu& eye) {
    auto& box = boxes_[s.id];
    if (box.is_empty()) box = box_of(s.ground);
    const double east = std::max({metres(box.min.x) - eye.east, 0.0, eye.east - metres(box.max.x)}),
                 north = std::max({metres(box.min.y) - eye.north, 0.0, eye.north - metres(box.max.y)});
    return std::hypot(east, north, eye.up);
  }

  const GlbFile& file_of(const SectorPart& part, const std::string& text) {
    GlbFile& file = files_[text];
    if (file.bytes.empty()) {
      file.bytes = sector_glb(city_.index(), *part.sector, part.detail, city_.pngs(), {coding_, 1});
      file.sent = std::min(file.bytes.size(), brotli(file.bytes, kBrotli).size());
    }
    return file;
  }

  SharedCity& city_;
  GlbCoding coding_;
  FormName name_;
  Shown shown_;
  Parts parts_;
  std::map<std::string, GlbFile> files_;
  std::map<std::string, PlanBox> boxes_;
  PngImages images_;
};

}  // namespace

Form glb_files(SharedCity& city, GlbCoding coding, double tau_px) {
  return std::make_unique<GlbFiles>(city, coding, tau_px);
}

}  // namespace vicus::measure
