#include "cli/measure_sector_forms.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/issues.hpp"
#include "cli/measure_memory.hpp"
#include "cli/measure_sector_parts.hpp"
#include "sectorgen/bake/impostors/bake_impostor.hpp"
#include "sectorgen/bake/impostors/impostor_mesh.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/package.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus::measure {
namespace {

constexpr int kBrotli = 6;  // as near files are stored

/// All that is the same for representations by sector files: the scene of the last parts is kept.
class SectorForm : public Representation {
 public:
  SectorForm(SharedCity& city, FormName name) : city_(city), name_(std::move(name)) {}
  const FormName& name() const override { return name_; }
  bool shows(Path) const override { return true; }

  Shown show(const Parts& parts) override {
    if (shown_.tracer && parts == parts_) return shown_;
    std::vector<SectorPart> list;
    shown_ = {};  // two scenes of a large city would need twice the memory
    for (const std::string& text : parts) {
      list.push_back(part_of(city_, text));
      for (SentFile& file : files_of(list.back())) shown_.files.push_back(std::move(file));
    }
    shown_.files = once_each(std::move(shown_.files));
    PartsScene scene = scene_of(city_, list, extra(parts));
    shown_.tracer = std::move(scene.tracer);
    shown_.memory_bytes = scene.memory_bytes;
    parts_ = parts;
    return shown_;
  }

 protected:
  virtual std::vector<SentFile> files_of(const SectorPart& part) { return stored_files(city_, part); }
  virtual RenderMesh extra(const Parts&) { return {}; }
  /// L_1 from the street, all from the air; each as `make` says.
  template <class Make>
  Parts each(const Pose& pose, Make make) {
    Parts out;
    if (pose.path == Path::walk) {
      for (const auto& [sector, reason] : city_.seen_from(pose.sector_id)) out.push_back(part_text(make(*sector)));
    } else {
      for (const Sector& sector : city_.city().sectors) out.push_back(part_text(make(sector)));
    }
    return out;
  }
  SharedCity& city_;
  FormName name_;
  Shown shown_;

 private:
  Parts parts_;
};

class FullModel : public SectorForm {
 public:
  explicit FullModel(SharedCity& city) : SectorForm(city, {"full model", {}, 0}) {}
  Parts choose(const Pose&, double, const Parts& before) override {
    if (!before.empty()) return before;
    Parts out;
    for (const Sector& sector : city_.city().sectors) out.push_back(part_text({&sector}));
    return out;
  }
};

class LevelFiles : public SectorForm {
 public:
  LevelFiles(SharedCity& city, int level) : SectorForm(city, {"LOD" + std::to_string(level), {}, 0}), level_(level) {}
  Parts choose(const Pose& pose, double, const Parts&) override {
    return each(pose, [&](const Sector& s) { return SectorPart{&s, Detail::near, level_, {}}; });
  }

 private:
  /// The near file as if it had this level alone.
  std::vector<SentFile> files_of(const SectorPart& part) override {
    auto& known = known_[part.sector->id];
    if (!known.empty()) return known;
    for (const ExportFile& file :
         sector_files(city_.index(), *part.sector, Detail::near, SceneFormat::x3d, kFileLimit_bytes, part.level))
      known.push_back({file.path, stored(file.path, file.media_type, file.text, kBrotli).body.size()});
    const int level = std::min(part.level, finest_level(city_.index(), *part.sector));
    for (const std::string& id : images_of(city_, *part.sector, level))
      known.push_back({"textures/" + id + ".png", city_.stored_bytes("textures/" + id + ".png").value_or(0)});
    return known;
  }
  int level_;
  std::map<std::string, std::vector<SentFile>> known_;
};

class FarFiles : public SectorForm {
 public:
  explicit FarFiles(SharedCity& city) : SectorForm(city, {"far sectors", {}, 0}) {}
  Parts choose(const Pose& pose, double, const Parts&) override {
    return each(pose, [](const Sector& s) { return SectorPart{&s, Detail::far, 1, {}}; });
  }
};

std::string range_text(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "ranges x%g", share);
  return text;
}

