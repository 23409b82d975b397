// The pad with the coefficients of the printed table, and with those of the theory; its rows; without side leakage,
// and with the friction of the nominal load. Formula by formula as the source goes, and from the power that is lost;
// what the theory says in closed form and by quadrature of Reynolds' equation.
#pragma once

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/kit/statement/given_number.h"
#include "exercises/michell-thrust/problem.h"
#include "exercises/michell-thrust/quantities.h"
#include "geometry/constructions/ordinate.h"

namespace epure::michell_thrust {

using geometry::quotient;
using geometry::root;
using geometry::square;

// n, A, k of a film, found when they are asked for.
template <class T>
struct Coefficients {
  std::function<T()> n, A, k;
};

inline Words off_the_table() {
  return format_words("the source's table has no row on one side of the pivot: it reaches from x_N/l = {} to {}",
                      "la tabella della fonte non ha righe da un lato della cerniera: va da x_N/l = {} a {}",
                      told_value(table_1().front().x_N_over_l), told_value(table_1().back().x_N_over_l));
}

inline const RowsBeside& rows_beside_pivot(const Problem& of) {
  if (!of.beside) throw geometry::Impossible(off_the_table());
  return *of.beside;
}

// Of the table, on the chord between two of its rows.
template <class T>
Coefficients<T> by_chord(const Problem& of) {
  const auto on_chord = [&of](const Rational TableRow::*what) {
    const auto point = [&](const TableRow& row) {
      return geometry::Point<T>{number<T>(row.x_N_over_l), number<T>(row.*what)};
    };
    const RowsBeside& rows = rows_beside_pivot(of);
    return geometry::ordinate(geometry::line(point(*rows.before), point(*rows.after)), number<T>(of.centre));
  };
  return {[=] { return on_chord(&TableRow::n); }, [=] { return on_chord(&TableRow::A); },
          [=] { return on_chord(&TableRow::k); }};
}
// The same as a mean with weights.
template <class T>
Coefficients<T> by_weights(const Problem& of) {
  const auto mean = [&of](const Rational TableRow::*what) {
    const auto [before, after] = rows_beside_pivot(of);
    const Rational width = after->x_N_over_l - before->x_N_over_l;
    const Rational far = (of.centre - before->x_N_over_l) / width, near = Rational(1) - far;
    return number<T>(near * (before->*what) + far * (after->*what));
  };
  return {[=] { return mean(&TableRow::n); }, [=] { return mean(&TableRow::A); }, [=] { return mean(&TableRow::k); }};
}

inline const Words& words_of_theory() {
  static const Words words{", by the theory", ", secondo la teoria"};
  return words;
}

struct Routes {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    const Bearing<T> bearing = Bearing<T>::as_the_source_goes(of), again = Bearing<T>::of_the_circle(of);
    as_the_source_goes(ledger, bearing);
    by_power(ledger, again);
    by_theory(ledger, bearing, again);
    return ledger;
  }

 private:
  // What all cases share.
  template <class T>
  struct Bearing {
    T R, z, b, N_p, mu, omega, v, l, c, c_prime;

    // For signs alone neither π nor what it takes part in is needed.
    static T round() {
      if constexpr (signs_only<T>)
        return T(3);
      else
        return geometry::pi<T>();
    }
    static T angular(const Angle& speed) {
      if constexpr (signs_only<T>)
        return T(1);
      else
        return geometry::radians<T>(speed);
    }
    T half_turn_in_degrees() const { return quotient(T(180), round()); }

    static Bearing as_the_source_goes(const Problem& of) {
      const T R = number<T>(of.R_m()), z = number<T>(of.pads), b = number<T>(of.b()), omega = angular(of.speed),
              l = quotient(T(2) * round() * R, z) - number<T>(of.d);
      return {.R = R,
              .z = z,
              .b = b,
              .N_p = number<T>(of.Q / of.pads),
              .mu = number<T>(of.mu),
              .omega = omega,
              .v = omega * R,
              .l = l,
              .c = quotient(b, b + l),
              .c_prime = root(quotient(T(4) * l + b, b))};
    }
    // All of it once more, of the circle that the pads stand on, and μ of a kilogram's weight, 9.80665 N.
    static Bearing of_the_circle(const Problem& of) {
      const Rational outer = of.D_e / 2, inner = of.D_i / 2, mean = inner + (outer - inner) / 2;
      const T R = number<T>(mean), z = number<T>(of.pads), b = number<T>(outer - inner), circle = T(2) * round() * R,
              l = quotient(circle - z * number<T>(of.d), z), slenderness = quotient(l, b);
      const T v = circle * turns(of.speed);
      return {.R = R,
              .z = z,
              .b = b,
              .N_p = quotient(number<T>(of.Q), z),
              .mu = number<T>(of.mu_in_kgf * Rational(980665, 100000)),
              .omega = quotient(v, R),
              .v = v,
              .l = l,
              .c = quotient(T(1), T(1) + slenderness),
              .c_prime = root(T(1) + T(4) * slenderness)};
    }
    static T turns(const Angle& speed) {
      if constexpr (signs_only<T>)
        return T(1);
      else
        return geometry::quotient_of<T>(speed, Angle{1});
    }
  };
  template <class T>
  struct Put {
    Ledger<T>& ledger;
    Quantity (*described)(const std::string&) = quantity;
    void operator()(const char* name, const std::function<T()>& find) const { ledger.put(described(name), find); }
  };

