#include "x3d_export/text.hpp"

#include <cassert>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace vicus {
namespace {

constexpr std::size_t kLineLength = 120;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

struct Decoded {
  char32_t code = 0;
  std::size_t length = 0;  ///< 0: no UTF-8 here
};

Decoded decode(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || s.size() < length) return {};
  char32_t code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kSmallest[length] || code > 0x10FFFF) return {};
  return {code, length};
}

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }
bool is_no_character(char32_t c) {
  return (c >= 0xD800 && c < 0xE000) || (c >= 0xFDD0 && c <= 0xFDEF) || (c & 0xFFFE) == 0xFFFE;
}

/// A separator: a line break once the line is long enough, else `between` (and a space after a comma is not needed).
void append_break(std::string& out, std::size_t& line_start, char between) {
  if (between == ',') out += ',';
  if (out.size() - line_start > kLineLength) {
    out += '\n';
    line_start = out.size();
  } else if (between != ',') {
    out += between;
  }
}

/// Before and after the decimal point. Each case divides by a constant, which is a multiplication.
std::pair<std::uint64_t, std::uint32_t> parted(std::uint64_t scaled, int decimals) {
  const auto by = [&](auto power) { return std::pair{scaled / power, static_cast<std::uint32_t>(scaled % power)}; };
  switch (decimals) {
    case 0:
      return {scaled, 0};
    case 1:
      return by(std::integral_constant<std::uint64_t, 10>());
    case 2:
      return by(std::integral_constant<std::uint64_t, 100>());
    case 3:
      return by(std::integral_constant<std::uint64_t, 1000>());
    case 4:
      return by(std::integral_constant<std::uint64_t, 10'000>());
    case 5:
      return by(std::integral_constant<std::uint64_t, 100'000>());
    default:
      return by(std::integral_constant<std::uint64_t, 1'000'000>());
  }
}

}  // namespace

void append_number(std::string& out, double value, int decimals) {
  constexpr std::int64_t kPower[] = {1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
  assert(decimals >= 0 && decimals <= 6 && std::abs(value) < 1e12);
  const double shifted = value * static_cast<double>(kPower[decimals]);
  const auto scaled = static_cast<std::int64_t>(std::abs(shifted) + 0.5);
  if (shifted < 0 && scaled != 0) out += '-';
  const auto [whole, part] = parted(static_cast<std::uint64_t>(scaled), decimals);
  char buffer[32];
  char* end = std::to_chars(buffer, buffer + 24, whole).ptr;
  if (part != 0) {
    std::uint32_t rest = part;
    for (char* digit = end + decimals; digit > end; --digit, rest /= 10) *digit = static_cast<char>('0' + rest % 10);
    *end = '.';
    end += decimals + 1;
    while (end[-1] == '0') --end;
  }
  out.append(buffer, end);
}

void append_numbers(std::string& out, const std::vector<double>& values, int decimals, int width, char between) {
  std::size_t line_start = out.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i != 0) {
      if (i % static_cast<std::size_t>(width) == 0)
        append_break(out, line_start, between);
      else
        out += between;
    }
    append_number(out, values[i], decimals);
  }
}

void append_indices(std::string& out, const std::vector<std::int32_t>& values, char between) {
  std::size_t line_start = out.size();
  char buffer[16];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i != 0) append_break(out, line_start, between);
    out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, values[i]).ptr);
  }
}

std::string clean_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Decoded d = decode(text);
    if (d.length == 0 || is_no_character(d.code))
      out += kReplacement;
    else if (is_control(d.code))
      out += ' ';
    else
      out += text.substr(0, d.length);
    text.remove_prefix(d.length == 0 ? 1 : d.length);
  }
  return out;
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : clean_text(text)) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '\'':
        out += "&apos;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string vrml_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : clean_text(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string caption_of(std::string_view name) {
  std::string caption = clean_text(name);
  if (caption.ends_with('"')) caption.replace(caption.size() - 1, 1, "\xE2\x80\x9D");  // U+201D
  if (caption.starts_with('"')) caption.replace(0, 1, "\xE2\x80\x9C");                 // U+201C
  return caption;
}

}  // namespace vicus
