// Rolling circles and lines against the corpus, by construction and by closed forms: 94 cases of 40 digits, at cusps,
// beside them and missing them by as little as 1e-30 of the radius.
#include "geometry/analytic/roulette_formulas.h"
#include "geometry/motion/rolling.h"
#include "geometry/numbers/climb.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

#include <cmath>
#include <functional>

using namespace epure::geometry;
using namespace epure::tests;

namespace {

struct RolledCase {
  Rolling rolling;
  analytic::Roulette roulette;
  Angle phi;
  Rational omega, alpha;
};

RolledCase rolled(const CorpusCase& c) {
  const std::string& how = c.choices.at("how");
  const auto given = [&](const std::string& name) { return c.givens.count(name) ? c.givens.at(name) : Rational(0); };
  const std::map<std::string, std::pair<Rolls, analytic::RouletteKind>> kinds{
      {"circle_on_line", {Rolls::circle_on_line, analytic::RouletteKind::cycloid}},
      {"circle_outside_circle", {Rolls::circle_outside_circle, analytic::RouletteKind::epicycloid}},
      {"circle_inside_circle", {Rolls::circle_inside_circle, analytic::RouletteKind::hypocycloid}},
      {"line_on_circle", {Rolls::line_on_circle, analytic::RouletteKind::involute}}};
  const auto& [rolls, kind] = kinds.at(how);
  const Rational r = given("r"), R = given("R"), d = given("d");
  return {{rolls, r, R, d}, {kind, r, R, d}, {given("turns"), given("radians")}, given("omega"), given("alpha")};
}

template <class T>
using Readings = std::map<std::string, Reading<T>>;

template <class T>
Readings<T> by_construction(const RolledCase& c) {
  const auto at = rolling_instant<T>(c.rolling, c.phi, from_rational<T>(c.omega), from_rational<T>(c.alpha));
  const Point<T> P0 = contact_point<T>(c.rolling, c.phi), M = tracing_point<T>(c.rolling, c.phi);
  const Vector<T> v = at.velocity(), a = at.acceleration();
  const auto read = [](const auto& computation) { return Reading<T>::from(computation); };
  return {{"x", Reading<T>::of(M.x)},
          {"y", Reading<T>::of(M.y)},
          {"P0_x", Reading<T>::of(P0.x)},
          {"P0_y", Reading<T>::of(P0.y)},
          {"J_x", Reading<T>::of((P0 + (at.J - at.motion.A)).x)},
          {"J_y", Reading<T>::of((P0 + (at.J - at.motion.A)).y)},
          {"v_x", Reading<T>::of(v.x)},
          {"v_y", Reading<T>::of(v.y)},
          {"a_x", Reading<T>::of(a.x)},
          {"a_y", Reading<T>::of(a.y)},
          {"v", read([&] { return at.speed(); })},
          {"a", Reading<T>::of(length(a))},
          {"rho", read([&] { return at.radius_of_curvature(); })},
          {"Omega_x", read([&] { return finite(at.centre_of_curvature()).x + P0.x; })},
          {"Omega_y", read([&] { return finite(at.centre_of_curvature()).y + P0.y; })},
          {"a_n", read([&] { return at.normal_component(); })},
          {"a_t_before", read([&] { return at.tangential_component().before; })},
          {"a_t_after", read([&] { return at.tangential_component().after; })},
          {"s", read([&] { return arc_length<T>(c.rolling, c.phi); })}};
}

template <class T>
Readings<T> by_analysis(const RolledCase& c) {
  const T omega = from_rational<T>(c.omega), alpha = from_rational<T>(c.alpha);
  const auto path = analytic::roulette<T>(c.roulette, c.phi);
  const auto geometric = path.motion(T(1), T(0));  // what does not depend on the speed
  const analytic::Complex<T> v = path.velocity(omega), a = path.acceleration(omega, alpha);
  const auto read = [](const auto& computation) { return Reading<T>::from(computation); };
  return {{"x", Reading<T>::of(path.z.re)},
          {"y", Reading<T>::of(path.z.im)},
          {"P0_x", read([&] { return geometric.pole()->re; })},
          {"P0_y", read([&] { return geometric.pole()->im; })},
          {"J_x", read([&] { return geometric.inflection_pole()->re; })},
          {"J_y", read([&] { return geometric.inflection_pole()->im; })},
          {"v_x", Reading<T>::of(v.re)},
          {"v_y", Reading<T>::of(v.im)},
          {"a_x", Reading<T>::of(a.re)},
          {"a_y", Reading<T>::of(a.im)},
          {"v", Reading<T>::of(modulus(v))},
          {"a", Reading<T>::of(modulus(a))},
          {"rho", read([&] { return path.radius_of_curvature(); })},
          {"Omega_x", read([&] { return path.centre_of_curvature().re; })},
          {"Omega_y", read([&] { return path.centre_of_curvature().im; })},
          {"a_n", read([&] { return path.components(omega, alpha).normal; })},
          {"a_t_before", read([&] { return path.components(omega, alpha).before; })},
          {"a_t_after", read([&] { return path.components(omega, alpha).after; })},
          {"s", read([&] { return analytic::arc_length<T>(c.roulette, c.phi); })}};
}

// In the order of the corpus.
template <class T>
std::vector<Reading<T>> wanted(const CorpusCase& c, const Readings<T>& found) {
  std::vector<Reading<T>> in_order;
  for (const Reference& reference : c.references) in_order.push_back(found.at(reference.name));
  return in_order;
}

const std::vector<CorpusCase>& roulettes() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/roulettes.txt");
  return cases;
}

}  // namespace

