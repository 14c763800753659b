#include <bit>
#include <cmath>

#include "city_db/boxes.hpp"
#include "city_db/facade_layout.hpp"
#include "city_db/roof_blob.hpp"
#include "city_db/store_fields.hpp"
#include "city_db/store_records.hpp"

/// Rows of houses and their facades.
namespace vicus {
namespace {

constexpr std::size_t kSideWallBytes = 24;  // a.x, a.y, b.x, b.y i32 mm, bottom f64 m
constexpr std::size_t kOpeningBytes = 44;   // kind, floor u16; x0, x1, z0, z1, depth f64 m

std::string bytes_from_side_walls(const std::vector<SideWall>& walls) {
  std::string bytes;
  for (const auto& [a, b, bottom_m] : walls) {
    for (const std::int32_t mm : {a.x, a.y, b.x, b.y}) append_le(bytes, static_cast<std::uint32_t>(mm));
    append_le(bytes, std::bit_cast<std::uint64_t>(bottom_m));
  }
  return bytes;
}

std::vector<SideWall> side_walls_from(const Statement& row, int column) {
  const auto bytes = row.bytes(column);
  if (bytes.size() % kSideWallBytes != 0) row.database().throw_damaged("side walls of odd length");
  std::vector<SideWall> walls;
  for (std::size_t at = 0; at < bytes.size(); at += kSideWallBytes) {
    const auto mm = [&](std::size_t i) { return std::bit_cast<std::int32_t>(le_at<std::uint32_t>(bytes, at + 4 * i)); };
    SideWall wall{{mm(0), mm(1)}, {mm(2), mm(3)}, std::bit_cast<double>(le_at<std::uint64_t>(bytes, at + 16))};
    for (const std::int64_t v : {wall.a.x, wall.a.y, wall.b.x, wall.b.y})
      if (std::abs(v) >= kPlanLimit) row.database().throw_damaged("a side wall outside the lattice");
    if (!std::isfinite(wall.bottom_m)) row.database().throw_damaged("a side wall whose height is not finite");
    walls.push_back(wall);
  }
  return walls;
}

std::string bytes_from_openings(const std::vector<Opening>& openings) {
  std::string bytes;
  for (const Opening& o : openings) {
    append_le(bytes, static_cast<std::uint16_t>(o.kind));
    append_le(bytes, static_cast<std::uint16_t>(o.floor));
    for (const double m : {o.x0, o.x1, o.z0, o.z1, o.depth}) append_le(bytes, std::bit_cast<std::uint64_t>(m));
  }
  return bytes;
}

/// What is drawn must have a size, and stand in order.
std::vector<Opening> openings_from(const Statement& row, int column) {
  const auto bytes = row.bytes(column);
  const std::size_t count = bytes.size() / kOpeningBytes;
  if (bytes.size() % kOpeningBytes != 0 || count > kMostOwnOpenings)
    row.database().throw_damaged("openings of odd length, or too many");
  std::vector<Opening> openings;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * kOpeningBytes;
    const auto kind = le_at<std::uint16_t>(bytes, at);
    const auto m = [&](std::size_t k) { return std::bit_cast<double>(le_at<std::uint64_t>(bytes, at + 4 + 8 * k)); };
    const Opening o{static_cast<OpeningKind>(kind),
                    m(0),
                    m(1),
                    m(2),
                    m(3),
                    le_at<std::uint16_t>(bytes, at + 2),
                    static_cast<int>(i),
                    m(4)};
    for (const double v : {o.x0, o.x1, o.z0, o.z1, o.depth})
      if (!(v >= 0 && v < metres(kPlanLimit))) row.database().throw_damaged("an opening that is out of its facade");
    if (kind >= kOpeningKinds || o.floor > kMostFloors || !(o.x0 < o.x1 && o.z0 < o.z1))
      row.database().throw_damaged("an opening of no known kind or no size");
    openings.push_back(o);
  }
  return openings;
}

int small_number_at(const Statement& row, int i, int least, int most) {
  const auto number = row.integer(i);
  if (number < least || number > most)
    row.database().throw_damaged("a number of " + std::to_string(number) + " where " + std::to_string(least) + " to " +
                                 std::to_string(most) + " can be");
  return static_cast<int>(number);
}

}  // namespace

