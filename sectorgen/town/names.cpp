#include "sectorgen/town/site.hpp"

namespace vicus::town {

namespace {
constexpr const char* kOf[] = {"Löwen", "Brücken", "Mühl",    "Gerber",  "Töpfer", "Weiden",  "Kirch",   "Kloster",
                               "Salz",  "Hafner",  "Fischer", "Schmied", "Bäcker", "Tuch",    "Rosen",   "Linden",
                               "Adler", "Hirsch",  "Glocken", "Wein",    "Korn",   "Stern",   "Schiff",  "Färber",
                               "Küfer", "Nuss",    "Krähen",  "Brunnen", "Münz",   "Wächter", "Sattler", "Kessel"};
constexpr const char* kStreet[] = {"straße", "gasse", "weg", "graben", "zeile", "steig"};
constexpr const char* kWhole[] = {
    "Žitná",         "Am Öltor",    "Dlouhá třída",     "Rue de l'Écluse",  "Unter den Eschen",
    "Ulica Świętej", "Nad Potokem", "Szűk köz",         "Hinter der Mauer", "Čapkova",
    "An der Furt",   "Střelecká",   "Großer Bleichplan"};
constexpr const char* kBefore[] = {"Alte ", "Neue ", "Obere ", "Untere ", "Hintere ", "Kleine ", "Lange ", "Krumme "};
}  // namespace

std::string Names::unused(std::string name) {
  const int times = ++used_[name];
  if (times == 1) return name;
  const int turn = (times - 2) % 8;
  std::string other = kBefore[turn] + name;
  if (times > 9) other += " " + std::to_string(times / 8 + 1);
  return other;
}

std::string Names::street(Rng& rng) {
  if (rng.chance(0.18)) return unused(kWhole[rng.below(std::size(kWhole))]);
  const std::string of = kOf[rng.below(std::size(kOf))];
  return unused(of + kStreet[rng.below(std::size(kStreet))]);
}

std::string Names::lane(Rng& rng) { return unused(std::string(kOf[rng.below(std::size(kOf))]) + "gässchen"); }

}  // namespace vicus::town