  // The load on a width, with or without leakage in the friction.
  template <class T>
  struct Load {
    T width, c_prime;
  };

  // h_2, h_1 and the tilt, as they are found; the angle at once or from its half.
  enum class Angles { whole, halves };
  template <class T>
  static void put_films(const Put<T>& put, const Bearing<T>& bearing, const std::function<T()>& h_2,
                        const std::function<T()>& h_1, Angles angles) {
    const T l = bearing.l, degrees = bearing.half_turn_in_degrees();
    const auto alpha = [=] {
      const T rise = h_1() - h_2();
      if (angles == Angles::whole) return slope_angle(geometry::Vector<T>{l, rise});
      return T(2) * slope_angle(geometry::Vector<T>{l + root(square(l) + square(rise)), rise});
    };
    put("h_2", h_2);
    put("h_1", h_1);
    put("alpha", alpha);
    put("alpha_deg", [=] { return alpha() * degrees; });
  }

  // f_m first, and the power last.
  template <class T>
  static void put_friction(const Put<T>& put, const Bearing<T>& at, const Load<T>& load,
                           const std::function<T()>& k) {
    const T N = quotient(at.N_p, load.width);
    const auto f_m = [=] { return k() * load.c_prime * root(quotient(at.mu * at.v, N)); };
    const auto T_p = [=] { return f_m() * N * load.width; };
    put("f_m", f_m);
    put("T", [=] { return f_m() * N; });
    put("T_p", T_p);
    put("M", [=] { return at.z * T_p() * at.R; });
    put("dissipated_power", [=] { return at.z * T_p() * at.R * at.omega; });
  }
  // The other way round: T_p = k c' √(μ v N_p width) is what the power is lost by.
  template <class T>
  void put_friction_by_power(const Put<T>& put, const Bearing<T>& at, const Load<T>& load,
                             const std::function<T()>& k) const {
    const T Q = number<T>(of.Q);
    const auto power = [=] { return k() * load.c_prime * at.z * at.v * root(at.mu * at.v * at.N_p * load.width); };
    put("dissipated_power", power);
    put("M", [=] { return quotient(power(), at.omega); });
    put("T_p", [=] { return quotient(power(), at.z * at.v); });
    put("T", [=] { return quotient(power(), at.z * at.v * load.width); });
    put("f_m", [=] { return quotient(power(), Q * at.v); });
  }

  template <class T>
  void as_the_source_goes(Ledger<T>& ledger, const Bearing<T>& at) const {
    const Put<T> put{ledger, on_the_chord};
    const Coefficients<T> table = by_chord<T>(of);
    const T b_eff = at.c * at.b, N = quotient(at.N_p, b_eff);
    put("R_m", [&] { return at.R; });
    put("omega", [&] { return at.omega; });
    put("v", [&] { return at.v; });
    put("b", [&] { return at.b; });
    put("l", [&] { return at.l; });
    put("N_p", [&] { return at.N_p; });
    put("p_m", [&] { return quotient(at.N_p, at.b * at.l); });
    put("c", [&] { return at.c; });
    put("b_eff", [&] { return b_eff; });
    put("N", [&] { return N; });
    put("mu", [&] { return at.mu; });
    put("n", table.n);
    put("A", table.A);
    put("A_n_minus_1_squared", [&] { return table.A() * square(table.n() - T(1)); });
    put("k", table.k);
    put("x_N", [&] { return number<T>(of.centre) * at.l; });
    put("c_prime", [&] { return at.c_prime; });
    const auto film = [&](const T& load) { return at.l * root(quotient(table.A() * at.mu * at.v, load)); };
    const auto films = [&](const Put<T>& put_all, const T& load) {
      put_films<T>(
          put_all, at, [=] { return film(load); }, [=] { return table.n() * film(load); }, Angles::whole);
    };
    films(put, N);
    put_friction<T>(put, at, {b_eff, at.c_prime}, table.k);
    begin_without_leakage(ledger);
    films({ledger, of_infinite_width}, quotient(at.N_p, at.b));
    put_friction<T>(put, at, {at.b, T(1)}, table.k);
    begin_nominal(ledger);
    put_friction<T>(put, at, {at.b, at.c_prime}, table.k);
    ledger.begin_case("");
  }

