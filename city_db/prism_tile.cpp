#include "city_db/prism_tile.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "city_db/byte_fields.hpp"
#include "city_db/prism_tile_layout.h"
#include "city_db/varint.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kMostCoordinate = 1 << 28;
constexpr std::uint64_t kMostHeight = 1 << 24;
constexpr std::size_t kMostColours = 4096;

/// Kinds with a ridge have four points; the tent, the flat and the faceted roof any.
bool has_right_points(const PrismHouse& house) {
  if (house.kind == PrismKind::flat || house.kind == PrismKind::faceted) return true;
  if (house.rings.size() != 1) return false;
  return house.kind == PrismKind::tent || house.rings[0].size() == 4;
}

std::vector<PlanPoint> points_of(const std::vector<std::vector<PlanPoint>>& rings) {
  std::vector<PlanPoint> out;
  for (const auto& ring : rings) out.insert(out.end(), ring.begin(), ring.end());
  return out;
}

bool read_point(VarintSource (&in)[PRISM_STREAMS], const std::vector<PlanPoint>& corners, std::int64_t& anchor,
                PrismPoint& point) {
  anchor += in[PRISM_STREAM_ANCHOR].next_signed();
  if (anchor < 0 || anchor >= static_cast<std::int64_t>(corners.size())) return false;
  const PlanPoint near = corners[static_cast<std::size_t>(anchor)];
  const std::int64_t x = near.x + in[PRISM_STREAM_OFFSET].next_signed(),
                     y = near.y + in[PRISM_STREAM_OFFSET].next_signed(), up = in[PRISM_STREAM_RISE].next_signed();
  if (!in[PRISM_STREAM_OFFSET].is_good || std::abs(x) > kMostCoordinate || std::abs(y) > kMostCoordinate ||
      std::abs(up) > static_cast<std::int64_t>(kMostHeight))
    return false;
  point = {{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, static_cast<std::int32_t>(up)};
  return true;
}

bool read_facet(VarintSource& in, std::size_t corners, std::int64_t& first, PrismFacet& facet) {
  const std::uint64_t shape = in.next();
  facet.is_gable = shape % 2 == 1;
  std::int64_t corner = first;
  for (std::uint64_t n = shape / 2 + 3; n > 0; --n) {
    corner += in.next_signed();
    if (!in.is_good || corner < 0 || corner >= static_cast<std::int64_t>(corners)) return false;
    if (facet.corners.empty()) first = corner;
    facet.corners.push_back(static_cast<std::uint32_t>(corner));
  }
  return true;
}

/// `in` stands behind the rings.
bool read_facets(VarintSource (&in)[PRISM_STREAMS], PrismHouse& house) {
  const std::uint64_t points = in[PRISM_STREAM_SHAPE].next(), facets = in[PRISM_STREAM_SHAPE].next();
  const std::vector<PlanPoint> corners = points_of(house.rings);
  std::int64_t anchor = 0, first = 0;
  for (std::uint64_t i = 0; i < points; ++i)
    if (!read_point(in, corners, anchor, house.points.emplace_back())) return false;
  for (std::uint64_t i = 0; i < facets; ++i)
    if (!read_facet(in[PRISM_STREAM_FACET], corners.size() + house.points.size(), first, house.facets.emplace_back()))
      return false;
  return true;
}

void append_facets(std::string (&streams)[PRISM_STREAMS], const PrismHouse& house) {
  append_varint(streams[PRISM_STREAM_SHAPE], house.points.size());
  append_varint(streams[PRISM_STREAM_SHAPE], house.facets.size());
  const std::vector<PlanPoint> corners = points_of(house.rings);
  std::int64_t before = 0;
  for (const PrismPoint& p : house.points) {
    const std::size_t anchor = nearest_to(p.at, corners);
    append_signed(streams[PRISM_STREAM_ANCHOR], static_cast<std::int64_t>(anchor) - before);
    before = static_cast<std::int64_t>(anchor);
    append_signed(streams[PRISM_STREAM_OFFSET], std::int64_t{p.at.x} - corners[anchor].x);
    append_signed(streams[PRISM_STREAM_OFFSET], std::int64_t{p.at.y} - corners[anchor].y);
    append_signed(streams[PRISM_STREAM_RISE], p.up);
  }
  std::int64_t first = 0;
  for (const PrismFacet& facet : house.facets) {
    assert(facet.corners.size() >= 3);
    append_varint(streams[PRISM_STREAM_FACET], 2 * (facet.corners.size() - 3) + (facet.is_gable ? 1 : 0));
    std::int64_t corner = first;
    for (const std::uint32_t next : facet.corners) {
      assert(next < corners.size() + house.points.size());
      append_signed(streams[PRISM_STREAM_FACET], std::int64_t{next} - corner);
      corner = next;
    }
    first = facet.corners[0];
  }
}

bool read_house(VarintSource (&in)[PRISM_STREAMS], PlanPoint& at, std::int64_t& ground, std::size_t colours,
                PrismHouse& house) {
  const std::uint64_t shape = in[PRISM_STREAM_SHAPE].next();
  if (shape % 8 >= PRISM_KINDS) return false;
  house.kind = static_cast<PrismKind>(shape % 8);
  house.is_owned = (shape & PRISM_OWNED) != 0;
  house.quadrant = static_cast<std::uint8_t>(shape / PRISM_QUADRANT % PRISM_QUADRANTS);
  if (house.quadrant != 0 && !house.is_owned) return false;
  const std::uint64_t rings = shape / PRISM_RINGS + 1;
  PlanPoint p = at;
  for (std::uint64_t r = 0; r < rings; ++r) {
    const std::uint64_t points = in[PRISM_STREAM_SHAPE].next() + 3;
    auto& ring = house.rings.emplace_back();
    for (std::uint64_t i = 0; i < points; ++i) {
      const std::int64_t x = p.x + in[PRISM_STREAM_EAST].next_signed(), y = p.y + in[PRISM_STREAM_NORTH].next_signed();
      if (!in[PRISM_STREAM_EAST].is_good || std::abs(x) > kMostCoordinate || std::abs(y) > kMostCoordinate)
        return false;
      p = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
      ring.push_back(p);
      if (r == 0 && i == 0) at = p;
    }
  }
  const bool is_faceted = house.kind == PrismKind::faceted;
  if (is_faceted && !read_facets(in, house)) return false;
  ground += in[PRISM_STREAM_GROUND].next_signed();
  const std::uint64_t eave = in[PRISM_STREAM_EAVE].next(),
                      rise = is_faceted ? highest_of(house.points) : in[PRISM_STREAM_RISE].next();
  const std::uint64_t wall = in[PRISM_STREAM_COLOUR].next(), roof = in[PRISM_STREAM_COLOUR].next();
  if (std::abs(ground) > static_cast<std::int64_t>(kMostHeight) || eave > kMostHeight || rise > kMostHeight ||
      wall >= colours || roof >= colours)
    return false;
  house.ground = static_cast<std::int32_t>(ground);
  house.eave = static_cast<std::uint32_t>(eave);
  house.rise = static_cast<std::uint32_t>(rise);
  house.wall = static_cast<std::uint16_t>(wall);
  house.roof = static_cast<std::uint16_t>(roof);
  for (const VarintSource& s : in)
    if (!s.is_good) return false;
  return has_right_points(house);
}

void append_trees(std::string (&streams)[PRISM_STREAMS], const std::vector<PrismTree>& trees) {
  PrismTree before;
  for (const PrismTree& tree : trees) {
    append_signed(streams[PRISM_STREAM_TREE_EAST], std::int64_t{tree.at.x} - before.at.x);
    append_signed(streams[PRISM_STREAM_TREE_NORTH], std::int64_t{tree.at.y} - before.at.y);
    append_signed(streams[PRISM_STREAM_TREE_GROUND], std::int64_t{tree.ground} - before.ground);
    append_varint(streams[PRISM_STREAM_TREE_SIZE], tree.height);
    append_varint(streams[PRISM_STREAM_TREE_SIZE], tree.crown);
    append_varint(streams[PRISM_STREAM_TREE_LOOK], static_cast<std::uint64_t>(tree.form) +
                                                       std::uint64_t{PRISM_TREE_QUADRANT} * tree.quadrant +
                                                       std::uint64_t{PRISM_TREE_COLOUR} * tree.leaves);
    before = tree;
  }
}

bool read_tree(VarintSource (&in)[PRISM_STREAMS], const PrismTree& before, std::size_t colours, PrismTree& tree) {
  const std::int64_t x = before.at.x + in[PRISM_STREAM_TREE_EAST].next_signed(),
                     y = before.at.y + in[PRISM_STREAM_TREE_NORTH].next_signed(),
                     ground = before.ground + in[PRISM_STREAM_TREE_GROUND].next_signed();
  const std::uint64_t height = in[PRISM_STREAM_TREE_SIZE].next(), crown = in[PRISM_STREAM_TREE_SIZE].next(),
                      look = in[PRISM_STREAM_TREE_LOOK].next(), leaves = look / PRISM_TREE_COLOUR;
  if (std::abs(x) > kMostCoordinate || std::abs(y) > kMostCoordinate ||
      std::abs(ground) > static_cast<std::int64_t>(kMostHeight) || height > kMostHeight || crown > kMostHeight ||
      look % PRISM_TREE_QUADRANT >= PRISM_TREE_FORMS || leaves >= colours)
    return false;
  tree.at = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  tree.ground = static_cast<std::int32_t>(ground);
  tree.height = static_cast<std::uint32_t>(height);
  tree.crown = static_cast<std::uint32_t>(crown);
  tree.form = static_cast<TreeForm>(look % PRISM_TREE_QUADRANT);
  tree.quadrant = static_cast<std::uint8_t>(look / PRISM_TREE_QUADRANT % PRISM_QUADRANTS);
  tree.leaves = static_cast<std::uint16_t>(leaves);
  return std::all_of(std::begin(in), std::end(in), [](const VarintSource& s) { return s.is_good; });
}

}  // namespace

