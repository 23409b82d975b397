#include "exercises/kit/rolling/instant_steps.h"

namespace epure {
namespace {

using At = InstantStep::At;

// With the line that the stationarity circle has become.
Words at_constant_speed(const Rolled& f) {
  if (!is_zero(f.given.alpha) || is_zero(f.given.omega)) return {};
  return {" $α = 0$: $K ≡ J$; the stationarity circle is now the line $P_{0}K$.",
          " $α = 0$: $K ≡ J$; la circonferenza di stazionarietà è la retta $P_{0}K$."};
}

Words inflection_pole(const Rolled& f) {
  switch (f.given.rolling.how) {
    case geometry::Rolls::circle_on_line:
      return {
          "The contact $P_{0}$ is the pole. $C$ runs straight (1/$δ$ = 1/$r$ − 1/∞): it is the inflection pole, $J ≡ "
          "C$, $δ = P_{0}J = r$.",
          "Il contatto $P_{0}$ è il polo. $C$ va diritto (1/$δ$ = 1/$r$ − 1/∞): è il polo dei flessi, $J ≡ C$, $δ = "
          "P_{0}J = r$."};
    case geometry::Rolls::line_on_circle:
      return {
          "The contact $P_{0}$ is the pole. Seen from the line, $O$ moves on a straight line parallel to it: the "
          "inflection pole $J$ lies opposite it, $δ = P_{0}J = P_{0}O$.",
          "Il contatto $P_{0}$ è il polo. Vista dalla retta, la traiettoria di $O$ è rettilinea: il polo dei flessi "
          "$J$ gli sta di fronte, $δ = P_{0}J = P_{0}O$."};
    default:
      return {
          "The contact $P_{0}$ is the pole. $C$ goes about $O$: by Euler-Savary $P_{0}C^{2} = CO·CJ$ gives the "
          "inflection pole $J$. $δ = P_{0}J$.",
          "Il contatto $P_{0}$ è il polo. $C$ ruota intorno a $O$: per la formula di Euler-Savary $P_{0}C^{2} = "
          "CO·CJ$ dà il polo dei flessi $J$. $δ = P_{0}J$."};
  }
}

// ω² P0J at the pole carried over to M: ω² MJ, and what α adds. MJ = MM' + M'J, along the ray and across it.
Words acceleration_step(const Rolled& f) {
  const bool angular = !is_zero(f.given.alpha);
  const std::string &omega = f.names.omega, of_alpha = " + |$α$|·$P_{0}M$",
                    parts = "$\\vec{a}_{M} = \\vec{a}^{n}_{M} + \\vec{a}^{t}_{M}";
  const std::string tangential = "$a^{t}_{M} = " + omega + "^{2}·M'J$" + (angular ? of_alpha : "");
  if (is_zero(f.given.omega))
    return {"$" + omega + " = 0$: $a_{M}$ = |$α$|·$P_{0}M$, perpendicular to the ray.",
            "$" + omega + " = 0$: $a_{M}$ = |$α$|·$P_{0}M$, normale al raggio."};
  if (angular)
    return {tangential + ", perpendicular to the ray, each with its sense. " + parts + "$.",
            tangential + ", normali al raggio, ciascuno col suo verso. " + parts + "$."};
  const std::string all = parts + " = " + omega + "^{2}·MJ$: ";
  return {tangential + ", perpendicular to the ray. " + all + "it points at $J$.",
          tangential + ", normale al raggio. " + all + "è diretta verso $J$."};
}

std::vector<InstantStep> at_cusp(const Rolled& f) {
  const std::string a_M = "$\\vec{a}_{M} = " + f.names.omega + "^{2}·P_{0}J$";
  return {
      {{"$M$ is on the pole: $\\vec{v}_{M}$ = 0. " + a_M +
            " lies along the path: against the motion $\\vec{t}^{−}$ before, with $\\vec{t}^{+}$ after.",
        "$M$ è sul polo: $\\vec{v}_{M}$ = 0. Tutta la " + a_M +
            " è lungo la traiettoria: contro il moto $\\vec{t}^{−}$ prima, concorde col moto $\\vec{t}^{+}$ dopo."},
       At::acceleration},
      {f.runs_straight()
           ? Words{"The path is straight: $M$ turns back.", "La traiettoria è diritta: $M$ torna indietro."}
           : Words{"The path has a cusp: $ρ = 0$, the centre of curvature is $M$.",
                   "La traiettoria ha una cuspide: $ρ = 0$, il centro di curvatura è $M$."},
       At::centre_of_curvature}};
}

Words foot_step(const Rolled& f) {
  if (f.runs_straight())
    return {"$M$ is on the inflection circle, always: $M' ≡ M$, its path is a diameter, $\\vec{a}^{n}_{M}$ = 0.",
            "$M$ è sempre sulla circonferenza dei flessi: $M' ≡ M$, la traiettoria è un diametro, $\\vec{a}^{n}_{M}$ "
            "= 0."};
  const std::string to_contact = "$M' ≡ P_{0}$, $a^{n}_{M} = " + f.names.omega + "^{2}·MP_{0}$.",
                    to_foot = "$a^{n}_{M} = " + f.names.omega + "^{2}·MM'$.";
  if (f.given.unwinds())
    return {"The ray $P_{0}M$ touches the inflection circle at $P_{0}$: " + to_contact,
            "Il raggio $P_{0}M$ è tangente alla circonferenza dei flessi in $P_{0}$: " + to_contact};
  return {"The foot of the perpendicular from $J$ to the ray $P_{0}M$ is $M'$, on the inflection circle: " + to_foot,
          "Il piede della normale da $J$ sul raggio $P_{0}M$ è $M'$, sulla circonferenza dei flessi: " + to_foot};
}

Words curvature_step(const Rolled& f) {
  if (!f.centre)
    return {"$M$ is on the inflection circle: the path is straight here, $Ω$ is at infinity.",
            "$M$ è sulla circonferenza dei flessi: la traiettoria qui è diritta, $Ω$ è all'infinito."};
  if (f.given.unwinds())
    return {"$P_{0}M^{2} = ρ·MM'$: $ρ = P_{0}M$, the centre of curvature is $Ω ≡ P_{0}$.",
            "$P_{0}M^{2} = ρ·MM'$: $ρ = P_{0}M$, il centro di curvatura è $Ω ≡ P_{0}$."};
  return {"$P_{0}M^{2} = M$$Ω·MM'$: centre of curvature $Ω$, on the side of $M'$.",
          "$P_{0}M^{2} = M$$Ω·MM'$: centro di curvatura $Ω$, dalla parte di $M'$."};
}

}  // namespace

std::vector<InstantStep> instant_steps(const Rolled& f) {
  std::vector<InstantStep> steps{{inflection_pole(f) + at_constant_speed(f), At::inflection_pole}};
  if (f.is_at_cusp) {
    for (InstantStep& step : at_cusp(f)) steps.push_back(std::move(step));
    return steps;
  }
  const std::string velocity = "$\\vec{v}_{M}$ ⊥ $P_{0}M$, $v_{M}$ = |$" + f.names.omega + "$|·$P_{0}M$.";
  steps.push_back({{velocity, velocity}, At::tip_of_velocity});
  steps.push_back({foot_step(f), At::foot});
  steps.push_back({acceleration_step(f), At::acceleration});
  if (!f.runs_straight()) steps.push_back({curvature_step(f), At::centre_of_curvature});
  return steps;
}

}  // namespace epure
