#pragma once
#include <cstdint>
#include <string_view>

namespace vicus {

/// FNV-1a, 64 bits, mixed once so that "% n" spreads neighbouring ids: steady over runs and machines, for palettes.
constexpr std::uint64_t steady_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  hash ^= hash >> 32;
  hash *= 0x9E3779B97F4A7C15u;
  return hash ^ (hash >> 29);
}

}  // namespace vicus
