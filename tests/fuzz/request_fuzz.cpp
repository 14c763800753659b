#include <cstdint>
#include <string>
#include <string_view>

#include "httpd/etag.hpp"
#include "httpd/geo_json.hpp"
#include "httpd/negotiate.hpp"
#include "httpd/request_head.hpp"
#include "httpd/url.hpp"
#include "tests/fuzz/require.hpp"

namespace {

void check_url(std::string_view text) {
  using namespace vicus;
  std::string reason;
  const auto url = parse_url(text, reason);
  require(url.has_value() == reason.empty());
  if (!url) return;
  require(url->path.starts_with('/') && is_utf8(url->path));
  require(url->path.find('\\') == std::string::npos && url->path.find('\0') == std::string::npos);
  require((url->path + "/").find("/../") == std::string::npos);
  for (const auto& [name, value] : url->query) {
    require(is_utf8(name) && is_utf8(value));
    const auto again = parse_url("/?" + encode_url_part(name) + "=" + encode_url_part(value), reason);
    require(again && again->query.front().first == name && again->query.front().second == value);
  }
}

}  // namespace

/// Any bytes as a request's head, address, Accept-Encoding, Accept, If-None-Match and bbox.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vicus;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string field(text);
  check_url(text);
  if (const auto codings = accepted_codings(field)) require(codings->size() <= 3);
  if (const auto quality = media_quality(field, "model/x3d+xml")) require(*quality >= 0 && *quality <= 1000);
  if (names_etag(field, "\"a-br\"")) require(field.find('*') != field.npos || field.find("\"a-br\"") != field.npos);
  if (const auto box = parse_geo_box(field)) require(box->south <= box->north);
  if (const auto length = head_length(text)) {
    require(*length <= size && text[*length - 1] == '\n');
    if (!fault_of_bytes(text.substr(0, *length))) require(text.substr(0, *length).ends_with("\r\n\r\n"));
  }
  return 0;
}
