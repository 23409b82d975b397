#include "exercises/gear-pair/pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/problem.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

using Kind = geometry::Fault::Kind;

std::optional<double> value_of(const Solution& s, const std::string& name) {
  return s.has(name) ? s.value(name) : std::nullopt;
}

// The one of these points in which contact begins or ends, or else that.
PathEnd end_of(const Solution& s, const std::vector<std::string>& points, const PathEnd& otherwise) {
  for (const std::string& point : points)
    if (const auto xi = value_of(s, "xi_" + point)) return {point, *xi};
  return otherwise;
}

}  // namespace

Pair::Pair(const Solution& solution)
    : s(solution),
      of(pair_of(s.givens())),
      faults(geometry::faults(of)),
      pitch(s["circular_pitch"]),
      base_pitch(s["base_pitch"]) {
  for (const int wheel : {1, 2})
    if (!is_rack(wheel)) centres[static_cast<std::size_t>(wheel - 1)] = {0, -up(wheel) * (*this)("r_w_", wheel)};
  const double alpha_w = s["working_pressure_angle_deg"] * std::numbers::pi / 180;
  along = {-std::cos(alpha_w), std::sin(alpha_w)};
  T1 = s["xi_T1"];
  T2 = s.value("xi_T2");
  A = s.value("xi_A");
  E = s.value("xi_E");
  if (!has_contact()) return;
  if (const auto contact = value_of(s, "contact")) {
    begins = end_of(s, {"F1", "V2"}, {"A", *A});
    ends = end_of(s, {"F2", "V1"}, {"E", *E});
    is_known = true;
    touches = *contact >= 0;
    is_continuous = s["overlap"] >= 0;
    return;
  }
  begins = has(Kind::interference_approach) ? PathEnd{"T1", T1} : PathEnd{"A", *A};
  ends = has(Kind::interference_recess) ? PathEnd{"T2", *T2} : PathEnd{"E", *E};
  is_continuous = !has(Kind::contact_ratio_below_one);
}

double Pair::m() const { return CGAL::to_double(of.m); }

Place Pair::tip_at_mesh(int wheel) const {
  if (is_rack(wheel)) return {0, CGAL::to_double(rack_lines(of).tip)};
  return {0, O(wheel).y + up(wheel) * (*this)("r_tip_", wheel)};
}

Place Pair::root_at_mesh(int wheel) const {
  if (is_rack(wheel)) return {0, CGAL::to_double(rack_lines(of).root)};
  return {0, O(wheel).y + up(wheel) * (*this)("r_root_", wheel)};
}

double Pair::shown_contact() const {
  if (!has_contact() || !touches || (begins.xi < 0 && ends.xi > 0)) return 0;
  return (begins.xi + ends.xi) / 2;
}

bool Pair::has_single_contact() const {
  const double ratio = has_contact() ? (ends.xi - begins.xi) / base_pitch : 0;
  return ratio > 1 && ratio < 2;
}

bool Pair::has(Kind kind, int wheel) const {
  return std::any_of(faults.begin(), faults.end(), [&](const geometry::Fault& fault) {
    return !fault.undecided && fault.kind == kind && fault.wheel == wheel;
  });
}

Words written(double value, int significant) {
  return {figures(value, significant, Language::english), figures(value, significant, Language::italian)};
}

}  // namespace epure::gear_pair
