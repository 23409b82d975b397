// Speeds of aircraft and rim until slip ends; the areas below them are the ways.
#include "exercises/aircraft-landing/landing.h"
#include "exercises/aircraft-landing/sheets.h"
#include "exercises/aircraft-landing/speeds.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {
namespace {

// The law of the speeds and its integral, by the sign of B.
std::vector<Result> closed_form(const Landing& of, Language language) {
  const auto told = [&](const Words& words) { return remark(words.in(language)); };
  const geometry::analytic::SpinUp law = of.law();
  const std::string by_couple = "($f_{r}$ − $f_{v}$)$\\it{R}$/$\\it{J}_{r}$";
  const Words laws =
      Words{"d$v$/d$t$ = −($\\it{A}$ + $\\it{B}v^{2}$), d$ω$/d$t$ = $\\it{C}$ + $\\it{D}v^{2}$, with ",
            "d$v$/d$t$ = −($\\it{A}$ + $\\it{B}v^{2}$), d$ω$/d$t$ = $\\it{C}$ + $\\it{D}v^{2}$, con "} +
      Words{"$\\it{A}$ = $f_{r}g$, $\\it{B}$ = ($f_{r}c_{y}$ + $c_{x}$)/$\\it{M}$, ",
            "$\\it{A}$ = $f_{r}g$, $\\it{B}$ = ($f_{r}c_{y}$ + $c_{x}$)/$\\it{M}$, "};
  const std::string rest =
      "$\\it{C}$ = $\\it{Mg}$" + by_couple + ", $\\it{D}$ = $c_{y}$" + by_couple + ", $\\it{M}$ = $m_{a}$ + $m_{r}$.";
  const std::string turned = "$ω$ = $ω_{0}$ + $\\it{C}t$ + ($v_{0}$ − $v$ − $\\it{A}t$)$\\it{D}$/$\\it{B}$";
  const std::string v =
      law.B > 0 ? "$v$ = √($\\it{A}$/$\\it{B}$) tan($β$ − √($\\it{AB}$) $t$), tan $β$ = $v_{0}$√($\\it{B}$/$\\it{A}$)"
      : law.B < 0 ? "$v$ = $w$($v_{0}$ − $wθ$)/($w$ − $v_{0}θ$), $w$ = √(−$\\it{A}$/$\\it{B}$), $θ$ = "
                    "tanh(√(−$\\it{AB}$) $t$)"
                  : "$v$ = $v_{0}$ − $\\it{A}t$";
  const std::string omega =
      law.B != 0 ? turned : "$ω$ = $ω_{0}$ + $\\it{C}t$ + ($v_{0}^{3}$ − $v^{3}$)$\\it{D}$/3$\\it{A}$";
  return {told(laws + Words{rest, rest}), remark(v), remark(omega),
          told({"Slip ends at the first $t_{s}$ where $ω\\it{R}$ = $v$.",
                "Lo strisciamento finisce al primo $t_{s}$ in cui $ω\\it{R}$ = $v$."})};
}

}  // namespace

