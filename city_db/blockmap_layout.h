// The only statement of BlockMap+ bytes (FORMAT.md, "BlockMap+"). Read by C++, GLSL ES 3.00 and JavaScript, hence
// integer #defines only. Little-endian.
#define BLOCKMAP_MAGIC 0x31504D42  // "BMP1"
#define BLOCKMAP_VERSION 2
#define BLOCKMAP_MAGIC_AT 0          // u32
#define BLOCKMAP_VERSION_AT 4        // u16
#define BLOCKMAP_SIDE_AT 6           // u16: cells per side, N: a power of two
#define BLOCKMAP_ROWS_AT 8           // u16: texels of a wall column, from its foot up
#define BLOCKMAP_FLAGS_AT 10         // u16
#define BLOCKMAP_COLUMNS_AT 12       // u32: wall columns; follows from the planes, and must agree with them
#define BLOCKMAP_TILE_SIDE_AT 16     // u32: mm
#define BLOCKMAP_EAST_AT 20          // i32: mm, south-west corner in the plan frame
#define BLOCKMAP_NORTH_AT 24         // i32: mm
#define BLOCKMAP_BASE_AT 28          // i32: mm, the base plane at that corner
#define BLOCKMAP_BASE_EAST_AT 32     // i32: slope of the base plane to the east, BLOCKMAP_BASE_ONE is 45 degrees
#define BLOCKMAP_BASE_NORTH_AT 36    // i32: to the north
#define BLOCKMAP_STEP_AT 40          // u32: um, one step of height
#define BLOCKMAP_WALL_STEP_AT 44     // u32: um; where two cells without a line differ by more, there is a wall
#define BLOCKMAP_ERROR_AT 48         // u32: mm, no point of the houses or the ground is farther from the tile's surface
#define BLOCKMAP_COLOUR_ERROR_AT 52  // u32: thousandths of an 8-bit step, root of the mean square over all texels
#define BLOCKMAP_KEY_AT 56           // u64: of all that the tile was baked from
#define BLOCKMAP_TOP_AT 64           // u32: steps; no surface of the tile is higher above the base plane
#define BLOCKMAP_ROOF_BYTES_AT 68    // u32: of the image of N x N roof and ground colours, north row first
#define BLOCKMAP_GROUND_BYTES_AT 72  // u32: of N/2 x N/2 ground colours, houses filled
#define BLOCKMAP_AMBIENT_BYTES_AT 76  // u32: of N/2 x N/2 ambient light, grey; 0 unless BLOCKMAP_FLAG_AMBIENT
#define BLOCKMAP_WALL_BYTES_AT 80  // u32: of the wall columns, BLOCKMAP_ATLAS_WIDTH a strip, strips from the top down
#define BLOCKMAP_HEADER_BYTES 84
#define BLOCKMAP_FLAG_AMBIENT 1
// After the header the planes, each N * N bytes, row by row from the south, each from the west; then, of the cells with
// a line alone, in that order, what BLOCKMAP_LINE_ says, each a byte a cell; then the pictures (indexed_picture.hpp).
#define BLOCKMAP_PLANE_HEIGHT_HIGH 0  // high byte of the height above the base plane at the cell's middle, in steps
#define BLOCKMAP_PLANE_HEIGHT_LOW 1
#define BLOCKMAP_PLANE_SLOPE_EAST 2  // BLOCKMAP_SLOPE_ZERO: level
#define BLOCKMAP_PLANE_SLOPE_NORTH 3
#define BLOCKMAP_PLANE_OFFSET 4  // of the line from the cell's middle; 0: the cell has no line
#define BLOCKMAP_PLANES 5
#define BLOCKMAP_LINE_ANGLE 0      // of the line's normal, which looks to the lower side: 256 steps, 0 east, 64 north
#define BLOCKMAP_LINE_FOOT_HIGH 1  // beyond the line: height of the level surface there
#define BLOCKMAP_LINE_FOOT_LOW 2
#define BLOCKMAP_LINE_BYTES 3
#define BLOCKMAP_BASE_ONE 1000000
#define BLOCKMAP_SLOPE_ONE 32  // steps of slope to 45 degrees
#define BLOCKMAP_SLOPE_ZERO 128
#define BLOCKMAP_OFFSET_ZERO 128  // the line goes through the middle; 1 and 255 are half a cell's diagonal away
#define BLOCKMAP_OFFSET_STEPS 127
#define BLOCKMAP_LEAST_SIDE 16
#define BLOCKMAP_MOST_SIDE 512
#define BLOCKMAP_LEAST_ROWS 2
#define BLOCKMAP_MOST_ROWS 32
#define BLOCKMAP_ATLAS_WIDTH 1024  // wall columns in one strip
