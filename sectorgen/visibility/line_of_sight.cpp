#include "sectorgen/visibility/line_of_sight.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "city_db/run_parallel.hpp"
#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/visibility/bundle.hpp"
#include "sectorgen/visibility/rim_map.hpp"

namespace vicus {
namespace {

/// A directed line in lowest terms, so that equal lines are equal.
struct Line {
  std::int64_t dx, dy, offset;
  bool operator==(const Line&) const = default;
};
struct LineHash {
  std::size_t operator()(const Line& l) const {
    const auto mix = [](std::uint64_t h, std::int64_t v) {
      return (h ^ static_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15ULL;
    };
    std::uint64_t h = mix(mix(mix(1, l.dx), l.dy), l.offset);
    return h ^ (h >> 29);
  }
};
Line line_through(PlanPoint p, PlanPoint q) {
  std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y;
  const std::int64_t divisor = std::gcd(dx, dy);
  dx /= divisor;
  dy /= divisor;
  return {dx, dy, p.x * dy - p.y * dx};
}

/// A branch to come back to: the side to enter and the chains, kept in the search's store.
struct Branch {
  std::uint32_t side;
  std::size_t left_begin, right_begin;  // in the store; the right chain ends where the next branch begins
};

using Flooded = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // sector, group

class Search {
 public:
  Search(const SightMap& map, const LookMap& looks, const SightOptions& options)
      : map_(map),
        own_groups_(looks.own_groups),
        ground_(map, looks),
        budget_(options.step_budget),
        is_counting_(options.count_cells),
        seen_(map.sector_count(), kNowhere),
        met_(map.groups.size(), kNowhere),
        is_house_found_(map.owner.size(), 0) {}

  /// false: the budget is used up.
  bool run(std::uint32_t sector) {
    start(sector);
    steps_ = 0;
    lines_.clear();
    followed_.clear();
    for (const std::uint32_t c : ground_.own_cells())
      for (const std::uint32_t side : ground_.cell(c).beyond) {
        if (side >= kWall || ground_.cell(side >> 2).sector == sector) continue;
        if (!look_through(side)) return false;
      }
    return true;
  }

  std::vector<std::uint32_t> found() {
    std::sort(found_.begin(), found_.end());
    return found_;
  }
  std::vector<std::uint32_t> houses() {
    std::sort(houses_.begin(), houses_.end());
    return houses_;
  }
  /// After a flood: groups of houses at the grounds of sectors.
  const Flooded& flooded() const { return flooded_; }
  std::uint64_t steps() const { return steps_; }
  std::uint64_t cells = 0;  // different ones of each sector, where counted

  /// Every sector that a walk through sides not wholly behind one side of the rim reaches: no line is missed.
  void flood(std::uint32_t sector) {
    std::fill(seen_.begin(), seen_.end(), kNowhere);
    std::fill(met_.begin(), met_.end(), kNowhere);
    flooded_.clear();
    start(sector);
    std::vector<std::uint32_t> entered(ground_.size(), kNowhere), queue;
    for (const std::uint32_t c : ground_.own_cells())
      for (std::uint32_t k = 0; k < 3; ++k) {
        const LookCell& from = ground_.cell(c);
        const std::uint32_t side = from.beyond[k];
        if (side >= kWall || ground_.cell(side >> 2).sector == sector) continue;
        const PlanPoint a = from.corner[(k + 1) % 3], b = from.corner[(k + 2) % 3];
        const std::uint32_t stamp = 4 * c + k;
        queue.assign(1, side >> 2);
        entered[side >> 2] = stamp;
        while (!queue.empty()) {
          const LookCell& cell = ground_.cell(queue.back());
          queue.pop_back();
          flood(cell);
          for (std::size_t s = 0; s < 3; ++s) {
            if (cell.beyond[s] >= kWall || entered[cell.beyond[s] >> 2] == stamp) continue;
            // The source lies left of ab; a line through ab goes on to the right.
            if (orient(a, b, cell.corner[(s + 1) % 3]) > 0 && orient(a, b, cell.corner[(s + 2) % 3]) > 0) continue;
            entered[cell.beyond[s] >> 2] = stamp;
            queue.push_back(cell.beyond[s] >> 2);
          }
        }
      }
  }

