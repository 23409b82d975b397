// Sheet 3: the polodes by the transport method. Each position's triangle A B P₀ stands where it is found (P₀ draws
// the fixed polode) and is carried back onto the AB of the instant (P₀ then draws the moving polode).
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-velocity/loci.h"

namespace epure::slider_crank_velocity {
namespace {

// The polodes run to infinity: the sheet shows the plane around the mechanism, so many times its length wide.
constexpr double widths = 2.4;

bool is_on(const drawings::Box& room, drawings::Point p) {
  return p.x > room.low.x && p.x < room.high.x && p.y > room.low.y && p.y < room.high.y;
}

void draw_triangles(Plot& plot, const Drawn& f, const drawings::Box& room) {
  std::optional<Place> last_fixed, last_moving;  // steps 1 and 2 stand there
  for (const Position& at : divided_positions(f.instant)) {
    if (at.P0 && is_on(room, plot.at(*at.P0))) {
      plot.polygon({at.A, at.B, *at.P0}, Meaning::alternative);
      plot.dot(*at.P0, Meaning::locus);
      plot.small_label(at.label, *at.P0, at.A);
      last_fixed = at.P0;
    }
    if (at.P0_on_coupler && is_on(room, plot.at(*at.P0_on_coupler))) {
      plot.segment(f.at.A, *at.P0_on_coupler, Meaning::construction);
      plot.segment(f.at.B, *at.P0_on_coupler, Meaning::construction);
      plot.dot(*at.P0_on_coupler, Meaning::second_locus);
      plot.small_label(at.label, *at.P0_on_coupler, f.at.A);
      last_moving = at.P0_on_coupler;
    }
    plot.dot(at.A, Meaning::construction);
    plot.small_label(at.label, at.A, f.at.A0);
  }
  if (last_fixed) plot.step(1, *last_fixed);
  if (last_moving) plot.step(2, *last_moving);
}

// Where a branch can be named: the middle of its longest run inside the room.
std::optional<Place> middle_of(const geometry::Trace& trace, const Plot& plot, const drawings::Box& room) {
  std::optional<Place> best;
  double farthest = 0;
  const drawings::Point centre{(room.low.x + room.high.x) / 2, (room.low.y + room.high.y) / 2};
  const double limit = 0.42 * room.height();
  for (const geometry::Branch& branch : trace.branches) {
    for (const geometry::BezierArc& arc : branch.arcs) {
      const drawings::Point p = plot.at(arc.end);
      const double away = std::abs(p.y - centre.y);
      if (!is_on(room, p) || away > limit || away < farthest) continue;
      farthest = away;
      best = arc.end;
    }
  }
  return best;
}

std::string division(const SliderCrankInstant& instant, bool english) {
  const char* of_crank = english ? "The crank's circle in {} parts" : "La circonferenza di manovella in {} parti";
  const char* of_coupler =
      english ? "The directions of the coupler in {} parts" : "Le direzioni della biella in {} parti";
  const char* primed = english ? " (primed: $B$ behind $A$)" : " (con apice: $B$ dietro $A$)";
  const Circuit circuit = circuit_of(instant);
  return fmt::format(fmt::runtime(circuit == Circuit::coupler ? of_coupler : of_crank), positions) +
         (circuit == Circuit::both ? primed : "");
}

drawings::Steps steps(const SliderCrankInstant& instant, bool has_asymptotes, Language language) {
  const bool english = language == Language::english;
  drawings::Steps all =
      english
          ? drawings::Steps{{division(instant, english) +
                                 ". In each position $P_{0}$ on $A_{0}A$ and square to the guide through $B$: "
                                 "the points of the fixed polode $p$.",
                             "Each triangle $ABP_{0}$ on tracing paper, carried back until its $AB$ covers the $AB$ "
                             "of the position drawn: its $P_{0}$ marks a point of the moving polode $π$.",
                             "The curves through the points. They touch in the $P_{0}$ of the position drawn and "
                             "roll on each "
                             "other.",
                             "Where the crank is square to the guide $P_{0}$ goes to infinity: the dash-dot lines "
                             "are the asymptotes."}}
          : drawings::Steps{
                {division(instant, english) +
                     ". In ogni posizione $P_{0}$ su $A_{0}A$ e sulla normale alla guida per $B$: i "
                     "punti della polare fissa $p$.",
                 "Ogni triangolo $ABP_{0}$ su carta da lucido, riportato finché il suo $AB$ copre "
                 "l'$AB$ della posizione disegnata: il suo $P_{0}$ segna un punto della polare mobile $π$.",
                 "Le curve per i punti. Si toccano nel $P_{0}$ della posizione disegnata e rotolano l'una "
                 "sull'altra.",
                 "Dove la manovella è normale alla guida $P_{0}$ va all'infinito: le rette a tratto e "
                 "punto sono gli asintoti."}};
  if (!has_asymptotes) all.lines.pop_back();
  return all;
}

}  // namespace

void draw_polodes(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const double size = std::hypot(f.at.A.x, f.at.A.y) + CGAL::to_double(f.instant.lengths.l);
  const Scale scale =
      request.scale ? length_scale(*request.scale) : largest_length_scale(room.width() / (widths * size));
  // The middle of the mechanism's reach in the middle of the room.
  const drawings::Point centre{(room.low.x + room.high.x) / 2, (room.low.y + room.high.y) / 2};
  const GuideAxes guide(f.at);
  const Place middle = guide.at(0.45 * size);
  Plot plot(onto, {centre.x - scale.mm_per_unit * middle.x, centre.y - scale.mm_per_unit * middle.y}, scale);
  onto.sheet.figure.windows = {room};
  draw_triangles(plot, f, room);

  const geometry::Arithmetic<geometry::Bounded> scope;
  const auto reference = reference_of(f.instant).coupler;
  using Loop = geometry::SliderCrankLoop<geometry::Bounded>;
  const auto fixed = [](const Loop& loop) { return geometry::FixedPolode<geometry::Bounded>{loop}; };
  const auto moving = [&](const Loop& loop) { return geometry::MovingPolode<geometry::Bounded>{loop, reference}; };
  bool has_asymptotes = false;
  for (const Loop& loop : loops_of<geometry::Bounded>(f.instant)) {
    const auto of_fixed = geometry::asymptotes(fixed(loop)).lines,
               of_moving = geometry::asymptotes(moving(loop)).lines;
    for (const auto& lines : {of_fixed, of_moving})
      for (const geometry::Asymptote& asymptote : lines) draw_line(plot, asymptote.line, Meaning::axis);
    if (!has_asymptotes && !of_fixed.empty()) {
      // On the first of them, as far below the guide as the mechanism is long.
      const auto& [a, b, c] = of_fixed.front().line;
      const double abscissa = guide.abscissa({-a * c, -b * c});
      plot.step(4, guide.at(abscissa, -size));
    }
    has_asymptotes = has_asymptotes || !of_fixed.empty();
  }
  const geometry::Trace p = draw_loci(plot, f.instant, fixed, room, Meaning::locus, "fixed_polode");
  const geometry::Trace pi = draw_loci(plot, f.instant, moving, room, Meaning::second_locus, "moving_polode");
  draw_slider_crank(plot, f.at, sign_of(f.instant.n));
  if (f.P0) {
    plot.cross(*f.P0);
    plot.label("$P_{0}$", *f.P0, f.at.M, Meaning::locus);
    plot.step(3, *f.P0);
  }
  if (const auto at = middle_of(p, plot, room)) plot.label("$p$", *at, {}, Meaning::locus);
  if (const auto at = middle_of(pi, plot, room)) plot.label("$π$", *at, {}, Meaning::second_locus);
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {scale}, request);

  const bool english = request.language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(f.instant, has_asymptotes, request.language));
  column.push_back(drawings::Heading{english ? "The curves" : "Le curve"});
  const auto in_mm = [&](const geometry::Trace& t) {
    return figures(t.deviation() * scale.mm_per_unit, 1, request.language);
  };
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(
          english
              ? "$p$: {} Bezier arcs, at most {} mm from the true curve. $π$: {} arcs, at most {} mm."
              : "$p$: {} archi di Bézier, a non più di {} mm dalla curva vera. $π$: {} archi, a non più di {} mm."),
      p.arcs(), in_mm(p), pi.arcs(), in_mm(pi))});
  onto.sheet.description = in_words(
      {"Fixed and moving polode of the coupler by the transport method, in twelve positions, with their asymptotes",
       "Polare fissa e polare mobile della biella col metodo del trasporto, in dodici posizioni, con gli asintoti"},
      {}, request.language);
}

}  // namespace epure::slider_crank_velocity
