#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sectorgen/geo/source_map.hpp"

/// What the tests of reading share. Independent of the reader's own checks: GEOS alone judges.
namespace vicus::test {

/// OGC validity by GEOS, and orientation by a sum in floating point.
bool is_valid_by_geos(const Polygon& polygon);
double area_by_geos_m2(const Polygon& polygon);
double shared_area_by_geos_m2(const Polygon& a, const Polygon& b);

/// Every promise of source_map.hpp about `map`; "" where all hold, else what is broken first.
std::string broken_promise(const SourceMap& map);

struct Loaded {
  SourceMap map;
  std::vector<Issue> issues;
  std::size_t count(IssueCode code) const;
};
Loaded load(const std::vector<std::filesystem::path>& inputs);
Loaded load(const LoadOptions& options);

/// Real data: $VICUS_DATA, else ../shared/data beside the tree; nothing where it is missing (tests then skip).
std::optional<std::filesystem::path> real_data();

}  // namespace vicus::test
