#include "sectorgen/models/guess_roof.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "city_db/boxes.hpp"
#include "city_db/polygon_edges.hpp"
#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/tag_values.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/region_style.hpp"

namespace vicus {
namespace {

constexpr double kStorey_m = 3.0;
constexpr double kRise_m = 3.2, kRisePerWidth = 0.66, kMansardRise_m = 4.6;
constexpr double kMostRiseShare = 0.375;  // of the height over the base: 0.6 of the eave
constexpr double kNear_m = 120;
constexpr std::size_t kVoters = 5, kFewestVoters = 3;
constexpr double kMansardFrom_m = 12;

using PlanEdge = std::pair<PlanPoint, PlanPoint>;

PlanPoint centre_of(const Building& b) {
  const PlanBox box = box_of(b.footprint);
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

std::optional<RoofForm> tagged_form(const Tags& tags) { return roof_form_of(lower_case(tag(tags, "roof:shape"))); }

/// Degrees clockwise from north, from a number or a name of the compass.
std::optional<double> parse_direction(const std::string& text) {
  if (const auto number = parse_number(text)) return number;
  static const char* const kNames[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                       "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (text == kNames[i]) return 22.5 * static_cast<double>(i);
  return std::nullopt;
}

/// Houses with a tagged roof, in cells of kNear_m.
class TaggedRoofs {
 public:
  explicit TaggedRoofs(const City& city) {
    for (const auto& b : city.buildings)
      if (const auto form = tagged_form(b.tags)) {
        const PlanPoint at = centre_of(b);
        cells_[cell_of(at)].push_back({at, area_m2(b.footprint), *form});
      }
  }

  std::optional<RoofForm> vote(const Building& b) const {
    if (cells_.empty()) return std::nullopt;
    const PlanPoint at = centre_of(b);
    const double area = area_m2(b.footprint);
    const auto [column, row] = cell_of(at);
    std::vector<std::pair<double, RoofForm>> near;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells_.find({column + dx, row + dy});
        if (cell == cells_.end()) continue;
        for (const auto& known : cell->second) {
          const double distance = std::sqrt(static_cast<double>(distance2(at, known.at))) / kMmPerMetre;
          if (distance <= kNear_m && known.area >= area / 2 && known.area <= area * 2)
            near.emplace_back(distance, known.form);
        }
      }
    if (near.size() < kFewestVoters) return std::nullopt;
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), kVoters));
    std::map<RoofForm, int> votes;
    for (const auto& [distance, form] : near) ++votes[form];
    return std::max_element(votes.begin(), votes.end(),
                            [](const auto& x, const auto& y) { return x.second < y.second; })
        ->first;
  }

 private:
  struct Known {
    PlanPoint at;
    double area;
    RoofForm form;
  };
  static std::pair<std::int32_t, std::int32_t> cell_of(PlanPoint p) {
    constexpr double kCell_mm = kNear_m * kMmPerMetre;
    return {static_cast<std::int32_t>(std::floor(p.x / kCell_mm)),
            static_cast<std::int32_t>(std::floor(p.y / kCell_mm))};
  }
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Known>> cells_;
};

RoofForm form_by_rule(const Building& b, const PlanRectangle& box) {
  const double area = area_m2(b.footprint);
  if (area < 25 || area > 150 || !b.footprint.holes.empty()) return RoofForm::flat;
  const bool is_house = sides_of(b.footprint).size() <= 6 && b.height_m <= 7.5 + kRise_m && box.width_m <= 9 &&
                        area >= 0.7 * box.length_m * box.width_m;
  return is_house ? RoofForm::gabled : RoofForm::flat;
}

/// Compass direction, 0 to 180, of a line along (x, y).
double axis_deg(double x, double y) {
  const double deg = std::atan2(x, y) * 180 / std::numbers::pi;
  return deg < 0 ? deg + 180 : deg;
}