void bind_record(Statement& row, const Building& b) {
  row.bind_blob(1, encode_polygon(b.footprint));
  row.bind(2, b.id);
  row.bind(3, b.source_id);
  row.bind(4, b.name);
  row.bind(5, b.sector_id);
  row.bind(6, b.ground_m);
  row.bind(7, b.foot_m);
  row.bind(8, b.base_m);
  row.bind(9, b.height_m);
  row.bind(10, b.eave_m);
  row.bind(11, b.roof_shape);
  row.bind(12, name_of(b.roof_source));
  row.bind(13, name_of(b.height_source));
  row.bind(14, json_from_tags(b.tags));
  row.bind_blob(15, encode_roof(b.roof));
  row.bind_blob(16, bytes_from_side_walls(b.side_walls));
  row.bind(17, hex_of(b.wall_colour));
  row.bind(18, hex_of(b.roof_colour));
}

void read_record(const Statement& row, Building& b) {
  b.footprint = polygon_at(row, 0);
  b.id = row.text(1);
  b.source_id = row.text(2);
  b.name = row.text(3);
  b.sector_id = row.text(4);
  b.ground_m = row.real(5);
  b.foot_m = row.real(6);
  b.base_m = row.real(7);
  b.height_m = row.real(8);
  b.eave_m = row.real(9);
  b.roof_shape = row.text(10);
  b.roof_source = kind_at<RoofSource>(row, 11);
  b.height_source = kind_at<HeightSource>(row, 12);
  b.tags = tags_at(row, 13);
  b.roof = require(row, decode_roof(row.bytes(14)), "bytes that are no roof");
  b.side_walls = side_walls_from(row, 15);
  b.wall_colour = require(row, colour_from_hex(row.text(16)), "a colour is not #rrggbb");
  b.roof_colour = require(row, colour_from_hex(row.text(17)), "a colour is not #rrggbb");
}

void bind_record(Statement& row, const Facade& f) {
  row.bind_blob(1, encode_line({f.a, f.b}));
  row.bind(2, f.sector_id);
  row.bind(3, f.building_id);
  row.bind(4, f.bottom_m);
  row.bind(5, f.top_m);
  row.bind(6, name_of(f.style));
  row.bind(7, std::int64_t{f.floors});
  row.bind(8, std::int64_t{f.bays});
  row.bind(9, std::int64_t{f.repeats});
  row.bind(10, std::int64_t{f.door_bay});
  row.bind(11, std::int64_t{f.has_shop});
  row.bind(12, f.texture);
  row.bind_blob(13, bytes_from_openings(f.openings));
}

void read_record(const Statement& row, Facade& f) {
  const auto line = line_at(row, 0);
  if (line.size() != 2 || line[0] == line[1]) row.database().throw_damaged("a facade that is no straight line");
  f.a = line[0];
  f.b = line[1];
  f.sector_id = row.text(1);
  f.building_id = row.text(2);
  f.bottom_m = row.real(3);
  f.top_m = row.real(4);
  f.style = kind_at<FacadeStyle>(row, 5);
  f.floors = small_number_at(row, 6, 1, kMostFloors);
  f.bays = small_number_at(row, 7, 1, kMostBays);
  f.repeats = small_number_at(row, 8, 1, kMostRepeats);
  f.door_bay = small_number_at(row, 9, -1, f.bays - 1);
  f.has_shop = row.integer(10) != 0;
  f.texture = row.text(11);
  f.openings = openings_from(row, 12);
  if (!(f.bottom_m < f.top_m)) row.database().throw_damaged("a facade without height");
}

PlanBox box_of_record(const Building& b) { return box_of(b.footprint.outer); }
PlanBox box_of_record(const Facade& facade) {
  PlanBox box;
  box.add(facade.a);
  box.add(facade.b);
  return box;
}

}  // namespace vicus