namespace {

// With enough bits for what 1e-30 beside a cusp costs.
constexpr long bits = 512;

void hold_against(const CorpusCase& c, const Readings<Deep>& found) {
  for (const Reference& reference : c.references) {
    const Reading<Deep>& at = found.at(reference.name);
    INFO(reference.name << " " << reference.value << " " << at.reason().english);
    if (!is_value(reference.value)) {
      CHECK_FALSE(at.value());
      continue;
    }
    REQUIRE(at.value());
    const Deep& x = *at.value();
    CHECK(overlaps(x, exact_decimal(reference.value)));
    // A ball around zero is as narrow as the figure allows: no length or speed of the corpus exceeds 1e7.
    if (exact_decimal(reference.value) != 0) CHECK(narrow(x));
    if (exact_decimal(reference.value) == 0) CHECK(std::fabs(enclosure(x).upper) < 1e-100);
  }
}

}  // namespace

TEST_CASE("roulettes: the construction agrees with the corpus in 40 digits", "[roulettes]") {
  const Arithmetic<Deep> scope(bits);
  for (const CorpusCase& c : roulettes()) {
    INFO(c.name);
    hold_against(c, by_construction<Deep>(rolled(c)));
  }
}

TEST_CASE("roulettes: the closed forms agree with the corpus in 40 digits", "[roulettes]") {
  const Arithmetic<Deep> scope(bits);
  for (const CorpusCase& c : roulettes()) {
    INFO(c.name);
    hold_against(c, by_analysis<Deep>(rolled(c)));
  }
}

TEST_CASE("roulettes: every quantity climbs to its double by both routes, zeros and absences proved", "[roulettes]") {
  // The names in one order for all numbers; what the corpus does not state at a case is not asked.
  for (const CorpusCase& c : roulettes()) {
    INFO(c.name);
    const RolledCase of = rolled(c);
    const auto constructed = climb([&]<class T>() { return wanted<T>(c, by_construction<T>(of)); });
    const auto analysed = climb([&]<class T>() { return wanted<T>(c, by_analysis<T>(of)); });
    for (std::size_t i = 0; i < c.references.size(); ++i)
      for (const Settled& found : {constructed[i], analysed[i]}) {
        const Reference& reference = c.references[i];
        INFO(reference.name << " " << reference.value << " by " << found.rung << " " << found.reason.english);
        if (!is_value(reference.value)) {
          CHECK(found.kind == Settled::Kind::absent);
          continue;
        }
        CHECK(found.kind == Settled::Kind::certain);
        CHECK(overlaps(found.enclosure, exact_decimal(reference.value)));
      }
  }
}

TEST_CASE("roulettes: doubles alone keep their digits at a cusp and beside it", "[roulettes]") {
  // What the construction multiplies together it knows to a few ulp; twenty of them for the longest chain.
  const double few_ulp = 20 * 0x1p-53;
  for (const CorpusCase& c : roulettes()) {
    if (c.name.find("cusp") == std::string::npos && c.name.find("_by_") == std::string::npos) continue;
    INFO(c.name);
    const auto found = by_construction<Fast>(rolled(c));
    for (const char* name : {"v", "a", "rho"}) {
      const Fast value = *found.at(name).value(), expected = from_rational<Fast>(exact_decimal(c.reference(name)));
      INFO(name);
      CHECK(std::fabs(value - expected) <= few_ulp * std::fabs(expected));
    }
  }
}
