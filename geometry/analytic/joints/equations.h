// The equations of all joints at one place (joint_equations.h), row by row.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/analytic/joints/states.h"

namespace epure::geometry::analytic::joints {

// Φ_k = 0 at one place: what is left of it, its slopes by the unknowns, and what of its second derivative is
// quadratic in the rates. J q' = rate, J q'' = second_rate - quadratic.
template <class T>
struct Equation {
  T residual;
  std::vector<std::pair<int, T>> slopes;
  T quadratic{0}, rate{0}, second_rate{0};
};

// A vector fixed in a link, in the plane: r, from the link's origin, and with it the point X.
template <class T>
struct End {
  int link;
  Complex<T> r, X, v;
  T omega;

  Complex<T> quadratic() const { return -(square(omega) * r); }
};

// Links that have the point: what stands first. None: all come later.
std::vector<int> links_at(const Linkage& linkage, const Hanging& hanging, int point);
// Whether an equation of the joint is one of these: `points` and `links` are all that is in it.
bool is_joined(const Linkage& linkage, const Hanging& hanging, std::initializer_list<int> points,
               std::initializer_list<int> links);

// What a gear says of one of its links where the angles of the other two are told: as drives tell them, or other
// gears.
struct ToldByGear {
  int link;
  Angle angle;
};
// Of every gear; none where its links turn as the linkage lets them, or by what other gears say.
std::vector<std::optional<ToldByGear>> told_by_gears(const Linkage& linkage);

// The equations at a place; rates of the links as they stand in `links` (zero where only places are looked for).
template <class T>
class JointEquations {
 public:
  JointEquations(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Hanging& hanging)
      : linkage_(linkage), links_(links), hanging_(hanging) {}

  // What the point, or that which the moving line of a block is given through, is driven by along the line: the
  // slopes of such an equation.
  Equation<T> sliding(const LineFriction& of) const {
    const bool is_of_block = of.is_of_block;
    const auto k = static_cast<std::size_t>(of.which);
    const int moving = is_of_block ? linkage_.blocks[k].moving : nothing,
              line = is_of_block ? linkage_.blocks[k].guide : linkage_.pins[k].line;
    return ahead_on(is_of_block ? end(linkage_.link_of_line(moving), linkage_.line(moving).through)
                                : end_at(linkage_.pins[k].point),
                    line);
  }

  // What a force at the pitch point does, of the first wheel on the second: along the line of centres, or a quarter
  // turn from it.
  Equation<T> pressing(const MeshingLinks& gear, bool is_radial) const {
    const Complex<T> apart = analytic::direction({nothing, {0, 0}, linkage_.line_of_centres(gear)},
                                                 links_[static_cast<std::size_t>(gear.carrier)]),
                     u = is_radial ? apart : times_i(apart), P = end(gear.carrier, linkage_.pitch_point(gear)).X;
    Equation<T> equation{.residual = T(0), .slopes = {}};
    for (const bool is_second : {true, false}) {
      const int wheel = is_second ? gear.second : gear.first;
      const LinkState<T>& state = links_[static_cast<std::size_t>(wheel)];
      const Complex<T> r = P - state.O, on_wheel = is_second ? u : -u;
      add(equation, {wheel, r, P, state.v, state.omega}, on_wheel, dot(on_wheel, times_i(r)));
    }
    return equation;
  }

