#pragma once
#include "city_db/blockmap.hpp"
#include "city_db/blockmap_paper.hpp"
#include "city_db/ground_tile.hpp"
#include "city_db/prism_tile.hpp"

/// Small tiles made by hand: those that FORMAT.md shows byte by byte.
namespace vicus::test {

/// 16 x 16 cells of 8 m, one house of a cell and a half with a line; no pictures.
inline BlockMap sample_blockmap() {
  BlockMap map;
  map.side = 16;
  map.rows = 4;
  map.corner = {-128'000, 0};
  map.tile_side_mm = 128'000;
  map.base_mm = 2'500;
  map.base_east = 10'000;
  map.step_um = 250'000;
  map.wall_step_um = 6'000'000;
  map.error_mm = 1'234;
  map.colour_error_milli = 2'500;
  map.key = 0x1122334455667788u;
  map.top = 44;
  const std::size_t cells = 256;
  map.height.assign(cells, 0);
  map.foot.assign(cells, 0);
  map.slope_east.assign(cells, 128);
  map.slope_north.assign(cells, 128);
  map.angle.assign(cells, 0);
  map.offset.assign(cells, 0);
  map.height[17] = map.height[18] = 40;
  map.slope_north[17] = map.slope_north[18] = 136;
  map.offset[18] = 128;
  return map;
}

/// A house with a gabled roof, a flat one with a yard, one with a roof of its own, two trees.
inline PrismTile sample_prisms() {
  PrismTile tile;
  tile.corner = {-128'000, 0};
  tile.tile_side_mm = 128'000;
  tile.base_mm = 2'000;
  tile.step_mm = 125;
  tile.up_step_mm = 100;
  tile.error_mm = 210;
  tile.key = 0x1122334455667788u;
  tile.palette = {{200, 190, 180}, {150, 70, 50}, {112, 152, 70}, {78, 116, 80}};
  tile.houses = {{PrismKind::gabled, true, 2, {{{80, 520}, {160, 520}, {160, 584}, {80, 584}}}, 5, 62, 31, 0, 1},
                 {PrismKind::flat,
                  false,
                  0,
                  {{{-40, 200}, {120, 200}, {120, 360}, {-40, 360}}, {{20, 260}, {20, 300}, {60, 300}, {60, 260}}},
                  5,
                  150,
                  0,
                  0,
                  0},
                 {PrismKind::faceted,
                  true,
                  3,
                  {{{520, 600}, {600, 600}, {600, 680}, {520, 680}}},
                  5,
                  50,
                  20,
                  0,
                  1,
                  {{{560, 640}, 20}},
                  {{false, {0, 1, 4}}, {false, {1, 2, 4}}, {true, {2, 3, 4}}, {false, {0, 4, 3}}}}};
  tile.trees = {{{64, 600}, 5, 80, 26, TreeForm::round, 2, 2}, {{400, 520}, 6, 120, 19, TreeForm::conifer, 3, 3}};
  return tile;
}

/// A slope of 3 x 3 nodes; the picture is no picture.
inline GroundTile sample_ground() {
  GroundTile tile;
  tile.corner = {-128'000, 0};
  tile.tile_side_mm = 128'000;
  tile.nodes = 3;
  tile.base_mm = 2'000;
  tile.step_mm = 10;
  tile.key = 0x1122334455667788u;
  tile.height = {0, 100, 200, 0, 100, 300, 0, 100, 400};
  tile.picture_side = 256;
  tile.picture = "WebP";
  return tile;
}

/// 2007, 8:4: a house of four texels.
inline PaperBlockMap sample_paper() {
  PaperBlockMap map;
  map.side = 8;
  map.columns = 4;
  map.corner = {-128'000, 0};
  map.tile_side_mm = 128'000;
  map.base_mm = 2'000;
  map.top_mm = 12'750;
  map.texels.assign(std::size_t{map.width()} * map.side * map.channels(), 0);
  std::uint32_t wall = 1;
  for (std::size_t row = 2; row < 4; ++row)
    for (std::size_t column = 3; column < 5; ++column) {
      map.cell(column, row)[0] = 200;
      map.set_wall_column(column, row, wall++);
    }
  return map;
}

}  // namespace vicus::test
