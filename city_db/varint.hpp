#pragma once
#include <cstdint>
#include <string>
#include <string_view>

/// Whole numbers of as many bytes as they need: 7 bits a byte, the low ones first; signed ones zigzag.
namespace vicus {

inline void append_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>(value | 0x80));
  out.push_back(static_cast<char>(value));
}
inline void append_signed(std::string& out, std::int64_t value) {
  append_varint(out, (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
}

/// Varints of up to 35 bits from the front; after the first that is not there `is_good` is false and all others are 0.
class VarintSource {
 public:
  explicit VarintSource(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t next() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      if (at_ == bytes_.size()) break;
      const auto byte = static_cast<std::uint8_t>(bytes_[at_++]);
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) {
        if (byte == 0 && shift > 0) break;  // a longer spelling of the same number
        return value;
      }
    }
    is_good = false;
    return 0;
  }
  std::int64_t next_signed() {
    const std::uint64_t v = next();
    return static_cast<std::int64_t>(v >> 1) ^ -static_cast<std::int64_t>(v & 1);
  }
  bool is_done() const { return is_good && at_ == bytes_.size(); }
  bool is_good = true;

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace vicus
