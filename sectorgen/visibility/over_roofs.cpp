#include "sectorgen/visibility/over_roofs.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "city_db/run_parallel.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/visibility/horizon.hpp"
#include "sectorgen/visibility/sight_regions.hpp"
#include "sectorgen/visibility/spot_box.hpp"

namespace vicus {
namespace {

constexpr double kFirstRound_m = 0.5;
constexpr double kInset_m = 0.02;  // rays start and end this far off walls
/// Directions of a horizon: more where a disc is so small that a bin's width would blur it.
constexpr std::uint32_t kFewBins = 768, kManyBins = 1024;
constexpr double kManyBinsBelow_m = 1.5;

/// CPU seconds of this thread.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double highest_ground(const Sector& sector, const Terrain& terrain) {
  if (terrain.height_mm.empty()) return 0;
  std::vector<PlanPoint> points = sector.ground.outer;
  for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  double highest = kNoRoof_m;
  for (std::size_t i = 0; i + 2 < sector.ground_triangles.size(); i += 3) {
    PlanBox box;
    for (std::size_t k = i; k < i + 3; ++k) box.add(points[sector.ground_triangles[k]]);
    highest = std::max(highest, height_range(terrain, box).greatest_m);
  }
  return highest;
}

constexpr int kMostHillPlaces = 12;  // looked at along a line; 64 find no more (docs/visibility.md)

enum class State : char { unknown, open, known };  // known: proven visible, or in sight on the level

/// What was spent on a showing from one sector.
struct Effort {
  std::uint32_t rays = 0, pairs = 0;
};

/// A part of the rim, and the walls that some eye on it may see.
struct Part {
  Region eyes;
  std::vector<std::uint32_t> walls;  // nodes of the targets' tree
};

class Scene {
 public:
  Scene(const City& city, const RoofOptions& options)
      : terrain(city.terrain),
        walls(city),
        field(walls, options.grid_cells),
        targets(make_roof_targets(city, walls, options.least_height_m)) {}
  const Terrain& terrain;
  HouseWalls walls;
  RoofField field;
  RoofTargets targets;
};

/// All of one thread's work on one sector after the other.
class Explorer {
 public:
  Explorer(const Scene& scene, std::size_t sectors, const RoofOptions& options)
      : scene_(scene),
        options_(options),
        horizon_(scene.field),
        state_(scene.targets.showings.size()),
        unknown_in_(scene.targets.houses + sectors),
        effort_(scene.targets.showings.size()),
        blocker_(scene.targets.tree.segments.size()) {}

  std::vector<RoofSight> run(const City& city, std::uint32_t sector, const SightLists& level) {
    const auto& showings = scene_.targets.showings;
    std::fill(unknown_in_.begin(), unknown_in_.end(), 0);
    for (std::uint32_t i = 0; i < showings.size(); ++i) {
      state_[i] = is_in_sight(level, sector, showings[i]) ? State::known : State::unknown;
      unknown_in_[showings[i].house] += state_[i] == State::unknown;
    }
    found_.clear();
    std::fill(effort_.begin(), effort_.end(), Effort{});
    std::fill(blocker_.begin(), blocker_.end(), kNowhere);
    rim_ = rim_of(city.sectors[sector]);
    eye_m_ = highest_ground(city.sectors[sector], scene_.terrain) + kEyeTop_m;
    parts_.clear();
    pairs_ = 0;
    const double begin = thread_seconds();
    if (rim_.root != kNowhere && scene_.targets.tree.root != kNowhere) stand_on(region_of(rim_, rim_.root));
    const double stood = thread_seconds();
    look_closer();
    const double closer = thread_seconds();
    look_pair_by_pair();
    first_s += stood - begin;
    closer_s += closer - stood;
    pairs_s += thread_seconds() - closer;
    std::vector<RoofSight> out;
    for (const std::uint32_t i : found_)
      out.push_back({showings[i].sector, is_ground(showings[i].house) ? RoofSight::kGround : showings[i].house,
                     state_[i] == State::known});
    std::sort(out.begin(), out.end(), [](const RoofSight& a, const RoofSight& b) {
      return std::pair(a.sector, a.house) < std::pair(b.sector, b.house);
    });
    return out;
  }

  std::uint64_t horizons = 0, tests = 0, fine_tests = 0, rays = 0;
  double first_s = 0, closer_s = 0, pairs_s = 0;

 private:
  bool is_in_sight(const SightLists& level, std::uint32_t sector, const Showing& showing) const {
    const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t index) {
      return std::binary_search(list.begin(), list.end(), index);
    };
    return has(level.visible[sector], showing.sector) || (showing.is_owner && has(level.houses[sector], showing.house));
  }

  bool is_ground(std::uint32_t house) const { return house >= scene_.targets.houses; }

