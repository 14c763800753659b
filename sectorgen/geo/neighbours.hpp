#pragma once
#include <vector>

#include "sectorgen/geo/source_map.hpp"

/// Faults that show only when features are compared. Houses here: footprints on the ground that are no parts.
namespace vicus {

/// Issue 204: the same rings twice, as houses or as parts with the same tagged heights. The first one stays and takes
/// over tags that only the second one has. `is_cut` is kept in step.
void drop_duplicates(std::vector<Footprint>& footprints, std::vector<bool>& is_cut, std::vector<Issue>& issues);

/// Issue 207: moves a house's vertices that are within 10 cm of an earlier house onto that one's vertices, or its edge,
/// and takes over that one's vertices that are within 10 cm of its own edges; only if it stays valid. Gaps below 1 cm
/// are closed without an issue.
/// Error   no vertex moves by more than 10 cm + 1 mm.
void close_gaps(std::vector<Footprint>& footprints, std::vector<Issue>& issues);

/// Issue 206: two houses share more than 1 m2. Both stay: the ground is a house's either way.
void find_overlaps(const std::vector<Footprint>& footprints, std::vector<Issue>& issues);

/// Issue 213: less than half of a part lies in houses. It becomes a house itself.
void adopt_lost_parts(std::vector<Footprint>& footprints, std::vector<Issue>& issues);

/// Issue 208: more than 1 m of an axis without passage or bridge runs inside a house. Both stay.
void find_blocked_streets(const std::vector<Footprint>& footprints, const std::vector<Axis>& axes,
                          std::vector<Issue>& issues);

}  // namespace vicus
