#include "x3d_export/coding.hpp"

#include <brotli/decode.h>
#include <brotli/encode.h>
#include <libdeflate.h>
#include <openssl/sha.h>

#include <algorithm>
#include <memory>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

const std::uint8_t* bytes_of(const std::string& s) { return reinterpret_cast<const std::uint8_t*>(s.data()); }
std::uint8_t* bytes_of(std::string& s) { return reinterpret_cast<std::uint8_t*>(s.data()); }

/// The smallest window that holds the whole file: a larger one finds nothing more and costs its allocation.
int window_bits(std::size_t size) {
  int bits = BROTLI_MIN_WINDOW_BITS;
  while (bits < BROTLI_DEFAULT_WINDOW && (std::size_t{1} << bits) - 16 < size) ++bits;
  return bits;
}

}  // namespace

std::string strong_hash(const std::string& body) {
  constexpr std::size_t kBytes = 16;
  constexpr char kDigits[] = "0123456789abcdef";
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(bytes_of(body), body.size(), digest);
  std::string hex;
  for (std::size_t i = 0; i < kBytes; ++i) {
    hex += kDigits[digest[i] >> 4];
    hex += kDigits[digest[i] & 15u];
  }
  return hex;
}

std::optional<std::string> unbrotli(const std::string& coded, std::size_t most) {
  const std::unique_ptr<BrotliDecoderState, void (*)(BrotliDecoderState*)> decoder(
      BrotliDecoderCreateInstance(nullptr, nullptr, nullptr), BrotliDecoderDestroyInstance);
  if (!decoder) throw CityError("brotli cannot decode: out of memory");
  constexpr std::size_t kFirstGuess = 8;  // times the coded size, as our files are
  std::string body(std::min(most, std::max<std::size_t>(coded.size() * kFirstGuess, 1024)), '\0');
  std::size_t in = coded.size(), used = 0;
  const std::uint8_t* next_in = bytes_of(coded);
  for (;;) {
    std::uint8_t* next_out = bytes_of(body) + used;
    std::size_t room = body.size() - used;
    const auto result = BrotliDecoderDecompressStream(decoder.get(), &in, &next_in, &room, &next_out, nullptr);
    used = body.size() - room;
    if (result == BROTLI_DECODER_RESULT_SUCCESS) break;
    if (result != BROTLI_DECODER_RESULT_NEEDS_MORE_OUTPUT || body.size() == most) return std::nullopt;
    body.resize(std::min(most, 2 * body.size()));
  }
  if (in != 0) return std::nullopt;
  body.resize(used);
  return body;
}

std::string brotli(const std::string& body, int quality) {
  std::size_t size = BrotliEncoderMaxCompressedSize(body.size());
  std::string out(size, '\0');
  if (!BrotliEncoderCompress(quality, window_bits(body.size()), BROTLI_MODE_TEXT, body.size(), bytes_of(body), &size,
                             bytes_of(out)))
    throw CityError("brotli cannot compress " + std::to_string(body.size()) + " bytes: out of memory");
  out.resize(size);
  return out;
}

std::string gzip(const std::string& body, int level) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) throw CityError("libdeflate has no level " + std::to_string(level) + ", or there is no memory");
  std::string out(libdeflate_gzip_compress_bound(compressor.get(), body.size()), '\0');
  out.resize(libdeflate_gzip_compress(compressor.get(), body.data(), body.size(), out.data(), out.size()));
  return out;
}

}  // namespace vicus
