#include "x3d_export/svg_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sample_city.hpp"
#include "tests/support/x3d_text.hpp"
#include "x3d_export/svg_paper.hpp"

namespace vicus {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

TEST(SvgMap, DrawsEachPairOfGatesOnceAndEndsOfTheCity) {
  const City city = test::sample_city();
  std::size_t pairs = 0, ends = 0;
  for (const auto& g : city.gates) (g.twin_id.empty() ? ends : pairs)++;
  const auto svg = svg_map(city, {});
  // One more of each in the legend.
  EXPECT_EQ(count(svg, "stroke='#1e5fe0'"), ends + 1);
  EXPECT_EQ(count(svg, "stroke='#d42020'") + count(svg, "stroke='#0a9a3c'"), pairs / 2 + 2);
}

TEST(SvgMap, ColoursGateNeighboursDifferently) {
  const City city = test::sample_city();
  const auto svg = svg_map(city, {});
  const auto fills = test::attributes_in(svg, "path", "fill");
  // Domain and obstacles come first, then the sectors in the order of the city.
  const std::size_t first = city.domain.size() + city.obstacles.size();
  for (const auto& g : city.gates) {
    const auto number = [&](const std::string& id) {
      return static_cast<std::size_t>(
          std::find_if(city.sectors.begin(), city.sectors.end(), [&](const Sector& s) { return s.id == id; }) -
          city.sectors.begin());
    };
    if (g.to_sector_id.empty()) continue;
    EXPECT_NE(fills.at(first + number(g.sector_id)), fills.at(first + number(g.to_sector_id))) << g.id;
  }
}

TEST(SvgMap, LabelsWhenAskedAndEscapesNames) {
  const City city = test::sample_city();
  EXPECT_EQ(svg_map(city, {}).find("Zum &lt;Löwen&gt;"), std::string::npos);
  SvgOptions options;
  options.has_labels = true;
  const auto svg = svg_map(city, options);
  EXPECT_NE(svg.find("Zum &lt;Löwen&gt; &amp; Co"), std::string::npos);
  EXPECT_NE(svg.find(">s-yard<"), std::string::npos);
}

TEST(SvgMap, ShowsOnlyWhatMeetsTheBox) {
  const City city = test::sample_city();
  SvgOptions options;
  options.box = PlanBox{{12'000, 24'000}, {50'000, 34'000}};
  options.has_labels = true;
  const auto svg = svg_map(city, options);
  EXPECT_NE(svg.find(">s-yard<"), std::string::npos);
  EXPECT_EQ(svg.find(">s-south<"), std::string::npos);
}

TEST(SvgMap, ColoursTheListOfOneSectorByReason) {
  const City city = test::sample_city();
  SvgOptions options;
  options.lvis = "s-yard";
  options.box = PlanBox{{-70'000, -50'000}, {70'000, 50'000}};
  const auto svg = svg_map(city, options);
  const auto fills = test::attributes_in(svg, "path", "fill");
  const std::size_t first = city.domain.size() + city.obstacles.size();
  const char* const expected[] = {"#5fb35f", "#f7f5f0", "#5b9bd5", "#b4c9e4", "#f08c2e", "#f7f5f0", "#d42020"};
  for (std::size_t i = 0; i < std::size(expected); ++i)
    EXPECT_EQ(fills.at(first + i), expected[i]) << city.sectors[i].id;
  // The two houses seen over roofs, and one box each in the legend.
  EXPECT_EQ(count(svg, "fill='#1f3f8f'"), 2u);
  EXPECT_EQ(count(svg, "fill='#8092c4'"), 2u);
  for (const char* text :
       {"L_vis of s-yard (Löwenhof)<", ">gate 1<", ">in sight 0<", ">over roofs 1<", ">unresolved 1<", ">important 1<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(SvgMap, ShowsAListWithItsSurroundings) {
  SvgOptions options;
  options.lvis = "s-passage";
  options.has_labels = true;
  City city = test::sample_city();
  Sector far_away = city.sectors.front();
  far_away.id = "s-far";
  for (auto& p : far_away.ground.outer) p.x += 900'000;
  city.sectors.push_back(far_away);
  const auto svg = svg_map(city, options);
  EXPECT_NE(svg.find(">s-yard<"), std::string::npos);
  EXPECT_EQ(svg.find(">s-far<"), std::string::npos);
}

TEST(SvgMap, DrawsACityWithNothingInIt) {
  const auto svg = svg_map(City{}, {});
  EXPECT_NE(svg.find("0 sectors"), std::string::npos);
}

TEST(HslColour, AgreesWithKnownColours) {
  EXPECT_EQ(hsl_colour(0, 1, 0.5), "#ff0000");
  EXPECT_EQ(hsl_colour(120, 1, 0.5), "#00ff00");
  EXPECT_EQ(hsl_colour(240, 1, 0.5), "#0000ff");
  EXPECT_EQ(hsl_colour(60, 1, 0.25), "#808000");
  EXPECT_EQ(hsl_colour(200, 0, 0.5), "#808080");
}

}  // namespace
}  // namespace vicus
