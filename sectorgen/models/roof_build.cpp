#include "sectorgen/models/roof_build.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/roof_fans.hpp"
#include "sectorgen/models/roof_flat.hpp"
#include "sectorgen/models/roof_mesh.hpp"
#include "sectorgen/models/solid_check.hpp"

namespace vicus {
namespace {

constexpr double kSteepest = 1.19;         // tangent of 50 degrees: where the map gives no rise
constexpr double kFacing = 0.7;            // cosine: a side that looks along the ridge
constexpr double kMansardFoot_m = 2.6;     // height of the steep part
constexpr double kMansardFootRun = 0.364;  // cotangent of 70 degrees
constexpr double kMansardTop = 0.325;      // tangent of 18 degrees
constexpr double kLongestWingEnd_m = 12;

struct Plan {
  const Polygon& footprint;
  std::vector<RoofSide> sides;
  std::vector<bool> is_upright;  // per side
};

bool has_gables(RoofForm form) {
  return form == RoofForm::gabled || form == RoofForm::half_hipped || form == RoofForm::gambrel ||
         form == RoofForm::round || form == RoofForm::saltbox;
}

/// Ends of the ridge, ends of wings, and party walls where an upright wall does not cut into the house.
std::vector<bool> upright_sides(const Polygon& footprint, const std::vector<RoofSide>& sides,
                                const RoofRequest& request) {
  std::vector<bool> is_upright(sides.size(), false);
  const bool with_ends = has_gables(request.form);
  if (!with_ends && request.form != RoofForm::mansard) return is_upright;
  const PlanRectangle box = rectangle_around(footprint);
  double ux = box.ux, uy = box.uy;
  if (request.ridge_deg) {
    const double turn = *request.ridge_deg * std::numbers::pi / 180;
    ux = std::sin(turn), uy = std::cos(turn);
  }
  const bool has_wings = area_m2(footprint) < 0.85 * box.length_m * box.width_m;
  std::vector<bool> is_wall(sides.size(), false);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const RoofSide& side = sides[s];
    if (!request.is_party.empty())
      is_wall[s] = std::all_of(side.edges.begin(), side.edges.end(), [&](auto e) { return request.is_party[e]; });
    if (!with_ends || !side.is_convex) continue;
    const bool looks_along = std::abs(side.nx * ux + side.ny * uy) > kFacing;
    const bool is_wing_end = has_wings && side.length_m <= kLongestWingEnd_m &&
                             side.length_m < 0.9 * sides[side.before].length_m &&
                             side.length_m < 0.9 * sides[side.after].length_m;
    is_upright[s] = looks_along || is_wing_end;
  }
  // A party wall that looks across the ridge carries the slope, as the eave does.
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (is_wall[s] && sides[s].is_convex && (!with_ends || std::abs(sides[s].nx * ux + sides[s].ny * uy) > kFacing))
      is_upright[s] = true;
  const auto moving = std::count(is_upright.begin(), is_upright.end(), false);
  if (moving < 2) std::fill(is_upright.begin(), is_upright.end(), false);
  return is_upright;
}

double noise(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 40) / static_cast<double>(1u << 24) * 2 - 1;
}

/// One attempt: the wavefront for the plan with some perturbation of the runs.
class Attempt {
 public:
  Attempt(const Plan& plan, const RoofRequest& request, double perturbation) : plan_(plan), request_(request) {
    std::vector<bool> is_upright(edge_count(plan.footprint));
    side_of_.resize(is_upright.size());
    for (std::size_t s = 0; s < plan.sides.size(); ++s)
      for (const std::uint32_t e : plan.sides[s].edges) is_upright[e] = plan.is_upright[s], side_of_[e] = s;
    outline_ = make_outline(plan.footprint, is_upright);
    std::uint64_t state = request.seed;
    noise(state);
    for (std::size_t s = 0; s < plan.sides.size(); ++s) run_.push_back(run_of(s) * (1 + perturbation * noise(state)));
  }

  /// nullopt: `fault` says why.
  std::optional<Roof> make(double eave_m, double& rise_m, std::string& fault) {
    WaveInput input;
    input.rings = outline_.rings;
    input.phases.push_back({0, runs(false)});
    Wave wave = run_wavefront(input);
    if (!wave.failure.empty()) return fault = wave.failure, std::nullopt;
    double rise = request_.rise_m;
    if (!request_.is_rise_given && request_.form != RoofForm::mansard) rise = std::min(rise, kSteepest * wave.most);
    const RoofProfile profile = profile_of(wave.most, rise);
    if (profile.size() > 2 || profile.back().first < wave.most || request_.form == RoofForm::half_hipped) {
      const bool is_half = request_.form == RoofForm::half_hipped;
      if (is_half) input.phases.push_back({0.55 * wave.most, runs(true)});
      for (std::size_t i = 1; i + 1 < profile.size(); ++i) input.phases.push_back({profile[i].first, runs(false)});
      if (profile.back().first < wave.most * (1 - 1e-6)) input.stop = profile.back().first;
      wave = run_wavefront(input);
      if (!wave.failure.empty()) return fault = wave.failure, std::nullopt;
    }
    auto roof = roof_from_wave(outline_, wave, profile, eave_m);
    if (!roof) return fault = "faces that do not close", std::nullopt;
    if (auto found = fault_of_roof(plan_.footprint, eave_m, *roof)) return fault = *found, std::nullopt;
    std::int32_t top = 0;
    for (const auto& p : roof->points) top = std::max(top, p.up);
    rise_m = top / kRoofStepsPerMetre - eave_m;
    return roof;
  }

