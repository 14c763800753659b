#pragma once
#include "city_db/city.hpp"

namespace vicus {

/// Calls visit(a, b) for each edge a -> b of the outer ring, then of the holes, in their order.
template <class Visit>
void visit_edges(const Polygon& polygon, Visit visit) {
  const auto ring = [&](const Ring& points) {
    for (std::size_t i = 0; i < points.size(); ++i) visit(points[i], points[i + 1 < points.size() ? i + 1 : 0]);
  };
  ring(polygon.outer);
  for (const auto& hole : polygon.holes) ring(hole);
}

}  // namespace vicus
