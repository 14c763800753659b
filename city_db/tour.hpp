#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "city_db/units.hpp"

/// Ways through a city and places in it by name: what sectorgen/tours finds, and others show (paper 004 §3, §5).
namespace vicus {

/// A place a visitor can stand at.
struct TourPlace {
  std::string name;  ///< "Rue Haute 12", "Chez Paul"; a sector without a name: its id
  std::string
      kind;  ///< street, square, house, sector, place (a point of the map), or an object's kind: shop, cafe, ...
  std::string detail;  ///< the street it stands in, or empty
  std::string sector_id;
  PlanPoint at;         ///< on the ground one walks on
  PlanPoint look;       ///< what it is about: look this way from `at`; equal to `at` where any way is good
  double ground_m = 0;  ///< above the plan frame's 0
  LatLon degrees;       ///< of `at`
};

/// A point of the way: straight from one to the next.
struct TourPoint {
  PlanPoint at;
  double ground_m = 0;
  double walked_m = 0;  ///< along the way, in plan
};

struct TourSector {
  std::string id, name;
  double walked_m = 0;  ///< where it is entered
};

enum class TourTurn {
  start,
  straight,
  slight_left,
  left,
  sharp_left,
  slight_right,
  right,
  sharp_right,
  back,
  via,
  arrive
};

/// One line of what a guide would say.
struct TourStep {
  TourTurn turn = TourTurn::straight;
  std::string text;    ///< "Turn left into Rue Basse."
  std::string street;  ///< from here on; empty: it has no name
  double walked_m = 0;
  double length_m = 0;  ///< to the next step
};

struct TourViewpoint {
  std::string id, sector_id, name;
  PlanPoint at;
  double ground_m = 0, eye_m = 0, heading_deg = 0;
  double walked_m = 0;  ///< where the way passes it nearest
};

struct Tour {
  std::string name;
  std::vector<TourPlace> stops;  ///< from, via ..., to; of a round trip the last is the first again
  std::vector<TourPoint> points;
  std::vector<TourSector> sectors;  ///< in order; gates join each to the next
  std::vector<TourStep> steps;
  std::vector<TourViewpoint> viewpoints;  ///< near the way, in its order
  double length_m = 0;
  double duration_s = 0;  ///< at walking speed, turns included
};

struct TourQuery {
  std::string tour;                   ///< id of a TourProposal; then nothing else is given
  std::string from, to;               ///< sector id, a street's or house's name, or LAT,LON
  std::vector<std::string> via = {};  ///< in order
  bool is_round = false;              ///< back to `from` at the end
};

struct TourProblem {
  enum class Kind { nonsense, unknown_place, not_connected };
  Kind kind = Kind::nonsense;
  std::string detail;  ///< a sentence that says what to do
};

using TourAnswer = std::variant<Tour, TourProblem>;

/// A walk past sights of the city, made for who knows no names.
struct TourProposal {
  std::string id, name;
  std::vector<TourPlace> stops;  ///< the last is the first again
  double length_m = 0, duration_s = 0;
};

/// Names as in JSON.
const char* name_of(TourTurn);

inline constexpr double kWalkingSpeed_m_s = 1.4;
inline constexpr double kTourEye_m = 1.7;

}  // namespace vicus
