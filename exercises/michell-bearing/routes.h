// The film by the closed form and by quadrature of Reynolds' equation; Bezout's table by graphical integration of the
// gradients and by sums of them; the resultant of strips by the funicular polygon and by moments.
#pragma once

#include <functional>
#include <memory>

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/michell-bearing/problem.h"
#include "exercises/michell-bearing/quantities.h"
#include "geometry/analytic/reynolds.h"
#include "geometry/constructions/graphical_integral.h"
#include "geometry/statics/funicular.h"

namespace epure::michell_bearing {

using geometry::quotient;
using geometry::root;
using geometry::square;

// The greater of two, bounded also where it cannot be told which that is.
template <class T>
T greater(const T& a, const T& b) {
  switch (geometry::sign(a - b)) {
    case geometry::Sign::negative:
      return b;
    case geometry::Sign::undecided:
      return geometry::from_rational<T>(Rational(1, 2)) * (a + b + root(square(a - b)));
    default:
      return a;
  }
}

// A section and what is put down of it; the one at x_N is known by each route as it finds it.
template <class T>
struct Section {
  std::string name;
  std::function<T()> x;
};

inline const Phrase off_the_pad{"the film ends before this section", "il meato finisce prima di questa sezione"};
inline const Phrase above_the_film{"the film is thinner than this depth", "il meato è più sottile di questa quota"};
inline const Phrase off_the_grid{"it is no point of the grid", "non è un punto della griglia"};
inline const Phrase no_zero_shear{"h_1 is less than 2 h_2: the shear is zero nowhere on the wall",
                                  "h_1 è minore di 2 h_2: lo sforzo non si annulla in nessun punto della parete"};

struct InverseRoutes {
  const Film& film;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    ledger.begin_case("inverse.", {" (inverse problem)", " (problema inverso)"});
    by_closed_form(ledger);
    by_graphical_integration(ledger);
    by_quadrature(ledger);
    return ledger;
  }

 private:
  static constexpr int strips_of_load = 8;

  Rational middle_of_strip(int i) const { return film.l * Rational(2 * i + 1, 2 * strips_of_load); }
  // Number of the grid's point, or -1.
  long on_grid(const Rational& x) const {
    const Rational i = x / film.dx;
    return x > film.l || i.denominator() != 1 ? -1 : static_cast<long>(CGAL::to_double(i));
  }

  // h, p', p at the table's stations; with the velocities and shears at the three sections. `of` knows
  // gradient(x), pressure(x), h(x), velocity(x, z), shear_on_fixed(x), shear_on_moving(x).
  template <class T, class Of>
  void put_sections(Ledger<T>& ledger, const Of& of, const std::function<T()>& x_N) const {
    for (const Station& at : stations()) {
      const auto put = [&](const char* what, const std::function<T(const T&)>& find) {
        ledger.put(at_station(what, at.name), [&] {
          if (at.x > film.l) throw geometry::Impossible(off_the_pad);
          return find(number<T>(at.x));
        });
      };
      put("h", [&](const T& x) { return of.h(x); });
      put("dp_dx", [&](const T& x) { return of.gradient(x); });
      if (at.x != 0 && at.name != "0p40") put("p", [&](const T& x) { return of.pressure(x); });
    }
    const std::vector<Section<T>> sections{
        {"x_1", [&] { return number<T>(film.x_1); }}, {"x_2", x_N}, {"x_3", [&] { return number<T>(film.x_3); }}};
    for (const Section<T>& at : sections) put_section(ledger, of, at);
  }

  template <class T, class Of>
  void put_section(Ledger<T>& ledger, const Of& of, const Section<T>& at) const {
    const std::string& name = at.name;
    ledger.put(at_station("h", name), [&] { return of.h(at.x()); });
    ledger.put(at_station("dp_dx", name), [&] { return of.gradient(at.x()); });
    ledger.put(at_station("p", name), [&] { return of.pressure(at.x()); });
    const std::size_t shown = name == "x_1" ? 6 : name == "x_2" ? 5 : 3;  // of the depths
    for (std::size_t i = 0; i < shown; ++i) {
      const Depth& depth = depths()[i];
      ledger.put(velocity_at(name, depth.name), [&] {
        demand_within_film(name, depth.z, of, at);
        return of.velocity(at.x(), number<T>(depth.z));
      });
    }
    ledger.put(velocity_at(name, mid_film), [&] {
      const T x = at.x();
      return of.velocity(x, quotient(of.h(x), T(2)));
    });
    ledger.put(at_station("tau_0", name), [&] { return of.shear_on_fixed(at.x()); });
    ledger.put(at_station("tau_h", name), [&] { return of.shear_on_moving(at.x()); });
  }

