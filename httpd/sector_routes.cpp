#include "httpd/sector_routes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "httpd/answers.hpp"
#include "httpd/media_types.hpp"
#include "httpd/negotiate.hpp"
#include "httpd/parcels.hpp"
#include "httpd/problem.hpp"
#include "x3d_export/flyover_scene.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

/// The formats one can ask for without a suffix, first choice first.
constexpr std::array<const char*, 5> kSuffixes = {".x3d", ".wrl", ".x3dj", ".glb", ".json"};

constexpr int kMaxLevel = 3;  // rings of a static world: more is thousands of sectors in one scene

/// Formats that few ask for are not stored: they are written from the records when somebody does.
constexpr std::array kWritten = {SceneFormat::vrml, SceneFormat::x3dj};
constexpr const char* kGlb = ".glb";

std::optional<SceneFormat> written_format(const std::string& name) {
  for (const auto format : kWritten)
    if (name.ends_with(suffix_of(format))) return format;
  return std::nullopt;
}

constexpr std::string_view kSectors = "sectors/";

/// Is there a file `path` + `suffix`, stored or to be written? Needs   the path of a sector that exists.
bool has_format(const CityReader& city, const std::string& path, const std::string& suffix) {
  const bool is_written = written_format(suffix) || suffix == kGlb;
  return (is_written && city.sector(path.substr(kSectors.size()))) || !city.artefact_codings(path + suffix).empty();
}

std::string image_of(const CityReader& city, const std::string& id) {
  auto image = city.artefact("textures/" + id + ".png", {"identity"});
  if (!image) throw CityError("the city has no texture " + id + ": build it again");
  return std::move(image->body);
}

/// The sector's file of this name ("r12.wrl", "r12.glb", "r12.2.wrl") written from the records; nullopt: there is none.
std::optional<HttpResponse> answer_written(const HttpRequest& request, const CityReader& city, const std::string& id,
                                           const std::string& name) {
  const auto format = written_format(name);
  const bool is_glb = name == id + kGlb;
  if (!format && !is_glb) return std::nullopt;
  const auto around = city_around(city, id);
  if (!around) return std::nullopt;
  if (is_glb)
    return answer_made(request, std::string(media_type_of_file(kGlb)),
                       sector_glb(CityIndex(*around), around->sectors.front(), Detail::near,
                                  [&](const std::string& image) { return image_of(city, image); }));
  for (auto& file : sector_files(CityIndex(*around), around->sectors.front(), Detail::near, *format))
    if (file.path == "sectors/" + name) return answer_made(request, file.media_type, std::move(file.text));
  return std::nullopt;
}

/// The path with the suffix whose media type the client likes best, among those there are.
HttpResponse answer_by_accept(const HttpRequest& request, const CityReader& city, const std::string& id) {
  const auto path = "sectors/" + id;
  std::vector<std::string> media_types;
  std::string listed;
  for (const char* suffix : kSuffixes) {
    if (!has_format(city, path, suffix)) continue;
    media_types.emplace_back(media_type_of_file(suffix));
    listed += (listed.empty() ? "" : ", ") + media_types.back();
  }
  const auto wanted = preferred_media_type(field_of(request.fields, "Accept"), media_types);
  if (!wanted) return problem(400, "The Accept field is not a list of media ranges. Leave it out, or send */*.");
  if (wanted->empty()) return not_acceptable(listed);
  const auto suffix =
      std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](const char* s) { return media_type_of_file(s) == *wanted; });
  auto response = answer_artefact(request, city, path + *suffix);
  if (!response) response = answer_written(request, city, id, id + *suffix);
  if (!response) return problem(404, "Sector " + id + " has no " + *suffix + ".");
  response->fields.emplace_back("Content-Location", "/" + path + *suffix);
  return *std::move(response);
}

std::string formats_of(const CityReader& city, const std::string& id) {
  std::string listed;
  for (const char* suffix : {".x3d", ".far.x3d", ".tall.x3d", ".wrl", ".x3dj", ".glb", ".json"})
    if (has_format(city, "sectors/" + id, suffix)) listed += " /sectors/" + id + suffix;
  return listed.empty() ? " nothing: build the city again" : listed;
}

