#pragma once
#include <cstddef>
#include <optional>
#include <string>

/// Content codings of HTTP and the hash of bytes. Equal bytes in give equal bytes out.
namespace vicus {

/// 128 bits of SHA-256, 32 hexadecimal digits.
std::string strong_hash(const std::string& body);

/// quality 0 ... 11.   Fails  CityError: out of memory.
std::string brotli(const std::string& body, int quality);
/// libdeflate's level 1 ... 12.   Fails  CityError: out of memory.
std::string gzip(const std::string& body, int level);

/// Of hostile bytes: nullopt when they are not one whole stream, or hold more than `most` bytes.
/// Cost    memory: at most `most`, and twice what the bytes hold.
std::optional<std::string> unbrotli(const std::string& coded, std::size_t most);

}  // namespace vicus
