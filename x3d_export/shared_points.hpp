#pragma once
#include <string>
#include <vector>

#include "x3d_export/numbering.hpp"
#include "x3d_export/scene.hpp"

namespace vicus {

/// "x y z" of each point in turn, metres.
std::vector<double> numbers_of(const std::vector<X3dPoint>& points);

/// Corners of several Shapes in one Coordinate node: the levels of a facade stand on the same corners, and half of a
/// near file's text are points.
class SharedPoints {
 public:
  explicit SharedPoints(std::string def) : def_(std::move(def)) {}
  std::int32_t operator()(const X3dPoint& point) { return number_of_(point); }
  /// For each Shape.
  Node coordinate() const;
  /// The first coordinate() below `root`, in the order of the file, becomes the one that has the points; to be called
  /// once all Shapes are there.
  void put_into(Node& root) const;

 private:
  std::string def_;
  Numbering<X3dPoint> number_of_;
};

}  // namespace vicus
