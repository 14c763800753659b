#include "x3d_export/sector_mesh.hpp"

#include "city_db/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "city_db/facade_layout.hpp"
#include "city_db/segment.hpp"
#include "city_db/wall_stretches.hpp"
#include "x3d_export/facade_levels.hpp"
#include "x3d_export/far_windows.hpp"
#include "x3d_export/ground_levels.hpp"
#include "x3d_export/house_body.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/objects.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kParapet_m = 0.9;  // a bank's rail: one looks over it
constexpr double kEdge_m = 0.15;    // an edge without a wall
constexpr double kBuried_m = 0.5;   // of a wall on a slope
constexpr double kFence_m = 1.5;    // where the map names no height
constexpr double kBackdrop_m = 15;  // hides what is not there, as high as the houses of an old town

using Line = std::vector<PlanPoint>;

/// Douglas and Peucker: appends the points to keep of line[first, last), the last one left to the caller.
void append_simplified(Line& out, const Line& line, std::size_t first, std::size_t last) {
  std::size_t farthest = first;
  double distance = kFarTolerance_mm;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double d = distance_to_segment_mm(line[i], line[first], line[last]); d > distance) {
      farthest = i;
      distance = d;
    }
  if (farthest == first) {
    out.push_back(line[first]);
    return;
  }
  append_simplified(out, line, first, farthest);
  append_simplified(out, line, farthest, last);
}

Line simplified(const Line& line) {
  Line out;
  append_simplified(out, line, 0, line.size() - 1);
  out.push_back(line.back());
  return out;
}

void add_walls(FaceList& faces, const Line& line, double bottom_m, double top_m, Colour colour) {
  for (std::size_t i = 1; i < line.size(); ++i) faces.add_wall(line[i - 1], line[i], bottom_m, top_m, colour);
}

bool is_drawn(const Building& house, Detail detail, const CityIndex& index, const Sector& sector) {
  return detail != Detail::tall || index.tall_houses_of(sector.id).contains(house.id);
}

/// Walls on the ground; on a slope they go into it, so that nothing shows below them.
void add_walls_on_ground(FaceList& faces, const GroundLevels& ground, const Line& line, double height_m,
                         Colour colour) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const std::int32_t a = ground.at(line[i - 1]), b = ground.at(line[i]);
    faces.add_sloped_wall(line[i - 1], line[i], a, b, a == b ? 0 : -kBuried_m, height_m, colour);
  }
}

/// What the ground is made of; all of it one plain where the city has no surfaces.
void add_surfaces(FaceList& faces, const CityIndex& index, const Sector& sector) {
  const auto& surfaces = index.surfaces_of(sector.id);
  if (surfaces.empty()) faces.add_floor(sector.ground, sector.ground_triangles, 0, ground_colour(sector.kind), false);
  for (const Surface* s : surfaces) faces.add_ground(s->points, s->triangles, surface_colour(s->kind));
}

/// A wall with doors in it: what is beside, above and below them.
void add_pieces(FaceList& faces, const std::vector<WallStretch>& pieces, const Building& house,
                const LeveledStretches& levels) {
  for (const WallStretch& piece : pieces) {
    const auto leveled = levels.find({piece.a, piece.b});
    const double top_m = leveled == levels.end() ? wall_top_m(house) : leveled->second;
    const double sill_m = piece.door ? piece.door->sill_m - house.ground_m : top_m;
    faces.add_wall(piece.a, piece.b, -house.foot_m, sill_m, house.wall_colour);
    if (piece.door) faces.add_wall(piece.a, piece.b, sill_m + piece.door->height_m, top_m, house.wall_colour);
  }
}

/// The walls of a border, corner by corner. Of those that come with levels of detail only what is below the facade.
void add_walls_without_levels(FaceList& faces, const Border& border, const Building& house,
                              const LeveledStretches& levels, const std::vector<const Door*>& doors) {
  const auto runs = straight_runs(border.line);
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const auto pieces = wall_stretches(border.line[runs[i]], border.line[runs[i + 1]], doors);
    if (pieces.size() != 1 || pieces.front().door) {
      add_pieces(faces, pieces, house, levels);
      continue;
    }
    // A facade takes all of a run, or a part of it.
    for (std::size_t k = runs[i]; k < runs[i + 1];) {
      auto leveled = levels.end();
      std::size_t next = runs[i + 1];
      for (; next > k && (leveled = levels.find({border.line[k], border.line[next]})) == levels.end();) --next;
      if (leveled == levels.end()) next = k + 1;
      add_walls(faces,
                Line(border.line.begin() + static_cast<std::ptrdiff_t>(k),
                     border.line.begin() + static_cast<std::ptrdiff_t>(next) + 1),
                -house.foot_m, leveled == levels.end() ? wall_top_m(house) : leveled->second, house.wall_colour);
      k = next;
    }
  }
}

