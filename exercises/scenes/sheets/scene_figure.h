// What a scene looks like: its links as bars and plates, its joints, its guides.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/scenes/scene.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

// The names of the points that move, in the order of the file.
std::vector<std::string> moving_points(const Built& built);

// Where a link stands, by its points and lines. Of a link with neither a second point nor a line a caller's mistake.
geometry::PlacedLink<double> placed(const Built& built, const Solution& s, int link);

Mechanism figure_of(const Built& built, const Solution& solution);

// The mechanism elsewhere, dashed; the name tells this place from others. Letters of some of its points, rich text:
// with any, the others are where they are now, and have no dot of their own.
void add_in_outline(Mechanism& mechanism, const Built& built, const std::string& name,
                    const std::vector<Place>& points, const std::map<int, std::string>& letters = {});

// A link alone, cut free: its points, and the pins in its slots that something acts on; of what has but one point a
// block of this size. A link without points is `otherwise`.
Mechanism figure_of_link(const Built& built, const Solution& solution, int link, const std::vector<int>& acting,
                         double size_of_block, const Place& otherwise);

}  // namespace epure::scenes
