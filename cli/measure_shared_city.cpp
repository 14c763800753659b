#include "cli/measure_shared_city.hpp"

#include <algorithm>

#include "city_db/boxes.hpp"
#include "city_db/seen_houses.hpp"
#include "city_db/terrain.hpp"
#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/ground_colours.hpp"

namespace vicus::measure {
namespace {

constexpr double kBelow_m = 3;  // water lies lower than the streets

}  // namespace

SharedCity::SharedCity(const std::filesystem::path& path)
    : city_(read_city(path)), reader_(path), guide_(path), index_(std::make_unique<CityIndex>(city_)) {
  pngs_ = [this](const std::string& id) {
    auto image = reader_.artefact("textures/" + id + ".png", {"identity"});
    if (!image) throw CityError("the city lacks textures/" + id + ".png: build it again");
    return std::move(image->body);
  };
  images_ = cached(pngs_);
}

const BakeScene& SharedCity::bake_scene() {
  if (!bake_scene_)
    bake_scene_ = std::make_unique<BakeScene>(
        city_,
        [this](const std::string& id) {
          auto image = reader_.artefact("textures/" + id + ".png", {"identity"});
          return image ? std::move(image->body) : std::string();
        },
        1);
  return *bake_scene_;
}

std::optional<std::uint64_t> SharedCity::stored_bytes(const std::string& path) {
  const auto [at, is_new] = bytes_.emplace(path, std::nullopt);
  if (is_new)
    if (const auto artefact = reader_.artefact(path, {"br", "identity"})) at->second = artefact->body.size();
  return at->second;
}

std::vector<std::pair<const Sector*, VisibleReason>> SharedCity::seen_from(const std::string& sector_id) const {
  std::vector<std::pair<const Sector*, VisibleReason>> out;
  if (const Sector* self = index_->sector(sector_id)) out.emplace_back(self, VisibleReason::self);
  const auto add = [&](const std::string& id, VisibleReason reason) {
    const Sector* s = index_->sector(id);
    const auto is_same = [&](const auto& known) { return known.first == s; };
    if (s != nullptr && std::none_of(out.begin(), out.end(), is_same)) out.emplace_back(s, reason);
  };
  for (const Gate* gate : index_->gates_of(sector_id))
    if (!gate->to_sector_id.empty()) add(gate->to_sector_id, VisibleReason::gate);
  for (const Visible* v : index_->visible_from(sector_id)) {
    // Ground seen over lower houses is sent as what is seen along streets.
    const bool is_ground = v->reason == VisibleReason::over_roofs && !is_of_houses_alone(*v);
    add(v->visible_sector_id, is_ground ? VisibleReason::line_of_sight : v->reason);
  }
  return out;
}

void SharedCity::add_sheet(RenderMesh& mesh) const {
  const int levels = levels_of(city_);
  const PlanBox box = tile_box(levels, {});
  const bool is_flat = city_.terrain.height_mm.empty();
  const std::int64_t side = std::int64_t{box.max.x} - box.min.x,
                     steps = is_flat ? 1 : std::max<std::int64_t>(1, side / 20'000);
  RenderTriangle look;
  look.colour = kBeyondCity;
  const auto corner = [&](std::int64_t column, std::int64_t row) {
    const PlanPoint p{static_cast<std::int32_t>(box.min.x + column * side / steps),
                      static_cast<std::int32_t>(box.min.y + row * side / steps)};
    return mesh.add_point({metres(p.x), metres(p.y), height_m(city_.terrain, p) - kBelow_m});
  };
  for (std::int64_t row = 0; row < steps; ++row)
    for (std::int64_t column = 0; column < steps; ++column) {
      const auto a = corner(column, row), b = corner(column + 1, row), c = corner(column + 1, row + 1),
                 d = corner(column, row + 1);
      look.corners = {a, b, c};
      mesh.triangles.push_back(look);
      look.corners = {a, c, d};
      mesh.triangles.push_back(look);
    }
}

}  // namespace vicus::measure