constexpr std::array kFormats = {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj};

/// By the path's suffix, or for "/city" by Accept. Null: there is no such path; nullopt: nothing suits.
std::optional<const SceneFormat*> format_of(const HttpRequest& request, const std::string& path) {
  std::vector<std::string> media_types;
  for (const auto& format : kFormats) {
    if (path == std::string("/city") + suffix_of(format)) return &format;
    media_types.emplace_back(media_type_of(format));
  }
  if (path != "/city") return nullptr;
  const auto wanted = preferred_media_type(field_of(request.fields, "Accept"), media_types);
  for (const auto& format : kFormats)
    if (wanted == media_type_of(format)) return &format;
  return std::nullopt;
}

/// A sentence when a parameter is wrong.
std::optional<std::string> read_root_query(const Url& url, RootOptions& options) {
  for (const auto& [name, value] : url.query) {
    bool repeated = false;
    parameter_of(url, name, repeated);
    if (repeated) return "Give the parameter " + name + " only once.";
    if (name == "start") {
      if (!is_sector_id(value)) return "start must be a sector id: letters, digits, '-' and '_'.";
      options.start = value;
    } else if (name == "static") {
      if (value != "0" && value != "1") return "static must be 1 (all sectors loaded, no script) or 0.";
      options.is_static = value == "1";
    } else if (name == "i") {
      if (value.size() != 1 || value[0] < '0' || value[0] > '0' + kMaxLevel)
        return "i must be a whole number from 0 to " + std::to_string(kMaxLevel) + ": rings of sectors.";
      options.level = value[0] - '0';
      options.loader_level = value;
    } else if (name == "test") {
      if (value != "polygon" && value != "box" && value != "gate")
        return "test must be polygon, box or gate: how the visitor's sector is found.";
      options.loader_test = value;
    }
  }
  return std::nullopt;
}

}  // namespace

bool is_sector_id(const std::string& id) {
  return !id.empty() && id.size() <= 200 && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

HttpResponse answer_flyover(const HttpRequest& request, const CityReader& city) {
  return answer_made(request, media_type_of(SceneFormat::x3d), write_x3d(flyover_scene(source_of(city))));
}

HttpResponse answer_root(const HttpRequest& request, const Url& url, const CityReader& city) {
  RootOptions options;
  options.parcels = kParcels;
  const auto format = format_of(request, url.path);
  if (!format) return not_acceptable("model/x3d+xml, model/vrml and model/x3d+json");
  if (*format == nullptr)
    return problem(404, "There is no root world " + url.path + ". There are /city.x3d, /city.wrl and /city.x3dj.");
  options.format = **format;
  if (const auto wrong = read_root_query(url, options)) return problem(400, *wrong);
  const auto text = root_text(source_of(city), options);
  if (!text)
    return problem(404, "There is no sector " + options.start +
                            " to start in. Ask /collections/sectors/items for those "
                            "there are.");
  return answer_made(request, media_type_of(options.format), *text);
}

HttpResponse answer_sector(const HttpRequest& request, const CityReader& city, const std::string& name) {
  const auto dot = std::min(name.find('.'), name.size());
  const auto id = name.substr(0, dot);
  if (!is_sector_id(id))
    return problem(400, "'" + id +
                            "' is no sector id: ids have letters, digits, '-' and '_'. Ask "
                            "/collections/sectors/items for those there are.");
  const auto path = "sectors/" + name;
  if (dot < name.size()) {
    if (auto artefact = answer_artefact(request, city, path)) return *std::move(artefact);
    if (auto file = answer_written(request, city, id, name)) return *std::move(file);
  }
  if (!city.sector(id) && !city.interior(id))
    return problem(404, "There is no sector " + id + ". Ask /collections/sectors/items for those there are.");
  if (dot == name.size() && !city.artefact_codings(path + ".x3d").empty()) return answer_by_accept(request, city, id);
  return problem(404, "Sector " + id + " has no " + name.substr(dot) + ". It has:" + formats_of(city, id));
}

}  // namespace vicus
