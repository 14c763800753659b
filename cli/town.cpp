#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "city_db/issues.hpp"
#include "cli/command.hpp"
#include "sectorgen/town/town.hpp"

namespace vicus::cli {

namespace {

struct TownArguments {
  TownOptions options;
  std::vector<std::string> presets;
  std::filesystem::path output;
};

/// Whole or not at all: written beside the target, then renamed.
void write_whole(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (out && !error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw CityError("cannot write " + path.string() +
                  (error ? ": " + error.message() : "; is the folder there, is it full?"));
}

void run_town(TownArguments& arguments, Context& context) {
  for (const std::string& name : arguments.presets) apply_town_preset(name, arguments.options);
  const Town town = make_town(arguments.options);
  write_whole(arguments.output, town.osm);
  const TownCounts& c = town.counts;
  print_result(context,
               arguments.output.string() + ": " + std::to_string(c.houses) + " houses, " + std::to_string(c.streets) +
                   " streets, " + std::to_string(c.nodes) + " nodes\n",
               {{"output", arguments.output.string()},
                {"seed", arguments.options.seed},
                {"bytes", town.osm.size()},
                {"counts",
                 {{"houses", c.houses},
                  {"buildings", c.buildings},
                  {"streets", c.streets},
                  {"nodes", c.nodes},
                  {"ways", c.ways},
                  {"relations", c.relations}}}});
}

std::string preset_help() {
  std::string text = "make it hard (repeatable):";
  for (const TownPreset& p : town_presets()) text += "\n" + p.name + ": " + p.what;
  return text;
}

}  // namespace

void add_town(CLI::App& app, Context& context) {
  auto* command = new_command(app, context, "town", "Make a synthetic old town as OSM XML: equal seeds, equal bytes",
                              "vicus town --houses 300 --seed 1 -o town.osm");
  const auto arguments = std::make_shared<TownArguments>();
  std::vector<std::string> names;
  for (const TownPreset& p : town_presets()) names.push_back(p.name);
  command->add_option("--houses", arguments->options.houses, "number of houses")
      ->check(CLI::Range(kMinHouses, kMaxHouses))
      ->capture_default_str();
  command->add_option("--seed", arguments->options.seed, "which town")->capture_default_str();
  command->add_option("--lat", arguments->options.lat_deg, "degrees north of the town's centre")
      ->check(CLI::Range(-85.0, 85.0))
      ->capture_default_str();
  command->add_option("--lon", arguments->options.lon_deg, "degrees east of the town's centre")
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  command->add_option("--preset", arguments->presets, preset_help())->check(CLI::IsMember(names));
  command->add_option("-o,--output", arguments->output, "OSM XML file to write")->required();
  command->callback([arguments, &context] { run_town(*arguments, context); });
}

}  // namespace vicus::cli