 private:
  /// On a sector's ground a house is seen only where the sector is: that is settled when its list is.
  void flood(const LookCell& cell) {
    const auto add = [&](std::uint32_t sector, std::uint32_t group) {
      if (sector == kNowhere)
        meet(group);
      else
        flooded_.insert({sector, group});
    };
    if (cell.sector != kNowhere) mark(cell.sector);
    for (std::uint32_t p = cell.first_piece; p < cell.pieces_behind; ++p) {
      const GroundPiece& piece = ground_.piece(p);
      if (piece.sector != kNowhere) mark(piece.sector);
      if (piece.group != 0) add(piece.sector, piece.group);
    }
    for (const std::uint32_t side : cell.beyond)
      if (side >= kWall && side != kNowhere) add(cell.sector, side - kWall);
  }

  /// Nothing is found but the sector, and what stands at its ground.
  void start(std::uint32_t sector) {
    source_ = sector;
    found_.clear();
    for (const std::uint32_t house : houses_) is_house_found_[house] = 0;
    houses_.clear();
    mark(sector);
    meet(0);
    for (const std::uint32_t group : own_groups_[sector]) meet(group);
    ground_.turn_to(sector);
    if (is_counting_) entered_.assign(ground_.size(), 0);
  }

  void mark(std::uint32_t sector) {
    if (seen_[sector] == source_) return;
    seen_[sector] = source_;
    found_.push_back(sector);
  }
  /// What the lines meet in a cell that they enter.
  void mark(const LookCell& cell, const Wedge& lines) {
    if (is_counting_) {
      char& entered = entered_[ground_.index_of(cell)];
      cells += entered == 0;
      entered = 1;
    }
    if (cell.sector != kNowhere) mark(cell.sector);
    for (std::uint32_t p = cell.first_piece; p < cell.pieces_behind; ++p) {
      const GroundPiece& piece = ground_.piece(p);
      const bool is_new = piece.sector != kNowhere && seen_[piece.sector] != source_;
      if ((!is_new && met_[piece.group] == source_) || !meets(piece.corner, cell.corner, lines)) continue;
      if (is_new) mark(piece.sector);
      meet(piece.group);
    }
  }
  void meet_wall(std::uint32_t side) {
    if (side != kNowhere) meet(side - kWall);
  }
  void meet(std::uint32_t group) {
    if (met_[group] == source_) return;
    met_[group] = source_;
    for (const std::uint32_t house : map_.groups[group]) {
      if (is_house_found_[house] != 0) continue;
      is_house_found_[house] = 1;
      houses_.push_back(house);
    }
  }

  bool look_through(std::uint32_t side) {
    const LookCell& first = ground_.cell(side >> 2);
    bundle_.left.start(first.corner[((side & 3) + 1) % 3]);
    bundle_.right.start(first.corner[((side & 3) + 2) % 3]);
    for (;;) {
      side = enter(side);
      if (++steps_ > budget_) {
        branches_.clear();
        store_.clear();
        return false;
      }
      if (side != kNowhere) continue;
      if (branches_.empty()) return true;
      side = take_branch();
    }
  }

