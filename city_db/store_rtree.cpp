#include "city_db/store_rtree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vicus {
namespace {

// A node: u16 depth of the tree (root only), u16 number of cells, then cells: i64 id, f32 min x, max x, min y, max y;
// all big-endian, padded to the size of the empty root.
constexpr std::size_t kNodeHeaderBytes = 4, kCellBytes = 24;
constexpr std::int64_t kRoot = 1;

struct Cell {
  std::int64_t id = 0;  ///< of the row, or the child node
  float min_x = 0, max_x = 0, min_y = 0, max_y = 0;
};

float below(double v) {
  const auto f = static_cast<float>(v);
  return f > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float above(double v) {
  const auto f = static_cast<float>(v);
  return f < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// Place along the Hilbert curve of order 31 over the lattice.
std::uint64_t hilbert(const PlanBox& box) {
  auto x = static_cast<std::uint32_t>((std::int64_t{box.min.x} + box.max.x) / 2 + kPlanLimit);
  auto y = static_cast<std::uint32_t>((std::int64_t{box.min.y} + box.max.y) / 2 + kPlanLimit);
  std::uint64_t place = 0;
  for (std::uint32_t side = 1u << 30; side > 0; side >>= 1) {
    const bool right = (x & side) != 0, upper = (y & side) != 0;
    place = place << 2 | (right ? (upper ? 2u : 3u) : (upper ? 1u : 0u));
    if (upper) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return place;
}

class NodeBytes {
 public:
  explicit NodeBytes(std::size_t size) : bytes_(size, '\0') {}
  void put(std::uint64_t value, std::size_t n) {
    for (; n > 0; --n) bytes_[at_++] = static_cast<char>(value >> (8 * (n - 1)));
  }
  void put(float value) { put(std::bit_cast<std::uint32_t>(value), 4); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

class RtreePacker {
 public:
  RtreePacker(Database& db, const std::string& rtree)
      : node_(db.prepare("INSERT OR REPLACE INTO \"" + rtree + "_node\" VALUES (?1, ?2)")),
        parent_(db.prepare("INSERT INTO \"" + rtree + "_parent\" VALUES (?1, ?2)")) {
    auto root = db.prepare("SELECT length(data) FROM \"" + rtree + "_node\" WHERE nodeno = 1");
    root.step();
    node_bytes_ = static_cast<std::size_t>(root.integer(0));
    capacity_ = (node_bytes_ - kNodeHeaderBytes) / kCellBytes;
  }

  std::size_t capacity() const { return capacity_; }

  /// The level above `cells`: one cell per node of at most capacity() of them.
  std::vector<Cell> pack(const std::vector<Cell>& cells, bool is_leaf) {
    std::vector<Cell> level;
    for (std::size_t begin = 0; begin < cells.size(); begin += capacity_) {
      const std::size_t end = std::min(begin + capacity_, cells.size());
      const std::int64_t number = next_node_++;
      write_node(number, 0, cells, begin, end, is_leaf);
      Cell all = cells[begin];
      all.id = number;
      for (std::size_t i = begin; i < end; ++i) {
        all.min_x = std::min(all.min_x, cells[i].min_x);
        all.max_x = std::max(all.max_x, cells[i].max_x);
        all.min_y = std::min(all.min_y, cells[i].min_y);
        all.max_y = std::max(all.max_y, cells[i].max_y);
      }
      level.push_back(all);
    }
    return level;
  }

  void write_node(std::int64_t number, unsigned depth, const std::vector<Cell>& cells, std::size_t begin,
                  std::size_t end, bool is_leaf) {
    NodeBytes node(node_bytes_);
    node.put(depth, 2);
    node.put(end - begin, 2);
    for (std::size_t i = begin; i < end; ++i) {
      const Cell& cell = cells[i];
      node.put(static_cast<std::uint64_t>(cell.id), 8);
      for (const float v : {cell.min_x, cell.max_x, cell.min_y, cell.max_y}) node.put(v);
      if (is_leaf) continue;
      parent_.bind(0, cell.id);
      parent_.bind(1, number);
      parent_.run();
    }
    node_.bind(0, number);
    node_.bind_blob(1, node.bytes());
    node_.run();
  }

 private:
  Statement node_, parent_;
  std::size_t node_bytes_ = 0, capacity_ = 0;
  std::int64_t next_node_ = kRoot + 1;
};

std::vector<std::size_t> along_curve(const std::vector<RtreeEntry>& entries) {
  std::vector<std::pair<std::uint64_t, std::size_t>> places;
  places.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) places.emplace_back(hilbert(entries[i].box), i);
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> order;
  order.reserve(places.size());
  for (const auto& [place, i] : places) order.push_back(i);
  return order;
}

}  // namespace

void fill_rtree(Database& db, const std::string& rtree, const std::vector<RtreeEntry>& entries) {
  RtreePacker packer(db, rtree);
  const auto order = along_curve(entries);
  std::vector<Cell> cells;
  cells.reserve(entries.size());
  for (const std::size_t i : order) {
    const auto& [id, box] = entries[i];
    cells.push_back(
        {id, below(metres(box.min.x)), above(metres(box.max.x)), below(metres(box.min.y)), above(metres(box.max.y))});
  }
  std::vector<std::int64_t> leaf_of(entries.size(), kRoot);
  if (cells.size() > packer.capacity())
    for (std::size_t place = 0; place < order.size(); ++place)
      leaf_of[order[place]] = kRoot + 1 + static_cast<std::int64_t>(place / packer.capacity());
  unsigned depth = 0;
  for (; cells.size() > packer.capacity(); ++depth) cells = packer.pack(cells, depth == 0);
  packer.write_node(kRoot, depth, cells, 0, cells.size(), depth == 0);

  auto rowid = db.prepare("INSERT INTO \"" + rtree + "_rowid\" VALUES (?1, ?2)");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    rowid.bind(0, entries[i].id);
    rowid.bind(1, leaf_of[i]);
    rowid.run();
  }
}

}  // namespace vicus
