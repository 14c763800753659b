// Line of sight in plan: time, steps and size of the lists of a city.
// Over roofs: CPU time and what stays unresolved, by how far eyes and walls are told apart.
// usage: [EVERY=n] visibility_bench INPUT...      EVERY: over roofs each n-th sector only      (docs/visibility.md)
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "sectorgen/build_city.hpp"
#include "sectorgen/visibility/line_of_sight.hpp"
#include "sectorgen/visibility/over_roofs.hpp"

int main(int argc, char** argv) {
  vicus::LoadOptions load;
  for (int i = 1; i < argc; ++i) load.inputs.emplace_back(argv[i]);
  std::vector<vicus::Issue> issues;
  vicus::SourceMap source = vicus::load_source_map(load, issues);
  vicus::BuildReport report;
  vicus::BuildOptions build;
  build.with_visibility = false;
  const vicus::City city = vicus::build_city(std::move(source), build, std::move(issues), report);
  double before = vicus::cpu_seconds();
  const vicus::SightMap map = vicus::make_sight_map(city);
  const double map_s = vicus::cpu_seconds() - before;
  before = vicus::cpu_seconds();
  const vicus::SightLists lists = vicus::lines_of_sight(map, {});
  const double search_s = vicus::cpu_seconds() - before;
  std::size_t pairs = 0, largest = 0, one_way = 0;
  for (std::uint32_t a = 0; a < lists.visible.size(); ++a) {
    pairs += lists.visible[a].size();
    largest = std::max(largest, lists.visible[a].size());
    for (const std::uint32_t b : lists.visible[a])
      one_way += !std::binary_search(lists.visible[b].begin(), lists.visible[b].end(), a);
  }
  std::printf("%zu sectors, %zu cells (%u of sectors): map %.3f CPU s, search %.3f CPU s\n", map.sector_count(),
              map.cells.size(), map.begin.back(), map_s, search_s);
  std::printf("%.2f M steps, %.1f M a CPU second; L_vis mean %.1f, largest %zu; %zu one-way pairs, %zu over budget\n",
              static_cast<double>(lists.steps) / 1e6, static_cast<double>(lists.steps) / 1e6 / search_s,
              static_cast<double>(pairs) / static_cast<double>(map.sector_count()), largest, one_way,
              lists.over_budget.size());
  const char* text = std::getenv("EVERY");
  const std::uint32_t every = text != nullptr ? static_cast<std::uint32_t>(std::max(1, std::atoi(text))) : 1;
  const double measured = static_cast<double>((map.sector_count() + every - 1) / every);
  for (const double least : {4.0, 2.0, 1.0, 0.5, 0.25, 0.125}) {
    vicus::RoofOptions options;
    options.least_radius_m = least;
    options.every = every;
    before = vicus::cpu_seconds();
    const vicus::RoofLists roofs = vicus::sights_over_roofs(city, lists.visible, options);
    const double roof_s = vicus::cpu_seconds() - before;
    std::size_t sectors = 0, unresolved = 0;
    for (const auto& list : roofs.visible)
      for (std::size_t i = 0; i < list.size(); ++i)
        if (i == 0 || list[i].sector != list[i - 1].sector) {
          bool is_proven = false;
          for (std::size_t k = i; k < list.size() && list[k].sector == list[i].sector; ++k)
            is_proven |= list[k].is_proven;
          ++sectors;
          unresolved += !is_proven;
        }
    std::printf(
        "least radius %.3f m: %.2f CPU s, %.2f ms a sector; over roofs %.2f sectors each, %.2f unresolved = %.2f %% of "
        "L_vis; "
        "%.0f k horizons, %.1f M tests, %.2f M fine, %.2f M rays\n",
        least, roof_s, 1e3 * roof_s / measured, double(sectors) / measured,
        double(unresolved) / measured, 100 * double(unresolved) / (double(pairs) / every + double(sectors)),
        double(roofs.horizons) / 1e3, double(roofs.tests) / 1e6, double(roofs.fine_tests) / 1e6,
        double(roofs.rays) / 1e6);
    std::fflush(stdout);
  }
}
