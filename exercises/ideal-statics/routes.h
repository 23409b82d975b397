// The mechanisms in equilibrium by force polygons, one body after the other; by the equations of equilibrium of all
// bodies at once; and by virtual work, with poles, with the polar diagram of velocities, and with the equations that
// the joints put on the velocities.
#pragma once

#include "exercises/ideal-statics/quantities.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/loaded_routes.h"
#include "geometry/motion/instant_centres.h"

namespace epure::ideal_statics {

using namespace loaded;

inline constexpr Phrase normal_along_hinges{
    "it is at infinity: the contact's normal is parallel to the line of hinges",
    "è all'infinito: la normale di contatto è parallela alla retta delle cerniere"};
inline constexpr Phrase parallel_cranks{"it is at infinity: A₀A and B₀B are parallel",
                                        "è all'infinito: A₀A e B₀B sono parallele"};
inline constexpr Phrase resting_coupler{"the coupler does not turn", "la biella non ruota"};

// P along its direction, and as it is drawn; what the loads' powers in virtual velocities make of it.
template <class T, class Bodies, class Equal>
void put_P(Ledger<T>& ledger, const Bodies& bodies, const Equal& equations, const XY<T>& along) {
  ledger.route("force polygon");
  ledger.put(P().length(), [&] { return bodies().along("P"); });
  draw_vector(ledger, P().name, [&] { return bodies().force("P"); });
  ledger.route("equilibrium equations");
  ledger.put(P().length(), [&] { return analytic::dot(complex(along), complex(xy(equations().force("P")))); });
}
template <class T, class Equal>
void put_virtual_work(Ledger<T>& ledger, const Equal& equations, const Rational& Q) {
  ledger.route("constraint equations");
  const auto power = [=] { return equations().model.power("Q", equations().velocities); };
  ledger.put(v_Q_over_v_P(), [&] { return geometry::quotient(magnitude_of<T>(power()), number<T>(Q)); });
  ledger.put(P_virtual_work(), [&] { return -power(); });
}

// ---------------------------------------------------------------------------------------------------------------------
// The wedge.

template <class T>
WedgeDirections<T> ideal_wedge(const Wedge& of) {
  return {{geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta)}, {T(0), T(1)}, {T(1), T(0)}, {T(-1), T(0)}};
}

template <class T>
void by_velocity_diagram(Ledger<T>& ledger, const Wedge& of) {
  ledger.route("velocity diagram");
  // v_3 = v_2 + v_32: v_2 = 1 along x, v_32 along the face, v_3 along the rod.
  const Vector<T> v_2{T(1), T(0)}, along_face{geometry::cosine<T>(of.theta), -geometry::sine<T>(of.theta)};
  const auto v_3 = [=] { return geometry::close_polygon(v_2, along_face, Vector<T>{T(0), T(1)}).of_second; };
  ledger.put(v_Q_over_v_P(), [&] { return v_3(); });
  ledger.put(P_virtual_work(), [&] { return number<T>(of.Q) * v_3(); });
  ledger.draws_vector("v_2", v_2);
  draw_vector(ledger, "v_3", [&] { return Vector<T>{T(0), v_3()}; });
  draw_vector(ledger, "v_32", [&] { return Vector<T>{T(-1), v_3()}; });
}

template <class T>
void write_wedge(Ledger<T>& ledger, const Wedge& of) {
  const auto describe = [=](auto& model) { epure::describe(model, of, ideal_wedge<T>(of), Collar::one_force); };
  const auto bodies = solved_bodies<T>(3, describe);
  const auto equations = solved_equations<T>(3, "P", describe);
  ledger.begin_case("wedge_collar.", {", wedge and collar", ", cuneo e collare"});
  put_P(ledger, bodies, equations, {T(1), T(0)});
  put_forces(ledger, bodies, equations, {force_between(1, 2), force_between(1, 3), force_between(2, 3)});
  ledger.route("force polygon");
  draw_vector(ledger, "Q", [&] { return bodies().force("Q"); });
  ledger.draws_point("H_2", [&] { return geometry::finite(bodies().H(2)); });
  put_virtual_work(ledger, equations, of.Q);
  by_velocity_diagram(ledger, of);
}

