#include "x3d_export/shared_points.hpp"

namespace vicus {
namespace {

Node* first_use(Node& node, const std::string& def) {
  if (node.use == def) return &node;
  for (NodeField& field : node.nodes)
    for (Node& child : field.nodes)
      if (Node* found = first_use(child, def)) return found;
  return nullptr;
}

}  // namespace

std::vector<double> numbers_of(const std::vector<X3dPoint>& points) {
  std::vector<double> out;
  out.reserve(3 * points.size());
  for (const X3dPoint& p : points) out.insert(out.end(), {metres(p.x), metres(p.y), metres(p.z)});
  return out;
}

Node SharedPoints::coordinate() const { return use_of(Node("Coordinate", def_)); }

void SharedPoints::put_into(Node& root) const {
  if (Node* first = first_use(root, def_)) {
    *first = Node("Coordinate", def_);
    first->set("point", numbers_of(number_of_.items()));
  }
}

}  // namespace vicus
