// The oscillator in closed form, and by the exponential of its matrix with quadratures along its phase trajectory;
// Euler's table step by step, and by powers of the step's matrix. The pendulum by arithmetic-geometric means, and by
// quadrature of the energy integral with theta series; its table row by row, and summed up.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <type_traits>
#include <vector>

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/oscillator-pendulum/quantities.h"
#include "geometry/analytic/oscillation_by_matrix.h"
#include "geometry/analytic/pendulum_by_theta.h"
#include "geometry/numbers/at_each_precision.h"
#include "geometry/numbers/increasing_root.h"
#include "geometry/numbers/on_balls.h"
#include "geometry/vibration/pendulum.h"

namespace epure::oscillator_pendulum {

using geometry::Deep;
using geometry::on_balls;
using geometry::quotient;
using geometry::root;
using geometry::square;

inline const Phrase complex_roots{
    "zeta is less than 1: the roots are complex, and the motion has no exponentials of its own",
    "zeta è minore di 1: le radici sono complesse, e il moto non ha esponenziali propri"};
inline const Phrase double_root{"zeta is 1: the root is double, and x = v_0 t exp(-alpha t)",
                                "zeta è 1: la radice è doppia, e x = v_0 t exp(-alpha t)"};
inline const Phrase between_steps{"the step does not divide this instant: the table has no row for it",
                                  "il passo non divide questo istante: la tabella non ha una riga per esso"};
inline const Phrase beyond_doubles{"its size is beyond 10^300", "supera 10^300"};

inline const Phrase over_the_top{"the table goes over the top, and does not come back",
                                 "la tabella passa per il punto più alto, e non torna"};
inline const Phrase too_many_rows{"in 2000 rows the table has not come back",
                                  "in 2000 righe la tabella non è tornata"};

// The row, of those from 1 on that are given, in which a table of the pendulum rests again on the side where it
// began: the second in which the angle turns. Throws Impossible where it goes over the top before.
std::optional<std::size_t> row_of_return(const std::vector<Deep>& theta, const std::vector<Deep>& rates);

// What is larger than any double can tell is no value. (What is smaller is told between its neighbours, zero one of
// them.)
Deep within_doubles(Deep x);

// How many steps make up the instant; throws Impossible where no number of them does.
long steps_to(const Rational& t, const Rational& dt);

// What a route writes down in each number.
template <class T>
struct Writer {
  Ledger<T>& ledger;
  Quantity (*described)(const std::string&);

  void of(const std::string& name, const std::function<T()>& find) const { ledger.put(described(name), find); }
  void ball(const std::string& name, const std::function<Deep()>& find) const {
    ledger.put(described(name), [&] { return in_doubles_or_not<T>(find); });
  }
  // At every instant that is reported of it.
  void at_instants(const std::string& what, const std::function<Deep(const Rational&)>& find) const {
    for (const std::string& name : instants(what))
      ledger.put(at_instant(what, name), [&] { return in_doubles_or_not<T>([&] { return find(instant(name)); }); });
  }
  template <class N, class Find>
  static N in_doubles_or_not(const Find& find) {
    return on_balls<N>([&] { return within_doubles(find()); });
  }
};

struct OscillatorRoutes {
  Oscillator of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    ledger.begin_case("oscillator.", {" (oscillator)", " (oscillatore)"});
    const Writer<T> write{ledger, oscillator_quantity};
    by_closed_form<T>(write);
    by_matrix<T>(write);
    return ledger;
  }
  // Either alone, for what is at the rows of the table (tables.cpp).
  template <class Write>
  void one_route(const Write& write) const {
    by_closed_form<Deep>(write);
  }
  template <class Write>
  void other_route(const Write& write) const {
    by_matrix<Deep>(write);
  }