  /// Enters the cell by that side; says by which side to go on, and keeps the other way for later where both are open.
  std::uint32_t enter(std::uint32_t side) {
    const LookCell& cell = ground_.cell(side >> 2);
    const std::uint32_t s = side & 3;
    // Back in the sector: what leaves it again is in the bundle that begins at the side by which it leaves.
    if (cell.sector == source_) return kNowhere;
    mark(cell, bundle_.beyond(cell.corner[(s + 1) % 3], cell.corner[(s + 2) % 3]));
    const PlanPoint apex = cell.corner[s];
    const std::uint32_t to_right = cell.beyond[s == 2 ? 0 : s + 1], to_left = cell.beyond[s == 0 ? 2 : s - 1];
    const std::int64_t beyond_left = bundle_.beyond_leftmost(apex), beyond_right = bundle_.beyond_rightmost(apex);
    bool go_right = beyond_right >= 0;  // the apex is the left end there
    bool go_left = beyond_left <= 0;
    if (go_right && to_right >= kWall) meet_wall(to_right), go_right = false;
    if (go_left && to_left >= kWall) meet_wall(to_left), go_left = false;
    if (go_right && go_left) keep_branch(to_left, beyond_right > 0, apex);
    if (go_right) {
      if (beyond_left < 0) bundle_.narrow_left(apex);
      return beyond_left < 0 && bundle_.is_line() ? follow_line(bundle_, to_right) : to_right;
    }
    if (!go_left) return kNowhere;
    if (beyond_right > 0) bundle_.narrow_right(apex);
    return beyond_right > 0 && bundle_.is_line() ? follow_line(bundle_, to_left) : to_left;
  }

  /// One line needs no chains: each side that it passes once, whichever way round corners it touches. Along fronts in
  /// line, with niches between, the ways are two to the power of the niches.
  std::uint32_t follow_line(const Bundle& bundle, std::uint32_t side) {
    const PlanPoint p = bundle.right.front(), q = bundle.left.back();
    const auto line = lines_.emplace(line_through(p, q), static_cast<std::uint32_t>(lines_.size())).first->second;
    const auto is_new = [&](std::uint32_t entry) {
      return followed_.insert((std::uint64_t{line} << 32) | entry).second;
    };
    line_queue_.clear();
    if (is_new(side)) line_queue_.push_back(side);
    while (!line_queue_.empty()) {
      const std::uint32_t entry = line_queue_.back();
      const LookCell& cell = ground_.cell(entry >> 2);
      line_queue_.pop_back();
      ++steps_;
      if (cell.sector == source_) continue;
      mark(cell, {p, q, p, q, cell.corner[((entry & 3) + 1) % 3], cell.corner[((entry & 3) + 2) % 3]});
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t beyond = cell.beyond[k];
        if (orient(p, q, cell.corner[(k + 1) % 3]) > 0 || orient(p, q, cell.corner[(k + 2) % 3]) < 0) continue;
        if (beyond >= kWall)
          meet_wall(beyond);
        else if (is_new(beyond))
          line_queue_.push_back(beyond);
      }
    }
    return kNowhere;
  }

  void keep_branch(std::uint32_t side, bool narrows, PlanPoint apex) {
    const auto keep = [&](const Chain& chain) {
      store_.insert(store_.end(), chain.points.begin() + static_cast<std::ptrdiff_t>(chain.first), chain.points.end());
    };
    Branch branch{side, store_.size(), 0};
    if (narrows) {
      narrowed_ = bundle_;
      narrowed_.narrow_right(apex);
      if (narrowed_.is_line()) {
        follow_line(narrowed_, side);
        return;
      }
      keep(narrowed_.left);
      branch.right_begin = store_.size();
      keep(narrowed_.right);
    } else {
      keep(bundle_.left);
      branch.right_begin = store_.size();
      keep(bundle_.right);
    }
    branches_.push_back(branch);
  }

  std::uint32_t take_branch() {
    const Branch branch = branches_.back();
    branches_.pop_back();
    const auto at = [&](std::size_t i) { return store_.begin() + static_cast<std::ptrdiff_t>(i); };
    bundle_.left.points.assign(at(branch.left_begin), at(branch.right_begin));
    bundle_.right.points.assign(at(branch.right_begin), store_.end());
    bundle_.left.first = bundle_.right.first = 0;
    store_.resize(branch.left_begin);
    return branch.side;
  }

