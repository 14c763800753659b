#include "cli/near_names.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace vicus::cli {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i - 1]) != lower(b[j - 1]));
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 5;
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const auto& name : names)
    if (const auto steps = edit_distance(given, name); 2 * steps <= std::max(given.size(), name.size()))
      near.emplace_back(steps, name);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  if (near.size() > kMost) near.resize(kMost);
  std::string text;
  for (std::size_t i = 0; i < near.size(); ++i)
    text += (i == 0 ? "; did you mean " : i + 1 == near.size() ? " or " : ", ") + near[i].second;
  return text.empty() ? "" : text + "?";
}

}  // namespace vicus::cli
