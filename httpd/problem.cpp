#include "httpd/problem.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace vicus {
namespace {

constexpr std::pair<int, const char*> kPhrases[] = {
    {200, "OK"},
    {204, "No Content"},
    {304, "Not Modified"},
    {307, "Temporary Redirect"},
    {400, "Bad Request"},
    {404, "Not Found"},
    {405, "Method Not Allowed"},
    {406, "Not Acceptable"},
    {408, "Request Timeout"},
    {409, "Conflict"},
    {413, "Content Too Large"},
    {414, "URI Too Long"},
    {417, "Expectation Failed"},
    {431, "Request Header Fields Too Large"},
    {500, "Internal Server Error"},
    {501, "Not Implemented"},
    {503, "Service Unavailable"},
    {505, "HTTP Version Not Supported"},
};

}  // namespace

const char* reason_phrase(int status) {
  for (const auto& [number, phrase] : kPhrases)
    if (number == status) return phrase;
  return "Unknown";
}

HttpResponse problem(int status, const std::string& detail) {
  nlohmann::ordered_json json;
  json["type"] = "about:blank";
  json["title"] = reason_phrase(status);
  json["status"] = status;
  json["detail"] = detail;
  HttpResponse response;
  response.status = status;
  response.fields = {{"Content-Type", "application/problem+json"}, {"Cache-Control", "no-store"}};
  response.body = body_of(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  return response;
}

}  // namespace vicus
