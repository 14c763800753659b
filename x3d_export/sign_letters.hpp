#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Letters of strokes for signs: no font, no image, crisp from any distance.
namespace vicus {

/// A straight stroke in units of a letter: 4 wide, 6 high, from its left bottom.
struct Stroke4x6 {
  int x0, y0, x1, y1;
};

/// What of the name can be written so: capitals, figures and a few marks; accents are left off (É: E). Shortened to
/// `most` letters. Empty where more than a third has no letter here (other scripts).
std::string sign_text(std::string_view name, std::size_t most);

/// Strokes of one character of sign_text's answer.
std::vector<Stroke4x6> strokes_of(char letter);

}  // namespace vicus
