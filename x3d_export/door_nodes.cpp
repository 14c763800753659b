#include "x3d_export/door_nodes.hpp"

#include <cmath>

namespace vicus {
namespace {

// All in mm, in the door's own frame: x along the leaf from its hinges, y up from the sill, z the way it opens, 0 at
// the leaf's middle.
constexpr int kHalfLeaf = 25, kStile = 110, kPanel = 850, kBar = 60, kSunk = 6;
constexpr int kTrim = 130, kTrimOut = 20;
constexpr int kPicture = 60;
constexpr int kThresholdSunk = 5;  // below the interior's own floor, which covers it
constexpr Colour kGlass{34, 44, 52}, kBrass{176, 142, 72}, kJamb{214, 206, 192}, kTrimStone{198, 190, 174};
constexpr Colour kLeafColours[] = {{92, 58, 36}, {44, 74, 58}, {52, 62, 92}, {112, 44, 38}, {70, 62, 52}};
constexpr double kGlassTransparency = 0.35;

Colour leaf_colour(const Door& door) {
  std::uint32_t hash = 2166136261u;  // both sides of a door in one colour: by the house
  for (const char c : door.building_id) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  return kLeafColours[(hash >> 8) % std::size(kLeafColours)];
}

/// The door's own frame, and which of its faces the sector sees.
struct DoorFrame {
  PlanPoint hinge;
  double ux = 1, uy = 0;                 // plan direction of x
  int width = 0, height = 0, depth = 0;  // depth: from the line of the opening to the leaf's middle, mm; 0: none
  int side = -1;                         // the sector sees what faces this way along z
  std::int32_t sill_mm = 0;

  explicit DoorFrame(const Door& door) {
    const bool is_first = door.id < door.twin_id;
    const PlanPoint a = is_first ? door.a : door.b, b = is_first ? door.b : door.a;
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
    ux = dx / length;
    uy = dy / length;
    const double recess_mm = (is_first ? door.recess_m : -door.recess_m) * kMmPerMetre;
    hinge = {a.x + static_cast<std::int32_t>(std::lround(uy * recess_mm)),
             a.y - static_cast<std::int32_t>(std::lround(ux * recess_mm))};
    width = static_cast<int>(std::lround(length));
    height = height_mm(door.height_m);
    depth = static_cast<int>(std::lround(recess_mm));
    side = is_first ? -1 : 1;
    sill_mm = height_mm(door.sill_m);
  }

  X3dPoint in_sector(X3dPoint p, PlanPoint origin) const {
    const double east = hinge.x + ux * p.x + uy * p.z, north = hinge.y + uy * p.x - ux * p.z;
    return {static_cast<std::int32_t>(std::lround(east)) - origin.x, sill_mm + p.y,
            origin.y - static_cast<std::int32_t>(std::lround(north))};
  }
};

/// Faces in the door's frame.
class DoorFaces {
 public:
  /// A rectangle across z, seen from `side` of it.
  void add_front(int side, int x0, int x1, int y0, int y1, int z, Colour colour) {
    if (side > 0)
      add({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}, colour);
    else
      add({x1, y0, z}, {x0, y0, z}, {x0, y1, z}, {x1, y1, z}, colour);
  }
  void add(X3dPoint a, X3dPoint b, X3dPoint c, X3dPoint d, Colour colour) {
    faces_.push_back({{a, b, c, d}, 4, colour});
  }
  const std::vector<Face>& all() const { return faces_; }

