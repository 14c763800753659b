#include "sectorgen/geo/heights.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/ring_check.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

constexpr double kHighestM = 500;
constexpr double kMostLevels = 150;
constexpr double kDefaultM = 9, kOutbuildingM = 3;
// Of churches by the side of a square as large: from chapels to Notre-Dame (130 x 48 m, 43 m high). Towers are slender.
constexpr double kChurchSlenderness = 0.55, kLowestChurchM = 6, kHighestChurchM = 40;
constexpr double kTowerSlenderness = 5, kLowestTowerM = 12, kHighestTowerM = 60;
constexpr double kOutbuildingAreaM2 = 30;
constexpr std::int32_t kCellMm = 25'000;
constexpr std::int32_t kRings = 4;  // of cells around a house: 100 m
constexpr std::size_t kEnoughNeighbours = 16;
constexpr std::size_t kFewestNeighbours = 3;

/// Reads numbers from a footprint's tags; what is unreadable or absurd becomes an issue and counts as missing.
class TaggedNumbers {
 public:
  TaggedNumbers(const Footprint& footprint, std::vector<Issue>& issues) : footprint_(footprint), issues_(issues) {}

  std::optional<double> length(const char* key, double least, double most) {
    return checked(key, parse_metres(tag(footprint_.tags, key)), least, most);
  }
  std::optional<double> number(const char* key, double least, double most) {
    return checked(key, parse_number(tag(footprint_.tags, key)), least, most);
  }

 private:
  std::optional<double> checked(const char* key, std::optional<double> value, double least, double most) {
    if (!has_tag(footprint_.tags, key)) return std::nullopt;
    const std::string text = std::string(key) + "=" + tag(footprint_.tags, key);
    const bool is_absurd = value && !(*value > least && *value <= most);
    if (!value || is_absurd)
      issues_.push_back({is_absurd ? IssueCode::absurd_height : IssueCode::unknown_attribute_value,
                         text + (is_absurd ? " cannot be; ignored." : " was not understood; ignored."),
                         footprint_.source_id, footprint_.area.outer[0]});
    return is_absurd ? std::nullopt : value;
  }

  const Footprint& footprint_;
  std::vector<Issue>& issues_;
};

