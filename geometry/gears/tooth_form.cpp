#include "geometry/gears/tooth_form.h"

#include "geometry/gears/tooth_thickness.h"
#include "geometry/numbers/enclosure.h"

#include <optional>

namespace epure::geometry {

namespace {

bool is_positive(const Deep& x, const Phrase& question) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided) throw Undecided(question);
  return decided == Sign::positive;
}

// Where a function that is negative at `from` and positive at `to` crosses zero: halved until the doubles are
// neighbours, or the number at hand cannot tell the sign any more.
template <class Function>
Deep crossing(const Function& function, double from, double to) {
  for (double middle = from / 2 + to / 2; from < middle && middle < to; middle = from / 2 + to / 2) {
    const Sign there = sign(function(Deep::from_double(middle)));
    if (there == Sign::zero || there == Sign::undecided) return Deep::from_double(middle);
    (there == Sign::positive ? to : from) = middle;
  }
  return Deep::from_bounded(Bounded(from, to));
}

// Of the point at the radius r of the flank's involute.
Deep tangent_at(const RightFlank<Deep>& flank, const Deep& r) { return pressure_angle_at(r, flank.r_b).tangent; }

// Where the flank ends: on the tip circle, or before it where both flanks meet.
void close_tip(ToothForm<Deep>& form) {
  const RightFlank<Deep>& flank = form.flank;
  const Deep to_tip = tangent_at(flank, form.r_tip), inv = involute(to_tip);
  const Deep half = flank.ring ? flank.half_angle + inv : flank.half_angle - inv;
  const bool is_pointed = !is_positive(half, {"whether a tooth is pointed", "se un dente sia a punta"});
  form.tip_half_angle = is_pointed ? Deep(0) : half;
  form.t_tip = is_pointed ? tangent_of_involute(flank.ring ? -flank.half_angle : flank.half_angle) : to_tip;
}

// ---- wheel
// ---------------------------------------------------------------------------------------------------------

Deep out_of_base(const RightFlank<Deep>& flank, const Point<Deep>& Q) {
  return length_squared(Vector<Deep>{Q.x, Q.y}) - square(flank.r_b);
}

// How far to the right of the flank, as an angle, a point outside the base circle lies.
Deep beyond(const RightFlank<Deep>& flank, const Point<Deep>& Q) {
  const Deep t = quotient(root(out_of_base(flank, Q)), flank.r_b);
  return arc_tangent(Q.x, Q.y) + involute(t) - flank.half_angle;
}

// Where the root curve of an undercut tooth crosses the flank. The curve's distance from the wheel's centre grows
// with p; where it leaves the base circle it still lies inside the tooth, and its end lies beyond the involute's
// start, on the other branch. Nothing when doubles cannot tell that end from the base circle.
std::optional<Deep> undercut_end(const RootCurve<Deep>& curve, const RightFlank<Deep>& flank, const Deep& end) {
  const double last = to_bounded(end).inf();
  if (sign(out_of_base(flank, curve(Deep::from_double(last)))) != Sign::positive) return {};
  const auto out = [&](const Deep& p) { return out_of_base(flank, curve(p)); };
  const bool from_base = !is_positive(out(Deep(1)), {"whether the root circle reaches the base circle",
                                                     "se la circonferenza di piede raggiunga quella di base"});
  const double first = from_base ? to_bounded(crossing(out, 1, last)).sup() : 1;
  return crossing([&](const Deep& p) { return beyond(flank, curve(p)); }, first, last);
}

void cut_root(ToothForm<Deep>& form, const GearPair<Deep>& pair, const Rational& x, const WheelCircles<Deep>& circles,
              const Deep& back) {
  const Deep half_play = quotient(from_rational<Deep>(pair.given.j / 4), circles.r_w);
  CutterTip<Deep> tip = cutter_tip(pair.given, x, pair.alpha, half_play * circles.r);
  tip.rho += back;
  GeneratedRoot<Deep> cut{{circles.r, form.half_pitch, tip}, quotient(Deep(1) + pair.alpha.cosine, pair.alpha.sine)};
  // On the line of action through the centre of the rounding, from the base circle to the end of the straight edge.
  const Deep from_base = circles.r * pair.alpha.sine - quotient(tip.d, pair.alpha.sine) - tip.rho;
  // At the limit of undercut, which may not be decided here, the flank begins on the base circle either way.
  const bool is_undercut = sign(from_base) == Sign::negative;
  form.t_form = is_undercut ? Deep(0) : quotient(from_base, circles.r_b);
  if (const auto crossed = is_undercut ? undercut_end(cut.curve, form.flank, cut.end) : std::nullopt) {
    cut.end = *crossed;
    form.t_form = quotient(root(out_of_base(form.flank, cut.curve(cut.end))), circles.r_b);
  }
  form.root = cut;
}

