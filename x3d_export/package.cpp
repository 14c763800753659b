#include "x3d_export/package.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "city_db/ordered_work.hpp"
#include "city_db/run_parallel.hpp"
#include "x3d_export/coding.hpp"
#include "x3d_export/impostor_nodes.hpp"
#include "x3d_export/interior_scene.hpp"
#include "x3d_export/panorama_nodes.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

class CityArtefacts {
 public:
  CityArtefacts(City& city, const PackageOptions& options)
      : city_(city), index_(city), options_(options), near_shapes_(city.sectors.size(), 0) {
    add_textures();
    begin([this](std::size_t i) { return pack_near(i); });
  }

  std::optional<Artefact> next() {
    while (ready_.empty() && work_) {
      if (!work_->is_done()) {
        auto list = work_->take();
        std::move(list.begin(), list.end(), std::back_inserter(ready_));
      } else {
        work_.reset();
        if (!std::exchange(has_near_, true)) {
          finish_near();
          begin([this](std::size_t i) { return pack_rest(i); });
        }
      }
    }
    if (ready_.empty()) return std::nullopt;
    Artefact artefact = std::move(ready_.front());
    ready_.pop_front();
    return artefact;
  }

 private:
  void add_textures() {
    for (const Texture& texture : city_.textures)
      ready_.push_back(
          {"textures/" + texture.id + ".png", "image/png", "identity", strong_hash(texture.png), texture.png});
    for (const GateImpostor& i : city_.impostors)
      ready_.push_back({impostor_path(i.gate_id), "image/png", "identity", strong_hash(i.png), i.png});
    for (const Panorama& p : city_.panoramas)
      ready_.push_back({panorama_path(p.sector_id), "image/png", "identity", strong_hash(p.png), p.png});
  }

  void add_interiors() {
    for (Interior& interior : city_.interiors) {
      const ExportFile file = interior_file(index_, interior, SceneFormat::x3d);
      ready_.push_back(packed(file));
      interior.sector.bytes = ready_.back().body.size();
      const auto record = sector_record(source_of(index_), interior.sector, file.shapes);
      ready_.push_back(packed({"sectors/" + interior.sector.id + ".json", "application/json", record_json(record), 0}));
    }
  }

  std::vector<Artefact> pack_near(std::size_t i) {
    std::vector<Artefact> out;
    std::uint64_t bytes = 0;
    for (const auto& file : sector_files(index_, city_.sectors[i], Detail::near, SceneFormat::x3d)) {
      out.push_back(packed(file));
      near_shapes_[i] += file.shapes;
      bytes += out.back().body.size();
    }
    city_.sectors[i].bytes = bytes;
    return out;
  }

  /// Records tell the bytes of other sectors, too.
  void finish_near() {
    add_interiors();
    if (!city_.meta.contains("start")) city_.meta["start"] = start_sector(source_of(index_));
  }

  void begin(std::function<std::vector<Artefact>(std::size_t)> pack) {
    constexpr std::size_t kPerThread = 8;  // enough that threads seldom wait for the slowest sector
    const unsigned threads = thread_count(options_.threads);
    work_.emplace(city_.sectors.size(), threads, kPerThread * threads, std::move(pack));
  }

  std::vector<Artefact> pack_rest(std::size_t i) {
    const Sector& sector = city_.sectors[i];
    std::vector<Artefact> out;
    for (const auto detail : {Detail::far, Detail::tall})
      for (const auto& file : sector_files(index_, sector, detail, SceneFormat::x3d)) out.push_back(packed(file));
    const auto record = sector_record(source_of(index_), sector, near_shapes_[i]);
    out.push_back(packed({"sectors/" + sector.id + ".json", "application/json", record_json(record), 0}));
    return out;
  }

  Artefact packed(const ExportFile& file) const {
    return stored(file.path, file.media_type, file.text, options_.brotli_quality);
  }

  City& city_;
  CityIndex index_;
  PackageOptions options_;
  std::vector<int> near_shapes_;
  std::deque<Artefact> ready_;
  bool has_near_ = false;
  std::optional<OrderedWork<std::vector<Artefact>>> work_;  // of near files, then of the rest; last: it uses the others
};

}  // namespace

Artefact stored(const std::string& path, const std::string& media_type, const std::string& body, int brotli_quality) {
  std::string br = brotli(body, brotli_quality);
  if (br.size() < body.size()) return {path, media_type, "br", strong_hash(br), std::move(br)};
  return {path, media_type, "identity", strong_hash(body), body};
}

std::function<std::optional<Artefact>()> export_artefacts(City& city, const PackageOptions& options) {
  auto artefacts = std::make_shared<CityArtefacts>(city, options);
  return [artefacts] { return artefacts->next(); };
}

}  // namespace vicus
