#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/measure_pose.hpp"
#include "sectorgen/bake/render/render.hpp"

/// What is measured: ways of sending a city and showing it. A new one is one class in one file, and a line in
/// forms.cpp.
namespace vicus::measure {

struct SentFile {
  std::string path;         ///< one path, one file: whoever has it does not ask again
  std::uint64_t bytes = 0;  ///< as sent, compressed
};

/// Pieces of a city that are there together, in an order of the representation's own. Equal lists show equal pictures.
using Parts = std::vector<std::string>;

struct Shown {
  std::vector<SentFile> files;
  double memory_bytes = 0;   ///< that a graphics card holds for it: memory.hpp
  double decode_cpu_ms = 0;  ///< from the bytes sent to what can be drawn
  std::shared_ptr<const Tracer> tracer;
};

struct FormName {
  std::string family;   ///< "BlockMap+ 128"
  std::string setting;  ///< "tau 4 px"; empty: there is none
  double tau_px = 0;    ///< error on screen that is asked for; 0: chosen otherwise
  std::string full() const { return setting.empty() ? family : family + ", " + setting; }
};

class Representation {
 public:
  virtual ~Representation() = default;
  virtual const FormName& name() const = 0;
  virtual bool shows(Path path) const = 0;
  /// What must be there at a pose, where `before` was there a moment ago. `pixels_per_radian`: of the picture's middle.
  virtual Parts choose(const Pose& pose, double pixels_per_radian, const Parts& before) = 0;
  /// Needs   parts as choose() gives them.
  virtual Shown show(const Parts& parts) = 0;
};

using Form = std::unique_ptr<Representation>;

}  // namespace vicus::measure
