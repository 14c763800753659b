#include "sectorgen/models/roof_wavefront.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <queue>
#include <tuple>

namespace vicus {
namespace {

constexpr double kTiny_m = 1e-7;    // shorter edges are gone
constexpr double kTouch_m = 1e-6;   // ends of an edge that a corner may miss by rounding
constexpr double kParallel = 1e-6;  // sine below which two edges are parallel
constexpr double kStill = 1e-12;    // slower than this nothing ever meets
constexpr double kNever = 1e300;
constexpr double kRetry_m = 1e-9;  // a split whose edge is not there yet is tried once more, so much later

struct Line {
  double nx = 0, ny = 0, c = 0, run = 0;
  double distance(double x, double y, double d) const { return nx * x + ny * y - c - run * d; }
};

double cross(const Line& a, const Line& b) { return a.nx * b.ny - a.ny * b.nx; }
double dot(const Line& a, const Line& b) { return a.nx * b.nx + a.ny * b.ny; }

/// The edge after edge a turns back along it.
bool is_antiparallel(const Line& a, const Line& b) { return std::abs(cross(a, b)) < kParallel && dot(a, b) < 0; }

/// A corner of the wavefront between edges `left` (arriving) and `right` (leaving), on its way since clock d.
struct Corner {
  double x = 0, y = 0, d = 0, vx = 0, vy = 0;
  std::uint32_t left = 0, right = 0, prev = 0, next = 0, node = 0;
  bool is_alive = true;
  std::vector<std::pair<double, std::uint32_t>> hits = {};  // heap: when a reflex corner meets which edge's line
};

enum class Kind { loop, turn_back, collapse, split, late_split };

struct Event {
  double d;
  Kind kind;
  std::uint32_t corner, other;  // other: collapse: the next corner; split: the edge
  auto key() const { return std::tie(d, kind, corner, other); }
  friend bool operator<(const Event& a, const Event& b) { return b.key() < a.key(); }  // earliest first in a heap
};

class Wavefront {
 public:
  explicit Wavefront(const WaveInput& input) : input_(input) {
    for (const auto& ring : input.rings) add_ring(ring);
    by_edge_.resize(lines_.size());
    face_of_.resize(lines_.size());
    for (std::uint32_t e = 0; e < lines_.size(); ++e) {
      lines_[e].run = input.phases.front().run[e];
      face_of_[e] = add_face(e);
    }
    std::uint32_t first = 0;
    for (const auto& ring : input.rings) {
      const auto n = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < n; ++i)
        wave_.sides.push_back({face_of_[first + i], first + i, first + (i + 1) % n});
      first += n;
    }
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      aim(corners_[i]);
      by_edge_[corners_[i].right].push_back(i);
    }
  }

  Wave run() {
    const std::size_t most_events = 8 * lines_.size() + 64;
    for (std::size_t phase = 0;; ++phase) {
      const double next = phase + 1 < input_.phases.size() ? input_.phases[phase + 1].from : kNever;
      const double limit = std::min(next, input_.stop);
      events_ = {};
      for (std::uint32_t i = 0; i < corners_.size(); ++i)
        if (corners_[i].is_alive) schedule(i, true);
      Event event{};
      while (pop(event) && event.d < limit) {
        if (static_cast<std::size_t>(wave_.events) > most_events) return fail("more events than edges allow");
        now_ = std::max(now_, event.d);
        handle(event);
      }
      if (std::none_of(corners_.begin(), corners_.end(), [](const Corner& c) { return c.is_alive; })) break;
      if (limit == kNever) return fail("the wavefront never closes");
      now_ = limit;
      rise_to_level(limit == input_.stop ? nullptr : &input_.phases[phase + 1]);
      if (limit == input_.stop) break;
    }
    for (const auto& node : wave_.nodes) wave_.most = std::max(wave_.most, node.d);
    return std::move(wave_);
  }

 private:
  Wave fail(const char* why) {
    wave_.failure = why;
    return std::move(wave_);
  }

