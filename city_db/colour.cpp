#include "city_db/colour.hpp"

namespace vicus {

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
