#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Names as people type them.
namespace vicus {

/// Words in small letters without accents: "Rue de l'Écrivain" -> rue, de, l, ecrivain; "Große Str." -> grosse,
/// strasse. Latin letters lose their marks, Greek and Cyrillic ones become small, others stay; usual abbreviations are
/// written out. Bytes that are no UTF-8 part words.
std::vector<std::string> folded_words(std::string_view text);

/// How well a typed word fits a word: 1 the same, less for a beginning, a part, or one (from 8 letters two) typing
/// errors: a letter too many, too few, wrong, or two swapped; 0: not at all. Numbers fit only as they are or begin.
/// Needs   both from folded_words.
double fit(std::string_view typed, std::string_view word);

}  // namespace vicus
