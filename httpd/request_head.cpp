#include "httpd/request_head.hpp"

#include <algorithm>

#include "httpd/url.hpp"

namespace vicus {
namespace {

HeadFault too_long_target() {
  return {414, "The address is longer than " + std::to_string(kMaxTargetBytes) + " bytes. Shorten it."};
}

std::optional<HeadFault> fault_of_request_line(std::string_view line) {
  const auto first = line.find(' ');
  const auto last = line.rfind(' ');
  if (first == std::string_view::npos || first == last ||
      line.substr(first + 1, last - first - 1).find(' ') != line.npos)
    return HeadFault{400, "The request line must be METHOD, address and HTTP version with one space between them."};
  if (last - first - 1 > kMaxTargetBytes) return too_long_target();
  return std::nullopt;
}

std::optional<HeadFault> fault_of_field_line(std::string_view line) {
  if (line.front() == ' ' || line.front() == '\t')
    return HeadFault{400, "Folded header lines are obsolete and refused: put the value on one line."};
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0)
    return HeadFault{400, "Each header line must be a name, ':' and a value."};
  if (line[colon - 1] == ' ' || line[colon - 1] == '\t')
    return HeadFault{400, "There must be no space between a header's name and its ':'."};
  return std::nullopt;
}

std::size_t count_of(const HttpFields& fields, std::string_view name) {
  return static_cast<std::size_t>(std::count_if(
      fields.begin(), fields.end(), [&](const auto& field) { return equal_ignoring_case(field.first, name); }));
}

}  // namespace

std::optional<std::size_t> head_length(std::string_view bytes) {
  for (std::size_t at = bytes.find('\n'); at != bytes.npos; at = bytes.find('\n', at + 1)) {
    if (at + 1 < bytes.size() && bytes[at + 1] == '\n') return at + 2;
    if (at + 2 < bytes.size() && bytes[at + 1] == '\r' && bytes[at + 2] == '\n') return at + 3;
  }
  return std::nullopt;
}

std::optional<HeadFault> fault_of_bytes(std::string_view head) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    const auto byte = static_cast<unsigned char>(head[i]);
    if (byte == '\n' && (i == 0 || head[i - 1] != '\r'))
      return HeadFault{400, "Lines must end with CR LF, not with LF alone."};
    if (byte == '\r' && (i + 1 == head.size() || head[i + 1] != '\n'))
      return HeadFault{400, "A CR must be followed by a LF."};
    if ((byte < 0x20 && byte != '\r' && byte != '\n' && byte != '\t') || byte == 0x7f)
      return HeadFault{400, "Control characters are refused in a request's head."};
  }
  bool is_first = true;
  for (std::size_t begin = 0; begin < head.size();) {
    const auto end = std::min(head.find("\r\n", begin), head.size());
    const auto line = head.substr(begin, end - begin);
    begin = end + 2;
    if (line.empty()) break;
    if (auto fault = is_first ? fault_of_request_line(line) : fault_of_field_line(line)) return fault;
    is_first = false;
  }
  if (is_first) return HeadFault{400, "The request is empty."};
  return std::nullopt;
}

HeadFault fault_of_endless(std::string_view bytes) {
  constexpr std::size_t kLongestLine = kMaxTargetBytes + 64;  // a method, two spaces, HTTP/1.1
  if (bytes.substr(0, kLongestLine).find('\n') == bytes.npos) return too_long_target();
  return {431, "The request's head is longer than " + std::to_string(kMaxHeadBytes) +
                   " bytes. Send fewer or shorter header lines (cookies are not needed here)."};
}

std::optional<HeadFault> fault_of_fields(const HttpRequest& request, bool is_http_1_0) {
  const auto hosts = count_of(request.fields, "Host");
  if (hosts > 1 || (hosts == 0 && !is_http_1_0)) return HeadFault{400, "Send exactly one Host header line."};
  const auto coding = field_of(request.fields, "Transfer-Encoding");
  if (coding && !equal_ignoring_case(*coding, "chunked"))
    return HeadFault{501, "The only Transfer-Encoding understood here is chunked."};
  const auto lengths = count_of(request.fields, "Content-Length");
  if (lengths > 1 || (lengths == 1 && coding))
    return HeadFault{400, "Send one Content-Length, or Transfer-Encoding, not both and not twice."};
  if (coding && is_http_1_0) return HeadFault{400, "HTTP/1.0 has no Transfer-Encoding."};
  if (count_of(request.fields, "Expect") > 0)
    return HeadFault{417, "This server expects no bodies: send the request without Expect."};
  return std::nullopt;
}

}  // namespace vicus
