#include "x3d_export/house_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "tests/support/sample_city.hpp"
#include "x3d_export/city_index.hpp"

namespace vicus {
namespace {

/// A sector all of whose facades together have so many openings, or a few more.
struct Crowded {
  explicit Crowded(int openings) {
    for (Facade& f : city.facades) f.openings.clear();
    sector_id = city.facades.front().sector_id;
    Facade& f = city.facades.front();
    f.floors = 10;
    f.bays = 10;
    f.repeats = 1;
    f.door_bay = -1;
    f.has_shop = false;
    int others = -100;
    for (const Facade& g : city.facades) others += g.sector_id == sector_id ? g.floors * g.bays * g.repeats : 0;
    f.repeats = std::max(1, (openings - others + 99) / 100);
  }
  const Sector& sector() const {
    return *std::find_if(city.sectors.begin(), city.sectors.end(), [&](const Sector& s) { return s.id == sector_id; });
  }
  City city = test::sample_city_with_facades();
  std::string sector_id;
};

std::size_t faces_of(const LevelFaces& faces) { return faces.solid.size() + faces.atlas.size(); }

TEST(HouseNodes, LeaveLevelsOutOfSectorsWithManyOpenings) {
  for (const auto& [openings, finest, has_quads] :
       {std::tuple(kMostDeepOpenings - 200, 4, true), {kMostDeepOpenings + 1, 3, true}, {kMostQuads + 1, 3, false}}) {
    SCOPED_TRACE(openings);
    const Crowded crowded(openings);
    const CityIndex index(crowded.city);
    EXPECT_EQ(finest_level(index, crowded.sector()), finest);
    std::size_t first = 0, second = 0;
    for (const LevelPiece& piece : sector_pieces(index, crowded.sector())) {
      first += faces_of(piece.levels[0]);
      second += faces_of(piece.levels[1]);
    }
    EXPECT_GT(first, 0u);
    if (has_quads)
      EXPECT_GT(second, first + static_cast<std::size_t>(openings) / 2);
    else
      EXPECT_EQ(second, first);
  }
}

/// Corners of all faces below a node, in order, as text; `points`: of the Coordinate nodes by DEF so far.
void collect_corners(const Node& node, std::map<std::string, std::vector<double>>& points,
                     std::vector<std::string>& out, int& coordinates) {
  const auto child = [&](std::string_view field) -> const Node* {
    for (const NodeField& f : node.nodes)
      if (f.name == field) return &f.nodes.front();
    return nullptr;
  };
  const auto field = [](const Node& from, std::string_view name) -> const FieldValue* {
    for (const Field& f : from.fields)
      if (f.name == name) return &f.value;
    return nullptr;
  };
  if (const Node* coordinate = child("coord")) {
    if (coordinate->use.empty()) {
      ++coordinates;
      points[coordinate->def] = std::get<std::vector<double>>(*field(*coordinate, "point"));
    }
    const auto& list = points.at(coordinate->use.empty() ? coordinate->def : coordinate->use);
    for (const std::int32_t i : std::get<std::vector<std::int32_t>>(*field(node, "coordIndex"))) {
      std::string corner;
      for (std::size_t k = 0; i >= 0 && k < 3; ++k)
        corner += std::to_string(list.at(3 * static_cast<std::size_t>(i) + k)) + " ";
      out.push_back(corner);
    }
  }
  for (const NodeField& f : node.nodes)
    for (const Node& n : f.nodes) collect_corners(n, points, out, coordinates);
}

TEST(HouseNodes, WriteTheCornersOfAllLevelsOnceAndShowTheSameFaces) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  std::size_t corners = 0;
  for (const Sector& sector : city.sectors) {
    const auto lods = house_nodes(index, sector, SceneFormat::x3d);
    std::vector<std::vector<Node>> alone(5);
    for (int level = 1; level <= 4; ++level)
      alone[static_cast<std::size_t>(level)] = house_nodes(index, sector, SceneFormat::x3d, level);
    const int finest = finest_level(index, sector);
    for (std::size_t i = 0; i < lods.size(); ++i) {
      SCOPED_TRACE(sector.id + " " + std::to_string(i));
      std::map<std::string, std::vector<double>> shared;
      int coordinates = 0;
      const auto& levels = lods[i].nodes.front().nodes;
      ASSERT_EQ(levels.size(), static_cast<std::size_t>(finest));
      for (int level = finest; level >= 1; --level) {
        std::vector<std::string> got, expected;
        collect_corners(levels[static_cast<std::size_t>(finest - level)], shared, got, coordinates);
        std::map<std::string, std::vector<double>> own;
        int own_coordinates = 0;
        collect_corners(alone[static_cast<std::size_t>(level)][i], own, expected, own_coordinates);
        EXPECT_EQ(got, expected) << level;
        corners += got.size();
      }
      EXPECT_EQ(coordinates, 1);
      EXPECT_EQ(shared.begin()->first, "CORNERS-" + std::to_string(i));
    }
  }
  EXPECT_GT(corners, 1000u);
}

}  // namespace
}  // namespace vicus
