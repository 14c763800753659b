#include "cli/measure_results.hpp"

#include <gtest/gtest.h>

#include "city_db/issues.hpp"
#include "cli/measure_report.hpp"
#include "cli/measure_summary.hpp"

namespace vicus::measure {
namespace {

ViewRow view_row() {
  ViewRow row;
  row.city = "Saint \"X\", on the hill";
  row.version = "0.1.0";
  row.seed = 18446744073709551615u;
  row.family = "GLB, Draco", row.setting = "tau 4 px", row.tau_px = 4;
  row.path = "walk", row.view = 3, row.along_m = 33.25, row.width = 640, row.height = 480;
  row.bytes = 123456789012, row.requests = 17, row.new_bytes = 5, row.new_requests = 1, row.memory_bytes = 1.5e6;
  row.errors = {0.125, 1.5, 4, 0.75, 2.5, 30, 27.25, 0.875, 0.0625, 0.5, 0.1875};
  return row;
}

TEST(MeasuredCsv, ReadsBackWhatItWrote) {
  const std::string text = csv_of(std::vector{view_row(), ViewRow{}});
  const auto rows = views_from_csv(text);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(csv_of(rows), text);
  EXPECT_EQ(rows[0].city, "Saint \"X\", on the hill");
  EXPECT_EQ(rows[0].seed, 18446744073709551615u);
  EXPECT_EQ(rows[0].bytes, 123456789012u);
  EXPECT_EQ(rows[0].errors.flip_houses, 0.1875);
  const std::string times = csv_of(std::vector<TimeRow>{{"LOD3", "", "fly", 2, 640, 480, 1.5, 250}});
  EXPECT_NE(times.find(",gpu_ms\n"), std::string::npos);
  EXPECT_EQ(csv_of(times_from_csv(times)), times);
  const std::string pops = csv_of(std::vector<PopRow>{{"LOD3", "x", "fly", 640, 480, 2.5, 7, 0.5, 0.125}});
  EXPECT_EQ(csv_of(pops_from_csv(pops)), pops);
  EXPECT_EQ(pops_from_csv(pops)[0].excess(), 0.375);
  const std::string codecs = csv_of(std::vector<CodecRow>{{"tiles", "PNG, palette", "4 colours", 100.5, 0.25, 3}});
  EXPECT_EQ(csv_of(codecs_from_csv(codecs)), codecs);
}

TEST(MeasuredCsv, SaysWhatIsWrong) {
  const std::string text = csv_of(std::vector<CodecRow>{{"a", "b", "c", 1, 2, 3}});
  EXPECT_THROW(codecs_from_csv(""), CityError);
  EXPECT_THROW(codecs_from_csv("content,codec\na,b\n"), CityError);
  EXPECT_THROW(codecs_from_csv(text.substr(0, text.size() - 3)), CityError);
  std::string bad = text;
  bad.replace(bad.find("\na,") + 1, 1, "\"a");
  EXPECT_THROW(codecs_from_csv(bad), CityError);
  bad = text;
  bad.replace(bad.rfind('1'), 1, "x");
  EXPECT_THROW(codecs_from_csv(bad), CityError);
}

TEST(Summaries, AreMeansOfViewsAndSumsOfPaths) {
  Results results;
  for (int i = 0; i < 4; ++i) {
    ViewRow row = view_row();
    row.view = i;
    row.bytes = 100u * static_cast<unsigned>(i + 1), row.new_bytes = i == 0 ? 100 : 50;
    row.errors.flip = 0.1 * i;
    row.errors.depth_max_px = i;
    results.views.push_back(row);
    results.times.push_back({row.family, row.setting, row.path, i, row.width, row.height, 2, 10.0 * i});
  }
  results.pops = {{"GLB, Draco", "tau 4 px", "walk", 640, 480, 1, 9, 0.5, 0.25},
                  {"GLB, Draco", "tau 4 px", "walk", 640, 480, 2, 9, 0.1, 0.25}};
  const auto all = summaries_of(results);
  ASSERT_EQ(all.size(), 1u);
  const Summary& s = all[0];
  EXPECT_EQ(s.views, 4u);
  EXPECT_DOUBLE_EQ(s.bytes, 250);
  EXPECT_DOUBLE_EQ(s.path_bytes, 250);
  EXPECT_NEAR(s.errors.flip, 0.15, 1e-12);
  EXPECT_DOUBLE_EQ(s.errors.depth_max_px, 3);
  EXPECT_DOUBLE_EQ(s.errors.silhouette_iou, 0.75);
  EXPECT_DOUBLE_EQ(s.draw_cpu_ms, 15);
  EXPECT_DOUBLE_EQ(s.decode_cpu_ms, 2);
  EXPECT_EQ(s.switches, 9);
  EXPECT_DOUBLE_EQ(s.pop_mean, 0.125);
  EXPECT_DOUBLE_EQ(s.pop_most, 0.25);
}

TEST(RunFacts, SurviveTheirJson) {
  RunFacts facts;
  facts.city = "A \"town\"";
  facts.seed = 7;
  facts.walk_m = 400;
  const RunFacts back = facts_from_json(json_of(facts));
  EXPECT_EQ(json_of(back), json_of(facts));
  EXPECT_EQ(back.city, facts.city);
  EXPECT_THROW(facts_from_json("{}"), CityError);
}

}  // namespace
}  // namespace vicus::measure
