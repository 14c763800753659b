#pragma once
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include "sectorgen/geo/city_model.hpp"

namespace vicus {

using Json = nlohmann::json;

/// null where there is none.
const Json& member(const Json& object, const char* key);
const Json& entry(const Json& list, std::size_t i);
/// Text, or a number as text; else "".
std::string text_of(const Json& value);

/// Colours and images of a CityJSON file. Images that are not there are passed over, and whatever is not as specified.
/// Source  CityJSON Specifications 2.0.1, chapter 6. Differs  of several themes the first by name holds.
class CityjsonAppearance {
 public:
  /// Keeps `appearance`, which must outlive it.
  CityjsonAppearance(const Json& appearance, const std::filesystem::path& folder);

  /// Lists as deep as the geometry's boundaries; null: none; a number: one material for all.
  const Json& material_values(const Json& geometry) const;
  const Json& texture_values(const Json& geometry) const;
  std::optional<Colour> colour(const Json& value) const;
  /// `value`: one surface's, rings of [texture, place, place, ...].
  void put_image(const Json& value, ModelSurface& surface) const;

 private:
  const Json& appearance_;
  std::vector<std::filesystem::path> images_;  // "" for what is not there
};

}  // namespace vicus
