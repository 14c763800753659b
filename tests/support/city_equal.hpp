#pragma once
#include <string>

#include "city_db/city.hpp"

/// Equality of the records of a city, for tests only: field by field, geometry on the lattice, numbers bit by bit.
namespace vicus {

bool operator==(const LatLon& a, const LatLon& b);
bool operator==(const Polygon& a, const Polygon& b);
bool operator==(const Sector& a, const Sector& b);
bool operator==(const Gate& a, const Gate& b);
bool operator==(const Border& a, const Border& b);
bool operator==(const SideWall& a, const SideWall& b);
bool operator==(const Building& a, const Building& b);
bool operator==(const Facade& a, const Facade& b);
bool operator==(const Obstacle& a, const Obstacle& b);
bool operator==(const Street& a, const Street& b);
bool operator==(const StandaloneObject& a, const StandaloneObject& b);
bool operator==(const Surface& a, const Surface& b);
bool operator==(const RidePoint& a, const RidePoint& b);
bool operator==(const Ride& a, const Ride& b);
bool operator==(const Prototype& a, const Prototype& b);
bool operator==(const Viewpoint& a, const Viewpoint& b);
bool operator==(const Interior& a, const Interior& b);
bool operator==(const Door& a, const Door& b);
bool operator==(const Visible& a, const Visible& b);
bool operator==(const GateImpostor& a, const GateImpostor& b);
bool operator==(const Panorama& a, const Panorama& b);
bool operator==(const Terrain& a, const Terrain& b);
bool operator==(const Artefact& a, const Artefact& b);
bool operator==(const Issue& a, const Issue& b);

namespace test {

/// "" when equal, else the first list and row that differ: "gates[3]".
std::string difference(const City& a, const City& b);

}  // namespace test
}  // namespace vicus
