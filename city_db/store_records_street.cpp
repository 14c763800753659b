#include "city_db/mesh_blob.hpp"
#include "city_db/store_fields.hpp"
#include "city_db/store_records.hpp"

/// Rows of what stands and lies in the street.
namespace vicus {

void bind_record(Statement& row, const StandaloneObject& o) {
  row.bind_blob(1, encode_point(o.at));
  row.bind(2, o.id);
  row.bind(3, o.sector_id);
  row.bind(4, o.kind);
  row.bind(5, o.name);
  row.bind(6, o.ground_m);
  row.bind(7, o.height_m);
  row.bind(8, o.heading_deg);
  row.bind(9, o.url);
  row.bind(10, json_from_tags(o.tags));
}

void read_record(const Statement& row, StandaloneObject& o) {
  o.at = point_at(row, 0);
  o.id = row.text(1);
  o.sector_id = row.text(2);
  o.kind = row.text(3);
  o.name = row.text(4);
  o.ground_m = row.real(5);
  o.height_m = row.real(6);
  o.heading_deg = row.real(7);
  o.url = row.text(8);
  o.tags = tags_at(row, 9);
}

void bind_record(Statement& row, const Surface& s) {
  row.bind(1, s.sector_id);
  row.bind(2, name_of(s.kind));
  row.bind_blob(3, encode_mesh(s.points, s.triangles));
}

void read_record(const Statement& row, Surface& s) {
  s.sector_id = row.text(0);
  s.kind = kind_at<SurfaceKind>(row, 1);
  auto mesh = require(row, decode_mesh(row.bytes(2)), "bytes that are no mesh");
  s.points = std::move(mesh.points);
  s.triangles = std::move(mesh.triangles);
}

void bind_record(Statement& row, const Ride& r) {
  row.bind(1, r.sector_id);
  row.bind(2, r.kind);
  row.bind(3, r.cycle_s);
  row.bind_blob(4, encode_ride(r.points));
}

void read_record(const Statement& row, Ride& r) {
  r.sector_id = row.text(0);
  r.kind = row.text(1);
  r.cycle_s = row.real(2);
  r.points = require(row, decode_ride(row.bytes(3)), "bytes that are no ride");
  if (!(r.points.back().time_s <= r.cycle_s)) row.database().throw_damaged("a ride that outlasts its cycle");
}

void bind_record(Statement& row, const Prototype& p) {
  row.bind(1, p.kind);
  row.bind_blob(2, encode_mesh(p.points, p.triangles, p.colours));
}

void read_record(const Statement& row, Prototype& p) {
  p.kind = row.text(0);
  auto mesh = require(row, decode_mesh(row.bytes(1)), "bytes that are no mesh");
  p.points = std::move(mesh.points);
  p.triangles = std::move(mesh.triangles);
  p.colours = std::move(mesh.colours);
  if (3 * p.colours.size() != p.triangles.size()) row.database().throw_damaged("a model without colours");
}

void bind_record(Statement& row, const Viewpoint& v) {
  row.bind_blob(1, encode_point(v.at));
  row.bind(2, v.id);
  row.bind(3, v.sector_id);
  row.bind(4, v.kind);
  row.bind(5, v.name);
  row.bind(6, v.ground_m);
  row.bind(7, v.eye_m);
  row.bind(8, v.heading_deg);
}

void read_record(const Statement& row, Viewpoint& v) {
  v.at = point_at(row, 0);
  v.id = row.text(1);
  v.sector_id = row.text(2);
  v.kind = row.text(3);
  v.name = row.text(4);
  v.ground_m = row.real(5);
  v.eye_m = row.real(6);
  v.heading_deg = row.real(7);
}

void bind_record(Statement& row, const GateImpostor& i) {
  row.bind_blob(1, encode_line({i.left, i.right}));
  row.bind(2, i.gate_id);
  row.bind(3, i.sector_id);
  row.bind(4, metres(i.eye.x));
  row.bind(5, metres(i.eye.y));
  row.bind(6, i.eye_up_m);
  row.bind(7, i.bottom_m);
  row.bind(8, i.top_m);
  row.bind(9, i.near_m);
  row.bind(10, i.far_m);
  row.bind(11, i.plane_m);
  row.bind(12, i.radius_m);
  row.bind(13, std::int64_t{i.is_solid});
  row.bind(14, std::int64_t{i.width_px});
  row.bind(15, std::int64_t{i.height_px});
}

void read_record(const Statement& row, GateImpostor& i) {
  const auto line = require(row, decode_line(row.bytes(0)), "a geometry is no line on the lattice");
  if (line.size() != 2) row.database().throw_damaged("an impostor that is no rectangle");
  i.left = line[0];
  i.right = line[1];
  i.gate_id = row.text(1);
  i.sector_id = row.text(2);
  i.eye = {lattice_mm(row.real(3)), lattice_mm(row.real(4))};
  i.eye_up_m = row.real(5);
  i.bottom_m = row.real(6);
  i.top_m = row.real(7);
  i.near_m = row.real(8);
  i.far_m = row.real(9);
  i.plane_m = row.real(10);
  i.radius_m = row.real(11);
  i.is_solid = row.integer(12) != 0;
  const auto width = row.integer(13), height = row.integer(14);
  constexpr std::int64_t kMost_px = 1 << 14;
  if (width < 1 || width > kMost_px || height < 1 || height > kMost_px)
    row.database().throw_damaged("an impostor of " + std::to_string(width) + " x " + std::to_string(height) + " px");
  i.width_px = static_cast<std::uint32_t>(width);
  i.height_px = static_cast<std::uint32_t>(height);
}

PlanBox box_of_record(const GateImpostor& i) {
  PlanBox box;
  box.add(i.left);
  box.add(i.right);
  return box;
}

}  // namespace vicus