/// What a house's facades in the sector look like from afar: their mean colour, storeys and bays of the longest.
struct FarLook {
  Colour colour;
  int floors = 0;
  double bay_m = 1;
};

/// By house; those without openings are left out.
std::map<std::string, FarLook> looks_from_afar(const CityIndex& index, const Sector& sector) {
  struct Sum {
    double length = 0, r = 0, g = 0, b = 0, longest = 0;
    FarLook look;
  };
  std::map<std::string, Sum> sums;
  for (const Facade* f : index.facades_of(sector.id)) {
    const Building* house = index.building(f->building_id);
    if (!house) continue;
    const Colour c = mean_colour(*f, house->wall_colour);
    const double length = length_m(*f);
    Sum& sum = sums[house->id];
    sum.length += length;
    sum.r += length * c.r;
    sum.g += length * c.g;
    sum.b += length * c.b;
    if (length <= sum.longest) continue;
    sum.longest = length;
    sum.look = {{}, f->floors, length / (f->bays * f->repeats)};
  }
  std::map<std::string, FarLook> looks;
  for (const auto& [id, sum] : sums) {
    const auto channel = [&](double v) { return static_cast<std::uint8_t>(std::lround(v / sum.length)); };
    if (sum.length <= 0) continue;
    FarLook& look = looks.emplace(id, sum.look).first->second;
    look.colour = {channel(sum.r), channel(sum.g), channel(sum.b)};
  }
  return looks;
}

void add_windowed_walls(FaceList& faces, const Line& line, const Building& house, const FarLook& look) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length_m = std::hypot(metres(line[i].x - line[i - 1].x), metres(line[i].y - line[i - 1].y));
    const WindowGrid grid = window_grid(length_m, look.bay_m, look.floors);
    faces.add_wall(line[i - 1], line[i], -house.foot_m, wall_top_m(house), look.colour, grid.bays, grid.floors);
  }
}

/// Facades of the sector's own border: ground on the left of the line, and seen from there.
void add_facades(FaceList& faces, const CityIndex& index, const Sector& sector, Detail detail) {
  const LeveledStretches levels = detail == Detail::near ? stretches_with_levels(index, sector) : LeveledStretches();
  const auto from_afar = detail == Detail::near ? std::map<std::string, FarLook>() : looks_from_afar(index, sector);
  for (const Border* border : index.borders_of(sector.id)) {
    if (border->kind != BorderKind::facade || border->line.size() < 2) continue;
    const Building* house = index.building(border->building_id);
    // A house over a passage sends all its walls itself.
    if (!house || house->base_m > 0 || !is_drawn(*house, detail, index, sector)) continue;
    faces.set_lift(house->ground_m);
    const auto look = from_afar.find(house->id);
    if (detail == Detail::near)
      add_walls_without_levels(faces, *border, *house, levels, index.doors_of(sector.id));
    else if (look == from_afar.end())
      add_walls(faces, simplified(border->line), -house->foot_m, wall_top_m(*house), house->wall_colour);
    else
      add_windowed_walls(faces, simplified(border->line), *house, look->second);
  }
}

/// Is a -> b, as seen from outside, a piece of the facade's line?
bool lies_in(PlanPoint a, PlanPoint b, const Facade& f) {
  return distance_to_segment_mm(a, f.b, f.a) <= kStraight_mm && distance_to_segment_mm(b, f.b, f.a) <= kStraight_mm;
}

/// Facades that reach up into gables; the house's other ones end at the eave.
WallTop facade_tops(const CityIndex& index, const Sector& sector, const Building& house) {
  std::vector<const Facade*> tall;
  for (const Facade* f : index.facades_of(sector.id))
    if (f->building_id == house.id && f->bottom_m <= 0 && f->top_m > house.eave_m) tall.push_back(f);
  if (tall.empty()) return {};
  return [tall](PlanPoint a, PlanPoint b) {
    for (const Facade* f : tall)
      if (lies_in(a, b, *f)) return f->top_m;
    return -HUGE_VAL;
  };
}

