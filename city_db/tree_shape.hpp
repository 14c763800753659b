#pragma once
#include <utility>

#include "city_db/city.hpp"

/// How large a tree is and what it looks like, on foot and from the air: by its tags, else typical, steady by id.
namespace vicus {

enum class TreeForm : std::uint8_t { round, slim, conifer };
inline constexpr std::size_t kTreeForms = 3;

inline constexpr double kTypicalTree_m = 8;  ///< high
double typical_crown_m(TreeForm form);       ///< across, of a tree of that height

TreeForm form_of_tree(const StandaloneObject& tree);
/// One of three looks.
std::size_t look_of_tree(const StandaloneObject& tree);
Colour leaf_colour(TreeForm form, std::size_t look);

/// Across and upwards, of a model that is `model_m` high.
std::pair<double, double> tree_scale(const StandaloneObject& tree, double model_m);

struct TreeShape {
  TreeForm form = TreeForm::round;
  double height_m = 0, crown_m = 0;  ///< crown_m: radius
  Colour leaves;
};
TreeShape shape_of_tree(const StandaloneObject& tree);

}  // namespace vicus
