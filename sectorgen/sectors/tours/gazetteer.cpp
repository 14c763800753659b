#include "sectorgen/sectors/tours/gazetteer.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "sectorgen/sectors/tours/folded_text.hpp"

namespace vicus {
namespace {

constexpr float kDetailShare = 0.9f;  // of a word that says where the place stands, against one of its name
constexpr double kCoverShare = 0.25;  // of the score: how much of the name was typed
constexpr double kWeightShare = 0.05;
constexpr double kMissingWords = 1.0 / 3;  // that may be unknown, where no place has all

}  // namespace

Gazetteer::Gazetteer(const std::vector<NamedPlace>& places) {
  std::map<std::string, std::vector<Mention>> index;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    float letters = 0;
    for (const auto& word : folded_words(places[i].place.name)) {
      letters += static_cast<float>(word.size());
      auto& mentions = index[word];
      if (mentions.empty() || mentions.back().place != i) mentions.push_back({i, 1});
    }
    for (const auto* more : {&places[i].place.detail, &places[i].place.kind})
      for (const auto& word : folded_words(*more)) {
        auto& mentions = index[word];
        if (mentions.empty() || mentions.back().place != i) mentions.push_back({i, kDetailShare});
      }
    letters_.push_back(std::max(1.0f, letters));
    weight_.push_back(static_cast<float>(places[i].weight));
  }
  for (auto& [word, mentions] : index) {
    words_.push_back(word);
    mentions_.push_back(std::move(mentions));
  }
}

std::vector<FoundPlace> Gazetteer::find(std::string_view text, std::size_t limit) const {
  auto typed = folded_words(text.substr(0, kMostTyped));
  if (typed.size() > kMostWords) typed.resize(kMostWords);
  if (typed.empty() || limit == 0) return {};
  struct Tally {
    double score = 0, letters = 0, best = 0;
    std::uint32_t words = 0, last = 0;  // `last`: the typed word that `best` is of, + 1
  };
  std::vector<Tally> tally(letters_.size());
  std::vector<std::uint32_t> touched;
  double total = 0;
  for (std::uint32_t q = 0; q < typed.size(); ++q) {
    std::vector<std::pair<std::uint32_t, double>> fits;
    std::size_t count = 0;
    for (std::uint32_t w = 0; w < words_.size(); ++w)
      if (const double f = fit(typed[q], words_[w]); f > 0) {
        fits.emplace_back(w, f);
        count += mentions_[w].size();
      }
    // What many places have ("rue") tells less.
    const double telling = std::log(2 + static_cast<double>(letters_.size()) / static_cast<double>(count + 1));
    total += telling;
    for (const auto& [w, f] : fits)
      for (const Mention& m : mentions_[w]) {
        Tally& t = tally[m.place];
        if (t.words == 0) touched.push_back(m.place);
        if (t.last != q + 1) {
          t.last = q + 1;
          t.best = 0;
          ++t.words;
          if (m.share == 1) t.letters += static_cast<double>(words_[w].size());
        }
        if (const double better = f * m.share; better > t.best) {
          t.score += telling * (better - t.best);
          t.best = better;
        }
      }
  }
  std::uint32_t most = 0;
  for (const std::uint32_t i : touched) most = std::max(most, tally[i].words);
  const auto needed = static_cast<std::uint32_t>(typed.size());
  std::vector<FoundPlace> found;
  if (most + static_cast<std::uint32_t>(static_cast<double>(needed) * kMissingWords) < needed) return found;
  for (const std::uint32_t i : touched) {
    const Tally& t = tally[i];
    if (t.words < most) continue;
    const double cover = std::min(1.0, t.letters / static_cast<double>(letters_[i]));
    const double score = (1 - kCoverShare) * t.score / total + kCoverShare * cover + kWeightShare * weight_[i];
    found.push_back({i, score, t.words == needed});
  }
  const auto is_better = [](const FoundPlace& a, const FoundPlace& b) {
    return a.score != b.score ? a.score > b.score : a.index < b.index;
  };
  limit = std::min(limit, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(limit), found.end(), is_better);
  found.resize(limit);
  return found;
}

}  // namespace vicus
