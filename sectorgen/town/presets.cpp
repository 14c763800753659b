#include "sectorgen/town/random.hpp"
#include "sectorgen/town/town.hpp"

namespace vicus {

namespace {

struct Switch {
  const char* name;
  const char* what;
  bool TownFeatures::*on;
};

constexpr Switch kSwitches[] = {
    {"collinear_fronts", "straight streets along the axes, fronts in line across junctions",
     &TownFeatures::collinear_fronts},
    {"zero_width_alley", "houses touching without shared nodes, or one coordinate step apart",
     &TownFeatures::zero_width_alley},
    {"t_junctions", "no four-way crossroads, and a comb of side streets", &TownFeatures::t_junctions},
    {"touching_gates", "star crossroads between sharp corners", &TownFeatures::touching_gates},
    {"parallel_streets", "long streets nearly parallel to each other", &TownFeatures::parallel_streets},
    {"concave_square", "concave squares with islands of houses", &TownFeatures::concave_square},
    {"detached", "detached houses with gaps only", &TownFeatures::detached},
    {"dead_end", "streets that end in nothing", &TownFeatures::dead_end},
    {"no_streets", "not one highway", &TownFeatures::no_streets},
    {"antimeridian", "on both sides of 180 degrees", &TownFeatures::antimeridian},
    {"arctic", "at 85 degrees north", &TownFeatures::arctic},
    {"huge", "villages up to 60 km apart, joined by roads", &TownFeatures::huge},
};

/// A feature in every fourth town; those that move or empty the whole town more rarely.
TownFeatures random_features(std::uint64_t seed) {
  town::Rng rng(seed ^ 0x7065727475726265ull);
  TownFeatures features;
  for (const Switch& s : kSwitches) {
    const bool is_rare = s.on == &TownFeatures::no_streets || s.on == &TownFeatures::antimeridian ||
                         s.on == &TownFeatures::arctic || s.on == &TownFeatures::huge ||
                         s.on == &TownFeatures::detached;
    features.*s.on = rng.chance(is_rare ? 0.07 : 0.25);
  }
  return features;
}

}  // namespace

const std::vector<TownPreset>& town_presets() {
  static const std::vector<TownPreset> presets = [] {
    std::vector<TownPreset> all;
    for (const Switch& s : kSwitches) all.push_back({s.name, s.what});
    all.push_back({"random", "a mixture drawn by the seed"});
    return all;
  }();
  return presets;
}

bool apply_town_preset(const std::string& name, TownOptions& options) {
  if (name == "random") {
    options.features = random_features(options.seed);
    return true;
  }
  for (const Switch& s : kSwitches)
    if (name == s.name) return options.features.*s.on = true;
  return false;
}

TownOptions random_town_options(std::uint64_t seed) {
  town::Rng rng(seed);
  TownOptions options;
  options.seed = seed;
  options.houses = kMinHouses + static_cast<int>(rng.below(101));
  options.features = random_features(seed);
  return options;
}

std::string make_random_town(std::uint64_t seed) { return make_town_osm(random_town_options(seed)); }

}  // namespace vicus
