#pragma once
#include <string>
#include <utility>
#include <vector>

#include "city_db/city.hpp"

/// Plans that roofs are tried on, metres.
namespace vicus::test {

inline Ring ring_of(std::vector<std::pair<double, double>> points) {
  Ring ring;
  for (const auto& [x, y] : points) ring.push_back({lattice_mm(x), lattice_mm(y)});
  return ring;
}

/// Simple plans, then nasty ones.
inline std::vector<std::pair<std::string, Polygon>> roof_plans() {
  const Ring yard = ring_of({{0, 0}, {30, 0}, {30, 20}, {0, 20}});
  return {
      {"rectangle", {ring_of({{0, 0}, {12, 0}, {12, 8}, {0, 8}}), {}}},
      {"square", {ring_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), {}}},
      {"triangle", {ring_of({{0, 0}, {11, 2}, {4, 9}}), {}}},
      {"trapezium", {ring_of({{0, 0}, {14, 0}, {11, 7}, {2, 8}}), {}}},
      {"L", {ring_of({{0, 0}, {14, 0}, {14, 7}, {6, 7}, {6, 16}, {0, 16}}), {}}},
      {"U", {ring_of({{0, 0}, {20, 0}, {20, 15}, {14, 15}, {14, 6}, {6, 6}, {6, 14}, {0, 14}}), {}}},
      {"T", {ring_of({{0, 0}, {18, 0}, {18, 6}, {12, 6}, {12, 15}, {6, 15}, {6, 6}, {0, 6}}), {}}},
      {"courtyard", {yard, {ring_of({{8, 6}, {8, 14}, {22, 14}, {22, 6}})}}},
      {"hole that touches its ring",
       {ring_of({{0, 0}, {30, 0}, {30, 20}, {15, 20}, {0, 20}}), {ring_of({{8, 6}, {15, 20}, {22, 6}})}}},
      {"points on the sides",
       {ring_of({{0, 0}, {3, 0}, {7.123, 0}, {12, 0}, {12, 4.001}, {12, 8}, {5, 8}, {0, 8}, {0, 3}}), {}}},
      {"near parallel edges", {ring_of({{0, 0}, {6, 0.004}, {12, 0}, {12.003, 8}, {5, 8.011}, {0.002, 8}}), {}}},
      {"step of a centimetre", {ring_of({{0, 0}, {6, 0}, {6, 0.01}, {12, 0.01}, {12, 8}, {0, 8}}), {}}},
      {"sliver", {ring_of({{0, 0}, {20, 0.02}, {20, 0.3}, {0, 0.25}}), {}}},
      {"star", {ring_of({{0, 0}, {5, 3}, {10, 0}, {7, 5}, {10, 10}, {5, 7}, {0, 10}, {3, 5}}), {}}},
      {"comb",
       {ring_of({{0, 0},
                 {20, 0},
                 {20, 9},
                 {18, 9},
                 {18, 3},
                 {14, 3},
                 {14, 9},
                 {12, 9},
                 {12, 3},
                 {8, 3},
                 {8, 9},
                 {6, 9},
                 {6, 3},
                 {2, 3},
                 {2, 9},
                 {0, 9}}),
        {}}},
      {"two yards",
       {yard, {ring_of({{4, 4}, {4, 16}, {13, 16}, {13, 4}}), ring_of({{17, 4}, {17, 16}, {26, 16}, {26, 4}})}}},
  };
}

}  // namespace vicus::test
