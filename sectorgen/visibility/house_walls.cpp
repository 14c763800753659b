#include "sectorgen/visibility/house_walls.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "city_db/terrain.hpp"

namespace vicus {
namespace {

constexpr double kDoubt_m = 0.001;  // the lattice's step: more than any rounding of doubles within 2^30 mm

constexpr double kAbove_m = 0.02;  // by how much a line must clear a roof to count as clear

double cross(Spot a, Spot b, Spot p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

double distance2_to(const HouseWall& w, Spot p) {
  const double dx = w.b.x - w.a.x, dy = w.b.y - w.a.y;
  const double t = std::clamp(((p.x - w.a.x) * dx + (p.y - w.a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double ex = w.a.x + t * dx - p.x, ey = w.a.y + t * dy - p.y;
  return ex * ex + ey * ey;
}

HouseBody body_of(const Building& b, const Terrain& terrain, const std::vector<RoofTriangle>& roof) {
  double eave = b.eave_m > b.base_m ? std::min(b.eave_m, b.height_m) : b.height_m, top = std::max(b.eave_m, b.height_m);
  double sure_top = eave;
  if (!roof.empty()) {
    eave = sure_top = roof.front().least_m();
    for (const auto& t : roof) {
      eave = std::min(eave, t.least_m());
      sure_top = std::max(sure_top, t.most_m());
    }
    top = sure_top;
  }
  PlanBox box;
  for (const PlanPoint p : b.footprint.outer) box.add(p);
  const HeightRange ground = box.is_empty() ? HeightRange{} : height_range(terrain, box);
  HouseBody body;
  body.base_m = b.base_m;
  body.sure_zero_m = ground.least_m;
  body.most_zero_m = ground.greatest_m;
  body.sure_eave_m = ground.least_m + eave;
  body.sure_top_m = ground.least_m + sure_top;
  body.most_eave_m = ground.greatest_m + (roof.empty() ? top : eave);
  body.most_top_m = ground.greatest_m + top;
  return body;
}

}  // namespace

HouseWalls::HouseWalls(const City& city) {
  struct Side {
    PlanPoint a, b;
    std::uint32_t wall;
  };
  std::vector<Side> sides;
  PlanBox box;
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h) {
    const Building& building = city.buildings[h];
    const std::vector<RoofTriangle> roof = roof_triangles(building);
    HouseBody body = body_of(building, city.terrain, roof);
    body.first_triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.insert(triangles_.end(), roof.begin(), roof.end());
    body.last_triangle = static_cast<std::uint32_t>(triangles_.size());
    body.first_wall = static_cast<std::uint32_t>(walls_.size());
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        sides.push_back({a, b, static_cast<std::uint32_t>(walls_.size())});
        walls_.push_back({spot_of(a), spot_of(b), h, kNoRoof_m, kNoRoof_m});
        if (body.stands()) walls_.back().sure_top_m = std::nextafter(static_cast<float>(body.sure_top_m), 1e9F);
        box.add(a);
      }
    };
    add(building.footprint.outer);
    for (const auto& hole : building.footprint.holes) add(hole);
    body.last_wall = static_cast<std::uint32_t>(walls_.size());
    houses_.push_back(body);
  }
  // Party walls: the house on the other side has the same edge the other way round.
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  for (const Side& side : sides) {
    auto twin = std::lower_bound(sides.begin(), sides.end(), std::pair(side.b, side.a),
                                 [](const Side& x, const auto& key) { return std::pair(x.a, x.b) < key; });
    for (; twin != sides.end() && twin->a == side.b && twin->b == side.a; ++twin)
      if (const HouseBody& other = houses_[walls_[twin->wall].house]; other.stands())
        walls_[side.wall].beyond_m =
            std::max(walls_[side.wall].beyond_m, std::nextafter(static_cast<float>(other.sure_eave_m), kNoRoof_m));
  }
  if (box.is_empty()) box.add({0, 0});
  left_ = metres(box.min.x) - 1;
  bottom_ = metres(box.min.y) - 1;
  const double width = metres(box.max.x) + 1 - left_, height = metres(box.max.y) + 1 - bottom_;
  columns_ = static_cast<std::int64_t>(width / cell_m_) + 1;
  rows_ = static_cast<std::int64_t>(height / cell_m_) + 1;
  // A village in a country of fields: cells no more than a few times the walls.
  while (columns_ * rows_ > 4096 + 8 * static_cast<std::int64_t>(walls_.size())) {
    cell_m_ *= 2;
    columns_ = static_cast<std::int64_t>(width / cell_m_) + 1;
    rows_ = static_cast<std::int64_t>(height / cell_m_) + 1;
  }
  cell_begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const auto& w : walls_) visit_cells(w.a, w.b, [&](std::size_t cell) { return ++cell_begin_[cell + 1], false; });
  for (std::size_t c = 0; c + 1 < cell_begin_.size(); ++c) cell_begin_[c + 1] += cell_begin_[c];
  cell_walls_.resize(cell_begin_.back());
  std::vector<std::uint32_t> at(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    visit_cells(walls_[w].a, walls_[w].b, [&](std::size_t cell) { return cell_walls_[at[cell]++] = walls_[w], false; });
}

std::size_t HouseWalls::cell_at(std::int64_t column, std::int64_t row) const {
  return static_cast<std::size_t>(row * columns_ + column);
}

/// The cells within 1 mm of the segment, row by row from p to q; ends when visit says true.
template <class Visit>
void HouseWalls::visit_cells(Spot p, Spot q, Visit visit) const {
  const auto row_of = [&](double y) {
    return std::clamp(static_cast<std::int64_t>(std::floor((y - bottom_) / cell_m_)), std::int64_t{0}, rows_ - 1);
  };
  const auto column_of = [&](double x) {
    return std::clamp(static_cast<std::int64_t>(std::floor((x - left_) / cell_m_)), std::int64_t{0}, columns_ - 1);
  };
  const double low_y = std::min(p.y, q.y), high_y = std::max(p.y, q.y);
  const double slope = p.y != q.y ? (q.x - p.x) / (q.y - p.y) : 0;
  const std::int64_t first_row = row_of(low_y - kDoubt_m), last_row = row_of(high_y + kDoubt_m);
  for (std::int64_t i = 0; i <= last_row - first_row; ++i) {
    const std::int64_t row = p.y <= q.y ? first_row + i : last_row - i;
    const double low = bottom_ + static_cast<double>(row) * cell_m_ - kDoubt_m, high = low + cell_m_ + 2 * kDoubt_m;
    double from = p.x, to = q.x;
    if (p.y != q.y) {
      from = p.x + (std::clamp(low, low_y, high_y) - p.y) * slope;
      to = p.x + (std::clamp(high, low_y, high_y) - p.y) * slope;
    }
    const std::int64_t first = column_of(std::min(from, to) - 2 * kDoubt_m);
    const std::int64_t last = column_of(std::max(from, to) + 2 * kDoubt_m);
    for (std::int64_t k = 0; k <= last - first; ++k)
      if (visit(cell_at(p.x <= q.x ? first + k : last - k, row))) return;
  }
}

/// Over the house's roof the line does not stay above it.
bool HouseWalls::roof_stops(std::uint32_t house, Spot p, double p_up_m, Spot q, double q_up_m, bool is_goal) const {
  const HouseBody& body = houses_[house];
  const double zero_m = is_goal ? body.sure_zero_m : body.most_zero_m;
  const double last = is_goal ? 1 - 0.05 / std::max(0.05, length_of(q.x - p.x, q.y - p.y)) : 1;
  for (std::uint32_t i = body.first_triangle; i < body.last_triangle; ++i) {
    const RoofTriangle& t = triangles_[i];
    if (std::min(p_up_m, q_up_m) > zero_m + t.most_m() + kAbove_m) continue;
    const Stretch over = t.stretch(p, q);
    for (const double at : {over.from, std::min(over.to, last)}) {
      if (at > over.to || at < over.from) continue;
      const double roof_m = zero_m + t.height_at({p.x + at * (q.x - p.x), p.y + at * (q.y - p.y)});
      if (p_up_m + (q_up_m - p_up_m) * at < roof_m + (is_goal ? 0 : kAbove_m)) return true;
    }
  }
  return false;
}

bool HouseWalls::is_clear(Spot p, double p_up_m, Spot q, double q_up_m, std::uint32_t goal) const {
  bool is_clear = true;
  thread_local std::vector<std::uint32_t> asked;  // whose roofs let the line pass
  asked.clear();
  visit_cells(p, q, [&](std::size_t cell) {
    for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
      const HouseWall& w = cell_walls_[i];
      const double side_a = cross(p, q, w.a), side_b = cross(p, q, w.b);
      if ((side_a > 0) == (side_b > 0)) continue;
      const double side_p = cross(w.a, w.b, p), side_q = cross(w.a, w.b, q);
      const double at = side_p / (side_p - side_q), up = p_up_m + (q_up_m - p_up_m) * at;
      if (!(at >= 0 && at <= 1)) continue;
      const HouseBody& body = houses_[w.house];
      // A line is lowest over a house where it enters or leaves it: one such place is as low.
      if (up > body.most_top_m + kAbove_m) continue;
      const bool is_goal = w.house == goal, has_roof = body.first_triangle != body.last_triangle;
      if (is_goal ? has_roof && up <= body.sure_eave_m - kAbove_m : up <= body.most_eave_m + kAbove_m) {
        is_clear = false;
        return true;
      }
      if (!has_roof || std::find(asked.begin(), asked.end(), w.house) != asked.end()) continue;
      asked.push_back(w.house);
      if (!roof_stops(w.house, p, p_up_m, q, q_up_m, is_goal)) continue;
      is_clear = false;
      return true;
    }
    return false;
  });
  return is_clear;
}

namespace {

struct Hit {
  double at;
  std::uint32_t house;
  bool is_in;
  auto key() const { return std::tie(house, at, is_in); }
};

/// Where p -> q passes a wall, if it does. Points on the line count as right of it, so that a line through a corner
/// cuts one of the two walls there.
bool find_hit(Spot p, Spot q, const HouseWall& w, Hit& hit) {
  const double side_a = cross(p, q, w.a), side_b = cross(p, q, w.b);
  if ((side_a > 0) == (side_b > 0)) return false;
  const double side_p = cross(w.a, w.b, p), side_q = cross(w.a, w.b, q);
  hit = {side_p / (side_p - side_q), w.house, side_p < side_q};
  return hit.at >= 0 && hit.at <= 1;
}

void crossings_from(std::vector<Hit>& hits, std::vector<Crossing>& out) {
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.key() < b.key(); });
  hits.erase(std::unique(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.key() == b.key(); }),
             hits.end());  // a wall in several cells
  for (std::size_t i = 0; i < hits.size();) {
    const std::uint32_t house = hits[i].house;
    double from = 0;
    bool is_in = !hits[i].is_in;  // the line begins inside
    for (; i < hits.size() && hits[i].house == house; ++i) {
      if (hits[i].is_in && !is_in) from = hits[i].at;
      if (!hits[i].is_in && is_in) out.push_back({from, hits[i].at, house});
      is_in = hits[i].is_in;
    }
    if (is_in) out.push_back({from, 1, house});
  }
  std::sort(out.begin(), out.end(), [](const Crossing& a, const Crossing& b) { return a.from < b.from; });
}

}  // namespace

