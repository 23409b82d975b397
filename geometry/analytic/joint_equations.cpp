#include "geometry/analytic/joint_equations.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include "geometry/analytic/inverse.h"
#include "geometry/linkages/friction_circles.h"

namespace epure::geometry::analytic {
namespace {

constexpr int unknowns_of_a_link = 3;  // x, y, θ

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
std::vector<int> links_at(const Linkage& linkage, const Hanging& hanging, int point) {
  std::vector<int> there = linkage.links_at(point);
  std::erase_if(there, [&](int link) { return !hanging.has(link); });
  std::stable_partition(there.begin(), there.end(), [&](int link) { return !hanging.places(link); });
  return there;
}
// Whether an equation of the joint is one of these: `points` and `links` are all that is in it.
bool is_joined(const Linkage& linkage, const Hanging& hanging, std::initializer_list<int> points,
               std::initializer_list<int> links) {
  bool places_one = false;
  for (const int link : links) {
    if (!hanging.has(link)) return false;
    places_one = places_one || hanging.places(link);
  }
  for (const int point : points) {
    const std::vector<int> there = links_at(linkage, hanging, point);
    if (there.empty()) return false;
    places_one = places_one || hanging.places(there.front());
  }
  return places_one;
}

// What a gear says of one of its links where the angles of the other two are told: as drives tell them, or other
// gears.
struct ToldByGear {
  int link;
  Angle angle;
};
// Of every gear; none where its links turn as the linkage lets them, or by what other gears say.
std::vector<std::optional<ToldByGear>> told_by_gears(const Linkage& linkage) {
  std::vector<std::optional<Angle>> known(linkage.links.size());
  const auto of = [&](int link) -> std::optional<Angle>& { return known[static_cast<std::size_t>(link)]; };
  of(0) = Angle{};
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive)) of(turned->link) = turned->angle;
  // θ_second - phase = m θ_first + (1 - m) θ_carrier
  const auto told = [&](const MeshingLinks& gear) -> std::optional<ToldByGear> {
    const Rational m = gear.turns_of_second();
    const auto &first = of(gear.first), &second = of(gear.second), &carrier = of(gear.carrier);
    if (first && carrier && !second)
      return ToldByGear{gear.second, gear.phase + m * *first + Rational(1 - m) * *carrier};
    if (second && carrier && !first)
      return ToldByGear{gear.first, Rational(1 / m) * (*second - gear.phase - Rational(1 - m) * *carrier)};
    if (first && second && !carrier && m != 1)
      return ToldByGear{gear.carrier, Rational(1 / Rational(1 - m)) * (*second - gear.phase - m * *first)};
    return {};
  };
  std::vector<std::optional<ToldByGear>> all(linkage.gears.size());
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (!all[k] && (all[k] = told(linkage.gears[k]))) {
        of(all[k]->link) = all[k]->angle;
        is_new = true;
      }
  }
  return all;
}

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
    return analytic::is_joined(linkage_, hanging_, points, links);
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

template <class T>
using Column = std::vector<T>;

template <class T>
std::vector<LinkState<T>> states(const Column<T>& q) {
  const Complex<T> none{T(0), T(0)};
  std::vector<LinkState<T>> links{{none, none, none, T(0), T(0), T(0), {T(1), T(0)}}};
  for (std::size_t k = 0; k < q.size(); k += unknowns_of_a_link)
    links.push_back(
        {{q[k], q[k + 1]}, none, none, q[k + 2], T(0), T(0), {cosine_of_angle(q[k + 2]), sine_of_angle(q[k + 2])}});
  return links;
}

// Where drives turn links, these stand as they are driven: of an angle that no number holds its sine and cosine may
// be whole, as at 180°.
template <class T>
std::vector<LinkState<T>> as_driven(const Linkage& linkage, const Column<T>& q) {
  std::vector<LinkState<T>> links = states(q);
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive)) {
      LinkState<T>& link = links[static_cast<std::size_t>(turned->link)];
      link.theta = radians<T>(turned->angle);
      link.x = {cosine<T>(turned->angle), sine<T>(turned->angle)};
    }
  return links;
}

// With these rates.
template <class T>
std::vector<LinkState<T>> moving(const Column<T>& q, const Column<T>& rates) {
  std::vector<LinkState<T>> links = states(q);
  for (std::size_t k = 0; k < rates.size(); k += unknowns_of_a_link) {
    LinkState<T>& link = links[k / unknowns_of_a_link + 1];
    link.v = Complex<T>{rates[k], rates[k + 1]};
    link.omega = rates[k + 2];
  }
  return links;
}

template <class T>
std::vector<Equation<T>> equations(const Linkage& linkage, const std::vector<LinkState<T>>& links) {
  return JointEquations<T>(linkage, links, all_links(linkage)).all();
}
template <class T>
std::vector<Equation<T>> equations(const Linkage& linkage, const Column<T>& q) {
  return equations(linkage, states(q));
}

Eigen::MatrixXd matrix(const std::vector<Equation<Fast>>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index row = 0; row < n; ++row)
    for (const auto& [column, slope] : rows[static_cast<std::size_t>(row)].slopes) J(row, column) += slope;
  return J;
}

// Newton's iteration in doubles: until the step no longer shrinks.
Column<Fast> iterated(const Linkage& linkage, Column<Fast> q) {
  constexpr int most_steps = 60;
  double last = HUGE_VAL;
  for (int k = 0; k < most_steps; ++k) {
    const std::vector<Equation<Fast>> rows = equations(linkage, q);
    Eigen::VectorXd residual(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) residual(static_cast<Eigen::Index>(i)) = rows[i].residual;
    const Eigen::VectorXd step = matrix(rows).partialPivLu().solve(residual);
    const double size = step.cwiseAbs().maxCoeff();
    if (!(size < HUGE_VAL)) break;
    if (size == 0 || (k > 3 && size >= last)) return q;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] -= step(static_cast<Eigen::Index>(i));
    last = size;
  }
  throw Undecided("Newton's iteration on the equations of all joints comes to no end",
                  "l'iterazione di Newton sulle equazioni di tutti i vincoli non ha fine");
}

