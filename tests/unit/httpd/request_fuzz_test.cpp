#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Words of every grammar the target reads, so that random joins get deep into each.
const std::vector<std::string> kWords = {"/",
                                         "..",
                                         "%2e",
                                         "%",
                                         "%c3%b6",
                                         "%c0%af",
                                         "?",
                                         "&",
                                         "=",
                                         "+",
                                         "a",
                                         "br",
                                         "gzip",
                                         "identity",
                                         "*",
                                         ";q=",
                                         "0.5",
                                         "1",
                                         "0",
                                         ",",
                                         " ",
                                         ";",
                                         "\"",
                                         "W/",
                                         "\\",
                                         "\r\n",
                                         "\n",
                                         "GET / HTTP/1.1",
                                         "Host:",
                                         "\r\n\r\n",
                                         "model/x3d+xml",
                                         "*/*",
                                         "\"a-br\"",
                                         "-180",
                                         "90",
                                         "1e9",
                                         "nan",
                                         "http://",
                                         std::string(1, '\0'),
                                         "\xff"};

TEST(RequestFuzz, SurvivesRandomJoins) {
  for (unsigned seed = 0; seed < 20000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string text = seed % 4 == 0 ? "/" : "";
    for (auto n = random() % 14; n > 0; --n) text += kWords[random() % kWords.size()];
    if (!text.empty() && random() % 4 == 0) text[random() % text.size()] = static_cast<char>(random());
    // A copy of exactly this size, so that a sanitizer sees every byte read past the end.
    const std::vector<std::uint8_t> exact(text.begin(), text.end());
    ASSERT_EQ(LLVMFuzzerTestOneInput(exact.data(), exact.size()), 0);
  }
}

}  // namespace
