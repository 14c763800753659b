#include "httpd/etag.hpp"

namespace vicus {
namespace {

bool is_etag_char(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte == 0x21 || (byte >= 0x23 && byte != 0x7f);
}

std::size_t skip_space(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
  return at;
}

}  // namespace

std::string etag_of(std::string_view hash, std::string_view coding) {
  std::string tag = "\"";
  for (const char c : hash)
    if (is_etag_char(c) && static_cast<unsigned char>(c) < 0x80) tag += c;
  return tag.append("-").append(coding).append("\"");
}

bool names_etag(const std::optional<std::string>& if_none_match, std::string_view etag) {
  if (!if_none_match) return false;
  const std::string_view text = *if_none_match;
  std::size_t at = skip_space(text, 0);
  if (at < text.size() && text[at] == '*') return skip_space(text, at + 1) == text.size();
  bool found = false;
  while (at < text.size()) {
    if (text[at] == ',') {
      at = skip_space(text, at + 1);
      continue;
    }
    if (text.substr(at).starts_with("W/")) at += 2;
    if (at >= text.size() || text[at] != '"') return false;
    auto end = at + 1;
    while (end < text.size() && is_etag_char(text[end])) ++end;
    if (end >= text.size() || text[end] != '"') return false;
    found |= text.substr(at, end + 1 - at) == etag;
    at = skip_space(text, end + 1);
    if (at < text.size() && text[at] != ',') return false;
  }
  return found;
}

}  // namespace vicus
