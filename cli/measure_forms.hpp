#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cli/measure_representation.hpp"
#include "cli/measure_shared_city.hpp"

/// All representations that there are: the one list to add a new one to.
namespace vicus::measure {

/// A representation that is made only when its turn comes, so that one city's scenes are in memory once.
struct FormMaker {
  std::string key;  ///< as --as names it; several settings share one
  std::function<Form(SharedCity&)> make;
};

/// `taus`: of those that have one. Empty `keys`: all.   Fails  CityError: a key that is none.
std::vector<FormMaker> form_makers(const std::vector<std::string>& keys, const std::vector<double>& taus);
/// In the order of the list, each once.
std::vector<std::string> form_keys();

}  // namespace vicus::measure
