#include "geometry/linkages/drive_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/numbers/enclosure.h"

namespace epure::geometry {
namespace {

Bounded between(double one, double other) { return {std::min(one, other), std::max(one, other)}; }

[[noreturn]] void refuse_open_end() {
  throw Undecided("where the drive stops: a group hardly has room there, or several come to their limit at once",
                  "dove si fermi il movente: lì un gruppo ha appena gioco, o più d'uno arriva insieme al suo limite");
}

// All lengths of the links one after the other.
double length_of_all(const Linkage& linkage) {
  double sum = 0;
  for (const Link& link : linkage.links) {
    double most = 0;
    for (const LinkPoint& p : link.points)
      most = std::max(most, std::hypot(CGAL::to_double(p.at.x), CGAL::to_double(p.at.y)));
    for (const LinkLine& l : link.lines)
      most = std::max(most, std::hypot(CGAL::to_double(l.through.x), CGAL::to_double(l.through.y)));
    sum += 2 * most;
  }
  for (const Drive& drive : linkage.drives)
    if (const auto* cylinder = std::get_if<Stretched>(&drive)) sum += CGAL::to_double(cylinder->length);
  return sum;
}

// How much room a step has with the drive there, and how that changes with it.
template <class T>
T room_at(const DriveRange& range, const CarriedOut<T>& carried_out, std::size_t step, const T& at) {
  return carried_out.from_limit(step, carried_out.position_before(step, range.drive_at(at)));
}

}  // namespace

// One way, from where the drive is.
class WayToEnd {
 public:
  using Tangent = Taylor<Bounded, 1>;

  explicit WayToEnd(const DriveRange& range)
      : range_(range), values_(range.linkage_, range.steps_), slopes_(range.linkage_, range.steps_) {}

  std::optional<DriveEnd<Bounded>> operator()(double from, double to) {
    look(from, to);
    return found_;
  }

 private:
  static constexpr int most_looks = 20000;
  // Parted elsewhere than where mechanisms have a limit.
  static constexpr double part = 0.47, crumb = 0x1p-46;

  std::size_t count() const { return range_.steps_.size(); }

  // Ever farther from where the drive is, until an end is found.
  void look(double near, double far) {
    if (++looks_ > most_looks || std::abs(far - near) < crumb * std::max(1.0, std::abs(near))) refuse_open_end();
    const Bounded all = between(near, far);
    const std::optional<std::size_t> open = first_without_room(range_.drive_at(all), {});
    if (!open || ends_within(*open, near, far)) return;
    const double middle = near + part * (far - near);
    look(near, middle);
    if (!found_) look(middle, far);
  }

  // Of the steps that are not proved to have room over all of it the first.
  std::optional<std::size_t> first_without_room(const DriveAt<Bounded>& all,
                                                const std::optional<RoomTold<Bounded>>& told) const {
    const auto has_room = [&](std::size_t k, const LinkagePosition<Bounded>& at) {
      return (told && told->step == k) || sign(values_.from_limit(k, at)) == Sign::positive;
    };
    std::size_t k = 0;
    try {
      const LinkagePosition<Bounded> whole = values_.position_before(count(), all, told);
      while (k < count() && has_room(k, whole)) ++k;
    } catch (const Undecided&) {
      while (has_room(k, values_.position_before(k, all, told)) && is_placed(k, all, told)) ++k;
    }
    return k < count() ? std::optional(k) : std::nullopt;
  }
  bool is_placed(std::size_t k, const DriveAt<Bounded>& all, const std::optional<RoomTold<Bounded>>& told) const {
    try {
      values_.position_before(k + 1, all, told);
      return true;
    } catch (const Undecided&) {
      return false;
    }
  }

  // Whether the room of the step has one zero there, and nothing else stops the drive before.
  bool ends_within(std::size_t step, double near, double far) {
    try {
      const Sign slope = sign(room_at(range_, slopes_, step, Tangent::parameter(between(near, far))).c[1]);
      const Sign outwards = far > near ? Sign::negative : Sign::positive;
      if (slope != outwards || sign(room_at(range_, values_, step, Bounded(near))) != Sign::positive ||
          sign(room_at(range_, values_, step, Bounded(far))) != Sign::negative)
        return false;
      return is_free_up_to(step, near, closed_in(step, between(near, far)), far > near);
    } catch (const Undecided&) {
      return false;
    }
  }

