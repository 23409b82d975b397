#include "geometry/curves/view.h"

#include <cassert>

namespace epure::geometry {

namespace {

// |x| and |w| as intervals: x/w lies beyond ±half whatever x and w are, w = 0 included.
bool is_beyond(const Bounded& x, const Bounded& w, const Bounded& half) {
  return CGAL::abs(x).inf() > (half * CGAL::abs(w)).sup();
}

bool is_within(const Bounded& x, const Bounded& reach) { return CGAL::abs(x).sup() <= reach.inf(); }

}  // namespace

View::View(const Frame& frame) {
  assert(frame.x_min < frame.x_max && frame.y_min < frame.y_max && "a frame without an inside");
  const Point<Bounded> low{frame.x_min, frame.y_min}, high{frame.x_max, frame.y_max};
  const Bounded two(2);
  centre_ = {(low.x + high.x) / two, (low.y + high.y) / two};
  half_ = {(high.x - low.x) / two, (high.y - low.y) / two};
}

bool View::is_outside(const ProjectivePoint<Bounded>& P) const {
  return is_beyond(P.x - centre_.x * P.w, P.w, half_.x) || is_beyond(P.y - centre_.y * P.w, P.w, half_.y);
}

bool View::is_near(const Point<Bounded>& P) const {
  const Bounded three(3);
  return is_within(P.x - centre_.x, three * half_.x) && is_within(P.y - centre_.y, three * half_.y);
}

}  // namespace epure::geometry
