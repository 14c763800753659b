#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "city_db/city.hpp"

/// A roof as the bytes of a BLOB (FORMAT.md, *roof*). Internal to store*.cpp.
namespace vicus {

std::string encode_roof(const Roof& roof);

/// decode_roof(encode_roof(r)) == r. nullopt: bytes that are no roof; indices beyond the points, points beyond the
/// lattice and counts beyond the bytes among them.
std::optional<Roof> decode_roof(std::string_view bytes);

}  // namespace vicus
