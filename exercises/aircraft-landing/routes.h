// The landing by its routes: force polygons, moments and power series; closed forms and balances of energy; Euler's
// scheme step by step and as the iterates of a map.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "exercises/aircraft-landing/landing.h"
#include "exercises/aircraft-landing/quantities.h"
#include "exercises/kit/proof/ledger.h"
#include "geometry/numbers/accurate.h"

namespace epure::aircraft_landing {

using geometry::Deep;
inline Deep number(const Rational& q) { return geometry::from_rational<Deep>(q); }

// The value by one route, on balls, with as many bits as are open.
using Find = std::function<Deep()>;
using Put = std::function<void(const std::string& name, const Find& find)>;

enum class Extent { whole, of_a_case };  // of_a_case: what the source's other models are reported of

void by_closed_form(const Landing& of, Extent extent, const Put& put);
void by_construction(const Landing& of, Extent extent, const Put& put);

// "euler_1ms." of the step, and the steps after which it is reported.
struct EulerCase {
  std::string name;
  Words words;
  Rational step;
  std::vector<int> after;
};
std::vector<EulerCase> euler_cases(const Landing& of);
void by_euler(const Landing& of, const EulerCase& scheme, bool as_map, const Put& put);

struct Routes {
  Landing landing;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("closed form");
    const auto put = [&](const std::string& name, const Find& find) {
      ledger.put(quantity(name), [&] { return geometry::on_balls<T>(find); });
    };
    both(ledger, landing, Extent::whole, put);
    for (const EulerCase& scheme : euler_cases(landing)) {
      ledger.begin_case(scheme.name, scheme.words);
      for (const bool as_map : {false, true}) {
        ledger.route(as_map ? "quadratic map" : "recursion");
        by_euler(landing, scheme, as_map, put);
      }
    }
    ledger.begin_case("doubled_wheel.", {" (doubled wheel)", " (ruota doppia)"});
    both(ledger, landing.with_doubled_wheel(), Extent::of_a_case, put);
    ledger.begin_case("flap_lift.", {" (flaps that lift)", " (flap che sollevano)"});
    both(ledger, landing.with_lift(), Extent::of_a_case, put);
    return ledger;
  }

 private:
  template <class T>
  static void both(Ledger<T>& ledger, const Landing& of, Extent extent, const Put& put) {
    ledger.route("closed form");
    by_closed_form(of, extent, put);
    ledger.route("force polygon");
    by_construction(of, extent, put);
  }
};

}  // namespace epure::aircraft_landing
