#include "x3d_export/svg_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/steady_hash.hpp"
#include "x3d_export/city_index.hpp"
#include "x3d_export/svg_lvis.hpp"
#include "x3d_export/svg_paper.hpp"

namespace vicus {
namespace {

constexpr int kHues = 12;
constexpr double kMargin_m = 5, kListedMargin_m = 50;

struct Look {
  const char* what;
  const char* colour;
};
constexpr Look kGateLooks[] = {{"street gate", "#d42020"},
                               {"yard gate", "#8a2be2"},
                               {"kerb", "#ff8c00"},
                               {"passage gate", "#0a9a3c"},
                               {"end of the city", "#1e5fe0"}};
constexpr const char *kHouse = "#b3a89c", *kHouseLine = "#7d736a", *kWater = "#a9cfe8", *kWall = "#5a4636",
                     *kFence = "#a0825f", *kBank = "#3f86b5", *kAxis = "#333333", *kDomain = "#f1efea",
                     *kIsland = "#c9d8b6", *kYard = "#e2ddd2";

PlanBox whole_box(const City& city) {
  PlanBox box;
  for (const auto& polygon : city.domain)
    for (const auto& p : polygon.outer) box.add(p);
  for (const auto& s : city.sectors)
    for (const auto& p : s.ground.outer) box.add(p);
  for (const auto& b : city.buildings)
    for (const auto& p : b.footprint.outer) box.add(p);
  if (box.is_empty()) box.add({0, 0});
  return grown(box, lattice_mm(kMargin_m));
}

/// Around every listed sector.
PlanBox listed_box(const City& city, const LvisLooks& looks) {
  PlanBox box;
  for (const auto& s : city.sectors)
    if (looks.lists(s.id))
      for (const auto& p : s.ground.outer) box.add(p);
  return grown(box, lattice_mm(kListedMargin_m));
}

/// Hue numbers by sector: a hash of the id, moved on while a gate neighbour has it.
std::map<std::string, int> hues_of(const CityIndex& index) {
  std::map<std::string, int> hues;
  std::set<std::string> ids;
  for (const auto& s : index.city().sectors) ids.insert(s.id);
  for (const auto& id : ids) {
    std::set<int> taken;
    for (const Gate* g : index.gates_of(id))
      if (const auto at = hues.find(g->to_sector_id); at != hues.end()) taken.insert(at->second);
    int hue = static_cast<int>(steady_hash(id) % kHues);
    for (int tried = 0; tried < kHues && taken.contains(hue); ++tried) hue = (hue + 5) % kHues;
    hues[id] = hue;
  }
  return hues;
}

/// Saturation and lightness tell the kind: junctions and squares strong, yards pale, passages dark.
std::string sector_colour(SectorKind kind, int hue) {
  const double degrees = 360.0 * hue / kHues;
  switch (kind) {
    case SectorKind::street:
      return hsl_colour(degrees, 0.55, 0.78);
    case SectorKind::crossroads:
      return hsl_colour(degrees, 0.85, 0.58);
    case SectorKind::square:
      return hsl_colour(degrees, 0.8, 0.66);
    case SectorKind::yard:
      return hsl_colour(degrees, 0.28, 0.89);
    case SectorKind::passage:
      return hsl_colour(degrees, 0.4, 0.5);
    case SectorKind::interior:
      return hsl_colour(45, 0.6, 0.9);
    case SectorKind::open:
      return hsl_colour(90 + degrees / 12, 0.3, 0.84);
  }
  return {};
}

const char* obstacle_colour(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::water:
      return kWater;
    case ObstacleKind::wall:
      return kWall;
    case ObstacleKind::fence:
      return kFence;
    case ObstacleKind::island:
      return kIsland;
    case ObstacleKind::yard:
    case ObstacleKind::courtyard:
      return kYard;
  }
  return kYard;
}

class MapDrawing {
 public:
  MapDrawing(const City& city, const SvgOptions& options)
      : index_(city),
        city_(city),
        options_(options),
        looks_(options.lvis.empty() ? std::nullopt : std::optional<LvisLooks>(std::in_place, city, options.lvis)),
        box_(options.box ? *options.box
             : looks_    ? listed_box(city, *looks_)
                         : whole_box(city)),
        paper_(box_, options.side_px) {}

  std::string draw() {
    paper_.begin_map();
    for (const auto& polygon : city_.domain) paper_.polygon(polygon, kDomain, "");
    for (const auto& o : city_.obstacles)
      if (is_shown(o.area)) paper_.polygon(o.area, obstacle_colour(o.kind), "");
    draw_sectors();
    for (const auto& b : city_.buildings)
      if (is_shown(b.footprint)) draw_house(b);
    draw_lines();
    if (options_.has_labels) draw_labels();
    paper_.end_map();
    draw_legend();
    return paper_.finish();
  }

