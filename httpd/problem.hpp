#pragma once
#include <string>

#include "httpd/message.hpp"

/// Errors a person can act on (RFC 9457): what is wrong, and what to do about it.
namespace vicus {

/// `application/problem+json` with status, title and detail; never cached.
/// Needs   detail: a sentence that says what to do. Bytes in it that are not UTF-8 are replaced.
HttpResponse problem(int status, const std::string& detail);

/// The reason phrase, which is also the problem's title; "Unknown" for a number we never send.
const char* reason_phrase(int status);

}  // namespace vicus
