#include "sectorgen/sectors/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

constexpr double kMaxCells = 48e6;  // 60 km square at 9 m

/// Lower envelope of parabolas along one line of n samples, in place.
void transform_line(std::vector<float>& f, int n, std::vector<int>& v, std::vector<float>& z, std::vector<float>& out) {
  const float kFar = std::numeric_limits<float>::infinity();
  int k = -1;
  for (int q = 0; q < n; ++q) {
    const auto uq = static_cast<std::size_t>(q);
    if (f[uq] == kFar) continue;
    float s = -kFar;
    while (k >= 0) {
      const auto p = static_cast<std::size_t>(v[static_cast<std::size_t>(k)]);
      const float qf = static_cast<float>(q), pf = static_cast<float>(p);
      s = ((f[uq] + qf * qf) - (f[p] + pf * pf)) / (2 * (qf - pf));
      if (s > z[static_cast<std::size_t>(k)]) break;
      --k;
      s = -kFar;
    }
    ++k;
    v[static_cast<std::size_t>(k)] = q;
    z[static_cast<std::size_t>(k)] = s;
  }
  for (int q = 0, i = 0; q < n; ++q) {
    const auto uq = static_cast<std::size_t>(q);
    if (k < 0) {
      out[uq] = kFar;
      continue;
    }
    while (i < k && z[static_cast<std::size_t>(i + 1)] < static_cast<float>(q)) ++i;
    const auto p = v[static_cast<std::size_t>(i)];
    const auto d = static_cast<float>(q - p);
    out[uq] = d * d + f[static_cast<std::size_t>(p)];
  }
}

/// Fills what the border of the raster does not reach through unmarked cells.
Mask without_holes(const Raster& r, const Mask& mask) {
  Mask reached(r.size(), 0);
  std::vector<std::size_t> queue;
  const auto push = [&](int c, int y) {
    if (c < 0 || y < 0 || c >= r.columns || y >= r.rows) return;
    const std::size_t i = r.index(c, y);
    if (mask[i] || reached[i]) return;
    reached[i] = 1;
    queue.push_back(i);
  };
  for (int c = 0; c < r.columns; ++c) push(c, 0), push(c, r.rows - 1);
  for (int y = 0; y < r.rows; ++y) push(0, y), push(r.columns - 1, y);
  while (!queue.empty()) {
    const std::size_t i = queue.back();
    queue.pop_back();
    const int c = static_cast<int>(i % static_cast<std::size_t>(r.columns)),
              y = static_cast<int>(i / static_cast<std::size_t>(r.columns));
    push(c - 1, y), push(c + 1, y), push(c, y - 1), push(c, y + 1);
  }
  for (char& x : reached) x = static_cast<char>(!x);
  return reached;
}

}  // namespace

Raster Raster::over(const PlanBox& box, double cell_m, double margin_m) {
  Raster r;
  const double width = metres(std::int64_t{box.max.x} - box.min.x) + 2 * margin_m;
  const double height = metres(std::int64_t{box.max.y} - box.min.y) + 2 * margin_m;
  cell_m = std::max(cell_m, std::ceil(std::sqrt(width * height / kMaxCells)));
  r.cell_mm = lattice_mm(cell_m);
  const std::int32_t margin = lattice_mm(margin_m);
  // Cells lie on multiples of their size, so that an edit elsewhere moves none of them.
  const auto floor_to = [&](std::int64_t v) { return (v >= 0 ? v : v - r.cell_mm + 1) / r.cell_mm * r.cell_mm; };
  r.min = {static_cast<std::int32_t>(floor_to(std::int64_t{box.min.x} - margin)),
           static_cast<std::int32_t>(floor_to(std::int64_t{box.min.y} - margin))};
  r.columns = static_cast<int>((std::int64_t{box.max.x} + margin - r.min.x) / r.cell_mm) + 2;
  r.rows = static_cast<int>((std::int64_t{box.max.y} + margin - r.min.y) / r.cell_mm) + 2;
  return r;
}

int Raster::column_of(std::int32_t x) const {
  return static_cast<int>(std::clamp<std::int64_t>((std::int64_t{x} - min.x) / cell_mm, 0, columns - 1));
}
int Raster::row_of(std::int32_t y) const {
  return static_cast<int>(std::clamp<std::int64_t>((std::int64_t{y} - min.y) / cell_mm, 0, rows - 1));
}

void paint(const Raster& r, const std::vector<PlanPoint>& line, Mask& mask) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PlanPoint a = line[i], b = line[i + 1];
    const double length = std::sqrt(static_cast<double>(distance2(a, b)));
    const int steps = static_cast<int>(length * 2 / r.cell_mm) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      mask[r.cell_at({static_cast<std::int32_t>(a.x + t * (double(b.x) - a.x)),
                      static_cast<std::int32_t>(a.y + t * (double(b.y) - a.y))})] = 1;
    }
  }
}

