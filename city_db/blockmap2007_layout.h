// The only statement of the bytes of a BlockMap as published in 2007 (paper 000 §3.1): a texture of n rows and 2n + w
// texels of RGB, north row first, behind a header of ours that says where it is. Integer #defines only. Little-endian.
#define BLOCKMAP2007_MAGIC 0x37304D42  // "BM07"
#define BLOCKMAP2007_MAGIC_AT 0        // u32
#define BLOCKMAP2007_SIDE_AT 4         // u16: n, a power of two
#define BLOCKMAP2007_COLUMNS_AT 6      // u16: w
#define BLOCKMAP2007_SLICES_AT 8       // u16: 1
#define BLOCKMAP2007_TILE_SIDE_AT 12   // u32: mm
#define BLOCKMAP2007_EAST_AT 16        // i32: mm, south-west corner
#define BLOCKMAP2007_NORTH_AT 20       // i32: mm
#define BLOCKMAP2007_BASE_AT 24        // i32: mm, height 0
#define BLOCKMAP2007_TOP_AT 28         // u32: mm above it, height 255
#define BLOCKMAP2007_HEADER_BYTES 32
#define BLOCKMAP2007_CHANNELS 3
// Texels [0, n): red height, green the wall column (0: none; 1 ... 255 over the w columns), blue the distance in texels
// to the nearest house, 0 in houses. [n, 2n): colour of roof or ground. [2n, 2n + w): wall columns, the foot in the
// last row but one and the top in the first, the normal in the last.
#define BLOCKMAP2007_HEIGHT_CHANNEL 0
#define BLOCKMAP2007_COLUMN_CHANNEL 1
#define BLOCKMAP2007_DISTANCE_CHANNEL 2
#define BLOCKMAP2007_FIRST_COLUMN 1
#define BLOCKMAP2007_LAST_COLUMN 255
