// Sub-exercise 2: the slider-crank with its crank square to the guide. The coupler translates for the instant, and
// both circles have become lines. Crank and crank speed are 1: lengths are multiples of r.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar/figure.h"

namespace epure::four_bar {
namespace {

constexpr double beyond = 0.5;  // of r: how far the lines run on past K

struct Square {
  Place A0{0, 0}, A{0, 1}, B, K;
  double lambda, alpha_3, a_B;

  // sin ϑ₃ = -1/λ; α₃ = 1/√(λ² - 1), and so is a_B.
  explicit Square(const Rational& ratio) {
    const auto reach =
        deeply([&] { return to_double(geometry::root(geometry::from_rational<geometry::Deep>(ratio * ratio - 1))); });
    lambda = CGAL::to_double(ratio);
    B = {reach, 0};
    K = {reach, 1};
    alpha_3 = a_B = 1 / reach;
  }
};

void draw_mechanism(Plot& plot, const Square& f) {
  plot.long_segment({-1, 0}, {f.B.x, 0}, 8, Meaning::axis);
  plot.circle(f.A0, 1, Meaning::axis);
  const drawings::Point b = plot.at(f.B);
  plot.mark(drawings::Guide{{b.x - 14, b.y}, {b.x + 10, b.y}});
  plot.segment(f.A0, f.A, Meaning::link);
  plot.segment(f.A, f.B, Meaning::link);
  plot.mark(drawings::Slider{b, 0});
  plot.mark(drawings::FixedHinge{plot.at(f.A0), direction_of_support(f.A0, f.A)});
  plot.hinge(f.A);
  plot.hinge(f.B);
  draw_sense_of_crank(plot, f.A0, f.A, 1);
  plot.label("$A_{0}$", f.A0, f.A);
  plot.label("$A$", f.A, f.A0);
  plot.label("$B$", f.B, f.K);
}

void draw_lines(Plot& plot, const Square& f) {
  const double far = beyond;
  const std::string prefix = "slider_crank_ratio_3.";
  plot.mark(drawings::Line{drawings::segment(plot.at({f.B.x, -far}), plot.at({f.B.x, 1 + far})), Meaning::locus,
                           "inflection_line"});
  plot.mark(drawings::Line{drawings::segment(plot.at({-1.1, 1}), plot.at({f.B.x + far, 1})), Meaning::second_locus,
                           "stationarity_line"});
  plot.label("$F$", {f.B.x, 1 + far}, f.B, Meaning::locus);
  plot.label("$S$", {f.B.x + far, 1}, f.A, Meaning::second_locus);
  plot.cross(f.K, Meaning::acceleration);
  plot.label("$K$", f.K, f.A0, Meaning::acceleration);
  plot.right_angle(f.K, f.B, f.A);
  plot.measures_abscissa(prefix + "B_x_over_r", f.B, f.A0);
  plot.measures_abscissa(prefix + "K_x_over_r", f.K, f.A0);
  plot.step(1, {f.B.x, 1 + 0.6 * far});
  plot.step(2, {f.B.x / 2, 1});
  plot.step(3, f.K);
}

drawings::Steps steps(Language language) {
  if (language == Language::english) {
    return {
        {"The crank is square to the guide, $P_{31}$ at infinity: $ω_{3}$ = 0 and $\\vec{v}_{A}$ = $\\vec{v}_{B}$. "
         "The inflection circle passes $B$, whose path is straight, and has become the line $F$ through $B$ square "
         "to the guide.",
         "The stationarity circle passes $A$, whose acceleration is all normal, and has become the line $S$ through "
         "$A$ parallel to the guide.",
         "They meet in $K$, the acceleration pole. With $ω_{3}$ = 0 every acceleration is square to its ray: "
         "$a_{X}$ = $α_{3}$·$KX$, hence $α_{3}$ = $a_{A}$ / $KA$ and $a_{B}$ = $α_{3}$·$KB$."}};
  }
  return {
      {"La manovella è normale alla guida, $P_{31}$ all'infinito: $ω_{3}$ = 0 e $\\vec{v}_{A}$ = $\\vec{v}_{B}$. La "
       "circonferenza dei flessi passa per $B$, la cui traiettoria è retta, ed è diventata la retta $F$ per $B$ "
       "normale alla guida.",
       "La circonferenza di stazionarietà passa per $A$, la cui accelerazione è tutta normale, ed è diventata la "
       "retta $S$ per $A$ parallela alla guida.",
       "Si incontrano in $K$, il polo delle accelerazioni. Con $ω_{3}$ = 0 ogni accelerazione è normale al suo "
       "raggio: $a_{X}$ = $α_{3}$·$KX$, perciò $α_{3}$ = $a_{A}$ / $KA$ e $a_{B}$ = $α_{3}$·$KB$."}};
}

drawings::Box extent_of(const Square& f, const Scale& scale) {
  Extent extent;
  extent.include(scale, {-1.1, -1}, 3);
  extent.include(scale, {f.B.x + beyond, 1 + beyond}, 6);
  return extent.box();
}

}  // namespace

void draw_slider_crank(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Square f(of.lambda);
  const Language language = request.language;
  const bool english = language == Language::english;
  const Fit fit = fit_vectors(room_above_scale_bars(request), "r", language, 1000,
                              [&](const Scale& scale) { return extent_of(f, scale); });
  constexpr double longest_vector = 26;  // mm
  Plot plot(onto, fit.origin, fit.scale);
  // One scale for both, as crank and crank speed are 1.
  const Scale vectors = largest_vector_scale(longest_vector / std::max(1.0, f.a_B), "ω₂r, ω₂²r", language);
  plot.vectors_at(vectors);
  draw_lines(plot, f);
  draw_mechanism(plot, f);
  plot.segment(f.K, f.B, Meaning::construction);
  plot.vector_on("", f.A, {-1, 0}, Meaning::velocity, "$\\vec{v}_{A}$");
  plot.vector_on("slider_crank_ratio_3.v_B_over_omega_2_r", f.B, {-1, 0}, Meaning::velocity, "$\\vec{v}_{B}$");
  plot.vector_on("", f.A, {0, -1}, Meaning::acceleration, "$\\vec{a}_{A}$");
  plot.vector_on("slider_crank_ratio_3.a_B_over_omega_2_squared_r", f.B, {f.a_B, 0}, Meaning::acceleration,
                 "$\\vec{a}_{B}$");
  add_scale_bars(onto, {plot.scale(), vectors}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(drawings::Paragraph{
      fmt::format("$λ$ = $AB$ / $A_{{0}}A$ = {}: $x_{{B}}$ = {} $r$, $K$ = ({} $r$, $r$),  $α_{{3}}$ = {} "
                  "$ω^{{2}}_{{2}}$,  $v_{{B}}$ = $ω_{{2}}r$,  $a_{{B}}$ = {} $ω^{{2}}_{{2}}r$",
                  short_number(f.lambda, language), figures(f.B.x, 4, language), figures(f.K.x, 4, language),
                  figures(f.alpha_3, 4, language), figures(f.a_B, 4, language))});
  onto.sheet.description =
      in_words({"Slider-crank with the crank square to the guide: inflection and stationarity "
                "circle are lines that meet in K",
                "Manovellismo con la manovella normale alla guida: le circonferenze dei flessi e "
                "di stazionarietà sono rette che si incontrano in K"},
               {{"x_B/r", f.B.x, ""}, {"α₃/ω₂²", f.alpha_3, ""}}, language);
}

}  // namespace epure::four_bar
