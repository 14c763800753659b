#include "sectorgen/bake/picture/png.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

constexpr std::uint64_t kMostPixels = 1 << 26;

/// libpng's plain interface keeps memory in the handle until it is freed.
struct Handle {
  png_image image{};
  Handle() { image.version = PNG_IMAGE_VERSION; }
  ~Handle() { png_image_free(&image); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
};

std::uint8_t byte_of(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

}  // namespace

std::string png_text(const Picture& picture) {
  Handle handle;
  handle.image.width = static_cast<png_uint_32>(picture.width);
  handle.image.height = static_cast<png_uint_32>(picture.height);
  handle.image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * picture.pixels.size());
  for (const Rgb& pixel : picture.pixels)
    for (const float value : pixel) bytes.push_back(byte_of(value));
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(handle.image);
  std::string out(size, '\0');
  if (png_image_write_to_memory(&handle.image, out.data(), &size, 0, bytes.data(), 0, nullptr) == 0)
    throw CityError(std::string("the picture could not be packed: ") + handle.image.message);
  out.resize(size);
  return out;
}

CutOut read_png(const std::string& bytes) {
  Handle handle;
  if (png_image_begin_read_from_memory(&handle.image, bytes.data(), bytes.size()) == 0)
    throw CityError(std::string("expected a PNG picture: ") + handle.image.message);
  handle.image.format = PNG_FORMAT_RGBA;
  const std::uint64_t count = std::uint64_t{handle.image.width} * handle.image.height;
  if (count > kMostPixels) throw CityError("a PNG picture of " + std::to_string(count) + " pixels is too large");
  std::vector<std::uint8_t> rgba(4 * count);
  if (png_image_finish_read(&handle.image, nullptr, rgba.data(), 0, nullptr) == 0)
    throw CityError(std::string("a damaged PNG picture: ") + handle.image.message);
  CutOut picture(static_cast<int>(handle.image.width), static_cast<int>(handle.image.height));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) picture.pixels[i][k] = static_cast<float>(rgba[4 * i + k]) / 255;
  return picture;
}

}  // namespace vicus
