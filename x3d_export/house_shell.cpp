#include "x3d_export/house_shell.hpp"

#include <cmath>
#include <map>

namespace vicus {
namespace {

std::int32_t steps(double up_m) { return static_cast<std::int32_t>(std::llround(up_m * kRoofStepsPerMetre)); }

class ShellBuilder {
 public:
  explicit ShellBuilder(const Building& house)
      : house_(house), base_(steps(house.base_m > 0 ? house.base_m : -house.foot_m)), eave_(steps(house.eave_m)) {}

  HouseShell build() {
    add_floor();
    add_walls(house_.footprint.outer);
    for (const Ring& hole : house_.footprint.holes) add_walls(hole);
    for (const RoofFacet& facet : house_.roof.facets) {
      ShellFace face{is_upright(facet.kind) ? ShellPart::wall : ShellPart::roof, {}};
      for (const auto& ring : facet.rings) {
        auto& out = face.rings.emplace_back();
        for (const std::uint32_t i : ring) out.push_back(number(house_.roof.points.at(i)));
      }
      shell_.faces.push_back(std::move(face));
    }
    return std::move(shell_);
  }

 private:
  std::uint32_t number(const RoofPoint& point) {
    const auto [at, is_new] = numbers_.emplace(point, static_cast<std::uint32_t>(shell_.points.size()));
    if (is_new) shell_.points.push_back(point);
    return at->second;
  }

  /// The footprint seen from below.
  void add_floor() {
    ShellFace face{ShellPart::floor, {}};
    const auto add = [&](const Ring& ring) {
      auto& out = face.rings.emplace_back();
      for (std::size_t i = ring.size(); i-- > 0;) out.push_back(number({ring[i], base_}));
    };
    add(house_.footprint.outer);
    for (const Ring& hole : house_.footprint.holes) add(hole);
    shell_.faces.push_back(std::move(face));
  }

  /// Rings have the house on the left.
  void add_walls(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint p = ring[i], q = ring[i + 1 == ring.size() ? 0 : i + 1];
      shell_.faces.push_back(
          {ShellPart::wall, {{number({p, base_}), number({q, base_}), number({q, eave_}), number({p, eave_})}}});
    }
  }

  const Building& house_;
  std::int32_t base_, eave_;
  HouseShell shell_;
  std::map<RoofPoint, std::uint32_t> numbers_;
};

}  // namespace

HouseShell house_shell(const Building& house) { return ShellBuilder(house).build(); }

}  // namespace vicus
