// An exercise on a truss: Cremona's plan, and the forces of its bars in a table.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/trusses/loaded_truss.h"

namespace epure::trusses {

// The truss of these givens. Throws BadGivens.
using TrussOf = std::function<LoadedTruss(const Givens&)>;
// The givens that have no part in it.
using WithoutPart = std::function<std::set<std::string>(const Givens&)>;

// `about` without its question. `most_bars`: of any truss that the givens allow.
std::unique_ptr<Exercise> exercise_of_truss(Description about, std::size_t most_bars, const TrussOf& truss,
                                            const WithoutPart& without_part);

}  // namespace epure::trusses
