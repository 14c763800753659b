#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "city_db/issues.hpp"
#include "cli/command.hpp"
#include "cli/measure_codecs.hpp"
#include "cli/measure_forms.hpp"
#include "cli/measure_report.hpp"
#include "cli/measure_run.hpp"
#include "cli/write_whole.hpp"
#include "sectorgen/bake/webp_image.hpp"

namespace vicus::cli {
namespace {

namespace fs = std::filesystem;
using namespace measure;

struct Arguments {
  fs::path city, out = "report";
  std::size_t views = 60;
  std::vector<std::string> sizes, forms;
  std::vector<double> taus = {2, 4, 8, 16, 32};
  std::uint64_t seed = 1;
  int samples = 4;
  unsigned threads = 0;
  bool has_codecs = true, is_redrawn = false;
};

PictureSize size_of(const std::string& text) {
  PictureSize size;
  constexpr int kLeast = 32, kMost = 8192;
  unsigned long views = 0;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d:%lu%c", &size.width, &size.height, &views, &rest);
  if ((read != 2 && read != 3) || (read == 2 && text.find(':') != std::string::npos) || size.width < kLeast ||
      size.height < kLeast || size.width > kMost || size.height > kMost || (read == 3 && views == 0))
    throw CityError(
        "--size " + text +
            ": expected WIDTHxHEIGHT or WIDTHxHEIGHT:VIEWS, 32 to 8192 pixels a side, such as 640x480 or 1920x1080:6",
        kWrongUsage);
  if (read == 3) size.views = views;
  return size;
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw CityError("cannot read " + path.string() + ": --redraw needs the folder of an earlier run");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

RgbImage rgb_of(const Picture& picture) {
  RgbImage image(static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height));
  for (std::size_t i = 0; i < 3 * picture.pixels.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(picture.pixels[i / 3][i % 3], 0.0f, 1.0f)));
  return image;
}

void say(const Context& context, const std::string& text) {
  if (!context.quiet && isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "measure: %s\n", text.c_str());
}

void write_rows(const fs::path& folder, const Measured& measured) {
  write_whole(folder / "views.csv", csv_of(measured.views));
  write_whole(folder / "times.csv", csv_of(measured.times));
  write_whole(folder / "pops.csv", csv_of(measured.pops));
}

RunFacts facts_of(const RunOptions& options, const City& city, const Course& course) {
  RunFacts facts = facts_of_machine();
  facts.city = options.city_name;
  facts.version = options.version;
  facts.seed = options.seed;
  facts.samples = options.samples;
  facts.houses = city.buildings.size();
  facts.sectors = city.sectors.size();
  facts.walk_name = course.tour().name;
  facts.walk_m = course.tour().length_m;
  facts.fly_radius_m = course.fly_radius_m();
  return facts;
}

void measure(const Arguments& a, Context& context) {
  constexpr int kPictureQuality = 82;
  RunOptions options;
  options.walk_views = (a.views + 1) / 2;
  options.fly_views = a.views / 2;
  options.sizes.clear();
  for (const std::string& text : a.sizes) options.sizes.push_back(size_of(text));
  options.samples = a.samples;
  options.threads = a.threads;
  options.seed = a.seed;
  options.version = VICUS_VERSION;
  const auto makers = form_makers(a.forms, a.taus);
  SharedCity city(a.city);
  const auto name = city.city().meta.find("name");
  options.city_name = name != city.city().meta.end() && !name->second.empty() ? name->second : a.city.stem().string();
  fs::create_directories(a.out / "pictures");
  say(context, "the truth at " + std::to_string(a.views) + " key views");
  Course course(city, options);
  const auto keep = [&](const KeptPicture& p) {
    write_whole(a.out / picture_path(p.path, p.view, p.family, p.setting),
                encode_webp(rgb_of(p.picture), kPictureQuality));
  };
  course.keep_truth(keep);
  write_whole(a.out / "run.json", json_of(facts_of(options, city.city(), course)));
  write_whole(a.out / "codecs.csv", csv_of(std::vector<CodecRow>()));
  Measured measured;
  for (const FormMaker& maker : makers) {
    const Form form = maker.make(city);
    say(context, form->name().full());
    course.run(*form, measured, keep);
    write_rows(a.out, measured);  // who stops a long run keeps what is there, and --redraw shows it
  }
  std::vector<CodecRow> codecs;
  if (a.has_codecs) {
    say(context, "codecs at equal FLIP");
    codecs = compare_codecs(city, course, options);
  }
  write_whole(a.out / "codecs.csv", csv_of(codecs));
  write_whole(a.out / "run.json", json_of(facts_of(options, city.city(), course)));  // the load when it ended
}

void report(const Arguments& a, Context& context) {
  Results results;
  results.facts = facts_from_json(read_file(a.out / "run.json"));
  results.views = views_from_csv(read_file(a.out / "views.csv"));
  results.times = times_from_csv(read_file(a.out / "times.csv"));
  results.pops = pops_from_csv(read_file(a.out / "pops.csv"));
  results.codecs = codecs_from_csv(read_file(a.out / "codecs.csv"));
  const auto picture = [&](const std::string& path) {
    std::ifstream in(a.out / path, std::ios::binary);
    std::ostringstream bytes;
    if (in) bytes << in.rdbuf();
    return bytes.str();
  };
  fs::create_directories(a.out / "plots");
  for (const auto& [path, svg] : plots_of(results)) write_whole(a.out / path, svg);
  write_whole(a.out / "index.html", page_of(results, picture));
  const fs::path page = a.out / "index.html";
  std::set<std::string> forms;
  for (const ViewRow& row : results.views) forms.insert(row.family + row.setting);
  print_result(context,
               page.string() + ": " + std::to_string(forms.size()) + " representations, " +
                   std::to_string(results.views.size()) + " pictures measured, seed " +
                   std::to_string(results.facts.seed) + "\n",
               {{"path", page.string()},
                {"representations", forms.size()},
                {"pictures", results.views.size()},
                {"pops", results.pops.size()},
                {"seed", results.facts.seed},
                {"pareto", nlohmann::json::parse(best_json(results))}});
}

}  // namespace

