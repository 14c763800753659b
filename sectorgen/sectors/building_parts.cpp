#include "sectorgen/sectors/building_parts.hpp"

#include <algorithm>
#include <iterator>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/box_pairs.hpp"
#include "sectorgen/geo/shared_area.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/obstacles.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

using Polygons = std::vector<Polygon>;

constexpr double kSlit_m = 0.5;          // narrower gaps between parts are how they were drawn
constexpr double kLeastColumn_m2 = 0.3;  // smaller ones are crumbs of overlays
constexpr double kLeastBody_m2 = 1;
constexpr double kComplete = 0.6;  // of the outline: then ground without a part is open
constexpr double kOver = 0.9;      // share of open ground that parts hang over
constexpr double kPosts = 0.1;     // of a part: what bears less of it are posts
constexpr double kWithin = 0.9;    // of a house within a larger one's outline: it is a part, whatever its tags say
constexpr double kGap_m = 0.5;     // between a part and what bears it: more is air
constexpr double kInRoof_m = 0.5;  // so far above the eave a part stands in a roof, not on walls

double area_m2_of(const Polygons& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) sum += area_m2(p);
  return sum;
}

void drop_crumbs(Polygons& polygons, double least_m2) {
  std::erase_if(polygons, [&](const Polygon& p) { return area_m2(p) < least_m2; });
}

/// A part, or the outline's own body.
struct Block {
  std::uint32_t footprint = kNoFootprint;
  Polygons area;
  double base_m = 0, top_m = 0, eave_m = 0;
  bool has_slopes = false;
  bool stands() const { return base_m <= kWalkUnderMetres; }
};

Block block_of(const SourceMap& map, std::uint32_t part, const Footprint& outline) {
  const Footprint& f = map.footprints[part];
  Block block{part, {}, f.base_m, f.height_m, f.eave_m, f.roof_shape != "flat"};
  if (f.height_source == HeightSource::guessed && outline.height_source != HeightSource::guessed &&
      outline.height_m > f.base_m)
    block.top_m = outline.height_m, block.eave_m = std::clamp(outline.eave_m, f.base_m, outline.height_m);
  return block;
}

/// What is left of `free` when it is opened by half a slit, and the slits.
std::pair<Polygons, Polygons> wide_and_slits(const Polygons& free) {
  Polygons wide = intersect(offset(offset(free, -kSlit_m / 2, false), kSlit_m / 2 + 0.01, false), free);
  drop_crumbs(wide, kLeastBody_m2);
  Polygons slits = wide.empty() ? free : subtract(free, wide);
  return {std::move(wide), std::move(slits)};
}

class Columns {
 public:
  Columns(const SourceMap& map, std::uint32_t outline, const std::vector<std::uint32_t>& parts)
      : outline_(map.footprints[outline]) {
    for (const std::uint32_t i : parts) {
      Block block = block_of(map, i, outline_);
      block.area =
          block.stands() ? intersect(outline_.area, {map.footprints[i].area}) : Polygons{map.footprints[i].area};
      if (!block.area.empty()) (block.stands() ? standing_ : hanging_).push_back(std::move(block));
    }
    add_body(outline);
  }

  std::vector<HouseColumn> take() {
    // From the lowest up: what it stands on is settled by then.
    std::stable_sort(hanging_.begin(), hanging_.end(),
                     [](const Block& a, const Block& b) { return a.base_m < b.base_m; });
    settled_ = standing_;
    for (const Block& block : hanging_) settle(block);
    std::stable_sort(standing_.begin(), standing_.end(),
                     [](const Block& a, const Block& b) { return a.top_m > b.top_m; });
    Polygons taken;
    for (const Block& block : standing_) {
      put(block, taken.empty() ? block.area : subtract(block.area, taken), 0);
      taken.insert(taken.end(), block.area.begin(), block.area.end());
    }
    mark_main();
    return std::move(columns_);
  }

 private:
  /// The outline where no part stands.
  void add_body(std::uint32_t outline) {
    if (outline_.base_m > kWalkUnderMetres) return;
    Polygons covered;
    for (const Block& block : standing_) covered.insert(covered.end(), block.area.begin(), block.area.end());
    const Polygons free = covered.empty() ? Polygons{outline_.area} : subtract(outline_.area, covered);
    if (free.empty()) return;
    auto [wide, slits] = wide_and_slits(free);
    grow_into(slits);
    const double covered_m2 = area_m2(outline_.area) - area_m2_of(free);
    const bool is_complete = covered_m2 >= kComplete * area_m2(outline_.area);
    for (Polygon& piece : wide) {
      Block body{outline, {}, 0, outline_.height_m, outline_.eave_m, outline_.roof_shape != "flat"};
      double over_m2 = 0;
      for (const Block& block : standing_) body.top_m = std::min(body.top_m, block.top_m);
      for (const Block& block : hanging_) {
        const double shared = area_m2_of(intersect(piece, block.area));
        over_m2 += shared;
        if (shared >= kLeastColumn_m2) body.top_m = std::min(body.top_m, block.base_m);
      }
      if (is_complete && over_m2 >= kOver * area_m2(piece)) continue;
      body.eave_m = std::min(body.eave_m, body.top_m);
      if (body.top_m < outline_.height_m) body.eave_m = body.top_m, body.has_slopes = false;
      body.area = {std::move(piece)};
      standing_.push_back(std::move(body));
    }
  }