  // What comes after the step, up to its limit: an earlier end is taken instead.
  bool is_free_up_to(std::size_t step, double near, const Bounded& limit, bool is_forward) {
    for (const double shorter : {0x1p-12, 0x1p-24, 0x1p-36}) {
      const double away = shorter * std::max(1.0, std::abs(near)),
                   last = is_forward ? limit.inf() - away : limit.sup() + away;
      if (is_forward ? last <= near : last >= near) continue;
      const Bounded rest = between(last, is_forward ? limit.sup() : limit.inf()),
                    room = room_at(range_, values_, step, Bounded(last));
      if (sign(room) != Sign::positive) return false;
      const RoomTold<Bounded> told{step, Bounded(0, root(room).sup())};
      bool closes_to_the_end = true;
      try {
        if (first_without_room(range_.drive_at(rest), told)) continue;
      } catch (const Impossible&) {  // a group after it stops before
        closes_to_the_end = false;
      }
      look(near, last);
      if (!found_ && closes_to_the_end) found_ = DriveEnd<Bounded>{step, limit};
      return found_.has_value();
    }
    return false;
  }

  Bounded closed_in(std::size_t step, Bounded at) const {
    for (;;) {
      const Bounded middle = midpoint(at),
                    next = middle - quotient(room_at(range_, values_, step, middle),
                                             room_at(range_, slopes_, step, Tangent::parameter(at)).c[1]);
      const double low = std::max(next.inf(), at.inf()), high = std::min(next.sup(), at.sup());
      constexpr double worth_a_step = 0.9;
      if (!(high - low < worth_a_step * (at.sup() - at.inf()))) return at;
      at = Bounded(low, high);
    }
  }

  const DriveRange& range_;
  CarriedOut<Bounded> values_;
  CarriedOut<Tangent> slopes_;
  std::optional<DriveEnd<Bounded>> found_ = {};
  int looks_ = 0;
};

DriveRange::DriveRange(const Linkage& linkage, const std::vector<Step>& steps, int drive)
    : linkage_(linkage), steps_(steps), drive_(drive) {
  if (linkage.drives.size() == 1)
    turns_ = EveryPlace(linkage, steps).turns();
  else if (!linkage.gears.empty())
    throw Impossible("of gears that several drives turn no range is told",
                     "di ingranaggi mossi da più moventi non si dice alcun campo");
}

double DriveRange::now() const {
  if (const auto* turned = std::get_if<TurnedLink>(&drive())) return to_double(turned->angle);
  if (const auto* slid = std::get_if<SlidPoint>(&drive())) return CGAL::to_double(slid->at);
  return CGAL::to_double(std::get<Stretched>(drive()).length);
}

double DriveRange::farthest(bool is_forward) const {
  if (!is_forward && std::holds_alternative<Stretched>(drive())) return 0;
  const double far = turns() ? 2 * std::numbers::pi * turns_ * (1 + 0x1p-50) : length_of_all(linkage_);
  return now() + (is_forward ? far : -far);
}

std::optional<DriveEnd<Bounded>> DriveRange::end(bool is_forward) const {
  return WayToEnd(*this)(now(), farthest(is_forward));
}

DriveEnd<Deep> DriveRange::closed_in(const DriveEnd<Bounded>& end) const {
  using Tangent = Taylor<Deep, 1>;
  const CarriedOut<Deep> values(linkage_, steps_);
  const CarriedOut<Tangent> slopes(linkage_, steps_);
  Deep at = Deep::from_bounded(end.at);
  constexpr int steps = 7;  // each doubles the digits, from some ten to a thousand
  for (int k = 0; k < steps; ++k) {
    const Deep middle = midpoint(at);
    at = middle - quotient(room_at(*this, values, end.step, middle),
                           room_at(*this, slopes, end.step, Tangent::parameter(at)).c[1]);
  }
  return {end.step, at};
}

}  // namespace epure::geometry