 private:
  // Of what exists for ζ above 1, or from 1 on.
  template <class T>
  std::function<T()> with_real_roots(bool distinct, std::function<T()> find) const {
    return [this, distinct, find = std::move(find)] {
      if (of.zeta < 1) throw geometry::Impossible(complex_roots);
      if (distinct && of.zeta == 1) throw geometry::Impossible(double_root);
      return find();
    };
  }
  template <class T, class Write>
  void by_closed_form(const Write& write) const {
    const Rational zeta = of.zeta, m = of.m;
    const auto omega = [this] { return geometry::radians<T>(of.omega); };
    const auto b = [=] { return root(number<T>(zeta * zeta - 1)); };
    const auto greater = [=] { return number<T>(zeta) + b(); };  // ζ + b
    write.of("alpha", [&] { return number<T>(zeta) * omega(); });
    write.of("beta", with_real_roots<T>(false, [=] { return omega() * b(); }));
    write.of("two_beta", with_real_roots<T>(false, [=] { return T(2) * omega() * b(); }));
    write.of("C_1",
             with_real_roots<T>(true, [=, this] { return quotient(number<T>(of.v_0), T(2) * omega() * b()); }));
    write.of("C_2",
             with_real_roots<T>(true, [=, this] { return quotient(number<T>(-of.v_0), T(2) * omega() * b()); }));
    write.of("c", [&] { return number<T>(Rational(2) * zeta * m) * omega(); });
    write.of("k", [&] { return number<T>(m) * square(omega()); });
    write.of("c_critical", [&] { return number<T>(Rational(2) * m) * omega(); });
    write.of("lambda_1", with_real_roots<T>(false, [=] { return -quotient(omega(), greater()); }));
    write.of("lambda_2", with_real_roots<T>(false, [=] { return -(omega() * greater()); }));
    write.of("E_0", [&] { return number<T>(m * of.v_0 * of.v_0 / 2); });
    const geometry::FreeOscillation motion(zeta, of.omega, of.v_0);
    write.ball("t_x_max", [&] { return motion.time_of_extreme(); });
    write.ball("x_max", [&] { return motion.extreme(); });
    write.ball("t_inflection", [&] { return motion.time_of_inflection(); });
    write.ball("x_inflection", [&] { return motion.position_of_inflection(); });
    write.ball("x_dot_min", [&] { return motion.velocity_of_inflection(); });
    write.ball("E_at_x_max", [&] { return energy(motion.extreme()); });
    write.at_instants("x", [&](const Rational& t) { return motion.position(t); });
    write.at_instants("x_dot", [&](const Rational& t) { return motion.velocity(t); });
    write.at_instants("x_ddot", [&](const Rational& t) { return motion.acceleration(t); });
    write.ledger.route("recursion");
    const auto table = once([this] { return euler_in_steps(); });
    const auto row = [&](const Rational& t) { return table().at(static_cast<std::size_t>(steps_to(t, of.dt))); };
    write.at_instants("x_euler", [&](const Rational& t) { return row(t).x; });
    write.at_instants("x_dot_euler", [&](const Rational& t) { return row(t).v; });
    write.at_instants("x_ddot_euler", [&](const Rational& t) { return row(t).a; });
    write.at_instants("err_euler", [&](const Rational& t) {
      const Deep x = motion.position(t);
      return (row(t).x - x) / x;
    });
  }