  const SightMap& map_;
  const std::vector<std::vector<std::uint32_t>>& own_groups_;
  RimMap ground_;
  std::uint64_t budget_, steps_ = 0;
  std::uint32_t source_ = 0;
  bool is_counting_;
  std::vector<char> entered_;  // per cell: by a look of this sector, where counted
  std::vector<std::uint32_t> seen_, found_;
  std::vector<std::uint32_t> met_, houses_;  // per group: met from this sector; the houses of these
  std::vector<char> is_house_found_;
  Flooded flooded_;
  Bundle bundle_, narrowed_;
  std::vector<Branch> branches_;
  std::vector<PlanPoint> store_;
  std::unordered_map<Line, std::uint32_t, LineHash> lines_;
  std::unordered_set<std::uint64_t> followed_;  // line and side
  std::vector<std::uint32_t> line_queue_;
};

/// Houses whose owner is in sight come with it.
void leave_out_houses_of_listed(SightLists& lists, const SightMap& map) {
  for (std::size_t s = 0; s < lists.houses.size(); ++s)
    std::erase_if(lists.houses[s], [&](std::uint32_t house) {
      return std::binary_search(lists.visible[s].begin(), lists.visible[s].end(), map.owner[house]);
    });
}

/// A sector over its budget is seen by those that it sees: their lists say so exactly. Two over budget keep each other
/// where both floods reach.
void mend_by_symmetry(SightLists& lists, const std::vector<char>& over) {
  const auto has = [&](std::uint32_t s, std::uint32_t t) {
    return std::binary_search(lists.visible[s].begin(), lists.visible[s].end(), t);
  };
  std::vector<std::vector<std::uint32_t>> mended;
  for (const std::uint32_t s : lists.over_budget) {
    mended.emplace_back();
    for (std::uint32_t t = 0; t < lists.visible.size(); ++t)
      if (has(t, s) && (!over[t] || has(s, t))) mended.back().push_back(t);
  }
  for (std::size_t i = 0; i < mended.size(); ++i) lists.visible[lists.over_budget[i]] = std::move(mended[i]);
}

void add_houses_of_listed_grounds(SightLists& lists, std::uint32_t s, const Flooded& flooded, const SightMap& map) {
  auto& houses = lists.houses[s];
  for (const auto& [ground, group] : flooded)
    if (std::binary_search(lists.visible[s].begin(), lists.visible[s].end(), ground))
      houses.insert(houses.end(), map.groups[group].begin(), map.groups[group].end());
  std::sort(houses.begin(), houses.end());
  houses.erase(std::unique(houses.begin(), houses.end()), houses.end());
}

}  // namespace

SightLists lines_of_sight(const SightMap& map, const SightOptions& options) {
  const std::size_t sectors = map.sector_count();
  const unsigned threads = thread_count(options.threads);
  SightLists lists;
  lists.visible.resize(sectors);
  lists.houses.resize(sectors);
  const LookMap looks = make_look_map(map);
  std::vector<Search> searches(threads, Search(map, looks, options));
  std::vector<std::uint64_t> steps(sectors, 0);
  std::vector<char> over(sectors, 0);
  std::vector<Flooded> flooded(sectors);
  run_parallel(sectors, threads, [&](std::size_t i, unsigned thread) {
    const auto sector = static_cast<std::uint32_t>(i);
    Search& search = searches[thread];
    if (!search.run(sector)) {
      over[i] = 1;
      search.flood(sector);
      flooded[i] = search.flooded();
    }
    steps[i] = search.steps();
    lists.visible[i] = search.found();
    lists.houses[i] = search.houses();
  });
  for (const Search& search : searches) lists.cells += search.cells;
  for (std::uint32_t i = 0; i < sectors; ++i) {
    lists.steps += steps[i];
    if (over[i]) lists.over_budget.push_back(i);
  }
  mend_by_symmetry(lists, over);
  for (const std::uint32_t s : lists.over_budget) add_houses_of_listed_grounds(lists, s, flooded[s], map);
  leave_out_houses_of_listed(lists, map);
  return lists;
}

}  // namespace vicus
