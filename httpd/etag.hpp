#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Strong validators: equal tags, equal bytes (RFC 9110 §8.8.3).
namespace vicus {

/// `"HASH-CODING"`: each coding of a resource is a representation of its own.
/// Needs   nothing; characters of `hash` that an entity-tag cannot hold are left out.
std::string etag_of(std::string_view hash, std::string_view coding);

/// True when If-None-Match names `etag` (weak comparison, §13.1.2) or is "*": the answer is 304.
/// A field that is no list of entity-tags matches nothing: the client gets the bytes.
bool names_etag(const std::optional<std::string>& if_none_match, std::string_view etag);

}  // namespace vicus