template <class T>
void write_two_point_wedge(Ledger<T>& ledger, const Wedge& of) {
  const auto describe = [=](auto& model) { epure::describe(model, of, ideal_wedge<T>(of), Collar::two_forces); };
  const auto bodies = solved_bodies<T>(3, describe);
  const auto equations = solved_equations<T>(3, "P", describe);
  ledger.begin_case("wedge_collar_two_point.", {", collar with two forces", ", collare con due forze"});
  put_P(ledger, bodies, equations, {T(1), T(0)});
  put_forces(ledger, bodies, equations, {force_between(1, 2), R_13_upper(), R_13_lower(), force_between(2, 3)});
  ledger.route("force polygon");
  ledger.put(R_13_resultant_x(), [&] { return bodies().three_lines(3).resultant.direction().x; });
  draw_vector(ledger, "R_13", [&] { return bodies().three_lines(3).resultant.direction(); });
  const auto funicular = [=] { return bodies().three_lines(3).shared.value(); };
  draw_vector(ledger, "pole", [&] { return funicular().pole; });
  draw_vector(ledger, "between", [&] { return funicular().between; });
  ledger.draws_point("on_upper", [&] { return funicular().on_first; });
  ledger.draws_point("on_resultant", [&] { return funicular().on_F; });
  ledger.draws_point("on_lower", [&] { return funicular().on_second; });
  draw_vector(ledger, "Q", [&] { return bodies().force("Q"); });
  ledger.route("equilibrium equations");
  ledger.put(R_13_resultant_x(),
             [=] { return equations().force("R_13_upper").x + equations().force("R_13_lower").x; });
}

// ---------------------------------------------------------------------------------------------------------------------
// The double slider.

template <class T>
DoubleSliderAt<T> at_right_angles(const XY<T>& A, const XY<T>& B) {
  return {A, B, {T(1), T(0)}, {T(0), T(1)}};
}

template <class T>
void write_double_slider(Ledger<T>& ledger, const DoubleSlider& of) {
  ledger.begin_case("double_slider.", {", double slider", ", doppio pattino"});
  const T l = number<T>(of.l), c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta);
  // The link laid off from B along its direction; B where A stands over the origin.
  const Vector<T> link = l * Vector<T>{c, s};
  const Point<T> B{-link.x, T(0)}, A = B + link, by_theta_A{T(0), l * s}, by_theta_B{-(l * c), T(0)};
  ledger.route("construction");
  ledger.put(point("A").y(), A.y);
  ledger.put(point("B").x(), B.x);
  ledger.draws_point("A", Point<T>{T(0), A.y});
  ledger.draws_point("B", B);
  // From the other acute angle, π/2 - θ, at A.
  const Angle at_A = Angle{Rational(1, 4)} - of.theta;
  ledger.route("analytic");
  ledger.put(point("A").y(), [&] { return l * geometry::cosine<T>(at_A); });
  ledger.put(point("B").x(), [&] { return -(l * geometry::sine<T>(at_A)); });

  const auto bodies = solved_bodies<T>(4, [=](auto& model) {
    epure::describe(model, of, at_right_angles<T>({T(0), A.y}, xy(B)));
  });
  const auto equations = solved_equations<T>(
      4, "P", [=](auto& model) { epure::describe(model, of, at_right_angles<T>(xy(by_theta_A), xy(by_theta_B))); });
  put_P(ledger, bodies, equations, {T(1), T(0)});
  put_forces(ledger, bodies, equations,
             {force_between(1, 2), force_between(1, 4), force_between(3, 2), force_between(4, 3)});
  ledger.route("force polygon");
  draw_vector(ledger, "Q", [&] { return bodies().force("Q"); });
  put_virtual_work(ledger, equations, of.Q);
  put_point(
      ledger, pole("P31"),
      [=]() -> ProjectivePoint<T> {  // where v = v_0 + ω × r is zero
        const auto& link_3 = equations().velocities.at(3);
        return {-link_3.y, link_3.x, link_3.m};
      },
      resting_coupler);

  // The normals to the guides meet in P31, and velocities are as distances from it.
  ledger.route("poles");
  const ProjectivePoint<T> P31 = meet(line(A, Vector<T>{T(1), T(0)}), line(B, Vector<T>{T(0), T(1)}));
  const auto ratio = [=] {
    const Point<T> pole = geometry::finite(P31);
    return geometry::quotient(geometry::distance(pole, A), geometry::distance(pole, B));
  };
  put_point(
      ledger, pole("P31"), [&] { return P31; }, resting_coupler);
  ledger.put(v_Q_over_v_P(), [&] { return ratio(); });
  ledger.put(P_virtual_work(), [&] { return number<T>(of.Q) * ratio(); });
  // v_A = v_B + v_AB: v_B = 1 along x, v_AB square to the link, v_A upright.
  ledger.route("velocity diagram");
  const auto v_A = [=] {
    return geometry::close_polygon(Vector<T>{T(1), T(0)}, geometry::quarter_turn(link), Vector<T>{T(0), T(1)})
        .of_second;
  };
  ledger.put(v_Q_over_v_P(), [&] { return v_A(); });
  ledger.put(P_virtual_work(), [&] { return number<T>(of.Q) * v_A(); });
  ledger.draws_vector("v_B", {T(1), T(0)});
  draw_vector(ledger, "v_A", [&] { return Vector<T>{T(0), v_A()}; });
  draw_vector(ledger, "v_AB", [&] { return Vector<T>{T(-1), v_A()}; });
}