  void add_ring(const std::vector<WavePoint>& ring) {
    const auto n = static_cast<std::uint32_t>(ring.size()), first = static_cast<std::uint32_t>(lines_.size());
    assert(n >= 3);
    for (std::uint32_t i = 0; i < n; ++i) {
      const WavePoint p = ring[i], q = ring[(i + 1) % n];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      Line line;
      line.nx = -(q.y - p.y) / length;
      line.ny = (q.x - p.x) / length;
      line.c = line.nx * p.x + line.ny * p.y;
      lines_.push_back(line);
      Corner c;
      c.x = p.x, c.y = p.y;
      c.left = c.prev = first + (i + n - 1) % n;
      c.next = first + (i + 1) % n;
      c.right = first + i;
      c.node = add_node(p.x, p.y, 0);
      corners_.push_back(std::move(c));
    }
  }

  std::uint32_t add_node(double x, double y, double d) {
    wave_.nodes.push_back({x, y, d});
    return static_cast<std::uint32_t>(wave_.nodes.size() - 1);
  }
  std::uint32_t add_face(std::uint32_t edge) {
    wave_.faces.push_back({edge, false, lines_[edge].run == 0});
    return static_cast<std::uint32_t>(wave_.faces.size() - 1);
  }

  /// The velocity that keeps the corner on both its edges.
  void aim(Corner& c) const {
    const Line &a = lines_[c.left], &b = lines_[c.right];
    const double s = cross(a, b);
    if (std::abs(s) >= kParallel) {
      c.vx = (a.run * b.ny - b.run * a.ny) / s;
      c.vy = (a.nx * b.run - b.nx * a.run) / s;
    } else if (dot(a, b) > 0) {
      c.vx = a.nx * (a.run + b.run) / 2;
      c.vy = a.ny * (a.run + b.run) / 2;
    } else {
      c.vx = c.vy = 0;  // turns back: dealt with at once
    }
  }

  WavePoint at(const Corner& c, double d) const { return {c.x + c.vx * (d - c.d), c.y + c.vy * (d - c.d)}; }

  bool is_reflex(const Corner& c) const { return cross(lines_[c.left], lines_[c.right]) < -1e-9; }

  void add_arc(std::uint32_t from, std::uint32_t to, std::uint32_t left, std::uint32_t right) {
    if (from == to) return;
    wave_.sides.push_back({face_of_[left], from, to});
    wave_.sides.push_back({face_of_[right], to, from});
  }

  void end(Corner& c, std::uint32_t node) {
    c.is_alive = false;
    add_arc(c.node, node, c.left, c.right);
  }

  void begin(WavePoint p, std::uint32_t left, std::uint32_t right, std::uint32_t prev, std::uint32_t next,
             std::uint32_t node) {
    const auto id = static_cast<std::uint32_t>(corners_.size());
    Corner c;
    c.x = p.x, c.y = p.y, c.d = now_;
    c.left = left, c.right = right, c.prev = prev, c.next = next, c.node = node;
    aim(c);
    corners_.push_back(std::move(c));
    corners_[prev].next = id;
    corners_[next].prev = id;
    by_edge_[right].push_back(id);
    schedule(id, false);
    schedule_collapse(prev);
  }

  void schedule(std::uint32_t i, bool is_restart) {
    Corner& c = corners_[i];
    if (c.prev == c.next || c.prev == i) return events_.push({now_, Kind::loop, i, 0});
    if (is_antiparallel(lines_[c.left], lines_[c.right])) events_.push({now_, Kind::turn_back, i, 0});
    schedule_collapse(i);
    if (is_restart) c.hits.clear();
    if (!is_reflex(c)) return;
    const WavePoint p = at(c, now_);
    for (std::uint32_t e = 0; e < lines_.size(); ++e) {
      if (e == c.left || e == c.right) continue;
      const Line& line = lines_[e];
      const double away = line.distance(p.x, p.y, now_), speed = line.nx * c.vx + line.ny * c.vy - line.run;
      if (away < -kTouch_m || speed >= -kStill) continue;
      c.hits.emplace_back(away <= kTiny_m ? now_ : now_ - away / speed, e);
    }
    std::make_heap(c.hits.begin(), c.hits.end(), std::greater<>());
    push_hit(i);
  }

  void push_hit(std::uint32_t i) {
    auto& hits = corners_[i].hits;
    if (hits.empty()) return;
    std::pop_heap(hits.begin(), hits.end(), std::greater<>());
    events_.push({std::max(hits.back().first, now_), Kind::split, i, hits.back().second});
    hits.pop_back();
  }

