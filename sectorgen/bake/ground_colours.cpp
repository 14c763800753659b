#include "sectorgen/bake/ground_colours.hpp"

#include <algorithm>
#include <array>

#include "city_db/boxes.hpp"
#include "city_db/surface_colour.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/raster_triangle.hpp"

namespace vicus {
namespace {

constexpr int kSamples = 2;        // a cell and direction
constexpr double kReach_m = 32;    // of ambient light
constexpr float kReflects = 0.5f;  // of the light that falls on walls: yards are not black
constexpr int kMostReach = 16;     // samples
constexpr int kSteps[] = {1, 2, 3, 4, 6, 8, 12, 16};
constexpr std::uint8_t kLeaves = 15;  // among kinds
constexpr int kLanes = 64;            // samples at a time: so many that the loops over them stay loops

struct Sum {
  ColourMean colour;
  double weight = 0;
};

/// Colours of kinds, by GroundColours::kind_.
const std::array<ColourMean, 16>& colours_of_kinds() {
  static const auto kColours = [] {
    std::array<ColourMean, 16> out{};
    for (std::size_t i = 0; i + 1 < out.size(); ++i) out[i + 1] = mean_of(surface_colour(static_cast<SurfaceKind>(i)));
    out[kLeaves] = mean_of(leaf_colour(TreeForm::round, 0));
    return out;
  }();
  return kColours;
}

/// The sum over count x count samples, from one row to the next `stride` apart.
Sum sum_of(const std::uint8_t* kinds, std::size_t count, std::size_t stride) {
  const auto& colours = colours_of_kinds();
  // Mostly they are all of one kind.
  const std::uint8_t first = kinds[0];
  bool is_one = true;
  for (std::size_t y = 0; y < count; ++y)
    is_one &= std::all_of(kinds + y * stride, kinds + y * stride + count, [&](std::uint8_t k) { return k == first; });
  const auto all = static_cast<double>(count * count);
  if (is_one) return first == 0 ? Sum{} : Sum{colours[first] * all, all};
  std::array<int, 16> times{};
  for (std::size_t y = 0; y < count; ++y)
    for (std::size_t x = 0; x < count; ++x) ++times[kinds[y * stride + x]];
  Sum sum;
  for (std::size_t kind = 1; kind < times.size(); ++kind)
    if (times[kind] > 0) {
      sum.colour = sum.colour + colours[kind] * times[kind];
      sum.weight += times[kind];
    }
  return sum;
}

/// Ambient light of kLanes samples in a row of a height field `width` samples wide.
std::array<std::uint8_t, kLanes> light_of_lanes(const float* up, int width, int reach, float spacing) {
  constexpr int kDirections[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  std::array<float, kLanes> sky{};
  for (const auto& d : kDirections) {
    const float unit = spacing * (d[0] != 0 && d[1] != 0 ? 1.41421356f : 1.0f);
    std::array<float, kLanes> tangent{};
    for (const int step : kSteps) {
      if (step > reach) break;
      const float* from = up + step * (d[1] * width + d[0]);
      const float per_metre = 1 / (unit * static_cast<float>(step));
      for (std::size_t k = 0; k < kLanes; ++k) {
        const float rise = (from[k] - up[k]) * per_metre;
        tangent[k] = tangent[k] < rise ? rise : tangent[k];
      }
    }
    for (std::size_t k = 0; k < kLanes; ++k) sky[k] += 1 / (1 + tangent[k] * tangent[k]);
  }
  std::array<std::uint8_t, kLanes> light{};
  for (std::size_t k = 0; k < kLanes; ++k) {
    const float seen = sky[k] / 8;
    light[k] = static_cast<std::uint8_t>(seen / (1 - kReflects * (1 - seen)) * 255 + 0.5f);
  }
  return light;
}

/// The colour at a square of half the size, between the four nearest of n x n.
ColourMean between(const std::vector<Sum>& larger, std::size_t n, std::size_t column, std::size_t row) {
  const auto near = [&](std::size_t at) { return at / 2; };
  const auto beside = [&](std::size_t at) {
    return at % 2 == 0 ? (at / 2 == 0 ? 0 : at / 2 - 1) : std::min(n - 1, at / 2 + 1);
  };
  const auto mean = [&](std::size_t x, std::size_t y) {
    const Sum& s = larger[y * n + x];
    return s.colour * (1 / s.weight);
  };
  constexpr double kNear = 0.75, kBeside = 0.25;
  return (mean(near(column), near(row)) * kNear + mean(beside(column), near(row)) * kBeside) * kNear +
         (mean(near(column), beside(row)) * kNear + mean(beside(column), beside(row)) * kBeside) * kBeside;
}

}  // namespace

GroundColours::GroundColours(const BakeScene& scene, const TileFrame& frame, bool has_leaves)
    : side_(frame.side), texel_m_(2 * frame.cell_m()) {
  const int n = static_cast<int>(frame.side) * kSamples;
  kind_.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0);
  const double scale = kSamples / frame.cell_m();
  for (const std::uint32_t i : scene.ground_in(frame.box())) {
    const BakeGround& g = scene.ground()[i];
    double x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      const PlanPoint p = g.at[static_cast<std::size_t>(k)];
      x[k] = (metres(p.x) - frame.west_m()) * scale;
      y[k] = (metres(p.y) - frame.south_m()) * scale;
    }
    const auto kind = static_cast<std::uint8_t>(static_cast<int>(g.kind) + 1);
    raster_triangle(x, y, n, n, [&](int column, int row) {
      kind_[static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(column)] = kind;
    });
  }
  if (has_leaves) add_leaves(scene, frame);
}

