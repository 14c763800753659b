#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a client says it can take (RFC 9110 §12.5), read strictly: a coding or media type refused with q=0 is never
/// sent.
namespace vicus {

/// The codings of ours ("br", "gzip", "identity") the client takes, best first: by q, then br, gzip, identity.
///
/// No field: the client takes anything, but as given by few clients it is served identity first. An empty field:
/// identity alone. identity needs no mention (then it comes last) unless "identity;q=0" or "*;q=0" refuses it.
/// An empty list: nothing we have suits (406).
/// Fails   nullopt: not the grammar of RFC 9110 §12.5.3 (400).
std::optional<std::vector<std::string>> accepted_codings(const std::optional<std::string>& field);

/// q in thousandths that the Accept field gives the media type, by the most specific range that matches; 1000 where
/// there is no field. Parameters of a range other than q are compared with none: such a range never matches.
/// Fails   nullopt: not the grammar of RFC 9110 §12.5.1.
std::optional<int> media_quality(const std::optional<std::string>& field, std::string_view media_type);

/// The first of `media_types` with the highest quality; empty string: none suits (406).
/// Fails   nullopt as media_quality.
std::optional<std::string> preferred_media_type(const std::optional<std::string>& field,
                                                const std::vector<std::string>& media_types);

}  // namespace vicus