  template <class T, class Write>
  void by_matrix(const Write& write) const {
    write.ledger.route("phase plane");
    const Rational zeta = of.zeta, m = of.m;
    const auto omega = [this] { return geometry::radians<T>(of.omega); };
    // The mean proportional between α - ω and α + ω.
    const auto beta = [=] { return root(number<T>(zeta - 1)) * root(number<T>(zeta + 1)) * omega(); };
    const auto alpha = [=] {
      return quotient(number<T>(Rational(2) * zeta * m) * omega(), number<T>(Rational(2) * m));
    };
    const auto lambda_1 = [=] { return beta() - alpha(); };
    const auto lambda_2 = [=] { return quotient(square(omega()), lambda_1()); };
    const auto c_critical = [=] { return T(2) * root(square(number<T>(m) * omega())); };
    write.of("alpha", [&] { return alpha(); });
    write.of("beta", with_real_roots<T>(false, [=] { return beta(); }));
    write.of("two_beta",
             with_real_roots<T>(false, [=, this] { return of.zeta == 1 ? T(0) : lambda_1() - lambda_2(); }));
    write.of("C_1",
             with_real_roots<T>(true, [=, this] { return quotient(number<T>(of.v_0), lambda_1() - lambda_2()); }));
    write.of("C_2",
             with_real_roots<T>(true, [=, this] { return quotient(number<T>(of.v_0), lambda_2() - lambda_1()); }));
    write.of("c", [&] { return number<T>(zeta) * c_critical(); });
    write.of("k", [&] { return quotient(square(c_critical()), number<T>(Rational(4) * m)); });
    write.of("c_critical", [&] { return c_critical(); });
    write.of("lambda_1", with_real_roots<T>(false, [=] { return lambda_1(); }));
    write.of("lambda_2", with_real_roots<T>(false, [=] { return lambda_2(); }));
    // All of it in the spring, without damping.
    write.of("E_0", [&] {
      return quotient(number<T>(m) * square(omega()) * square(quotient(number<T>(of.v_0), omega())), T(2));
    });
    const geometry::analytic::OscillationByMatrix motion(zeta, of.omega);
    const auto v_0 = [this] { return number<Deep>(of.v_0); };
    const auto w = [this] { return geometry::radians<Deep>(of.omega); };
    const auto position = [=](const Deep& t) { return v_0() / w() * motion.after_push(t).omega_x; };
    const auto velocity = [=](const Deep& t) { return v_0() * motion.after_push(t).velocity; };
    write.ball("t_x_max", [&] { return motion.time_of_extreme(); });
    write.ball("x_max", [&] { return position(motion.time_of_extreme()); });
    write.ball("t_inflection", [&] { return motion.time_of_inflection(); });
    write.ball("x_inflection", [&] { return position(motion.time_of_inflection()); });
    write.ball("x_dot_min", [&] { return velocity(motion.time_of_inflection()); });
    write.ball("E_at_x_max", [&] { return energy(position(motion.time_of_extreme())); });
    write.at_instants("x", [&](const Rational& t) { return position(number<Deep>(t)); });
    write.at_instants("x_dot", [&](const Rational& t) { return velocity(number<Deep>(t)); });
    write.at_instants("x_ddot", [&](const Rational& t) {
      const auto [x, v] = motion.after_push(number<Deep>(t));
      return -(w() * v_0() * (x + number<Deep>(Rational(2) * of.zeta) * v));
    });
    write.ledger.route("matrix powers");
    const auto steps = [&](const Rational& t) {
      return geometry::analytic::steps_of_euler(of.zeta, of.dt * of.omega, steps_to(t, of.dt));
    };
    write.at_instants("x_euler", [&](const Rational& t) { return v_0() / w() * steps(t).omega_x; });
    write.at_instants("x_dot_euler", [&](const Rational& t) { return v_0() * steps(t).velocity; });
    write.at_instants("x_ddot_euler", [&](const Rational& t) {
      const auto [x, v] = steps(t);
      return -(w() * v_0() * (x + number<Deep>(Rational(2) * of.zeta) * v));
    });
    write.at_instants("err_euler", [&](const Rational& t) {
      const Deep x = position(number<Deep>(t));
      return (v_0() / w() * steps(t).omega_x - x) / x;
    });
  }

  Deep energy(const Deep& x) const { return number<Deep>(of.m / 2) * square(geometry::radians<Deep>(of.omega) * x); }

