// The ends of an axis that is to show these values.
#pragma once

#include <vector>

namespace epure::drawings {

struct ValueSpan {
  double low, high;
};

// An axis that is narrower has no numbers of its own.
double narrowest_span(double low, double high);

// From the least to the greatest value; where a few of them run away, to infinity or nearly, what the others take,
// and as much again. Around a single value a tenth of it, or 1; of none, from 0 to 1.
ValueSpan span_of(std::vector<double> values);

}  // namespace epure::drawings