// A matrix beside the inverse of the equations' one.
template <class T>
class Preconditioner {
 public:
  explicit Preconditioner(const std::vector<Equation<T>>& rows) {
    std::vector<Column<T>> J(rows.size(), Column<T>(rows.size(), T(0)));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [column, slope] : rows[i].slopes) J[i][static_cast<std::size_t>(column)] += slope;
    std::optional<std::vector<Column<T>>> near = inverse_near(J);
    if (!near)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
    Y_ = std::move(*near);
  }
  Column<T> times(const Column<T>& b) const {
    Column<T> product;
    for (const Column<T>& row : Y_) {
      T sum(0);
      for (std::size_t k = 0; k < b.size(); ++k) sum += row[k] * b[k];
      product.push_back(sum);
    }
    return product;
  }
  // 1 - Y J, row by row.
  std::vector<Column<T>> defect(const std::vector<Equation<T>>& rows) const {
    std::vector<Column<T>> E(Y_.size(), Column<T>(Y_.size(), T(0)));
    for (std::size_t i = 0; i < Y_.size(); ++i) {
      E[i][i] = T(1);
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (const auto& [column, slope] : rows[k].slopes) E[i][static_cast<std::size_t>(column)] -= Y_[i][k] * slope;
    }
    return E;
  }

 private:
  std::vector<Column<T>> Y_;
};

double near(Fast x) { return x; }
template <class T>
double near(const T& x) {
  return enclosure(x).value;
}

template <class T>
T size_of(const T& x) {
  return root(square(x));
}
// At least twice the upper end of what is not negative; an enclosure may reach down to zero.
template <class T>
T twice_the_most(const T& x) {
  return midpoint(T(4) * x);
}
template <class T>
bool may_be_zero_all(const Column<T>& b) {
  for (const T& x : b)
    if (const Sign decided = sign(x); decided == Sign::positive || decided == Sign::negative) return false;
  return true;
}
template <class T>
Column<T> residuals(const std::vector<Equation<T>>& rows) {
  Column<T> all;
  for (const Equation<T>& row : rows) all.push_back(row.residual);
  return all;
}

// The rows of the drives are the last, in their order.
template <class T>
std::size_t row_of_drive(const Linkage& linkage, const std::vector<Equation<T>>& rows, std::size_t drive) {
  return rows.size() - linkage.drives.size() + drive;
}

// As many equations as unknowns, at a place or over a box.
template <class T>
using System = std::function<std::vector<Equation<T>>(const Column<T>&)>;
// Of the links as they are driven: what says so of a turned one holds, and its angle is no unknown.
template <class T>
System<T> of_joints(const Linkage& linkage) {
  return [&linkage](const Column<T>& q) {
    std::vector<Equation<T>> rows = equations(linkage, as_driven(linkage, q));
    for (std::size_t k = 0; k < linkage.drives.size(); ++k)
      if (std::holds_alternative<TurnedLink>(linkage.drives[k])) rows[row_of_drive(linkage, rows, k)].residual = T(0);
    return rows;
  };
}
std::vector<bool> angles_of_drives(const Linkage& linkage) {
  std::vector<bool> given(unknowns_of_a_link * (linkage.links.size() - 1));
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive))
      given[static_cast<std::size_t>(unknowns_of_a_link * turned->link - 1)] = true;
  return given;
}

// Each step with the inverse at its place, until what is left of the equations cannot be told from zero, or a step is
// no shorter than the one before, and so but rounding.
template <class T>
Column<T> refined(const System<T>& system, Column<T> q) {
  constexpr int most_steps = 40;
  std::optional<T> last;
  for (int k = 0; k < most_steps; ++k) {
    const std::vector<Equation<T>> rows = system(q);
    if (may_be_zero_all(residuals(rows))) break;
    const Column<T> step = Preconditioner<T>(rows).times(residuals(rows));
    T length(0);
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = midpoint(q[i] - step[i]);
      length = midpoint(length + size_of(step[i]));
    }
    if (last && sign(*last - length) != Sign::positive) break;
    last = length;
  }
  return q;
}

// E x for x in ±size.
template <class T>
T spread(const Column<T>& row_of_E, const Column<T>& size) {
  T sum(0);
  for (std::size_t k = 0; k < size.size(); ++k) sum += size_of(row_of_E[k]) * size[k];
  return sum;
}

// Whatever place of the box the slopes are of, they are independent.
template <class T>
void demand_regular(const Preconditioner<T>& Y, const std::vector<Equation<T>>& rows) {
  const Column<T> ones(rows.size(), T(1));
  for (const Column<T>& row : Y.defect(rows))
    if (sign(T(1) - spread(row, ones)) != Sign::positive)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
}

// Krawczyk: K = m - Y Φ(m) + (1 - Y J(box)) (box - m). Where K lies inside the box there is a solution in it, and one
// only where the equations are independent all over it, which `solved` demands.
// (Krawczyk 1969; Neumaier, Interval Methods for Systems of Equations, section 5.1.) Of those `given` nothing is
// sought: the system takes them for what they are, whatever stands in m, and so does what is said of the others.
template <class T>
Column<T> proved_box(const System<T>& system, const Preconditioner<T>& Y, const Column<T>& m,
                     const std::vector<bool>& given) {
  Column<T> newton = Y.times(residuals(system(m)));
  for (std::size_t i = 0; i < m.size(); ++i)
    if (given[i]) newton[i] = T(0);
  Column<T> radius;
  for (const T& x : newton) radius.push_back(twice_the_most(size_of(x)));
  constexpr int most_boxes = 30;
  for (int k = 0; k < most_boxes; ++k) {
    Column<T> box;
    for (std::size_t i = 0; i < m.size(); ++i) box.push_back(widened(m[i], radius[i]));
    const std::vector<Column<T>> E = Y.defect(system(box));
    Column<T> needed, inside;
    bool is_inside = true;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const T around = given[i] ? T(0) : spread(E[i], radius);
      needed.push_back(size_of(newton[i]) + around);
      // An unknown that stands right already, whatever the others are, has a box without width.
      is_inside = is_inside && (sign(radius[i] - needed[i]) == Sign::positive || sign(needed[i]) == Sign::zero);
      inside.push_back(widened(m[i] - newton[i], around));
    }
    if (is_inside) return inside;
    for (std::size_t i = 0; i < m.size(); ++i) radius[i] = twice_the_most(needed[i]);
  }
  throw Undecided("no box around the last iterate is proved to hold one solution of the equations of all joints",
                  "di nessun intorno dell'ultima iterata è dimostrato che contenga una soluzione delle equazioni di "
                  "tutti i vincoli");
}