void add_measure(CLI::App& app, Context& context) {
  auto* command = new_command(
      app, context, "measure", "speed against error of every way to send and show a city: CSV, plots and one page",
      "vicus measure city.gpkg -o report --views 60 --size 640x480 --size 1920x1080:6 --as lod3,page,prisms");
  const auto a = std::make_shared<Arguments>();
  std::string keys;
  for (const std::string& key : form_keys()) keys += (keys.empty() ? "" : ", ") + key;
  command->add_option("CITY", a->city, "a city made by vicus build")->required();
  command->add_option("-o,--output", a->out, "folder of the report")->capture_default_str();
  command->add_option("--views", a->views, "key views, half of them on the walk, half in flight")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  command
      ->add_option("--size", a->sizes,
                   "WIDTHxHEIGHT of the pictures, :VIEWS of each path's key views; may be given again")
      ->default_str("640x480 1920x1080:4");
  command->add_option("--as", a->forms, "of these only, with commas: " + keys)->delimiter(',');
  command->add_option("--tau", a->taus, "pixels of error asked for, with commas, where a representation has a tree")
      ->delimiter(',')
      ->check(CLI::Range(0.01, 10000.0))
      ->capture_default_str();
  command->add_option("--seed", a->seed, "where the walk leads")->capture_default_str();
  command->add_option("--samples", a->samples, "rays a pixel: the next square number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--threads", a->threads, "0: all cores");
  command->add_flag("!--no-codecs", a->has_codecs, "leave the comparison of codecs out");
  command->add_flag("--redraw", a->is_redrawn, "measure nothing: plots and page again from the folder's CSV files");
  command->callback([a, &context] {
    if (a->sizes.empty()) a->sizes = {"640x480", "1920x1080:4"};
    if (!a->is_redrawn) measure(*a, context);
    report(*a, context);
  });
}

}  // namespace vicus::cli
