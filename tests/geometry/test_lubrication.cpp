// The film under a flat slider, in closed form and by quadrature, against mpmath (tests/corpus/make_lubrication.py).
#include "geometry/analytic/reynolds.h"
#include "geometry/lubrication/flat_slider.h"
#include "geometry/numbers/increasing_root.h"
#include "tests/geometry/holds_reference.h"

#include <cmath>

namespace epure::tests {

using namespace geometry;

namespace {

std::vector<CorpusCase> films(const std::string& given) {
  std::vector<CorpusCase> all;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/lubrication.txt"))
    if (c.givens.contains(given)) all.push_back(c);
  return all;
}

const std::array<std::pair<const char*, Logarithms>, 4> combinations{{{"plain", Logarithms::plain},
                                                                      {"drag", Logarithms::drag},
                                                                      {"load", Logarithms::load},
                                                                      {"couple", Logarithms::couple}}};

}  // namespace

TEST_CASE("combinations of logarithms keep their digits where films are nearly parallel") {
  const auto cases = films("n");
  CHECK(cases.size() == 4);
  for (const CorpusCase& c : cases)
    for (const auto& [name, which] : combinations) {
      const std::string reference = std::string("logarithms_") + name;
      const Arithmetic<Deep> deep(192);
      holds(c, reference, logarithms(which, from_rational<Deep>(c.givens.at("n"))));
      const Arithmetic<Bounded> scope;
      const Bounded n = from_rational<Bounded>(c.givens.at("n")), found = logarithms(which, n);
      CAPTURE(c.name, name);
      CHECK(overlaps(enclosure(found), exact_decimal(c.reference(reference))));
    }
}

TEST_CASE("the slider's coefficients are the reference's") {
  const Arithmetic<Deep> scope(192);
  for (const CorpusCase& c : films("n")) {
    const FlatSlider<Deep> slider{from_rational<Deep>(c.givens.at("n"))};
    holds(c, "load", slider.load());
    holds(c, "centre", slider.centre());
    holds(c, "drag", slider.drag());
    holds(c, "friction", slider.friction());
  }
}

TEST_CASE("integrals over the film are the reference's, and so is what is made of them") {
  const Arithmetic<Deep> scope(256);
  for (const CorpusCase& c : films("n")) {
    const Rational n = c.givens.at("n"), epsilon = (n - 1) / (n + 1);
    const Deep wedge = from_rational<Deep>(epsilon), third = from_rational<Deep>(Rational(1, 3));
    for (const auto& [k, b] :
         std::vector<std::pair<int, int>>{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}) {
      const std::string name = "integral_" + std::to_string(k) + "_" + std::to_string(b);
      holds(c, name + "_end", analytic::film_integral(k, b, wedge, Deep(1)));
      holds(c, name + "_third", analytic::film_integral(k, b, wedge, third));
    }
    const analytic::FilmByQuadrature<Deep> film(wedge);
    holds(c, "load", film.load());
    holds(c, "centre", (Deep(1) + film.centre()) / Deep(2));
  }
}

TEST_CASE("the film of a given centre of pressure is found by both routes") {
  const Arithmetic<Deep> scope(192);
  const auto cases = films("centre");
  CHECK(cases.size() == 4);
  for (const CorpusCase& c : cases) {
    const Rational centre = c.givens.at("centre");
    holds(c, "less_one", ratio_of_films<Deep>(centre) - Deep(1));
    const Deep epsilon = analytic::wedge_of_centre<Deep>(centre);
    holds(c, "less_one", Deep(2) * epsilon / (Deep(1) - epsilon));
  }
}

TEST_CASE("an increasing function's zero is enclosed, or not found where it is not") {
  const Arithmetic<Deep> scope(192);
  const auto cube_less_two = [](const Deep& x) { return x * x * x - Deep(2); };
  const Deep root = increasing_root(cube_less_two, -3, 4);
  CHECK(sign(root * root * root - Deep(2)) == Sign::undecided);
  CHECK(narrow(root));
  CHECK_THROWS_AS(increasing_root([](const Deep& x) { return x + Deep(1); }, -3, 4), Undecided);
  // Known to a thousandth only.
  const Deep blur = widened(Deep(0), from_rational<Deep>(Rational(1, 1000)));
  const Deep wide = increasing_root([&](const Deep& x) { return x - Deep(3) + blur; }, 0, 4);
  CHECK(overlaps(wide, 3));
  CHECK_FALSE(narrow(wide));
}

}  // namespace epure::tests
