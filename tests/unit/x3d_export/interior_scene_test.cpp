#include "x3d_export/interior_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/sample_interior.hpp"
#include "tests/support/x3d_text.hpp"
#include "x3d_export/door_nodes.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/sector_mesh.hpp"

namespace vicus {
namespace {

struct Vec {
  double x, y, z;
};
Vec vec(X3dPoint p) { return {double(p.x), double(p.y), double(p.z)}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Does the ray meet the triangle from its front? (Möller and Trumbore)
bool meets(Vec from, Vec way, Vec a, Vec b, Vec c) {
  const Vec e = b - a, f = c - a, p = cross(way, f);
  const double det = dot(e, p);
  if (det < 1e-9) return false;
  const Vec t = from - a, q = cross(t, e);
  const double u = dot(t, p), v = dot(way, q);
  return u >= -1e-9 && v >= -1e-9 && u + v <= det * (1 + 1e-9) && dot(f, q) >= 0;
}

bool meets(const std::vector<Face>& faces, Vec from, Vec way) {
  for (const Face& face : faces)
    for (int k = 2; k < face.count; ++k)
      if (meets(from, way, vec(face.corners[0]), vec(face.corners[static_cast<std::size_t>(k) - 1]),
                vec(face.corners[static_cast<std::size_t>(k)])))
        return true;
  return false;
}

struct Sample {
  City city = test::sample_city_with_interior();
  CityIndex index{city};
  std::string text(std::size_t i) const { return interior_file(index, city.interiors[i], SceneFormat::x3d).text; }
};

TEST(InteriorFaces, CloseTheRoomButForItsDoors) {
  const Sample sample;
  for (const Interior& room : sample.city.interiors) {
    const auto faces = interior_faces(sample.index, room);
    std::vector<Face> all = faces.rest;
    all.insert(all.end(), faces.ceiling.begin(), faces.ceiling.end());
    all.insert(all.end(), faces.floor.begin(), faces.floor.end());
    const PlanPoint eye{room.sector.origin.x, room.sector.origin.y};
    const X3dPoint from = x3d_from_plan(eye, height_mm(room.floor_m + 1.6), room.sector.origin);
    int open = 0;
    for (int turn = 0; turn < 720; ++turn)
      for (int tilt = -8; tilt <= 8; ++tilt) {
        const double a = (turn + 0.37) * std::numbers::pi / 360, t = (tilt + 0.21) * std::numbers::pi / 18;
        const Vec way{std::cos(t) * std::sin(a), std::sin(t), -std::cos(t) * std::cos(a)};
        if (meets(all, vec(from), way)) continue;
        bool is_door = false;
        for (const Door* door : sample.index.doors_of(room.sector.id)) {
          // The leaf's plane: what is beyond is the street's to draw.
          const double length = std::hypot(door->b.x - door->a.x, door->b.y - door->a.y);
          const double mm = door->recess_m * 1000 / length;
          const auto at_leaf = [&](PlanPoint q) {
            return PlanPoint{q.x + static_cast<std::int32_t>(std::lround(mm * (door->b.y - door->a.y))),
                             q.y - static_cast<std::int32_t>(std::lround(mm * (door->b.x - door->a.x)))};
          };
          const X3dPoint p = x3d_from_plan(at_leaf(door->a), height_mm(door->sill_m), room.sector.origin),
                         q = x3d_from_plan(at_leaf(door->b), height_mm(door->sill_m), room.sector.origin);
          const Vec up{0, door->height_m * 1000, 0};
          const Vec d = vec(q) - vec(p), n = cross(up, d);
          const double s = dot(vec(p) - vec(from), n) / dot(way, n);
          const Vec hit{from.x + s * way.x, from.y + s * way.y, from.z + s * way.z};
          const Vec h = hit - vec(p);
          const double along = dot(h, d) / dot(d, d), high = h.y / up.y;
          is_door = is_door || (s > 0 && along > -0.001 && along < 1.001 && high > -0.001 && high < 1.001);
        }
        EXPECT_TRUE(is_door) << room.sector.id << ": a hole at " << turn / 2.0 << " degrees, " << tilt * 10 << " up";
        ++open;
      }
    EXPECT_GT(open, 0) << "no door can be looked through";
  }
}

TEST(InteriorFiles, AreNearFilesWithALampOfTheirOwn) {
  const Sample sample;
  const std::string hall = sample.text(0);
  for (const char* part : {"<MetadataSet DEF='RECORD'", "value='\"interior\"'", "<Shape DEF='GROUND'>", "<PointLight ",
                           "DEF='DOOR-TOUCH-hall-d1-in'", "DEF='DOOR-TOUCH-kitchen-d1'", "DEF='DOOR-LEAF-kitchen-d1'",
                           "DEF='DOOR-GLASS-kitchen-d1'", "DEF='DOOR-LAMP-kitchen-d1'", "DEF='DOOR-BEYOND-kitchen-d1'",
                           "<WorldInfo title='Diele'>"})
    EXPECT_NE(hall.find(part), std::string::npos) << part;
  EXPECT_EQ(hall.find("DOOR-TOUCH-hall-d1'"), std::string::npos) << "the street's side is the street's";
  EXPECT_LT(hall.size(), kFileLimit_bytes);
  for (const Face& face : interior_faces(sample.index, sample.city.interiors[0]).floor)
    EXPECT_EQ(face.count, 3) << "the page walks on the triangles of GROUND";
}

TEST(InteriorFiles, TellOfTheirDoorsAndOfNothingElse) {
  const Sample sample;
  const auto source = source_of(sample.index);
  const auto record = sector_record(source, sample.city.interiors[0].sector, 5);
  EXPECT_EQ(record.visible, std::vector<std::string>{"hall"});
  EXPECT_TRUE(record.gates.empty());
  EXPECT_TRUE(record.neighbours.empty()) << "what is behind a shut door is not wanted";
  ASSERT_EQ(record.doors.size(), 2u);
  EXPECT_EQ(record.doors[0].to.id, "s-main-e");
  const auto street = sector_record(source, *source.sector("s-main-e"), 5);
  ASSERT_EQ(street.doors.size(), 1u);
  EXPECT_EQ(street.doors[0].to.id, "hall");
  for (const auto& n : street.neighbours) EXPECT_NE(n.id, "hall");
}

/// The wall of b-8 along s-main-e, everything that is drawn of it.
std::vector<Face> facade_of(const Sample& sample, Detail detail) {
  const Sector& sector = *sample.index.sector("s-main-e");
  std::vector<Face> faces;
  for (const auto& layer : sector_layers(sample.index, sector, detail))
    faces.insert(faces.end(), layer.faces.begin(), layer.faces.end());
  if (detail == Detail::far) return faces;
  for (int level = 1; level <= 4; ++level) {
    const LevelFaces f = sector_facades(sample.index, sector, level);
    faces.insert(faces.end(), f.solid.begin(), f.solid.end());
    const auto add = [&](const TexturedFace& t) { faces.push_back({t.corners, 4, {}}); };
    for (const auto& t : f.atlas) add(t);
    for (const auto& [image, list] : f.own_images)
      for (const auto& t : list) add(t);
  }
  return faces;
}

TEST(DoorsInFacades, LeaveAHoleInEveryLevelAndWallAllAround) {
  const Sample sample;
  const Sector& sector = *sample.index.sector("s-main-e");
  const Door& door = sample.city.doors[0];
  const auto near = facade_of(sample, Detail::near), far = facade_of(sample, Detail::far);
  const auto wall_at = [&](const std::vector<Face>& faces, double east, double up_m) {
    const X3dPoint p = x3d_from_plan({lattice_mm(east), lattice_mm(-4.9)}, height_mm(up_m), sector.origin);
    return meets(faces, vec(p), {0, 0, 1});  // southwards
  };
  for (const double x : {10.02, 10.5, 10.98})
    for (const double up : {0.2, 1.0, 2.2}) {
      EXPECT_FALSE(wall_at(near, x, up)) << x << ", " << up;
      EXPECT_TRUE(wall_at(far, x, up)) << "from afar a door is wall";
    }
  for (const auto& [x, up] :
       {std::pair{9.9, 1.0}, {11.1, 1.0}, {10.5, door.sill_m + door.height_m + 0.05}, {10.5, 0.05}})
    EXPECT_TRUE(wall_at(near, x, up)) << x << ", " << up;
  auto shut = near;
  const auto leaf = door_faces(sample.index, sector);
  shut.insert(shut.end(), leaf.begin(), leaf.end());
  for (const double x : {10.02, 10.5, 10.98}) EXPECT_TRUE(wall_at(shut, x, 1.0)) << "exports without doors have a hole";
}

/// The place and turn of a door's Transform, in plan.
std::array<double, 4> frame_of(const Node& node, PlanPoint origin) {
  std::array<double, 4> out{};
  for (const auto& field : node.fields) {
    const auto* values = std::get_if<std::vector<double>>(&field.value);
    if (field.name == "translation")
      out[0] = (*values)[0] + metres(origin.x), out[1] = (*values)[1], out[2] = metres(origin.y) - (*values)[2];
    if (field.name == "rotation") out[3] = (*values)[3];
  }
  return out;
}

TEST(DoorNodes, OfBothSidesHangAtOnePlace) {
  const Sample sample;
  const auto node_of = [&](const std::string& sector_id, std::size_t i) {
    const Interior* room = sample.index.interior(sector_id);
    const Sector& sector = room ? room->sector : *sample.index.sector(sector_id);
    return frame_of(door_nodes(sample.index, sector).at(i), sector.origin);
  };
  const auto street = node_of("s-main-e", 0), hall = node_of("hall", 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(street[i], hall[i], 0.0011) << i;
  EXPECT_NEAR(street[2], -5 - 0.145, 0.001) << "the leaf stands in the doorway";
  const auto one = node_of("hall", 1), other = node_of("kitchen", 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(one[i], other[i], 0.0011) << i;
}

}  // namespace
}  // namespace vicus
