#include <cmath>

#include "city_db/panorama_sides.hpp"
#include "city_db/store_fields.hpp"
#include "city_db/store_records.hpp"

/// Rows of pictures that stand for what has not come.
namespace vicus {
namespace {

std::uint32_t pixels_at(const Statement& row, int column) {
  constexpr std::int64_t kMost_px = 1 << 14;
  const auto side = row.integer(column);
  if (side < 1 || side > kMost_px)
    row.database().throw_damaged("a picture with a side of " + std::to_string(side) + " px");
  return static_cast<std::uint32_t>(side);
}

}  // namespace

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
  i.width_px = pixels_at(row, 13);
  i.height_px = pixels_at(row, 14);
}

PlanBox box_of_record(const GateImpostor& i) {
  PlanBox box;
  box.add(i.left);
  box.add(i.right);
  return box;
}

void bind_record(Statement& row, const Panorama& p) {
  row.bind_blob(1, encode_point(p.eye));
  row.bind(2, p.sector_id);
  row.bind(3, p.eye_up_m);
  row.bind(4, p.radius_m);
  row.bind(5, p.bottom_m);
  row.bind(6, p.top_m);
  row.bind(7, p.near_m);
  row.bind(8, p.far_m);
  row.bind(9, std::int64_t{p.sides});
  row.bind(10, std::int64_t{p.width_px});
  row.bind(11, std::int64_t{p.height_px});
}

void read_record(const Statement& row, Panorama& p) {
  p.eye = point_at(row, 0);
  p.sector_id = row.text(1);
  p.eye_up_m = row.real(2);
  p.radius_m = row.real(3);
  p.bottom_m = row.real(4);
  p.top_m = row.real(5);
  p.near_m = row.real(6);
  p.far_m = row.real(7);
  const auto sides = row.integer(8);
  if (sides < 1 || sides >= std::int64_t{1} << kPanoramaSides)
    row.database().throw_damaged("a panorama without sides, or with more than there are");
  p.sides = static_cast<std::uint32_t>(sides);
  p.width_px = pixels_at(row, 9);
  p.height_px = pixels_at(row, 10);
  const bool has_size = p.radius_m > 0 && p.radius_m <= kMostPanoramaRadius_m && p.top_m > p.bottom_m;
  if (!has_size || !std::isfinite(p.top_m - p.bottom_m)) row.database().throw_damaged("a panorama of no size");
}

PlanBox box_of_record(const Panorama& p) {
  PlanBox box;
  box.add(p.eye);
  return box;
}

}  // namespace vicus