 private:
  bool is_shown(const Polygon& polygon) const { return meet(box_of(polygon), box_); }
  bool is_shown(const std::vector<PlanPoint>& line) const { return meet(box_of(line), box_); }

  void draw_house(const Building& b) {
    const char* marked = looks_ ? looks_->house_colour(b.id) : nullptr;
    paper_.polygon(b.footprint, marked ? marked : kHouse, kHouseLine, b.base_m > 0 ? 0.45 : 1);
  }

  void draw_sectors() {
    if (looks_) {
      for (const auto& s : city_.sectors)
        if (is_shown(s.ground)) paper_.polygon(s.ground, looks_->ground_colour(s.id), "");
      return;
    }
    const auto hues = hues_of(index_);
    for (const auto& s : city_.sectors)
      if (is_shown(s.ground)) paper_.polygon(s.ground, sector_colour(s.kind, hues.at(s.id)), "");
  }

  void draw_lines() {
    for (const auto& s : city_.streets)
      if (is_shown(s.line)) paper_.line(s.line, kAxis, 0.6, s.is_passage ? "2 2" : "");
    for (const auto& b : city_.borders) {
      if (!is_shown(b.line)) continue;
      if (b.kind == BorderKind::wall) paper_.line(b.line, kWall, 1.2, "");
      if (b.kind == BorderKind::fence) paper_.line(b.line, kFence, 1.2, "3 1.5");
      if (b.kind == BorderKind::bank) paper_.line(b.line, kBank, 1.2, "");
    }
    for (const auto& g : city_.gates)
      // A pair of twins is one line on the map.
      if (is_shown(g.line) && (g.twin_id.empty() || g.id <= g.twin_id))
        paper_.line(g.line, kGateLooks[static_cast<int>(g.kind)].colour, 1.8, "");
  }

  void draw_labels() {
    // A name once: at the first sector by id that bears it; ids everywhere.
    std::set<std::string> named;
    std::vector<const Sector*> sectors;
    for (const auto& s : city_.sectors)
      if (is_shown(s.ground)) sectors.push_back(&s);
    std::sort(sectors.begin(), sectors.end(), [](const Sector* a, const Sector* b) { return a->id < b->id; });
    for (const Sector* s : sectors) {
      const PlanPoint at = point_inside(*s);
      const bool has_name = !s->name.empty() && named.insert(s->name).second;
      paper_.label(at, short_id(s->id), 7, 0);
      if (has_name) paper_.label(at, s->name, 9, 9.5);
    }
  }

  /// Ids may be long; what tells them apart is at their end.
  static std::string short_id(const std::string& id) {
    constexpr std::size_t kLongest = 12;
    return id.size() <= kLongest ? id : ".." + id.substr(id.size() - kLongest + 2);
  }

  void draw_legend() {
    for (const auto& look : kGateLooks) paper_.legend_line(look.what, look.colour);
    paper_.legend_line("wall", kWall);
    paper_.legend_line("fence", kFence);
    paper_.legend_line("street axis", kAxis);
    if (looks_)
      looks_->draw_legend(paper_);
    else
      draw_kinds();
    paper_.legend_box("building", kHouse);
    paper_.legend_box("water", kWater);
    paper_.legend_box("closed yard", kYard);
    draw_title();
  }

  void draw_kinds() {
    for (const auto kind : {SectorKind::street, SectorKind::crossroads, SectorKind::square, SectorKind::yard,
                            SectorKind::passage, SectorKind::open})
      paper_.legend_box(name_of(kind), sector_colour(kind, 7));
  }

  void draw_title() {
    const auto meta = [this](const char* key) {
      const auto at = city_.meta.find(key);
      return at == city_.meta.end() ? std::string() : at->second;
    };
    std::string attribution = meta("licences");  // one to a line
    std::replace(attribution.begin(), attribution.end(), '\n', ';');
    const std::string name = meta("name").empty() ? "City" : meta("name");
    paper_.title(looks_ ? looks_->title()
                        : name + ": " + std::to_string(city_.sectors.size()) + " sectors, " +
                              std::to_string(city_.gates.size()) + " gates, " + std::to_string(city_.buildings.size()) +
                              " buildings",
                 attribution);
  }

  CityIndex index_;
  const City& city_;
  SvgOptions options_;
  std::optional<LvisLooks> looks_;
  PlanBox box_;
  SvgPaper paper_;
};

}  // namespace

std::string svg_map(const City& city, const SvgOptions& options) { return MapDrawing(city, options).draw(); }

}  // namespace vicus
