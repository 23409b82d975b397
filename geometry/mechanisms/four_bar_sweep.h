// A crank that is turned through many directions, and the side of A -> B₀ on which B stays meanwhile.
//
// B cannot change sides as long as AB₀ stays between |AB - B₀B| and AB + B₀B, for then B is not on the line A B₀. So
// a sweep comes apart into stretches:
//   at a limit position the crank has to turn back (B goes over to the other side, and the crank not beyond);
//   at a change point two motions go on, and in both B crosses the line (change_point.h): which one is not guessed.
#pragma once

#include "geometry/mechanisms/change_point.h"
#include "geometry/mechanisms/four_bar_questions.h"

namespace epure::geometry {

enum class Obstacle { none, limit, change_point };

// Directions first to last of a sweep, in all of which, and between which, B stays on one side. Only the first and
// the last may be limit positions or change points, where B is on the line.
struct Stretch {
  std::size_t first, last;
  Obstacle ended_by;  // none: by the end of the sweep
};

namespace sweeping {

// The sign of a quantity of the scene. Throws Undecided when no number can tell.
template <class Quantity>
Sign settled_sign(const Quantity& quantity) {
  const Decision decision = decide(quantity);
  if (decision.sign == Sign::undecided) throw Undecided(decision.reason);
  return decision.sign;
}

class Sweep {
 public:
  Sweep(const FourBarLengths& of, const std::vector<CrankDirection>& cranks)
      : of_(of), cranks_(cranks), AB0_(span(of)), has_change_points_(grashof(of).is == LinkageClass::change_point) {}

  std::vector<Stretch> stretches() const {
    std::vector<Stretch> found;
    for (std::size_t i = 0; i < cranks_.size(); ++i) {
      if (!closes(i)) continue;
      found.push_back(stretch_from(i));
      i = found.back().last;
      const bool stands_on_obstacle = found.back().first < i && i + 1 < cranks_.size() && at(i) != Obstacle::none;
      if (stands_on_obstacle) --i;  // the next stretch begins where this one ends
    }
    return found;
  }

 private:
  // Decided on the lengths: neither limits nor change points.
  bool turns_freely() const {
    return AB0_.nearest_to_least == Sign::positive && AB0_.farthest_to_most == Sign::negative;
  }

  bool closes(std::size_t i) const {
    return turns_freely() ||
           (reach(i, of_.AB + of_.B0B) != Sign::positive && reach(i, of_.AB - of_.B0B) != Sign::negative);
  }
  Stretch stretch_from(std::size_t first) const {
    for (std::size_t i = first; i + 1 < cranks_.size(); ++i) {
      const Obstacle here = i > first ? at(i) : Obstacle::none, ahead = here == Obstacle::none ? between(i) : here;
      if (ahead != Obstacle::none) return {first, i, ahead};
    }
    return {first, cranks_.size() - 1, Obstacle::none};
  }

  // What direction i itself is: B on the line A B₀, or not.
  Obstacle at(std::size_t i) const {
    if (turns_freely()) return Obstacle::none;
    if (reach(i, of_.AB + of_.B0B) != Sign::zero && reach(i, of_.AB - of_.B0B) != Sign::zero) return Obstacle::none;
    const auto across = [&]<class T>() -> T { return cross(frame<T>(), crank<T>(i)); };
    return has_change_points_ && settled_sign(across) == Sign::zero ? Obstacle::change_point : Obstacle::limit;
  }

  // The sign of AB₀² - bars².
  Sign reach(std::size_t i, const Rational& bars) const {
    const Rational squares = of_.A0A * of_.A0A + frame_squared(of_) - bars * bars;
    return settled_sign([&]<class T>() -> T {
      return from_rational<T>(squares) -
             from_rational<T>(2 * of_.A0A) * dot(questions::frame_vector<T>(of_), unit_vector<T>(cranks_[i]));
    });
  }

  // What lies on the way from direction i to the next, the shorter way round; its ends not counted.
  // AB₀ is nearest and farthest at the ends of the arc, or where the arc crosses the line A₀B₀.
  Obstacle between(std::size_t i) const {
    if (turns_freely()) return Obstacle::none;
    if (!closes(i) || !closes(i + 1)) return Obstacle::limit;
    const bool passes_near = passes(i, 1), passes_far = passes(i, -1);
    if (passes_near && AB0_.nearest_to_least == Sign::negative) return Obstacle::limit;
    if (passes_far && AB0_.farthest_to_most == Sign::positive) return Obstacle::limit;
    if (passes_near && AB0_.nearest_to_least == Sign::zero) return Obstacle::change_point;
    if (passes_far && AB0_.farthest_to_most == Sign::zero) return Obstacle::change_point;
    return Obstacle::none;
  }

  // Whether the frame's direction (towards = 1) or its opposite (-1) lies between direction i and the next, ends
  // excluded.
  bool passes(std::size_t i, int towards) const {
    const Sign turning = settled_sign([&]<class T>() -> T { return cross(crank<T>(i), crank<T>(i + 1)); });
    if (turning == Sign::zero) {
      const Sign same = settled_sign([&]<class T>() -> T { return dot(crank<T>(i), crank<T>(i + 1)); });
      if (same == Sign::negative)
        throw Impossible("two directions of the sweep are opposite: the way from one to the other is not known",
                         "due direzioni del giro sono opposte: non si sa per quale via si vada dall'una all'altra");
      return false;
    }
    const Sign before = settled_sign([&]<class T>() -> T { return T(towards) * cross(crank<T>(i), frame<T>()); });
    const Sign after = settled_sign([&]<class T>() -> T { return T(towards) * cross(frame<T>(), crank<T>(i + 1)); });
    return before == turning && after == turning;
  }

  template <class T>
  Vector<T> crank(std::size_t i) const {
    return unit_vector<T>(cranks_[i]);
  }
  template <class T>
  Vector<T> frame() const {
    return questions::frame_vector<T>(of_);
  }

  const FourBarLengths& of_;
  const std::vector<CrankDirection>& cranks_;
  Span AB0_;
  bool has_change_points_;
};

}  // namespace sweeping

// The stretches of a sweep that goes from each direction to the next the shorter way round. Directions in which the
// linkage does not close are in none. A limit position or change point ends one stretch and begins the next.
// Throws Impossible when two directions one after the other are opposite, and as grashof does; Undecided when no
// number can tell.
inline std::vector<Stretch> stretches(const FourBarLengths& of, const std::vector<CrankDirection>& cranks) {
  return sweeping::Sweep(of, cranks).stretches();
}

// The side of A -> B₀ on which B is throughout the sweep, when it begins on the side `start`. Throws Impossible when
// the sweep does not stay on it: because a limit position or a change point is in the way. Else as stretches.
inline Side side_throughout(const FourBarLengths& of, const std::vector<CrankDirection>& cranks, Side start) {
  const std::vector<Stretch> found = stretches(of, cranks);
  if (found.size() == 1 && found.front().first == 0 && found.front().last + 1 == cranks.size()) return start;
  const bool is_change =
      !found.empty() && found.front().first == 0 && found.front().ended_by == Obstacle::change_point;
  throw Impossible(is_change ? Phrase{"the sweep passes a change point, from which two motions lead",
                                      "il giro passa per un punto di cambiamento, da cui partono due moti"}
                             : Phrase{"the sweep passes a limit position of the crank",
                                      "il giro passa per una posizione limite della manovella"});
}

}  // namespace epure::geometry
