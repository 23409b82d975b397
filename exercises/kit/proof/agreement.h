// What several routes say of one quantity, held together.
#pragma once

#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// Of the route that knows most: a value before an absence, a narrow enclosure before a wide one. There must be one.
const geometry::Settled& best_known(const std::vector<RouteValue>& routes);

bool are_apart(const geometry::Enclosure& a, const geometry::Enclosure& b);

// "in [1, 2]", "absent (...)".
Words where_it_lies(const geometry::Settled& settled);

// Of each two routes that cannot both be right, a sentence without the quantity's name: "in [1, 2] by poles, but
// absent
// (...) by analytic". None of routes without bounds.
std::vector<Words> contradictions(const std::vector<RouteValue>& routes);

// Why no more is known than an enclosure that holds several doubles; empty where a value is known to the last digit,
// or there is none. (A true value midway between two doubles has no nearest one: no ball around it tells more than
// these two.)
Words want_of_certainty(const geometry::Settled& settled);

}  // namespace epure
