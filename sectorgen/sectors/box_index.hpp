#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "city_db/units.hpp"

/// Boxes found again by box: a uniform grid whose cell fits the boxes' mean size.
namespace vicus {

class BoxIndex {
 public:
  BoxIndex() = default;
  explicit BoxIndex(std::vector<PlanBox> boxes) : boxes_(std::move(boxes)) {
    double sum = 0;
    for (const auto& b : boxes_) {
      sum += std::max(double(b.max.x) - b.min.x, double(b.max.y) - b.min.y);
      all_.add(b.min);
      all_.add(b.max);
    }
    if (boxes_.empty()) return;
    const double extent = std::max(double(all_.max.x) - all_.min.x, double(all_.max.y) - all_.min.y) + 1;
    // At least the mean box, at most 2048 cells a side.
    cell_ = std::max({1.0, sum / static_cast<double>(boxes_.size()), extent / 2048});
    columns_ = column(all_.max.x) + 1;
    rows_ = row(all_.max.y) + 1;
    std::vector<std::uint32_t> count(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    each([&](std::size_t c, std::uint32_t) { ++count[c + 1]; });
    for (std::size_t c = 1; c < count.size(); ++c) count[c] += count[c - 1];
    begin_ = count;
    items_.resize(begin_.back());
    each([&](std::size_t c, std::uint32_t i) { items_[count[c]++] = i; });
  }

  /// Indices of the boxes that meet `box`, ascending.
  std::vector<std::uint32_t> meeting(const PlanBox& box) const {
    std::vector<std::uint32_t> out;
    if (boxes_.empty() || box.is_empty()) return out;
    const int x0 = clamp(column(box.min.x), columns_), x1 = clamp(column(box.max.x), columns_);
    const int y0 = clamp(row(box.min.y), rows_), y1 = clamp(row(box.max.y), rows_);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const auto c = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
        for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
          const PlanBox& b = boxes_[items_[k]];
          if (b.min.x <= box.max.x && b.max.x >= box.min.x && b.min.y <= box.max.y && b.max.y >= box.min.y)
            out.push_back(items_[k]);
        }
      }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

 private:
  int column(std::int32_t x) const { return static_cast<int>((double(x) - all_.min.x) / cell_); }
  int row(std::int32_t y) const { return static_cast<int>((double(y) - all_.min.y) / cell_); }
  static int clamp(int v, int n) { return v < 0 ? 0 : v >= n ? n - 1 : v; }
  template <class Visit>
  void each(Visit visit) const {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      for (int y = row(boxes_[i].min.y); y <= row(boxes_[i].max.y); ++y)
        for (int x = column(boxes_[i].min.x); x <= column(boxes_[i].max.x); ++x)
          visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x), i);
  }

  std::vector<PlanBox> boxes_;
  PlanBox all_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_, items_;
};

}  // namespace vicus
