// Which places of the drive are reached from where it is.
#pragma once

#include <numbers>

#include "exercises/scenes/scene.h"
#include "geometry/curves/trace.h"

namespace epure::scenes {

// Of the turn of directions (every_place.h): on to the first of the parts in which the mechanism is proved not to
// close, and back to the last.
class Reached {
 public:
  explicit Reached(double now) : now_(now) {}
  void leave_out(const geometry::Gap& gap);

  bool is_whole() const { return is_whole_; }
  bool has(double angle) const;
  // The angles between which it goes back and forth, where it does not go round.
  double low() const { return now_ + last_begin_ - 2 * std::numbers::pi; }
  double high() const { return now_ + first_end_; }
  // Without the branches that are not reached.
  void leave_in(geometry::Trace& trace) const;

 private:
  bool has(const geometry::Branch& branch) const;

  double now_, first_end_ = 2 * std::numbers::pi, last_begin_ = 0;
  bool is_whole_ = true;
};

// By the path of a point that the drive moves.
Reached reached(const Built& built, int point);

}  // namespace epure::scenes
