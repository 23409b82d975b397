// The levers: friction in C.
#pragma once

#include "exercises/friction-efficiency/with_friction.h"

namespace epure::friction_efficiency {

// The lever that P drives turns as P does, the other so that they stay in touch.
template <class T>
Vector<T> sliding_in_C(const Levers& of, const LeverPoints<T>& at) {
  const Point<T>&h_P = of.driven() == 2 ? at.A0 : at.B0, &h_Q = of.loaded == 2 ? at.A0 : at.B0;
  const T omega_P = of.arm_P > 0 ? T(1) : T(-1);
  const T omega_Q =
      geometry::quotient(omega_P * geometry::cross(at.C - h_P, at.n), geometry::cross(at.C - h_Q, at.n));
  return omega_Q * geometry::quarter_turn(at.C - h_Q) - omega_P * geometry::quarter_turn(at.C - h_P);
}

template <class T>
void write_case(Ledger<T>& ledger, const Problem& problem, const Levers& of, bool is_at_limit) {
  const LeverPoints<T> at = points_of<T>(of);
  const Angle phi = problem.phi;
  const auto constructed = [=](auto& model, const Turned& turned) {
    const Vector<T> sliding = sliding_in_C(of, at);
    if (is_at_limit && turned.motion == Motion::retrograde)
      model.through(of.contact(), "R_1" + std::to_string(of.driven()));
    epure::describe(
        model, of,
        LeversAt<T>{xy(at.C), turned.components<T>(at.n, sliding), turned.direction<T>(of.nu, at.n, sliding)});
  };
  const Complex<T> C{number<T>(of.x_C), number<T>(of.y_C)};
  const auto angle = [=](const Turned& turned, const Equations<T>* ideal) {
    return turned.angle<T>(of.nu, velocity_of(ideal, of.loaded, C) - velocity_of(ideal, of.driven(), C));
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const Angle along = angle(turned, ideal);
    epure::describe(model, of, LeversAt<T>{{C.re, C.im}, unit<T>(along), along});
  };
  const Motions<T> all = in_all_motions<T>(3, "P", phi, constructed, analysed);
  const VectorQuantity contact = force_between(of.driven(), of.loaded);
  ledger.route("construction");
  for (const auto& [name, P] : {std::pair{"A0", at.A0}, std::pair{"B0", at.B0}, std::pair{"C", at.C},
                                std::pair{"A", at.A}, std::pair{"B", at.B}})
    ledger.draws_point(name, P);
  write_motions<T>(ledger, names_of_P(), all, unit<T>(of.direction_P),
                   {force_between(1, 2), force_between(1, 3), contact}, without_effort(is_at_limit));
  draw_vector(ledger, "sliding", [&] { return sliding_in_C(of, at); });
  for (const Motion motion : with_friction) {
    const Quantity direction{
        "contact_force_angle" + suffix(motion) + "_deg",
        "$ν_{" + std::string(motion == Motion::direct ? "D" : "R") + "}$", "deg",
        Words{"direction of the contact's force", "direzione della forza di contatto"} + words_of(motion)};
    ledger.route("force polygon");
    ledger.put(direction, [&] { return in_degrees(angle_of(all.bodies.at(motion)().force(contact.name))); });
    ledger.route("equilibrium equations");
    ledger.put(direction, [&] {
      const Angle found = geometry::within_one_turn(angle({phi, motion}, &all.equations.at(Motion::ideal)()));
      return given_in_degrees<T>(sign_of(half() - found) < 0 ? found - Angle{1} : found);
    });
    for (const int lever : {2, 3}) {
      const PointQuantity H = in(
          motion, PointQuantity{"H_" + std::to_string(lever), Words{" of the meeting point of the forces on lever ",
                                                                    " del punto d'incontro delle forze sulla leva "} +
                                                                  std::to_string(lever)});
      ledger.route("force polygon");
      put_point(
          ledger, H, [&] { return all.bodies.at(motion)().H(lever); }, parallel_forces);
      ledger.route("equilibrium equations");
      put_point(
          ledger, H,
          [=] {
            const bool is_loaded = lever == of.loaded;
            if (geometry::are_parallel(angle({phi, motion}, &all.equations.at(Motion::ideal)()),
                                       is_loaded ? of.direction_Q : of.direction_P))
              throw geometry::Impossible(parallel_forces);
            const XY<T> X = is_loaded ? XY<T>{number<T>(of.x_Q), T(0)} : foot_of_P<T>(of);
            return on_reaction<T>({number<T>(of.hinge(lever)), T(0)},
                                  all.equations.at(motion)().force("R_1" + std::to_string(lever)), complex(X),
                                  complex(unit<T>(is_loaded ? of.direction_Q : of.direction_P)));
          },
          parallel_forces);
    }
  }
  put_locking_angle(ledger, [&] {
    const Vector<T> sliding = sliding_in_C(of, at), left = geometry::quarter_turn(at.n);
    return to_line<T>(at.n, at.C - (of.driven() == 2 ? at.A0 : at.B0), T(sense_of<T>(geometry::dot(sliding, left))));
  });
}

template <class T>
void write_levers(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("sliding_levers.", {", sliding levers", ", leve striscianti"});
  write_case(ledger, problem, problem.of.levers, problem.levers_at_limit);
}
template <class T>
void write_levers_Q_on_2(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("sliding_levers_Q_on_2.", {", sliding levers with Q on 2", ", leve striscianti con Q sulla 2"});
  write_case(ledger, problem, problem.of.levers_Q_on_2, problem.levers_Q_on_2_at_limit);
}

}  // namespace epure::friction_efficiency
