// A pair of involute gears as it is given: two wheels, a wheel in a ring, or a wheel on a rack. All of it exact.
//
// Lengths in metres. The generating rack has the profile of ISO 53 with the factors ha, hf, rho of the module; x is
// counted positive outwards from the centre of the wheel, for a ring too.
#pragma once

#include "geometry/numbers/angle.h"

namespace epure::geometry {

enum class PairKind {
  external,
  internal,  // wheel 2 is a ring with teeth inside
  rack       // wheel 2 is a rack: z2 and x2 are not looked at
};

struct PairData {
  PairKind kind = PairKind::external;
  long z1 = 0, z2 = 0;
  Rational m = {};          // module
  Angle alpha = {};         // pressure angle of the generating rack
  Rational x1 = 0, x2 = 0;  // profile shifts over m
  Rational ha = 1;          // addendum of the rack over m
  Rational hf = {5, 4};     // dedendum over m, which is how deep the cutter reaches
  Rational k = 0;           // the tips are shortened by k m
  Rational rho = {1, 4};    // rounding of the cutter's tip, over m
  Rational j = 0;           // backlash on the working pitch circles: each tooth is thinner there by j/2
};

// Of wheel 1 or 2.
inline long teeth_of(const PairData& of, int wheel) { return wheel == 1 ? of.z1 : of.z2; }
inline const Rational& shift_of(const PairData& of, int wheel) { return wheel == 1 ? of.x1 : of.x2; }

// One wheel of the pair.
struct WheelData {
  bool ring = false;
  long z = 0;
  Rational m = {};
  Rational x = 0;
  Rational r = {};      // reference circle, m z / 2
  Rational r_tip = {};  // of a ring smaller than r_root
  Rational r_root = {};
};

inline WheelData first_wheel(const PairData& of) {
  const Rational r = of.m * Rational(of.z1) / 2;
  return {false, of.z1, of.m, of.x1, r, r + of.m * (of.ha + of.x1 - of.k), r - of.m * (of.hf - of.x1)};
}

// The second one, which must not be a rack.
inline WheelData second_wheel(const PairData& of) {
  const Rational r = of.m * Rational(of.z2) / 2;
  if (of.kind == PairKind::internal)
    return {true, of.z2, of.m, of.x2, r, r + of.m * (of.x2 - of.ha + of.k), r + of.m * (of.x2 + of.hf)};
  return {false, of.z2, of.m, of.x2, r, r + of.m * (of.ha + of.x2 - of.k), r - of.m * (of.hf - of.x2)};
}

// The heights of a rack's lines above its pitch line, on which wheel 1's pitch circle r1 rolls; its teeth point down.
struct RackLines {
  Rational reference, tip, root;
};
inline RackLines rack_lines(const PairData& of) {
  const Rational reference = of.m * of.x1;
  return {reference, reference - of.m * (of.ha - of.k), reference + of.m * of.hf};
}

// (x1 + x2)/(z1 + z2), internal (x2 - x1)/(z2 - z1), rack 0: the working pressure angle follows from
//   inv α_w = inv α + 2 tan α · this,
// and is α itself when this is zero.
inline Rational shift_per_tooth(const PairData& of) {
  switch (of.kind) {
    case PairKind::external:
      return (of.x1 + of.x2) / Rational(of.z1 + of.z2);
    case PairKind::internal:
      return (of.x2 - of.x1) / Rational(of.z2 - of.z1);
    default:
      return 0;
  }
}

}  // namespace epure::geometry