 private:
  std::vector<Face> faces_;
};

void add_leaf(DoorFaces& faces, const DoorFrame& f, Colour wood) {
  const int w = f.width, h = f.height, z = f.side * kHalfLeaf, sunk = f.side * (kHalfLeaf - kSunk), s = f.side;
  const Colour panel = shaded(wood, 0.82), bar = shaded(wood, 1.12);
  faces.add_front(s, 0, kStile, 0, h, z, wood);
  faces.add_front(s, w - kStile, w, 0, h, z, wood);
  faces.add_front(s, kStile, w - kStile, h - kStile, h, z, wood);
  faces.add_front(s, kStile, w - kStile, 0, kStile, z, wood);
  faces.add_front(s, kStile, w - kStile, kPanel - kStile, kPanel, z, wood);
  faces.add_front(s, kStile, w - kStile, kStile, kPanel - kStile, sunk, panel);
  // A cross on the pane, a handle.
  const int middle = w / 2, across = (kPanel + h - kStile) / 2, out = f.side * (kHalfLeaf + 2);
  faces.add_front(s, middle - kBar / 2, middle + kBar / 2, kPanel, h - kStile, z, bar);
  faces.add_front(s, kStile, w - kStile, across - kBar / 2, across + kBar / 2, z, bar);
  faces.add_front(s, w - kStile / 2 - 15, w - kStile / 2 + 15, 960, 1120, out, kBrass);
  if (f.side > 0) return;  // the edge is drawn once
  faces.add({w, 0, kHalfLeaf}, {w, 0, -kHalfLeaf}, {w, h, -kHalfLeaf}, {w, h, kHalfLeaf}, panel);
}

/// The doorway as far as the leaf, and a frame of stone around it on the facade.
void add_jamb(DoorFaces& faces, const DoorFrame& f) {
  if (f.side > 0 || f.depth <= 0) return;
  const int w = f.width, h = f.height, out = -f.depth, front = out - kTrimOut;
  faces.add({0, 0, kHalfLeaf}, {0, 0, front}, {0, h, front}, {0, h, kHalfLeaf}, kJamb);
  faces.add({w, 0, front}, {w, 0, kHalfLeaf}, {w, h, kHalfLeaf}, {w, h, front}, kJamb);
  faces.add({0, h, front}, {w, h, front}, {w, h, kHalfLeaf}, {0, h, kHalfLeaf}, kJamb);
  faces.add({0, -kThresholdSunk, kHalfLeaf}, {w, -kThresholdSunk, kHalfLeaf}, {w, -kThresholdSunk, out},
            {0, -kThresholdSunk, out}, kTrimStone);
  faces.add_front(-1, -kTrim, 0, 0, h + kTrim, front, kTrimStone);
  faces.add_front(-1, w, w + kTrim, 0, h + kTrim, front, kTrimStone);
  faces.add_front(-1, 0, w, h, h + kTrim, front, kTrimStone);
  faces.add({-kTrim, 0, out}, {-kTrim, 0, front}, {-kTrim, h + kTrim, front}, {-kTrim, h + kTrim, out},
            shaded(kTrimStone, 0.85));
  faces.add({w + kTrim, 0, front}, {w + kTrim, 0, out}, {w + kTrim, h + kTrim, out}, {w + kTrim, h + kTrim, front},
            shaded(kTrimStone, 0.85));
}

/// A room seen from its door, or a street from inside: flat, in the plane behind the pane.
void add_picture(DoorFaces& faces, const DoorFrame& f, bool leads_out) {
  const int w = f.width, h = f.height, z = -f.side * kPicture, s = f.side;
  if (leads_out) {
    faces.add_front(s, 0, w, 0, h * 5 / 12, z, {134, 128, 120});
    faces.add_front(s, 0, w, h * 5 / 12, h * 9 / 12, z, {206, 188, 156});
    faces.add_front(s, 0, w, h * 9 / 12, h, z, {176, 204, 232});
    return;
  }
  const int l = w * 3 / 10, r = w - l, low = h * 4 / 10, top = h * 8 / 10;
  const auto add = [&](int ax, int ay, int bx, int by, int cx, int cy, int dx, int dy, Colour c) {
    if (s > 0)
      faces.add({ax, ay, z}, {bx, by, z}, {cx, cy, z}, {dx, dy, z}, c);
    else
      faces.add({dx, dy, z}, {cx, cy, z}, {bx, by, z}, {ax, ay, z}, c);
  };
  add(l, low, r, low, r, top, l, top, {212, 202, 182});
  add(0, 0, w, 0, r, low, l, low, {142, 104, 70});
  add(l, top, r, top, w, h, 0, h, {238, 234, 224});
  add(0, 0, l, low, l, top, 0, h, {196, 186, 166});
  add(r, low, w, 0, w, h, r, top, {186, 176, 156});
}

DoorFaces pane_of(const DoorFrame& f) {
  DoorFaces pane;
  pane.add_front(f.side, kStile, f.width - kStile, kPanel, f.height - kStile, f.side * (kHalfLeaf - kSunk), kGlass);
  return pane;
}

/// A Shape whose Material has a name.
Node named_shape(const std::vector<Face>& faces, const std::string& material, double transparency) {
  Node shape = shape_of("", Shading::solid, faces);
  for (auto& field : shape.nodes)
    if (field.name == "appearance") {
      Node& node = field.nodes.front().nodes.front().nodes.front();
      node.def = material;
      if (transparency > 0) node.set("transparency", transparency);
    }
  return shape;
}

Node door_node(const Door& door, const CityIndex& index, PlanPoint origin) {
  const DoorFrame f(door);
  DoorFaces leaf, jamb, picture;
  add_leaf(leaf, f, leaf_colour(door));
  add_jamb(jamb, f);
  add_picture(picture, f, index.interior(door.to_sector_id) == nullptr);

  Node place("Transform"), touch("TouchSensor", "DOOR-TOUCH-" + door.id), swing("Transform", "DOOR-LEAF-" + door.id),
      beyond("Group", "DOOR-BEYOND-" + door.id);
  const X3dPoint hinge = f.in_sector({0, 0, 0}, origin);
  place.set("translation", std::vector<double>{metres(hinge.x), metres(hinge.y), metres(hinge.z)});
  place.set("rotation", std::vector<double>{0, 1, 0, std::atan2(f.uy, f.ux)});
  touch.set("description", "Open the door");
  swing.add(shape_of("", Shading::solid, leaf.all()));
  swing.add(named_shape(pane_of(f).all(), "DOOR-GLASS-" + door.id, kGlassTransparency));
  beyond.add(named_shape(picture.all(), "DOOR-LAMP-" + door.id, 0));
  place.add(std::move(touch)).add(std::move(beyond));
  if (!jamb.all().empty()) place.add(shape_of("", Shading::solid, jamb.all()));
  return place.add(std::move(swing));
}

}  // namespace

std::vector<Node> door_nodes(const CityIndex& index, const Sector& sector) {
  std::vector<Node> nodes;
  for (const Door* door : index.doors_of(sector.id)) nodes.push_back(door_node(*door, index, sector.origin));
  return nodes;
}

std::vector<Face> door_faces(const CityIndex& index, const Sector& sector) {
  std::vector<Face> faces;
  for (const Door* door : index.doors_of(sector.id)) {
    const DoorFrame f(*door);
    DoorFaces own = pane_of(f);
    add_leaf(own, f, leaf_colour(*door));
    add_jamb(own, f);
    for (Face face : own.all()) {
      for (X3dPoint& p : face.corners) p = f.in_sector(p, sector.origin);
      faces.push_back(face);
    }
  }
  return faces;
}

}  // namespace vicus
