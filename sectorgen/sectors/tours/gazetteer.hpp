#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "city_db/tour.hpp"

/// Places by name: typed as people type, ranked.
namespace vicus {

struct NamedPlace {
  TourPlace place;
  double weight = 0;      ///< among equally good names the heavier first; 0 ... 1
  bool is_sight = false;  ///< worth a walk
};

struct FoundPlace {
  std::uint32_t index = 0;  ///< of the list given
  double score = 0;         ///< 0 ... about 1
  bool is_whole = false;    ///< every word that was typed is in its name, or where it stands
};

class Gazetteer {
 public:
  explicit Gazetteer(const std::vector<NamedPlace>& places);

  /// Best first, equal ones in the list's order; at most `limit`. Words may be typed in any order; one in three may be
  /// unknown when no place has them all.
  /// Needs   nothing: the text may be anything; kMostTyped bytes of it count.
  /// Cost    different words in all names x words typed; Berlin's 30,000 places: see docs/tours.md.
  std::vector<FoundPlace> find(std::string_view typed, std::size_t limit) const;

  static constexpr std::size_t kMostTyped = 120, kMostWords = 8;

 private:
  struct Mention {
    std::uint32_t place = 0;
    float share = 1;  ///< a word of the name counts whole, one of where it stands half
  };
  std::vector<std::string> words_;
  std::vector<std::vector<Mention>> mentions_;  // per word
  std::vector<float> letters_, weight_;         // per place: letters in its name
};

}  // namespace vicus
