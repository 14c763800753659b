#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// The wavefront of a roof: every edge of a plan moves inwards, the clock is its distance from the footprint's edge.
///
/// Source  weighted straight skeletons (Aichholzer et al. 1995); research/HOUSES.md §1.2. Edge i obeys
///         n_i . p = c_i + run_i * d, where d is the clock. run 0 is an upright wall: gable, party wall.
/// Differs the clock is not height but d: heights come after it (roof_mesh.hpp), so that one run serves every profile.
namespace vicus {

struct WavePoint {
  double x = 0, y = 0;
};

/// From clock `from` on, every edge's run; edges counted ring by ring. A new phase gives each moving edge a new face.
struct WavePhase {
  double from = 0;
  std::vector<double> run;
};

struct WaveInput {
  std::vector<std::vector<WavePoint>> rings;  ///< interior on the left; edge i runs from point i to the next
  std::vector<WavePhase> phases;              ///< the first from 0
  double stop = 1e300;                        ///< what is left then is level
  bool brute_force = false;                   ///< look for each next event among all pairs: O(n^3), for tests
};

struct WaveNode {
  double x = 0, y = 0, d = 0;
};

/// A directed border of a face, face on the left. Faces are numbered: Wave::face.
struct WaveSide {
  std::uint32_t face = 0, a = 0, b = 0;  ///< nodes
};

struct WaveFace {
  std::uint32_t edge = 0;
  bool is_top = false, is_upright = false;
};

/// The first nodes are the rings' points in their order.
struct Wave {
  std::vector<WaveNode> nodes;
  std::vector<WaveSide> sides;
  std::vector<WaveFace> faces;
  double most = 0;      ///< the largest d
  std::string failure;  ///< empty: done
  int events = 0;
};

/// Needs   rings of >= 3 points, consecutive ones differ; a run per edge, >= 0.
/// Error   doubles; nodes of one place may come several times, within 0.1 mm. Whether the faces are a roof is for the
///         checker to say (solid_check.hpp).
/// Fails   Wave::failure: an open wavefront (too many runs are 0), more events than there can be.
/// Cost    n r log n for r reflex corners.
Wave run_wavefront(const WaveInput& input);

}  // namespace vicus
