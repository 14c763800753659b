#include "tests/support/hex_dump.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/scratch.hpp"

namespace vicus::test {

std::string dumped_bytes(int which) {
  const std::string text = read_bytes(std::string(VICUS_TESTS) + "/../city_db/FORMAT.md"), fence = "```hexdump\n";
  std::size_t begin = 0;
  for (int i = 0; i <= which; ++i) begin = text.find(fence, begin) + fence.size();
  std::istringstream lines(text.substr(begin, text.find("```", begin) - begin));
  std::string bytes;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::stoul(line.substr(0, 4), nullptr, 16), bytes.size()) << line;
    for (std::size_t at = 6; at + 1 < line.size() && line[at] != ' '; at += 3)
      bytes.push_back(static_cast<char>(std::stoi(line.substr(at, 2), nullptr, 16)));
  }
  return bytes;
}

}  // namespace vicus::test