  // Where x is given, so is h; at x_N it is transcendental and never equal to a depth.
  template <class T, class Of>
  void demand_within_film(const std::string& name, const Rational& z, const Of& of, const Section<T>& at) const {
    geometry::Sign above;
    if (name == "x_2")
      above = geometry::sign(of.h(at.x()) - number<T>(z));
    else
      above = film.h(name == "x_1" ? film.x_1 : film.x_3) >= z ? geometry::Sign::positive : geometry::Sign::negative;
    if (above == geometry::Sign::undecided)
      throw geometry::Undecided("whether the film reaches a depth", "se il meato arrivi a una quota");
    if (above == geometry::Sign::negative) throw geometry::Impossible(above_the_film);
  }

  template <class T>
  void by_closed_form(Ledger<T>& ledger) const {
    const geometry::FilmWedge<T> wedge = film.wedge<T>();
    const geometry::FlatSlider<T> slider{number<T>(film.n())};
    const auto put = [&](const char* name, const std::function<T()>& find) { ledger.put(film_quantity(name), find); };
    const T drag_unit = quotient(wedge.mu * wedge.V * wedge.l, wedge.h2);  // μ V l/h2
    const auto N = once([&] { return slider.load() * drag_unit * quotient(wedge.l, wedge.h2); });
    const auto x_N = once([&] { return slider.centre() * wedge.l; });
    const auto T_moving = [&] { return slider.drag() * drag_unit; };
    const auto p_max = [&] {
      return quotient(T(3) * wedge.mu * wedge.V * wedge.l * (wedge.h1 - wedge.h2),
                      T(2) * wedge.h1 * wedge.h2 * (wedge.h1 + wedge.h2));
    };
    put("n", [&] { return slider.n; });
    put("h_bar", [&] { return wedge.h_bar(); });
    put("x_bar", [&] { return wedge.x_bar(); });
    put("p_max", p_max);
    put("A", [&] { return slider.load(); });
    put("N", [&] { return N(); });
    put("x_N", [&] { return x_N(); });
    put("T", T_moving);
    put("T_fixed", [&] { return slider.drag_on_fixed() * drag_unit; });
    put("f_m", [&] { return quotient(T_moving(), N()); });
    put("p_mean", [&] { return quotient(N(), wedge.l); });
    put("p_max_over_p_mean", [&] { return quotient(p_max() * wedge.l, N()); });
    put("flow_rate", [&] { return wedge.flow(); });
    put("power_loss", [&] { return T_moving() * wedge.V; });
    const auto zero_shear = [&](int numerator, int denominator) {
      if (!film.has_zero_shear()) throw geometry::Impossible(no_zero_shear);
      return wedge.x_of(number<T>(Rational(numerator, denominator)) * wedge.h_bar());
    };
    put("x_shear_zero_fixed", [&] { return zero_shear(3, 2); });
    put("x_shear_zero_moving", [&] { return zero_shear(3, 4); });
    put_sections<T>(ledger, wedge, [&] { return x_N(); });

    ledger.route("funicular polygon");
    const auto polygon = once([&] {
      std::vector<geometry::VerticalForce<T>> forces;
      T sum(0);
      for (int i = 0; i < strips_of_load; ++i) {
        const T x = number<T>(middle_of_strip(i));
        forces.push_back({x, wedge.pressure(x) * quotient(wedge.l, T(strips_of_load))});
        sum += forces.back().up;
      }
      return geometry::funicular<T>(forces, {sum, T(0)}, {T(0), T(0)});
    });
    put("N_funicular", [&] { return polygon().corners.back(); });
    put("x_N_funicular", [&] { return finite(meet(polygon().strings.front(), polygon().strings.back())).x; });
  }

