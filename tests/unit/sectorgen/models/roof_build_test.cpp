#include "sectorgen/models/roof_build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/roof_fans.hpp"
#include "sectorgen/models/roof_mesh.hpp"
#include "sectorgen/models/solid_check.hpp"
#include "tests/unit/sectorgen/models/roof_plans.hpp"

/// Every form on simple, nasty and random plans; the wavefront against brute force.
namespace vicus::test {
namespace {

constexpr double kEave_m = 6;
constexpr RoofForm kForms[] = {RoofForm::flat,   RoofForm::skillion,  RoofForm::gabled,  RoofForm::half_hipped,
                               RoofForm::hipped, RoofForm::pyramidal, RoofForm::gambrel, RoofForm::mansard,
                               RoofForm::dome,   RoofForm::onion,     RoofForm::cone,    RoofForm::round,
                               RoofForm::saltbox};

RoofRequest request_for(RoofForm form, double rise_m = 3) {
  RoofRequest request;
  request.form = form;
  request.rise_m = rise_m;
  return request;
}

/// The triangles cover the facets: their areas in plan add up to the footprint's, none is turned over.
void expect_triangles(const Polygon& plan, const Roof& roof) {
  Int128 sum = 0;
  for (const auto& facet : roof.facets) {
    ASSERT_EQ(facet.triangles.size() % 3, 0u);
    ASSERT_FALSE(facet.triangles.empty());
    for (std::size_t i = 0; i < facet.triangles.size(); i += 3) {
      const auto at = [&](std::size_t k) { return roof.points[facet.triangles[i + k]].at; };
      const std::int64_t area = orient(at(0), at(1), at(2));
      EXPECT_TRUE(area > 0 || facet.kind == FacetKind::gable);  // gables lean by a millimetre
      sum += area;
    }
  }
  EXPECT_TRUE(sum == area2(plan));
}

TEST(BuildRoof, BuildsEveryFormOnEveryPlan) {
  std::size_t asked = 0, tried = 0;
  for (const auto& [name, plan] : roof_plans())
    for (const RoofForm form : kForms) {
      SCOPED_TRACE(name + " " + name_of(form));
      const BuiltRoof built = build_roof(plan, kEave_m, request_for(form));
      EXPECT_EQ(fault_of_roof(plan, kEave_m, built.roof).value_or("none"), "none");
      expect_triangles(plan, built.roof);
      EXPECT_NE(built.rung, RoofRung::flat) << built.fault;
      EXPECT_LE(built.rise_m, 4.7);
      EXPECT_NEAR(top_of(built.roof), kEave_m + built.rise_m, 2e-4);
      asked += built.rung <= RoofRung::perturbed;
      ++tried;
    }
  EXPECT_GE(asked * 100, tried * 97) << asked << " of " << tried;
}

std::size_t count(const Roof& roof, FacetKind kind) {
  return static_cast<std::size_t>(
      std::count_if(roof.facets.begin(), roof.facets.end(), [&](const RoofFacet& f) { return f.kind == kind; }));
}

TEST(BuildRoof, GivesARectangleTheFacetsOfItsForm) {
  const Polygon plan = roof_plans()[0].second;  // 12 x 8
  const auto facets = [&](RoofForm form) {
    const Roof roof = build_roof(plan, kEave_m, request_for(form)).roof;
    return std::array{count(roof, FacetKind::slope), count(roof, FacetKind::gable), count(roof, FacetKind::top)};
  };
  using Counts = std::array<std::size_t, 3>;
  EXPECT_EQ(facets(RoofForm::flat), (Counts{0, 0, 1}));
  EXPECT_EQ(facets(RoofForm::skillion), (Counts{1, 3, 0}));
  EXPECT_EQ(facets(RoofForm::gabled), (Counts{2, 2, 0}));
  EXPECT_EQ(facets(RoofForm::half_hipped), (Counts{6, 2, 0}));
  EXPECT_EQ(facets(RoofForm::hipped), (Counts{4, 0, 0}));
  EXPECT_EQ(facets(RoofForm::pyramidal), (Counts{4, 0, 0}));
  EXPECT_EQ(facets(RoofForm::gambrel), (Counts{4, 2, 0}));
  EXPECT_EQ(facets(RoofForm::mansard), (Counts{8, 0, 1}));
  EXPECT_EQ(facets(RoofForm::round), (Counts{10, 2, 0}));
  EXPECT_EQ(facets(RoofForm::saltbox), (Counts{2, 2, 0}));
}

TEST(BuildRoof, TurnsTheRidgeAsAsked) {
  const Polygon plan = roof_plans()[0].second;
  for (const double deg : {0.0, 90.0}) {
    RoofRequest request = request_for(RoofForm::gabled, 2);
    request.ridge_deg = deg;
    const Roof roof = build_roof(plan, kEave_m, request).roof;
    PlanBox ridge;
    for (const auto& p : roof.points)
      if (p.up > 60'000) ridge.add(p.at);
    EXPECT_EQ(ridge.max.x - ridge.min.x, deg == 90 ? 12'000 : 0) << deg;
    EXPECT_EQ(ridge.max.y - ridge.min.y, deg == 90 ? 0 : 8'000) << deg;
  }
}

TEST(BuildRoof, LetsWaterRunAsAsked) {
  const Polygon plan = roof_plans()[0].second;
  RoofRequest request = request_for(RoofForm::skillion, 2);
  request.is_rise_given = true;
  request.downslope_deg = 90;  // east
  for (const auto& p : build_roof(plan, kEave_m, request).roof.points)
    if (p.up > 60'000) {
      EXPECT_EQ(p.at.x, 0);
      EXPECT_EQ(p.up, 80'000);
    }
}

TEST(BuildRoof, HoldsGuessedSlopesAndKeepsGivenOnes) {
  const Polygon plan = roof_plans()[0].second;  // half width 4 m
  EXPECT_NEAR(build_roof(plan, kEave_m, request_for(RoofForm::gabled, 20)).rise_m, 4 * 1.19, 1e-3);
  RoofRequest request = request_for(RoofForm::gabled, 20);
  request.is_rise_given = true;
  EXPECT_NEAR(build_roof(plan, kEave_m, request).rise_m, 20, 1e-3);
}

TEST(BuildRoof, StandsPartyWallsUpright) {
  const Polygon plan = roof_plans()[1].second;  // square: which way the ridge runs is for the walls to say
  RoofRequest request = request_for(RoofForm::mansard, 4.6);
  request.is_party = {false, true, false, true};
  const Roof roof = build_roof(plan, kEave_m, request).roof;
  EXPECT_EQ(count(roof, FacetKind::gable), 2u);
  for (const auto& facet : roof.facets) {
    if (facet.kind != FacetKind::gable) continue;
    for (const std::uint32_t i : facet.rings[0]) EXPECT_TRUE(roof.points[i].at.x < 3 || roof.points[i].at.x > 9'997);
  }
}

/// A ring around the origin, as ragged as the seed says; every third has right angles only.
Polygon random_plan(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 1'000'000) / 1e6;
  };
  Ring ring;
  const int n = 3 + static_cast<int>(random() % 14);
  if (random() % 3 == 0) {
    double x = 0;  // a skyline: right angles only
    ring = {{0, 0}};
    std::vector<PlanPoint> top;
    for (int i = 0; i < n; ++i) {
      const double height = between(3, 12), next = x + between(0.5, 5);
      top.push_back({lattice_mm(x), lattice_mm(height)});
      top.push_back({lattice_mm(next), lattice_mm(height)});
      x = next;
    }
    ring.push_back({lattice_mm(x), 0});
    ring.insert(ring.end(), top.rbegin(), top.rend());
  } else {
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * 3.14159265358979 * (i + between(0, 0.7)) / n, radius = between(3, 12);
      ring.push_back({lattice_mm(radius * std::cos(turn)), lattice_mm(radius * std::sin(turn))});
    }
  }
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return {std::move(ring), {}};
}

TEST(BuildRoof, ClosesRandomPlans) {
  std::size_t tried = 0, as_asked = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    std::mt19937_64 random(seed);
    const Polygon plan = random_plan(random);
    if (area2(plan.outer) <= 0) continue;
    for (const RoofForm form : kForms) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " " + name_of(form));
      RoofRequest request = request_for(form);
      request.seed = seed;
      for (std::size_t e = 0; e < plan.outer.size(); ++e) request.is_party.push_back(random() % 4 == 0);
      const BuiltRoof built = build_roof(plan, kEave_m, request);
      ASSERT_EQ(fault_of_roof(plan, kEave_m, built.roof).value_or("none"), "none");
      ++tried;
      as_asked += built.rung <= RoofRung::perturbed;
    }
  }
  EXPECT_GT(tried, 4000u);
  EXPECT_GE(static_cast<double>(as_asked), 0.985 * static_cast<double>(tried)) << as_asked << " of " << tried;
}

/// Volume over the eave by facets in plan, and where they end: the same roof has the same.
double volume_m3(const Roof& roof) {
  double sum = 0;
  for (const auto& facet : roof.facets) {
    const auto& ring = facet.rings[0];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const RoofPoint &a = roof.points[ring[0]], &b = roof.points[ring[i]], &c = roof.points[ring[i + 1]];
      sum += static_cast<double>(orient(a.at, b.at, c.at)) / 2e6 *
             (static_cast<double>(a.up) + b.up + c.up - 3 * kEave_m * kRoofStepsPerMetre) / 3 / kRoofStepsPerMetre;
    }
  }
  return sum;
}