  std::vector<Equation<T>> all() {
    for (int point = 0; point < linkage_.count_of_points(); ++point) {
      const std::vector<int> there = links_at(linkage_, hanging_, point);
      for (std::size_t k = 1; k < there.size(); ++k)
        if (is_joined({}, {there[0], there[k]}))
          hinge(end(there[0], linkage_.place(there[0], point)), end(there[k], linkage_.place(there[k], point)));
    }
    for (const PinOnLine& pin : linkage_.pins)
      if (is_joined({pin.point}, {linkage_.link_of_line(pin.line)})) beside(end_at(pin.point), pin.line);
    for (const LineOnLine& block : linkage_.blocks) {
      if (!is_joined({}, {linkage_.link_of_line(block.moving), linkage_.link_of_line(block.guide)})) continue;
      beside(end(linkage_.link_of_line(block.moving), linkage_.line(block.moving).through), block.guide);
      parallel(block);
    }
    const std::vector<std::optional<ToldByGear>> told = told_by_gears(linkage_);
    for (std::size_t k = 0; k < told.size(); ++k) {
      const MeshingLinks& gear = linkage_.gears[k];
      if (is_joined({}, {gear.first, gear.second, gear.carrier})) meshing(gear, told[k]);
    }
    for (const RollingWheel& roll : linkage_.rolls)
      if (is_joined({roll.centre}, {roll.wheel, linkage_.link_of_line(roll.line)})) rolling(roll);
    for (const Drive& drive : linkage_.drives)
      std::visit(
          [this](const auto& d) {
            if (is_joined(d)) driven(d);
          },
          drive);
    return std::move(equations_);
  }

 private:
  bool is_joined(std::initializer_list<int> points, std::initializer_list<int> links) const {
    return joints::is_joined(linkage_, hanging_, points, links);
  }
  bool is_joined(const TurnedLink& drive) const { return is_joined({}, {drive.link}); }
  bool is_joined(const SlidPoint& drive) const {
    return is_joined({drive.point}, {linkage_.link_of_line(drive.guide)});
  }
  bool is_joined(const Stretched& drive) const { return is_joined({drive.from, drive.to}, {}); }

  End<T> end_at(int point) const {
    const int link = links_at(linkage_, hanging_, point).front();
    return end(link, linkage_.place(link, point));
  }
  End<T> end(int link, const Own& own) const {
    const LinkState<T>& state = links_[static_cast<std::size_t>(link)];
    const Complex<T> r = Complex<T>{from_rational<T>(own.x), from_rational<T>(own.y)} * axis(link);
    return {link, r, state.O + r, state.v + state.omega * times_i(r), state.omega};
  }
  const Complex<T>& axis(int link) const { return links_[static_cast<std::size_t>(link)].x; }
  Complex<T> direction(int line) const {
    return analytic::direction(linkage_.line(line), links_[static_cast<std::size_t>(linkage_.link_of_line(line))]);
  }

  // Slopes of u . X for a fixed u, as part of an equation.
  void add(Equation<T>& equation, const End<T>& at, const Complex<T>& u, const T& by_turning) const {
    if (at.link == 0) return;  // the frame does not move
    const int first = unknowns_of_a_link * (at.link - 1);
    equation.slopes.emplace_back(first, u.re);
    equation.slopes.emplace_back(first + 1, u.im);
    equation.slopes.emplace_back(first + 2, by_turning);
  }

  void hinge(const End<T>& i, const End<T>& j) {
    const Complex<T> gap = i.X - j.X, quadratic = i.quadratic() - j.quadratic();
    for (const bool is_x : {true, false}) {
      const Complex<T> u = is_x ? Complex<T>{T(1), T(0)} : Complex<T>{T(0), T(1)};
      Equation<T> equation{.residual = is_x ? gap.re : gap.im, .slopes = {}};
      equation.quadratic = is_x ? quadratic.re : quadratic.im;
      add(equation, i, u, dot(u, times_i(i.r)));
      add(equation, j, -u, -dot(u, times_i(j.r)));
      equations_.push_back(std::move(equation));
    }
  }

  // X_i on the line: s x (X_i - G) = 0.
  void beside(const End<T>& i, int line) {
    const Complex<T> s = direction(line);
    const End<T> G = end(linkage_.link_of_line(line), linkage_.line(line).through);
    const Complex<T> D = i.X - G.X, D_rate = i.v - G.v, n = times_i(s);
    Equation<T> equation{.residual = dot(n, D), .slopes = {}};
    add(equation, i, n, dot(n, times_i(i.r)));
    add(equation, G, -n, -dot(s, D) - dot(n, times_i(G.r)));
    equation.quadratic =
        -(square(G.omega) * dot(n, D)) - T(2) * G.omega * dot(s, D_rate) + dot(n, i.quadratic() - G.quadratic());
    equations_.push_back(std::move(equation));
  }

