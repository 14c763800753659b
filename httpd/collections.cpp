#include "httpd/collections.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "city_db/issues.hpp"
#include "httpd/answers.hpp"
#include "httpd/features.hpp"
#include "httpd/geo_json.hpp"
#include "httpd/problem.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kDefaultLimit = 10, kMaxLimit = 10000;  // OGC 17-069r4 §7.15.2
constexpr const char* kJson = "application/json";
constexpr const char* kGeoJson = "application/geo+json";

Json link(const std::string& rel, const std::string& type, const std::string& href, const std::string& title) {
  return {{"href", href}, {"rel", rel}, {"type", type}, {"title", title}};
}

HttpResponse answer_json(const HttpRequest& request, const char* media_type, const Json& json) {
  return answer_made(request, media_type, json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json describe(const Collection& collection) {
  const auto path = std::string("/collections/") + collection.name;
  return {{"id", collection.name},
          {"title", collection.title},
          {"description", collection.description},
          {"itemType", "feature"},
          {"crs", Json::array({"http://www.opengis.net/def/crs/OGC/1.3/CRS84"})},
          {"links", Json::array({link("self", kJson, path, collection.title),
                                 link("items", kGeoJson, path + "/items", collection.title)})}};
}

struct ItemsQuery {
  std::optional<GeoBox> box;
  std::size_t limit = kDefaultLimit, offset = 0;
  std::string box_text;
};

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Fills the query; a sentence when a parameter is wrong (OGC 17-069r4 §7.4: unknown ones are 400 too).
std::optional<std::string> read_query(const Url& url, ItemsQuery& query) {
  for (const auto& [name, value] : url.query) {
    bool repeated = false;
    parameter_of(url, name, repeated);
    if (repeated) return "Give the parameter " + name + " only once.";
    if (name == "bbox") {
      query.box = parse_geo_box(value);
      query.box_text = value;
      if (!query.box) return "bbox must be west,south,east,north in degrees, such as bbox=2.33,48.88,2.35,48.89.";
    } else if (name == "limit") {
      const auto limit = whole_number(value);
      if (!limit || *limit == 0) return "limit must be a whole number from 1 to " + std::to_string(kMaxLimit) + ".";
      query.limit = std::min(*limit, kMaxLimit);
    } else if (name == "offset") {
      const auto offset = whole_number(value);
      if (!offset || *offset > 1'000'000'000) return "offset must be a whole number from 0 to 1000000000.";
      query.offset = *offset;
    } else if (name != "datetime" &&
               name != "f") {  // no feature has a time, so every time matches; f=json is what we give
      return "There is no parameter " + name + ". There are bbox, limit and offset.";
    }
  }
  return std::nullopt;
}

LatLon origin_of(const CityReader& city) {
  const auto degrees = [&](const char* key) {
    const auto text = city.meta(key).value_or("");
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || rest != text.data() + text.size())
      throw CityError(std::string("meta ") + key + " is '" + text + "', expected degrees");
    return value;
  };
  return {degrees("origin_lat"), degrees("origin_lon")};
}

Json feature_json(const Collection& collection, const GeoFrame& frame, const Feature& feature) {
  return {{"type", "Feature"},
          {"id", feature.id},
          {"geometry", collection.is_area ? frame.geometry_of(feature.area) : frame.geometry_of(feature.line)},
          {"properties", feature.properties}};
}

std::string items_href(const Collection& collection, const ItemsQuery& query, std::size_t offset) {
  auto href = std::string("/collections/") + collection.name + "/items?limit=" + std::to_string(query.limit) +
              "&offset=" + std::to_string(offset);
  if (query.box) href += "&bbox=" + encode_url_part(query.box_text);
  return href;
}

HttpResponse answer_items(const HttpRequest& request, const Url& url, const CityReader& city,
                          const Collection& collection) {
  ItemsQuery query;
  if (const auto wrong = read_query(url, query)) return problem(400, *wrong);
  const GeoFrame frame(origin_of(city));
  PlanBox box{{-kPlanLimit, -kPlanLimit}, {kPlanLimit, kPlanLimit}};
  if (query.box) box = frame.plan_box_around(*query.box);
  Json features = Json::array();
  auto at = query.offset;
  bool has_more = false;
  while (!box.is_empty() && !has_more) {
    const auto found = collection.fetch(city, box, query.limit - features.size() + 1, at);
    for (const auto& feature : found) {
      if (features.size() == query.limit) {
        has_more = true;
        break;
      }
      ++at;
      const auto meets = [&] {
        return collection.is_area ? frame.meets(feature.area, *query.box) : frame.meets(feature.line, *query.box);
      };
      if (!query.box || meets()) features.push_back(feature_json(collection, frame, feature));
    }
    if (found.empty()) break;
  }
  Json links =
      Json::array({link("self", kGeoJson, items_href(collection, query, query.offset), "this page"),
                   link("collection", kJson, std::string("/collections/") + collection.name, collection.title)});
  if (has_more) links.push_back(link("next", kGeoJson, items_href(collection, query, at), "next page"));
  const auto count = features.size();
  return answer_json(request, kGeoJson,
                     {{"type", "FeatureCollection"},
                      {"features", std::move(features)},
                      {"numberReturned", count},
                      {"links", std::move(links)}});
}

HttpResponse answer_item(const HttpRequest& request, const CityReader& city, const Collection& collection,
                         const std::string& id) {
  const auto feature = collection.find(city, id);
  if (!feature)
    return problem(404, "Collection " + std::string(collection.name) + " has no item " + id + ". Ask /collections/" +
                            collection.name + "/items for those there are.");
  auto json = feature_json(collection, GeoFrame(origin_of(city)), *feature);
  const auto path = std::string("/collections/") + collection.name;
  json["links"] = Json::array({link("self", kGeoJson, path + "/items/" + encode_url_part(id), id),
                               link("collection", kJson, path, collection.title)});
  for (const auto& [media_type, href] : feature->alternates)
    json["links"].push_back(link("alternate", media_type, href, id));
  return answer_json(request, kGeoJson, json);
}

HttpResponse answer_conformance(const HttpRequest& request) {
  const std::string base = "http://www.opengis.net/spec/ogcapi-features-1/1.0/conf/";
  return answer_json(request, kJson, {{"conformsTo", Json::array({base + "core", base + "geojson"})}});
}

}  // namespace

HttpResponse answer_landing(const HttpRequest& request) {
  return answer_json(
      request, kJson,
      {{"title", "Vicus"},
       {"description", "A city to walk through, and its records"},
       {"links",
        Json::array({link("self", kJson, "/", "this document"), link("alternate", "text/html", "/", "the city"),
                     link("service-desc", "application/vnd.oai.openapi+json;version=3.0", "/api", "the API"),
                     link("conformance", kJson, "/conformance", "conformance classes"),
                     link("data", kJson, "/collections", "records"),
                     link("item", "model/x3d+xml", "/city.x3d", "the root world")})}});
}

HttpResponse answer_collections(const HttpRequest& request, const Url& url, const CityReader& city) {
  if (url.path == "/conformance") return answer_conformance(request);
  std::string rest = url.path.substr(std::string("/collections").size());
  if (rest.empty() || rest == "/") {
    Json all = Json::array();
    for (const auto& collection : collections()) all.push_back(describe(collection));
    return answer_json(
        request, kJson,
        {{"links", Json::array({link("self", kJson, "/collections", "records")})}, {"collections", std::move(all)}});
  }
  rest.erase(0, 1);
  const auto slash = std::min(rest.find('/'), rest.size());
  const auto name = rest.substr(0, slash);
  const auto& all = collections();
  const auto collection = std::find_if(all.begin(), all.end(), [&](const Collection& c) { return name == c.name; });
  if (collection == all.end())
    return problem(404, "There is no collection " + name + ". There are sectors, gates, houses and interiors.");
  rest.erase(0, slash);
  if (rest.empty()) return answer_json(request, kJson, describe(*collection));
  if (rest == "/items") return answer_items(request, url, city, *collection);
  if (rest.starts_with("/items/")) return answer_item(request, city, *collection, rest.substr(7));
  return problem(404,
                 "Collection " + name + " has no " + rest + ". Its records are at /collections/" + name + "/items.");
}

}  // namespace vicus