  // Strip after strip, with the mean of the gradients at its ends for slope.
  template <class T>
  void by_graphical_integration(Ledger<T>& ledger) const {
    ledger.route("graphical integration");
    const geometry::FilmWedge<T> wedge = film.wedge<T>();
    const T half_step = number<T>(film.dx / 2);
    const auto pressures = once([&] {
      std::vector<T> stations, gradients, all;
      for (long i = 0; i <= film.strips; ++i) {
        stations.push_back(number<T>(film.dx * Rational(i)));
        gradients.push_back(wedge.gradient(stations.back()));
      }
      for (const auto& corner :
           geometry::graphical_integral<T>(stations, geometry::means_of_ends(gradients), T(1)).corners)
        all.push_back(corner.y);
      return all;
    });
    put_bezout<T>(ledger, [&](long i) { return pressures().at(static_cast<std::size_t>(i)); });
    ledger.put(film_quantity("p_max_bezout"), [&] { return greatest(pressures()); });
    const auto trapezoids = [&](const std::function<T(long)>& ordinate) {
      T sum(0);
      for (long i = 1; i <= film.strips; ++i) sum += half_step * (ordinate(i - 1) + ordinate(i));
      return sum;
    };
    const auto p = [&](long i) { return pressures().at(static_cast<std::size_t>(i)); };
    ledger.put(film_quantity("N_bezout"), [&] { return trapezoids(p); });
    ledger.put(film_quantity("x_N_bezout"), [&] {
      return quotient(trapezoids([&](long i) { return number<T>(film.dx * Rational(i)) * p(i); }), trapezoids(p));
    });
  }

  template <class T>
  static T greatest(const std::vector<T>& of) {
    T most = of.front();
    for (const T& each : of) most = greater(most, each);
    return most;
  }

  template <class T>
  void put_bezout(Ledger<T>& ledger, const std::function<T(long)>& pressure) const {
    for (const Station& at : stations()) {
      if (at.x == 0) continue;
      ledger.put(at_station("p_bezout", at.name), [&] {
        if (at.x > film.l) throw geometry::Impossible(off_the_pad);
        const long i = on_grid(at.x);
        if (i < 0) throw geometry::Impossible(off_the_grid);
        return pressure(i);
      });
    }
  }

  template <class T>
  void by_quadrature(Ledger<T>& ledger) const {
    ledger.route("quadrature");
    const geometry::analytic::ReynoldsFilm<T> reynolds = film.reynolds<T>();
    const auto& by_t = reynolds.by_t;
    const auto put = [&](const char* name, const std::function<T()>& find) { ledger.put(film_quantity(name), find); };
    const T& epsilon = by_t.epsilon();
    const T drag_unit = quotient(reynolds.mu * reynolds.V * reynolds.l, reynolds.h_m);  // μ V l/h_m
    const auto N = once([&] {
      return number<T>(Rational(3, 2)) * epsilon * by_t.inertia() * drag_unit * quotient(reynolds.l, reynolds.h_m);
    });
    const auto x_N = once([&] { return reynolds.x_of(by_t.centre()); });
    const auto T_moving = once([&] { return by_t.drag_on_moving() * drag_unit; });
    const auto p_max = once([&] { return reynolds.greatest_pressure(); });
    put("n", [&] { return by_t.ratio(); });
    put("h_bar", [&] { return reynolds.h_m * reynolds.share(reynolds.centroid()); });
    put("x_bar", [&] { return reynolds.x_of(reynolds.centroid()); });
    put("p_max", [&] { return p_max(); });
    put("A", [&] { return by_t.load(); });
    put("N", [&] { return N(); });
    put("x_N", [&] { return x_N(); });
    put("T", [&] { return T_moving(); });
    put("T_fixed", [&] { return by_t.drag_on_fixed() * drag_unit; });
    put("f_m", [&] { return quotient(T_moving(), N()); });
    put("p_mean", [&] { return quotient(N(), reynolds.l); });
    // N/l in the unit of pressures is Q/2.
    put("p_max_over_p_mean", [&] { return quotient(T(2) * by_t.pressure(reynolds.centroid()), by_t.inertia()); });
    // What passes at the inlet.
    put("flow_rate", [&] {
      const T h1 = number<T>(film.h_1);
      return quotient(reynolds.V * h1, T(2)) -
             quotient(square(h1) * h1 * reynolds.gradient(T(0)), T(12) * reynolds.mu);
    });
    put("power_loss", [&] { return by_t.dissipated() * drag_unit * reynolds.V; });
    const auto zero_shear = [&](const std::function<T()>& t) {
      if (!film.has_zero_shear()) throw geometry::Impossible(no_zero_shear);
      return reynolds.x_of(t());
    };
    put("x_shear_zero_fixed", [&] {
      return zero_shear([&] { return quotient(T(3) * epsilon * reynolds.centroid() - T(1), T(2) * epsilon); });
    });
    put("x_shear_zero_moving", [&] {
      return zero_shear([&] { return quotient(T(3) * epsilon * reynolds.centroid() + T(1), T(4) * epsilon); });
    });
    put_sections<T>(ledger, reynolds, [&] { return x_N(); });
    by_sums<T>(ledger, reynolds);
  }

