#include "tests/support/x3d_text.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace vicus::test {
namespace {

template <class T>
std::vector<T> numbers_in(const std::string& text) {
  std::istringstream in(text);
  std::vector<T> values;
  for (std::string word; in >> word;) values.push_back(static_cast<T>(std::stof(word)));
  return values;
}

std::string unescaped(std::string text) {
  for (const auto& [entity, character] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&apos;", "'"}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string(entity).size(), character);
  return text;
}

/// Values of one attribute in the start tags of one element; a tag without it gives "".
std::string attribute_of(const std::string& tag, const std::string& attribute) {
  const auto at = tag.find(" " + attribute + "='");
  if (at == std::string::npos) return {};
  const auto first = at + attribute.size() + 3;
  return unescaped(tag.substr(first, tag.find('\'', first) - first));
}

std::array<double, 3> normal_of(const std::vector<ReadPoint>& c) {
  const double ux = c[1].x - c[0].x, uy = c[1].y - c[0].y, uz = c[1].z - c[0].z;
  const double vx = c[2].x - c[1].x, vy = c[2].y - c[1].y, vz = c[2].z - c[1].z;
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(length > 0)) throw std::runtime_error("a face without area");
  return {nx / length, ny / length, nz / length};
}

void add_faces(std::vector<ReadFace>& faces, const std::string& shape, const std::string& indices,
               const std::string& coordinates) {
  const auto numbers = numbers_in<float>(coordinates);
  ReadFace face{shape, {}, {}};
  for (const int index : numbers_in<int>(indices)) {
    if (index < 0) {
      face.normal = normal_of(face.corners);
      faces.push_back(face);
      face.corners.clear();
      continue;
    }
    const auto at = static_cast<std::size_t>(index) * 3;
    face.corners.push_back({numbers.at(at), numbers.at(at + 1), numbers.at(at + 2)});
  }
  if (!face.corners.empty()) throw std::runtime_error("a face without end");
}

}  // namespace

std::vector<std::string> attributes_in(const std::string& x3d, const std::string& element,
                                       const std::string& attribute) {
  std::vector<std::string> values;
  for (std::size_t at = 0; (at = x3d.find("<" + element + " ", at)) != std::string::npos; ++at)
    values.push_back(attribute_of(x3d.substr(at, x3d.find('>', at) - at), attribute));
  return values;
}

std::vector<ReadFace> faces_in(const std::string& x3d) {
  std::vector<ReadFace> faces;
  int depth = 0;  // of Transforms
  for (std::size_t at = 0; (at = x3d.find('<', at)) != std::string::npos; ++at) {
    if (x3d.compare(at, 11, "<Transform ") == 0 && x3d[x3d.find('>', at) - 1] != '/') ++depth;
    if (x3d.compare(at, 12, "</Transform>") == 0) --depth;
    if (x3d.compare(at, 6, "<Shape") != 0 || depth > 0) continue;
    const std::string tag = x3d.substr(at, x3d.find('>', at) - at + 1);
    if (!attribute_of(tag, "USE").empty()) throw std::runtime_error("a Shape used again in the sector's own frame");
    const std::string shape = x3d.substr(at, x3d.find("</Shape>", at) - at);
    const auto indices = attributes_in(shape, "IndexedFaceSet", "coordIndex"),
               points = attributes_in(shape, "Coordinate", "point");
    if (indices.size() != 1 || points.size() != 1) throw std::runtime_error("a Shape without one face set");
    add_faces(faces, attribute_of(tag, "DEF"), indices[0], points[0]);
  }
  return faces;
}

}  // namespace vicus::test