// Which unknowns are zero whatever the slopes are, by which of the right sides are: each equation takes an unknown of
// its own; where it and all that it hangs on, by the unknowns in it, have a right side of zero, those unknowns are in
// no more equations than they are, and so all zero.
template <class T>
class ZeroByStructure {
 public:
  explicit ZeroByStructure(const std::vector<Equation<T>>& rows)
      : takes_(rows.size(), none), taken_by_(rows.size(), none) {
    for (const Equation<T>& row : rows) {
      std::vector<std::size_t>& in = unknowns_.emplace_back();
      for (const auto& [column, slope] : row.slopes)
        if (sign(slope) != Sign::zero) in.push_back(static_cast<std::size_t>(column));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<bool> is_asked(rows.size());
      takes_one(i, is_asked);
    }
  }
  std::vector<bool> of(const Column<T>& b) const {
    std::vector<bool> all(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      std::vector<bool> hangs_on(b.size());
      if (takes_[i] != none && is_idle(i, b, hangs_on)) all[takes_[i]] = true;
    }
    return all;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool takes_one(std::size_t row, std::vector<bool>& is_asked) {
    for (const std::size_t unknown : unknowns_[row]) {
      if (is_asked[unknown]) continue;
      is_asked[unknown] = true;
      if (taken_by_[unknown] != none && !takes_one(taken_by_[unknown], is_asked)) continue;
      taken_by_[unknown] = row;
      takes_[row] = unknown;
      return true;
    }
    return false;
  }
  bool is_idle(std::size_t row, const Column<T>& b, std::vector<bool>& hangs_on) const {
    hangs_on[row] = true;
    return sign(b[row]) == Sign::zero &&
           std::all_of(unknowns_[row].begin(), unknowns_[row].end(), [&](std::size_t unknown) {
             const std::size_t next = taken_by_[unknown];
             return next != none && (hangs_on[next] || is_idle(next, b, hangs_on));
           });
  }

  std::vector<std::vector<std::size_t>> unknowns_;
  std::vector<std::size_t> takes_, taken_by_;
};

// J x = b, enclosed: x0 by the preconditioner until that brings no more, then what may be left.
template <class T>
Column<T> solved(const std::vector<Equation<T>>& rows, const Preconditioner<T>& Y, const Column<T>& b) {
  const std::vector<Column<T>> E = Y.defect(rows);
  Column<T> x;
  for (const T& y : Y.times(b)) x.push_back(midpoint(y));
  const auto left = [&] {
    Column<T> r = b;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [column, slope] : rows[i].slopes) r[i] -= slope * x[static_cast<std::size_t>(column)];
    return Y.times(r);
  };
  Column<T> step = left();
  constexpr int most_steps = 400;
  for (int k = 0; k < most_steps && !may_be_zero_all(step); ++k) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = midpoint(x[i] + step[i]);
    step = left();
  }
  // |x - x0| <= |step| + |E| |x - x0|, and each row of |E| has a sum below a half.
  T most(0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (sign(from_rational<T>(Rational(1, 2)) - spread(E[i], Column<T>(x.size(), T(1)))) != Sign::positive)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
    most += T(2) * size_of(step[i]);
  }
  const Column<T> off(x.size(), most);
  const std::vector<bool> is_zero = ZeroByStructure<T>(rows).of(b);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = is_zero[i] ? T(0) : widened(x[i] + step[i], spread(E[i], off));
  return x;
}

Column<Fast> solved(const std::vector<Equation<Fast>>& rows, const Column<Fast>& b) {
  const Eigen::VectorXd x = matrix(rows).partialPivLu().solve(
      Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Eigen::Index>(b.size())));
  return {x.data(), x.data() + x.size()};
}

// The solution of J x = b.
template <class T>
using SolveRates = std::function<Column<T>(const std::vector<Equation<T>>& J, const Column<T>& b)>;

// Of the row: J y.
template <class T>
T along(const Equation<T>& row, const Column<T>& y) {
  T sum(0);
  for (const auto& [column, slope] : row.slopes) sum += slope * y[static_cast<std::size_t>(column)];
  return sum;
}

template <class T>
void demand_zero(const T& x) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided)
    throw Undecided("whether what was constructed satisfies the equations of all joints",
                    "se quanto costruito soddisfi le equazioni di tutti i vincoli");
  if (decided != Sign::zero)
    throw Impossible("what was constructed does not satisfy the equations of all joints",
                     "quanto costruito non soddisfa le equazioni di tutti i vincoli");
}

// The first derivatives of the unknowns, or the second ones.
template <class T>
Column<T> rates_of(const std::vector<LinkState<T>>& links, bool is_first) {
  Column<T> rates;
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Complex<T>& of_origin = is_first ? links[i].v : links[i].a;
    for (const T& rate : {of_origin.re, of_origin.im, is_first ? links[i].omega : links[i].alpha})
      rates.push_back(rate);
  }
  return rates;
}

// The links that do not turn, as lines led in lines begin at the frame: there s_i x s_j = 0 says ω_i = ω_j = 0, which
// enclosures would only nearly say.
std::vector<bool> led_without_turning(const Linkage& linkage) {
  std::vector<bool> led(linkage.links.size());
  led[0] = true;
  for (std::size_t farther = 0; farther < linkage.blocks.size(); ++farther)
    for (const LineOnLine& block : linkage.blocks) {
      const auto i = static_cast<std::size_t>(linkage.link_of_line(block.moving)),
                 j = static_cast<std::size_t>(linkage.link_of_line(block.guide));
      if (led[i] || led[j]) led[i] = led[j] = true;
    }
  return led;
}

template <class T>
std::vector<LinkState<T>> with_rates(const Linkage& linkage, const Column<T>& q, const SolveRates<T>& solve) {
  std::vector<LinkState<T>> links = as_driven(linkage, q);
  const std::vector<bool> led = led_without_turning(linkage);
  const auto take = [&](const Column<T>& rates, bool is_first) {
    for (std::size_t k = 0; k < rates.size(); k += unknowns_of_a_link) {
      const std::size_t i = k / unknowns_of_a_link + 1;
      LinkState<T>& link = links[i];
      (is_first ? link.v : link.a) = Complex<T>{rates[k], rates[k + 1]};
      (is_first ? link.omega : link.alpha) = led[i] ? T(0) : rates[k + 2];
    }
  };
  Column<T> b;
  const std::vector<Equation<T>> at_rest = equations(linkage, links);
  for (const Equation<T>& row : at_rest) b.push_back(row.rate);
  take(solve(at_rest, b), true);
  b.clear();
  for (const Equation<T>& row : equations(linkage, links)) b.push_back(row.second_rate - row.quadratic);
  take(solve(at_rest, b), false);
  return links;
}

