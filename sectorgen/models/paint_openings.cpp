#include "sectorgen/models/paint_openings.hpp"

#include <algorithm>

namespace vicus {
namespace {

constexpr Paint kReveal{0.42, 0.39, 0.35}, kFrame{0.90, 0.89, 0.86}, kIron{0.14, 0.15, 0.17};
constexpr Paint kGlassLow{0.18, 0.22, 0.27}, kGlassHigh{0.43, 0.51, 0.59}, kCurtain{0.82, 0.81, 0.77};
constexpr Paint kShade{0.05, 0.05, 0.06};
constexpr Paint kDoor{0.24, 0.20, 0.15}, kChurchDoor{0.27, 0.17, 0.11}, kGate{0.36, 0.36, 0.33};
constexpr Paint kSign{0.42, 0.14, 0.12}, kShopFrame{0.16, 0.17, 0.18};

void shadows(Canvas& c, const Opening& o) {
  c.rectangle(o.x0, o.z1 - 0.14, o.x1, o.z1, kShade, 0.45);
  c.rectangle(o.x0, o.z0, o.x0 + 0.05, o.z1, kShade, 0.35);
}

/// Panes between bars: `columns` x `rows`, the glass lighter upwards where it mirrors the sky.
void panes(Canvas& c, const Opening& o, int columns, int rows, double bar, int variant) {
  const double brightness = 0.75 + 0.5 * steady_random(variant, 7, 1);
  c.rectangle(o.x0, o.z0, o.x1, o.z1, kReveal);
  c.rectangle(o.x0 + 0.03, o.z0, o.x1 - 0.03, o.z1 - 0.04, kFrame);
  const double width = (o.x1 - o.x0 - 0.06 - bar) / columns, height = (o.z1 - o.z0 - 0.04 - bar) / rows;
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k) {
      const double x = o.x0 + 0.03 + bar + i * width, z = o.z0 + bar + k * height;
      c.gradient(x, z, x + width - bar, z + height - bar,
                 mix(kGlassLow, kGlassHigh, static_cast<double>(k) / rows) * brightness,
                 mix(kGlassLow, kGlassHigh, (k + 1.0) / rows) * brightness, 4);
    }
}

void curtains(Canvas& c, const Opening& o, int variant) {
  for (int side = 0; side < 2; ++side) {
    if (steady_random(variant, side, 4) > 0.55) continue;
    const double width = (o.x1 - o.x0) * (0.12 + 0.2 * steady_random(variant, side + 5, 4));
    const double x = side == 0 ? o.x0 + 0.09 : o.x1 - 0.09 - width;
    c.rectangle(x, o.z0 + 0.1, x + width, o.z1 - 0.12, kCurtain, 0.45);
  }
}

void railing(Canvas& c, const Opening& o) {
  const double top = o.z0 + std::min(0.95, 0.5 * (o.z1 - o.z0));
  c.rectangle(o.x0 - 0.03, top - 0.05, o.x1 + 0.03, top, kIron);
  c.rectangle(o.x0 - 0.03, o.z0 + 0.06, o.x1 + 0.03, o.z0 + 0.1, kIron);
  for (double x = o.x0; x < o.x1; x += 0.11) c.rectangle(x, o.z0 + 0.05, x + 0.028, top, kIron, 0.85);
}

void house_door(Canvas& c, const Opening& o, Paint wood, double fanlight) {
  c.rectangle(o.x0, o.z0, o.x1, o.z1, wood * 0.55);
  const double top = o.z1 - fanlight;
  for (int leaf = 0; leaf < 2; ++leaf) {
    const double middle = (o.x0 + o.x1) / 2, x0 = leaf == 0 ? o.x0 + 0.06 : middle + 0.02,
                 x1 = leaf == 0 ? middle - 0.02 : o.x1 - 0.06, w = x1 - x0;
    c.rectangle(x0, o.z0 + 0.04, x1, top - 0.06, wood);
    for (const auto& [low, high] : {std::pair{0.08, 0.34}, {0.42, 0.92}}) {
      const double z0 = o.z0 + low * (top - o.z0), z1 = o.z0 + high * (top - o.z0);
      c.rectangle(x0 + 0.15 * w, z0, x1 - 0.15 * w, z1, wood * 0.7);
      c.rectangle(x0 + 0.2 * w, z0 + 0.03, x1 - 0.15 * w, z1, wood * 1.25);
    }
  }
  if (fanlight > 0.2) c.gradient(o.x0 + 0.08, top, o.x1 - 0.08, o.z1 - 0.08, kGlassLow, kGlassHigh, 3);
  shadows(c, o);
}

void garage_door(Canvas& c, const Opening& o) {
  c.rectangle(o.x0, o.z0, o.x1, o.z1, kGate);
  for (double z = o.z0 + 0.28; z < o.z1; z += 0.3) c.rectangle(o.x0, z, o.x1, z + 0.035, kGate * 0.65);
  shadows(c, o);
}

void shop_front(Canvas& c, const Opening& o) {
  const double height = o.z1 - o.z0, glass_top = o.z0 + 0.76 * height;
  c.rectangle(o.x0, o.z0, o.x1, o.z1, kShopFrame);
  c.gradient(o.x0 + 0.09, o.z0 + 0.13 * height, o.x1 - 0.09, glass_top, {0.13, 0.15, 0.17}, {0.40, 0.44, 0.47}, 6);
  c.rectangle((o.x0 + o.x1) / 2 - 0.03, o.z0, (o.x0 + o.x1) / 2 + 0.03, glass_top, kShopFrame);
  c.rectangle(o.x0, glass_top + 0.05, o.x1, o.z1, kSign);
  c.rectangle(o.x0 + 0.2 * (o.x1 - o.x0), glass_top + 0.12 * height, o.x1 - 0.2 * (o.x1 - o.x0), o.z1 - 0.07 * height,
              {0.86, 0.79, 0.58}, 0.8);
  c.rectangle(o.x0, o.z1 - 0.08, o.x1, o.z1, kShade, 0.4);
}

/// A pointed light in a wall: tracery, and stone where the arch leaves the rectangle.
void church_window(Canvas& c, const Opening& o, int variant) {
  panes(c, o, 2, 7, 0.07, variant);
  const double width = o.x1 - o.x0, arch = 0.8 * width;
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    const double low = o.z1 - arch + arch * i / kSteps, t = (i + 0.5) / kSteps, cut = 0.5 * width * t * t;
    c.rectangle(o.x0, low, o.x0 + cut, low + arch / kSteps, kReveal * 1.5);
    c.rectangle(o.x1 - cut, low, o.x1, low + arch / kSteps, kReveal * 1.5);
  }
}