// ---------------------------------------------------------------------------------------------------------------------
// The sliding levers.

// Ratios of angular velocities by poles: of the levers by P23, of the coupler of the equivalent four-bar by P41.
template <class T>
void by_poles(Ledger<T>& ledger, const Levers& of, const LeverPoints<T>& at) {
  using geometry::projective;
  ledger.route("poles");
  const ProjectivePoint<T> P23 = meet(line(at.C, at.n), line(at.A0, at.B0)),
                           P41 = meet(line(at.A0, at.A), line(at.B0, at.B));
  ledger.put(contact_pole().x(), [&] { return Ledger<T>::ratio(P23.x, P23.w, normal_along_hinges); });
  put_point(
      ledger, pole("P41"), [&] { return P41; }, parallel_cranks);
  ledger.distance(distance("P41", "A"), P41, at.A, parallel_cranks);
  ledger.distance(distance("P41", "B"), P41, at.B, parallel_cranks);
  // ω_j/ω_2 from the pole that both share.
  const auto over_2 = [=](const ProjectivePoint<T>& P_1j, const ProjectivePoint<T>& P_2j) {
    const auto [second, jth] = geometry::angular_velocities(projective(at.A0), P_1j, P_2j);
    return geometry::quotient(jth, second);
  };
  const auto omega_3 = [=] { return over_2(projective(at.B0), P23); };
  ledger.put(ratio_of_speeds(3, 2), [&] { return omega_3(); });
  ledger.put(ratio_of_speeds(4, 2), [&] { return over_2(P41, projective(at.A)); });
  // Displacements along P and Q are as the arms times the angular velocities of their levers.
  const XY<T> q = unit<T>(of.direction_Q);
  const Point<T> hinge = of.loaded == 2 ? at.A0 : at.B0, on_Q{number<T>(of.x_Q), T(0)};
  const geometry::Line<T> line_of_Q = line(on_Q, Vector<T>{q.x, q.y});
  ledger.put(arm_of_Q(), [&] { return geometry::distance(hinge, geometry::foot(hinge, line_of_Q)); });
  const auto ratio = [=] {
    const T arms = geometry::quotient(moment_about(projective(hinge), line_of_Q), number<T>(of.arm_P));
    return of.loaded == 3 ? omega_3() * arms : geometry::quotient(arms, omega_3());
  };
  ledger.put(v_Q_over_v_P(), [&] { return magnitude_of<T>(ratio()); });
  ledger.put(P_virtual_work(), [&] { return -(number<T>(of.Q) * ratio()); });
}

