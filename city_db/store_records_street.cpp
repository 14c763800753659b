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

}  // namespace vicus
