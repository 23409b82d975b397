// The sheet of the path: the bodies at the start and at the instant, the path with the points it is built from, and
// its cusps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/rolling/rolling_picture.h"
#include "exercises/roulette/exercise.h"
#include "geometry/curves/roulettes.h"

namespace epure::roulette {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The cusps, from the instant on, in radians that the body turns.
std::vector<double> cusps_on(const RollingGivens& given, const Way& way) {
  std::vector<double> found;
  // A little inside the far end, where a closed path comes back to its first cusp.
  const double little = 1e-9 * (way.to - way.from);
  const Angle from{0, Rational(way.from - little)}, to{0, Rational(way.closed ? way.to - little : way.to + little)};
  for (const Angle& phi : geometry::cusps(given.rolling, given.phi + from, given.phi + to))
    found.push_back(to_double(phi - given.phi));
  return found;
}

constexpr double overhang = 0.1;  // of an arch, beyond both ends of a path that does not close

// The rounds of a path near its circle would run together: then one before the instant and one after.
Way way_to_tell_apart(const Rolled& f) {
  const Way whole = way_of(f.given, overhang);
  if (f.given.is_line() || f.given.rolls_on_line()) return whole;
  constexpr double apart = 0.005;  // of the path's size
  const double rounds = (whole.to - whole.from) / (2 * std::numbers::pi) *
                        geometry::from_rational<double>(geometry::rolled_per_turned(f.given.rolling)) * f.r / f.R;
  return 2 * f.d / rounds < apart * (f.R + f.r + f.d) ? way_around(f.given, overhang) : whole;
}

class PathPanel : public Panel {
 public:
  explicit PathPanel(const Solution& solution)
      : f_(rolled(solution, rolling_of(solution.givens()))),
        way_(way_to_tell_apart(f_)),
        cusps_(cusps_on(f_.given, way_)),
        path_(f_.given.rolling, f_.given.phi),
        points_(samples_of_path(f_.given, way_)) {}

  double reach() const override {
    return f_.given.is_line() ? std::max(std::abs(f_.d), f_.R) : std::max({f_.r, f_.d, way_.closed ? f_.R : 0});
  }
  bool is_cut() const override { return true; }

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    for (const Place& P : points_) extent.include(scale, P, letters_room / 2);
    if (f_.C()) include_circle(extent, scale, *f_.C(), f_.r);
    if (way_.closed || f_.given.is_line()) include_circle(extent, scale, *f_.O(), f_.R);
    if (f_.given.is_line()) extent.include(scale, ends_of_line(f_, scale).second, letters_room);
    extent.include(scale, f_.P0, letters_room);
    extent.include(scale, f_.M, letters_room);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box& room, Language) const override {
    draw_ground(plot, f_, room);
    draw_axes(plot, room);
    draw_start(plot);
    plot.cross(f_.P0);
    plot.label("$P_{0}$", f_.P0, f_.C() ? *f_.C() : f_.M, Meaning::locus);
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language) const override {
    draw_ground(plot, f_, room);
    draw_axes(plot, room);
    draw_start(plot);
    draw_path(plot, f_.given, way_);
    draw_division(plot);
    draw_body(plot, f_, room);
    draw_sense(plot, f_);
    draw_angles(plot, room);
    draw_cusps(plot);
    if (f_.C()) plot.label("$C$", *f_.C(), f_.M);
    plot.dot(f_.M, Meaning::locus);
    plot.label("$M$", f_.M, f_.C() ? *f_.C() : f_.P0, Meaning::locus);
    plot.cross(f_.P0);
    plot.label("$P_{0}$", f_.P0, f_.C() ? *f_.C() : f_.M, Meaning::locus);
    plot.measures("P0M", f_.P0, f_.M);
    if (f_.O() && is_in(room, plot, *f_.O())) {
      plot.measures_coordinates("M", f_.M, *f_.O());
      plot.measures_coordinates("P0", f_.P0, *f_.O());
    }
    return {};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    std::vector<PanelStep> all{{rolled_off(), f_.P0}, {traced(plot), f_.M}};
    if (!cusps_.empty()) all.push_back({about_cusps(), at(cusps_.front())});
    return all;
  }

 private:
  Place at(double since) const { return path_(since); }
  const geometry::Rolling& rolling() const { return f_.given.rolling; }
  bool is_inside() const { return rolling().how == geometry::Rolls::circle_inside_circle; }

  // The bodies as they stood at φ = 0, where that is on the sheet.
  void draw_start(Plot& plot) const {
    const double since = -to_double(f_.given.phi);
    if (since == 0 || (!way_.closed && (way_.from > since || way_.to < since))) return;
    const Place start = at(since);
    if (!f_.given.is_line()) {
      const Place C = start + f_.d * geometry::common_normal<double>(rolling(), Angle{});
      plot.circle(C, f_.r, Meaning::alternative);
      plot.segment(C, start, Meaning::alternative);
    }
    if (geometry::has_cusps(rolling())) return;  // there is a cusp then, with its letter
    plot.dot(start, Meaning::locus);
    plot.label("$M_{0}$", start, f_.C() && f_.O() ? *f_.O() : f_.P0, Meaning::locus);
  }

