#include "sectorgen/models/author_models.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "sectorgen/geo/csv_fields.hpp"
#include "sectorgen/geo/tag_values.hpp"
#include "sectorgen/models/gltf_scene.hpp"

namespace vicus {
namespace {

constexpr double kMostSize_m = 1000;

std::uint8_t byte_of(double linear) {
  return static_cast<std::uint8_t>(std::lround(255 * srgb_of_linear(std::clamp(linear, 0.0, 1.0))));
}

}  // namespace

Prototype read_model(const std::filesystem::path& path, const std::string& kind, double height_m) {
  const auto triangles = read_gltf(path);
  if (triangles.empty()) throw CityError(path.string() + ": expected triangles, found none", 4);
  if (triangles.size() > kMostModelTriangles)
    throw CityError(path.string() + ": has " + std::to_string(triangles.size()) + " triangles; at most " +
                        std::to_string(kMostModelTriangles) + ", as it is sent with every sector that has one",
                    4);
  double low = HUGE_VAL, high = -HUGE_VAL, wide = 0;
  for (const auto& triangle : triangles)
    for (const auto& p : triangle.corners) {
      low = std::min(low, p[1]);
      high = std::max(high, p[1]);
      wide = std::max({wide, std::abs(p[0]), std::abs(p[2])});
    }
  if (!(high > low) || !std::isfinite(wide)) throw CityError(path.string() + ": has no height", 4);
  const double scale = height_m > 0 ? height_m / (high - low) : 1;
  if (std::max(wide, high - low) * scale > kMostSize_m)
    throw CityError(path.string() + ": is larger than " + std::to_string(static_cast<int>(kMostSize_m)) +
                        " m; glTF counts in metres: give its height in the list",
                    4);
  Prototype out;
  out.kind = kind;
  std::map<GroundPoint, std::uint32_t> index;
  for (const auto& triangle : triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = triangle.corners[k];
      const GroundPoint point{{lattice_mm(scale * p[0]), lattice_mm(-scale * p[2])}, lattice_mm(scale * (p[1] - low))};
      const auto [at, is_new] = index.emplace(point, static_cast<std::uint32_t>(out.points.size()));
      if (is_new) out.points.push_back(point);
      corners[k] = at->second;
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    out.triangles.insert(out.triangles.end(), corners.begin(), corners.end());
    out.colours.push_back({byte_of(triangle.colour[0]), byte_of(triangle.colour[1]), byte_of(triangle.colour[2])});
  }
  if (out.colours.empty())
    throw CityError(path.string() + ": is smaller than a millimetre; give its height in the list", 4);
  return out;
}

std::vector<Prototype> read_model_list(const std::filesystem::path& list) {
  std::ifstream in(list);
  if (!in) throw CityError(list.string() + ": cannot be opened", 4);
  std::vector<Prototype> models;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
    const std::string where = list.string() + ", line " + std::to_string(number) + ": ";
    const auto fields = csv_fields(line);
    if (!fields) throw CityError(where + "its quotation marks do not match", 4);
    const auto& cells = *fields;
    if (cells[0].empty() || cells.size() < 2 || cells.size() > 3 || cells[1].empty())
      throw CityError(where + "expected KIND,FILE[,HEIGHT_M], such as tree,lime.glb,12", 4);
    const bool has_height = cells.size() == 3 && !cells[2].empty();
    const auto height = has_height ? parse_metres(cells[2]) : std::optional(0.0);
    if (!height || (has_height && *height <= 0)) throw CityError(where + cells[2] + " is no height in metres", 4);
    if (std::any_of(models.begin(), models.end(), [&](const Prototype& p) { return p.kind == cells[0]; }))
      throw CityError(where + "a second model of " + cells[0], 4);
    try {
      models.push_back(read_model(list.parent_path() / cells[1], cells[0], *height));
    } catch (const CityError& error) {
      throw CityError(where + error.what(), error.exit_code);
    }
  }
  if (models.empty()) throw CityError(list.string() + ": expected lines KIND,FILE[,HEIGHT_M], found none", 4);
  return models;
}

void add_author_models(std::vector<Prototype> models, City& city) {
  for (auto& model : models) {
    if (std::none_of(city.objects.begin(), city.objects.end(), [&](const auto& o) { return o.kind == model.kind; }))
      city.issues.push_back({IssueCode::unused_model,
                             "The city has no object of the kind " + model.kind + ": its model stands nowhere.",
                             model.kind, PlanPoint{}});
    city.prototypes.push_back(std::move(model));
  }
}

}  // namespace vicus
