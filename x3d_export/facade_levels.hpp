#pragma once
#include <map>
#include <string>
#include <vector>

#include "city_db/facade_layout.hpp"
#include "x3d_export/mesh.hpp"

/// One facade in the four levels of detail of paper 004 §4.2 ("Urban LOD"), all from one layout of its openings.
///
/// Levels  1 silhouette: the wall in the mean colour of wall and openings. 2 = 1 + quads of windows and doors in front
/// of it, from the city's
///         atlas. 3 = one texture over the facade, the door before it, balconies and sills, about as many
///         triangles as 2. 4 = the openings
///         of level 2 set into the wall of 3 at their depth, with its balconies.
/// Frame   the sector's own.
namespace vicus {

/// Faces in one colour each, and faces under an image.
struct LevelFaces {
  std::vector<Face> solid;
  std::vector<TexturedFace> atlas;                              ///< under the atlas of windows and doors
  std::map<std::string, std::vector<TexturedFace>> own_images;  ///< by id of the texture
  std::size_t triangles() const;
};

/// Distance of level 2's quads before the wall: two steps of a 24-bit depth buffer at 200 m (near 0.1 m), so they do
/// not flicker out to 250 m. research/HOUSES.md §7.
inline constexpr double kQuadOffset_m = 0.05;

/// Mean colour of an opening as it is painted (sectorgen/models/paint_openings).
Colour opening_colour(OpeningKind kind);
/// What a facade looks like from where its openings cannot be told apart: the mean of wall and openings by area.
Colour mean_colour(const Facade& facade, Colour wall);

/// Adds the facade to all four levels (levels[0] is level 1).
/// Error   level 4 sets the openings of the lowest ten floors only; above them nobody sees the depth.
/// `taken`: triangles that the house spends on other relief of level 3, its chimneys.
/// `ground_m`: of the house, Building::ground_m.
void add_facade(const Facade& facade, Colour wall, double ground_m, PlanPoint origin, std::size_t taken,
                LevelFaces (&levels)[4]);

/// The same facade as several, pattern by pattern, none with more than `most` openings where a pattern has fewer.
std::vector<Facade> split_facade(const Facade& facade, int most);

}  // namespace vicus
