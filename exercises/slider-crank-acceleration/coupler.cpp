// Sheets 2 to 4, the coupler as a moving plane: inflection and stationarity circle, accelerations by K, centres of
// curvature of the paths of C and M.
#include "exercises/slider-crank-acceleration/exercise.h"

namespace epure::slider_crank_acceleration {
namespace {

drawings::Steps circle_steps(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  if (!f.coupler.P0) {
    return english ? drawings::Steps{{"The crank is square to the guide: $P_{0}$ is at infinity and $ω_{3}$ = 0.",
                                      "The inflection circle becomes a line through $B$, square to the guide.",
                                      "The stationarity circle becomes a line too.", "The two lines meet in $K$."}}
                   : drawings::Steps{{"La manovella è normale alla guida: $P_{0}$ è all'infinito e $ω_{3}$ = 0.",
                                      "La circonferenza dei flessi diventa una retta per $B$, normale alla guida.",
                                      "Anche la circonferenza di stazionarietà diventa una retta.",
                                      "Le due rette si incontrano in $K$."}};
  }
  // With P₀ in B the three points of the circle are two; J is still seen at right angles from A' and on the guide.
  const std::string circle =
      f.instant.dead_centre
          ? Words{"Dead centre: $P_{0}$ is $B$. The square to the crank through $A'$ meets the guide in $J$; the "
                  "inflection circle has the diameter $P_{0}J$, the centre $F$.",
                  "Punto morto: $P_{0}$ è $B$. La normale alla manovella per $A'$ incontra la guida in $J$; la "
                  "circonferenza dei flessi ha il diametro $P_{0}J$, il centro $F$."}
                .in(language)
          : Words{"Inflection circle through $P_{0}$, $A'$ and $B$, whose path is straight. Centre $F$, diameter "
                  "$P_{0}J$.",
                  "Circonferenza dei flessi per $P_{0}$, $A'$ e $B$, la cui traiettoria è retta. Centro $F$, diametro "
                  "$P_{0}J$."}
                .in(language);
  if (english) {
    return {{"$A'$ on the ray $P_{0}A$: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, on the side of $A_{0}$.", circle,
             "Stationarity circle: through $P_{0}$, its centre $S$ on the square to $P_{0}J$, and (for $α_{2}$ = 0) "
             "through $A$, "
             "whose acceleration is all normal.",
             "$K$, where the circles meet again: the foot of the perpendicular from $P_{0}$ on $JS'$."}};
  }
  return {
      {"$A'$ sul raggio $P_{0}A$: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, dalla parte di $A_{0}$.", circle,
       "Circonferenza di stazionarietà: per $P_{0}$, col centro $S$ sulla normale a $P_{0}J$, e (per $α_{2}$ = 0) "
       "per $A$, la cui "
       "accelerazione è tutta normale.",
       "$K$, dove le due si incontrano ancora: il piede della normale da $P_{0}$ a $JS'$."}};
}

drawings::Steps acceleration_steps(Language language) {
  if (language == Language::english) {
    return {{"$K$ from the two circles (sheet 2). At $K$ the acceleration is zero.",
             "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), known: the factor is $a_{A}$ / $KA$.",
             "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ for every point $X$ of the coupler.",
             "All are inclined to their rays $XK$ by the same $γ$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$."}};
  }
  return {{"$K$ dalle due circonferenze (foglio 2). In $K$ l'accelerazione è nulla.",
           "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), nota: il fattore è $a_{A}$ / $KA$.",
           "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ per ogni punto $X$ della biella.",
           "Tutte sono inclinate dello stesso $γ$ sui raggi $XK$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$."}};
}

// With the pole at infinity C' and M' are there too, and only the last two steps are left.
drawings::Steps curvature_steps_without_pole(Language language) {
  if (language == Language::english) {
    return {{"$P_{0}$ is at infinity, and $C'$ with it. $Ω_{C}$ on the normal to $\\vec{v}_{C}$, at $ρ_{C}$ = "
             "$v^{2}_{C}$ / $a^{n}_{C}$.",
             "Likewise $Ω_{M}$. The thin circles are the osculating circles of the two paths."},
            3};
  }
  return {{"$P_{0}$ è all'infinito, e $C'$ con lui. $Ω_{C}$ sulla normale a $\\vec{v}_{C}$, a $ρ_{C}$ = $v^{2}_{C}$ "
           "/ $a^{n}_{C}$.",
           "Così $Ω_{M}$. I cerchi sottili sono i cerchi osculatori delle due traiettorie."},
          3};
}

drawings::Steps curvature_steps(Language language) {
  if (language == Language::english) {
    return {{"The ray $P_{0}C$ meets the inflection circle again in $C'$.", "Likewise $M'$ on the ray $P_{0}M$.",
             "Euler-Savary: $P_{0}C^{2}$ = $Ω_{C}C$·$C'C$ gives $Ω_{C}$ on the ray, on the same side of $C$ as $C'$.",
             "Likewise $Ω_{M}$: $P_{0}M^{2}$ = $Ω_{M}M$·$M'M$. The thin circles are the osculating circles of the "
             "two paths."}};
  }
  return {{"Il raggio $P_{0}C$ incontra ancora la circonferenza dei flessi in $C'$.",
           "Così $M'$ sul raggio $P_{0}M$.",
           "Euler-Savary: $P_{0}C^{2}$ = $Ω_{C}C$·$C'C$ dà $Ω_{C}$ sul raggio, dalla stessa parte di $C'$ rispetto a "
           "$C$.",
           "Così $Ω_{M}$: $P_{0}M^{2}$ = $Ω_{M}M$·$M'M$. I cerchi sottili sono i cerchi osculatori delle due "
           "traiettorie."}};
}

}  // namespace

void draw_circles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_circles_sheet(onto, f.coupler, request,
                     {circle_steps(f, request.language),
                      {"Inflection and stationarity circle of the coupler, which meet in P₀ and K",
                       "Circonferenze dei flessi e di stazionarietà della biella, che si incontrano in P₀ e K"}});
}

void draw_poles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_acceleration_pole_sheet(
      onto, f.coupler, request,
      {acceleration_steps(request.language),
       {"Accelerations of A, B, C and M, proportional to their distances from the acceleration pole K",
        "Accelerazioni di A, B, C e M, proporzionali alle distanze dal polo delle accelerazioni K"}},
      [&](DrawnSheet& other, const SheetRequest& own) { draw_polar_diagram(other, f, own); });
}

void draw_curvature(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  draw_curvature_sheet(
      onto, f.coupler, {"C", "M"}, request,
      {f.coupler.P0 ? curvature_steps(language) : curvature_steps_without_pole(language),
       {"Centres of curvature of the paths of C and M by Euler-Savary, with their osculating circles",
        "Centri di curvatura delle traiettorie di C e M con Euler-Savary, con i cerchi osculatori"}});
}

}  // namespace epure::slider_crank_acceleration
