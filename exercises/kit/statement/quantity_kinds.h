// A table of quantities by name: their letters, units and meanings.
#pragma once

#include <map>
#include <string>

#include "exercises/kit/statement/quantity.h"

namespace epure {

struct QuantityKind {
  std::string symbol, unit;
  Words meaning;
};
using QuantityKinds = std::map<std::string, QuantityKind>;

// The name must be in the table.
inline Quantity quantity_of(const QuantityKinds& kinds, const std::string& name) {
  const QuantityKind& kind = kinds.at(name);
  return {name, kind.symbol, kind.unit, kind.meaning};
}

}  // namespace epure
