// A pair of involute gears by closed formulas: the second route.
//
// Symbols of the books on gears (DIN 3960, ISO 21771): α_w from inv α_w = inv α + 2 tan α (x1 + x2)/(z1 + z2); then
//   a cos α_w = (z1 + z2) m cos α / 2,   g_f = √(r_a2² - r_b2²) - r_b2 tan α_w,   g_a = √(r_a1² - r_b1²) - r_b1 tan
//   α_w.
// One sign s turns them into those of a ring (s = -1: z2, r_w2 and their like become negative there); a rack is the
// limit of infinite z2.
//
// Metres, radians.
#pragma once

#include "geometry/analytic/decide.h"
#include "geometry/analytic/involute_formulas.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry::analytic {

enum class Mate { wheel, ring, rack };

// As given. z need not be whole.
struct Gears {
  Mate mate = Mate::wheel;
  Rational z1 = 0, z2 = 0, m = 0;
  Angle alpha = {};
  Rational x1 = 0, x2 = 0, ha = 0, hf = 0, k = 0, j = 0;

  int s() const { return mate == Mate::ring ? -1 : 1; }
  // tan α_w is not tan α.
  bool is_shifted() const { return mate != Mate::rack && x1 + s() * x2 != 0; }
};

template <class T>
struct GearAngle {
  T cosine, sine;
  T tangent() const { return quotient(sine, cosine); }
};

// α_w. Throws Impossible when there is none; LeavesTheTower or Undecided on the exact numbers, when shifts change it.
template <class T>
GearAngle<T> working_angle(const Gears& of) {
  const GearAngle<T> alpha{cosine<T>(of.alpha), sine<T>(of.alpha)};
  if (!of.is_shifted()) return alpha;
  if constexpr (NumberWithAngles<T>) {
    const T in_radians = radians<T>(of.alpha);
    // (x1 + x2)/(z1 + z2); in a ring (x2 - x1)/(z2 - z1).
    const T quota = from_rational<T>(2 * (of.x1 + of.s() * of.x2) / (of.z1 + of.s() * of.z2));
    const T involute = (T(1) + quota) * alpha.tangent() - in_radians;
    if (decided_sign(involute, {"whether the wheels have a working pressure angle",
                                "se le ruote abbiano un angolo di pressione di lavoro"}) == Sign::negative)
      throw Impossible(
          "the wheels cannot mesh: for these profile shifts no working pressure angle exists",
          "le ruote non possono ingranare: con queste correzioni non esiste alcun angolo di pressione di lavoro");
    const T angle = angle_of_involute(involute);
    return {cosine_of_angle(angle), sine_of_angle(angle)};
  } else {
    throw LeavesTheTower("the inverse of the involute function", "l'inversa della funzione involuta");
  }
}

template <class T>
struct GearFormulas {
  Gears of;
  GearAngle<T> alpha, alpha_w;

  static T number(const Rational& q) { return from_rational<T>(q); }
  const Rational& z(int wheel) const { return wheel == 1 ? of.z1 : of.z2; }
  const Rational& x(int wheel) const { return wheel == 1 ? of.x1 : of.x2; }
  // -1 for the ring.
  int s(int wheel) const { return wheel == 1 ? 1 : of.s(); }

  // Of wheel 1, or of wheel 2 that is no rack.
  T r(int wheel) const { return number(of.m * z(wheel) / 2); }
  T r_b(int wheel) const { return number(of.m * z(wheel) / 2) * alpha.cosine; }
  T r_w(int wheel) const { return of.is_shifted() ? quotient(r_b(wheel), alpha_w.cosine) : r(wheel); }
  T r_tip(int wheel) const { return number(of.m * (z(wheel) / 2 + x(wheel) + s(wheel) * (of.ha - of.k))); }
  T r_root(int wheel) const { return number(of.m * (z(wheel) / 2 + x(wheel) - s(wheel) * of.hf)); }
  // The tangent from the tip to the base circle: √(r_a² - r_b²).
  T tip_tangent(int wheel) const {
    const T squares = square(r_tip(wheel)) - square(r_b(wheel));
    if (decided_sign(squares, {"whether a tip circle reaches the base circle",
                               "se una circonferenza di testa raggiunga quella di base"}) == Sign::negative)
      throw Impossible("the tip circle lies inside the base circle, where no involute is",
                       "la circonferenza di testa sta dentro quella di base, dove non c'è evolvente");
    return root(squares);
  }

  // O1O2; to a rack's pitch line.
  T a() const {
    if (of.mate == Mate::rack) return r(1);
    const T unshifted = number(of.m * (of.z2 + of.s() * of.z1) / 2);
    return of.is_shifted() ? quotient(unshifted * alpha.cosine, alpha_w.cosine) : unshifted;
  }
  T base_pitch() const { return number(of.m) * pi<T>() * alpha.cosine; }

  // How far T1 and T2 lie before and after the pitch point: r_b tan α_w. Wheel 2 of an external pair only.
  T limit_of_path(int wheel) const { return r_b(wheel) * alpha_w.tangent(); }
  // O2T1 and O1T2: the hypotenuse over r_b and T1T2 = a sin α_w.
  T limit_of_tip(int wheel) const { return root(square(r_b(wheel)) + square(a() * alpha_w.sine)); }

