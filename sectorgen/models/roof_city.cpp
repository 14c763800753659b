#include "sectorgen/models/roof_city.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "city_db/polygon_edges.hpp"
#include "sectorgen/models/guess_roof.hpp"
#include "sectorgen/models/roof_fans.hpp"
#include "sectorgen/models/roof_flat.hpp"
#include "sectorgen/models/roof_import.hpp"

namespace vicus {
namespace {

constexpr double kLeastWall_m = 0.05;  // lower steps between neighbours are not modelled

using PlanEdge = std::pair<PlanPoint, PlanPoint>;

std::vector<PlanEdge> facade_edges(const City& city) {
  std::vector<PlanEdge> edges;
  for (const auto& border : city.borders)
    if (border.kind == BorderKind::facade)
      for (std::size_t k = 0; k + 1 < border.line.size(); ++k) edges.push_back({border.line[k + 1], border.line[k]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

void update_side_walls(City& city) {
  const auto facades = facade_edges(city);
  std::vector<std::pair<PlanEdge, double>> tops;  // eaves of houses on the ground, above the plan frame's 0, by edge
  for (const auto& b : city.buildings)
    if (b.base_m <= 0)
      visit_edges(b.footprint, [&](PlanPoint p, PlanPoint q) {
        tops.emplace_back(PlanEdge{p, q}, b.ground_m + b.eave_m);
      });
  std::sort(tops.begin(), tops.end());
  for (auto& b : city.buildings) {
    if (b.base_m > 0) continue;  // the exporter draws all walls of what hangs in the air
    std::vector<SideWall> walls;
    visit_edges(b.footprint, [&](PlanPoint p, PlanPoint q) {
      const PlanEdge e{p, q};
      if (std::binary_search(facades.begin(), facades.end(), e)) return;
      const PlanEdge twin{e.second, e.first};
      std::optional<double> bottom;
      for (auto it = std::lower_bound(tops.begin(), tops.end(), std::pair(twin, -HUGE_VAL));
           it != tops.end() && it->first == twin; ++it)
        bottom = std::max(bottom.value_or(-b.foot_m), it->second - b.ground_m);
      if (!bottom)
        for (const auto& wall : b.side_walls)
          if (wall.a == e.first && wall.b == e.second && wall.bottom_m <= 0) bottom = -b.foot_m;
      if (bottom && *bottom + kLeastWall_m < b.eave_m) walls.push_back({e.first, e.second, *bottom});
    });
    b.side_walls = std::move(walls);
  }
}

namespace {

/// The roof stands on the walls where the top is known: what it rises less than asked, the walls rise more.
void put_on(Building& b, const RoofWish& wish, BuiltRoof built, double asked_eave_m) {
  b.roof_shape = name_of(built.form);
  b.roof_source = built.rung == RoofRung::flat ? RoofSource::flat_fallback : wish.source;
  double lift_m = 0;
  if (b.height_source != HeightSource::levels || b.eave_m < b.height_m - 0.001)
    lift_m = std::max(0.0, std::floor((b.height_m - top_of(built.roof)) * kMmPerMetre) / kMmPerMetre);
  for (auto& p : built.roof.points) p.up += roof_steps(lift_m);
  b.eave_m = asked_eave_m + lift_m;
  b.height_m = top_of(built.roof);
  b.roof = std::move(built.roof);
}

/// The roof its author modelled. False: it cannot be used; the issue says why.
bool put_model_on(Building& b, const HouseModel& model, std::vector<Issue>& issues) {
  std::string fault;
  auto imported = roof_from_model(b.footprint, model, fault);
  if (imported && b.base_m + 0.2 > imported->eave_m)
    imported.reset(), fault = "it lies below the house's own underside";
  if (!imported) {
    issues.push_back({IssueCode::model_unused,
                      "The house's own roof cannot be used: " + fault + "; one of ours instead.", b.source_id,
                      b.footprint.outer[0]});
    return false;
  }
  if (imported->is_level)
    b.roof_shape = "flat";
  else if (b.roof_shape.empty() || b.roof_shape == "flat")
    b.roof_shape = "many";
  b.roof_source = RoofSource::model;
  b.height_source = HeightSource::measured;
  b.eave_m = imported->eave_m;
  b.height_m = top_of(imported->roof);
  b.roof = std::move(imported->roof);
  return true;
}

void put_wish_on(Building& b, const RoofWish& wish, std::vector<Issue>& issues) {
  double eave_m = b.height_m;
  if (wish.request.form != RoofForm::flat) {
    // Levels count storeys below the roof: it comes on top of them. Of other heights it is a part.
    const bool is_on_top = b.height_source == HeightSource::levels && b.eave_m >= b.height_m - 0.001;
    eave_m = is_on_top ? b.eave_m : std::max(b.height_m - wish.request.rise_m, b.base_m + 0.2);
  }
  eave_m = metres(lattice_mm(eave_m));
  BuiltRoof built = build_roof(b.footprint, eave_m, wish.request);
  if (built.rung == RoofRung::other_form || built.rung == RoofRung::flat)
    issues.push_back({IssueCode::roof_flattened,
                      std::string("No ") + name_of(wish.request.form) + " roof can be built here; " +
                          name_of(built.form) + " instead.",
                      b.source_id, b.footprint.outer[0]});
  put_on(b, wish, std::move(built), eave_m);
}

}  // namespace

void roof_houses(City& city, const std::map<std::string, HouseModel>& models) {
  const auto wishes = guess_roofs(city);
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    Building& b = city.buildings[i];
    const auto model = models.find(b.source_id);
    if (model == models.end() || !put_model_on(b, model->second, city.issues)) put_wish_on(b, wishes[i], city.issues);
  }
  update_side_walls(city);
}

}  // namespace vicus
