// The inverse of a square matrix, row by row, nearly: for a proof to multiply by, which asks no more of it.
#pragma once

#include <optional>
#include <vector>

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// Of a matrix between these bounds, as points; none where it is found to be singular. Bounded: in doubles.
std::optional<std::vector<std::vector<Bounded>>> inverse_near(const std::vector<std::vector<Bounded>>& matrix);
// Deep: with as many bits as the scope has.
std::optional<std::vector<std::vector<Deep>>> inverse_near(const std::vector<std::vector<Deep>>& matrix);

}  // namespace epure::geometry::analytic
