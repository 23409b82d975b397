// A figure that is turned, mirrored, shifted or scaled has its answers turned, mirrored, shifted or scaled. And on
// random figures, close to contact, the constructions agree with the closed formulas of geometry/analytic.
#include "geometry/analytic/circles.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace epure::tests {
namespace {

// Mirrored in the x axis or not, then turned by the angle of the 3-4-5 triangle or not, scaled, shifted.
struct Similarity {
  const char* name;
  bool mirrors, turns;
  Rational scale;
  Rational x, y;

  template <class T>
  Vector<T> operator()(const Vector<T>& v) const {
    const Vector<T> m{v.x, mirrors ? T(-v.y) : v.y}, n = quarter_turn(m);
    const T s = from_rational<T>(scale);
    if (!turns) return s * m;
    return s * (number<T>(3, 5) * m + number<T>(4, 5) * n);
  }
  template <class T>
  Point<T> operator()(const Point<T>& P) const {
    return Point<T>{from_rational<T>(x), from_rational<T>(y)} + (*this)(Vector<T>{P.x, P.y});
  }
  template <class T>
  T length(const T& l) const {
    return from_rational<T>(scale) * l;
  }
  Side operator()(Side side) const {
    if (!mirrors) return side;
    return side == Side::left ? Side::right : Side::left;
  }
};

const Rational billion(1000000000), billionth(1, 1000000000);
const std::vector<Similarity> similarities{
    {"shift", false, false, Rational(1), Rational(-7, 3), Rational(5, 2)},
    {"turn", false, true, Rational(1), Rational(0), Rational(0)},
    {"mirror", true, false, Rational(1), Rational(0), Rational(0)},
    {"mirror and turn", true, true, Rational(2, 3), Rational(1), Rational(-4)},
    {"scale by 1e-9", false, true, billionth, billionth, Rational(0)},
    {"scale by 1e9", true, true, billion, Rational(0), -billion},
};

// A figure with one of each construction. Its points come out in the order in which they are listed.
template <class T>
std::vector<Point<T>> constructed(const Similarity& by) {
  const Point<T> A = by(Point<T>{0, 0}), B = by(Point<T>{5, 1}), C = by(Point<T>{2, 4}), D = by(Point<T>{-1, 2});
  const T AX = by.length(T(3)), BX = by.length(T(4));
  const Side left = by(Side::left), right = by(Side::right);
  const Line<T> AB = line(A, B), CD = line(C, D);
  const auto [first, second] = close_polygon(C - A, B - A, D - A);
  const Transport<T> paper(A, B, B, B + quarter_turn(B - A));
  const Cycle<T> circle = cycle_through(A, B, C);
  return {finite(meet(AB, CD)), foot(C, AB), finite(meet(parallel(AB, C), perpendicular(CD, A))),
          meet(Circle<T>{A, AX}, CD, Along::ahead), meet(Circle<T>{A, AX}, CD, Along::behind),
          meet(Circle<T>{A, AX}, Circle<T>{B, BX}, left), meet(Circle<T>{A, AX}, Circle<T>{B, BX}, right),
          C + first * (B - A), A + second * (D - A), midpoint(C, D),
          // A quarter turn is the other way about in a mirror.
          by.mirrors ? Transport<T>(A, B, B, B + -quarter_turn(B - A))(C) : paper(C),
          turned(C, A, Angle{by.mirrors ? Rational(-1, 12) : Rational(1, 12)}), finite(circle.centre())};
}

const Similarity identity{"identity", false, false, Rational(1), Rational(0), Rational(0)};

analytic::Complex<Exact> complex(const Point<Exact>& P) { return {P.x, P.y}; }

bool meets(const Bounded& x, const Bounded& y) { return x.inf() <= y.sup() && y.inf() <= x.sup(); }

// What becomes of a construction: a point, or why there is none.
enum class Kind { point, impossible, undecided };
template <class T>
struct Outcome {
  Kind kind;
  std::optional<Point<T>> point = {};
};
template <class T, class Construction>
Outcome<T> outcome(const Construction& construction) {
  try {
    return {Kind::point, construction()};
  } catch (const Impossible&) {
    return {Kind::impossible};
  } catch (const Undecided&) {
    return {Kind::undecided};
  }
}

// Two circles, sizes from 1e-6 to 1e6, a gap or an overlap of 1 down to 1e-25 of the size, or contact.
struct TwoCircles {
  Rational x, y, r, s;  // the second about (x, y)
};
TwoCircles random_circles(Random& random) {
  const Rational size = random.power_of_ten(-6, 6);
  const Rational r = CGAL::abs(random.fraction()) * size, d = CGAL::abs(random.fraction()) * size;
  const Rational gap = random.up_to(5) == 0 ? Rational(0) : random.fraction() * random.power_of_ten(-25, 0) * size;
  const Rational contact = random.up_to(2) == 0 || d == r ? d + r : CGAL::abs(d - r);
  // 3-4-5 again, so that the distance is rational.
  return {d * Rational(3, 5), d * Rational(-4, 5), r, CGAL::abs(contact + gap)};
}

template <class T>
Outcome<T> constructed(const TwoCircles& of, Side which) {
  const Circle<T> first{{0, 0}, from_rational<T>(of.r)};
  const Circle<T> second{{from_rational<T>(of.x), from_rational<T>(of.y)}, from_rational<T>(of.s)};
  return outcome<T>([&] { return meet(first, second, which); });
}

template <class T>
Outcome<T> analysed(const TwoCircles& of, Side which) {
  return outcome<T>([&] {
    const auto both =
        analytic::meet_of_circles<T>({T(0), T(0)}, from_rational<T>(of.r),
                                     {from_rational<T>(of.x), from_rational<T>(of.y)}, from_rational<T>(of.s));
    if (!both) throw Impossible("they miss");
    const auto& z = which == Side::left ? both->left : both->right;
    return Point<T>{z.re, z.im};
  });
}

}  // namespace

