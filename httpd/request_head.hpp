#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "httpd/message.hpp"

/// The rules of RFC 9112 that a parser lets pass and request smuggling lives on: checked on the raw bytes of a head
/// before they are parsed, and on the fields after.
namespace vicus {

inline constexpr std::size_t kMaxHeadBytes = 16 * 1024;  ///< request line, fields and the empty line: more is 431

struct HeadFault {
  int status = 400;
  std::string detail;
};

/// Bytes up to and including the empty line; nullopt: it is not there yet. A bare LF ends lines too here, so that a
/// client that sends no CR gets its 400 at once and not a timeout.
std::optional<std::size_t> head_length(std::string_view bytes);

/// Bare CR or LF, NUL and other control characters, folded lines, a space before a colon, a line without a colon, a
/// request line of other than three words, a target over kMaxTargetBytes (414).
/// Needs   nothing: the bytes are hostile.
std::optional<HeadFault> fault_of_bytes(std::string_view head);

/// For a head that grew past kMaxHeadBytes without end: 414 when it is its first line that is too long, else 431.
HeadFault fault_of_endless(std::string_view bytes);

/// Not exactly one Host (an HTTP/1.0 client may send none); Transfer-Encoding other than chunked (501); both
/// Transfer-Encoding and Content-Length; several Content-Length; Expect (417).
std::optional<HeadFault> fault_of_fields(const HttpRequest& request, bool is_http_1_0);

}  // namespace vicus
