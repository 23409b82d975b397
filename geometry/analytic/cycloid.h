// The cycloid by its natural equation: curvature against arc, no coordinates needed.
//
// With σ the arc from M to the top of its arch, positive before the top:
//   ρ² + σ² = 16 r²          (Cesàro)
//   σ = 4 r sin ψ            (Whewell), ψ the inclination of the tangent, so ρ = 4 r cos ψ
// The wheel turns through φ = (2 k + 1) π - 2 ψ, k whole arches lying behind; so ds/dt = -dσ/dt = 2 r ω cos ψ = ω
// ρ/2.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry::analytic {

// For a constant angular velocity omega > 0 of the wheel. Required of the caller: r > 0, s >= 0.
template <class T>
class CycloidByArc {
 public:
  CycloidByArc(const Rational& r, const Rational& s, const T& omega)
      : arches_(whole_turns({s / (8 * r)})), r_(from_rational<T>(r)), omega_(omega) {
    const Rational since_cusp = s - 8 * r * arches_, to_top = 4 * r - since_cusp;
    is_at_cusp_ = since_cusp == 0;
    sigma_ = from_rational<T>(to_top);
    rho_ = root(from_rational<T>((4 * r - to_top) * (4 * r + to_top)));
  }

  bool is_at_cusp() const { return is_at_cusp_; }
  const T& radius_of_curvature() const { return rho_; }

  // Off a cusp Exact throws LeavesTheTower, Generic and Calcium Undecided.
  T angle() const {
    if (is_at_cusp_) return radians<T>(Angle{arches_});
    if constexpr (std::is_same_v<T, Exact>) throw LeavesTheTower("an arc tangent", "un arcotangente");
    if constexpr (std::is_same_v<T, Generic> || std::is_same_v<T, Calcium>)
      throw Undecided("an arc tangent", "un arcotangente");
    if constexpr (NumberWithAngles<T>)
      return radians<T>(Angle{arches_ + Rational(1, 2)}) - T(2) * arc_tangent(sigma_, rho_);
  }

  // sin φ = 2 sin ψ cos ψ, 1 - cos φ = 2 cos² ψ.
  Complex<T> position() const {
    const T eight_r = T(8) * r_;
    return {r_ * angle() - quotient(sigma_ * rho_, eight_r), height()};
  }
  T height() const { return quotient(square(rho_), T(8) * r_); }

  T speed() const { return quotient(omega_ * rho_, T(2)); }
  Complex<T> velocity() const { return speed() * tangent(); }

  // dv/dt = v dv/ds = ω²/4 ρ dρ/ds, where ρ dρ = -σ dσ and dσ = -ds. At a cusp, where the tangent turns about, the
  // one after it; before it is the same with the other sign.
  T tangential_acceleration() const { return quotient(square(omega_) * sigma_, T(4)); }
  T tangential_acceleration_before() const {
    return is_at_cusp_ ? -tangential_acceleration() : tangential_acceleration();
  }
  // v²/ρ
  T normal_acceleration() const { return quotient(square(omega_) * rho_, T(4)); }
  Complex<T> acceleration() const { return tangential_acceleration() * tangent() + normal_acceleration() * normal(); }

  Complex<T> to_centre_of_curvature() const { return rho_ * normal(); }

 private:
  // e^{iψ}, and square to it towards the hollow side, which is the right.
  Complex<T> tangent() const { return divided(Complex<T>{rho_, sigma_}, T(4) * r_); }
  Complex<T> normal() const { return -times_i(tangent()); }

  Rational arches_;
  T r_, omega_, sigma_{0}, rho_{0};
  bool is_at_cusp_ = false;
};

}  // namespace epure::geometry::analytic