TEMPLATE_TEST_CASE("answers move with the figure", "[constructions]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  for (const Similarity& by : similarities) {
    const Scope<T> scope;
    const std::vector<Point<T>> here = constructed<T>(identity), there = constructed<T>(by);
    const double size = CGAL::to_double(by.scale) * 100;
    REQUIRE(here.size() == there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      CAPTURE(by.name, i);
      CHECK(is(there[i], by(here[i]), size));
    }
    const Point<T> A{0, 0}, B{5, 1}, C{2, 4};
    CHECK(is(cycle_through(by(A), by(B), by(C)).radius(), by.length(cycle_through(A, B, C).radius()), size));
  }
}

TEST_CASE("random circles close to contact: construction and formula are one, in every number", "[constructions]") {
  const std::uint64_t start = seed();
  Random random(start);
  int points = 0, impossible = 0, contacts = 0, left_open = 0;
  for (int i = 0; i < 400; ++i) {
    const TwoCircles circles = random_circles(random);
    const Side which = random.up_to(2) == 0 ? Side::left : Side::right;
    CAPTURE(start, i, circles.x, circles.y, circles.r, circles.s);
    const Arithmetic<Deep> bits(256);
    const Arithmetic<Exact> tower;
    const Outcome<Exact> proved = constructed<Exact>(circles, which), formula = analysed<Exact>(circles, which);
    REQUIRE(proved.kind != Kind::undecided);
    REQUIRE(proved.kind == formula.kind);
    const Outcome<Deep> deep = constructed<Deep>(circles, which);
    Outcome<Bounded> bounded{Kind::undecided};
    {
      const Arithmetic<Bounded> rounding;
      bounded = constructed<Bounded>(circles, which);
    }
    CHECK((deep.kind == proved.kind || deep.kind == Kind::undecided));
    CHECK((bounded.kind == proved.kind || bounded.kind == Kind::undecided));
    if (proved.kind == Kind::impossible) {
      ++impossible;
      continue;
    }
    ++points;
    const Point<Exact>&P = *proved.point, &Q = *formula.point;
    CHECK(is(P, Q));
    // Only contact itself may be too much for 256 bits.
    const bool contact =
        sign(P.x * from_rational<Exact>(circles.y) - P.y * from_rational<Exact>(circles.x)) == Sign::zero;
    contacts += contact ? 1 : 0;
    if (!contact) REQUIRE(deep.kind == Kind::point);
    if (deep.kind == Kind::point) {
      const double size = CGAL::to_double(circles.r);
      CHECK(is(*deep.point, {to_deep(P.x), to_deep(P.y)}, size));
    }
    if (bounded.kind != Kind::point) {
      ++left_open;
      continue;
    }
    const Arithmetic<Bounded> rounding;
    CHECK(meets(bounded.point->x, to_bounded(to_deep(P.x))));
    CHECK(meets(bounded.point->y, to_bounded(to_deep(P.y))));
  }
  std::printf("circles with seed %llu: %d points (%d of contact; %d undecided in intervals), %d without\n",
              static_cast<unsigned long long>(start), points, contacts, left_open, impossible);
  CHECK(points > 100);
  CHECK(contacts > 20);
  CHECK(impossible > 50);
  CHECK(left_open < points);
}