  // The two lines of a block: s_j x s_i = 0.
  void parallel(const LineOnLine& block) {
    const int i = linkage_.link_of_line(block.moving), j = linkage_.link_of_line(block.guide);
    const Complex<T> s_i = direction(block.moving), s_j = direction(block.guide);
    const T turn = cross(s_j, s_i), slope = dot(s_j, s_i);
    const T relative = links_[static_cast<std::size_t>(i)].omega - links_[static_cast<std::size_t>(j)].omega;
    Equation<T> equation{.residual = turn, .slopes = {}, .quadratic = -(square(relative) * turn)};
    if (i != 0) equation.slopes.emplace_back(unknowns_of_a_link * i - 1, slope);
    if (j != 0) equation.slopes.emplace_back(unknowns_of_a_link * j - 1, -slope);
    equations_.push_back(std::move(equation));
  }

  void meshing(const MeshingLinks& gear, const std::optional<ToldByGear>& told) {
    const Rational m = gear.turns_of_second();
    Equation<T> equation{.residual = off_mesh(gear, told), .slopes = {}};
    for (const auto& [link, times] :
         {std::pair(gear.second, Rational(1)), {gear.first, Rational(-m)}, {gear.carrier, Rational(m - 1)}})
      if (link != 0) equation.slopes.emplace_back(unknowns_of_a_link * link - 1, from_rational<T>(times));
    equations_.push_back(std::move(equation));
  }
  // Where the number has no angles, and none is told: of whole times of them all, the square of the distance between
  // two axes.
  T off_mesh(const MeshingLinks& gear, const std::optional<ToldByGear>& told) const {
    const Rational m = gear.turns_of_second();
    if constexpr (NumberWithAngles<T>) {
      const auto theta = [&](int link) { return links_[static_cast<std::size_t>(link)].theta; };
      return theta(gear.second) - theta(gear.carrier) - radians<T>(gear.phase) -
             from_rational<T>(m) * (theta(gear.first) - theta(gear.carrier));
    } else {
      if (told) return off_axis(told->link, told->angle);
      constexpr int most = 100;
      const double whole = CGAL::to_double(Rational(m.denominator())), of_first = CGAL::to_double(m) * whole;
      if (whole > most || std::abs(of_first) > most)
        throw Undecided("the ratio of gears with that many teeth on exact numbers",
                        "il rapporto di ruote con tanti denti su numeri esatti");
      const int q = static_cast<int>(whole), p = static_cast<int>(std::round(of_first));
      const Angle phase = Rational(q) * gear.phase;
      const Complex<T> all =
          power(axis(gear.second), q) * power(axis(gear.first), -p) * power(axis(gear.carrier), p - q);
      return squared_modulus(all - Complex<T>{cosine<T>(phase), sine<T>(phase)});
    }
  }
  // Of a unit vector.
  static Complex<T> power(const Complex<T>& unit, int times) {
    const Complex<T> each = times < 0 ? conjugate(unit) : unit;
    Complex<T> all{T(1), T(0)};
    for (int i = std::abs(times); i > 0; --i) all = all * each;
    return all;
  }

  void rolling(const RollingWheel& roll) {
    const int carrier = linkage_.link_of_line(roll.line);
    const T r = from_rational<T>(roll.radius);
    Equation<T> equation = ahead_on(end_at(roll.centre), roll.line);
    if constexpr (NumberWithAngles<T>)
      equation.residual += r * (links_[static_cast<std::size_t>(roll.wheel)].theta -
                                links_[static_cast<std::size_t>(carrier)].theta - radians<T>(roll.phase)) -
                           from_rational<T>(roll.at);
    else
      throw Undecided("how far a wheel has rolled on exact numbers",
                      "quanto una ruota abbia rotolato su numeri esatti");
    equation.slopes.emplace_back(unknowns_of_a_link * roll.wheel - 1, r);
    if (carrier != 0) equation.slopes.emplace_back(unknowns_of_a_link * carrier - 1, -r);
    equations_.push_back(std::move(equation));
  }