// ---- ring
// ----------------------------------------------------------------------------------------------------------

// The centre of a rounding that touches root circle and flank lies on a parallel of the flank. Its angle from +y.
struct RoundingCentre {
  Deep t, r, direction;
};
RoundingCentre rounding_centre(const ToothForm<Deep>& form, const Deep& radius) {
  const Deep r = form.r_root - radius, t = tangent_at(form.flank, r);
  return {t, r, form.flank.half_angle + quotient(radius, form.flank.r_b) + involute(t)};
}

// The given radius, or the largest above `least` that fits between the tooth and the middle of the space. Nothing
// when the flanks of two teeth meet before they reach the root circle.
std::optional<Deep> rounding_that_fits(const ToothForm<Deep>& form, const Deep& radius, const Deep& least) {
  const auto too_wide = [&](const Deep& tried) { return rounding_centre(form, tried).direction - form.half_pitch; };
  if (!is_positive(too_wide(radius), {"whether a rounding fits into a space", "se un raccordo stia in un vano"}))
    return radius;
  if (is_positive(too_wide(least), {"whether a space is pointed", "se un vano sia a punta"})) return {};
  return Deep::from_double(to_bounded(crossing(too_wide, to_bounded(least).sup(), to_bounded(radius).sup())).inf());
}

void round_root(ToothForm<Deep>& form, const Deep& wanted, const Deep& least) {
  const auto radius = rounding_that_fits(form, wanted, least);
  if (!radius) {
    form.root = RoundedRoot<Deep>{{}, Deep(0), form.half_pitch, Deep(0)};
    form.t_form = tangent_of_involute(form.half_pitch - form.flank.half_angle);
    return;
  }
  const RoundingCentre at = rounding_centre(form, *radius);
  const Point<Deep> centre{at.r * sine_of_angle(at.direction), at.r * cosine_of_angle(at.direction)};
  form.root = RoundedRoot<Deep>{centre, *radius, at.direction, arc_tangent(Deep(1), at.t)};
  form.t_form = at.t + quotient(*radius, form.flank.r_b);
}

}  // namespace

// From the thickness on the reference circle, where the involute has the pressure angle of the rack.
RightFlank<Deep> right_flank(const GearPair<Deep>& pair, int wheel) {
  const WheelCircles<Deep>& circles = wheel == 1 ? pair.wheel1 : *pair.wheel2;
  const Deep half = quotient(tooth_thickness(pair, wheel, circles.r), Deep(2) * circles.r);
  const Deep inv = involute(pair.alpha.tangent);
  const bool is_ring = wheel == 2 && pair.given.kind == PairKind::internal;
  return {circles.r_b, is_ring ? half - inv : half + inv, is_ring};
}

ToothForm<Deep> tooth_form(const PairData& of, int wheel, const Rational& set_back) {
  const GearPair<Deep> pair = gear_pair<Deep>(of);
  const WheelData data = wheel == 1 ? first_wheel(of) : second_wheel(of);
  const WheelCircles<Deep>& circles = wheel == 1 ? pair.wheel1 : *pair.wheel2;
  const Deep back = from_rational<Deep>(set_back);
  ToothForm<Deep> form;
  form.flank = right_flank(pair, wheel);
  form.flank.half_angle -= quotient(back, circles.r_b);
  form.half_pitch = quotient(pi<Deep>(), from_rational<Deep>(Rational(data.z)));
  if (data.ring) {
    const bool reaches_base = sign(circles.r_tip - circles.r_b) != Sign::positive;
    form.r_tip = (reaches_base ? circles.r_b : circles.r_tip) + back;
    form.r_root = circles.r_root + back;
    round_root(form, from_rational<Deep>(of.rho * of.m) + back, back);
  } else {
    form.r_tip = circles.r_tip - back;
    form.r_root = circles.r_root - back;
    cut_root(form, pair, data.x, circles, back);
  }
  close_tip(form);
  const Deep flank = data.ring ? form.t_form - form.t_tip : form.t_tip - form.t_form;
  if (!is_positive(flank, {"whether a tooth has a flank", "se un dente abbia un fianco"}))
    throw Impossible(
        Words{"nothing is left of the flanks of wheel ", "dei fianchi della ruota non resta nulla: ruota "} +
        std::to_string(wheel));
  return form;
}

Deep form_radius(const ToothForm<Deep>& form) { return form.flank.r_b * root(Deep(1) + square(form.t_form)); }

}  // namespace epure::geometry
