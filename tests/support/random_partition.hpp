#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "city_db/city.hpp"

/// Random cities without any generator: a triangulated field whose triangles are dealt out to sectors, houses,
/// obstacles and the world outside. What covers what is known triangle by triangle.
namespace vicus::test {

/// side x side squares of 1 m, corners moved at random, each cut along a random diagonal.
struct Field {
  std::vector<PlanPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;   ///< counter-clockwise
  std::vector<std::array<std::uint32_t, 3>> neighbours;  ///< beyond edge k -> k + 1; kNoTriangle outside
  static constexpr std::uint32_t kNoTriangle = 0xffffffffu;
};
Field random_field(std::uint64_t seed, std::uint32_t side);

/// The polygon made of the triangles; `is_in` says which. Where it falls into parts, each becomes one polygon.
/// Rings may touch themselves at points. In `among` are all triangles that are in.
std::vector<Polygon> polygons_of(const Field& field, const std::vector<std::uint32_t>& among,
                                 const std::function<bool(std::uint32_t)>& is_in);

struct RandomCity {
  Field field;
  std::vector<std::uint32_t> region_of;               ///< per triangle
  std::vector<std::vector<std::uint32_t>> triangles;  ///< per region
  /// Per region what became of it; `index` into the city's list. outside: nothing.
  enum class Use { sector, house, obstacle, outside };
  struct Region {
    Use use;
    std::uint32_t index;
  };
  std::vector<Region> regions;
  City city;
};

/// A city that keeps every rule: every region grown edge by edge from a random triangle. Some houses get a second,
/// overlapping record. Equal seeds give equal cities.
RandomCity random_city(std::uint64_t seed, std::uint32_t side, std::uint32_t region_count);

}  // namespace vicus::test
