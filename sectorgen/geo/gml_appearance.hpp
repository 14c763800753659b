#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "city_db/colour.hpp"

namespace vicus {

/// What CityGML says of colours and images of surfaces, by their gml:id: X3DMaterial and ParameterizedTexture with
/// texture coordinates. Back sides, and images that are not there, are passed over.
/// Source  OGC 12-019 (CityGML 2.0), chapter 9. Differs  themes are not told apart: the last one holds; TexCoordGen is
///         not read.
class GmlAppearance {
 public:
  struct Image {
    std::filesystem::path file;
    std::vector<std::array<double, 2>> places;  ///< one each position of the ring, the repeated one among them
  };

  explicit GmlAppearance(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `attribute`: value by local name, "" where there is none.
  void start(std::string_view element, const std::function<std::string(std::string_view)>& attribute);
  /// The element was an appearance's.
  bool end(std::string_view element, const std::string& text);

  /// By gml:id of a surface, or of one that holds it.
  const std::unordered_map<std::string, Colour>& colours() const { return colours_; }
  /// By gml:id of a ring.
  const std::unordered_map<std::string, Image>& images() const { return images_; }

 private:
  enum class Kind { none, material, image };
  void end_material();

  std::filesystem::path folder_, file_;
  Kind kind_ = Kind::none;
  bool is_front_ = true;
  std::optional<Colour> colour_;
  std::vector<std::string> targets_;
  std::string ring_;
  std::unordered_map<std::string, Colour> colours_;
  std::unordered_map<std::string, Image> images_;
};

}  // namespace vicus
