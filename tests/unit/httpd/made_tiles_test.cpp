#include "httpd/made_tiles.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/unit/httpd/served_city.hpp"

namespace vicus {
namespace {

TEST(MadeTiles, MakesATileOnceForManyAskers) {
  std::atomic<int> makes{0};
  MadeTiles tiles([&](const std::string& path) -> std::optional<MadeTile> {
    ++makes;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return MadeTile{"x/y", "bytes of " + path};
  });
  std::atomic<int> right{0};
  std::vector<std::thread> askers;
  for (int i = 0; i < 16; ++i)
    askers.emplace_back([&] { right += tiles.get("blockmaps/0/0/0", 1)->bytes == "bytes of blockmaps/0/0/0"; });
  for (auto& t : askers) t.join();
  EXPECT_EQ(makes, 1);
  EXPECT_EQ(right, 16);
  tiles.get("blockmaps/0/0/0", 1);
  EXPECT_EQ(makes, 1);
  tiles.get("blockmaps/0/0/0", 2);  // another file
  EXPECT_EQ(makes, 2);
}

TEST(MadeTiles, KeepsNothingOfTilesThatDoNotExistAndTriesAgainAfterAFailure) {
  int makes = 0;
  MadeTiles tiles([&](const std::string& path) -> std::optional<MadeTile> {
    ++makes;
    if (path == "bad" && makes < 3) throw std::runtime_error("the disk");
    if (path == "bad") return MadeTile{"x/y", "good"};
    return std::nullopt;
  });
  EXPECT_THROW(tiles.get("bad", 1), std::runtime_error);
  EXPECT_EQ(tiles.get("nowhere", 1), nullptr);
  EXPECT_EQ(tiles.get("nowhere", 1), nullptr);
  EXPECT_EQ(makes, 3);
  EXPECT_EQ(tiles.get("bad", 1)->bytes, "good");
}

TEST(MadeTiles, GivesUpWhatWasAskedForLongestAgo) {
  std::vector<std::string> made;
  MadeTiles tiles(
      [&](const std::string& path) -> std::optional<MadeTile> {
        made.push_back(path);
        return MadeTile{"x/y", std::string(100, 'x')};
      },
      250);
  for (const char* path : {"a", "b", "a", "c", "a", "b"}) tiles.get(path, 1);
  EXPECT_EQ(made, (std::vector<std::string>{"a", "b", "c", "b"}));
}

TEST(Routes, ServesTilesThatAreMadeWhenAskedFor) {
  test::ServedCity served;
  const auto tiles = std::make_shared<MadeTiles>([](const std::string& path) -> std::optional<MadeTile> {
    if (path != "blockmaps/1/0/0") return std::nullopt;
    return MadeTile{"application/vnd.vicus.blockmap", std::string(1000, 'b')};
  });
  Routes routes(served.path(), std::make_shared<const StaticFiles>(served.scratch / "x_ite"),
                std::make_shared<Metrics>(), tiles);
  HttpRequest request;
  request.method = "GET";
  request.target = "/blockmaps/1/0/0";
  const auto response = routes.respond(request);
  EXPECT_EQ(response.status, 200);
  ASSERT_TRUE(response.body);
  EXPECT_EQ(*response.body, std::string(1000, 'b'));
  request.target = "/blockmaps/1/9/9";
  EXPECT_EQ(routes.respond(request).status, 404);
  EXPECT_EQ(served.routes().respond(request).status, 404);
}

}  // namespace
}  // namespace vicus
