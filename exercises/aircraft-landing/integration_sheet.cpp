// The time that the law a(v) takes, by graphical integration of 1/|a| over the speed.
#include <algorithm>
#include <memory>

#include "exercises/aircraft-landing/sheets.h"
#include "exercises/aircraft-landing/speeds.h"
#include "exercises/kit/panels/integration_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {
namespace {

// Until slip ends, when so much speed is left to lose: between neighbours in a straight line.
double time_at(const std::vector<SpeedsAt>& falling, double left) {
  const double lost = falling.back().lost - left;
  const auto after =
      std::find_if(falling.begin() + 1, falling.end() - 1, [&](const SpeedsAt& each) { return each.lost >= lost; });
  const SpeedsAt &next = *after, &here = *(after - 1);
  const double t = here.t + (next.t - here.t) * (lost - here.lost) / (next.lost - here.lost);
  return falling.back().t - t;
}

}  // namespace

PanelSheet integration_sheet(const Solution& s, Language language) {
  constexpr int strips = Landing::strips;
  const auto law = Landing(s.givens()).law();
  const double A = CGAL::to_double(law.A), B = CGAL::to_double(law.B), v_s = s["v_s"];
  const auto at = speeds_until_slip_ends(s, strips);
  std::vector<double> speeds, times, slowness;
  for (auto now = at.rbegin(); now != at.rend(); ++now) {
    speeds.push_back(at.back().lost - now->lost);
    times.push_back(s["t_s"] - now->t);
  }
  for (std::size_t i = 0; i < strips; ++i)
    slowness.push_back((times[i + 1] - times[i]) / (speeds[i + 1] - speeds[i]));
  // Backwards too.
  const auto exact = std::make_shared<const std::vector<SpeedsAt>>(speeds_until_slip_ends(s, 240));
  const IntegrationPanel panel(
      {.letters = "$v$ − $v_{s}$", .unit = "m/s", .ends = speeds},
      {{.letters = "1/|$a$|",
        .unit = "s²/m",
        .meaning = Meaning::acceleration,
        .curve = [=](double left) { return 1 / (A + B * (v_s + left) * (v_s + left)); },
        .carried = slowness},
       {.letters = "$t$",
        .unit = "s",
        .meaning = Meaning::velocity,
        .id = "t",
        .curve = [=](double left) { return time_at(*exact, left); },
        .corners = times,
        .read = {{.quantity = "t_s", .label = "$t_{s}$", .at = speeds.back(), .value = times.back()}}}},
      {"the ordinate that makes the areas equal", "l'ordinata che compensa le aree"});
  const Words law_of_time{
      "d$t$ = −d$v$/|$a$($v$)|, |$a$| = $f_{r}g$ + ($f_{r}c_{y}$ + $c_{x}$)$v^{2}$/($m_{a}$ + $m_{r}$): integrated "
      "from $v_{s}$, at the left, up to $v_{0}$; the time counts backwards from the end of slip.",
      "d$t$ = −d$v$/|$a$($v$)|, |$a$| = $f_{r}g$ + ($f_{r}c_{y}$ + $c_{x}$)$v^{2}$/($m_{a}$ + $m_{r}$): integrata da "
      "$v_{s}$, a sinistra, fino a $v_{0}$; il tempo si conta all'indietro dalla fine dello strisciamento."};
  const Words off_the_curve{
      "At its corners the polygon lies on the true curve, as the areas are equal; between them it is off by at most "
      "$δ_{t}$, the greatest of Δ$v^{2}$/8 times the steepest slope of 1/|$a$| in the strip of the width Δ$v$.",
      "Nei vertici il poligono sta sulla curva esatta, poiché le aree sono uguali; fra l'uno e l'altro se ne scosta "
      "al più di $δ_{t}$, il massimo di Δ$v^{2}$/8 per la massima pendenza di 1/|$a$| nella striscia larga Δ$v$."};
  return {
      .panels = panels(panel),
      .results = {remark(law_of_time.in(language)), remark(off_the_curve.in(language)),
                  values({"polygon_off_at_most"}), values({"a_0", "a_s"}), values({"v_0", "v_s"}), values({"t_s"})},
      .seen = {"The reciprocal of the acceleration over the speed, and its integral polygon, the time",
               "Il reciproco dell'accelerazione in funzione della velocità e il suo poligono integrale, il tempo"},
      .told = {"v_0", "v_s", "t_s"},
      .without_part = {"f_a", "Delta_t"}};
}

}  // namespace epure::aircraft_landing
