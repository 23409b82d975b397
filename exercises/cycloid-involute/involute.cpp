// The involute as a student draws it: on the tangent in each point of the circle the length that has been unrolled.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/cycloid-involute/figure.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/motion/roulette_divisions.h"

namespace epure::cycloid_involute {
namespace {

using geometry::Deep;

// Of a turn: small enough for a divider to step off the arc by its chord, large enough for letters. Twelve of them
// are two thirds of a turn, as much as A4 takes at the source's scale.
const Rational part_of_turn(1, 18);
constexpr int unrolled_part = 5;  // the one that is explained, as in the source

struct InvolutePart {
  Place on_line, on_circle, M;
};

struct Involute {
  double r;
  std::vector<InvolutePart> parts;  // 1..12
  const InvolutePart& part(int number) const { return parts[static_cast<std::size_t>(number - 1)]; }
  Place P0() const { return {r, 0}; }
};

std::vector<InvolutePart> parts_of_involute(const Problem& of) {
  return deeply([&] {
    std::vector<InvolutePart> found;
    for (int i = 1; i <= divisions; ++i) {
      const auto at = geometry::involute_division<Deep>(of.r_0, {i * part_of_turn});
      found.push_back({to_double(at.on_line), to_double(at.on_circle), to_double(at.M)});
    }
    return found;
  });
}

drawings::Box extent_of(const Involute& f, const Scale& scale) {
  Extent extent;
  constexpr double letters = 7, a_little = 2;  // mm
  extent.include(scale, {-f.r, -f.r}, a_little);
  extent.include(scale, {f.r, f.r}, a_little);
  extent.include(f.r * scale.mm_per_unit + letters + 3, 0);
  extent.include(scale, f.part(divisions).on_line, a_little);
  for (const InvolutePart& at : f.parts) {
    extent.include(scale, at.M, a_little);
    extent.include(scale.mm_per_unit * at.M.x - letters, scale.mm_per_unit * at.M.y);
  }
  return extent.box();
}

void draw_figure(Plot& plot, const Involute& f) {
  const Place C{0, 0}, P0 = f.P0(), end = f.part(divisions).on_line;
  plot.circle(C, f.r, Meaning::link, "base_circle");
  plot.long_segment({P0.x, 0}, end, 3, Meaning::link);
  plot.segment(C, P0, Meaning::axis);
  for (int i = 1; i <= divisions; ++i) {
    const InvolutePart& at = f.part(i);
    plot.segment(at.on_circle, at.M, i == unrolled_part ? Meaning::dimension : Meaning::construction);
    plot.dot(at.on_circle);
    plot.dot(at.on_line);
    plot.dot(at.M, Meaning::locus);
    plot.small_label(roman[static_cast<std::size_t>(i - 1)], at.M, at.on_circle);
    plot.small_label(std::to_string(i), at.on_circle, at.M);
    plot.small_label(fmt::format("{}'", i), at.on_line, C);
  }
  const InvolutePart& at = f.part(unrolled_part);
  const auto middle = [](const Place& P, const Place& Q) { return Place{(P.x + Q.x) / 2, (P.y + Q.y) / 2}; };
  plot.segment(C, at.on_circle, Meaning::construction);
  plot.right_angle(at.on_circle, C, at.M);
  plot.dot(C, Meaning::text);
  plot.label("$C$", C, at.on_circle);
  plot.label("$P_{0}$", P0, C);
  plot.label("λ", {-f.r * std::numbers::sqrt2 / 2, -f.r * std::numbers::sqrt2 / 2}, C);
  plot.label("l", middle(f.part(divisions - 1).on_line, end), Place{2 * P0.x, end.y});
  plot.step(1, middle(f.part(divisions - 3).on_line, f.part(divisions - 2).on_line));
  plot.step(2, middle(f.part(1).on_circle, f.part(2).on_circle));
  plot.step(3, middle(at.on_circle, at.M));
  plot.step(4, f.part(divisions - 1).M);
}

drawings::Steps steps_of_involute(Language language) {
  if (language == Language::english)
    return {
        {"On the line l, from $P_{0}$, small equal parts: 1', 2', ... 12', here $πd_{0}$/18 each.",
         "On the circle λ as many arcs of the same length, here 20° each: 1, 2, ... 12. They are the instant centres "
         "in their order: 5' comes to 5.",
         "In 5 the tangent to λ, and on it, backwards, the length $P_{0}$ 5': its end V is where $P_{0}$ has come "
         "to.",
         "So all the others; the curve through them is square to every tangent. Rolled the other way, the line draws "
         "the other branch, the mirror image in $CP_{0}$."}};
  return {
      {"Sulla retta l, da $P_{0}$, parti uguali e piccole: 1', 2', ... 12', qui di $πd_{0}$/18.",
       "Sul cerchio λ altrettanti archi di uguale lunghezza, qui di 20°: 1, 2, ... 12. Sono i successivi centri di "
       "istantanea rotazione: 5' viene in 5.",
       "In 5 la tangente a λ, e su di essa, all'indietro, la lunghezza $P_{0}$ 5': l'estremo V è dove $P_{0}$ è "
       "andato.",
       "Così tutti gli altri; la curva che li unisce è normale a ogni tangente. Rotolando in senso inverso la retta "
       "traccia l'altro ramo, simmetrico rispetto a $CP_{0}$."}};
}

}  // namespace

void draw_involute(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const Involute f{CGAL::to_double(of.r_0), parts_of_involute(of)};
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / f.r,
                              [&](const Scale& scale) { return extent_of(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  const double to = divisions * CGAL::to_double(part_of_turn) * 2 * std::numbers::pi;
  const double deviation = draw_path(plot, of.line(), 0, to, "involute");
  draw_figure(plot, f);
  add_scale_bars(onto, {fit.scale}, request);

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_of_involute(language));
  column.push_back(drawings::Heading{english ? "The curve" : "La curva"});
  column.push_back(
      drawings::Paragraph{english ? "$x$ = $r$ (cos $φ$ + $φ$ sin $φ$),  $y$ = $r$ (sin $φ$ − $φ$ cos $φ$)"
                                  : "$x$ = $r$ (cos $φ$ + $φ$ sen $φ$),  $y$ = $r$ (sen $φ$ − $φ$ cos $φ$)"});
  const double there = 1, wrong = printed_equation_speed(there) / there;
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(english
                       ? "The source prints $x$ with − for +. At $φ$ = 1 that point would move {} times as fast as "
                         "$v$ = $ω$·$P_{{0}}M$, which the source uses too."
                       : "La fonte stampa $x$ con − al posto di +. A $φ$ = 1 quel punto andrebbe {} volte più "
                         "veloce di $v$ = $ω$·$P_{{0}}M$, che usa anche la fonte."),
      figures(wrong, 3, language))});
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(english
                       ? "The line through the points is the true involute; as drawn it is nowhere more than {} mm "
                         "of paper off it (proved)."
                       : "La linea per i punti è la vera evolvente; così disegnata non se ne scosta in alcun punto "
                         "più di {} mm sul foglio (dimostrato)."),
      figures(deviation, 2, language))});
  onto.sheet.description =
      in_words({"The base circle with twelve tangents, each as long as the arc unrolled from it, "
                "and the involute through their ends",
                "Il cerchio di base con dodici tangenti, lunghe ciascuna quanto l'arco svolto, e "
                "l'evolvente per i loro estremi"},
               {{"d_0", 2 * f.r, "m"}}, language);
}

}  // namespace epure::cycloid_involute
