#include "cli/measure_tile_forms.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/blockmap.hpp"
#include "cli/measure_ground_mesh.hpp"
#include "cli/measure_memory.hpp"
#include "cli/measure_prism_mesh.hpp"
#include "cli/measure_tile_choice.hpp"
#include "cli/measure_tile_tracer.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"
#include "sectorgen/bake/bake_ground.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "x3d_export/coding.hpp"

namespace vicus::measure {
namespace {

constexpr int kBrotli = 9;  // as the server codes tiles

std::string setting_of(double tau_px) {
  char text[32];
  std::snprintf(text, sizeof text, "tau %g px", tau_px);
  return text;
}

/// One tile in its form.
struct MadeTile {
  std::uint64_t bytes = 0;
  double error_m = 0, memory_bytes = 0, decode_cpu_ms = 0;
  std::shared_ptr<const CastTile> cast;     // of a height field
  std::shared_ptr<const PrismTile> prisms;  // or of polygons
};

/// What all kinds share: the tree, tiles made when first looked at and kept, pictures of a choice.
class TileForm : public Representation {
 public:
  TileForm(SharedCity& city, FormName name) : city_(city), name_(std::move(name)), levels_(levels_of(city.city())) {
    name_.setting = setting_of(name_.tau_px);
  }

  const FormName& name() const override { return name_; }
  bool shows(Path) const override { return true; }

  Parts choose(const Pose& pose, double pixels_per_radian, const Parts& before) override {
    std::vector<TileAddress> drawn;
    for (const std::string& part : before)
      if (const auto at = parse_tile(part, levels_)) drawn.push_back(*at);
    std::set<TileAddress> refined = above(drawn);
    const TileTree tree{levels_, [this](const TileAddress& at) -> std::optional<double> {
                          return has(at) ? std::optional(error_m(at)) : std::nullopt;
                        }};
    Parts out;
    for (const TileAddress& at : choose_tiles(tree, {pose.eye, pixels_per_radian, name_.tau_px}, refined))
      out.push_back(std::to_string(at.z) + "/" + std::to_string(at.x) + "/" + std::to_string(at.y));
    return out;
  }

  Shown show(const Parts& parts) override {
    Shown out;
    std::vector<std::shared_ptr<const CastTile>> casts;
    RenderMesh mesh;
    for (const std::string& part : parts) {
      const TileAddress at = parse_tile(part, levels_).value();
      const MadeTile& tile = made(at);
      out.files.push_back({vicus::tile_path(at), tile.bytes});
      out.memory_bytes += tile.memory_bytes;
      out.decode_cpu_ms += tile.decode_cpu_ms;
      if (tile.cast) casts.push_back(tile.cast);
      if (tile.prisms) {
        const double start = cpu_ms();
        out.memory_bytes -= add_prisms(mesh, *tile.prisms, draws_all_prisms());
        out.decode_cpu_ms += cpu_ms() - start;
      }
    }
    if (has_ground_tiles()) add_ground_of(parts, out, mesh);
    out.memory_bytes += memory_of(mesh);
    city_.add_sheet(mesh);
    out.tracer = std::make_shared<TileTracer>(std::move(casts), std::move(mesh));
    return out;
  }

 protected:
  virtual bool has(const TileAddress& at) { return at.z == 0 || houses(at) > 0; }
  virtual double error_m(const TileAddress& at) { return made(at).error_m; }
  virtual MadeTile make(const TileAddress& at) = 0;
  virtual bool draws_all_prisms() const { return false; }
  virtual bool has_ground_tiles() const { return false; }  ///< prisms come with a file of ground each

  const MadeTile& made(const TileAddress& at) {
    const auto known = made_.find(at);
    return known != made_.end() ? known->second : made_.emplace(at, make(at)).first->second;
  }
  PlanPoint corner(const TileAddress& at) const { return tile_corner(levels_, at); }
  std::uint32_t side_mm(const TileAddress& at) const { return tile_side_mm(levels_, at.z); }
  std::size_t houses(const TileAddress& at) {
    const auto known = houses_.find(at);  // asked at every step of a path
    if (known != houses_.end()) return known->second;
    return houses_[at] = city_.bake_scene().houses_in(tile_box(levels_, at)).size();
  }

