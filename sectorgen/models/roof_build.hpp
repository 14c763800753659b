#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/models/roof_form.hpp"

/// One roof on one footprint.
namespace vicus {

struct RoofRequest {
  RoofForm form = RoofForm::flat;
  double rise_m = 3;                ///< top over eave, > 0
  bool is_rise_given = false;       ///< the map says so; else the slope is held below 50 degrees, and the rise with it
  std::optional<double> ridge_deg;  ///< compass direction of the ridge; else along the longer side
  std::optional<double> downslope_deg;  ///< skillion: compass direction that water runs to; else a long side
  std::vector<bool> is_party;           ///< per edge of the footprint: a neighbour stands there; empty: none
  std::uint64_t seed = 0;               ///< of the perturbations
};

/// asked: at first try; perturbed: with runs changed by up to 0.3 %; other_form: hipped where the form asked for fails;
/// flat: nothing else could be built.
enum class RoofRung { asked, perturbed, other_form, flat };

struct BuiltRoof {
  Roof roof;
  RoofForm form = RoofForm::flat;
  RoofRung rung = RoofRung::asked;
  double rise_m = 0;
  std::string fault;  ///< of the first try, where it failed
};

/// The roof asked for, or what comes nearest to it on this footprint; always sound (solid_check.hpp), with triangles.
/// Needs   a valid footprint.   Fails  never.
/// Source  research/HOUSES.md §1.2.
BuiltRoof build_roof(const Polygon& footprint, double eave_m, const RoofRequest& request);

}  // namespace vicus
