#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <string>

#include "city_db/store.hpp"
#include "sectorgen/sectors/tours/corner_caps.hpp"
#include "sectorgen/sectors/tours/shortest_walk.hpp"

/// How long it takes to find a walk: tour_bench CITY.gpkg [WALKS [CLEARANCE_MM]]. Both ends are drawn at random, each
/// sector alike.
namespace {

/// Of this thread's CPU: a busy machine's other work does not count.
double now_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

double resident_mb() {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("VmRSS:")) return std::atof(line.c_str() + 6) / 1024;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vicus;
  if (argc < 2) {
    std::fprintf(stderr, "usage: tour_bench CITY.gpkg [WALKS [CLEARANCE_MM]]\n");
    return 2;
  }
  const int count = argc > 2 ? std::atoi(argv[2]) : 2000;
  const auto clearance = argc > 3 ? static_cast<std::int32_t>(std::atoi(argv[3])) : kWalkClearance_mm;
  const City city = read_city(argv[1]);
  const double before_mb = resident_mb();
  double begin = now_ms();
  const WalkMesh walk = make_clear_walk_mesh(city.sectors, city.gates, clearance);
  const WalkPlaces places(walk);
  std::printf("sectors %zu  triangles %zu  points %zu  parts %u  mesh %.0f ms  memory %.0f MB\n", city.sectors.size(),
              walk.mesh.triangles.size(), walk.mesh.points.size(), walk.part_count, now_ms() - begin,
              resident_mb() - before_mb);
  std::fflush(stdout);
  begin = now_ms();
  const SightGraph graph = make_sight_graph(walk);
  std::printf("corners %zu  edges %zu  graph %.0f ms (this thread)  memory %.0f MB\n", graph.point.size(),
              graph.neighbour.size() / 2, now_ms() - begin, resident_mb() - before_mb);
  std::fflush(stdout);
  std::vector<std::vector<std::uint32_t>> of_sector(city.sectors.size());
  for (std::uint32_t t = 0; t < walk.sector.size(); ++t)
    if (walk.sector[t] != kNone) of_sector[walk.sector[t]].push_back(t);
  std::mt19937_64 random(1);
  const auto place = [&] {
    for (;;) {
      const auto& triangles = of_sector[random() % of_sector.size()];
      if (triangles.empty()) continue;
      const std::uint32_t t = triangles[random() % triangles.size()];
      const PlanPoint a = walk.at(t, 0), b = walk.at(t, 1), c = walk.at(t, 2);
      return PlanPoint{static_cast<std::int32_t>((std::int64_t{a.x} + b.x + c.x) / 3),
                       static_cast<std::int32_t>((std::int64_t{a.y} + b.y + c.y) / 3)};
    }
  };
  ShortestWalk shortest(walk, places, graph);
  std::vector<double> times;
  double length = 0, steps = 0;
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const PlanPoint from = place(), to = place();
    begin = now_ms();
    const auto w = shortest.find(from, to);
    times.push_back(now_ms() - begin);
    if (std::getenv("TOUR_BENCH_ALL"))
      std::printf("%.2f ms  %.0f m  steps %llu\n", times.back(), w ? w->length_mm / 1e3 : -1,
                  static_cast<unsigned long long>(w ? w->steps : 0));
    if (!w) continue;
    ++found;
    length += w->length_mm / 1e3;
    steps += static_cast<double>(w->steps);
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("walks %d of %d  mean %.0f m  steps %.0f  p50 %.2f ms  p95 %.2f  p99 %.2f  max %.2f\n", found, count,
              length / found, steps / found, at(0.5), at(0.95), at(0.99), times.back());
}
