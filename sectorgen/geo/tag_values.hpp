#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "city_db/city.hpp"

/// Values of OSM-like tags as numbers and answers.
namespace vicus {

/// The tag's value, or "" where it is missing.
const std::string& tag(const Tags& tags, const char* key);
bool has_tag(const Tags& tags, const char* key);
/// True where the tag is present and not "no", "false", "0" or empty.
bool is_yes(const Tags& tags, const char* key);

/// Metres: "12", "12.5 m", "12,5", "1200 cm", "40'", "40'6\"", "40 ft", "12 feet". Nothing for anything else, nor for
/// values that are not finite.
std::optional<double> parse_metres(std::string_view text);
/// A plain number: "3", "2.5", "2,5", "-1". Nothing for anything else ("2;3", "1-2", "low").
std::optional<double> parse_number(std::string_view text);

std::string lower_case(std::string_view ascii);
bool contains_word_part(std::string_view text, std::string_view part);

}  // namespace vicus
