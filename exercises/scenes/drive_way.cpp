#include "exercises/scenes/drive_way.h"

#include <algorithm>

#include "exercises/kit/proof/place.h"

namespace epure::scenes {

using geometry::CarriedOut;
using geometry::DriveAt;
using geometry::Fast;
using geometry::LinkagePosition;
using geometry::SlidPoint;
using geometry::Stretched;

std::optional<LinkagePosition<Fast>> DriveWay::closed_at(const DriveAt<Fast>& there) const {
  try {
    return CarriedOut<Fast>(built_.linkage, built_.steps).position(there);
  } catch (const geometry::Impossible&) {
  } catch (const geometry::Undecided&) {
    // At a limit of the motion.
  }
  return {};
}

double DriveWay::now() const {
  if (const auto* slid = std::get_if<SlidPoint>(&drive())) return CGAL::to_double(slid->at);
  return CGAL::to_double(std::get<Stretched>(drive()).length);
}

double DriveWay::farthest(double sense) const {
  const double from = now();
  double closes = 0, open = 4 * size();
  if (std::holds_alternative<Stretched>(drive()) && sense < 0) open = std::min(open, from);
  constexpr int looks = 64, halvings = 40;
  for (int look = 1; look <= looks; ++look)
    if (const double to = open * look / looks; closed_at(at(from + sense * to))) {
      closes = to;
    } else {
      open = to;
      break;
    }
  for (int i = 0; i < halvings && closes < open; ++i)
    (closed_at(at(from + sense * (closes + open) / 2)) ? closes : open) = (closes + open) / 2;
  return from + sense * closes;
}

double DriveWay::size() const {
  double far = 0;
  const auto points = CarriedOut<Fast>(built_.linkage, built_.steps).position().points;
  for (const Place& P : points) far = std::max(far, distance(points.front(), P));
  return far;
}

}  // namespace epure::scenes
