// The only statement of the bytes of a BlockMap as published in 2009 (paper 001 §4): a texture of n rows and 2n + w
// texels of RGBA, north row first, behind a header of ours that says where it is. Integer #defines only. Little-endian.
#define BLOCKMAP2009_MAGIC 0x39304D42  // "BM09"
#define BLOCKMAP2009_MAGIC_AT 0        // u32
#define BLOCKMAP2009_SIDE_AT 4         // u16: n, a power of two
#define BLOCKMAP2009_COLUMNS_AT 6      // u16: w
#define BLOCKMAP2009_SLICES_AT 8       // u16: s, 1 ... n/4: equal parts of the rows, each with its own w columns
#define BLOCKMAP2009_TILE_SIDE_AT 12   // u32: mm
#define BLOCKMAP2009_EAST_AT 16        // i32: mm, south-west corner
#define BLOCKMAP2009_NORTH_AT 20       // i32: mm
#define BLOCKMAP2009_BASE_AT 24        // i32: mm, height 0
#define BLOCKMAP2009_TOP_AT 28         // u32: mm above it, height 255
#define BLOCKMAP2009_HEADER_BYTES 32
#define BLOCKMAP2009_CHANNELS 4
// Texels [0, n): red height; of void texels green 0, blue the distance in texels to the nearest house, alpha 255; of
// houses green and alpha the wall column (0: none; 1 ... 65535 over the w columns, green the low byte), blue the roof's
// normal, 4 bits east, 4 bits north, 8 is 0, in sevenths: the paper has a map of normals, but says not where.
// [n, 2n): colour of roof or ground, ambient light in alpha. [2n, 2n + w): in each slice, the first at the top, wall
// columns with ambient light in alpha, the foot in the slice's last row but one, the normal in its last.
#define BLOCKMAP2009_HEIGHT_CHANNEL 0
#define BLOCKMAP2009_COLUMN_CHANNEL 1
#define BLOCKMAP2009_DISTANCE_CHANNEL 2
#define BLOCKMAP2009_NORMAL_CHANNEL 2
#define BLOCKMAP2009_COLUMN_HIGH_CHANNEL 3
#define BLOCKMAP2009_FIRST_COLUMN 1
#define BLOCKMAP2009_LAST_COLUMN 65535
