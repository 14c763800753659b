// What L_vis saves: bytes and Shapes loaded on a walk by L_1 and L_2 (paper 004 §5.1), against loading by distance with
// the radius that shows the same share of the facade pixels in sight.
// usage: walk_savings CITY.gpkg [METRES [SEED]]      (docs/visibility.md)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "city_db/seen_houses.hpp"
#include "city_db/store.hpp"
#include "tests/support/ray_scene.hpp"
#include "tests/support/street_walk.hpp"
#include "x3d_export/coding.hpp"

namespace {

using namespace vicus;
using test::Owner;

constexpr double kStep_m = 10, kEye_m = 1.7;
/// A panorama on a cylinder, in columns round about and rows from 27 degrees down to 56 up.
constexpr int kColumns = 1024, kRows = 48;
constexpr double kLowest = -0.5, kHighest = 1.5;

enum class Level { near, far, tall };
using File = std::pair<std::uint32_t, Level>;  // a sector's
using Files = std::set<File>;

struct Cost {
  double bytes = 0, shapes = 0;
};

/// Facade pixels of one panorama by what they show.
using Pixels = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;  // sector, house

class Bench {
 public:
  Bench(const std::string& path, double length_m, std::uint64_t seed)
      : city_(read_city(path)), reader_(path), walk_(test::walk_streets(city_, length_m, kStep_m, seed)) {
    for (std::uint32_t s = 0; s < city_.sectors.size(); ++s) sectors_.emplace(city_.sectors[s].id, s);
    for (std::uint32_t h = 0; h < city_.buildings.size(); ++h) houses_.emplace(city_.buildings[h].id, h);
    visible_.resize(city_.sectors.size());
    beyond_gates_.resize(city_.sectors.size());
    only_tall_.resize(city_.sectors.size());
    for (const auto& v : city_.visible) {
      const std::uint32_t from = sectors_.at(v.sector_id), to = sectors_.at(v.visible_sector_id);
      visible_[from].insert(to);
      if (is_of_houses_alone(v)) only_tall_[from].insert(to);
      for (const auto& id : v.building_ids) tall_houses_.insert({to, houses_.at(id)});
    }
    for (const auto& gate : city_.gates)
      if (!gate.to_sector_id.empty()) beyond_gates_[sectors_.at(gate.sector_id)].insert(sectors_.at(gate.to_sector_id));
    render();
  }

  void run() {
    std::set<std::uint32_t> entered;
    for (const auto& place : walk_) entered.insert(place.sector);
    std::printf("%zu eyes on %.0f m through %zu of %zu sectors; %.1f M rays, %.1f M facade pixels\n", walk_.size(),
                kStep_m * static_cast<double>(walk_.size()), entered.size(), city_.sectors.size(),
                1e-6 * kColumns * kRows * static_cast<double>(walk_.size()), 1e-6 * total_);
    std::printf("%-34s %8s %8s %8s %8s %9s %8s\n", "loaded", "radius m", "share %", "sectors", "Shapes", "kB",
                "walk kB");
    const double by_gates = report("L_0 and its gates' sectors", 0, [&](std::size_t eye) { return gates_of(eye); });
    report_distance("by distance, same share", by_gates, true);
    const double by_l1 = report("L_1", 0, [&](std::size_t eye) { return near(l_1(walk_[eye].sector)); });
    report_distance("by distance, same share", by_l1, true);
    const double by_l2 = report("L_2", 0, [&](std::size_t eye) { return near(l_2(walk_[eye].sector)); });
    report_distance("by distance, same share", by_l2, true);
    const double by_page = report("L_1: near, far, tall files", 0, [&](std::size_t eye) { return as_page(eye); });
    report_distance("by distance: near, far files", by_page, false);
    for (const double share : {0.99, 0.95}) report_distance("by distance: near, far files", share, false);
  }

