// What is given of the landing: the aircraft as one mass over one wheel that stands still in the air.
#pragma once

#include <optional>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/spin_up.h"

namespace epure::aircraft_landing {

std::vector<GivenSpec> given_specs();

struct Landing {
  Rational v_0, m_a, m_r, R, J_r, c_x, c_y, f_r, f_a, f_v, g, step;
  Rational rim_0;  // R ω at touch-down

  // Throws BadGivens: a wheel that friction does not set turning, one that rolls already, one that does not press.
  explicit Landing(const Givens& givens);

  // Why the wheel does not press on the ground at touch-down; none when it does.
  std::optional<Words> airborne() const;

  Landing with_doubled_wheel() const;
  Landing with_lift() const;  // F_y the other way up

  Rational M() const { return m_a + m_r; }
  Rational normal(const Rational& v) const { return M() * g + c_y * v * v; }
  // ω' = turning · N while it slips
  Rational turning() const { return (f_r - f_v) * R / J_r; }
  geometry::analytic::SpinUp law() const;

  // Of the graphical integration: the time that slip lasts in equal parts.
  static constexpr int strips = 6;
};

}  // namespace epure::aircraft_landing
