// A scale bar where several share the foot of a sheet.
#pragma once

#include "exercises/kit/panels/scale.h"

namespace epure {

// As in scale.h, but at most `longest` mm long.
drawings::ScaleBar bar(const Scale& scale, drawings::Point at, double longest, Language language);

}  // namespace epure
