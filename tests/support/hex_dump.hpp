#pragma once
#include <string>

namespace vicus::test {

/// The bytes of the `which`-th ```hexdump block of city_db/FORMAT.md: after the offset, pairs of hex digits with one
/// space between, then two spaces. Expects each offset to be right.
std::string dumped_bytes(int which);

}  // namespace vicus::test
