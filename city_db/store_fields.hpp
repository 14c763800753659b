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

inline PlanPoint point_at(const Statement& row, int i) {
  return require(row, decode_point(row.bytes(i)), "a geometry is no point on the lattice");
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
