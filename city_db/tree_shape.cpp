#include "city_db/tree_shape.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/steady_hash.hpp"

namespace vicus {
namespace {

constexpr double kLeastScale = 0.25, kMostScale = 4;

bool contains_tag(const StandaloneObject& object, const char* key, std::initializer_list<const char*> words) {
  const auto at = object.tags.find(key);
  return at != object.tags.end() && std::any_of(words.begin(), words.end(), [&](const char* word) {
           return at->second.find(word) != std::string::npos;
         });
}

/// -0.5 ... 0.5.
double spread_of(const std::string& text) { return static_cast<double>(steady_hash(text) % 100) / 100 - 0.5; }

}  // namespace

double typical_crown_m(TreeForm form) {
  switch (form) {
    case TreeForm::round:
      return 5.2;
    case TreeForm::slim:
      return 1.9;
    case TreeForm::conifer:
      return 3.8;
  }
  return 0;
}

TreeForm form_of_tree(const StandaloneObject& tree) {
  for (const char* key : {"species", "genus", "taxon"}) {
    if (contains_tag(tree, key, {"italica", "Italica", "Cupressus", "fastigiata", "Fastigiata"})) return TreeForm::slim;
    if (contains_tag(tree, key, {"Picea", "Abies", "Larix", "Pseudotsuga", "Cedrus", "Pinus"}))
      return TreeForm::conifer;
  }
  return contains_tag(tree, "leaf_type", {"needleleaved"}) ? TreeForm::conifer : TreeForm::round;
}

std::size_t look_of_tree(const StandaloneObject& tree) { return steady_hash(tree.id) % 3; }

Colour leaf_colour(TreeForm form, std::size_t look) {
  constexpr Colour kRound[] = {{112, 152, 70}, {130, 166, 80}, {98, 138, 72}};
  if (form == TreeForm::conifer) return {78, 116, 80};
  return form == TreeForm::slim ? Colour{98, 138, 76} : kRound[look];
}

std::pair<double, double> tree_scale(const StandaloneObject& tree, double model_m) {
  const double up = tree.height_m > 0 ? std::clamp(tree.height_m / model_m, kLeastScale, kMostScale)
                                      : 1 + 0.3 * spread_of(tree.id + "h");
  return {std::sqrt(up) * (1 + 0.2 * spread_of(tree.id + "w")), up};
}

TreeShape shape_of_tree(const StandaloneObject& tree) {
  const TreeForm form = form_of_tree(tree);
  const auto [across, up] = tree_scale(tree, kTypicalTree_m);
  return {form, up * kTypicalTree_m, across * typical_crown_m(form) / 2, leaf_colour(form, look_of_tree(tree))};
}

}  // namespace vicus