void HouseWalls::cut(Spot p, Spot q, double p_up_m, double rise_m, std::vector<Crossing>& out) const {
  out.clear();
  thread_local std::vector<Hit> hits;
  hits.clear();
  Hit hit{};
  visit_cells(p, q, [&](std::size_t cell) {
    for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i)
      if (find_hit(p, q, cell_walls_[i], hit) &&
          cell_walls_[i].sure_top_m >= p_up_m + (rise_m >= 0 ? rise_m * hit.at : rise_m))
        hits.push_back(hit);
    return false;
  });
  crossings_from(hits, out);
}

void HouseWalls::cut(Spot p, Spot q, std::uint32_t house, std::vector<Crossing>& out) const {
  out.clear();
  thread_local std::vector<Hit> hits;
  hits.clear();
  Hit hit{};
  for (std::uint32_t i = houses_[house].first_wall; i < houses_[house].last_wall; ++i)
    if (find_hit(p, q, walls_[i], hit)) hits.push_back(hit);
  crossings_from(hits, out);
}

bool HouseWalls::contains(std::uint32_t house, Spot x) const {
  bool is_inside = false;
  for (std::uint32_t i = houses_[house].first_wall; i < houses_[house].last_wall; ++i) {
    const HouseWall& w = walls_[i];
    if ((w.a.y > x.y) != (w.b.y > x.y) && (cross(w.a, w.b, x) > 0) == (w.b.y > w.a.y)) is_inside = !is_inside;
  }
  return is_inside;
}