Fast point_in(Fast x) { return x; }
Bounded point_in(const Bounded& x) { return midpoint(x); }
Deep point_in(const Deep& x) { return midpoint(x); }

// With half of the digits.
Fast about(Fast x) { return static_cast<double>(static_cast<float>(x)); }
Bounded about(const Bounded& x) { return about(enclosure(x).value); }
Deep about(const Deep& x) {
  const Arithmetic<Deep> scope(Arithmetic<Deep>::bits() / 2);
  return midpoint(x + Deep(0));
}

// Where the wheel points, where the beginning has its centre, in doubles.
template <class T>
double rolled_to(const Linkage& linkage, const RollingWheel& roll, const Beginning<T>& beginning, double carrier) {
  const LinkLine& line = linkage.line(roll.line);
  const LinkState<T>&body = beginning[static_cast<std::size_t>(linkage.link_of_line(roll.line))],
        &wheel = beginning[static_cast<std::size_t>(roll.wheel)];
  const T ahead = dot(direction(line, body),
                      point_of(wheel, linkage.place(roll.wheel, roll.centre)).z - point_of(body, line.through).z);
  return carrier + to_double(roll.phase) + (CGAL::to_double(roll.at) - near(ahead)) / CGAL::to_double(roll.radius);
}

// Without the frame. The angle of a link that is turned has as many whole turns as it is given with, or the first
// step would turn the link by these.
template <class T>
Column<T> moving_links(const Linkage& linkage, const Beginning<T>& beginning) {
  std::vector<double> turned;
  for (const LinkState<T>& link : beginning) turned.push_back(near(link.theta));
  for (const Drive& drive : linkage.drives)
    if (const auto* crank = std::get_if<TurnedLink>(&drive))
      turned[static_cast<std::size_t>(crank->link)] = to_double(crank->angle);
  Column<T> q;
  for (std::size_t i = 1; i < beginning.size(); ++i) {
    const auto &O = beginning[i].O, &x = beginning[i].x;
    const T angle = about(arc_tangent(point_in(x.im), point_in(x.re)));
    const double turns = std::round((turned[i] - near(angle)) / (2 * pi<Fast>()));
    const T theta = angle + from_rational<T>(Rational(2 * turns)) * pi<T>();
    q.insert(q.end(), {point_in(O.re), point_in(O.im), point_in(theta)});
  }
  for (const RollingWheel& roll : linkage.rolls) {
    const auto theta = [&](int link) {
      return link == 0 ? 0 : near(q[static_cast<std::size_t>(unknowns_of_a_link * link - 1)]);
    };
    const int carrier = linkage.link_of_line(roll.line);
    const double turns =
        std::round((rolled_to(linkage, roll, beginning, theta(carrier)) - theta(roll.wheel)) / (2 * pi<Fast>()));
    T& of_wheel = q[static_cast<std::size_t>(unknowns_of_a_link * roll.wheel - 1)];
    of_wheel = point_in(of_wheel + from_rational<T>(Rational(2 * turns)) * pi<T>());
  }
  return q;
}

std::vector<LinkState<Fast>> found(const Linkage& linkage, const Beginning<Fast>& beginning) {
  return with_rates<Fast>(
      linkage, iterated(linkage, moving_links(linkage, beginning)),
      [](const std::vector<Equation<Fast>>& rows, const Column<Fast>& b) { return solved(rows, b); });
}

template <class T>
std::vector<LinkState<T>> proved_near(const Linkage& linkage, const Column<T>& last) {
  const System<T> system = of_joints<T>(linkage);
  const Preconditioner<T> Y(system(last));
  const Column<T> q = proved_box(system, Y, last, angles_of_drives(linkage));
  return with_rates<T>(linkage, q,
                       [&](const std::vector<Equation<T>>& rows, const Column<T>& b) { return solved(rows, Y, b); });
}

std::vector<LinkState<Bounded>> found(const Linkage& linkage, const Beginning<Bounded>& beginning) {
  Column<Fast> start;
  for (const Bounded& x : moving_links(linkage, beginning)) start.push_back(near(x));
  Column<Bounded> last;
  for (const double x : iterated(linkage, start)) last.emplace_back(x);
  return proved_near(linkage, refined(of_joints<Bounded>(linkage), last));
}

std::vector<LinkState<Deep>> found(const Linkage& linkage, const Beginning<Deep>& beginning) {
  return proved_near(linkage, refined(of_joints<Deep>(linkage), moving_links(linkage, beginning)));
}

// The links' places, and how they move while all drives stand still (solve_dead_point).
template <class T>
class AtDeadPoint {
 public:
  AtDeadPoint(const Linkage& linkage, int drive, std::size_t kept_one)
      : linkage_(linkage), drive_(static_cast<std::size_t>(drive)), kept_one_(kept_one) {}

  std::vector<Equation<T>> operator()(const Column<T>& places_and_motion) const {
    const auto half = static_cast<std::ptrdiff_t>(places_and_motion.size() / 2);
    const Column<T> q(places_and_motion.begin(), places_and_motion.begin() + half),
        n(places_and_motion.begin() + half, places_and_motion.end());
    const std::vector<Equation<T>> rows = equations(linkage_, q);
    const std::size_t driven = row_of_drive(linkage_, rows, drive_);
    std::vector<Equation<T>> all;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (i != driven) all.push_back({.residual = rows[i].residual, .slopes = rows[i].slopes});
    const std::size_t first = all.size();
    for (const Equation<T>& row : rows) {
      Equation<T>& still = all.emplace_back(Equation<T>{.residual = along(row, n), .slopes = {}});
      for (const auto& [column, slope] : row.slopes) still.slopes.emplace_back(column + half, slope);
    }
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Column<T> with = second_along(q, n, j, T(1)), without = second_along(q, n, j, T(-1));
      for (std::size_t i = 0; i < rows.size(); ++i)
        all[first + i].slopes.emplace_back(static_cast<int>(j), quotient(with[i] - without[i], T(4)));
    }
    all.push_back({.residual = n[kept_one_] - T(1), .slopes = {{half + static_cast<int>(kept_one_), T(1)}}});
    return all;
  }

 private:
  // Φ''(n ± e, n ± e): of both 4 Φ''(n, e) is left.
  Column<T> second_along(const Column<T>& q, Column<T> n, std::size_t j, const T& sense) const {
    n[j] += sense;
    Column<T> all;
    for (const Equation<T>& row : equations(linkage_, moving(q, n))) all.push_back(row.quadratic);
    return all;
  }

  const Linkage& linkage_;
  std::size_t drive_, kept_one_;
};

