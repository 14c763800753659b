#include "sectorgen/bake/webp_image.hpp"

#include <webp/decode.h>
#include <webp/encode.h>

#include "city_db/issues.hpp"

namespace vicus {

std::string encode_webp(const RgbImage& image, int quality) {
  WebPConfig config;
  WebPPicture picture;
  bool good = WebPConfigInit(&config) != 0 && WebPPictureInit(&picture) != 0;
  config.method = 2;  // 43 % of the time of 4 for 1.7 % more bytes (pictures of 202 tiles)
  config.thread_level = 0;
  if (quality > 100) {
    config.lossless = 1;
    config.exact = 1;
  } else {
    config.quality = static_cast<float>(quality);
    config.use_sharp_yuv = 0;
  }
  picture.width = static_cast<int>(image.width);
  picture.height = static_cast<int>(image.height);
  picture.use_argb = config.lossless;
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  good = good && WebPPictureImportRGB(&picture, image.rgb.data(), 3 * static_cast<int>(image.width)) != 0 &&
         WebPEncode(&config, &picture) != 0;
  std::string out(reinterpret_cast<const char*>(writer.mem), good ? writer.size : 0);
  const int fault = picture.error_code;
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&writer);
  if (!good)
    throw CityError("cannot code a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                    " as WebP: fault " + std::to_string(fault));
  return out;
}

std::optional<RgbImage> decode_webp(std::string_view bytes, std::uint32_t width, std::uint32_t height) {
  int w = 0, h = 0;
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  if (WebPGetInfo(data, bytes.size(), &w, &h) == 0 || w != static_cast<int>(width) || h != static_cast<int>(height))
    return std::nullopt;
  RgbImage image(width, height);
  if (WebPDecodeRGBInto(data, bytes.size(), image.rgb.data(), image.rgb.size(), 3 * w) == nullptr) return std::nullopt;
  return image;
}

}  // namespace vicus