  // 0 where a tip circle is the working pitch circle itself.
  T path_of_approach() const {
    if (of.mate == Mate::rack) return quotient(number(of.m * (of.ha - of.k - of.x1)), alpha.sine);
    return tip_is_pitch_circle(2) ? T(0) : number(of.s()) * (tip_tangent(2) - r_b(2) * alpha_w.tangent());
  }
  T path_of_recess() const { return tip_is_pitch_circle(1) ? T(0) : tip_tangent(1) - r_b(1) * alpha_w.tangent(); }
  T path_of_contact() const { return path_of_approach() + path_of_recess(); }
  T contact_ratio() const { return quotient(path_of_contact(), base_pitch()); }
  // On the working pitch circles.
  T arc(const T& path) const { return quotient(path, alpha_w.cosine); }

  // Of wheel 1 the distance O1A; of wheel 2, no rack, O2E.
  T start_of_active_profile(int wheel) const {
    const T from_T = wheel == 1 ? r_b(1) * alpha_w.tangent() - path_of_approach()
                                : r_b(2) * alpha_w.tangent() - number(of.s()) * path_of_recess();
    return root(square(r_b(wheel)) + square(from_T));
  }

  // z1/z2; 0 for a rack.
  Rational ratio() const { return of.mate == Mate::rack ? Rational(0) : of.z1 / of.z2; }
  Rational speed_ratio() const { return -of.s() * ratio(); }  // ω2/ω1

  // Over the velocity of the flank itself, at ξ from the pitch point:
  //   1 - ω2-part/ω1-part = ξ (1 + s z1/z2)/(P0T1 + ξ)   and its like. Throw Impossible in T1, T2.
  T specific_sliding_1(const T& xi) const { return over(number(1 + of.s() * ratio()) * xi, limit_of_path(1) + xi); }
  T specific_sliding_2(const T& xi) const {
    if (of.mate == Mate::rack) return -over(xi, limit_of_path(1));
    return -over(number(of.z2 / of.z1 + of.s()) * xi, limit_of_path(2) - number(of.s()) * xi);
  }

  // s_b = cos α (s + m z inv α) on the base circle, of a ring cos α (s - m z inv α); the angle s_b/r_b less twice
  // inv α_ρ is left at the radius ρ (of a ring, more). The backlash takes j/2
  // on r_w, which is j cos α_w / 2 on r_b.
  T base_thickness(int wheel) const {
    const T from_shift = number(2 * s(wheel) * x(wheel)) * alpha.tangent();
    const T on_reference = number(of.m) * (number(Rational(1, 2)) * pi<T>() + from_shift);
    const T opened = number(s(wheel) * of.m * z(wheel)) * involute(alpha);
    return alpha.cosine * (on_reference + opened) - number(of.j / 2) * alpha_w.cosine;
  }
  // `tangent`: √(ρ² - r_b²).
  T thickness(int wheel, const T& radius, const T& tangent) const {
    const T at = quotient(tangent, r_b(wheel)) - angle(tangent, r_b(wheel));  // inv
    return radius * (quotient(base_thickness(wheel), r_b(wheel)) - number(2 * s(wheel)) * at);
  }
  T reference_thickness(int wheel) const {
    return thickness(wheel, r(wheel), number(of.m * z(wheel) / 2) * alpha.sine);
  }
  T working_thickness(int wheel) const { return thickness(wheel, r_w(wheel), r_b(wheel) * alpha_w.tangent()); }
  T tip_thickness(int wheel) const { return thickness(wheel, r_tip(wheel), tip_tangent(wheel)); }
  // Of a rack `h` above its reference line.
  T rack_thickness(const Rational& h) const {
    return number(of.m) * (number(Rational(1, 2)) * pi<T>() - number(2 * h / of.m) * alpha.tangent()) -
           number(of.j / 2);
  }
  T tip_pressure_angle(int wheel) const { return angle(tip_tangent(wheel), r_b(wheel)); }

  // r sin²α + x m: the rack's largest addendum that does not undercut wheel 1.
  T undercut_limit_addendum() const {
    return number(of.m) * (number(of.z1 / 2) * square(alpha.sine) + number(of.x1));
  }
  // Between the tip of the wheel and the other's root.
  T clearance(int wheel) const {
    if (!of.is_shifted()) return number(of.m * (of.hf - of.ha + of.k));
    if (of.mate == Mate::wheel) return a() - r_tip(wheel) - r_root(3 - wheel);
    return wheel == 1 ? r_root(2) - a() - r_tip(1) : r_tip(2) - a() - r_root(1);
  }

 private:
  bool tip_is_pitch_circle(int wheel) const { return !of.is_shifted() && x(wheel) + s(wheel) * (of.ha - of.k) == 0; }
  static T over(const T& numerator, const T& denominator) {
    if (is_zero(denominator, {"whether contact is where a flank has no velocity",
                              "se il contatto sia dove un fianco non ha velocità"}))
      throw Impossible("a flank has no velocity along itself there", "lì un fianco non ha velocità lungo sé stesso");
    return quotient(numerator, denominator);
  }
  // arctan(y/x); tan α - α of an angle.
  static T angle(const T& y, const T& x) {
    if constexpr (NumberWithAngles<T>) {
      return arc_tangent(y, x);
    } else {
      throw Undecided("an angle", "un angolo");
    }
  }
  static T involute(const GearAngle<T>& of_angle) {
    return of_angle.tangent() - angle(of_angle.sine, of_angle.cosine);
  }
};

template <class T>
GearFormulas<T> gear_formulas(const Gears& of) {
  return {of, {cosine<T>(of.alpha), sine<T>(of.alpha)}, working_angle<T>(of)};
}

}  // namespace epure::geometry::analytic
