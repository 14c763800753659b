#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "city_db/store.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/unit/cli/run_program.hpp"

namespace vicus {
namespace {

using test::read_bytes;
using test::vicus_program;

struct Sample {
  Sample() { write_city(scratch / "city.gpkg", test::sample_city(), nullptr); }
  test::Outcome run(const std::string& arguments) const {
    return vicus_program(scratch, "render '" + (scratch / "city.gpkg").string() + "' " + arguments);
  }
  std::string path(const char* name) const { return "'" + (scratch / name).string() + "'"; }
  test::ScratchDirectory scratch;
};

constexpr const char* kView = "--eye=-40,0,1.7 --look=-40,5,2 --size 64x48 --samples 4 ";

TEST(VicusRender, WritesEqualBytesForEqualInput) {
  const Sample sample;
  const auto one = sample.run(std::string(kView) + "--threads 1 --json -o " + sample.path("1.png"));
  ASSERT_EQ(one.rc, 0) << one.errors;
  const auto object = nlohmann::json::parse(one.out);
  EXPECT_EQ(object["width"], 64);
  EXPECT_GT(object["triangles"], 50);
  ASSERT_EQ(
      sample.run(std::string(kView) + "--threads 3 -o " + sample.path("2.png") + " --depth " + sample.path("2.pfm")).rc,
      0);
  const auto first = read_bytes(sample.scratch / "1.png");
  EXPECT_EQ(first, read_bytes(sample.scratch / "2.png"));
  EXPECT_EQ(first.substr(1, 3), "PNG");
  EXPECT_EQ(read_bytes(sample.scratch / "2.pfm").substr(0, 9), "Pf\n64 48\n");
}

TEST(VicusRender, SaysWhatIsWrongAndWritesNothing) {
  const Sample sample;
  const auto expect = [&](const std::string& arguments, const char* said) {
    const auto outcome = sample.run(arguments + " -o " + sample.path("no.png"));
    EXPECT_EQ(outcome.rc, 2) << arguments;
    EXPECT_NE(outcome.errors.find(said), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(sample.scratch / "no.png"));
  };
  expect("--eye 1,2 --look 1,2,3", "--eye 1,2: expected EAST,NORTH,UP");
  expect("--eye 1,2,3 --look nowhere", "--look nowhere: expected");
  expect("--eye 1,2,3 --look 1,2,3", "same place");
  expect("--eye 1,2,3 --look 1,2,4 --size 0x10", "--size 0x10");
  expect("--eye 1,2,3 --look 1,2,4 --as lod7", "lod7");
}

}  // namespace
}  // namespace vicus
