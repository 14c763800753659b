#pragma once
#include <string>
#include <vector>

/// What somebody may have meant.
namespace vicus::cli {

/// Steps (insert, delete, replace a byte) from one text to the other, letters of either case alike.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// "; did you mean a, b or c?" with at most five of `names`, nearest first, none that differs in more than half of
/// its bytes; empty where none is near.
std::string did_you_mean(const std::string& given, const std::vector<std::string>& names);

}  // namespace vicus::cli
