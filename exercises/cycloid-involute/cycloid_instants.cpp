// The wheel at both instants of the cycloid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/figure.h"
#include "exercises/cycloid-involute/instants.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

class WheelPicture : public InstantPicture {
 public:
  WheelPicture(const Problem& of, DrawnInstant at, const std::string& title)
      : InstantPicture(std::move(at), title, title), wheel_(of.wheel()), r_(CGAL::to_double(of.r)) {}

  double size() const override { return 2 * r_; }

 private:
  // From the start of the arch where that is near, else as much on both sides of the wheel.
  double low() const {
    const double from = at().P0.x - 1.6 * r_;
    return from < 0.8 * r_ && at().is_first_arch ? -0.1 * r_ : from;
  }
  double high() const { return std::max(at().P0.x + 1.1 * r_, low() + 3.2 * r_); }

  void include_bodies(Extent& extent, const Scale& scale) const override {
    constexpr double hatching = 5, letters = 6;  // mm
    extent.include(scale.mm_per_unit * low(), -hatching);
    extent.include(scale.mm_per_unit * high(), 2 * r_ * scale.mm_per_unit + 1);
    extent.include(scale, at().centre, letters);
  }

  void draw_bodies(Plot& plot) const override {
    plot.mark(drawings::Ground{plot.at({low(), 0}), plot.at({high(), 0})});
    // x = r (φ - sin φ) is within r of r φ. Nothing was drawn before the start.
    const double first = at().is_first_arch ? 0 : low() / r_ - 1;
    draw_path(plot, wheel_, std::max(first, low() / r_ - 1), high() / r_ + 1, "");
    plot.circle({at().P0.x, r_}, r_, Meaning::link);
    plot.circle({at().P0.x, r_ / 2}, r_ / 2, Meaning::second_locus);
    plot.segment({at().P0.x, 0}, at().J, Meaning::axis);
  }

  void draw_construction(Plot& plot) const override {
    const DrawnInstant& f = at();
    const Place aside{f.P0.x + (f.M.x > f.P0.x ? -r_ : r_), f.P0.y};
    if (f.is_at_cusp) {
      plot.dot(f.M, Meaning::locus);
      plot.label("$M$ ≡ $M'$ ≡ $P_{0}$ ≡ $Ω$", f.P0, f.J);
    } else {
      plot.segment(f.centre, f.M, Meaning::construction);
      plot.segment(f.J, f.M_prime, Meaning::construction);
      plot.right_angle(f.M_prime, f.J, f.M);
      plot.cross(f.centre);
      plot.label("$Ω$", f.centre, f.P0, Meaning::locus);
      plot.dot(f.M_prime, Meaning::second_locus);
      plot.label("$M'$", f.M_prime, f.J, Meaning::second_locus);
      plot.cross(f.P0);
      plot.label("$P_{0}$", f.P0, aside);
      plot.dot(f.M, Meaning::locus);
      plot.label("$M$", f.M, f.P0, Meaning::locus);
      plot.measures(f.names("P0M"), f.P0, f.M);
      plot.measures(f.names("rho_M"), f.centre, f.M);
      plot.step(1, {f.P0.x + 0.3 * (f.M.x - f.P0.x), f.P0.y + 0.3 * (f.M.y - f.P0.y)});
      plot.step(3, f.centre);
    }
    plot.step(2, f.J);
    plot.cross(f.J, Meaning::acceleration);
    plot.label("$C$ ≡ $J$ ≡ $K$", f.J, f.M);
    if (f.names.after.empty()) {
      plot.measures("cycloid.inflection_diameter", f.P0, f.J);
      plot.measures("cycloid.KM", f.J, f.M);
      plot.measures("cycloid.Mprime_M", f.M_prime, f.M);
    }
    if (f.is_first_arch && low() <= 0) {
      const Place start{0, 0};
      plot.dot(start);
      plot.label("$O$", start, f.J);
      plot.measures_abscissa(f.names("x_M"), f.M, start);
      plot.measures_abscissa(f.names("curvature_centre_x"), f.centre, start);
    }
  }

  geometry::Rolling wheel_;
  double r_;
};