// v_B = v_A + v_BA of the equivalent four-bar: ω2 = 1, so v_A is A0A turned by a right angle.
template <class T>
void by_velocity_diagram(Ledger<T>& ledger, const Levers& of, const LeverPoints<T>& at) {
  ledger.route("velocity diagram");
  using geometry::quarter_turn;
  const Vector<T> v_A = quarter_turn(at.A - at.A0), across_coupler = quarter_turn(at.B - at.A),
                  across_B0B = quarter_turn(at.B - at.B0);
  const auto closed = [=] { return geometry::close_polygon(v_A, across_coupler, across_B0B); };
  ledger.put(ratio_of_speeds(4, 2), [&] { return closed().of_first; });
  ledger.put(ratio_of_speeds(3, 2), [&] { return closed().of_second; });
  // The velocities of the points where P and Q act, each on its own line of action.
  const auto ratio = [=] {
    const T omega_3 = closed().of_second;
    const XY<T> q = unit<T>(of.direction_Q), p = unit<T>(of.direction_P), foot = foot_of_P<T>(of);
    const auto along = [&](int lever, const Point<T>& X, const XY<T>& direction) {
      const Vector<T> v = quarter_turn(X - (lever == 2 ? at.A0 : at.B0));
      const T component = geometry::dot(v, Vector<T>{direction.x, direction.y});
      return lever == 2 ? component : omega_3 * component;
    };
    return geometry::quotient(along(of.loaded, {number<T>(of.x_Q), T(0)}, q),
                              along(of.driven(), {foot.x, foot.y}, p));
  };
  ledger.put(v_Q_over_v_P(), [&] { return magnitude_of<T>(ratio()); });
  ledger.put(P_virtual_work(), [&] { return -(number<T>(of.Q) * ratio()); });
  ledger.draws_vector("v_A", v_A);
  draw_vector(ledger, "v_BA", [&] { return closed().of_first * across_coupler; });
  draw_vector(ledger, "v_B", [&] { return closed().of_second * across_B0B; });
}

// The levers' geometry in complex numbers; what moves, from the equations of the joints of the equivalent four-bar.
template <class T, class Equal>
void by_analysis(Ledger<T>& ledger, const Levers& of, const Equal& equations) {
  ledger.route("analytic");
  const Complex<T> C{number<T>(of.x_C), number<T>(of.y_C)}, B0{number<T>(of.b), T(0)}, A0{T(0), T(0)};
  const Angle back = of.nu + Angle{Rational(1, 2)};
  const auto centre = [=](int lever) {
    const Rational offset = offset_of_centre(of, lever);
    return C + number<T>(CGAL::abs(offset)) * complex(unit<T>(offset > 0 ? of.nu : back));
  };
  const Complex<T> A = centre(2), B = centre(3);
  ledger.put(point("A"), Point<T>{A.re, A.im});
  ledger.put(point("B"), Point<T>{B.re, B.im});
  // A right triangle on the normal: the hinge's arm, and how far the centre is from the arm's foot.
  const auto arm = [=](const Complex<T>& hinge) { return analytic::cross(complex(unit<T>(of.nu)), hinge - C); };
  const auto crank = [=](const Complex<T>& hinge, int lever) {
    const T along = analytic::dot(C - hinge, complex(unit<T>(of.nu))) + number<T>(offset_of_centre(of, lever));
    return size(Vector<T>{arm(hinge), along});
  };
  ledger.put(arm_of_normal("A0"), [&] { return magnitude_of<T>(arm(A0)); });
  ledger.put(arm_of_normal("B0"), [&] { return magnitude_of<T>(arm(B0)); });
  ledger.put(distance("A0", "A"), [&] { return crank(A0, 2); });
  ledger.put(distance("B0", "B"), [&] { return crank(B0, 3); });
  const XY<T> q = unit<T>(of.direction_Q);
  ledger.put(arm_of_Q(), [&] { return magnitude_of<T>(q.y * number<T>(of.x_Q - of.hinge(of.loaded))); });

  ledger.route("constraint equations");
  const auto omega_3 = [=] { return geometry::quotient(equations().omega(3), equations().omega(2)); };
  ledger.put(ratio_of_speeds(3, 2), [&] { return omega_3(); });
  ledger.put(contact_pole().x(),
             [=] { return Ledger<T>::ratio(number<T>(of.b) * omega_3(), omega_3() - T(1), normal_along_hinges); });
  const auto four_bar = once([=] {
    analytic::Equilibrium<T> model(4);
    model.hinge("A0", 1, 2, A0.re, A0.im);
    model.hinge("A", 2, 4, A.re, A.im);
    model.hinge("B", 4, 3, B.re, B.im);
    model.hinge("B0", 1, 3, B0.re, B0.im);
    model.couple("drive", 2);
    return model.velocities("drive");
  });
  ledger.put(ratio_of_speeds(4, 2), [&] { return four_bar().at(4).m; });
  put_point(
      ledger, pole("P41"),
      [=]() -> ProjectivePoint<T> {
        return {-four_bar().at(4).y, four_bar().at(4).x, four_bar().at(4).m};
      },
      parallel_cranks);
  const auto from_pole = [=](const Complex<T>& X) {
    const Complex<T> v = analytic::velocity_at<T>(four_bar().at(4), X);
    return Ledger<T>::ratio(size(Vector<T>{v.re, v.im}), magnitude_of<T>(four_bar().at(4).m), parallel_cranks);
  };
  ledger.put(distance("P41", "A"), [&] { return from_pole(A); });
  ledger.put(distance("P41", "B"), [&] { return from_pole(B); });
}

