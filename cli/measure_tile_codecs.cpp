#include "cli/measure_tile_codecs.hpp"

#include <algorithm>
#include <functional>

#include "city_db/surroundings.hpp"
#include "cli/measure_tile_forms.hpp"
#include "cli/measure_tile_tracer.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "sectorgen/models/palette_png.hpp"
#include "x3d_export/coding.hpp"

namespace vicus::measure {
namespace {

constexpr std::uint32_t kCells = 128;
constexpr double kTau_px = 4;
constexpr int kBrotli = 9;

/// What a codec makes of a picture: how many bytes, and what a reader sees.
struct Coded {
  std::size_t bytes = 0;
  RgbImage image;
};
using Codec = std::function<Coded(const RgbImage&)>;

Coded webp(const RgbImage& image, int quality) {
  const std::string bytes = encode_webp(image, quality);
  return {bytes.size(), decode_webp(bytes, image.width, image.height).value()};
}

Coded palette(const RgbImage& image, int colours) {
  std::vector<std::uint8_t> rgba;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    rgba.insert(rgba.end(), {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2], 255});
  const std::string bytes = palette_png(rgba, static_cast<int>(image.width), static_cast<int>(image.height), colours);
  const CutOut back = read_png(bytes);
  Coded out{bytes.size(), RgbImage(image.width, image.height)};
  for (std::size_t i = 0; i < back.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out.image.rgb[3 * i + k] = static_cast<std::uint8_t>(std::lround(255 * back.pixels[i][k]));
  return out;
}

class TileCodecs {
 public:
  TileCodecs(SharedCity& city, const RunOptions& options) : city_(city), options_(options) {}

  void add_view(const Pose& pose) {
    const PictureSize& size = options_.sizes.front();
    FlownView view{camera_at(pose.eye, pose.look, kFieldOfView, size.width, size.height), {}, {}};
    const int levels = levels_of(city_.city());
    BlockMapOptions baking;
    baking.side = kCells;
    for (const std::string& part :
         blockmap_tiles(city_, kCells, kTau_px)->choose(pose, pixels_per_radian(size.height), {})) {
      const TileAddress at = parse_tile(part, levels).value();
      view.tiles.push_back(
          bake_unpacked(city_.bake_scene(), tile_corner(levels, at), tile_side_mm(levels, at.z), baking));
    }
    double ignored = 0;
    view.truth = look(
        view,
        [](const RgbImage& image) {
          return Coded{0, image};
        },
        ignored);
    views_.push_back(std::move(view));
  }

  CodecRow run(const char* name, const std::string& setting, const Codec& codec) const {
    CodecRow row{"colours of tiles", name, setting, 0, 0, static_cast<int>(views_.size())};
    for (const FlownView& view : views_) row.flip += flip_mean(view.truth, look(view, codec, row.bytes));
    row.flip /= static_cast<double>(views_.size());
    row.bytes /= static_cast<double>(views_.size());
    return row;
  }

 private:
  struct FlownView {
    Camera camera;
    std::vector<BakedBlockMap> tiles;
    Picture truth;
  };

  Picture look(const FlownView& view, const Codec& codec, double& bytes) const {
    std::vector<std::shared_ptr<const CastTile>> casts;
    for (const BakedBlockMap& tile : view.tiles) {
      BlockMap map = tile.map;
      bytes += static_cast<double>(brotli(encode_blockmap(map), kBrotli).size());
      TilePictures pictures = tile.pictures;
      for (RgbImage* image : {&pictures.roof, &pictures.ground, &pictures.ambient, &pictures.wall}) {
        if (image->rgb.empty()) continue;
        Coded coded = codec(*image);
        bytes += static_cast<double>(coded.bytes);
        *image = std::move(coded.image);
      }
      casts.push_back(cast_tile(std::move(map), std::move(pictures)));
    }
    RenderMesh sheet;
    city_.add_sheet(sheet);
    const PictureSize& size = options_.sizes.front();
    return render(TileTracer(std::move(casts), std::move(sheet)), view.camera,
                  {size.width, size.height, options_.samples, 0.05, options_.threads})
        .colour;
  }

  SharedCity& city_;
  const RunOptions& options_;
  std::vector<FlownView> views_;
};

}  // namespace

std::vector<CodecRow> compare_tile_codecs(SharedCity& city, const std::vector<Pose>& poses, const RunOptions& options) {
  TileCodecs codecs(city, options);
  for (const Pose& pose : poses) codecs.add_view(pose);
  std::vector<CodecRow> rows;
  for (const int quality : {5, 20, 40, 60, 80, 95, kLossless})
    rows.push_back(codecs.run("WebP", quality == kLossless ? "lossless" : "quality " + std::to_string(quality),
                              [quality](const RgbImage& image) { return webp(image, quality); }));
  for (const int colours : {4, 8, 16, 32, 64, 128, 256})
    rows.push_back(codecs.run("PNG, palette", std::to_string(colours) + " colours",
                              [colours](const RgbImage& image) { return palette(image, colours); }));
  return rows;
}

}  // namespace vicus::measure
