#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/store.hpp"
#include "cli/command.hpp"
#include "cli/near_names.hpp"
#include "cli/tiles.hpp"
#include "httpd/static_files.hpp"
#include "x3d_export/flyover_scene.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/house_shell.hpp"
#include "x3d_export/impostor_nodes.hpp"
#include "x3d_export/interior_scene.hpp"
#include "x3d_export/panorama_nodes.hpp"
#include "x3d_export/portals.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"
#include "x3d_export/svg_map.hpp"
#include "x3d_export/text.hpp"
#include "x3d_export/tileset.hpp"
#include "x3d_export/writers.hpp"

namespace vicus::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path city, out, x_ite;
  std::string format, start, lvis;
  bool has_labels = false, keeps_triangles = false;
  GlbOptions glb;
  std::vector<double> box_m;  ///< west, south, east, north
};

struct Written {
  std::size_t files = 0, bytes = 0;
};

const std::vector<std::string> kFormats = {"svg",     "x3d", "vrml",     "x3dj", "site",
                                           "portals", "obj", "cityjson", "glb",  "3dtiles"};

void write_file(const fs::path& path, std::string_view bytes, Written& written) {
  fs::create_directories(path.parent_path().empty() ? "." : path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw CityError("cannot write " + path.string() + ": is the disk full, or the folder not ours to write?");
  ++written.files;
  written.bytes += bytes.size();
}

/// Ids of sectors and gates become file names; a city file from elsewhere may hold anything. A gate's has dots within.
void require_plain_ids(const City& city) {
  const auto require = [](const char* what, const std::string& id, bool may_have_dots) {
    const auto is_plain = [&](unsigned char c) {
      return std::isalnum(c) || c == '_' || c == '-' || (may_have_dots && c == '.');
    };
    if (id.empty() || id.front() == '.' || !std::all_of(id.begin(), id.end(), is_plain))
      throw CityError(std::string(what) + " id '" + id +
                      "' cannot be a file's name: expected letters, digits, '-' and '_'");
  };
  for (const auto& s : city.sectors) require("sector", s.id, false);
  for (const auto& i : city.interiors) require("interior", i.sector.id, false);
  for (const auto& i : city.impostors) require("gate", i.gate_id, true);
}

void write_sectors(const CityIndex& index, const fs::path& folder, SceneFormat format, bool is_site, Written& written) {
  if (format == SceneFormat::x3d)
    for (const auto& interior : index.city().interiors) {
      const auto file = interior_file(index, interior, format);
      write_file(folder / file.path, file.text, written);
      if (is_site)
        write_file(folder / "sectors" / (interior.sector.id + ".json"),
                   record_json(sector_record(source_of(index), interior.sector, file.shapes)), written);
    }
  for (const auto& sector : index.city().sectors) {
    int shapes = 0;
    for (const auto& file : sector_files(index, sector, Detail::near, format)) {
      write_file(folder / file.path, file.text, written);
      shapes += file.shapes;
    }
    if (!is_site || format != SceneFormat::x3d) continue;
    for (const auto detail : {Detail::far, Detail::tall})
      for (const auto& file : sector_files(index, sector, detail, format))
        write_file(folder / file.path, file.text, written);
    write_file(folder / "sectors" / (sector.id + ".json"), record_json(sector_record(source_of(index), sector, shapes)),
               written);
  }
}

std::string stored_image(const CityReader& reader, const fs::path& city_file, const std::string& path) {
  auto image = reader.artefact(path, {"identity"});
  if (!image) throw CityError(city_file.string() + " lacks " + path + ": build the city again");
  return std::move(image->body);
}

/// Which sectors there are, and their boxes in plan metres: the page finds ground to land on where no server answers.
/// {"sectors": [[id, west, south, east, north], ...]}
std::string plan_json(const City& city) {
  std::string out = "{\"sectors\":[";
  for (const auto& sector : city.sectors) {
    const PlanBox box = box_of(sector.ground);
    out += out.back() == '[' ? "\n" : ",\n";
    out += "[\"" + sector.id + "\"";  // a plain id
    for (const std::int32_t mm : {box.min.x, box.min.y, box.max.x, box.max.y}) {
      out += ",";
      append_number(out, metres(mm), 3);
    }
    out += "]";
  }
  return out + "\n]}\n";
}

/// The images that sectors refer to, as they are stored.
void write_textures(const City& city, const fs::path& city_file, const fs::path& folder, Written& written) {
  const CityReader reader(city_file);
  std::set<std::string> ids;
  for (const auto& facade : city.facades) ids.insert(facade.texture);
  for (const char* image : {"atlas", "grain"})
    if (const auto id = city.meta.find(image); id != city.meta.end()) ids.insert(id->second);
  for (const auto& id : ids)
    write_file(folder / "textures" / (id + ".png"), stored_image(reader, city_file, "textures/" + id + ".png"),
               written);
  for (const auto& impostor : city.impostors) {
    const std::string path = impostor_path(impostor.gate_id);
    write_file(folder / path, stored_image(reader, city_file, path), written);
  }
  for (const auto& panorama : city.panoramas) {
    const std::string path = panorama_path(panorama.sector_id);
    write_file(folder / path, stored_image(reader, city_file, path), written);
  }
}

/// Sectors as binary glTF; as 3D Tiles with their far files and the tree over all.
void write_glb(const CityIndex& index, const fs::path& city_file, const fs::path& folder, bool is_tileset,
               const GlbOptions& options, Written& written) {
  const CityReader reader(city_file);
  std::map<std::string, std::string> images;
  const auto image = [&](const std::string& id) {
    if (const auto known = images.find(id); known != images.end()) return known->second;
    return images[id] = stored_image(reader, city_file, "textures/" + id + ".png");
  };
  for (const auto& sector : index.city().sectors) {
    const std::string stem = "sectors/" + sector.id;
    write_file(folder / (stem + ".glb"), sector_glb(index, sector, Detail::near, image, options), written);
    if (is_tileset)
      write_file(folder / (stem + ".far.glb"), sector_glb(index, sector, Detail::far, image, options), written);
  }
  if (is_tileset) write_file(folder / "tileset.json", tileset_json(index), written);
}

void write_root(const CityIndex& index, const Arguments& arguments, const fs::path& folder, SceneFormat format,
                bool is_static, Written& written) {
  RootOptions options;
  options.start = arguments.start;
  options.format = format;
  options.is_static = is_static;
  options.level = kEverySector;
  const auto text = root_text(source_of(index), options);
  if (!text) throw CityError("there is no sector " + arguments.start + " to start in", kWrongUsage);
  write_file(folder / (std::string("city") + suffix_of(format)), *text, written);
}

/// What flying takes: the tiles that the city's file has, and the world that draws them.
void write_tiles(const CityIndex& index, const fs::path& city_file, const fs::path& folder, Written& written) {
  for (const Artefact& tile : stored_tiles(city_file)) write_file(folder / tile.path, tile.body, written);
  write_file(folder / kFlyoverName, write_x3d(flyover_scene(source_of(index))), written);
}

/// Everything a plain web server needs to show the city at its root: page, X_ITE, root worlds, sectors, records, tiles,
/// and where the sectors lie.
void write_site(const CityIndex& index, const Arguments& arguments, const fs::path& folder, Written& written) {
  for (const auto format : {SceneFormat::x3d, SceneFormat::vrml}) {
    write_root(index, arguments, folder, format, false, written);
    write_sectors(index, folder, format, true, written);
  }
  write_textures(index.city(), arguments.city, folder, written);
  write_tiles(index, arguments.city, folder, written);
  write_file(folder / "plan.json", plan_json(index.city()), written);
  for (const auto& file : embedded_client_files()) {
    write_file(folder / "client" / file.path, file.bytes, written);
    if (file.path == "page/index.html") write_file(folder / "index.html", file.bytes, written);
  }
  std::error_code ignored;
  const auto package = find_x_ite(arguments.x_ite, fs::read_symlink("/proc/self/exe", ignored));
  if (package.empty())
    throw CityError(
        "X_ITE was not found: a site shows nothing without it. Run `npm install x_ite`, then give --x_ite "
        "node_modules/x_ite");
  const fs::path dist = folder / "x_ite" / StaticFiles(package).x_ite_version() / "dist";
  fs::create_directories(dist);
  fs::copy(package / "dist", dist, fs::copy_options::recursive);
}

/// A folder that appears whole: made beside its place, then renamed. An older export there is replaced, nothing else.
Written write_folder(const CityIndex& index, const Arguments& arguments) {
  require_plain_ids(index.city());
  const fs::path out = fs::absolute(arguments.out).lexically_normal();
  const bool is_export = fs::exists(out / "sectors");
  if (fs::exists(out) && !is_export && !(fs::is_directory(out) && fs::is_empty(out)))
    throw CityError(out.string() + " is there and is no export of a city: give another folder", kWrongUsage);
  const fs::path fresh = out.string() + ".partial-" + std::to_string(getpid());
  const fs::path old = out.string() + ".old-" + std::to_string(getpid());
  Written written;
  try {
    if (arguments.format == "site") {
      write_site(index, arguments, fresh, written);
    } else if (arguments.format == "glb" || arguments.format == "3dtiles") {
      write_glb(index, arguments.city, fresh, arguments.format == "3dtiles", arguments.glb, written);
    } else {
      const auto format = arguments.format == "x3d"    ? SceneFormat::x3d
                          : arguments.format == "vrml" ? SceneFormat::vrml
                                                       : SceneFormat::x3dj;
      write_root(index, arguments, fresh, format, true, written);
      write_sectors(index, fresh, format, false, written);
      write_textures(index.city(), arguments.city, fresh, written);
    }
    const bool is_replaced = fs::exists(out);
    if (is_replaced) fs::rename(out, old);
    std::error_code refused;
    fs::rename(fresh, out, refused);
    if (refused && is_replaced) fs::rename(old, out);
    if (refused) throw CityError("cannot rename " + fresh.string() + " to " + out.string() + ": " + refused.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);
    throw;
  }
  fs::remove_all(old);
  return written;
}

/// A file that appears whole.
void write_renamed(const fs::path& path, std::string_view bytes, Written& written) {
  const fs::path fresh = path.string() + ".partial-" + std::to_string(getpid());
  write_file(fresh, bytes, written);
  fs::rename(fresh, path);
}

void require_sector(const City& city, const std::string& id) {
  std::vector<std::string> ids;
  for (const auto& s : city.sectors) ids.push_back(s.id);
  if (std::find(ids.begin(), ids.end(), id) != ids.end()) return;
  // Somebody who gives a street's name gets the ids of its sectors.
  std::vector<std::string> namesakes;
  for (const auto& s : city.sectors)
    if (s.name == id) namesakes.push_back(s.id);
  std::string hint = did_you_mean(id, ids);
  if (!namesakes.empty()) {
    hint = "; sectors of that name:";
    for (const auto& name : namesakes) hint += " " + name;
  }
  throw CityError("there is no sector " + id + hint + (hint.empty() ? "; --labels shows the ids on a map" : ""),
                  kWrongUsage);
}

Written write_portals(const City& city, const Arguments& arguments) {
  const auto graph = portal_graph(city, arguments.keeps_triangles);
  Written written;
  write_renamed(arguments.out.string() + ".json", prt_json(graph, city), written);
  write_renamed(arguments.out, prt_text(graph), written);
  return written;
}

Written write_map(const City& city, const Arguments& arguments) {
  SvgOptions options;
  options.has_labels = arguments.has_labels;
  options.lvis = arguments.lvis;
  if (!options.lvis.empty()) require_sector(city, options.lvis);
  if (const auto& b = arguments.box_m; !b.empty()) {
    options.box = PlanBox{{lattice_mm(b[0]), lattice_mm(b[1])}, {lattice_mm(b[2]), lattice_mm(b[3])}};
    if (b[0] >= b[2] || b[1] >= b[3])
      throw CityError("--bbox is empty: expected WEST,SOUTH,EAST,NORTH in metres from the city's origin", kWrongUsage);
  }
  Written written;
  write_renamed(arguments.out, svg_map(city, options), written);
  return written;
}

void export_city(Arguments arguments, Context& context) {
  const City city = read_city(arguments.city);
  if (arguments.out.empty())
    arguments.out = arguments.city.stem().string() + (arguments.format == "svg"        ? ".svg"
                                                      : arguments.format == "portals"  ? ".prt"
                                                      : arguments.format == "obj"      ? ".obj"
                                                      : arguments.format == "cityjson" ? ".city.json"
                                                                                       : "-" + arguments.format);
  Written written;
  try {
    if (arguments.format == "svg") {
      written = write_map(city, arguments);
    } else if (arguments.format == "obj" || arguments.format == "cityjson") {
      write_renamed(arguments.out, arguments.format == "obj" ? obj_text(city) : cityjson_text(city), written);
    } else {
      if (city.sectors.empty()) throw CityError("the city has no sectors: there is nothing to walk in", kNothingUsable);
      written =
          arguments.format == "portals" ? write_portals(city, arguments) : write_folder(CityIndex(city), arguments);
    }
  } catch (const fs::filesystem_error& e) {
    throw CityError(std::string("cannot write the export: ") + e.what());
  }
  print_result(context,
               arguments.out.string() + ": " + std::to_string(written.files) + " files, " +
                   std::to_string(written.bytes) + " bytes\n",
               {{"path", arguments.out.string()},
                {"format", arguments.format},
                {"files", written.files},
                {"bytes", written.bytes}});
}

}  // namespace

