#include "city_db/colour.hpp"

#include <cmath>

namespace vicus {

double linear_of_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double srgb_of_linear(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

std::string hex_of(Colour c) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "#";
  for (const unsigned v : {c.r, c.g, c.b}) {
    out += kDigits[v >> 4];
    out += kDigits[v & 15u];
  }
  return out;
}

std::optional<Colour> colour_from_hex(std::string_view text) {
  if (text.empty() || text[0] != '#') return std::nullopt;
  std::string digits(text.substr(1));
  if (digits.size() == 3) digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  if (digits.size() != 6 || digits.find_first_not_of("0123456789abcdef") != std::string::npos) return std::nullopt;
  return colour_of(static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16)));
}

}  // namespace vicus
