// The direct problem: n, A and k off their charts; the bearing with its dimensions.
#include "exercises/kit/panels/pad_ring_panel.h"
#include "exercises/kit/panels/pad_section_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/slider_charts.h"
#include "exercises/michell-bearing/exercise.h"

namespace epure::michell_bearing {
namespace {

const std::set<std::string> of_the_film{"l", "V", "h_1", "h_2", "mu", "dx", "x_1", "x_3"};

Result verdict(const Solution& s, Language language, const std::string& quantity, const Words& which) {
  const Words enough = s.value(of_pad(quantity)) == 1.0
                           ? Words{": the film is at least $h_{0}$, lubrication is hydrodynamic.",
                                   ": il meato è almeno $h_{0}$, la lubrificazione è idrodinamica."}
                           : Words{": the film is thinner than $h_{0}$, lubrication is not hydrodynamic.",
                                   ": il meato è più sottile di $h_{0}$, la lubrificazione non è idrodinamica."};
  return told(which + enough, language);
}

// Of the source's own numbers alone.
Result misprint(const Solution& s, Language language) {
  if (!s.givens().as_stated()) return remark("");
  return told({"The source prints 0.0375 for $l_{p}$ in the formula of $h_{2}$, the first two digits of 0.0735 "
               "exchanged; its 37 µm are of 0.0735.",
               "La fonte stampa 0,0375 per $l_{p}$ nella formula di $h_{2}$, le prime due cifre di 0,0735 scambiate; "
               "i suoi 37 µm sono con 0,0735."},
              language);
}

}  // namespace

PanelSheet direct_sheet(const Solution& s, Language language) {
  return {
      .panels = slider_charts({.up_to = std::max(4.0, 1.25 * s[of_pad("n")]),
                               .found = {s[of_pad("n")], s[of_pad("x_N_over_l")], s[of_pad("A")], s[of_pad("k")]},
                               .ratio_quantity = of_pad("n"),
                               .load_quantity = of_pad("A"),
                               .friction_quantity = of_pad("k")},
                              language),
      .theory =
          {{{"The way", "Il procedimento"},
            {told({"$x_{N}$/$l$ of the pivot gives $n$ on the first chart; below it $\\it{A}$ and $k$. The curves:",
                   "$x_{N}$/$l$ della cerniera dà $n$ sul primo grafico; sotto, $\\it{A}$ e $k$. Le curve:"},
                  language),
             remark(slider_formulas()[0]), remark(slider_formulas()[1]), remark(slider_formulas()[2]),
             told(
                 {"$h_{2}$ = $l_{p}$ √($\\it{A}$ $μ$ $\\it{V}$/$\\it{N}$), $f_{m}$ = $k$ √($μ$ $\\it{V}$/$\\it{N}$).",
                  "$h_{2}$ = $l_{p}$ √($\\it{A}$ $μ$ $\\it{V}$/$\\it{N}$), $f_{m}$ = $k$ √($μ$ "
                  "$\\it{V}$/$\\it{N}$)."},
                 language),
             misprint(s, language)}}},
      .results = {values({of_pad("x_N_over_l"), of_pad("n")}), values({of_pad("A"), of_pad("k")}),
                  values({of_pad("V"), of_pad("N")}), workshop_values({of_pad("h_2"), of_pad("h_1")}),
                  values({of_pad("tilt"), of_pad("f_m")}),
                  values({of_pad("film_margin"), of_pad("film_margin_side_leakage")})},
      .seen = {"Place of the load, A and k against n, read off at the pivot of the pad",
               "Posizione del carico, A e k in funzione di n, letti per la cerniera del pattino"},
      .told = {of_pad("n"), of_pad("A"), of_pad("k"), of_pad("h_2"), of_pad("f_m")},
      .without_part = of_the_film};
}

PanelSheet bearing_sheet(const Solution& s, Language language) {
  const Pad pad = Problem(s.givens()).pad;
  return {.panels = panels(PadRingPanel({.pads = static_cast<int>(CGAL::to_double(pad.pads)),
                                         .inner = s[of_pad("R_inner")],
                                         .outer = s[of_pad("R_outer")],
                                         .length = geometry::from_rational<double>(pad.l),
                                         .pivot = s[of_pad("x_N_over_l")],
                                         .mean_letters = "$r_{m}$",
                                         .length_letters = "$l_{p}$",
                                         .width_letters = "$b$",
                                         .pivot_letters = "$x_{N}$",
                                         .pitch_letters = "$p_{c}$",
                                         .gap_letters = "$d$",
                                         .outer_quantity = of_pad("R_outer"),
                                         .inner_quantity = of_pad("R_inner")}),
                           PadSectionPanel({.length = geometry::from_rational<double>(pad.l),
                                            .pivot = s[of_pad("x_N_over_l")],
                                            .h_1 = s[of_pad("h_1")],
                                            .h_2 = s[of_pad("h_2")],
                                            .length_letters = "$l_{p}$",
                                            .pivot_letters = "$x_{N}$",
                                            .speed_letters = "$\\it{V}$",
                                            .inlet_quantity = of_pad("h_1"),
                                            .outlet_quantity = of_pad("h_2")})),
          .theory = {{{"Side leakage", "Fuoriuscite laterali"},
                      {remark("$c$ = 1 + $l_{p}$/$b$, $c'$ = √(1 + 4 $l_{p}$/$b$); $\\it{N}'$ = $\\it{N}$/$c$, "
                              "$h'_{2}$ = $h_{2}$/√$c$, $f'_{m}$ = $c'$ $f_{m}$.")}}},
          .results = {values({of_pad("R_outer"), of_pad("R_inner")}), values({of_pad("pitch"), of_pad("gap")}),
                      workshop_values({of_pad("p_mean"), of_pad("p_max")}), values({of_pad("f_m"), of_pad("T")}),
                      values({of_pad("friction_torque"), of_pad("power_loss")}),
                      verdict(s, language, "hydrodynamic", {"Without side leakage", "Senza fuoriuscite laterali"}),
                      values({of_pad("c"), of_pad("c_prime")}), values({of_pad("N_side_leakage")}),
                      workshop_values({of_pad("h_2_side_leakage")}), values({of_pad("f_m_side_leakage")}),
                      verdict(s, language, "hydrodynamic_side_leakage",
                              {"With side leakage", "Con fuoriuscite laterali"})},
          .seen = {"The ring of pads, with its dimensions, and a pad and the runner in section",
                   "La corona di pattini, quotata, e un pattino e la ralla in sezione"},
          .told = {of_pad("R_outer"), of_pad("R_inner"), of_pad("gap"), of_pad("p_mean")},
          .without_part = of_the_film};
}

}  // namespace epure::michell_bearing
