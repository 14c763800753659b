#include "sectorgen/visibility/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vicus {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStepCells = 2;      // a grid's radius is four cells or more: no roof that counts is stepped over
constexpr double kStepShare = 0.006;  // far away steps grow with the width of a bin
constexpr double kPastTile_m = 1e-3;
constexpr double kAskTiles_m = 16;    // where a roof may rise: so far on, the tiles are asked again
constexpr float kNoRise = -1e3F;      // of where no roof is: lower than any line falls that counts
constexpr double kRounding = 1e-6;    // of a rise, of a metre: against doing sums in floats
constexpr double kAngleDoubt = 1e-5;  // rad, of angle_of: bins are a thousand times as wide

/// Of (x, y), as std::atan2 within 2e-6.   Source  least squares, reweighted until the errors were level (Lawson).
double angle_of(double y, double x) {
  const double across = std::abs(x), along = std::abs(y), most = std::max(across, along);
  if (most == 0) return 0;
  const double t = std::min(across, along) / most, s = t * t;
  double angle =
      t * (0.99997722 + s * (-0.33262282 + s * (0.19354030 + s * (-0.11642630 + s * (0.05264714 + s * -0.01171905)))));
  if (along > across) angle = kTurn / 4 - angle;
  if (x < 0) angle = kTurn / 2 - angle;
  return y < 0 ? -angle : angle;
}

/// No less than asin(u), 0 <= u <= 1: the series' terms beyond u are at most u^3 each, and pi/2 - 1 in all at 1.
double most_arcsine(double u) { return u + (kTurn / 4 - 1) * u * u * u; }

double distance_to_segment(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return length_of(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

}  // namespace

void Horizon::start(Spot centre, double radius, double eye_m, std::uint32_t bins) {
  centre_ = centre;
  eye_m_ = eye_m;
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

/// The greatest rise of a line from an eye to something at the distances given.
double Horizon::rise_of(double top_m, double nearest, double farthest) const {
  const double height = top_m - eye_m_;
  return height >= 0 ? height / nearest : height / farthest;
}

bool Horizon::hides_disc(Spot centre, double radius, double top_m) {
  const double dx = centre.x - centre_.x, dy = centre.y - centre_.y, distance = length_of(dx, dy);
  const double nearest = distance - radius;
  if (nearest <= radius_) return false;
  const double angle = angle_of(dy, dx), half = most_arcsine(radius / distance);
  return hides_bins(angle - half, angle + half, nearest, rise_of(top_m, nearest, distance + radius));
}

bool Horizon::hides_segment(Spot a, Spot b, double top_m) {
  const double nearest = distance_to_segment(centre_, a, b);
  if (nearest <= radius_) return false;
  const double farthest =
      std::max(length_of(a.x - centre_.x, a.y - centre_.y), length_of(b.x - centre_.x, b.y - centre_.y));
  const double rise = rise_of(top_m, nearest, farthest);
  const double first = angle_of(a.y - centre_.y, a.x - centre_.x);
  double sweep = angle_of(b.y - centre_.y, b.x - centre_.x) - first;
  if (std::abs(sweep) > kTurn / 2) sweep -= std::copysign(kTurn, sweep);
  return sweep < 0 ? hides_bins(first + sweep, first, nearest, rise) : hides_bins(first, first + sweep, nearest, rise);
}

bool Horizon::hides_bins(double first_angle, double last_angle, double distance, double rise) {
  const auto bins = static_cast<std::int64_t>(bins_.size());
  const double per_bin = kTurn / static_cast<double>(bins);
  const auto first = static_cast<std::int64_t>(std::floor((first_angle - kAngleDoubt) / per_bin));
  const auto last = static_cast<std::int64_t>(std::floor((last_angle + kAngleDoubt) / per_bin));
  const auto least_distance = static_cast<float>(distance * (1 - kRounding));
  const auto most_rise = static_cast<float>(rise + (std::abs(rise) + 1) * kRounding);
  auto bin = static_cast<std::uint32_t>((first % bins + bins) % bins);
  for (std::int64_t i = first; i <= last; ++i) {
    if (!hides(bin, least_distance, most_rise)) return false;
    if (++bin == bins_.size()) bin = 0;
  }
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
  const auto place = [&](double at) { return Spot{centre_.x + at * direction.x, centre_.y + at * direction.y}; };
  const double field_end = field_.end_of(centre_, direction), widening = half_width_ * (1 + kRounding);
  float best = bin.steps > 0 ? bin.step[bin.steps - 1].rise : kNoRise;
  double at = bin.followed, tile_end = at;
  const WornGrid* grid = nullptr;
  while (at < static_cast<double>(distance) && best < rise) {
    if (const double radius = radius_ + at * widening; grid == nullptr || radius > grid->radius_m)
      grid = field_.grid_for(radius);
    const double roofs_end = best > 0 ? (field_.ceiling() - eye_m_) / double{best} : HUGE_VAL;  // the line is above all
    if (grid == nullptr || at >= field_end || at >= roofs_end) {
      bin.is_ended = true;
      break;
    }
    if (at >= tile_end) {
      // A line that rises gets no lower on the way; one that falls is at its lowest where the question ends.
      const double way =
          field_.clear_way(place(at), direction, eye_m_ + double{best} * (best >= 0 ? at : double{distance}));
      if (way > 0) {
        at += way + kPastTile_m;
        continue;
      }
      tile_end = at + kAskTiles_m;
    }
    const double stop = std::min(
        {static_cast<double>(distance), field_end, roofs_end, tile_end, (grid->radius_m - radius_) / widening});
    const double step = kStepCells * grid->cell_m;
    double top_m = 0, here_at = at;
    do {  // to the next roof above the line
      here_at = at;
      top_m = field_.sure_height(*grid, place(at));
      at += std::max(step, kStepShare * at);
    } while (top_m <= eye_m_ + double{best} * here_at && at < stop);
    const double rise_here = (top_m - eye_m_) / here_at;
    const auto here = static_cast<float>(rise_here - std::abs(rise_here) * kRounding);
    if (here > best && here > kNoRise / 2) {
      best = here;
      tile_end = here_at;
      if (bin.steps == bin.step.size()) --bin.steps;  // the last one gives way: less is known between the two
      bin.step[bin.steps++] = {static_cast<float>(here_at * (1 + kRounding)), here};
    }
  }
  bin.followed = static_cast<float>(at);
}

}  // namespace vicus
