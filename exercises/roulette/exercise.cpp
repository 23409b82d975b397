#include "exercises/roulette/exercise.h"

#include "exercises/kit/rolling/instant_panel.h"
#include "exercises/roulette/routes.h"

namespace epure {
namespace roulette {
namespace {

PanelSheet instant_sheet(const Solution& s, Language language) {
  const Rolled f = rolled(s, rolling_of(s.givens()), names);
  constexpr double longest_velocity = 38;  // mm
  std::vector<Result> results{values({"P0M", "v_M"}), values({"a_M", "a_M_n"})};
  // Two numbers at a cusp, else twice the same.
  results.push_back(f.is_at_cusp ? values({"a_M_t_before", "a_M_t_after"}) : value_as("$a^{t}_{M}$", "a_M_t_after"));
  results.insert(results.end(), {values({"inflection_diameter", "rho_M"}),
                                 values({"curvature_centre_M_x", "curvature_centre_M_y"})});
  if (!f.centre) results.push_back(remark("$ρ_{M}$ = ∞"));
  return {
      .panels =
          panels(RollingInstantPanel(s, f, instant_steps(f), scale_of_velocities({f}, longest_velocity, language))),
      .results = std::move(results),
      .seen =
          {"The bodies, the path, velocity and acceleration of M, the inflection circle and the centre of curvature",
           "I corpi, la traiettoria, velocità e accelerazione di M, la circonferenza dei flessi e il centro di "
           "curvatura"},
      .told = {"v_M", "a_M", "rho_M"}};
}

// A line has no radius, and gives the sheets another title.
template <class Make>
auto for_what_rolls(const Make& make) {
  return [=](const Solution& s, Language language) {
    const RollingGivens given = rolling_of(s.givens());
    PanelSheet sheet = make(s, language);
    if (given.is_line()) {
      sheet.without_part = {"r"};
      sheet.title = {"A point carried by a rolling line", "Un punto portato da una retta che rotola"};
    }
    if (given.rolls_on_line()) sheet.without_part = {"R"};
    return sheet;
  };
}

}  // namespace
}  // namespace roulette

std::unique_ptr<Exercise> make_roulette() {
  using namespace roulette;
  Description about{
      .id = "roulette",
      .title = {"A point carried by a rolling circle", "Un punto portato da un cerchio che rotola"},
      .document = "epure",
      .item = "roulettes",
      .source = {"epure, roulettes", "epure, curve di rotolamento"},
      .question =
          {"A circle or a line rolls without slipping. Draw the path of the point that it carries; at the given "
           "instant find its velocity, acceleration, inflection circle and centre of curvature.",
           "Una circonferenza o una retta rotola senza strisciare. Tracciare la traiettoria del punto che porta con "
           "sé; all'istante dato trovarne velocità, accelerazione, circonferenza dei flessi e centro di curvatura."},
      .givens = given_specs()};
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(Routes{rolling_of(givens), rung != Rung::drawing}, rung);
  };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"path",
         {"Path of the point", "Traiettoria del punto"},
         {"A circle or a line rolls without slipping. Draw the path of the point that it carries.",
          "Una circonferenza o una retta rotola senza strisciare. Tracciare la traiettoria del punto che porta con "
          "sé."}},
        for_what_rolls(path_sheet)},
       {{"instant",
         {"Velocity, acceleration, curvature", "Velocità, accelerazione, curvatura"},
         {"A circle or a line rolls without slipping. At the given instant find velocity, acceleration, inflection "
          "circle and centre of curvature of the point that it carries.",
          "Una circonferenza o una retta rotola senza strisciare. All'istante dato trovare velocità, accelerazione, "
          "circonferenza dei flessi e centro di curvatura del punto che porta con sé."}},
        for_what_rolls(instant_sheet)}});
}

}  // namespace epure
