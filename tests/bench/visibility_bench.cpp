// Line of sight in plan: time, steps and size of the lists. Over roofs: CPU time against what stays unresolved, by how
// far eyes and walls are told apart.
// usage: [EVERY=n] [LEAST=m] visibility_bench INPUT...     a map; EVERY: over roofs each n-th sector only
//                                                          (0: none), LEAST: only this least radius
//        visibility_bench city CITY.gpkg                   the same for a city file
//        visibility_bench grid CROSSROADS NICHES           a jittered grid of streets, line of sight only
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "city_db/store.hpp"
#include "sectorgen/visibility/line_of_sight.hpp"
#include "sectorgen/visibility/look_map.hpp"
#include "sectorgen/visibility/over_roofs.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/grid_city.hpp"

namespace {

using namespace vicus;

double number_from(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atof(text);
}

std::size_t pairs_of(const SightLists& lists) {
  std::size_t pairs = 0;
  for (const auto& list : lists.visible) pairs += list.size();
  return pairs;
}

SightLists measure_level(const City& city) {
  double before = cpu_seconds();
  const SightMap map = make_sight_map(city);
  const double map_s = cpu_seconds() - before;
  before = cpu_seconds();
  const std::size_t looks = make_look_map(map).cells.size();
  const double looks_s = cpu_seconds() - before;
  before = cpu_seconds();
  SightLists lists = lines_of_sight(map, {});
  const double search_s = cpu_seconds() - before - looks_s;
  std::size_t largest = 0, one_way = 0, houses = 0;
  for (const auto& list : lists.houses) houses += list.size();
  for (std::uint32_t a = 0; a < lists.visible.size(); ++a) {
    largest = std::max(largest, lists.visible[a].size());
    for (const std::uint32_t b : lists.visible[a])
      one_way += !std::binary_search(lists.visible[b].begin(), lists.visible[b].end(), a);
  }
  std::printf("%zu sectors, %zu cells (%u of sectors), %zu to look over: maps %.3f + %.3f CPU s, search %.3f CPU s\n",
              map.sector_count(), map.cells.size(), map.begin.back(), looks, map_s, looks_s, search_s);
  std::printf(
      "%.2f M steps, %.1f M a CPU second; L_vis mean %.1f, largest %zu; %.1f houses of other sectors each; %zu one-way "
      "pairs, %zu over budget\n",
      double(lists.steps) / 1e6, double(lists.steps) / 1e6 / search_s,
      double(pairs_of(lists)) / double(map.sector_count()), largest, double(houses) / double(map.sector_count()),
      one_way, lists.over_budget.size());
  SightOptions counting;
  counting.count_cells = true;
  std::printf("different cells that each sector's looks enter, all sectors: %.2f M\n",
              double(lines_of_sight(map, counting).cells) / 1e6);
  return lists;
}

void measure_roofs(const City& city, const SightLists& level, double least_m) {
  RoofOptions options;
  options.least_radius_m = least_m;
  options.most_rays = static_cast<std::uint32_t>(number_from("RAYS", options.most_rays));
  options.most_pairs = static_cast<std::uint32_t>(number_from("PAIRS", options.most_pairs));
  options.most_sector_pairs = static_cast<std::uint32_t>(number_from("SPAIRS", options.most_sector_pairs));
  options.first_radius_m = number_from("FIRST", options.first_radius_m);
  options.pair_radius_m = number_from("PAIR", options.pair_radius_m);
  options.every = static_cast<std::uint32_t>(number_from("EVERY", 1));
  const RoofLists roofs = sights_over_roofs(city, level, options);
  const double seconds = roofs.first_s + roofs.closer_s + roofs.pairs_s;
  const double measured = double((city.sectors.size() + options.every - 1) / options.every);
  double sectors = 0, unresolved = 0;
  for (const auto& list : roofs.visible)
    for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
      bool is_proven = false;
      for (end = i; end < list.size() && list[end].sector == list[i].sector; ++end) is_proven |= list[end].is_proven;
      ++sectors;
      unresolved += is_proven ? 0 : 1;
    }
  std::printf(
      "least radius %.3f m: scene %.2f CPU s, then %.2f (first horizons %.2f, smaller %.2f, pairs %.2f), %.1f ms a "
      "sector; over roofs %.2f sectors each, %.2f unresolved = %.2f %% of "
      "L_vis; %.0f k horizons, %.1f M tests, %.2f M pairs of pieces, %.2f M rays\n",
      least_m, roofs.scene_s, seconds, roofs.first_s, roofs.closer_s, roofs.pairs_s, 1e3 * seconds / measured,
      sectors / measured, unresolved / measured, 100 * unresolved / (double(pairs_of(level)) / options.every + sectors),
      double(roofs.horizons) / 1e3, double(roofs.tests) / 1e6, double(roofs.fine_tests) / 1e6,
      double(roofs.rays) / 1e6);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "grid") == 0) {
    test::GridOptions options;
    options.side = std::atoi(argv[2]);
    options.niches = std::atoi(argv[3]);
    measure_level(test::grid_city(options));
    return 0;
  }
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: visibility_bench INPUT... | visibility_bench city CITY.gpkg | visibility_bench grid "
                 "CROSSROADS NICHES\n");
    return 2;
  }
  const bool is_built = argc == 3 && std::strcmp(argv[1], "city") == 0;
  const City city = is_built ? read_city(argv[2]) : test::city_of_files({argv + 1, argv + argc});
  const SightLists level = measure_level(city);
  if (number_from("EVERY", 1) < 1) return 0;
  if (const double only = number_from("LEAST", 0); only > 0) {
    measure_roofs(city, level, only);
    return 0;
  }
  for (const double least_m : {4.0, 2.0, 1.0, 0.5, 0.25, 0.125}) measure_roofs(city, level, least_m);
}
