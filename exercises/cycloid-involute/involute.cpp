// The involute as a student draws it: on the tangent at each point of the circle the length that has been unrolled.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/rolling/rolling_picture.h"
#include "geometry/motion/roulette_divisions.h"

namespace epure::cycloid_involute {
namespace {

using geometry::Deep;

// Of a turn: small enough for a divider to step off the arc by its chord, large enough for letters. Twelve of them
// are two thirds of a turn, as much as A4 takes at the source's scale.
const Rational part_of_turn(1, 18);
constexpr int unrolled_part = 5;  // the one that is explained, as in the source

// Seen from P₀, where the line first touches the circle.
std::vector<Division> parts_of(const Rational& r) {
  return deeply([&] {
    const geometry::Vector<Deep> to_P0{geometry::from_rational<Deep>(r), Deep(0)};
    const auto seen = [&](const geometry::Point<Deep>& P) { return to_double(P + -to_P0); };
    std::vector<Division> found;
    for (int i = 1; i <= divisions; ++i) {
      const auto at = geometry::involute_division<Deep>(r, {i * part_of_turn});
      found.push_back({seen(at.on_line), seen(at.on_circle), seen(at.M)});
    }
    return found;
  });
}

Place middle(const Place& P, const Place& Q) { return {(P.x + Q.x) / 2, (P.y + Q.y) / 2}; }

class InvolutePanel : public Panel {
 public:
  explicit InvolutePanel(const Problem& of) : of_(of), r_(CGAL::to_double(of.r_0)), parts_(parts_of(of.r_0)) {}

  double reach() const override { return r_; }
  bool is_cut() const override { return true; }

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    constexpr double letters = 7, a_little = 2;  // mm
    extent.include(scale, {-2 * r_, -r_}, a_little);
    extent.include(scale, {0, r_}, a_little);
    extent.include(letters + 3, 0);
    extent.include(scale, part(divisions).on_line, a_little);
    for (const Division& at : parts_) {
      extent.include(scale, at.M, a_little);
      extent.include(scale.mm_per_unit * at.M.x - letters, scale.mm_per_unit * at.M.y);
    }
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    plot.circle(centre(), r_, Meaning::link, "base_circle");
    plot.long_segment(P0_, part(divisions).on_line, 3, Meaning::link);
    plot.dot(centre(), Meaning::text);
    plot.label("$C$", centre(), P0_);
    plot.label("$P_{0}$", P0_, centre());
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override {
    const RollingGivens line{of_.line(), {}, {}, {}};
    const double to = divisions * CGAL::to_double(part_of_turn) * 2 * std::numbers::pi;
    plot.in_step(Step::other_branch);
    draw_path(plot, line, {-to / 2, 0}, Meaning::alternative);
    plot.in_step(Step::all_others);
    const double deviation = draw_path(plot, line, {0, to});
    const Place C = centre(), end = part(divisions).on_line;
    plot.in_step(Step::given);
    plot.circle(C, r_, Meaning::link, "base_circle");
    plot.long_segment(P0_, end, 3, Meaning::link);
    plot.segment(C, P0_, Meaning::axis);
    draw_parts(plot);
    draw_sense_of_line(plot, P0_, end,
                       {.sense = 1, .share = 0.96});  // beyond the curve, which the line meets further down
    const Division& at = part(unrolled_part);
    plot.in_step(Step::tangent);
    plot.segment(C, at.on_body, Meaning::construction);
    plot.right_angle(at.on_body, C, at.M);
    plot.in_step(Step::given);
    plot.dot(C, Meaning::text);
    plot.label("$C$", C, at.on_body);
    plot.label("$P_{0}$", P0_, C);
    const double diagonal = r_ * std::numbers::sqrt2 / 2;
    plot.label("$λ$", {C.x - diagonal, C.y - diagonal}, C);
    plot.label("$l$", middle(part(divisions - 1).on_line, end), Place{r_, end.y});
    return of_curve(deviation, language);
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    const Division& at = part(unrolled_part);
    return {{{"On the line $l$, from $P_{0}$, small equal parts: 1′, 2′, ... 12′, here $πd_{0}$/18 each.",
              "Sulla retta $l$, da $P_{0}$, parti uguali e piccole: 1′, 2′, ... 12′, qui di $πd_{0}$/18."},
             middle(part(divisions - 3).on_line, part(divisions - 2).on_line)},
            {{"On the circle $λ$ as many arcs of the same length, here 20° each: 1, 2, ... 12. They are the instant "
              "centres in their order: 5′ comes to 5.",
              "Sul cerchio $λ$ altrettanti archi di uguale lunghezza, qui di 20°: 1, 2, ... 12. Sono i successivi "
              "centri di istantanea rotazione: 5′ viene in 5."},
             middle(part(1).on_body, part(2).on_body)},
            {{"At 5 the tangent to $λ$, and on it, backwards, the length $P_{0}$ 5′: its end V is where $P_{0}$ has "
              "come to.",
              "In 5 la tangente a $λ$, e su di essa, all'indietro, la lunghezza $P_{0}$ 5′: l'estremo V è dove "
              "$P_{0}$ è andato."},
             middle(at.on_body, at.M)},
            {{"So all the others; the curve through them is perpendicular to every tangent.",
              "Così tutti gli altri; la curva che li unisce è normale a ogni tangente."},
             part(divisions - 1).M},
            {{"Drawn is $ω$ counter-clockwise, as the source's equations have it. Clockwise, as its text says, the "
              "line draws the other branch (dashed), the mirror image in $CP_{0}$.",
              "È disegnata $ω$ antioraria, come nelle equazioni della fonte. In senso orario, come dice il testo, la "
              "retta traccia l'altro ramo (a tratti), simmetrico rispetto a $CP_{0}$."},
             Place{part(3).M.x, -part(3).M.y}}};
  }

