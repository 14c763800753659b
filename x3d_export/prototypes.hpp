#pragma once
#include <string>

#include "x3d_export/city_index.hpp"
#include "x3d_export/mesh.hpp"

/// One model of each kind of object, made here from a few dozen faces; an author's own model stands for it where the
/// city has one. Source  paper 004 §4.1.5, §6 (street furniture from few prototypes).
namespace vicus {

/// Frame   metres in X3D axes from the object's foot; its front looks along +z (south).
struct ObjectModel {
  std::string name;  ///< DEF of its Shape: equal for equal models
  std::vector<Face> faces;
  double height_m = 1, width_m = 1;  ///< as modelled: an instance is scaled to its own
  bool is_smooth = false;
};

/// Empty faces: nothing is drawn for that kind.
ObjectModel model_of(const CityIndex& index, const StandaloneObject& object);

/// What shows where a lamp is lit: its glass, and light on the ground.
ObjectModel lamp_glow(const ObjectModel& lamp);
/// The jets of a fountain; they rise and fall.
ObjectModel fountain_jets();
ObjectModel tram();

/// How an instance of the model is scaled: across, upwards.
std::pair<double, double> scale_of(const ObjectModel& model, const StandaloneObject& object);

}  // namespace vicus
