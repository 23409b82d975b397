// What is reported of a scene, by two routes: group after group with ruler and compass, and by the equations of all
// joints at once.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"
#include "geometry/linkages/centre_plan.h"

namespace epure::scenes {

// What both routes take from the joints and the letters, and by which lines instant centres are found: those that
// meet well where the drive stands when it is made.
struct RoutePlan;
std::shared_ptr<const RoutePlan> route_plan(const Built& built);

// `plan`: of this mechanism, perhaps with its drive elsewhere. Throws geometry::NotClosed where it does not close.
std::vector<RouteValue> by_both_routes(const std::shared_ptr<const Built>& built,
                                       const std::shared_ptr<const RoutePlan>& plan, Rung rung);

// By which lines its instant centres are found.
geometry::CentrePlan centre_plan_of(const Built& built);

// θ_3, of the link as the file numbers it.
Quantity link_angle(int number);

// P_ij, of the links as the file numbers them, in either order: "P13", "P2_13".
PointQuantity instant_centre(int one, int other);

// The links that no joint pins to the frame, by their places in the linkage: of these the point without acceleration
// is reported.
std::vector<std::size_t> links_without_pivot(const Built& built);
// K_3, of the link as the file numbers it.
PointQuantity acceleration_centre(int link);

}  // namespace epure::scenes
