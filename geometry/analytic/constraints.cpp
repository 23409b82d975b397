#include "geometry/analytic/constraints.h"

#include "geometry/numbers/round_to_nearest.h"

#include <cmath>
#include <limits>

namespace epure::geometry::analytic {

namespace {

using namespace constraints;

constexpr double largest_angle = 0x1p26;

// What can be told of an iterate when each angle may be any number between the doubles next to it.
struct Certainty {
  bool residual_may_be_zero, determinant_may_be_zero;
};

Bounded with_its_neighbours(double x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(x, -infinity), std::nextafter(x, infinity)};
}

Certainty certainty(const FourBar& g, const CrankState<Fast>& crank, double theta_3, double theta_4) {
  const Arithmetic<Bounded> scope;
  const CrankState<Bounded> same{crank.cosine, crank.sine, Bounded(0), Bounded(0)};
  const Pair<Bounded> y = pair<Bounded>(with_its_neighbours(theta_3), with_its_neighbours(theta_4));
  const auto q = at<Bounded>(links<Bounded>(g, same), y);
  const Pair<Bounded> psi = residual(q);
  return {may_be_zero(psi(0)) && may_be_zero(psi(1)), may_be_zero(q.determinant)};
}

Words after(int steps) {
  const std::string count = std::to_string(steps);
  return {"after " + count + (steps == 1 ? " step" : " steps"), "dopo " + count + (steps == 1 ? " passo" : " passi")};
}

Words sentence(NewtonEnd end, const NewtonIterate& last, int steps) {
  const Words residual = digits(last.residual_norm) + " m", when = after(steps);
  switch (end) {
    case NewtonEnd::converged:
      return Words{"converged ", "convergente "} + when + Words{": the residual, ", ": il residuo, "} + residual +
             Words{", is as small as its rounding errors", ", è piccolo quanto i suoi errori di arrotondamento"};
    case NewtonEnd::singular:
      return Words{"stopped ", "arrestato "} + when +
             Words{": the Jacobian is singular there, coupler and rocker are in line; the residual is ",
                   ": lì lo jacobiano è singolare, biella e bilanciere sono allineati; il residuo è "} +
             residual;
    case NewtonEnd::diverged:
      return Words{"diverged ", "divergente "} + when +
             Words{": a link turned through more than ten million turns; the residual was ",
                   ": un membro ha fatto più di dieci milioni di giri; il residuo era "} +
             residual;
    case NewtonEnd::exhausted:
      break;
  }
  return Words{"no convergence ", "nessuna convergenza "} + when +
         Words{": the residual is still ", ": il residuo è ancora "} + residual;
}

NewtonIterate iterate(const Configuration<Fast>& q, double theta_2) {
  NewtonIterate now;
  now.q << q.theta_3, q.theta_4, theta_2;
  now.residual = residual(q);
  now.residual_norm = now.residual.norm();
  now.determinant = q.determinant;
  return now;
}

bool is_lost(const Eigen::Vector2d& y) { return !(y.cwiseAbs().maxCoeff() <= largest_angle); }

}  // namespace

NewtonRun newton_raphson(const FourBar& g, const CrankState<Fast>& crank, double theta_3, double theta_4,
                         int most_steps) {
  // Sines of the standard library are meant for this mode; a scope of intervals may be open around the call.
  const RoundToNearest rounding;
  const Configuration<Fast> fixed = links<Fast>(g, crank);
  const double theta_2 = arc_tangent(fixed.e_2.im, fixed.e_2.re);
  NewtonRun run;
  Eigen::Vector2d y(theta_3, theta_4);
  for (int step = 0;; ++step) {
    const Configuration<Fast> q = at<Fast>(fixed, y);
    run.iterates.push_back(iterate(q, theta_2));
    NewtonIterate& now = run.iterates.back();
    const auto ends = [&](NewtonEnd how) {
      run.end = how;
      run.reason = sentence(how, now, step);
      return run;
    };
    const Certainty known = certainty(g, crank, y(0), y(1));
    if (known.residual_may_be_zero) return ends(NewtonEnd::converged);
    if (known.determinant_may_be_zero) return ends(NewtonEnd::singular);
    if (step == most_steps) return ends(NewtonEnd::exhausted);
    const Eigen::Vector2d next = y - inverse<Fast>(jacobian(q)) * now.residual;
    if (is_lost(next)) return ends(NewtonEnd::diverged);
    now.step = next - y;
    y = next;
  }
}

}  // namespace epure::geometry::analytic
