#pragma once
#include <filesystem>

#include "sectorgen/geo/raw_map.hpp"

/// CityGML 1 to 3: houses as modelled.
namespace vicus {

/// By its root element, CityModel.
bool is_citygml_file(const std::filesystem::path& path);

/// Buildings and BuildingParts of the file, each in its finest level of detail up to 3, with windows, doors, colours of
/// materials, and images that lie beside the file. Links within the file are followed: a surface stands wherever it is
/// referred to, and means what it means there. Faulty objects, and links to nowhere, become issue 101.
/// `assumed_system`: taken where the file names none.
/// Fails   CityError: broken XML, no coordinate system, no house.
/// Source  OGC 12-019 (CityGML 2.0), chapters 9 and 10.3; OGC 20-010 (3.0).
void read_citygml(const std::filesystem::path& path, const std::string& assumed_system, RawMap& map);

}  // namespace vicus
