#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "city_db/blockmap2007_layout.h"
#include "city_db/blockmap2009_layout.h"
#include "city_db/blockmap_layout.h"
#include "city_db/ground_tile_layout.h"
#include "city_db/prism_tile_layout.h"
#include "tests/support/hex_dump.hpp"
#include "tests/support/sample_tiles.hpp"
#include "tests/support/scratch.hpp"

/// FORMAT.md's tiles are what the encoders write.
namespace vicus::test {
namespace {

TEST(FormatMd, ShowsABlockMapsHeaderAsTheEncoderWritesIt) {
  const std::string bytes = encode_blockmap(sample_blockmap());
  EXPECT_EQ(dumped_bytes(1), bytes.substr(0, BLOCKMAP_HEADER_BYTES));
  EXPECT_EQ(bytes.size(), std::size_t{BLOCKMAP_HEADER_BYTES + BLOCKMAP_PLANES * 16 * 16 + BLOCKMAP_LINE_BYTES});
  EXPECT_EQ(decode_blockmap(bytes), sample_blockmap());
}

TEST(FormatMd, ShowsAPrismTileAsTheEncoderWritesIt) {
  EXPECT_EQ(dumped_bytes(2), encode_prisms(sample_prisms()));
  EXPECT_EQ(decode_prisms(dumped_bytes(2)), sample_prisms());
}

TEST(FormatMd, ShowsAGroundTileAsTheEncoderWritesIt) {
  EXPECT_EQ(dumped_bytes(3), encode_ground(sample_ground()));
  EXPECT_EQ(decode_ground(dumped_bytes(3)), sample_ground());
}

/// Version 1 had no quadrants: its houses would be drawn in the wrong ones.
TEST(PrismTile, OfVersion1IsRefused) {
  std::string bytes = encode_prisms(sample_prisms());
  bytes[PRISM_VERSION_AT] = 1;
  EXPECT_FALSE(decode_prisms(bytes));
}

TEST(FormatMd, ShowsTheHeaderOfABlockMapOf2007) {
  EXPECT_EQ(dumped_bytes(4), encode_paper(sample_paper()).substr(0, BLOCKMAP2007_HEADER_BYTES));
  EXPECT_EQ(decode_paper(encode_paper(sample_paper())), sample_paper());
}

/// What JavaScript and shaders read must be what C++ was compiled with: numbers only, one a line.
TEST(Layouts, AreIntegerDefinesThatAnyoneCanRead) {
  for (const char* name : {"blockmap_layout.h", "blockmap2007_layout.h", "blockmap2009_layout.h", "prism_tile_layout.h",
                           "ground_tile_layout.h"}) {
    std::istringstream lines(read_bytes(std::string(VICUS_TESTS) + "/../city_db/" + name));
    int defines = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("//") || line.find_first_not_of(' ') == std::string::npos) continue;
      std::istringstream words(line);
      std::string define, symbol, value, rest;
      words >> define >> symbol >> value >> rest;
      if (define == "//") continue;
      EXPECT_EQ(define, "#define") << line;
      std::size_t used = 0;
      std::stoul(value, &used, 0);
      EXPECT_EQ(used, value.size()) << line;
      EXPECT_TRUE(rest.empty() || rest.starts_with("//")) << line;
      ++defines;
    }
    EXPECT_GT(defines, 10) << name;
  }
}

TEST(TileColumns, AreCountedByTheRuleAlone) {
  const BlockMap map = sample_blockmap();
  const auto walls = wall_bits(map);
  // 17: south is the cell below, west is ground, east is 18, which has a line; its north side stands 2 m higher.
  EXPECT_EQ(walls[17], kWallNorth | kWallWest | kWallSouth);
  EXPECT_EQ(walls[18], kWallLine);
  const auto first = first_columns(walls);
  EXPECT_EQ(column_total(first), 4u);
  EXPECT_LT(first[17], first[18]);
}

}  // namespace
}  // namespace vicus::test
