// Circles that touch, nearly touch, nest or coincide; lines of action that are nearly parallel.
#pragma once

#include "bench/families/four_bar_family.h"
#include "geometry/constructions/circle.h"
#include "geometry/constructions/vector_polygon.h"

namespace epure::bench {

struct CirclesGivens {
  Rational x_1, y_1, r_1, x_2, y_2, r_2;
  Side side;
};

struct Circles {
  static constexpr const char* name = "circles";
  static constexpr const char* corpus = "circles.txt";
  using Givens = CirclesGivens;
  static Givens givens(const CorpusCase& c) {
    const auto given = [&](const char* name) { return c.givens.at(name); };
    return {given("x_1"),
            given("y_1"),
            given("r_1"),
            given("x_2"),
            given("y_2"),
            given("r_2"),
            side_in_words(c.choices.at("side"))};
  }

  template <class T>
  struct On {
    Circle<T> first, second;
    Side side;
    explicit On(const Givens& of)
        : first{{from_rational<T>(of.x_1), from_rational<T>(of.y_1)}, from_rational<T>(of.r_1)},
          second{{from_rational<T>(of.x_2), from_rational<T>(of.y_2)}, from_rational<T>(of.r_2)},
          side(of.side) {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const Point<T> P = meet(of.first, of.second, of.side);
    report("x", [&] { return P.x; });
    report("y", [&] { return P.y; });
  }

  // Positive while they cross, zero at contact, negative when they lie apart or one in the other.
  static std::vector<Question> questions(const Givens& of) {
    const auto overlap = [of]<class T>() -> T {
      const T dx = from_rational<T>(of.x_2 - of.x_1), dy = from_rational<T>(of.y_2 - of.y_1);
      const T d2 = square(dx) + square(dy);
      const T sum = from_rational<T>(of.r_1 + of.r_2), difference = from_rational<T>(of.r_1 - of.r_2);
      return (d2 - square(difference)) * (square(sum) - d2);
    };
    return {{"overlap", [=] { return in_words(decide(overlap)); }}};
  }
};

// known + x u = y w; and the meeting point of the line through P along u with the line through Q along w.
struct VectorPolygonGivens {
  Rational x_known, y_known, x_u, y_u, x_w, y_w, x_P, y_P, x_Q, y_Q;
};

struct VectorPolygon {
  static constexpr const char* name = "vector-polygon";
  static constexpr const char* corpus = "vector_polygon.txt";
  using Givens = VectorPolygonGivens;
  static Givens givens(const CorpusCase& c) {
    const auto given = [&](const char* name) { return c.givens.at(name); };
    return {given("x_known"), given("y_known"), given("x_u"), given("y_u"), given("x_w"),
            given("y_w"),     given("x_P"),     given("y_P"), given("x_Q"), given("y_Q")};
  }

  template <class T>
  struct On {
    Vector<T> known, u, w;
    Point<T> P, Q;
    explicit On(const Givens& of)
        : known{from_rational<T>(of.x_known), from_rational<T>(of.y_known)},
          u{from_rational<T>(of.x_u), from_rational<T>(of.y_u)},
          w{from_rational<T>(of.x_w), from_rational<T>(of.y_w)},
          P{from_rational<T>(of.x_P), from_rational<T>(of.y_P)},
          Q{from_rational<T>(of.x_Q), from_rational<T>(of.y_Q)} {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const TwoMagnitudes<T> sides = close_polygon(of.known, of.u, of.w);
    report("of_first", [&] { return sides.of_first; });
    report("of_second", [&] { return sides.of_second; });
    const ProjectivePoint<T> S = meet(line(of.P, of.u), line(of.Q, of.w));
    report("x_S", [&] { return unless_infinite(S).x; });
    report("y_S", [&] { return unless_infinite(S).y; });
  }

  static std::vector<Question> questions(const Givens& of) {
    const auto turn = [of]<class T>() -> T {
      return cross(Vector<T>{from_rational<T>(of.x_u), from_rational<T>(of.y_u)},
                   Vector<T>{from_rational<T>(of.x_w), from_rational<T>(of.y_w)});
    };
    return {{"turns_to", [=] { return in_words(decide(turn)); }}};
  }
};

}  // namespace epure::bench
