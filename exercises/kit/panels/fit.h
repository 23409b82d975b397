// Finding room for a picture: the largest standard scale at which it fits, and where its origin then lies.
#pragma once

#include <functional>
#include <optional>

#include "exercises/kit/panels/plot.h"

namespace epure {

// Grows with what is put in: the smallest box around it, in mm from the picture's origin.
class Extent {
 public:
  void include(double x_mm, double y_mm);
  // A point of the plane drawn at `scale`, with `air` mm around it.
  void include(const Scale& scale, const Place& P, double air = 0);
  drawings::Box box() const { return {low_, high_}; }

 private:
  drawings::Point low_{0, 0}, high_{0, 0};
  bool empty_ = true;
};

// A figure and its paper, not what is given.
struct DoesNotFit : BadGivens {
  using BadGivens::BadGivens;
};

struct Fit {
  Scale scale;
  drawings::Point origin;  // paper mm of the plane's origin: the picture stands in the middle of the room
};

// Whether a picture of this extent fits the room, and where its origin then lies: it stands in the middle.
bool fits(const drawings::Box& extent, const drawings::Box& room);
drawings::Point origin_in(const drawings::Box& room, const drawings::Box& extent);

// `extent_at` says how much paper the picture takes at a scale of lengths. `at_most` (mm per metre) bounds the
// search. Throws DoesNotFit when a requested scale does not fit, naming the room and what would fit.
Fit fit_lengths(const drawings::Box& room, const SheetRequest& request, double at_most,
                const std::function<drawings::Box(const Scale&)>& extent_at);

}  // namespace epure
