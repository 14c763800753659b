#include "sectorgen/geo/box_pairs.hpp"

#include <algorithm>
#include <numeric>

namespace vicus {

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::vector<std::uint32_t> order_by_min_x(const std::vector<PlanBox>& boxes) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].is_empty()) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(boxes[i].min.x, i) < std::pair(boxes[j].min.x, j);
  });
  return order;
}

/// Boxes met by the sweep that reach as far as where it is now.
class Active {
 public:
  Active(const std::vector<PlanBox>& boxes, std::int32_t margin) : boxes_(boxes), margin_(margin) {}

  void add(std::uint32_t i) { open_.push_back({boxes_[i].max.x, boxes_[i].min.y, boxes_[i].max.y, i}); }

  template <typename Visit>
  void visit(const PlanBox& box, Visit found) {
    std::size_t kept = 0;
    for (const Open& open : open_) {
      if (std::int64_t{open.max_x} + margin_ < box.min.x) continue;
      if (std::int64_t{open.min_y} - margin_ <= box.max.y && std::int64_t{open.max_y} + margin_ >= box.min.y)
        found(open.index);
      open_[kept++] = open;
    }
    open_.resize(kept);
  }

 private:
  struct Open {
    std::int32_t max_x, min_y, max_y;
    std::uint32_t index;
  };
  const std::vector<PlanBox>& boxes_;
  std::int32_t margin_;
  std::vector<Open> open_;
};

}  // namespace

Pairs box_pairs(const std::vector<PlanBox>& boxes, std::int32_t margin_mm) {
  Pairs pairs;
  Active active(boxes, margin_mm);
  for (std::uint32_t i : order_by_min_x(boxes)) {
    active.visit(boxes[i], [&](std::uint32_t j) { pairs.emplace_back(std::min(i, j), std::max(i, j)); });
    active.add(i);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& p, const auto& q) { return std::pair(p.second, p.first) < std::pair(q.second, q.first); });
  return pairs;
}

Pairs box_pairs(const std::vector<PlanBox>& a, const std::vector<PlanBox>& b) {
  Pairs pairs;
  Active active_a(a, 0), active_b(b, 0);
  const auto order_a = order_by_min_x(a), order_b = order_by_min_x(b);
  for (std::size_t i = 0, j = 0; i < order_a.size() || j < order_b.size();) {
    const bool is_a = j == order_b.size() || (i < order_a.size() && a[order_a[i]].min.x <= b[order_b[j]].min.x);
    if (is_a) {
      const std::uint32_t index = order_a[i++];
      active_b.visit(a[index], [&](std::uint32_t other) { pairs.emplace_back(index, other); });
      active_a.add(index);
    } else {
      const std::uint32_t index = order_b[j++];
      active_a.visit(b[index], [&](std::uint32_t other) { pairs.emplace_back(other, index); });
      active_b.add(index);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace vicus