  State state_of(const Region& target) const { return state_[scene_.targets.showing[target.segment]]; }

  void set_state(const Region& target, State state) {
    const std::uint32_t i = scene_.targets.showing[target.segment];
    if (state_[i] >= state) return;
    if (state_[i] == State::unknown) found_.push_back(i);
    if (state == State::known) --unknown_in_[scene_.targets.showings[i].house];
    state_[i] = state;
  }

  Effort& effort_of(const Region& target) { return effort_[scene_.targets.showing[target.segment]]; }

  /// No eye of the region is on the outer side of the wall.
  bool is_behind(const Region& eyes, const Region& wall) const {
    if (!scene_.targets.is_wall[wall.segment]) return false;
    const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y, length = length_of(dx, dy);
    const auto left_of = [&](Spot p) { return (dx * (p.y - wall.a.y) - dy * (p.x - wall.a.x)) / length; };
    constexpr double kSlack_m = 1e-5;
    if (eyes.is_segment()) return left_of(eyes.a) > kSlack_m && left_of(eyes.b) > kSlack_m;
    return left_of(eyes.centre) > eyes.radius + kSlack_m;
  }

  /// Everything in the disc is on the outer side of that stretch of rim, and higher than the eyes: steps back from it
  /// lead into the sector, and only lift the line, as far as the rim where it enters.
  bool is_seen_better_elsewhere(const Region& eyes, Spot centre, double radius, double low_m) const {
    if (!eyes.is_segment()) {
      const SegmentNode& n = rim_.nodes[eyes.node];
      return is_seen_better_elsewhere(region_of(rim_, n.left), centre, radius, low_m) &&
             is_seen_better_elsewhere(region_of(rim_, n.right), centre, radius, low_m);
    }
    constexpr double kSlack_m = 1e-5;
    const SightSegment& rim = rim_.segments[eyes.segment];
    const double dx = rim.b.x - rim.a.x, dy = rim.b.y - rim.a.y,
                 inwards = (dx * (centre.y - rim.a.y) - dy * (centre.x - rim.a.x)) / length_of(dx, dy);
    return inwards < -radius - kSlack_m && low_m > eye_m_;
  }

  /// Parts of the rim as large as the first horizon allows.
  void stand_on(const Region& eyes) {
    if (eyes.radius > options_.first_radius_m) {
      const auto [first, second] = halves(rim_, eyes);
      stand_on(first);
      stand_on(second);
      return;
    }
    parts_.push_back({eyes, {}});
    start_horizon(eyes);
    search(eyes, scene_.targets.tree.root, parts_.back().walls);
  }

  void start_horizon(const Region& eyes) {
    horizon_.start(eyes.centre, eyes.radius, eye_m_, eyes.radius > kManyBinsBelow_m ? kFewBins : kManyBins);
    ++horizons;
  }

  /// Walls that the horizon does not hide.
  void search(const Region& eyes, std::uint32_t node, std::vector<std::uint32_t>& seen) {
    const SegmentNode& n = scene_.targets.tree.nodes[node];
    if (n.segment != kNowhere) {
      if (is_left(eyes, node)) seen.push_back(node);
      return;
    }
    if (n.house != kNowhere && unknown_in_[n.house] == 0) return;
    if (is_seen_better_elsewhere(eyes, n.centre, n.radius, n.low_m)) return;
    ++tests;
    if (horizon_.hides_disc(n.centre, n.radius, n.top_m)) return;
    search(eyes, n.left, seen);
    search(eyes, n.right, seen);
  }

  /// The wall is still to be asked about: nothing hides it, and no ray proved it seen.
  bool is_left(const Region& eyes, std::uint32_t node) {
    const Region wall = region_of(scene_.targets.tree, node);
    if (state_of(wall) == State::known || is_behind(eyes, wall) ||
        is_seen_better_elsewhere(eyes, wall.centre, wall.radius, wall.low_m))
      return false;
    ++tests;
    if (horizon_.hides_segment(wall.a, wall.b, wall.top_m)) return false;
    if (!eyes.is_segment() || !is_seen(eyes, wall)) return true;
    set_state(wall, State::known);
    return false;
  }

  /// The walls that are left, from halves of the rim's parts: all parts of one size before any smaller one, so that
  /// what is plainly seen from somewhere is not asked about elsewhere.
  void look_closer() {
    std::vector<Part> next;
    close_parts_.clear();
    for (; !parts_.empty(); parts_.swap(next), next.clear())
      for (Part& part : parts_) {
        drop_known(part);
        if (part.walls.empty()) continue;
        if (part.eyes.is_segment() && part.eyes.radius <= options_.pair_radius_m) {
          close_parts_.push_back(std::move(part));
          continue;
        }
        const auto [first, second] = halves(rim_, part.eyes);
        for (const Region* half : {&first, &second}) {
          next.push_back({*half, {}});
          start_horizon(*half);
          for (const std::uint32_t node : part.walls)
            if (is_left(*half, node)) next.back().walls.push_back(node);
        }
      }
  }

