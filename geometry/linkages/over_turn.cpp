#include "geometry/linkages/over_turn.h"

#include <memory>

namespace epure::geometry {
namespace {

std::size_t at_index(int i) { return static_cast<std::size_t>(i); }

// The coefficients of the derivative: c[0] the first, c[1] the second, half the third.
template <class T>
using Slope = std::array<T, 3>;

template <class T>
Slope<T> slope_of(const Taylor<T, 3>& x) {
  return {x.c[1], T(2) * x.c[2], T(3) * x.c[3]};
}

// Of the angle of a unit vector: θ' = x × x'.
template <class T>
Slope<T> slope_of_angle(const Vector<Taylor<T, 3>>& x) {
  const Slope<T> along = slope_of(x.x), up = slope_of(x.y);
  Slope<T> slope{T(0), T(0), T(0)};
  for (std::size_t k = 0; k < slope.size(); ++k)
    for (std::size_t i = 0; i <= k; ++i) slope[k] += x.x.c[k - i] * up[i] - x.y.c[k - i] * along[i];
  return slope;
}

// Of a direction, but for whole turns: from the axis that lies nearest, so that nothing is cut.
template <class T>
T angle_but_for_turns(Vector<T> v) {
  int quarters = 0;
  for (; quarters < 3 && !(sign(v.x - v.y) == Sign::positive && sign(v.x + v.y) == Sign::positive); ++quarters)
    v = -quarter_turn(v);
  return arc_tangent(v.y, v.x) + quotient(T(quarters) * pi<T>(), T(2));
}

// `a_second`: by how much the angle grows in one; nothing: the number itself is asked for.
template <class T>
OverAngle<T> told(const T& value, const Slope<T>& slope, const std::optional<T>& a_second) {
  if (!a_second) return {value, slope[0], slope[1]};
  return {*a_second * slope[0], *a_second * slope[1], *a_second * T(2) * slope[2]};
}

template <class T>
std::function<OverAngle<T>(const T&)> over(const EveryPlace& places, const Linkage& linkage,
                                           const std::vector<Step>& steps,
                                           const std::variant<CoordinateOfPoint, DirectionOfLink>& of, bool is_rate) {
  using Series = Taylor<T, 3>;
  // Numbers of many bits are read again, with as many as are asked for then.
  const auto read = [&linkage, &steps] { return std::make_shared<const CarriedOut<Series>>(linkage, steps); };
  std::shared_ptr<const CarriedOut<Series>> kept;
  if constexpr (std::is_same_v<T, Bounded>) kept = read();
  return [&places, read, kept, of, is_rate](const T& at) {
    const auto carried_out = kept ? kept : read();
    const Series angle = Series::parameter(at);
    const LinkagePosition<Series> position =
        carried_out->position(places.drive<Series>({cosine_of_angle(angle), sine_of_angle(angle)}));
    std::optional<T> a_second;
    if (is_rate) a_second = quotient(carried_out->rates().front().first.c[0], T(places.turns()));
    if (const auto* coordinate = std::get_if<CoordinateOfPoint>(&of)) {
      const Point<Series>& P = position.points[at_index(coordinate->point)];
      const Series& x = coordinate->is_x ? P.x : P.y;
      return told(x.c[0], slope_of(x), a_second);
    }
    const Vector<Series>& x = position.links[at_index(std::get<DirectionOfLink>(of).link)].x;
    return told(is_rate ? T(0) : angle_but_for_turns<T>({x.x.c[0], x.y.c[0]}), slope_of_angle(x), a_second);
  };
}

}  // namespace

NumberOverAngle over_turn(const EveryPlace& places, const Linkage& linkage, const std::vector<Step>& steps,
                          const std::variant<CoordinateOfPoint, DirectionOfLink>& of, bool is_rate) {
  return {over<Bounded>(places, linkage, steps, of, is_rate), over<Deep>(places, linkage, steps, of, is_rate),
          std::holds_alternative<DirectionOfLink>(of) && !is_rate};
}

}  // namespace epure::geometry