/// Facades on walls between parts of the house's roof.
StepWall step_walls(const CityIndex& index, const Sector& sector, const Building& house) {
  std::vector<const Facade*> upper;
  for (const Facade* f : index.facades_of(sector.id))
    if (f->building_id == house.id && f->bottom_m > 0) upper.push_back(f);
  if (upper.empty()) return {};
  return [upper](PlanPoint a, PlanPoint b) -> std::optional<std::pair<double, double>> {
    for (const Facade* f : upper)
      if (lies_in(a, b, *f)) return std::pair(f->bottom_m, f->top_m);
    return std::nullopt;
  };
}

/// Roofs, side walls and undersides of the houses that this sector sends.
void add_houses(FaceList& faces, const CityIndex& index, const Sector& sector, Detail detail) {
  const LeveledStretches levels = detail == Detail::near ? stretches_with_levels(index, sector) : LeveledStretches();
  for (const Building* house : index.buildings_of(sector.id))
    if (is_drawn(*house, detail, index, sector)) {
      faces.set_lift(house->ground_m);
      add_body(
          faces, *house,
          [&](const SideWall& wall) {
            return levels.contains({wall.b, wall.a});
          },
          detail == Detail::near ? facade_tops(index, sector, *house) : WallTop(),
          detail == Detail::near ? step_walls(index, sector, *house) : StepWall());
    }
}

void add_barriers(FaceList& faces, const CityIndex& index, const GroundLevels& ground, const Sector& sector) {
  for (const Border* border : index.borders_of(sector.id)) {
    const double height_m = border->height_m > 0 ? border->height_m : kFence_m;
    switch (border->kind) {
      case BorderKind::facade:
        break;
      case BorderKind::wall:
        add_walls_on_ground(faces, ground, border->line, height_m, kWallColour);
        break;
      case BorderKind::fence:
        add_walls_on_ground(faces, ground, border->line, height_m, kFenceColour);
        break;
      case BorderKind::bank:
        add_walls_on_ground(faces, ground, border->line, kParapet_m, kParapetColour);
        break;
      case BorderKind::edge:
        add_walls_on_ground(faces, ground, border->line, kEdge_m, kParapetColour);
        break;
    }
  }
}

/// Objects beyond those that have a Shape of their own, and from afar the larger trees.
void add_objects(FaceList& faces, const CityIndex& index, const Sector& sector, Detail detail) {
  for (const StandaloneObject* object :
       detail == Detail::near ? plain_objects(index, sector) : index.objects_of(sector.id)) {
    faces.set_lift(object->ground_m);
    for (const auto& s : detail == Detail::near ? spindles_of(*object) : far_spindles_of(*object))
      faces.add_spindle(object->at, s.sides, s.radius_low_m, s.radius_high_m, s.low_m, s.high_m, s.colour);
  }
}

/// Paper 004 §4.1.4: out of the city a gate is a solid face, an obstacle.
void add_backdrops(FaceList& faces, const CityIndex& index, const GroundLevels& ground, const Sector& sector) {
  for (const Gate* gate : index.gates_of(sector.id))
    if (gate->to_sector_id.empty()) add_walls_on_ground(faces, ground, gate->line, kBackdrop_m, kSkyColour);
}

}  // namespace

std::vector<Layer> sector_layers(const CityIndex& index, const Sector& sector, Detail detail) {
  FaceList ground(sector.origin), houses(sector.origin), barriers(sector.origin), objects(sector.origin),
      backdrops(sector.origin);
  FaceList& floor = detail == Detail::far ? houses : ground;
  if (detail != Detail::tall) add_surfaces(floor, index, sector);
  add_facades(houses, index, sector, detail);
  add_houses(houses, index, sector, detail);
  if (detail == Detail::far) add_objects(houses, index, sector, detail);
  if (detail == Detail::near) {
    const GroundLevels levels(index, sector);
    add_barriers(barriers, index, levels, sector);
    add_objects(objects, index, sector, detail);
    add_backdrops(backdrops, index, levels, sector);
  }
  const auto& meta = index.city().meta;
  const auto grain = meta.find("grain");
  std::vector<Layer> layers{{"GROUND", Shading::solid, ground.take(), grain == meta.end() ? "" : grain->second},
                            {"HOUSES", Shading::solid, houses.take()},
                            {"BARRIERS", Shading::two_sided, barriers.take()},
                            {"OBJECTS", Shading::solid, objects.take()},
                            {"BACKDROP", Shading::backdrop, backdrops.take()}};
  std::erase_if(layers, [](const Layer& layer) { return layer.faces.empty(); });
  return layers;
}

}  // namespace vicus
