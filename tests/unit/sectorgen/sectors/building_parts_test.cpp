#include "sectorgen/sectors/building_parts.hpp"

#include <algorithm>
#include <random>

#include "city_db/house_parts.hpp"
#include "sectorgen/geo/shared_area.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Houses given in parts: Simple 3D Buildings.
namespace vicus::test {
namespace {

Footprint part(const std::string& id, Polygon area, double base_m, double height_m) {
  Footprint f = house(id, std::move(area));
  f.is_part = true;
  f.base_m = base_m;
  f.height_m = f.eave_m = height_m;
  f.height_source = HeightSource::measured;
  f.tags["building:part"] = "yes";
  return f;
}

Footprint outline(Polygon area, double height_m) {
  Footprint f = house("outline", std::move(area));
  f.height_m = f.eave_m = height_m;
  f.height_source = HeightSource::measured;
  f.tags["building"] = "church";
  return f;
}

std::vector<HouseColumn> columns_of(const std::vector<Footprint>& footprints) {
  SourceMap map;
  map.footprints = footprints;
  return BuildingParts(map).columns_of(0);
}

const HouseColumn* column(const std::vector<HouseColumn>& columns, std::uint32_t footprint) {
  for (const auto& c : columns)
    if (c.footprint == footprint) return &c;
  return nullptr;
}

double area_of(const std::vector<HouseColumn>& columns, std::uint32_t footprint) {
  double sum = 0;
  for (const auto& c : columns)
    if (c.footprint == footprint) sum += area_m2(c.area);
  return sum;
}

TEST(BuildingParts, ATowerCutsThePodium) {
  const auto columns = columns_of({outline(box(0, 0, 40, 20), 50), part("podium", box(0, 0, 40, 20), 0, 8),
                                   part("tower", box(10, 5, 20, 15), 8, 50)});
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_NEAR(area_of(columns, 1), 700, 0.01);
  EXPECT_NEAR(area_of(columns, 2), 100, 0.01);
  EXPECT_EQ(column(columns, 2)->base_m, 0);  // the podium bears it: one solid from the ground up
  EXPECT_EQ(column(columns, 2)->top_m, 50);
  EXPECT_TRUE(column(columns, 1)->is_main);
  EXPECT_FALSE(column(columns, 2)->is_main);
}

TEST(BuildingParts, TheOutlineStandsWhereAMapGivesTheTowerOnly) {
  const auto columns = columns_of({outline(box(0, 0, 40, 20), 50), part("tower", box(10, 5, 20, 15), 12, 50)});
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(column(columns, 0)->top_m, 12);
  EXPECT_NEAR(area_of(columns, 0), 700, 0.01);
  EXPECT_EQ(column(columns, 1)->base_m, 0);
}

TEST(BuildingParts, ASpireOnATowerIsItsRoof) {
  std::vector<Footprint> footprints{outline(box(0, 0, 30, 10), 60), part("nave", box(0, 0, 20, 10), 0, 20),
                                    part("tower", box(20, 0, 30, 10), 0, 40),
                                    part("spire", box(20, 0, 30, 10), 40, 60)};
  footprints[3].roof_shape = "pyramidal";
  footprints[3].eave_m = 40;
  const auto columns = columns_of(footprints);
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(column(columns, 2), nullptr);
  EXPECT_EQ(column(columns, 3)->base_m, 0);
  EXPECT_EQ(column(columns, 3)->eave_m, 40);
}

TEST(BuildingParts, ARidgeTurretDoesNotCutTheRoofItStandsIn) {
  std::vector<Footprint> footprints{outline(box(0, 0, 30, 12), 30), part("nave", box(0, 0, 30, 12), 0, 20),
                                    part("turret", box(14, 5, 16, 7), 17, 30)};
  footprints[1].roof_shape = "gabled";
  footprints[1].eave_m = 12;
  const auto columns = columns_of(footprints);
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_NEAR(area_of(columns, 1), 360, 0.01);
  EXPECT_EQ(column(columns, 2)->base_m, 12);  // down to the eave, inside the roof
}

TEST(BuildingParts, AnArcadeIsOpenWhereThePartsAreComplete) {
  const auto columns = columns_of({outline(box(0, 0, 40, 20), 20), part("house", box(0, 4, 40, 20), 0, 20),
                                   part("above", box(0, 0, 40, 4), 4, 20)});
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(column(columns, 2)->base_m, 4);
}

TEST(BuildingParts, ARoofOnColumnsHangsOverThePodium) {
  const auto columns = columns_of({outline(box(0, 0, 20, 20), 20), part("podium", box(0, 0, 20, 20), 0, 5),
                                   part("column", box(2, 2, 3, 3), 5, 15), part("roof", box(2, 2, 18, 18), 15, 20)});
  EXPECT_EQ(column(columns, 2)->base_m, 0);
  EXPECT_NEAR(area_of(columns, 1), 399, 0.01);
  EXPECT_EQ(column(columns, 3)->base_m, 15);
}

TEST(BuildingParts, AHouseWithinALargerOneIsAPartOfIt) {
  SourceMap map;
  map.footprints = {outline(box(10, 5, 20, 15), 30), outline(box(0, 0, 40, 20), 3),
                    part("turret", box(12, 8, 14, 10), 30, 40), outline(box(38, 0, 48, 20), 8)};
  const BuildingParts parts(map);
  EXPECT_TRUE(parts.is_part(0));
  EXPECT_TRUE(parts.is_part(2));
  EXPECT_FALSE(parts.is_part(1));
  EXPECT_FALSE(parts.is_part(3));  // shares a fifth of its ground only
  const auto columns = parts.columns_of(1);
  EXPECT_NEAR(area_of(columns, 1), 700, 0.01);
  EXPECT_NEAR(area_of(columns, 0), 96, 0.01);
  EXPECT_NEAR(area_of(columns, 2), 4, 0.01);
  EXPECT_EQ(column(columns, 2)->base_m, 0);
}

TEST(BuildingParts, SlitsBetweenPartsClose) {
  const auto columns = columns_of({outline(box(0, 0, 40, 20), 20), part("west", box(0.1, 0, 19.9, 20), 0, 20),
                                   part("east", box(20.1, 0, 40, 19.8), 0, 15)});
  EXPECT_NEAR(area_of(columns, 1) + area_of(columns, 2), 800, 0.01);
  EXPECT_EQ(column(columns, 0), nullptr);
}

TEST(BuildingParts, APartWithoutAHeightIsAsHighAsItsHouse) {
  std::vector<Footprint> footprints{outline(box(0, 0, 40, 20), 50), part("half", box(0, 0, 20, 20), 0, 9)};
  footprints[1].height_source = HeightSource::guessed;
  EXPECT_EQ(column(columns_of(footprints), 1)->top_m, 50);
}

TEST(BuildingParts, ColumnsOnTheGroundFillTheOutlineOnce) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto number = [&](int least, int most) {
      return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
    };
    std::vector<Footprint> footprints{
        outline({{at(0, 0), at(40, 0), at(40, 30), at(20, 30), at(20, 20), at(0, 20)}, {}}, 60)};
    for (int i = number(1, 8); i > 0; --i) {
      const int west = number(-5, 35), south = number(-5, 25), base = number(0, 2) == 0 ? number(3, 30) : 0;
      footprints.push_back(part("part" + std::to_string(i),
                                box(west, south, west + number(1, 20), south + number(1, 20)), base,
                                base + number(3, 30)));
      if (number(0, 2) == 0) footprints.back().roof_shape = "gabled", footprints.back().eave_m -= 2;
    }
    const auto columns = columns_of(footprints);
    double on_ground = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const HouseColumn& c = columns[i];
      EXPECT_GT(c.top_m, c.base_m);
      if (c.base_m > 0) continue;
      on_ground += area_m2(c.area);
      for (std::size_t j = 0; j < i; ++j)
        if (columns[j].base_m <= 0) {
          EXPECT_LT(shared_area_m2(c.area, columns[j].area), 0.05) << i << " " << j;
        }
    }
    EXPECT_LE(on_ground, area_m2(footprints[0].area) + 0.05);
    if (std::none_of(footprints.begin() + 1, footprints.end(), [](const Footprint& f) { return f.base_m > 0; })) {
      EXPECT_GT(on_ground, area_m2(footprints[0].area) - 3);
    }
    EXPECT_EQ(std::count_if(columns.begin(), columns.end(), [](const auto& c) { return c.is_main; }), 1);
  }
}

