#include "sectorgen/build_city.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <thread>

#include "city_db/store.hpp"
#include "cli/city_mesh.hpp"
#include "cli/command.hpp"
#include "cli/tiles.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/impostors/bake_impostor.hpp"
#include "sectorgen/bake/impostors/bake_panorama.hpp"
#include "sectorgen/geo/map_name.hpp"
#include "sectorgen/geo/room_list.hpp"
#include "sectorgen/models/author_models.hpp"
#include "x3d_export/package.hpp"

namespace vicus::cli {
namespace {

/// Up to so many `--impostors auto` bakes pictures beyond gates: one takes about 0.035 CPU s.
constexpr std::size_t kSectorsWithImpostors = 1500;

struct Arguments {
  std::vector<std::string> inputs;
  std::string output, name, boundary, buildings, streets, origin, important, terrain, crs, models, photos, interiors;
  unsigned threads = 0;
  unsigned budget_kb = 200;
  bool strict = false;
  bool fresh_ids = false;
  bool no_tiles = false;
  std::string over_roofs = "auto", impostors = "no", panoramas = "no";
};

/// Whole map to sectors, with what each stage cost so far: how the time left is guessed.
struct Progress {
  bool shown;
  explicit Progress(const Context& context) : shown(!context.quiet && isatty(STDERR_FILENO) != 0) {}
  void operator()(const char* stage) const {
    // Shares of a typical build (docs/figures.md), so that the estimate is a number a person can use.
    static const std::map<std::string, double> kDone = {{"read", 0},         {"normalise", 0.1}, {"sectors", 0.2},
                                                        {"records", 0.25},   {"models", 0.27},   {"ground", 0.29},
                                                        {"visibility", 0.3}, {"impostors", 0.5}, {"panoramas", 0.55},
                                                        {"tiles", 0.8},      {"export", 0.85}};
    if (!shown) return;
    const double done = kDone.at(stage), spent = cpu_seconds();
    if (done > 0)
      std::fprintf(stderr, "\r\033[K%s ... about %.0f s left", stage, spent / done * (1 - done) + 0.5);
    else
      std::fprintf(stderr, "\r\033[K%s ...", stage);
  }
  ~Progress() {
    if (shown) std::fprintf(stderr, "\r\033[K");
  }
};

OverRoofs over_roofs_of(const std::string& text) {
  return text == "yes"         ? OverRoofs::yes
         : text == "landmarks" ? OverRoofs::landmarks
         : text == "no"        ? OverRoofs::no
                               : OverRoofs::automatic;
}

LatLon parse_origin(const std::string& text) {
  double lat = 0, lon = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &lat, &lon, &rest) != 2 || !(std::abs(lat) <= 90) ||
      !(std::abs(lon) <= 180))
    throw CityError("--origin " + text + ": expected LAT,LON in degrees, such as 48.8770,2.3450", kWrongUsage);
  return {lat, lon};
}

LoadOptions load_options(const Arguments& arguments) {
  LoadOptions load;
  for (const auto& input : arguments.inputs) load.inputs.emplace_back(input);
  if (!arguments.boundary.empty()) load.boundary = arguments.boundary;
  if (!arguments.buildings.empty()) load.buildings_layer = arguments.buildings;
  if (!arguments.streets.empty()) load.streets_layer = arguments.streets;
  if (!arguments.origin.empty()) load.origin = parse_origin(arguments.origin);
  load.assumed_system = arguments.crs;
  return load;
}

/// The city built before under this name, for its sector ids. A file that is no city is refused before any work is
/// done; one of another format version is replaced, and its ids are lost.
std::optional<City> previous_city(const Arguments& arguments, const Context& context) {
  if (!std::filesystem::exists(arguments.output)) return std::nullopt;
  try {
    City city = read_city(arguments.output);
    if (!arguments.fresh_ids) return city;
  } catch (const OtherVersionError& error) {
    if (!context.quiet) std::fprintf(stderr, "%s\nit is replaced; its sector ids are not kept\n", error.what());
  } catch (const CityError& error) {
    throw CityError(std::string(error.what()) + "\nto build under this name all the same, remove the file first",
                    error.exit_code);
  }
  return std::nullopt;
}

