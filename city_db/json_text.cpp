#include "city_db/json_text.hpp"

namespace vicus {
namespace {

void append_string(std::string& out, const std::string& s) {
  constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  for (const char c : s) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (byte < 0x20) {
      out += "\\u00";
      out += {kHex[byte >> 4], kHex[byte & 15]};
    } else {
      out += c;
    }
  }
  out += '"';
}

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

void append_utf8(std::string& out, unsigned code) {
  const auto push = [&](unsigned byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    push(code);
  } else if (code < 0x800) {
    push(0xC0 | code >> 6);
    push(0x80 | (code & 63));
  } else {
    push(0xE0 | code >> 12);
    push(0x80 | (code >> 6 & 63));
    push(0x80 | (code & 63));
  }
}

/// A cursor over hostile text; after the first fault ok() stays false.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : rest_(text) {}
  bool take(char c) {
    skip_space();
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail();
  }
  std::string string() {
    std::string out;
    expect('"');
    while (ok_) {
      const char c = next();
      if (c == '"' && ok_) return out;
      if (c != '\\')
        out += c;
      else
        escape(out);
    }
    return out;
  }
  bool is_done() {
    skip_space();
    return ok_ && rest_.empty();
  }
  bool ok() const { return ok_; }

 private:
  void fail() {
    ok_ = false;
    rest_ = {};
  }
  void skip_space() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t' || rest_[0] == '\n' || rest_[0] == '\r'))
      rest_.remove_prefix(1);
  }
  char next() {
    if (rest_.empty()) {
      fail();
      return 0;
    }
    const char c = rest_[0];
    rest_.remove_prefix(1);
    return c;
  }
  void escape(std::string& out) {
    const char c = next();
    constexpr std::string_view kLetters = "bfnrt\"\\/", kBytes = "\b\f\n\r\t\"\\/";
    if (const auto i = kLetters.find(c); i != kLetters.npos) {
      out += kBytes[i];
      return;
    }
    unsigned code = 0;
    if (c != 'u') fail();
    for (int i = 0; i < 4 && ok_; ++i) {
      const int digit = hex_value(next());
      if (digit < 0) fail();
      code = code * 16 + static_cast<unsigned>(digit & 15);
    }
    // We never write surrogates; a foreign pair would need joining, so it is refused, not mangled.
    if (code >= 0xD800 && code < 0xE000) fail();
    append_utf8(out, code);
  }

  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace

std::string json_from_names(const std::vector<std::string>& names) {
  std::string out = "[";
  for (const auto& name : names) {
    if (out.size() > 1) out += ',';
    append_string(out, name);
  }
  return out + "]";
}

std::string json_from_tags(const Tags& tags) {
  std::string out = "{";
  for (const auto& [key, value] : tags) {
    if (out.size() > 1) out += ',';
    append_string(out, key);
    out += ':';
    append_string(out, value);
  }
  return out + "}";
}

std::optional<std::vector<std::string>> names_from_json(std::string_view text) {
  Cursor in(text);
  std::vector<std::string> names;
  in.expect('[');
  if (!in.take(']')) {
    do names.push_back(in.string());
    while (in.take(','));
    in.expect(']');
  }
  if (!in.is_done()) return std::nullopt;
  return names;
}

std::optional<Tags> tags_from_json(std::string_view text) {
  Cursor in(text);
  Tags tags;
  in.expect('{');
  if (!in.take('}')) {
    do {
      std::string key = in.string();
      in.expect(':');
      tags[std::move(key)] = in.string();
    } while (in.take(','));
    in.expect('}');
  }
  if (!in.is_done()) return std::nullopt;
  return tags;
}

}  // namespace vicus
