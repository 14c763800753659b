#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// 32-bit numbers, little-endian, into blobs and out of bytes that may be anything.
namespace vicus {

inline void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>((value >> shift) & 0xff));
}

inline void append_list(std::string& out, const std::vector<std::uint32_t>& list) {
  append_u32(out, static_cast<std::uint32_t>(list.size()));
  for (const std::uint32_t i : list) append_u32(out, i);
}

/// Takes numbers from the front; after the first that is not there, `is_good` is false and all others are 0.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t u32() {
    if (bytes_.size() < 4) return is_good = false, 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<std::uint8_t>(bytes_[i])} << (8 * i);
    bytes_.remove_prefix(4);
    return value;
  }
  std::int32_t i32() { return std::bit_cast<std::int32_t>(u32()); }
  /// A count of things of at least `size` bytes each: never more than there are bytes for.
  std::uint32_t count(std::size_t size) {
    const std::uint32_t n = u32();
    if (n > bytes_.size() / size) return is_good = false, 0;
    return n;
  }
  std::vector<std::uint32_t> list(std::size_t below) {
    std::vector<std::uint32_t> out(count(4));
    for (auto& i : out)
      if ((i = u32()) >= below) is_good = false;
    return out;
  }
  bool is_empty() const { return bytes_.empty(); }

  bool is_good = true;

 private:
  std::string_view bytes_;
};

}  // namespace vicus
