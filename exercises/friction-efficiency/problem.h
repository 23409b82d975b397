// The mechanisms with friction: the givens beside those of the mechanisms, and what is decided on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/linkages/loaded_mechanisms.h"

namespace epure::friction_efficiency {

// What has quantities of its own: friction, and each mechanism.
inline const std::vector<std::string> cases{"",
                                            "wedge_collar",
                                            "wedge_collar_two_point",
                                            "double_slider",
                                            "double_slider_pins",
                                            "sliding_levers",
                                            "sliding_levers_Q_on_2",
                                            "fairbairn",
                                            "fairbairn_short_lever"};

struct Problem {
  LoadedMechanisms of;
  Angle phi;        // of friction, at every contact
  Rational radius;  // of the pins

  // From AB to the link's force, with friction in its pins, where that is a given angle: δ of sin δ = 2 r sin φ/l is
  // φ for 2 r = l. Otherwise no sum of given angles is δ, unless the link jams: sines of rational angles have a
  // rational ratio only when they are equal, or those of 30° and 90°; sines of angles in radians only when they are
  // equal.
  std::optional<Angle> tilt;
  // Exactly at the limit of self-locking, where P is zero in the retrograde motion.
  bool wedge_at_limit, double_slider_at_limit, pins_at_limit, levers_at_limit, levers_Q_on_2_at_limit;

  // Throws BadGivens also where the direct motion jams.
  explicit Problem(const Givens& givens);
};
std::vector<GivenSpec> stated_givens();
// Of Fairbairn's mechanism with its lever upright, or across the crank.
Words why_no_sliding(const Fairbairn& of, const std::string& name);

}  // namespace epure::friction_efficiency
