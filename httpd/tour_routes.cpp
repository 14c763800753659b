#include "httpd/tour_routes.hpp"

#include <algorithm>
#include <charconv>

#include "httpd/answers.hpp"
#include "httpd/problem.hpp"
#include "x3d_export/tour_json.hpp"
#include "x3d_export/tour_scene.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

constexpr const char* kJson = "application/json";
constexpr const char* kNoDesk = "This server knows no ways and no names: it was started without them.";

/// A sentence when a parameter is wrong.
std::optional<std::string> read_tour_query(const Url& url, TourQuery& query) {
  for (const auto& [name, value] : url.query) {
    bool is_repeated = false;
    if (name != "via") parameter_of(url, name, is_repeated);
    if (is_repeated) return "Give the parameter " + name + " only once.";
    if (name == "from") {
      query.from = value;
    } else if (name == "to") {
      query.to = value;
    } else if (name == "via") {
      query.via.push_back(value);
    } else if (name == "tour") {
      query.tour = value;
    } else if (name == "round") {
      if (value != "0" && value != "1") return "round must be 1 (back to the start) or 0.";
      query.is_round = value == "1";
    } else {
      return "There is no parameter " + name + ". There are from, to, via, round and tour.";
    }
  }
  const bool has_stops = !query.from.empty() || !query.to.empty() || !query.via.empty();
  if (!query.tour.empty()) {
    if (has_stops || query.is_round) return "Give tour alone, or from and to.";
  } else if (query.from.empty() || (query.to.empty() && !query.is_round)) {
    return "Give from and to: each a sector's id, a street's or house's name, or LAT,LON.";
  }
  return std::nullopt;
}

int status_of(TourProblem::Kind kind) {
  switch (kind) {
    case TourProblem::Kind::nonsense:
      return 400;
    case TourProblem::Kind::unknown_place:
      return 404;
    case TourProblem::Kind::not_connected:
      return 409;
  }
  return 500;
}

}  // namespace

HttpResponse answer_tours(const HttpRequest& request, const Url& url, const CityReader& city, const TourDesk& desk) {
  if (!desk.tour) return problem(404, kNoDesk);
  const bool is_world = url.path.ends_with(".x3d");
  if (url.query.empty() && !is_world) return answer_made(request, kJson, tour_proposals_json(desk.proposals()));
  TourQuery query;
  if (const auto wrong = read_tour_query(url, query)) return problem(400, *wrong);
  const TourAnswer answer = desk.tour(query);
  if (const auto* failed = std::get_if<TourProblem>(&answer)) return problem(status_of(failed->kind), failed->detail);
  const auto& tour = std::get<Tour>(answer);
  if (!is_world) return answer_made(request, kJson, tour_json(tour));
  const auto scene = tour_scene(source_of(city), tour);
  if (!scene) return problem(404, "The city has changed while the tour was made. Ask again.");
  return answer_made(request, media_type_of(SceneFormat::x3d), write_x3d(*scene));
}

HttpResponse answer_search(const HttpRequest& request, const Url& url, const TourDesk& desk) {
  if (!desk.search) return problem(404, kNoDesk);
  std::string typed;
  std::size_t limit = kDefaultResults;
  for (const auto& [name, value] : url.query) {
    bool is_repeated = false;
    parameter_of(url, name, is_repeated);
    if (is_repeated) return problem(400, "Give the parameter " + name + " only once.");
    if (name == "q") {
      typed = value;
    } else if (name == "limit") {
      const auto [rest, error] = std::from_chars(value.data(), value.data() + value.size(), limit);
      if (error != std::errc() || rest != value.data() + value.size() || limit < 1 || limit > kMostResults)
        return problem(400, "limit must be a whole number from 1 to " + std::to_string(kMostResults) + ".");
    } else {
      return problem(400, "There is no parameter " + name + ". There are q and limit.");
    }
  }
  if (typed.empty() || typed.size() > kMostSearched_bytes)
    return problem(400,
                   "Give q: a name, or its beginning, in at most " + std::to_string(kMostSearched_bytes) + " bytes.");
  return answer_made(request, kJson, places_json(typed, desk.search(typed, limit)));
}

}  // namespace vicus
