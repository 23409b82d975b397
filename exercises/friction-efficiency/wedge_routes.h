// The wedge.
#pragma once

#include "exercises/friction-efficiency/with_friction.h"

namespace epure::friction_efficiency {

// When the wedge moves by 1 along x.
template <class T>
Vector<T> velocity_of_rod(const Wedge& of) {
  const Vector<T> v_2{T(1), T(0)}, up{T(0), T(1)},
      along_face{geometry::cosine<T>(of.theta), -geometry::sine<T>(of.theta)};
  return geometry::close_polygon(v_2, along_face, up).of_second * up;
}
template <class T>
void draw_sliding_of_wedge(Ledger<T>& ledger, const Wedge& of) {
  draw_vector(ledger, "v_21", [] { return Vector<T>{T(1), T(0)}; });
  draw_vector(ledger, "v_31", [&] { return velocity_of_rod<T>(of); });
  draw_vector(ledger, "v_32", [&] { return velocity_of_rod<T>(of) - Vector<T>{T(1), T(0)}; });
}

template <class T>
auto wedge_motions(const Problem& problem, Collar collar) {
  const Wedge of = problem.of.wedge;
  const auto constructed = [=](auto& model, const Turned& turned) {
    const T c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta);
    const Vector<T> v_2{T(1), T(0)}, up{T(0), T(1)}, left{T(-1), T(0)}, n{s, c}, v_3 = velocity_of_rod<T>(of);
    model.directed("Q", quarter());
    model.directed("R_23", turned.direction<T>(quarter() - of.theta, n, v_3 - v_2));
    model.directed("R_12", turned.direction<T>(quarter(), up, v_2));
    const bool is_one = collar == Collar::one_force;
    epure::describe(
        model, of,
        WedgeDirections<T>{turned.components<T>(n, v_3 - v_2), turned.components<T>(up, v_2),
                           turned.components<T>(is_one ? left : -left, v_3), turned.components<T>(left, v_3)},
        collar);
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const Complex<T> O{T(0), T(0)}, v_2 = velocity_of(ideal, 2, O), v_3 = velocity_of(ideal, 3, O);
    const bool is_one = collar == Collar::one_force;
    epure::describe(model, of,
                    WedgeDirections<T>{unit<T>(turned.angle<T>(quarter() - of.theta, v_3 - v_2)),
                                       unit<T>(turned.angle<T>(quarter(), v_2)),
                                       unit<T>(turned.angle<T>(is_one ? half() : Angle{}, v_3)),
                                       unit<T>(turned.angle<T>(half(), v_3))},
                    collar);
  };
  return in_all_motions<T>(3, "P", problem.phi, constructed, analysed);
}

template <class T>
void write_wedge(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("wedge_collar.", {", wedge and collar", ", cuneo e collare"});
  write_motions<T>(ledger, names_of_P(), wedge_motions<T>(problem, Collar::one_force), {T(1), T(0)},
                   {force_between(1, 2), force_between(1, 3), force_between(2, 3)},
                   without_effort(problem.wedge_at_limit));
  draw_sliding_of_wedge(ledger, problem.of.wedge);
  put_half(ledger, self_locking_angle(), problem.of.wedge.theta);
  put_half(ledger, jamming_angle(), quarter() - problem.of.wedge.theta);
}

