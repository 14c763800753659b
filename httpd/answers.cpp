#include "httpd/answers.hpp"

#include <algorithm>

#include "city_db/issues.hpp"
#include "httpd/etag.hpp"
#include "httpd/media_types.hpp"
#include "httpd/negotiate.hpp"
#include "httpd/problem.hpp"
#include "x3d_export/coding.hpp"

namespace vicus {

const char* const kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; connect-src 'self' data: blob:; "
    "img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; font-src 'self' data:; media-src 'self' data: "
    "blob:; "
    "worker-src 'self' blob:; base-uri 'none'; form-action 'self'";

namespace {

// Made for one request: br 4 costs 0.8 ms per 100 kB, gzip 6 0.7 ms (research/SERVER.md §4).
constexpr int kBrotliQuality = 4, kGzipLevel = 6;
constexpr std::size_t kLeastCompressed = 256;  // bytes; below this a coding's frame eats what it saves

/// What the request allows, or the answer that ends it.
struct Choice {
  std::vector<std::string> codings;
  std::optional<HttpResponse> refusal;
};

Choice choose(const HttpRequest& request, std::string_view media_type) {
  Choice choice;
  const auto quality = media_quality(field_of(request.fields, "Accept"), media_type.substr(0, media_type.find(';')));
  const auto codings = accepted_codings(field_of(request.fields, "Accept-Encoding"));
  if (!quality)
    choice.refusal = problem(400, "The Accept field is not a list of media ranges. Leave it out, or send */*.");
  else if (!codings)
    choice.refusal =
        problem(400, "The Accept-Encoding field is not a list of codings. Leave it out, or send br, gzip.");
  else if (*quality == 0)
    choice.refusal = not_acceptable(std::string(media_type));
  else
    choice.codings = *codings;
  return choice;
}

HttpResponse answer_in_coding(const HttpRequest& request, const std::string& media_type, const std::string& coding,
                              const std::string& etag, Caching caching) {
  HttpResponse response;
  response.fields = {
      {"ETag", etag},
      {"Vary", "Accept, Accept-Encoding"},
      {"Cache-Control", caching == Caching::immutable ? "public, max-age=31536000, immutable, no-transform"
                                                      : "public, no-cache, no-transform"}};
  if (names_etag(field_of(request.fields, "If-None-Match"), etag)) {
    response.status = 304;
    return response;
  }
  response.fields.emplace_back("Content-Type", media_type);
  if (coding != "identity") response.fields.emplace_back("Content-Encoding", coding);
  return response;
}

/// The coding for bytes we code ourselves; empty: none suits.
std::string own_coding(const std::vector<std::string>& codings, std::string_view media_type, std::size_t bytes) {
  if (codings.empty()) return "";
  const bool pays = is_compressible(media_type) && bytes >= kLeastCompressed;
  const bool takes_identity = std::find(codings.begin(), codings.end(), "identity") != codings.end();
  return !pays && takes_identity ? "identity" : codings.front();
}

/// A media type from a file we did not write ourselves goes into a header line: token characters and '/', '+' only.
std::string safe_media_type(const std::string& media_type) {
  const auto is_safe = [](unsigned char c) { return c > 0x20 && c < 0x7f && c != '"' && c != ',' && c != ';'; };
  const bool ok = !media_type.empty() && std::all_of(media_type.begin(), media_type.end(), is_safe);
  return ok ? media_type : "application/octet-stream";
}

std::string in_coding(std::string bytes, const std::string& coding, int brotli_quality = kBrotliQuality) {
  if (coding == "br") return brotli(bytes, brotli_quality);
  if (coding == "gzip") return gzip(bytes, kGzipLevel);
  return bytes;
}

const char* const kNoCoding = "the codings br, gzip and identity; the request refuses all of them";

}  // namespace

HttpResponse not_acceptable(const std::string& what_there_is) {
  auto response = problem(406, "There is only " + what_there_is + ". Ask for that, or send */*.");
  set_field(response.fields, "Vary", "Accept, Accept-Encoding");
  return response;
}

HttpResponse answer_file(const HttpRequest& request, const StaticFile& file, Caching caching) {
  auto choice = choose(request, file.media_type());
  if (choice.refusal) return *std::move(choice.refusal);
  const auto bytes = file.in_coding("identity").body->size();
  const auto coding = own_coding(choice.codings, file.media_type(), bytes);
  if (coding.empty()) return not_acceptable(kNoCoding);
  const auto representation = file.in_coding(coding);
  auto response = answer_in_coding(request, file.media_type(), coding, representation.etag, caching);
  if (response.status == 200) response.body = representation.body;
  return response;
}

HttpResponse answer_made(const HttpRequest& request, const std::string& media_type, std::string bytes) {
  auto choice = choose(request, media_type);
  if (choice.refusal) return *std::move(choice.refusal);
  const auto coding = own_coding(choice.codings, media_type, bytes.size());
  if (coding.empty()) return not_acceptable(kNoCoding);
  const auto etag = etag_of(strong_hash(bytes), coding);
  auto response = answer_in_coding(request, media_type, coding, etag, Caching::revalidate);
  if (response.status == 200) response.body = body_of(in_coding(std::move(bytes), coding));
  return response;
}

namespace {

/// What no file of ours comes near; a city file from elsewhere may unpack to anything.
constexpr std::size_t kMostUnpacked_bytes = 64 << 20;

/// The plain bytes of the stored row.
std::string plain_bytes(const CityReader& city, const Artefact& row) {
  const auto artefact = city.artefact(row.path, {row.coding});
  if (!artefact) throw CityError("the artefact " + row.path + " went away while it was read");
  if (row.coding == "identity") return artefact->body;
  auto plain = unbrotli(artefact->body, kMostUnpacked_bytes);
  if (!plain)
    throw CityError("the artefact " + row.path + " is damaged: expected brotli of at most " +
                    std::to_string(kMostUnpacked_bytes) + " bytes; build the city again");
  return *std::move(plain);
}

/// The body in a coding that is not stored; null: gzip, which would save nothing, as brotli did not.
std::shared_ptr<const std::string> derived_body(const CityReader& city, const Artefact& row,
                                                const std::string& coding) {
  std::string plain = plain_bytes(city, row);
  if (coding == "identity") return body_of(std::move(plain));
  std::string gz = gzip(plain, kGzipLevel);
  return gz.size() < plain.size() ? body_of(std::move(gz)) : nullptr;
}

}  // namespace

std::optional<HttpResponse> answer_artefact(const HttpRequest& request, const CityReader& city,
                                            const std::string& path) {
  const auto rows = city.artefact_codings(path);
  if (rows.empty()) return std::nullopt;
  const Caching caching = path.starts_with("textures/") ? Caching::immutable : Caching::revalidate;
  const auto media_type = safe_media_type(rows.front().media_type);
  auto choice = choose(request, media_type);
  if (choice.refusal) return *std::move(choice.refusal);
  for (const auto& coding : choice.codings) {
    const auto row_in = [&](const std::string& c) {
      return std::find_if(rows.begin(), rows.end(), [&](const Artefact& r) { return r.coding == c; });
    };
    auto row = row_in(coding);
    const bool is_stored = row != rows.end();
    if (!is_stored && coding != "br") row = row_in("identity") != rows.end() ? row_in("identity") : row_in("br");
    if (row == rows.end()) continue;
    // Unpacking gives the same bytes each time, so the stored row's hash, with the coding's name, tags them, too.
    auto response = answer_in_coding(request, media_type, coding, etag_of(row->hash, coding), caching);
    if (response.status != 200) return response;
    if (!is_stored)
      response.body = derived_body(city, *row, coding);
    else if (auto artefact = city.artefact(path, {coding}))
      response.body = body_of(std::move(artefact->body));
    if (response.body) return response;
  }
  return not_acceptable(kNoCoding);
}

std::string plain_artefact(const CityReader& city, const std::string& path) {
  const auto rows = city.artefact_codings(path);
  if (rows.empty()) throw CityError("the city has no " + path);
  return plain_bytes(city, rows.front());
}

HttpResponse answer_composed(
    const HttpRequest& request, const std::string& media_type, const std::string& hash, int brotli_quality,
    const std::function<std::shared_ptr<const std::string>(const std::string& coding, const Code& code)>& make) {
  auto choice = choose(request, media_type);
  if (choice.refusal) return *std::move(choice.refusal);
  if (choice.codings.empty()) return not_acceptable(kNoCoding);
  const std::string& coding = choice.codings.front();
  auto response = answer_in_coding(request, media_type, coding, etag_of(hash, coding), Caching::revalidate);
  if (response.status == 200)
    response.body =
        make(coding, [&](std::string plain) { return in_coding(std::move(plain), coding, brotli_quality); });
  return response;
}

void add_common_fields(HttpResponse& response) {
  set_field(response.fields, "Access-Control-Allow-Origin", "*");
  set_field(response.fields, "Access-Control-Expose-Headers", "ETag, Link");
  set_field(response.fields, "Cross-Origin-Resource-Policy", "cross-origin");
  set_field(response.fields, "Referrer-Policy", "no-referrer");
  set_field(response.fields, "X-Content-Type-Options", "nosniff");
}

}  // namespace vicus
