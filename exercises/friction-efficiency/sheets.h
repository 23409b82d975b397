// The sheets: bodies cut free in the direct motion with their friction cones, the polygons of both motions over those
// without friction, the details of the pins, and the efficiencies over the friction angle.
#pragma once

#include "exercises/friction-efficiency/exercise.h"

namespace epure::friction_efficiency {

PanelSheet wedge(const Solution& s, Language language);
PanelSheet two_forces(const Solution& s, Language language);
PanelSheet double_slider(const Solution& s, Language language);
PanelSheet levers(const Solution& s, const std::string& name, int loaded_lever, Language language);
PanelSheet fairbairn(const Solution& s, const std::string& name, Language language);
// The efficiencies of all mechanisms over the friction angle, those given as they are.
PanelSheet over_friction_angle(const Solution& s, Language language);

}  // namespace epure::friction_efficiency