std::size_t nearest_to(PlanPoint p, const std::vector<PlanPoint>& points) {
  const auto away = [p](PlanPoint q) { return std::abs(std::int64_t{q.x} - p.x) + std::abs(std::int64_t{q.y} - p.y); };
  const auto least =
      std::min_element(points.begin(), points.end(), [&](PlanPoint a, PlanPoint b) { return away(a) < away(b); });
  return static_cast<std::size_t>(least - points.begin());
}

std::uint32_t highest_of(const std::vector<PrismPoint>& points) {
  std::int32_t most = 0;
  for (const PrismPoint& p : points) most = std::max(most, p.up);
  return static_cast<std::uint32_t>(most);
}

std::string encode_prisms(const PrismTile& tile) {
  std::string streams[PRISM_STREAMS];
  PlanPoint first;
  std::int32_t ground = 0;
  for (const PrismHouse& house : tile.houses) {
    assert(!house.rings.empty() && has_right_points(house));
    append_varint(streams[PRISM_STREAM_SHAPE],
                  static_cast<std::uint64_t>(house.kind) + (house.is_owned ? PRISM_OWNED : 0) +
                      std::uint64_t{PRISM_QUADRANT} * house.quadrant + PRISM_RINGS * (house.rings.size() - 1));
    PlanPoint p = first;
    for (const auto& ring : house.rings) {
      append_varint(streams[PRISM_STREAM_SHAPE], ring.size() - 3);
      for (const PlanPoint q : ring) {
        append_signed(streams[PRISM_STREAM_EAST], std::int64_t{q.x} - p.x);
        append_signed(streams[PRISM_STREAM_NORTH], std::int64_t{q.y} - p.y);
        p = q;
      }
    }
    first = house.rings[0][0];
    append_signed(streams[PRISM_STREAM_GROUND], std::int64_t{house.ground} - ground);
    ground = house.ground;
    append_varint(streams[PRISM_STREAM_EAVE], house.eave);
    if (house.kind == PrismKind::faceted) {
      assert(house.rise == highest_of(house.points));
      append_facets(streams, house);
    } else {
      assert(house.points.empty() && house.facets.empty());
      append_varint(streams[PRISM_STREAM_RISE], house.rise);
    }
    append_varint(streams[PRISM_STREAM_COLOUR], house.wall);
    append_varint(streams[PRISM_STREAM_COLOUR], house.roof);
  }
  append_trees(streams, tile.trees);
  std::string out(PRISM_HEADER_BYTES, '\0');
  const auto put = [&](std::size_t at, std::uint64_t value, std::size_t size) { set_field(out, at, value, size); };
  put(PRISM_MAGIC_AT, PRISM_MAGIC, 4);
  put(PRISM_VERSION_AT, PRISM_VERSION, 2);
  put(PRISM_COLOURS_AT, tile.palette.size(), 2);
  put(PRISM_HOUSES_AT, tile.houses.size(), 4);
  put(PRISM_TILE_SIDE_AT, tile.tile_side_mm, 4);
  put(PRISM_EAST_AT, static_cast<std::uint32_t>(tile.corner.x), 4);
  put(PRISM_NORTH_AT, static_cast<std::uint32_t>(tile.corner.y), 4);
  put(PRISM_BASE_AT, static_cast<std::uint32_t>(tile.base_mm), 4);
  put(PRISM_STEP_AT, tile.step_mm, 4);
  put(PRISM_UP_STEP_AT, tile.up_step_mm, 4);
  put(PRISM_ERROR_AT, tile.error_mm, 4);
  put(PRISM_KEY_AT, tile.key, 8);
  put(PRISM_TREES_AT, tile.trees.size(), 4);
  for (std::size_t i = 0; i < PRISM_STREAMS; ++i) put(PRISM_LENGTHS_AT + 4 * i, streams[i].size(), 4);
  for (const Colour c : tile.palette)
    for (const std::uint8_t v : {c.r, c.g, c.b}) out.push_back(static_cast<char>(v));
  for (const auto& s : streams) out += s;
  return out;
}

