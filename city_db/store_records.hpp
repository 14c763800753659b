#pragma once
#include "city_db/city.hpp"
#include "city_db/store_sqlite.hpp"

/// One row of a table as one record of City and back. Columns are in the order of store_schema.cpp's tables():
/// bind_* starts at parameter 1 (after fid), read_* at column 0 (as select_sql gives them). Internal to store*.cpp.
///
/// read_* Fails   CityError: geometry, name, list or number that cannot be what we wrote.
namespace vicus {

void bind_record(Statement& row, const Sector& sector);
void bind_record(Statement& row, const Gate& gate);
void bind_record(Statement& row, const Border& border);
void bind_record(Statement& row, const Building& building);
void bind_record(Statement& row, const Facade& facade);
void bind_record(Statement& row, const Obstacle& obstacle);
void bind_record(Statement& row, const Polygon& domain);
void bind_record(Statement& row, const Street& street);
void bind_record(Statement& row, const StandaloneObject& object);
void bind_record(Statement& row, const Surface& surface);
void bind_record(Statement& row, const Ride& ride);
void bind_record(Statement& row, const Prototype& prototype);
void bind_record(Statement& row, const Viewpoint& viewpoint);
void bind_record(Statement& row, const Interior& interior);
void bind_record(Statement& row, const Door& door);
void bind_record(Statement& row, const Visible& visible);
void bind_record(Statement& row, const GateImpostor& impostor);
void bind_record(Statement& row, const Panorama& panorama);
void bind_record(Statement& row, const Terrain& terrain);
void bind_record(Statement& row, const Issue& issue);
void bind_record(Statement& row, const Artefact& artefact);

void read_record(const Statement& row, Sector& sector);
void read_record(const Statement& row, Gate& gate);
void read_record(const Statement& row, Border& border);
void read_record(const Statement& row, Building& building);
void read_record(const Statement& row, Facade& facade);
void read_record(const Statement& row, Obstacle& obstacle);
void read_record(const Statement& row, Polygon& domain);
void read_record(const Statement& row, Street& street);
void read_record(const Statement& row, StandaloneObject& object);
void read_record(const Statement& row, Surface& surface);
void read_record(const Statement& row, Ride& ride);
void read_record(const Statement& row, Prototype& prototype);
void read_record(const Statement& row, Viewpoint& viewpoint);
void read_record(const Statement& row, Interior& interior);
void read_record(const Statement& row, Door& door);
void read_record(const Statement& row, Visible& visible);
void read_record(const Statement& row, GateImpostor& impostor);
void read_record(const Statement& row, Panorama& panorama);
void read_record(const Statement& row, Terrain& terrain);
void read_record(const Statement& row, Issue& issue);
void read_record(const Statement& row, Artefact& artefact);

/// The R-tree's box of a record; empty for records without place.
PlanBox box_of_record(const Sector& sector);
PlanBox box_of_record(const Gate& gate);
PlanBox box_of_record(const Border& border);
PlanBox box_of_record(const Building& building);
PlanBox box_of_record(const Facade& facade);
PlanBox box_of_record(const Obstacle& obstacle);
PlanBox box_of_record(const Polygon& domain);
PlanBox box_of_record(const Street& street);
PlanBox box_of_record(const StandaloneObject& object);
PlanBox box_of_record(const Viewpoint& viewpoint);
PlanBox box_of_record(const Interior& interior);
PlanBox box_of_record(const Door& door);
PlanBox box_of_record(const GateImpostor& impostor);
PlanBox box_of_record(const Panorama& panorama);
PlanBox box_of_record(const Issue& issue);

}  // namespace vicus
