#include "exercises/gear-pair/fault_marks.h"

#include <cmath>

#include "exercises/gear-pair/fault_words.h"

namespace epure::gear_pair {
namespace {

using geometry::Fault;
using Kind = Fault::Kind;

class Marker {
 public:
  Marker(Plot& plot, const DrawnPair& pair, Language language) : plot_(plot), pair_(pair), language_(language) {}

  void mark(const Fault& fault, const Teeth& teeth) const {
    const int wheel = fault.wheel;
    switch (fault.kind) {
      case Kind::undercut:
      case Kind::undercut_by_edge:
        if (teeth.has(wheel)) at(teeth.foot_of_flank(wheel, free_tooth(wheel)), fault.kind);
        break;
      case Kind::pointed:
        if (teeth.has(wheel)) at(teeth.tip_of_tooth(wheel, free_tooth(wheel)), fault.kind);
        break;
      case Kind::pointed_cutter:
        if (teeth.has(1)) mark_cutter(teeth);
        break;
      case Kind::tip_inside_base:
      case Kind::negative_clearance:
        led(pair_.tip_at_mesh(wheel), fault.kind, {-26, wheel == 1 ? 36.0 : -36.0});
        break;
      case Kind::contact_on_fillet:
        wheel == 1 ? led(pair_.at(*pair_.A), fault.kind, {14, -36}) : led(pair_.at(*pair_.E), fault.kind, {-14, 36});
        break;
      case Kind::corner_in_root:
        led(pair_.tip_at_mesh(3 - wheel), fault.kind, {-26, wheel == 2 ? 36.0 : -36.0});
        break;
      case Kind::interference_approach:
        beyond(pair_.T1, *pair_.A, fault.kind);
        break;
      case Kind::interference_recess:
        beyond(*pair_.T2, *pair_.E, fault.kind);
        break;
      case Kind::contact_ratio_below_one:
        break;  // marked by the path that is left, which may be too short where AE is not
      case Kind::tips_collide:
        mark_crossing_of_tips();
        break;
    }
  }

  // Where the next pair of teeth touches, this one has parted.
  void mark_missed_contact() const {
    plot_.segment(pair_.at(pair_.path.ends.xi), pair_.at(pair_.D()), fault_ink);
    led(pair_.at(pair_.D()), Kind::contact_ratio_below_one, {-8, 30});
  }

  // On the side to which the teeth leave: with the crossing at the height y over O1, x² + y² = r_a1² and
  // x² + (y - (O2 - O1))² = r_a2².
  void mark_crossing_of_tips() const {
    const double r1 = pair_.wheel1.circles.r_tip, r2 = pair_.wheel2->circles.r_tip, d = pair_.O2->y - pair_.O1.y;
    const double y = (d * d + (r1 - r2) * (r1 + r2)) / (2 * d), squared = (r1 - y) * (r1 + y);
    if (squared < 0) return;
    for (const double side : {-1.0, 1.0}) {
      const Place Q{side * std::sqrt(squared), pair_.O1.y + y};
      plot_.cross(Q, fault_ink);
      if (side < 0) plot_.label(mark_of(Kind::tips_collide, language_), Q, pair_.O1, fault_ink);
    }
  }

 private:
  void at(const Place& P, Kind kind) const {
    plot_.cross(P, fault_ink);
    plot_.label(mark_of(kind, language_), P, {}, fault_ink);
  }

  // In the midst of the mesh there is no room for words: they stand `away` mm from the place, at the end of a line.
  void led(const Place& P, Kind kind, drawings::Point away) const {
    const drawings::Point p = plot_.at(P);
    const Place end = plot_.from_paper({p.x + away.x, p.y + away.y});
    plot_.cross(P, fault_ink);
    plot_.segment(P, end, Meaning::dimension);
    plot_.label(mark_of(kind, language_), end, P, fault_ink);
  }

  // What should not be needed of the line of action.
  void beyond(double from, double to, Kind kind) const {
    plot_.segment(pair_.at(from), pair_.at(to), fault_ink);
    at(pair_.at(to), kind);
  }

  // Away from the teeth in contact and the letters there: wheel 1's to the left, wheel 2's to the right.
  double free_tooth(int wheel) const { return wheel == 1 || pair_.is_rack() || pair_.is_ring() ? 1 : 2; }

  // At a root of wheel 1: of a small wheel one that opens away from the mesh, where words stand outside its teeth.
  void mark_cutter(const Teeth& teeth) const {
    const double r = pair_.wheel1.circles.r_root;
    const auto root = [&](const Arrow2& out) { return Place{pair_.O1.x + r * out.x, pair_.O1.y + r * out.y}; };
    const Arrow2 aside = teeth.direction_of_tooth(1, std::ceil(static_cast<double>(pair_.of.z1) / 6) + 0.5);
    constexpr double away = 26;  // mm
    const drawings::Point p = plot_.at(root(aside));
    const Place end = plot_.from_paper({p.x + away * aside.x, p.y + away * aside.y});
    if (plot_.shows(end))
      led(root(aside), Kind::pointed_cutter, {away * aside.x, away * aside.y});
    else
      at(root(teeth.direction_of_tooth(1, 1.5)), Kind::pointed_cutter);
  }

  Plot& plot_;
  const DrawnPair& pair_;
  Language language_;
};

}  // namespace

void mark_faults(Plot& plot, const DrawnPair& pair, const Teeth& teeth, Language language) {
  const Marker marker(plot, pair, language);
  for (const Fault& fault : pair.faults)
    if (!fault.undecided) marker.mark(fault, teeth);
  if (pair.has_contact() && pair.path.touches && !pair.path.is_continuous) marker.mark_missed_contact();
}

void mark_colliding_tips(Plot& plot, const DrawnPair& pair, Language language) {
  if (pair.has(Kind::tips_collide)) Marker(plot, pair, language).mark_crossing_of_tips();
}

}  // namespace epure::gear_pair
