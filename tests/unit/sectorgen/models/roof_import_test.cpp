#include "sectorgen/models/roof_import.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectorgen/models/roof_fans.hpp"
#include "sectorgen/models/roof_flat.hpp"
#include "sectorgen/models/solid_check.hpp"
#include "tests/unit/sectorgen/models/roof_plans.hpp"

/// A house's own roof on the footprint as noded here: sound, and where the model has it.
namespace vicus::test {
namespace {

const Polygon kPlan{ring_of({{0, 0}, {12, 0}, {12, 8}, {0, 8}}), {}};

ModelFace face(std::initializer_list<std::array<double, 3>> corners) {
  ModelFace out;
  out.rings.emplace_back();
  for (const auto& c : corners) out.rings[0].push_back({{lattice_mm(c[0]), lattice_mm(c[1])}, c[2]});
  return out;
}

HouseModel gabled() {
  return {{face({{0, 0, 5}, {12, 0, 5}, {12, 4, 8}, {0, 4, 8}}), face({{0, 4, 8}, {12, 4, 8}, {12, 8, 5}, {0, 8, 5}})}};
}

/// Height of the roof over a place that lies on no edge; NaN where no facet is.
double up_at(const Roof& roof, double x, double y) {
  for (const auto& facet : roof.facets) {
    if (facet.kind == FacetKind::gable || facet.kind == FacetKind::step) continue;
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      const RoofPoint &a = roof.points[facet.triangles[i]], &b = roof.points[facet.triangles[i + 1]],
                      &c = roof.points[facet.triangles[i + 2]];
      const double px = 1000 * x, py = 1000 * y;
      const auto side = [&](PlanPoint p, PlanPoint q) {
        return (double(q.x) - p.x) * (py - p.y) - (double(q.y) - p.y) * (px - p.x);
      };
      const double wc = side(a.at, b.at), wa = side(b.at, c.at), wb = side(c.at, a.at);
      if (wa < 0 || wb < 0 || wc < 0 || wa + wb + wc == 0) continue;
      return (wa * a.up + wb * b.up + wc * c.up) / (wa + wb + wc) / kRoofStepsPerMetre;
    }
  }
  return std::nan("");
}

/// The oracle: the highest plane over the place, by brute force.
double model_up_at(const HouseModel& model, double x, double y) {
  double most = std::nan("");
  for (const auto& f : model.tops) {
    const auto& r = f.rings[0];
    bool is_inside = true;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const auto &p = r[i].at, &q = r[(i + 1) % r.size()].at;
      is_inside &= (double(q.x) - p.x) * (1000 * y - p.y) - (double(q.y) - p.y) * (1000 * x - p.x) >= 0;
    }
    if (!is_inside) continue;
    const double ux = r[1].at.x - r[0].at.x, uy = r[1].at.y - r[0].at.y, uz = r[1].up_m - r[0].up_m;
    const double vx = r[2].at.x - r[0].at.x, vy = r[2].at.y - r[0].at.y, vz = r[2].up_m - r[0].up_m;
    const double det = ux * vy - uy * vx;
    const double s = ((1000 * x - r[0].at.x) * vy - (1000 * y - r[0].at.y) * vx) / det,
                 t = (ux * (1000 * y - r[0].at.y) - uy * (1000 * x - r[0].at.x)) / det;
    const double up = r[0].up_m + s * uz + t * vz;
    if (!(most >= up)) most = up;
  }
  return most;
}

std::size_t count(const Roof& roof, FacetKind kind) {
  return static_cast<std::size_t>(
      std::count_if(roof.facets.begin(), roof.facets.end(), [&](const RoofFacet& f) { return f.kind == kind; }));
}

TEST(RoofFromModel, GivesAGabledRoofBackAsItIs) {
  std::string fault;
  const auto roof = roof_from_model(kPlan, gabled(), fault);
  ASSERT_TRUE(roof) << fault;
  EXPECT_EQ(roof->eave_m, 5);
  EXPECT_FALSE(roof->is_level);
  EXPECT_EQ(count(roof->roof, FacetKind::slope), 2u);
  EXPECT_EQ(count(roof->roof, FacetKind::gable), 2u);
  EXPECT_EQ(roof->roof.facets.size(), 4u);
  EXPECT_EQ(top_of(roof->roof), 8);
}

