#pragma once
#include "sectorgen/visibility/author_list.hpp"

/// Important sectors (paper 004 §4.1.7): kept loaded in a whole vicinity, because visitors come back to them.
///
/// Differs the paper adds them by hand only; here a person's list does, and sectors found by measure are proposed.
namespace vicus {

struct ImportantOptions {
  std::vector<AuthorEntry> list;
  PlanOf plan_of;                  ///< for entries of the list with degrees
  const City* previous = nullptr;  ///< the city that is replaced: what a person marked there stays, by sector id
};

/// Fills Sector.importance and vicinity_m: what the replaced city had from a person, then the list, then proposals.
/// A mark whose sector is gone, and a place the city does not have, become issue 104.
/// Needs   sectors with their ids, gates, borders, buildings, objects.
void mark_important(City& city, const ImportantOptions& options, std::vector<Issue>& issues);

/// Appends to L_vis, with reason important, every important sector of a person's choice for each sector that does not
/// list it yet and the middle of whose box is at most vicinity_m from its box.
void add_important(City& city);

}  // namespace vicus
