#include <nlohmann/json.hpp>

#include "httpd/answers.hpp"
#include "httpd/collections.hpp"
#include "httpd/features.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

Json answers(const char* media_type, const char* what) {
  return {{"200", {{"description", what}, {"content", {{media_type, {{"schema", {{"type", "object"}}}}}}}}},
          {"default",
           {{"description", "a problem (RFC 9457) that says what to do"},
            {"content", {{"application/problem+json", {{"schema", {{"type", "object"}}}}}}}}}};
}

Json path_parameter(const char* name, Json schema) {
  return {{"name", name}, {"in", "path"}, {"required", true}, {"schema", std::move(schema)}};
}

Json query_parameter(const char* name, const char* what, Json schema) {
  return {{"name", name}, {"in", "query"}, {"required", false}, {"description", what}, {"schema", std::move(schema)}};
}

Json get(const char* id, const char* media_type, const char* what, Json parameters = Json::array()) {
  return {
      {"get", {{"operationId", id}, {"parameters", std::move(parameters)}, {"responses", answers(media_type, what)}}}};
}

}  // namespace

HttpResponse answer_api(const HttpRequest& request) {
  Json names = Json::array();
  for (const auto& collection : collections()) names.push_back(collection.name);
  const auto collection = path_parameter("collectionId", {{"type", "string"}, {"enum", names}});
  const Json numbers = {{"type", "array"}, {"minItems", 4}, {"maxItems", 6}, {"items", {{"type", "number"}}}};
  auto bbox = query_parameter("bbox", "west,south,east,north in degrees (CRS84)", numbers);
  bbox["style"] = "form";
  bbox["explode"] = false;
  const auto limit = query_parameter("limit", "features per page",
                                     {{"type", "integer"}, {"minimum", 1}, {"maximum", 10000}, {"default", 10}});
  const auto offset = query_parameter("offset", "where the page begins, as the link next gives it",
                                      {{"type", "integer"}, {"minimum", 0}, {"default", 0}});
  const auto datetime = query_parameter("datetime", "no feature has a time: every time matches", {{"type", "string"}});
  Json paths;
  paths["/"] = get("getLandingPage", "application/json", "links to everything else");
  paths["/conformance"] = get("getConformance", "application/json", "conformance classes");
  paths["/collections"] = get("getCollections", "application/json", "sectors, gates, houses, interiors");
  paths["/collections/{collectionId}"] =
      get("describeCollection", "application/json", "one collection", Json::array({collection}));
  paths["/collections/{collectionId}/items"] = get("getFeatures", "application/geo+json", "a page of features",
                                                   Json::array({collection, bbox, limit, offset, datetime}));
  paths["/collections/{collectionId}/items/{featureId}"] =
      get("getFeature", "application/geo+json", "one feature",
          Json::array({collection, path_parameter("featureId", {{"type", "string"}})}));
  const auto text = [](const char* name, const char* what) {
    return query_parameter(name, what, {{"type", "string"}});
  };
  paths["/parcels"] =
      get("getParcel", "application/x-ndjson", "X3D files of many sectors: a line that lists them, then one line each",
          Json::array({text("files", "ID, ID.far, ID.tall, separated by commas"),
                       text("without", "images too, but those whose names begin so; may be empty")}));
  paths["/search"] = get("search", "application/json", "streets, squares, houses, rooms, shops and sights by name",
                         Json::array({text("q", "a name, accents and typing errors forgiven")}));
  paths["/tours"] =
      get("getTour", "application/json", "the shortest walk, step by step; without parameters, ready ones",
          Json::array({text("from", "a sector's id, a name, or LAT,LON"), text("to", "the same"),
                       text("via", "the same; may be repeated")}));
  const Json api = {{"openapi", "3.0.3"},
                    {"info", {{"title", "Vicus"}, {"description", "A city's records"}, {"version", "1"}}},
                    {"paths", std::move(paths)}};
  return answer_made(request, "application/vnd.oai.openapi+json;version=3.0", api.dump() + "\n");
}

}  // namespace vicus
