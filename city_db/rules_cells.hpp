#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "city_db/units.hpp"

/// A uniform grid of the plan, sparse: which numbered things may lie in which cell.
namespace vicus::rules {

class CellIndex {
 public:
  explicit CellIndex(std::int64_t cell_mm) : cell_mm_(cell_mm) {}

  /// Enters the thing in every cell the closed segment meets, and perhaps in some beside it: the column range of a
  /// row is widened by 1 mm, far above the rounding of its doubles (< 1e-6 mm).
  void add_segment(std::uint32_t id, PlanPoint a, PlanPoint b) {
    visit_segment(a, b, [&](std::int32_t ix, std::int32_t iy) { entries_.push_back({key_of(ix, iy), id}); });
  }
  void add_box(std::uint32_t id, const PlanBox& box) {
    for (auto iy = cell_of(box.min.y); iy <= cell_of(box.max.y); ++iy)
      for (auto ix = cell_of(box.min.x); ix <= cell_of(box.max.x); ++ix) entries_.push_back({key_of(ix, iy), id});
  }
  /// Call once, after the last add and before the first look.
  void finish() {
    std::sort(entries_.begin(), entries_.end());
    ids_.reserve(entries_.size());
    for (const auto& [key, id] : entries_) {
      if (keys_.empty() || keys_.back() != key) {
        keys_.push_back(key);
        starts_.push_back(ids_.size());
      }
      ids_.push_back(id);
    }
    starts_.push_back(ids_.size());
    entries_ = {};
  }

  std::size_t cell_count() const { return keys_.size(); }
  std::span<const std::uint32_t> ids(std::size_t cell) const {
    return {ids_.data() + starts_[cell], ids_.data() + starts_[cell + 1]};
  }
  /// Empty span where nothing was entered.
  std::span<const std::uint32_t> ids_at(std::int32_t ix, std::int32_t iy) const {
    const std::size_t cell = first_cell_from(ix, iy);
    return cell < keys_.size() && keys_[cell] == key_of(ix, iy) ? ids(cell) : std::span<const std::uint32_t>{};
  }
  /// Cells are sorted by row, then column: the first one at or after (ix, iy).
  std::size_t first_cell_from(std::int32_t ix, std::int32_t iy) const {
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key_of(ix, iy)) - keys_.begin());
  }
  std::int32_t column(std::size_t cell) const {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(keys_[cell] & 0xffffffffu) - kBias);
  }
  std::int32_t row(std::size_t cell) const {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(keys_[cell] >> 32) - kBias);
  }
  std::int32_t cell_of(double mm) const {
    return static_cast<std::int32_t>(std::floor(mm / static_cast<double>(cell_mm_)));
  }
  std::int32_t cell_of(std::int32_t mm) const {
    const std::int64_t q = mm / cell_mm_;
    return static_cast<std::int32_t>(mm % cell_mm_ < 0 ? q - 1 : q);
  }
  std::int64_t cell_mm() const { return cell_mm_; }

  template <class Visit>
  void visit_segment(PlanPoint a, PlanPoint b, Visit visit) const {
    if (b.y < a.y) std::swap(a, b);
    const auto row0 = cell_of(a.y), row1 = cell_of(b.y);
    const double slope = a.y == b.y ? 0 : (double(b.x) - a.x) / (double(b.y) - a.y);
    for (auto iy = row0; iy <= row1; ++iy) {
      const double cell = static_cast<double>(cell_mm_);
      const double y0 = std::max(double(a.y), iy * cell), y1 = std::min(double(b.y), (iy + 1.0) * cell);
      double x0 = a.x, x1 = b.x;
      if (row0 != row1) x0 = a.x + (y0 - a.y) * slope, x1 = a.x + (y1 - a.y) * slope;
      const auto first = cell_of(std::min(x0, x1) - 1.0), last = cell_of(std::max(x0, x1) + 1.0);
      for (auto ix = first; ix <= last; ++ix) visit(ix, iy);
    }
  }

 private:
  static constexpr std::int64_t kBias = std::int64_t{1} << 31;
  static std::uint64_t key_of(std::int32_t ix, std::int32_t iy) {
    return static_cast<std::uint64_t>(iy + kBias) << 32 | static_cast<std::uint64_t>(ix + kBias);
  }
  std::int64_t cell_mm_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace vicus::rules
