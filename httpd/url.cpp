#include "httpd/url.hpp"

#include <cstdint>

namespace vicus {
namespace {

bool is_unreserved(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
         c == '_' || c == '~';
}

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

enum class Part { path, query };

bool decode(std::string_view text, Part part, std::string& out, std::string& reason) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto c = static_cast<unsigned char>(text[i]);
    if (c == '%') {
      const int high = i + 2 < text.size() ? hex_value(text[i + 1]) : -1;
      const int low = i + 2 < text.size() ? hex_value(text[i + 2]) : -1;
      if (high < 0 || low < 0) return reason = "a '%' must be followed by two hexadecimal digits", false;
      c = static_cast<unsigned char>(high * 16 + low);
      i += 2;
      if (part == Part::path && c == '/') return reason = "'/' must not be percent-encoded in a path", false;
      if (part == Part::path && is_unreserved(c))
        return reason = std::string("'") + static_cast<char>(c) + "' must not be percent-encoded in a path", false;
    } else if (c <= 0x20 || c >= 0x7f) {
      return reason = "spaces, control characters and characters beyond ASCII must be percent-encoded", false;
    } else if (part == Part::query && c == '+') {
      c = ' ';
    } else if (c == '#') {
      return reason = "a request has no fragment ('#')", false;
    }
    if (c < 0x20 || c == 0x7f) return reason = "control characters are refused, encoded or not", false;
    if (part == Part::path && c == '\\') return reason = "'\\' is refused in a path", false;
    out += static_cast<char>(c);
  }
  if (!is_utf8(out)) return reason = "the decoded bytes are not UTF-8", false;
  return true;
}

bool has_canonical_segments(std::string_view path, std::string& reason) {
  for (std::size_t begin = 1; begin <= path.size();) {
    const auto end = std::min(path.find('/', begin), path.size());
    const auto segment = path.substr(begin, end - begin);
    if (segment == "." || segment == "..") return reason = "'.' and '..' segments are refused", false;
    if (segment.empty() && end != path.size()) return reason = "empty segments ('//') are refused", false;
    begin = end + 1;
  }
  return true;
}

bool parse_query(std::string_view text, Url& url, std::string& reason) {
  while (!text.empty()) {
    const auto end = std::min(text.find('&'), text.size());
    const auto pair = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (pair.empty()) continue;
    const auto equals = std::min(pair.find('='), pair.size());
    std::string name, value;
    if (!decode(pair.substr(0, equals), Part::query, name, reason)) return false;
    if (equals < pair.size() && !decode(pair.substr(equals + 1), Part::query, value, reason)) return false;
    url.query.emplace_back(std::move(name), std::move(value));
  }
  return true;
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80         ? 1
                               : (first >> 5) == 6  ? 2
                               : (first >> 4) == 14 ? 3
                               : (first >> 3) == 30 ? 4
                                                    : 0;
    if (length == 0 || i + length > text.size()) return false;
    std::uint32_t code = length == 1 ? first : first & (0x7fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if ((next >> 6) != 2) return false;
      code = code << 6 | (next & 0x3fu);
    }
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < kLeast[length] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return false;
    i += length;
  }
  return true;
}

std::optional<Url> parse_url(std::string_view target, std::string& reason) {
  for (std::string_view scheme : {"http://", "https://"}) {
    if (!target.starts_with(scheme)) continue;
    target.remove_prefix(scheme.size());
    const auto end = target.find_first_of("/?#");
    target = end == std::string_view::npos ? "/" : target.substr(end);
  }
  if (target.empty() || target[0] != '/') return reason = "the path must begin with '/'", std::nullopt;
  const auto question = std::min(target.find('?'), target.size());
  Url url;
  if (!decode(target.substr(0, question), Part::path, url.path, reason)) return std::nullopt;
  if (!has_canonical_segments(url.path, reason)) return std::nullopt;
  if (question < target.size() && !parse_query(target.substr(question + 1), url, reason)) return std::nullopt;
  return url;
}

std::string encode_url_part(std::string_view text) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_unreserved(byte)) {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  return out;
}

std::optional<std::string> parameter_of(const Url& url, std::string_view name, bool& repeated) {
  std::optional<std::string> found;
  repeated = false;
  for (const auto& [key, value] : url.query) {
    if (key != name) continue;
    if (found) return repeated = true, std::nullopt;
    found = value;
  }
  return found;
}

}  // namespace vicus
