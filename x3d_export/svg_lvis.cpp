#include "x3d_export/svg_lvis.hpp"

#include <algorithm>
#include <array>

namespace vicus {
namespace {

enum Look { kSelf, kGate, kSight, kRoofs, kUnresolved, kImportant };
constexpr std::size_t kLooks = 6;

struct Entry {
  const char* what;
  const char* colour;
};
constexpr std::array<Entry, kLooks> kEntries = {{{"the sector", "#d42020"},
                                                 {"gate", "#f08c2e"},
                                                 {"in sight", "#f6d04d"},
                                                 {"over roofs", "#5b9bd5"},
                                                 {"unresolved", "#b4c9e4"},
                                                 {"important", "#5fb35f"}}};
constexpr const char *kUnlisted = "#f7f5f0", *kTall = "#1f3f8f", *kTallUnresolved = "#8092c4";

Look look_of(const Visible& v) {
  switch (v.reason) {
    case VisibleReason::self:
      return kSelf;
    case VisibleReason::gate:
      return kGate;
    case VisibleReason::line_of_sight:
      return kSight;
    case VisibleReason::over_roofs:
      return v.is_proven ? kRoofs : kUnresolved;
    case VisibleReason::important:
      return kImportant;
  }
  return kSelf;
}

}  // namespace

LvisLooks::LvisLooks(const City& city, const std::string& id) {
  look_of_[id] = kSelf;
  for (const auto& g : city.gates)
    if (g.sector_id == id && !g.to_sector_id.empty()) look_of_.emplace(g.to_sector_id, kGate);
  for (const auto& v : city.visible) {
    if (v.sector_id != id) continue;
    look_of_.emplace(v.visible_sector_id, look_of(v));
    (v.is_proven ? houses_ : unresolved_houses_).insert(v.building_ids.begin(), v.building_ids.end());
  }
  for (const auto& [other, look] : look_of_) ++counts_[static_cast<std::size_t>(look)];
  const auto sector =
      std::find_if(city.sectors.begin(), city.sectors.end(), [&](const Sector& s) { return s.id == id; });
  title_ = "L_vis of " + id;
  if (sector != city.sectors.end() && !sector->name.empty()) title_ += " (" + sector->name + ")";
}

const char* LvisLooks::ground_colour(const std::string& id) const {
  const auto at = look_of_.find(id);
  return at == look_of_.end() ? kUnlisted : kEntries[static_cast<std::size_t>(at->second)].colour;
}

const char* LvisLooks::house_colour(const std::string& id) const {
  return houses_.contains(id) ? kTall : unresolved_houses_.contains(id) ? kTallUnresolved : nullptr;
}

void LvisLooks::draw_legend(SvgPaper& paper) const {
  for (std::size_t i = 0; i < kLooks; ++i) {
    std::string what = kEntries[i].what;
    if (i != kSelf) what.append(" ").append(std::to_string(counts_[i]));
    paper.legend_box(what, kEntries[i].colour);
  }
  paper.legend_box("not listed", kUnlisted);
  paper.legend_box("house seen", kTall);
  paper.legend_box("perhaps seen", kTallUnresolved);
}

std::string LvisLooks::title() const { return title_; }

}  // namespace vicus
