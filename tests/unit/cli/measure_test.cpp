#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/unit/cli/run_program.hpp"

namespace vicus {
namespace {

using test::read_bytes;
using test::vicus_program;

struct Town {
  Town() {
    EXPECT_EQ(vicus_program(scratch, "town --houses 30 --seed 3 -o " + path("town.osm")).rc, 0);
    EXPECT_EQ(vicus_program(scratch, "build " + path("town.osm") + " -o " + path("town.gpkg") + " --quiet").rc, 0);
  }
  test::Outcome measure(const std::string& arguments) const {
    return vicus_program(scratch, "measure " + path("town.gpkg") + " " + arguments);
  }
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  test::ScratchDirectory scratch;
};

TEST(VicusMeasure, MeasuresAndDrawsTheSameTwice) {
  const Town town;
  const std::string small =
      "--views 4 --size 96x64 --size 160x120:1 --samples 1 --no-codecs --tau 4 --as "
      "full,lod1,page,gates,prisms,blockmap32 --json ";
  const auto one = town.measure(small + "--threads 1 -o " + town.path("one"));
  ASSERT_EQ(one.rc, 0) << one.errors;
  const auto two = town.measure(small + "--threads 3 -o " + town.path("two"));
  ASSERT_EQ(two.rc, 0) << two.errors;
  for (const char* file : {"views.csv", "pops.csv"})
    EXPECT_EQ(read_bytes(town.path(std::string("one/") + file)), read_bytes(town.path(std::string("two/") + file)))
        << file;
  const auto object = nlohmann::json::parse(one.out);
  EXPECT_EQ(object["representations"], 8);
  // On foot 2 + 1 views of 8 ways, in flight 2 + 1 and one overview of each size of 4 ways.
  EXPECT_EQ(object["pictures"], 3 * 8 + 5 * 4);
  for (const auto& [path, front] : object["pareto"].items()) {
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_GT(front[i]["bytes"], front[i - 1]["bytes"]) << path;
      EXPECT_LT(front[i]["flip"], front[i - 1]["flip"]) << path;
    }
  }
  const std::string page = read_bytes(town.path("one/index.html"));
  EXPECT_NE(page.find("data:image/webp;base64,"), std::string::npos);
  ASSERT_TRUE(std::filesystem::exists(town.path("one/plots/fly-bytes.svg")));
  std::filesystem::remove(town.path("one/index.html"));
  ASSERT_EQ(town.measure("--redraw -o " + town.path("one")).rc, 0);
  EXPECT_EQ(read_bytes(town.path("one/index.html")), page);
}

TEST(VicusMeasure, SaysWhatIsWrong) {
  const Town town;
  const auto expect = [&](const std::string& arguments, int rc, const char* said) {
    const auto outcome = town.measure(arguments + " -o " + town.path("no"));
    EXPECT_EQ(outcome.rc, rc) << arguments;
    EXPECT_NE(outcome.errors.find(said), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(town.path("no/index.html")));
  };
  expect("--size 640", 2, "--size 640: expected WIDTHxHEIGHT");
  expect("--size 640x480:0", 2, "--size 640x480:0: expected");
  expect("--as lod7", 2, "expected one of full");
  expect("--tau 0", 2, "--tau");
  expect("--redraw", 1, "--redraw needs the folder of an earlier run");
}

}  // namespace
}  // namespace vicus
