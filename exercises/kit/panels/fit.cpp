#include "exercises/kit/panels/fit.h"

#include <algorithm>

#include "drawings/text/text.h"

namespace epure {
namespace {

// Smaller and smaller standard scales until the picture fits. Every step at least halves it, so labels and symbols,
// which do not shrink, are the only reason to give up.
Fit descend(Scale scale, const drawings::Box& room, const std::function<Scale(double)>& next,
            const std::function<drawings::Box(const Scale&)>& extent_at) {
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i) {
    const drawings::Box extent = extent_at(scale);
    if (fits(extent, room)) return Fit{scale, origin_in(room, extent)};
    scale = next(scale.mm_per_unit * 0.99);
  }
  throw DoesNotFit("the figure does not fit the paper at any standard scale",
                   "la figura non sta sulla carta in alcuna scala normalizzata");
}

}  // namespace

void Extent::include(double x, double y) {
  low_ = empty_ ? drawings::Point{x, y} : drawings::Point{std::min(low_.x, x), std::min(low_.y, y)};
  high_ = empty_ ? drawings::Point{x, y} : drawings::Point{std::max(high_.x, x), std::max(high_.y, y)};
  empty_ = false;
}

void Extent::include(const Scale& scale, const Place& P, double air) {
  const double x = scale.mm_per_unit * P.x, y = scale.mm_per_unit * P.y;
  include(x - air, y - air);
  include(x + air, y + air);
}

bool fits(const drawings::Box& extent, const drawings::Box& room) {
  return extent.width() <= room.width() && extent.height() <= room.height();
}

drawings::Point origin_in(const drawings::Box& room, const drawings::Box& extent) {
  return {room.low.x + (room.width() - extent.width()) / 2 - extent.low.x,
          room.low.y + (room.height() - extent.height()) / 2 - extent.low.y};
}

Fit fit_lengths(const drawings::Box& room, const SheetRequest& request, double at_most,
                const std::function<drawings::Box(const Scale&)>& extent_at) {
  const Fit largest = descend(largest_length_scale(at_most), room, largest_length_scale, extent_at);
  if (!request.scale) return largest;
  const Scale asked = length_scale(*request.scale);
  const drawings::Box extent = extent_at(asked);
  if (!fits(extent, room)) {
    throw DoesNotFit(format_words(
        "at scale {} the figure takes {:.0f} x {:.0f} mm, but this sheet has {:.0f} x {:.0f} mm for it; {} would fit",
        "in scala {} la figura occupa {:.0f} x {:.0f} mm, ma questa tavola ne ha {:.0f} x {:.0f}; andrebbe bene {}",
        drawings::plain(asked.caption), extent.width(), extent.height(), room.width(), room.height(),
        drawings::plain(largest.scale.caption)));
  }
  return Fit{asked, origin_in(room, extent)};
}

}  // namespace epure
