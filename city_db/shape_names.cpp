#include "city_db/shape_names.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "city_db/rules_exact.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kCellMm = 32'000;

/// A piece of a named street's centre line.
struct Segment {
  PlanPoint a, b;
  std::uint32_t name;
};

/// Where streets of two names meet; within `radius` of it, neither is blamed for the other's sector.
struct Crossing {
  PlanPlace at;
  std::uint32_t name, other;
  double radius = 0;
};

struct Lengths {
  double in_w = 0, outside_cores = 0, borne_outside_cores = 0, borne_strict = 0, borne_all = 0;
};

bool meet(const Segment& s, const Segment& t, PlanPlace& at) {
  using rules::orient, rules::sign;
  const auto s_a = orient(t.a, t.b, s.a), s_b = orient(t.a, t.b, s.b);
  if (sign(s_a) * sign(s_b) > 0 || sign(orient(s.a, s.b, t.a)) * sign(orient(s.a, s.b, t.b)) > 0) return false;
  for (const PlanPoint p : {s.a, s.b})
    for (const PlanPoint q : {t.a, t.b})
      if (p == q) return at = place_of(p), true;
  if (s_a == s_b) return false;  // on one line
  const double f = double(s_a) / (double(s_a) - double(s_b));
  at = {s.a.x + f * (double(s.b.x) - s.a.x), s.a.y + f * (double(s.b.y) - s.a.y)};
  return true;
}

std::vector<Segment> named_segments(const City& city, std::vector<std::string>& names) {
  std::map<std::string, std::uint32_t> numbers;
  for (const auto& street : city.streets)
    if (!street.name.empty()) numbers.emplace(street.name, 0);
  for (auto& [name, number] : numbers) {
    number = static_cast<std::uint32_t>(names.size());
    names.push_back(name);
  }
  std::vector<Segment> segments;
  for (const auto& street : city.streets)
    for (std::size_t i = 0; !street.name.empty() && i + 1 < street.line.size(); ++i)
      if (street.line[i] != street.line[i + 1])
        segments.push_back({street.line[i], street.line[i + 1], numbers[street.name]});
  return segments;
}

std::vector<Crossing> find_crossings(const std::vector<Segment>& segments, const GroundMap& ground) {
  rules::CellIndex cells(kCellMm);
  for (std::uint32_t i = 0; i < segments.size(); ++i) cells.add_segment(i, segments[i].a, segments[i].b);
  cells.finish();
  std::vector<Crossing> crossings;
  for (std::size_t cell = 0; cell < cells.cell_count(); ++cell) {
    const auto ids = cells.ids(cell);
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        const Segment &s = segments[ids[i]], &t = segments[ids[j]];
        PlanPlace at;
        if (s.name != t.name && meet(s, t, at))
          crossings.push_back({at, std::min(s.name, t.name), std::max(s.name, t.name)});
      }
  }
  const auto key = [](const Crossing& c) { return std::tie(c.at.x, c.at.y, c.name, c.other); };
  std::sort(crossings.begin(), crossings.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  crossings.erase(
      std::unique(crossings.begin(), crossings.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
      crossings.end());
  std::erase_if(crossings, [&](const Crossing& c) { return ground.sector_at(c.at) == kNoSector; });
  for (auto& c : crossings) c.radius = 2 * ground.clearance_mm(c.at);
  return crossings;
}

/// Where the segment enters and leaves the disc.
void add_disc(const Segment& s, const Crossing& c, std::vector<double>& fractions) {
  const double dx = double(s.b.x) - s.a.x, dy = double(s.b.y) - s.a.y, px = s.a.x - c.at.x, py = s.a.y - c.at.y;
  const double a = dx * dx + dy * dy, b = px * dx + py * dy,
               rest = b * b - a * (px * px + py * py - c.radius * c.radius);
  if (rest <= 0) return;
  for (const double t : {(-b - std::sqrt(rest)) / a, (-b + std::sqrt(rest)) / a})
    if (t > 0 && t < 1) fractions.push_back(t);
}

/// Discs by the cells they reach into.
rules::CellIndex index_discs(const std::vector<Crossing>& crossings) {
  rules::CellIndex cells(kCellMm);
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    const auto& c = crossings[i];
    PlanBox box;
    box.add({static_cast<std::int32_t>(c.at.x - c.radius), static_cast<std::int32_t>(c.at.y - c.radius)});
    box.add({static_cast<std::int32_t>(c.at.x + c.radius), static_cast<std::int32_t>(c.at.y + c.radius)});
    cells.add_box(i, box);
  }
  cells.finish();
  return cells;
}