// The motion that all equations let be, as nearly as doubles have it.
Column<Fast> motion_at_rest(const Linkage& linkage, const Column<Fast>& q) {
  const Eigen::VectorXd n =
      Eigen::JacobiSVD<Eigen::MatrixXd>(matrix(equations(linkage, q)), Eigen::ComputeFullV).matrixV().rightCols(1);
  return {n.data(), n.data() + n.size()};
}

// Whether a solution is the one that was meant, whatever it was looked for from.
template <class T>
class Sides {
 public:
  Sides(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Hanging& hanging)
      : linkage_(linkage), links_(links), hanging_(hanging) {}

  // Of every joint: no where one is proved to lie on the other side.
  Truth are_as_meant() const {
    bool is_open = false;
    const auto look = [&](const T& ahead) {  // zero where the two places are one
      const Sign decided = sign(ahead);
      is_open = is_open || decided == Sign::undecided;
      return decided != Sign::negative;
    };
    for (const Chosen& chosen : linkage_.chosen)
      if (std::visit([this](const auto& side) { return is_joined(side); }, chosen) &&
          !look(std::visit([this](const auto& side) { return ahead(side); }, chosen)))
        return Truth::no;
    for (const LineOnLine& block : linkage_.blocks)  // the equations hold for both ways it can lie in its guide
      if (analytic::is_joined(linkage_, hanging_, {},
                              {linkage_.link_of_line(block.moving), linkage_.link_of_line(block.guide)}) &&
          !look(dot(direction(block.moving), direction(block.guide))))
        return Truth::no;
    return is_open ? Truth::undecided : Truth::yes;
  }

 private:
  bool is_joined(const BesideLine& side) const {
    return analytic::is_joined(linkage_, hanging_, {side.joint, side.from, side.to}, {});
  }
  bool is_joined(const OnGuide& side) const {
    demand_told(side.guide != nothing && side.other_end != nothing);
    return analytic::is_joined(linkage_, hanging_, {side.joint, side.other_end}, {linkage_.link_of_line(side.guide)});
  }
  bool is_joined(const SlotPoints& side) const {
    demand_told(side.hinge != nothing && side.pin != nothing);
    return analytic::is_joined(linkage_, hanging_, {side.pin, side.hinge}, {linkage_.link_of_line(side.line)});
  }
  // Positive in the place that is meant, negative in the other.
  T ahead(const BesideLine& side) const {
    const Complex<T> P = at(side.from);
    const T left = cross(at(side.to) - P, at(side.joint) - P);
    return side.is_left ? left : -left;
  }
  T ahead(const OnGuide& side) const {
    const T ahead = dot(direction(side.guide), at(side.joint) - at(side.other_end));
    return side.is_ahead ? ahead : -ahead;
  }
  T ahead(const SlotPoints& side) const {
    const T towards = dot(direction(side.line), at(side.pin) - at(side.hinge));
    return side.is_towards_pin ? towards : -towards;
  }
  static void demand_told(bool is_told) {
    if (!is_told)
      throw Undecided("a side is not told in full: from which point",
                      "un lato non è detto per intero: da quale punto");
  }

  Complex<T> at(int point) const {
    const int link = links_at(linkage_, hanging_, point).front();
    return point_of(links_[static_cast<std::size_t>(link)], linkage_.place(link, point)).z;
  }
  Complex<T> direction(int line) const {
    return analytic::direction(linkage_.line(line), links_[static_cast<std::size_t>(linkage_.link_of_line(line))]);
  }

  const Linkage& linkage_;
  const std::vector<LinkState<T>>& links_;
  const Hanging& hanging_;
};

template <class T>
void demand_sides(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Hanging& hanging) {
  const Truth as_meant = Sides<T>(linkage, links, hanging).are_as_meant();
  if (as_meant == Truth::undecided)
    throw Undecided("whether a joint lies on the side that was said", "se un nodo stia dalla parte che si è detta");
  if (as_meant == Truth::no)
    throw Impossible("a joint lies on the other side than was said",
                     "un nodo sta dalla parte opposta a quella che si è detta");
}

// Forces on the links' origins along x and y, and moments about them.
template <class T>
Column<T> loads_on_links(const std::vector<LinkState<T>>& links, const Loads& loads, Inertia inertia) {
  Column<T> all(unknowns_of_a_link * (links.size() - 1), T(0));
  const auto of_link = [&](int link, std::size_t which) -> T& {
    return all[unknowns_of_a_link * (static_cast<std::size_t>(link) - 1) + which];
  };
  const auto add = [&](int link, const Own& at, const Complex<T>& F) {
    const LinkState<T>& state = links[static_cast<std::size_t>(link)];
    of_link(link, 0) += F.re;
    of_link(link, 1) += F.im;
    of_link(link, 2) += cross(point_of(state, at).z - state.O, F);
  };
  for (const LinkForce& load : loads.forces)
    if (load.link != 0)
      add(load.link, load.at,
          Complex<T>{from_rational<T>(load.components.x), from_rational<T>(load.components.y)} *
              Complex<T>{cosine<T>(load.turned), sine<T>(load.turned)});
  for (const LinkCouple& load : loads.couples)
    if (load.link != 0) of_link(load.link, 2) += from_rational<T>(load.moment);
  for (const LinkMass& body : loads.masses) {
    const T m = from_rational<T>(body.mass);
    add(body.link, body.at, m * Complex<T>{from_rational<T>(loads.gravity.x), from_rational<T>(loads.gravity.y)});
    if (inertia == Inertia::left_out) continue;
    const MassInMotion<T> moving = in_motion(body, links[static_cast<std::size_t>(body.link)]);
    add(body.link, body.at, -(m * Complex<T>{moving.a_x, moving.a_y}));
    of_link(body.link, 2) -= from_rational<T>(body.inertia) * moving.alpha;
  }
  return all;
}

