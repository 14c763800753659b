#include "cli/measure_forms.hpp"

#include <gtest/gtest.h>

#include "city_db/issues.hpp"
#include "city_db/surroundings.hpp"
#include "cli/measure_glb_mesh.hpp"
#include "cli/measure_memory.hpp"
#include "cli/measure_prism_mesh.hpp"
#include "cli/measure_sector_forms.hpp"
#include "cli/measure_sector_parts.hpp"
#include "cli/measure_tile_tracer.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/models/facades.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"
#include "x3d_export/package.hpp"

namespace vicus::measure {
namespace {

/// The sample city with painted facades, as a file.
class SampleForms : public ::testing::Test {
 protected:
  SampleForms() {
    City city = test::sample_city_with_facades();
    for (auto& facade : city.facades) facade.texture.clear();
    paint_textures(city, 1);
    const auto artefacts = export_artefacts(city, {1, 6});
    std::vector<Artefact> list;
    while (auto artefact = artefacts()) list.push_back(std::move(*artefact));
    write_city(scratch_ / "city.gpkg", city, test::one_by_one(std::move(list)));
    shared_ = std::make_unique<SharedCity>(scratch_ / "city.gpkg");
  }

  Pose street() const {
    Pose pose{Path::walk, 0, {45, 0, 1.7}, {45, 5, 1.6}, {}};
    pose.sector_id = shared_->city().sectors.front().id;
    return pose;
  }
  Pose air() const { return {Path::fly, 0, {0, -150, 120}, {0, 0, 0}, {}}; }
  View look(const Tracer& tracer, const Pose& pose) const {
    return render(tracer, camera_at(pose.eye, pose.look, kFieldOfView, 96, 72), {96, 72, 4, 0.05, 1});
  }
  test::ScratchDirectory scratch_;
  std::unique_ptr<SharedCity> shared_;
};

TEST_F(SampleForms, PartsComeBackFromTheirText) {
  const Sector* sector = &shared_->city().sectors.back();
  for (const SectorPart& part : {SectorPart{sector}, SectorPart{sector, Detail::far, 1},
                                 SectorPart{sector, Detail::tall, 1}, SectorPart{sector, Detail::near, 2, {4, 3, 1}}}) {
    const SectorPart back = part_of(*shared_, part_text(part));
    EXPECT_EQ(back.sector, sector);
    EXPECT_EQ(back.detail, part.detail);
    EXPECT_EQ(back.levels, part.levels);
    if (part.detail == Detail::near) {
      EXPECT_EQ(back.level, part.level);
    }
  }
}

TEST_F(SampleForms, TheFullModelIsTheTruthAndSendsEveryNearFile) {
  const Form full = full_model(*shared_);
  const Shown shown = full->show(full->choose(air(), 500, {}));
  EXPECT_EQ(look(*shown.tracer, air()).colour, look(*truth_of(*shared_), air()).colour);
  std::uint64_t bytes = 0, images = 0;
  for (const SentFile& file : shown.files) (file.path.starts_with("textures/") ? images : bytes) += file.bytes;
  std::uint64_t near = 0;
  for (const Sector& sector : shared_->city().sectors) near += sector.bytes;
  EXPECT_EQ(bytes, near);
  EXPECT_GT(images, 0u);
}

TEST_F(SampleForms, CoarserLevelsSendLessAndErrMore) {
  const View truth = look(*truth_of(*shared_), street());
  double bytes = 0, error = 1;
  for (int level = 1; level <= 4; ++level) {
    const Form form = level_files(*shared_, level);
    const Shown shown = form->show(form->choose(air(), 500, {}));
    double sum = 0;
    for (const SentFile& file : shown.files) sum += static_cast<double>(file.bytes);
    const double flip = flip_mean(truth.colour, look(*shown.tracer, street()).colour);
    EXPECT_GT(sum, bytes) << level;
    EXPECT_LT(flip, error) << level;
    bytes = sum, error = flip;
  }
  EXPECT_EQ(error, 0);
}

TEST_F(SampleForms, DecodedGlbLooksAsLevelThree) {
  std::vector<SectorPart> parts;
  for (const Sector& sector : shared_->city().sectors) parts.push_back({&sector, Detail::near, 3});
  const View expected = look(*scene_of(*shared_, parts).tracer, street());
  for (const GlbCoding coding : {GlbCoding::draco, GlbCoding::meshopt}) {
    RenderMesh mesh;
    PngImages images;
    for (const Sector& sector : shared_->city().sectors)
      add_glb(mesh, sector_glb(shared_->index(), sector, Detail::near, shared_->pngs(), {coding, 1}), sector.origin,
              images);
    shared_->add_sheet(mesh);
    const View shown = look(MeshTracer(std::move(mesh)), street());
    EXPECT_LT(flip_mean(expected.colour, shown.colour), 0.01);
    EXPECT_GT(silhouette_iou(expected.coverage, shown.coverage), 0.999);
  }
}

/// Close above a carriageway all is ground, and its picture has the colour of what lies there.
TEST_F(SampleForms, PrismsStandOnTheirGround) {
  Pose above = air();
  above.eye = {-9, -1, 4}, above.look = {-9, -0.9, 0};
  const View truth = look(*truth_of(*shared_), above);
  RenderMesh bare;
  shared_->add_sheet(bare);
  const double without = flip_mean(truth.colour, look(MeshTracer(std::move(bare)), above).colour);
  for (const double tau : {0.01, 100000.0}) {
    const Form form = form_makers({"prisms"}, {tau}).front().make(*shared_);
    const Shown shown = form->show(form->choose(above, 500, {}));
    std::size_t grounds = 0;
    for (const SentFile& file : shown.files) grounds += file.path.ends_with(".ground");
    EXPECT_GT(grounds, 0u);
    const double with_ground = flip_mean(truth.colour, look(*shown.tracer, above).colour);
    EXPECT_LT(with_ground, 0.3 * without) << tau;
  }
}

TEST_F(SampleForms, SmallerTauRefinesTilesAndSendsMore) {
  for (const char* key : {"blockmap32", "paper2007-32", "glb-draco", "glb-meshopt"}) {
    double bytes = 0;
    for (const double tau : {100000.0, 0.01}) {
      const Form form = form_makers({key}, {tau}).front().make(*shared_);
      const Shown shown = form->show(form->choose(air(), 500, {}));
      double sum = 0;
      for (const SentFile& file : shown.files) sum += static_cast<double>(file.bytes);
      EXPECT_GT(sum, bytes) << key;
      bytes = sum;
      EXPECT_GT(shown.memory_bytes, 0) << key;
    }
  }
  EXPECT_THROW(form_makers({"nothing"}, {1}), CityError);
  EXPECT_EQ(form_makers({}, {1, 2}).size(), form_keys().size() + 2 + 11);
}

TEST_F(SampleForms, PrismsStandWhereHousesStand) {
  const BakeScene& scene = shared_->bake_scene();
  RenderMesh mesh;
  const double painted_bytes = add_prisms(mesh, bake_prisms(scene, {-128'000, -128'000}, 256'000), true);
  EXPECT_FALSE(mesh.images.empty()) << "walls have windows";
  RenderMesh walls_alone = mesh;
  walls_alone.images.clear();
  EXPECT_NEAR(memory_of(mesh) - painted_bytes, memory_of(walls_alone), 1) << "which a shader paints";
  const RayScene rays(std::move(mesh));
  for (const BakeHouse& house : scene.houses()) {
    const double x = metres((std::int64_t{house.box.min.x} + house.box.max.x) / 2),
                 y = metres((std::int64_t{house.box.min.y} + house.box.max.y) / 2);
    const auto hit = rays.first_hit({x, y, 500}, {0, 0, -1}, 0.1);
    if (!hit) continue;  // the middle of a box may lie beside an L
    EXPECT_LE(500 - hit->t, house.top_m + 0.2);
    EXPECT_GE(500 - hit->t, house.ground_m + house.eave_m - 3);
  }
}

TEST(PrismWindows, AreTheClients) {
  const std::string mesh = test::read_bytes(VICUS_TESTS "/../client_scripts/core/prismMesh.js"),
                    shader = test::read_bytes(VICUS_TESTS "/../client_scripts/x3d/flyover.frag");
  const auto said = [](const char* format, auto... values) {
    char text[128];
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text);
  };
  const std::string walls = said("kWindowWidth = %g, kStorey = %g, kBlind = %g;", kWindowWidth_m, kStorey_m, kBlind_m);
  EXPECT_NE(mesh.find(walls), std::string::npos) << walls;
  for (const std::string& line : {said("kGlass = vec3(%g, %g, %g);", kGlass[0], kGlass[1], kGlass[2]),
                                  said("kWindowLow = vec2(%g, %g), kWindowHigh = vec2(%g, %g);", kWindowLow[0],
                                       kWindowLow[1], kWindowHigh[0], kWindowHigh[1]),
                                  said("mix(own, kGlass, %g * share.x * share.y)", kOpaque)})
    EXPECT_NE(shader.find(line), std::string::npos) << line;
}

TEST_F(SampleForms, TilesAreMetWhereTheirCasterMeetsThem) {
  const BlockMap map = bake_blockmap(shared_->bake_scene(), {-128'000, 0}, 128'000);
  const BlockMapCaster caster(map);
  const TileTracer tracer({cast_tile(map)}, {});
  std::size_t hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 from{-140 + 0.7 * i, -20, 60}, way{0.3, 1, -0.5 - 0.001 * i};
    const PlanRay ray{from[0], from[1], from[2], way[0], way[1], way[2]};
    const CastHit hit = caster.cast(ray);
    const auto t = tracer.distance(from, way, 0);
    ASSERT_EQ(t.has_value(), bool(hit)) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_DOUBLE_EQ(*t, hit.t);
    const auto behind = tracer.distance(from, way, hit.t - 1);  // from 1 before it
    ASSERT_TRUE(behind);
    EXPECT_NEAR(*behind, hit.t, 2e-3);
  }
  EXPECT_GT(hits, 100u);
}

}  // namespace
}  // namespace vicus::measure
