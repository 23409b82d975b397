#include "exercises/point-mass/problem.h"
#include "exercises/kit/statement/given_number.h"

#include "exercises/kit/statement/decimal.h"

namespace epure::point_mass {
namespace {

constexpr long most_rows = 2000, most_strips = 200;

GivenSpec given(const char* symbol, const Words& meaning, const char* unit, const char* stated, const char* letters,
                Range range = Range::positive) {
  return {symbol, meaning, unit, stated, range, letters};
}

void demand_in_order(const Problem& of) {
  for (int i = 0; i < 2; ++i)
    if (of.t[i] >= of.t[i + 1])
      throw BadGivens(format_words(
          "t_{} = {} s must be before t_{} = {} s: the instants follow one another, and the last ends the diagrams",
          "t_{} = {} s deve precedere t_{} = {} s: gli istanti si susseguono, e l'ultimo chiude i diagrammi", i + 1,
          told_value(of.t[i]), i + 2, told_value(of.t[i + 1])));
}

void demand_rows(const Problem& of) {
  const Rational rows = of.end() / of.dt;
  if (rows > most_rows)
    throw BadGivens(format_words("dt = {} s makes a table of {} rows from 0 to t_3 = {} s: at most {} are made",
                                 "dt = {} s dà una tabella di {} righe da 0 a t_3 = {} s: se ne fanno al più {}",
                                 told_value(of.dt), told_value(rows), told_value(of.end()), most_rows));
  if (rows.denominator() != 1)
    throw BadGivens(format_words(
        "dt = {} s does not divide the interval from 0 to t_3 = {} s into whole steps: it makes {} of them",
        "dt = {} s non divide l'intervallo da 0 a t_3 = {} s in passi interi: ne fa {}", told_value(of.dt),
        told_value(of.end()), told_value(rows)));
  if (rows < 2)
    throw BadGivens(format_words(
        "dt = {} s must be at most half of t_3 = {} s: Cavalieri-Simpson's formula takes two steps at a time",
        "dt = {} s deve essere al più la metà di t_3 = {} s: la formula di Cavalieri-Simpson prende due passi alla "
        "volta",
        told_value(of.dt), told_value(of.end())));
  if (of.end() / of.strip > most_strips)
    throw BadGivens(format_words("strip = {} s makes {} strips from 0 to t_3 = {} s: at most {} are drawn",
                                 "strip = {} s dà {} strisce da 0 a t_3 = {} s: se ne disegnano al più {}",
                                 told_value(of.strip), told_value(of.end() / of.strip), told_value(of.end()),
                                 most_strips));
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  const auto worth = [](const char* symbol, const Words& of, const char* unit, const char* stated,
                        const char* letters) {
    return given(
        symbol,
        Words{"what a centimetre of the diagram is worth: ", "quanto vale un centimetro del diagramma: "} + of, unit,
        stated, letters);
  };
  return {
      given("m", {"mass of the body", "massa del corpo"}, "kg", "50", "$m$"),
      given("A", {"coefficient of t^3 in the force", "coefficiente di t^3 nella forza"}, "N/s^3", "0.32", "$\\it{A}$",
            Range::any),
      given("B", {"coefficient of t^2 in the force", "coefficiente di t^2 nella forza"}, "N/s^2", "-10.4",
            "$\\it{B}$", Range::any),
      given("C", {"coefficient of t in the force", "coefficiente di t nella forza"}, "N/s", "80", "$\\it{C}$",
            Range::any),
      given("t_1", {"first instant", "primo istante"}, "s", "5", "$t_{1}$"),
      given("t_2", {"second instant", "secondo istante"}, "s", "14", "$t_{2}$"),
      given("t_3", {"third instant, where the diagrams end", "terzo istante, dove i diagrammi finiscono"}, "s", "20",
            "$t_{3}$"),
      given("dt", {"step of the tables", "passo delle tabelle"}, "s", "0.1", "Δ$t$"),
      given("strip",
            {"width of the strips of the graphical integration", "larghezza delle strisce dell'integrazione grafica"},
            "s", "1", "Δ$t_{g}$"),
      worth("cm_t", {"time", "tempo"}, "s", "1", "$u_{t}$"),
      worth("cm_a", {"acceleration", "accelerazione"}, "m/s^2", "0.5", "$u_{a}$"),
      worth("cm_v", {"velocity", "velocità"}, "m/s", "5", "$u_{v}$"),
      worth("cm_s", {"space", "spazio"}, "m", "50", "$u_{s}$"),
  };
}

Problem::Problem(const Givens& givens)
    : m(givens["m"]),
      A(givens["A"]),
      B(givens["B"]),
      C(givens["C"]),
      t{givens["t_1"], givens["t_2"], givens["t_3"]},
      dt(givens["dt"]),
      strip(givens["strip"]),
      cm_t(givens["cm_t"]),
      cm_a(givens["cm_a"]),
      cm_v(givens["cm_v"]),
      cm_s(givens["cm_s"]) {
  demand_in_order(*this);
  demand_rows(*this);
}

long Problem::rows() const { return static_cast<long>(CGAL::to_double(end() / dt)); }

std::optional<long> Problem::row(const Rational& at) const {
  const Rational i = at / dt;
  if (at > end() || i.denominator() != 1) return {};
  return static_cast<long>(CGAL::to_double(i));
}

// The last may be narrower.
std::vector<Rational> Problem::strip_ends() const {
  std::vector<Rational> ends;
  for (Rational at = 0; at < end(); at += strip) ends.push_back(at);
  ends.push_back(end());
  return ends;
}

Quadratic::Quadratic(const Rational& square, const Rational& linear, const Rational& constant, const Rational& end)
    : a(square), b(linear), c(constant) {
  using geometry::Polynomial;
  if (a == 0 && b == 0) return;
  const Polynomial t = Polynomial::indeterminate();
  for (const geometry::RealRoot& root : (Polynomial(a) * t * t + Polynomial(b) * t + Polynomial(c)).real_roots()) {
    const auto sign = [&](const Rational& factor, const Rational& term) {
      return root.sign_of([&](const auto& x) {
        using T = std::decay_t<decltype(x)>;
        return T(geometry::from_rational<T>(factor) * x + geometry::from_rational<T>(term));
      });
    };
    if (sign(1, 0) != geometry::Sign::positive || sign(1, -end) != geometry::Sign::negative) continue;
    const geometry::Sign slope = sign(2 * a, b);
    if (slope == geometry::Sign::negative) falling = Crossing{root, true};
    if (slope == geometry::Sign::positive) rising = Crossing{root, false};
  }
}

}  // namespace epure::point_mass