std::optional<PrismTile> decode_prisms(std::string_view bytes) {
  if (bytes.size() < PRISM_HEADER_BYTES || u32_at(bytes, PRISM_MAGIC_AT) != PRISM_MAGIC ||
      u16_at(bytes, PRISM_VERSION_AT) != PRISM_VERSION)
    return std::nullopt;
  PrismTile tile;
  tile.corner = {i32_at(bytes, PRISM_EAST_AT), i32_at(bytes, PRISM_NORTH_AT)};
  tile.tile_side_mm = u32_at(bytes, PRISM_TILE_SIDE_AT);
  tile.base_mm = i32_at(bytes, PRISM_BASE_AT);
  tile.step_mm = u32_at(bytes, PRISM_STEP_AT);
  tile.up_step_mm = u32_at(bytes, PRISM_UP_STEP_AT);
  tile.error_mm = u32_at(bytes, PRISM_ERROR_AT);
  tile.key = field_at(bytes, PRISM_KEY_AT, 8);
  const std::size_t colours = u16_at(bytes, PRISM_COLOURS_AT), houses = u32_at(bytes, PRISM_HOUSES_AT),
                    trees = u32_at(bytes, PRISM_TREES_AT);
  if (colours > kMostColours || tile.step_mm == 0 || tile.up_step_mm == 0) return std::nullopt;
  std::uint64_t total = PRISM_HEADER_BYTES + 3 * colours, lengths[PRISM_STREAMS];
  for (std::size_t i = 0; i < PRISM_STREAMS; ++i) total += lengths[i] = u32_at(bytes, PRISM_LENGTHS_AT + 4 * i);
  if (total != bytes.size() || houses > lengths[PRISM_STREAM_SHAPE] || trees > lengths[PRISM_STREAM_TREE_LOOK])
    return std::nullopt;
  std::size_t at = PRISM_HEADER_BYTES;
  for (std::size_t i = 0; i < colours; ++i, at += 3)
    tile.palette.push_back({static_cast<std::uint8_t>(bytes[at]), static_cast<std::uint8_t>(bytes[at + 1]),
                            static_cast<std::uint8_t>(bytes[at + 2])});
  const auto stream = [&](std::size_t i) {
    const auto part = bytes.substr(at, lengths[i]);
    at += lengths[i];
    return VarintSource(part);
  };
  VarintSource in[PRISM_STREAMS] = {stream(0),  stream(1),  stream(2),  stream(3),  stream(4),
                                    stream(5),  stream(6),  stream(7),  stream(8),  stream(9),
                                    stream(10), stream(11), stream(12), stream(13), stream(14)};
  PlanPoint first;
  std::int64_t ground = 0;
  for (std::size_t i = 0; i < houses; ++i)
    if (!read_house(in, first, ground, colours, tile.houses.emplace_back())) return std::nullopt;
  PrismTree before;
  for (std::size_t i = 0; i < trees; ++i, before = tile.trees.back())
    if (!read_tree(in, before, colours, tile.trees.emplace_back())) return std::nullopt;
  for (const VarintSource& s : in)
    if (!s.is_done()) return std::nullopt;
  return tile;
}

}  // namespace vicus
