#include "exercises/scenes/file/limits.h"

#include "exercises/scenes/file/refusals.h"
#include "geometry/numbers/climb.h"

namespace epure::scenes {

using namespace geometry;

std::optional<Words> limit_of(const Built& built) {
  for (std::size_t step = 0; step < built.steps.size(); ++step) {
    const auto is_at_limit = [&]<class T>() {
      const CarriedOut<T> carried_out(built.linkage, built.steps);
      const Sign room = sign(carried_out.from_limit(step, carried_out.position_before(step)));
      return room == Sign::undecided ? Truth::undecided : room == Sign::zero ? Truth::yes : Truth::no;
    };
    if (ask(is_at_limit).truth == Truth::yes) return limit_in_words(step, built);
  }
  return {};
}

}  // namespace epure::scenes
