#include "city_db/store_records.hpp"

#include <bit>
#include <cassert>
#include <cmath>

#include "city_db/boxes.hpp"
#include "city_db/geometry_blob.hpp"
#include "city_db/json_text.hpp"
#include "city_db/store_fields.hpp"

namespace vicus {
namespace {

std::size_t point_count(const Polygon& polygon) {
  std::size_t n = polygon.outer.size();
  for (const auto& hole : polygon.holes) n += hole.size();
  return n;
}

constexpr std::size_t kTriangleBytes = 12;  // three u32

std::string bytes_from_triangles(const Triangles& triangles, [[maybe_unused]] const Polygon& polygon) {
  assert(triangles.size() % 3 == 0);
  std::string bytes;
  bytes.reserve(4 * triangles.size());
  for (const std::uint32_t index : triangles) {
    assert(index < point_count(polygon));
    append_le(bytes, index);
  }
  return bytes;
}

Triangles triangles_from(const Statement& row, int column, const Polygon& polygon) {
  const auto bytes = row.bytes(column);
  if (bytes.size() % kTriangleBytes != 0) row.database().throw_damaged("triangles of odd length");
  const std::size_t points = point_count(polygon);
  Triangles triangles(bytes.size() / 4);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    triangles[i] = le_at<std::uint32_t>(bytes, 4 * i);
    if (triangles[i] >= points) row.database().throw_damaged("a triangle with a corner the polygon does not have");
  }
  return triangles;
}

std::int32_t lattice_at(const Statement& row, int i) {
  const double m = row.real(i);
  if (!(std::abs(m) < metres(kPlanLimit))) row.database().throw_damaged("a coordinate outside the lattice");
  return lattice_mm(m);
}

IssueCode issue_code_at(const Statement& row, int i) {
  const auto number = row.integer(i);
  const auto code = static_cast<IssueCode>(number);
  if (number < 100 || number > 999 || name_of(code)[0] == '?')
    row.database().throw_damaged("unknown issue code " + std::to_string(number));
  return code;
}

}  // namespace

void bind_record(Statement& row, const Sector& s) {
  row.bind_blob(1, encode_polygon(s.ground));
  row.bind(2, s.id);
  row.bind(3, name_of(s.kind));
  row.bind(4, s.name);
  row.bind(5, json_from_names(s.names));
  row.bind(6, static_cast<std::int64_t>(s.bytes));
  row.bind(7, metres(s.origin.x));
  row.bind(8, metres(s.origin.y));
  row.bind_blob(9, bytes_from_triangles(s.ground_triangles, s.ground));
  row.bind(10, name_of(s.importance));
  row.bind(11, s.vicinity_m);
}

void read_record(const Statement& row, Sector& s) {
  s.ground = polygon_at(row, 0);
  s.id = row.text(1);
  s.kind = kind_at<SectorKind>(row, 2);
  s.name = row.text(3);
  s.names = require(row, names_from_json(row.bytes(4)), "names are no JSON array");
  s.bytes = static_cast<std::uint64_t>(row.integer(5));
  s.origin = {lattice_at(row, 6), lattice_at(row, 7)};
  s.ground_triangles = triangles_from(row, 8, s.ground);
  s.importance = kind_at<Importance>(row, 9);
  s.vicinity_m = row.real(10);
  if (s.vicinity_m < 0) row.database().throw_damaged("a vicinity below 0");
}

void bind_record(Statement& row, const Interior& i) {
  row.bind_blob(1, encode_polygon(i.sector.ground));
  row.bind(2, i.sector.id);
  row.bind(3, i.building_id);
  row.bind(4, i.source_id);
  row.bind(5, i.sector.name);
  row.bind(6, static_cast<std::int64_t>(i.sector.bytes));
  row.bind(7, metres(i.sector.origin.x));
  row.bind(8, metres(i.sector.origin.y));
  row.bind_blob(9, bytes_from_triangles(i.sector.ground_triangles, i.sector.ground));
  row.bind(10, i.floor_m);
  row.bind(11, i.height_m);
}

