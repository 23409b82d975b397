#include "geometry/analytic/joints/enclosed.h"
#include "geometry/analytic/joints/sides.h"

namespace epure::geometry::analytic {
namespace {

using namespace joints;

template <class T>
void demand_zero(const T& x) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided)
    throw Undecided("whether what was constructed satisfies the equations of all joints",
                    "se quanto costruito soddisfi le equazioni di tutti i vincoli");
  if (decided != Sign::zero)
    throw Impossible("what was constructed does not satisfy the equations of all joints",
                     "quanto costruito non soddisfa le equazioni di tutti i vincoli");
}

}  // namespace

template <class T>
void demand_joints(const Linkage& linkage, const std::vector<LinkState<T>>& state, UpTo order,
                   const Hanging& hanging) {
  const std::vector<Equation<T>> rows = JointEquations<T>(linkage, state, hanging).all();
  if (order == UpTo::place) {
    for (std::size_t i = 0; i < state.size(); ++i)
      if (hanging.is_placed[i]) demand_zero(squared_modulus(state[i].x) - T(1));
    for (const Equation<T>& row : rows) demand_zero(row.residual);
    demand_sides(linkage, state, hanging);
    return;
  }
  const bool is_first = order == UpTo::velocity;
  const Column<T> rates = rates_of(state, is_first);
  for (const Equation<T>& row : rows)
    demand_zero(along(row, rates) - (is_first ? row.rate : row.second_rate - row.quadratic));
}
template void demand_joints<Exact>(const Linkage&, const std::vector<LinkState<Exact>>&, UpTo, const Hanging&);
template void demand_joints<Generic>(const Linkage&, const std::vector<LinkState<Generic>>&, UpTo, const Hanging&);
template void demand_joints<Calcium>(const Linkage&, const std::vector<LinkState<Calcium>>&, UpTo, const Hanging&);

void demand_independent(const Linkage& linkage, const std::vector<LinkState<Deep>>& place) {
  const std::vector<Equation<Deep>> rows = equations(linkage, place);
  demand_regular(Preconditioner<Deep>(rows), rows);
}

}  // namespace epure::geometry::analytic
