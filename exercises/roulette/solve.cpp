// Every quantity by the poles, with Euler and Savary, and by closed formulas; the arc by its primitive and by
// quadrature.
#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/roulette/exercise.h"

namespace epure::roulette {
namespace {

using geometry::analytic::Complex;

template <class T>
void by_poles(Ledger<T>& ledger, const Problem& problem) {
  ledger.route("poles");
  const auto at = geometry::rolling_instant<T>(problem.rolling, problem.phi, geometry::radians<T>(problem.omega),
                                               geometry::radians<T>(problem.alpha));
  // From the contact into the fixed plane. On a line the contact has gone r φ, with a π in it that the exact numbers
  // of a tower have no room for: looked for anew by each quantity that needs it.
  const auto contact = [&] { return geometry::contact_point<T>(problem.rolling, problem.phi); };
  const auto put_point = [&](const std::string& name, const std::function<geometry::Vector<T>()>& from_contact) {
    ledger.put(name + "_x", [&] { return contact().x + from_contact().x; });
    ledger.put(name + "_y", [&] { return contact().y + from_contact().y; });
  };
  const geometry::Vector<T> P0M = at.M - at.motion.A;
  put_point("M", [&] { return P0M; });
  put_point("P0", [&] { return geometry::Vector<T>{T(0), T(0)}; });
  ledger.put("P0M", [&] { return size(at.by_normal); });
  ledger.vector("v_M", at.velocity());
  ledger.vector("a_M", at.acceleration());
  ledger.put("a_M_n", [&] { return size(at.normal_acceleration()); });
  ledger.put("a_M_t_before", [&] { return at.tangential_component().before; });
  ledger.put("a_M_t_after", [&] { return at.tangential_component().after; });
  ledger.put("inflection_diameter", at.diameter);
  put_point("inflection_pole", [&] { return at.J - at.motion.A; });
  ledger.put("Mprime_M", [&] { return size(at.M_prime() - at.M); });
  ledger.put("rho_M", [&] { return at.radius_of_curvature(); });
  put_point("curvature_centre_M", [&] {
    const geometry::ProjectivePoint<T> centre = at.centre_of_curvature();
    if (geometry::sign(centre.w) == geometry::Sign::zero) throw geometry::Impossible(no_curvature);
    return geometry::finite(centre) - at.motion.A;
  });
  ledger.route("primitive");
  ledger.put("s", [&] { return geometry::arc_length<T>(problem.rolling, problem.phi); });
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Problem& problem) {
  ledger.route("analytic");
  const T omega = geometry::radians<T>(problem.omega), alpha = geometry::radians<T>(problem.alpha);
  const auto closed = problem.closed_form();
  const auto path = geometry::analytic::roulette<T>(closed, problem.phi);
  const auto motion = path.motion(T(1), T(0));  // poles and circles do not depend on how fast
  put_point<T>(ledger, "M", [&] { return path.z; });
  // Not motion.pole(): on a line that is r - r above it, which an enclosure cannot tell from zero.
  put_point<T>(ledger, "P0", [&] { return geometry::analytic::contact<T>(closed, problem.phi); });
  put_length<T>(ledger, "P0M", [&] { return path.z_prime; });
  put_vector<T>(ledger, "v_M", [&] { return path.velocity(omega); });
  put_vector<T>(ledger, "a_M", [&] { return path.acceleration(omega, alpha); });
  ledger.put("a_M_n", [&] { return path.normal_component(omega); });
  ledger.put("a_M_t_before", [&] { return path.components(omega, alpha).before; });
  ledger.put("a_M_t_after", [&] { return path.components(omega, alpha).after; });
  put_length<T>(ledger, "inflection_diameter", [&] { return *motion.inflection_pole() - *motion.pole(); });
  put_point<T>(ledger, "inflection_pole", [&] { return *motion.inflection_pole(); });
  put_length<T>(ledger, "Mprime_M", [&]() -> Complex<T> {
    if (path.is_at_rest) return {};  // M, M' and the pole are one
    return *motion.on_inflection_circle(path.z) - path.z;
  });
  ledger.put("rho_M", [&] { return path.radius_of_curvature(); });
  put_point<T>(ledger, "curvature_centre_M", [&] { return path.centre_of_curvature(); });
  ledger.route("quadrature");
  ledger.put("s", [&] { return geometry::analytic::arc_length<T>(closed, problem.phi); });
}

struct Routes {
  const Problem& problem;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    by_poles(ledger, problem);
    by_analysis(ledger, problem);
    return ledger;
  }
};

}  // namespace

std::vector<RouteValue> solved(const Problem& problem, Rung rung) { return settle(Routes{problem}, rung); }

}  // namespace epure::roulette
