#pragma once
#include <string>

#include "cli/measure_svg_plot.hpp"

/// Small pieces of the report's page.
namespace vicus::measure {

/// From the doctype to the opening of <main>, style included.
std::string page_head(const std::string& title);
/// Number and what it counts, for a <dl>.
std::string fact(const std::string& value, const std::string& what);
std::string paragraph(const std::string& html);
std::string number_text(double value, int decimals);
/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace vicus::measure