  // The way of the centre, and the line of centres.
  void draw_axes(Plot& plot, const drawings::Box& room) const {
    if (f_.given.is_line()) {
      plot.segment(*f_.O(), f_.P0, Meaning::axis);
    } else if (f_.given.rolls_on_line()) {
      const double y = plot.at(*f_.C()).y;
      plot.mark(drawings::Line{drawings::segment({room.low.x, y}, {room.high.x, y}), Meaning::axis, {}});
      plot.segment(*f_.C(), f_.P0, Meaning::axis);
    } else {
      plot.cycle(circle_through(*f_.C(), *f_.O()), Meaning::axis);
      plot.long_segment(*f_.O(), is_inside() ? f_.P0 : *f_.C(), 4, Meaning::axis);
    }
  }

  // β at O, from the first contact on; ψ at C, from the contact to M.
  void draw_angles(Plot& plot, const drawings::Box& room) const {
    const auto mark = [&](const Place& vertex, double radius, double from, double by, const std::string& letter) {
      constexpr double least = 5, whole = 2 * std::numbers::pi;  // mm of arc; no arc says more than a turn
      if (std::abs(by) * radius < least || std::abs(by) > whole) return;
      const drawings::Point v = plot.at(vertex);
      plot.mark(drawings::AngleMark{v, radius, std::min(from, from + by), std::max(from, from + by)});
      const double middle = from + by / 2;
      plot.label(letter, plot.from_paper({v.x + radius * std::cos(middle), v.y + radius * std::sin(middle)}), vertex);
    };
    const double mm = plot.scale().mm_per_unit;
    if (f_.O() && is_in(room, plot, *f_.O()))
      mark(*f_.O(), std::min(14.0, 0.4 * f_.R * mm), 0, to_double(geometry::contact_angle(rolling(), f_.given.phi)),
           f_.given.is_line() ? "$φ$" : "$β$");
    if (!f_.C() || f_.d == 0) return;
    const double in_arch = to_double(geometry::within_one_turn(geometry::rolled_angle(rolling(), f_.given.phi)));
    mark(*f_.C(), std::min(9.0, 0.5 * f_.r * mm), direction(*f_.C(), f_.P0), geometry::sense(rolling()) * in_arch,
         "$ψ$");
  }

  bool is_divided() const {
    constexpr int most_divided_arches = 8;
    return way_.arches <= most_divided_arches;
  }
  // Twelve to an arch, or every 30 deg of an involute: what the curve is drawn through by hand.
  void draw_division(Plot& plot) const {
    if (!is_divided()) return;
    const double k = geometry::from_rational<double>(geometry::rolled_per_turned(rolling()));
    const Angle psi = geometry::rolled_angle(rolling(), f_.given.phi);
    const double step = 30 * degree / k, rolled = to_double(geometry::within_one_turn(psi)) / k;
    for (double i = std::ceil((way_.from + rolled) / step - 1e-9); i * step - rolled <= way_.to + 1e-9 * step; ++i)
      plot.dot(at(i * step - rolled), Meaning::construction);
    if (has_numbers(plot)) number_arch(plot, step, rolled);
  }
  // Of circles, where an arc of 30° has room for its number, and an arch goes no more than once round p.
  bool has_numbers(const Plot& plot) const {
    constexpr double apart = 5;  // mm
    const bool is_within_turn = f_.given.rolls_on_line() || f_.r <= f_.R;
    return is_divided() && !f_.given.is_line() && is_within_turn &&
           30 * degree * f_.r * plot.scale().mm_per_unit >= apart;
  }
  // The arch of M: its points, and where the bodies touch then.
  void number_arch(Plot& plot, double step, double rolled) const {
    constexpr int divisions = 12;
    for (int n = 1; n < divisions; ++n) {
      const double since = n * step - rolled;
      if (since < way_.from || since > way_.to) continue;
      const Place M = at(since), P0 = contact(since);
      plot.dot(P0, Meaning::construction);
      plot.small_label(std::to_string(n), M, P0, Meaning::construction);
      plot.small_label(std::to_string(n), P0, M, Meaning::construction);
    }
  }
  // Where the bodies touch when they have turned so far since now.
  Place contact(double since) const {
    if (f_.given.rolls_on_line()) return f_.P0 + Arrow2{f_.r * since, 0};
    const double beta = to_double(geometry::contact_angle(rolling(), f_.given.phi + Angle{0, Rational(since)}));
    return *f_.O() + f_.R * Arrow2{std::cos(beta), std::sin(beta)};
  }

  void draw_cusps(Plot& plot) const {
    constexpr std::size_t most_letters = 12;
    for (std::size_t i = 0; i < cusps_.size(); ++i) {
      const Place Q = at(cusps_[i]);
      plot.cross(Q);
      if (cusps_.size() > most_letters) continue;
      const Place inwards = !f_.O() ? Place{Q.x, Q.y + f_.r} : is_inside() ? *f_.O() : Q + 0.5 * (Q - *f_.O());
      plot.label(fmt::format("$Q_{{{}}}$", i), Q, inwards, Meaning::locus);
    }
  }