 private:
  void render() {
    const test::RayScene scene(city_);
    for (const auto& place : walk_) {
      const PlanPoint at{static_cast<std::int32_t>(std::lround(1000 * place.east_m)),
                         static_cast<std::int32_t>(std::lround(1000 * place.north_m))};
      test::Vec eye{static_cast<float>(scene.x_of(at)), static_cast<float>(scene.y_of(at)), 0};
      eye.z = static_cast<float>(kEye_m + scene.ground_at(eye.x, eye.y));
      Pixels pixels;
      for (int i = 0; i < kColumns * kRows; i += 16) {
        test::Vec directions[16];
        for (int k = 0; k < 16; ++k) {
          const double turn = 6.283185307179586 * ((i + k) / kRows + 0.5) / kColumns,
                       rise = kLowest + (kHighest - kLowest) * ((i + k) % kRows + 0.5) / kRows;
          directions[k] = {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)),
                           static_cast<float>(rise)};
        }
        Owner found[16];
        scene.meet(eye, directions, found);
        for (const Owner& owner : found)
          if (owner.is_wall && owner.sector != test::kNobody) ++pixels[{owner.sector, owner.house}], ++total_;
      }
      pixels_.push_back(std::move(pixels));
      distances_.emplace_back();
      for (const auto& sector : city_.sectors) distances_.back().push_back(distance_m(sector, at));
    }
  }

  static double distance_m(const Sector& sector, PlanPoint p) {
    double least = 1e18;
    bool is_inside = false;
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
        const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        least = std::min(least, std::hypot(px - t * dx, py - t * dy));
        if ((a.y > p.y) != (b.y > p.y) && px * dy - py * dx < 0 == (dy > 0)) is_inside = !is_inside;
      }
    };
    add(sector.ground.outer);
    for (const auto& hole : sector.ground.holes) add(hole);
    return is_inside ? 0 : least / 1000;
  }

  std::set<std::uint32_t> l_1(std::uint32_t sector) const { return visible_[sector]; }
  std::set<std::uint32_t> l_2(std::uint32_t sector) const {
    std::set<std::uint32_t> all;
    for (const std::uint32_t s : visible_[sector]) all.insert(visible_[s].begin(), visible_[s].end());
    return all;
  }
  static Files near(const std::set<std::uint32_t>& sectors) {
    Files files;
    for (const std::uint32_t s : sectors) files.insert({s, Level::near});
    return files;
  }
  Files gates_of(std::size_t eye) const {
    Files files = near(beyond_gates_[walk_[eye].sector]);
    files.insert({walk_[eye].sector, Level::near});
    return files;
  }
  /// As the page loads L_1: what is not beyond a gate far, what is seen over roofs alone tall.
  Files as_page(std::size_t eye) const {
    const std::uint32_t here = walk_[eye].sector;
    Files files = gates_of(eye);
    for (const std::uint32_t s : visible_[here])
      if (!files.contains({s, Level::near})) files.insert({s, only_tall_[here].contains(s) ? Level::tall : Level::far});
    return files;
  }
  Files within(std::size_t eye, double radius_m, bool all_near) const {
    Files files;
    if (!all_near) files = gates_of(eye);
    for (std::uint32_t s = 0; s < city_.sectors.size(); ++s)
      if (distances_[eye][s] <= radius_m && !files.contains({s, Level::near}))
        files.insert({s, all_near ? Level::near : Level::far});
    return files;
  }

  bool shows(const Files& files, std::uint32_t sector, std::uint32_t house) const {
    return files.contains({sector, Level::near}) || files.contains({sector, Level::far}) ||
           (files.contains({sector, Level::tall}) && tall_houses_.contains({sector, house}));
  }

  /// Stored bytes and Shapes of a file with its parts; of one that is not there nothing.
  Cost cost_of(File file) {
    const auto known = costs_.find(file);
    if (known != costs_.end()) return known->second;
    const std::string stem = "sectors/" + city_.sectors[file.first].id +
                             (file.second == Level::far    ? ".far"
                              : file.second == Level::tall ? ".tall"
                                                           : "");
    Cost cost;
    for (int part = 0;; ++part) {
      const auto body = reader_.artefact(stem + (part == 0 ? "" : "." + std::to_string(part)) + ".x3d", {"br", ""});
      if (!body) break;
      cost.bytes += static_cast<double>(body->body.size());
      const std::string text = body->coding == "br" ? unbrotli(body->body, 1 << 30).value() : body->body;
      for (std::size_t at = text.find("<Shape"); at != std::string::npos; at = text.find("<Shape", at + 1))
        ++cost.shapes;
    }
    return costs_.emplace(file, cost).first->second;
  }

  /// One row of the table; returns the share of facade pixels that are shown.
  template <class FilesAt>
  double report(const char* what, double radius_m, FilesAt files_at) {
    double shown = 0, sectors = 0;
    Cost mean, walk;
    Files all;
    for (std::size_t eye = 0; eye < walk_.size(); ++eye) {
      const Files files = files_at(eye);
      for (const auto& [key, count] : pixels_[eye]) shown += shows(files, key.first, key.second) ? count : 0;
      for (const File& file : files) {
        const Cost cost = cost_of(file);
        mean.bytes += cost.bytes, mean.shapes += cost.shapes;
        if (all.insert(file).second) walk.bytes += cost.bytes;
      }
      sectors += static_cast<double>(files.size());
    }
    const double eyes = static_cast<double>(walk_.size());
    std::printf("%-34s %8.0f %8.3f %8.1f %8.0f %9.1f %8.0f\n", what, radius_m, 100 * shown / total_, sectors / eyes,
                mean.shapes / eyes, mean.bytes / eyes / 1000, walk.bytes / 1000);
    std::fflush(stdout);
    return shown / total_;
  }

  /// The least radius, one for the whole walk, that shows as much.
  void report_distance(const char* what, double share, bool all_near) {
    std::vector<std::pair<double, double>> pixels;  // from where on they are shown
    for (std::size_t eye = 0; eye < walk_.size(); ++eye) {
      const Files gates = all_near ? Files{} : gates_of(eye);
      for (const auto& [key, count] : pixels_[eye])
        pixels.push_back({gates.contains({key.first, Level::near}) ? 0 : distances_[eye][key.first], count});
    }
    std::sort(pixels.begin(), pixels.end());
    double shown = 0, radius_m = 0;
    for (const auto& [distance, count] : pixels) {
      if (shown >= share * total_ * (1 - 1e-12)) break;
      shown += count;
      radius_m = distance;
    }
    report(what, radius_m, [&](std::size_t eye) { return within(eye, radius_m, all_near); });
  }

  City city_;
  CityReader reader_;
  std::vector<test::WalkPlace> walk_;
  std::unordered_map<std::string, std::uint32_t> sectors_, houses_;
  std::vector<std::set<std::uint32_t>> visible_, beyond_gates_, only_tall_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> tall_houses_;
  std::vector<Pixels> pixels_;
  std::vector<std::vector<double>> distances_;  // per eye and sector, m
  double total_ = 0;
  std::map<File, Cost> costs_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: walk_savings CITY.gpkg [METRES [SEED]]\n", stderr), 2;
  Bench(argv[1], argc > 2 ? std::atof(argv[2]) : 1000, argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1).run();
}
