#include "exercises/cycloid-involute/routes.h"

namespace epure::cycloid_involute {
namespace {

struct CycloidAtPhiRoutes {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    const CycloidAtPhi<T> write{of, ledger};
    write.by_poles();
    write.by_derivatives();
    write.arcs();
    return ledger;
  }
};

struct CycloidAtArcRoutes {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    const CycloidAtArc<T> write{of, ledger};
    write.by_poles();
    write.by_natural_equation();
    return ledger;
  }
};

struct InvoluteRoutes {
  const Problem& of;
  const Angle& phi;
  const InstantNames& names;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    const OnInvolute<T> write{of, phi, names, ledger};
    write.by_poles();
    write.by_derivatives();
    return ledger;
  }
};

}  // namespace

// Instant by instant, so that one that needs many bits or a proof does not hold up the others.
std::vector<RouteValue> solved(const Problem& of, Rung rung) {
  std::vector<RouteValue> all = settle(CycloidAtPhiRoutes{of}, rung);
  for (const auto& more : {settle(CycloidAtArcRoutes{of}, rung), settle(InvoluteRoutes{of, of.phi_1, at_t1}, rung),
                           settle(InvoluteRoutes{of, of.phi_2, at_t2}, rung)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace epure::cycloid_involute
