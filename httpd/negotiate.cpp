#include "httpd/negotiate.hpp"

#include <algorithm>
#include <array>

#include "httpd/message.hpp"

namespace vicus {
namespace {

constexpr int kQualityOne = 1000;
constexpr std::array<std::string_view, 3> kCodings = {"br", "gzip", "identity"};

bool is_token_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         (c != '\0' && std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos);
}

/// Reads RFC 9110's list elements from the front of a field value.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}
  bool at_end() const { return at_ == text_.size(); }
  void skip_space() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string_view token() {
    const auto begin = at_;
    while (!at_end() && is_token_char(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// A quoted string without its quotes, escapes left as they are.
  std::optional<std::string_view> quoted() {
    if (!take('"')) return std::nullopt;
    const auto begin = at_;
    for (; !at_end(); ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size())
        ++at_;
      else if (text_[at_] == '"')
        return text_.substr(begin, at_++ - begin);
    }
    return std::nullopt;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// qvalue = ( "0" [ "." 0*3DIGIT ] ) / ( "1" [ "." 0*3("0") ] ), in thousandths.
std::optional<int> quality_of(std::string_view text) {
  if (text.empty() || (text[0] != '0' && text[0] != '1')) return std::nullopt;
  int quality = (text[0] - '0') * kQualityOne;
  if (text.size() == 1) return quality;
  if (text[1] != '.' || text.size() > 5) return std::nullopt;
  int step = kQualityOne / 10;
  for (const char digit : text.substr(2)) {
    if (digit < '0' || digit > '9') return std::nullopt;
    quality += (digit - '0') * step;
    step /= 10;
  }
  return quality <= kQualityOne ? std::optional(quality) : std::nullopt;
}

/// `*( OWS ";" OWS name "=" value )`: the weight, and whether other parameters came before it.
struct Parameters {
  int quality = kQualityOne;
  bool has_other = false;
};
std::optional<Parameters> read_parameters(Reader& reader) {
  Parameters parameters;
  bool has_quality = false;
  for (;;) {
    reader.skip_space();
    if (!reader.take(';')) return parameters;
    reader.skip_space();
    const auto name = reader.token();
    if (name.empty() || !reader.take('=')) return std::nullopt;
    auto value = reader.token();
    if (value.empty()) {
      const auto quoted = reader.quoted();
      if (!quoted) return std::nullopt;
      value = *quoted;
    }
    if (!equal_ignoring_case(name, "q")) {
      parameters.has_other |= !has_quality;  // what follows q is an accept-ext (RFC 7231) and means nothing here
      continue;
    }
    const auto quality = quality_of(value);
    if (!quality || has_quality) return std::nullopt;
    parameters.quality = *quality;
    has_quality = true;
  }
}

struct MediaRange {
  std::string_view type, subtype;
  Parameters parameters;
};

std::optional<std::vector<MediaRange>> read_accept(std::string_view text) {
  std::vector<MediaRange> ranges;
  Reader reader(text);
  for (;;) {
    reader.skip_space();
    if (reader.at_end()) return ranges;
    if (reader.take(',')) continue;
    MediaRange range;
    range.type = reader.token();
    if (range.type.empty() || !reader.take('/')) return std::nullopt;
    range.subtype = reader.token();
    if (range.subtype.empty()) return std::nullopt;
    const auto parameters = read_parameters(reader);
    if (!parameters) return std::nullopt;
    range.parameters = *parameters;
    ranges.push_back(range);
    if (!reader.at_end() && !reader.take(',')) return std::nullopt;
  }
}

int quality_among(const std::vector<MediaRange>& ranges, std::string_view media_type) {
  const auto slash = std::min(media_type.find('/'), media_type.size());
  const auto type = media_type.substr(0, slash);
  const auto subtype = slash < media_type.size() ? media_type.substr(slash + 1) : std::string_view();
  int best_rank = -1, quality = 0;
  for (const auto& range : ranges) {
    if (range.parameters.has_other) continue;
    int rank = -1;
    if (range.type == "*" && range.subtype == "*")
      rank = 0;
    else if (equal_ignoring_case(range.type, type) && range.subtype == "*")
      rank = 1;
    else if (equal_ignoring_case(range.type, type) && equal_ignoring_case(range.subtype, subtype))
      rank = 2;
    if (rank > best_rank) {
      best_rank = rank;
      quality = range.parameters.quality;
    }
  }
  return quality;
}

}  // namespace

std::optional<std::vector<std::string>> accepted_codings(const std::optional<std::string>& field) {
  if (!field) return std::vector<std::string>{"identity", "gzip", "br"};
  std::array<int, kCodings.size()> quality{-1, -1, -1};  // -1: not mentioned
  int any = -1;
  Reader reader(*field);
  for (;;) {
    reader.skip_space();
    if (reader.at_end()) break;
    if (reader.take(',')) continue;
    auto coding = reader.token();
    if (coding.empty()) return std::nullopt;
    const auto parameters = read_parameters(reader);
    if (!parameters || parameters->has_other) return std::nullopt;
    if (!reader.at_end() && !reader.take(',')) return std::nullopt;
    if (equal_ignoring_case(coding, "x-gzip")) coding = "gzip";  // RFC 9110 §8.4.1.3
    if (coding == "*" && any < 0) any = parameters->quality;
    for (std::size_t i = 0; i < kCodings.size(); ++i)
      if (equal_ignoring_case(coding, kCodings[i]) && quality[i] < 0) quality[i] = parameters->quality;
  }
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < kCodings.size(); ++i) {
    const bool is_identity = kCodings[i] == "identity";
    int q = quality[i];
    if (q < 0)
      q = any >= 0 ? any * 2 : is_identity ? 1 : 0;  // below: mentioned ones count double, 1 is the least
    else
      q *= 2;
    if (q > 0) order.emplace_back(-q, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::string> codings;
  for (const auto& [q, i] : order) codings.emplace_back(kCodings[i]);
  return codings;
}

std::optional<int> media_quality(const std::optional<std::string>& field, std::string_view media_type) {
  if (!field) return kQualityOne;
  const auto ranges = read_accept(*field);
  if (!ranges) return std::nullopt;
  return ranges->empty() ? kQualityOne : quality_among(*ranges, media_type);
}

std::optional<std::string> preferred_media_type(const std::optional<std::string>& field,
                                                const std::vector<std::string>& media_types) {
  std::string best;
  int best_quality = 0;
  for (const auto& media_type : media_types) {
    const auto quality = media_quality(field, media_type);
    if (!quality) return std::nullopt;
    if (*quality > best_quality) best_quality = *quality, best = media_type;
  }
  return best;
}

}  // namespace vicus
