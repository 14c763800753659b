#include "sectorgen/models/rectify.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

constexpr double kMostPixels = 1e8;

using Matrix = std::array<std::array<double, 3>, 3>;

/// The projective map of the unit square's corners (0,0), (1,0), (1,1), (0,1) onto four points.
/// Source  Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, §2.2.3.
Matrix map_of_square(const std::array<double, 8>& q) {
  const double sx = q[0] - q[2] + q[4] - q[6], sy = q[1] - q[3] + q[5] - q[7];
  const double dx1 = q[2] - q[4], dx2 = q[6] - q[4], dy1 = q[3] - q[5], dy2 = q[7] - q[5];
  const double det = dx1 * dy2 - dx2 * dy1;
  const double g = (sx * dy2 - dx2 * sy) / det, h = (dx1 * sy - sx * dy1) / det;
  return {{{q[2] - q[0] + g * q[2], q[6] - q[0] + h * q[6], q[0]},
           {q[3] - q[1] + g * q[3], q[7] - q[1] + h * q[7], q[1]},
           {g, h, 1}}};
}

Matrix inverse(const Matrix& m) {
  const auto minor_of = [&](std::size_t r, std::size_t c) {
    const std::size_t r0 = (r + 1) % 3, r1 = (r + 2) % 3, c0 = (c + 1) % 3, c1 = (c + 2) % 3;
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
  };
  const double det = m[0][0] * minor_of(0, 0) + m[0][1] * minor_of(0, 1) + m[0][2] * minor_of(0, 2);
  Matrix out;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) out[c][r] = minor_of(r, c) / det;
  return out;
}

}  // namespace

Canvas rectified(const std::filesystem::path& photo, const std::optional<std::array<double, 8>>& corners, int width,
                 int height, double width_m, double height_m) {
  using namespace OIIO;
  ImageBuf source(photo.string());
  if (!source.init_spec(photo.string(), 0, 0) || source.spec().width < 2 || source.spec().height < 2)
    throw CityError(photo.string() + ": expected a picture: " + source.geterror(), 4);
  const double w = source.spec().width, h = source.spec().height;
  if (w * h > kMostPixels) throw CityError(photo.string() + ": has more than 100 million pixels; make it smaller", 4);
  if (!source.read(0, 0, true, TypeDesc::FLOAT)) throw CityError(photo.string() + ": " + source.geterror(), 4);
  const std::array<double, 8> q = corners.value_or(std::array<double, 8>{0, h, w, h, w, 0, 0, 0});
  // Photo to unit square, then to pixels of the new picture, whose rows go down.
  const Matrix to_square = inverse(map_of_square(q));
  float place[3][3];  // of row vectors
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = to_square[0][c] * width, y = (to_square[2][c] - to_square[1][c]) * height, z = to_square[2][c];
    place[c][0] = static_cast<float>(x);
    place[c][1] = static_cast<float>(y);
    place[c][2] = static_cast<float>(z);
  }
  ImageBuf straight =
      ImageBufAlgo::warp(source, place, "lanczos3", 0, false, ImageBuf::WrapClamp, ROI(0, width, 0, height));
  if (straight.has_error()) throw CityError(photo.string() + ": cannot be drawn straight: " + straight.geterror(), 4);
  Canvas out(width, height, width_m, height_m);
  const int channels = straight.nchannels();
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto value = [&](int c) {
        return std::clamp(static_cast<double>(straight.getchannel(column, row, 0, channels >= 3 ? c : 0)), 0.0, 1.0);
      };
      out.set(column, row, {value(0), value(1), value(2)});
    }
  return out;
}

}  // namespace vicus