void fill_meta(const Arguments& arguments, const SourceMap& map, City& city) {
  const auto lines = [](const auto& list) {
    std::string out;
    for (const auto& line : list) out += (out.empty() ? "" : "\n") + std::filesystem::path(line).string();
    return out;
  };
  std::vector<std::string> names;
  for (const auto& input : arguments.inputs) names.push_back(std::filesystem::path(input).filename().string());
  city.meta["name"] = !arguments.name.empty() ? arguments.name
                      : !map.name.empty()     ? map.name
                                              : name_from_file(std::filesystem::absolute(arguments.inputs.front()));
  if (!arguments.terrain.empty()) names.push_back(std::filesystem::path(arguments.terrain).filename().string());
  city.meta["sources"] = lines(names);
  city.meta["licences"] = lines(map.licences);
  city.meta["program_version"] = VICUS_VERSION;
  city.meta["budget_bytes"] = std::to_string(std::uint64_t{arguments.budget_kb} * 1000);
  nlohmann::json options = {{"budget_kb", arguments.budget_kb}};
  if (!arguments.name.empty()) options["name"] = arguments.name;
  if (!arguments.origin.empty()) options["origin"] = arguments.origin;
  if (!arguments.crs.empty()) options["crs"] = arguments.crs;
  if (!arguments.boundary.empty()) options["boundary"] = std::filesystem::path(arguments.boundary).filename().string();
  if (!arguments.buildings.empty()) options["buildings"] = arguments.buildings;
  if (!arguments.streets.empty()) options["streets"] = arguments.streets;
  if (arguments.over_roofs != "auto") options["over_roofs"] = arguments.over_roofs;
  if (arguments.impostors != "no") options["impostors"] = arguments.impostors;
  if (arguments.panoramas != "no") options["panoramas"] = arguments.panoramas;
  if (!arguments.terrain.empty()) options["terrain"] = std::filesystem::path(arguments.terrain).filename().string();
  if (!arguments.photos.empty()) options["photos"] = std::filesystem::path(arguments.photos).filename().string();
  if (!arguments.interiors.empty())
    options["interiors"] = std::filesystem::path(arguments.interiors).filename().string();
  if (!arguments.models.empty()) options["models"] = std::filesystem::path(arguments.models).filename().string();
  if (!arguments.important.empty())
    options["important"] = std::filesystem::path(arguments.important).filename().string();
  city.meta["options"] = options.dump();
}

nlohmann::json report_object(const City& city, const BuildReport& report, const std::string& output) {
  nlohmann::json object = {{"output", output},
                           {"counts",
                            {{"sectors", city.sectors.size()},
                             {"gates", city.gates.size()},
                             {"buildings", city.buildings.size()},
                             {"streets", city.streets.size()},
                             {"interiors", city.interiors.size()},
                             {"objects", city.objects.size()},
                             {"issues", city.issues.size()}}}};
  std::map<std::string, int> issues;
  for (const auto& issue : city.issues)
    ++issues[std::to_string(static_cast<int>(issue.code)) + " " + name_of(issue.code)];
  object["issues"] = issues;
  if (const Terrain& t = city.terrain; !t.height_mm.empty())
    object["terrain"] = {{"columns", t.columns},
                         {"rows", t.rows},
                         {"step_m", metres(t.step_mm)},
                         {"is_coarsened", report.is_terrain_coarsened},
                         {"base_m", std::stoi(city.meta.at("terrain_base_m"))},
                         {"largest_gap_m", report.largest_gap_m}};
  object["stages"] = nlohmann::json::array();
  for (const auto& s : report.stages)
    object["stages"].push_back({{"stage", s.stage}, {"cpu_s", s.cpu_s}, {"wall_s", s.wall_s}, {"peak_mb", s.peak_mb}});
  return object;
}

