#pragma once
#include <memory>

#include "sectorgen/bake/picture/picture.hpp"

/// How different two pictures look to a person who switches between them.
namespace vicus {

/// Pixels a degree of sight: 0.7 m before a screen 0.7 m wide with 3840 pixels, as the paper has it.
inline constexpr double kPixelsPerDegree = 67.0206;

/// The error of each pixel, 0 (equal) ... 1. Symmetric but for rounding.
/// Needs   equal sizes (assert).
/// Source  Andersson et al., FLIP: A Difference Evaluator for Alternating Images, HPG 2020, for pictures of low dynamic
///         range. Filters as separable sums, borders repeated.
PixelGrid<float> flip_map(const Picture& reference, const Picture& test, double pixels_per_degree = kPixelsPerDegree);

/// A picture that many others are held against: what the eye sees of it is worked out once.
class FlipReference {
 public:
  explicit FlipReference(const Picture& reference, double pixels_per_degree = kPixelsPerDegree);
  /// As flip_map.   Needs   equal sizes (assert).
  PixelGrid<float> map(const Picture& test) const;

 private:
  struct Seen;
  std::shared_ptr<const Seen> seen_;
  double pixels_per_degree_;
};

/// Mean of flip_map.
double flip_mean(const Picture& reference, const Picture& test, double pixels_per_degree = kPixelsPerDegree);

/// Mean and the value that 99 % of the pixels stay below, of any map of errors; 0, 0 of no pixel.
struct ErrorSummary {
  double mean = 0, p99 = 0, max = 0;
};
ErrorSummary summary_of(std::vector<float> errors);

}  // namespace vicus
