#include "cli/check_models.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "sectorgen/models/solid_check.hpp"

namespace vicus::cli {
namespace {

/// Width x height by a PNG's header; 0: it is none.
double pixels_of(std::string_view png) {
  constexpr std::size_t kWidthAt = 16, kHeightAt = 20, kHeader = 24;
  if (png.size() < kHeader || !png.starts_with("\x89PNG")) return 0;
  const auto u32 = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(png[at + k]);
    return static_cast<double>(value);
  };
  return u32(kWidthAt) * u32(kHeightAt);
}

}  // namespace

ModelFigures check_models(const City& city, const CityReader& file) {
  ModelFigures figures;
  for (const Building& b : city.buildings) {
    if (b.roof.facets.empty())
      ++figures.without;
    else if (auto fault = fault_of_roof(b.footprint, b.eave_m, b.roof))
      figures.unsound.push_back({b.id, std::move(*fault)});
    else
      ++figures.sound;
  }
  std::map<std::string, std::set<std::string>> images;  // of each sector
  const auto atlas = city.meta.find("atlas"), grain = city.meta.find("grain");
  for (const auto& f : city.facades) {
    images[f.sector_id].insert(f.texture);
    if (atlas != city.meta.end()) images[f.sector_id].insert(atlas->second);
  }
  if (grain != city.meta.end())
    for (const auto& s : city.surfaces) images[s.sector_id].insert(grain->second);
  std::map<std::string, double> kilobytes;
  const auto kb_of = [&](const std::string& id) {
    const auto [at, is_new] = kilobytes.try_emplace(id, 0);
    if (is_new)
      if (const auto image = file.artefact("textures/" + id + ".png", {"identity"}))
        at->second = pixels_of(image->body) * 4 * 4 / 3 / 1000;
    return at->second;
  };
  std::vector<double> totals;
  for (const auto& sector : city.sectors) {
    double total = 0;
    for (const auto& id : images[sector.id]) total += kb_of(id);
    totals.push_back(total);
    figures.texture_max_kb = std::max(figures.texture_max_kb, total);
  }
  figures.texture_kb = spread_of(std::move(totals));
  return figures;
}

}  // namespace vicus::cli
