#include "exercises/kit/rolling/instant_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/origin_showing.h"
#include "exercises/kit/panels/osculating_arc.h"
#include "exercises/kit/panels/short_vectors.h"

namespace epure {
namespace {

using At = InstantStep::At;

constexpr double longest_acceleration = 56;  // mm
constexpr double far_off = 3.2;              // times the bodies beside M: a circle still whole, a centre still shown
constexpr double least_part = 1.5;           // mm: a part of the acceleration that can be seen
constexpr double title_height = 7;           // mm
constexpr double axis_beyond_start = 12;     // mm: of the x axis, with its letter

Place middle(const Place& P, const Place& Q) { return {(P.x + Q.x) / 2, (P.y + Q.y) / 2}; }

DrawnCycle inflection_circle(const Rolled& f) { return circle_through(f.P0, middle(f.P0, f.J)); }

// On the side that M leaves free.
void name_inflection_circle(Plot& plot, const Rolled& f, Language language) {
  const Place centre = middle(f.P0, f.J);
  const Arrow2 left = geometry::quarter_turn(centre - f.P0);
  const Place beside = centre + (dot(left, f.M - centre) > 0 ? -1.0 : 1.0) * left;
  if (plot.shows(beside))
    plot.small_label(Words{"inflection circle", "circonferenza dei flessi"}.in(language), beside, centre);
}

}  // namespace

RollingInstantPanel::RollingInstantPanel(const Solution& solution, Rolled at, std::vector<InstantStep> steps,
                                         Scale velocities)
    : solution_(solution),
      f_(std::move(at)),
      steps_(std::move(steps)),
      velocities_(std::move(velocities)),
      way_(way_around(f_.given, 1)) {}

RollingInstantPanel& RollingInstantPanel::titled(std::string title) {
  title_ = std::move(title);
  return *this;
}
RollingInstantPanel& RollingInstantPanel::measured_from(const Place& origin) {
  origin_ = origin;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::without_room_for_centre() {
  leaves_out_centre_ = true;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::no_larger_than(double mm) {
  largest_on_paper_ = mm;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::with_path(const Way& way) {
  way_ = way;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::with_whole_path(const Way& way) {
  whole_path_ = samples_of_path(f_.given, way);
  return with_path(way);
}
RollingInstantPanel& RollingInstantPanel::beside_close_up() {
  shows_ = Shows::vectors;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::at_own_scale() {
  has_own_scale_ = true;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::set_out() {
  sets_out_ = true;
  return *this;
}
RollingInstantPanel& RollingInstantPanel::close_up() {
  shows_ = Shows::contact;
  return *this;
}

// Inside a circle hardly larger than the rolling one the inflection circle is many times as large as both.
bool RollingInstantPanel::is_inflection_circle_small() const {
  const double bodies = std::max(f_.given.is_line() ? f_.R : 2 * f_.r, f_.P0M());
  return f_.inflection_diameter() <= far_off * bodies;
}

// How large the figure is without the centre of curvature.
double RollingInstantPanel::size() const {
  const double bodies = std::max(f_.given.is_line() ? f_.R : 2 * f_.r, f_.P0M());
  return is_inflection_circle_small() ? std::max(bodies, f_.inflection_diameter()) : bodies;
}

bool RollingInstantPanel::is_near(const Place& P) const { return distance(P, f_.M) <= far_off * size(); }

double RollingInstantPanel::reach() const {
  constexpr double metre = 1000;  // mm
  return shows_ == Shows::contact ? 2 * f_.R : metre / largest_on_paper_ * size();
}

Panel::Vectors RollingInstantPanel::vectors() const {
  if (shows_ == Shows::contact || magnitude(f_.a) == 0) return {};
  return {"m/s²", magnitude(f_.a), longest_acceleration};
}

std::vector<Scale> RollingInstantPanel::own_scales() const {
  if (shows_ == Shows::contact || magnitude(f_.v) == 0) return {};
  return {velocities_};
}

// Two contacts beside each other, or two whole paths.
std::string RollingInstantPanel::scale_group() const {
  return shows_ == Shows::contact ? "contact" : shows_ == Shows::vectors && !has_own_scale_ ? "path" : "";
}

// Where the contact has a picture of its own they are told apart there.
std::vector<Place> RollingInstantPanel::lettered() const {
  if (shows_ != Shows::all || f_.is_at_cusp || f_.given.unwinds()) return {};
  std::vector<Place> all{f_.P0, f_.M, f_.J, f_.M_prime};
  for (const std::optional<Place>& P : {f_.C(), f_.O(), f_.centre})
    if (P) all.push_back(*P);
  return all;
}

drawings::Box RollingInstantPanel::extent(const Scale& lengths, const Scale& vectors) const {
  Extent extent;
  const auto include_tip = [&](const Arrow2& v, const Scale& of) {
    const double x = lengths.mm_per_unit * f_.M.x + of.mm_per_unit * v.x;
    const double y = lengths.mm_per_unit * f_.M.y + of.mm_per_unit * v.y;
    extent.include(x - letters_room, y - letters_room);
    extent.include(x + letters_room, y + letters_room);
  };
  if (f_.C()) include_circle(extent, lengths, *f_.C(), f_.r);
  if (is_set_out()) extent.include(lengths, {f_.O()->x + f_.R, f_.O()->y}, axis_beyond_start);
  if (f_.given.is_line() && f_.R <= far_off * size()) include_circle(extent, lengths, *f_.O(), f_.R);
  if (is_inflection_circle_small())
    include_circle(extent, lengths, middle(f_.P0, f_.J), f_.inflection_diameter() / 2);
  extent.include(lengths, f_.P0, letters_room);
  if (shows_ != Shows::contact) {
    extent.include(lengths, f_.M, letters_room);
    for (const std::optional<Place>& P : {std::optional{f_.M_prime}, leaves_out_centre_ ? std::nullopt : f_.centre})
      if (P && is_near(*P)) extent.include(lengths, *P, letters_room);
    include_tip(f_.v, velocities_);
    for (const Arrow2& a : {f_.a, f_.a_n}) include_tip(a, vectors);
    for (const Place& P : whole_path_) extent.include(lengths, P, 2);
  }
  drawings::Box box = extent.box();
  if (!title_.empty()) box.high.y += title_height;
  return box;
}

drawings::Point RollingInstantPanel::origin(const drawings::Box& room, const drawings::Box& needed,
                                            const Scale& lengths) const {
  if (f_.given.rolls_on_line() || f_.given.is_line()) return origin_in(room, needed);
  Extent all;
  for (const drawings::Point& corner : {needed.low, needed.high}) all.include(corner.x, corner.y);
  include_circle(all, lengths, *f_.O(), f_.R);
  // Sideways, where a sheet has room to spare; its height the figure needs.
  return {origin_showing(all.box(), needed, room).x, origin_in(room, needed).y};
}

Place RollingInstantPanel::towards_centre(const Plot& plot, const drawings::Box& room) const {
  if (is_in(room, plot, *f_.centre)) return *f_.centre;
  return ray_to_edge(plot, room, f_.M, *f_.centre - f_.M);
}

// A path that has just begun begins at M.
bool RollingInstantPanel::is_set_out() const { return sets_out_ && !f_.is_at_cusp; }

// Where φ is counted from.
void RollingInstantPanel::draw_start(Plot& plot) const {
  if (!is_set_out()) return;
  constexpr double behind = 6, letter = 3;  // mm
  const Place O = *f_.O(), M0{O.x + f_.R, O.y};
  const drawings::Point o = plot.at(O), start = plot.at(M0);
  const Place end = plot.from_paper({start.x + axis_beyond_start - letter, start.y});
  plot.segment(plot.from_paper({o.x - behind, o.y}), end, Meaning::axis);
  plot.label("$x$", end, O);
  plot.dot(M0, Meaning::locus);
  plot.label("$M_{0}$", M0, O, Meaning::locus);
}

void RollingInstantPanel::draw_radius(Plot& plot) const {
  if (!is_set_out()) return;
  constexpr double widest = 11, narrowest = 5, least = 3;  // mm
  const Place O = *f_.O();
  plot.segment(O, f_.P0, Meaning::dimension);
  const double radius = std::min(widest, 0.7 * f_.R * plot.scale().mm_per_unit), to_P0 = direction(O, f_.P0),
               turned = to_P0 < 0 ? to_P0 + 2 * std::numbers::pi : to_P0;
  if (radius < narrowest || radius * turned < least) return;
  const drawings::Point o = plot.at(O);
  plot.mark(drawings::AngleMark{o, radius, 0, turned});
  plot.label("$φ$", plot.from_paper(o + radius * drawings::direction(turned / 2)), O);
}

// Below the path, which it nearly covers.
void RollingInstantPanel::draw_osculating_circle(Plot& plot, const drawings::Box& room, Language language) const {
  if (f_.is_at_cusp || !f_.centre) return;
  if (!is_in(room, plot, *f_.centre)) {
    draw_towards(plot, room, f_.M, *f_.centre, "$Ω$", language);
    return;
  }
  if (f_.given.unwinds()) return;  // the line itself leads there
  plot.segment(f_.M, *f_.centre, Meaning::construction);
  draw_osculating_arc(plot, f_.M, *f_.centre, beside_whole_path, "osculating_circle");
}

// With the line P0J, which the stationarity circle is when the speed is constant.
void RollingInstantPanel::draw_inflection_circle(Plot& plot) const {
  plot.cycle(inflection_circle(f_), Meaning::locus, "inflection_circle");
  constexpr double beyond = 9;  // mm
  const bool is_stationarity = is_zero(f_.given.alpha) && !is_zero(f_.given.omega) && shows_ != Shows::vectors;
  if (is_stationarity && is_set_out())  // its other end would lie on OP0
    plot.segment(f_.P0, f_.J + (beyond / (plot.scale().mm_per_unit * f_.inflection_diameter())) * (f_.J - f_.P0),
                 Meaning::second_locus);
  else if (is_stationarity)
    plot.long_segment(f_.P0, f_.J, beyond, Meaning::second_locus);
  else
    plot.segment(f_.P0, f_.J, Meaning::axis);
}

void RollingInstantPanel::draw_ray(Plot& plot) const {
  if (f_.is_at_cusp || shows_ == Shows::contact) return;
  if (!f_.given.unwinds()) {  // else it is the line, and M' the contact
    plot.long_segment(f_.P0, f_.M, 5, Meaning::construction);
    plot.segment(f_.M, f_.M_prime, Meaning::construction);
    plot.segment(f_.J, f_.M_prime, Meaning::construction);
  }
  if (!f_.runs_straight()) plot.right_angle(f_.M_prime, f_.J, f_.M);
}

void RollingInstantPanel::draw_velocity(Plot& plot, Language language) const {
  if (magnitude(f_.v) == 0) return;
  const Scale accelerations = plot.vector_scale();
  plot.vectors_at(velocities_);
  plot.vector_on(f_.names("v_M"), f_.M, f_.v, Meaning::velocity,
                 letters_or_value("$\\vec{v}_{M}$", magnitude(f_.v), magnitude(f_.v) * velocities_.mm_per_unit, "m/s",
                                  language));
  plot.vectors_at(accelerations);
}

bool RollingInstantPanel::shows_parts(const Scale& accelerations) const {
  const double least = least_part / accelerations.mm_per_unit;
  return magnitude(f_.a_n) >= least && magnitude(f_.a_t) >= least;
}

// A side of the triangle of the accelerations that lies on a line of the body: beside that line, on the side away
// from the others, and joined to the triangle's corners.
void RollingInstantPanel::draw_beside(Plot& plot, const std::pair<std::string, std::string>& name_and_letters,
                                      const Arrow2& v, const Arrow2& others) const {
  constexpr double beside = 1.5;  // mm
  const double by = (cross(v, others) > 0 ? -beside : beside) / (plot.scale().mm_per_unit * magnitude(v));
  const Arrow2 aside = by * geometry::quarter_turn(v);
  const Place start = f_.M + aside, tip = plot.tip(f_.M, v);
  plot.segment(f_.M, start, Meaning::dimension);
  plot.segment(tip, tip + aside, Meaning::dimension);
  plot.vector_on(name_and_letters.first, start, v, Meaning::acceleration, name_and_letters.second);
}

// The parts are drawn only where there are two. The tangential one follows the normal one to the tip of their sum:
// set off from M it would lie on v_M.
void RollingInstantPanel::draw_acceleration(Plot& plot, Language language) const {
  if (magnitude(f_.a) == 0) return;
  constexpr double beside = 3;  // mm
  Place start = f_.M;
  // Along v_M and in its sense one would hide the other: then beside M, joined to it.
  if (dot(f_.a, f_.v) > 0 && magnitude(f_.a_n) * plot.vector_scale().mm_per_unit < least_part) {
    start = f_.M + (beside / (plot.scale().mm_per_unit * f_.P0M())) * (f_.M - f_.P0);
    plot.segment(f_.M, start, Meaning::construction);
  }
  const bool has_parts = shows_parts(plot.vector_scale());
  const Place tip = plot.tip(f_.M, f_.a_n);
  // The line of the tangential part, which leads to the tip.
  if (has_parts) plot.segment(tip, plot.tip(f_.M, f_.a), Meaning::construction);
  const std::string letters = letters_or_value("$\\vec{a}_{M}$", magnitude(f_.a),
                                               magnitude(f_.a) * plot.vector_scale().mm_per_unit, "m/s²", language);
  // It points at J, which is C when a circle rolls on a line: then it lies on the radius MC.
  const bool is_on_radius = f_.given.rolls_on_line() && is_zero(f_.given.alpha);
  if (has_parts && is_on_radius)
    draw_beside(plot, {f_.names("a_M"), letters}, f_.a, f_.a_n);
  else
    plot.vector_on(f_.names("a_M"), start, f_.a, Meaning::acceleration, letters);
  if (!has_parts) return;
  if (f_.given.unwinds())
    draw_beside(plot, {f_.names(f_.names.normal), "$\\vec{a}^{n}_{M}$"}, f_.a_n, f_.a_t);
  else
    plot.vector_on(f_.names(f_.names.normal), f_.M, f_.a_n, Meaning::acceleration, "$\\vec{a}^{n}_{M}$");
  const std::string tangential = f_.names("a_t");
  plot.vector_on(solution_.has(tangential) ? tangential : "", tip, f_.a_t, Meaning::acceleration,
                 "$\\vec{a}^{t}_{M}$");
}

// Which way M goes before and after, on the sides on which it comes and leaves.
void RollingInstantPanel::draw_directions_at_cusp(Plot& plot) const {
  if (!f_.is_at_cusp || f_.turning() == 0 || f_.runs_straight()) return;
  constexpr double aside = 11, from = 4, length = 12;  // mm: clear of the path, which is narrow so near the cusp
  const double mm = plot.scale().mm_per_unit, size = magnitude(f_.a);
  const Arrow2 along{f_.a.x / size, f_.a.y / size}, left{-along.y, along.x};
  const auto at = [&](double across, double up) { return plot.at(f_.M + (across / mm) * left + (up / mm) * along); };
  const double after = f_.turning() > 0 ? aside : -aside;
  const auto arrow = [&](drawings::Point tail, drawings::Point tip, const std::string& letters) {
    plot.mark(drawings::Arrow{tail, tip, Meaning::dimension, {}});  // no velocity: M rests
    plot.label(letters, plot.from_paper(tail.y > tip.y ? tail : tip), f_.M);
  };
  arrow(at(-after, from + length), at(-after, from), "$\\vec{t}^{−}$");
  arrow(at(after, from), at(after, from + length), "$\\vec{t}^{+}$");
}

void RollingInstantPanel::draw_points(Plot& plot, const drawings::Box& room) const {
  const bool names_contact = shows_ != Shows::vectors;
  const std::string at_pole = f_.is_at_cusp ? (f_.runs_straight() ? "$M$ ≡ $P_{0}$" : "$M$ ≡ $P_{0}$ ≡ $Ω$")
                                            : (f_.given.unwinds() ? "$P_{0}$ ≡ $M'$ ≡ $Ω$" : "$P_{0}$");
  const bool is_K = is_zero(f_.given.alpha) && !is_zero(f_.given.omega);
  const std::string at_J = std::string(f_.given.rolls_on_line() ? "$C$ ≡ " : "") + "$J$" + (is_K ? " ≡ $K$" : "");
  if (shows_ != Shows::contact && !f_.is_at_cusp) {
    plot.dot(f_.M, Meaning::locus);
    plot.label("$M$", f_.M, f_.C() ? *f_.C() : f_.P0, Meaning::locus);
  }
  if (!names_contact) return;
  if (f_.C() && !f_.given.rolls_on_line()) plot.label("$C$", *f_.C(), f_.M);
  // On a line at 45° a cross would lie along it and its normal.
  const auto mark = [&](const Place& P) { f_.given.unwinds() ? plot.dot(P, Meaning::locus) : plot.cross(P); };
  mark(f_.J);
  plot.label(at_J, f_.J, f_.is_at_cusp ? f_.P0 : f_.M, Meaning::locus);
  if (f_.is_at_cusp)
    plot.dot(f_.M, Meaning::locus);
  else
    mark(f_.P0);
  plot.label(at_pole, f_.P0, f_.J, Meaning::locus);
  if (f_.is_at_cusp || f_.given.unwinds()) return;
  if (!f_.runs_straight()) {
    plot.dot(f_.M_prime, Meaning::locus);
    plot.label("$M'$", f_.M_prime, f_.M, Meaning::locus);
  }
  if (f_.centre && is_in(room, plot, *f_.centre)) {
    plot.cross(*f_.centre);
    plot.label("$Ω$", *f_.centre, f_.M, Meaning::locus);
  }
}

// What the exercise reports, where the sheet shows it.
void RollingInstantPanel::measure(Plot& plot) const {
  const auto measures = [&](const std::string& name, const Place& P, const Place& Q) {
    if (solution_.has(f_.names(name))) plot.measures(f_.names(name), P, Q);
  };
  if (shows_ != Shows::vectors) measures("inflection_diameter", f_.P0, f_.J);
  if (shows_ == Shows::contact || f_.is_at_cusp) return;
  measures("P0M", f_.P0, f_.M);
  measures("Mprime_M", f_.M_prime, f_.M);
  measures("KM", f_.J, f_.M);
  if (f_.centre) measures("rho_M", *f_.centre, f_.M);
  if (!origin_) return;
  plot.measures_abscissa(f_.names("x_M"), f_.M, *origin_);
  if (f_.centre) plot.measures_abscissa(f_.names("curvature_centre_x"), *f_.centre, *origin_);
}

std::string RollingInstantPanel::off_sheet(const Plot& plot, const drawings::Box& room, Language language) const {
  if (shows_ == Shows::contact) return {};
  OffSheet off(plot, room);
  off.point("$J$", f_.J);
  off.point("$M'$", f_.M_prime);
  off.point("$Ω$", f_.centre);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, inflection_circle(f_));
  if (f_.O()) off.circle({"part of $p$", "parte di $p$"}, circle_through(f_.P0, *f_.O()));
  std::string sentence = off.sentence(language);
  if (!sentence.empty() && !title_.empty()) sentence.insert(sentence.size() - 1, " (" + title_ + ")");
  return sentence;
}

void RollingInstantPanel::draw_given(Plot& plot, const drawings::Box& room, Language) const {
  draw_ground(plot, f_, room);
  draw_body(plot, f_, room);
  draw_start(plot);
  plot.dot(f_.M, Meaning::locus);
  plot.label("$M$", f_.M, f_.P0, Meaning::locus);
}

std::vector<drawings::Block> RollingInstantPanel::draw(Plot& plot, const drawings::Box& room,
                                                       Language language) const {
  const bool has_vectors = shows_ != Shows::contact;
  plot.in_step(0);
  draw_ground(plot, f_, room);
  plot.in_step({});
  if (has_vectors) draw_osculating_circle(plot, room, language);
  if (has_vectors) draw_path(plot, f_.given, way_);
  draw_inflection_circle(plot);
  if (title_.empty()) name_inflection_circle(plot, f_, language);
  plot.in_step(0);
  draw_body(plot, f_, room);
  if (has_vectors) draw_sense(plot, f_);
  draw_start(plot);
  plot.in_step(1);
  draw_radius(plot);
  plot.in_step({});
  draw_ray(plot);
  if (has_vectors) {
    draw_velocity(plot, language);
    draw_acceleration(plot, language);
    draw_directions_at_cusp(plot);
  }
  draw_points(plot, room);
  measure(plot);
  if (origin_ && f_.given.rolls_on_line() && is_in(room, plot, *origin_)) {
    plot.dot(*origin_);
    plot.label("$O$", *origin_, f_.J);
  }
  if (!title_.empty()) plot.mark(drawings::Writing{title_, {room.low.x + 2, room.high.y - title_height + 2}, 3.5});
  const std::string beyond = off_sheet(plot, room, language);
  if (beyond.empty()) return {};
  return {drawings::Paragraph{beyond}};
}

std::vector<PanelStep> RollingInstantPanel::steps(const Plot& plot, const drawings::Box& room) const {
  const auto place = [&](At at) -> Place {
    Plot of_velocities = plot;
    of_velocities.vectors_at(velocities_);
    switch (at) {
      case At::contact:
        return middle(*f_.O(), f_.P0);
      case At::inflection_pole:
        return f_.J;
      case At::tip_of_velocity:
        return of_velocities.tip(f_.M, f_.v);
      case At::foot:
        return f_.M_prime;
      case At::acceleration:
        return middle(f_.M, plot.tip(f_.M, f_.a));  // its tip may be J, with a number of its own
      case At::centre_of_curvature:
        break;
    }
    if (f_.is_at_cusp || !f_.centre) return f_.M;
    // On the line, which is ρ: the contact has numbers enough.
    return f_.given.unwinds() && shows_ != Shows::contact ? middle(f_.P0, f_.M) : towards_centre(plot, room);
  };
  std::vector<PanelStep> all;
  const bool osculates = !f_.is_at_cusp && !f_.given.unwinds() && f_.centre && is_in(room, plot, *f_.centre);
  for (const InstantStep& step : steps_) {
    all.push_back({step.text, place(step.at)});
    if (osculates && step.at == At::centre_of_curvature)
      all.back().text =
          step.text + Words{" Thin: the circle about it through $M$.", " Sottile: il suo cerchio per $M$."};
  }
  return all;
}

Scale scale_of_velocities(const std::vector<Rolled>& instants, double longest_mm, Language language) {
  double fastest = 0;
  for (const Rolled& f : instants) fastest = std::max(fastest, magnitude(f.v));
  return largest_vector_scale(longest_mm / (fastest > 0 ? fastest : 1), "m/s", language);
}

}  // namespace epure
