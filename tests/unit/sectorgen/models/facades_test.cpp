#include "sectorgen/models/facades.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "city_db/facade_layout.hpp"
#include "sectorgen/models/facade_choice.hpp"

namespace vicus {
namespace {

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// One house, 12 m wide to a street in the south and 8 m to a yard in the north; a short stretch in the west.
City one_house(double eave_m = 9.5) {
  City city;
  for (const auto& [id, kind] : {std::pair{"street", SectorKind::street}, {"yard", SectorKind::yard}}) {
    Sector s;
    s.id = id;
    s.kind = kind;
    city.sectors.push_back(s);
  }
  Building house;
  house.id = "h";
  house.sector_id = "street";
  house.height_m = eave_m + 3;
  house.eave_m = eave_m;
  house.tags = {{"building", "house"}};
  city.buildings.push_back(house);
  city.borders = {{"street", "h", BorderKind::facade, 0, {at(12, 0), at(7, 0), at(0, 0), at(0, 2)}},
                  {"yard", "h", BorderKind::facade, 0, {at(0, 10), at(8, 10)}},
                  {"yard", "", BorderKind::wall, 2, {at(8, 10), at(20, 10)}}};
  return city;
}

const Facade& facade_in(const City& city, const std::string& sector) {
  return *std::find_if(city.facades.begin(), city.facades.end(),
                       [&](const Facade& f) { return f.sector_id == sector; });
}

TEST(LayOutFacades, OneForEachStraightStretchOf3mAndMore) {
  City city = one_house();
  lay_out_facades(city);
  ASSERT_EQ(city.facades.size(), 2u);
  const Facade& front = facade_in(city, "street");
  EXPECT_EQ(front.a, at(12, 0));
  EXPECT_EQ(front.b, at(0, 0));
  EXPECT_EQ(front.top_m, 9.5);
  EXPECT_EQ(front.floors, 3);
  EXPECT_EQ(front.bays, 5);
}

TEST(LayOutFacades, TheDoorIsInTheStreetFrontUnlessTheMapHasOne) {
  City city = one_house();
  lay_out_facades(city);
  EXPECT_EQ(facade_in(city, "street").door_bay, 2);
  EXPECT_EQ(facade_in(city, "yard").door_bay, -1);
  city.objects.push_back({"d", "yard", "door", "", at(7.5, 9.8), 0, 0, 0, {}, {}});
  lay_out_facades(city);
  EXPECT_EQ(facade_in(city, "street").door_bay, -1);
  EXPECT_EQ(facade_in(city, "yard").door_bay, 0) << "from the left seen from the north is the east";
}

TEST(LayOutFacades, AShopIsInTheFacadeNearestToIt) {
  City city = one_house();
  city.objects.push_back({"s", "street", "shop", "Bakery", at(5, 3), 0, 0, 0, {}, {}});
  lay_out_facades(city);
  EXPECT_TRUE(facade_in(city, "street").has_shop);
  EXPECT_FALSE(facade_in(city, "yard").has_shop);
}

TEST(LayOutFacades, HousesOverPassagesAndUnknownHousesHaveNone) {
  City city = one_house();
  city.buildings[0].base_m = 3;
  lay_out_facades(city);
  EXPECT_TRUE(city.facades.empty());
  city = one_house();
  city.buildings[0].id = "other";
  lay_out_facades(city);
  EXPECT_TRUE(city.facades.empty());
}

TEST(LayOutFacades, LongOnesRepeatTheirPattern) {
  City city = one_house();
  city.borders = {{"street", "h", BorderKind::facade, 0, {at(100, 0), at(0, 0)}}};
  lay_out_facades(city);
  ASSERT_EQ(city.facades.size(), 1u);
  EXPECT_EQ(city.facades[0].repeats, 5);
  EXPECT_EQ(city.facades[0].bays, 8);
}

TEST(LayOutFacades, WallsBetweenPartsOfAModelsRoofHaveItsWindows) {
  City city = one_house(4);
  Building& house = city.buildings[0];
  house.source_id = "model";
  // 5 m behind the street's front the house goes on to 10 m; the low roof before that wall rises to 5 and to 6 m.
  const auto up = [](double m) { return static_cast<std::int32_t>(std::lround(m * kRoofStepsPerMetre)); };
  house.roof.points = {{at(0, 5), up(5)},  {at(6, 5), up(6)},  {at(6, 5), up(10)},
                       {at(0, 5), up(10)}, {at(12, 5), up(5)}, {at(12, 5), up(10)}};
  house.roof.facets = {{FacetKind::step, {{0, 1, 2, 3}}, {}}, {FacetKind::step, {{1, 4, 5, 2}}, {}}};
  const auto window = [](double x0, double x1, double z0, double z1) {
    return ModelOpening{false, {{at(x0, 5), z0}, {at(x1, 5), z0}, {at(x1, 5), z1}, {at(x0, 5), z1}}};
  };
  HouseModel model;
  model.openings = {window(1, 2, 7, 9), window(5.5, 6.5, 7, 9), window(3, 4, 11, 12)};  // the last stands above it
  lay_out_facades(city, {{"model", model}});
  ASSERT_EQ(city.facades.size(), 1u) << "walls without windows have none";
  const Facade& f = city.facades[0];
  EXPECT_EQ(f.sector_id, "street");
  EXPECT_EQ(f.a, at(12, 5));
  EXPECT_EQ(f.b, at(0, 5));
  EXPECT_EQ(f.bottom_m, 6);
  EXPECT_EQ(f.top_m, 10);
  ASSERT_EQ(f.openings.size(), 2u);
  EXPECT_NEAR(f.openings[0].x0, 1, 1e-9);
  EXPECT_NEAR(f.openings[0].z0, 1, 1e-9) << "above the facade's bottom";
  EXPECT_NEAR(f.openings[1].x1, 6.5, 1e-9) << "over both pieces of the wall";
}

TEST(FloorsOf, AreAsTaggedWhereThatIsPossible) {
  Building house;
  house.tags["building:levels"] = "4";
  EXPECT_EQ(floors_of(house, FacadeStyle::plaster, 12), 4);
  EXPECT_EQ(floors_of(house, FacadeStyle::plaster, 40), 13) << "4 storeys of 10 m are no storeys";
  house.tags["building:levels"] = "nonsense";
  EXPECT_EQ(floors_of(house, FacadeStyle::plaster, 9.5), 3);
  EXPECT_EQ(floors_of(house, FacadeStyle::church, 30), 1);
}

TEST(StyleOf, ComesFromTagsElseFromHeightSteadyById) {
  const auto with = [](Tags tags) {
    Building house;
    house.eave_m = 8;
    house.tags = std::move(tags);
    return style_of(house, region_style({}));
  };
  EXPECT_EQ(with({{"building", "church"}}), FacadeStyle::church);
  EXPECT_EQ(with({{"building", "yes"}, {"amenity", "place_of_worship"}}), FacadeStyle::church);
  EXPECT_EQ(with({{"building", "garage"}}), FacadeStyle::shed);
  EXPECT_EQ(with({{"building", "office"}}), FacadeStyle::modern);
  EXPECT_EQ(with({{"building:material", "brick"}}), FacadeStyle::brick);
  std::set<FacadeStyle> low, high;
  for (int i = 0; i < 100; ++i) {
    Building house;
    house.id = std::to_string(i);
    house.eave_m = 8;
    EXPECT_EQ(style_of(house, region_style({})), style_of(house, region_style({})));
    low.insert(style_of(house, region_style({})));
    house.eave_m = 18;
    high.insert(style_of(house, region_style({})));
  }
  EXPECT_EQ(low, (std::set{FacadeStyle::plaster, FacadeStyle::brick}));
  EXPECT_EQ(high, (std::set{FacadeStyle::plaster, FacadeStyle::stone}));
}

TEST(PaintTextures, OnePictureServesAllFacadesThatLookAlike) {
  City city = one_house();
  Building twin = city.buildings[0];
  twin.id = "twin";
  city.buildings.push_back(twin);
  city.borders.push_back({"street", "twin", BorderKind::facade, 0, {at(30, 0), at(18, 0)}});
  lay_out_facades(city);
  for (auto& house : city.buildings) house.wall_colour = {200, 180, 160};
  for (auto& facade : city.facades) facade.style = FacadeStyle::plaster;
  city.facades.back().door_bay = 4;
  paint_textures(city, 2);
  std::set<std::string> ids;
  for (const auto& t : city.textures) {
    ids.insert(t.id);
    EXPECT_EQ(t.png.substr(1, 3), "PNG");
  }
  EXPECT_EQ(ids.size(), 4u) << "12 m, 8 m, the atlas and the ground's grain";
  EXPECT_TRUE(ids.contains(city.meta["grain"]));
  EXPECT_TRUE(ids.contains(city.meta["atlas"]));
  for (const auto& facade : city.facades) EXPECT_TRUE(ids.contains(facade.texture));
  const auto once = city.textures.front().png;
  paint_textures(city, 1);
  EXPECT_EQ(city.textures.front().png, once) << "the same for any number of threads";
}

}  // namespace
}  // namespace vicus
