#include "sectorgen/sectors/noded_map.hpp"

#include "sectorgen/geom/noding.hpp"

namespace vicus {

std::vector<NodedPart> node_map(const Blocks& blocks, const std::vector<Polygon>& domain,
                                const std::vector<std::vector<PlanPoint>>& kerbs) {
  std::vector<NodedPart> parts;
  std::vector<Segment> segments;
  std::vector<std::size_t> begin;  // first segment of each part
  const auto add_line = [&](MapLayer layer, std::uint32_t feature, const std::vector<PlanPoint>& line, bool is_ring) {
    parts.push_back({layer, feature, {}});
    begin.push_back(segments.size());
    for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.push_back({line[i], line[i + 1]});
    if (is_ring) segments.push_back({line.back(), line.front()});
  };
  const auto add = [&](MapLayer layer, std::size_t feature, const Polygon& polygon) {
    add_line(layer, static_cast<std::uint32_t>(feature), polygon.outer, true);
    for (const auto& hole : polygon.holes) add_line(layer, static_cast<std::uint32_t>(feature), hole, true);
  };
  for (std::size_t i = 0; i < blocks.houses.size(); ++i)
    add(blocks.houses[i].is_overhead ? MapLayer::overhead : MapLayer::house, i, blocks.houses[i].area);
  for (std::size_t i = 0; i < blocks.walls.size(); ++i) add(MapLayer::wall, i, blocks.walls[i].area);
  for (std::size_t i = 0; i < blocks.water.size(); ++i) add(MapLayer::water, i, blocks.water[i]);
  for (std::size_t i = 0; i < domain.size(); ++i) add(MapLayer::domain, i, domain[i]);
  for (std::size_t i = 0; i < kerbs.size(); ++i)
    add_line(MapLayer::kerb, static_cast<std::uint32_t>(i), kerbs[i], false);

  const Noded noded = node_segments(segments);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::size_t end = k + 1 < parts.size() ? begin[k + 1] : segments.size();
    auto& points = parts[k].points;
    for (std::size_t s = begin[k]; s < end; ++s)
      points.insert(
          points.end(), noded.points.begin() + noded.begin[s],
          noded.points.begin() + noded.begin[s + 1] - (s + 1 < end || parts[k].layer != MapLayer::kerb ? 1 : 0));
  }
  return parts;
}

}  // namespace vicus
