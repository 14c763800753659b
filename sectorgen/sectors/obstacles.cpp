#include "sectorgen/sectors/obstacles.hpp"

#include <algorithm>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

constexpr double kPassageHalfWidthMin = 1.25, kPassageHalfWidthMax = 3.0;
constexpr double kOpeningHalfWidth = 1.5;  // a gate in a wall or fence
constexpr double kWallThicknessMin = 0.2;  // thinner ones would come out as slivers

/// Strokes along axes, found again by box.
struct Strokes {
  std::vector<Stroke> strokes;
  BoxIndex index;
  Strokes(std::vector<Stroke> s) : strokes(std::move(s)) {
    std::vector<PlanBox> boxes;
    for (const auto& stroke : strokes) boxes.push_back(grown(box_of(stroke.line), lattice_mm(stroke.radius_m + 1)));
    index = BoxIndex(std::move(boxes));
  }
  std::vector<Stroke> near(const PlanBox& box) const {
    std::vector<Stroke> out;
    for (std::uint32_t i : index.meeting(box)) out.push_back(strokes[i]);
    return out;
  }
};

void add_houses(const SourceMap& map, Blocks& blocks) {
  std::vector<Stroke> passages;
  for (const auto& axis : map.axes)
    if (axis.is_passage)
      passages.push_back({axis.line, std::clamp(axis.width_m / 2, kPassageHalfWidthMin, kPassageHalfWidthMax)});
  const Strokes strokes(std::move(passages));
  for (std::uint32_t i = 0; i < map.footprints.size(); ++i) {
    const Footprint& f = map.footprints[i];
    if (f.is_part) continue;  // parts shape the model; their outline blocks the ground
    if (f.base_m > kWalkUnderMetres) {
      blocks.houses.push_back({i, f.area, true, f.base_m});
      continue;
    }
    const auto near = strokes.near(box_of(f.area));
    if (near.empty()) {
      blocks.houses.push_back({i, f.area, false, 0});
      continue;
    }
    const auto ways = stroke_outlines(near, Cap::square);
    const double headroom = std::min(kPassageHeadroom, 0.7 * f.height_m);
    for (auto& p : subtract(f.area, ways)) blocks.houses.push_back({i, std::move(p), false, 0});
    for (auto& p : intersect(f.area, ways)) {
      blocks.passages.push_back(p);
      blocks.houses.push_back({i, std::move(p), true, headroom});
    }
  }
}

/// Does any piece of the line run over the area?
bool runs_over(const Line& line, const Polygon& area) {
  const auto crosses = [&](PlanPoint a, PlanPoint b, const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (cross_properly(a, b, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
    return false;
  };
  const PlanBox box = box_of(area);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PlanPoint a = line[i], b = line[i + 1];
    if (std::max(a.x, b.x) < box.min.x || std::min(a.x, b.x) > box.max.x || std::max(a.y, b.y) < box.min.y ||
        std::min(a.y, b.y) > box.max.y)
      continue;
    if (locate(area, a) == Side::inside || crosses(a, b, area.outer)) return true;
    for (const auto& hole : area.holes)
      if (crosses(a, b, hole)) return true;
  }
  return false;
}

void add_water(const SourceMap& map, Blocks& blocks) {
  std::vector<Stroke> decks;
  for (const auto& axis : map.axes)
    if (!axis.is_passage) decks.push_back({axis.line, axis.width_m / 2 + 1});
  const Strokes strokes(std::move(decks));
  for (const auto& area : map.areas) {
    if (area.kind != AreaKind::water) continue;
    auto near = strokes.near(box_of(area.area));
    std::erase_if(near, [&](const Stroke& s) { return !runs_over(s.line, area.area); });
    if (near.empty())
      blocks.water.push_back(area.area);
    else
      for (auto& p : subtract(area.area, stroke_outlines(near, Cap::flat))) blocks.water.push_back(std::move(p));
  }
}

void add_walls(const SourceMap& map, Blocks& blocks) {
  std::vector<Stroke> ways;
  for (const auto& axis : map.axes) ways.push_back({axis.line, axis.width_m / 2 + 0.5});
  const Strokes strokes(std::move(ways));
  for (std::uint32_t i = 0; i < map.barriers.size(); ++i) {
    const Barrier& b = map.barriers[i];
    const double half = std::max(kWallThicknessMin, b.thickness_m) / 2;
    auto open = strokes.near(grown(box_of(b.line), lattice_mm(half)));
    for (PlanPoint p : b.openings) {
      const std::int32_t d = lattice_mm(kOpeningHalfWidth);
      open.push_back({{{p.x - d, p.y}, {p.x + d, p.y}}, kOpeningHalfWidth});
    }
    for (auto& area : stroke_outlines({{b.line, half}}, Cap::flat)) {
      if (open.empty()) {
        blocks.walls.push_back({i, std::move(area)});
        continue;
      }
      for (auto& p : subtract(area, stroke_outlines(open, Cap::flat))) blocks.walls.push_back({i, std::move(p)});
    }
  }
}

}  // namespace

Blocks make_blocks(const SourceMap& map) {
  Blocks blocks;
  add_houses(map, blocks);
  add_water(map, blocks);
  add_walls(map, blocks);
  return blocks;
}

}  // namespace vicus
