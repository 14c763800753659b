#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/city.hpp"

/// Lists of names and tags as JSON text, the form in which they stand in columns: readable in QGIS and by SQL's json_*
/// functions. Strings are bytes: what is no control character stands as it is.
namespace vicus {

std::string json_from_names(const std::vector<std::string>& names);  ///< ["a","b"]
std::string json_from_tags(const Tags& tags);                        ///< {"key":"value"}

/// nullopt: anything but one array of strings, or one object of strings. decode(encode(x)) == x.
std::optional<std::vector<std::string>> names_from_json(std::string_view text);
std::optional<Tags> tags_from_json(std::string_view text);

}  // namespace vicus
