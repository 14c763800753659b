#pragma once
#include "city_db/city.hpp"

/// Sectors that visitors probably come back to, found by measure: squares, places of landmarks, and what many ways lead
/// through. A proposal is only a mark: a person decides (Importance::author).
namespace vicus {

inline constexpr double kProposedShare = 0.03;          ///< of all sectors, at least one
inline constexpr std::size_t kMostExactSectors = 5000;  ///< betweenness is exact up to here, else estimated

/// Marks at most kProposedShare of the sectors that a person has not marked, by the sum of three scores of 0 ... 1:
/// size among the squares, best landmark whose longest facade (or whose place) is here, betweenness in the graph of
/// gates over the greatest there is. Vicinity 500 m for the best third, then 300 m, then 200 m.
/// Equal cities get equal marks: ties go by id.
void propose_important(City& city);

}  // namespace vicus
