// Is this the position? Questions about a four-bar linkage whose crank stands in a direction that is given exactly,
// answered by climbing from number to number: yes and no are proved.
//
// None of them needs the position of B, and so no root but that of the crank's direction: what B would have to be is
// put to the test.
#pragma once

#include "geometry/mechanisms/four_bar_positions.h"
#include "geometry/numbers/climb.h"

#include <variant>

namespace epure::geometry {

// The direction (x, y), not (0, 0), of any length.
struct Heading {
  Rational x, y;
};
using CrankDirection = std::variant<Turn, Heading>;

template <class T>
Vector<T> unit_vector(const CrankDirection& crank) {
  if (const Turn* turn = std::get_if<Turn>(&crank)) return {cosine<T>(*turn), sine<T>(*turn)};
  const auto& [x, y] = std::get<Heading>(crank);
  const T share = quotient(T(1), root(from_rational<T>(x * x + y * y)));
  return {share * from_rational<T>(x), share * from_rational<T>(y)};
}

namespace questions {

template <class T>
Truth vanishes(const T& x) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided) return Truth::undecided;
  return decided == Sign::zero ? Truth::yes : Truth::no;
}

inline Truth all(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::undecided;
}
inline Truth any(Truth a, Truth b) {
  if (a == Truth::yes || b == Truth::yes) return Truth::yes;
  return a == Truth::no && b == Truth::no ? Truth::no : Truth::undecided;
}

template <class T>
Vector<T> frame_vector(const FourBarLengths& of) {
  return {from_rational<T>(of.x_B0), from_rational<T>(of.y_B0)};
}

// u points to the named side of A₀ -> B₀, or along the frame, where both sides meet.
template <class T>
Truth points_to(const FourBarLengths& of, const Vector<T>& u, Side side) {
  const Sign decided = sign(cross(frame_vector<T>(of), u));
  if (decided == Sign::undecided) return Truth::undecided;
  return decided != (side == Side::left ? Sign::negative : Sign::positive) ? Truth::yes : Truth::no;
}

// |A₀B₀ - leg u| = other.
template <class T>
Truth closes(const FourBarLengths& of, const Vector<T>& u, const Rational& leg, const Rational& other) {
  const Rational squares = frame_squared(of) + leg * leg - other * other;
  return vanishes<T>(from_rational<T>(squares) - from_rational<T>(2 * leg) * dot(frame_vector<T>(of), u));
}

}  // namespace questions

// With the crank along the unit vector u and B on the named side of A -> B₀ (on that line: on both): are crank and
// coupler in line, the rocker's dead centre?
template <class T>
Truth is_dead_centre(const FourBarLengths& of, const Vector<T>& u, Side branch, Reach reach) {
  const bool is_extended = reach == Reach::extended;
  const Truth in_line = questions::closes(of, u, Rational(is_extended ? of.A0A + of.AB : of.A0A - of.AB), of.B0B);
  return questions::all(in_line, questions::points_to(of, u, is_extended ? branch : opposite(branch)));
}

// Are crank and rocker parallel?
template <class T>
Truth is_parallel(const FourBarLengths& of, const Vector<T>& u, Side branch, Sense sense) {
  const bool is_same = sense == Sense::same;
  const Truth parallel = questions::closes(of, u, Rational(is_same ? of.A0A - of.B0B : of.A0A + of.B0B), of.AB);
  return questions::all(parallel, questions::points_to(of, u, is_same ? branch : opposite(branch)));
}

// Are coupler and rocker in line, a limit position of the crank? (Then B is on both branches.)
template <class T>
Truth is_crank_limit(const FourBarLengths& of, const Vector<T>& u, Reach reach) {
  return questions::closes(of, u, of.A0A, Rational(reach == Reach::extended ? of.AB + of.B0B : of.AB - of.B0B));
}

// Are all four hinges in line, and can two motions leave? Errors as grashof.
template <class T>
Truth is_change_point(const FourBarLengths& of, const Vector<T>& u) {
  if (grashof(of).is != LinkageClass::change_point) return Truth::no;
  const Truth on_frame = questions::vanishes(cross(questions::frame_vector<T>(of), u));
  return questions::all(on_frame,
                        questions::any(is_crank_limit(of, u, Reach::extended), is_crank_limit(of, u, Reach::folded)));
}

// The same, for a crank direction given exactly, up the numbers.
inline Answer is_dead_centre(const FourBarLengths& of, const CrankDirection& crank, Side branch, Reach reach) {
  return ask([&]<class T>() { return is_dead_centre<T>(of, unit_vector<T>(crank), branch, reach); });
}
inline Answer is_parallel(const FourBarLengths& of, const CrankDirection& crank, Side branch, Sense sense) {
  return ask([&]<class T>() { return is_parallel<T>(of, unit_vector<T>(crank), branch, sense); });
}
inline Answer is_crank_limit(const FourBarLengths& of, const CrankDirection& crank, Reach reach) {
  return ask([&]<class T>() { return is_crank_limit<T>(of, unit_vector<T>(crank), reach); });
}
inline Answer is_change_point(const FourBarLengths& of, const CrankDirection& crank) {
  return ask([&]<class T>() { return is_change_point<T>(of, unit_vector<T>(crank)); });
}

}  // namespace epure::geometry
