#include <cstdio>
#include <filesystem>
#include <memory>

#include "city_db/store.hpp"
#include "city_db/surroundings.hpp"
#include "cli/city_mesh.hpp"
#include "cli/command.hpp"
#include "cli/write_whole.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace vicus::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path city, out, depth;
  std::string eye, look, size = "960x600", as = "truth";
  double field_of_view = kFieldOfView;
  int samples = 16;
  unsigned threads = 0;
};

Enu place_of(const std::string& option, const std::string& text) {
  Enu place;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &place.east, &place.north, &place.up, &rest) != 3 ||
      !(std::abs(place.east) < 1e6) || !(std::abs(place.north) < 1e6) || !(std::abs(place.up) < 1e6))
    throw CityError(
        option + " " + text + ": expected EAST,NORTH,UP in metres from the city's origin, such as 12.5,-40,1.7",
        kWrongUsage);
  return place;
}

void read_size(const std::string& text, RenderOptions& options) {
  constexpr int kMost = 16384;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &options.width, &options.height, &rest) != 2 || options.width < 1 ||
      options.height < 1 || options.width > kMost || options.height > kMost)
    throw CityError("--size " + text + ": expected WIDTHxHEIGHT in pixels, up to 16384, such as 960x600", kWrongUsage);
}

/// The images as the file has them.
ImageSource images_of(const CityReader& reader, const fs::path& city) {
  return [&reader, city](const std::string& id) {
    const std::string path = "textures/" + id + ".png";
    auto image = reader.artefact(path, {"identity"});
    if (!image) throw CityError(city.string() + " lacks " + path + ": build the city again");
    return std::move(image->body);
  };
}

CityMeshOptions mesh_options(const std::string& as) {
  CityMeshOptions options;
  options.is_as_sent = as != "truth";
  if (options.is_as_sent) options.level = as.back() - '0';
  return options;
}

void render_city(const Arguments& arguments, Context& context) {
  RenderOptions options;
  options.samples = arguments.samples;
  options.threads = arguments.threads;
  read_size(arguments.size, options);
  const Enu eye = place_of("--eye", arguments.eye), look = place_of("--look", arguments.look);
  if (eye.east == look.east && eye.north == look.north && eye.up == look.up)
    throw CityError("--eye and --look are the same place: look somewhere else", kWrongUsage);
  const City city = read_city(arguments.city);
  const CityReader reader(arguments.city);
  const CityIndex index(city);
  const RayScene scene(city_mesh(index, images_of(reader, arguments.city), mesh_options(arguments.as)));
  const View view =
      render(scene, camera_at(eye, look, arguments.field_of_view, options.width, options.height), options);
  write_whole(arguments.out, png_text(view.colour));
  if (!arguments.depth.empty()) write_whole(arguments.depth, pfm_text(view.depth));
  nlohmann::json object = {{"path", arguments.out.string()},
                           {"width", options.width},
                           {"height", options.height},
                           {"triangles", scene.mesh().triangles.size()}};
  if (!arguments.depth.empty()) object["depth"] = arguments.depth.string();
  print_result(context,
               arguments.out.string() + ": " + arguments.size + ", " + std::to_string(scene.mesh().triangles.size()) +
                   " triangles\n",
               object);
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
  auto* command =
      new_command(app, context, "render", "a picture of the city from any place, by ray tracing",
                  "vicus render city.gpkg --eye 0,0,1.7 --look 10,4,3 --size 960x600 --as truth -o view.png");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("CITY", arguments->city, "a city made by vicus build")->required();
  command->add_option("--eye", arguments->eye, "EAST,NORTH,UP of the eye, metres in the plan frame")->required();
  command->add_option("--look", arguments->look, "EAST,NORTH,UP of the place it looks at")->required();
  command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command->add_option("--as", arguments->as, "truth: all facades in their finest level; lod1 ... lod4: all in that one")
      ->check(CLI::IsMember({"truth", "lod1", "lod2", "lod3", "lod4"}))
      ->capture_default_str();
  command->add_option("--samples", arguments->samples, "rays a pixel: the next square number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--field-of-view", arguments->field_of_view, "rad, of the smaller side")
      ->check(CLI::Range(0.01, 3.0))
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "0: all cores");
  command->add_option("-o,--output", arguments->out, "the picture, PNG")->required();
  command->add_option("--depth", arguments->depth, "metres ahead of the eye as a portable float map (PFM)");
  command->callback([arguments, &context] { render_city(*arguments, context); });
}

}  // namespace vicus::cli
