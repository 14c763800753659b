#include <algorithm>

#include "sectorgen/town/site.hpp"

/// Streets as ways: whole lines where they are kept, cut where a gatehouse stands on them.
namespace vicus::town {

namespace {

constexpr std::size_t kMostNodes = 400;  // of one way
constexpr double kCarriageway = 5.5;     // m from an avenue's middle to each carriageway's
constexpr double kLampEvery = 34;        // m

const char* highway_of(StreetKind kind) {
  switch (kind) {
    case StreetKind::lane:
      return "footway";
    case StreetKind::main:
      return "tertiary";
    case StreetKind::ring:
      return "secondary";
    case StreetKind::avenue:
      return "primary";
    default:
      return "residential";
  }
}

struct Stop {
  NodeId node = 0;
  bool is_gatehouse = false;
};

/// Nodes of an edge from its start to its end, junctions in their places.
std::vector<Stop> stops_of(Site& site, const Edge& e) {
  std::vector<Junction> junctions = e.junctions;
  std::sort(junctions.begin(), junctions.end(),
            [](const Junction& a, const Junction& b) { return std::pair(a.at, a.node) < std::pair(b.at, b.node); });
  std::vector<Stop> stops;
  double at = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < e.centre.size(); ++i) {
    if (i > 0) at += distance(e.centre[i - 1], e.centre[i]);
    const bool is_last = i + 1 == e.centre.size();
    while (next < junctions.size() && (junctions[next].at < at || is_last)) {
      stops.push_back({junctions[next].node, junctions[next].is_gatehouse});
      ++next;
    }
    stops.push_back({site.map.node(e.centre[i]), false});
  }
  return stops;
}

struct Crossing {
  NodeId left = 0, right = 0;
  Vec left_at, right_at;
};
using Crossings = std::unordered_map<std::size_t, Crossing>;  // by vertex; looked up only

struct Run {
  std::vector<std::size_t> edges;
};

/// Kept edges of a line in order, parted where one is missing.
std::vector<Run> runs_of(const Network& n, const std::vector<std::size_t>& edges) {
  std::vector<Run> runs;
  for (const std::size_t e : edges) {
    if (runs.empty() || n.edges[runs.back().edges.back()].to != n.edges[e].from) runs.emplace_back();
    runs.back().edges.push_back(e);
  }
  return runs;
}

void draw_lamps(Site& site, const Edge& e, double half_width) {
  const double size = length_of(e.centre);
  bool is_left = true;
  for (double at = kLampEvery / 2; at < size - 6; at += kLampEvery, is_left = !is_left) {
    Vec forward;
    const Vec p = point_along(e.centre, at, &forward);
    const double off = (half_width - 0.8) * (is_left ? 1 : -1);
    site.map.point(p + left_of(forward) * off, {{"highway", "street_lamp"}});
  }
}

void draw_street(Site& site, const Line& line, const Run& run, const Crossings& crossings) {
  const Network& n = site.network;
  std::vector<Stop> stops;
  for (const std::size_t e : run.edges) {
    const auto more = stops_of(site, n.edges[e]);
    stops.insert(stops.end(), more.begin() + (stops.empty() ? 0 : 1), more.end());
    if (line.kind != StreetKind::lane) draw_lamps(site, n.edges[e], line.half_width);
  }
  const auto meet = [&](Stop& end, std::size_t vertex, Vec before) {  // an avenue's nearer carriageway instead
    const auto c = crossings.find(vertex);
    if (c == crossings.end()) return;
    const bool is_left = distance(before, c->second.left_at) < distance(before, c->second.right_at);
    end.node = is_left ? c->second.left : c->second.right;
  };
  const Edge &first = n.edges[run.edges.front()], &last = n.edges[run.edges.back()];
  meet(stops.front(), first.from, first.centre[1]);
  meet(stops.back(), last.to, last.centre[last.centre.size() - 2]);
  const Tags tags = street_tags(line);
  std::vector<NodeId> nodes;
  bool is_inside = false;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    nodes.push_back(stops[i].node);
    const bool is_cut = stops[i].is_gatehouse || nodes.size() == kMostNodes || i + 1 == stops.size();
    if (!is_cut || nodes.size() < 2) continue;
    Tags own = tags;
    if (is_inside) own.insert(own.end(), {{"tunnel", "building_passage"}, {"maxheight", "4.2"}});
    if (stops[i].is_gatehouse) is_inside = !is_inside;
    draw_way(site, std::move(nodes), std::move(own));
    nodes.assign(1, stops[i].node);
  }
}

