#pragma once
#include <cstddef>
#include <vector>

#include "city_db/city.hpp"

/// Where the openings of a facade are: the one source for the painter of its texture and for the geometry of every
/// level of detail, so that the levels agree.
///
/// Frame   Opening's.
/// Source  figures: facades measured in Ingolstadt and Paris (research/HOUSES.md §3).
namespace vicus {

/// What a Facade may say; a city file with more is damaged.
inline constexpr int kMostFloors = 150, kMostBays = 24, kMostRepeats = 200;
inline constexpr std::size_t kMostOwnOpenings = 2000;

/// What all facades of a style have in common, metres. A facade's openings scale with its length and height.
struct StyleFigures {
  double bay, ground_floor, storey, cornice;
  double depth;  ///< of openings behind the facade in the fourth level of detail
};
const StyleFigures& figures_of(FacadeStyle style);

/// Of one pattern as it is painted: bays and storeys of the style's own size; with openings of its own, the facade.
double pattern_width_m(const Facade& facade);
double pattern_height_m(const Facade& facade);
std::vector<Opening> pattern_openings(const Facade& facade);
/// The pattern of a facade's image: doors for people are not in it; where a house has one, its image has a window. Of
/// own openings all are in it.
Facade image_pattern(Facade facade);

double length_m(const Facade& facade);
/// All openings in the facade's own metres, pattern by pattern from the left; its own where it has any.
std::vector<Opening> openings_of(const Facade& facade);
/// About how many they are, at once.
int opening_count(const Facade& facade);

/// Texture coordinates of a kind of opening in the city's window atlas, which has 4 x 2 tiles of 64 x 64 pixels.
struct AtlasTile {
  double u0, v0, u1, v1;
};
inline constexpr int kAtlasColumns = 4, kAtlasRows = 2, kTilePixels = 64;
inline constexpr double kTileInset_px = 1.5;  ///< of a tile that is not shown: neighbours stay out of the filter
AtlasTile atlas_tile(OpeningKind kind);

/// A border's line as straight stretches: index of each one's first point, and last of all the line's last index.
/// Points between stand out by no more than kStraight_mm.
inline constexpr double kStraight_mm = 5;
std::vector<std::size_t> straight_runs(const std::vector<PlanPoint>& line);

}  // namespace vicus
