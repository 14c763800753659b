#include <gtest/gtest.h>

#include "cli/measure_page_parts.hpp"
#include "cli/measure_plots.hpp"
#include "cli/measure_summary.hpp"

namespace vicus::measure {
namespace {

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++count;
  return count;
}

Results some_results() {
  Results results;
  results.facts.city = "A <town>";
  for (const char* path : {"walk", "fly"})
    for (const auto& [family, bytes, flip] : {std::tuple{"LOD3", 900'000, 0.02},
                                              {"prisms", 7'000, 0.3},
                                              {"prisms", 9'000, 0.25},
                                              {"far sectors", 990'000, 0.4}}) {
      ViewRow row;
      row.family = family, row.path = path, row.width = 640, row.height = 480;
      row.setting = std::string(family) == "prisms" ? "tau " + std::to_string(bytes) : "";
      row.bytes = static_cast<std::uint64_t>(bytes), row.memory_bytes = 3.0 * bytes;
      row.errors.flip = flip;
      results.views.push_back(row);
      results.times.push_back({row.family, row.setting, path, 0, 640, 480, 1, 100});
    }
  return results;
}

TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(BytesText, HasTheUnitThatFits) {
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(1500), "1.5 kB");
  EXPECT_EQ(bytes_text(123'456), "123 kB");
  EXPECT_EQ(bytes_text(2'460'000), "2.5 MB");
}

TEST(Plots, ShowEachPointOnceAndNameEverySeries) {
  const Results results = some_results();
  for (const auto& [path, svg] : plots_of(results)) {
    SCOPED_TRACE(path);
    EXPECT_EQ(count_of(svg, "<title>"), 4u);
    for (const char* name : {">LOD3</text>", ">prisms</text>", ">far sectors</text>", "A &lt;town&gt;"})
      EXPECT_NE(svg.find(name), std::string::npos) << name;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg.find("prefers-color-scheme:dark"), std::string::npos);
  }
  EXPECT_EQ(plots_of(results).size(), 6u);
}

TEST(Page, HoldsItsPicturesAndNeedsNoOtherFile) {
  const Results results = some_results();
  const std::string page = page_of(results, [](const std::string& path) {
    return path == picture_path("walk", 0, "truth", "") || path == picture_path("walk", 0, "LOD3", "") ? "foo" : "";
  });
  EXPECT_EQ(count_of(page, "data:image/webp;base64,Zm9v"), 2u);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("A &lt;town&gt;"), std::string::npos);
  EXPECT_NE(page.find("GPU time was not measured"), std::string::npos);
  // Of the ways on foot three are beaten by no other: two settings of prisms and LOD3.
  EXPECT_NE(page.find("3 of the 4 ways measured on foot are beaten by no other"), std::string::npos);
}

}  // namespace
}  // namespace vicus::measure
