#include "exercises/kit/panels/force_plan_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/on_sides.h"
#include "exercises/kit/statement/nth_letter.h"

namespace epure {
namespace {

constexpr double plan_air = 8;  // mm, for letters

}  // namespace

double ForcePlanPanel::longest() const {
  double longest = 0;
  for (const Place& P : figure_->plan)
    for (const Place& Q : figure_->plan) longest = std::max(longest, distance(P, Q));
  return longest;
}

bool ForcePlanPanel::is_slender() const {
  constexpr double slender = 0.25;
  Extent all;
  for (const Place& P : figure_->plan) all.include(P.x, P.y);  // N
  return std::min(all.box().width(), all.box().height()) < slender * longest();
}

Panel::Vectors ForcePlanPanel::vectors() const {
  // mm: longer the truss beside it would have no room; a slender plan stands above or below it.
  constexpr double longest_on_paper = 100, longest_if_slender = 110;
  return {"N", longest(), is_slender() ? longest_if_slender : longest_on_paper};
}

drawings::Box ForcePlanPanel::extent(const Scale&, const Scale& vectors) const {
  Extent extent;
  for (const Place& P : figure_->plan) extent.include(vectors, P, plan_air);
  return extent.box();
}

// The loads in their row have room; but not across a slender plan.
std::vector<Place> ForcePlanPanel::lettered() const {
  const auto without = static_cast<std::ptrdiff_t>(is_slender() ? 0 : figure_->bow.forces.size());
  return {figure_->plan.begin() + without, figure_->plan.end()};
}

std::vector<drawings::Block> ForcePlanPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const geometry::BowNotation& bow = figure_->bow;
  for (std::size_t i = 0; i < figure_->bars.size(); ++i) {
    const TrussFigure::Bar& bar = figure_->bars[i];
    if (bar.force == 0) continue;
    const Place &P = figure_->plan[bow.sides[i].left], &Q = figure_->plan[bow.sides[i].right];
    plot.in_step(figure_->step_of_bar(i));
    plot.segment(P, Q, TrussFigure::meaning(bar.force), bar.quantity);
    plot.measures(bar.quantity, P, Q);
  }
  const auto ends_of = [&](std::size_t k) {
    return std::pair{figure_->plan[k], figure_->plan[(k + 1) % bow.forces.size()]};
  };
  plot.in_step(1);
  std::vector<std::pair<Place, Place>> loads;
  for (std::size_t k = 0; k < bow.forces.size(); ++k)
    if (bow.forces[k] > 1) loads.push_back(ends_of(k));
  for (std::size_t k = 0; k < bow.forces.size(); ++k) {
    const TrussFigure::Outside& force = figure_->outside[bow.forces[k]];
    if (magnitude(force.f) == 0) continue;
    const auto [from, to] = ends_of(k);
    // A reaction that would lie on the loads stands beside them.
    Arrow2 aside{0, 0};
    if (bow.forces[k] < 2 && lies_on_a_side(from, to, loads)) {
      constexpr double beside = 1.5;  // mm
      const Arrow2 normal = geometry::quarter_turn(to - from);
      aside = (beside / plot.scale().mm_per_unit / magnitude(normal)) * normal;
    }
    plot.side(force.quantity, from + aside, to + aside, Meaning::force, force.label);
  }
  // Points that the eye cannot tell apart have their letters together.
  constexpr double together = 0.3;  // mm
  std::vector<bool> is_written(bow.regions(), false);
  for (std::size_t r = 0; r < bow.regions(); ++r) {
    if (is_written[r]) continue;
    std::string letters = nth_letter(r);
    for (std::size_t s = r + 1; s < bow.regions(); ++s)
      if (distance(figure_->plan[r], figure_->plan[s]) * plot.scale().mm_per_unit < together) {
        is_written[s] = true;
        letters += ", " + nth_letter(s);
      }
    plot.in_step(figure_->step_of_region(r));
    plot.dot(figure_->plan[r]);
    plot.label("$" + letters + "$", figure_->plan[r]);
  }
  return {};
}

std::vector<PanelStep> ForcePlanPanel::steps(const Plot&, const drawings::Box&) const {
  const geometry::BowNotation& bow = figure_->bow;
  const auto letter = nth_letter;  // of a region
  std::vector<PanelStep> all{{{"Clockwise round the truss the forces from outside, each between the letters of its "
                               "regions: the loads and the reactions found before. They close.",
                               "In senso orario attorno alla travatura le forze esterne, ognuna tra le lettere delle "
                               "sue regioni: i carichi e le reazioni già trovate. Si chiudono."},
                              figure_->plan.front()}};
  for (const auto& step : bow.steps) {
    const auto beyond = [&](std::size_t bar) {
      const auto& [left, right] = bow.sides[bar];
      return letter(left == step.region ? right : left);
    };
    const std::string first = std::to_string(step.bars[0] + 1), second = std::to_string(step.bars[1] + 1);
    const std::string lines = "$" + beyond(step.bars[0]) + letter(step.region) + "$ ∥ " + first + ", $" +
                              beyond(step.bars[1]) + letter(step.region) + "$ ∥ " + second;
    const std::string at = step.joint ? "$" + figure_->letters[*step.joint] + "$: " : "";
    all.push_back({Words{at + lines + ".", at + lines + "."}, figure_->plan[step.region]});
  }
  const std::string last = std::to_string(bow.closing_bar + 1);
  const auto& [left, right] = bow.sides[bow.closing_bar];
  const std::string line = "$" + letter(left) + letter(right) + "$";
  all.push_back({Words{line + " has come out parallel to bar " + last + ": the plan closes.",
                       line + " è risultata parallela all'asta " + last + ": il diagramma si chiude."}});
  return all;
}

}  // namespace epure