class Survey {
 public:
  Survey(const City& city, const GroundMap& ground)
      : city_(city),
        ground_(ground),
        segments_(named_segments(city, names_)),
        crossings_(find_crossings(segments_, ground)),
        discs_(index_discs(crossings_)),
        lengths_(names_.size()) {}

  std::vector<Lengths> run() {
    for (const auto& segment : segments_) walk(segment);
    return lengths_;
  }

 private:
  void walk(const Segment& s) {
    std::vector<std::uint32_t> near;
    discs_.visit_segment(s.a, s.b, [&](std::int32_t ix, std::int32_t iy) {
      for (const auto id : discs_.ids_at(ix, iy))
        if (crossings_[id].name == s.name || crossings_[id].other == s.name) near.push_back(id);
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<double> stops{0, 1};
    ground_.add_crossings(s.a, s.b, stops);
    for (const auto id : near) add_disc(s, crossings_[id], stops);
    std::sort(stops.begin(), stops.end());
    const double dx = double(s.b.x) - s.a.x, dy = double(s.b.y) - s.a.y, length = std::hypot(dx, dy);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double middle = (stops[i] + stops[i + 1]) / 2;
      count({s.a.x + middle * dx, s.a.y + middle * dy}, (stops[i + 1] - stops[i]) * length, s.name, near);
    }
  }

  void count(PlanPlace at, double length, std::uint32_t name, const std::vector<std::uint32_t>& near) {
    const auto index = ground_.sector_at(at);
    if (index == kNoSector) return;
    const Sector& sector = city_.sectors[index];
    const bool is_core =
        sector.kind == SectorKind::crossroads || sector.kind == SectorKind::square ||
        std::any_of(near.begin(), near.end(), [&](auto id) {
          return std::hypot(at.x - crossings_[id].at.x, at.y - crossings_[id].at.y) < crossings_[id].radius;
        });
    const bool bears_strictly = sector.name == names_[name];
    const bool bears =
        bears_strictly || std::find(sector.names.begin(), sector.names.end(), names_[name]) != sector.names.end();
    Lengths& sum = lengths_[name];
    sum.in_w += length;
    if (bears_strictly) sum.borne_strict += length;
    if (bears) sum.borne_all += length;
    if (is_core) return;
    sum.outside_cores += length;
    if (bears) sum.borne_outside_cores += length;
  }

  const City& city_;
  const GroundMap& ground_;
  std::vector<std::string> names_;
  std::vector<Segment> segments_;
  std::vector<Crossing> crossings_;
  rules::CellIndex discs_;
  std::vector<Lengths> lengths_;
};

}  // namespace

NamedStreets measure_named_streets(const City& city, const GroundMap& ground) {
  const auto lengths = Survey(city, ground).run();
  Lengths total;
  std::vector<double> shares;
  for (const auto& l : lengths) {
    total.in_w += l.in_w;
    total.outside_cores += l.outside_cores;
    total.borne_outside_cores += l.borne_outside_cores;
    total.borne_strict += l.borne_strict;
    total.borne_all += l.borne_all;
    if (l.outside_cores > kMmPerMetre) shares.push_back(l.borne_outside_cores / l.outside_cores);
  }
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  return {total.in_w / kMmPerMetre,
          total.outside_cores / kMmPerMetre,
          share(total.borne_outside_cores, total.outside_cores),
          share(total.borne_strict, total.in_w),
          share(total.borne_all, total.in_w),
          spread_of(std::move(shares))};
}

}  // namespace vicus
