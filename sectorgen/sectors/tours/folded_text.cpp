#include "sectorgen/sectors/tours/folded_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace vicus {
namespace {

constexpr std::size_t kOneErrorFrom = 4, kTwoErrorsFrom = 8;  // letters
constexpr std::size_t kLongestWord = 40;                      // bytes: what is longer is cut for comparing

/// U+00C0 ... U+017F. '1' ae, '2' oe, '3' ss, '4' th, '5' ij; '.' parts words.
constexpr std::string_view kLatin =
    "aaaaaa1ceeeeiiiidnooooo.ouuuuy43aaaaaa1ceeeeiiiidnooooo.ouuuuy4y"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiii55jjkkkllllllllllnnnnnnnnnoooooo22rrrrrrsssssssstttttt"
    "uuuuuuuuuuuuwwyyyzzzzzzs";

/// One code point; `at` moves on. Broken bytes: 0xFFFD.
char32_t decode(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(at++);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
  char32_t code = more == 3 ? first & 0x07u : more == 2 ? first & 0x0Fu : first & 0x1Fu;
  for (int i = 0; i < more; ++i, ++at) {
    if (at >= text.size() || (byte(at) & 0xC0) != 0x80) return 0xFFFD;
    code = (code << 6) | (byte(at) & 0x3Fu);
  }
  return more == 0 ? 0xFFFD : code;
}

void append_utf8(std::string& out, char32_t code) {
  const auto push = [&](char32_t bits) { out.push_back(static_cast<char>(static_cast<unsigned char>(bits))); };
  if (code < 0x80) return push(code);
  if (code < 0x800) return push(0xC0 | code >> 6), push(0x80 | (code & 0x3F));
  if (code < 0x10000) return push(0xE0 | code >> 12), push(0x80 | (code >> 6 & 0x3F)), push(0x80 | (code & 0x3F));
  push(0xF0 | code >> 18);
  push(0x80 | (code >> 12 & 0x3F));
  push(0x80 | (code >> 6 & 0x3F));
  push(0x80 | (code & 0x3F));
}

/// Appends the letter, small and bare; false: it parts words.
bool append_folded(std::string& word, char32_t code) {
  if (code < 0x80) {
    const auto c = static_cast<char>(code);
    if (c >= 'A' && c <= 'Z') return word.push_back(static_cast<char>(c - 'A' + 'a')), true;
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) return word.push_back(c), true;
    return false;
  }
  if (code >= 0x300 && code < 0x370) return true;  // marks that stand alone
  if (code >= 0xC0 && code < 0xC0 + kLatin.size()) {
    static const std::map<char, const char*> kPairs = {{'1', "ae"}, {'2', "oe"}, {'3', "ss"}, {'4', "th"}, {'5', "ij"}};
    const char c = kLatin[code - 0xC0];
    if (c == '.') return false;
    const auto pair = kPairs.find(c);
    if (pair != kPairs.end())
      word += pair->second;
    else
      word.push_back(c);
    return true;
  }
  if (code == 0x218 || code == 0x219) return word.push_back('s'), true;
  if (code == 0x21A || code == 0x21B) return word.push_back('t'), true;
  if (code == 0x1E9E) return word += "ss", true;
  if ((code >= 0x391 && code <= 0x3A9) || (code >= 0x410 && code <= 0x42F)) code += 0x20;
  if (code >= 0x400 && code <= 0x40F) code += 0x50;
  if (code < 0xC0 || (code >= 0x2000 && code < 0x2C00) || (code >= 0x3000 && code <= 0x3002) || code == 0xFFFD)
    return false;
  append_utf8(word, code);
  return true;
}

void write_out(std::string& word) {
  static const std::map<std::string, const char*, std::less<>> kAbbreviations = {
      {"str", "strasse"}, {"bd", "boulevard"}, {"bld", "boulevard"}, {"blvd", "boulevard"}, {"av", "avenue"},
      {"ave", "avenue"},  {"rd", "road"},      {"sq", "square"},     {"fbg", "faubourg"},   {"ul", "ulice"}};
  if (const auto found = kAbbreviations.find(word); found != kAbbreviations.end())
    word = found->second;
  else if (word.size() > 5 && word.ends_with("str"))
    word += "asse";
}

bool has_digit(std::string_view word) {
  return std::any_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Least errors between `typed` and the whole of `word`, and any beginning of it. More than two are not told apart.
struct Errors {
  std::size_t whole = 3, beginning = 3;
};

Errors errors(std::string_view typed, std::string_view word) {
  typed = typed.substr(0, kLongestWord);
  word = word.substr(0, std::min(kLongestWord, typed.size() + 3));
  std::array<std::array<std::uint8_t, kLongestWord + 1>, 3> rows{};
  for (std::size_t j = 0; j <= word.size(); ++j) rows[0][j] = static_cast<std::uint8_t>(j);
  for (std::size_t i = 1; i <= typed.size(); ++i) {
    auto& row = rows[i % 3];
    const auto &above = rows[(i + 2) % 3], &two_above = rows[(i + 1) % 3];
    row[0] = static_cast<std::uint8_t>(i);
    std::uint8_t least = row[0];
    for (std::size_t j = 1; j <= word.size(); ++j) {
      int best = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (typed[i - 1] != word[j - 1])});
      if (i > 1 && j > 1 && typed[i - 1] == word[j - 2] && typed[i - 2] == word[j - 1])
        best = std::min(best, two_above[j - 2] + 1);
      row[j] = static_cast<std::uint8_t>(best);
      least = std::min(least, row[j]);
    }
    if (least > 2) return {};
  }
  const auto& last = rows[typed.size() % 3];
  return {last[word.size()],
          *std::min_element(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(word.size()) + 1)};
}

}  // namespace

std::vector<std::string> folded_words(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    write_out(word);
    words.push_back(std::move(word));
    word.clear();
  };
  for (std::size_t at = 0; at < text.size();)
    if (!append_folded(word, decode(text, at))) end_word();
  end_word();
  return words;
}

double fit(std::string_view typed, std::string_view word) {
  if (typed == word) return 1;
  if (typed.empty()) return 0;
  if (word.starts_with(typed)) {
    const double share = static_cast<double>(typed.size()) / static_cast<double>(word.size());
    return has_digit(typed) && word[typed.size()] >= '0' && word[typed.size()] <= '9' ? 0 : 0.8 + 0.15 * share;
  }
  if (has_digit(typed) || has_digit(word)) return 0;
  if (typed.size() >= 3 && word.find(typed) != std::string_view::npos) return 0.7;
  if (typed.size() < kOneErrorFrom) return 0;
  const std::size_t allowed = typed.size() >= kTwoErrorsFrom ? 2 : 1;
  if (word.size() + allowed < typed.size()) return 0;
  const Errors e = errors(typed, word);
  const bool is_whole = word.size() <= typed.size() + allowed && e.whole <= allowed;
  if (is_whole) return 0.8 - 0.12 * static_cast<double>(e.whole);
  return e.beginning <= allowed ? 0.65 - 0.12 * static_cast<double>(e.beginning) : 0;
}

}  // namespace vicus
