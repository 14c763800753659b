#include "sectorgen/visibility/propose.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/visibility/betweenness.hpp"

namespace vicus {
namespace {

constexpr std::size_t kSampledSources = 1000;  // above kMostExactSectors; the greatest are found by far fewer
constexpr double kVicinities_m[] = {500, 300, 200};
constexpr double kTowerHeight_m = 30;  // what stands out of an old town
constexpr double kTowerFullHeight_m = 60;
constexpr double kHighHouseScore = 0.8;  // a name beats a height

using SectorIndex = std::unordered_map<std::string, std::uint32_t>;
using Scores = std::vector<double>;

void add_squares(const City& city, Scores& scores) {
  double largest_m2 = 0;
  for (const auto& s : city.sectors)
    if (s.kind == SectorKind::square) largest_m2 = std::max(largest_m2, area_m2(s.ground));
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (city.sectors[i].kind == SectorKind::square && largest_m2 > 0)
      scores[i] += std::sqrt(area_m2(city.sectors[i].ground) / largest_m2);
}

bool is_one_of(const Tags& tags, const char* key, std::initializer_list<const char*> values) {
  const auto at = tags.find(key);
  return at != tags.end() && std::any_of(values.begin(), values.end(), [&](const char* v) { return at->second == v; });
}

double landmark_score(const Building& b) {
  if (is_one_of(b.tags, "building",
                {"cathedral", "church", "chapel", "mosque", "synagogue", "temple", "tower", "castle", "palace"}) ||
      is_one_of(b.tags, "amenity", {"place_of_worship", "theatre", "townhall"}) ||
      is_one_of(b.tags, "man_made", {"tower"}) || b.tags.contains("historic"))
    return 1;
  return kHighHouseScore * std::clamp((b.height_m - kTowerHeight_m) / (kTowerFullHeight_m - kTowerHeight_m), 0.0, 1.0);
}

double landmark_score(const StandaloneObject& o) {
  for (const char* kind : {"church", "monument", "tower"})
    if (o.kind == kind) return 1;
  return 0;
}

/// A house counts once, where it shows its longest facade.
void add_landmarks(const City& city, const SectorIndex& index, Scores& scores) {
  std::unordered_map<std::string, double> score_of;
  for (const auto& b : city.buildings)
    if (const double score = landmark_score(b); score > 0) score_of[b.id] = score;
  std::map<std::pair<std::string, std::string>, std::int64_t> facade_mm;  // by house, sector
  for (const auto& border : city.borders)
    if (score_of.contains(border.building_id))
      for (std::size_t i = 1; i < border.line.size(); ++i)
        facade_mm[{border.building_id, border.sector_id}] += length_mm(border.line[i - 1], border.line[i]);
  Scores best(scores.size(), 0.0);
  const auto add = [&](const std::string& sector_id, double score) {
    if (const auto at = index.find(sector_id); at != index.end()) best[at->second] = std::max(best[at->second], score);
  };
  for (auto at = facade_mm.begin(); at != facade_mm.end();) {
    auto longest = at;
    const auto house = at->first.first;
    for (; at != facade_mm.end() && at->first.first == house; ++at)
      if (at->second > longest->second) longest = at;
    add(longest->first.second, score_of.at(house));
  }
  for (const auto& o : city.objects) add(o.sector_id, landmark_score(o));
  for (std::size_t i = 0; i < scores.size(); ++i) scores[i] += best[i];
}

void add_betweenness(const City& city, const SectorIndex& index, Scores& scores) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& g : city.gates) {
    const auto a = index.find(g.sector_id), b = index.find(g.to_sector_id);
    if (a != index.end() && b != index.end() && a->second != b->second) edges.insert(std::minmax(a->second, b->second));
  }
  const std::size_t sources = city.sectors.size() <= kMostExactSectors ? kMostExactSectors : kSampledSources;
  const auto sums = betweenness({city.sectors.size(), {edges.begin(), edges.end()}}, sources);
  const double most = sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (most > 0) scores[i] += sums[i] / most;
}

}  // namespace

void propose_important(City& city) {
  SectorIndex index;
  for (std::uint32_t i = 0; i < city.sectors.size(); ++i) index.emplace(city.sectors[i].id, i);
  Scores scores(city.sectors.size(), 0.0);
  add_squares(city, scores);
  add_landmarks(city, index, scores);
  add_betweenness(city, index, scores);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < scores.size(); ++i)
    if (city.sectors[i].importance == Importance::none && scores[i] > 0) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return scores[a] != scores[b] ? scores[a] > scores[b] : city.sectors[a].id < city.sectors[b].id;
  });
  const auto most = static_cast<std::size_t>(kProposedShare * static_cast<double>(scores.size()));
  if (order.size() > std::max<std::size_t>(1, most)) order.resize(std::max<std::size_t>(1, most));
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    Sector& sector = city.sectors[order[rank]];
    sector.importance = Importance::proposed;
    sector.vicinity_m = kVicinities_m[rank * std::size(kVicinities_m) / order.size()];
  }
}

}  // namespace vicus
