// Sheet 3: the polodes by the transport method. Each position's triangle A B P₀ stands where it is found (P₀ draws
// the fixed polode) and is carried back onto the AB of the instant (P₀ then draws the moving polode).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/paths/vectors.h"
#include "exercises/kit/linkages/slider_crank_mechanism.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/named_curve.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/slider-crank-velocity/loci.h"

namespace epure::slider_crank_velocity {
namespace {

// The polodes run to infinity: the sheet shows the plane around the mechanism, so many times its length wide; less of
// it, with P0 where that is near, where twice as many points stand there.
constexpr double widths = 2.2, widths_of_two_series = 1.4, near = 1.5;
constexpr double middle_of_reach = 0.45;  // of the same length, from A0 along the guide

Words division(const SliderCrankInstant& instant) {
  const Circuit circuit = circuit_of(instant);
  const Words divided = circuit == Circuit::coupler
                            ? Words{"The directions of the coupler", "Le direzioni della biella"}
                            : Words{"The crank's circle", "La circonferenza di manovella"};
  const Words all = divided + format_words(" in {} parts", " in {} parti", positions);
  const Words primed{" (primed: $B$ behind $A$)", " (con l'apice: l'altra posizione di $B$, dietro $A$)"};
  return circuit == Circuit::both ? all + primed : all;
}

std::vector<Words> step_words(const SliderCrankInstant& instant, bool touch_at_infinity) {
  const Words joined = circuit_of(instant) == Circuit::coupler
                           ? Words{". ", ". "}
                           : Words{". The arc of radius $l$ about each $A$ gives $B$ on the guide. ",
                                   ". L'arco di raggio $l$ con centro in ogni $A$ dà $B$ sulla guida. "};
  const Words of_fixed{
      "In each position $P_{0}$ on $A_{0}A$ and on the perpendicular to the guide through $B$: the points of the "
      "fixed polode $p$.",
      "In ogni posizione $P_{0}$ su $A_{0}A$ e sulla normale alla guida per $B$: i punti della polare fissa $p$."};
  const Words of_moving{
      "Each triangle $ABP_{0}$ on tracing paper, carried back until its $AB$ covers the $AB$ of the position drawn: "
      "its $P_{0}$ marks a point of the moving polode $π$.",
      "Ogni triangolo $ABP_{0}$ su carta da lucido, riportato finché il suo $AB$ copre l'$AB$ della posizione "
      "disegnata: il suo $P_{0}$ segna un punto della polare mobile $π$."};
  const Words beyond{
      "The curves through the points. They roll on each other; in the position drawn $P_{0}$ is at infinity, and "
      "they have an asymptote in common.",
      "Le curve per i punti. Rotolano l'una sull'altra; nella posizione disegnata $P_{0}$ è all'infinito, e hanno un "
      "asintoto in comune."};
  const Words touching{
      "The curves through the points. They touch in the $P_{0}$ of the position drawn and roll on each other.",
      "Le curve per i punti. Si toccano nel $P_{0}$ della posizione disegnata e rotolano l'una sull'altra."};
  const Words asymptotes{
      "Where the crank is perpendicular to the guide $P_{0}$ goes to infinity: the dash-dot lines are the "
      "asymptotes.",
      "Dove la manovella è normale alla guida $P_{0}$ va all'infinito: le rette a tratto e punto sono gli asintoti."};
  return {division(instant) + joined + of_fixed, of_moving, touch_at_infinity ? beyond : touching, asymptotes};
}

class PolodesPanel : public Panel {
 public:
  PolodesPanel(const Solution& solution, const SliderCrankInstant& instant)
      : instant_(instant),
        mechanism_(Mechanism(*slider_crank_mechanism(solution, instant, {.marks_M = false})).with_open_blocks()),
        P0_(solution.point("P0")),
        positions_(divided_positions(instant)),
        size_(CGAL::to_double(instant.lengths.r + instant.lengths.l)) {
    const geometry::Arithmetic<geometry::Bounded> scope;
    reference_.emplace(reference_of(instant).coupler);
    for (const Loop& loop : loops_of<geometry::Bounded>(instant)) {
      for (const geometry::Asymptote& each : geometry::asymptotes(fixed(loop)).lines) of_fixed_.push_back(each.line);
      for (const geometry::Asymptote& each : geometry::asymptotes(moving(loop)).lines)
        of_moving_.push_back(each.line);
    }
  }

  double reach() const override { return size_; }
  bool is_cut() const override { return true; }