  void schedule_collapse(std::uint32_t i) {
    const Corner &c = corners_[i], &n = corners_[c.next];
    const Line& line = lines_[c.right];
    const WavePoint p = at(c, now_), q = at(n, now_);
    const double tx = line.ny, ty = -line.nx;
    const double length = (q.x - p.x) * tx + (q.y - p.y) * ty, grows = (n.vx - c.vx) * tx + (n.vy - c.vy) * ty;
    if (length < kTiny_m)
      events_.push({now_, Kind::collapse, i, c.next});
    else if (grows < -kStill)
      events_.push({now_ - length / grows, Kind::collapse, i, c.next});
  }

  /// The next event. Brute force forgets what was planned and looks at every pair again.
  bool pop(Event& event) {
    if (input_.brute_force) {
      events_ = {};
      for (std::uint32_t i = 0; i < corners_.size(); ++i)
        if (corners_[i].is_alive) plan_all(i);
    }
    if (events_.empty()) return false;
    event = events_.top();
    events_.pop();
    return true;
  }

  void plan_all(std::uint32_t i) {
    schedule(i, true);
    for (auto& [d, e] : corners_[i].hits) events_.push({std::max(d, now_), Kind::split, i, e});
    corners_[i].hits.clear();
    // Only splits that find their edge, as it will be then.
    std::vector<Event> kept;
    for (; !events_.empty(); events_.pop())
      if (const Event& e = events_.top(); e.kind != Kind::split || corner_before(e, e.d) != kNobody) kept.push_back(e);
    for (const Event& e : kept) events_.push(e);
  }

  void handle(const Event& event) {
    Corner& c = corners_[event.corner];
    if (!c.is_alive) return;
    switch (event.kind) {
      case Kind::loop:
        return close_loop(event.corner);
      case Kind::turn_back:
        return turn_back(event.corner);
      case Kind::collapse:
        if (corners_[event.other].is_alive && c.next == event.other) collapse(event.corner, event.other);
        return;
      case Kind::split:
      case Kind::late_split:
        return try_split(event);
    }
  }

  static constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

  /// The corner at which the stretch of the event's edge begins that its corner is on at clock d.
  std::uint32_t corner_before(const Event& event, double d) {
    const WavePoint p = at(corners_[event.corner], d);
    const Line& line = lines_[event.other];
    auto& list = by_edge_[event.other];
    std::erase_if(list, [&](std::uint32_t i) { return !corners_[i].is_alive; });
    for (const std::uint32_t i : list) {
      const std::uint32_t n = corners_[i].next;
      if (i == event.corner || n == event.corner) continue;
      const WavePoint a = at(corners_[i], d), b = at(corners_[n], d);
      const double tx = line.ny, ty = -line.nx;
      if ((p.x - a.x) * tx + (p.y - a.y) * ty >= -kTouch_m && (b.x - p.x) * tx + (b.y - p.y) * ty >= -kTouch_m)
        return i;
    }
    return kNobody;
  }

  void try_split(const Event& event) {
    const std::uint32_t before = corner_before(event, now_);
    if (before != kNobody) return split(event.corner, before);
    if (event.kind == Kind::split) events_.push({now_ + kRetry_m, Kind::late_split, event.corner, event.other});
    push_hit(event.corner);
  }

  void split(std::uint32_t i, std::uint32_t before) {
    ++wave_.events;
    const WavePoint p = at(corners_[i], now_);
    const std::uint32_t node = add_node(p.x, p.y, now_), after = corners_[before].next, edge = corners_[before].right;
    end(corners_[i], node);
    const auto [left, right, prev, next] =
        std::tuple(corners_[i].left, corners_[i].right, corners_[i].prev, corners_[i].next);
    begin(p, left, edge, prev, after, node);
    begin(p, edge, right, before, next, node);
  }

