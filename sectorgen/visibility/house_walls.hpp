#pragma once
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/visibility/roof_shape.hpp"

/// The houses as sight over roofs needs them: walls in a grid, lines cut by them, discs of roof.
namespace vicus {

inline constexpr double kEyeTop_m = 2.0;  ///< eyes are 1.2 to 2.0 m above ground

/// A height below everything: there is no roof.
inline constexpr float kNoRoof_m = -1e6F;

/// One edge of a footprint, house on the left.
struct HouseWall {
  Spot a, b;
  std::uint32_t house = 0;
  float beyond_m = kNoRoof_m;  ///< sure eave of the house on the other side
  float sure_top_m = 0;        ///< of the house, or a little more; kNoRoof_m: it does not stand
};

/// A house that stands on the ground fills at least its footprint up to its roof, sure_eave_m and more, and never
/// reaches above most_top_m, wherever between the least and the greatest height of the ground below it its own 0 is.
/// In the plan frame's height; base_m above the ground. A house without roof triangles is sure up to the eave only.
struct HouseBody {
  double base_m = 0, sure_zero_m = 0, most_zero_m = 0;
  double sure_eave_m = 0, sure_top_m = 0;  ///< the lowest and the highest that it surely reaches
  double most_eave_m = 0, most_top_m = 0;  ///< the most that its walls reach, and its roof
  std::uint32_t first_wall = 0, last_wall = 0, first_triangle = 0, last_triangle = 0;
  bool stands() const { return base_m <= 0; }
};

/// A line's way through a house, as shares of its length.
struct Crossing {
  double from = 0, to = 0;
  std::uint32_t house = 0;
};

class HouseWalls {
 public:
  explicit HouseWalls(const City& city);

  const std::vector<HouseBody>& houses() const { return houses_; }
  const std::vector<HouseWall>& walls() const { return walls_; }

  /// Where the line p -> q, rising from p_up_m by rise_m, runs through houses that stand and surely reach it, by
  /// `from`. A crossing may go on where it should not: beyond where the line is above the house. Needs   p in no house
  /// (on a wall is well).   Error  rounding of doubles: ends within 1 um.
  void cut(Spot p, Spot q, double p_up_m, double rise_m, std::vector<Crossing>& out) const;

  /// The same for one house.
  void cut(Spot p, Spot q, std::uint32_t house, std::vector<Crossing>& out) const;

  /// The line from p (in no house) at height p_up_m to q meets no house. Cheap where something near p stops it. Never
  /// true when a house is in the way: what hangs over ground counts from the ground up, and 2 cm are added on top. Of
  /// the house `goal`, to whose roof the line leads, only what stands higher than the line counts, and not the last
  /// 5 cm.
  bool is_clear(Spot p, double p_up_m, Spot q, double q_up_m, std::uint32_t goal = kNoHouse) const;

  /// Every point within `radius` of x lies in houses that stand and surely reach up to `up_m`, x in `house`.
  /// Never true when it is not: 1 mm of doubt counts against it.
  bool is_roofed(Spot x, double radius, std::uint32_t house, double up_m) const;

  static constexpr std::uint32_t kNoHouse = 0xFFFFFFFFu;
  const RoofTriangle* triangles(std::uint32_t i) const { return triangles_.data() + i; }

 private:
  bool contains(std::uint32_t house, Spot x) const;
  bool is_near_open_wall(std::uint32_t house, Spot x, double reach2) const;
  bool reaches(const HouseBody& house, Spot x, double reach, double up_m) const;
  bool roof_stops(std::uint32_t house, Spot p, double p_up_m, Spot q, double q_up_m, bool is_goal) const;
  template <class Visit>
  void visit_cells(Spot p, Spot q, Visit visit) const;
  std::size_t cell_at(std::int64_t column, std::int64_t row) const;

  std::vector<HouseBody> houses_;
  std::vector<HouseWall> walls_;
  std::vector<RoofTriangle> triangles_;  // by house
  double cell_m_ = 12, left_ = 0, bottom_ = 0;
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> cell_begin_;
  std::vector<HouseWall> cell_walls_;  // copies, cell by cell: lines and discs read them in a row
};

}  // namespace vicus
