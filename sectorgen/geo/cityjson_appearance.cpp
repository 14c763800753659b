#include "sectorgen/geo/cityjson_appearance.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vicus {
namespace {

/// The first theme's `key`.
const Json& of_theme(const Json& themes, const char* key) {
  if (!themes.is_object() || themes.empty()) return member(Json(), key);
  return member(*themes.begin(), key);
}

}  // namespace

const Json& member(const Json& object, const char* key) {
  static const Json kNothing;
  if (!object.is_object()) return kNothing;
  const auto at = object.find(key);
  return at == object.end() ? kNothing : *at;
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return std::to_string(value.get<long long>());
  if (value.is_number()) {
    std::ostringstream out;
    out << value.get<double>();
    return out.str();
  }
  return "";
}

const Json& entry(const Json& list, std::size_t i) {
  static const Json kNothing;
  return list.is_array() && i < list.size() ? list[i] : kNothing;
}

CityjsonAppearance::CityjsonAppearance(const Json& appearance, const std::filesystem::path& folder)
    : appearance_(appearance) {
  const Json& textures = member(appearance, "textures");
  if (!textures.is_array()) return;
  for (const Json& texture : textures) {
    std::error_code error;
    const std::filesystem::path file = folder / text_of(member(texture, "image"));
    images_.push_back(std::filesystem::is_regular_file(file, error) ? file : "");
  }
}

const Json& CityjsonAppearance::material_values(const Json& geometry) const {
  const Json& themes = member(geometry, "material");
  const Json& values = of_theme(themes, "values");
  return values.is_null() ? of_theme(themes, "value") : values;
}

const Json& CityjsonAppearance::texture_values(const Json& geometry) const {
  return of_theme(member(geometry, "texture"), "values");
}

std::optional<Colour> CityjsonAppearance::colour(const Json& value) const {
  if (!value.is_number_unsigned()) return std::nullopt;
  const Json& channels = member(entry(member(appearance_, "materials"), value.get<std::size_t>()), "diffuseColor");
  std::uint8_t bytes[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& channel = entry(channels, k);
    if (!channel.is_number()) return std::nullopt;
    bytes[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel.get<double>(), 0.0, 1.0)));
  }
  return Colour{bytes[0], bytes[1], bytes[2]};
}

void CityjsonAppearance::put_image(const Json& value, ModelSurface& surface) const {
  const Json& ring = entry(value, 0);
  const Json& number = entry(ring, 0);
  if (!number.is_number_unsigned() || number.get<std::size_t>() >= images_.size() || surface.rings.empty() ||
      ring.size() != surface.rings[0].size() + 1 || images_[number.get<std::size_t>()].empty())
    return;
  const Json& places = member(appearance_, "vertices-texture");
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const Json& index = ring[i + 1];
    const Json& place = index.is_number_unsigned() ? entry(places, index.get<std::size_t>()) : entry(places, SIZE_MAX);
    if (!entry(place, 0).is_number() || !entry(place, 1).is_number()) return;
    surface.rings[0][i].u = place[0].get<double>();
    surface.rings[0][i].v = place[1].get<double>();
  }
  surface.image = images_[number.get<std::size_t>()];
}

}  // namespace vicus