// J^T, row by row.
template <class T>
std::vector<Equation<T>> transposed(const std::vector<Equation<T>>& rows) {
  std::vector<Equation<T>> columns(rows.size(), Equation<T>{.residual = T(0), .slopes = {}});
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [column, slope] : rows[i].slopes)
      columns[static_cast<std::size_t>(column)].slopes.emplace_back(static_cast<int>(i), slope);
  return columns;
}

// Multipliers in the order of the equations, and the forces that they are. `take` is called with the force and its
// multiplier's factor: force = factor * λ.
template <class T, class Take>
void for_each_force(const Linkage& linkage, JointForces<T>& forces, const Take& take) {
  for (auto& hinge : forces.hinges) {
    take(hinge.x, Rational(-1));
    take(hinge.y, Rational(-1));
  }
  for (T& pin : forces.pins) take(pin, Rational(1));
  for (auto& guide : forces.guides) {
    take(guide.force, Rational(1));
    take(guide.couple, Rational(1));
  }
  for (auto& tooth : forces.teeth) take(tooth.tangential, Rational(1));
  for (std::size_t i = 0; i < linkage.drives.size(); ++i) {
    const auto* cylinder = std::get_if<Stretched>(&linkage.drives[i]);
    take(forces.drives[i], cylinder ? Rational(2) * cylinder->length : Rational(1));
  }
}
// Where the multipliers of the pins, the blocks and the gears begin.
struct Multipliers {
  std::size_t pins, blocks, gears;
  explicit Multipliers(const Linkage& linkage)
      : pins(2 * JointForces<Fast>(linkage).hinges.size()),
        blocks(pins + linkage.pins.size()),
        gears(blocks + 2 * linkage.blocks.size()) {}
};

[[noreturn]] void refuse_angles() {
  throw Undecided("the equations of all joints are solved for angles, which are no algebraic numbers",
                  "le equazioni di tutti i vincoli si risolvono negli angoli, che non sono numeri algebrici");
}

// The links of these equations, a row each.
std::vector<std::vector<int>> links_of_equations(const Linkage& linkage, const Hanging& hanging) {
  const std::vector<LinkState<Fast>> anywhere = states(Column<Fast>(unknowns_of_a_link * (linkage.links.size() - 1)));
  std::vector<std::vector<int>> all;
  for (const Equation<Fast>& row : JointEquations<Fast>(linkage, anywhere, hanging).all()) {
    std::vector<int>& links = all.emplace_back();
    for (const auto& [column, slope] : row.slopes) links.push_back(column / unknowns_of_a_link + 1);
  }
  return all;
}

// What acts beside what presses, so many times its size: friction, which does work with what slides, and the part of
// a tooth's force along the line of centres.
template <class T>
struct Beside {
  std::size_t multiplier;  // of what presses
  Equation<T> along;
  T slope;  // against `along`
};
// Of all friction, and then of all gears.
template <class T>
std::vector<Beside<T>> beside_what_presses(const Linkage& linkage, const std::vector<LinkState<T>>& links,
                                           const Loads& loads) {
  const Hanging whole = all_links(linkage);
  const JointEquations<T> joints(linkage, links, whole);
  const Column<T> rates = rates_of(links, true);
  const Multipliers at(linkage);
  std::vector<Beside<T>> all;
  for (const LineFriction& each : loads.frictions) {
    const auto k = static_cast<std::size_t>(each.which);
    Equation<T> sliding = joints.sliding(each);
    const int sense = sense_of_sliding(along(sliding, rates));
    all.push_back(
        {each.is_of_block ? at.blocks + 2 * k : at.pins + k, std::move(sliding), T(sense) * each.coefficient<T>()});
  }
  for (std::size_t k = 0; k < linkage.gears.size(); ++k) {
    const MeshingLinks& gear = linkage.gears[k];
    all.push_back({at.gears + k, joints.pressing(gear, true), -slope_of_teeth<T>(gear)});
  }
  return all;
}
template <class T>
T& beside(JointForces<T>& forces, const Loads& loads, std::size_t i) {
  const std::size_t frictions = loads.frictions.size();
  return i < frictions ? forces.friction(loads.frictions[i]) : forces.teeth[i - frictions].radial;
}
template <class T>
const T& pressing(const JointForces<T>& forces, const Loads& loads, std::size_t i) {
  const std::size_t frictions = loads.frictions.size();
  return i < frictions ? forces.normal(loads.frictions[i]) : forces.teeth[i - frictions].tangential;
}

// The equilibrium of all links: what each force of a joint does to them. (That wheels mesh is an equation of their
// angles; what their teeth do to each other acts in the pitch point.)
template <class T>
std::vector<Equation<T>> equilibrium(const Linkage& linkage, const std::vector<LinkState<T>>& links) {
  std::vector<Equation<T>> rows = equations(linkage, links);
  const Hanging whole = all_links(linkage);
  const JointEquations<T> joints(linkage, links, whole);
  const Multipliers at(linkage);
  for (std::size_t k = 0; k < linkage.gears.size(); ++k)
    rows[at.gears + k] = joints.pressing(linkage.gears[k], false);
  return transposed(rows);
}

// What is left over of a sum of forces on exact numbers.
template <class T>
void demand_in_equilibrium(const T& left_over) {
  const Sign left = sign(left_over);
  if (left == Sign::undecided)
    throw Undecided("whether the forces found hold all links in equilibrium",
                    "se le forze trovate tengano in equilibrio tutti i membri");
  if (left != Sign::zero)
    throw Impossible("the forces found do not hold all links in equilibrium",
                     "le forze trovate non tengono in equilibrio tutti i membri");
}

template <class T>
T magnitude_proved(const T& x) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided)
    throw Undecided("from which side a guide presses", "da quale parte prema una guida");
  return decided == Sign::negative ? -x : x;
}

