#include "cli/measure_errors.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sectorgen/bake/picture/depth_error.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/bake/picture/similarity.hpp"

namespace vicus::measure {
namespace {

constexpr int kLeastSide_px = 11;
constexpr double kMostPsnr_db = 99;  // equal pictures, and nearly equal ones

}  // namespace

PixelGrid<std::uint8_t> standing(const View& truth, const Camera& camera, const Terrain& terrain) {
  const int width = truth.depth.width, height = truth.depth.height;
  PixelGrid<std::uint8_t> out(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double t = double{truth.depth.at(column, row)};
      if (!std::isfinite(t)) continue;
      const double x = (column + 0.5) / width, y = (row + 0.5) / height;
      const Vec3 way = camera.ahead + camera.right * (camera.left_side + x * (camera.right_side - camera.left_side)) +
                       camera.above * (camera.top_side + y * (camera.bottom_side - camera.top_side));
      const Vec3 at = camera.eye + way * t;
      if (std::abs(at[0]) > 1e6 || std::abs(at[1]) > 1e6) continue;
      out.at(column, row) = at[2] - height_m(terrain, {lattice_mm(at[0]), lattice_mm(at[1])}) > kStanding_m;
    }
  return out;
}

Crop crop_of(const Coverage& a, const Coverage& b) {
  assert(a.width == b.width && a.height == b.height && a.width >= kLeastSide_px && a.height >= kLeastSide_px);
  int west = a.width, east = -1, top = a.height, bottom = -1;
  for (int row = 0; row < a.height; ++row)
    for (int column = 0; column < a.width; ++column)
      if (a.at(column, row) > 0 || b.at(column, row) > 0) {
        west = std::min(west, column), east = std::max(east, column);
        top = std::min(top, row), bottom = std::max(bottom, row);
      }
  if (east < 0) return {0, 0, a.width, a.height};
  Crop out{west, top, std::max(kLeastSide_px, east - west + 1), std::max(kLeastSide_px, bottom - top + 1)};
  out.column = std::min(out.column, a.width - out.width);
  out.row = std::min(out.row, a.height - out.height);
  return out;
}

ViewErrors errors_of(const View& truth, const FlipReference& flip_reference, const View& shown,
                     const PixelGrid<std::uint8_t>& standing) {
  ViewErrors out;
  const ErrorSummary depth = projected_depth_error_px(truth.depth, shown.depth);
  out.depth_mean_px = depth.mean, out.depth_p99_px = depth.p99, out.depth_max_px = depth.max;
  out.silhouette_iou = silhouette_iou(truth.coverage, shown.coverage);
  const SkylineDistance skyline = skyline_distance(truth.coverage, shown.coverage);
  out.skyline_mean_px = skyline.mean_px, out.skyline_max_px = skyline.max_px;
  const Crop c = crop_of(truth.coverage, shown.coverage);
  const Picture a = crop(truth.colour, c.column, c.row, c.width, c.height),
                b = crop(shown.colour, c.column, c.row, c.width, c.height);
  out.psnr_db = std::min(kMostPsnr_db, psnr_db(a, b));
  out.ssim = ssim(a, b);
  const auto map = flip_reference.map(shown.colour);
  const ErrorSummary flip = summary_of(map.pixels);
  out.flip = flip.mean, out.flip_p99 = flip.p99;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i)
    if (standing.pixels[i] != 0) sum += double{map.pixels[i]}, count += 1;
  out.flip_houses = count > 0 ? sum / count : 0;
  return out;
}

}  // namespace vicus::measure
