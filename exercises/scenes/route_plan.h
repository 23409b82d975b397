// What both routes of a scene take from its joints and letters, and how they write down a vector.
#pragma once

#include <vector>

#include "exercises/kit/proof/ledger.h"
#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/forces/force_groups.h"
#include "exercises/scenes/links_alike.h"
#include "exercises/scenes/scene_routes.h"

namespace epure::scenes {

struct RoutePlan {
  explicit RoutePlan(const Built& built)
      : vectors(relative_vectors(dyad_equations(built))),
        centres(centre_plan_of(built)),
        alike(built),
        floating(links_without_pivot(built)),
        groups(force_groups(built)) {}

  std::vector<Term> vectors;
  CentrePlan centres;
  LinksAlike alike;
  std::vector<std::size_t> floating;
  std::vector<GroupForces> groups;
};

template <class T, class Find>
void put_vector(Ledger<T>& ledger, const VectorQuantity& quantity, const Find& find) {
  ledger.put_x(quantity, [find] { return find().x; });
  ledger.put_y(quantity, [find] { return find().y; });
  ledger.put_size(quantity, [find] { return size(find()); });
}

}  // namespace epure::scenes
