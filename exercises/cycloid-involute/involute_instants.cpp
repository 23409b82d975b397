// The line on its circle at both instants of the involute, each with the path that led there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/figure.h"
#include "exercises/cycloid-involute/instants.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

constexpr double longest_path = 6 * std::numbers::pi;  // rad: of a longer one only the last turns are drawn

class LinePicture : public InstantPicture {
 public:
  LinePicture(const Problem& of, DrawnInstant at, const std::string& symbol, const std::string& title)
      : InstantPicture(std::move(at), symbol, title), line_(of.line()), R_(CGAL::to_double(of.r_0)) {}

  double size() const override { return 2 * R_; }

 private:
  double first() const { return std::max(0.0, at().phi - longest_path); }

  void include_bodies(Extent& extent, const Scale& scale) const override {
    constexpr double a_little = 2, letters = 5;  // mm
    extent.include(scale, {-R_, -R_}, letters);
    extent.include(scale, {R_, R_}, letters);
    extent.include(scale, at().J, letters);
    constexpr int samples = 240;
    for (int i = 0; i <= samples; ++i) {
      const double phi = first() + i * (at().phi - first()) / samples;
      extent.include(scale, {R_ * (std::cos(phi) + phi * std::sin(phi)), R_ * (std::sin(phi) - phi * std::cos(phi))},
                     a_little);
    }
  }

  void draw_bodies(Plot& plot) const override {
    plot.circle({0, 0}, R_, Meaning::link);
    if (at().phi > first()) draw_path(plot, line_, first(), at().phi, "");
    const Place F{(at().P0.x + at().J.x) / 2, (at().P0.y + at().J.y) / 2};
    plot.circle(F, R_ / 2, Meaning::second_locus);
    if (at().is_at_cusp) {
      plot.long_segment({R_, -R_}, {R_, R_}, 3, Meaning::link);
    } else {
      plot.long_segment(at().P0, at().M, 6, Meaning::link);
    }
    plot.segment({0, 0}, at().J, Meaning::axis);
  }

  void draw_construction(Plot& plot) const override {
    const DrawnInstant& f = at();
    const Place C{0, 0};
    constexpr double room_for_letters = 5;  // mm
    plot.dot(C);
    if (R_ * plot.scale().mm_per_unit > room_for_letters) plot.label("$C$", C, f.J);
    if (f.is_at_cusp) {
      plot.dot(f.M, Meaning::locus);
      plot.label("$M$ ≡ $M'$ ≡ $P_{0}$ ≡ $Ω$", f.P0, C);
    } else {
      plot.cross(f.P0);
      plot.label("$P_{0}$ ≡ $M'$ ≡ $Ω$", f.P0, f.M, Meaning::locus);
      plot.dot(f.M, Meaning::locus);
      plot.label("$M$", f.M, f.P0, Meaning::locus);
      plot.measures(f.names("P0M"), f.P0, f.M);
      plot.measures(f.names("rho_M"), f.P0, f.M);
      plot.measures_abscissa(f.names("x_M"), f.M, C);
      const auto from_P0 = [&](double share) {
        return Place{f.P0.x + share * (f.M.x - f.P0.x), f.P0.y + share * (f.M.y - f.P0.y)};
      };
      plot.step(1, from_P0(0.5));
      plot.step(3, from_P0(0));
    }
    plot.step(2, f.J);
    plot.cross(f.J, Meaning::acceleration);
    plot.label("$J$ ≡ $K$", f.J, f.P0, Meaning::acceleration);
  }

  geometry::Rolling line_;
  double R_;
};

drawings::Steps steps_at_involute_instants(Language language) {
  if (language == Language::english)
    return {
        {"$P_{0}$, where the line touches, is the instant centre: $P_{0}M$ = $rφ$, $v_{M}$ = $ω$·$P_{0}M$, square "
         "to the line.",
         "Euler-Savary for the polodes: $δ$ = $r$, $J$ lies beyond $P_{0}$ from $C$. $ω$ is constant: $K$ ≡ $J$, "
         "$a_{M}$ = $ω^{2}$·$KM$ towards $K$.",
         "The ray $P_{0}M$ touches the inflection circle in $P_{0}$: $M'$ ≡ $P_{0}$, so $ρ$ = $P_{0}M$ and $Ω$ ≡ "
         "$P_{0}$.",
         "$a^{n}_{M}$ = $ω^{2}$·$MP_{0}$ = $v^{2}_{M}$/$ρ$, $a^{t}_{M}$ = $ω^{2}$·$P_{0}J$ = $ω^{2}r$, at every "
         "instant the same."}};
  return {
      {"$P_{0}$, dove la retta tocca, è il centro d'istantanea rotazione: $P_{0}M$ = $rφ$, $v_{M}$ = $ω$·$P_{0}M$, "
       "normale alla retta.",
       "Euler-Savary per le polari: $δ$ = $r$, $J$ è oltre $P_{0}$ rispetto a $C$. $ω$ è costante: $K$ ≡ $J$, "
       "$a_{M}$ = $ω^{2}$·$KM$ verso $K$.",
       "Il raggio $P_{0}M$ tocca la circonferenza dei flessi in $P_{0}$: $M'$ ≡ $P_{0}$, quindi $ρ$ = $P_{0}M$ e "
       "$Ω$ ≡ $P_{0}$.",
       "$a^{n}_{M}$ = $ω^{2}$·$MP_{0}$ = $v^{2}_{M}$/$ρ$, $a^{t}_{M}$ = $ω^{2}$·$P_{0}J$ = $ω^{2}r$, la stessa in "
       "ogni istante."}};
}

// Farther on, the circle is a point to the eye and doubles no longer tell where on it the line touches.
void require_drawable(const DrawnInstant& at) {
  constexpr double farthest = 1e9;  // rad
  if (at.phi > farthest)
    throw BadGivens(format_words("at t = {} s the line has turned through {} rad; it can be drawn up to 1e9 rad",
                                 "a t = {} s la retta ha ruotato di {} rad; si può disegnare fino a 1e9 rad",
                                 decimal(at.t, 17), decimal(at.phi, 3)));
}

std::string title(const std::string& symbol, const DrawnInstant& at, Language language) {
  return fmt::format("{} = {} s", symbol, short_number(at.t, language));
}

}  // namespace

void draw_involute_instants(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const DrawnInstant at_first = drawn_on_involute(of, of.phi_1, at_t1),
                     at_second = drawn_on_involute(of, of.phi_2, at_t2);
  require_drawable(at_first);
  require_drawable(at_second);
  const LinePicture first(of, at_first, "$t_{1}$", title("$t_{1}$", at_first, language)),
      second(of, at_second, "$t_{2}$", title("$t_{2}$", at_second, language));
  const std::vector<const InstantPicture*> pictures{&first, &second};
  draw_two_instants(onto, pictures, LengthScales::each_its_own, request);

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_at_involute_instants(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(instants_table(pictures, language));
  onto.sheet.description = in_words(
      {"The line on its circle at two instants, with the involute that led there, velocity and acceleration of M",
       "La retta sul suo cerchio in due istanti, con l'evolvente percorsa, velocità e accelerazione di M"},
      {{"v_M (t1)", magnitude(at_first.v), "m/s"}, {"v_M (t2)", magnitude(at_second.v), "m/s"}}, language);
}

}  // namespace epure::cycloid_involute
