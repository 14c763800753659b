#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "city_db/colour.hpp"
#include "x3d_export/frames.hpp"

namespace vicus {

inline std::uint64_t hash_of(std::uint64_t seed, std::uint64_t bits) {
  const std::uint64_t mixed = (seed ^ bits) * 0x9E3779B97F4A7C15u;
  return mixed ^ mixed >> 32;
}
inline std::uint64_t hash_of(const X3dPoint& p) {
  const auto low = static_cast<std::uint32_t>(p.x), high = static_cast<std::uint32_t>(p.z);
  return hash_of(hash_of(0, std::uint64_t{high} << 32 | low), static_cast<std::uint32_t>(p.y));
}
inline std::uint64_t hash_of(const Colour& c) {
  return hash_of(0, std::uint64_t{c.r} << 16 | std::uint64_t{c.g} << 8 | c.b);
}
inline std::uint64_t hash_of(const std::array<double, 2>& place) {
  // + 0.0: the two zeros are equal.
  return hash_of(hash_of(0, std::bit_cast<std::uint64_t>(place[0] + 0.0)),
                 std::bit_cast<std::uint64_t>(place[1] + 0.0));
}
template <class A, class B>
std::uint64_t hash_of(const std::pair<A, B>& pair) {
  return hash_of(hash_of(pair.first), hash_of(pair.second));
}

/// Numbers things in the order in which they first come. Open addressing, no memory of its own for each item: near
/// files have a hundred million corners in a large city.
template <class T>
class Numbering {
 public:
  std::int32_t operator()(const T& item) {
    if (2 * items_.size() >= slots_.size()) grow();
    std::int32_t& slot = slots_[place_of(item)];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(items_.size());
      items_.push_back(item);
    }
    return slot;
  }
  const std::vector<T>& items() const { return items_; }

 private:
  /// Of the item, or of the empty slot where it belongs.
  std::size_t place_of(const T& item) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash_of(item) & mask;
    while (slots_[at] >= 0 && !(items_[static_cast<std::size_t>(slots_[at])] == item)) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), -1);
    for (std::size_t i = 0; i < items_.size(); ++i) slots_[place_of(items_[i])] = static_cast<std::int32_t>(i);
  }

  std::vector<T> items_;
  std::vector<std::int32_t> slots_;  // number of the item, -1: empty; a power of two
};

}  // namespace vicus
