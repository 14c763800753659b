#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Numbers and strings as files hold them.
namespace vicus {

/// Appends `value` rounded to `decimals` places, without trailing zeros, exponent or "-0".
/// Error   half a unit of the last decimal: every lattice value (whole millimetres) comes out exact with 3 decimals.
/// Needs   0 <= decimals <= 6, |value| < 10^12 (assert).
void append_number(std::string& out, double value, int decimals);

/// Appends a list, `width` numbers to a value; lines are broken between values so that people and diffs can read them.
void append_numbers(std::string& out, const std::vector<double>& values, int decimals, int width, char between = ' ');
/// Index lists: a line may break after each -1, or anywhere in a list without one.
void append_indices(std::string& out, const std::vector<std::int32_t>& values, char between = ' ');

/// Valid UTF-8 without control characters: bytes that are no UTF-8, surrogates and non-characters become U+FFFD,
/// control characters become a space. clean_text(clean_text(s)) == clean_text(s).
std::string clean_text(std::string_view text);

/// Between the apostrophes of an XML attribute (quotation marks stay as they are), or as element text. Cleans.
std::string xml_escaped(std::string_view text);
/// "text" with quotes, as VRML97 and the strings inside an X3D MFString write it. Cleans.
std::string vrml_quoted(std::string_view text);

/// A name as a caption (WorldInfo title, Viewpoint description): quotation marks at its ends become typographic ones,
/// because readers of X3D take an SFString between straight ones for a mistake and strip them.
std::string caption_of(std::string_view name);

}  // namespace vicus
