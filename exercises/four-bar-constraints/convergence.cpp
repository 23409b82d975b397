// Sheet 2: how fast residual and angles converge, and the three methods side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawings/charts/chart.h"
#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_constraints {
namespace {

// How far an iterate's angle is from the solution, whole turns aside.
double miss(double angle, double solution) {
  return std::abs(std::remainder(angle - solution, 2 * std::numbers::pi));
}

// A logarithmic axis has no zero: what became zero is left out.
drawings::Curve curve(const std::string& name, const std::string& label, const std::vector<double>& values) {
  drawings::Curve curve{.name = name, .runs = {{}}, .meaning = Meaning::locus, .label = label};
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k] <= 0) continue;
    curve.points.push_back({static_cast<double>(k), values[k]});
  }
  curve.runs.front() = curve.points;
  return curve;
}

drawings::Chart chart_of(const Drawn& f) {
  std::vector<double> residual, theta_3, theta_4;
  for (const auto& now : f.iterates()) {
    residual.push_back(now.residual_norm);
    theta_3.push_back(miss(now.q(0), f.compared.at(0).by_constraints));
    theta_4.push_back(miss(now.q(1), f.compared.at(1).by_constraints));
  }
  constexpr double finest = 1e-17;  // below what doubles hold of an angle
  double low = 1, high = finest;
  for (const auto* values : {&residual, &theta_3, &theta_4})
    for (const double value : *values) {
      if (value <= 0) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  drawings::Chart chart;
  chart.x = {.quantity = "$k$",
             .low = 0,
             .high = std::max(1.0, static_cast<double>(f.iterates().size()) - 1),
             .steps = drawings::whole_steps};
  chart.y = {.quantity = "$|ψ|$ (m), $|Δθ_{3}|$, $|Δθ_{4}|$ (rad)",
             .low = std::max(finest, low / 10),
             .high = 10 * high,
             .scale = drawings::AxisScale::logarithmic};
  for (auto& [name, label, values] :
       {std::tuple{"residual", "$|ψ|$", residual}, std::tuple{"error_theta_3", "$|Δθ_{3}|$", theta_3},
        std::tuple{"error_theta_4", "$|Δθ_{4}|$", theta_4}})
    if (drawings::Curve c = curve(name, label, values); !c.points.empty()) chart.curves.push_back(std::move(c));
  return chart;
}

drawings::Table comparison(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  drawings::Table table{{"", english ? "constraints" : "vincoli", english ? "analytic" : "analitico",
                         english ? "diagrams" : "diagrammi"},
                        {}};
  const auto num = [&](double x) { return figures(x, 6, language); };
  for (const Compared& row : f.compared)
    table.rows.push_back(
        {"$" + row.symbol + "$", num(row.by_constraints), num(row.by_analysis), num(row.by_polar_diagram)});
  return table;
}

std::vector<std::string> explained(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  const std::size_t steps = f.iterates().size() - 1;
  std::vector<std::string> lines{fmt::format(
      fmt::runtime(english ? "{} steps, until doubles can tell the residual from zero no more."
                           : "{} passi, finché in doppia precisione il residuo non si distingue da zero."),
      steps)};
  if (f.iterates().back().residual_norm == 0)
    lines.emplace_back(english ? "At the last iterate it is 0, which has no place on a logarithmic axis."
                               : "All'ultima iterata vale 0, che non ha posto su un asse logaritmico.");
  lines.emplace_back(english
                         ? "That one solution, and only one, lies in a box around the last iterate is proved by a "
                           "Krawczyk interval step; what is reported follows from the box."
                         : "Che intorno all'ultima iterata ci sia una e una sola soluzione lo prova un passo a "
                           "intervalli di Krawczyk; quanto si riporta segue da quella scatola.");
  return lines;
}

}  // namespace

void draw_convergence(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  drawings::Box room = drawings::drawing_area(request.paper);
  constexpr double air = 4;  // mm
  room = {{room.low.x + air, room.low.y + air}, {room.high.x - air, room.high.y - air}};
  draw(chart_of(f), room, onto.sheet.figure, language);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "The iteration" : "L'iterazione"});
  for (const std::string& line : explained(f, language)) column.push_back(drawings::Paragraph{line});
  column.push_back(drawings::Heading{english ? "Three methods" : "Tre metodi"});
  column.push_back(comparison(f, language));
  column.push_back(drawings::Paragraph{english ? "SI units: rad, rad/s, rad/s², m/s, m/s²."
                                               : "Unità SI: rad, rad/s, rad/s², m/s, m/s²."});
  onto.sheet.description = in_words({"Residual and errors of the angles against the number of Newton-Raphson steps",
                                     "Residuo ed errori delle anomalie contro il numero di passi di Newton-Raphson"},
                                    {{"|ψ⁰|", f.iterates().front().residual_norm, "m"},
                                     {english ? "steps" : "passi", static_cast<double>(f.iterates().size() - 1), ""}},
                                    language);
}

}  // namespace epure::four_bar_constraints
