#include "httpd/parcels.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>
#include <vector>

#include "httpd/answers.hpp"
#include "httpd/problem.hpp"
#include "httpd/sector_routes.hpp"
#include "x3d_export/coding.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;

constexpr const char* kMediaType = "application/x-ndjson";
constexpr const char* kExample = "Give files once: /parcels?files=r12,r13.far,r14.tall";
/// Part of each tag: another one where the same members are written in another way.
constexpr const char* kForm = "parcel 1\n";
/// Kept, so that it pays to look harder than for what is made once: 7 % fewer bytes than 4, in about the same time.
constexpr int kParcelBrotli = 6;

constexpr const char* kImages = "textures/";
constexpr std::string_view kImageEnd = ".png";

struct Query {
  std::vector<std::string> stems;
  bool has_images = false;
  std::vector<std::string> without;  ///< beginnings of images' names
};
/// What was asked for, or a sentence that says what is wrong with it.
using Asked = std::variant<Query, std::string>;

bool is_stem(const std::string& stem) {
  const auto dot = std::min(stem.find('.'), stem.size());
  const std::string end = stem.substr(dot);
  return is_sector_id(stem.substr(0, dot)) && (end.empty() || end == ".far" || end == ".tall");
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const auto end = std::min(list.find(',', begin), list.size());
    parts.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Asked read_query(const Url& url) {
  bool is_repeated = false;
  const auto list = parameter_of(url, "files", is_repeated), without = parameter_of(url, "without", is_repeated);
  if (!list || is_repeated || url.query.size() != (without ? 2U : 1U)) return std::string(kExample) + ".";
  Query query;
  query.has_images = without.has_value();
  if (without && !without->empty()) query.without = split(*without);
  for (const auto& begin : query.without)
    if (!is_sector_id(begin)) return "'" + begin + "' begins no image's name: expected letters and digits.";
  std::set<std::string> known;
  for (const std::string& stem : split(*list)) {
    if (!is_stem(stem))
      return "'" + stem + "' names no sector's file: expected ID, ID.far or ID.tall. " + kExample + ".";
    if (!known.insert(stem).second) return "'" + stem + "' stands twice in files.";
    query.stems.push_back(stem);
  }
  if (query.stems.size() > kMostParcelFiles)
    return "Ask for at most " + std::to_string(kMostParcelFiles) + " files at a time, not " +
           std::to_string(query.stems.size()) + ".";
  return query;
}

/// The members of a parcel, before any of them is read.
struct Parcel {
  std::vector<std::string> names;  ///< of files: "r12.x3d", "r12.1.x3d", ...
  std::vector<std::string> missing;
  std::string tag;
};

Parcel parcel_of(const Query& query, const CityReader& city) {
  Parcel parcel;
  std::string members = kForm;
  const auto add = [&](const std::string& name) {
    const auto rows = city.artefact_codings("sectors/" + name);
    if (rows.empty()) return false;
    members += name + ' ' + rows.front().hash + '\n';
    parcel.names.push_back(name);
    return true;
  };
  for (const auto& stem : query.stems) {
    if (add(stem + ".x3d"))
      for (int part = 1; add(stem + '.' + std::to_string(part) + ".x3d");) ++part;
    else
      parcel.missing.push_back(stem);
  }
  for (const auto& stem : parcel.missing) members += "- " + stem + '\n';
  if (query.has_images) members += "images";  // they are named by their content, in the files
  for (const auto& begin : query.without) members += ' ' + begin;
  parcel.tag = strong_hash(members);
  return parcel;
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (unsigned k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63U];
  }
  return out;
}

/// Texts of a city from elsewhere may be no UTF-8.
std::string line_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

/// Lines of a parcel, files and images as they come.
class Lines {
 public:
  Lines(const Query& query, const CityReader& city) : query_(query), city_(city) {}

  void add_file(const std::string& name) {
    const std::string text = plain_artefact(city_, "sectors/" + name);
    add(name, text);
    const bool is_near = name.find(".far.") == std::string::npos && name.find(".tall.") == std::string::npos;
    if (query_.has_images && is_near) add_images(text);
  }

  std::string text(const std::vector<std::string>& missing) const {
    return line_of({{"files", sizes_}, {"missing", missing}}) + lines_;
  }

 private:
  void add(const std::string& name, const std::string& text) {
    sizes_.push_back({name, text.size()});
    lines_ += line_of({name, text});
  }

  void add_images(const std::string& text) {
    for (auto at = text.find(kImages); at != std::string::npos; at = text.find(kImages, at + 1)) {
      const auto end = text.find(kImageEnd, at);
      if (end == std::string::npos) return;
      const std::string path = text.substr(at, end + kImageEnd.size() - at);
      const std::string name = path.substr(std::string_view(kImages).size());
      const bool is_known = std::any_of(query_.without.begin(), query_.without.end(),
                                        [&](const std::string& begin) { return name.starts_with(begin); });
      if (is_known || !images_.insert(name).second || city_.artefact_codings(path).empty()) continue;
      add(path, base64(plain_artefact(city_, path)));
    }
  }

  const Query& query_;
  const CityReader& city_;
  std::set<std::string> images_;
  Json sizes_ = Json::array();
  std::string lines_;
};

std::string text_of(const Query& query, const Parcel& parcel, const CityReader& city) {
  Lines lines(query, city);
  for (const auto& name : parcel.names) lines.add_file(name);
  return lines.text(parcel.missing);
}

}  // namespace

HttpResponse Parcels::answer(const HttpRequest& request, const Url& url, const CityReader& city) {
  const Asked asked = read_query(url);
  if (const auto* wrong = std::get_if<std::string>(&asked)) return problem(400, *wrong);
  const auto& query = std::get<Query>(asked);
  const auto& stems = query.stems;
  const Parcel parcel = parcel_of(query, city);
  if (parcel.names.empty())
    return problem(404, "There is no file of " + stems.front() + (stems.size() > 1 ? ", nor of the others" : "") +
                            ". Ask /collections/sectors/items for the sectors there are.");
  return answer_composed(request, kMediaType, parcel.tag, kParcelBrotli,
                         [&](const std::string& coding, const auto& code) {
                           const std::string tag = parcel.tag + '-' + coding;
                           if (auto kept = find(tag)) return kept;
                           auto body = body_of(code(text_of(query, parcel, city)));
                           keep(tag, body);
                           return body;
                         });
}

std::shared_ptr<const std::string> Parcels::find(const std::string& tag) {
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(tag);
  if (found == kept_.end()) return nullptr;
  by_use_.splice(by_use_.begin(), by_use_, found->second.used);
  return found->second.body;
}

void Parcels::keep(const std::string& tag, std::shared_ptr<const std::string> body) {
  const std::lock_guard lock(mutex_);
  if (kept_.contains(tag)) return;  // another thread was faster
  bytes_ += body->size();
  by_use_.push_front(tag);
  kept_.emplace(tag, Kept{std::move(body), by_use_.begin()});
  while (bytes_ > most_bytes_ && by_use_.size() > 1) {
    const auto last = kept_.find(by_use_.back());
    bytes_ -= last->second.body->size();
    kept_.erase(last);
    by_use_.pop_back();
  }
}

std::size_t Parcels::kept_bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace vicus
