// How far the drive of a linkage can go from where it is, the others at rest: until a group of links is stretched or
// folded, which is a zero of from_limit (carried_out.h), a function of the drive without a root in it.
//
// Proved: over intervals from where the drive is on all groups have room, until in one interval the first that has
// none has one zero: its slope keeps its sign, it has unlike signs at the ends. That is closed in by interval Newton
// steps. What comes after that group is looked at up to the zero itself, with the root that vanishes there told.
#pragma once

#include <optional>

#include "geometry/linkages/carried_out.h"
#include "geometry/linkages/every_place.h"

namespace epure::geometry {

// Where the drive stops, and the step whose group stops it.
template <class T>
struct DriveEnd {
  std::size_t step;
  T at;  // of a turned link its angle in radians, on from where it is; else the way in metres
};

class DriveRange {
 public:
  // The linkage and the steps must outlive it. Throws Impossible as EveryPlace does; where gears mesh, and other
  // drives than this one turn them.
  DriveRange(const Linkage& linkage, const std::vector<Step>& steps, int drive);

  // None: a turned link goes right round; a point or a cylinder goes as far as `farthest`. In a scope of
  // Arithmetic<Bounded>. Throws NotClosed where it does not close where it is; Undecided where a group hardly has
  // room, several come to their limit at once, or two guides become parallel.
  std::optional<DriveEnd<Bounded>> end(bool is_forward) const;
  // A cylinder has no length below zero; a point may go so far that all links in one line would not be as long.
  double farthest(bool is_forward) const;
  double now() const;

  // The same end, with as many bits as the scope of Arithmetic<Deep> has.
  DriveEnd<Deep> closed_in(const DriveEnd<Bounded>& end) const;
  // The linkage there.
  template <class T>
  LinkagePosition<T> position_at(const DriveEnd<T>& end) const {
    return CarriedOut<T>(linkage_, steps_)
        .position_before(steps_.size(), drive_at(end.at), RoomTold<T>{end.step, T(0)});
  }
  template <class T>
  DriveAt<T> drive_at(const T& at) const;

 private:
  friend class WayToEnd;
  bool turns() const { return std::holds_alternative<TurnedLink>(drive()); }
  const Drive& drive() const { return linkage_.drives[static_cast<std::size_t>(drive_)]; }

  const Linkage& linkage_;
  const std::vector<Step>& steps_;
  int drive_, turns_ = 1;
};

template <class T>
DriveAt<T> DriveRange::drive_at(const T& at) const {
  if (!turns()) return {drive_, {T(1), T(0)}, at};
  const T part = quotient(at, T(turns_));
  return {drive_, {cosine_of_angle(part), sine_of_angle(part)}, T(0), turns_};
}

}  // namespace epure::geometry
