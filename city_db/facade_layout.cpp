#include "city_db/facade_layout.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/segment.hpp"

namespace vicus {
namespace {

/// Widest and highest of the openings of one floor.
struct WindowFigures {
  OpeningKind kind;
  double width, height, sill;
};

WindowFigures upper_window(FacadeStyle style, int floor) {
  switch (style) {
    case FacadeStyle::stone:
      return {OpeningKind::tall_window, 1.12, 2.3 - 0.12 * std::min(floor - 1, 4), 0.32};
    case FacadeStyle::modern:
      return {OpeningKind::wide_window, 1.75, 1.45, 0.92};
    case FacadeStyle::church:
    case FacadeStyle::shed:
    case FacadeStyle::plaster:
    case FacadeStyle::brick:
      break;
  }
  return {OpeningKind::window, 1.06, 1.55, 0.80};
}

WindowFigures ground_window(FacadeStyle style) {
  switch (style) {
    case FacadeStyle::church:
      return {OpeningKind::church_window, 1.5, 4.0, 4.3};
    case FacadeStyle::modern:
      return {OpeningKind::wide_window, 1.75, 1.45, 1.0};
    case FacadeStyle::stone:
    case FacadeStyle::plaster:
    case FacadeStyle::brick:
    case FacadeStyle::shed:
      break;
  }
  return {OpeningKind::window, 1.06, 1.60, 1.05};
}

/// House doors are larger than the ground floor windows with their surrounds: a door stands before the image of one.
Opening door_of(FacadeStyle style, double ground_floor) {
  const auto door = [&](OpeningKind kind, double width, double height) {
    return Opening{kind, -width / 2, width / 2, 0, std::min(height, ground_floor - 0.3), 0, 0};
  };
  switch (style) {
    case FacadeStyle::church:
      return door(OpeningKind::church_door, 2.4, 3.8);
    case FacadeStyle::shed:
      return door(OpeningKind::gate_door, 2.4, 2.2);
    case FacadeStyle::stone:
      return door(OpeningKind::house_door, 1.55, 2.95);
    case FacadeStyle::modern:
      return door(OpeningKind::house_door, 1.95, 2.65);
    case FacadeStyle::plaster:
    case FacadeStyle::brick:
      break;
  }
  return door(OpeningKind::house_door, 1.42, 2.85);
}

constexpr double kTallestDoor = 1.2;  // times its usual height

}  // namespace

const StyleFigures& figures_of(FacadeStyle style) {
  static constexpr StyleFigures kPlaster{2.5, 3.4, 2.95, 0.5, 0.12}, kStone{2.55, 3.8, 3.05, 0.7, 0.22},
      kBrick{2.5, 3.3, 2.95, 0.4, 0.12}, kModern{3.0, 3.2, 3.0, 0.4, 0.10}, kChurch{4.5, 9.0, 3.0, 0.6, 0.30},
      kShed{4.0, 2.7, 2.7, 0.2, 0.06};
  switch (style) {
    case FacadeStyle::plaster:
      return kPlaster;
    case FacadeStyle::stone:
      return kStone;
    case FacadeStyle::brick:
      return kBrick;
    case FacadeStyle::modern:
      return kModern;
    case FacadeStyle::church:
      return kChurch;
    case FacadeStyle::shed:
      return kShed;
  }
  return kPlaster;
}

double pattern_width_m(const Facade& facade) {
  return facade.openings.empty() ? facade.bays * figures_of(facade.style).bay : length_m(facade);
}

double pattern_height_m(const Facade& facade) {
  if (!facade.openings.empty()) return facade.top_m - facade.bottom_m;
  const StyleFigures& f = figures_of(facade.style);
  return f.ground_floor + (facade.floors - 1) * f.storey + f.cornice;
}

std::vector<Opening> pattern_openings(const Facade& facade) {
  if (!facade.openings.empty()) return facade.openings;
  const StyleFigures& f = figures_of(facade.style);
  std::vector<Opening> openings;
  for (int bay = 0; bay < facade.bays; ++bay) {
    const double middle = (bay + 0.5) * f.bay;
    const auto add = [&](const Opening& o, double floor_z, int floor) {
      openings.push_back({o.kind, middle + o.x0, middle + o.x1, floor_z + o.z0, floor_z + o.z1, floor, bay, f.depth});
    };
    const auto window = [](const WindowFigures& w) {
      return Opening{w.kind, -w.width / 2, w.width / 2, w.sill, w.sill + w.height, 0, 0};
    };
    if (facade.style == FacadeStyle::church) {  // windows stand above the door
      if (bay == facade.door_bay) add(door_of(facade.style, f.ground_floor), 0, 0);
      add(window(ground_window(facade.style)), 0, 1);
    } else if (bay == facade.door_bay) {
      add(door_of(facade.style, f.ground_floor), 0, 0);
    } else if (facade.has_shop) {
      add({OpeningKind::shop, -0.46 * f.bay, 0.46 * f.bay, 0.12, f.ground_floor - 0.35, 0, 0}, 0, 0);
    } else if (facade.style != FacadeStyle::shed) {
      add(window(ground_window(facade.style)), 0, 0);
    }
    for (int floor = 1; floor < facade.floors; ++floor)
      add(window(upper_window(facade.style, floor)), f.ground_floor + (floor - 1) * f.storey, floor);
  }
  return openings;
}

Facade image_pattern(Facade facade) {
  if (facade.style != FacadeStyle::shed && facade.openings.empty()) facade.door_bay = -1;
  return facade;
}

double length_m(const Facade& facade) {
  return std::hypot(metres(facade.b.x - facade.a.x), metres(facade.b.y - facade.a.y));
}

int opening_count(const Facade& facade) {
  return facade.openings.empty() ? facade.floors * facade.bays * facade.repeats
                                 : static_cast<int>(facade.openings.size());
}

std::vector<Opening> openings_of(const Facade& facade) {
  if (!facade.openings.empty()) return facade.openings;
  const auto pattern = pattern_openings(facade);
  const double width = length_m(facade) / facade.repeats, sx = width / pattern_width_m(facade);
  const double sz = (facade.top_m - facade.bottom_m) / pattern_height_m(facade);
  std::vector<Opening> openings;
  for (int i = 0; i < facade.repeats; ++i)
    for (const Opening& o : pattern) {
      // The walls of a church grow with it, its door is made for people.
      const double top = o.kind == OpeningKind::church_door ? std::min(sz * o.z1, kTallestDoor * o.z1) : sz * o.z1;
      openings.push_back({o.kind, i * width + sx * o.x0, i * width + sx * o.x1, sz * o.z0, top, o.floor,
                          i * facade.bays + o.bay, o.depth});
    }
  return openings;
}

AtlasTile atlas_tile(OpeningKind kind) {
  constexpr double kInset = kTileInset_px / kTilePixels;
  const int i = static_cast<int>(kind), column = i % kAtlasColumns, row = i / kAtlasColumns;
  const auto at = [](double n, int of) { return n / of; };
  return {at(column + kInset, kAtlasColumns), at(kAtlasRows - 1 - row + kInset, kAtlasRows),
          at(column + 1 - kInset, kAtlasColumns), at(kAtlasRows - row - kInset, kAtlasRows)};
}

std::vector<std::size_t> straight_runs(const std::vector<PlanPoint>& line) {
  std::vector<std::size_t> runs;
  if (line.empty()) return runs;
  std::size_t first = 0;
  runs.push_back(0);
  for (std::size_t last = 2; last < line.size(); ++last) {
    bool is_straight = true;
    for (std::size_t i = first + 1; i < last && is_straight; ++i)
      is_straight = distance_to_segment_mm(line[i], line[first], line[last]) <= kStraight_mm;
    if (is_straight) continue;
    first = last - 1;
    runs.push_back(first);
  }
  if (line.size() > 1) runs.push_back(line.size() - 1);
  return runs;
}

}  // namespace vicus
