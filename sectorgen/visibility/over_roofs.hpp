#pragma once
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/visibility/line_of_sight.hpp"

/// L_vis over roofs: houses seen above lower ones from sectors that no level look joins.
namespace vicus {

struct RoofOptions {
  unsigned threads = 0;                       ///< 0: all cores
  double least_height_m = 0;                  ///< lower houses are not looked for, nor, where it is not 0, the ground
  double first_radius_m = 2.5;                ///< of the first horizons
  double pair_radius_m = 1;                   ///< below it eyes and walls are taken pair by pair
  double least_radius_m = 0.125;              ///< and told apart down to pieces of twice this length
  std::uint32_t every = 1;                    ///< only each n-th sector, the others' lists stay empty: to measure
  std::uint32_t most_rays = 5000;             ///< to prove that a sector sees one house's walls
  std::uint32_t most_pairs = 5000;            ///< to prove that it does not; then it stays unresolved
  std::uint32_t most_sector_pairs = 400'000;  ///< the same for all houses from one sector
  std::size_t grid_cells = 400'000'000;
};

/// A house of the city, seen from a sector: what `sector` sends of it is needed there.
struct RoofSight {
  static constexpr std::uint32_t kGround = 0xFFFFFFFFu;  ///< as `house`: the ground of `sector`, seen on a slope
  std::uint32_t sector = 0, house = 0;
  bool is_proven = false;  ///< a line to one of its walls was found; else nothing was found that hides them all
};

struct RoofLists {
  /// Per sector, by sector then house; none that `level` has.
  std::vector<std::vector<RoofSight>> visible;
  std::uint64_t horizons = 0, tests = 0, fine_tests = 0, rays = 0;
  /// CPU seconds: what all sectors share; then, summed over them, first horizons, smaller ones, pairs of pieces.
  double scene_s = 0, first_s = 0, closer_s = 0, pairs_s = 0;
};

/// For each sector the houses that some eye in it, at most kEyeTop_m above ground, may see over other houses, by the
/// sector that sends them (the owner of the roof, the owner of the facade). Conservative: a house left out is hidden.
/// On a terrain also the sectors whose ground some eye may see over houses.
///
/// Frame   plan, metres.
/// Needs   `level` of the same city: what is in it is left out here.
/// Error   a superset; what is neither proven visible nor proven hidden at least_radius_m stays in.
/// Source  Wonka, Wimmer, Schmalstieg, EGRW 2000, §3 (shrunk occluders); research/VISIBILITY.md §4.3 (erosion lemma).
/// Differs pairs of regions in place of one horizon per point: when the middle line from a disc of eyes (radius r) to a
///         disc of targets (radius s) passes, at share t of its length and height z, a place where all houses within
///         (1-t) r + t s reach z, then every line from the one disc to the other, no higher at both ends, is blocked
///         there: it is displaced by (1-t) v + t w, |v| <= r, |w| <= s. Regions are split until told apart. Eyes on the
///         sector's rim suffice: stepping back within the sector only lifts the line.
RoofLists sights_over_roofs(const City& city, const SightLists& level, const RoofOptions& options);

}  // namespace vicus
