#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "city_db/city.hpp"

/// Geometries as GeoPackage stores them: the "GP" header, an envelope, then well-known binary; metres in the plan
/// frame. FORMAT.md shows one byte by byte.
///
/// Exact   decode(encode(g)) == g for everything on the lattice.
/// Source  OGC 12-128r17 (GeoPackage 1.3), clause 2.1.3.
namespace vicus {

/// `srs_id` of the plan frame in gpkg_spatial_ref_sys.
inline constexpr std::int32_t kPlanSrsId = 100000;

/// Needs   lines of 0 or >= 2 points, rings of >= 3; an empty outer ring only without holes (an empty geometry).
std::string encode_point(PlanPoint point);
std::string encode_line(const std::vector<PlanPoint>& line);
std::string encode_polygon(const Polygon& polygon);

/// nullopt: truncated, overlong, another type, Z or M, open ring, off the lattice by more than 1 um or out of its
/// limits. Either byte order and every envelope are read. Never reserves more than the bytes at hand can fill.
std::optional<PlanPoint> decode_point(std::string_view blob);
std::optional<std::vector<PlanPoint>> decode_line(std::string_view blob);
std::optional<Polygon> decode_polygon(std::string_view blob);

}  // namespace vicus
