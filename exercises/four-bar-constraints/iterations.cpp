// Sheets 1 and 2: the linkage open at B, closed step by step, and how fast. Where the gap is too small to be seen on
// the whole linkage, it is shown larger beside it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_constraints {

Quantity residual() { return {"residual", "$|ψ|$", "m", {"residual of the constraints", "residuo dei vincoli"}}; }
Quantity error_of(const Quantity& angle) {
  return {"error_" + angle.name, "$|Δ" + angle.symbol.substr(1, angle.symbol.size() - 2) + "|$", angle.unit,
          Words{"error of: ", "errore di: "} + angle.meaning};
}
Quantity iterate(const Quantity& quantity, std::size_t k) {
  const std::string number = std::to_string(k);
  return {quantity.name + "_" + number, quantity.symbol, quantity.unit,
          quantity.meaning + format_words(", iterate {}", ", iterata {}", number)};
}
std::string end_of_coupler(std::size_t k) { return "end_of_coupler_" + std::to_string(k); }
std::string end_of_rocker(std::size_t k) { return "end_of_rocker_" + std::to_string(k); }
std::size_t iterates(const Solution& s) {
  std::size_t k = 0;
  while (s.has(iterate(residual(), k).name)) ++k;
  return k;
}

namespace {

double gap(const Solution& s, std::size_t k) { return s[iterate(residual(), k).name]; }

constexpr std::size_t most_drawn = 4;  // open linkages that can be told apart

// The gap can be drawn, but not so that it is seen on the whole linkage.
bool is_beside_gap(const Solution& s) {
  constexpr double smallest = 1e-9, clear = 0.08;  // of the linkage
  const double share = gap(s, 0) / linkage(s)->reach();
  return share > smallest && share < clear;
}

class OpenLinkagePanel : public Panel {
 public:
  enum class Shows { all, gap };
  OpenLinkagePanel(const Solution& solution, Shows shows, std::vector<PanelStep> steps)
      : solution_(solution), mechanism_(linkage(solution)), shows_(shows), steps_(std::move(steps)) {}

  double reach() const override {
    constexpr double longest = 45;  // mm, of the first gap
    return shows_ == Shows::all ? mechanism_->reach() : gap(solution_, 0) * 1000 / longest;
  }
  bool is_cut() const override { return shows_ == Shows::gap; }

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    if (shows_ == Shows::gap) {
      constexpr double of_links = 14;  // mm beside the gap
      for (const Place& P :
           {solution_.place(end_of_coupler(0)), solution_.place(end_of_rocker(0)), mechanism_->at("B")})
        extent.include(scale, P, of_links);
      return extent.box();
    }
    constexpr double letters = 8;  // mm
    mechanism_->include(extent, scale);
    for (std::size_t k = 0; k < drawn_open(); ++k)
      for (const std::string& end : {end_of_coupler(k), end_of_rocker(k)})
        extent.include(scale, solution_.place(end), letters);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    if (shows_ == Shows::all) mechanism_->draw_given(plot);
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override {
    constexpr double ring = 5, ring_in_detail = 33;  // mm: about what is shown larger; to the links' numbers there
    const Place &A = mechanism_->at("A"), &B0 = mechanism_->at("B0"), &B = mechanism_->at("B");
    for (std::size_t k = 0; k < drawn_open() && is_seen(plot, k); ++k) {
      const Place on_coupler = solution_.place(end_of_coupler(k)), on_rocker = solution_.place(end_of_rocker(k));
      draw_link(plot, A, on_coupler, Meaning::alternative);
      draw_link(plot, B0, on_rocker, Meaning::alternative);
      plot.side("", on_rocker, on_coupler, Meaning::dimension, fmt::format("$\\vec{{ψ}}^{{{}}}$", k), B);
      plot.dot(on_coupler);
      plot.dot(on_rocker);
      plot.label(fmt::format("$B^{{{}}}_{{3}}$", k), on_coupler, on_rocker);
      plot.label(fmt::format("$B^{{{}}}_{{4}}$", k), on_rocker, on_coupler);
    }
    if (shows_ == Shows::all) {
      mechanism_->draw(plot);
      if (is_beside_gap(solution_)) {
        plot.mark(drawings::Line{drawings::circle(plot.at(B), ring), Meaning::construction, {}});
        const double aside = ring / plot.scale().mm_per_unit;
        plot.small_label(Words{"close-up", "ingrandimento"}.in(language), B + Arrow2{-aside, 0}, B);
      }
      return {};
    }
    draw_link(plot, A, B, Meaning::link);
    draw_link(plot, B0, B, Meaning::link);
    const double number_at = ring_in_detail / plot.scale().mm_per_unit;
    for (const auto& [number, end, side] : {std::tuple{"3", A, B0}, {"4", B0, A}})
      plot.label(number, B + number_at / distance(B, end) * (end - B), side);
    plot.hinge(B);
    plot.label("$B$", B, Place{(A.x + B0.x) / 2, (A.y + B0.y) / 2});
    return {};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    std::vector<PanelStep> all = steps_;
    if (!all.empty() && iterates(solution_) > most_drawn && is_seen(plot, most_drawn))
      all.back().text = all.back().text + format_words(" Only $k$ = 0 to {} are drawn.",
                                                       " Sono disegnate solo $k$ da 0 a {}.", most_drawn - 1);
    return all;
  }

