#include "sectorgen/geo/number_list.hpp"

#include <charconv>
#include <system_error>

namespace vicus {

bool append_numbers(std::string_view text, std::vector<double>& out) {
  for (;;) {
    const auto begin = text.find_first_not_of(" \t\r\n,");
    if (begin == std::string_view::npos) return true;
    text.remove_prefix(begin);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + (text[0] == '+' ? 1 : 0), text.data() + text.size(), value);
    if (error != std::errc()) return false;
    out.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

}  // namespace vicus