// The equilibrium under friction with one set of senses.
template <class T>
class WithSenses {
 public:
  WithSenses(const std::vector<Equation<T>>& columns, const std::vector<Beside<T>>& rubbing,
             const std::vector<int>& senses)
      : equations_(columns) {
    for (std::size_t i = 0; i < rubbing.size(); ++i) {
      slopes_.push_back(T(senses[i]) * rubbing[i].slope);
      for (const auto& [column, slope] : rubbing[i].along.slopes)
        equations_[static_cast<std::size_t>(column)].slopes.emplace_back(static_cast<int>(rubbing[i].multiplier),
                                                                         -(slopes_[i] * slope));
    }
    if constexpr (!std::is_same_v<T, Fast>) inverse_.emplace(equations_);
  }
  JointForces<T> forces(const Linkage& linkage, const Loads& loads, const Column<T>& borne) const {
    const Column<T> multipliers = solution(borne);
    JointForces<T> all(linkage);
    std::size_t next = 0;
    for_each_force(linkage, all,
                   [&](T& force, const Rational& factor) { force = from_rational<T>(factor) * multipliers[next++]; });
    for (std::size_t i = 0; i < slopes_.size(); ++i) beside(all, loads, i) = -(slopes_[i] * pressing(all, loads, i));
    return all;
  }

 private:
  Column<T> solution(const Column<T>& borne) const {
    if constexpr (std::is_same_v<T, Fast>)
      return solved(equations_, borne);
    else
      return solved(equations_, *inverse_, borne);
  }

  std::vector<Equation<T>> equations_;
  std::vector<T> slopes_;
  std::optional<Preconditioner<T>> inverse_ = {};
};

template <class T>
FrictionCircles<T> friction_circles(const Linkage& linkage, const std::vector<LinkState<T>>& links,
                                    const Loads& loads) {
  std::vector<T> turning;
  for (const auto& hinge : JointForces<T>(linkage).hinges)
    turning.push_back(links[static_cast<std::size_t>(hinge.on)].omega -
                      links[static_cast<std::size_t>(hinge.by)].omega);
  return {linkage, loads, turning};
}
template <class T>
void add_couple(const typename JointForces<T>::Hinge& hinge, const T& couple, Column<T>& acting) {
  const auto on_link = [&](int link) -> T& {
    return acting[unknowns_of_a_link * static_cast<std::size_t>(link) - 1];
  };
  if (hinge.on != 0) on_link(hinge.on) += couple;
  if (hinge.by != 0) on_link(hinge.by) -= couple;
}

template <class T>
JointForces<T> forces_found(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                            Inertia inertia) {
  const std::vector<Equation<T>> columns = equilibrium(linkage, links);
  const Column<T> acting = loads_on_links(links, loads, inertia);
  const std::vector<Beside<T>> rubbing = beside_what_presses(linkage, links, loads);
  const JointForces<T> none(linkage);
  const FrictionCircles<T> circles = friction_circles(linkage, links, loads);
  return forces_with_friction<JointForces<T>>(
      rubbing.size(),
      [&](const std::vector<int>& senses) {
        const WithSenses<T> held(columns, rubbing, senses);
        return circles.forces([&](const std::vector<T>& couples, bool is_loaded) {
          Column<T> borne;
          for (const T& load : acting) borne.push_back(is_loaded ? -load : T(0));
          for (std::size_t k = 0; k < couples.size(); ++k) add_couple(none.hinges[k], -couples[k], borne);
          JointForces<T> forces = held.forces(linkage, loads, borne);
          for (std::size_t k = 0; k < couples.size(); ++k) forces.hinges[k].couple = couples[k];
          return forces;
        });
      },
      [&](const JointForces<T>& found, std::size_t i) { return pressing(found, loads, i); },
      [](const JointForces<T>& a, const JointForces<T>& b) { return either(a, b); });
}

}  // namespace

Hanging all_links(const Linkage& linkage) {
  Hanging all{std::vector<bool>(linkage.links.size(), false), std::vector<bool>(linkage.links.size(), true)};
  all.stands[0] = true;
  all.is_placed[0] = false;
  return all;
}

std::vector<Hanging> one_after_another(const Linkage& linkage, const std::vector<std::vector<int>>& order) {
  std::vector<Hanging> all;
  const std::vector<bool> none(linkage.links.size(), false);
  Hanging next{none, none};
  next.stands[0] = true;
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const int link : order[k]) next.is_placed[static_cast<std::size_t>(link)] = true;
    const auto unknowns = unknowns_of_a_link * std::count(next.is_placed.begin(), next.is_placed.end(), true);
    const std::vector<std::vector<int>> rows = links_of_equations(linkage, next);
    // Wheels may hang on each other in another order: then they are placed together.
    const bool is_whole = static_cast<std::ptrdiff_t>(rows.size()) == unknowns || k + 1 == order.size();
    if (unknowns == 0 || !is_whole) continue;
    std::set<int> on;
    for (const std::vector<int>& row : rows) on.insert(row.begin(), row.end());
    std::copy_if(on.begin(), on.end(), std::back_inserter(next.on), [&](int link) { return !next.places(link); });
    all.push_back(next);
    for (std::size_t i = 0; i < none.size(); ++i) next.stands[i] = next.has(static_cast<int>(i));
    next.is_placed = none;
    next.on.clear();
  }
  return all;
}

template <class T>
std::vector<LinkState<T>> solve_joints(const Linkage& linkage, const Beginning<T>& beginning) {
  if constexpr (!NumberWithAngles<T>) {
    refuse_angles();
  } else {
    std::vector<LinkState<T>> links = found(linkage, beginning);
    // An iteration that went astray says nothing of the linkage.
    const Hanging all = all_links(linkage);
    if (Sides<T>(linkage, links, all).are_as_meant() == Truth::no &&
        Sides<T>(linkage, beginning, all).are_as_meant() != Truth::no)
      throw Undecided("the iteration came to the place of a joint on the other side than was said",
                      "l'iterazione è arrivata al posto di un nodo dalla parte opposta a quella detta");
    demand_sides(linkage, links, all);
    return links;
  }
}