std::string report_text(const City& city, const BuildReport& report, const std::string& output) {
  std::ostringstream out;
  double wall = 0;
  for (const auto& s : report.stages) wall += s.wall_s;
  char line[200];
  std::snprintf(line, sizeof line, "%s: %zu sectors, %zu gates, %zu buildings from the map in %.1f s, %zu issues\n",
                output.c_str(), city.sectors.size(), city.gates.size(), city.buildings.size(), wall,
                city.issues.size());
  out << line;
  if (const Terrain& t = city.terrain; !t.height_mm.empty())
    out << "terrain: " << t.columns << " x " << t.rows << " heights, every " << metres(t.step_mm) << " m"
        << (report.is_terrain_coarsened ? " (coarser than 5 m: the city is large)" : "") << ", above "
        << city.meta.at("terrain_base_m") << " m; largest gap between a house and the ground before it "
        << std::lround(100 * report.largest_gap_m) << " cm\n";
  out << "next: vicus check " << output << "; vicus serve " << output << "\n";
  return out.str();
}

bool wants_impostors(const Arguments& arguments, const City& city) {
  if (arguments.impostors == "auto") return city.sectors.size() <= kSectorsWithImpostors;
  return arguments.impostors == "yes";
}

/// Facades as they are seen from some distance: one image each.
void add_impostors(const Arguments& arguments, City& city) {
  const CityIndex index(city);
  CityMeshOptions mesh;
  mesh.level = 3;
  const RayScene scene(city_mesh(index, textures_of(city), mesh));
  ImpostorOptions options;
  options.threads = arguments.threads;
  city.impostors = bake_impostors(city, scene, options);
}

void add_panoramas(const Arguments& arguments, City& city) {
  const CityIndex index(city);
  std::vector<SectorPart> parts;
  for (const Sector& s : city.sectors) parts.push_back({&s, Detail::far, 1, {}});
  std::vector<std::uint32_t> first;
  RenderMesh mesh = parts_mesh(index, cached(textures_of(city)), parts, false, &first);
  const FarCity far{RayScene(std::move(mesh)), std::move(first)};
  PanoramaOptions options;
  options.threads = arguments.threads;
  city.panoramas = bake_panoramas(city, far, options);
}

void report_over_budget(City& city, std::uint64_t budget_bytes) {
  for (const auto& s : city.sectors)
    if (s.bytes > budget_bytes)
      city.issues.push_back(
          {IssueCode::over_budget,
           "sector " + s.id + " takes " + std::to_string(s.bytes) + " bytes and has no chord left to cut at", s.id,
           s.origin});
}

void run(const Arguments& arguments, Context& context) {
  const std::optional<City> previous = previous_city(arguments, context);
  const Progress progress(context);
  BuildReport report;
  StageClock clock(report, [&](const char* stage) { progress(stage); });
  clock.begin("read");
  std::vector<Issue> issues;
  SourceMap map = load_source_map(load_options(arguments), issues);
  if (!arguments.interiors.empty()) read_room_list(arguments.interiors, map);
  clock.end();

  BuildOptions options;
  options.budget_bytes = std::uint64_t{arguments.budget_kb} * 1000;
  options.threads = options.visible.threads = arguments.threads;
  options.visible.over_roofs = over_roofs_of(arguments.over_roofs);
  if (!arguments.important.empty()) options.important = read_author_list(arguments.important, issues);
  if (!arguments.models.empty()) options.models = read_model_list(arguments.models);
  if (!arguments.photos.empty()) options.photos = read_photo_list(arguments.photos);
  options.terrain = arguments.terrain;
  options.previous = previous ? &*previous : nullptr;
  options.on_stage = [&](const char* stage) { progress(stage); };
  const std::vector<std::string> licences = map.licences;
  City city = build_city(map, options, std::move(issues), report);
  fill_meta(arguments, map, city);

  std::vector<Artefact> tiles;
  city.meta["tile_levels"] = std::to_string(levels_of(city));
  if (!arguments.no_tiles) {
    clock.begin("tiles");
    tiles = bake_tiles(city, arguments.output, arguments.threads);
    clock.end();
  }
  if (wants_impostors(arguments, city)) {
    clock.begin("impostors");
    add_impostors(arguments, city);
  }
  if (arguments.panoramas == "yes") {
    clock.begin("panoramas");
    add_panoramas(arguments, city);
  }
  clock.begin("export");
  PackageOptions package;
  package.threads = arguments.threads;
  const auto artefacts = followed_by(export_artefacts(city, package), std::move(tiles));
  write_city(arguments.output, city, [&] {
    auto artefact = artefacts();
    if (!artefact) report_over_budget(city, options.budget_bytes);
    return artefact;
  });
  clock.end();
  if (arguments.strict && !city.issues.empty()) context.exit_code = kRuleBroken;
  print_result(context, report_text(city, report, arguments.output), report_object(city, report, arguments.output));
}

}  // namespace

