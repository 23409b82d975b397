#include "exercises/four-bar-constraints/exercise.h"

#include <cmath>

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace four_bar_constraints {

std::vector<Quantity> quantities() {
  const Quantity determinant{
      "jacobian_determinant_psi_y",
      "$det ψ_{y}$",
      "m^2",
      {"determinant of the constraints' Jacobian", "determinante dello jacobiano dei vincoli"}};
  return joined({link_angle_quantities(), link_rate_quantities(), midpoint_quantities(), {determinant}});
}

namespace {

// The source's numbers with six figures, of which some are cut off where they should be rounded.
double size_of(Arrow2 MidpointMotion<double>::*vector) {
  static const Drawn figure = drawn(problem(Givens(givens())));
  return magnitude(figure.motion.*vector);
}
Explanation cut_off_size(Arrow2 MidpointMotion<double>::*vector, int decimals) {
  return cut_off([vector] { return size_of(vector); }, decimals);
}
double rate(std::size_t row) {
  static const Drawn figure = drawn(problem(Givens(givens())));
  return figure.compared.at(row).by_constraints;
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  using M = MidpointMotion<double>;
  const std::string route = "constraint equations";
  return {{"theta_3", "1.23", route},
          {"theta_4", "-0.88", route},
          {"omega_3", "-18.42", route, 0, cut_off([] { return rate(2); }, 2)},
          {"omega_4", "-10.78", route},
          {"alpha_3", "-259.65", route, 0, cut_off([] { return rate(4); }, 2)},
          {"alpha_4", "584.71", route},
          {"v_G2", "4.18879", route},
          {"v_G3", "6.50865", route},
          {"v_G4", "3.77417", route, 0, cut_off_size(&M::v_G4, 5)},
          {"a_G2", "175.459", route, 0, cut_off_size(&M::a_G2, 3)},
          {"a_G3", "370.445", route, 0, cut_off_size(&M::a_G3, 3)},
          {"a_G4", "208.656", route}};
}

namespace {

Description description() {
  return {.id = "four-bar-constraints",
          .title = {"Four-bar linkage: constraint equations", "Quadrilatero articolato: equazioni di vincolo"},
          .document = "sapienza",
          .item = "N.11",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.11",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.11"},
          .givens = givens(),
          .sheets = {{"iterations", {"Newton-Raphson on the open linkage", "Newton-Raphson sul quadrilatero aperto"}},
                     {"convergence", {"Convergence of the iteration", "Convergenza dell'iterazione"}},
                     {"velocities", {"Velocities of the midpoints", "Velocità delle mezzerie"}},
                     {"accelerations", {"Accelerations of the midpoints", "Accelerazioni delle mezzerie"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class FourBarConstraints : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return four_bar_constraints::solve(problem(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Drawn figure = drawn(problem(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "iterations") draw_iterations(onto, figure, request);
    if (sheet == "convergence") draw_convergence(onto, figure, request);
    if (sheet == "velocities") draw_velocities(onto, figure, request);
    if (sheet == "accelerations") draw_accelerations(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace
}  // namespace four_bar_constraints

std::unique_ptr<Exercise> make_four_bar_constraints() {
  return std::make_unique<four_bar_constraints::FourBarConstraints>();
}

}  // namespace epure
