#pragma once
#include <optional>
#include <string>

#include "city_db/city.hpp"
#include "city_db/geometry_blob.hpp"
#include "city_db/json_text.hpp"
#include "city_db/store_sqlite.hpp"

/// Columns of a row as values; what cannot be what we wrote is "damaged". Internal to store_records*.cpp.
namespace vicus {

/// The value, or "damaged" when a decoder gave nullopt.
template <class T>
T require(const Statement& row, std::optional<T> value, const char* what) {
  if (!value) row.database().throw_damaged(what);
  return std::move(*value);
}

/// A number into a blob and out of one, little-endian.
template <class Unsigned>
void append_le(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
}

/// Needs   bytes that reach so far.
template <class Unsigned>
Unsigned le_at(std::string_view bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i)
    value |= static_cast<Unsigned>(Unsigned{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i));
  return value;
}

inline PlanPoint point_at(const Statement& row, int i) {
  return require(row, decode_point(row.bytes(i)), "a geometry is no point on the lattice");
}
inline Polygon polygon_at(const Statement& row, int i) {
  return require(row, decode_polygon(row.bytes(i)), "a geometry is no polygon on the lattice");
}
inline std::vector<PlanPoint> line_at(const Statement& row, int i) {
  return require(row, decode_line(row.bytes(i)), "a geometry is no line on the lattice");
}
inline Tags tags_at(const Statement& row, int i) {
  return require(row, tags_from_json(row.bytes(i)), "tags are no JSON object");
}

template <class Kind>
Kind kind_at(const Statement& row, int i) {
  Kind kind{};
  const std::string name = row.text(i);
  if (!parse_name(name, kind)) row.database().throw_damaged("unknown kind '" + name.substr(0, 40) + "'");
  return kind;
}

}  // namespace vicus
