#pragma once
#include <ctime>
#include <string>

#include "httpd/message.hpp"

namespace vicus {

/// The status line and fields as sent, with Date, Server, Content-Length and Connection, through the empty line.
/// Control characters in a value are sent as spaces: no value can begin another line.
std::string response_head(const HttpResponse& response, bool keeps_alive, std::time_t now);

/// RFC 9110 §6.4.1: 1xx, 204 and 304 have none.
bool may_have_body(int status);

}  // namespace vicus