  MadeTile blockmap(const TileAddress& at, std::uint32_t cells) {
    BlockMapOptions options;
    options.side = cells;
    const std::string bytes = encode_blockmap(bake_blockmap(city_.bake_scene(), corner(at), side_mm(at), options));
    MadeTile tile;
    tile.bytes = brotli(bytes, kBrotli).size();
    const double start = cpu_ms();
    BlockMap map = decode_blockmap(bytes).value();
    tile.error_m = map.error_mm / kMmPerMetre;
    tile.memory_bytes = memory_of(map);
    tile.cast = cast_tile(std::move(map));
    tile.decode_cpu_ms = cpu_ms() - start;
    return tile;
  }

  MadeTile prisms(const TileAddress& at) {
    const std::string bytes = encode_prisms(bake_prisms(city_.bake_scene(), corner(at), side_mm(at)));
    MadeTile tile;
    tile.bytes = std::min(brotli(bytes, kBrotli).size(), bytes.size());
    const double start = cpu_ms();
    tile.prisms = std::make_shared<PrismTile>(decode_prisms(bytes).value());
    tile.error_m = tile.prisms->error_mm / kMmPerMetre;
    tile.decode_cpu_ms = cpu_ms() - start;
    return tile;
  }

  SharedCity& city_;
  FormName name_;
  const int levels_;

 private:
  struct MadeGround {
    std::uint64_t bytes = 0;
    double decode_cpu_ms = 0;
    ReadGround read;
  };
  const MadeGround& ground(const TileAddress& at) {
    const auto known = grounds_.find(at);
    if (known != grounds_.end()) return known->second;
    const std::string bytes = encode_ground(bake_ground(city_.bake_scene(), corner(at), side_mm(at)));
    MadeGround made;
    made.bytes = std::min(brotli(bytes, kBrotli).size(), bytes.size());
    // Light from the sky is left out, as with BlockMaps: the truth has none.
    const std::string shown = encode_ground(bake_ground(city_.bake_scene(), corner(at), side_mm(at), false));
    const double start = cpu_ms();
    made.read = read_ground(decode_ground(shown).value());
    made.decode_cpu_ms = cpu_ms() - start;
    return grounds_.emplace(at, std::move(made)).first->second;
  }

  /// Of the tiles drawn as prisms, and where a tile above them lacks a child, that one's quadrant (paper 001, Fig. 8).
  void add_ground_of(const Parts& parts, Shown& out, RenderMesh& mesh) {
    std::map<TileAddress, unsigned> quadrants;
    std::vector<TileAddress> drawn;
    for (const std::string& part : parts) drawn.push_back(parse_tile(part, levels_).value());
    for (const TileAddress& at : drawn)
      if (made(at).prisms) quadrants[at] = kWholeTile;
    const std::set<TileAddress> refined = above(drawn), leaves(drawn.begin(), drawn.end());
    for (const TileAddress& at : refined)
      for (int child = 0; child < 4; ++child)
        if (!refined.contains(child_of(at, child)) && !leaves.contains(child_of(at, child)))
          quadrants[at] |= 1u << child;
    for (const auto& [at, which] : quadrants) {
      const MadeGround& made = ground(at);
      const double start = cpu_ms();
      add_ground(mesh, made.read, which);
      out.decode_cpu_ms += made.decode_cpu_ms + cpu_ms() - start;
      out.files.push_back({vicus::tile_path(at, TileKind::ground), made.bytes});
    }
  }

