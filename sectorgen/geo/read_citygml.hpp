#pragma once
#include <filesystem>

#include "sectorgen/geo/raw_map.hpp"

/// CityGML 1 to 3: houses as modelled.
namespace vicus {

/// By its root element, CityModel.
bool is_citygml_file(const std::filesystem::path& path);

/// Buildings and BuildingParts of the file, each in its finest level of detail up to 3. Faulty objects become issue
/// 101. `assumed_system`: taken where the file names none. Fails   CityError: broken XML, no coordinate system, no
/// house. Source  OGC 12-019 (CityGML 2.0), chapter 10.3; OGC 20-010 (3.0). Differs geometry referred to by XLink is
/// not followed: surfaces stand where they bound their house, and a solid
///         only repeats them.
void read_citygml(const std::filesystem::path& path, const std::string& assumed_system, RawMap& map);

}  // namespace vicus