/// The roof within `reach` of x is nowhere lower.
bool HouseWalls::reaches(const HouseBody& house, Spot x, double reach, double up_m) const {
  if (house.sure_eave_m >= up_m) return true;
  if (house.sure_top_m < up_m) return false;
  for (std::uint32_t i = house.first_triangle; i < house.last_triangle; ++i)
    if (house.sure_zero_m + triangles_[i].least_within(x, reach) < up_m) return false;
  return true;
}

bool HouseWalls::is_near_open_wall(std::uint32_t house, Spot x, double reach2) const {
  for (std::uint32_t i = houses_[house].first_wall; i < houses_[house].last_wall; ++i)
    if (walls_[i].beyond_m <= kNoRoof_m && distance2_to(walls_[i], x) < reach2) return true;
  return false;
}

bool HouseWalls::is_roofed(Spot x, double radius, std::uint32_t house, double up_m) const {
  if (!houses_[house].stands()) return false;
  const double reach = radius + kDoubt_m, reach2 = reach * reach;
  // Cheap and mostly enough: the house's own walls.
  if (is_near_open_wall(house, x, reach2) || !reaches(houses_[house], x, reach, up_m) || !contains(house, x))
    return false;
  const auto low_column = static_cast<std::int64_t>(std::floor((x.x - reach - left_) / cell_m_));
  const auto high_column = static_cast<std::int64_t>(std::floor((x.x + reach - left_) / cell_m_));
  const auto low_row = static_cast<std::int64_t>(std::floor((x.y - reach - bottom_) / cell_m_));
  const auto high_row = static_cast<std::int64_t>(std::floor((x.y + reach - bottom_) / cell_m_));
  if (low_column < 0 || low_row < 0 || high_column >= columns_ || high_row >= rows_) return false;
  for (std::int64_t row = low_row; row <= high_row; ++row)
    for (std::int64_t column = low_column; column <= high_column; ++column) {
      const std::size_t cell = cell_at(column, row);
      for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
        const HouseWall& w = cell_walls_[i];
        if (w.house == house || w.sure_top_m <= kNoRoof_m || distance2_to(w, x) >= reach2) continue;
        // A party wall: its other side is a wall of the other house, which is asked about in its turn.
        if (w.beyond_m <= kNoRoof_m || !reaches(houses_[w.house], x, reach, up_m)) return false;
      }
    }
  return true;
}

}  // namespace vicus