  void grow_into(Polygons slits) {
    for (Block& block : standing_) {
      drop_crumbs(slits, 1e-4);
      if (slits.empty()) return;
      const Polygons gained = intersect(offset(block.area, kSlit_m, false), slits);
      if (gained.empty()) continue;
      slits = subtract(slits, gained);
      block.area.insert(block.area.end(), gained.begin(), gained.end());
      block.area = unite(block.area);
    }
  }

  /// A part off the ground, piece by piece: on what bears it, in a roof, or in the air.
  void settle(const Block& block) {
    std::stable_sort(settled_.begin(), settled_.end(),
                     [](const Block& a, const Block& b) { return a.top_m > b.top_m; });
    Polygons left = block.area, borne, hanging;
    const auto move_to = [](Polygons& from, Polygons& to) {
      std::move(from.begin(), from.end(), std::back_inserter(to));
    };
    for (const Block& below : settled_) {
      if (below.base_m >= block.base_m) continue;
      Polygons pieces = intersect(left, below.area);
      drop_crumbs(pieces, kLeastColumn_m2);
      if (pieces.empty()) continue;
      left = subtract(left, pieces);
      if (below.has_slopes && below.eave_m + kInRoof_m < block.base_m)
        put(block, std::move(pieces), std::max(below.eave_m, kWalkUnderMetres + 0.1));
      else
        move_to(pieces, below.stands() && below.top_m + kGap_m >= block.base_m ? borne : hanging);
    }
    move_to(left, hanging);
    const bool is_on_posts = area_m2_of(borne) < kPosts * area_m2_of(block.area);  // they go on to stand below it
    if (is_on_posts) move_to(borne, hanging);
    settled_.push_back(block);
    settled_.back().area = unite(hanging);
    put(block, settled_.back().area, block.base_m);
    if (is_on_posts) return;
    standing_.push_back(block);
    standing_.back().base_m = 0;
    standing_.back().area = unite(borne);
    settled_.push_back(standing_.back());
  }

  void put(const Block& block, Polygons pieces, double base_m) {
    drop_crumbs(pieces, kLeastColumn_m2);
    for (Polygon& piece : pieces)
      columns_.push_back({block.footprint, std::move(piece), base_m, block.top_m, block.eave_m, false});
  }

  void mark_main() {
    HouseColumn* main = nullptr;
    for (HouseColumn& column : columns_)
      if (column.base_m <= 0 && (main == nullptr || area_m2(column.area) > area_m2(main->area))) main = &column;
    if (main == nullptr && !columns_.empty()) main = &columns_.front();
    if (main != nullptr) main->is_main = true;
  }

  const Footprint& outline_;
  std::vector<Block> standing_, hanging_, settled_;
  std::vector<HouseColumn> columns_;
};

/// The house that each footprint is a part of: by tag, or because it lies within a larger one's outline.
std::vector<std::uint32_t> holders_of(const SourceMap& map) {
  std::vector<std::uint32_t> holder(map.footprints.size(), kNoFootprint);
  std::vector<double> share(map.footprints.size(), 0), size_m2;
  std::vector<PlanBox> boxes;
  for (const Footprint& f : map.footprints) boxes.push_back(box_of(f.area)), size_m2.push_back(area_m2(f.area));
  const auto offer = [&](std::uint32_t part, std::uint32_t outline) {
    const Footprint &p = map.footprints[part], &o = map.footprints[outline];
    const auto is_larger = [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(size_m2[a], b) > std::pair(size_m2[b], a);
    };
    if (o.is_part || common_box_m2(boxes[part], boxes[outline]) < (p.is_part ? 1e-6 : kWithin * size_m2[part])) return;
    const bool is_house_below = !p.is_part && std::max(p.base_m, o.base_m) > kWalkUnderMetres;
    if (is_house_below || (!p.is_part && !is_larger(outline, part))) return;
    const double shared = shared_area_m2(p.area, o.area) / size_m2[part];
    if (!p.is_part && shared < kWithin) return;
    // Of two that hold it alike the larger, which holds the other as well.
    const bool is_alike = std::abs(shared - share[part]) < 0.01;
    if (holder[part] == kNoFootprint || (is_alike ? is_larger(outline, holder[part]) : shared > share[part]))
      holder[part] = outline, share[part] = shared;
  };
  for (const auto& [i, j] : box_pairs(boxes, 0)) {
    offer(i, j);
    offer(j, i);
  }
  for (std::uint32_t& h : holder)
    while (h != kNoFootprint && holder[h] != kNoFootprint) h = holder[h];
  return holder;
}

}  // namespace

BuildingParts::BuildingParts(const SourceMap& map)
    : map_(map), parts_of_(map.footprints.size()), holder_(holders_of(map)) {
  for (std::uint32_t i = 0; i < holder_.size(); ++i)
    if (holder_[i] != kNoFootprint) parts_of_[holder_[i]].push_back(i);
}

std::vector<HouseColumn> BuildingParts::columns_of(std::uint32_t outline) const {
  return Columns(map_, outline, parts_of_[outline]).take();
}

}  // namespace vicus