void read_record(const Statement& row, Interior& i) {
  i.sector.kind = SectorKind::interior;
  i.sector.ground = polygon_at(row, 0);
  i.sector.id = row.text(1);
  i.building_id = row.text(2);
  i.source_id = row.text(3);
  i.sector.name = row.text(4);
  i.sector.bytes = static_cast<std::uint64_t>(row.integer(5));
  i.sector.origin = {lattice_at(row, 6), lattice_at(row, 7)};
  i.sector.ground_triangles = triangles_from(row, 8, i.sector.ground);
  i.floor_m = row.real(9);
  i.height_m = row.real(10);
  if (!(i.height_m > 0)) row.database().throw_damaged("an interior without height");
}

void bind_record(Statement& row, const Door& d) {
  row.bind_blob(1, encode_line({d.a, d.b}));
  row.bind(2, d.id);
  row.bind(3, d.twin_id);
  row.bind(4, d.sector_id);
  row.bind(5, d.to_sector_id);
  row.bind(6, d.building_id);
  row.bind(7, d.sill_m);
  row.bind(8, d.height_m);
  row.bind(9, d.recess_m);
}

void read_record(const Statement& row, Door& d) {
  const auto line = require(row, decode_line(row.bytes(0)), "a geometry is no line on the lattice");
  if (line.size() != 2 || line[0] == line[1]) row.database().throw_damaged("a door that is no line of two points");
  d.a = line[0];
  d.b = line[1];
  d.id = row.text(1);
  d.twin_id = row.text(2);
  d.sector_id = row.text(3);
  d.to_sector_id = row.text(4);
  d.building_id = row.text(5);
  d.sill_m = row.real(6);
  d.height_m = row.real(7);
  d.recess_m = row.real(8);
}

void bind_record(Statement& row, const Gate& g) {
  row.bind_blob(1, encode_line(g.line));
  row.bind(2, g.id);
  row.bind(3, g.sector_id);
  row.bind_or_null(4, g.to_sector_id);
  row.bind_or_null(5, g.twin_id);
  row.bind(6, name_of(g.kind));
}

void read_record(const Statement& row, Gate& g) {
  g.line = line_at(row, 0);
  g.id = row.text(1);
  g.sector_id = row.text(2);
  g.to_sector_id = row.text(3);
  g.twin_id = row.text(4);
  g.kind = kind_at<GateKind>(row, 5);
}

void bind_record(Statement& row, const Border& b) {
  row.bind_blob(1, encode_line(b.line));
  row.bind(2, b.sector_id);
  row.bind_or_null(3, b.building_id);
  row.bind(4, name_of(b.kind));
  row.bind(5, b.height_m);
}

void read_record(const Statement& row, Border& b) {
  b.line = line_at(row, 0);
  b.sector_id = row.text(1);
  b.building_id = row.text(2);
  b.kind = kind_at<BorderKind>(row, 3);
  b.height_m = row.real(4);
}

void bind_record(Statement& row, const Obstacle& o) {
  row.bind_blob(1, encode_polygon(o.area));
  row.bind(2, name_of(o.kind));
  row.bind(3, o.source_id);
  row.bind(4, o.height_m);
}

void read_record(const Statement& row, Obstacle& o) {
  o.area = polygon_at(row, 0);
  o.kind = kind_at<ObstacleKind>(row, 1);
  o.source_id = row.text(2);
  o.height_m = row.real(3);
}

void bind_record(Statement& row, const Polygon& domain) { row.bind_blob(1, encode_polygon(domain)); }
void read_record(const Statement& row, Polygon& domain) { domain = polygon_at(row, 0); }

void bind_record(Statement& row, const Street& s) {
  row.bind_blob(1, encode_line(s.line));
  row.bind(2, s.source_id);
  row.bind(3, s.name);
  row.bind(4, s.kind);
  row.bind(5, s.width_m);
  row.bind(6, std::int64_t{s.is_passage});
  row.bind(7, std::int64_t{s.is_bridge});
  row.bind(8, std::int64_t{s.is_steps});
}

void read_record(const Statement& row, Street& s) {
  s.line = line_at(row, 0);
  s.source_id = row.text(1);
  s.name = row.text(2);
  s.kind = row.text(3);
  s.width_m = row.real(4);
  s.is_passage = row.integer(5) != 0;
  s.is_bridge = row.integer(6) != 0;
  s.is_steps = row.integer(7) != 0;
}

