#include "x3d_export/reveal_strips.hpp"

#include <algorithm>
#include <map>

#include "x3d_export/frames.hpp"

namespace vicus {
namespace {

/// An opening in mm, seen along one axis: `low` ... `high` across the strips, `from` ... `to` along them.
struct Span {
  std::int32_t low, high, from, to;
};

/// Does a strip at `at` come out between the two?
bool is_parted(const std::vector<Span>& spans, std::int32_t at, std::int32_t from, std::int32_t to) {
  return std::any_of(spans.begin(), spans.end(), [&](const Span& other) {
    return other.low < at && at < other.high && other.from < to && from < other.to;
  });
}

/// Strips through the sides `side` of all spans.
std::vector<RevealStrip> joined(const std::vector<Span>& spans, std::int32_t Span::*side) {
  std::map<std::int32_t, std::vector<Span>> by_place;
  for (const Span& span : spans) by_place[span.*side].push_back(span);
  std::vector<RevealStrip> strips;
  for (auto& [at, list] : by_place) {
    std::sort(list.begin(), list.end(),
              [](const Span& a, const Span& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    std::size_t first = strips.size();
    for (const Span& span : list) {
      if (strips.size() > first && !is_parted(spans, at, strips.back().to, span.from))
        strips.back().to = std::max(strips.back().to, span.to);
      else
        strips.push_back({at, span.from, span.to});
    }
  }
  return strips;
}

}  // namespace

RevealStrips reveal_strips(const std::vector<Opening>& openings) {
  std::vector<Span> across, upward;
  for (const Opening& o : openings) {
    const std::int32_t x0 = height_mm(o.x0), x1 = height_mm(o.x1), z0 = height_mm(o.z0), z1 = height_mm(o.z1);
    across.push_back({x0, x1, z0, z1});
    upward.push_back({z0, z1, x0, x1});
  }
  return {joined(across, &Span::low), joined(across, &Span::high), joined(upward, &Span::low),
          joined(upward, &Span::high)};
}

}  // namespace vicus