template <class T>
void write_two_point_wedge(Ledger<T>& ledger, const Problem& problem) {
  const Wedge of = problem.of.wedge;
  const Angle phi = problem.phi;
  const VectorQuantity upper =
                           force_between(1, 3, "upper", "^{{u}}", {", at the upper end", ", all'estremo superiore"}),
                       lower =
                           force_between(1, 3, "lower", "^{{l}}", {", at the lower end", ", all'estremo inferiore"});
  ledger.begin_case("wedge_collar_two_point.", {", collar with two forces", ", collare con due forze"});
  const Motions<T> all = wedge_motions<T>(problem, Collar::two_forces);
  write_motions<T>(ledger, names_of_P(), all, {T(1), T(0)}, {force_between(1, 2), upper, lower, force_between(2, 3)},
                   without_effort(problem.wedge_at_limit));
  draw_sliding_of_wedge(ledger, of);
  put_half(ledger, self_locking_angle(), of.theta);
  for (const Motion motion : with_friction) {
    const PointQuantity K = in(
        motion,
        PointQuantity{
            "K", {" of K, where the collar's forces meet", " di K, dove si incontrano le forze del collare"}, "K"});
    const Quantity culmann =
        in(motion, Quantity{"culmann_angle",
                            "$κ$",
                            "deg",
                            {"angle of Culmann's line OK from +x", "angolo della retta di Culmann OK da +x"}});
    const Quantity culmann_deg{"culmann_angle" + suffix(motion) + "_deg", culmann.symbol, culmann.unit,
                               culmann.meaning};
    ledger.route("force polygon");
    const auto found = [=]() -> ProjectivePoint<T> {
      if (is_zero(phi)) throw geometry::Impossible(parallel_collar);
      return all.bodies.at(motion)().three_lines(3).K;
    };
    put_point(ledger, K, found, parallel_collar);
    const auto slope = [](const Vector<T>& v) {  // of a line, in (-90°, 90°]
      const geometry::Sign right = geometry::sign(v.x);
      if (right == geometry::Sign::undecided)
        throw geometry::Undecided("whether Culmann's line is upright", "se la retta di Culmann sia verticale");
      return right == geometry::Sign::negative ? -v : v;
    };
    ledger.put(culmann_deg, [&] {
      const ProjectivePoint<T> P = found();
      const Point<T> at = geometry::finite(P);
      return in_degrees(angle_of(slope({at.x, at.y})));
    });
    // K from the collar's ends: a = 2 x tan φ along it. The sum of the two forces runs from O to K.
    ledger.route("equilibrium equations");
    const T sense = motion == Motion::direct ? T(1) : T(-1);
    const auto of_K = [=] {
      if (is_zero(phi)) throw geometry::Impossible(parallel_collar);
      const T mu = sense * geometry::quotient(geometry::sine<T>(phi), geometry::cosine<T>(phi));
      return Vector<T>{geometry::quotient(number<T>((of.y_upper - of.y_lower) / 2), mu),
                       number<T>((of.y_upper + of.y_lower) / 2) - mu * number<T>(of.w / 2)};
    };
    ledger.put(K.x(), [&] { return of_K().x; });
    ledger.put(K.y(), [&] { return of_K().y; });
    ledger.put(culmann_deg, [&] {
      // In line with Q the wedge's force leaves nothing for the collar, and no sum has a direction.
      const bool is_free = motion == Motion::retrograde && of.theta == phi;
      const Vector<T> OK = of_K();
      const Equations<T>& equations = all.equations.at(motion)();
      const Vector<T> R = slope(is_free ? OK : equations.force("R_13_upper") + equations.force("R_13_lower"));
      return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{R.x, R.y}));
    });
  }
  ledger.route("force polygon");
  ledger.put(jamming_angle(), [&]() -> T {
    if constexpr (signs_only<T>)
      return T(1);
    else
      return geometry::on_balls<T>(
          [=] { return in_degrees(geometry::arc_tangent(jamming_coefficient(of), geometry::Deep(1))); });
  });
  // The cubic by its trigonometric roots.
  ledger.route("analytic");
  ledger.put(jamming_angle(), [&]() -> T {
    if constexpr (signs_only<T>) {
      return T(1);
    } else {
      const T t = geometry::quotient(geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta));
      const T w = number<T>(of.w), a = number<T>(of.y_upper - of.y_lower),
              twice_m = number<T>(of.y_upper + of.y_lower);
      const T b2 = geometry::quotient(w * t - twice_m, w), b1 = geometry::quotient(-((a + twice_m) * t), w),
              b0 = geometry::quotient(a, w);
      const T third = number<T>(Rational(1, 3));
      const T p = b1 - third * geometry::square(b2),
              q = number<T>(Rational(2, 27)) * b2 * geometry::square(b2) - third * b1 * b2 + b0;
      const geometry::Sign bends = geometry::sign(p);
      if (bends == geometry::Sign::positive || bends == geometry::Sign::zero) throw geometry::Impossible(never_jams);
      const T spread = geometry::root(-(third * p)), cube = spread * geometry::square(spread);
      const T inside = geometry::square(T(2) * cube) - geometry::square(q);
      const geometry::Sign has_three = geometry::sign(inside);
      if (has_three == geometry::Sign::negative) throw geometry::Impossible(never_jams);  // the only root is negative
      if (has_three != geometry::Sign::positive && !jams_at_one_coefficient(of))
        throw geometry::Undecided("how many friction angles jam the rod",
                                  "quanti angoli d'attrito facciano impuntare l'asta");
      const T width = has_three == geometry::Sign::positive ? geometry::root(inside) : T(0);
      const T alpha = third * geometry::arc_tangent(width, T(-q));
      // The middle one of the three: the least is negative.
      const T mu = T(2) * spread * geometry::cosine_of_angle(alpha - number<T>(Rational(2, 3)) * geometry::pi<T>()) -
                   third * b2;
      if (geometry::sign(mu) == geometry::Sign::negative) throw geometry::Impossible(never_jams);  // all three are
      return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{T(1), mu}));
    }
  });
}

}  // namespace epure::friction_efficiency