void bind_record(Statement& row, const Visible& v) {
  row.bind(1, v.sector_id);
  row.bind(2, v.visible_sector_id);
  row.bind(3, name_of(v.reason));
  row.bind(4, std::int64_t{v.is_proven});
  row.bind(5, json_from_names(v.building_ids));
}

void read_record(const Statement& row, Visible& v) {
  v.sector_id = row.text(0);
  v.visible_sector_id = row.text(1);
  v.reason = kind_at<VisibleReason>(row, 2);
  v.is_proven = row.integer(3) != 0;
  v.building_ids = require(row, names_from_json(row.bytes(4)), "building ids are no JSON array");
}

void bind_record(Statement& row, const Terrain& t) {
  assert(t.height_mm.size() == std::size_t{t.columns} * t.rows);
  std::string heights;
  heights.reserve(4 * t.height_mm.size());
  for (const std::int32_t mm : t.height_mm) append_le(heights, static_cast<std::uint32_t>(mm));
  row.bind(1, metres(t.corner.x));
  row.bind(2, metres(t.corner.y));
  row.bind(3, metres(t.step_mm));
  row.bind(4, std::int64_t{t.columns});
  row.bind(5, std::int64_t{t.rows});
  row.bind_blob(6, heights);
}

void read_record(const Statement& row, Terrain& t) {
  t.corner = {lattice_at(row, 0), lattice_at(row, 1)};
  t.step_mm = lattice_at(row, 2);
  const std::int64_t columns = row.integer(3), rows = row.integer(4);
  // No side can have more nodes than the lattice has millimetres; with that, the products below cannot overflow.
  for (const auto& [nodes, corner_mm] : {std::pair(columns, t.corner.x), {rows, t.corner.y}})
    if (t.step_mm < 1 || nodes < 1 || nodes > kPlanLimit || corner_mm + (nodes - 1) * t.step_mm >= kPlanLimit)
      row.database().throw_damaged("a terrain that does not fit the lattice");
  const auto bytes = row.bytes(5);
  if (static_cast<std::int64_t>(bytes.size()) != 4 * columns * rows)
    row.database().throw_damaged("a terrain with other than columns x rows heights");
  t.columns = static_cast<std::uint32_t>(columns);
  t.rows = static_cast<std::uint32_t>(rows);
  t.height_mm.resize(bytes.size() / 4);
  for (std::size_t i = 0; i < t.height_mm.size(); ++i)
    t.height_mm[i] = std::bit_cast<std::int32_t>(le_at<std::uint32_t>(bytes, 4 * i));
}

void bind_record(Statement& row, const Issue& i) {
  row.bind_blob(1, encode_point(i.at));
  row.bind(2, static_cast<std::int64_t>(i.code));
  row.bind(3, name_of(i.code));
  row.bind(4, i.message);
  row.bind(5, i.source_id);
}

void read_record(const Statement& row, Issue& i) {
  i.at = point_at(row, 0);
  i.code = issue_code_at(row, 1);
  i.message = row.text(3);
  i.source_id = row.text(4);
}

void bind_record(Statement& row, const Artefact& a) {
  row.bind(1, a.path);
  row.bind(2, a.media_type);
  row.bind(3, a.coding);
  row.bind(4, a.hash);
  row.bind_blob(5, a.body);
}

void read_record(const Statement& row, Artefact& a) {
  a.path = row.text(0);
  a.media_type = row.text(1);
  a.coding = row.text(2);
  a.hash = row.text(3);
  a.body = row.text(4);
}

PlanBox box_of_record(const Sector& s) { return box_of(s.ground.outer); }
PlanBox box_of_record(const Interior& i) { return box_of(i.sector.ground.outer); }
PlanBox box_of_record(const Door& d) { return box_of({d.a, d.b}); }
PlanBox box_of_record(const Gate& g) { return box_of(g.line); }
PlanBox box_of_record(const Border& b) { return box_of(b.line); }
PlanBox box_of_record(const Obstacle& o) { return box_of(o.area.outer); }
PlanBox box_of_record(const Polygon& domain) { return box_of(domain.outer); }
PlanBox box_of_record(const Street& s) { return box_of(s.line); }
PlanBox box_of_record(const StandaloneObject& o) { return box_of({o.at}); }
PlanBox box_of_record(const Viewpoint& v) { return box_of({v.at}); }
PlanBox box_of_record(const Issue& i) { return box_of({i.at}); }

}  // namespace vicus
