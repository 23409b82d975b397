// The truss of the givens.
#pragma once

#include "exercises/kit/trusses/loaded_truss.h"
#include "exercises/truss/shapes.h"

namespace epure::truss {

std::vector<GivenSpec> given_specs();

Shape shape_of(const Givens& givens);

// Throws BadGivens, naming value and condition, for panels that this truss cannot have, for one that is not flat,
// held or loaded.
trusses::LoadedTruss given_truss(const Givens& givens);

}  // namespace epure::truss
