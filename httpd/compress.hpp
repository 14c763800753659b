#pragma once
#include <string>
#include <string_view>

/// Content codings for what was not coded when the city was built.
namespace vicus {

enum class Effort { on_request, once };  ///< on_request: some ms per 100 kB; once: some 100 ms per MB, kept

/// Deterministic; decoding gives `bytes` back.
/// Needs   coding is "br", "gzip" or "identity".
std::string compress(std::string_view bytes, std::string_view coding, Effort effort);

}  // namespace vicus