TEST(RoofFromModel, ClosesASplitLevelWithAStepAndPutsTheEaveALipBelow) {
  // The step's foot lies on the footprint's edges, at the lowest height of all: nothing can rise from the eave there.
  const HouseModel model{
      {face({{0, 0, 5}, {6, 0, 5}, {6, 8, 5}, {0, 8, 5}}), face({{6, 0, 9}, {12, 0, 9}, {12, 8, 9}, {6, 8, 9}})}};
  std::string fault;
  const auto roof = roof_from_model(kPlan, model, fault);
  ASSERT_TRUE(roof) << fault;
  EXPECT_TRUE(roof->is_level);
  EXPECT_EQ(roof->eave_m, 5 - kLip_m);
  EXPECT_EQ(count(roof->roof, FacetKind::step), 1u);
  EXPECT_EQ(count(roof->roof, FacetKind::top), 2u);
  EXPECT_EQ(count(roof->roof, FacetKind::gable), 4u);
}

TEST(RoofFromModel, TakesTheHighestFaceWhereSeveralOverlapAndCutsOffWhatHangsOut) {
  HouseModel model = gabled();
  for (auto& f : model.tops)
    for (auto& p : f.rings[0]) p.at.x += p.at.x == 0 ? -600 : 600;               // gable overhang
  model.tops.push_back(face({{4, 3, 9}, {5, 3, 9}, {5, 4.5, 9}, {4, 4.5, 9}}));  // a chimney over the ridge
  std::string fault;
  const auto roof = roof_from_model(kPlan, model, fault);
  ASSERT_TRUE(roof) << fault;
  EXPECT_NEAR(up_at(roof->roof, 4.51, 3.52), 9, 1e-3);
  EXPECT_NEAR(up_at(roof->roof, 8.01, 2.03), 5 + 2.03 * 0.75, 1e-3);
  EXPECT_TRUE(std::isnan(up_at(roof->roof, -0.3, 4)));
}

TEST(RoofFromModel, FollowsTheNearestFaceWhereTheWallWasMoved) {
  const Polygon moved{ring_of({{0, 0}, {12.03, 0}, {12.02, 8}, {0, 8}}), {}};
  std::string fault;
  const auto roof = roof_from_model(moved, gabled(), fault);
  ASSERT_TRUE(roof) << fault;
  EXPECT_NEAR(up_at(roof->roof, 12.01, 2.0), 6.5, 0.02);
}

/// Where a slope's rim rises along a wall to a corner at which a third part ends, the wall's gable has no point of that
/// part.
TEST(RoofFromModel, PassesOtherLevelsOfACornerThatTheRimOnlyRisesTo) {
  const HouseModel model{{face({{0, 0, 5}, {6, 0, 8}, {6, 8, 8}, {0, 8, 5}}),
                          face({{6, 0, 6.5}, {9, 0, 6.5}, {9, 8, 6.5}, {6, 8, 6.5}}),
                          face({{9, 0, 5.5}, {12, 0, 7}, {12, 8, 7}, {9, 8, 5.5}}),
                          face({{5, 0, 7.2}, {6, 0, 7.2}, {6, 1, 7.2}, {5, 1, 7.2}})}};
  std::string fault;
  const auto roof = roof_from_model(kPlan, model, fault);
  ASSERT_TRUE(roof) << fault;
  EXPECT_NEAR(up_at(roof->roof, 3.01, 4.02), 6.505, 1e-3);
  EXPECT_NEAR(up_at(roof->roof, 7.51, 4.02), 6.5, 1e-3);
}

/// Built wherever one looks as high as the model, but for the 5 cm round a point.
void expect_as_model(const HouseModel& model, double notch_x = -1, double notch_y = -1) {
  std::string fault;
  const auto roof = roof_from_model(kPlan, model, fault);
  ASSERT_TRUE(roof) << fault;
  for (double x = 0.11; x < 12; x += 0.37)
    for (double y = 0.13; y < 8; y += 0.41)
      if (std::hypot(x - notch_x, y - notch_y) > 0.06) {
        EXPECT_NEAR(up_at(roof->roof, x, y), model_up_at(model, x, y), 0.01) << x << ", " << y;
      }
}

TEST(RoofFromModel, CutsThePlanWhereFacesCrossWithoutAnEdge) {
  expect_as_model(
      {{face({{0, 0, 3}, {12, 0, 9}, {12, 8, 9}, {0, 8, 3}}), face({{0, 0, 9}, {12, 0, 3}, {12, 8, 3}, {0, 8, 9}})}});
}

TEST(RoofFromModel, LetsGoWhereHighAndLowPartsMeetLikeAChessboard) {
  expect_as_model(
      {{face({{0, 0, 8}, {6, 0, 8}, {6, 4, 8}, {0, 4, 8}}), face({{6, 0, 5}, {12, 0, 5}, {12, 4, 5}, {6, 4, 5}}),
        face({{0, 4, 5}, {6, 4, 5}, {6, 8, 5}, {0, 8, 5}}), face({{6, 4, 8}, {12, 4, 8}, {12, 8, 8}, {6, 8, 8}})}},
      6, 4);
}

