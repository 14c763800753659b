#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The request target, taken apart and decoded once. One resource has one spelling: what could be spelt in another way
/// is refused, so that no cache, log or check sees another path than the routes do.
namespace vicus {

struct Url {
  std::string path;  ///< decoded, valid UTF-8, begins with '/', no empty, "." or ".." segment, no control, no '\'
  std::vector<std::pair<std::string, std::string>> query;  ///< decoded ('+' is a space), in the order sent
};

inline constexpr std::size_t kMaxTargetBytes = 4096;  ///< longer: 414. City paths are under 200 bytes

/// Needs   nothing: the bytes are hostile.
/// Accepts origin form `/path?query` and absolute form `http://host/path?query` (RFC 9112 §3.2.2).
/// Fails   nullopt, and `reason` says in a sentence what is wrong: a bad, control or NUL escape, bytes that are not
///         UTF-8 (overlong forms included), '\' or '/' encoded, an unreserved character encoded in the path, a
///         fragment.
std::optional<Url> parse_url(std::string_view target, std::string& reason);

/// Percent-encodes everything but RFC 3986's unreserved characters.
/// parse_url("/" + encode_url_part(s)) gives the path "/" + s for every s without '/', '\' and control characters,
/// but "", "." and "..".
std::string encode_url_part(std::string_view text);

/// The only value of the parameter; nullopt and `repeated` = true when it was given twice.
std::optional<std::string> parameter_of(const Url& url, std::string_view name, bool& repeated);

/// Shortest-form UTF-8 of scalar values only (RFC 3629).
bool is_utf8(std::string_view text);

}  // namespace vicus