TEST_CASE("random lines, feet, chords and polygons: construction and formula are one", "[constructions]") {
  const std::uint64_t start = seed();
  Random random(start);
  int chords = 0, missed = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(start, i);
    const Arithmetic<Exact> tower;
    const Rational size = random.power_of_ten(-6, 6);
    const auto coordinate = [&] { return from_rational<Exact>(random.fraction() * size); };
    const auto point = [&] {
      const Exact x = coordinate(), y = coordinate();
      return Point<Exact>{x, y};
    };
    const Point<Exact> P = point(), Q = point(), X = point();
    const Vector<Exact> u = point() - P, w = point() - Q;
    const auto complex_of = [](const Vector<Exact>& v) { return analytic::Complex<Exact>{v.x, v.y}; };
    const auto same = [](const Point<Exact>& K, const analytic::Complex<Exact>& z) {
      return is(K, Point<Exact>{z.re, z.im});
    };
    if (sign(length_squared(u)) != Sign::zero)
      CHECK(same(foot(X, line(P, u)), analytic::foot(complex(X), complex(P), complex_of(u))));
    if (const auto z = analytic::meet_of_lines(complex(P), complex_of(u), complex(Q), complex_of(w)))
      CHECK(same(finite(meet(line(P, u), line(Q, w))), *z));
    // Here known + x u = y w, there known + x u + y' w = 0.
    if (const auto sides = analytic::close_polygon(complex_of(X - P), complex_of(u), complex_of(w))) {
      const auto [first, second] = close_polygon(X - P, u, w);
      CHECK(is(first, sides->first));
      CHECK(is(second, -sides->second));
    }
    const Exact radius = from_rational<Exact>(CGAL::abs(random.fraction()) * size);
    const auto chord = analytic::meet_of_line_and_circle(complex(P), complex_of(u), complex(X), radius);
    if (!chord) {
      ++missed;
      CHECK_THROWS_AS(meet(Circle<Exact>{X, radius}, line(P, u), Along::ahead), Impossible);
      continue;
    }
    ++chords;
    CHECK(same(meet(Circle<Exact>{X, radius}, line(P, u), Along::ahead), chord->leaving));
    CHECK(same(meet(Circle<Exact>{X, radius}, line(P, u), Along::behind), chord->entering));
  }
  std::printf("lines with seed %llu: %d chords, %d lines past their circle\n", static_cast<unsigned long long>(start),
              chords, missed);
  CHECK(chords > 80);
  CHECK(missed > 30);
}

}  // namespace epure::tests