 private:
  bool is_seen(const Plot& plot, std::size_t k) const {
    constexpr double seen = 1.5;  // mm: such a gap can be drawn with its letters
    return gap(solution_, k) * plot.scale().mm_per_unit > seen;
  }
  // An iteration that wanders would cover the linkage with its iterates: of them the first.
  std::size_t drawn_open() const { return std::min(iterates(solution_), most_drawn); }

  // Beside the gap no more of it than its end.
  void draw_link(Plot& plot, const Place& from, const Place& end, Meaning meaning) const {
    constexpr double end_of_link = 40;  // mm
    const double length = distance(from, end) * plot.scale().mm_per_unit;
    const bool is_whole = shows_ == Shows::all || length <= end_of_link;
    plot.segment(is_whole ? from : end + end_of_link / length * (from - end), end, meaning);
  }

  const Solution& solution_;
  std::shared_ptr<const Mechanism> mechanism_;
  Shows shows_;
  std::vector<PanelStep> steps_;
};

Panels open_linkage(const Solution& s) {
  using Shows = OpenLinkagePanel::Shows;
  const Place A = s.place("A"), on_coupler = s.place(end_of_coupler(0)), on_rocker = s.place(end_of_rocker(0));
  const bool is_beside = is_beside_gap(s);
  std::vector<PanelStep> steps{
      {{"The start: link 3 at $θ^{0}_{3}$ about $A$, link 4 at $θ^{0}_{4}$ to $B_{0}$. The linkage is open at $B$.",
        "La partenza: il membro 3 a $θ^{0}_{3}$ intorno ad $A$, il 4 a $θ^{0}_{4}$ verso $B_{0}$. Il quadrilatero è "
        "aperto in $B$."},
       is_beside ? on_coupler + 0.6 * gap(s, 0) / distance(on_coupler, A) * (A - on_coupler)
                 : Place{(A.x + 2 * on_coupler.x) / 3, (A.y + 2 * on_coupler.y) / 3}}};
  const std::vector<PanelStep> closing{
      {{"$\\vec{ψ}^{\\it{k}}$ leads from $B^{\\it{k}}_{4}$, the end of link 4, to $B^{\\it{k}}_{3}$, the end of link "
        "3.",
        "$\\vec{ψ}^{\\it{k}}$ va da $B^{\\it{k}}_{4}$, estremo del membro 4, a $B^{\\it{k}}_{3}$, estremo del membro "
        "3."},
       Place{(on_coupler.x + 2 * on_rocker.x) / 3, (on_coupler.y + 2 * on_rocker.y) / 3}},
      {format_words(
           "Each step turns both links by −$ψ^{{−1}}_{{\\it{{y}}}}$ $ψ^{{\\it{{k}}}}$; after {} steps they "
           "meet at $B$.",
           "Ogni passo fa ruotare i due membri di −$ψ^{{−1}}_{{\\it{{y}}}}$ $ψ^{{\\it{{k}}}}$; dopo {} passi si "
           "incontrano in $B$.",
           iterates(s) - 1),
       s.place("B")}};
  steps.insert(steps.end(), closing.begin(), closing.end());
  if (is_beside) return panels(OpenLinkagePanel(s, Shows::all, {}), OpenLinkagePanel(s, Shows::gap, steps));
  return panels(OpenLinkagePanel(s, Shows::all, steps));
}

// With as many figures after the decimal sign in every row.
std::string with_decimals(double x, Language language) {
  constexpr int decimals = 6;
  const int before = x == 0 ? 1 : std::max(1, static_cast<int>(std::floor(std::log10(std::abs(x)))) + 1);
  const int zeros = x == 0 || std::abs(x) >= 1 ? 0 : -static_cast<int>(std::floor(std::log10(std::abs(x))));
  return figures(x, std::clamp(decimals + before - zeros, 1, 15), language);
}

std::optional<drawings::Block> table_of_iterates(const Solution& s, Language language) {
  constexpr std::size_t most_rows = 9;  // the first ones and the last
  drawings::Table table{{"$k$", "$θ^{\\it{k}}_{3}$ (rad)", "$θ^{\\it{k}}_{4}$ (rad)", "$|ψ^{\\it{k}}|$ (m)"}, {}};
  const std::size_t count = iterates(s);
  for (std::size_t k = 0; k < count; ++k) {
    if (count > most_rows && k + 1 == most_rows) table.rows.push_back({"…", "…", "…", "…"});
    if (count > most_rows && k + 1 >= most_rows && k + 1 < count) continue;
    const double left = gap(s, k);
    table.rows.push_back({std::to_string(k), with_decimals(s[iterate(coupler_angle(), k).name], language),
                          with_decimals(s[iterate(rocker_angle(), k).name], language),
                          left == 0 ? "0" : figures(left, 3, language)});
  }
  return table;
}

// How many turns the iteration has run past the angle that is told, which is within half a turn.
double turns_beyond(const Solution& s, const Quantity& angle) {
  return std::round((s[iterate(angle, iterates(s) - 1).name] - s[angle.name]) / (2 * std::numbers::pi));
}
Words about_whole_turns(const Solution& s) {
  std::string differences;
  for (const Quantity& angle : {coupler_angle(), rocker_angle()}) {
    const double turns = turns_beyond(s, angle);
    if (turns == 0) continue;
    const std::string by = std::abs(turns) == 1 ? "2π" : fmt::format("{}·2π", std::abs(turns));
    differences +=
        fmt::format("{}{} {} {}", differences.empty() ? "" : ", ", angle.symbol, turns > 0 ? "+" : "−", by);
  }
  if (differences.empty()) return {};
  return format_words("The last iterates are {}: whole turns beyond the angles told as results.",
                      "Le ultime iterate valgono {}: giri interi oltre le anomalie date come risultati.",
                      differences);
}

// A logarithmic axis has no zero: what became zero is left out.
drawings::Curve points_of(const Solution& s, const Quantity& quantity, Meaning meaning, drawings::PointShape shape) {
  drawings::Curve curve{.name = quantity.name, .meaning = meaning, .label = quantity.symbol};
  for (std::size_t k = 0; k < iterates(s); ++k)
    if (const double y = s[iterate(quantity, k).name]; y > 0) curve.points.push_back({static_cast<double>(k), y});
  curve.shape = shape;
  return curve;
}

drawings::Chart chart_of_convergence(const Solution& s, Language language) {
  constexpr double finest = 1e-17;  // below what doubles hold of an angle
  constexpr double beside = 0.25;   // of a step: no point lies on the frame
  drawings::Chart chart;
  double low = 1, high = finest;
  using Shape = drawings::PointShape;
  for (drawings::Curve curve : {points_of(s, residual(), Meaning::text, Shape::dot),
                                points_of(s, error_of(coupler_angle()), Meaning::locus, Shape::square),
                                points_of(s, error_of(rocker_angle()), Meaning::second_locus, Shape::triangle)}) {
    if (curve.points.empty()) continue;
    for (const drawings::Datum& point : curve.points) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
    if (curve.name == residual().name) {  // the others fall so nearly with it that three lines would be one
      curve.runs = {curve.points};
      for (const drawings::Datum& point : curve.points)
        chart.markers.push_back({.at = point, .label = figures(point.y, 2, language) + " m"});
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.x = {.quantity = "$k$",
             .low = -beside,
             .high = std::max(1.0, static_cast<double>(iterates(s)) - 1) + beside,
             .steps = drawings::whole_steps,
             .to_ticks = false};
  chart.y = {.quantity = "$|ψ|$ (m), $|Δθ_{3}|$, $|Δθ_{4}|$ (rad)",
             .low = std::max(finest, low / 10),
             .high = 10 * high,
             .scale = drawings::AxisScale::logarithmic};
  return chart;
}

}  // namespace

PanelSheet iterations_sheet(const Solution& s, Language language) {
  const std::string sin = Words{"sin", "sen"}.in(language);
  const bool is_source = s.givens().as_stated();
  return {
      .panels = open_linkage(s),
      .theory =
          {{{"Constraint equations", "Equazioni di vincolo"},
            {remark("$ψ_{1}$ = $r_{2}$ cos $θ_{2}$ + $r_{3}$ cos $θ_{3}$ + $r_{4}$ cos $θ_{4}$ − $r_{1}$ = 0"),
             remark("$ψ_{2}$ = $r_{2}$ " + sin + " $θ_{2}$ + $r_{3}$ " + sin + " $θ_{3}$ + $r_{4}$ " + sin +
                    " $θ_{4}$ = 0"),
             remark("$x$ = $θ_{2}$,  $y$ = ($θ_{3}$, $θ_{4}$):  $y^{\\it{k}+1}$ = $y^{\\it{k}}$ − $ψ^{−1}_{\\it{y}}$ "
                    "$ψ^{\\it{k}}$"),
             remark(Words{"$r_{1}$ = $A_{0}B_{0}$, $r_{2}$ = $A_{0}A$, $r_{3}$ = $AB$, $r_{4}$ = $BB_{0}$",
                          "$r_{1}$ = $A_{0}B_{0}$, $r_{2}$ = $A_{0}A$, $r_{3}$ = $AB$, $r_{4}$ = $BB_{0}$"}
                        .in(language))}},
           {{"Iterates", "Iterate"}, {table_of_iterates, remark(about_whole_turns(s).in(language))}},
           {{"Jacobian at the solution", "Jacobiano nella soluzione"},
            {table({"$ψ_{\\it{q}}$ (m)", "∂/∂$θ_{2}$", "∂/∂$θ_{3}$", "∂/∂$θ_{4}$"},
                   {{"$ψ_{1}$", {"jacobian_psi_1_theta_2", "jacobian_psi_1_theta_3", "jacobian_psi_1_theta_4"}},
                    {"$ψ_{2}$", {"jacobian_psi_2_theta_2", "jacobian_psi_2_theta_3", "jacobian_psi_2_theta_4"}}}),
             remark("∂$ψ$/∂$θ_{\\it{i}}$ = $r_{\\it{i}}$ (−" + sin +
                    " $θ_{\\it{i}}$, cos $θ_{\\it{i}}$);  $ψ_{\\it{y}}$: ∂/∂$θ_{3}$, ∂/∂$θ_{4}$"),
             remark("det $ψ_{\\it{y}}$ = $r_{3}$ $r_{4}$ " + sin + "($θ_{4}$ − $θ_{3}$)"),
             values({"jacobian_determinant_psi_y"})}},
           {{"The source", "La fonte"},
            {remark(
                is_source
                    ? Words{"It calls its start [$θ_{3}$, $θ_{4}$, $θ_{2}$]: the numbers are [$θ_{2}$, $θ_{3}$, "
                            "$θ_{4}$].",
                            "Chiama i valori iniziali [$θ_{3}$, $θ_{4}$, $θ_{2}$]: sono [$θ_{2}$, $θ_{3}$, $θ_{4}$]."}
                          .in(language)
                    : "")}}},
      .results = {values({"theta_3", "theta_4"})},
      .seen = {"The open four-bar linkage as Newton-Raphson closes it",
               "Il quadrilatero aperto che Newton-Raphson chiude"},
      .told = {"theta_3", "theta_4"},
      .without_part = {"n", "alpha_2"}};
}

PanelSheet convergence_sheet(const Solution& s, Language language) {
  const std::size_t steps = iterates(s) - 1;
  const Words of_zero = gap(s, steps) > 0
                            ? Words{}
                            : Words{"At the last iterate $|ψ|$ is 0, which has no place on a logarithmic axis.",
                                    "All'ultima iterata $|ψ|$ vale 0, che non ha posto su un asse logaritmico."};
  return {
      .panels = panels(ChartPanel(chart_of_convergence(s, language))),
      .theory = {{{"The iteration", "L'iterazione"},
                  {remark(format_words("{} steps: then $|ψ|$ no longer falls, as what is left of it is within the "
                                       "rounding of the angles.",
                                       "{} passi: poi $|ψ|$ non scende più, perché quanto ne resta sta "
                                       "nell'arrotondamento delle anomalie.",
                                       steps)
                              .in(language)),
                   remark(Words{"$Δθ_{\\it{i}}$ = $θ^{\\it{k}}_{\\it{i}}$ − $θ_{\\it{i}}$: how far iterate $k$ is "
                                "from the solution.",
                                "$Δθ_{\\it{i}}$ = $θ^{\\it{k}}_{\\it{i}}$ − $θ_{\\it{i}}$: quanto l'iterata $k$ "
                                "dista dalla soluzione."}
                              .in(language)),
                   remark(of_zero.in(language)),
                   remark(Words{
                       "Near the solution each step doubles the number of correct digits: the iteration converges "
                       "quadratically.",
                       "Vicino alla soluzione ogni passo raddoppia le cifre esatte: la convergenza è quadratica."}
                              .in(language)),
                   remark(Words{"The last errors are the rounding of doubles, no longer convergence.",
                                "Gli ultimi errori sono arrotondamento in doppia precisione, non più convergenza."}
                              .in(language)),
                   remark(Words{
                       "There is one solution, and only one, near the last iterate; what is reported are its values.",
                       "Vicino all'ultima iterata c'è una sola soluzione; i valori riportati sono i suoi."}
                              .in(language))}},
                 {{"Iterates", "Iterate"}, {table_of_iterates}}},
      .seen = {"Residual and errors of the angles against the number of Newton-Raphson steps",
               "Residuo ed errori delle anomalie contro il numero di passi di Newton-Raphson"},
      .told = {"residual_0"},
      .without_part = {"n", "alpha_2"}};
}

}  // namespace epure::four_bar_constraints
