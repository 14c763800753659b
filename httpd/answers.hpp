#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "city_db/store.hpp"
#include "httpd/message.hpp"
#include "httpd/static_files.hpp"

/// From bytes to an answer: the coding and media type the client takes, validator, 304, 406, caching.
namespace vicus {

/// revalidate: a cache asks each time (304 when nothing changed). immutable: the path changes when the bytes do.
enum class Caching { revalidate, immutable };

HttpResponse answer_file(const HttpRequest& request, const StaticFile& file, Caching caching);

/// Bytes made for this request; coded here when that pays.
HttpResponse answer_made(const HttpRequest& request, const std::string& media_type, std::string bytes);

/// What table `artefact` has under the path: a stored coding as it is, plain bytes and gzip made from what is stored.
/// nullopt: there is no such path.
/// Fails   CityError: the stored bytes cannot be unpacked.
std::optional<HttpResponse> answer_artefact(const HttpRequest& request, const CityReader& city,
                                            const std::string& path);

/// The plain bytes of the artefact of that path.
/// Fails   CityError: there is none, or it cannot be unpacked.
std::string plain_artefact(const CityReader& city, const std::string& path);

/// Puts plain bytes into the coding that was chosen.
using Code = std::function<std::string(std::string plain)>;

/// Bytes that are made only where the client has not those of `hash` already: `make(coding, code)` gives them in
/// `coding`, brotli of that quality.
HttpResponse answer_composed(
    const HttpRequest& request, const std::string& media_type, const std::string& hash, int brotli_quality,
    const std::function<std::shared_ptr<const std::string>(const std::string& coding, const Code& code)>& make);

/// 406 that says what there is.
HttpResponse not_acceptable(const std::string& what_there_is);

/// Fields every answer bears: any page may read it, no browser may take it for another type.
void add_common_fields(HttpResponse& response);

/// For / and whatever else is a document: scripts from here only, and none from text. The page loads sectors by its own
/// module; an X3D Script node would need 'unsafe-eval' (client_scripts/README.md).
extern const char* const kContentSecurityPolicy;

}  // namespace vicus
