#pragma once
#include <array>
#include <string>
#include <vector>

/// Faces as a browser reads them: out of the text, as 32-bit floats. Shares no code with the writers.
namespace vicus::test {

struct ReadPoint {
  float x = 0, y = 0, z = 0;
};

struct ReadFace {
  std::string shape;  ///< DEF of the Shape
  std::vector<ReadPoint> corners;
  std::array<double, 3> normal{};  ///< of the first three corners, length 1
};

/// Faces of every IndexedFaceSet of an X3D XML file of ours, in file order.
std::vector<ReadFace> faces_in(const std::string& x3d);

/// Values of the attribute in elements of that name, unescaped, in file order.
std::vector<std::string> attributes_in(const std::string& x3d, const std::string& element,
                                       const std::string& attribute);

}  // namespace vicus::test