template <class T>
void write_levers(Ledger<T>& ledger, const Levers& of) {
  const LeverPoints<T> at = points_of<T>(of);
  const auto describe = [=](auto& model) { epure::describe(model, of, LeversAt<T>{xy(at.C), xy(at.n), of.nu}); };
  const auto bodies = solved_bodies<T>(3, describe);
  const auto equations = solved_equations<T>(3, "P", describe);
  put_P(ledger, bodies, equations, unit<T>(of.direction_P));
  put_forces(ledger, bodies, equations,
             {force_between(1, 2), force_between(1, 3), force_between(of.driven(), of.loaded)});
  ledger.route("force polygon");
  draw_vector(ledger, "Q", [&] { return bodies().force("Q"); });
  for (const int lever : {2, 3}) {
    const PointQuantity H = meeting("H_" + std::to_string(lever), lever);
    ledger.route("force polygon");
    put_point(
        ledger, H, [&] { return bodies().H(lever); }, parallel_forces);
    ledger.route("equilibrium equations");
    put_point(
        ledger, H,
        [=] {
          const bool is_loaded = lever == of.loaded;
          const Angle& direction = is_loaded ? of.direction_Q : of.direction_P;
          const XY<T> X = is_loaded ? XY<T>{number<T>(of.x_Q), T(0)} : foot_of_P<T>(of);
          if (are_parallel(of.nu, direction)) throw geometry::Impossible(parallel_forces);
          return on_reaction<T>({number<T>(of.hinge(lever)), T(0)}, equations().force("R_1" + std::to_string(lever)),
                                complex(X), complex(unit<T>(direction)));
        },
        parallel_forces);
  }
  ledger.route("construction");
  ledger.draws_point("A0", at.A0);
  ledger.draws_point("B0", at.B0);
  ledger.draws_point("C", at.C);
  ledger.put(point("A"), at.A);
  ledger.put(point("B"), at.B);
  ledger.put(distance("A0", "A"), [&] { return geometry::distance(at.A0, at.A); });
  ledger.put(distance("B0", "B"), [&] { return geometry::distance(at.B0, at.B); });
  const auto foot_from = [=](const Point<T>& hinge) { return geometry::foot(hinge, line(at.C, at.n)); };
  ledger.put(arm_of_normal("A0"), [&] { return geometry::distance(at.A0, foot_from(at.A0)); });
  ledger.put(arm_of_normal("B0"), [&] { return geometry::distance(at.B0, foot_from(at.B0)); });
  by_poles(ledger, of, at);
  by_velocity_diagram(ledger, of, at);
  put_virtual_work(ledger, equations, of.Q);
  by_analysis(ledger, of, equations);
}

// ---------------------------------------------------------------------------------------------------------------------
// Fairbairn's mechanism.

template <class T>
FairbairnAt<T> ideal_fairbairn(const Fairbairn& of, const XY<T>& A, const XY<T>& B, const XY<T>& D) {
  return {A, B, D, {-geometry::cosine<T>(of.theta), geometry::sine<T>(of.theta)}, {T(1), T(0)}, {T(0), T(1)}};
}

template <class T>
void by_poles(Ledger<T>& ledger, const Fairbairn& of, const FairbairnPoints<T>& at) {
  using geometry::projective;
  ledger.route("poles");
  const ProjectivePoint<T> P24 = meet(line(at.C, at.A), line(at.B, geometry::quarter_turn(at.lever)));
  const auto P24_from = [=](const Point<T>& X) { return geometry::distance(geometry::finite(P24), X); };
  ledger.put(distance("P24", "C"), [&] { return P24_from(at.C); });
  ledger.put(distance("P24", "A"), [&] { return P24_from(at.A); });
  ledger.draws_point("P24", [&] { return geometry::finite(P24); });
  const auto omega_4 = [=] {
    const auto [second, fourth] = geometry::angular_velocities(projective(at.A), projective(at.C), P24);
    return geometry::quotient(fourth, second);
  };
  // D turns about C; of its velocity the ram has the part along x.
  const auto v_D6 = [=] { return omega_4() * number<T>(of.CD) * geometry::cosine<T>(of.theta); };
  ledger.put(ratio_of_speeds(4, 2), [&] { return omega_4(); });
  ledger.put(v_D6_over_omega_2(), [&] { return magnitude_of<T>(v_D6()); });
  ledger.put(M_virtual_work(), [&] { return number<T>(of.F) * v_D6(); });
}