  void collapse(std::uint32_t i, std::uint32_t j) {
    ++wave_.events;
    const WavePoint p = at(corners_[i], now_), q = at(corners_[j], now_), m{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const std::uint32_t node = add_node(m.x, m.y, now_);
    end(corners_[i], node);
    end(corners_[j], node);
    if (corners_[i].prev == j) return;
    begin(m, corners_[i].left, corners_[j].right, corners_[i].prev, corners_[j].next, node);
  }

  /// Two corners are left of a ring: a ridge between its two edges.
  void close_loop(std::uint32_t i) {
    const std::uint32_t j = corners_[i].next;
    if (j == i) {
      corners_[i].is_alive = false;
      return;
    }
    const WavePoint p = at(corners_[i], now_), q = at(corners_[j], now_);
    const std::uint32_t a = add_node(p.x, p.y, now_);
    const std::uint32_t b = std::hypot(p.x - q.x, p.y - q.y) < 1e-5 ? a : add_node(q.x, q.y, now_);
    end(corners_[i], a);
    end(corners_[j], b);
    add_arc(a, b, corners_[i].right, corners_[i].left);
  }

  /// Neighbours run in opposite directions on one line: the shorter is used up at once, a ridge remains.
  void turn_back(std::uint32_t i) {
    ++wave_.events;
    const std::uint32_t p = corners_[i].prev, n = corners_[i].next;
    const WavePoint here = at(corners_[i], now_), before = at(corners_[p], now_), after = at(corners_[n], now_);
    const auto length = [&](WavePoint to) { return std::hypot(to.x - here.x, to.y - here.y); };
    const std::uint32_t middle = add_node(here.x, here.y, now_);
    end(corners_[i], middle);
    if (length(before) <= length(after)) {
      const std::uint32_t node = add_node(before.x, before.y, now_);
      end(corners_[p], node);
      add_arc(middle, node, corners_[i].left, corners_[i].right);
      begin(before, corners_[p].left, corners_[i].right, corners_[p].prev, n, node);
    } else {
      const std::uint32_t node = add_node(after.x, after.y, now_);
      end(corners_[n], node);
      add_arc(middle, node, corners_[i].left, corners_[i].right);
      begin(after, corners_[i].left, corners_[n].right, p, corners_[n].next, node);
    }
  }

  /// All corners get a node at the present level, and the next phase's faces begin there; without one, the top.
  void rise_to_level(const WavePhase* next) {
    std::vector<std::uint32_t> alive;
    for (std::uint32_t i = 0; i < corners_.size(); ++i)
      if (corners_[i].is_alive) alive.push_back(i);
    for (const std::uint32_t i : alive) {
      Corner& c = corners_[i];
      // Between two walls that stay upright nothing changes: no point amid their common edge.
      if (next && lines_[c.left].run == 0 && lines_[c.right].run == 0 && next->run[c.left] == 0 &&
          next->run[c.right] == 0)
        continue;
      const WavePoint p = at(c, now_);
      const std::uint32_t node = add_node(p.x, p.y, now_);
      add_arc(c.node, node, c.left, c.right);
      c.x = p.x, c.y = p.y, c.d = now_, c.node = node;
    }
    std::vector<std::uint32_t> new_face = face_of_;
    if (next)
      for (std::uint32_t e = 0; e < lines_.size(); ++e) {
        Line& line = lines_[e];
        if (line.run == 0 && next->run[e] == 0) continue;  // one upright wall
        line.c += (line.run - next->run[e]) * now_;
        line.run = next->run[e];
        new_face[e] = add_face(e);
      }
    else {
      wave_.faces.push_back({0, true, false});
      new_face.assign(lines_.size(), static_cast<std::uint32_t>(wave_.faces.size() - 1));
    }
    for (const std::uint32_t i : alive) {
      const Corner& c = corners_[i];
      const std::uint32_t to = corners_[c.next].node;
      if (new_face[c.right] == face_of_[c.right]) continue;
      wave_.sides.push_back({face_of_[c.right], to, c.node});
      wave_.sides.push_back({new_face[c.right], c.node, to});
    }
    face_of_ = std::move(new_face);
    for (const std::uint32_t i : alive) aim(corners_[i]);
  }

  const WaveInput& input_;
  Wave wave_;
  std::vector<Line> lines_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> face_of_;               // per edge, in this phase
  std::vector<std::vector<std::uint32_t>> by_edge_;  // per edge, corners that it leaves from
  std::priority_queue<Event> events_;
  double now_ = 0;
};

}  // namespace

Wave run_wavefront(const WaveInput& input) { return Wavefront(input).run(); }

}  // namespace vicus