  /// In two rounds, for the same reason.
  void look_pair_by_pair() {
    for (const double least_m : {std::max(options_.least_radius_m, kFirstRound_m), options_.least_radius_m}) {
      least_m_ = least_m;
      is_last_round_ = least_m == options_.least_radius_m;
      for (Part& part : close_parts_) {
        std::erase_if(part.walls,
                      [&](std::uint32_t node) { return !is_unsure(part.eyes, region_of(scene_.targets.tree, node)); });
      }
      if (is_last_round_) return;
    }
  }

  void drop_known(Part& part) const {
    std::erase_if(part.walls,
                  [&](std::uint32_t node) { return state_of(region_of(scene_.targets.tree, node)) == State::known; });
  }

  /// A part of the rim and a part of a wall, by the houses between them: true when more has to be told apart.
  bool is_unsure(const Region& eyes, const Region& target) {
    if (state_of(target) != State::unknown || is_behind(eyes, target) ||
        is_seen_better_elsewhere(eyes, target.centre, target.radius, target.low_m))
      return false;
    const double length = length_of(target.centre.x - eyes.centre.x, target.centre.y - eyes.centre.y);
    if (length > eyes.radius + target.radius && is_blocked(eyes, target)) return false;
    if (is_seen(eyes, target)) return set_state(target, State::known), false;
    const bool eyes_are_small = eyes.radius <= least_m_, target_is_small = target.radius <= least_m_;
    const bool is_spent = ++effort_of(target).pairs > options_.most_pairs || ++pairs_ > options_.most_sector_pairs;
    if (is_spent || (eyes_are_small && target_is_small)) {
      if (is_spent || is_last_round_) set_state(target, State::open);
      return true;
    }
    const bool split_target = !target_is_small && (eyes_are_small || target.radius > eyes.radius);
    const auto [first, second] = halves(split_target ? scene_.targets.tree : rim_, split_target ? target : eyes);
    const bool is_first_unsure = split_target ? is_unsure(eyes, first) : is_unsure(first, target);
    return (split_target ? is_unsure(eyes, second) : is_unsure(second, target)) || is_first_unsure;
  }

  /// One place on the middle line where the whole disc of displaced lines is under roofs that reach it. First the house
  /// that hid the wall from elsewhere.
  bool is_blocked(const Region& eyes, const Region& target) {
    std::uint32_t& blocker = blocker_[target.segment];
    if (blocker != kNowhere) {
      scene_.walls.cut(eyes.centre, target.centre, blocker, crossings_);
      for (const Crossing& crossing : crossings_)
        if (blocks(eyes, target, crossing)) return true;
    }
    ++fine_tests;
    scene_.walls.cut(eyes.centre, target.centre, eye_m_, target.top_m - eye_m_, crossings_);
    for (const Crossing& crossing : crossings_)
      if (blocks(eyes, target, crossing)) {
        blocker = crossing.house;
        return true;
      }
    return is_behind_a_hill(eyes, target);
  }

  /// The same with the ground in place of a roof.
  bool is_behind_a_hill(const Region& eyes, const Region& target) const {
    const Terrain& terrain = scene_.terrain;
    if (terrain.height_mm.empty()) return false;
    const double length = length_of(target.centre.x - eyes.centre.x, target.centre.y - eyes.centre.y);
    const int places = std::clamp(static_cast<int>(length / metres(terrain.step_mm)), 4, kMostHillPlaces);
    for (int i = 1; i < places; ++i) {
      const double t = static_cast<double>(i) / places, radius = (1 - t) * eyes.radius + t * target.radius;
      const double x = std::lerp(eyes.centre.x, target.centre.x, t), y = std::lerp(eyes.centre.y, target.centre.y, t);
      if (height_range(terrain, box_around({x - radius, y - radius}, {x + radius, y + radius})).least_m >=
          std::lerp(eye_m_, target.top_m, t))
        return true;
    }
    return false;
  }

