// N.12 of the Sapienza sheets: a pair of involute gears around its pitch point, whole, and how its flanks slide.
#pragma once

#include "exercises/gear-pair/drawn_pair.h"
#include "exercises/gear-pair/problem.h"

namespace epure::gear_pair {

// A number of the source that is not the quantity's, which is `value`.
struct Difference {
  Quantity quantity;
  std::string printed;
  double value;
  std::optional<Words> explanation;
};
using Differences = std::vector<Difference>;

// One sheet each; they add to an empty sheet. `differences`: those of the source, empty when its givens were changed.
void draw_pitch_point(DrawnSheet& onto, const DrawnPair& pair, const Differences& differences,
                      const SheetRequest& request);
void draw_wheels(DrawnSheet& onto, const DrawnPair& pair, const SheetRequest& request);
void draw_sliding(DrawnSheet& onto, const DrawnPair& pair, const Differences& differences,
                  const SheetRequest& request);

// A heading and a line for each of those among `quantities`; nothing when there is none.
void add_differences(DrawnSheet& onto, const Differences& differences, const std::vector<std::string>& quantities,
                     Language language);

}  // namespace epure::gear_pair
