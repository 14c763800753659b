#include "x3d_export/sign_letters.hpp"

#include <cctype>

namespace vicus {
namespace {

/// Polylines of pairs of figures, parted by '|'.
struct Letter {
  char letter;
  const char* lines;
};
constexpr Letter kLetters[] = {{'A', "002640|1232"},
                               {'B', "00063645443303|3342413000"},
                               {'C', "4536160501103041"},
                               {'D', "00062644422000"},
                               {'E', "46060040|0333"},
                               {'F', "460600|0333"},
                               {'G', "45361605011030414323"},
                               {'H', "0006|4046|0343"},
                               {'I', "2026"},
                               {'J', "4641301001"},
                               {'K', "0006|460340"},
                               {'L', "060040"},
                               {'M', "0006234640"},
                               {'N', "00064046"},
                               {'O', "010516364541301001"},
                               {'P', "00063645443303"},
                               {'Q', "010516364541301001|2240"},
                               {'R', "00063645443303|2340"},
                               {'S', "453616050413334241301001"},
                               {'T', "0646|2620"},
                               {'U', "060110304146"},
                               {'V', "062046"},
                               {'W', "0610233046"},
                               {'X', "0046|0640"},
                               {'Y', "062346|2320"},
                               {'Z', "06460040"},
                               {'0', "010516364541301001"},
                               {'1', "152620|1030"},
                               {'2', "05163645440040"},
                               {'3', "064623334241301001"},
                               {'4', "30360242"},
                               {'5', "460603334241301001"},
                               {'6', "36160501103041423303"},
                               {'7', "064610"},
                               {'8', "13040516364544331302011030414233"},
                               {'9', "10304145361605041343"},
                               {'&', "40051626351301103042"},
                               {'-', "1333"},
                               {'.', "2021"},
                               {'\'', "2625"},
                               {' ', ""}};

const Letter* find_letter(char c) {
  for (const auto& l : kLetters)
    if (l.letter == c) return &l;
  return nullptr;
}

/// Base letters of U+00C0 ... U+017F.
constexpr std::string_view kBases =
    "AAAAAAACEEEEIIIIDNOOOOOXOUUUUYTSAAAAAAACEEEEIIIIDNOOOOO-OUUUUYTY"
    "AAAAAACCCCCCCCDDDDEEEEEEEEEEGGGGGGGGHHHHIIIIIIIIIIIIJJKKKLLLLLLLLLLNNNNNNNNNOOOOOOOORRRRRRSSSSSSSSTTTTTTUUUUUUUUU"
    "UUUWWYYYZZZZZZS";
static_assert(kBases.size() == 0x180 - 0xC0);

/// The next code point, and on; U+FFFD for what is no UTF-8.
char32_t take(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  char32_t code = first & (0x3Fu >> more);
  for (int i = 0; i < more; ++i) {
    if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xC0) != 0x80) return 0xFFFD;
    code = code << 6 | (static_cast<unsigned char>(text.front()) & 0x3Fu);
    text.remove_prefix(1);
  }
  return more == 0 ? 0xFFFD : code;
}

}  // namespace

std::string sign_text(std::string_view name, std::size_t most) {
  std::string out;
  std::size_t unknown = 0, all = 0;
  while (!name.empty() && out.size() < most) {
    char32_t code = take(name);
    ++all;
    if (code == 0x2019) code = '\'';
    char c = ' ';
    if (code < 0x80)
      c = static_cast<char>(std::toupper(static_cast<int>(code)));
    else if (code >= 0xC0 && code < 0x180)
      c = kBases[code - 0xC0];
    else
      ++unknown;
    if (!find_letter(c)) c = ' ';
    if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return 3 * unknown > all ? "" : out;
}

std::vector<Stroke4x6> strokes_of(char letter) {
  std::vector<Stroke4x6> out;
  const Letter* l = find_letter(letter);
  if (!l) return out;
  const std::string_view lines = l->lines;
  for (std::size_t i = 0; i + 3 < lines.size(); i += 2) {
    if (lines[i] == '|') ++i;
    if (i + 3 >= lines.size() || lines[i + 2] == '|') continue;
    out.push_back({lines[i] - '0', lines[i + 1] - '0', lines[i + 2] - '0', lines[i + 3] - '0'});
  }
  return out;
}

}  // namespace vicus