// v_B4 = v_B2 + v_B42 with ω2 = 1; D as B on its lever; v_D6 = v_D5 + v_D65.
template <class T>
void by_velocity_diagram(Ledger<T>& ledger, const Fairbairn& of, const FairbairnPoints<T>& at) {
  ledger.route("velocity diagram");
  using geometry::quarter_turn;
  const Vector<T> v_B2 = quarter_turn(at.B - at.A), across = quarter_turn(at.lever);
  const auto closed = [=] { return geometry::close_polygon(v_B2, at.lever, across); };
  const auto omega_4 = [=] { return geometry::quotient(closed().of_second, geometry::dot(at.B - at.C, at.lever)); };
  const auto v_D5 = [=] { return omega_4() * quarter_turn(at.D - at.C); };
  const auto v_D6 = [=] {
    return geometry::close_polygon(v_D5(), Vector<T>{T(0), T(1)}, Vector<T>{T(1), T(0)}).of_second;
  };
  ledger.put(ratio_of_speeds(4, 2), [&] { return omega_4(); });
  ledger.put(v_D6_over_omega_2(), [&] { return magnitude_of<T>(v_D6()); });
  ledger.put(M_virtual_work(), [&] { return -(number<T>(of.F) * v_D6()); });
  ledger.draws_vector("v_B2", v_B2);
  draw_vector(ledger, "v_B42", [&] { return closed().of_first * at.lever; });
  draw_vector(ledger, "v_B4", [&] { return closed().of_second * across; });
  draw_vector(ledger, "v_D5", v_D5);
  draw_vector(ledger, "v_D65", [&] { return Vector<T>{T(0), -v_D5().y}; });
  draw_vector(ledger, "v_D6", [&] { return Vector<T>{v_D6(), T(0)}; });
}

template <class T, class Equal>
void by_analysis(Ledger<T>& ledger, const Fairbairn& of, const Equal& equations) {
  ledger.route("analytic");
  const auto crank = [=] { return crank_by_sines<T>(of); };
  const auto B = [=] { return crank() + Complex<T>{T(0), number<T>(of.AC)}; };
  const auto CB = [=] { return size(Vector<T>{B().re, B().im}); };
  const auto projected = [=](const Complex<T>& X) {
    return analytic::dot(X, {geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta)});
  };
  ledger.put(distance("C", "B"), [&] { return CB(); });
  ledger.put(point("B").x(), [&] { return B().re; });
  ledger.put(point("B").y(), [&] { return B().im; });
  const Angle of_lever = Angle{Rational(1, 4)} - of.theta;
  ledger.put(point("D").x(), [&] { return number<T>(of.CD) * geometry::cosine<T>(of_lever); });
  ledger.put(point("D").y(), [&] { return number<T>(of.CD) * geometry::sine<T>(of_lever); });
  ledger.put(crank_angle(), [&] {
    const Complex<T> z = crank();
    if constexpr (signs_only<T>) {
      return angles::zero_along_x(Vector<T>{z.re, z.im});
    } else {
      return part_of_turn_in_degrees(T(2) * geometry::arc_tangent(z.im, T(z.re + analytic::modulus(z))));
    }
  });
  // CP24 cos θ = CB, and A lies on CP24.
  const auto P24C = [=] { return geometry::quotient(projected(B()), geometry::cosine<T>(of.theta)); };
  ledger.put(distance("P24", "C"), [&] { return P24C(); });
  ledger.put(distance("P24", "A"), [&] { return magnitude_of<T>(P24C() - number<T>(of.AC)); });
  ledger.put(arm_of_F_23(), [&] { return magnitude_of<T>(projected(crank())); });

  ledger.route("constraint equations");
  const auto power = [=] { return equations().model.power("F", equations().velocities); };
  ledger.put(ratio_of_speeds(4, 2), [&] { return equations().omega(4); });
  ledger.put(v_D6_over_omega_2(), [&] { return magnitude_of<T>(equations().velocities.at(6).x); });
  ledger.put(M_virtual_work(), [&] { return -power(); });
}

