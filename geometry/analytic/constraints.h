// The four-bar linkage by the method of constraint equations, a general method for computers: nothing is solved in
// closed form. With the links' angles as coordinates, y = (θ₃, θ₄) dependent and x = θ₂ independent, the closure
//   ψ₁ = r₂ cos θ₂ + r₃ cos θ₃ + r₄ cos θ₄ - r₁ = 0
//   ψ₂ = r₂ sin θ₂ + r₃ sin θ₃ + r₄ sin θ₄      = 0
// is solved by Newton-Raphson, y ← y - ψ_y⁻¹ ψ, and differentiated:
//   ẏ = - ψ_y⁻¹ ψ_x ẋ,     ÿ = - ψ_y⁻¹ (ψ_x ẍ + (ψ_y ẏ)_y ẏ + (ψ_x ẋ)_x ẋ).
// Source: Esercitazioni di Meccanica Applicata, N.11, with its conventions: all angles counter-clockwise from the
// frame A0 -> B0 (length r₁); θ₂ of the crank A0 -> A, θ₃ of the coupler A -> B, θ₄ from B to B0, against the rocker.
//
// The iteration runs in doubles and proves nothing. A step of Krawczyk's interval method on top of it then proves
// that one solution lies in a box around the last iterate, and how wide the box is.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/crank_state.h"
#include "geometry/analytic/four_bar_formulas.h"
#include "geometry/numbers/enclosure.h"

#include <Eigen/Core>
#include <string>
#include <type_traits>
#include <vector>

