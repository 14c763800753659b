#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "x3d_export/colours.hpp"
#include "x3d_export/frames.hpp"
#include "x3d_export/scene.hpp"

/// Faces of one material on their way into one Shape.
namespace vicus {

/// A planar, convex face of 3 or 4 corners, counter-clockwise seen from outside, of one colour.
struct Face {
  std::array<X3dPoint, 4> corners;
  int count = 4;
  Colour colour;
  std::uint8_t bays = 0, floors = 0;  ///< of a wall seen from afar (far_windows.hpp): its windows; 0: plain
};

/// A planar face of 4 corners, counter-clockwise seen from outside, under an image.
struct TexturedFace {
  std::array<X3dPoint, 4> corners;
  std::array<std::array<double, 2>, 4> uv;  ///< 0 ... 1 from the image's left and bottom; beyond it repeats
};

enum class Shading {
  solid,      ///< lit, seen from outside only
  two_sided,  ///< lit, seen from both sides
  backdrop    ///< not lit, seen from its front only
};

/// All faces of one material of a sector.
struct Layer {
  std::string name;  ///< DEF of its Shape
  Shading shading = Shading::solid;
  std::vector<Face> faces;
  std::string grain = {};  ///< id of the image that gives it its grain (ground_grain.hpp); empty: none
};

/// Frame   faces in the frame of the sector with the plan origin `origin`.
class FaceList {
 public:
  /// `lift_m` is added to every height but those of add_ground and add_sloped_wall.
  explicit FaceList(PlanPoint origin, double lift_m = 0) : origin_(origin), lift_mm_(height_mm(lift_m)) {}
  void set_lift(double lift_m) { lift_mm_ = height_mm(lift_m); }
  /// The upright wall over the line from `a` to `b`, seen from the left of a -> b. Nothing when it has no area.
  void add_wall(PlanPoint a, PlanPoint b, double bottom_m, double top_m, Colour colour, int bays = 0, int floors = 0);
  /// Triangles of `polygon` at a height, seen from above, or from below.
  void add_floor(const Polygon& polygon, const Triangles& triangles, double up_m, Colour colour, bool from_below);
  /// Triangles with heights of their own; upright ones have no top to see.
  void add_ground(const std::vector<GroundPoint>& points, const Triangles& triangles, Colour colour);
  /// add_wall over ground that is `a_mm` and `b_mm` high, from `low_m` to `high_m` above it.
  void add_sloped_wall(PlanPoint a, PlanPoint b, std::int32_t a_mm, std::int32_t b_mm, double low_m, double high_m,
                       Colour colour);
  /// The triangle through three points of a roof, counter-clockwise seen from outside. Nothing when it has no area in
  /// whole millimetres.
  void add_triangle(const RoofPoint& a, const RoofPoint& b, const RoofPoint& c, Colour colour);
  /// A prism of `sides` sides around `at`; radius 0 makes that end a point, else it is left open.
  void add_spindle(PlanPoint at, int sides, double radius_low_m, double radius_high_m, double low_m, double high_m,
                   Colour colour);
  /// Four walls and a top, `width_m` square along the axes.
  void add_block(PlanPoint middle, double width_m, double bottom_m, double top_m, Colour colour);
  std::vector<Face> take() { return std::move(faces_); }

 private:
  std::int32_t up(double m) const { return height_mm(m) + lift_mm_; }
  PlanPoint origin_;
  std::int32_t lift_mm_ = 0;
  std::vector<Face> faces_;
};

class SharedPoints;

/// From a sector's file.
std::string texture_url(const std::string& id);

/// A Shape with an IndexedFaceSet, one colour per face, normals by face (creaseAngle 0), equal corners written once.
/// `points`: where the corners go instead, to be written once for several Shapes.
/// Needs   !faces.empty() (assert).
Node shape_of(const std::string& def, Shading shading, std::span<const Face> faces, SharedPoints* points = nullptr);

/// Upright walls of four corners, all of one colour, not lit, whole below and fading into what is behind them towards
/// their tops. In VRML97, which has no such colours, they end all at once.
/// Needs   !faces.empty() (assert).
Node fading_shape(const std::string& def, std::span<const Face> faces);

/// A Shape under one image. Its Appearance's DEF is "IMAGE-" + `image`: equal ones in a file can be USEd.
/// Needs   !faces.empty() (assert).
Node textured_shape(const std::string& image, const std::string& url, std::span<const TexturedFace> faces,
                    SharedPoints* points = nullptr);

}  // namespace vicus
