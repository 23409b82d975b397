// The tooth of a rack, in the frame of tooth_outline.h, set back as tooth_form.h explains.
#pragma once

#include "geometry/gears/root_curve.h"

namespace epure::geometry {

template <class T>
struct RackForm {
  T half_pitch, root;               // the middle of the space; the height of the root line
  Point<T> centre;                  // of the rounding, which begins straight above it
  T radius, angle;                  // and turns by this angle towards the flank
  Point<T> flank_start, flank_end;  // at the rounding; at the tip, on the y axis when the tooth is pointed
};

// Throws Impossible when the spaces are pointed before they reach the root line, or no flank is left.
template <class T>
RackForm<T> rack_form(const PairData& of, const Rational& set_back) {
  const PressureAngle<T> alpha = pressure_angle<T>(of.alpha);
  const T half_pitch = quotient(pi<T>() * from_rational<T>(of.m), T(2)), back = from_rational<T>(set_back);
  const T thinner = from_rational<T>(of.j / 4);
  const CutterTip<T> space = cutter_tip(of, Rational(0), alpha, thinner);
  RackForm<T> form{half_pitch,
                   from_rational<T>(of.hf * of.m) + back,
                   {half_pitch - space.c, space.d},
                   space.rho + back,
                   arc_tangent(alpha.cosine, alpha.sine),
                   {},
                   {}};
  form.flank_start = {form.centre.x - form.radius * alpha.cosine, form.centre.y + form.radius * alpha.sine};
  // The flank: x = at_reference + y tan α.
  const T at_reference = quotient(half_pitch, T(2)) - thinner - quotient(back, alpha.cosine);
  const T tip = back - from_rational<T>(of.m * (of.ha - of.k)), at_tip = at_reference + tip * alpha.tangent;
  switch (sign(at_tip)) {
    case Sign::undecided:
      throw Undecided("whether the rack's teeth are pointed", "se i denti della dentiera siano a punta");
    case Sign::positive:
      form.flank_end = {at_tip, tip};
      break;
    default:
      form.flank_end = {T(0), -quotient(at_reference, alpha.tangent)};
  }
  if (sign(form.flank_start.y - form.flank_end.y) != Sign::positive)
    throw Impossible("nothing is left of the flanks of the rack", "dei fianchi della dentiera non resta nulla");
  return form;
}

}  // namespace epure::geometry