void add_build(CLI::App& app, Context& context) {
  auto* command =
      new_command(app, context, "build", "derive a city from a map: sectors, gates, houses, X3D",
                  "vicus build city.osm.pbf -o city.gpkg\n  vicus build buildings.gpkg streets.gpkg -o city.gpkg");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("INPUT", arguments->inputs,
                   "map files: OSM PBF/XML, GeoPackage, GeoJSON (.geojson, .geojsonl, .gz), Shapefile, FlatGeobuf; "
                   "houses as models: CityJSON, CityGML")
      ->required();
  command->add_option("-o,--output", arguments->output, "the city file to write")->required();
  command->add_option("--name", arguments->name,
                      "the city's name; else the map's own, else the first file's or its folder's");
  command->add_option("--boundary", arguments->boundary, "a polygon file: what belongs to the city");
  command->add_option("--buildings", arguments->buildings, "FILE or FILE:LAYER with the footprints");
  command->add_option("--streets", arguments->streets, "FILE or FILE:LAYER with the centre lines");
  command->add_option("--origin", arguments->origin, "LAT,LON of the plan frame's origin");
  command->add_option("--crs", arguments->crs,
                      "EPSG:NUMBER, the coordinate system of CityJSON and CityGML that name none");
  command->add_option("--terrain", arguments->terrain,
                      "heights of the ground: a GeoTIFF or other raster with a coordinate system");
  command->add_option("--important", arguments->important,
                      "important sectors, one a line: PLACE[,METRES] or LAT,LON[,METRES]; PLACE is a sector id or the "
                      "name of a street or square, METRES (default 500) how far around it stays loaded, 0: no more");
  command->add_option(
      "--models", arguments->models,
      "your own glTF models in place of ours, one a line: KIND,FILE[,HEIGHT_M], such as tree,lime.glb,12");
  command->add_option(
      "--photos", arguments->photos,
      "a table of photos of facades: first line house,file,heading,corners,bays,floors (docs/houses.md)");
  command->add_option("--interiors", arguments->interiors,
                      "a table of rooms behind doors: first line house,outline,doors,name,height, places as WKT "
                      "(docs/interiors.md)");
  command->add_option("--threads", arguments->threads, "0: all cores");
  command->add_option("--budget-kb", arguments->budget_kb, "largest sector as sent, in kB")
      ->check(CLI::Range(10u, 100000u));
  command
      ->add_option("--over-roofs", arguments->over_roofs,
                   "list houses seen above nearer roofs: yes, landmarks (houses of " +
                       std::to_string(std::lround(kLandmark_m)) +
                       " m and more alone: a quarter of the time in a large city), no, auto (yes up to " +
                       std::to_string(kSectorsOverRoofs) + " sectors: it takes about 0.03 to 0.2 CPU s a sector)")
      ->check(CLI::IsMember({"auto", "yes", "landmarks", "no"}));
  command
      ->add_option("--impostors", arguments->impostors,
                   "pictures shown in gates until what lies behind has come: no, yes, auto (yes up to " +
                       std::to_string(kSectorsWithImpostors) + " sectors)")
      ->check(CLI::IsMember({"auto", "yes", "no"}));
  command
      ->add_option("--panoramas", arguments->panoramas,
                   "what squares and open land see of the city above nearer roofs, as a picture behind all that comes "
                   "itself: yes, no; a city with whole lists over roofs needs none")
      ->check(CLI::IsMember({"yes", "no"}));
  command->add_flag("--strict", arguments->strict, "exit 3 when the map has any issue");
  command->add_flag("--no-tiles", arguments->no_tiles,
                    "bake no BlockMaps and prisms for flying over; the server then makes each when first asked for");
  command->add_flag("--fresh-ids", arguments->fresh_ids, "do not keep the sector ids of the city that is replaced");
  command->callback([arguments, &context] { run(*arguments, context); });
}

}  // namespace vicus::cli
