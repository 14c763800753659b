#include <algorithm>
#include <cstdio>
#include <set>

#include "city_db/rules_parts.hpp"

namespace vicus::rules {
namespace {

constexpr std::size_t kNamedSectors = 4;  ///< of a fault that concerns many

std::string describe(const City& city, std::span<const EdgeUse> uses) {
  for (const auto& use : uses) {
    if (use.layer == Layer::sector) return "sector " + city.sectors[use.owner].id;
    if (use.layer == Layer::building) return "building " + city.buildings[use.owner].id;
    if (use.layer == Layer::obstacle) return std::string("obstacle ") + name_of(city.obstacles[use.owner].kind);
  }
  return "the domain";
}

/// nullptr: as it should be.
const char* find_fault(const Cover& cover) {
  if (cover.is_walkable()) {
    if (cover.sectors == 1) return nullptr;
    if (cover.sectors == 0) return "walkable ground that no sector covers";
    return cover.sectors > 1 ? "ground that sectors share" : "ground that a sector's hole takes away twice";
  }
  if (cover.sectors == 0) return nullptr;
  return cover.domain >= 1 ? "a sector's ground that a house or an obstacle covers"
                           : "a sector's ground outside of the domain";
}

struct FaceNote {
  bool is_bad = false, has_place = false;
  PlanPoint at;
  std::vector<std::uint32_t> sectors;  ///< of a bad face: those whose rings bound it from inside
  std::uint32_t owner = kNone;         ///< of a good face: the one sector
};

/// The union of the sectors that ring round a good face must be one sector, and a sector must have one face; else
/// counts could be right by rings that nest wrongly (a hole of one sector inside of another).
class FaceOwners {
 public:
  FaceOwners(const Subject& subject, Findings& findings)
      : subject_(subject), findings_(findings), face_of_(subject.city.sectors.size(), kNone) {}

  void see(std::uint32_t face, FaceNote& note, std::uint32_t sector, PlanPoint at) {
    const auto& sectors = subject_.city.sectors;
    if (note.owner == kNone) note.owner = sector;
    if (note.owner != sector)
      findings_.add(Rule::partition, sectors[sector].id, at,
                    "rings nest wrongly with sector " + sectors[note.owner].id);
    if (face_of_[sector] == kNone) face_of_[sector] = face;
    if (face_of_[sector] != face && was_split_.insert(face).second)
      findings_.add(Rule::connected, sectors[sector].id, at, "the ground of the sector falls into separate parts");
  }

  void report_empty(const std::vector<FaceNote>& notes) {
    std::vector<bool> seen(face_of_.size());
    for (std::size_t s = 0; s < face_of_.size(); ++s) seen[s] = face_of_[s] != kNone;
    for (const auto& note : notes)
      for (const auto s : note.sectors) seen[s] = true;
    for (std::size_t s = 0; s < seen.size(); ++s) {
      const auto& sector = subject_.city.sectors[s];
      const PlanPoint at = sector.ground.outer.empty() ? PlanPoint{} : sector.ground.outer.front();
      if (!seen[s]) findings_.add(Rule::connected, sector.id, at, "the sector has no ground");
    }
  }

 private:
  const Subject& subject_;
  Findings& findings_;
  std::vector<std::uint32_t> face_of_;
  std::set<std::uint32_t> was_split_;
};

std::string area_text(Int128 twice_mm2) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f mm2", static_cast<double>(twice_mm2) / 2);
  return text;
}

void report_bad_faces(const Subject& subject, const std::vector<FaceNote>& notes, Findings& findings) {
  const auto& plane = subject.plane;
  Int128 error = 0, walkable = 0;
  for (std::size_t f = 1; f < notes.size(); ++f) {
    if (plane.face_covers[f].is_walkable()) walkable += plane.face_twice_mm2[f];
    if (!notes[f].is_bad) continue;
    error += plane.face_twice_mm2[f];
    std::string message = area_text(plane.face_twice_mm2[f]) + " of " + find_fault(plane.face_covers[f]), id;
    for (std::size_t i = 0; i < std::min(notes[f].sectors.size(), kNamedSectors); ++i)
      message += (i == 0 ? ": " : ", ") + subject.city.sectors[notes[f].sectors[i]].id;
    if (!notes[f].sectors.empty()) id = subject.city.sectors[notes[f].sectors[0]].id;
    findings.add(Rule::partition, id, notes[f].at, message);
  }
  findings.report().area_error_mm2 = static_cast<double>(error) / 2;
  findings.report().walkable_mm2 = static_cast<double>(walkable) / 2;
}

}  // namespace

void report_noding(const Subject& subject, const std::vector<NodingFault>& faults, Findings& findings) {
  for (const auto& fault : faults) {
    const auto a = subject.table.uses_of(fault.edge), b = subject.table.uses_of(fault.other);
    std::string id;
    for (const auto& uses : {a, b})
      for (const auto& use : uses)
        if (use.layer == Layer::sector && id.empty()) id = subject.city.sectors[use.owner].id;
    findings.add(Rule::partition, id, fault.at,
                 "an edge of " + describe(subject.city, a) + " crosses, or has inside it an end of, an edge of " +
                     describe(subject.city, b));
  }
}

void check_partition(const Subject& subject, Findings& findings) {
  const auto& [city, table, plane, s, g, b] = subject;
  std::vector<FaceNote> notes(plane.face_covers.size());
  for (std::size_t f = 1; f < notes.size(); ++f) notes[f].is_bad = find_fault(plane.face_covers[f]) != nullptr;
  FaceOwners owners(subject, findings);
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    if (!table.has_ring(e)) continue;
    for (const bool on_left : {true, false}) {
      const std::uint32_t face = on_left ? plane.left_face[e] : plane.right_face[e];
      auto& note = notes[face];
      if (note.is_bad && !note.has_place) note.at = table.edges[e].lo, note.has_place = true;
      for (const auto& use : table.uses_of(e)) {
        if (use.layer != Layer::sector || use.forward != on_left) continue;
        if (!note.is_bad) {
          owners.see(face, note, use.owner, table.edges[e].lo);
        } else if (std::find(note.sectors.begin(), note.sectors.end(), use.owner) == note.sectors.end()) {
          note.sectors.push_back(use.owner);
        }
      }
    }
  }
  owners.report_empty(notes);
  report_bad_faces(subject, notes, findings);
  auto& report = findings.report();
  if (report.holds(Rule::partition) && report.sectors_mm2 != *report.walkable_mm2)
    findings.add(Rule::partition, "", {}, "the sectors' areas do not sum to the walkable area");
}

}  // namespace vicus::rules
