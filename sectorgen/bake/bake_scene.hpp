#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/tree_shape.hpp"
#include "sectorgen/bake/facade_sums.hpp"

/// A city as the baker sees it: what is seen from the air. Houses as walls and roof planes, the ground as coloured
/// triangles on the terrain, trees.
namespace vicus {

/// A plane over the plan: up(x, y) = up + east (x - x0) + north (y - y0), metres.
struct UpPlane {
  double x0 = 0, y0 = 0, up = 0, east = 0, north = 0;
  double at(double x, double y) const { return up + east * (x - x0) + north * (y - y0); }
};

struct BakeTriangle {
  double x[3], y[3];  ///< counter-clockwise, metres in the plan frame
  std::uint32_t plane = 0;
};

/// The upright wall over a -> b, house on the left.
struct BakeWall {
  double ax = 0, ay = 0, bx = 0, by = 0;
  std::int32_t facade = -1;     ///< of the house; -1: blind
  double from_m = 0, to_m = 0;  ///< of a and b along the facade, from its left end seen from outside
  double top_m = 0;             ///< where the roof begins, at its highest
  double light = 1;             ///< that falls on it (surroundings.hpp)
};

/// Where a wall has a picture.
struct BakeFacade {
  std::shared_ptr<const FacadeSums> picture;     ///< null: blind
  double length_m = 1, bottom_m = 0, top_m = 0;  ///< heights above the plan frame's 0
  int repeats = 1;
};

struct BakeHouse {
  PlanBox box;
  std::string id;
  Polygon footprint;
  double ground_m = 0, eave_m = 0;  ///< above the plan frame's 0; above the ground
  double top_m = 0;                 ///< above the plan frame's 0
  Colour wall_colour, roof_colour;
  std::vector<UpPlane> planes;
  std::vector<Colour> lit_roof;    ///< the roof's colour as each plane shows it
  std::vector<BakeTriangle> roof;  ///< covers the footprint once
  Roof facets;                     ///< the same as the city has it, gables too; heights above the ground
  std::vector<BakeWall> walls;
  std::vector<BakeFacade> facades;
  std::uint64_t key = 0;  ///< of all of this
};

/// A triangle of the ground. There are far more of them than of anything else: no more is kept of one than this.
struct BakeGround {
  std::array<PlanPoint, 3> at;
  SurfaceKind kind = SurfaceKind::pavement;
  PlanBox box() const {
    PlanBox out;
    for (const PlanPoint p : at) out.add(p);
    return out;
  }
};

inline constexpr std::int32_t kGroundSquare_mm = 64'000;

struct BakeTree {
  std::string id;
  PlanPoint at;
  PlanBox box;          ///< of the crown
  double ground_m = 0;  ///< above the plan frame's 0
  TreeShape shape;
  std::uint64_t key = 0;  ///< of all of this
};

/// Differs what lies under a house's underside (passages) is filled: nobody sees it from above.
class BakeScene {
 public:
  /// `picture`: the PNG of a texture by id; empty where there is none (its facades are blind).
  BakeScene(const City& city, const std::function<std::string(const std::string& id)>& picture, unsigned threads);

  const std::vector<BakeHouse>& houses() const { return houses_; }  ///< by id
  const std::vector<BakeGround>& ground() const { return ground_; }
  const std::vector<BakeTree>& trees() const { return trees_; }  ///< by id
  const Terrain& terrain() const { return terrain_; }
  std::vector<std::uint32_t> houses_in(const PlanBox& box) const;  ///< whose box meets it, in order
  std::vector<std::uint32_t> ground_in(const PlanBox& box) const;
  /// Some square of kGroundSquare_mm (from the origin on) that meets the box has none.   Error  triangles count by
  /// their boxes.
  bool lacks_ground(const PlanBox& box) const;
  std::vector<std::uint32_t> trees_in(const PlanBox& box) const;  ///< whose crown meets it, in order
  /// Of everything that a tile of this box is made from.
  std::uint64_t key_of(const PlanBox& box) const;
  const PlanBox& box() const { return box_; }  ///< of all houses and ground

 private:
  class Grid {
   public:
    void add(const PlanBox& box, std::uint32_t item);
    std::vector<std::uint32_t> find(const PlanBox& box) const;
    bool is_full(const PlanBox& box) const;  ///< every cell that meets the box has an item

   private:
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
  };
  void add_house(const Building& house, BakeHouse& out) const;
  void add_ground(const City& city);
  void add_trees(const City& city);

  std::vector<BakeHouse> houses_;
  std::vector<BakeGround> ground_;
  std::vector<BakeTree> trees_;
  Terrain terrain_;
  std::uint64_t terrain_key_ = 0;
  Grid house_grid_, ground_grid_, tree_grid_;
  PlanBox box_;
};

/// The PNGs of City::textures.  Needs   the city outlives it.
std::function<std::string(const std::string&)> pictures_of(const City& city);

/// Colours of a stretch of wall: `from`, `to` are 0 at a ... 1 at b, heights above the plan frame's 0. Above the wall
/// it is the roof that shows.
class WallColumn {
 public:
  /// Needs   house and wall outlive it.
  WallColumn(const BakeHouse& house, const BakeWall& wall, double from, double to);
  /// Integral of the colour over the height, up to `up_m`, from a height of its own choice: differences are what
  /// counts.
  ColourMean up_to(double up_m) const;

 private:
  ColourMean plain_, roof_;
  double top_m_, u0_ = 0, u1_ = 0;
  const BakeFacade* facade_ = nullptr;  // with a picture
};

/// Mean colour of it between two heights.
ColourMean wall_mean(const BakeHouse& house, const BakeWall& wall, double from, double to, double low_m, double high_m);

/// FNV-1a over whole numbers, for keys.
class KeyHash {
 public:
  void add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) hash_ = (hash_ ^ ((value >> (8 * i)) & 0xff)) * 0x100000001b3u;
  }
  void add(const std::string& text) {
    for (const char c : text) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    add(text.size());
  }
  std::uint64_t value() const {
    const std::uint64_t mixed = (hash_ ^ (hash_ >> 32)) * 0x9E3779B97F4A7C15u;
    return mixed ^ (mixed >> 29);
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace vicus