template <class T>
std::vector<LinkState<T>> solve_dead_point(const Linkage& linkage, int drive, const Beginning<T>& beginning) {
  Column<T> start = moving_links(linkage, beginning);
  Column<Fast> place;
  for (const T& x : start) place.push_back(near(x));
  const Column<Fast> motion = motion_at_rest(linkage, place);
  const auto kept =
      std::max_element(motion.begin(), motion.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (const double rate : motion) start.push_back(from_rational<T>(Rational(rate / *kept)));
  const AtDeadPoint<T> system(linkage, drive, static_cast<std::size_t>(kept - motion.begin()));
  const Column<T> last = refined<T>(system, start);
  const Preconditioner<T> Y(system(last));
  const Column<T> box = proved_box<T>(system, Y, last, std::vector<bool>(last.size()));
  demand_regular(Y, system(box));
  const auto half = static_cast<std::ptrdiff_t>(box.size() / 2);
  std::vector<LinkState<T>> links =
      moving(Column<T>(box.begin(), box.begin() + half), Column<T>(box.begin() + half, box.end()));
  if (Sides<T>(linkage, links, all_links(linkage)).are_as_meant() == Truth::no)
    throw Undecided("the iteration came to the place of a joint on the other side than was said",
                    "l'iterazione è arrivata al posto di un nodo dalla parte opposta a quella detta");
  return links;
}
template std::vector<LinkState<Deep>> solve_dead_point<Deep>(const Linkage&, int, const Beginning<Deep>&);

template <class T>
T place_of_drive(const Linkage& linkage, int drive, const std::vector<LinkState<T>>& links) {
  const Drive& of = linkage.drives[static_cast<std::size_t>(drive)];
  const auto state = [&](int link) -> const LinkState<T>& { return links[static_cast<std::size_t>(link)]; };
  const auto at = [&](int point) {
    const int link = linkage.links_at(point).front();
    return point_of(state(link), linkage.place(link, point)).z;
  };
  if (const auto* turned = std::get_if<TurnedLink>(&of)) return state(turned->link).theta;
  if (const auto* cylinder = std::get_if<Stretched>(&of)) return modulus(at(cylinder->to) - at(cylinder->from));
  const auto& slid = std::get<SlidPoint>(of);
  const LinkLine& guide = linkage.line(slid.guide);
  const LinkState<T>& body = state(linkage.link_of_line(slid.guide));
  return dot(direction(guide, body), at(slid.point) - point_of(body, guide.through).z);
}
template Deep place_of_drive<Deep>(const Linkage&, int, const std::vector<LinkState<Deep>>&);

template <class T>
void demand_joints(const Linkage& linkage, const std::vector<LinkState<T>>& state, UpTo order,
                   const Hanging& hanging) {
  const std::vector<Equation<T>> rows = JointEquations<T>(linkage, state, hanging).all();
  if (order == UpTo::place) {
    for (std::size_t i = 0; i < state.size(); ++i)
      if (hanging.is_placed[i]) demand_zero(squared_modulus(state[i].x) - T(1));
    for (const Equation<T>& row : rows) demand_zero(row.residual);
    demand_sides(linkage, state, hanging);
    return;
  }
  const bool is_first = order == UpTo::velocity;
  const Column<T> rates = rates_of(state, is_first);
  for (const Equation<T>& row : rows)
    demand_zero(along(row, rates) - (is_first ? row.rate : row.second_rate - row.quadratic));
}
template void demand_joints<Exact>(const Linkage&, const std::vector<LinkState<Exact>>&, UpTo, const Hanging&);
template void demand_joints<Generic>(const Linkage&, const std::vector<LinkState<Generic>>&, UpTo, const Hanging&);
template void demand_joints<Calcium>(const Linkage&, const std::vector<LinkState<Calcium>>&, UpTo, const Hanging&);

void demand_independent(const Linkage& linkage, const std::vector<LinkState<Deep>>& place) {
  const std::vector<Equation<Deep>> rows = equations(linkage, place);
  demand_regular(Preconditioner<Deep>(rows), rows);
}

template <class T>
JointForces<T> solve_forces(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                            Inertia inertia) {
  return forces_found(linkage, links, loads, inertia);
}

template <class T>
void demand_equilibrium(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                        const JointForces<T>& forces, Inertia inertia) {
  JointForces<T> held = forces;
  Column<T> multipliers;
  for_each_force(linkage, held, [&](T& force, const Rational& factor) {
    multipliers.push_back(from_rational<T>(Rational(1 / factor)) * force);
  });
  Column<T> borne = loads_on_links(links, loads, inertia);
  for (const T& left : friction_circles(linkage, links, loads).left_over(forces)) demand_in_equilibrium(left);
  for (const auto& hinge : forces.hinges) add_couple(hinge, hinge.couple, borne);
  const std::vector<Beside<T>> rubbing = beside_what_presses(linkage, links, loads);
  for (std::size_t k = 0; k < rubbing.size(); ++k) {
    const T& acts = beside(held, loads, k);
    demand_in_equilibrium(acts + rubbing[k].slope * magnitude_proved(pressing(held, loads, k)));
    for (const auto& [column, each] : rubbing[k].along.slopes) borne[static_cast<std::size_t>(column)] += each * acts;
  }
  const std::vector<Equation<T>> columns = equilibrium(linkage, links);
  for (std::size_t i = 0; i < columns.size(); ++i) demand_in_equilibrium(along(columns[i], multipliers) + borne[i]);
}
template JointForces<Fast> solve_forces<Fast>(const Linkage&, const std::vector<LinkState<Fast>>&, const Loads&,
                                              Inertia);
template JointForces<Bounded> solve_forces<Bounded>(const Linkage&, const std::vector<LinkState<Bounded>>&,
                                                    const Loads&, Inertia);
template JointForces<Deep> solve_forces<Deep>(const Linkage&, const std::vector<LinkState<Deep>>&, const Loads&,
                                              Inertia);
template void demand_equilibrium<Exact>(const Linkage&, const std::vector<LinkState<Exact>>&, const Loads&,
                                        const JointForces<Exact>&, Inertia);
template void demand_equilibrium<Generic>(const Linkage&, const std::vector<LinkState<Generic>>&, const Loads&,
                                          const JointForces<Generic>&, Inertia);
template void demand_equilibrium<Calcium>(const Linkage&, const std::vector<LinkState<Calcium>>&, const Loads&,
                                          const JointForces<Calcium>&, Inertia);

template std::vector<LinkState<Fast>> solve_joints<Fast>(const Linkage&, const Beginning<Fast>&);
template std::vector<LinkState<Bounded>> solve_joints<Bounded>(const Linkage&, const Beginning<Bounded>&);
template std::vector<LinkState<Deep>> solve_joints<Deep>(const Linkage&, const Beginning<Deep>&);
template std::vector<LinkState<Exact>> solve_joints<Exact>(const Linkage&, const Beginning<Exact>&);
template std::vector<LinkState<Generic>> solve_joints<Generic>(const Linkage&, const Beginning<Generic>&);
template std::vector<LinkState<Calcium>> solve_joints<Calcium>(const Linkage&, const Beginning<Calcium>&);

}  // namespace epure::geometry::analytic
