#include <algorithm>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/naming.hpp"

namespace vicus {
namespace {

constexpr std::int32_t kCoarsestMm = 16'384;  // the grid an id's position is on; halved until ids differ

/// Lower-case ASCII of a name: accents dropped, everything else between words a hyphen.
std::string slug(const std::string& name) {
  // Latin-1 and Latin Extended-A letters by their second byte; the first is C3, C4 or C5.
  static const char* kC3 = "aaaaaaaceeeeiiiidnooooo-ouuuuytsaaaaaaaceeeeiiiidnooooo-ouuuuyty";
  static const char* kC4 = "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllll";
  static const char* kC5 = "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
  std::string out;
  for (std::size_t i = 0; i < name.size() && out.size() < 40; ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const auto next = i + 1 < name.size() ? static_cast<unsigned char>(name[i + 1]) : 0u;
    char letter = '-';
    if (c < 0x80) {
      if (std::isalnum(c)) letter = static_cast<char>(std::tolower(c));
    } else if (c >= 0xC3 && c <= 0xC5 && next >= 0x80 && next < 0xC0) {
      letter = (c == 0xC3 ? kC3 : c == 0xC4 ? kC4 : kC5)[next - 0x80];
      ++i;
    } else {
      continue;
    }
    if (letter != '-' || (!out.empty() && out.back() != '-')) out += letter;
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out;
}

/// Position on a grid as a short word: coordinates folded to non-negative, bits interleaved, base 32.
std::string place_code(PlanPoint p, std::int32_t cell) {
  const auto fold = [&](std::int32_t v) {
    const std::int64_t q = v >= 0 ? v / cell : -((std::int64_t{-1} - v) / cell) - 1;
    return static_cast<std::uint64_t>(q >= 0 ? 2 * q : -2 * q - 1);
  };
  const std::uint64_t x = fold(p.x), y = fold(p.y);
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < 31; ++i) bits |= (x >> i & 1) << (2 * i) | (y >> i & 1) << (2 * i + 1);
  std::string out;
  for (; bits != 0 || out.empty(); bits /= 32) out += "0123456789abcdefghjkmnpqrstvwxyz"[bits % 32];
  std::reverse(out.begin(), out.end());
  return out;
}

/// Area of a's triangles whose centre lies in b: their common ground, good enough to tell who is whose successor.
double common_m2(const Sector& a, const Sector& b) {
  std::vector<PlanPoint> points = a.ground.outer;
  for (const auto& hole : a.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  double sum = 0;
  for (std::size_t i = 0; i + 2 < a.ground_triangles.size(); i += 3) {
    const PlanPoint p = points[a.ground_triangles[i]], q = points[a.ground_triangles[i + 1]],
                    r = points[a.ground_triangles[i + 2]];
    const PlanPoint centre{static_cast<std::int32_t>((std::int64_t{p.x} + q.x + r.x) / 3),
                           static_cast<std::int32_t>((std::int64_t{p.y} + q.y + r.y) / 3)};
    if (locate(b.ground, centre) != Side::outside) sum += static_cast<double>(orient(p, q, r)) / 2e6;
  }
  return sum;
}

/// For each new sector the old one it continues, if both agree.
std::vector<const Sector*> successors(const City* previous, const City& city) {
  std::vector<const Sector*> out(city.sectors.size(), nullptr);
  if (previous == nullptr) return out;
  std::vector<PlanBox> boxes;
  for (const auto& s : previous->sectors) boxes.push_back(box_of(s.ground));
  const BoxIndex index(boxes);
  std::vector<std::pair<double, std::uint32_t>> best_of_old(previous->sectors.size(), {0, kNone});
  std::vector<std::pair<double, std::uint32_t>> best_of_new(city.sectors.size(), {0, kNone});
  for (std::uint32_t i = 0; i < city.sectors.size(); ++i)
    for (std::uint32_t j : index.meeting(box_of(city.sectors[i].ground))) {
      const Sector &now = city.sectors[i], &was = previous->sectors[j];
      const double common = now.ground.outer == was.ground.outer ? area_m2(now.ground)
                                                                 : std::max(common_m2(now, was), common_m2(was, now));
      if (common > best_of_new[i].first) best_of_new[i] = {common, j};
      if (common > best_of_old[j].first) best_of_old[j] = {common, i};
    }
  for (std::uint32_t i = 0; i < city.sectors.size(); ++i) {
    const auto [common, j] = best_of_new[i];
    if (j == kNone || best_of_old[j].second != i) continue;
    if (2 * common > area_m2(city.sectors[i].ground) && 2 * common > area_m2(previous->sectors[j].ground))
      out[i] = &previous->sectors[j];
  }
  return out;
}

std::vector<std::string> sector_ids(const City* previous, const City& city) {
  const auto old = successors(previous, city);
  std::vector<std::string> ids(city.sectors.size());
  std::set<std::string> taken;  // also by sectors that are no more: their ids are not used again
  if (previous != nullptr)
    for (const auto& s : previous->sectors) taken.insert(s.id);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < ids.size(); ++i) {
    if (old[i] != nullptr)
      ids[i] = old[i]->id;
    else
      open.push_back(i);
  }
  for (std::int32_t cell = kCoarsestMm; !open.empty(); cell /= 2) {
    std::map<std::string, std::vector<std::uint32_t>> wish;
    for (std::uint32_t i : open) {
      const Sector& s = city.sectors[i];
      const std::string word = slug(s.name);
      wish[(word.empty() ? name_of(s.kind) : word) + "-" + place_code(s.origin, cell)].push_back(i);
    }
    open.clear();
    for (const auto& [id, who] : wish) {
      // At 1 mm two sectors with one centre and one name: tell them apart by order of their ground.
      if (who.size() == 1 && taken.count(id) == 0) {
        ids[who.front()] = id;
        taken.insert(id);
      } else if (cell == 1) {
        for (std::uint32_t i : who) {
          std::string other = id;
          while (taken.count(other) != 0) other += 'x';
          ids[i] = other;
          taken.insert(other);
        }
      } else {
        open.insert(open.end(), who.begin(), who.end());
      }
    }
  }
  return ids;
}

void number_gates(City& city) {
  const auto key = [](const Gate& g) { return std::tie(g.sector_id, g.to_sector_id, g.line); };
  std::sort(city.gates.begin(), city.gates.end(), [&](const Gate& a, const Gate& b) { return key(a) < key(b); });
  int n = 0;
  for (std::size_t i = 0; i < city.gates.size(); ++i) {
    Gate& g = city.gates[i];
    const bool same =
        i > 0 && city.gates[i - 1].sector_id == g.sector_id && city.gates[i - 1].to_sector_id == g.to_sector_id;
    n = same ? n + 1 : 1;
    g.id =
        g.sector_id + "." + (g.to_sector_id.empty() ? "out" : g.to_sector_id) + (n > 1 ? "." + std::to_string(n) : "");
  }
  std::map<std::vector<PlanPoint>, std::vector<std::size_t>> by_line;
  for (std::size_t i = 0; i < city.gates.size(); ++i) by_line[city.gates[i].line].push_back(i);
  for (auto& g : city.gates) {
    if (g.to_sector_id.empty()) continue;
    const std::vector<PlanPoint> reversed(g.line.rbegin(), g.line.rend());
    const auto it = by_line.find(reversed);
    if (it == by_line.end()) continue;
    for (std::size_t i : it->second)
      if (city.gates[i].to_sector_id == g.sector_id && city.gates[i].sector_id == g.to_sector_id)
        g.twin_id = city.gates[i].id;
  }
  std::sort(city.gates.begin(), city.gates.end(), [](const Gate& a, const Gate& b) { return a.id < b.id; });
}

}  // namespace

void identify(const City* previous, City& city) {
  const std::vector<std::string> ids = sector_ids(previous, city);
  const auto rename = [&](std::string& id) {
    if (!id.empty()) id = ids[std::stoul(id)];
  };
  for (auto& s : city.sectors) rename(s.id);
  for (auto& g : city.gates) rename(g.sector_id), rename(g.to_sector_id);
  for (auto& b : city.borders) rename(b.sector_id);
  for (auto& b : city.buildings) rename(b.sector_id);
  for (auto& o : city.objects) rename(o.sector_id);
  for (auto& v : city.viewpoints) {
    rename(v.sector_id);
    v.id = v.sector_id + "." + v.kind;
  }
  number_gates(city);
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(city.sectors.begin(), city.sectors.end(), by_id);
  std::sort(city.viewpoints.begin(), city.viewpoints.end(), by_id);
  std::sort(city.objects.begin(), city.objects.end(), by_id);
  std::stable_sort(city.borders.begin(), city.borders.end(), [](const Border& a, const Border& b) {
    return std::tie(a.sector_id, a.line) < std::tie(b.sector_id, b.line);
  });
}

}  // namespace vicus
