// A computation with Arb's own functions (exponentials, elliptic integrals), asked for by a construction over any
// number.
#pragma once

#include "geometry/numbers/growing.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// `computation` returns a Deep, with as many bits as are open while it runs.
template <class T, class Computation>
T on_balls(const Computation& computation) {
  if constexpr (std::is_same_v<T, Deep>) {
    return computation();
  } else if constexpr (std::is_same_v<T, Bounded>) {
    return in_doubles(computation);
  } else if constexpr (std::is_same_v<T, Fast>) {
    const Arithmetic<Deep> scope(64);
    return enclosure(computation()).value;
  } else {
    throw Undecided("a transcendental function of which only bounds are known",
                    "una funzione trascendente di cui si conoscono solo dei limiti");
  }
}

}  // namespace epure::geometry
