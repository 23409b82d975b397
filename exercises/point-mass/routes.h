// Every quantity by two routes, from exact rationals where all is rational; extremes at roots of quadratics.
#pragma once

#include <functional>
#include <memory>

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/point-mass/motion.h"
#include "exercises/point-mass/quantities.h"
#include "geometry/constructions/graphical_integral.h"
#include "geometry/constructions/proportion.h"

namespace epure::point_mass {

inline constexpr Phrase no_row{"the instant is no row of the table: dt does not divide it",
                               "l'istante non è una riga della tabella: dt non lo divide"};
inline constexpr Phrase beyond_end{"the table ends before", "la tabella finisce prima"};
inline constexpr Phrase no_error{"the exact value is zero: there is no relative error",
                                 "il valore esatto è zero: non c'è errore relativo"};
inline constexpr Phrase no_centroid{"the areas cancel: the tangent is parallel to the axis",
                                    "le aree si elidono: la tangente è parallela all'asse"};
inline constexpr Phrase no_extreme{"the force has none inside of the interval",
                                   "la forza non ne ha all'interno dell'intervallo"};
inline constexpr Phrase no_greatest_velocity{
    "the force does not pass from positive to negative inside of the interval: the velocity is greatest at its ends",
    "la forza non passa da positiva a negativa all'interno dell'intervallo: la velocità è massima agli estremi"};

inline const std::array<std::string, 2> methods{"bezout", "simpson"};
inline const std::array<std::string, 3> instants{"1", "2", "3"};
// Of the table, beside the instants of the source.
inline constexpr std::array<int, 17> seconds{1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 18, 19};

class Routes {
 public:
  explicit Routes(const Problem& of);

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    put_instants(ledger);
    put_extremes(ledger);
    ledger.begin_case("table.");
    put_table(ledger);
    ledger.begin_case("graphical.", {" (graphical integration)", " (integrazione grafica)"});
    put_graphical(ledger);
    return ledger;
  }

  const Problem& problem() const { return of_; }
  const BySteps& table() const { return steps_; }

 private:
  using Exact = std::function<Instant<Rational>(const Rational&)>;
  using Table = std::function<TableRow(const std::string& method, long row)>;

  template <class T>
  static void put(Ledger<T>& ledger, const Quantity& quantity, const std::function<Rational()>& find) {
    ledger.put(quantity, [&] { return geometry::from_rational<T>(find()); });
  }
  TableRow row(const Table& table, const std::string& method, const Rational& t) const {
    if (t > of_.end()) throw geometry::Impossible(beyond_end);
    const auto found = of_.row(t);
    if (!found) throw geometry::Impossible(no_row);
    return table(method, *found);
  }

  template <class T>
  void put_instants(Ledger<T>& ledger) const {
    const Exact by_powers = [this](const Rational& t) { return powers_.at(t); };
    const Exact by_quadrature = [this](const Rational& t) { return ByQuadrature{of_}.at(t); };
    for (int i = 0; i < 3; ++i) {
      ledger.route("closed form");
      put_exact(ledger, by_powers, i);
      // The tangent to the space, by its construction.
      ledger.put(centroid_at(instants[i]), [&] {
        const Instant<Rational> at = powers_.at(of_.t[i]);
        if (at.v == 0) throw geometry::Impossible(no_centroid);
        const auto number = geometry::from_rational<T>;
        const geometry::Line<T> axis = line(geometry::Point<T>{T(0), T(0)}, geometry::Vector<T>{T(1), T(0)});
        const geometry::Line<T> tangent =
            line(geometry::Point<T>{number(of_.t[i]), number(at.s)}, geometry::Vector<T>{T(1), number(at.v)});
        return finite(geometry::over_centroid(axis, tangent)).x;
      });
      ledger.route("quadrature");
      put_exact(ledger, by_quadrature, i);
      put(ledger, centroid_at(instants[i]), [&] {
        if (ByQuadrature{of_}.momentum(of_.t[i]) == 0) throw geometry::Impossible(no_centroid);
        return ByQuadrature{of_}.centroid(of_.t[i]);
      });
      ledger.route("sums");
      put_columns(
          ledger, by_powers, [this](const std::string& method, long k) { return steps_.at(method, k); }, i);
      ledger.route("Euler-Maclaurin");
      put_columns(
          ledger, by_quadrature, [this](const std::string& method, long k) { return closed_.at(method, k); }, i);
    }
  }

