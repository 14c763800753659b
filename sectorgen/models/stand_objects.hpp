#pragma once
#include <optional>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// What the map says stands in the street, made ready to be drawn.
namespace vicus {

/// Turns benches and the like away from the nearest wall; hangs a sign over the front of each shop, cafe, museum that
/// has a name; makes the ways of trams (City::rides) from rails that meet end to end.
/// Needs   facades laid out; sectors and objects with their final ids.
/// Raises  103 unknown_attribute_value for web addresses that are none.
void stand_objects(const SourceMap& map, City& city);

/// An http or https address with a host, as given or with https:// before it; nothing for anything else. What would
/// end a quoted string or hold control characters is no address.
std::optional<std::string> web_address(const std::string& text);

/// Of a tram, and its pause before it comes again.
inline constexpr double kTram_m_per_s = 6, kTramPause_s = 20;

}  // namespace vicus
