#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "city_db/issues.hpp"
#include "cli/command.hpp"
#include "cli/write_whole.hpp"
#include "sectorgen/sectors/tours/guide.hpp"
#include "x3d_export/tour_json.hpp"
#include "x3d_export/tour_scene.hpp"
#include "x3d_export/writers.hpp"

namespace vicus::cli {
namespace {

struct Arguments {
  std::filesystem::path city, x3d;
  TourQuery query;
};

std::string distance_text(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%5.0f m", m);
  return text;
}

std::string text_from(const Tour& tour) {
  std::string text = tour.name + ": " + std::to_string(std::lround(tour.length_m)) + " m, " +
                     std::to_string(std::max(1L, std::lround(tour.duration_s / 60))) + " min, " +
                     std::to_string(tour.sectors.size()) + " sectors\n";
  for (const auto& step : tour.steps) text += distance_text(step.walked_m) + "  " + step.text + "\n";
  return text;
}

std::string text_from(const std::vector<TourProposal>& proposals) {
  if (proposals.empty()) return "This city has no ready-made tours: too few sights bear a name.\n";
  std::string text;
  for (const auto& p : proposals) {
    text += p.id + ": " + p.name + "," + distance_text(p.length_m) + "\n";
    for (const auto& stop : p.stops) text += "  " + stop.name + "\n";
  }
  return text;
}

void show_tour(const Arguments& arguments, Context& context) {
  const Guide guide(arguments.city);
  const auto& query = arguments.query;
  if (query.from.empty() && query.tour.empty()) {
    const auto& proposals = guide.proposals();
    return print_result(context, text_from(proposals), nlohmann::json::parse(tour_proposals_json(proposals)));
  }
  const TourAnswer answer = guide.tour(query);
  if (const auto* failed = std::get_if<TourProblem>(&answer))
    throw CityError(failed->detail, failed->kind == TourProblem::Kind::nonsense ? kWrongUsage : kFailed);
  const auto& tour = std::get<Tour>(answer);
  if (!arguments.x3d.empty()) {
    const CityReader reader(arguments.city);
    const auto scene = tour_scene(source_of(reader), tour);
    if (!scene) throw CityError("the city " + arguments.city.string() + " changed while it was read");
    write_whole(arguments.x3d, write_x3d(*scene));
  }
  print_result(context, text_from(tour), nlohmann::json::parse(tour_json(tour)));
}

}  // namespace

void add_tour(CLI::App& app, Context& context) {
  auto* command = new_command(app, context, "tour", "the shortest walk between places, step by step",
                              "vicus tour city.gpkg --from \"Rue Haute 12\" --to \"Place du Marche\"");
  const auto arguments = std::make_shared<Arguments>();
  auto& query = arguments->query;
  const char* const kPlace = "a sector's id, a street's or house's name, or LAT,LON";
  command->add_option("CITY", arguments->city, "a city made by vicus build")->required();
  auto* from = command->add_option("--from", query.from, kPlace);
  command->add_option("--to", query.to, kPlace)->needs(from);
  command->add_option("--via", query.via, "a place to pass; may be given again")->needs(from);
  command->add_flag("--round", query.is_round, "back to the start")->needs(from);
  command->add_option("--tour", query.tour, "a ready-made tour; without --from and --tour they are listed")
      ->excludes(from);
  command->add_option("-o,--x3d", arguments->x3d, "also write a world that walks the tour by itself; beside sectors/");
  command->callback([&context, arguments] { show_tour(*arguments, context); });
}

}  // namespace vicus::cli
