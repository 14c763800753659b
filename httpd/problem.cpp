#include "httpd/problem.hpp"

#include <nlohmann/json.hpp>

namespace vicus {

const char* reason_phrase(int status) {
  switch (status) {
    case 200: return "OK";
    case 204: return "No Content";
    case 304: return "Not Modified";
    case 307: return "Temporary Redirect";
    case 400: return "Bad Request";
    case 404: return "Not Found";
    case 405: return "Method Not Allowed";
    case 406: return "Not Acceptable";
    case 408: return "Request Timeout";
    case 413: return "Content Too Large";
    case 414: return "URI Too Long";
    case 417: return "Expectation Failed";
    case 431: return "Request Header Fields Too Large";
    case 500: return "Internal Server Error";
    case 501: return "Not Implemented";
    case 503: return "Service Unavailable";
    case 505: return "HTTP Version Not Supported";
    default: return "Unknown";
  }
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
