#include "tests/support/random_partition.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace vicus::test {
namespace {

using Random = std::mt19937_64;

std::uint32_t below(Random& random, std::uint64_t n) { return static_cast<std::uint32_t>(random() % n); }

/// A directed boundary edge of a set of triangles, the set on its left.
struct HalfEdge {
  std::uint32_t from, to;
  bool used = false;
};

double angle(PlanPoint a, PlanPoint b) { return std::atan2(double(b.y) - a.y, double(b.x) - a.x); }

/// The next edge round the same part: the first one clockwise from where we came.
HalfEdge* next_edge(const Field& field, const HalfEdge& edge, std::vector<HalfEdge>& edges) {
  const auto first = std::lower_bound(edges.begin(), edges.end(), edge.to,
                                      [](const HalfEdge& e, std::uint32_t vertex) { return e.from < vertex; });
  HalfEdge* best = nullptr;
  double best_turn = 0;
  for (auto e = first; e != edges.end() && e->from == edge.to; ++e) {
    const auto& p = field.points;
    double turn = angle(p[edge.to], p[edge.from]) - angle(p[e->from], p[e->to]);
    if (turn <= 0) turn += 2 * std::acos(-1.0);
    if (!best || turn < best_turn) best = &*e, best_turn = turn;
  }
  return best;
}

double twice_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += double(a.x) * b.y - double(a.y) * b.x;
  }
  return sum;
}

bool is_inside(PlanPoint p, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (double(p.y) - a.y) * (double(b.x) - a.x) / (double(b.y) - a.y))
      inside = !inside;
  }
  return inside;
}

void deal_out(RandomCity& random_city, Random& random, std::uint32_t region_count) {
  const auto& field = random_city.field;
  const auto count = static_cast<std::uint32_t>(field.triangles.size());
  random_city.region_of.assign(count, Field::kNoTriangle);
  random_city.triangles.resize(region_count);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> frontier;  // triangle, region that wants it
  for (std::uint32_t r = 0; r < region_count; ++r) frontier.push_back({below(random, count), r});
  while (!frontier.empty()) {
    std::swap(frontier[below(random, frontier.size())], frontier.back());
    const auto [t, r] = frontier.back();
    frontier.pop_back();
    if (random_city.region_of[t] != Field::kNoTriangle) continue;
    random_city.region_of[t] = r;
    random_city.triangles[r].push_back(t);
    for (const auto n : field.neighbours[t])
      if (n != Field::kNoTriangle) frontier.push_back({n, r});
  }
}

Polygon polygon_of_region(const RandomCity& rc, std::uint32_t region) {
  return polygons_of(rc.field, rc.triangles[region], [&](auto t) { return rc.region_of[t] == region; }).front();
}

void make_records(RandomCity& rc, Random& random) {
  City& city = rc.city;
  for (std::uint32_t r = 0; r < rc.triangles.size(); ++r) {
    const auto choice = rc.triangles[r].empty() ? 99 : below(random, 100);
    const auto number = std::to_string(r);
    if (choice < 50) {
      rc.regions.push_back({RandomCity::Use::sector, static_cast<std::uint32_t>(city.sectors.size())});
      Sector sector;
      sector.id = "s" + number;
      sector.ground = polygon_of_region(rc, r);
      city.sectors.push_back(sector);
    } else if (choice < 80) {
      rc.regions.push_back({RandomCity::Use::house, static_cast<std::uint32_t>(city.buildings.size())});
      Building house;
      house.id = "b" + number;
      house.footprint = polygon_of_region(rc, r);
      house.height_m = house.eave_m = 10;
      city.buildings.push_back(house);
    } else if (choice < 92) {
      rc.regions.push_back({RandomCity::Use::obstacle, static_cast<std::uint32_t>(city.obstacles.size())});
      city.obstacles.push_back(
          {static_cast<ObstacleKind>(below(random, 6)), "o" + number, 1, polygon_of_region(rc, r)});
    } else {
      rc.regions.push_back({RandomCity::Use::outside, 0});
    }
  }
  std::vector<std::uint32_t> inside;
  const auto is_inside_domain = [&](std::uint32_t t) {
    return rc.regions[rc.region_of[t]].use != RandomCity::Use::outside;
  };
  for (std::uint32_t t = 0; t < rc.region_of.size(); ++t)
    if (is_inside_domain(t)) inside.push_back(t);
  city.domain = polygons_of(rc.field, inside, is_inside_domain);
}

BorderKind border_of(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::water:
      return BorderKind::bank;
    case ObstacleKind::wall:
      return BorderKind::wall;
    case ObstacleKind::island:
      return BorderKind::edge;
    default:
      return BorderKind::fence;
  }
}

