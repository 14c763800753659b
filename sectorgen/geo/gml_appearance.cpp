#include "sectorgen/geo/gml_appearance.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/geo/number_list.hpp"

namespace vicus {
namespace {

/// "#id" as id; "" for what is in another file.
std::string local_name(const std::string& link) { return link.size() > 1 && link[0] == '#' ? link.substr(1) : ""; }

}  // namespace

void GmlAppearance::start(std::string_view element, const std::function<std::string(std::string_view)>& attribute) {
  if (element == "X3DMaterial" || element == "ParameterizedTexture") {
    kind_ = element == "X3DMaterial" ? Kind::material : Kind::image;
    is_front_ = true;
    colour_.reset();
    targets_.clear();
    file_.clear();
  } else if (kind_ == Kind::image && element == "textureCoordinates") {
    ring_ = local_name(attribute("ring"));
  }
}

bool GmlAppearance::end(std::string_view element, const std::string& text) {
  if (kind_ == Kind::none) return false;
  if (element == "X3DMaterial") {
    end_material();
    kind_ = Kind::none;
  } else if (element == "ParameterizedTexture") {
    kind_ = Kind::none;
  } else if (element == "isFront") {
    is_front_ = text != "false" && text != "0";
  } else if (element == "diffuseColor") {
    std::vector<double> c;
    const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0))); };
    if (append_numbers(text, c) && c.size() == 3) colour_ = Colour{byte(c[0]), byte(c[1]), byte(c[2])};
  } else if (element == "target" && kind_ == Kind::material) {
    targets_.push_back(local_name(text));
  } else if (element == "imageURI") {
    std::error_code error;
    const std::filesystem::path file = folder_ / text;
    if (std::filesystem::is_regular_file(file, error)) file_ = file;
  } else if (element == "textureCoordinates" && is_front_ && !file_.empty() && !ring_.empty()) {
    std::vector<double> numbers;
    if (append_numbers(text, numbers) && numbers.size() % 2 == 0) {
      Image image{file_, {}};
      for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) image.places.push_back({numbers[i], numbers[i + 1]});
      images_.insert_or_assign(ring_, std::move(image));
    }
  }
  return true;
}

void GmlAppearance::end_material() {
  if (!colour_ || !is_front_) return;
  for (const std::string& target : targets_)
    if (!target.empty()) colours_.insert_or_assign(target, *colour_);
}

}  // namespace vicus
