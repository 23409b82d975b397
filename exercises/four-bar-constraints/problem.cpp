// The givens, and when they are impossible.
#include <fmt/format.h>

#include "exercises/four-bar-constraints/exercise.h"

namespace epure::four_bar_constraints {
namespace {

// A start may be given in any unit of an angle.
double radians_of(const Givens& givens, const char* start) {
  return geometry::radians<geometry::Fast>(givens.angle(start));
}

constexpr int most_steps = 60;

Words start_in_words(const Givens& givens) {
  return format_words("from the start θ₃ = {} rad, θ₄ = {} rad", "dalla partenza θ₃ = {} rad, θ₄ = {} rad",
                      decimal(radians_of(givens, "theta_3_start"), 6),
                      decimal(radians_of(givens, "theta_4_start"), 6));
}

[[noreturn]] void refuse(const Givens& givens, const geometry::analytic::NewtonRun& run) {
  using geometry::analytic::NewtonEnd;
  const bool at_once = run.end == NewtonEnd::singular && run.iterates.size() == 1;
  if (at_once)
    throw BadGivens(
        format_words("{} the Jacobian ψ_y is singular: coupler and rocker are parallel there, and Newton-Raphson has "
                     "no step to make; start from angles that differ by no multiple of π",
                     "{} lo jacobiano ψ_y è singolare: lì biella e bilanciere sono paralleli, e Newton-Raphson non "
                     "ha un passo da fare; partire da angoli che non differiscano di un multiplo di π",
                     start_in_words(givens)));
  throw BadGivens(format_words("Newton-Raphson does not reach a configuration {}: {}",
                               "Newton-Raphson non raggiunge una configurazione {}: {}", start_in_words(givens),
                               run.reason));
}

}  // namespace

std::vector<GivenSpec> givens() {
  std::vector<GivenSpec> all = four_bar_on_x_givens();
  all.push_back({"theta_3_start",
                 {"direction of AB from which the iteration starts", "anomalia di AB da cui parte l'iterazione"},
                 "rad",
                 "1.22",
                 Range::any,
                 "$θ^{0}_{3}$"});
  all.push_back({"theta_4_start",
                 {"direction from B to B₀ from which it starts", "anomalia di BB₀ da cui parte"},
                 "rad",
                 "-0.87",
                 Range::any,
                 "$θ^{0}_{4}$"});
  return all;
}

Problem problem(const Givens& givens) {
  using geometry::Fast;
  Problem of{.instant = four_bar_on_x(givens, geometry::Side::left), .run = {}};
  require_drivable(of.instant);  // whichever branch
  const auto crank = geometry::analytic::crank_at<Fast>(of.instant.crank, 1.0, 0.0);
  of.run =
      geometry::analytic::newton_raphson(of.instant.analytic_lengths(), crank, radians_of(givens, "theta_3_start"),
                                         radians_of(givens, "theta_4_start"), most_steps);
  if (of.run.end != geometry::analytic::NewtonEnd::converged) refuse(givens, of.run);
  if (of.run.iterates.back().determinant > 0) {
    of.instant.side = geometry::Side::right;
    require_drivable(of.instant);
  }
  return of;
}

}  // namespace epure::four_bar_constraints
