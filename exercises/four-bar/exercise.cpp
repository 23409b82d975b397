#include "exercises/four-bar/exercise.h"

#include "exercises/four-bar/figure.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace four_bar {
namespace {

Description description() {
  return {
      .id = "four-bar",
      .title = {"Four-bar linkage", "Quadrilatero articolato"},
      .document = "sapienza",
      .item = "N.3",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.3",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.3"},
      .givens = givens(),
      .sheets = {{"poles", {"Velocities by the poles", "Velocità col metodo dei poli"}},
                 {"velocity-diagram", {"Polar diagram of velocity", "Diagramma polare delle velocità"}},
                 {"acceleration-diagram", {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"}},
                 {"circles", {"Inflection and stationarity circles", "Circonferenze dei flessi e di stazionarietà"}},
                 {"acceleration-pole", {"Accelerations by the pole K", "Accelerazioni col metodo dei poli"}},
                 {"curvature", {"Curvature of C's path (Euler-Savary)", "Curvatura della traiettoria di C"}},
                 {"dead-centres", {"The rocker's dead centres", "I punti morti del bilanciere"}},
                 {"dead-centre-extended", {"Dead centre, extended", "Punto morto esteso"}},
                 {"dead-centre-folded", {"Dead centre, folded", "Punto morto ripiegato"}},
                 {"circles-extended", {"Circles, extended dead centre", "Circonferenze, punto morto esteso"}},
                 {"circles-folded", {"Circles, folded dead centre", "Circonferenze, punto morto ripiegato"}},
                 {"parallel-links", {"Crank and rocker parallel", "Manovella e bilanciere paralleli"}},
                 {"slider-crank", {"Circles that are lines", "Circonferenze degeneri in rette"}}},
      .quantities = quantities(),
      .printed = printed_by_the_source()};
}

void draw_at_instant(DrawnSheet& onto, const std::string& sheet, const Drawn& f, const SheetRequest& request) {
  if (sheet == "poles") draw_poles(onto, f, request);
  if (sheet == "velocity-diagram") draw_velocity_diagram(onto, f, request);
  if (sheet == "acceleration-diagram") draw_acceleration_diagram(onto, f, request);
  if (sheet == "circles") draw_circles(onto, f, request);
  if (sheet == "acceleration-pole") draw_acceleration_pole(onto, f, request);
  if (sheet == "curvature") draw_curvature(onto, f, request);
}

// `f` is null when there is no such dead centre, which the sheet then says.
void draw_at_dead_centre(DrawnSheet& onto, const std::string& sheet, const Drawn* f, const SheetRequest& request) {
  if (!f) return say_that_there_is_none(onto, request.language);
  if (sheet.starts_with("circles"))
    draw_circles(onto, *f, request);
  else
    draw_dead_centre(onto, *f, request);
}

class FourBarExercise : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return four_bar::solve(problem(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Problem of = problem(givens);
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "dead-centres") {
      draw_dead_centres(onto, of, request);
    } else if (sheet == "parallel-links") {
      draw_parallel_links(onto, of, request);
    } else if (sheet == "slider-crank") {
      draw_slider_crank(onto, of, request);
    } else if (sheet.ends_with("-extended")) {
      draw_at_dead_centre(onto, sheet, at_dead_centre(of, geometry::Reach::extended).get(), request);
    } else if (sheet.ends_with("-folded")) {
      draw_at_dead_centre(onto, sheet, at_dead_centre(of, geometry::Reach::folded).get(), request);
    } else {
      draw_at_instant(onto, sheet, *at_instant(of), request);
    }
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace
}  // namespace four_bar

std::unique_ptr<Exercise> make_four_bar() { return std::make_unique<four_bar::FourBarExercise>(); }

}  // namespace epure