void GroundColours::add_leaves(const BakeScene& scene, const TileFrame& frame) {
  const int n = static_cast<int>(side_) * kSamples;
  const double scale = kSamples / frame.cell_m();
  for (const std::uint32_t i : scene.trees_in(frame.box())) {
    const BakeTree& tree = scene.trees()[i];
    const double x = (metres(tree.at.x) - frame.west_m()) * scale, y = (metres(tree.at.y) - frame.south_m()) * scale;
    const double r = tree.shape.crown_m * scale;
    const auto first = [](double from) { return std::max(0, static_cast<int>(std::ceil(from - 0.5))); };
    for (int row = first(y - r); row < n && row + 0.5 <= y + r; ++row)
      for (int column = first(x - r); column < n && column + 0.5 <= x + r; ++column)
        if (std::hypot(column + 0.5 - x, row + 0.5 - y) <= r)
          kind_[static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(column)] =
              kLeaves;
  }
}

ColourMean GroundColours::of_cell(std::size_t column, std::size_t row) const {
  const std::size_t stride = side_ * kSamples;
  const Sum sum = sum_of(&kind_[row * kSamples * stride + column * kSamples], kSamples, stride);
  return sum.weight > 0 ? sum.colour * (1 / sum.weight) : mean_of(kBeyondCity);
}

RgbImage GroundColours::filled(double reach_m, const RgbImage* larger) const {
  // Pull: sums of ever larger squares. Push: empty squares take the colour of the next larger one.
  // Kept from one tile to the next: memory that is given back and asked for again costs a tenth of the bake.
  thread_local std::array<std::vector<Sum>, 16> levels;
  std::size_t n = side_ / 2, top = 0;
  levels[0].resize(n * n);
  const std::size_t samples = 2 * kSamples, stride = side_ * kSamples;
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column)
      levels[0][row * n + column] = sum_of(&kind_[row * samples * stride + column * samples], samples, stride);
  for (double square_m = texel_m_; n > 1 && square_m < reach_m; n /= 2, square_m *= 2) {
    std::vector<Sum>& next = levels.at(top + 1);
    next.assign(n / 2 * (n / 2), {});
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < n; ++column) {
        Sum& s = next[row / 2 * (n / 2) + column / 2];
        const Sum& from = levels[top][row * n + column];
        s.colour = s.colour + from.colour;
        s.weight += from.weight;
      }
    ++top;
  }
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column) {
      Sum& s = levels[top][row * n + column];
      if (s.weight > 0) continue;
      const std::size_t margin = larger == nullptr ? 0 : (larger->width - n) / 2;
      s = {mean_of(larger == nullptr ? kBeyondCity : larger->at(margin + column, margin + n - 1 - row)), 1};
    }
  for (std::size_t level = top; level-- > 0;) {
    const std::size_t size = (side_ / 2) >> level;
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) {
        Sum& s = levels[level][row * size + column];
        if (s.weight == 0) s = {between(levels[level + 1], size / 2, column, row), 1};
      }
  }
  const auto half = static_cast<std::uint32_t>(side_ / 2);
  RgbImage image(half, half);
  for (std::size_t row = 0; row < half; ++row)
    for (std::size_t column = 0; column < half; ++column) {
      const Sum& s = levels[0][(half - 1 - row) * half + column];
      image.set(column, row, rounded(s.colour * (1 / s.weight)));
    }
  return image;
}

std::vector<std::uint8_t> ambient_light(const BakeScene& scene, const TileFrame& frame) {
  const double spacing = 2 * frame.cell_m();
  const int reach = std::clamp(static_cast<int>(kReach_m / spacing), 1, kMostReach);
  const int half = static_cast<int>(frame.side / 2), width = half + 2 * reach;
  const double west = frame.west_m() - reach * spacing, south = frame.south_m() - reach * spacing;
  // A row's last lanes may lie beyond it: they are thrown away, but must be there.
  std::vector<float> up(static_cast<std::size_t>(width) * static_cast<std::size_t>(width) + kLanes, 0.0f);
  if (!scene.terrain().height_mm.empty())
    for (int row = 0; row < width; ++row)
      for (int column = 0; column < width; ++column)
        up[static_cast<std::size_t>(row * width + column)] = static_cast<float>(height_m(
            scene.terrain(), {lattice_mm(west + (column + 0.5) * spacing), lattice_mm(south + (row + 0.5) * spacing)}));
  for (const std::uint32_t i : scene.houses_in(grown(frame.box(), lattice_mm(reach * spacing)))) {
    const BakeHouse& house = scene.houses()[i];
    for (const BakeTriangle& t : house.roof) {
      const UpPlane& plane = house.planes[t.plane];
      double x[3], y[3];
      for (int k = 0; k < 3; ++k) {
        x[k] = (t.x[k] - west) / spacing;
        y[k] = (t.y[k] - south) / spacing;
      }
      raster_triangle(x, y, width, width, [&](int column, int row) {
        up[static_cast<std::size_t>(row * width + column)] =
            static_cast<float>(plane.at(west + (column + 0.5) * spacing, south + (row + 0.5) * spacing));
      });
    }
  }
  std::vector<std::uint8_t> out(static_cast<std::size_t>(half) * static_cast<std::size_t>(half));
  for (int row = 0; row < half; ++row)
    for (int column = 0; column < half; column += kLanes) {
      const auto light = light_of_lanes(&up[static_cast<std::size_t>((row + reach) * width + column + reach)], width,
                                        reach, static_cast<float>(spacing));
      std::copy_n(light.begin(), std::min(kLanes, half - column), out.begin() + std::ptrdiff_t{row} * half + column);
    }
  return out;
}

}  // namespace vicus