  void driven(const TurnedLink& drive) {
    Equation<T> equation{.residual = off_angle(drive), .slopes = {{unknowns_of_a_link * drive.link - 1, T(1)}}};
    const bool counts_turns = !NumberWithAngles<T> && linkage_.is_turned_steadily();
    equation.rate = counts_turns ? from_rational<T>(drive.omega.turns) : radians<T>(drive.omega);
    equation.second_rate = counts_turns ? T(0) : radians<T>(drive.alpha);
    equations_.push_back(std::move(equation));
  }
  // θ_i - θ; the square of the distance between the two axes where the number has no angles.
  T off_angle(const TurnedLink& drive) const {
    if constexpr (NumberWithAngles<T>)
      return links_[static_cast<std::size_t>(drive.link)].theta - radians<T>(drive.angle);
    else
      return off_axis(drive.link, drive.angle);
  }
  T off_axis(int link, const Angle& angle) const {
    return squared_modulus(axis(link) - Complex<T>{cosine<T>(angle), sine<T>(angle)});
  }

  void driven(const SlidPoint& drive) {
    Equation<T> equation = ahead_on(end_at(drive.point), drive.guide);
    equation.residual -= from_rational<T>(drive.at);
    equation.rate = from_rational<T>(drive.velocity);
    equation.second_rate = from_rational<T>(drive.acceleration);
    equations_.push_back(std::move(equation));
  }
  // How far X_i is ahead of G on the line: s . (X_i - G).
  Equation<T> ahead_on(const End<T>& i, int line) const {
    const Complex<T> s = direction(line);
    const End<T> G = end(linkage_.link_of_line(line), linkage_.line(line).through);
    const Complex<T> D = i.X - G.X, D_rate = i.v - G.v;
    Equation<T> equation{.residual = dot(s, D), .slopes = {}};
    add(equation, i, s, dot(s, times_i(i.r)));
    add(equation, G, -s, cross(s, D) - dot(s, times_i(G.r)));
    equation.quadratic =
        -(square(G.omega) * dot(s, D)) + T(2) * G.omega * cross(s, D_rate) + dot(s, i.quadratic() - G.quadratic());
    return equation;
  }

  void driven(const Stretched& drive) {
    const End<T> i = end_at(drive.to), j = end_at(drive.from);
    const Complex<T> D = i.X - j.X, D_rate = i.v - j.v;
    const T l = from_rational<T>(drive.length), l_rate = from_rational<T>(drive.velocity);
    Equation<T> equation{.residual = squared_modulus(D) - square(l), .slopes = {}};
    add(equation, i, T(2) * D, T(2) * dot(D, times_i(i.r)));
    add(equation, j, T(-2) * D, T(-2) * dot(D, times_i(j.r)));
    equation.quadratic = T(2) * (squared_modulus(D_rate) + dot(D, i.quadratic() - j.quadratic()));
    equation.rate = T(2) * l * l_rate;
    equation.second_rate = T(2) * (square(l_rate) + l * from_rational<T>(drive.acceleration));
    equations_.push_back(std::move(equation));
  }

  const Linkage& linkage_;
  const std::vector<LinkState<T>>& links_;
  const Hanging& hanging_;
  std::vector<Equation<T>> equations_;
};

// Of all joints, at a place or with rates.
template <class T>
std::vector<Equation<T>> equations(const Linkage& linkage, const std::vector<LinkState<T>>& links) {
  return JointEquations<T>(linkage, links, all_links(linkage)).all();
}
template <class T>
std::vector<Equation<T>> equations(const Linkage& linkage, const Column<T>& q) {
  return equations(linkage, states(q));
}

// The rows of the drives are the last, in their order.
template <class T>
std::size_t row_of_drive(const Linkage& linkage, const std::vector<Equation<T>>& rows, std::size_t drive) {
  return rows.size() - linkage.drives.size() + drive;
}

// Of the row: J y.
template <class T>
T along(const Equation<T>& row, const Column<T>& y) {
  T sum(0);
  for (const auto& [column, slope] : row.slopes) sum += slope * y[static_cast<std::size_t>(column)];
  return sum;
}

}  // namespace epure::geometry::analytic::joints
