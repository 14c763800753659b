#pragma once
#include <string_view>
#include <vector>

namespace vicus {

/// Numbers with white space or commas between them, such as a posList, behind those of `out`. False: something that is
/// none.
bool append_numbers(std::string_view text, std::vector<double>& out);

}  // namespace vicus
