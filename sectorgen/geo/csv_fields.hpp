#pragma once
#include <optional>
#include <string>
#include <vector>

namespace vicus {

/// Without spaces, tabs and line ends around it.
std::string trimmed(const std::string& text);

/// Fields of a line of CSV, trimmed; one with commas or quotation marks stands in quotation marks, doubled inside.
/// nullopt: a quotation mark is left open, or text follows a closed one.   Source  RFC 4180.
std::optional<std::vector<std::string>> csv_fields(const std::string& line);

}  // namespace vicus
