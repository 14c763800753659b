#include "sectorgen/models/gltf_meshopt.hpp"

#include <meshoptimizer.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "city_db/byte_source.hpp"
#include "city_db/issues.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;

constexpr const char* kName = "EXT_meshopt_compression";
constexpr std::size_t kMostBytes = std::size_t{256} << 20;
constexpr std::uint32_t kGlb = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

/// A file's JSON and the bytes that follow it.
struct Parts {
  Json json;
  std::string bin;
};

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::optional<Parts> parts_of(const std::string& file) {
  ByteSource source(file);
  Parts parts;
  if (source.u32() != kGlb) {
    parts.json = Json::parse(file, nullptr, false);
    return parts.json.is_object() ? std::optional(std::move(parts)) : std::nullopt;
  }
  std::size_t at = 12;
  while (at + 8 <= file.size()) {
    ByteSource head(std::string_view(file).substr(at, 8));
    const std::size_t size = head.u32();
    const std::uint32_t kind = head.u32();
    at += 8;
    if (size > file.size() - at) return std::nullopt;
    if (kind == kJsonChunk) parts.json = Json::parse(file.substr(at, size), nullptr, false);
    if (kind == kBinChunk) parts.bin = file.substr(at, size);
    at += size;
  }
  return parts.json.is_object() ? std::optional(std::move(parts)) : std::nullopt;
}

/// Nothing: no base64.
std::optional<std::string> from_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int count = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  for (const char c : text) {
    const auto digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    if ((count += 6) >= 8) out += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return out;
}

class Decoder {
 public:
  Decoder(const std::filesystem::path& path, Parts parts) : path_(path), parts_(std::move(parts)) {}

  std::string run() {
    Json& json = parts_.json;
    std::string plain;
    if (json.contains("bufferViews"))
      for (Json& view : json.at("bufferViews")) {
        const std::string bytes = plain_of(view);
        if (plain.size() + bytes.size() > kMostBytes) fail("decodes to more than 256 MB");
        view["buffer"] = 0;
        view["byteOffset"] = plain.size();
        view["byteLength"] = bytes.size();
        if (view.contains("extensions")) view["extensions"].erase(kName);
        plain += bytes;
        while (plain.size() % 16 != 0) plain += '\0';
      }
    json["buffers"] = Json::array({{{"byteLength", plain.size()}}});
    for (const char* list : {"extensionsRequired", "extensionsUsed"})
      if (json.contains(list)) {
        Json rest = Json::array();
        for (const Json& name : json[list])
          if (name != kName) rest.push_back(name);
        json.erase(list);
        if (!rest.empty()) json[list] = rest;
      }
    return glb(json.dump(), plain);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw CityError(path_.string() + ": " + what, 4); }

  static std::size_t number(const Json& object, const char* key) { return object.value(key, std::size_t{0}); }

  const std::string& buffer(std::size_t i) {
    if (const auto held = buffers_.find(i); held != buffers_.end()) return held->second;
    const Json& buffer = parts_.json.at("buffers").at(i);
    const std::string uri = buffer.value("uri", "");
    if (uri.empty()) return buffers_[i] = parts_.bin;
    if (uri.starts_with("data:")) {
      const auto comma = uri.find(";base64,");
      const auto bytes =
          comma == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(comma + 8));
      if (!bytes) fail("has a buffer in a data URI that is no base64");
      return buffers_[i] = *bytes;
    }
    const auto beside = path_.parent_path() / uri;
    std::error_code error;
    if (!std::filesystem::is_regular_file(beside, error)) fail("its buffer " + uri + " is not there");
    if (std::filesystem::file_size(beside, error) > kMostBytes) fail("its buffer " + uri + " is larger than 256 MB");
    return buffers_[i] = bytes_of(beside);
  }

  std::string_view slice(std::size_t i, std::size_t offset, std::size_t length) {
    const std::string& bytes = buffer(i);
    if (offset > bytes.size() || length > bytes.size() - offset) fail("a buffer view reaches beyond its bytes");
    return std::string_view(bytes).substr(offset, length);
  }

  std::string plain_of(const Json& view) {
    if (!view.contains("extensions") || !view.at("extensions").contains(kName))
      return std::string(slice(number(view, "buffer"), number(view, "byteOffset"), number(view, "byteLength")));
    const Json& coded = view.at("extensions").at(kName);
    const std::string_view from =
        slice(number(coded, "buffer"), number(coded, "byteOffset"), number(coded, "byteLength"));
    const std::size_t count = number(coded, "count"), stride = number(coded, "byteStride");
    const std::string mode = coded.value("mode", ""), filter = coded.value("filter", "NONE");
    const bool is_list = mode == "TRIANGLES" || mode == "INDICES";
    const bool is_good = is_list ? (stride == 2 || stride == 4) && (mode != "TRIANGLES" || count % 3 == 0)
                                 : mode == "ATTRIBUTES" && stride > 0 && stride <= 256 && stride % 4 == 0;
    if (!is_good) fail("has a buffer view of an unknown coding (" + mode + ", stride " + std::to_string(stride) + ")");
    if (count > kMostBytes / stride) fail("decodes to more than 256 MB");
    std::string out(count * stride, '\0');
    const auto* bytes = reinterpret_cast<const unsigned char*>(from.data());
    int code = 0;
    if (count > 0)
      code = mode == "TRIANGLES" ? meshopt_decodeIndexBuffer(out.data(), count, stride, bytes, from.size())
             : mode == "INDICES" ? meshopt_decodeIndexSequence(out.data(), count, stride, bytes, from.size())
                                 : meshopt_decodeVertexBuffer(out.data(), count, stride, bytes, from.size());
    if (code != 0) fail("a buffer view coded by " + std::string(kName) + " does not decode");
    apply(filter, out, count, stride, is_list);
    return out;
  }

  void apply(const std::string& filter, std::string& out, std::size_t count, std::size_t stride, bool is_list) const {
    if (filter == "NONE" || count == 0) return;
    if (!is_list && filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
      meshopt_decodeFilterOct(out.data(), count, stride);
    else if (!is_list && filter == "QUATERNION" && stride == 8)
      meshopt_decodeFilterQuat(out.data(), count, stride);
    else if (!is_list && filter == "EXPONENTIAL")
      meshopt_decodeFilterExp(out.data(), count, stride);
    else
      fail("has a buffer view with an unknown filter (" + filter + ")");
  }

  static std::string glb(std::string json, std::string bin) {
    while (json.size() % 4 != 0) json += ' ';
    std::string out;
    append_u32(out, kGlb);
    append_u32(out, 2);
    append_u32(out, static_cast<std::uint32_t>(28 + json.size() + bin.size()));
    append_u32(out, static_cast<std::uint32_t>(json.size()));
    append_u32(out, kJsonChunk);
    out += json;
    append_u32(out, static_cast<std::uint32_t>(bin.size()));
    append_u32(out, kBinChunk);
    return out + bin;
  }

  const std::filesystem::path& path_;
  Parts parts_;
  std::map<std::size_t, std::string> buffers_;
};

}  // namespace

std::string without_meshopt(const std::filesystem::path& path) {
  std::error_code error;
  if (const auto size = std::filesystem::file_size(path, error); error || size > kMostBytes) return "";
  const std::string file = bytes_of(path);
  if (file.find(kName) == std::string::npos) return "";
  auto parts = parts_of(file);
  if (!parts) return "";
  try {
    return Decoder(path, std::move(*parts)).run();
  } catch (const Json::exception& what) {
    throw CityError(path.string() + ": expected glTF 2.0: " + what.what(), 4);
  }
}

}  // namespace vicus
