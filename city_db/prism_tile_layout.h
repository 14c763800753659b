// The only statement of prism tile bytes (FORMAT.md, "Prism tile"). Integer #defines only. Little-endian.
#define PRISM_MAGIC 0x31545250  // "PRT1"
#define PRISM_VERSION 4
#define PRISM_MAGIC_AT 0       // u32
#define PRISM_VERSION_AT 4     // u16
#define PRISM_COLOURS_AT 6     // u16: colours of the palette, 1 ... 4096
#define PRISM_HOUSES_AT 8      // u32
#define PRISM_TILE_SIDE_AT 12  // u32: mm
#define PRISM_EAST_AT 16       // i32: mm, south-west corner in the plan frame
#define PRISM_NORTH_AT 20      // i32: mm
#define PRISM_BASE_AT 24       // i32: mm, what ground heights count from
#define PRISM_STEP_AT 28       // u32: mm, one step of a footprint's point
#define PRISM_UP_STEP_AT 32    // u32: mm, one step of height
#define PRISM_ERROR_AT 36      // u32: mm, no point of a house is farther from its prism
#define PRISM_KEY_AT 40        // u64: of all that the tile was baked from
#define PRISM_TREES_AT 48      // u32
#define PRISM_LENGTHS_AT 52    // u32 each: bytes of the streams, in order
#define PRISM_STREAMS 15
#define PRISM_HEADER_BYTES 112
// After the header the palette, 3 bytes a colour, then the streams, varints (7 bits a byte, the low ones first; signed
// ones zigzag). Houses come in Z order of their first points.
// Shape of a house: kind + 8 * owned + 16 * quadrant + 64 * number of rings beyond the first; then of each ring its
// points less 3; of a faceted house then how many points its roof has beside them, and how many facets.
#define PRISM_STREAM_SHAPE 0
#define PRISM_STREAM_EAST 1  // signed: first point of a house from that of the house before, then point to point
#define PRISM_STREAM_NORTH 2
#define PRISM_STREAM_GROUND 3  // signed: from the house before
#define PRISM_STREAM_EAVE 4    // above the ground
#define PRISM_STREAM_RISE 5    // top above the eave; of a faceted house one, signed, for each point beside the rings'
#define PRISM_STREAM_COLOUR 6  // wall, roof: of the palette
// Of each point of a faceted house beside the rings': which of the rings' points is near (signed: from the one before,
// the first from 0), and how far it is from there.
#define PRISM_STREAM_ANCHOR 7
#define PRISM_STREAM_OFFSET 8  // signed: east, north
// Of each facet: 2 * (corners less 3) + 1 if it is a gable; its first corner from that of the facet before, then corner
// to corner, signed.
#define PRISM_STREAM_FACET 9
// Trees come in Z order. Signed: from the tree before. A tree stands in the middle of a square of the lattice.
#define PRISM_STREAM_TREE_EAST 10
#define PRISM_STREAM_TREE_NORTH 11
#define PRISM_STREAM_TREE_GROUND 12
#define PRISM_STREAM_TREE_SIZE 13  // height, radius of the crown: steps of height
#define PRISM_STREAM_TREE_LOOK 14  // form + 4 * quadrant + 16 * colour of the palette
#define PRISM_KIND_FLAT 0
#define PRISM_KIND_TENT 1     // to a point over the middle of the outer ring
#define PRISM_KIND_GABLED 2   // four points: a ridge between the middles of the shorter two sides
#define PRISM_KIND_HIPPED 3   // four points: the same, drawn in at both ends by half the shorter sides' length
#define PRISM_KIND_FACETED 4  // the house's own roof
#define PRISM_KINDS 5
#define PRISM_OWNED 8      // the house's middle lies in the tile: the other tiles it reaches into have it too
#define PRISM_QUADRANT 16  // of an owned house: 1 its middle lies in the east half, 2 in the north half
#define PRISM_QUADRANTS 4
#define PRISM_RINGS 64
#define PRISM_TREE_ROUND 0
#define PRISM_TREE_SLIM 1
#define PRISM_TREE_CONIFER 2
#define PRISM_TREE_FORMS 3
#define PRISM_TREE_QUADRANT 4
#define PRISM_TREE_COLOUR 16
