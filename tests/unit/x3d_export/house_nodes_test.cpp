#include "x3d_export/house_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace vicus
