#include "sectorgen/models/window_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vicus {
namespace {

constexpr double kLagStep = 0.25;        // pixels
constexpr double kLeastContrast = 0.01;  // standard deviation of the sums, of 1 for white
constexpr double kAlmost = 0.85;         // a shorter lag nearly as good is the repeat, the longer one a multiple

double brightness(Paint p) { return 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b; }

/// Likeness of the signal and itself moved by `lag` pixels, which need not be whole: windows seldom are.
double likeness(const std::vector<double>& signal, double lag) {
  const auto whole = static_cast<std::size_t>(lag);
  const double part = lag - static_cast<double>(whole);
  const std::size_t n = signal.size() - whole - 1;
  const auto moved = [&](std::size_t i) { return (1 - part) * signal[i + whole] + part * signal[i + whole + 1]; };
  double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < n; ++i) ma += signal[i], mb += moved(i);
  ma /= static_cast<double>(n);
  mb /= static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = signal[i] - ma, b = moved(i) - mb;
    ab += a * b, aa += a * a, bb += b * b;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

/// The repeat in pixels, and the likeness there.
std::optional<std::pair<double, double>> find_lag(const std::vector<double>& signal, double length_m, double least_m,
                                                  double most_m, double sure) {
  const auto n = static_cast<double>(signal.size());
  double mean = 0, spread = 0;
  for (const double v : signal) mean += v / n;
  for (const double v : signal) spread += (v - mean) * (v - mean) / n;
  if (std::sqrt(spread) < kLeastContrast) return std::nullopt;
  // At least two repeats: one is no evidence.
  const double first = std::max(2.0, least_m / length_m * n), last = std::min(most_m / length_m * n, n / 2);
  std::vector<std::pair<double, double>> peaks;  // likeness, lag
  for (double lag = first; lag <= last; lag += kLagStep) {
    const double here = likeness(signal, lag);
    if (here >= likeness(signal, lag - kLagStep) && here >= likeness(signal, lag + kLagStep))
      peaks.emplace_back(here, lag);
  }
  if (peaks.empty()) return std::nullopt;
  const double best = std::max_element(peaks.begin(), peaks.end())->first;
  if (best < sure) return std::nullopt;
  const auto peak = std::find_if(peaks.begin(), peaks.end(), [&](const auto& p) { return p.first >= kAlmost * best; });
  return std::pair(peak->second, peak->first);
}

}  // namespace

std::optional<Repeats> find_bays(const Canvas& facade) {
  std::vector<double> columns(static_cast<std::size_t>(facade.width()));
  for (int x = 0; x < facade.width(); ++x)
    for (int y = 0; y < facade.height(); ++y)
      columns[static_cast<std::size_t>(x)] += brightness(facade.at(x, y)) / facade.height();
  const auto found = find_lag(columns, facade.width_m(), 1.4, 6, kSureOfBays);
  if (!found) return std::nullopt;
  return Repeats{static_cast<int>(std::lround(facade.width() / found->first)), found->second};
}

std::optional<Repeats> find_floors(const Canvas& facade) {
  std::vector<double> rows(static_cast<std::size_t>(facade.height()));
  for (int y = 0; y < facade.height(); ++y)
    for (int x = 0; x < facade.width(); ++x)
      rows[static_cast<std::size_t>(y)] += brightness(facade.at(x, y)) / facade.width();
  const auto found = find_lag(rows, facade.height_m(), 2.4, 5, kSureOfFloors);
  if (!found) return std::nullopt;
  // The ground floor and the cornice are higher than a storey, together by less than one.
  return Repeats{static_cast<int>(facade.height() / found->first + 0.2), found->second};
}

}  // namespace vicus