  struct Row {
    Deep x, v, a;
  };
  // Up to t = 20 s; rational as far as ω is.
  std::vector<Row> euler_in_steps() const {
    const long rows = static_cast<long>(CGAL::to_double(Rational(20) / of.dt)) + 1;
    return of.omega.turns == 0 ? euler_in_steps<Rational>(rows, of.omega.radians)
                               : euler_in_steps<Deep>(rows, geometry::radians<Deep>(of.omega));
  }
  template <class N>
  std::vector<Row> euler_in_steps(long rows, const N& omega) const {
    const auto in = [](const Rational& q) {
      if constexpr (std::is_same_v<N, Rational>) {
        return q;
      } else {
        return number<Deep>(q);
      }
    };
    const auto out = [](const N& x) {
      if constexpr (std::is_same_v<N, Rational>) {
        return number<Deep>(x);
      } else {
        return x;
      }
    };
    const N damping = in(Rational(2) * of.zeta) * omega, stiffness = omega * omega, dt = in(of.dt);
    std::vector<Row> table;
    N x = in(0), v = in(of.v_0);
    for (long i = 0; i < rows; ++i) {
      const N a = -(damping * v) - stiffness * x;
      table.push_back({out(x), out(v), out(a)});
      x = x + v * dt;
      v = v + a * dt;
    }
    return table;
  }
};

