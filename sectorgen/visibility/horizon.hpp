#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/roof_field.hpp"

/// What a disc of eyes surely cannot look over, direction by direction.
namespace vicus {

/// The circle is cut into bins. Along each a line is followed outwards as far as questions ask; where the field is sure
/// of a roof over the whole width of the bin and the disc, the least rise that clears it is kept with its distance.
///
/// Error   never hides what some eye of the disc sees: see over_roofs.hpp, with targets as points.
class Horizon {
 public:
  explicit Horizon(const RoofField& field) : field_(field) {}

  /// Eyes within `radius` of `centre`, no higher than eye_m. Keeps its memory from one disc to the next.
  void start(Spot centre, double radius, double eye_m, std::uint32_t bins);

  /// Everything in the disc of targets, no higher than top_m, is hidden from every eye.
  bool hides_disc(Spot centre, double radius, double top_m);
  /// The same for the points of a segment.
  bool hides_segment(Spot a, Spot b, double top_m);

 private:
  struct Step {
    float distance, rise;
  };
  struct Bin {
    std::uint32_t stamp = 0, steps = 0;
    float followed = 0;
    bool is_ended = false;
    std::array<Step, 12> step{};
  };
  double rise_of(double top_m, double nearest, double farthest) const;
  bool hides_bins(double first_angle, double last_angle, double distance, double rise);
  bool hides(std::uint32_t bin, float distance, float rise);
  void follow(std::uint32_t bin_index, Bin& bin, float distance, float rise);

  const RoofField& field_;
  Spot centre_;
  double radius_ = 0, eye_m_ = 0, half_width_ = 0;
  std::uint32_t stamp_ = 0;
  std::vector<Bin> bins_;
  std::vector<Spot> directions_;
};

}  // namespace vicus
