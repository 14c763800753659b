#pragma once
#include <cstddef>
#include <vector>

#include "city_db/city.hpp"

/// Where the openings of a facade are: the one source for the painter of its texture and for the geometry of every
/// level of detail, so that the levels agree.
///
/// Frame   x in metres from the facade's left end (its point b) seen from outside, z in metres above its bottom.
/// Source  figures: facades measured in Ingolstadt and Paris (research/HOUSES.md §3).
namespace vicus {

enum class OpeningKind { tall_window, window, wide_window, church_window, house_door, church_door, gate_door, shop };
inline constexpr std::size_t kOpeningKinds = 8;
/// What a Facade may say; a city file with more is damaged.
inline constexpr int kMostFloors = 150, kMostBays = 24, kMostRepeats = 200;

struct Opening {
  OpeningKind kind = OpeningKind::window;
  double x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  int floor = 0;
  int bay = 0;  ///< of the whole facade
};

/// What all facades of a style have in common, metres. A facade's openings scale with its length and height.
struct StyleFigures {
  double bay, ground_floor, storey, cornice;
  double depth;  ///< of openings behind the facade in the fourth level of detail
};
const StyleFigures& figures_of(FacadeStyle style);

/// Of one pattern as it is painted: bays and storeys of the style's own size.
double pattern_width_m(const Facade& facade);
double pattern_height_m(const Facade& facade);
std::vector<Opening> pattern_openings(const Facade& facade);
/// The pattern of a facade's image: doors for people are not in it; where a house has one, its image has a window.
Facade image_pattern(Facade facade);

double length_m(const Facade& facade);
/// All openings in the facade's own metres, pattern by pattern from the left.
std::vector<Opening> openings_of(const Facade& facade);

/// Texture coordinates of a kind of opening in the city's window atlas, which has 4 x 2 tiles of 64 x 64 pixels.
struct AtlasTile {
  double u0, v0, u1, v1;
};
inline constexpr int kAtlasColumns = 4, kAtlasRows = 2, kTilePixels = 64;
AtlasTile atlas_tile(OpeningKind kind);

/// A border's line as straight stretches: index of each one's first point, and last of all the line's last index.
/// Points between stand out by no more than kStraight_mm.
inline constexpr double kStraight_mm = 5;
std::vector<std::size_t> straight_runs(const std::vector<PlanPoint>& line);

}  // namespace vicus