void paint_strokes(Canvas& c, const Opening& o) {
  constexpr int variant = 3;  // of curtains and glass
  switch (o.kind) {
    case OpeningKind::tall_window:
      panes(c, o, 2, 3, 0.07, variant);
      curtains(c, o, variant);
      shadows(c, o);
      railing(c, o);
      return;
    case OpeningKind::window:
      panes(c, o, 2, 2, 0.07, variant);
      curtains(c, o, variant);
      shadows(c, o);
      return;
    case OpeningKind::wide_window:
      panes(c, o, 3, 1, 0.08, variant);
      curtains(c, o, variant);
      shadows(c, o);
      return;
    case OpeningKind::church_window:
      church_window(c, o, variant);
      return;
    case OpeningKind::house_door:
      house_door(c, o, kDoor, 0.22 * (o.z1 - o.z0));
      return;
    case OpeningKind::church_door:
      house_door(c, o, kChurchDoor, 0.1);
      return;
    case OpeningKind::gate_door:
      garage_door(c, o);
      return;
    case OpeningKind::shop:
      shop_front(c, o);
      return;
  }
}

}  // namespace

Canvas paint_tile(OpeningKind kind) {
  // The size in which the kind usually comes, so that frames and bars have their true width.
  constexpr std::pair<double, double> kSizes[kOpeningKinds] = {{1.12, 2.1}, {1.06, 1.55}, {1.75, 1.45}, {1.5, 4.6},
                                                               {1.3, 2.6},  {2.4, 3.8},   {2.4, 2.2},   {2.3, 3.2}};
  const auto& [width, height] = kSizes[static_cast<std::size_t>(kind)];
  Canvas tile(kTilePixels, kTilePixels, width, height);
  paint_strokes(tile, {kind, 0, width, 0, height, 0, 0});
  return tile;
}

void paint_opening(Canvas& canvas, const Opening& o) {
  static const std::vector<Canvas> kTiles = [] {
    std::vector<Canvas> tiles;
    for (std::size_t i = 0; i < kOpeningKinds; ++i) tiles.push_back(paint_tile(static_cast<OpeningKind>(i)));
    return tiles;
  }();
  canvas.draw(kTiles[static_cast<std::size_t>(o.kind)], kTileInset_px, o.x0, o.z0, o.x1, o.z1);
}

Canvas paint_atlas() {
  Canvas atlas(kAtlasColumns * kTilePixels, kAtlasRows * kTilePixels, 1, 1);
  for (int i = 0; i < static_cast<int>(kOpeningKinds); ++i)
    atlas.paste(paint_tile(static_cast<OpeningKind>(i)), i % kAtlasColumns * kTilePixels,
                i / kAtlasColumns * kTilePixels);
  return atlas;
}

}  // namespace vicus