  std::map<TileAddress, MadeTile> made_;
  std::map<TileAddress, MadeGround> grounds_;
  std::map<TileAddress, std::size_t> houses_;
};

class BlockMapTiles : public TileForm {
 public:
  BlockMapTiles(SharedCity& city, std::uint32_t cells, double tau_px)
      : TileForm(city, {"BlockMap+ " + std::to_string(cells), {}, tau_px}), cells_(cells) {}

 private:
  MadeTile make(const TileAddress& at) override { return blockmap(at, cells_); }
  std::uint32_t cells_;
};

class PaperTiles : public TileForm {
 public:
  PaperTiles(SharedCity& city, int year, std::uint32_t side, std::uint32_t columns, double tau_px)
      : TileForm(city, {"BlockMap " + std::to_string(year) + " " + std::to_string(side) + ":" + std::to_string(columns),
                        {},
                        tau_px}),
        year_(year == 2007 ? PaperYear::y2007 : PaperYear::y2009),
        side_(side),
        columns_(columns) {}

 private:
  MadeTile make(const TileAddress& at) override {
    PaperBlockMap map = bake_paper(city_.bake_scene(), corner(at), side_mm(at), year_, side_, columns_);
    MadeTile tile;
    tile.bytes = static_cast<std::uint64_t>(paper_sent_bytes(map));
    const double cell = metres(side_mm(at)) / side_, step = metres(map.top_mm) / 255;
    tile.error_m = std::sqrt(2 * cell * cell + step * step) / 2;
    tile.memory_bytes = memory_of(map);
    const double start = cpu_ms();
    tile.cast = cast_tile(std::move(map));
    tile.decode_cpu_ms = cpu_ms() - start;
    return tile;
  }
  PaperYear year_;
  std::uint32_t side_, columns_;
};

class PrismTiles : public TileForm {
 public:
  PrismTiles(SharedCity& city, double tau_px) : TileForm(city, {"prisms", {}, tau_px}) {}

 private:
  bool has(const TileAddress& at) override {
    const TileAddress parent{at.z - 1, at.x / 2, at.y / 2};
    return at.z == 0 || (houses(at) > 0 && houses(parent) > kFewHouses);
  }
  /// More houses than a tile may have: always refined.
  double error_m(const TileAddress& at) override {
    return houses(at) > kMostPrisms ? std::numeric_limits<double>::infinity() : TileForm::error_m(at);
  }
  MadeTile make(const TileAddress& at) override { return prisms(at); }
  bool has_ground_tiles() const override { return true; }
};

class ClientTiles : public TileForm {
 public:
  ClientTiles(SharedCity& city, double tau_px) : TileForm(city, {"both tiles", {}, tau_px}) {}

 private:
  bool has(const TileAddress& at) override {
    const TileAddress parent{at.z - 1, at.x / 2, at.y / 2};
    return at.z == 0 || (houses(at) > 0 && houses(parent) > kFewHouses);
  }
  MadeTile make(const TileAddress& at) override {
    const std::size_t n = houses(at);
    const bool has_prisms = n > 0 && n <= kMostPrisms, has_blockmap = n >= kHousesWorth || at.z == 0;
    if (!has_prisms || (has_blockmap && n > kMostPolygonHouses)) return blockmap(at, 128);
    return prisms(at);
  }
  bool draws_all_prisms() const override { return true; }
  bool has_ground_tiles() const override { return true; }
};

}  // namespace

Form client_tiles(SharedCity& city, double tau_px) { return std::make_unique<ClientTiles>(city, tau_px); }
Form prism_tiles(SharedCity& city, double tau_px) { return std::make_unique<PrismTiles>(city, tau_px); }
Form blockmap_tiles(SharedCity& city, std::uint32_t cells, double tau_px) {
  return std::make_unique<BlockMapTiles>(city, cells, tau_px);
}
Form paper_tiles(SharedCity& city, int year, std::uint32_t side, std::uint32_t columns, double tau_px) {
  return std::make_unique<PaperTiles>(city, year, side, columns, tau_px);
}

}  // namespace vicus::measure
