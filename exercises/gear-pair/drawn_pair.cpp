#include "exercises/gear-pair/drawn_pair.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/rounded.h"
#include "geometry/gears/sliding.h"
#include "geometry/gears/tooth_thickness.h"

namespace epure::gear_pair {
namespace {

using geometry::Deep;

template <class Find>
std::optional<double> double_if_there(const Find& find) {
  return if_there([&] { return epure::to_double(find()); });
}

// Over k teeth the faces touch the flanks half of W_k from the middle of the base tangent: k is chosen so that this
// is nearest to the middle of the teeth.
std::optional<BaseTangent> base_tangent(const geometry::GearPair<Deep>& pair, const geometry::WheelData& wheel,
                                        const geometry::WheelCircles<double>& circles, int number) {
  const auto on_base = double_if_there([&] { return base_thickness(pair, number); });
  if (!on_base || wheel.z < 4) return {};
  const double pitch = 2 * geometry::pi<geometry::Fast>() * circles.r_b / static_cast<double>(wheel.z);
  const double middle = circles.r + CGAL::to_double(wheel.m * wheel.x);
  if (middle <= circles.r_b) return {};
  const double wanted = 2 * std::sqrt((middle - circles.r_b) * (middle + circles.r_b));
  const long k = std::clamp(std::lround((wanted - *on_base) / pitch) + 1, 2L, wheel.z / 2);
  const double length = static_cast<double>(k - 1) * pitch + *on_base;
  const double touched = std::hypot(circles.r_b, length / 2);
  if (touched <= std::max(circles.r_root, circles.r_b) || touched >= circles.r_tip) return {};
  return BaseTangent{k, length};
}

geometry::WheelCircles<double> to_double(const geometry::WheelCircles<Deep>& c) {
  return {epure::to_double(c.r), epure::to_double(c.r_b), epure::to_double(c.r_w), epure::to_double(c.r_tip),
          epure::to_double(c.r_root)};
}

DrawnWheel drawn_wheel(const geometry::GearPair<Deep>& pair, int number) {
  const geometry::WheelData data = number == 1 ? first_wheel(pair.given) : second_wheel(pair.given);
  const auto& circles = number == 1 ? pair.wheel1 : *pair.wheel2;
  DrawnWheel wheel{.circles = to_double(circles),
                   .thickness = epure::to_double(tooth_thickness(pair, number, circles.r)),
                   .tip_thickness = double_if_there([&] { return tip_thickness(pair, number); }),
                   .base_tangent = {}};
  if (!data.ring) wheel.base_tangent = base_tangent(pair, data, wheel.circles, number);
  return wheel;
}

std::string name_of_begin(DrawnPath::By by) {
  if (by == DrawnPath::By::tip) return "A";
  return by == DrawnPath::By::root ? "F_{1}" : "V_{2}";
}
std::string name_of_end(DrawnPath::By by) {
  if (by == DrawnPath::By::tip) return "E";
  return by == DrawnPath::By::root ? "F_{2}" : "V_{1}";
}

DrawnPath drawn_path(const geometry::ContactPath& path, const Deep& base_pitch) {
  const auto end = [](const geometry::EndOfContact& of, const std::string& name) {
    return DrawnPath::End{epure::to_double(of.xi), name, of.by};
  };
  const auto is_negative = [](const Deep& x) { return sign(x) == geometry::Sign::negative; };
  return {.begins = end(path.begins, name_of_begin(path.begins.by)),
          .ends = end(path.ends, name_of_end(path.ends.by)),
          .known = true,
          .touches = !is_negative(path.length()),
          .is_continuous = !is_negative(path.length() - base_pitch)};
}

// Where involutes of these base circles could touch: all that can be said of a wheel without an outline.
DrawnPath path_of_whole_flanks(const DrawnPair& pair) {
  using Kind = geometry::Fault::Kind;
  DrawnPath path{.begins = {*pair.A, "A"}, .ends = {*pair.E, "E"}};
  if (pair.has(Kind::interference_approach)) path.begins = {pair.T1, "T_{1}"};
  if (pair.has(Kind::interference_recess)) path.ends = {*pair.T2, "T_{2}"};
  path.is_continuous = !pair.has(Kind::contact_ratio_below_one);
  return path;
}

// Whatever shortens the flanks of an external pair is a fault; a ring's or rack's own roots are not asked for.
DrawnPath path_of(const DrawnPair& pair, const Deep& base_pitch) {
  if (pair.faults.empty() && pair.of.kind == geometry::PairKind::external) {
    DrawnPath path = path_of_whole_flanks(pair);
    path.known = true;
    return path;
  }
  const auto path = if_there([&] { return geometry::contact_path(pair.of); });
  return path ? drawn_path(*path, base_pitch) : path_of_whole_flanks(pair);
}

}  // namespace

Place DrawnPair::tip_at_mesh(int wheel) const {
  if (wheel == 1) return {0, O1.y + wheel1.circles.r_tip};
  if (is_rack()) return {0, CGAL::to_double(rack_lines(of).tip)};
  return {0, O2->y + (is_ring() ? 1 : -1) * wheel2->circles.r_tip};
}

Place DrawnPair::root_at_mesh(int wheel) const {
  if (wheel == 1) return {0, O1.y + wheel1.circles.r_root};
  if (is_rack()) return {0, CGAL::to_double(rack_lines(of).root)};
  return {0, O2->y + (is_ring() ? 1 : -1) * wheel2->circles.r_root};
}

double DrawnPair::shown_contact() const {
  if (!has_contact() || !path.touches || (path.begins.xi < 0 && path.ends.xi > 0)) return 0;
  return (path.begins.xi + path.ends.xi) / 2;
}

bool DrawnPair::has_single_contact() const {
  return has_contact() && true_contact_ratio() > 1 && true_contact_ratio() < 2;
}

bool DrawnPair::has(geometry::Fault::Kind kind, int wheel) const {
  return std::any_of(faults.begin(), faults.end(), [&](const geometry::Fault& fault) {
    return !fault.undecided && fault.kind == kind && fault.wheel == wheel;
  });
}

DrawnPair drawn_pair(const geometry::PairData& of, const Angle& speed) {
  return deeply([&] {
    const auto pair = geometry::gear_pair<Deep>(of);
    const auto speeds = pair_speeds(pair, geometry::radians<Deep>(speed));
    const auto angle = [](const geometry::PressureAngle<Deep>& a) {
      return epure::to_double(arc_tangent(a.sine, a.cosine));
    };
    const Deep pitch = geometry::pi<Deep>() * geometry::from_rational<Deep>(of.m);
    DrawnPair drawn{.of = of,
                    .alpha = angle(pair.alpha),
                    .alpha_w = angle(pair.alpha_w),
                    .centre_distance = epure::to_double(pair.centre_distance),
                    .pitch = epure::to_double(pitch),
                    .base_pitch = epure::to_double(pitch * pair.alpha.cosine),
                    .wheel1 = drawn_wheel(pair, 1),
                    .wheel2 = {},
                    .O1 = epure::to_double(pair.O1),
                    .O2 = {},
                    .along = epure::to_double(pair.line_of_action.direction()),
                    .T1 = epure::to_double(pair.position(pair.T1)),
                    .T2 = {},
                    .A = double_if_there([&] { return pair.position(pair.A()); }),
                    .E = double_if_there([&] { return pair.position(pair.E()); }),
                    .omega_1 = epure::to_double(speeds.omega_1),
                    .omega_2 = epure::to_double(speeds.omega_2),
                    .faults = geometry::faults(of)};
    if (pair.O2) {
      drawn.wheel2 = drawn_wheel(pair, 2);
      drawn.O2 = epure::to_double(*pair.O2);
      drawn.T2 = epure::to_double(pair.position(*pair.T2));
    }
    if (drawn.has_contact()) drawn.path = path_of(drawn, pitch * pair.alpha.cosine);
    return drawn;
  });
}

}  // namespace epure::gear_pair
