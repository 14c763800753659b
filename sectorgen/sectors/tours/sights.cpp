#include "sectorgen/sectors/tours/sights.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace vicus {
namespace {

constexpr std::size_t kShortWalk = 5, kLongWalk = 10;
constexpr double kApart_m = 40;  // sights nearer to each other count as one stop

using WalkLength = std::function<double(const TourPlace&, const TourPlace&)>;

double apart_m(PlanPoint a, PlanPoint b) {
  return std::hypot(metres(std::int64_t{b.x} - a.x), metres(std::int64_t{b.y} - a.y));
}

/// The `most` sights nearest to the middle one, none beside another.
std::vector<TourPlace> around_middle(const std::vector<TourPlace>& sights, std::size_t most) {
  if (sights.empty()) return {};
  std::vector<std::int32_t> east, north;
  for (const auto& s : sights) {
    east.push_back(s.at.x);
    north.push_back(s.at.y);
  }
  const auto half = static_cast<std::ptrdiff_t>(sights.size() / 2);
  std::nth_element(east.begin(), east.begin() + half, east.end());
  std::nth_element(north.begin(), north.begin() + half, north.end());
  const PlanPoint middle{east[static_cast<std::size_t>(half)], north[static_cast<std::size_t>(half)]};
  auto sorted = sights;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const TourPlace& a, const TourPlace& b) {
    return apart_m(a.at, middle) < apart_m(b.at, middle);
  });
  std::vector<TourPlace> chosen;
  std::set<std::string> names;
  for (const auto& s : sorted) {
    const bool is_beside =
        std::any_of(chosen.begin(), chosen.end(), [&](const TourPlace& c) { return apart_m(c.at, s.at) < kApart_m; });
    if (is_beside || !names.insert(s.name).second) continue;
    chosen.push_back(s);
    if (chosen.size() == most) break;
  }
  return chosen;
}

/// All walks between the stops; stops that the first cannot be walked to from are left out.
struct Lengths {
  std::vector<TourPlace> stops;
  std::vector<std::vector<double>> m;
};

Lengths lengths_between(const std::vector<TourPlace>& stops, const WalkLength& walk_m) {
  Lengths lengths;
  for (const auto& stop : stops)
    if (lengths.stops.empty() || walk_m(lengths.stops.front(), stop) >= 0) lengths.stops.push_back(stop);
  const auto n = lengths.stops.size();
  lengths.m.assign(n, std::vector<double>(n, 0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      lengths.m[i][j] = lengths.m[j][i] = walk_m(lengths.stops[i], lengths.stops[j]);
  return lengths;
}

/// A short round through all: indices, the first one first.
std::vector<std::size_t> short_round(const std::vector<std::vector<double>>& m) {
  std::vector<std::size_t> order{0};
  while (order.size() < m.size()) {
    std::size_t best = m.size();
    for (std::size_t i = 0; i < m.size(); ++i)
      if (std::find(order.begin(), order.end(), i) == order.end() &&
          (best == m.size() || m[order.back()][i] < m[order.back()][best]))
        best = i;
    order.push_back(best);
  }
  const std::size_t n = order.size();
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t i = 1; i + 1 < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const std::size_t a = order[i - 1], b = order[i], c = order[j], d = order[(j + 1) % n];
        if (m[a][c] + m[b][d] >= m[a][b] + m[c][d] - 1e-6) continue;
        std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                     order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        is_better = true;
      }
  }
  return order;
}

void propose(std::vector<TourProposal>& proposals, const char* id, const char* name,
             const std::vector<TourPlace>& stops, const WalkLength& walk_m) {
  const auto lengths = lengths_between(stops, walk_m);
  if (lengths.stops.size() < kFewestStops) return;
  const auto order = short_round(lengths.m);
  TourProposal proposal;
  proposal.id = id;
  proposal.name = name;
  for (std::size_t i = 0; i < order.size(); ++i) {
    proposal.stops.push_back(lengths.stops[order[i]]);
    proposal.length_m += lengths.m[order[i]][order[(i + 1) % order.size()]];
  }
  proposal.stops.push_back(lengths.stops[order[0]]);
  proposal.duration_s = proposal.length_m / kWalkingSpeed_m_s;
  proposals.push_back(std::move(proposal));
}

}  // namespace

std::vector<TourProposal> propose_tours(const std::vector<TourPlace>& sights, const WalkLength& walk_m) {
  std::vector<TourPlace> squares, others;
  for (const auto& s : sights) (s.kind == "square" ? squares : others).push_back(s);
  std::vector<TourProposal> proposals;
  const auto few = around_middle(others, kShortWalk), many = around_middle(others, kLongWalk);
  propose(proposals, "short", "A short walk past sights", few, walk_m);
  if (many.size() > few.size()) propose(proposals, "sights", "Sights of the city", many, walk_m);
  propose(proposals, "squares", "From square to square", around_middle(squares, kLongWalk), walk_m);
  return proposals;
}

}  // namespace vicus
