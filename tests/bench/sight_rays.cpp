// Rays against the lists of visible sectors: what a visitor would see must be listed.
// usage: sight_rays CITY.gpkg RAYS [SEED [yes|no]]      exit 3: a ray saw what is not listed      (docs/visibility.md)
//        yes, no: the lists are made anew first, with or without those over roofs
#include "tests/support/sight_rays.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "city_db/store.hpp"
#include "sectorgen/visibility/visible.hpp"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: sight_rays CITY.gpkg RAYS [SEED [yes|no]]\n");
    return 2;
  }
  vicus::City city = vicus::read_city(argv[1]);
  if (argc > 4) {
    vicus::VisibleOptions options;
    options.over_roofs = argv[4] == std::string("yes") ? vicus::OverRoofs::yes : vicus::OverRoofs::no;
    vicus::list_visible(city, options);
  }
  const std::clock_t before = std::clock();
  const vicus::test::RayReport report = vicus::test::shoot_rays(city, std::strtoull(argv[2], nullptr, 10),
                                                                argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  const double seconds = double(std::clock() - before) / CLOCKS_PER_SEC;
  std::printf("%llu rays in %.0f CPU s (%.1f M/s): %llu pairs of sectors, %llu houses in pairs seen; %zu missing\n",
              static_cast<unsigned long long>(report.rays), seconds, double(report.rays) / 1e6 / seconds,
              static_cast<unsigned long long>(report.pairs_seen), static_cast<unsigned long long>(report.showings_seen),
              report.missing.size());
  for (std::size_t i = 0; i < report.missing.size() && i < 20; ++i) std::printf("  %s\n", report.missing[i].c_str());
  return report.missing.empty() ? 0 : 3;
}
