#include "httpd/sector_routes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "httpd/answers.hpp"
#include "httpd/media_types.hpp"
#include "httpd/negotiate.hpp"
#include "httpd/problem.hpp"

namespace vicus {
namespace {

/// The formats one can ask for without a suffix, first choice first.
constexpr std::array<const char*, 5> kSuffixes = {".x3d", ".wrl", ".x3dj", ".glb", ".json"};

bool is_id(const std::string& id) {
  return !id.empty() && id.size() <= 200 && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// The path with the suffix whose media type the client likes best, among those stored.
HttpResponse answer_by_accept(const HttpRequest& request, const CityReader& city, const std::string& path) {
  std::vector<std::string> media_types;
  std::string listed;
  for (const char* suffix : kSuffixes) {
    if (city.artefact_codings(path + suffix).empty()) continue;
    media_types.emplace_back(media_type_of_file(suffix));
    listed += (listed.empty() ? "" : ", ") + media_types.back();
  }
  const auto wanted = preferred_media_type(field_of(request.fields, "Accept"), media_types);
  if (!wanted) return problem(400, "The Accept field is not a list of media ranges. Leave it out, or send */*.");
  if (wanted->empty()) return not_acceptable(listed);
  const auto suffix = std::find_if(kSuffixes.begin(), kSuffixes.end(),
                                   [&](const char* s) { return media_type_of_file(s) == *wanted; });
  auto response = answer_artefact(request, city, path + *suffix).value();
  response.fields.emplace_back("Content-Location", "/" + path + *suffix);
  return response;
}

std::string formats_of(const CityReader& city, const std::string& id) {
  std::string listed;
  for (const char* suffix : {".x3d", ".far.x3d", ".wrl", ".x3dj", ".glb", ".json"})
    if (!city.artefact_codings("sectors/" + id + suffix).empty()) listed += " /sectors/" + id + suffix;
  return listed.empty() ? " nothing: build the city again" : listed;
}

}  // namespace

HttpResponse answer_root(const HttpRequest& request, const Url& url, const CityReader& city) {
  if (auto artefact = answer_artefact(request, city, url.path.substr(1))) return *std::move(artefact);
  return problem(404, "There is no root world " + url.path + ". There are /city.x3d and /city.wrl.");
}

HttpResponse answer_sector(const HttpRequest& request, const CityReader& city, const std::string& name) {
  const auto dot = std::min(name.find('.'), name.size());
  const auto id = name.substr(0, dot);
  if (!is_id(id))
    return problem(400, "'" + id + "' is no sector id: ids have letters, digits, '-' and '_'. Ask "
                        "/collections/sectors/items for those there are.");
  const auto path = "sectors/" + name;
  if (dot < name.size())
    if (auto artefact = answer_artefact(request, city, path)) return *std::move(artefact);
  if (!city.sector(id))
    return problem(404, "There is no sector " + id + ". Ask /collections/sectors/items for those there are.");
  if (dot == name.size() && !city.artefact_codings(path + ".x3d").empty()) return answer_by_accept(request, city, path);
  return problem(404, "Sector " + id + " has no " + name.substr(dot) + ". It has:" + formats_of(city, id));
}

}  // namespace vicus
