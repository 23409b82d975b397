// The coupler as a moving plane: circles, accelerations by K, curvature of C's path.
#include "exercises/four-bar/figure.h"

namespace epure::four_bar {
namespace {

drawings::Steps circle_steps(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  if (!f.coupler.P0) {
    return english ? drawings::Steps{{"Crank and rocker are parallel: $P_{31}$ is at infinity and $ω_{3}$ = 0.",
                                      "The inflection circle becomes a line.",
                                      "The stationarity circle becomes a line square to it.",
                                      "The two lines meet in $K$."}}
                   : drawings::Steps{{"Manovella e bilanciere sono paralleli: $P_{31}$ è all'infinito e $ω_{3}$ = 0.",
                                      "La circonferenza dei flessi diventa una retta.",
                                      "La circonferenza di stazionarietà diventa una retta normale ad essa.",
                                      "Le due rette si incontrano in $K$."}};
  }
  if (english) {
    return {
        {"$A'$ and $B'$ on the rays from $P_{31}$ (Euler-Savary): $P_{31}A^{2}$ = $A_{0}A$·$A'A$ and "
         "$P_{31}B^{2}$ = $B_{0}B$·$B'B$.",
         "Inflection circle through $P_{31}$, $A'$ and $B'$; centre $F$, diameter $P_{31}J$. The squares to the "
         "rays in $A'$ and $B'$ meet in $J$.",
         "Stationarity circle: through $P_{31}$, its centre $S$ on the square to $P_{31}J$, and (for $α_{2}$ = 0) "
         "through $A$, whose acceleration is all normal.",
         "$K$, where the circles meet again: the foot of the perpendicular from $P_{31}$ on $JS'$."}};
  }
  return {
      {"$A'$ e $B'$ sui raggi da $P_{31}$ (Euler-Savary): $P_{31}A^{2}$ = $A_{0}A$·$A'A$ e $P_{31}B^{2}$ = "
       "$B_{0}B$·$B'B$.",
       "Circonferenza dei flessi per $P_{31}$, $A'$ e $B'$; centro $F$, diametro $P_{31}J$. Le normali ai raggi in "
       "$A'$ e $B'$ si incontrano in $J$.",
       "Circonferenza di stazionarietà: per $P_{31}$, col centro $S$ sulla normale a $P_{31}J$, e (per $α_{2}$ = "
       "0) per $A$, la cui accelerazione è tutta normale.",
       "$K$, dove le due si incontrano ancora: il piede della normale da $P_{31}$ a $JS'$."}};
}

drawings::Steps acceleration_steps(Language language) {
  if (language == Language::english) {
    return {
        {"$K$ from the two circles. At $K$ the acceleration is zero.",
         "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), known: the factor is $a_{A}$ / $KA$.",
         "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ for every point $X$ of the coupler.",
         "All are inclined to their rays $XK$ by the same $γ$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$. It is no angle of "
         "the rocker, which turns about $B_{0}$: $α_{4}$ from $a^{t}_{B}$."}};
  }
  return {{"$K$ dalle due circonferenze. In $K$ l'accelerazione è nulla.",
           "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), nota: il fattore è $a_{A}$ / $KA$.",
           "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ per ogni punto $X$ della biella.",
           "Tutte sono inclinate dello stesso $γ$ sui raggi $XK$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$. Non vale per il "
           "bilanciere, che ruota attorno a $B_{0}$: $α_{4}$ dalla $a^{t}_{B}$."}};
}

drawings::Steps curvature_steps(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  if (!f.coupler.P0) {
    return english ? drawings::Steps{{"$P_{31}$ is at infinity, and $C'$ with it. $Ω_{C}$ on the normal to "
                                      "$\\vec{v}_{C}$, at $ρ_{C}$ = $v^{2}_{C}$ / $a^{n}_{C}$."},
                                     2}
                   : drawings::Steps{{"$P_{31}$ è all'infinito, e $C'$ con lui. $Ω_{C}$ sulla normale a "
                                      "$\\vec{v}_{C}$, a $ρ_{C}$ = $v^{2}_{C}$ / $a^{n}_{C}$."},
                                     2};
  }
  if (english) {
    return {
        {"The ray $P_{31}C$ meets the inflection circle again in $C'$.",
         "Euler-Savary: $P_{31}C^{2}$ = $Ω_{C}C$·$C'C$ gives $Ω_{C}$ on the ray, on the same side of $C$ as $C'$. "
         "The thin circle is the osculating circle of the path of $C$."}};
  }
  return {
      {"Il raggio $P_{31}C$ incontra ancora la circonferenza dei flessi in $C'$.",
       "Euler-Savary: $P_{31}C^{2}$ = $Ω_{C}C$·$C'C$ dà $Ω_{C}$ sul raggio, dalla stessa parte di $C'$ rispetto a "
       "$C$. Il cerchio sottile è il cerchio osculatore della traiettoria di $C$."}};
}

}  // namespace

void draw_circles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_circles_sheet(onto, f.coupler, request,
                     {circle_steps(f, request.language),
                      {"Inflection and stationarity circle of the coupler, which meet in P31 and K",
                       "Circonferenze dei flessi e di stazionarietà della biella, che si incontrano in P31 e K"}});
}

void draw_acceleration_pole(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_acceleration_pole_sheet(
      onto, f.coupler, request,
      {acceleration_steps(request.language),
       {"Accelerations of A, B and C, proportional to their distances from the acceleration pole K",
        "Accelerazioni di A, B e C, proporzionali alle distanze dal polo delle accelerazioni K"}},
      [&](DrawnSheet& other, const SheetRequest& own) { draw_acceleration_diagram(other, f, own); });
}

void draw_curvature(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_curvature_sheet(onto, f.coupler, {"C"}, request,
                       {curvature_steps(f, request.language),
                        {"Centre of curvature of the path of C by Euler-Savary, with its osculating circle",
                         "Centro di curvatura della traiettoria di C con Euler-Savary, col cerchio osculatore"}});
}

}  // namespace epure::four_bar
