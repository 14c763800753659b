#include "sectorgen/geo/stitch_pieces.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/box_pairs.hpp"
#include "sectorgen/geo/repair.hpp"
#include "sectorgen/geo/shared_area.hpp"
#include "sectorgen/geo/tag_values.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {

namespace {

constexpr double kSharedM2 = 0.1;
constexpr double kInsideShare = 0.9;
constexpr const char* kTile = "tile";

/// Sets of footprints, each known by its smallest index.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t first_of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = first_of(i), b = first_of(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

bool have_equal_tags_elsewhere(const Footprint& a, const Footprint& b) {
  const std::string &tile_a = tag(a.tags, kTile), &tile_b = tag(b.tags, kTile);
  if (tile_a.empty() || tile_b.empty() || tile_a == tile_b || a.is_part != b.is_part) return false;
  return a.tags.size() == b.tags.size() &&
         std::equal(a.tags.begin(), a.tags.end(), b.tags.begin(), [](const auto& s, const auto& t) {
           return s.first == t.first && (s.first == kTile || s.second == t.second);
         });
}

bool are_pieces(const Footprint& a, bool is_a_cut, const Footprint& b, bool is_b_cut) {
  if (!have_equal_tags_elsewhere(a, b)) return false;
  const double shared = shared_area_m2(a.area, b.area);
  if (shared <= kSharedM2) return false;
  return (is_a_cut && is_b_cut) || shared >= kInsideShare * area_m2(is_a_cut ? a.area : b.area);
}

std::map<std::size_t, std::vector<std::size_t>> groups_of(const std::vector<Footprint>& footprints,
                                                          const std::vector<bool>& is_cut) {
  std::vector<PlanBox> cut, all;
  std::vector<std::size_t> cut_index;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    all.push_back(box_of(footprints[i].area.outer));
    if (!is_cut[i]) continue;
    cut.push_back(all.back());
    cut_index.push_back(i);
  }
  Groups groups(footprints.size());
  std::map<std::size_t, std::vector<std::size_t>> members;
  if (cut.empty()) return members;
  for (const auto& [c, j] : box_pairs(cut, all)) {
    const std::size_t i = cut_index[c];
    if (i != j && groups.first_of(i) != groups.first_of(j) && are_pieces(footprints[i], true, footprints[j], is_cut[j]))
      groups.join(i, j);
  }
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (groups.first_of(i) != i) members[groups.first_of(i)].push_back(i);
  return members;
}

}  // namespace

void stitch_pieces(std::vector<Footprint>& footprints, std::vector<bool>& is_cut) {
  assert(footprints.size() == is_cut.size());
  std::vector<bool> is_gone(footprints.size());
  std::vector<Footprint> extra;
  for (const auto& [first, others] : groups_of(footprints, is_cut)) {
    std::vector<Polygon> pieces = {footprints[first].area};
    for (std::size_t other : others) pieces.push_back(footprints[other].area);
    std::vector<Polygon> united = united_polygons(pieces);
    if (united.empty()) continue;
    footprints[first].area = std::move(united[0]);
    for (std::size_t i = 1; i < united.size(); ++i) {
      extra.push_back(footprints[first]);
      extra.back().area = std::move(united[i]);
    }
    for (std::size_t other : others) is_gone[other] = true;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (is_gone[i]) continue;
    if (kept != i) footprints[kept] = std::move(footprints[i]);
    is_cut[kept++] = is_cut[i];
  }
  footprints.resize(kept);
  is_cut.resize(kept);
  footprints.insert(footprints.end(), std::make_move_iterator(extra.begin()), std::make_move_iterator(extra.end()));
  is_cut.resize(footprints.size(), true);
  for (Footprint& footprint : footprints) footprint.tags.erase(kTile);
}

}  // namespace vicus
