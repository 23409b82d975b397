#include "exercises/friction-efficiency/exercise.h"
#include "exercises/friction-efficiency/routes.h"

namespace epure::friction_efficiency {

std::vector<RouteValue> solve(const Givens& givens, Rung rung) { return settle(Routes{Problem(givens)}, rung); }

std::vector<std::pair<std::string, double>> efficiencies_at(const Givens& givens, const Rational& degrees) {
  Problem at(givens);
  at.phi = Angle{degrees / 360};
  // What was decided of the angle that is given.
  at.tilt.reset();
  at.wedge_at_limit = at.double_slider_at_limit = at.pins_at_limit = false;
  at.levers_at_limit = at.levers_Q_on_2_at_limit = false;
  std::vector<std::pair<std::string, double>> all;
  for (const RouteValue& value : settle(Routes{at}, Rung::fast))
    if (value.route == "force polygon" && value.quantity.find(".eta_") != std::string::npos &&
        value.settled.kind == geometry::Settled::Kind::unbounded)
      all.emplace_back(value.quantity, value.settled.enclosure.value);
  return all;
}

}  // namespace epure::friction_efficiency
