#include "sectorgen/models/roof_fans.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sectorgen/models/roof_flat.hpp"

namespace vicus {

double top_of(const Roof& roof) {
  std::int32_t top = 0;
  for (const auto& p : roof.points) top = std::max(top, p.up);
  return top / kRoofStepsPerMetre;
}

Roof skillion_roof(const Polygon& footprint, double eave_m, const RoofRequest& request) {
  // Uphill, unit. Without a tag: across the longer side.
  const PlanRectangle box = rectangle_around(footprint);
  double ux = -box.uy, uy = box.ux;
  if (request.downslope_deg) {
    const double turn = *request.downslope_deg * std::numbers::pi / 180;
    ux = -std::sin(turn), uy = -std::cos(turn);
  }
  const PlanPoint o = footprint.outer.front();
  const auto uphill = [&](PlanPoint p) {
    return ux * metres(std::int64_t{p.x} - o.x) + uy * metres(std::int64_t{p.y} - o.y);
  };
  double low = 0, high = 0;
  for (const PlanPoint p : footprint.outer) low = std::min(low, uphill(p)), high = std::max(high, uphill(p));
  double rise = request.rise_m;
  if (!request.is_rise_given) rise = std::min(rise, 0.36 * (high - low));  // 20 degrees

  Roof roof;
  RoofFacet slope{FacetKind::slope, {}, {}};
  std::vector<RoofFacet> gables;
  const std::int32_t eave = roof_steps(eave_m);
  const auto add = [&](const Ring& ring) {
    std::vector<std::uint32_t> foot, head;
    for (const PlanPoint p : ring) {
      foot.push_back(static_cast<std::uint32_t>(roof.points.size()));
      roof.points.push_back({p, eave});
      const std::int32_t up = roof_steps(rise * (uphill(p) - low) / (high - low));
      head.push_back(up > 0 ? static_cast<std::uint32_t>(roof.points.size()) : foot.back());
      if (up > 0) roof.points.push_back({p, eave + up});
    }
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const std::size_t k = (i + 1) % n;
      std::vector<std::uint32_t> gable{foot[i], foot[k]};
      if (head[k] != foot[k]) gable.push_back(head[k]);
      if (head[i] != foot[i]) gable.push_back(head[i]);
      if (gable.size() > 2) gables.push_back({FacetKind::gable, {std::move(gable)}, {}});
    }
    slope.rings.push_back(std::move(head));
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  roof.facets.push_back(std::move(slope));
  roof.facets.insert(roof.facets.end(), gables.begin(), gables.end());
  return roof;
}

FanProfile fan_profile(RoofForm form) {
  switch (form) {
    case RoofForm::pyramidal:
    case RoofForm::cone:
      return {{0, 1}};
    case RoofForm::dome: {
      FanProfile profile;
      for (int i = 1; i <= 5; ++i) {
        const double turn = i * std::numbers::pi / 10;
        profile.emplace_back(i == 5 ? 0 : std::cos(turn), std::sin(turn));
      }
      return profile;
    }
    case RoofForm::onion:
      return {{0.98, 0.2}, {0.85, 0.4}, {0.6, 0.55}, {0.3, 0.67}, {0.12, 0.8}, {0, 1}};
    default:
      return {};
  }
}

Roof fan_roof(const Polygon& footprint, PlanPoint centre, double eave_m, double rise_m, const FanProfile& profile) {
  Roof roof;
  const Ring& ring = footprint.outer;
  const std::size_t n = ring.size();
  const std::int32_t eave = roof_steps(eave_m);
  std::vector<std::uint32_t> below(n), above(n);
  const auto add_point = [&](RoofPoint p) {
    roof.points.push_back(p);
    return static_cast<std::uint32_t>(roof.points.size() - 1);
  };
  for (std::size_t i = 0; i < n; ++i) below[i] = add_point({ring[i], eave});
  for (const auto& [size, share] : profile) {
    const std::int32_t up = eave + roof_steps(rise_m * share);
    if (size == 0) {
      const std::uint32_t apex = add_point({centre, up});
      for (std::size_t i = 0; i < n; ++i)
        roof.facets.push_back({FacetKind::slope, {{below[i], below[(i + 1) % n], apex}}, {}});
      break;
    }
    for (std::size_t i = 0; i < n; ++i)
      above[i] = add_point({{centre.x + static_cast<std::int32_t>(std::llround(size * (ring[i].x - centre.x))),
                             centre.y + static_cast<std::int32_t>(std::llround(size * (ring[i].y - centre.y)))},
                            up});
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (i + 1) % n;
      // Two triangles: on the lattice the four points need not be planar.
      roof.facets.push_back({FacetKind::slope, {{below[i], below[k], above[k]}}, {}});
      roof.facets.push_back({FacetKind::slope, {{below[i], above[k], above[i]}}, {}});
    }
    below = above;
  }
  return roof;
}

}  // namespace vicus