  // Bezout's table once more: what each gradient adds to the sums.
  template <class T>
  void by_sums(Ledger<T>& ledger, const geometry::analytic::ReynoldsFilm<T>& reynolds) const {
    ledger.route("sums");
    const auto gradients = once([&] {
      std::vector<T> all;
      for (long i = 0; i <= film.strips; ++i) all.push_back(reynolds.gradient(number<T>(film.dx * Rational(i))));
      return all;
    });
    // Σ weight(i) p'_i, the weights being exact.
    const auto sum = [&](const std::function<Rational(long)>& weight) {
      T total(0);
      for (long i = 0; i <= film.strips; ++i)
        if (const Rational share = weight(i); share != 0)
          total += number<T>(share) * gradients().at(static_cast<std::size_t>(i));
      return total;
    };
    const long m = film.strips;
    const Rational half_step = film.dx / 2;
    // Strip j between j - 1 and j counts `of_strip(j)` times.
    const auto by_strips = [&](const std::function<Rational(long)>& of_strip) {
      return sum([&](long i) {
        return half_step * ((i > 0 ? of_strip(i) : Rational(0)) + (i < m ? of_strip(i + 1) : Rational(0)));
      });
    };
    const auto pressure = [&](long i) { return by_strips([i](long j) { return Rational(j <= i ? 1 : 0); }); };
    put_bezout<T>(ledger, pressure);
    ledger.put(film_quantity("p_max_bezout"), [&] {
      std::vector<T> all;
      for (long i = 0; i <= m; ++i) all.push_back(pressure(i));
      return greatest(all);
    });
    const auto load = [&] { return by_strips([&](long j) { return film.dx * (Rational(m - j) + Rational(1, 2)); }); };
    ledger.put(film_quantity("N_bezout"), load);
    ledger.put(film_quantity("x_N_bezout"), [&] {
      return quotient(by_strips([&](long j) { return film.dx * film.dx * Rational(m * m - j * j + j) / 2; }), load());
    });
    ledger.route("moments");
    const auto strips = [&](bool with_arm) {
      T total(0);
      for (int i = 0; i < strips_of_load; ++i) {
        const T x = number<T>(middle_of_strip(i)), force = reynolds.pressure(x) * number<T>(film.l / strips_of_load);
        total += with_arm ? x * force : force;
      }
      return total;
    };
    ledger.put(film_quantity("N_funicular"), [&] { return strips(false); });
    ledger.put(film_quantity("x_N_funicular"), [&] { return quotient(strips(true), strips(false)); });
  }
};

