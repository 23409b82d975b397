#include <map>

#include "exercises/friction-efficiency/double_slider_routes.h"
#include "exercises/friction-efficiency/exercise.h"
#include "exercises/friction-efficiency/fairbairn_routes.h"
#include "exercises/friction-efficiency/levers_routes.h"
#include "exercises/friction-efficiency/wedge_routes.h"

namespace epure::friction_efficiency {
namespace {

// One case.
struct Routes {
  Problem problem;
  std::string of_case;

  template <class T>
  Ledger<T> operator()() const {
    static const std::map<std::string, void (*)(Ledger<T>&, const Problem&)> writes{
        {"", write_friction<T>},
        {"wedge_collar", write_wedge<T>},
        {"wedge_collar_two_point", write_two_point_wedge<T>},
        {"double_slider", write_double_slider<T>},
        {"double_slider_pins", write_double_slider_pins<T>},
        {"sliding_levers", write_levers<T>},
        {"sliding_levers_Q_on_2", write_levers_Q_on_2<T>},
        {"fairbairn", write_fairbairn<T>},
        {"fairbairn_short_lever", write_fairbairn_short_lever<T>}};
    Ledger<T> ledger("construction");
    writes.at(of_case)(ledger, problem);
    return ledger;
  }
};

}  // namespace

std::vector<PartOfExercise> parts() {
  std::vector<PartOfExercise> all;
  for (const std::string& each : cases)
    all.push_back({each, [each](const Givens& givens, Rung rung) {
                     return settle(Routes{Problem(givens), each}, rung);
                   }});
  return all;
}

std::vector<ValuesByName> values_at_friction_angles(const Givens& givens, int most, const std::string& of_case,
                                                    const std::vector<std::string>& names) {
  const Asked asked(names);
  const FirstRouteOnly once(true);
  Problem at(givens);
  // What was decided of the angle that is given.
  at.tilt.reset();
  at.wedge_at_limit = at.double_slider_at_limit = at.pins_at_limit = false;
  at.levers_at_limit = at.levers_Q_on_2_at_limit = false;
  std::vector<ValuesByName> all(static_cast<std::size_t>(most));
  for (int degrees = 1; degrees <= most; ++degrees) {
    at.phi = Angle{Rational(degrees, 360)};
    for (const RouteValue& value : settle(Routes{at, of_case}, Rung::fast))
      if (value.settled.kind == geometry::Settled::Kind::unbounded)
        all[static_cast<std::size_t>(degrees - 1)].emplace_back(value.quantity, value.settled.enclosure.value);
  }
  return all;
}

}  // namespace epure::friction_efficiency
