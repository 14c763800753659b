#include "sectorgen/models/palette_png.hpp"

#include <libdeflate.h>
#include <libimagequant.h>

#include <cassert>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "city_db/issues.hpp"
#include "city_db/steady_hash.hpp"

namespace vicus {
namespace {

using Bytes = std::vector<unsigned char>;

struct Indexed {
  int width = 0, height = 0;
  Bytes palette;  // r, g, b
  Bytes opacity;  // one byte each colour, without those at the end that are opaque
  Bytes pixels;   // one byte each
  int colours() const { return static_cast<int>(palette.size() / 3); }
};

template <class T, void (*Destroy)(T*)>
struct Destroyer {
  void operator()(T* handle) const { Destroy(handle); }
};
template <class T, void (*Destroy)(T*)>
using Handle = std::unique_ptr<T, Destroyer<T, Destroy>>;

Indexed quantised(std::span<const unsigned char> rgba, int width, int height, int colours) {
  const auto check = [](bool is_fine) {
    if (!is_fine) throw CityError("an image could not be given a palette: out of memory");
  };
  const Handle<liq_attr, liq_attr_destroy> attributes(liq_attr_create());
  check(attributes != nullptr);
  liq_set_max_colors(attributes.get(), colours);
  liq_set_speed(attributes.get(), 8);
  const Handle<liq_image, liq_image_destroy> image(
      liq_image_create_rgba(attributes.get(), rgba.data(), width, height, 0));
  check(image != nullptr);
  liq_result* raw = nullptr;
  check(liq_image_quantize(image.get(), attributes.get(), &raw) == LIQ_OK);
  const Handle<liq_result, liq_result_destroy> result(raw);
  liq_set_dithering_level(result.get(), 0);  // noise costs bytes and shows less than steps at this size
  Indexed out{width, height, {}, {}, Bytes(rgba.size() / 4)};
  check(liq_write_remapped_image(result.get(), image.get(), out.pixels.data(), out.pixels.size()) == LIQ_OK);
  const liq_palette* palette = liq_get_palette(result.get());
  for (unsigned i = 0; i < palette->count; ++i) {
    out.palette.insert(out.palette.end(), {palette->entries[i].r, palette->entries[i].g, palette->entries[i].b});
    out.opacity.push_back(palette->entries[i].a);
  }
  while (!out.opacity.empty() && out.opacity.back() == 255) out.opacity.pop_back();
  return out;
}

void append_number(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<unsigned char>(value >> shift));
}

void append_chunk(Bytes& out, std::string_view type, const Bytes& data) {
  append_number(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  append_number(out, libdeflate_crc32(0, out.data() + begin, out.size() - begin));
}

/// Rows of packed pixels, each after its filter byte: none, the best for palettes.
Bytes packed_rows(const Indexed& image, int bits) {
  Bytes rows;
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    rows.push_back(0);
    int filled = 0;
    unsigned byte = 0;
    for (std::size_t x = 0; x < width; ++x) {
      byte = (byte << bits) | image.pixels[y * width + x];
      filled += bits;
      if (filled < 8) continue;
      rows.push_back(static_cast<unsigned char>(byte));
      byte = 0;
      filled = 0;
    }
    if (filled > 0) rows.push_back(static_cast<unsigned char>(byte << (8 - filled)));
  }
  return rows;
}

Bytes deflated(const Bytes& data) {
  thread_local const Handle<libdeflate_compressor, libdeflate_free_compressor> compressor(
      libdeflate_alloc_compressor(10));
  if (!compressor) throw CityError("an image could not be packed: out of memory");
  Bytes out(libdeflate_zlib_compress_bound(compressor.get(), data.size()));
  out.resize(libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), out.data(), out.size()));
  return out;
}

constexpr unsigned char kGrey = 0, kPalette = 3;  // PNG's colour types

/// Signature and header: deflate, not interlaced.
Bytes begun_png(int width, int height, int bits, unsigned char colour_type) {
  Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
  append_number(header, static_cast<std::uint32_t>(width));
  append_number(header, static_cast<std::uint32_t>(height));
  header.insert(header.end(), {static_cast<unsigned char>(bits), colour_type, 0, 0, 0});
  append_chunk(out, "IHDR", header);
  return out;
}

Texture texture_of(int width, int height, std::string png) {
  char id[17];
  std::snprintf(id, sizeof id, "%016llx", static_cast<unsigned long long>(steady_hash(png)));
  return {id, width, height, std::move(png)};
}

}  // namespace

std::string palette_png(const Canvas& picture, int colours) {
  return palette_png(picture.rgba(), picture.width(), picture.height(), colours);
}

std::string palette_png(std::span<const unsigned char> rgba, int width, int height, int colours) {
  assert(colours >= 2 && colours <= 256);
  assert(rgba.size() == 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const Indexed image = quantised(rgba, width, height, colours);
  const int count = image.colours(), bits = count <= 2 ? 1 : count <= 4 ? 2 : count <= 16 ? 4 : 8;
  Bytes out = begun_png(width, height, bits, kPalette);
  append_chunk(out, "PLTE", image.palette);
  if (!image.opacity.empty()) append_chunk(out, "tRNS", image.opacity);
  append_chunk(out, "IDAT", deflated(packed_rows(image, bits)));
  append_chunk(out, "IEND", {});
  return std::string(out.begin(), out.end());
}

Texture palette_texture(const Canvas& picture, int colours) {
  return texture_of(picture.width(), picture.height(), palette_png(picture, colours));
}

Texture grey_texture(std::span<const unsigned char> grey, int width, int height) {
  assert(grey.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Bytes out = begun_png(width, height, 8, kGrey);
  append_chunk(out, "IDAT", deflated(packed_rows({width, height, {}, {}, Bytes(grey.begin(), grey.end())}, 8)));
  append_chunk(out, "IEND", {});
  return texture_of(width, height, std::string(out.begin(), out.end()));
}

}  // namespace vicus