 private:
  struct Step {  // of the construction
    static constexpr int given = 0, line = 1, circle = 2, tangent = 3, all_others = 4, other_branch = 5;
  };

  const Division& part(int number) const { return parts_[static_cast<std::size_t>(number - 1)]; }
  Place centre() const { return {-r_, 0}; }

  void draw_parts(Plot& plot) const {
    constexpr double room_for_letters = 14, for_some = 5;  // mm: about a smaller circle each third is named, or none
    const double radius = r_ * plot.scale().mm_per_unit;
    for (int i = 1; i <= divisions; ++i) {
      const Division& at = part(i);
      const int found = i == unrolled_part ? Step::tangent : Step::all_others;
      plot.in_step(found);
      plot.segment(at.on_body, at.M, i == unrolled_part ? Meaning::dimension : Meaning::construction);
      plot.in_step(Step::circle);
      plot.dot(at.on_body);
      plot.in_step(Step::line);
      plot.dot(at.on_line);
      plot.in_step(found);
      plot.dot(at.M, Meaning::locus);
      if (radius < for_some || (radius < room_for_letters && i % 3 != 0 && i != unrolled_part)) continue;
      plot.small_label(roman[static_cast<std::size_t>(i - 1)], at.M, at.on_body);
      plot.in_step(Step::circle);
      plot.small_label(std::to_string(i), at.on_body, at.M);
      plot.in_step(Step::line);
      plot.small_label(fmt::format("{}′", i), at.on_line, centre());
    }
    plot.in_step(Step::given);
  }

  static std::vector<drawings::Block> of_curve(double deviation, Language language) {
    const Words equation{"$x$ = $r$ (cos $φ$ + $φ$ sin $φ$),  $y$ = $r$ (sin $φ$ − $φ$ cos $φ$)",
                         "$x$ = $r$ (cos $φ$ + $φ$ sen $φ$),  $y$ = $r$ (sen $φ$ − $φ$ cos $φ$)"};
    // With − its speed is √((2 sin φ + φ cos φ)² + φ² sin² φ) times ω r instead of φ: 2.38 of them at φ = 1.
    const Words slip{
        "The source prints $x$ with − for +. At $φ$ = 1 that point would move more than twice as fast as $v$ = "
        "$ω$·$P_{0}M$, which the source uses too.",
        "La fonte stampa $x$ con − al posto di +. A $φ$ = 1 quel punto andrebbe più di due volte più veloce di $v$ = "
        "$ω$·$P_{0}M$, che usa anche la fonte."};
    std::vector<drawings::Block> told = told_of_curve({"involute", "evolvente"}, equation, deviation, language);
    told.push_back(drawings::Paragraph{slip.in(language)});
    return told;
  }

  Problem of_;
  double r_;
  std::vector<Division> parts_;  // 1..12
  const Place P0_{0, 0};
};

}  // namespace

PanelSheet involute_sheet(const Solution& s, Language) {
  return {.panels = panels(InvolutePanel(Problem(s.givens()))),
          .seen = {"The base circle with twelve tangents, each as long as the arc unrolled from it, and the involute "
                   "through their ends",
                   "Il cerchio di base con dodici tangenti, lunghe ciascuna quanto l'arco svolto, e l'evolvente per "
                   "i loro estremi"},
          .without_part = givens_of_cycloid};
}

}  // namespace epure::cycloid_involute
