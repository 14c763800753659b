#include "cli/measure_forms.hpp"

#include <algorithm>

#include "city_db/issues.hpp"
#include "cli/measure_glb_forms.hpp"
#include "cli/measure_sector_forms.hpp"
#include "cli/measure_tile_forms.hpp"

namespace vicus::measure {
namespace {

std::vector<FormMaker> all_makers(const std::vector<double>& taus) {
  std::vector<FormMaker> out;
  const auto add = [&](const char* key, auto make) { out.push_back({key, make}); };
  const auto add_taus = [&](const char* key, auto make) {
    for (const double tau : taus) out.push_back({key, [make, tau](SharedCity& city) { return make(city, tau); }});
  };
  add("full", full_model);
  for (int level = 1; level <= 4; ++level)
    add(("lod" + std::to_string(level)).c_str(), [level](SharedCity& city) { return level_files(city, level); });
  add("far", far_files);
  for (const double share : {0.5, 1.0, 2.0}) add("page", [share](SharedCity& city) { return page_files(city, share); });
  add("gates", gate_pictures);
  add_taus("glb-draco", [](SharedCity& city, double tau) { return glb_files(city, GlbCoding::draco, tau); });
  add_taus("glb-meshopt", [](SharedCity& city, double tau) { return glb_files(city, GlbCoding::meshopt, tau); });
  add_taus("tiles", client_tiles);
  add_taus("prisms", prism_tiles);
  for (const std::uint32_t cells : {32u, 64u, 128u, 256u})
    add_taus(("blockmap" + std::to_string(cells)).c_str(),
             [cells](SharedCity& city, double tau) { return blockmap_tiles(city, cells, tau); });
  add_taus("paper2007-32", [](SharedCity& city, double tau) { return paper_tiles(city, 2007, 32, 192, tau); });
  add_taus("paper2007-64", [](SharedCity& city, double tau) { return paper_tiles(city, 2007, 64, 256, tau); });
  add_taus("paper2009-128", [](SharedCity& city, double tau) { return paper_tiles(city, 2009, 128, 512, tau); });
  return out;
}

}  // namespace

std::vector<std::string> form_keys() {
  std::vector<std::string> keys;
  for (const FormMaker& maker : all_makers({1}))
    if (keys.empty() || keys.back() != maker.key) keys.push_back(maker.key);
  return keys;
}

std::vector<FormMaker> form_makers(const std::vector<std::string>& keys, const std::vector<double>& taus) {
  const auto known = form_keys();
  std::string list;
  for (const std::string& key : known) list += (list.empty() ? "" : ", ") + key;
  for (const std::string& key : keys)
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw CityError("--as " + key + ": expected one of " + list, 2);
  auto out = all_makers(taus);
  if (!keys.empty())
    std::erase_if(out, [&](const FormMaker& m) { return std::find(keys.begin(), keys.end(), m.key) == keys.end(); });
  return out;
}

}  // namespace vicus::measure