struct PendulumRoutes {
  Pendulum of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    ledger.begin_case("pendulum.", {" (pendulum)", " (pendolo)"});
    const Writer<T> write{ledger, pendulum_quantity};
    by_means<T>(write);
    by_theta<T>(write);
    return ledger;
  }
  template <class Write>
  void one_route(const Write& write) const {
    by_means<Deep>(write);
  }
  template <class Write>
  void other_route(const Write& write) const {
    by_theta<Deep>(write);
  }

 private:
  template <class T>
  T cosine_of_start() const {
    return geometry::cosine<T>(of.theta_0);
  }
  // m r²/I_A0
  Rational share() const { return of.m * of.r * of.r / of.I_A0(); }

  template <class T>
  struct Reaction {
    T x, y;
  };
  // 1) and 2) of the source.
  template <class T>
  Reaction<T> reaction(const T& sine, const T& cosine, const T& rate, const T& acceleration) const {
    const T m_r = number<T>(of.m * of.r);
    return {m_r * (acceleration * cosine - square(rate) * sine),
            number<T>(of.m * of.g) + m_r * (acceleration * sine + square(rate) * cosine)};
  }
  // Along A0G and across it: m g cos θ + m r θ'², and m g sin θ less m r Ω² sin θ.
  template <class T>
  Reaction<T> from_components(const T& sine, const T& cosine, const T& rate_squared) const {
    const T along = number<T>(of.m * of.g) * cosine + number<T>(of.m * of.r) * rate_squared,
            across = number<T>(of.m * of.g * (Rational(1) - share())) * sine;
    return {across * cosine - along * sine, along * cosine + across * sine};
  }
  // The cosine of the angle at which |R_12x| is greatest: where 6 c² - 2 c0 c - 3 = 0, but not above θ_0.
  bool is_greatest_at_start() const { return of.against(30) <= 0; }

  template <class T, class Write>
  void by_means(const Write& write) const {
    const T Omega_squared = number<T>(of.Omega_squared());
    const auto c0 = [this] { return cosine_of_start<T>(); };
    write.of("I_A0", [&] { return number<T>(of.I_A0()); });
    write.of("Omega_squared", [&] { return Omega_squared; });
    write.of("Omega", [&] { return root(Omega_squared); });
    write.of("equivalent_length", [&] { return number<T>(of.equivalent_length()); });
    write.of("weight", [&] { return number<T>(of.m * of.g); });
    const auto k = [this] { return geometry::sine<T>(Rational(sign_of(of.theta_0), 2) * of.theta_0); };
    write.of("k", [&] { return k(); });
    const auto swing = once([this] { return geometry::PendulumSwing(of.theta_0, of.Omega_squared()); });
    write.ball("K", [&] { return swing().K(); });
    write.ball("period", [&] { return Deep(4) * swing().K() / swing().Omega(); });
    write.of("period_small", [&] { return quotient(T(2) * geometry::pi<T>(), root(Omega_squared)); });
    write.ball("period_ratio", [&] { return Deep(2) * swing().K() / geometry::pi<Deep>(); });
    write.ball("t_first_bottom", [&] { return swing().K() / swing().Omega(); });
    write.of("theta_dot_max", [&] { return T(2) * k() * root(Omega_squared); });
    const T m_r_Omega_squared = number<T>(of.m * of.r * of.Omega_squared()), weight = number<T>(of.m * of.g);
    const auto c_of_greatest = [=]<class N>(const N& from) {
      return quotient(from + root(square(from) + N(18)), N(6));
    };
    write.of("R_12_x_max", [&] {
      const T c = is_greatest_at_start() ? c0() : c_of_greatest(c0());
      return m_r_Omega_squared * root(T(1) - square(c)) * geometry::absolute(T(3) * c - T(2) * c0());
    });
    write.ball("t_R_12_x_max", [&] {
      if (is_greatest_at_start()) return Deep(0);
      const Deep from = cosine_of_start<Deep>(), c = c_of_greatest(from);
      return swing().time_until(root((Deep(1) - c) / Deep(2)), root((c - from) / Deep(2)));
    });
    const auto at_bottom = [&] { return weight + T(2) * m_r_Omega_squared * (T(1) - c0()); };
    write.of("R_12_y_max", at_bottom);
    write.of("R_12_y_at_bottom", at_bottom);
    write.of("R_12_y_min", [&] {
      return weight +
             m_r_Omega_squared * (of.against(90) < 0 ? square(c0()) - T(1) : -(T(1) + quotient(square(c0()), T(3))));
    });
    at_instants_by<T>(
        write, [=](const Rational& t) { return swing().at(t); }, true);
    write.at_instants("theta_small", [&](const Rational& t) {
      return geometry::radians<Deep>(of.theta_0) *
             geometry::cosine_of_angle(root(number<Deep>(of.Omega_squared())) * number<Deep>(t));
    });
    write.ledger.route("recursion");
    const auto rows = once([this] { return geometry::row_by_row(of.table(), last_row()); });
    const auto theta = [=, this](const Rational& t, long after) {
      return rows().at(static_cast<std::size_t>(steps_to(t, of.dt) + after));
    };
    const auto rate = [=, this](const Rational& t) { return (theta(t, 1) - theta(t, 0)) / number<Deep>(of.dt); };
    const auto acceleration = [=, this](const Rational& t) {
      return (theta(t, 2) + theta(t, 0) - Deep(2) * theta(t, 1)) / number<Deep>(of.dt * of.dt);
    };
    const auto force = [=, this](const Rational& t) {
      const Deep angle = theta(t, 0);
      return reaction<Deep>(geometry::sine_of_angle(angle), geometry::cosine_of_angle(angle), rate(t),
                            acceleration(t));
    };
    write.at_instants("theta_numeric", [&](const Rational& t) { return theta(t, 0); });
    write.at_instants("theta_dot_numeric", rate);
    write.at_instants("theta_ddot_numeric", acceleration);
    write.at_instants("R_12_x_numeric", [&](const Rational& t) { return force(t).x; });
    write.at_instants("R_12_y_numeric", [&](const Rational& t) { return force(t).y; });
    write.ball("period_numeric", [this] {
      return time_of_return([this](long n) {
        const std::vector<Deep> angles = geometry::row_by_row(of.table(), n);
        std::vector<Deep> gained;
        for (std::size_t i = 0; i + 1 < angles.size(); ++i) gained.push_back(angles[i + 1] - angles[i]);
        return row_of_return(angles, gained);
      });
    });
    write.ball("energy_ratio_numeric_at_1", [&] {
      const Deep one(1), lever = number<Deep>(of.m * of.g * of.r);
      return (number<Deep>(of.I_A0() / 2) * square(rate(1)) +
              lever * (one - geometry::cosine_of_angle(theta(1, 0)))) /
             (lever * (one - cosine_of_start<Deep>()));
    });
  }

  // `row`: of the table with so many rows, that of its return. Tables twice as long are tried until it is there.
  template <class Row>
  Deep time_of_return(const Row& row) const {
    constexpr long most = 2000;
    for (long n = last_row();; n = std::min(2 * n, most)) {
      if (const auto found = row(n)) return number<Deep>(of.dt * Rational(static_cast<long>(*found)));
      if (n == most) throw geometry::Impossible(too_many_rows);
    }
  }

  // As far as rows are needed for what is reported at t = 1 s.
  long last_row() const { return static_cast<long>(CGAL::to_double(Rational(1) / of.dt)) + 2; }

  // `is_by_axes`: reactions by the source's equations, the start from the given angle itself.
  template <class T, class Write, class At>
  void at_instants_by(const Write& write, const At& at, bool is_by_axes) const {
    const auto start = [=](const Rational& t) { return is_by_axes && t == 0; };
    // How it moves at t, `now`, for which five numbers ask, some of them four times.
    using State = std::decay_t<decltype(at(Rational()))>;
    std::map<Rational, std::function<const State&()>> states;
    const auto state = [&](const Rational& t) {
      const auto [known, is_new] = states.try_emplace(t);
      if (is_new) known->second = geometry::at_each_precision([&at, t] { return at(t); });
      return known->second;
    };
    const auto sine = [=, this](const Rational& t, const auto& now) {
      return start(t) ? geometry::sine<Deep>(of.theta_0) : sine_of(now());
    };
    // At the start by both routes from the given angle: where it is level, the cosine is zero and no series proves
    // it.
    const auto cosine = [=, this](const Rational& t, const auto& now) {
      return t == 0 ? cosine_of_start<Deep>() : cosine_of(now());
    };
    const auto rate = [=](const Rational& t, const auto& now) { return start(t) ? Deep(0) : now().rate; };
    const auto acceleration = [=, this](const Rational& t, const auto& now) {
      return -number<Deep>(of.Omega_squared()) * sine(t, now);
    };
    const auto force = [=, this](const Rational& t) {
      const auto now = state(t);
      return is_by_axes ? reaction<Deep>(sine(t, now), cosine(t, now), rate(t, now), acceleration(t, now))
                        : from_components<Deep>(sine(t, now), cosine(t, now), square(rate(t, now)));
    };
    write.at_instants("theta", [&](const Rational& t) {
      return start(t) ? geometry::radians<Deep>(of.theta_0) : angle_of(state(t)());
    });
    write.at_instants("theta_dot", [&](const Rational& t) { return rate(t, state(t)); });
    write.at_instants("theta_ddot", [&](const Rational& t) { return acceleration(t, state(t)); });
    write.at_instants("R_12_x", [&](const Rational& t) { return force(t).x; });
    write.at_instants("R_12_y", [&](const Rational& t) { return force(t).y; });
  }
  template <class State>
  static Deep sine_of(const State& s) {
    return Deep(2) * s.sine_of_half * s.cosine_of_half;
  }
  template <class State>
  static Deep cosine_of(const State& s) {
    return square(s.cosine_of_half) - square(s.sine_of_half);
  }
  template <class State>
  static Deep angle_of(const State& s) {
    return Deep(2) * geometry::arc_tangent(s.sine_of_half, s.cosine_of_half);
  }

  template <class T, class Write>
  void by_theta(const Write& write) const {
    write.ledger.route("energy integral");
    const T m = number<T>(of.m), r = number<T>(of.r), g = number<T>(of.g);
    const T length = r + quotient(number<T>(of.I_G), m * r);  // to the centre of oscillation
    const auto c0 = [this] { return cosine_of_start<T>(); };
    write.of("I_A0", [&] { return m * r * length; });
    write.of("Omega_squared", [&] { return quotient(g, length); });
    write.of("Omega", [&] { return root(quotient(g, length)); });
    write.of("equivalent_length", [&] { return length; });
    write.of("weight", [&] { return m * length * number<T>(of.Omega_squared()); });
    write.of("k", [&] { return root(quotient(T(1) - c0(), T(2))); });
    const auto swing =
        once([this] { return geometry::analytic::PendulumByTheta(of.theta_0, of.g, of.equivalent_length()); });
    const auto small = [this] {
      return Deep(2) * geometry::pi<Deep>() * root(number<Deep>(of.equivalent_length() / of.g));
    };
    const auto period = [=] { return Deep(4) * swing().K() / swing().Omega(); };
    write.ball("K", [&] { return swing().K(); });
    write.ball("period", period);
    write.ball("period_small", small);
    write.ball("period_ratio", [&] { return period() / small(); });
    write.ball("t_first_bottom", [&] { return period() / Deep(4); });
    // m g r (1 - cos θ_0) = I_A0 θ'²/2
    const auto greatest_square = [=] { return quotient(T(2) * g * (T(1) - c0()), length); };
    write.of("theta_dot_max", [&] { return root(greatest_square()); });
    // Along A0G, across it, where the cosine is c.
    const auto force_at = [this]<class N>(const N& from, const N& c) {
      return from_components<N>(root(N(1) - square(c)), c, number<N>(Rational(2) * of.Omega_squared()) * (c - from));
    };
    const auto c_of_greatest = [](const Deep& from) {
      return geometry::increasing_root(
          [&](const Deep& c) { return Deep(6) * square(c) - Deep(2) * from * c - Deep(3); }, -2, 0.5);
    };
    write.ball("R_12_x_max", [&] {
      const Deep from = cosine_of_start<Deep>();
      return geometry::absolute(force_at(from, is_greatest_at_start() ? from : c_of_greatest(from)).x);
    });
    write.ball("t_R_12_x_max", [&] {
      if (is_greatest_at_start()) return Deep(0);
      const Deep from = cosine_of_start<Deep>(), c = c_of_greatest(from);
      return swing().time_until(geometry::arc_tangent(root(Deep(1) - c), root(c - from)));
    });
    const auto at_bottom = [&] { return m * g + m * r * greatest_square(); };
    write.of("R_12_y_max", at_bottom);
    write.of("R_12_y_at_bottom", at_bottom);
    write.of("R_12_y_min", [&] { return force_at(c0(), of.against(90) < 0 ? c0() : quotient(c0(), T(3))).y; });
    at_instants_by<T>(
        write, [=](const Rational& t) { return swing().at(t); }, false);
    const geometry::analytic::OscillationByMatrix small_swing(0, Angle{0, 1});
    write.at_instants("theta_small", [&](const Rational& t) {
      return geometry::radians<Deep>(of.theta_0) *
             small_swing.after_release(root(number<Deep>(of.g / of.equivalent_length())) * number<Deep>(t)).omega_x;
    });
    write.ledger.route("sums");
    const auto table = once([this] { return geometry::summed_up(of.table(), last_row()); });
    const auto row = [this](const Rational& t) { return static_cast<std::size_t>(steps_to(t, of.dt)); };
    const auto rate = [=, this](const Rational& t) {
      return -number<Deep>(of.Omega_squared() * of.dt) * table().sums.at(row(t));
    };
    const auto force = [=, this](const Rational& t) {
      const std::size_t i = row(t);
      return from_components<Deep>(table().sines[i], geometry::cosine_of_angle(table().theta[i]), square(rate(t)));
    };
    write.at_instants("theta_numeric", [&](const Rational& t) { return table().theta.at(row(t)); });
    write.at_instants("theta_dot_numeric", rate);
    write.at_instants("theta_ddot_numeric", [&](const Rational& t) {
      return -number<Deep>(of.Omega_squared()) * table().sines.at(row(t));
    });
    write.at_instants("R_12_x_numeric", [&](const Rational& t) { return force(t).x; });
    write.at_instants("R_12_y_numeric", [&](const Rational& t) { return force(t).y; });
    write.ball("period_numeric", [this] {
      return time_of_return([this](long n) {
        const geometry::SummedUp summed = geometry::summed_up(of.table(), n);
        return row_of_return(summed.theta, summed.sums);  // θ' is -Ω² Δt times the sum
      });
    });
    write.ball("energy_ratio_numeric_at_1", [&] {
      const auto height = [](const Deep& angle) { return square(geometry::sine_of_angle(angle / Deep(2))); };
      return (square(rate(1)) / number<Deep>(Rational(4) * of.Omega_squared()) + height(table().theta.at(row(1)))) /
             height(geometry::radians<Deep>(of.theta_0));
    });
  }
};

}  // namespace epure::oscillator_pendulum