class PageFiles : public SectorForm {
 public:
  PageFiles(SharedCity& city, double share) : SectorForm(city, {"as the page", range_text(share), 0}), share_(share) {}
  bool shows(Path path) const override { return path == Path::walk; }
  Parts choose(const Pose& pose, double, const Parts&) override {
    Parts out;
    for (const auto& [sector, reason] : city_.seen_from(pose.sector_id)) {
      if (reason == VisibleReason::self || reason == VisibleReason::gate)
        out.push_back(part_text({sector, Detail::near, 1, levels_at(*sector, pose.eye)}));
      else
        out.push_back(part_text({sector, reason == VisibleReason::over_roofs ? Detail::tall : Detail::far, 1, {}}));
    }
    return out;
  }

 private:
  std::vector<int> levels_at(const Sector& sector, const Enu& eye) {
    auto& centres = centres_[sector.id];
    if (centres.empty())
      for (const LevelPiece& piece : sector_pieces(city_.index(), sector)) {
        const PlanPoint at = plan_from_x3d(piece.centre, sector.origin);
        centres.push_back({metres(at.x), metres(at.y), metres(piece.centre.y)});
      }
    std::vector<int> out;
    for (const Enu& c : centres)
      out.push_back(level_at(std::hypot(c.east - eye.east, c.north - eye.north, c.up - eye.up) / share_,
                             finest_level(city_.index(), sector)));
    return out;
  }
  double share_;
  std::map<std::string, std::vector<Enu>> centres_;
};

class GatePictures : public SectorForm {
 public:
  explicit GatePictures(SharedCity& city) : SectorForm(city, {"gate impostors", {}, 0}), ground_(city.city()) {}
  bool shows(Path path) const override { return path == Path::walk; }
  Parts choose(const Pose& pose, double, const Parts&) override {
    return {part_text({city_.index().sector(pose.sector_id), Detail::near, 4, {}})};
  }

 private:
  std::vector<SentFile> files_of(const SectorPart& part) override {
    auto files = stored_files(city_, part);
    for (const GateImpostor& i : pictures_of(part.sector->id))
      files.push_back({"impostors/" + i.gate_id + ".png", i.png.size()});
    return files;
  }
  RenderMesh extra(const Parts& parts) override {
    RenderMesh mesh;
    for (const GateImpostor& i : pictures_of(part_of(city_, parts.at(0)).sector->id)) add_impostor(mesh, i);
    return mesh;
  }
  const std::vector<GateImpostor>& pictures_of(const std::string& sector_id) {
    const auto known = pictures_.find(sector_id);
    if (known != pictures_.end()) return known->second;
    if (!whole_) {
      CityMeshOptions options;
      options.level = 3;
      whole_ = std::make_unique<RayScene>(city_mesh(city_.index(), city_.images(), options));
    }
    auto& list = pictures_[sector_id];
    for (const Gate* gate : city_.index().gates_of(sector_id))
      if (gate->to_sector_id.empty()) {  // an end of the city: nothing shuts it here
        continue;
      } else if (auto picture = bake_impostor(ground_, *whole_, *gate, {})) {
        list.push_back(std::move(*picture));
      }
    return list;
  }
  CityGround ground_;
  std::unique_ptr<RayScene> whole_;
  std::map<std::string, std::vector<GateImpostor>> pictures_;
};

}  // namespace

std::shared_ptr<const Tracer> truth_of(const SharedCity& city) {
  CityMeshOptions options;
  options.is_as_sent = false;
  options.has_city_ends = false;
  RenderMesh mesh = city_mesh(city.index(), city.images(), options);
  city.add_sheet(mesh);
  return std::make_shared<MeshTracer>(std::move(mesh));
}

Form full_model(SharedCity& city) { return std::make_unique<FullModel>(city); }
Form level_files(SharedCity& city, int level) { return std::make_unique<LevelFiles>(city, level); }
Form far_files(SharedCity& city) { return std::make_unique<FarFiles>(city); }
Form page_files(SharedCity& city, double range_share) { return std::make_unique<PageFiles>(city, range_share); }
Form gate_pictures(SharedCity& city) { return std::make_unique<GatePictures>(city); }

}  // namespace vicus::measure
