#pragma once
#include <string>
#include <vector>

#include "sectorgen/sectors/ground.hpp"
#include "sectorgen/sectors/routes.hpp"

/// Where the ground is cut: corridors, their mouths, junctions, yards (research/SECTORS.md §4.4-4.8).
namespace vicus {

enum class CellKind : char { street, junction, yard };

/// Free ground that is no cell: a yard behind narrow gaps, a courtyard no street reaches, ground beyond the city.
enum class Closed : char { no, yard, courtyard, outside };

/// Which cell each free triangle belongs to; kNone: not walkable (closed off, or never reached).
struct Cells {
  std::vector<std::uint32_t> of;  ///< per triangle
  std::vector<CellKind> kind;     ///< per cell
  std::vector<Closed> closed;     ///< per triangle
};

struct CutOptions {
  double piece_m = 120;              ///< long streets are cut into pieces about this long
  bool join_across_islands = false;  ///< cells that would meet across an island become one
  double fence_m = 0.9;              ///< ground behind gaps narrower than this is closed off
};

/// Street and junction cells from the used edges, yards behind them.
/// Differs ties are broken by coordinates; kerbs bound a street; gaps between detached houses lead into yards.
Cells cut_cells(const Ground& ground, const StreetRoutes& routes, const CutOptions& options);

/// Joins what a person would not have cut: small crossroads with one of their streets, wedges, slivers, short pieces of
/// one street.
void merge_cells(const Ground& ground, const StreetRoutes& routes, Cells& cells);

/// Cells longer than 240 m, mostly open ground, are cut in pieces of about 200 m, each cut the cheapest near its place:
/// short, along plot lines and outlines rather than across the grass. What is cut depends on the cell alone, so an edit
/// beyond its neighbours changes nothing.
void split_long_cells(const Ground& ground, const CutOptions& options, Cells& cells);

/// A sector's bytes grow with the sides of its ground: about kBytesPerSide each (docs/figures.md), with the house
/// behind.
inline constexpr std::uint64_t kBytesPerSide = 45;
/// Whatever the budget: the record of a sector with more sides takes more than the 100 kB, as text, that a browser
/// parses without a halt (DESIGN §10), and unlike houses it cannot be told in parts.
inline constexpr std::uint32_t kMostSides = 1800;

/// Cells with more sides than the limit are halved until none has: rule 6 of DESIGN §3. Their small obstacles must be
/// in the mesh first: the first function names those that are not.
std::vector<PlanPoint> islands_in_heavy_cells(const Ground& ground, const Cells& cells, std::uint32_t limit);
void split_heavy_cells(const Ground& ground, Cells& cells, std::uint32_t limit);

/// First points of the islands that some cell's boundary crosses: they must be made obstacles, and the ground cut anew.
/// None with CutOptions::join_across_islands.
std::vector<PlanPoint> crossed_islands(const Ground& ground, const Cells& cells);

}  // namespace vicus
