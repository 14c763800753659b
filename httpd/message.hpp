#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// An HTTP request and its answer as plain values: what routes turn into each other, without sockets.
namespace vicus {

using HttpFields = std::vector<std::pair<std::string, std::string>>;

struct HttpRequest {
  std::string method = "GET";
  std::string target = "/";  ///< as sent, still percent-encoded
  HttpFields fields;         ///< as sent, one entry per line
};

struct HttpResponse {
  int status = 200;
  HttpFields fields;  ///< without Content-Length, Connection, Date and Server: these belong to the connection
  std::shared_ptr<const std::string> body;  ///< null: none; a HEAD request gets the fields of this body, not the body
  const char* route = "other";              ///< label in /metrics; static storage
  std::string fault;                        ///< for the operator's log, not for the client: what failed behind a 500
};

/// ASCII only, as HTTP's names are.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// Value of the field, ASCII case ignored; several lines of one name are one list (RFC 9110 §5.3): joined by ", ".
std::optional<std::string> field_of(const HttpFields& fields, std::string_view name);

/// Sets the field, replacing any of that name.
void set_field(HttpFields& fields, const std::string& name, const std::string& value);

std::shared_ptr<const std::string> body_of(std::string bytes);

}  // namespace vicus
