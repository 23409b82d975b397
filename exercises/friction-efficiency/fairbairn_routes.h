// Fairbairn's mechanism: friction of block 3 on the lever, of block 5 in the slot, of the ram in its guide.
#pragma once

#include "exercises/friction-efficiency/with_friction.h"

namespace epure::friction_efficiency {

// The guide presses on the ram against the friction of block 5.
template <class T>
T pressing(const T& upwards) {
  const geometry::Sign sign = geometry::sign(upwards);
  if (sign == geometry::Sign::undecided)
    throw geometry::Undecided("on which side the guide presses on the ram",
                              "da che lato la guida prema sulla slitta");
  return sign == geometry::Sign::positive ? T(-1) : T(1);
}

// With the crank across it the lever rests, and nothing but friction loads the crank.
inline std::set<Motion> at_dead_centre(const Fairbairn& of, const Angle& phi) {
  if (!of.touches) return {};
  return is_zero(phi) ? std::set<Motion>(motions.begin(), motions.end()) : std::set{Motion::ideal};
}

// How the blocks slide when the crank turns by 1: 5 on the ram, the lever on block 3, the ram in its guide.
template <class T>
struct SlidingOfFairbairn {
  Vector<T> v_56, v_43, v_61;
};
template <class T>
SlidingOfFairbairn<T> sliding_of(const Fairbairn& of, const FairbairnPoints<T>& at) {
  using geometry::quarter_turn;
  const auto [along, turning] = geometry::close_polygon(quarter_turn(at.B - at.A), at.lever, quarter_turn(at.lever));
  const T omega_4 = of.touches ? T(0) : geometry::quotient(turning, geometry::dot(at.B - at.C, at.lever));
  const Vector<T> v_D5 = omega_4 * quarter_turn(at.D - at.C), v_D6{v_D5.x, T(0)};
  return {v_D5 - v_D6, along * at.lever, v_D6};
}

template <class T>
void write_case(Ledger<T>& ledger, const Problem& problem, const Fairbairn& of, const std::string& name) {
  const Angle phi = problem.phi;
  const auto at = once([=] { return points_of<T>(of); });
  const auto require_sliding = [=](const Turned& turned) {
    if (turned.motion != Motion::ideal && !is_zero(turned.phi) && (of.touches || is_zero(of.theta)))
      throw geometry::Impossible(why_no_sliding(of, name));
  };
  const auto constructed = [=](auto& model, const Turned& turned) {
    require_sliding(turned);
    const FairbairnPoints<T>& P = at();
    const Vector<T> across = geometry::quarter_turn(P.lever), x{T(1), T(0)}, y{T(0), T(1)};
    const auto [v_56, v_43, v_61] = sliding_of(of, P);
    const XY<T> R_56 = turned.components<T>(-x, -v_56);
    model.directed("F", Angle{});
    model.directed("R_56", turned.direction<T>(half(), -x, -v_56));
    model.directed("R_34", turned.direction<T>(half() - of.theta, across, v_43));
    epure::describe(model, of,
                    FairbairnAt<T>{xy(P.A), xy(P.B), xy(P.D), turned.components<T>(across, v_43), R_56,
                                   turned.components<T>(pressing<T>(R_56.y) * y, v_61)});
  };
  const auto by_sines = [=] {
    const T CD = number<T>(of.CD);
    return std::pair{crank_by_sines<T>(of) + Complex<T>{T(0), number<T>(of.AC)},
                     Complex<T>{CD * geometry::sine<T>(of.theta), CD * geometry::cosine<T>(of.theta)}};
  };
  // Of R_56 and R_34.
  const auto angles = [=](const Turned& turned, const Equations<T>* ideal) {
    const auto [B, D] = by_sines();
    const auto slides = [&](int j, int i, const Complex<T>& X) {
      return velocity_of(ideal, j, X) - velocity_of(ideal, i, X);
    };
    return std::pair{turned.angle<T>(half(), slides(6, 5, D)), turned.angle<T>(half() - of.theta, slides(4, 3, B))};
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    require_sliding(turned);
    const auto [B, D] = by_sines();
    const auto [of_R_56, of_R_34] = angles(turned, ideal);
    const XY<T> R_56 = unit<T>(of_R_56);
    const Angle R_16 = geometry::sign(pressing<T>(R_56.y)) == geometry::Sign::positive ? quarter() : -quarter();
    epure::describe(model, of,
                    FairbairnAt<T>{{T(0), number<T>(of.AC)},
                                   {B.re, B.im},
                                   {D.re, D.im},
                                   unit<T>(of_R_34),
                                   R_56,
                                   unit<T>(turned.angle<T>(R_16, velocity_of(ideal, 6, D)))});
  };
  const Motions<T> all = in_all_motions<T>(6, "M", phi, constructed, analysed);
  ledger.route("construction");
  ledger.draws_point("A", [&] { return at().A; });
  ledger.draws_point("B", [&] { return at().B; });
  ledger.draws_point("C", [&] { return at().C; });
  ledger.draws_point("D", [&] { return at().D; });
  draw_vector(ledger, "v_56", [&] { return sliding_of(of, at()).v_56; });
  draw_vector(ledger, "v_43", [&] { return sliding_of(of, at()).v_43; });
  draw_vector(ledger, "v_61", [&] { return sliding_of(of, at()).v_61; });
  write_motions<T>(ledger, names_of_M(), all, {T(1), T(0)},
                   {force_between(5, 6), force_between(1, 6), force_between(1, 4), force_between(3, 4)},
                   at_dead_centre(of, phi));
  for (const Motion motion : with_friction) {
    const Quantity F_23 =
        in(motion,
           Quantity{"F_23", "$\\it{R}_{32}$", "N", {"force between crank and lever", "forza tra manovella e leva"}});
    const Quantity d =
        in(motion, Quantity{"d", "$d$", "m", {"arm of R32 about A", "braccio della R32 rispetto ad A"}});
    const PointQuantity H = in(motion, PointQuantity{"H",
                                                     {" of the meeting point of the forces on the lever",
                                                      " del punto d'incontro delle forze sulla leva"}});
    ledger.route("force polygon");
    ledger.put(F_23, [&] { return size(all.bodies.at(motion)().force("R_23")); });
    ledger.put(d, [&] {
      return geometry::distance(at().A, geometry::foot(at().A, all.bodies.at(motion)().line_of("R_23")));
    });
    put_point(
        ledger, H, [&] { return all.bodies.at(motion)().H(4); }, parallel_forces);
    ledger.route("equilibrium equations");
    ledger.put(F_23, [&] { return size(all.equations.at(motion)().force("R_23")); });
    ledger.put(d, [&] {
      const Equations<T>& equations = all.equations.at(motion)();
      return geometry::quotient(magnitude_of<T>(equations.forces.at("M").m), size(equations.force("R_23")));
    });
    put_point(
        ledger, H,
        [=] {
          const Equations<T>& equations = all.equations.at(motion)();
          const auto [of_R_56, of_R_34] = angles({phi, motion}, &all.equations.at(Motion::ideal)());
          if (geometry::are_parallel(of_R_56, of_R_34)) throw geometry::Impossible(parallel_forces);
          return on_reaction<T>({T(0), T(0)}, equations.force("R_14"), by_sines().second,
                                complex(xy(equations.force("R_56"))));
        },
        parallel_forces);
  }
  put_locking_angle(ledger, [&] {
    const FairbairnPoints<T>& P = at();
    const Vector<T> across = geometry::quarter_turn(P.lever), v_B2 = geometry::quarter_turn(P.B - P.A);
    const T along = geometry::close_polygon(v_B2, P.lever, across).of_first;  // the lever on the block, along it
    return to_line<T>(across, P.B - P.A, T(sense_of<T>(-along)));
  });
  put_half(ledger, jamming_angle(), quarter());
}

template <class T>
void write_fairbairn(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("fairbairn.", {", Fairbairn's mechanism", ", guida di Fairbairn"});
  write_case(ledger, problem, problem.of.fairbairn, "fairbairn");
}
template <class T>
void write_fairbairn_short_lever(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("fairbairn_short_lever.",
                    {", Fairbairn's mechanism, shorter lever", ", guida di Fairbairn, leva più corta"});
  write_case(ledger, problem, problem.of.fairbairn_short_lever, "fairbairn_short_lever");
}

}  // namespace epure::friction_efficiency
