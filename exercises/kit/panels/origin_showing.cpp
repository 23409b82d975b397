#include "exercises/kit/panels/origin_showing.h"

#include <algorithm>

namespace epure {
namespace {

// Along one axis: the origin for which `all` stands in the middle of the room, or, when it is too large, covers it
// while `needed` stays inside.
double shifted(double room_low, double room_high, double needed_low, double needed_high, double all_low,
               double all_high) {
  const double middle = (room_low + room_high) / 2;
  if (all_high - all_low <= room_high - room_low) return middle - (all_low + all_high) / 2;
  const double least = room_low - needed_low, most = room_high - needed_high;  // what is needed stays inside
  const double covers_least = room_high - all_high, covers_most = room_low - all_low;
  const double wanted = std::clamp(middle - (needed_low + needed_high) / 2, covers_least, covers_most);
  return std::clamp(wanted, std::min(least, most), std::max(least, most));
}

}  // namespace

drawings::Point origin_showing(const drawings::Box& all, const drawings::Box& needed, const drawings::Box& room) {
  return {shifted(room.low.x, room.high.x, needed.low.x, needed.high.x, all.low.x, all.high.x),
          shifted(room.low.y, room.high.y, needed.low.y, needed.high.y, all.low.y, all.high.y)};
}

}  // namespace epure