  template <class T>
  void by_power(Ledger<T>& ledger, const Bearing<T>& at) const {
    ledger.route("power balance");
    const Put<T> put{ledger, on_the_chord};
    const Coefficients<T> table = by_weights<T>(of);
    const T b_eff = at.c * at.b;
    put("R_m", [&] { return at.R; });
    put("omega", [&] { return at.omega; });
    put("v", [&] { return at.v; });
    put("b", [&] { return at.b; });
    put("l", [&] { return at.l; });
    put("N_p", [&] { return at.N_p; });
    put("p_m", [&] { return quotient(number<T>(of.Q), at.b * at.z * at.l); });
    put("c", [&] { return at.c; });
    put("b_eff", [&] { return b_eff; });
    put("N", [&] { return quotient(at.N_p * (at.b + at.l), square(at.b)); });
    put("mu", [&] { return at.mu; });
    put("n", table.n);
    put("A", table.A);
    put("A_n_minus_1_squared", [&] { return square(root(table.A()) * (table.n() - T(1))); });
    put("k", table.k);
    put("x_N", [&] { return quotient(at.l, T(2)) + number<T>(of.centre - Rational(1, 2)) * at.l; });
    put("c_prime", [&] { return at.c_prime; });
    const auto films = [&](const Put<T>& put_all, const T& width) {
      const auto h_2 = [=] { return root(quotient(table.A() * at.mu * at.v * square(at.l) * width, at.N_p)); };
      put_films<T>(
          put_all, at, h_2, [=] { return h_2() + (table.n() - T(1)) * h_2(); }, Angles::halves);
    };
    films(put, b_eff);
    put_friction_by_power<T>(put, at, {b_eff, at.c_prime}, table.k);
    begin_without_leakage(ledger);
    films({ledger, of_infinite_width}, at.b);
    put_friction_by_power<T>(put, at, {at.b, T(1)}, table.k);
    begin_nominal(ledger);
    put_friction_by_power<T>(put, at, {at.b, at.c_prime}, table.k);
    ledger.begin_case("");
  }

  // The rows of the table, and the pad with the exact coefficients.
  template <class T>
  void by_theory(Ledger<T>& ledger, const Bearing<T>& at, const Bearing<T>& again) const {
    ledger.route("closed form");
    for (const auto& [name, n] : rows_of_theory()) {
      begin_row(ledger, name, n);
      const geometry::FlatSlider<T> slider{number<T>(n)};
      ledger.tells(quantity("n"), [&] { return slider.n; });
      put_row<T>(ledger, n, {{}, [&] { return slider.load(); }, [&] { return slider.friction(); }},
                 [&] { return slider.centre(); });
    }
    ledger.route("quadrature");
    for (const auto& [name, n] : rows_of_theory()) {
      begin_row(ledger, name, n);
      const geometry::analytic::FilmByQuadrature<T> by_t(number<T>((n - 1) / (n + 1)));
      put_row<T>(ledger, n, coefficients(by_t), [&] { return quotient(T(1) + by_t.centre(), T(2)); });
    }
    by_theory_in_closed_form(ledger, at);
    by_theory_by_quadrature(ledger, again);
  }

  template <class T>
  static Coefficients<T> coefficients(const geometry::analytic::FilmByQuadrature<T>& by_t) {
    return {[&] { return by_t.ratio(); }, [&] { return by_t.load(); },
            // T/√(μ v N) with the mean film for unit of length
            [&] {
              return quotient(by_t.drag_on_moving(),
                              root(number<T>(Rational(3, 2)) * by_t.epsilon() * by_t.inertia()));
            }};
  }

