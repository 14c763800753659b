#include "httpd/response_head.hpp"

#include <array>
#include <cstdio>

#include "httpd/problem.hpp"

namespace vicus {
namespace {

/// RFC 9110 §5.6.7, whatever the locale.
std::string http_date(std::time_t now) {
  static constexpr std::array<const char*, 7> kDays = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  static constexpr std::array<const char*, 12> kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                          "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  std::tm t{};
  gmtime_r(&now, &t);
  char text[80];
  std::snprintf(text, sizeof text, "%s, %02d %s %04d %02d:%02d:%02d GMT", kDays[static_cast<std::size_t>(t.tm_wday)],
                t.tm_mday, kMonths[static_cast<std::size_t>(t.tm_mon)], t.tm_year + 1900, t.tm_hour, t.tm_min,
                t.tm_sec);
  return text;
}

void add_line(std::string& out, const std::string& name, const std::string& value) {
  out.append(name).append(": ");
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7f ? ' ' : c;
  }
  out += "\r\n";
}

}  // namespace

bool may_have_body(int status) { return status >= 200 && status != 204 && status != 304; }

std::string response_head(const HttpResponse& response, bool keeps_alive, std::time_t now) {
  std::string out = "HTTP/1.1 " + std::to_string(response.status) + " " + reason_phrase(response.status) + "\r\n";
  add_line(out, "Date", http_date(now));
  add_line(out, "Server", "vicus");
  for (const auto& [name, value] : response.fields) add_line(out, name, value);
  if (may_have_body(response.status))
    add_line(out, "Content-Length", std::to_string(response.body ? response.body->size() : 0));
  add_line(out, "Connection", keeps_alive ? "keep-alive" : "close");
  return out += "\r\n";
}

}  // namespace vicus