 private:
  /// Saltbox: the side that looks most across the ridge, and those like it, are half as steep.
  double run_of(std::size_t s) const {
    if (request_.form != RoofForm::saltbox) return 1;
    const PlanRectangle box = rectangle_around(plan_.footprint);
    return -plan_.sides[s].nx * box.uy + plan_.sides[s].ny * box.ux > 0.5 ? 1.8 : 1;
  }

  std::vector<double> runs(bool all_move) const {
    std::vector<double> out;
    for (const std::uint32_t e : outline_.first_edge)
      out.push_back(plan_.is_upright[side_of_[e]] && !all_move ? 0 : run_[side_of_[e]]);
    return out;
  }

  RoofProfile profile_of(double most, double rise) const {
    switch (request_.form) {
      case RoofForm::gambrel:
        return {{0, 0}, {0.35 * most, 0.62 * rise}, {most, rise}};
      case RoofForm::mansard: {
        const double foot = std::min(kMansardFoot_m, 0.75 * rise), run = std::min(kMansardFootRun * foot, 0.45 * most);
        const double left = rise - foot, slope = request_.is_rise_given ? left / (most - run) : kMansardTop;
        const double end = std::min(most, run + left / slope);
        return {{0, 0}, {run, foot}, {end, foot + (end - run) * slope}};
      }
      case RoofForm::round:
      case RoofForm::dome:
      case RoofForm::onion: {
        RoofProfile profile;
        constexpr int kSteps = 5;
        for (int i = 0; i <= kSteps; ++i) {
          const double turn = i * std::numbers::pi / 2 / kSteps;
          profile.emplace_back(most * (1 - std::cos(turn)), rise * std::sin(turn));
        }
        return profile;
      }
      default:
        return {{0, 0}, {most, rise}};
    }
  }

  const Plan& plan_;
  const RoofRequest& request_;
  RoofOutline outline_;
  std::vector<std::size_t> side_of_;  // per edge of the footprint
  std::vector<double> run_;           // per side
};

std::optional<BuiltRoof> by_wavefront(const Polygon& footprint, double eave_m, const RoofRequest& request,
                                      std::string& first_fault) {
  Plan plan{footprint, sides_of(footprint), {}};
  plan.is_upright = upright_sides(footprint, plan.sides, request);
  for (const double perturbation : {0.0, 1e-4, 3e-3}) {
    Attempt attempt(plan, request, perturbation);
    BuiltRoof built;
    std::string fault;
    if (auto roof = attempt.make(eave_m, built.rise_m, fault)) {
      built.roof = std::move(*roof);
      built.form = request.form;
      built.rung = perturbation == 0 ? RoofRung::asked : RoofRung::perturbed;
      return built;
    }
    if (first_fault.empty()) first_fault = fault;
  }
  return std::nullopt;
}

/// Forms that need no wavefront.
std::optional<BuiltRoof> directly(const Polygon& footprint, double eave_m, const RoofRequest& request) {
  std::optional<Roof> roof;
  double rise = request.rise_m;
  if (request.form == RoofForm::skillion) {
    roof = skillion_roof(footprint, eave_m, request);
    rise = std::max(0.0, top_of(*roof) - eave_m);
  } else if (const auto centre = star_centre(footprint)) {
    const PlanRectangle box = rectangle_around(footprint);
    if (!request.is_rise_given) rise = std::min(rise, kSteepest * box.width_m / 2);
    if (const auto profile = fan_profile(request.form); !profile.empty())
      roof = fan_roof(footprint, *centre, eave_m, rise, profile);
  }
  if (!roof || fault_of_roof(footprint, eave_m, *roof)) return std::nullopt;
  return BuiltRoof{std::move(*roof), request.form, RoofRung::asked, rise, ""};
}

}  // namespace

namespace {

/// The wavefront's time grows with their square: 14,000 take four minutes. Berlin's most has 540.
constexpr std::size_t kMostCorners = 1500;

}  // namespace

BuiltRoof build_roof(const Polygon& footprint, double eave_m, const RoofRequest& request) {
  std::string fault;
  const auto finish = [&](BuiltRoof built) {
    triangulate_facets(built.roof);
    built.fault = fault;
    return built;
  };
  if (edge_count(footprint) > kMostCorners) fault = "more corners than any house has";
  if (request.form != RoofForm::flat && fault.empty()) {
    if (auto built = directly(footprint, eave_m, request)) return finish(std::move(*built));
    if (auto built = by_wavefront(footprint, eave_m, request, fault)) return finish(std::move(*built));
    if (request.form != RoofForm::hipped) {
      RoofRequest hipped = request;
      hipped.form = RoofForm::hipped;
      if (auto built = by_wavefront(footprint, eave_m, hipped, fault)) {
        built->rung = RoofRung::other_form;
        return finish(std::move(*built));
      }
    }
  }
  return {flat_roof(footprint, eave_m), RoofForm::flat,
          request.form == RoofForm::flat ? RoofRung::asked : RoofRung::flat, 0, fault};
}

}  // namespace vicus
