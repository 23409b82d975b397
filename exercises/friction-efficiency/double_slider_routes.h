// The double slider: the sliders as bodies 2 and 3, the link as the line of its force.
#pragma once

#include "exercises/friction-efficiency/with_friction.h"

namespace epure::friction_efficiency {

template <class Model, class T>
void describe_by_link(Model& model, const DoubleSlider& of, const XY<T>& A, const XY<T>& B, const XY<T>& on_link,
                      const XY<T>& link, const XY<T>& R_12, const XY<T>& R_14) {
  model.load("Q", 2, A.x, A.y, T(0), -number<T>(of.Q));
  model.guide("R_12", 1, 2, R_12.x, R_12.y);
  model.contact("R_32", 3, 2, on_link.x, on_link.y, link.x, link.y);
  model.guide("R_14", 1, 3, R_14.x, R_14.y);
  model.effort("P", 3, B.x, B.y, T(1), T(0));
}

// The line of the link's force, from slider 4 to slider 2, turned from AB clockwise in the direct motion by the angle
// whose sine is that of two friction circles' radii over AB; its turn is told by sine and cosine.
template <class T>
struct Tilt {
  T sine, cosine;
};
template <class T>
Tilt<T> tilt_of(const Problem& problem, bool has_pins) {
  if (!has_pins) return {T(0), T(1)};
  const T s = geometry::quotient(number<T>(2 * problem.radius) * geometry::sine<T>(problem.phi),
                                 number<T>(problem.of.double_slider.l));
  return {s, geometry::root(T(1) - geometry::square(s))};
}

template <class T>
Motions<T> double_slider_motions(const Problem& problem, bool has_pins) {
  const DoubleSlider of = problem.of.double_slider;
  const auto link_at = [=](const Turned& turned) {
    const Tilt<T> tilt = tilt_of<T>(problem, has_pins && turned.motion != Motion::ideal);
    const T c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta), turn = T(-turned.sense()) * tilt.sine;
    return XY<T>{c * tilt.cosine - s * turn, s * tilt.cosine + c * turn};
  };
  const auto points = [=] {
    const T l = number<T>(of.l);
    return std::pair{XY<T>{T(0), l * geometry::sine<T>(of.theta)}, XY<T>{-(l * geometry::cosine<T>(of.theta)), T(0)}};
  };
  const auto middle = [](const XY<T>& A, const XY<T>& B) {
    const T h = number<T>(Rational(1, 2));
    return XY<T>{h * (A.x + B.x), h * (A.y + B.y)};
  };
  const auto constructed = [=](auto& model, const Turned& turned) {
    const auto [A, B] = points();
    const Vector<T> right{T(1), T(0)}, up{T(0), T(1)};  // sliding of 4 and of 2
    model.directed("Q", quarter());
    if (const auto tilt = has_pins ? problem.tilt : Angle{})
      model.directed("R_32", of.theta - Rational(turned.sense()) * *tilt);
    model.directed("R_14", turned.direction<T>(quarter(), up, right));
    describe_by_link<std::decay_t<decltype(model)>, T>(model, of, A, B, middle(A, B), link_at(turned),
                                                       turned.components<T>(-right, up),
                                                       turned.components<T>(up, right));
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const auto [A, B] = points();
    const Complex<T> O{T(0), T(0)};
    describe_by_link<std::decay_t<decltype(model)>, T>(model, of, A, B, middle(A, B), link_at(turned),
                                                       unit<T>(turned.angle<T>(half(), velocity_of(ideal, 2, O))),
                                                       unit<T>(turned.angle<T>(quarter(), velocity_of(ideal, 3, O))));
  };
  return in_all_motions<T>(3, "P", problem.phi, constructed, analysed);
}

inline std::vector<VectorQuantity> forces_of_double_slider() {
  return {force_between(1, 2), force_between(1, 4), force_between(3, 2)};
}

template <class T>
void write_double_slider(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("double_slider.", {", double slider", ", doppio pattino"});
  write_motions<T>(ledger, names_of_P(), double_slider_motions<T>(problem, false), {T(1), T(0)},
                   forces_of_double_slider(), without_effort(problem.double_slider_at_limit));
  put_whole(ledger, self_locking_angle(), quarter() - problem.of.double_slider.theta);
  put_whole(ledger, jamming_angle(), problem.of.double_slider.theta);
}

template <class T>
void write_double_slider_pins(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("double_slider_pins.",
                    {", double slider with friction in the pins", ", doppio pattino con attrito nei perni"});
  write_motions<T>(ledger, names_of_P(), double_slider_motions<T>(problem, true), {T(1), T(0)},
                   forces_of_double_slider(), without_effort(problem.pins_at_limit));
  const Quantity circle{
      "friction_circle_radius", "$ρ$", "m", {"radius of the friction circles", "raggio dei cerchi d'attrito"}};
  const Quantity tilt{"link_line_tilt_angle_deg",
                      "$δ$",
                      "deg",
                      {"angle of the link's force with AB", "angolo della forza dell'asta con AB"}};
  const Angle phi = problem.phi, theta = problem.of.double_slider.theta;
  const auto at = [=] { return tilt_of<T>(problem, true); };
  const auto tilt_deg = [=] { return in_degrees(slope_angle(Vector<T>{at().cosine, at().sine})); };
  const auto tilt_by_half = [=] {
    return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{at().cosine, at().sine}));
  };
  ledger.route("construction");
  ledger.put(circle, [&] { return number<T>(problem.radius) * geometry::sine<T>(phi); });
  ledger.put(tilt, [&] { return tilt_deg(); });
  for (const Motion motion : with_friction)
    ledger.put(
        Quantity{"link_line_angle" + suffix(motion) + "_deg", motion == Motion::direct ? "$ψ$" : "$ψ'$", "deg",
                 Words{"direction of the link's force on slider 2", "direzione della forza dell'asta sul pattino 2"} +
                     words_of(motion)},
        [=] { return given_in_degrees<T>(theta) + (motion == Motion::direct ? -tilt_deg() : tilt_deg()); });
  ledger.route("analytic");
  ledger.put(circle, [&] { return number<T>(problem.radius) * geometry::cosine<T>(quarter() - phi); });
  ledger.put(tilt, [&] { return tilt_by_half(); });
  const Motions<T> all = double_slider_motions<T>(problem, true);
  const T l = number<T>(problem.of.double_slider.l), twice_r = number<T>(2 * problem.radius);
  put_limit_with_pins(ledger, self_locking_angle(), quarter() - theta, l, twice_r);
  put_limit_with_pins(ledger, jamming_angle(), theta, l, twice_r);
  ledger.route("construction");
  const Point<T> A{T(0), l * geometry::sine<T>(theta)}, B{-(l * geometry::cosine<T>(theta)), T(0)};
  ledger.draws_point("A", A);
  ledger.draws_point("B", B);
  for (const Motion motion : with_friction) {
    const auto touched = [=](const Point<T>& X) {
      return geometry::foot(X, all.bodies.at(motion)().line_of("R_32"));
    };
    ledger.draws_point("on_A" + suffix(motion), [&] { return touched(A); });
    ledger.draws_point("on_B" + suffix(motion), [&] { return touched(B); });
  }
  ledger.route("equilibrium equations");
  for (const Motion motion : with_friction)
    ledger.put("link_line_angle" + suffix(motion) + "_deg",
               [=] { return in_degrees(angle_of(all.equations.at(motion)().force("R_32"))); });
}

}  // namespace epure::friction_efficiency
