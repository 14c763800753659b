#include "x3d_export/tour_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, double steps) { return std::round(value * steps) / steps; }
double millimetres(double m) { return rounded(m, 1e3); }
Json plan_json(PlanPoint p) { return Json::array({metres(p.x), metres(p.y)}); }

Json place_json(const TourPlace& place) {
  return {{"name", place.name},
          {"kind", place.kind},
          {"detail", place.detail},
          {"sector", place.sector_id},
          {"at", plan_json(place.at)},
          {"look", plan_json(place.look)},
          {"ground", millimetres(place.ground_m)},
          {"lat", rounded(place.degrees.lat_deg, 1e7)},
          {"lon", rounded(place.degrees.lon_deg, 1e7)}};
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string tour_json(const Tour& tour) {
  Json stops = Json::array(), sectors = Json::array(), steps = Json::array(), views = Json::array(),
       points = Json::array();
  for (const auto& stop : tour.stops) stops.push_back(place_json(stop));
  for (const auto& s : tour.sectors)
    sectors.push_back({{"id", s.id}, {"name", s.name}, {"walked", millimetres(s.walked_m)}});
  for (const auto& s : tour.steps)
    steps.push_back({{"turn", name_of(s.turn)},
                     {"text", s.text},
                     {"street", s.street},
                     {"walked", millimetres(s.walked_m)},
                     {"length", millimetres(s.length_m)}});
  for (const auto& v : tour.viewpoints)
    views.push_back({{"id", v.id},
                     {"sector", v.sector_id},
                     {"name", v.name},
                     {"at", plan_json(v.at)},
                     {"ground", millimetres(v.ground_m)},
                     {"eye", millimetres(v.eye_m)},
                     {"heading", rounded(v.heading_deg, 10)},
                     {"walked", millimetres(v.walked_m)}});
  for (const auto& p : tour.points)
    points.push_back(Json::array({metres(p.at.x), metres(p.at.y), millimetres(p.ground_m), millimetres(p.walked_m)}));
  return text_of({{"name", tour.name},
                  {"length", millimetres(tour.length_m)},
                  {"duration", rounded(tour.duration_s, 10)},
                  {"stops", std::move(stops)},
                  {"sectors", std::move(sectors)},
                  {"steps", std::move(steps)},
                  {"viewpoints", std::move(views)},
                  {"points", std::move(points)}});
}

std::string tour_proposals_json(const std::vector<TourProposal>& proposals) {
  Json tours = Json::array();
  for (const auto& p : proposals) {
    Json stops = Json::array();
    for (const auto& stop : p.stops) stops.push_back(place_json(stop));
    tours.push_back({{"id", p.id},
                     {"name", p.name},
                     {"length", millimetres(p.length_m)},
                     {"duration", rounded(p.duration_s, 10)},
                     {"stops", std::move(stops)},
                     {"href", "/tours?tour=" + p.id}});
  }
  return text_of({{"tours", std::move(tours)}});
}

std::string places_json(const std::string& typed, const std::vector<TourPlace>& places) {
  Json results = Json::array();
  for (const auto& place : places) results.push_back(place_json(place));
  return text_of({{"query", typed}, {"results", std::move(results)}});
}

}  // namespace vicus