PanelSheet slip_sheet(const Solution& s, Language language) {
  const double t_s = s["t_s"], v_s = s["v_s"], v_0 = s["v_0"], R = CGAL::to_double(s.givens()["R"]);
  const double t_star = s["t_s_tangents"], v_star = s["v_s_tangents"];
  drawings::Chart chart = chart_of_speeds(s, 1.15 * t_s, 0, 1.1 * v_0);
  const auto ends = speeds_until_slip_ends(s, 100);
  std::vector<drawings::Datum> below = of_rim(ends), between = of_aircraft(ends);
  const double rim_0 = below.front().y;
  between.insert(between.end(), below.rbegin(), below.rend());
  below.push_back({t_s, 0});
  below.push_back({0, 0});
  chart.areas = {{below, Meaning::locus}, {between, Meaning::velocity}};
  chart.curves.push_back({.name = "tangents",
                          .runs = {{{0, v_0}, {t_star, v_star}}, {{0, rim_0}, {t_star, v_star}}},
                          .meaning = Meaning::construction,
                          .line = drawings::LineType::dashed});
  chart.verticals = {{.at = t_s, .label = "$t_{s}$"}};
  std::vector<ChartPanel::Read> read{{{t_s, v_s}, "t_s", "v_s"},
                                     {{t_s, v_s}, {}, "omega_s", 1, 1 / R},
                                     {{t_star, v_star}, "t_s_tangents", "v_s_tangents"},
                                     {{0, v_0}, {}, "v_0"}};
  chart.curves.push_back({.name = "end", .meaning = Meaning::text, .points = {{t_s, v_s}}});
  Words at_10ms{"", ""};  // unless slip has ended by then
  if (const auto v = s.value("v_10ms"), omega = s.value("omega_10ms"); v && omega) {
    at_10ms = {" The points at 10 ms are the exact solution.", " I punti a 10 ms sono la soluzione esatta."};
    chart.curves.push_back(
        {.name = "at_10ms", .meaning = Meaning::force, .points = {{0.01, *v}, {0.01, R * *omega}}});
    read.push_back({{0.01, *v}, {}, "v_10ms"});
    read.push_back({{0.01, R * *omega}, {}, "omega_10ms", 1, 1 / R});
  }
  const Words ways{
      "The whole area below $v$ is the way $s_{v}$ of the aircraft; that below $ω\\it{R}$ the way $s_{ω}$ of the "
      "rim; "
      "between them lies the way slipped. Grey and dashed, as far as they leave the curves: the tangents at "
      "touch-down, which cross at "
      "$t^{*}_{s}$.",
      "L'intera area sotto $v$ è lo spazio $s_{v}$ dell'aereo; quella sotto $ω\\it{R}$ lo spazio $s_{ω}$ della "
      "periferia; tra le due sta lo spazio strisciato. In grigio, tratteggiate, per quanto si staccano dalle curve, "
      "le "
      "tangenti al contatto, che si "
      "incontrano in "
      "$t^{*}_{s}$."};
  const Words works =
      s.givens()["rim_0"] == 0
          ? Words{"The wheel takes $\\it{E}_{s}$, and $\\it{L}_{F}$ is lost by sliding: as much, if $v$ and $\\it{F}$ did "
                  "not change and $f_{v}$ were 0.",
                  "La ruota riceve $\\it{E}_{s}$ e si perde $\\it{L}_{F}$ strisciando: altrettanto, se $v$ e $\\it{F}$ "
                  "non cambiassero e $f_{v}$ fosse 0."}
          : Words{"The wheel, which had $\\it{J}_{r}ω_{0}^{2}$/2, takes what is wanting to $\\it{E}_{s}$; "
                  "$\\it{L}_{F}$ is lost by sliding.",
                  "La ruota, che aveva $\\it{J}_{r}ω_{0}^{2}$/2, riceve quanto manca a $\\it{E}_{s}$; si perde "
                  "$\\it{L}_{F}$ strisciando."};
  const Words lost{" $\\it{L}_{x}$ is lost to the drag, $\\it{L}_{u}$ to the rolling friction.",
                   " $\\it{L}_{x}$ si perde per la resistenza, $\\it{L}_{u}$ per l'attrito volvente."};
  return {
      .panels = panels(ChartPanel(chart, read)),
      .theory = {{{"In closed form", "In forma chiusa"}, closed_form(Landing(s.givens()), language)},
                 {{"The diagram", "Il diagramma"}, {remark((ways + at_10ms).in(language))}}},
      .results = {values({"t_s", "v_s"}), values({"omega_s", "omega_rolling_0"}),
                  values({"t_s_tangents", "v_s_tangents"}), values({"ground_path_s", "rolled_path_s"}),
                  values({"slip_path_s", "wheel_angle_s"}), values({"v_10ms", "omega_10ms"}),
                  remark((works + lost).in(language)), values({"wheel_energy_s", "friction_work_s"}),
                  values({"drag_work_s", "rolling_work_s"})},
      .seen = {"Speeds of aircraft and rim over time until slip ends, with the ways as areas",
               "Velocità dell'aereo e della periferia nel tempo fino alla fine dello strisciamento, con gli spazi "
               "come aree"},
      .told = {"t_s", "v_s", "omega_s", "ground_path_s", "rolled_path_s", "slip_path_s"},
      .without_part = {"f_a", "Delta_t"}};
}

}  // namespace epure::aircraft_landing