void set_ridge(const Building& b, const PlanRectangle& box, RoofRequest& request) {
  const double along = axis_deg(box.ux, box.uy), across = along < 90 ? along + 90 : along - 90;
  if (const auto direction = parse_direction(tag(b.tags, "roof:direction"))) {
    request.downslope_deg = *direction;
    request.ridge_deg = *direction + 90;
  } else if (const std::string& orientation = tag(b.tags, "roof:orientation");
             orientation == "across" || orientation == "along") {
    request.ridge_deg = orientation == "along" ? along : across;
  } else if (box.length_m < 2 * box.width_m) {
    double longest = 3;  // m: shorter stretches of party wall say nothing
    for (const RoofSide& side : sides_of(b.footprint))
      if (side.length_m > longest && request.is_party[side.edges.front()] && request.is_party[side.edges.back()]) {
        longest = side.length_m;
        request.ridge_deg = axis_deg(side.nx, side.ny);
      }
  }
}

double guessed_rise(const PlanRectangle& box, RoofForm form) {
  switch (form) {
    case RoofForm::mansard:
      return kMansardRise_m;
    case RoofForm::skillion:
      return std::min(0.8, 0.36 * box.width_m);
    case RoofForm::dome:
      return box.width_m / 2;
    case RoofForm::onion:
    case RoofForm::cone:
      return box.width_m;
    default:
      return std::min(kRise_m, kRisePerWidth * box.width_m);
  }
}

void set_rise(const Building& b, const PlanRectangle& box, RoofRequest& request) {
  const auto height = parse_metres(tag(b.tags, "roof:height"));
  const auto levels = parse_number(tag(b.tags, "roof:levels"));
  const auto angle = parse_number(tag(b.tags, "roof:angle"));
  const double most = b.height_m - b.base_m - 0.2;
  request.is_rise_given = true;
  if (height && *height > 0)
    request.rise_m = *height;
  else if (levels && *levels > 0)
    request.rise_m = *levels * kStorey_m;
  else if (angle && *angle > 0 && *angle < 80)
    request.rise_m = std::tan(*angle * std::numbers::pi / 180) * box.width_m / 2;
  else if (b.height_m - b.eave_m > 0.3)
    request.rise_m = b.height_m - b.eave_m;
  else {
    request.is_rise_given = false;
    request.rise_m = std::min(guessed_rise(box, request.form), kMostRiseShare * (b.height_m - b.base_m));
  }
  request.rise_m = std::max(0.1, std::min(request.rise_m, most));
}

}  // namespace

std::vector<RoofWish> guess_roofs(const City& city) {
  const TaggedRoofs tagged(city);
  const bool has_mansards = region_style(city.origin).has_mansards;
  std::vector<PlanEdge> edges;
  for (const auto& b : city.buildings)
    if (b.base_m <= 0) visit_edges(b.footprint, [&](PlanPoint p, PlanPoint q) { edges.push_back({p, q}); });
  std::sort(edges.begin(), edges.end());

  std::vector<RoofWish> wishes(city.buildings.size());
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const Building& b = city.buildings[i];
    RoofRequest& request = wishes[i].request;
    const PlanRectangle box = rectangle_around(b.footprint);
    request.seed = i;
    visit_edges(b.footprint, [&](PlanPoint p, PlanPoint q) {
      request.is_party.push_back(std::binary_search(edges.begin(), edges.end(), PlanEdge{q, p}));
    });
    if (const auto form = tagged_form(b.tags)) {
      request.form = *form;
      wishes[i].source = RoofSource::tagged;
    } else if (b.base_m > 0 || is_open_below(b.tags) || has_tag(b.tags, "building:part")) {
      request.form = RoofForm::flat;
    } else if (const auto voted = tagged.vote(b)) {
      request.form = *voted;
      wishes[i].source = RoofSource::neighbours;
    } else if (has_mansards && b.height_m - b.base_m >= kMansardFrom_m && box.width_m >= 3) {
      request.form = RoofForm::mansard;
      wishes[i].source = RoofSource::preset;
    } else {
      request.form = form_by_rule(b, box);
    }
    if (request.form == RoofForm::flat) continue;
    set_ridge(b, box, request);
    set_rise(b, box, request);
  }
  return wishes;
}

}  // namespace vicus
