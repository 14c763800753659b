// The only statement of the bytes of a BlockMap as published in 2009 (paper 001 §4): a texture of n rows and 2n + w
// texels of RGBA, north row first, behind a header of ours that says where it is. Integer #defines only. Little-endian.
#define BLOCKMAP2009_MAGIC 0x39304D42        // "BM09"
#define BLOCKMAP2009_MAGIC_AT 0              // u32
#define BLOCKMAP2009_SIDE_AT 4               // u16: n, a power of two
#define BLOCKMAP2009_COLUMNS_AT 6            // u16: w
#define BLOCKMAP2009_SLICES_AT 8             // u16: s, 1 ... n/4: equal parts of the rows, each with its own w columns
#define BLOCKMAP2009_TILE_SIDE_AT 12         // u32: mm
#define BLOCKMAP2009_EAST_AT 16              // i32: mm, south-west corner
#define BLOCKMAP2009_NORTH_AT 20             // i32: mm
#define BLOCKMAP2009_BASE_AT 24              // i32: mm, height 0
#define BLOCKMAP2009_TOP_AT 28               // u32: mm above it, height 255
#define BLOCKMAP2009_HEADER_BYTES 32
#define BLOCKMAP2009_CHANNELS 4
// Texels [0, n): red height, green the wall column (0: none), blue the distance map; alpha, and the green and blue of
// texels without a column, are 255 and 0. [n, 2n): colour of roof or ground, ambient occlusion in alpha. [2n, 2n + w):
// in each slice wall columns with ambient occlusion in alpha, the normal in the slice's last row. The roof's normal is
// (east + 128, north + 128) in a second square below the first one in the paper's figure 2: here texels [2n + w, 3n + w).
#define BLOCKMAP2009_ROOF_NORMALS 1          // squares of n texels after the columns