template <class T>
void write_fairbairn(Ledger<T>& ledger, const Fairbairn& of) {
  const auto at = once([=] { return points_of<T>(of); });
  const auto bodies = solved_bodies<T>(6, [=](auto& model) {
    epure::describe(model, of, ideal_fairbairn<T>(of, xy(at().A), xy(at().B), xy(at().D)));
  });
  const auto equations = solved_equations<T>(6, "M", [=](auto& model) {
    const T AC = number<T>(of.AC), CD = number<T>(of.CD);
    const Complex<T> B = crank_by_sines<T>(of) + Complex<T>{T(0), AC};
    epure::describe(model, of,
                    ideal_fairbairn<T>(of, {T(0), AC}, {B.re, B.im},
                                       {CD * geometry::sine<T>(of.theta), CD * geometry::cosine<T>(of.theta)}));
  });
  ledger.route("construction");
  ledger.draws_point("A", [&] { return at().A; });
  ledger.draws_point("C", [&] { return at().C; });
  for (const auto& [name, which] : {std::pair{"B", &FairbairnPoints<T>::B}, std::pair{"D", &FairbairnPoints<T>::D}}) {
    ledger.put(point(name).x(), [&, w = which] { return (at().*w).x; });
    ledger.put(point(name).y(), [&, w = which] { return (at().*w).y; });
  }
  ledger.put(distance("C", "B"), [&] { return geometry::distance(at().C, at().B); });
  ledger.put(crank_angle(), [&] { return in_degrees(angle_of(at().B - at().A)); });
  ledger.put(arm_of_F_23(), [&] {
    return geometry::distance(at().A, geometry::foot(at().A, line(at().B, geometry::quarter_turn(at().lever))));
  });
  ledger.route("force polygon");
  ledger.put(M(), [&] { return bodies().moment("M"); });
  ledger.put(F_23(), [&] { return size(bodies().force("R_23")); });
  draw_vector(ledger, "F", [&] { return bodies().force("F"); });
  ledger.route("equilibrium equations");
  ledger.put(M(), [&] { return equations().forces.at("M").m; });
  ledger.put(F_23(), [&] { return size(equations().force("R_23")); });
  put_forces(ledger, bodies, equations,
             {force_between(3, 4), force_between(1, 4), force_between(1, 2), force_between(5, 6)});
  const PointQuantity H = meeting("H", 4);
  ledger.route("force polygon");
  put_point(
      ledger, H, [&] { return bodies().H(4); }, parallel_forces);
  ledger.route("equilibrium equations");
  put_point(
      ledger, H,
      [=] {
        return on_reaction<T>({T(0), T(0)}, equations().force("R_14"),
                              {T(0), number<T>(of.CD) * geometry::cosine<T>(of.theta)}, {T(1), T(0)});
      },
      parallel_forces);
  by_poles(ledger, of, at());
  by_velocity_diagram(ledger, of, at());
  by_analysis(ledger, of, equations);
}

struct Routes {
  LoadedMechanisms of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("force polygon");
    write_wedge(ledger, of.wedge);
    write_two_point_wedge(ledger, of.wedge);
    write_double_slider(ledger, of.double_slider);
    ledger.begin_case("sliding_levers.", {", sliding levers", ", leve striscianti"});
    write_levers(ledger, of.levers);
    ledger.begin_case("sliding_levers_Q_on_2.", {", sliding levers with Q on 2", ", leve striscianti con Q sulla 2"});
    write_levers(ledger, of.levers_Q_on_2);
    ledger.begin_case("fairbairn.", {", Fairbairn's mechanism", ", guida di Fairbairn"});
    write_fairbairn(ledger, of.fairbairn);
    ledger.begin_case("fairbairn_short_lever.",
                      {", Fairbairn's mechanism, shorter lever", ", guida di Fairbairn, leva più corta"});
    write_fairbairn(ledger, of.fairbairn_short_lever);
    return ledger;
  }
};

}  // namespace epure::ideal_statics
