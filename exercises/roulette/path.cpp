// The sheet of the path: the bodies at the start and at the instant, the path with the points it is built from, and
// its cusps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/roulette/exercise.h"

namespace epure::roulette {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Points of the path, as many as show how far it reaches.
std::vector<Place> samples(const Drawn& f, const Way& way) {
  const int count = 60 + static_cast<int>(60 * std::max<double>(way.arches, (way.to - way.from) / (360 * degree)));
  std::vector<Place> points;
  for (int i = 0; i <= count; ++i) points.push_back(f.path(way.from + (way.to - way.from) * i / count));
  return points;
}

drawings::Box extent_of(const Drawn& f, const Way& way, const std::vector<Place>& points, const Scale& scale) {
  Extent extent;
  for (const Place& P : points) extent.include(scale, P, letters / 2);
  const auto include_circle = [&](const Place& centre, double radius) {
    extent.include(scale, {centre.x - radius, centre.y - radius}, letters / 2);
    extent.include(scale, {centre.x + radius, centre.y + radius}, letters / 2);
  };
  if (f.C) include_circle(*f.C, f.r);
  if (way.closed || f.problem.is_line()) include_circle(f.O, f.R);
  if (f.problem.is_line()) extent.include(scale, ends_of_line(f).second, letters);
  extent.include(scale, f.P0, letters);
  extent.include(scale, f.M, letters);
  return extent.box();
}

// The bodies as they stood at φ = 0, where that is on the sheet.
void draw_start(Plot& plot, const Drawn& f, const Way& way) {
  if (f.phi == 0 || (!way.closed && (way.from > -f.phi || way.to < -f.phi))) return;
  const geometry::Rolling& g = f.problem.rolling;
  const Place start = f.path(-f.phi);
  if (!f.problem.is_line()) {
    const Place C = start + f.d * geometry::common_normal<double>(g, Angle{});
    plot.circle(C, f.r, Meaning::alternative);
    plot.segment(C, start, Meaning::alternative);
  }
  if (geometry::has_cusps(g)) return;  // M0 is a cusp and has its letter as such
  plot.dot(start, Meaning::locus);
  plot.label("$M_{0}$", start, f.C ? f.O : f.P0, Meaning::locus);
}

// The way of the centre, and the line of centres.
void draw_axes(Plot& plot, const Drawn& f, const drawings::Box& room) {
  if (f.problem.is_line()) {
    plot.segment(f.O, f.P0, Meaning::axis);
  } else if (f.problem.rolls_on_line()) {
    const double y = plot.at(*f.C).y;
    plot.mark(drawings::Line{drawings::segment({room.low.x, y}, {room.high.x, y}), Meaning::axis, {}});
    plot.segment(*f.C, f.P0, Meaning::axis);
  } else {
    plot.cycle(circle_through(*f.C, f.O), Meaning::axis);
    plot.long_segment(f.O, f.problem.rolling.how == Rolls::circle_outside_circle ? *f.C : f.P0, 4, Meaning::axis);
  }
}

// β at O, from the first contact on; ψ at C, from the contact to M.
void draw_angles(Plot& plot, const Drawn& f) {
  const auto mark = [&](const Place& vertex, double radius, double from, double by, const std::string& letter) {
    constexpr double least = 5, whole = 2 * std::numbers::pi;  // mm of arc; no arc says more than a turn
    if (std::abs(by) * radius < least || std::abs(by) > whole) return;
    plot.mark(drawings::AngleMark{plot.at(vertex), radius, std::min(from, from + by), std::max(from, from + by)});
    const drawings::Point v = plot.at(vertex);
    plot.label(letter,
               plot.from_paper({v.x + radius * std::cos(from + by / 2), v.y + radius * std::sin(from + by / 2)}),
               vertex);
  };
  const double mm = plot.scale().mm_per_unit;
  if (!f.problem.rolls_on_line() && plot.shows(f.O))
    mark(f.O, std::min(14.0, 0.4 * f.R * mm), 0, f.beta, f.problem.is_line() ? "$φ$" : "$β$");
  if (!f.C) return;
  const double towards_contact = std::atan2(f.P0.y - f.C->y, f.P0.x - f.C->x);
  const double whole = 2 * std::numbers::pi, rest = f.psi - whole * std::floor(f.psi / whole);
  mark(*f.C, std::min(9.0, 0.5 * f.r * mm), towards_contact, geometry::sense(f.problem.rolling) * rest, "$ψ$");
}

// Twelve to an arch, or every 30 deg of an involute: what the curve is drawn through by hand.
void draw_division(Plot& plot, const Drawn& f, const Way& way) {
  constexpr int most_divided_arches = 8;
  if (way.arches > most_divided_arches) return;
  const double k = geometry::from_rational<double>(geometry::rolled_per_turned(f.problem.rolling));
  const double step = 30 * degree / k, rolled = f.in_arch / k;
  for (double i = std::ceil((way.from + rolled) / step - 1e-9); i * step - rolled <= way.to + 1e-9 * step; ++i)
    plot.dot(f.path(i * step - rolled), Meaning::construction);
}

struct Cusp {
  Angle phi;
  Place at;
};
std::vector<Cusp> cusps_on(const Drawn& f, const Way& way) {
  std::vector<Cusp> found;
  // A little inside the far end, where a closed path comes back to its first cusp.
  const double little = 1e-9 * (way.to - way.from);
  const Angle from{0, Rational(way.from - little)}, to{0, Rational(way.closed ? way.to - little : way.to + little)};
  for (const Angle& phi : geometry::cusps(f.problem.rolling, f.problem.phi + from, f.problem.phi + to))
    found.push_back({phi, f.path(geometry::radians<double>(phi - f.problem.phi))});
  return found;
}

void draw_cusps(Plot& plot, const Drawn& f, const std::vector<Cusp>& cusps) {
  constexpr std::size_t most_letters = 12;
  for (std::size_t i = 0; i < cusps.size(); ++i) {
    plot.cross(cusps[i].at);
    if (cusps.size() > most_letters) continue;
    const std::string letter = fmt::format("$Q_{{{}}}$", i);
    const bool inside = f.problem.rolling.how == Rolls::circle_inside_circle;
    const Place outwards = cusps[i].at + 0.5 * (cusps[i].at - f.O);
    plot.label(letter, cusps[i].at,
               inside                      ? f.O
               : f.problem.rolls_on_line() ? Place{cusps[i].at.x, f.r}
                                           : outwards,
               Meaning::locus);
  }
}

std::vector<std::string> steps_along_path(const Drawn& f, Language language) {
  const Words name = name_of_path(f.problem);
  if (f.problem.is_line())
    return {
        Words{"The line $π$ rolls on the circle $p$ without slipping: what it has unwound, from its contact $P_{0}$ "
              "to the foot of $M$, is the arc $R$·$φ$.",
              "La retta $π$ rotola sul cerchio $p$ senza strisciare: il tratto svolto, dal contatto $P_{0}$ al piede "
              "di $M$, è l'arco $R$·$φ$."}
            .in(language),
        Words{"$M$ is carried by the line at the distance $d$: it traces the " + name.english + ".",
              "$M$ è portato dalla retta alla distanza $d$: descrive la curva detta " + name.italian + "."}
            .in(language)};
  const Words rolled =
      f.problem.rolls_on_line()
          ? Words{"The circle $π$ rolls on the line $p$ without slipping: its contact $P_{0}$ and its centre $C$ go "
                  "$r$·$φ$ to the right, $ψ$ = $φ$.",
                  "Il cerchio $π$ rotola sulla retta $p$ senza strisciare: il contatto $P_{0}$ e il centro $C$ vanno di "
                  "$r$·$φ$ a destra, $ψ$ = $φ$."}
          : Words{"The circle $π$ rolls on the circle $p$ without slipping: the arcs rolled off are equal, $r$·$ψ$ = "
                  "$R$·$β$, and the body has turned through $φ$ = $ψ$ " +
                      std::string(f.problem.rolling.how == Rolls::circle_outside_circle ? "+" : "−") + " $β$.",
                  "Il cerchio $π$ rotola sul cerchio $p$ senza strisciare: gli archi svolti sono uguali, $r$·$ψ$ = "
                  "$R$·$β$, e il corpo è ruotato di $φ$ = $ψ$ " +
                      std::string(f.problem.rolling.how == Rolls::circle_outside_circle ? "+" : "−") + " $β$."};
  return {rolled.in(language), Words{"$CM$ = $d$, at the angle $ψ$ from $CP_{0}$. $M$ traces the " + name.english +
                                         "; the dots are 30° of $ψ$ apart.",
                                     "$CM$ = $d$, all'angolo $ψ$ da $CP_{0}$. $M$ descrive la curva detta " +
                                         name.italian + "; i punti distano 30° di $ψ$."}
                                   .in(language)};
}

std::string degrees(double radians, Language language) { return short_number(radians / degree, language) + "°"; }

void fill_column(DrawnSheet& onto, const Drawn& f, const std::vector<Cusp>& cusps, Language language) {
  const bool english = language == Language::english;
  const auto num = [&](double x) { return figures(x, 4, language); };
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(drawings::Steps{steps_along_path(f, language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  if (f.problem.is_line() || f.problem.rolls_on_line())
    column.push_back(drawings::Paragraph{fmt::format("$φ$ = {}", degrees(f.phi, language))});
  else
    column.push_back(drawings::Paragraph{fmt::format("$φ$ = {},  $β$ = {},  $ψ$ = {}", degrees(f.phi, language),
                                                     degrees(f.beta, language), degrees(f.psi, language))});
  column.push_back(drawings::Paragraph{fmt::format("$M$ = ({}; {}) m", num(f.M_in_plane.x), num(f.M_in_plane.y))});
  column.push_back(drawings::Paragraph{fmt::format(
      "{} $s$ = {} m", english ? "Arc travelled since $φ$ = 0:" : "Arco percorso da $φ$ = 0:", num(f.s))});
  if (cusps.empty()) return;
  constexpr std::size_t most_rows = 6;
  column.push_back(drawings::Heading{f.runs_straight ? (english ? "$M$ turns back" : "$M$ torna indietro")
                                                     : (english ? "Cusps" : "Cuspidi")});
  drawings::Table table{{"", "$φ$", "$x$ (m)", "$y$ (m)"}, {}};
  for (std::size_t i = 0; i < std::min(cusps.size(), most_rows); ++i) {
    const Place in_plane = geometry::tracing_point<double>(f.problem.rolling, cusps[i].phi);
    table.rows.push_back({fmt::format("$Q_{{{}}}$", i), degrees(geometry::radians<double>(cusps[i].phi), language),
                          num(in_plane.x), num(in_plane.y)});
  }
  column.push_back(table);
  if (cusps.size() > most_rows)
    column.push_back(drawings::Paragraph{
        fmt::format("{} {}", english ? "and so on; in all" : "e così via; in tutto", cusps.size())});
}

}  // namespace

void draw_path_sheet(DrawnSheet& onto, const Problem& problem, const SheetRequest& request) {
  const Drawn f = drawn(problem);
  const Way way = way_of(f, 0.25);
  const std::vector<Place> points = samples(f, way);
  const drawings::Box room = room_above_scale_bars(request);
  const double reach = f.problem.is_line() ? std::max(f.d, f.R) : std::max({f.r, f.d, way.closed ? f.R : 0});
  const Fit fit =
      fit_lengths(room, request, 1000 / reach, [&](const Scale& s) { return extent_of(f, way, points, s); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_ground(plot, f, room);
  draw_axes(plot, f, room);
  draw_start(plot, f, way);
  draw_path(plot, f, way);
  draw_division(plot, f, way);
  draw_body(plot, f);
  draw_angles(plot, f);
  const double turning = geometry::to_double(problem.omega) * geometry::sense(problem.rolling);
  if (f.C && f.d > 0 && turning != 0) draw_sense_of_turning(plot, *f.C, f.M, turning, "$ω$");
  const std::vector<Cusp> cusps = cusps_on(f, way);
  draw_cusps(plot, f, cusps);
  plot.dot(f.M, Meaning::locus);
  plot.label("$M$", f.M, f.C ? *f.C : f.P0, Meaning::locus);
  plot.cross(f.P0);
  plot.label("$P_{0}$", f.P0, f.C ? *f.C : f.M, Meaning::locus);
  plot.step(1, f.P0);
  plot.step(2, f.M);
  plot.measures("P0M", f.P0, f.M);
  if (plot.shows(f.O)) {
    plot.measures_coordinates("M", f.M, f.O);
    plot.measures_coordinates("P0", f.P0, f.O);
  }
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {fit.scale}, request);
  fill_column(onto, f, cusps, request.language);
  const Words name = name_of_path(problem);
  onto.sheet.description =
      in_words({"The bodies at the start and at the instant, and the path of M: " + name.english,
                "I corpi all'inizio e all'istante, e la traiettoria di M: " + name.italian},
               {{"x_M", f.M_in_plane.x, "m"}, {"y_M", f.M_in_plane.y, "m"}, {"s", f.s, "m"}}, request.language);
}

}  // namespace epure::roulette