  template <class T>
  void put_exact(Ledger<T>& ledger, const Exact& exact, int i) const {
    const Instant<Rational> at = exact(of_.t[i]);
    const auto put_kind = [&](const char* kind, const Rational& value) {
      put(ledger, of_motion(kind, "", instants[i]), [&] { return value; });
    };
    put_kind("F", at.F);
    put_kind("a", at.a);
    put_kind("v", at.v);
    put_kind("q", at.q);
    put_kind("E", at.E);
    put_kind("s", at.s);
  }

  template <class T>
  void put_columns(Ledger<T>& ledger, const Exact& exact, const Table& table, int i) const {
    const Instant<Rational> at = exact(of_.t[i]);
    for (const std::string& method : methods) {
      const auto put_kind = [&](const char* kind, const Rational& truth,
                                const std::function<Rational(const TableRow&)>& of_row) {
        put(ledger, of_motion(kind, method, instants[i]), [&] { return of_row(row(table, method, of_.t[i])); });
        put(ledger, error_of(kind, method, instants[i]), [&] {
          const Rational found = of_row(row(table, method, of_.t[i]));
          if (truth == 0) throw geometry::Impossible(no_error);
          return (found - truth) / truth;
        });
      };
      put_kind("v", at.v, [](const TableRow& of) { return of.v; });
      put_kind("q", at.q, [this](const TableRow& of) { return of_.m * of.v; });
      put_kind("E", at.E, [this](const TableRow& of) { return of_.m * of.v * of.v / 2; });
      put_kind("s", at.s, [](const TableRow& of) { return of.s; });
    }
  }

  template <class T>
  void put_table(Ledger<T>& ledger) const {
    for (const int second : seconds) {
      const Rational t = second;
      const std::string at = "at_" + std::to_string(second);
      const auto put_rows = [&](const Exact& exact, const Table& table, const char* of_exact, const char* of_table) {
        ledger.route(of_exact);
        const auto put_kind = [&](const char* kind, const Rational Instant<Rational>::*value) {
          put(ledger, of_motion(kind, "", at), [&] {
            if (t > of_.end()) throw geometry::Impossible(beyond_end);
            return exact(t).*value;
          });
        };
        put_kind("F", &Instant<Rational>::F);
        put_kind("v", &Instant<Rational>::v);
        put_kind("s", &Instant<Rational>::s);
        ledger.route(of_table);
        for (const std::string& method : methods) {
          put(ledger, of_motion("v", method, at), [&] { return row(table, method, t).v; });
          put(ledger, of_motion("s", method, at), [&] { return row(table, method, t).s; });
        }
      };
      put_rows([this](const Rational& x) { return powers_.at(x); },
               [this](const std::string& method, long k) { return steps_.at(method, k); }, "closed form", "sums");
      put_rows([this](const Rational& x) { return ByQuadrature{of_}.at(x); },
               [this](const std::string& method, long k) { return closed_.at(method, k); }, "quadrature",
               "Euler-Maclaurin");
    }
  }

