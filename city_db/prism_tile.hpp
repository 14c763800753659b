#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/tree_shape.hpp"

/// The houses of a tile as prisms with simple roofs, and its trees: what a client turns into polygons. Bytes:
/// prism_tile_layout.h. Source  research/IMAGE_BASED.md §0: for prisms the polygon wins near and mid.
namespace vicus {

/// faceted: the house's own roof.
enum class PrismKind : std::uint8_t { flat, tent, gabled, hipped, faceted };

/// A corner of a roof that is none of the footprint's.
struct PrismPoint {
  PlanPoint at;         ///< steps from the tile's corner
  std::int32_t up = 0;  ///< steps above the eave
  friend auto operator<=>(const PrismPoint&, const PrismPoint&) = default;
};

/// A face of a roof, drawn as a fan from its first corner; counter-clockwise from outside.
struct PrismFacet {
  bool is_gable = false;               ///< has the wall's colour
  std::vector<std::uint32_t> corners;  ///< points of the rings in their order, at the eave; then PrismHouse::points
  friend bool operator==(const PrismFacet&, const PrismFacet&) = default;
};

struct PrismHouse {
  PrismKind kind = PrismKind::flat;
  bool is_owned = true;       ///< its middle lies in the tile
  std::uint8_t quadrant = 0;  ///< of the middle: 0 south-west, 1 south-east, 2 north-west, 3 north-east; 0 if not owned
  /// Steps from the tile's corner; outer counter-clockwise, then holes clockwise; at least three points each.
  std::vector<std::vector<PlanPoint>> rings;
  std::int32_t ground = 0;           ///< steps above the tile's base
  std::uint32_t eave = 0, rise = 0;  ///< steps above the ground, above the eave; faceted: of its highest point
  std::uint16_t wall = 0, roof = 0;  ///< of the palette
  /// Faceted only. With the walls up to the eave the facets are closed: each edge of one is one of another, turned
  /// round, or of a ring.
  std::vector<PrismPoint> points = {};
  std::vector<PrismFacet> facets = {};
  friend bool operator==(const PrismHouse&, const PrismHouse&) = default;
};

struct PrismTree {
  PlanPoint at;              ///< steps from the tile's corner: the south-west one of the lattice's square it stands in
  std::int32_t ground = 0;   ///< steps above the tile's base
  std::uint32_t height = 0;  ///< steps above the ground
  std::uint32_t crown = 0;   ///< radius, in steps of height
  TreeForm form = TreeForm::round;
  std::uint8_t quadrant = 0;  ///< as a house's; every tree of a tile is owned
  std::uint16_t leaves = 0;   ///< of the palette
  friend bool operator==(const PrismTree&, const PrismTree&) = default;
};

struct PrismTile {
  PlanPoint corner;
  std::uint32_t tile_side_mm = 0;
  std::int32_t base_mm = 0;
  std::uint32_t step_mm = 1, up_step_mm = 1, error_mm = 0;
  std::uint64_t key = 0;
  std::vector<Colour> palette;
  std::vector<PrismHouse> houses;
  std::vector<PrismTree> trees = {};
  friend bool operator==(const PrismTile&, const PrismTile&) = default;
};

/// The first of the points nearest to p, by the sum of both distances along the axes.   Needs   some points.
std::size_t nearest_to(PlanPoint p, const std::vector<PlanPoint>& points);
/// The rise of a faceted house.
std::uint32_t highest_of(const std::vector<PrismPoint>& points);

/// Needs   gabled and hipped houses have one ring of four points; only faceted ones points and facets, of three corners
///         and more; indices exist; rise as said above.
std::string encode_prisms(const PrismTile& tile);
/// Of hostile bytes; nullopt for what encode_prisms cannot have made.
std::optional<PrismTile> decode_prisms(std::string_view bytes);

}  // namespace vicus
