#include "city_db/tour.hpp"

namespace vicus {

const char* name_of(TourTurn turn) {
  switch (turn) {
    case TourTurn::start:
      return "start";
    case TourTurn::straight:
      return "straight";
    case TourTurn::slight_left:
      return "slight_left";
    case TourTurn::left:
      return "left";
    case TourTurn::sharp_left:
      return "sharp_left";
    case TourTurn::slight_right:
      return "slight_right";
    case TourTurn::right:
      return "right";
    case TourTurn::sharp_right:
      return "sharp_right";
    case TourTurn::back:
      return "back";
    case TourTurn::via:
      return "via";
    case TourTurn::arrive:
      return "arrive";
  }
  return "?";
}

}  // namespace vicus
