#pragma once
#include "sectorgen/sectors/sectors.hpp"

/// What a sector is called and what kind it is.
namespace vicus {

/// Sets kind, name and names. Main name: the one with most centre line inside, a square's own name where the square
/// covers more than half. Also raises 301 for ground that looks like a street no axis was drawn for.
/// Needs   sectors in cell order, from write_sectors.
void name_sectors(const SourceMap& map, const Plan& plan, City& city);

/// Ids that say where a sector is, not in which order it was found: an edit in one street renames no other
/// (DESIGN §3.7). A sector keeps the id of the previous city's sector it overlaps most, if each is the other's best
/// match and they share more than half of both. Else: name and position on a 16 m grid, finer where two would be equal.
/// Turns index texts in gates, borders, buildings into ids, numbers gates, finds twins, sorts records by id.
void identify(const City* previous, City& city);

/// Objects with the sector they are in.
void furnish(const SourceMap& map, const Plan& plan, City& city);

/// Where a visitor of each sector starts: on its street's axis near its middle, looking where he sees far and into the
/// city; where that would be a wall before his nose, in another place of the sector.
void add_start_views(const Plan& plan, City& city);

}  // namespace vicus