namespace epure::geometry::analytic {

// One step of the iteration; angles in radians, as they come (not reduced to one turn), residual in metres.
struct NewtonIterate {
  Eigen::Vector3d q;         // θ₃, θ₄, θ₂ in the source's order
  Eigen::Vector2d residual;  // ψ
  double residual_norm = 0;
  double determinant = 0;                          // of ψ_y, in m²: r₃ r₄ sin(θ₄ - θ₃)
  Eigen::Vector2d step = Eigen::Vector2d::Zero();  // to the next iterate; zero at the last
};

// Why the iteration ended.
enum class NewtonEnd {
  converged,  // doubles can say no more: the residual's interval, for angles up to the next doubles, contains zero
  singular,   // likewise the interval of det ψ_y contains zero, by which the next step would divide
  diverged,   // a step led beyond 2²⁶ rad, where doubles no longer resolve half their digits of an angle
  exhausted   // none of these within the number of steps allowed
};

struct NewtonRun {
  NewtonEnd end = NewtonEnd::exhausted;
  std::vector<NewtonIterate> iterates = {};  // the start first; at least one
  Words reason = {};                         // one sentence, also when it converged
};

// Newton-Raphson from the given θ₃ and θ₄ with the crank as it stands, at most `most_steps` >= 0 steps. Of a linkage
// with two branches the start decides which is found: det ψ_y < 0 with B on the left of A -> B0, > 0 on the right.
// Throws Impossible when A0 and B0 coincide.
NewtonRun newton_raphson(const FourBar& g, const CrankState<Fast>& crank, double theta_3, double theta_4,
                         int most_steps);

// The configuration: unit directions that go with the angles.
template <class T>
struct Configuration {
  T theta_3, theta_4;        // in radians, in [-π, π] but for rounding
  Complex<T> frame;          // unit direction A0 -> B0, by which the angles turn into directions of the plane
  Complex<T> e_2, e_3, e_4;  // e^{iθ}, against the frame
  T r_1, r_2, r_3, r_4;      // metres
  T determinant;             // of ψ_y, m²
};

// Angular velocities in rad/s and accelerations in rad/s², counter-clockwise positive.
template <class T>
struct ConstraintMotion {
  T omega_2, omega_3, omega_4, alpha_2, alpha_3, alpha_4;
};

namespace constraints {

template <class T>
using Pair = Eigen::Matrix<T, 2, 1>;
template <class T>
using Square = Eigen::Matrix<T, 2, 2>;

template <class T>
Pair<T> pair(const T& first, const T& second) {
  Pair<T> p;
  p << first, second;
  return p;
}

template <class T>
Complex<T> direction(const T& angle) {
  return {cosine_of_angle(angle), sine_of_angle(angle)};
}

template <class T>
Pair<T> residual(const Configuration<T>& q) {
  const Complex<T> sum = q.r_2 * q.e_2 + q.r_3 * q.e_3 + q.r_4 * q.e_4;
  return pair<T>(sum.re - q.r_1, sum.im);
}

template <class T>
Square<T> jacobian(const Configuration<T>& q) {
  Square<T> psi_y;
  psi_y << -(q.r_3 * q.e_3.im), -(q.r_4 * q.e_4.im), q.r_3 * q.e_3.re, q.r_4 * q.e_4.re;
  return psi_y;
}

template <class T>
T determinant(const Square<T>& m) {
  return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
}

// m⁻¹ by Cramer's rule. Throws Undecided when its determinant may be zero.
template <class T>
Square<T> inverse(const Square<T>& m) {
  const T d = determinant(m);
  Square<T> result;
  result << quotient(m(1, 1), d), -quotient(m(0, 1), d), -quotient(m(1, 0), d), quotient(m(0, 0), d);
  return result;
}

// Lengths and crank; the angles are still to come.
template <class T>
Configuration<T> links(const FourBar& g, const CrankState<T>& crank) {
  require_frame(g);
  Configuration<T> q;
  q.r_1 = root(from_rational<T>(g.squared_frame()));
  q.r_2 = from_rational<T>(g.A0A);
  q.r_3 = from_rational<T>(g.AB);
  q.r_4 = from_rational<T>(g.B0B);
  q.frame = divided(g.B0<T>(), q.r_1);
  q.e_2 = conjugate(q.frame) * Complex<T>{crank.cosine, crank.sine};
  return q;
}

template <class T>
Configuration<T> at(Configuration<T> q, const Pair<T>& y) {
  q.theta_3 = y(0);
  q.theta_4 = y(1);
  q.e_3 = direction(y(0));
  q.e_4 = direction(y(1));
  q.determinant = determinant<T>(jacobian(q));
  return q;
}

template <class T>
bool may_be_zero(const T& x) {
  return sign(x) == Sign::zero || sign(x) == Sign::undecided;
}

// |x| <= bound is proved with strict inequality.
template <class T>
bool is_within(const T& x, const T& bound) {
  return sign(bound - x) == Sign::positive && sign(bound + x) == Sign::positive;
}

// An upper bound of |x|, twice over: room for the next step to land inside.
template <class T>
T twice_the_size(const T& x) {
  const T size = root(square(x));
  return size + size;
}

// An iterate may be whole turns away.
inline double within_half_a_turn(double angle) { return std::remainder(angle, 2 * pi<Fast>()); }

// As many Newton steps as still help: until the residual cannot be told from zero.
template <class T>
Pair<T> refined(const Configuration<T>& q, Pair<T> y) {
  constexpr int most_steps = 60;  // each doubles the digits once they are right; doubles bring the first 16
  for (int k = 0; k < most_steps; ++k) {
    const Configuration<T> now = at(q, y);
    const Pair<T> psi = residual(now);
    if (may_be_zero(psi(0)) && may_be_zero(psi(1))) break;
    const Pair<T> next = y - inverse<T>(jacobian(now)) * psi;
    y = pair<T>(midpoint(next(0)), midpoint(next(1)));
  }
  return y;
}

// Krawczyk: with Y ≈ ψ_y⁻¹ at the centre m and the box Y = m ± ρ, the box  K = m - Y ψ(m) + (1 - Y ψ_y(box)) (± ρ)
// contains every solution in the box; and when K lies inside, there is one, and only one.
// (Krawczyk 1969; Neumaier, Interval Methods for Systems of Equations, section 5.1.)
template <class T>
Pair<T> proved_box(const Configuration<T>& q, const Pair<T>& m) {
  const Square<T> Y = inverse<T>(jacobian(at(q, m)));
  const Pair<T> newton = Y * residual(at(q, m));
  Pair<T> rho = pair<T>(twice_the_size(newton(0)), twice_the_size(newton(1)));
  constexpr int most_boxes = 30;  // each at least as wide as twice the one before it needed
  for (int k = 0; k < most_boxes; ++k) {
    const Pair<T> around = pair<T>(widened(T(0), rho(0)), widened(T(0), rho(1)));
    const Square<T> slopes = Y * jacobian(at<T>(q, m + around));
    const Pair<T> shift = (Square<T>::Identity() - slopes) * around - newton;
    if (is_within(shift(0), midpoint(rho(0))) && is_within(shift(1), midpoint(rho(1)))) return m + shift;
    rho = pair<T>(twice_the_size(shift(0)), twice_the_size(shift(1)));
  }
  throw Undecided(
      "no box around the last iterate is proved to hold one solution of the constraint equations",
      "di nessun intorno dell'ultima iterata è dimostrato che contenga una soluzione delle equazioni di vincolo");
}

}  // namespace constraints

// The configuration to which the iteration converged. Bounded and Deep: proved to be a solution, the only one within
// the box of its angles; Deep refines the last iterate first, so that the box is as narrow as its bits allow. Fast:
// the last iterate itself. Throws Undecided when the iteration did not converge, when the box cannot be proved (crank
// near a limit, for this number), and always on Exact and Calcium: angles are no algebraic numbers.
template <class T>
Configuration<T> configuration(const FourBar& g, const CrankState<T>& crank, const NewtonRun& run) {
  if (run.end != NewtonEnd::converged) throw Undecided(run.reason);
  if constexpr (requires(const T angle) { cosine_of_angle(angle); }) {
    using namespace constraints;
    const auto& last = run.iterates.back().q;
    const Configuration<T> q = links<T>(g, crank);
    const double theta_3 = within_half_a_turn(last(0)), theta_4 = within_half_a_turn(last(1));
    if constexpr (std::is_same_v<T, Fast>) {
      return at<T>(q, pair<T>(theta_3, theta_4));
    } else {
      const Pair<T> start = pair<T>(from_rational<T>(Rational(theta_3)), from_rational<T>(Rational(theta_4)));
      return at<T>(q, proved_box<T>(q, refined<T>(q, start)));
    }
  } else {
    throw Undecided("the constraint equations are solved for angles, which are no algebraic numbers",
                    "le equazioni di vincolo si risolvono negli angoli, che non sono numeri algebrici");
  }
}

// Throws Undecided when det ψ_y may be zero.
template <class T>
ConstraintMotion<T> motion(const CrankState<T>& crank, const Configuration<T>& q) {
  using namespace constraints;
  const T omega_2 = crank.omega, alpha_2 = crank.alpha;
  const Square<T> inverse_of_psi_y = inverse<T>(jacobian(q));
  const Pair<T> psi_x = pair<T>(-(q.r_2 * q.e_2.im), q.r_2 * q.e_2.re);
  const Pair<T> y_1 = inverse_of_psi_y * pair<T>(-(psi_x(0) * omega_2), -(psi_x(1) * omega_2));
  // The quadratic terms: differentiating sines and cosines once more gives -r e^{iθ} θ'² for each link.
  const Complex<T> of_y = -(q.r_3 * square(y_1(0)) * q.e_3) - q.r_4 * square(y_1(1)) * q.e_4;
  const Complex<T> of_x = -(q.r_2 * square(omega_2) * q.e_2);
  const Pair<T> y_2 = inverse_of_psi_y *
                      pair<T>(-(psi_x(0) * alpha_2 + of_y.re + of_x.re), -(psi_x(1) * alpha_2 + of_y.im + of_x.im));
  return {omega_2, y_1(0), y_1(1), alpha_2, y_2(0), y_2(1)};
}

// A point of the linkage in the plane's own axes: metres, m/s, m/s².
template <class T>
struct MovingPoint {
  Complex<T> z, v, a;
};

namespace constraints {

// What the vector w e^{iθ} of a link adds to a point that it leads to; (i ω) and (i α - ω²) differentiate e^{iθ}.
template <class T>
MovingPoint<T> turned(const Complex<T>& w, const T& omega, const T& alpha) {
  return {w, omega * times_i(w), Complex<T>{-square(omega), alpha} * w};
}

template <class T>
MovingPoint<T> sum(const MovingPoint<T>& p, const MovingPoint<T>& q) {
  return {p.z + q.z, p.v + q.v, p.a + q.a};
}

}  // namespace constraints

// Points given in their link's frame as in four_bar_formulas.h: real part along the link, imaginary part across, 90°
// counter-clockwise; from A0 along A0A, from A along AB, from B0 along B0B.
template <class T>
MovingPoint<T> crank_point(const Configuration<T>& q, const ConstraintMotion<T>& m, const Complex<T>& in_link) {
  return constraints::turned<T>(in_link * q.e_2 * q.frame, m.omega_2, m.alpha_2);
}
template <class T>
MovingPoint<T> coupler_point(const Configuration<T>& q, const ConstraintMotion<T>& m, const Complex<T>& in_link) {
  const MovingPoint<T> A = crank_point(q, m, Complex<T>{q.r_2, T(0)});
  return constraints::sum(A, constraints::turned<T>(in_link * q.e_3 * q.frame, m.omega_3, m.alpha_3));
}
template <class T>
MovingPoint<T> rocker_point(const Configuration<T>& q, const ConstraintMotion<T>& m, const Complex<T>& in_link) {
  const MovingPoint<T> B0{q.r_1 * q.frame, {}, {}};
  return constraints::sum(B0, constraints::turned<T>(-(in_link * q.e_4 * q.frame), m.omega_4, m.alpha_4));
}

}  // namespace epure::geometry::analytic
