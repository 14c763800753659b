#include <algorithm>
#include <cmath>
#include <tuple>

#include "city_db/rules_cells.hpp"
#include "city_db/rules_plane.hpp"

namespace vicus::rules {
namespace {

double length_mm(const Edge& e) { return std::hypot(double(e.hi.x) - e.lo.x, double(e.hi.y) - e.lo.y); }

/// Twice the median edge, but so large that the long edges do not fill more than a few cells per edge on average.
std::int64_t cell_size_mm(const EdgeTable& table) {
  std::vector<double> lengths;
  lengths.reserve(table.edges.size());
  double total = 0;
  for (const auto& e : table.edges) total += lengths.emplace_back(length_mm(e));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  const double mean_cells = 4;
  return std::max<std::int64_t>(
      1, std::llround(std::max(2 * *middle, total / mean_cells / static_cast<double>(lengths.size()))));
}

bool boxes_apart(const Edge& a, const Edge& b) {
  // lo.x <= hi.x always
  return a.hi.x < b.lo.x || b.hi.x < a.lo.x || std::max(a.lo.y, a.hi.y) < std::min(b.lo.y, b.hi.y) ||
         std::max(b.lo.y, b.hi.y) < std::min(a.lo.y, a.hi.y);
}

/// Distinct edges that overlap on a line always have an end of one inside the other.
bool find_fault(const Edge& a, const Edge& b, PlanPoint& at) {
  if (boxes_apart(a, b)) return false;
  for (const PlanPoint p : {b.lo, b.hi})
    if (is_inside_segment(p, a.lo, a.hi)) return at = p, true;
  for (const PlanPoint p : {a.lo, a.hi})
    if (is_inside_segment(p, b.lo, b.hi)) return at = p, true;
  if (cross_properly(a.lo, a.hi, b.lo, b.hi)) return at = b.lo, true;
  return false;
}

}  // namespace

std::vector<NodingFault> noding_faults(const EdgeTable& table) {
  std::vector<NodingFault> faults;
  if (table.edges.empty()) return faults;
  CellIndex cells(cell_size_mm(table));
  for (std::uint32_t e = 0; e < table.edges.size(); ++e)
    if (table.has_ring(e)) cells.add_segment(e, table.edges[e].lo, table.edges[e].hi);
  cells.finish();
  for (std::size_t cell = 0; cell < cells.cell_count(); ++cell) {
    const auto ids = cells.ids(cell);
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        NodingFault fault{ids[i], ids[j], {}};
        if (find_fault(table.edges[ids[i]], table.edges[ids[j]], fault.at)) faults.push_back(fault);
      }
  }
  // A pair may meet in several cells.
  const auto key = [](const NodingFault& f) { return std::tie(f.edge, f.other); };
  std::sort(faults.begin(), faults.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  faults.erase(
      std::unique(faults.begin(), faults.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
      faults.end());
  return faults;
}

}  // namespace vicus::rules