/// Two one-way carriageways, trees between, parted from the run's first vertex to its last.
void draw_avenue(Site& site, const Line& line, const Run& run, Crossings& crossings) {
  Network& n = site.network;
  Polyline centre;
  std::vector<std::size_t> vertex_at;  // place in `centre` of each inner vertex
  for (const std::size_t e : run.edges) {
    const Polyline& c = n.edges[e].centre;
    centre.insert(centre.end(), c.begin() + (centre.empty() ? 0 : 1), c.end());
    vertex_at.push_back(centre.size() - 1);
  }
  const Polyline left = offset_left(centre, kCarriageway), right = offset_left(centre, -kCarriageway);
  std::vector<NodeId> up{site.map.node(centre.front())}, down = up;
  for (std::size_t i = 1; i + 1 < centre.size(); ++i) {
    down.push_back(site.map.node(left[i]));
    up.push_back(site.map.node(right[i]));
    if (i % 2 == 0) site.map.point(centre[i], {{"natural", "tree"}, {"denotation", "avenue"}});
  }
  const NodeId end = site.map.node(centre.back());
  up.push_back(end);
  down.push_back(end);
  for (std::size_t k = 0; k + 1 < run.edges.size(); ++k) {
    const std::size_t i = vertex_at[k];
    Crossing c{down[i], up[i], left[i], right[i]};
    crossings[n.edges[run.edges[k]].to] = c;
    draw_way(site, {c.left, c.right}, {{"highway", "residential"}});
  }
  std::reverse(down.begin(), down.end());  // keep right
  Tags tags = street_tags(line);
  tags.insert(tags.end(), {{"oneway", "yes"}, {"dual_carriageway", "yes"}});
  for (auto* nodes : {&up, &down})
    for (std::size_t from = 0; from + 1 < nodes->size(); from += kMostNodes) {
      const auto begin = nodes->begin() + static_cast<std::ptrdiff_t>(from);
      const auto stop = nodes->begin() + static_cast<std::ptrdiff_t>(std::min(nodes->size(), from + kMostNodes + 1));
      draw_way(site, {begin, stop}, tags);
    }
}

}  // namespace

void draw_way(Site& site, std::vector<NodeId> nodes, Tags tags) {
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (site.features.no_streets || nodes.size() < 2) return;
  ++site.counts.streets;
  site.map.way(std::move(nodes), std::move(tags));
}

void draw_footway(Site& site, std::vector<NodeId> nodes, Tags more) {
  const bool is_service = std::any_of(more.begin(), more.end(), [](const auto& t) { return t.first == "service"; });
  more.insert(more.begin(), {"highway", is_service ? "service" : "footway"});
  draw_way(site, std::move(nodes), std::move(more));
}

Tags street_tags(const Line& line) {
  Tags tags{{"highway", line.is_steps ? "steps" : highway_of(line.kind)}};
  if (!line.name.empty()) tags.emplace_back("name", line.name);
  if (line.kind == StreetKind::lane)
    tags.emplace_back("width", number_text(2 * line.half_width));
  else if (line.kind != StreetKind::avenue)
    tags.emplace_back("width", number_text(2 * line.half_width - 2.5));
  tags.emplace_back("surface", line.kind == StreetKind::ring || line.kind == StreetKind::avenue ? "asphalt" : "sett");
  return tags;
}

void draw_dead_end(Site& site, std::size_t face, const std::vector<Side>& sides, const Ring& outline,
                   std::vector<Ring>& built) {
  const Side* longest = nullptr;
  for (const Side& s : sides) {
    const StreetKind kind = site.network.lines[s.line].kind;
    if (kind == StreetKind::border || kind == StreetKind::avenue) continue;
    if (!longest || length_of(s.front) > length_of(longest->front)) longest = &s;
  }
  if (!longest || length_of(longest->front) < 40) return;
  Vec forward;
  const Vec from = point_along(longest->front, length_of(longest->front) * site.rng.between(0.42, 0.58), &forward);
  const Vec inward = left_of(forward);
  double reach = 45;
  while (reach > 15 && !contains_with_margin(outline, from + inward * reach, 12)) reach -= 5;
  if (reach <= 15) return;
  const Vec to = from + inward * reach;
  const NodeId street = join_street(site.network, site.map, face, longest->line, from);
  Line line;
  line.half_width = 3;
  line.name = site.names.street(site.rng);
  Tags tags = street_tags(line);
  tags.emplace_back("noexit", "yes");
  draw_way(site, {street, site.map.node(from), site.map.node(to)}, tags);
  built.push_back(rectangle(mix(from, to, 0.5), inward, reach / 2 + 3.5, 3.5));
}

void draw_streets(Site& site) {
  Network& n = site.network;
  std::vector<std::vector<std::size_t>> of_line(n.lines.size());
  for (std::size_t e = 0; e < n.edges.size(); ++e)
    if (n.edges[e].is_kept) of_line[n.edges[e].line].push_back(e);
  std::vector<int> arms(n.vertices.size());
  for (const Edge& e : n.edges) {
    if (!e.is_kept) continue;
    if (n.lines[e.line].kind == StreetKind::lane) site.sights |= kAlley;
    ++arms[e.from];
    if (++arms[e.to] > 3 || arms[e.from] > 3) site.sights |= kCrossroads;
  }
  Crossings crossings;
  for (const bool is_avenue : {true, false})
    for (std::size_t l = 0; l < n.lines.size(); ++l) {
      if ((n.lines[l].kind == StreetKind::avenue) != is_avenue) continue;
      const Line line = n.lines[l];
      auto& edges = of_line[l];
      const auto along = [&](std::size_t e) {
        return dot(n.straight[n.edges[e].from] - line.from, line.to - line.from);
      };
      std::sort(edges.begin(), edges.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
      for (const Run& run : runs_of(n, edges))
        is_avenue ? draw_avenue(site, line, run, crossings) : draw_street(site, line, run, crossings);
    }
}

}  // namespace vicus::town