/// One border or gate per ground edge, so that twins need no thought.
void make_edges(RandomCity& rc) {
  City& city = rc.city;
  for (std::uint32_t r = 0; r < rc.regions.size(); ++r) {
    if (rc.regions[r].use != RandomCity::Use::sector) continue;
    const auto& id = city.sectors[rc.regions[r].index].id;
    for (const auto t : rc.triangles[r])
      for (std::size_t k = 0; k < 3; ++k) {
        const auto n = rc.field.neighbours[t][k];
        const std::vector<PlanPoint> line{rc.field.points[rc.field.triangles[t][k]],
                                          rc.field.points[rc.field.triangles[t][(k + 1) % 3]]};
        const auto name = [&](std::uint32_t from, std::uint32_t to) {
          return "g" + std::to_string(from) + "-" + std::to_string(to);
        };
        const auto other =
            n == Field::kNoTriangle ? RandomCity::Region{RandomCity::Use::outside, 0} : rc.regions[rc.region_of[n]];
        if (n != Field::kNoTriangle && rc.region_of[n] == r) continue;
        if (other.use == RandomCity::Use::sector)
          city.gates.push_back({name(t, n), id, city.sectors[other.index].id, name(n, t), GateKind::street, line});
        else if (other.use == RandomCity::Use::outside)
          city.gates.push_back({name(t, n) + "k" + std::to_string(k), id, "", "", GateKind::end_of_city, line});
        else if (other.use == RandomCity::Use::house)
          city.borders.push_back({id, city.buildings[other.index].id, BorderKind::facade, 0, line});
        else
          city.borders.push_back({id, "", border_of(city.obstacles[other.index].kind), 0, line});
      }
  }
}

}  // namespace

Field random_field(std::uint64_t seed, std::uint32_t side) {
  Random random(seed);
  Field field;
  const std::int32_t step = 1000, jitter = 200;  // mm; at 200 no triangle turns over
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) {
      const auto moved = [&](std::uint32_t i) {
        return static_cast<std::int32_t>(i) * step + static_cast<std::int32_t>(below(random, 2 * jitter + 1)) - jitter;
      };
      const std::int32_t px = moved(x), py = moved(y);
      field.points.push_back({px, py});
    }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, std::size_t>> open_edges;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, c = b + side + 1, d = c - 1;
      if (random() % 2)
        field.triangles.insert(field.triangles.end(), {{a, b, c}, {a, c, d}});
      else
        field.triangles.insert(field.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  field.neighbours.assign(field.triangles.size(), {Field::kNoTriangle, Field::kNoTriangle, Field::kNoTriangle});
  for (std::uint32_t t = 0; t < field.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = field.triangles[t][k], to = field.triangles[t][(k + 1) % 3];
      if (const auto twin = open_edges.find({to, from}); twin != open_edges.end()) {
        field.neighbours[t][k] = twin->second.first;
        field.neighbours[twin->second.first][twin->second.second] = t;
        open_edges.erase(twin);
      } else {
        open_edges[{from, to}] = {t, k};
      }
    }
  return field;
}

std::vector<Polygon> polygons_of(const Field& field, const std::vector<std::uint32_t>& among,
                                 const std::function<bool(std::uint32_t)>& is_in) {
  std::vector<HalfEdge> edges;
  for (const auto t : among)
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto n = field.neighbours[t][k]; n == Field::kNoTriangle || !is_in(n))
        edges.push_back({field.triangles[t][k], field.triangles[t][(k + 1) % 3]});
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (auto& start : edges) {
    Ring ring;
    for (HalfEdge* e = &start; !e->used; e = next_edge(field, *e, edges)) {
      e->used = true;
      ring.push_back(field.points[e->from]);
    }
    if (ring.empty()) continue;
    if (twice_area(ring) > 0)
      polygons.push_back({ring, {}});
    else
      holes.push_back(ring);
  }
  // A hole belongs to the smallest outer ring around it.
  std::sort(polygons.begin(), polygons.end(),
            [](const Polygon& a, const Polygon& b) { return twice_area(a.outer) < twice_area(b.outer); });
  for (const auto& hole : holes)
    for (auto& polygon : polygons) {
      const bool around =
          twice_area(polygon.outer) > -twice_area(hole) && std::all_of(hole.begin(), hole.end(), [&](PlanPoint p) {
            return is_inside(p, polygon.outer) ||
                   std::find(polygon.outer.begin(), polygon.outer.end(), p) != polygon.outer.end();
          });
      if (!around) continue;
      polygon.holes.push_back(hole);
      break;
    }
  return polygons;
}

RandomCity random_city(std::uint64_t seed, std::uint32_t side, std::uint32_t region_count) {
  RandomCity rc;
  Random random(seed ^ 0x9e3779b97f4a7c15u);
  rc.field = random_field(seed, side);
  deal_out(rc, random, region_count);
  make_records(rc, random);
  make_edges(rc);
  // A second record over a house, as of a building part: blocks may overlap.
  for (std::size_t i = 0, n = rc.city.buildings.size(); i < n; i += 5) {
    Building part = rc.city.buildings[i];
    part.id += "-part";
    part.height_m += 1;
    rc.city.buildings.push_back(part);
  }
  return rc;
}

}  // namespace vicus::test