const std::string& kind_of(const Footprint& footprint) {
  return tag(footprint.tags, footprint.is_part ? "building:part" : "building");
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_tower(const Footprint& footprint) {
  return tag(footprint.tags, "man_made") == "tower" || has_tag(footprint.tags, "tower:type") ||
         is_one_of(kind_of(footprint), {"tower", "bell_tower", "campanile", "steeple"});
}

/// Small things are low whatever their neighbours are, but not towers.
bool is_small(const Footprint& footprint, bool is_cut) {
  return is_outbuilding(footprint.tags) || is_open_below(footprint.tags) ||
         (!is_cut && !footprint.is_part && !is_tower(footprint) && area_m2(footprint.area) < kOutbuildingAreaM2);
}

/// Where nothing is known of like houses near by.
double default_height_m(const Footprint& footprint, bool is_low, bool is_cut) {
  const double side_m = std::sqrt(area_m2(footprint.area));
  if (is_low) return kOutbuildingM;
  if (is_cut) return kDefaultM;  // its area says nothing
  if (is_tower(footprint)) return std::clamp(kTowerSlenderness * side_m, kLowestTowerM, kHighestTowerM);
  if (is_one_of(kind_of(footprint), {"church", "cathedral", "basilica", "minster", "abbey", "chapel"}))
    return std::clamp(kChurchSlenderness * side_m, kLowestChurchM, kHighestChurchM);
  return kDefaultM;
}

struct TaggedHeight {
  std::optional<double> top, levels, roof;
};

/// Tops and eaves that the tags state. False: they state no top.
bool set_tagged_height(Footprint& footprint, std::vector<Issue>& issues) {
  TaggedNumbers tagged(footprint, issues);
  const auto top = tagged.length("height", 0, kHighestM);
  const auto levels = tagged.number("building:levels", -1, kMostLevels);
  auto roof = tagged.length("roof:height", -1e-9, kHighestM);
  const auto roof_levels = tagged.number("roof:levels", -1, kMostLevels);
  if (!roof && roof_levels) roof = *roof_levels * kStoreyM;
  const double body = levels ? *levels * kStoreyM : 0;
  if (has_tag(footprint.tags, "roof:shape")) footprint.roof_shape = tag(footprint.tags, "roof:shape");
  if (top) {
    footprint.height_m = *top;
    footprint.height_source = HeightSource::measured;
    const bool has_pitch = footprint.roof_shape != "flat";
    footprint.eave_m = roof ? *top - *roof : has_pitch && body > *top / 2 ? std::min(*top, body) : *top;
    footprint.eave_m = std::max(footprint.eave_m, 0.0);
    return true;
  }
  if (levels && body + roof.value_or(0) > 0) {
    footprint.height_m = body + roof.value_or(0);
    footprint.eave_m = body;
    footprint.height_source = HeightSource::levels;
    return true;
  }
  return false;
}

using Cell = std::pair<std::int32_t, std::int32_t>;

Cell cell_of(PlanPoint p) {
  const auto floor_div = [](std::int32_t v) { return v >= 0 ? v / kCellMm : -((-v + kCellMm - 1) / kCellMm); };
  return {floor_div(p.x), floor_div(p.y)};
}

PlanPoint centre_of(const Footprint& footprint) {
  const PlanBox box = box_of(footprint.area.outer);
  return {static_cast<std::int32_t>((std::int64_t{box.min.x} + box.max.x) / 2),
          static_cast<std::int32_t>((std::int64_t{box.min.y} + box.max.y) / 2)};
}

/// Known heights of one kind of house, by cell, in input order.
class KnownHeights {
 public:
  void add(PlanPoint at, double height) { known_.push_back({cell_of(at), at, height}); }

  void index() {
    std::stable_sort(known_.begin(), known_.end(), [](const Known& a, const Known& b) { return a.cell < b.cell; });
    for (std::size_t i = 0; i < known_.size(); ++i)
      if (i == 0 || known_[i].cell != known_[i - 1].cell) first_.push_back(i);
  }

  /// Weighted median, the nearest cells first, until there are enough.
  std::optional<double> median_near(PlanPoint at) const {
    std::vector<std::pair<double, double>> heights;  // height, weight
    const Cell centre = cell_of(at);
    for (std::int32_t ring = 0; ring <= kRings && heights.size() < kEnoughNeighbours; ++ring)
      for (std::int32_t dx = -ring; dx <= ring; ++dx)
        for (std::int32_t dy = -ring; dy <= ring; ++dy)
          if (std::max(std::abs(dx), std::abs(dy)) == ring)
            collect({centre.first + dx, centre.second + dy}, at, heights);
    if (heights.size() < kFewestNeighbours) return std::nullopt;
    std::sort(heights.begin(), heights.end());
    double total = 0, sum = 0;
    for (const auto& [height, weight] : heights) total += weight;
    for (const auto& [height, weight] : heights)
      if ((sum += weight) * 2 >= total) return height;
    return heights.back().first;
  }

 private:
  struct Known {
    Cell cell;
    PlanPoint at;
    double height;
  };

  void collect(Cell cell, PlanPoint at, std::vector<std::pair<double, double>>& heights) const {
    const auto found = std::lower_bound(first_.begin(), first_.end(), cell,
                                        [&](std::size_t i, const Cell& c) { return known_[i].cell < c; });
    if (found == first_.end() || known_[*found].cell != cell) return;
    constexpr double kNearM = 10;  // nearer than this, neighbours count alike
    for (std::size_t i = *found; i < known_.size() && known_[i].cell == cell; ++i) {
      const double distance = std::hypot(metres(known_[i].at.x) - metres(at.x), metres(known_[i].at.y) - metres(at.y));
      heights.emplace_back(known_[i].height, 1 / (kNearM + distance));
    }
  }

  std::vector<Known> known_;
  std::vector<std::size_t> first_;  // of each cell
};

void set_base(Footprint& footprint, std::vector<Issue>& issues) {
  TaggedNumbers tagged(footprint, issues);
  tagged.length("min_height", -kHighestM, kHighestM);  // for its issue
  footprint.base_m =
      building_base_m(footprint.tags, footprint.is_part ? Theme::part : Theme::building, footprint.height_m);
  if (footprint.base_m < footprint.height_m) return;
  if (footprint.height_source == HeightSource::guessed) {
    // The guess is worth less than the tagged underside.
    footprint.height_m = footprint.base_m + kStoreyM;
  } else {
    issues.push_back({IssueCode::absurd_height, "The underside is not below the top; it was put on the ground.",
                      footprint.source_id, footprint.area.outer[0]});
    footprint.base_m = 0;
  }
}

}  // namespace

void set_heights(std::vector<Footprint>& footprints, const std::vector<bool>& is_cut, std::vector<Issue>& issues) {
  assert(footprints.size() == is_cut.size());
  std::map<std::string, KnownHeights> known;
  std::vector<bool> is_known(footprints.size());
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    is_known[i] = set_tagged_height(footprints[i], issues);
    if (is_known[i] && !is_small(footprints[i], is_cut[i]))
      known[kind_of(footprints[i])].add(centre_of(footprints[i]), footprints[i].height_m);
  }
  for (auto& [kind, heights] : known) heights.index();
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    Footprint& footprint = footprints[i];
    if (!is_known[i]) {
      const bool is_low = is_small(footprint, is_cut[i]);
      const auto like = is_low ? known.end() : known.find(kind_of(footprint));
      const auto median = like == known.end() ? std::nullopt : like->second.median_near(centre_of(footprint));
      const double by_kind = std::round(default_height_m(footprint, is_low, is_cut[i]));
      const bool is_like_others = median && !is_tower(footprint);
      footprint.height_m = is_like_others ? *median : by_kind;
      footprint.height_source = HeightSource::guessed;
      footprint.eave_m = footprint.height_m;
      issues.push_back({IssueCode::no_height,
                        is_like_others ? "No height; as its neighbours."
                                       : "No height; " + std::to_string(std::lround(by_kind)) + " m.",
                        footprint.source_id, footprint.area.outer[0]});
    }
    set_base(footprint, issues);
    footprint.eave_m = std::clamp(footprint.eave_m, footprint.base_m, footprint.height_m);
  }
}

}  // namespace vicus