TEST(RoofFromModel, HasItsEaveBelowAnInnerCourtThatIsLowerThanTheRim) {
  expect_as_model(
      {{face({{0, 0, 7}, {12, 0, 7}, {12, 3, 7}, {0, 3, 7}}), face({{0, 5, 7}, {12, 5, 7}, {12, 8, 7}, {0, 8, 7}}),
        face({{0, 3, 7}, {4, 3, 7}, {4, 5, 7}, {0, 5, 7}}), face({{8, 3, 7}, {12, 3, 7}, {12, 5, 7}, {8, 5, 7}}),
        face({{4, 3, 4}, {8, 3, 4}, {8, 5, 4}, {4, 5, 4}})}});
}

TEST(RoofFromModel, SaysWhyItCannotBeUsed) {
  std::string fault;
  HouseModel half{{face({{0, 0, 5}, {6, 0, 5}, {6, 8, 5}, {0, 8, 5}})}};
  EXPECT_FALSE(roof_from_model(kPlan, half, fault));
  EXPECT_EQ(fault, "it covers only 50 % of the footprint");
  HouseModel low{{face({{0, 0, 0.2}, {12, 0, 0.2}, {12, 8, 3}, {0, 8, 3}})}};
  EXPECT_FALSE(roof_from_model(kPlan, low, fault));
  EXPECT_EQ(fault, "it comes down to the ground");
  EXPECT_FALSE(roof_from_model(kPlan, {}, fault));
}

/// Random roofs of boxes and gables that overlap: what is built is sound (roof_from_model checks it) and as high as the
/// model wherever one looks.
TEST(RoofFromModel, IsAsHighAsTheModelOnRandomHouses) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto in = [&](double a, double b) { return a + (b - a) * static_cast<double>(random()) / 4294967296.0; };
    const double turn = in(0, 3.14), w = in(8, 20), d = in(6, 15), s = std::sin(turn), c = std::cos(turn);
    const auto at = [&](double x, double y) { return std::array<double, 2>{c * x - s * y, s * x + c * y}; };
    const auto box = [&](double x0, double y0, double x1, double y1, double up, double up_back) {
      ModelFace f;
      f.rings.emplace_back();
      for (const auto& [x, y, z] : {std::array{x0, y0, up}, {x1, y0, up}, {x1, y1, up_back}, {x0, y1, up_back}}) {
        const auto p = at(x, y);
        f.rings[0].push_back({{lattice_mm(p[0]), lattice_mm(p[1])}, z});
      }
      return f;
    };
    HouseModel model;
    const double eave = in(3, 12);
    if (seed % 2 == 0) {
      model.tops.push_back(box(0, 0, w, d / 2, eave, eave + in(1, 5)));
      const double ridge = model.tops[0].rings[0][2].up_m;
      model.tops.push_back(box(0, d / 2, w, d, ridge, eave));
    } else {
      model.tops.push_back(box(0, 0, w, d, eave, eave));
    }
    for (unsigned k = random() % 4; k > 0; --k) {
      const double x = in(0, w - 2), y = in(0, d - 2);
      // The first may slope; the others are level and far above, so that no two pass through each other.
      const double up = eave + 5.5 + 2 * static_cast<double>(model.tops.size()) + in(0, 0.5);
      model.tops.push_back(box(x, y, in(x + 1, w), in(y + 1, d), up, model.tops.size() < 3 ? up + in(0, 1) : up));
    }
    Polygon plan;
    for (const auto& [x, y] : {std::array{0.0, 0.0}, {w, 0.0}, {w, d}, {0.0, d}}) {
      const auto p = at(x, y);
      plan.outer.push_back({lattice_mm(p[0]), lattice_mm(p[1])});
    }
    std::string fault;
    const auto roof = roof_from_model(plan, model, fault);
    ASSERT_TRUE(roof) << fault;
    EXPECT_EQ(fault_of_roof(plan, roof->eave_m, roof->roof), std::nullopt);
    int looked = 0, off = 0;
    for (int k = 0; k < 400; ++k) {
      const auto p = at(in(0.01, w - 0.01), in(0.01, d - 0.01));
      const double got = up_at(roof->roof, p[0], p[1]), want = model_up_at(model, p[0], p[1]);
      ++looked;
      // A millimetre of noding may put a place on the other side of a step.
      off += !(std::abs(got - want) < 0.01);
    }
    EXPECT_LE(off, looked / 100) << turn;
  }
}

}  // namespace
}  // namespace vicus::test