void paint(const Raster& r, const Polygon& polygon, Mask& mask) {
  const auto edges = [&](const Ring& ring) {
    Ring closed = ring;
    closed.push_back(ring.front());
    paint(r, closed, mask);
  };
  edges(polygon.outer);
  for (const auto& hole : polygon.holes) edges(hole);
  const PlanBox box = box_of(polygon);
  std::vector<double> xs;
  for (int row = r.row_of(box.min.y); row <= r.row_of(box.max.y); ++row) {
    const double y = r.min.y + (row + 0.5) * r.cell_mm;
    xs.clear();
    const auto scan = [&](const Ring& ring) {
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if ((ring[j].y > y) != (ring[i].y > y))
          xs.push_back(ring[j].x + (y - ring[j].y) / (double(ring[i].y) - ring[j].y) * (double(ring[i].x) - ring[j].x));
    };
    scan(polygon.outer);
    for (const auto& hole : polygon.holes) scan(hole);
    std::sort(xs.begin(), xs.end());
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2) {
      const int first = static_cast<int>(std::ceil((xs[k] - r.min.x) / r.cell_mm - 0.5));
      const int last = static_cast<int>(std::floor((xs[k + 1] - r.min.x) / r.cell_mm - 0.5));
      for (int c = std::max(0, first); c <= std::min(last, r.columns - 1); ++c) mask[r.index(c, row)] = 1;
    }
  }
}

std::vector<float> distance_m(const Raster& r, const Mask& mask) {
  std::vector<float> d(r.size());
  const int n = std::max(r.columns, r.rows);
  std::vector<float> f(static_cast<std::size_t>(n)), z(static_cast<std::size_t>(n) + 1),
      out(static_cast<std::size_t>(n));
  std::vector<int> v(static_cast<std::size_t>(n));
  for (int row = 0; row < r.rows; ++row) {
    for (int c = 0; c < r.columns; ++c)
      f[static_cast<std::size_t>(c)] = mask[r.index(c, row)] ? 0.f : std::numeric_limits<float>::infinity();
    transform_line(f, r.columns, v, z, out);
    std::copy_n(out.begin(), r.columns, d.begin() + static_cast<std::ptrdiff_t>(r.index(0, row)));
  }
  const float cell = static_cast<float>(metres(r.cell_mm));
  for (int c = 0; c < r.columns; ++c) {
    for (int row = 0; row < r.rows; ++row) f[static_cast<std::size_t>(row)] = d[r.index(c, row)];
    transform_line(f, r.rows, v, z, out);
    for (int row = 0; row < r.rows; ++row)
      d[r.index(c, row)] = std::min(std::sqrt(out[static_cast<std::size_t>(row)]) * cell, 1e6f);
  }
  return d;
}

std::vector<Polygon> outlines(const Raster& r, const Mask& with_holes) {
  const Mask mask = without_holes(r, with_holes);
  const auto at = [&](int c, int y) { return c >= 0 && y >= 0 && c < r.columns && y < r.rows && mask[r.index(c, y)]; };
  // Walk cell edges with the marked cell on the left; direction 0 east, 1 north, 2 west, 3 south. An eastward edge at
  // the lower side of a marked cell starts each ring; `seen` marks those.
  Mask seen(r.size(), 0);
  std::vector<Polygon> out;
  constexpr int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};
  for (int y0 = 0; y0 < r.rows; ++y0)
    for (int c0 = 0; c0 < r.columns; ++c0) {
      if (!at(c0, y0) || at(c0, y0 - 1) || seen[r.index(c0, y0)]) continue;
      Line ring;
      int x = c0, y = y0, dir = 0;
      do {
        if (dir == 0) seen[r.index(x, y)] = 1;
        // Half way along each cell edge: corners come out cut at 45 degrees.
        ring.push_back(
            {r.min.x + x * r.cell_mm + dx[dir] * r.cell_mm / 2, r.min.y + y * r.cell_mm + dy[dir] * r.cell_mm / 2});
        x += dx[dir], y += dy[dir];
        // Cells ahead, seen from the vertex reached: left and right of the direction.
        const int lx = dir == 0   ? x
                       : dir == 1 ? x - 1
                       : dir == 2 ? x - 1
                                  : x,
                  ly = dir == 0   ? y
                       : dir == 1 ? y
                       : dir == 2 ? y - 1
                                  : y - 1;
        const int rx = dir == 0   ? x
                       : dir == 1 ? x
                       : dir == 2 ? x - 1
                                  : x - 1,
                  ry = dir == 0   ? y - 1
                       : dir == 1 ? y
                       : dir == 2 ? y
                                  : y - 1;
        if (at(rx, ry))
          dir = (dir + 3) % 4;  // diagonal neighbours hang together
        else if (!at(lx, ly))
          dir = (dir + 1) % 4;
      } while (x != c0 || y != y0 || dir != 0);
      // Start anywhere but on the middle of a straight side: at the smallest point, a corner.
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
      ring.push_back(ring.front());
      Line line = simplify(ring, metres(r.cell_mm) * 0.75);
      line.pop_back();
      std::vector<Ring> rings;
      for (auto& simple : simple_rings(line))
        if (area2(simple) > 0) rings.push_back(std::move(simple));
      for (auto& p : assemble(std::move(rings))) out.push_back(std::move(p));
    }
  return out;
}

}  // namespace vicus