  // At a crossing as an isolated root, in closed forms of powers; and by the formula of the quadratic, by quadrature.
  template <class T>
  void put_extremes(Ledger<T>& ledger) const {
    const ByQuadrature quadrature{of_};
    const auto by_root = [&](const char* name, const std::optional<Crossing>& at, const Phrase& none,
                             const Powers& of) {
      ledger.put(extreme(name), [&] {
        if (!at) throw geometry::Impossible(none);
        return at->at.template into<T>([&](const auto& x) { return of.at(x); });
      });
    };
    const auto by_surd = [&](const char* name, const std::optional<Crossing>& at, const Phrase& none,
                             const Quadratic& of, const std::function<T(const T&)>& find) {
      ledger.put(extreme(name), [&] {
        if (!at) throw geometry::Impossible(none);
        return find(of.surd<T>(at->falls));
      });
    };
    const Powers itself{0, 1};
    const auto force = [&](const T& t) { return quadrature.force(t); };
    const auto same = [](const T& t) { return t; };
    ledger.route("closed form");
    by_root("t_F_max", slope_.falling, no_extreme, itself);
    by_root("F_max", slope_.falling, no_extreme, powers_.F);
    by_root("t_F_min", slope_.rising, no_extreme, itself);
    by_root("F_min", slope_.rising, no_extreme, powers_.F);
    by_root("t_v_max", zeros_.falling, no_greatest_velocity, itself);
    by_root("v_max", zeros_.falling, no_greatest_velocity, powers_.v);
    by_root("q_max", zeros_.falling, no_greatest_velocity, powers_.q);
    by_root("E_max", zeros_.falling, no_greatest_velocity, powers_.E);
    by_root("s_at_v_max", zeros_.falling, no_greatest_velocity, powers_.s);
    put_impulses<T>(
        ledger,
        [this](const Crossing* at) {
          return at ? at->at.template into<T>([&](const auto& x) { return powers_.q.at(x); })
                    : geometry::from_rational<T>(powers_.q.at(of_.end()));
        },
        [](const T& from, const T& to) { return to - from; });
    ledger.route("quadrature");
    by_surd("t_F_max", slope_.falling, no_extreme, slope_, same);
    by_surd("F_max", slope_.falling, no_extreme, slope_, force);
    by_surd("t_F_min", slope_.rising, no_extreme, slope_, same);
    by_surd("F_min", slope_.rising, no_extreme, slope_, force);
    const auto at_v_max = [&](const char* name, const std::function<T(const T&)>& find) {
      by_surd(name, zeros_.falling, no_greatest_velocity, zeros_, find);
    };
    at_v_max("t_v_max", same);
    at_v_max("v_max", [&](const T& t) { return quadrature.velocity(t); });
    at_v_max("q_max", [&](const T& t) { return quadrature.momentum(t); });
    at_v_max("E_max", [&](const T& t) { return quadrature.energy(t); });
    at_v_max("s_at_v_max", [&](const T& t) { return quadrature.space(t); });
    put_impulses<T>(
        ledger,
        [this](const Crossing* at) {
          return at ? zeros_.template surd<T>(at->falls) : geometry::from_rational<T>(of_.end());
        },
        [&](const T& from, const T& to) { return quadrature.impulse(from, to); });
  }

  // Between the zeros of the force, in their order: `at` finds what is known of a zero (null: of the end), `between`
  // the area from one to the next.
  template <class T>
  void put_impulses(Ledger<T>& ledger, const std::function<T(const Crossing*)>& at,
                    const std::function<T(const T&, const T&)>& between) const {
    for (const bool positive : {true, false})
      ledger.put(extreme(positive ? "impulse_positive" : "impulse_negative"), [&] {
        T sum(0), from(0);
        bool is_positive = begins_positive();
        for (const Crossing* zero : zeros_in_order()) {
          const T to = at(zero);
          if (is_positive == positive && of_.has_force()) sum += between(from, to);
          from = to;
          is_positive = !is_positive;
        }
        return sum;
      });
  }
  bool begins_positive() const;
  // The end, null, after them.
  std::vector<const Crossing*> zeros_in_order() const;