drawings::Steps steps_at_cycloid_instants(Language language) {
  if (language == Language::english)
    return {
        {"$P_{0}$, where the wheel touches, is the instant centre: $v_{M}$ = $ω$·$P_{0}M$, square to $P_{0}M$.",
         "Euler-Savary for the polodes: 1/$δ$ = 1/$r$ − 1/∞, so $δ$ = $r$ and the inflection pole $J$ is the centre "
         "$C$. $ω$ is constant: $K$ ≡ $J$, $a_{M}$ = $ω^{2}$·$KM$ towards $K$.",
         "$M'$ on the ray $P_{0}M$, square below $J$. $ρ$ = $P_{0}M^{2}$/$MM'$ sets the centre of curvature $Ω$.",
         "$M$, $M'$, $J$ are the triangle of accelerations: $a^{n}_{M}$ = $ω^{2}$·$MM'$ = $v^{2}_{M}$/$ρ$, "
         "$a^{t}_{M}$ = $ω^{2}$·$M'J$."}};
  return {
      {"$P_{0}$, dove la ruota tocca, è il centro d'istantanea rotazione: $v_{M}$ = $ω$·$P_{0}M$, normale a "
       "$P_{0}M$.",
       "Euler-Savary per le polari: 1/$δ$ = 1/$r$ − 1/∞, dunque $δ$ = $r$ e il polo dei flessi $J$ è il centro $C$. "
       "$ω$ è costante: $K$ ≡ $J$, $a_{M}$ = $ω^{2}$·$KM$ verso $K$.",
       "$M'$ sul raggio $P_{0}M$, piede della normale da $J$. $ρ$ = $P_{0}M^{2}$/$MM'$ dà il centro di curvatura "
       "$Ω$.",
       "$M$, $M'$, $J$ formano il triangolo delle accelerazioni: $a^{n}_{M}$ = $ω^{2}$·$MM'$ = $v^{2}_{M}$/$ρ$, "
       "$a^{t}_{M}$ = $ω^{2}$·$M'J$."}};
}

std::string about_cusp(Language language) {
  return language == Language::english
             ? "At a cusp $v_{M}$ = 0 and $ρ$ = 0, yet $a_{M}$ = $ω^{2}r$: it runs along the tangent, against the "
               "motion $\\vec{t}$ until $M$ stands, with it after. The source leaves this instant out."
             : "In una cuspide $v_{M}$ = 0 e $ρ$ = 0, ma $a_{M}$ = $ω^{2}r$: è diretta secondo la tangente, contro "
               "il "
               "moto $\\vec{t}$ finché $M$ si ferma, poi con il moto. La fonte tralascia questo istante.";
}

bool is_as_printed(const Problem& of) {
  return of.r == Rational(1, 2) && of.omega_1 == Angle{0, 30} && of.phi == Angle{Rational(3, 8)};
}
std::string about_source(Language language) {
  return language == Language::english
             ? "What the source prints for $φ$ = 135° belongs to 90°: $P_{0}M$ = 0.71 m, $v_{M}$ = 21.2 m/s, $ρ$ = "
               "1.44 m, $a^{n}_{M}$ = 312.1 m/s², $a^{t}_{M}$ = 315 m/s²."
             : "Quanto la fonte stampa per $φ$ = 135° è di 90°: $P_{0}M$ = 0,71 m, $v_{M}$ = 21,2 m/s, $ρ$ = 1,44 m, "
               "$a^{n}_{M}$ = 312,1 m/s², $a^{t}_{M}$ = 315 m/s².";
}

}  // namespace

void draw_cycloid_instants(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const auto num = [&](const Rational& x) { return short_number(CGAL::to_double(x), language); };
  const WheelPicture first(of, drawn_at_phi(of), "$φ$ = " + num(360 * of.phi.turns) + "°"),
      second(of, drawn_at_s(of), "$s$ = " + num(of.s) + " m");
  const std::vector<const InstantPicture*> pictures{&first, &second};
  draw_two_instants(onto, pictures, LengthScales::one, request);

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_at_cycloid_instants(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(instants_table(pictures, language));
  if (is_as_printed(of)) column.push_back(drawings::Paragraph{about_source(language)});
  if (first.at().is_at_cusp || second.at().is_at_cusp) column.push_back(drawings::Paragraph{about_cusp(language)});
  onto.sheet.description = in_words(
      {"The wheel on its guide at two instants, with contact point, inflection circle and centre of curvature, "
       "velocity and acceleration of M",
       "La ruota sulla guida in due istanti, con punto di contatto, circonferenza dei flessi e centro di "
       "curvatura, velocità e accelerazione di M"},
      {{"v_M", magnitude(first.at().v), "m/s"},
       {"ρ_M", first.at().rho, "m"},
       {"v_M (s)", magnitude(second.at().v), "m/s"}},
      language);
}

}  // namespace epure::cycloid_involute
