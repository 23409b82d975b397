#include "exercises/scenes/sheets/diagram_sheets.h"

#include <map>
#include <utility>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/vectors_panel.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/motion_steps.h"
#include "exercises/scenes/sheets/scene_figure.h"

namespace epure::scenes {
namespace {

// With the steps by which its vectors are found, each at the tip of its own.
class DiagramPanel : public VectorsPanel {
 public:
  DiagramPanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism,
               VectorQuantity (*vector)(const std::string& of), const std::vector<std::string>& points,
               std::vector<MotionStep> steps)
      : VectorsPanel(solution, mechanism, vector, points), steps_(std::move(steps)) {
    for (const std::string& X : points)
      vectors_.insert({X, {vector(X).name, mechanism->at(X), solution.vector(vector(X).name)}});
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    std::vector<PanelStep> placed;
    for (const MotionStep& step : steps_) {
      placed.push_back({step.text});
      if (const auto found = vectors_.find(step.of); found != vectors_.end())
        placed.back().at = plot.tip(found->second.at, found->second.v);
    }
    return placed;
  }

 private:
  // Those of a sum are thin, from where the sum begins to its tip: the triangle is closed by it.
  void draw_terms(Plot& plot, const Acting& drawn) const override {
    for (const MotionStep& step : steps_) {
      const auto sum = vectors_.find(step.of), first = vectors_.find(step.from);
      if (sum == vectors_.end() || first == vectors_.end() || sum->second.quantity != drawn.quantity.name) continue;
      const Place corner = plot.tip(drawn.at, first->second.v);
      plot.segment(drawn.at, corner, Meaning::construction);
      plot.segment(corner, plot.tip(drawn.at, drawn.v), Meaning::construction);
    }
  }

  struct Vector {
    std::string quantity;
    Place at;
    Arrow2 v;
  };
  std::vector<MotionStep> steps_;
  std::map<std::string, Vector> vectors_ = {};  // by their points
};

// How far points lie from the lines that the file tells them from.
void add_offsets(PanelSheet& sheet, const Built& built, Language language) {
  for (const PointOffset& offset : built.offsets)
    sheet.results.push_back(value_as(
        format_words("Distance of ${1}$ from ${0}$, to the left: {2}", "Distanza di ${1}$ da ${0}$, a sinistra: {2}",
                     point_letters(built.letters.lines[index(offset.line)]),
                     point_letters(built.letters.points[index(offset.point)]), given_letters(offset.name))
            .in(language),
        offset.name));
}

PanelSheet diagram(const Scene& scene, const Solution& s, bool is_of_velocities, const SheetNumbers& numbers,
                   Language language) {
  const Built built = scene.built(s.givens());
  const auto vector = is_of_velocities ? velocity : acceleration;
  PanelSheet sheet;
  std::vector<std::string> moving, rates;
  for (const std::string& name : moving_points(built)) {
    if (s.value(vector(name).name)) moving.push_back(name);
    sheet.results.push_back(components(vector(name)));
  }
  for (std::size_t i = 1; i < built.linkage.links.size(); ++i)
    rates.push_back((is_of_velocities ? angular_velocity : angular_acceleration)(built.letters.links[i]).name);
  add_in_lines(sheet, rates, 3);
  sheet.results.push_back(remark(positive_rates.in(language)));
  if (is_of_velocities) add_offsets(sheet, built, language);
  const auto figure = std::make_shared<const Mechanism>(figure_of(built, s));
  if (moving.empty())
    sheet.panels = panels(MechanismPanel(figure));
  else
    sheet.panels = panels(DiagramPanel(s, figure, vector, moving, motion_steps(built, is_of_velocities, numbers)));
  return sheet;
}

}  // namespace

std::vector<SheetMaker> diagram_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers) {
  const auto sheet_of = [&](bool is_of_velocities) {
    return [scene, numbers, is_of_velocities](const Solution& s, Language language) {
      return diagram(*scene, s, is_of_velocities, numbers, language);
    };
  };
  return {{{"velocities", {"Velocities", "Velocità"}}, sheet_of(true)},
          {{"accelerations", {"Accelerations", "Accelerazioni"}}, sheet_of(false)}};
}

}  // namespace epure::scenes