TEST(BuildRoof, LeavesPlansFlatThatAreNoHouse) {
  Polygon comb;  // a coast, tagged as a house
  for (int i = 0; i < 1000; ++i)
    for (const PlanPoint p : {PlanPoint{0, 0}, {1000, 0}, {1000, 5000}, {2000, 5000}})
      comb.outer.push_back({p.x + 2000 * i, p.y});
  comb.outer.push_back({2'000'000, 100'000});
  comb.outer.push_back({0, 100'000});
  RoofRequest request;
  request.form = RoofForm::hipped;
  const BuiltRoof built = build_roof(comb, kEave_m, request);
  EXPECT_EQ(built.rung, RoofRung::flat);
  EXPECT_NE(built.fault.find("corners"), std::string::npos);
  EXPECT_EQ(fault_of_roof(comb, kEave_m, built.roof), std::nullopt);
}

TEST(Wavefront, IsTheSameWithEventsFromAHeapAndByBruteForce) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Polygon plan = random_plan(random);
    if (area2(plan.outer) <= 0) continue;
    const RoofOutline outline = make_outline(plan, std::vector<bool>(edge_count(plan)));
    WaveInput input;
    input.rings = outline.rings;
    input.phases.push_back({0, std::vector<double>(outline.chains.size(), 1)});
    const Wave heap = run_wavefront(input);
    input.brute_force = true;
    const Wave brute = run_wavefront(input);
    ASSERT_EQ(heap.failure, brute.failure);
    if (!heap.failure.empty()) continue;
    EXPECT_NEAR(heap.most, brute.most, 1e-6);
    const RoofProfile profile{{0, 0}, {heap.most, 3}};
    const auto a = roof_from_wave(outline, heap, profile, kEave_m),
               b = roof_from_wave(outline, brute, profile, kEave_m);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_NEAR(volume_m3(*a), volume_m3(*b), 1e-3 * area_m2(plan)) << "points are rounded to 1 mm";
    ++compared;
  }
  EXPECT_GT(compared, 250u);
}

}  // namespace
}  // namespace vicus::test