  Words rolled_off() const {
    if (f_.given.is_line())
      return {
          "The line $π$ rolls on the circle $p$ without slipping: what it has unwound, from its contact $P_{0}$ to "
          "the foot of $M$, is the arc $\\it{R}$·$φ$.",
          "La retta $π$ rotola sul cerchio $p$ senza strisciare: il tratto svolto, dal contatto $P_{0}$ al piede di "
          "$M$, è l'arco $\\it{R}$·$φ$."};
    if (f_.given.rolls_on_line())
      return {
          "The circle $π$ rolls on the line $p$ without slipping: its contact $P_{0}$ and its centre $C$ go $r$·$φ$ "
          "to the right, $ψ$ = $φ$.",
          "Il cerchio $π$ rotola sulla retta $p$ senza strisciare: il contatto $P_{0}$ e il centro $C$ vanno di "
          "$r$·$φ$ a destra, $ψ$ = $φ$."};
    const std::string turned =
        is_inside() ? "$ψ$ − $β$, $β$ = $φ$·$r$/($\\it{R}$ − $r$)." : "$ψ$ + $β$, $β$ = $φ$·$r$/($\\it{R}$ + $r$).";
    return {
        "The circle $π$ rolls on the circle $p$ without slipping: the arcs rolled off are equal, $r$·$ψ$ = "
        "$\\it{R}$·$β$, "
        "and the body has turned through $φ$ = " +
            turned,
        "Il cerchio $π$ rotola sul cerchio $p$ senza strisciare: gli archi svolti sono uguali, $r$·$ψ$ = "
        "$\\it{R}$·$β$, e "
        "il corpo è ruotato di $φ$ = " +
            turned};
  }

  Words traced(const Plot& plot) const {
    const Words name = name_of_path(f_.given);
    if (f_.given.is_line())
      return {"$M$ is carried by the line at the distance $d$: it traces the " + name.english + ".",
              "$M$ è portato dalla retta alla distanza $d$: descrive la curva detta " + name.italian + "."};
    const Words dots =
        is_divided() ? Words{"; the dots are 30° of $ψ$ apart.", "; i punti distano 30° di $ψ$."} : Words{".", "."};
    const Words numbers = has_numbers(plot)
                              ? Words{" Those of $M$'s arch have the number of their contact on $p$, along which the "
                                      "arcs of 30° of $π$ are laid off.",
                                      " Quelli dell'arcata di $M$ hanno il numero del loro contatto su $p$, lungo il "
                                      "quale sono riportati gli archi di 30° di $π$."}
                              : Words{};
    const Way whole = way_of(f_.given, overhang);
    const Words part = way_.to - way_.from < whole.to - whole.from
                           ? Words{" Its rounds lie close together: one before the instant and one after are drawn.",
                                   " I suoi giri sono fitti: ne sono disegnati uno prima dell'istante e uno dopo."}
                           : Words{};
    return Words{"$CM$ = $d$, at the angle $ψ$ from $CP_{0}$. $M$ traces the ",
                 "$CM$ = $d$, all'angolo $ψ$ da $CP_{0}$. $M$ descrive la curva detta "} +
           name + dots + numbers + part;
  }

  Words about_cusps() const {
    if (f_.given.is_line())
      return {"Cusp $Q_{0}$: where $M$ itself touched $p$, $φ$ = 0.",
              "Cuspide $Q_{0}$: dove $M$ stesso toccava $p$, $φ$ = 0."};
    const Words what =
        f_.runs_straight() ? Words{"There $M$ turns back", "Lì $M$ torna indietro"} : Words{"Cusps", "Cuspidi"};
    const std::string where = f_.given.rolls_on_line() ? "" : ", $β$ = $ψ$·$r$/$\\it{R}$";
    return what +
           Words{": $Q_{0}$, $Q_{1}$ ... where $M$ itself touches $p$: a whole number of turns $ψ$" + where + ".",
                 ": $Q_{0}$, $Q_{1}$ ... dove $M$ stesso tocca $p$: $ψ$ un numero intero di giri" + where + "."};
  }

  Rolled f_;
  Way way_;
  std::vector<double> cusps_;
  geometry::RouletteSince<double> path_;
  std::vector<Place> points_;
};

}  // namespace

PanelSheet path_sheet(const Solution& s, Language language) {
  const Words name = name_of_path(rolling_of(s.givens()));
  return {.panels = panels(PathPanel(s)),
          .results = {coordinates("M"), coordinates("P0"), values({"P0M"}),
                      value_as(Words{"Arc travelled from $φ$ = 0: $s$", "Arco percorso da $φ$ = 0: $s$"}.in(language),
                               "s")},
          .seen = {"The bodies at the start and at the instant, and the path of M: " + name.english,
                   "I corpi all'inizio e all'istante, e la traiettoria di M: " + name.italian},
          .told = {"M_x", "M_y", "s"}};
}

}  // namespace epure::roulette
