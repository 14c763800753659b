#include <gtest/gtest.h>

#include "city_db/store.hpp"
#include "tests/support/city_equal.hpp"
#include "tests/support/sample_interior.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

TEST(StoreInteriors, ComeBackAsTheyWere) {
  test::ScratchDirectory scratch;
  City city = test::sample_city_with_interior();
  write_city(scratch / "city.gpkg", city, nullptr);
  City read = read_city(scratch / "city.gpkg");
  city.textures.clear();  // they are artefacts
  EXPECT_EQ(test::difference(city, read), "");
  EXPECT_EQ(read.interiors.size(), 2u);
}

TEST(StoreInteriors, AreReadOneByOne) {
  test::ScratchDirectory scratch;
  const City city = test::sample_city_with_interior();
  write_city(scratch / "city.gpkg", city, nullptr);
  const CityReader reader(scratch / "city.gpkg");
  ASSERT_TRUE(reader.interior("kitchen"));
  EXPECT_TRUE(*reader.interior("kitchen") == city.interiors[1]);
  EXPECT_FALSE(reader.interior("s-yard"));
  EXPECT_FALSE(reader.sector("kitchen")) << "an interior is no sector of the streets";
  EXPECT_EQ(reader.doors_of("hall").size(), 2u);
  EXPECT_TRUE(reader.doors_of("hall").front() == city.doors[1]);
}

}  // namespace
}  // namespace vicus