  // The middle of the mechanism's reach in the middle of the room.
  drawings::Box extent(const Scale& lengths, const Scale&) const override {
    const Place middle = along_guide(middle_of_reach * size_);
    const double x = lengths.mm_per_unit * middle.x, y = lengths.mm_per_unit * middle.y;
    const bool has_two_series = circuit_of(instant_) == Circuit::both;
    const double shown = has_two_series ? widths_of_two_series : widths;
    const double half_wide = lengths.mm_per_unit * shown * size_ / 2, half_high = half_wide / 2;
    constexpr double letters = 8;  // mm
    Extent extent;
    mechanism_.include(extent, lengths);
    extent.include(x - half_wide, y - half_high);
    extent.include(x + half_wide, y + half_high);
    if (has_two_series && P0_ && distance(*P0_, middle) < near * size_) extent.include(lengths, *P0_, letters);
    return extent.box();
  }

  // B, through which both curves pass, and their points near the mechanism: where many are in one place it is drawn
  // larger. As the curves roll on each other, points of both that are all but one are no crowd.
  std::vector<Place> lettered() const override {
    constexpr double one_point = 0.012;  // of the mechanism's length: a millimetre, where it is drawn large
    std::vector<Place> all{mechanism_.at("B")};
    for (const Position& at : positions_)
      for (const auto& P : {at.P0, at.P0_on_coupler})
        if (P && distance(*P, mechanism_.at("A0")) < size_ &&
            std::none_of(all.begin(), all.end(), [&](const Place& Q) { return distance(*P, Q) < one_point * size_; }))
          all.push_back(*P);
    return all;
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_.draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    draw_triangles(plot, room);
    plot.in_step(of_fixed_.empty() ? Step::curves : Step::asymptotes);
    for (const auto* lines : {&of_fixed_, &of_moving_})
      for (const geometry::Line<double>& line : *lines) draw_line(plot, line, Meaning::axis);
    if (room.width() > size_ * plot.scale().mm_per_unit) {  // a close-up shows less: the whole names them
      name_asymptotes(plot, room, of_fixed_, "$p$", language);
      name_asymptotes(plot, room, of_moving_, "$π$", language);
    }
    plot.in_step(Step::curves);
    const geometry::Trace p = draw_loci(
        plot, instant_, [&](const Loop& loop) { return fixed(loop); }, room, Meaning::locus, "fixed_polode");
    const geometry::Trace pi = draw_loci(
        plot, instant_, [&](const Loop& loop) { return moving(loop); }, room, Meaning::second_locus, "moving_polode");
    plot.in_step(Step::given);
    mechanism_.draw(plot);
    plot.in_step(Step::moving);
    for (const Position& at : positions_)
      if (at.P0_on_coupler && is_in(room, plot, *at.P0_on_coupler))
        plot.dot(*at.P0_on_coupler, Meaning::second_locus);  // over the hinge B, through which π passes
    plot.in_step(Step::curves);
    if (P0_) {
      plot.cross(*P0_);
      plot.label("$P_{0}$", *P0_, mechanism_.at("M"), Meaning::locus);
    }
    name_branches(plot, room, p, "$p$", Meaning::locus);
    name_branches(plot, room, pi, "$π$", Meaning::second_locus);
    std::vector<drawings::Block> told = of_curves(p, pi, plot.scale(), language);
    for (const Words& each : left_out(plot, room)) told.emplace_back(drawings::Paragraph{each.in(language)});
    return told;
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override {
    std::optional<Place> last_fixed, last_moving;
    for (const Position& at : positions_) {
      if (at.P0 && is_in(room, plot, *at.P0)) last_fixed = at.P0;
      if (at.P0_on_coupler && is_in(room, plot, *at.P0_on_coupler)) last_moving = at.P0_on_coupler;
    }
    const std::vector<Words> texts = step_words(instant_, !P0_);
    std::vector<PanelStep> all{{texts[0], last_fixed}, {texts[1], last_moving}, {texts[2], P0_}};
    if (!of_fixed_.empty()) all.push_back({texts[3], on_asymptote(plot, room)});
    return all;
  }

 private:
  struct Step {  // of the construction
    static constexpr int given = 0, fixed = 1, moving = 2, curves = 3, asymptotes = 4;
  };
  using Loop = geometry::SliderCrankLoop<geometry::Bounded>;

  static geometry::FixedPolode<geometry::Bounded> fixed(const Loop& loop) { return {loop}; }
  geometry::MovingPolode<geometry::Bounded> moving(const Loop& loop) const { return {loop, *reference_}; }

  Arrow2 guide() const {
    const double delta = geometry::to_double(instant_.guide);
    return {std::cos(delta), std::sin(delta)};
  }
  // From the foot of A0 on the guide, so far along it and to its left.
  Place along_guide(double abscissa, double ordinate = 0) const {
    const Arrow2 along = guide(), left{-along.y, along.x};
    return mechanism_.at("A0") + abscissa * along + (CGAL::to_double(instant_.lengths.e) + ordinate) * left;
  }
  // As far below the guide as the mechanism is long; where the sheet ends before, where one crosses its middle.
  Place on_asymptote(const Plot& plot, const drawings::Box& room) const {
    const auto& [a, b, c] = of_fixed_.front();
    const Place below = along_guide(dot(Place{-a * c, -b * c} - along_guide(0), guide()), -size_);
    if (is_in(room, plot, below)) return below;
    const Place middle = plot.from_paper({(room.low.x + room.high.x) / 2, (room.low.y + room.high.y) / 2});
    Place nearest = below;
    for (const auto& [p, q, r] : of_fixed_)
      if (const Place foot = middle + -(p * middle.x + q * middle.y + r) * Arrow2{p, q};
          distance(foot, middle) < distance(nearest, middle))
        nearest = foot;
    return nearest;
  }

  // Each where it leaves the room, below if it does so there; two in one line once.
  static void name_asymptotes(Plot& plot, const drawings::Box& room, const std::vector<geometry::Line<double>>& lines,
                              const std::string& curve, Language language) {
    constexpr double one_line = 1;  // mm
    std::vector<Place> named;
    for (const geometry::Line<double>& line : lines) {
      const auto P = near_edge(plot, room, line);
      const bool is_named = P && std::any_of(named.begin(), named.end(), [&](const Place& Q) {
                              return distance(*P, Q) * plot.scale().mm_per_unit < one_line;
                            });
      if (!P || is_named) continue;
      plot.small_label(Words{"asymptote of ", "asintoto di "}.in(language) + curve, *P, *P);
      named.push_back(*P);
    }
  }
  static std::optional<Place> near_edge(const Plot& plot, const drawings::Box& room,
                                        const geometry::Line<double>& line) {
    constexpr double above_end = 5, half_letters = 12;  // mm
    const auto& [a, b, c] = line;
    const Place low = plot.from_paper({room.low.x + half_letters, room.low.y + above_end}),
                high = plot.from_paper({room.high.x - half_letters, room.high.y - above_end});
    for (const double y : {low.y, high.y})
      if (const Place P{-(b * y + c) / a, y}; a != 0 && is_in(room, plot, P)) return P;
    for (const double x : {high.x, low.x})
      if (const Place P{x, -(a * x + c) / b}; b != 0 && is_in(room, plot, P)) return P;
    return {};
  }

  // What rolls off the sheet and comes back has its letter on each piece.
  static void name_branches(Plot& plot, const drawings::Box& room, const geometry::Trace& curve,
                            const std::string& letter, Meaning ink) {
    constexpr double one_piece = 12;  // mm
    std::vector<Place> named;
    for (const geometry::Branch& branch : curve.branches) {
      geometry::Trace alone;
      alone.branches = {branch};
      const auto at = middle_of(alone, plot, room);
      if (!at || std::any_of(named.begin(), named.end(), [&](const Place& other) {
            return distance(*at, other) * plot.scale().mm_per_unit < one_piece;
          }))
        continue;
      plot.label(letter, *at, {}, ink);
      named.push_back(*at);
    }
  }

  // Where the arcs about A meet the guide; a point of p that lies there has its number already.
  void draw_B(Plot& plot, const drawings::Box& room) const {
    std::vector<std::pair<Place, std::string>> of_guide;
    for (const Position& at : positions_) {
      if (at.P0 && is_one_point(plot, *at.P0, at.B)) continue;
      plot.dot(at.B, Meaning::construction);
      of_guide.emplace_back(at.B, at.label);
    }
    const auto numbered = numbered_together(plot, of_guide);
    if (!has_room(plot, numbered)) return;
    // mm: about the block the numbers stand below its guide, to which lines lead
    constexpr double half_guide = 14, hatched = 6;
    const double mm = plot.scale().mm_per_unit;
    const Arrow2 up{-guide().y, guide().x};
    for (const auto& [B, numbers] : numbered) {
      if (!is_in(room, plot, B)) continue;
      const bool is_on_guide = distance(B, mechanism_.at("B")) * mm < half_guide;
      const Place at = is_on_guide ? B + (-hatched / mm) * up : B;
      if (is_on_guide) plot.segment(B, at, Meaning::dimension);
      plot.small_label(numbers, at, B + size_ * up, Meaning::construction);
    }
  }
  // For the numbers of these points beside each other on the guide.
  bool has_room(const Plot& plot, const std::vector<std::pair<Place, std::string>>& numbered) const {
    constexpr double each = 4.5;  // mm
    double low = 0, high = 0;     // from the first
    for (const auto& [B, numbers] : numbered) {
      const double along = dot(B - numbered.front().first, guide());
      low = std::min(low, along);
      high = std::max(high, along);
    }
    return (high - low) * plot.scale().mm_per_unit >= each * static_cast<double>(numbered.size());
  }
  static bool is_one_point(const Plot& plot, const Place& P, const Place& Q) {
    constexpr double one_point = 0.5;  // mm
    return distance(P, Q) * plot.scale().mm_per_unit < one_point;
  }

  void draw_triangles(Plot& plot, const drawings::Box& room) const {
    const Place A0 = mechanism_.at("A0"), A = mechanism_.at("A"), B = mechanism_.at("B");
    std::vector<std::pair<Place, std::string>> of_moving_polode;
    for (const Position& at : positions_) {
      plot.in_step(Step::fixed);
      if (at.P0 && is_in(room, plot, *at.P0)) {
        plot.polygon({at.A, at.B, *at.P0}, Meaning::construction);
        plot.dot(*at.P0, Meaning::locus);
        plot.small_label(at.label, *at.P0, at.A, Meaning::locus);
      }
      plot.dot(at.A, Meaning::construction);
      if (!shares_A(at, positions_)) plot.small_label(at.label, at.A, A0, Meaning::construction);
      plot.in_step(Step::moving);
      if (at.P0_on_coupler && is_in(room, plot, *at.P0_on_coupler)) {
        plot.segment(A, *at.P0_on_coupler, Meaning::construction);
        plot.segment(B, *at.P0_on_coupler, Meaning::construction);
        // In the position drawn it is the point of p, which has the number.
        if (!at.P0 || !is_one_point(plot, *at.P0, *at.P0_on_coupler))
          of_moving_polode.emplace_back(*at.P0_on_coupler, at.label);
      }
    }
    plot.in_step(Step::fixed);
    draw_B(plot, room);
    plot.in_step(Step::moving);
    for (const auto& [P0, numbers] : numbered_together(plot, of_moving_polode))
      plot.small_label(numbers, P0, A, Meaning::second_locus);
  }

  // Of the twelve positions those whose points are not on the sheet, and why.
  std::vector<Words> left_out(const Plot& plot, const drawings::Box& room) const {
    std::string off_fixed, off_moving, infinite;
    const auto add = [](std::string& list, const std::string& label) { list += (list.empty() ? "" : ", ") + label; };
    for (const Position& at : positions_) {
      if (!at.P0) {
        add(infinite, at.label);
        continue;
      }
      if (!is_in(room, plot, *at.P0)) add(off_fixed, at.label);
      if (at.P0_on_coupler && !is_in(room, plot, *at.P0_on_coupler)) add(off_moving, at.label);
    }
    std::vector<Words> all;
    for (const auto& [letter, list] : {std::pair{"p", off_fixed}, std::pair{"π", off_moving}})
      if (!list.empty())
        all.push_back(
            format_words("Points of ${}$ off the sheet: {}.", "Punti di ${}$ fuori del foglio: {}.", letter, list));
    if (!infinite.empty())
      all.push_back(format_words("$P_{{0}}$ at infinity: {}.", "$P_{{0}}$ all'infinito: {}.", infinite));
    return all;
  }

  static std::vector<drawings::Block> of_curves(const geometry::Trace& p, const geometry::Trace& pi,
                                                const Scale& scale, Language language) {
    const auto in_mm = [&](const geometry::Trace& t) {
      return figures(t.deviation() * scale.mm_per_unit, 1, language);
    };
    const Words sentence{
        "$p$: {} Bezier arcs, at most {} mm from the true curve. $π$: {} arcs, at most {} mm.",
        "$p$: {} archi di Bézier, a non più di {} mm dalla curva vera. $π$: {} archi, a non più di {} mm."};
    return {drawings::Heading{Words{"The curves", "Le curve"}.in(language)},
            drawings::Paragraph{
                fmt::format(fmt::runtime(sentence.in(language)), p.arcs(), in_mm(p), pi.arcs(), in_mm(pi))}};
  }

  SliderCrankInstant instant_;
  Mechanism mechanism_;  // both polodes pass beneath its block
  std::optional<Place> P0_;
  std::vector<Position> positions_;
  double size_;  // crank and coupler in line
  std::optional<geometry::CouplerPosition<geometry::Bounded>> reference_ = {};
  std::vector<geometry::Line<double>> of_fixed_, of_moving_;  // asymptotes
};

}  // namespace

PanelSheet polodes_sheet(const Solution& s, Language) {
  return {.panels = panels(PolodesPanel(s, slider_crank_instant(s.givens()))),
          .seen = {"Fixed and moving polode of the coupler by the transport method, in twelve positions, with their "
                   "asymptotes",
                   "Polare fissa e polare mobile della biella col metodo del trasporto, in dodici posizioni, con gli "
                   "asintoti"}};
}

}  // namespace epure::slider_crank_velocity
