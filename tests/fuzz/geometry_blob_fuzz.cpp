#include <cstdint>
#include <string_view>

#include "city_db/geometry_blob.hpp"
#include "tests/fuzz/require.hpp"

/// Any bytes: no crash, no read outside, and what is accepted encodes to something that decodes to the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vicus;
  const std::string_view blob(reinterpret_cast<const char*>(data), size);
  if (const auto point = decode_point(blob)) require(decode_point(encode_point(*point)) == point);
  if (const auto line = decode_line(blob)) {
    require(line->size() * 16 <= size);
    require(decode_line(encode_line(*line)) == line);
  }
  if (const auto polygon = decode_polygon(blob)) {
    const auto again = decode_polygon(encode_polygon(*polygon));
    require(again && again->outer == polygon->outer && again->holes == polygon->holes);
  }
  return 0;
}
