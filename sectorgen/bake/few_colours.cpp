#include "sectorgen/bake/few_colours.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <unordered_map>

namespace vicus {
namespace {

constexpr int kRounds = 6;        // of moving each colour to the middle of what it stands for
constexpr unsigned kBinBits = 6;  // of a channel, where there are many colours
constexpr std::size_t kMany = 1024;

/// Colours that lie close together, as one.
struct Bin {
  std::array<std::int64_t, 3> sum{};
  std::int64_t count = 0;
  std::size_t in = 0;  ///< which of the palette stands for it
  std::array<std::int32_t, 3> mean{};
};

std::uint32_t packed(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]};
}
std::uint32_t coarse(std::uint32_t rgb) {
  constexpr std::uint32_t kMask = 0xff & ~((1u << (8 - kBinBits)) - 1);
  return rgb & (kMask << 16 | kMask << 8 | kMask);
}

class Quantiser {
 public:
  Quantiser(const RgbImage& image, bool is_coarse) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      const std::uint32_t rgb = packed(&image.rgb[i]), key = is_coarse ? coarse(rgb) : rgb;
      const auto [at, is_new] = places_.try_emplace(key, bins_.size());
      if (is_new) bins_.emplace_back();
      Bin& bin = bins_[at->second];
      for (std::size_t k = 0; k < 3; ++k) bin.sum[k] += image.rgb[i + k];
      ++bin.count;
      of_pixel_.push_back(static_cast<std::uint32_t>(at->second));
    }
    for (Bin& bin : bins_)
      for (std::size_t k = 0; k < 3; ++k)
        bin.mean[k] = static_cast<std::int32_t>((bin.sum[k] + bin.count / 2) / bin.count);
  }
  std::size_t distinct() const { return bins_.size(); }

  IndexedPicture picture(std::size_t colours) {
    split(std::min(colours, bins_.size()));
    for (int round = 0; round < kRounds && move(); ++round) {
    }
    return sorted();
  }

 private:
  using Mean = std::array<std::int32_t, 3>;

  /// Halves the box with the largest squared error along its widest axis, at its mean, until there are enough.
  /// Source  Wan, Wong & Prusinkiewicz, "An algorithm for multidimensional data clustering", ACM TOMS 14(2), 1988.
  void split(std::size_t colours) {
    std::vector<std::vector<std::uint32_t>> boxes(1);
    for (std::uint32_t i = 0; i < bins_.size(); ++i) boxes[0].push_back(i);
    std::vector<Spread> spreads{spread_of(boxes[0])};
    while (boxes.size() < colours) {
      std::size_t worst = 0;
      for (std::size_t b = 1; b < boxes.size(); ++b)
        if (spreads[b].error > spreads[worst].error) worst = b;
      if (spreads[worst].error <= 0) break;
      const auto [axis, mean, error] = spreads[worst];
      std::vector<std::uint32_t> low, high;
      for (const std::uint32_t i : boxes[worst]) (bins_[i].mean[axis] <= mean ? low : high).push_back(i);
      boxes[worst] = std::move(low);
      spreads[worst] = spread_of(boxes[worst]);
      spreads.push_back(spread_of(high));
      boxes.push_back(std::move(high));
    }
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      for (const std::uint32_t i : boxes[b]) bins_[i].in = b;
      palette_.push_back({});
    }
    set_means();
  }

  struct Spread {
    std::size_t axis = 0;
    std::int32_t mean = 0;
    double error = 0;
  };
  Spread spread_of(const std::vector<std::uint32_t>& box) const {
    std::array<std::int64_t, 3> sum{}, squares{};
    std::int64_t count = 0;
    for (const std::uint32_t i : box) {
      count += bins_[i].count;
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += bins_[i].count * bins_[i].mean[k];
        squares[k] += bins_[i].count * bins_[i].mean[k] * bins_[i].mean[k];
      }
    }
    Spread out;
    double widest = -1;
    for (std::size_t k = 0; k < 3 && count > 0; ++k) {
      const double error = static_cast<double>(squares[k]) -
                           static_cast<double>(sum[k]) * static_cast<double>(sum[k]) / static_cast<double>(count);
      out.error += std::max(0.0, error);
      if (error > widest) widest = error, out.axis = k, out.mean = static_cast<std::int32_t>(sum[k] / count);
    }
    if (box.size() < 2) out.error = 0;
    return out;
  }

  void set_means() {
    std::vector<Bin> sums(palette_.size());
    for (const Bin& bin : bins_) {
      for (std::size_t k = 0; k < 3; ++k) sums[bin.in].sum[k] += bin.sum[k];
      sums[bin.in].count += bin.count;
    }
    for (std::size_t c = 0; c < sums.size(); ++c)
      for (std::size_t k = 0; k < 3 && sums[c].count > 0; ++k)
        palette_[c][k] = static_cast<std::int32_t>((sums[c].sum[k] + sums[c].count / 2) / sums[c].count);
  }

  /// Each bin to the nearest colour; false: all stay.
  bool move() {
    bool has_moved = false;
    for (Bin& bin : bins_) {
      std::int32_t least = std::numeric_limits<std::int32_t>::max();
      std::size_t best = bin.in;
      for (std::size_t c = 0; c < palette_.size(); ++c) {
        const std::int32_t r = bin.mean[0] - palette_[c][0], g = bin.mean[1] - palette_[c][1],
                           b = bin.mean[2] - palette_[c][2], off = r * r + g * g + b * b;
        if (off < least) least = off, best = c;
      }
      has_moved = has_moved || best != bin.in;
      bin.in = best;
    }
    set_means();
    return has_moved;
  }

  /// Dark to light: numbers of alike colours are near each other.
  IndexedPicture sorted() const {
    std::vector<std::pair<std::int32_t, std::size_t>> order;
    for (std::size_t c = 0; c < palette_.size(); ++c)
      order.emplace_back(2 * palette_[c][0] + 5 * palette_[c][1] + palette_[c][2], c);
    std::sort(order.begin(), order.end());
    IndexedPicture out;
    std::vector<char> place(palette_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Mean& c = palette_[order[i].second];
      place[order[i].second] = static_cast<char>(i);
      out.palette.push_back(
          {static_cast<std::uint8_t>(c[0]), static_cast<std::uint8_t>(c[1]), static_cast<std::uint8_t>(c[2])});
    }
    for (const std::uint32_t bin : of_pixel_) out.pixels.push_back(place[bins_[bin].in]);
    return out;
  }

  std::unordered_map<std::uint32_t, std::size_t> places_;
  std::vector<Bin> bins_;
  std::vector<std::uint32_t> of_pixel_;
  std::vector<Mean> palette_;
};

}  // namespace

IndexedPicture with_few_colours(const RgbImage& image, int colours) {
  assert(!image.rgb.empty() && colours >= 2 && colours <= 256);
  Quantiser exact(image, false);
  if (exact.distinct() <= kMany) return exact.picture(static_cast<std::size_t>(colours));
  return Quantiser(image, true).picture(static_cast<std::size_t>(colours));
}

RgbImage rgb_of(const IndexedPicture& picture, std::uint32_t width, std::uint32_t height) {
  assert(picture.pixels.size() == std::size_t{width} * height);
  RgbImage out(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    out.set(i % width, i / width, picture.palette[static_cast<std::uint8_t>(picture.pixels[i])]);
  return out;
}

}  // namespace vicus
