#include "x3d_export/interior_scene.hpp"

#include <cassert>
#include <cmath>

#include "x3d_export/door_nodes.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kSkirting_m = 0.12, kLampBelow_m = 0.55, kShade_m = 0.18;
constexpr double kLightReach_m = 14, kLight = 0.3;
constexpr Colour kFloor{124, 92, 64}, kSkirtingColour{96, 78, 60}, kCeiling{150, 147, 140}, kDoorway{172, 166, 154},
    kShade{240, 214, 150}, kCord{60, 56, 52};
constexpr Colour kWalls[] = {{176, 166, 146}, {158, 166, 154}, {160, 163, 172}, {176, 156, 144}};

Colour wall_colour(const std::string& id) {
  std::uint32_t hash = 2166136261u;
  for (const char c : id) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  return kWalls[(hash >> 8) % std::size(kWalls)];
}

/// The part of the way from the room to the line of a door that this side of the leaf sees.
PlanPoint at_leaf(PlanPoint room, PlanPoint line, double recess_m) {
  const double length = std::hypot(double(line.x) - room.x, double(line.y) - room.y);
  const double share = length > 0 ? std::max(0.0, 1 - std::abs(recess_m) * kMmPerMetre / length) : 0;
  return {room.x + static_cast<std::int32_t>(std::lround(share * (double(line.x) - room.x))),
          room.y + static_cast<std::int32_t>(std::lround(share * (double(line.y) - room.y)))};
}

class RoomFaces {
 public:
  RoomFaces(const CityIndex& index, const Interior& interior)
      : interior_(interior), doors_(index.doors_of(interior.sector.id)), rest_(interior.sector.origin) {}

  InteriorFaces run() {
    const Sector& sector = interior_.sector;
    FaceList floor(sector.origin), ceiling(sector.origin);
    floor.add_floor(sector.ground, sector.ground_triangles, interior_.floor_m, kFloor, false);
    ceiling.add_floor(sector.ground, sector.ground_triangles, top_m(), kCeiling, true);
    add_ring(sector.ground.outer);
    for (const Ring& hole : sector.ground.holes) add_ring(hole);
    add_lamp();
    return {floor.take(), ceiling.take(), rest_.take()};
  }

 private:
  double top_m() const { return interior_.floor_m + interior_.height_m; }

  const Door* door_at(PlanPoint a, PlanPoint b) const {
    for (const Door* door : doors_)
      if (door->a == a && door->b == b) return door;
    return nullptr;
  }

  void add_wall(PlanPoint a, PlanPoint b) {
    rest_.add_wall(a, b, interior_.floor_m, interior_.floor_m + kSkirting_m, kSkirtingColour);
    rest_.add_wall(a, b, interior_.floor_m + kSkirting_m, top_m(), wall_colour(interior_.sector.id));
  }

  /// A doorway is four corners in a row: on the wall, the two ends of the door's line, on the wall.
  void add_ring(const Ring& ring) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t i) { return ring[i % n]; };
    for (std::size_t i = 0; i < n; ++i) {
      if (const Door* door = door_at(at(i), at(i + 1)))
        add_doorway(*door, at(i + n - 1), at(i + 2));
      else if (!door_at(at(i + 1), at(i + 2)) && !door_at(at(i + n - 1), at(i)))
        add_wall(at(i), at(i + 1));
    }
  }

  void add_doorway(const Door& door, PlanPoint before, PlanPoint after) {
    const double low_m = interior_.floor_m, high_m = door.sill_m + door.height_m;
    const PlanPoint a = at_leaf(before, door.a, door.recess_m), b = at_leaf(after, door.b, door.recess_m);
    rest_.add_wall(before, a, low_m, high_m, kDoorway);
    rest_.add_wall(b, after, low_m, high_m, kDoorway);
    rest_.add_wall(before, after, high_m, top_m(), wall_colour(interior_.sector.id));
    if (door.sill_m > low_m) rest_.add_wall(a, b, low_m, door.sill_m, kDoorway);
    const Polygon soffit{{before, a, b, after}, {}};
    rest_.add_floor(soffit, {0, 1, 2, 0, 2, 3}, high_m, kDoorway, true);
  }

  void add_lamp() {
    const PlanPoint at = point_inside(interior_.sector);
    rest_.add_spindle(at, 4, 0.012, 0.012, top_m() - kLampBelow_m + kShade_m, top_m(), kCord);
    rest_.add_spindle(at, 8, 0.2, 0.07, top_m() - kLampBelow_m, top_m() - kLampBelow_m + kShade_m, kShade);
  }

  const Interior& interior_;
  const std::vector<const Door*>& doors_;
  FaceList rest_;
};

Node lamp_light(const Interior& interior) {
  const X3dPoint p =
      x3d_from_plan(point_inside(interior.sector), height_mm(interior.floor_m + interior.height_m - kLampBelow_m - 0.1),
                    interior.sector.origin);
  Node light("PointLight");
  light.set("location", std::vector<double>{metres(p.x), metres(p.y), metres(p.z)});
  light.set("color", std::vector<double>{1, 0.93, 0.8});
  return light.set("intensity", kLight).set("ambientIntensity", 0.2).set("radius", kLightReach_m);
}

Node ceiling_shape(const std::vector<Face>& faces) {
  Node shape = shape_of("CEILING", Shading::solid, faces);
  for (auto& field : shape.nodes)
    if (field.name == "appearance")
      field.nodes.front().nodes.front().nodes.front().set("emissiveColor", std::vector<double>{0.42, 0.4, 0.36});
  return shape;
}

}  // namespace

InteriorFaces interior_faces(const CityIndex& index, const Interior& interior) {
  return RoomFaces(index, interior).run();
}

ExportFile interior_file(const CityIndex& index, const Interior& interior, SceneFormat format) {
  assert(format != SceneFormat::vrml);
  const Sector& sector = interior.sector;
  const std::string place = sector.name.empty() ? name_of(sector.kind) : sector.name;
  const InteriorFaces faces = interior_faces(index, interior);
  std::vector<Node> content = door_nodes(index, sector);
  content.push_back(shape_of("GROUND", Shading::solid, faces.floor));
  content.push_back(ceiling_shape(faces.ceiling));
  content.push_back(shape_of("ROOM", Shading::solid, faces.rest));
  int shapes = 0;
  for (const Node& node : content) shapes += count_shapes(node);

  Scene scene;
  scene.title = sector.id + suffix_of(format);
  scene.metas.emplace_back("description", place + ", a room in a house of a city");
  for (auto& meta : rights_of(source_of(index))) scene.metas.push_back(std::move(meta));
  Node info("WorldInfo");
  info.set("title", FieldValue(caption_of(place)));
  info.add("metadata", record_node(sector_record(source_of(index), sector, shapes)));
  scene.nodes.push_back(std::move(info));
  for (const Viewpoint* v : index.viewpoints_of(sector.id))
    scene.nodes.push_back(viewpoint_node(*v, sector.origin, place));
  scene.nodes.push_back(lamp_light(interior));
  for (Node& node : content) scene.nodes.push_back(std::move(node));
  return {"sectors/" + scene.title, media_type_of(format), write_scene(scene, format), shapes};
}

}  // namespace vicus