  // On paper: places in metres, with the poles that the scales ask for; its twin in closed form.
  template <class T>
  void put_graphical(Ledger<T>& ledger) const {
    const auto number = geometry::from_rational<T>;
    const Rational per_metre = 100;
    const auto scale = [&](const Rational& cm) { return number(per_metre * cm); };
    const T t_scale = scale(of_.cm_t), a_scale = scale(of_.cm_a), v_scale = scale(of_.cm_v),
            s_scale = scale(of_.cm_s);
    const T H_v = geometry::IntegrationScales<T>{t_scale, a_scale, v_scale}.pole_distance();
    const T H_s = geometry::IntegrationScales<T>{t_scale, v_scale, s_scale}.pole_distance();
    const std::vector<Rational> ends = of_.strip_ends();
    const auto drawn = once([&] {
      std::vector<T> on_paper, means;
      for (std::size_t i = 0; i < ends.size(); ++i) {
        on_paper.push_back(number(ends[i] / (per_metre * of_.cm_t)));
        if (i > 0) means.push_back(number(powers_.a.at((ends[i - 1] + ends[i]) / 2) / (per_metre * of_.cm_a)));
      }
      const auto v = geometry::graphical_integral<T>(on_paper, means, H_v);
      return std::pair(v, geometry::graphical_integral<T>(on_paper, v.middles(), H_s));
    });
    ledger.route("graphical integration");
    ledger.put(pole_distance("v"), H_v);
    ledger.put(pole_distance("s"), H_s);
    for (int i = 0; i < 3; ++i) {
      const std::size_t strip = strip_of(of_.t[i]);
      const auto on_paper = [&] { return number(of_.t[i] / (per_metre * of_.cm_t)); };
      ledger.put(ordinate_of_polygon("v", instants[i]),
                 [&] { return v_scale * drawn().first.at(strip, on_paper()); });
      ledger.put(ordinate_of_polygon("s", instants[i]),
                 [&] { return s_scale * drawn().second.at(strip, on_paper()); });
    }
    // How far their ends are from the true curves.
    const auto off = [&](const geometry::IntegralPolygon<T>& polygon, const Powers& curve, const T& worth) {
      std::vector<T> truth;
      for (const Rational& end : ends) truth.push_back(geometry::quotient(number(curve.at(end)), worth));
      return worth * polygon.off_from(truth).back();
    };
    ledger.tells(distance_of_polygon("v"), [&] { return off(drawn().first, powers_.v, v_scale); });
    ledger.tells(distance_of_polygon("s"), [&] { return off(drawn().second, powers_.s, s_scale); });
    // Thales: what rises as steeply as a centimetre in a centimetre is, on the diagram, as high as the pole is far.
    ledger.route("Euler-Maclaurin");
    const T cm = number(1 / per_metre);
    const auto by_proportion = [&](const Rational& ordinate, const Rational& integral) {
      return geometry::fourth_proportional<T>(number(of_.cm_t * ordinate), number(integral), cm);
    };
    ledger.put(pole_distance("v"), [&] { return by_proportion(of_.cm_a, of_.cm_v); });
    ledger.put(pole_distance("s"), [&] { return by_proportion(of_.cm_v, of_.cm_s); });
    for (int i = 0; i < 3; ++i) {
      put(ledger, ordinate_of_polygon("v", instants[i]), [&] { return polygon_in_closed_form(of_.t[i]).v; });
      put(ledger, ordinate_of_polygon("s", instants[i]), [&] { return polygon_in_closed_form(of_.t[i]).s; });
    }
  }
  std::size_t strip_of(const Rational& t) const;
  TableRow polygon_in_closed_form(const Rational& t) const;

  Problem of_;
  ByPowers powers_;
  BySteps steps_;
  InClosedForm closed_;
  Quadratic slope_, zeros_;  // of F, and of F/t
};

std::vector<RouteValue> solved(const Routes& routes, Rung rung);

}  // namespace epure::point_mass
