#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sectorgen/sectors/locator.hpp"
#include "sectorgen/sectors/naming.hpp"

namespace vicus {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The cell at p, or near it: shops and doors are mapped inside houses or on their walls.
std::uint32_t cell_near(const Plan& plan, const Locator& locator, PlanPoint p) {
  for (double radius : {0.0, 1.0, 3.0, 6.0, 10.0})
    for (int k = 0; k < (radius > 0 ? 8 : 1); ++k) {
      const PlanPoint q{p.x + lattice_mm(radius * std::cos(k * kPi / 4)),
                        p.y + lattice_mm(radius * std::sin(k * kPi / 4))};
      const std::uint32_t t = locator.locate(q);
      if (t != kNone && plan.cells.of[t] != kNone) return plan.cells.of[t];
    }
  return kNone;
}

std::string object_id(const std::string& source_id) {
  std::string id;
  for (char c : source_id) id += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '-';
  return id.empty() ? "object" : id;
}

}  // namespace

void furnish(const SourceMap& map, const Plan& plan, City& city) {
  const Locator locator(plan.ground.mesh);
  std::map<std::string, int> used;
  for (const auto& o : map.objects) {
    if (o.kind == "indoor_door") continue;  // interiors.hpp
    const std::uint32_t c = cell_near(plan, locator, o.at);
    if (c == kNone) continue;  // in a closed courtyard or out of the city
    StandaloneObject out;
    out.id = object_id(o.source_id);
    out.sector_id = std::to_string(c);
    out.kind = o.kind;
    out.name = o.name;
    out.at = o.at;
    out.height_m = o.height_m;
    out.tags = o.tags;
    const int n = used[out.id]++;
    if (n > 0) out.id += "-" + std::to_string(n + 1);
    city.objects.push_back(std::move(out));
  }
}

}  // namespace vicus