TEST(BuildingParts, AreHousesOfTheCity) {
  SourceMap map = one_street();
  std::erase_if(map.footprints, [](const Footprint& f) { return f.source_id == "north5" || f.source_id == "north6"; });
  Footprint church = outline(box(50, 6, 70, 16), 40);
  church.name = "Saint Anna";
  church.tags["addr:housenumber"] = "7";
  map.footprints.push_back(church);
  map.footprints.push_back(part("nave", box(50, 6, 62, 16), 0, 15));
  map.footprints.push_back(part("tower", box(62, 6, 70, 16), 0, 40));
  map.footprints.back().tags["building:colour"] = "red";
  const City city = built(std::move(map));
  const auto found = [&](const std::string& source_id) {
    return std::find_if(city.buildings.begin(), city.buildings.end(),
                        [&](const Building& b) { return b.source_id == source_id; });
  };
  const auto nave = found("outline"), tower = found("tower");
  ASSERT_NE(nave, city.buildings.end());
  ASSERT_NE(tower, city.buildings.end());
  EXPECT_EQ(nave->name, "Saint Anna");
  EXPECT_EQ(nave->tags.at("addr:housenumber"), "7");
  EXPECT_EQ(tower->name, "");
  EXPECT_EQ(tower->tags.count("addr:housenumber"), 0u);
  EXPECT_EQ(tower->tags.at("building"), "church");
  EXPECT_EQ(nave->height_m, 15);
  EXPECT_EQ(tower->height_m, 40);
  const bool rises = std::any_of(tower->side_walls.begin(), tower->side_walls.end(),
                                 [](const SideWall& w) { return w.bottom_m == 15; });
  EXPECT_TRUE(rises);  // above the nave
  EXPECT_EQ(house_of(*nave), house_of(*tower));
  const auto upper =
      std::find_if(city.facades.begin(), city.facades.end(), [](const Facade& f) { return f.bottom_m > 0; });
  ASSERT_NE(upper, city.facades.end());  // with windows, and no door up there
  EXPECT_EQ(upper->building_id, tower->id);
  EXPECT_EQ(upper->sector_id, tower->sector_id);
  EXPECT_EQ(upper->bottom_m, 15);
  EXPECT_EQ(upper->door_bay, -1);
  EXPECT_EQ(std::count_if(city.facades.begin(), city.facades.end(), [](const Facade& f) { return f.bottom_m > 0; }), 1);
}

}  // namespace
}  // namespace vicus::test
