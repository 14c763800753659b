#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/scene.hpp"

/// A sector's record: what a visitor's side must know to walk on (DESIGN §10, client_scripts/README.md).
///
/// Frame   plan-frame lattice; written as plan-frame metres, east then north, from the city's origin.
/// One function builds it; /sectors/ID.json, the MetadataSet of ID.x3d and the Anchor of ID.wrl all write it.
namespace vicus {

struct SectorNeighbour {
  std::string id;
  PlanPoint origin;
  PlanBox box;
};

/// A disc on the ground that a visitor cannot enter: what stands there.
struct Body {
  PlanPoint at;
  double radius_m = 0;
};

/// What a page tells of a place: a shop, a sight.
struct PlaceName {
  std::string kind, name;
  PlanPoint at;
};

/// A door, and the place of what it leads to: that is not loaded before it is asked for.
struct RecordDoor {
  Door door;
  SectorNeighbour to;
};

struct SectorRecord {
  Sector sector;
  PlanBox box;
  int shapes = 0;  ///< Shape nodes in the near file and its parts
  std::vector<Gate> gates;
  std::map<std::string, GateImpostor> impostors;  ///< by gate, without their pictures
  std::optional<Panorama> panorama;               ///< without its picture
  std::vector<SectorNeighbour> neighbours;        ///< every sector a gate leads to and every visible one, by id
  std::vector<std::string> visible;               ///< L_vis by id, with what none lacks: itself and its gate neighbours
  std::map<std::string, VisibleReason> reasons;   ///< of each in `visible`
  std::vector<std::string> over_roofs, unresolved;  ///< of `visible`: seen only above roofs; of these: not proven
  std::vector<RecordDoor> doors;
  std::vector<Viewpoint> viewpoints;
  std::vector<Body> bodies;       ///< of the sector's objects, in their order
  std::vector<PlaceName> places;  ///< objects that bear a name, in their order; in ID.json alone
};

SectorRecord sector_record(const RecordSource& source, const Sector& sector, int shapes);

/// The text of /sectors/ID.json.
std::string record_json(const SectorRecord& record);
/// MetadataSet DEF="RECORD".
Node record_node(const SectorRecord& record);
/// The same with no more than what leads further (id, place, neighbours, which of them are seen over roofs alone): for
/// far files, so that a visitor's sets L_2, L_3 ... grow without a request for each record.
Node links_node(const SectorRecord& record);

}  // namespace vicus
