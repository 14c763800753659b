#include "tests/support/sight_rays.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <random>
#include <set>
#include <unordered_map>

#include "city_db/run_parallel.hpp"
#include "city_db/seen_houses.hpp"
#include "tests/support/ray_scene.hpp"

namespace vicus::test {
namespace {

constexpr float kInset_m = 0.02F;
constexpr double kStops_m = 2.5;

/// What City::visible promises.
class Promise {
 public:
  explicit Promise(const City& city) : city_(city) {
    std::unordered_map<std::string, std::uint32_t> sectors, houses;
    for (std::uint32_t s = 0; s < city.sectors.size(); ++s) sectors.emplace(city.sectors[s].id, s);
    for (std::uint32_t h = 0; h < city.buildings.size(); ++h) houses.emplace(city.buildings[h].id, h);
    whole_.resize(city.sectors.size());
    showing_.resize(city.sectors.size());
    for (const auto& v : city.visible) {
      const std::uint32_t from = sectors.at(v.sector_id), to = sectors.at(v.visible_sector_id);
      if (!is_of_houses_alone(v)) whole_[from].insert(to);
      for (const auto& id : v.building_ids) showing_[from].insert({to, houses.at(id)});
    }
  }
  bool holds(std::uint32_t from, Owner seen) const {
    return whole_[from].contains(seen.sector) || showing_[from].contains({seen.sector, seen.house});
  }
  std::string describe(std::uint32_t from, Owner seen) const {
    return city_.sectors[from].id + " sees " + city_.sectors[seen.sector].id +
           (seen.house == kNobody ? std::string(", its ground") : ", house " + city_.buildings[seen.house].id);
  }

 private:
  const City& city_;
  std::vector<std::set<std::uint32_t>> whole_;
  std::vector<std::set<std::pair<std::uint32_t, std::uint32_t>>> showing_;
};

bool is_level(const City& city) {
  const auto made = city.meta.find("over_roofs");
  return made != city.meta.end() && made->second == "no";
}

class Shooter {
 public:
  Shooter(const City& city, const RayScene& scene, const Promise& promise, std::uint64_t seed)
      : city_(city), scene_(scene), promise_(promise), is_level_(is_level(city)), random_(seed) {
    for (std::uint32_t h = 0; h < city.buildings.size(); ++h)
      if (city.buildings[h].height_m > kStops_m * (is_level_ ? 1 : 2)) aims_.push_back(h);
  }

  /// Packets from one eye in the sector.
  void look_from(std::uint32_t sector, int packets) {
    Vec eye{};
    if (!find_place(sector, 1.2F + 0.8F * share(), eye)) return;
    for (int i = 0; i < packets; ++i) {
      if (!city_.terrain.height_mm.empty() && i % 4 == 3) {
        look_at_ground(sector, eye);
        continue;
      }
      const bool is_aimed = i % 2 == 0 && !aims_.empty();
      const float turn = share() * 6.2831853F;
      const std::uint32_t house = is_aimed ? aims_[static_cast<std::size_t>(random_() % aims_.size())] : 0;
      Vec directions[16];
      for (auto& d : directions) d = is_aimed ? towards(eye, city_.buildings[house]) : around(turn);
      shoot(sector, eye, directions);
    }
  }

  std::uint64_t rays = 0;
  std::set<std::uint64_t> pairs, showings;
  std::set<std::string> missing;

 private:
  float share() { return std::uniform_real_distribution<float>(0, 1)(random_); }

  /// Somewhere in the sector, so high above its ground.
  bool find_place(std::uint32_t s, float above_m, Vec& place) {
    const Sector& sector = city_.sectors[s];
    std::vector<PlanPoint> points = sector.ground.outer;
    for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
    const auto& t = sector.ground_triangles;
    const std::size_t k = 3 * static_cast<std::size_t>(random_() % (t.size() / 3));
    // Anywhere in a triangle, moved towards its middle by the inset; half of the places are at a rim.
    float u = share(), v = share() * (share() < 0.5F ? 1.F : 0.02F);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    float x[3], y[3];
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = static_cast<float>(scene_.x_of(points[t[k + i]]));
      y[i] = static_cast<float>(scene_.y_of(points[t[k + i]]));
    }
    place = {x[0] + u * (x[1] - x[0]) + v * (x[2] - x[0]), y[0] + u * (y[1] - y[0]) + v * (y[2] - y[0]), above_m};
    const float mx = (x[0] + x[1] + x[2]) / 3 - place.x, my = (y[0] + y[1] + y[2]) / 3 - place.y;
    const float m = std::hypot(mx, my);
    if (m < 2 * kInset_m) return false;
    place.x += mx / m * kInset_m;
    place.y += my / m * kInset_m;
    place.z += static_cast<float>(scene_.ground_at(place.x, place.y));
    return true;
  }

  /// Any place on a slope, over lower houses too.
  void look_at_ground(std::uint32_t sector, Vec eye) {
    const auto seen = static_cast<std::uint32_t>(random_() % city_.sectors.size());
    Vec place{};
    if (!find_place(seen, 0.005F, place)) return;
    const float length = std::hypot(place.x - eye.x, place.y - eye.y);
    if (!is_above_ground(eye, {place.x - eye.x, place.y - eye.y, place.z - eye.z}, 1)) return;
    Vec directions[16];
    const auto aside = [&] { return 0.01F * (share() - 0.5F); };
    for (auto& d : directions) d = {place.x + aside() - eye.x, place.y + aside() - eye.y, place.z - eye.z};
    Owner found[16];
    scene_.meet(eye, directions, found, 1 - kInset_m / length);
    rays += 16;
    if (std::count_if(found, found + 16, [](Owner o) { return o.house == kNobody; }) < 6) return;
    const Owner ground{seen, kNobody, false};
    pairs.insert((std::uint64_t{sector} << 32) | seen);
    if (!promise_.holds(sector, ground))
      missing.insert(promise_.describe(sector, ground) + " at " + std::to_string(place.x) + " " +
                     std::to_string(place.y) + " from " + std::to_string(eye.x) + " " + std::to_string(eye.y));
  }