  template <class T>
  void by_theory_in_closed_form(Ledger<T>& ledger, const Bearing<T>& at) const {
    const T b_eff = at.c * at.b, N = quotient(at.N_p, b_eff);
    const Put<T> put{ledger};
    ledger.route("closed form");
    ledger.begin_case("theory.", words_of_theory());
    const auto n = once([&] { return geometry::ratio_of_films<T>(of.centre); });
    const auto A = once([&] { return geometry::FlatSlider<T>{n()}.load(); });
    const auto k = once([&] { return geometry::FlatSlider<T>{n()}.friction(); });
    const auto h_2 = once([&] { return at.l * root(quotient(A() * at.mu * at.v, N)); });
    const auto wedge = [&] { return geometry::FilmWedge<T>{at.l, at.v, at.mu, n() * h_2(), h_2()}; };
    put("n", [&] { return n(); });
    put("A", [&] { return A(); });
    put("k", [&] { return k(); });
    put_films<T>(
        put, at, [&] { return h_2(); }, [&] { return n() * h_2(); }, Angles::whole);
    put_friction<T>(put, at, {b_eff, at.c_prime}, [&] { return k(); });
    put("h_p_max", [&] { return wedge().h_bar(); });
    put("x_p_max", [&] { return wedge().x_bar(); });
    put("p_max", [&] {
      return quotient(T(3) * at.mu * at.v * at.l * (n() - T(1)), T(2) * square(h_2()) * n() * (n() + T(1)));
    });
    const auto pressure = [&](int quarters) { return wedge().pressure(quotient(T(quarters) * at.l, T(4))); };
    put("p_1_4", [&] { return pressure(1); });
    put("p_1_2", [&] { return pressure(2); });
    put("p_3_4", [&] { return pressure(3); });
  }

  template <class T>
  void by_theory_by_quadrature(Ledger<T>& ledger, const Bearing<T>& at) const {
    const T b_eff = at.c * at.b, N = quotient(at.N_p, b_eff);
    const Put<T> put{ledger};
    ledger.route("quadrature");
    using Film = geometry::analytic::ReynoldsFilm<T>;
    const auto film = once([&] {
      const geometry::analytic::FilmByQuadrature<T> by_t(geometry::analytic::wedge_of_centre<T>(of.centre));
      return Film{at.l, at.v, at.mu, geometry::analytic::film_of_load(by_t, at.l, at.v, at.mu, N), by_t};
    });
    const auto k = [&] { return coefficients(film().by_t).k(); };
    put("n", [&] { return film().by_t.ratio(); });
    put("A", [&] { return film().by_t.load(); });
    put("k", k);
    put_films<T>(
        put, at, [&] { return film().h(at.l); }, [&] { return film().h(T(0)); }, Angles::halves);
    put_friction_by_power<T>(put, at, {b_eff, at.c_prime}, k);
    const auto x_bar = [&] { return film().x_of(film().centroid()); };
    put("h_p_max", [&] { return film().h(x_bar()); });
    put("x_p_max", x_bar);
    put("p_max", [&] { return film().greatest_pressure(); });
    const auto pressure = [&](int quarters) { return film().pressure(number<T>(Rational(quarters, 4)) * at.l); };
    put("p_1_4", [&] { return pressure(1); });
    put("p_1_2", [&] { return pressure(2); });
    put("p_3_4", [&] { return pressure(3); });
    ledger.begin_case("");
  }

  static std::vector<std::pair<std::string, Rational>> rows_of_theory() {
    std::vector<std::pair<std::string, Rational>> all;
    for (const TableRow& row : table_1()) {
      all.emplace_back(row.name, row.n);
      if (row.name == "1_8") all.emplace_back("1_9", Rational(19, 10));
    }
    return all;
  }
  template <class T>
  static void begin_row(Ledger<T>& ledger, const std::string& name, const Rational& n) {
    ledger.begin_case("table_n_" + name + ".", Words{" for n = ", " per n = "} + decimal(CGAL::to_double(n), 2));
  }
  template <class T>
  static void put_row(Ledger<T>& ledger, const Rational& n, const Coefficients<T>& coefficients,
                      const std::function<T()>& centre) {
    const Put<T> put{ledger};
    put("A", coefficients.A);
    put("A_n_minus_1_squared", [&] { return coefficients.A() * number<T>((n - 1) * (n - 1)); });
    put("x_N_over_l", centre);
    put("k", coefficients.k);
  }
  template <class T>
  static void begin_without_leakage(Ledger<T>& ledger) {
    ledger.begin_case("no_side_leakage.", {", without side leakage", ", senza fuoriuscite laterali"});
  }
  template <class T>
  static void begin_nominal(Ledger<T>& ledger) {
    ledger.begin_case("nominal_load.",
                      {", with the load on the actual width", ", col carico sulla larghezza effettiva"});
  }
};

}  // namespace epure::michell_thrust
