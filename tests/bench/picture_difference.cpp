/// How far two pictures are apart: picture_difference A.png B.png [SKY_A.png DEPTH_B.pfm]
///
/// Prints FLIP (mean, 99th percentile), PSNR, SSIM. With SKY_A, picture A with its sky in pure magenta, and the depths
/// of picture B: also the silhouettes' intersection over union and the skyline's distance.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/bake/picture/similarity.hpp"

namespace {

std::string bytes_of(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

vicus::Coverage without_magenta(const vicus::CutOut& picture) {
  vicus::Coverage out(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const auto& p = picture.pixels[i];
    if (p[0] > 0.9f && p[1] < 0.1f && p[2] > 0.9f) out.pixels[i] = 0;
  }
  return out;
}

/// As pfm_text writes it.
vicus::Coverage not_sky(const std::string& pfm, int width, int height) {
  vicus::Coverage out(width, height);
  const char* at = pfm.data() + pfm.size() - 4 * out.pixels.size();
  for (int row = height - 1; row >= 0; --row)
    for (int column = 0; column < width; ++column, at += 4) {
      float depth = 0;
      std::memcpy(&depth, at, 4);
      out.at(column, row) = depth < std::numeric_limits<float>::infinity() ? 1 : 0;
    }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vicus;
  if (argc != 3 && argc != 5)
    return std::fprintf(stderr, "usage: picture_difference A.png B.png [SKY_A.png DEPTH_B.pfm]\n"), 2;
  const Picture a = colours_of(read_png(bytes_of(argv[1]))), b = colours_of(read_png(bytes_of(argv[2])));
  if (a.width != b.width || a.height != b.height) return std::fprintf(stderr, "pictures of different sizes\n"), 2;
  const auto flip = summary_of(flip_map(a, b).pixels);
  std::printf("flip %.4f p99 %.4f psnr %.2f dB ssim %.4f", flip.mean, flip.p99, psnr_db(a, b), ssim(a, b));
  if (argc == 5) {
    const std::string pfm = bytes_of(argv[4]);
    if (pfm.size() < 4 * a.pixels.size()) return std::fprintf(stderr, "%s is too short\n", argv[4]), 2;
    const Coverage ca = without_magenta(read_png(bytes_of(argv[3]))), cb = not_sky(pfm, a.width, a.height);
    const auto skyline = skyline_distance(ca, cb);
    std::printf(" iou %.5f skyline %.3f px (max %.0f)", silhouette_iou(ca, cb), skyline.mean_px, skyline.max_px);
  }
  std::printf("\n");
}
