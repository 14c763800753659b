#include "sectorgen/geo/tag_values.hpp"

#include <charconv>
#include <cmath>

namespace vicus {

namespace {

constexpr double kMetresPerFoot = 0.3048;
constexpr double kInchesPerFoot = 12;

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// The number at the text's start, which is removed; a decimal comma counts as a point.
std::optional<double> take_number(std::string_view& text) {
  std::string digits;
  std::size_t used = 0;
  for (; used < text.size(); ++used) {
    const char c = text[used];
    const bool is_sign = (c == '-' || c == '+') && used == 0;
    if (!is_sign && c != '.' && c != ',' && (c < '0' || c > '9')) break;
    if (c != '+') digits += c == ',' ? '.' : c;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  text = trimmed(text.substr(used));
  return value;
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  for (std::string_view word : words)
    if (text == word) return true;
  return false;
}

/// What follows the foot sign: nothing, or whole inches.
std::optional<double> parse_inches(std::string_view text) {
  if (text.empty()) return 0.0;
  const auto inches = take_number(text);
  if (!inches || *inches < 0 || !is_one_of(text, {"", "\"", "''", "in", "″"})) return std::nullopt;
  return inches;
}

}  // namespace

const std::string& tag(const Tags& tags, const char* key) {
  static const std::string none;
  const auto found = tags.find(key);
  return found == tags.end() ? none : found->second;
}

bool has_tag(const Tags& tags, const char* key) { return tags.find(key) != tags.end(); }

bool is_yes(const Tags& tags, const char* key) { return !is_one_of(tag(tags, key), {"", "no", "false", "0"}); }

std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> parse_metres(std::string_view text) {
  text = trimmed(text);
  const auto value = take_number(text);
  if (!value) return std::nullopt;
  if (is_one_of(text, {"", "m", "M", "metre", "metres", "meter", "meters", "mètres"})) return value;
  if (text == "cm") return *value / 100;
  if (text == "km") return *value * 1000;
  if (is_one_of(text, {"ft", "ft.", "feet", "foot"})) return *value * kMetresPerFoot;
  if (is_one_of(text, {"\"", "in", "″"})) return *value / kInchesPerFoot * kMetresPerFoot;
  for (std::string_view sign : {std::string_view("'"), std::string_view("′"), std::string_view("ft")}) {
    if (text.substr(0, sign.size()) != sign) continue;
    const auto inches = parse_inches(trimmed(text.substr(sign.size())));
    if (!inches) return std::nullopt;
    return (*value + *inches / kInchesPerFoot) * kMetresPerFoot;
  }
  return std::nullopt;
}

std::string lower_case(std::string_view ascii) {
  std::string lower(ascii);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool contains_word_part(std::string_view text, std::string_view part) {
  return lower_case(text).find(part) != std::string::npos;
}

}  // namespace vicus
