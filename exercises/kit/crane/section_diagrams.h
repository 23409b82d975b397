// Section C of the crane's beam with its diagrams of stress, for sheets.
#pragma once

#include "exercises/kit/panels/section_panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// Half the depth of the beam, to its outer fibre and to where the flange begins, in metres.
double half_depth(const Solution& s);
double half_web(const Solution& s);

// The section with bending stress and Jourawsky's shear along its depth, in MPa. `outer` is the stress of the upper
// fibre; the shear is T S(y)/(J t(y)), of which `shear_over_J` is T/J (MPa/m³).
SectionPanel section_with_stresses(const Solution& s, double outer, double shear_over_J,
                                   std::vector<StressDiagram::Read> bending, std::vector<StressDiagram::Read> shear,
                                   Language language);

}  // namespace epure