  Vec towards(Vec eye, const Building& house) {
    const auto& ring = house.footprint.outer;
    const std::size_t i = static_cast<std::size_t>(random_() % ring.size());
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const float at = share();
    const float x = static_cast<float>(scene_.x_of(a) + at * (scene_.x_of(b) - scene_.x_of(a)));
    const float y = static_cast<float>(scene_.y_of(a) + at * (scene_.y_of(b) - scene_.y_of(a)));
    if (is_level_ && share() < 0.5F) return {x - eye.x, y - eye.y, -eye.z * share() * share()};
    const double top = scene_.zero_of(house) + (house.eave_m > house.base_m ? house.eave_m : house.height_m);
    const float up = static_cast<float>(top - 0.3 * house.height_m * share() * share()) - 0.01F;
    return {x - eye.x, y - eye.y, up - eye.z};
  }
  Vec around(float turn) {
    const float angle = turn + 0.1F * share(), rise = std::tan(-0.15F + 0.6F * share() * share());
    return {std::cos(angle), std::sin(angle), rise};
  }

  /// Always on the flat, where the ground is in the scene.
  bool is_above_ground(Vec eye, Vec direction, float farthest) const {
    if (city_.terrain.height_mm.empty() || std::isinf(farthest)) return true;
    const float step = 0.5F / std::hypot(direction.x, direction.y);
    for (float at = 0; at < farthest; at += step)
      if (eye.z + at * direction.z <
          static_cast<float>(scene_.ground_at(eye.x + at * direction.x, eye.y + at * direction.y)))
        return false;
    return true;
  }

  void shoot(std::uint32_t sector, Vec eye, const Vec* directions) {
    Owner found[16];
    float distances[16];
    scene_.meet(eye, directions, found, INFINITY, distances);
    rays += 16;
    for (int i = 0; i < 16; ++i)
      if (found[i].sector != kNobody && !is_above_ground(eye, directions[i], distances[i])) found[i] = Owner{};
    if (is_level_) forget_what_is_over_roofs(eye, directions, found);
    for (int i = 0; i < 16; ++i) {
      if (found[i].sector == kNobody) continue;
      pairs.insert((std::uint64_t{sector} << 32) | found[i].sector);
      if (found[i].house != kNobody)
        showings.insert((std::uint64_t{sector} << 32) | (found[i].house * 31ULL + found[i].sector));
      if (!promise_.holds(sector, found[i]) && is_seen_beside(eye, directions[i], found[i]))
        missing.insert(promise_.describe(sector, found[i]) + " from " + std::to_string(eye.x) + " " +
                       std::to_string(eye.y) + " " + std::to_string(eye.z));
    }
  }

  /// What a rising ray meets counts when a level one in the same direction meets the same house.
  void forget_what_is_over_roofs(Vec eye, const Vec* directions, Owner* found) {
    Vec level[16];
    for (int i = 0; i < 16; ++i) level[i] = {directions[i].x, directions[i].y, 0};
    Owner met[16];
    scene_.meet(eye, level, met);
    rays += 16;
    for (int i = 0; i < 16; ++i)
      if (directions[i].z > 0 && (met[i].sector == kNobody || met[i].house != found[i].house)) found[i] = Owner{};
  }

  /// Against leaks of floats at seams: rays a millimetre beside see the same.
  bool is_seen_beside(Vec eye, Vec direction, Owner what) {
    const float length = std::hypot(direction.x, direction.y, direction.z);
    Vec beside[16];
    for (auto& d : beside) {
      const float spread = 2e-6F * length;
      d = {direction.x + spread * (share() - 0.5F), direction.y + spread * (share() - 0.5F),
           direction.z + spread * (share() - 0.5F)};
    }
    Owner found[16];
    scene_.meet(eye, beside, found);
    rays += 16;
    return std::count_if(found, found + 16,
                         [&](Owner o) { return o.sector == what.sector && o.house == what.house; }) >= 6;
  }

  const City& city_;
  const RayScene& scene_;
  const Promise& promise_;
  bool is_level_;
  std::mt19937_64 random_;
  std::vector<std::uint32_t> aims_;
};

}  // namespace

RayReport shoot_rays(const City& city, std::uint64_t rays, std::uint64_t seed, unsigned threads) {
  const RayScene scene(city);
  const Promise promise(city);
  constexpr int kPackets = 64;
  const std::uint64_t looks = rays / (16 * kPackets) + 1;
  RayReport report;
  std::set<std::uint64_t> pairs, showings;
  std::set<std::string> missing;
  std::mutex mutex;
  const std::size_t tasks = 64;
  run_parallel(tasks, thread_count(threads), [&](std::size_t task, unsigned) {
    Shooter shooter(city, scene, promise, seed * 1000 + task);
    for (std::uint64_t look = task; look < looks; look += tasks)
      shooter.look_from(static_cast<std::uint32_t>((look * 2654435761ULL) % city.sectors.size()), kPackets);
    const std::lock_guard lock(mutex);
    report.rays += shooter.rays;
    pairs.merge(shooter.pairs);
    showings.merge(shooter.showings);
    missing.merge(shooter.missing);
  });
  report.pairs_seen = pairs.size();
  report.showings_seen = showings.size();
  report.missing.assign(missing.begin(), missing.end());
  return report;
}

}  // namespace vicus::test
