// Graphical integration with every number, against sums and closed forms.
#include "geometry/constructions/graphical_integral.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

using namespace epure::tests;

namespace {

// y = 3 x² - 2 over five unequal strips from -1.
template <class T>
T cubed(const T& x) {
  return x * x * x;
}
template <class T>
T ordinate_of_curve(const T& x) {
  return T(3) * square(x) - T(2);
}
template <class T>
std::vector<T> strip_ends() {
  return {number<T>(-1), number<T>(-1, 2), number<T>(0), number<T>(2, 3), number<T>(3), number<T>(7, 2)};
}
template <class T>
std::vector<T> in_the_middles(const std::vector<T>& ends) {
  std::vector<T> all;
  for (std::size_t i = 1; i < ends.size(); ++i)
    all.push_back(ordinate_of_curve<T>(quotient(ends[i - 1] + ends[i], T(2))));
  return all;
}
// x³ - 2 x from -1.
template <class T>
std::vector<T> true_integral(const std::vector<T>& ends) {
  std::vector<T> all;
  for (const T& x : ends) all.push_back(cubed(x) - T(2) * x - T(1));
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("the polygon rises by width times mean over pole distance", "[graphical integral]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const std::vector<T> ends{number<T>(0), number<T>(1), number<T>(3), number<T>(4)};
  const auto polygon =
      graphical_integral<T>(ends, {number<T>(2), number<T>(-1, 2), T(0)}, number<T>(4), number<T>(5));
  CHECK(polygon.strings.size() == 3);
  CHECK(is(polygon.corners[0].y, number<T>(5)));
  CHECK(is(polygon.corners[1].y, number<T>(11, 2)));
  CHECK(is(polygon.corners[2].y, number<T>(21, 4)));
  CHECK(is(polygon.corners[3], Point<T>{number<T>(4), number<T>(21, 4)}));
  CHECK(is(polygon.at(1, number<T>(2)), number<T>(43, 8)));
  CHECK(is(polygon.pole(), Point<T>{number<T>(-4), T(0)}));
  CHECK(is(cross(polygon.ray(0), polygon.corners[1] - polygon.corners[0]), T(0)));
  CHECK(is(polygon.middles()[1], number<T>(43, 8)));
}

// The distances that the header tells: y'' = 6, so w³/4 too low by middles, w³/2 too high by the ends' means.
TEMPLATE_TEST_CASE("the polygon of a parabola is off by w³ y''/24 or w³ y''/12", "[graphical integral]", Fast,
                   Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const std::vector<T> ends = strip_ends<T>();
  std::vector<T> at_ends;
  for (const T& x : ends) at_ends.push_back(ordinate_of_curve(x));
  const auto off_by_middles = graphical_integral<T>(ends, in_the_middles(ends), T(1)).off_from(true_integral(ends));
  const auto off_by_ends = graphical_integral<T>(ends, means_of_ends(at_ends), T(1)).off_from(true_integral(ends));
  T cubes(0);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0) cubes += cubed<T>(ends[i] - ends[i - 1]);
    CAPTURE(i);
    CHECK(is(off_by_middles[i], -(cubes * number<T>(1, 4)), 1e3));
    CHECK(is(off_by_ends[i], cubes * number<T>(1, 2), 1e3));
  }
}

// Any scales: on paper, times the scale, the same.
TEMPLATE_TEST_CASE("the pole distance makes the integral come out at its scale", "[graphical integral]", Fast,
                   Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const std::vector<T> ends = strip_ends<T>(), means = in_the_middles(ends);
  const IntegrationScales<T> scales{number<T>(100), number<T>(50), number<T>(1000)};
  CHECK(is(scales.pole_distance(), number<T>(1, 5)));
  std::vector<T> ends_on_paper, means_on_paper;
  for (const T& x : ends) ends_on_paper.push_back(quotient(x, scales.abscissa));
  for (const T& y : means) means_on_paper.push_back(quotient(y, scales.ordinate));
  const auto drawn = graphical_integral<T>(ends_on_paper, means_on_paper, scales.pole_distance());
  const auto computed = graphical_integral<T>(ends, means, T(1));
  for (std::size_t i = 0; i < ends.size(); ++i)
    CHECK(is(scales.integral * drawn.corners[i].y, computed.corners[i].y, 1e3));
}

// Drawn twice it is a funicular polygon: the first and the last string meet over the centroid of the strips' areas,
// each taken in the middle of its strip.
TEMPLATE_TEST_CASE("the tangents of the second integral meet over the centroid", "[graphical integral]", Fast,
                   Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // y = x from 0 to 3: y integrated twice is x³/6, with tangents 0 and y = 9/2 (x - 3) + 9/2 there; centroid at 2.
  const Line<T> first = line(Point<T>{T(0), T(0)}, Vector<T>{T(1), T(0)});
  const Line<T> last = line(Point<T>{T(3), number<T>(9, 2)}, Vector<T>{T(1), number<T>(9, 2)});
  CHECK(is(finite(over_centroid(first, last)), Point<T>{T(2), T(0)}));
  CHECK(is(over_centroid(first, parallel(first, Point<T>{T(3), T(1)})).w, T(0)));
}
