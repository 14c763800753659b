#pragma once
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/models/roof_wavefront.hpp"

/// From a footprint to a wavefront and from the wavefront to a roof on the lattice.
namespace vicus {

/// Edges of a footprint are counted ring by ring, from each ring's first point.
std::size_t edge_count(const Polygon& footprint);

/// A footprint as the wavefront sees it: points on the line between others are left out where both edges move, so that
/// one facet rises from them. Metres from `origin`, the first point: large coordinates cost digits.
struct RoofOutline {
  PlanPoint origin;
  std::vector<std::vector<WavePoint>> rings;
  std::vector<std::vector<PlanPoint>> chains;  ///< per edge: the footprint's points on it, both ends included
  std::vector<std::uint32_t> first_edge;       ///< per edge: the footprint's edge that it begins with
};
RoofOutline make_outline(const Polygon& footprint, const std::vector<bool>& is_upright);

/// Height over the eave, piecewise linear over the wavefront's clock; the first pair is (0, 0), d rises.
using RoofProfile = std::vector<std::pair<double, double>>;

/// The roof, its points rounded to the lattice: points of gables inwards, others to the nearest.
/// nullopt: faces that do not close. What comes back need not be sound: see solid_check.hpp. Facets have no triangles.
std::optional<Roof> roof_from_wave(const RoofOutline& outline, const Wave& wave, const RoofProfile& profile,
                                   double eave_m);

}  // namespace vicus
