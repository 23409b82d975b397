#include "exercises/kit/trusses/loaded_truss.h"

#include <utility>

namespace epure::trusses {

LoadedTruss::LoadedTruss(geometry::Truss held, const Angle& along, std::vector<Load> by)
    : truss(std::move(held)), roller(along), loads(std::move(by)) {
  for (const Load& load : loads) truss.outside.push_back(load.joint);
  bow = geometry::bow_notation(truss);
}

}  // namespace epure::trusses
