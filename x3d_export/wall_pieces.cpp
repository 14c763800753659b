#include "x3d_export/wall_pieces.hpp"

#include <algorithm>
#include <map>

namespace vicus {

std::vector<WallRectangle> wall_pieces(double length_m, double bottom_m, double top_m,
                                       const std::vector<Opening>& openings) {
  std::vector<double> levels{bottom_m, top_m};
  for (const Opening& o : openings) levels.insert(levels.end(), {o.z0, o.z1});
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<WallRectangle> pieces;
  std::map<std::pair<double, double>, std::size_t> growing;  // x0, x1: pieces that end at the level
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    std::vector<std::pair<double, double>> taken;
    for (const Opening& o : openings)
      if (o.z0 <= levels[i] && o.z1 >= levels[i + 1]) taken.emplace_back(o.x0, o.x1);
    std::sort(taken.begin(), taken.end());
    taken.emplace_back(length_m, length_m);
    std::map<std::pair<double, double>, std::size_t> still;
    double x = 0;
    for (const auto& [x0, x1] : taken) {
      if (x < x0) {
        const auto below = growing.find({x, x0});
        const std::size_t piece = below == growing.end() ? pieces.size() : below->second;
        if (piece == pieces.size()) pieces.push_back({x, x0, levels[i], levels[i]});
        pieces[piece].z1 = levels[i + 1];
        still.emplace(std::pair(x, x0), piece);
      }
      x = std::max(x, x1);
    }
    growing = std::move(still);
  }
  return pieces;
}

}  // namespace vicus
