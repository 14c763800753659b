#pragma once
#include <array>
#include <map>
#include <set>
#include <string>

#include "city_db/city.hpp"
#include "x3d_export/svg_paper.hpp"

/// What the map of one sector's L_vis shows in which colour.
namespace vicus {

class LvisLooks {
 public:
  /// Needs   a sector of that id. What no list lacks is there, too: itself and its gate neighbours.
  LvisLooks(const City& city, const std::string& sector_id);

  /// Of a sector's ground: by why it is listed; pale where it is not.
  const char* ground_colour(const std::string& sector_id) const;
  /// Of a house seen over roofs; null: not one.
  const char* house_colour(const std::string& building_id) const;
  bool lists(const std::string& sector_id) const { return look_of_.contains(sector_id); }
  void draw_legend(SvgPaper& paper) const;
  /// "L_vis of s-yard (Löwenhof)"; how many for each reason stands in the legend.
  std::string title() const;

 private:
  std::string title_;
  std::map<std::string, int> look_of_;  ///< by sector
  std::array<int, 6> counts_{};         ///< by look
  std::set<std::string> houses_, unresolved_houses_;
};

}  // namespace vicus
