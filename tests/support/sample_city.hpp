#pragma once
#include "city_db/city.hpp"

/// A small city made by hand, for the tests of whoever reads a city: two streets crossing, houses, a church, a
/// passage under a house to a yard, an island, a bank, ends of the city.
namespace vicus::test {

/// The street that tests escaping: `"Zum <Löwen> & Co"`, quotes included.
extern const char* const kAwkwardName;

/// Every rule of DESIGN §3 holds exactly: sector grounds, houses on the ground and obstacles are a noded partition of
/// the domain, every ground edge is one border or one gate, gates are twins or lead out. Every list of City is used.
///
///        y=40 +--------+-----+---out--+---+--------------+---+
///             | court  | b-2 | north  |b-6| (yard ground) |b-7|
///        y=20 +--------+ (O) |        |   +--------------+   |
///             |  b-1   |     |        +---+   s-yard     +---+ y=22
///         y=5 +--------+-----+        |b-3|psg|  b-5         |
///         out |   s-main-w   | s-cross|   s-main-e  [island] | out
///        y=-5 +--------------+        +------------+---------+
///             |  b-10 church |s-south |    b-8     |   b-9   |
///             |~~~~~ water ~~|        |   (yard ground)      |
///       y=-40 +--------------+==wall==+----------------------+
///            x=-60          -5        5                      60
City sample_city();

/// The same with windows and doors on every straight facade of 3 m and more, in all styles, and meta["atlas"].
City sample_city_with_facades();

}  // namespace vicus::test
