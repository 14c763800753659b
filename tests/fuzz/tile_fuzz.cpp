#include <cstdint>
#include <string_view>

#include "city_db/blockmap.hpp"
#include "city_db/blockmap_paper.hpp"
#include "city_db/ground_tile.hpp"
#include "city_db/prism_tile.hpp"
#include "tests/fuzz/require.hpp"

/// Any bytes: no crash, no read outside, and what is accepted encodes to something that decodes to the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vicus;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto map = decode_blockmap(bytes)) require(encode_blockmap(*map) == bytes);
  if (const auto map = decode_paper(bytes)) require(decode_paper(encode_paper(*map)) == *map);
  if (const auto tile = decode_prisms(bytes)) require(decode_prisms(encode_prisms(*tile)) == *tile);
  if (const auto tile = decode_ground(bytes)) require(encode_ground(*tile) == bytes);
  return 0;
}
