// The only statement of ground tile bytes (FORMAT.md, "Ground tile"). Integer #defines only. Little-endian.
#define GROUND_MAGIC 0x31545247  // "GRT1"
#define GROUND_VERSION 1
#define GROUND_MAGIC_AT 0           // u32
#define GROUND_VERSION_AT 4         // u16
#define GROUND_NODES_AT 6           // u16: nodes of height per side, odd, GROUND_LEAST_NODES ... GROUND_MOST_NODES
#define GROUND_TILE_SIDE_AT 8       // u32: mm
#define GROUND_EAST_AT 12           // i32: mm, south-west corner in the plan frame
#define GROUND_NORTH_AT 16          // i32: mm
#define GROUND_BASE_AT 20           // i32: mm, what heights count from
#define GROUND_STEP_AT 24           // u32: mm, one step of height
#define GROUND_PICTURE_SIDE_AT 28   // u32: texels per side
#define GROUND_PICTURE_BYTES_AT 32  // u32: of the WebP, north row first
#define GROUND_KEY_AT 36            // u64: of all that the tile was baked from
#define GROUND_HEADER_BYTES 44
// After the header the heights at the nodes, u16 steps above the base, all high bytes, then all low bytes, row by row
// from the south, each from the west; the first and last nodes of a row lie on the tile's rim. Then the picture.
#define GROUND_LEAST_NODES 3
#define GROUND_MOST_NODES 129
#define GROUND_MOST_PICTURE_SIDE 2048
#define GROUND_BEYOND_CITY 0xA3AC8A  // sRGB: ground that no surface covers
