// The pump by its routes: formulas and the primitive of the torque; what pressures, powers and areas give by
// quadrature.
#pragma once

#include <functional>

#include "exercises/kit/proof/ledger.h"
#include "exercises/pump-flywheel/pump.h"
#include "exercises/pump-flywheel/quantities.h"
#include "exercises/pump-flywheel/torque.h"
#include "geometry/numbers/accurate.h"

namespace epure::pump_flywheel {

inline Deep number(const Rational& q) { return geometry::from_rational<Deep>(q); }
using Find = std::function<Deep()>;
using Put = std::function<void(const std::string& name, const Find& find)>;
// Begins a case of the exercise.
using Begin = std::function<void(const std::string& prefix, const Words& words)>;

void by_formulas(const Pump& of, const Put& put, const Begin& begin);
void by_areas(const Pump& of, const Put& put, const Begin& begin);

// 1 when a is less than b, 0 when not. Throws Undecided.
Deep is_less(const Deep& a, const Deep& b);

const Words with_mass{" (with the reciprocating mass)", " (con le masse alterne)"},
    by_wittenbauer{" (Wittenbauer's diagram)", " (diagramma di Wittenbauer)"},
    of_the_text{" (2010 mm, as the text has it)", " (2010 mm, come nel testo)"};

struct Routes {
  Pump pump;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    const auto put = [&](const std::string& name, const Find& find) {
      ledger.put(quantity(name), [&] { return geometry::on_balls<T>(find); });
    };
    const auto begin = [&](const std::string& prefix, const Words& words) { ledger.begin_case(prefix, words); };
    by_formulas(pump, put, begin);
    begin("", {});
    ledger.route("quadrature");
    by_areas(pump, put, begin);
    return ledger;
  }
};

}  // namespace epure::pump_flywheel