void add_export(CLI::App& app, Context& context) {
  auto* command = new_command(app, context, "export",
                              "a city in other formats: a map, X3D, a web site, portals, solids, glTF, 3D Tiles",
                              "vicus export city.gpkg --format svg --labels -o city.svg\n"
                              "  vicus export city.gpkg --format svg --lvis r12 -o r12.svg");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("CITY", arguments->city, "a city made by vicus build")->required();
  command
      ->add_option("--format", arguments->format,
                   "svg: a map; x3d, vrml, x3dj: a folder, open city.* in it; site: a folder for a web server; "
                   "portals: convex cells and portals (PRT1) for other visibility programs, with OUT.json beside; "
                   "obj, cityjson: houses as closed solids; glb: a folder of sectors as binary glTF; 3dtiles: "
                   "the same as a tree for CesiumJS, tileset.json")
      ->required()
      ->check(CLI::IsMember(kFormats));
  command->add_option("-o,--output", arguments->out, "file or folder; else named after the city, here");
  command
      ->add_option_function<std::string>(
          "--coding",
          [arguments](const std::string& name) {
            arguments->glb.coding = name == "meshopt" ? GlbCoding::meshopt : GlbCoding::draco;
          },
          "glb, 3dtiles: draco (exact, smaller), meshopt (read faster)")
      ->check(CLI::IsMember({"draco", "meshopt"}));
  command->add_flag("--labels", arguments->has_labels, "svg: ids and names of sectors");
  command->add_option("--lvis", arguments->lvis, "svg: a sector's id; shows what it sees, and why");
  command->add_flag("--triangles", arguments->keeps_triangles, "portals: keep triangles, do not join them");
  command->add_option("--bbox", arguments->box_m, "svg: WEST,SOUTH,EAST,NORTH in metres from the city's origin")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--start", arguments->start, "id of the sector where a visitor starts");
  command->add_option("--x_ite", arguments->x_ite, "site: the folder of X_ITE: node_modules/x_ite");
  command->callback([&context, arguments] { export_city(*arguments, context); });
}

}  // namespace vicus::cli
