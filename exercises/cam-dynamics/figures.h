// How the cam is drawn, and the sides of its polygons.
#pragma once

#include "exercises/cam-dynamics/exercise.h"
#include "exercises/cam-dynamics/quantities.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/polygon_panel.h"

namespace epure::cam_dynamics {

double given(const Solution& s, const std::string& symbol);

// Disc, roller and follower of a case ("", "maximum_lift."). G3 and T are on the follower's rod.
enum class Shown { all, cam, follower };
Mechanism cam_figure(const Solution& s, const std::string& prefix, Shown shown = Shown::all);
// Dimensioned: the angle of the cam and how far the guide stands off.
enum class Dimensioned { no, yes };
std::shared_ptr<const Mechanism> whole(const Solution& s, const std::string& prefix,
                                       Dimensioned dimensioned = Dimensioned::no);
Place centre_of_follower(const Solution& s, const std::string& prefix);

// A side of a case's polygon; what is not reported there is not measured.
PolygonSide of_case(const Solution& s, const std::string& prefix, const VectorQuantity& quantity,
                    const std::string& direction, const std::string& magnitude, const std::string& tip = {});
VectorPolygon velocities(const Solution& s, const std::string& prefix, Language language);
VectorPolygon accelerations(const Solution& s, const std::string& prefix, Language language);

}  // namespace epure::cam_dynamics