  bool blocks(const Region& eyes, const Region& target, const Crossing& crossing) const {
    const HouseBody& body = scene_.walls.houses()[crossing.house];
    const double length = length_of(target.centre.x - eyes.centre.x, target.centre.y - eyes.centre.y);
    const double rise = target.top_m - eye_m_;
    if (!body.stands() || body.sure_top_m < eye_m_ + rise * (rise >= 0 ? crossing.from : crossing.to)) return false;
    double step = std::max(0.02, 0.25 * (eyes.radius + (target.radius - eyes.radius) * crossing.from)) / length;
    for (double t = crossing.from + step; t < crossing.to; step *= 1.6, t += step) {
      const double up = eye_m_ + rise * t;
      if (body.sure_top_m < up) {
        if (rise >= 0) return false;
        continue;
      }
      const Spot x{eyes.centre.x + t * (target.centre.x - eyes.centre.x),
                   eyes.centre.y + t * (target.centre.y - eyes.centre.y)};
      if (scene_.walls.is_roofed(x, (1 - t) * eyes.radius + t * target.radius, crossing.house, up)) return true;
    }
    return false;
  }

  /// A line from the middle of the eyes to the middle of the wall's top, or to the ground there, meets no house.
  bool is_seen(const Region& eyes, const Region& target) {
    if (++effort_of(target).rays > options_.most_rays) return false;
    ++rays;
    if (is_ground(target.house)) return is_ground_seen(beside(eyes, kInset_m), target.centre);
    const HouseBody& body = scene_.walls.houses()[target.house];
    const bool is_wall = scene_.targets.is_wall[target.segment];
    const Spot p = beside(eyes, kInset_m), q = is_wall ? beside(target, -kInset_m) : target.centre;
    const double middle_m = (target.up_a + target.up_b) / 2 - body.most_zero_m + body.sure_zero_m,
                 p_up = ground_at(p) + kEyeTop_m,
                 q_up = is_wall ? std::min(middle_m, body.sure_eave_m) - kInset_m : std::min(middle_m, body.sure_top_m);
    return scene_.walls.is_clear(p, p_up, q, q_up, is_wall ? HouseWalls::kNoHouse : target.house) &&
           is_above_ground(p, p_up, q, q_up);
  }

  bool is_ground_seen(Spot p, Spot q) const {
    const double p_up = ground_at(p) + kEyeTop_m, q_up = ground_at(q) + kInset_m;
    return scene_.walls.is_clear(p, p_up, q, q_up) && is_above_ground(p, p_up, q, q_up);
  }

  double ground_at(Spot x) const {
    if (scene_.terrain.height_mm.empty()) return 0;
    const auto mm = [](double m) { return static_cast<std::int32_t>(std::lround(m * kMmPerMetre)); };
    return height_m(scene_.terrain, {mm(x.x), mm(x.y)});
  }

  /// Asked at each half step of the terrain: only what is called proven depends on it.
  bool is_above_ground(Spot p, double p_up, Spot q, double q_up) const {
    if (scene_.terrain.height_mm.empty()) return true;
    const double steps = std::ceil(length_of(q.x - p.x, q.y - p.y) / metres(scene_.terrain.step_mm) * 2);
    for (double i = 1; i < steps; ++i)
      if (p_up + (q_up - p_up) * i / steps <
          ground_at({std::lerp(p.x, q.x, i / steps), std::lerp(p.y, q.y, i / steps)}))
        return false;
    return true;
  }

  const Scene& scene_;
  const RoofOptions& options_;
  Horizon horizon_;
  std::vector<Part> parts_, close_parts_;
  double least_m_ = 0, eye_m_ = 0;
  std::uint32_t pairs_ = 0;  // from this sector
  bool is_last_round_ = false;
  SegmentTree rim_;
  std::vector<State> state_;
  std::vector<std::uint32_t> found_, unknown_in_;  // unknown_in_: showings that are not known, per house
  std::vector<Effort> effort_;                     // per showing
  std::vector<std::uint32_t> blocker_;             // per wall, the house that hid it last
  std::vector<Crossing> crossings_;
};

}  // namespace

RoofLists sights_over_roofs(const City& city, const SightLists& level, const RoofOptions& options) {
  RoofLists lists;
  lists.visible.resize(city.sectors.size());
  const double begin = thread_seconds();
  const Scene scene(city, options);
  lists.scene_s = thread_seconds() - begin;
  const unsigned threads = thread_count(options.threads);
  std::vector<Explorer> explorers;
  for (unsigned t = 0; t < threads; ++t) explorers.emplace_back(scene, city.sectors.size(), options);
  run_parallel(city.sectors.size(), threads, [&](std::size_t sector, unsigned thread) {
    if (sector % options.every != 0) return;
    lists.visible[sector] = explorers[thread].run(city, static_cast<std::uint32_t>(sector), level);
  });
  for (const auto& explorer : explorers) {
    lists.horizons += explorer.horizons;
    lists.tests += explorer.tests;
    lists.fine_tests += explorer.fine_tests;
    lists.rays += explorer.rays;
    lists.first_s += explorer.first_s;
    lists.closer_s += explorer.closer_s;
    lists.pairs_s += explorer.pairs_s;
  }
  return lists;
}

}  // namespace vicus