struct DirectRoutes {
  const Pad& pad;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    ledger.begin_case("direct.", {" (direct problem)", " (problema diretto)"});
    by_closed_form(ledger);
    by_quadrature(ledger);
    return ledger;
  }

 private:
  // At least the film allowed?
  template <class T>
  static T is_enough(const T& margin) {
    switch (geometry::sign(margin - T(1))) {
      case geometry::Sign::undecided:
        throw geometry::Undecided("whether the film is at least the one allowed",
                                  "se il meato sia almeno quello di riferimento");
      case geometry::Sign::negative:
        return T(0);
      default:
        return T(1);
    }
  }
  template <class T>
  struct Put {
    Ledger<T>& ledger;
    void operator()(const char* name, const std::function<T()>& find) const { ledger.put(pad_quantity(name), find); }
  };

  template <class T>
  void by_closed_form(Ledger<T>& ledger) const {
    const Put<T> put{ledger};
    const T P = number<T>(pad.P), z = number<T>(pad.pads), r = number<T>(pad.r_m), l = number<T>(pad.l),
            b = number<T>(pad.b), mu = number<T>(pad.mu), h_ref = number<T>(pad.h_ref);
    const auto omega = [&] { return geometry::radians<T>(pad.speed); };
    const T N = quotient(P, z * b);
    const auto V = once([&] { return omega() * r; });
    const auto n = once([&] { return geometry::ratio_of_films<T>(pad.centre()); });
    const auto A = once([&] { return geometry::FlatSlider<T>{n()}.load(); });
    const auto k = once([&] { return geometry::FlatSlider<T>{n()}.friction(); });
    const auto unit = once([&] { return root(quotient(mu * V(), N)); });  // √(μ V/N)
    const auto h_2 = once([&] { return l * root(A()) * unit(); });
    const auto f_m = once([&] { return k() * unit(); });
    const T c = quotient(b + l, b), c_prime = root(quotient(b + T(4) * l, b));
    const auto h_2_side = [&] { return l * root(quotient(A() * mu * V(), c * N)); };
    const auto wedge = [&] { return geometry::FilmWedge<T>{l, V(), mu, n() * h_2(), h_2()}; };
    put("omega", omega);
    put("V", [&] { return V(); });
    put("N", [&] { return N; });
    put("l", [&] { return l; });
    put("x_N_over_l", [&] { return number<T>(pad.centre()); });
    put("n", [&] { return n(); });
    put("A", [&] { return A(); });
    put("k", [&] { return k(); });
    put("h_2", [&] { return h_2(); });
    put("h_1", [&] { return n() * h_2(); });
    put("tilt", [&] { return quotient((n() - T(1)) * h_2(), l); });
    put("f_m", [&] { return f_m(); });
    put("T", [&] { return f_m() * N; });
    put("p_mean", [&] { return quotient(N, l); });
    put("p_max",
        [&] { return quotient(T(3) * mu * V() * l * (n() - T(1)), T(2) * square(h_2()) * n() * (n() + T(1))); });
    put("x_bar", [&] { return wedge().x_bar(); });
    put("c", [&] { return c; });
    put("c_prime", [&] { return c_prime; });
    put("N_side_leakage", [&] { return quotient(N, c); });
    put("h_2_side_leakage", h_2_side);
    put("f_m_side_leakage", [&] { return c_prime * f_m(); });
    put("film_margin", [&] { return quotient(h_2(), h_ref); });
    put("film_margin_side_leakage", [&] { return quotient(h_2_side(), h_ref); });
    put("hydrodynamic", [&] { return is_enough<T>(quotient(h_2(), h_ref)); });
    put("hydrodynamic_side_leakage", [&] { return is_enough<T>(quotient(h_2_side(), h_ref)); });
    put("friction_torque", [&] { return f_m() * P * r; });
    put("power_loss", [&] { return f_m() * P * V(); });
    put("R_outer", [&] { return r + quotient(b, T(2)); });
    put("R_inner", [&] { return r - quotient(b, T(2)); });
    put("pitch", [&] { return quotient(T(2) * geometry::pi<T>() * r, z); });
    put("gap", [&] { return quotient(T(2) * geometry::pi<T>() * r, z) - l; });
  }

  // In the terms of geometry/analytic/reynolds.h.
  template <class T>
  void by_quadrature(Ledger<T>& ledger) const {
    ledger.route("quadrature");
    const Put<T> put{ledger};
    const T z = number<T>(pad.pads), l = number<T>(pad.l), b = number<T>(pad.b), mu = number<T>(pad.mu);
    const T slenderness = number<T>(pad.l / pad.b);
    const auto circle = [&] { return geometry::pi<T>() * number<T>(Rational(2) * pad.r_m); };
    const auto V = once([&] { return circle() * geometry::quotient_of<T>(pad.speed, Angle{1}); });
    const T N = number<T>(pad.P / pad.pads / pad.b);
    const auto film = once([&] {
      return geometry::analytic::FilmByQuadrature<T>(geometry::analytic::wedge_of_centre<T>(pad.centre()));
    });
    const auto epsilon = [&] { return film().epsilon(); };
    const auto h_m = once(
        [&] { return l * root(quotient(number<T>(Rational(3, 2)) * epsilon() * film().inertia() * mu * V(), N)); });
    const auto h_2 = [&] { return h_m() * (T(1) - epsilon()); };
    const auto h_2_side = [&] { return quotient(h_2(), root(T(1) + slenderness)); };
    const auto friction = once([&] { return film().drag_on_moving() * quotient(mu * V() * l, h_m()); });
    const auto pressure_unit = [&] { return quotient(T(3) * mu * V() * l * epsilon(), square(h_m())); };
    const auto margin = [&](const T& least) { return least * number<T>(Rational(1) / pad.h_ref); };
    put("omega", [&] { return quotient(V(), number<T>(pad.r_m)); });
    put("V", [&] { return V(); });
    put("N", [&] { return N; });
    const auto centre = [&] { return quotient(T(1) + film().centre(), T(2)); };
    put("l", [&] { return quotient(number<T>(pad.x_N), centre()); });
    put("x_N_over_l", centre);
    put("n", [&] { return film().ratio(); });
    put("A", [&] { return film().load(); });
    put("k", [&] { return quotient(friction(), root(mu * V() * N)); });
    put("h_2", h_2);
    put("h_1", [&] { return h_m() * (T(1) + epsilon()); });
    put("tilt", [&] { return quotient(T(2) * h_m() * epsilon(), l); });
    put("f_m", [&] { return quotient(friction(), N); });
    put("T", [&] { return friction(); });
    put("p_mean", [&] { return number<T>(pad.P / (pad.pads * pad.b * pad.l)); });
    put("p_max", [&] { return pressure_unit() * film().pressure(film().centroid()); });
    put("x_bar", [&] { return quotient(l * (T(1) + film().centroid()), T(2)); });
    put("c", [&] { return T(1) + slenderness; });
    put("c_prime", [&] { return root(T(1) + T(4) * slenderness); });
    put("N_side_leakage", [&] { return number<T>(pad.P / (pad.pads * (pad.b + pad.l))); });
    put("h_2_side_leakage", h_2_side);
    put("f_m_side_leakage", [&] { return root(square(quotient(friction(), N)) * (T(1) + T(4) * slenderness)); });
    put("film_margin", [&] { return margin(h_2()); });
    put("film_margin_side_leakage", [&] { return margin(h_2_side()); });
    put("hydrodynamic", [&] { return is_enough<T>(margin(h_2())); });
    put("hydrodynamic_side_leakage", [&] { return is_enough<T>(margin(h_2_side())); });
    // Of what becomes heat in all films.
    const auto power = once([&] { return z * b * film().dissipated() * quotient(mu * square(V()) * l, h_m()); });
    put("friction_torque", [&] { return quotient(power() * number<T>(pad.r_m), V()); });
    put("power_loss", [&] { return power(); });
    put("R_outer", [&] { return number<T>(pad.r_m + pad.b / 2); });
    put("R_inner", [&] { return number<T>(pad.r_m - pad.b / 2); });
    put("pitch", [&] { return quotient(circle(), z); });
    put("gap", [&] { return quotient(circle() - z * l, z); });
  }
};

inline std::vector<RouteValue> solved(const Problem& of, Rung rung) {
  std::vector<RouteValue> all = settle(InverseRoutes{of.film}, rung);
  const std::vector<RouteValue> more = settle(DirectRoutes{of.pad}, rung);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace epure::michell_bearing
