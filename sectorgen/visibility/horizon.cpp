#include "sectorgen/visibility/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vicus {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStepCells = 2;      // a grid's radius is four cells or more: no roof that counts is stepped over
constexpr double kStepShare = 0.006;  // far away steps grow with the width of a bin
constexpr double kRounding = 1e-6;    // of a rise, of a metre: against doing sums in floats

double distance_to_segment(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

}  // namespace

void Horizon::start(Spot centre, double radius, std::uint32_t bins) {
  centre_ = centre;
  radius_ = radius;
  half_width_ = kTurn / 2 / bins;
  if (bins_.size() != bins) {
    bins_.assign(bins, {});
    stamp_ = 0;
    directions_.clear();
    for (std::uint32_t i = 0; i < bins; ++i)
      directions_.push_back({std::cos((i + 0.5) * kTurn / bins), std::sin((i + 0.5) * kTurn / bins)});
  }
  ++stamp_;
}

bool Horizon::hides_disc(Spot centre, double radius, double top_m) {
  const double dx = centre.x - centre_.x, dy = centre.y - centre_.y, distance = std::hypot(dx, dy);
  const double nearest = distance - radius;
  if (nearest <= radius_) return false;
  const double angle = std::atan2(dy, dx), half = std::asin(radius / distance);
  return hides_bins(angle - half, angle + half, nearest, (top_m - kEyeTop_m) / nearest);
}

bool Horizon::hides_segment(Spot a, Spot b, double top_m) {
  const double nearest = distance_to_segment(centre_, a, b);
  if (nearest <= radius_) return false;
  const double first = std::atan2(a.y - centre_.y, a.x - centre_.x);
  double sweep = std::remainder(std::atan2(b.y - centre_.y, b.x - centre_.x) - first, kTurn);
  return sweep < 0 ? hides_bins(first + sweep, first, nearest, (top_m - kEyeTop_m) / nearest)
                   : hides_bins(first, first + sweep, nearest, (top_m - kEyeTop_m) / nearest);
}

bool Horizon::hides_bins(double first_angle, double last_angle, double distance, double rise) {
  const auto bins = static_cast<std::int64_t>(bins_.size());
  const double per_bin = kTurn / static_cast<double>(bins);
  const auto first = static_cast<std::int64_t>(std::floor((first_angle - kRounding) / per_bin));
  const auto last = static_cast<std::int64_t>(std::floor((last_angle + kRounding) / per_bin));
  const auto least_distance = static_cast<float>(distance * (1 - kRounding));
  const auto most_rise = static_cast<float>(rise * (1 + kRounding) + kRounding);
  for (std::int64_t i = first; i <= last; ++i)
    if (!hides(static_cast<std::uint32_t>(((i % bins) + bins) % bins), least_distance, most_rise)) return false;
  return true;
}

bool Horizon::hides(std::uint32_t bin_index, float distance, float rise) {
  Bin& bin = bins_[bin_index];
  if (bin.stamp != stamp_) {
    bin.stamp = stamp_;
    bin.steps = 0;
    bin.followed = static_cast<float>(radius_);
    bin.is_ended = false;
  }
  const auto known = [&] {
    for (std::uint32_t i = bin.steps; i-- > 0;)
      if (bin.step[i].distance < distance) return bin.step[i].rise >= rise;
    return false;
  };
  if (known()) return true;
  if (bin.is_ended || bin.followed >= distance) return false;
  follow(bin_index, bin, distance, rise);
  return known();
}

/// Goes on until a roof rises as asked, the distance is reached or the field ends.
void Horizon::follow(std::uint32_t bin_index, Bin& bin, float distance, float rise) {
  const Spot direction = directions_[bin_index];
  float best = bin.steps > 0 ? bin.step[bin.steps - 1].rise : 0;
  double at = bin.followed;
  const WornGrid* grid = nullptr;
  while (at < static_cast<double>(distance) && best < rise) {
    const Spot x{centre_.x + at * direction.x, centre_.y + at * direction.y};
    const double radius = radius_ + at * half_width_ * (1 + kRounding);
    if (grid == nullptr || radius > grid->radius_m) grid = field_.grid_for(radius);
    if (grid == nullptr || field_.is_left_for_good(x, direction)) {
      bin.is_ended = true;
      break;
    }
    const auto here = static_cast<float>((field_.sure_height(*grid, x) - kEyeTop_m) / at * (1 - kRounding));
    if (here > best) {
      best = here;
      if (bin.steps == bin.step.size()) --bin.steps;  // the last one gives way: less is known between the two
      bin.step[bin.steps++] = {static_cast<float>(at * (1 + kRounding)), here};
    }
    at += std::max(kStepCells * grid->cell_m, kStepShare * at);
  }
  bin.followed = static_cast<float>(at);
}

}  // namespace vicus
