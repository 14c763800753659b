#pragma once
#include "city_db/terrain.hpp"
#include "cli/measure_pose.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/render/render.hpp"

/// How far a picture is from the truth, by every measure of docs/speed-against-error.md.
namespace vicus::measure {

struct ViewErrors {
  double depth_mean_px = 0, depth_p99_px = 0, depth_max_px = 0;  ///< picture/depth_error.hpp
  double silhouette_iou = 1, skyline_mean_px = 0, skyline_max_px = 0;
  double psnr_db = 0;  ///< of the crop, 99 at most
  double ssim = 1, flip = 0, flip_p99 = 0;
  double flip_houses = 0;  ///< mean over the pixels where the truth shows something that stands on the ground
};

/// 1 where the truth shows what stands more than kStanding_m above the ground.
PixelGrid<std::uint8_t> standing(const View& truth, const Camera& camera, const Terrain& terrain);
inline constexpr double kStanding_m = 1;

/// `flip`: of truth.colour.   Needs   equal sizes of at least 11 x 11 pixels (assert).
ViewErrors errors_of(const View& truth, const FlipReference& flip, const View& shown,
                     const PixelGrid<std::uint8_t>& standing);

/// The smallest rectangle that holds all that is not sky in either picture, 11 x 11 pixels at least.
struct Crop {
  int column = 0, row = 0, width = 0, height = 0;
};
Crop crop_of(const Coverage& a, const Coverage& b);

}  // namespace vicus::measure
