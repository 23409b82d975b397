#include "exercises/gear-pair/wheels_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/faults.h"
#include "exercises/kit/panels/edge.h"

namespace epure::gear_pair {
namespace {

using View = WheelsPanel::View;

constexpr double degree = std::numbers::pi / 180;
constexpr double smallest_module = 0.8;  // mm of paper: below it teeth are no longer seen
constexpr double outlined_thin = 2.5;    // mm: teeth of smaller modules have thin outlines
constexpr double coarse = 0.03;          // mm: a sixth of the outlines of small teeth, of which there are many
constexpr double least_room = 9;         // mm of paper, of a root circle that holds the sense of rotation
constexpr double air = 4;                // mm
constexpr double beside = 10;            // mm from the largest wheel to the dimension of the centre distance

// Of the body, teeth included; no rack.
double outer_radius(const Pair& pair, int wheel) {
  return pair.is_ring(wheel) ? pair("r_root_", wheel) + pair.rim() : pair("r_tip_", wheel);
}

class WheelsPicture {
 public:
  WheelsPicture(const Pair& pair, View view, Plot& plot, const drawings::Box& room, Language language)
      : pair_(pair),
        view_(view),
        plot_(plot),
        room_(room),
        language_(language),
        teeth_(pair, coarse / plot.scale().mm_per_unit) {}

  void draw() const {
    for (const int wheel : {2, 1}) {
      draw_circles(wheel);
      draw_body(wheel);
    }
    draw_line_of_centres();
    draw_line_of_action();
    for (const int wheel : {1, 2}) {
      if (pair_.is_rack(wheel) || !inside(pair_.O(wheel))) continue;
      draw_radii(wheel);
      draw_rotation(wheel);
    }
    draw_centre_distance();
    mark_colliding_tips(plot_, pair_, language_);
  }

  // The circles that roll on each other, as far as the teeth alone say which they are.
  void draw_given() const {
    for (const int wheel : {2, 1})
      if (!pair_.is_shifted()) draw_pitch_circle(wheel);
    draw_line_of_centres();
    for (const int wheel : {1, 2})
      if (pair_.is_placed(wheel) && !pair_.is_rack(wheel) && inside(pair_.O(wheel))) draw_centre(wheel);
  }

 private:
  bool inside(const Place& P) const { return is_in(room_, plot_, P); }
  double on_paper(double length) const { return length * plot_.scale().mm_per_unit; }
  double mm() const { return 1 / plot_.scale().mm_per_unit; }

  void circle(int wheel, double radius, Meaning meaning) const {
    plot_.cycle({.centre = pair_.O(wheel), .radius = radius}, meaning);
  }
  void level(double y, Meaning meaning) const {
    plot_.cycle({.centre = {}, .on_line = Place{0, y}, .along = {1, 0}}, meaning);
  }

  void draw_body(int wheel) const {
    const bool thin = on_paper(pair_.m()) < outlined_thin;
    if (view_ != View::circles && teeth_.has(wheel)) {
      teeth_.tint(plot_, wheel, INFINITY);
      teeth_.draw(plot_, wheel, thin ? Meaning::plate : Meaning::link);
    } else if (pair_.is_rack(wheel)) {
      level(pair_.tip_at_mesh(wheel).y, Meaning::link);
    } else {
      circle(wheel, pair_("r_tip_", wheel), Meaning::link);
    }
    if (pair_.is_rack(wheel)) level(pair_.root_at_mesh(wheel).y + pair_.rim(), Meaning::link);
    if (pair_.is_ring(wheel)) circle(wheel, outer_radius(pair_, wheel), Meaning::link);
  }

  void draw_circles(int wheel) const {
    if (pair_.is_rack(wheel)) return draw_pitch_circle(wheel);
    if (view_ == View::circles) circle(wheel, pair_("r_root_", wheel), Meaning::construction);
    if (on_paper(pair_.m()) >= 1.5) circle(wheel, pair_("r_base_", wheel), Meaning::second_locus);
    draw_pitch_circle(wheel);
  }
  void draw_pitch_circle(int wheel) const {
    if (pair_.is_rack(wheel)) return level(0, Meaning::axis);
    circle(wheel, pair_("r_w_", wheel), Meaning::axis);
  }
  void draw_line_of_centres() const {
    const double x = plot_.at({0, 0}).x;
    plot_.segment(plot_.from_paper({x, room_.low.y}), plot_.from_paper({x, room_.high.y}), Meaning::axis);
  }

  void draw_line_of_action() const {
    if (!pair_.has_contact()) return;
    constexpr double beyond = 8;  // mm
    plot_.long_segment(pair_.at(*pair_.A), pair_.at(*pair_.E), beyond, Meaning::construction);
    plot_.segment(pair_.at(*pair_.A), pair_.at(*pair_.E), Meaning::locus, "AE");
    plot_.label("$P_{0}$", {0, 0});
  }

  // From the centre away from the mesh, so that the lines meet no teeth in contact.
  void draw_radii(int wheel) const {
    struct Radius {
      const char *index, *name;
      double direction;
    };
    const bool shifted = pair_.is_shifted(), roomy = on_paper(pair_("r_root_", wheel)) > 36;
    const std::array radii{Radius{"a", "r_tip_", 207}, Radius{"b", "r_base_", 239},
                           Radius{shifted ? "w" : "", shifted ? "r_w_" : "r", 301}, Radius{"f", "r_root_", 333}};
    const Place& O = pair_.O(wheel);
    plot_.measures(on("r_w_", wheel), O, {0, 0});
    for (const Radius& radius : radii) {
      const double angle = towards(wheel, radius.direction) * degree, r = pair_(radius.name, wheel);
      const Place end = O + Arrow2{r * std::cos(angle), r * std::sin(angle)};
      if (!inside(end)) continue;
      const std::string text = on(std::string("$r_{") + radius.index, wheel) + "}$ = " + in_mm(r).in(language_);
      plot_.mark(drawings::Arrow{plot_.at(O), plot_.at(end), Meaning::dimension, {}});  // of a radius: one head
      if (roomy)
        plot_.onto().sheet.figure.labels.push_back({.text = text, .at = plot_.at(O), .to = plot_.at(end)});
      else
        name_outside(text, wheel, end);
      plot_.measures(on(radius.name, wheel), O, end);
    }
  }

  // Wheel 1 shows its radii below its centre, wheel 2 above, as a ring below; wheel 1 in a ring to the sides, where
  // the ring's own do not pass, unless it is so small that these begin far below it.
  double towards(int wheel, double direction) const {
    if (wheel == 2) return pair_.is_ring() ? direction : direction - 180;
    if (!pair_.is_ring() || is_tiny(1)) return direction;
    return 180 + (direction < 270 ? (direction - 223) * 0.8 : 180 + (direction - 317) * 0.8);
  }

  // What has no room within is led out beyond the teeth.
  void name_outside(const std::string& text, int wheel, const Place& end) const {
    const Place& O = pair_.O(wheel);
    const double out = (pair_("r_tip_", wheel) + 5 * mm()) / distance(O, end);
    const Place outside = O + out * (end - O);
    plot_.segment(end, outside, Meaning::dimension);
    plot_.label(text, outside, O);
  }

  // There is no room between the hinge and the teeth.
  bool is_tiny(int wheel) const { return on_paper(pair_("r_root_", wheel)) < least_room; }

  void draw_centre(int wheel) const {
    const Place& O = pair_.O(wheel);
    const std::string letters = on("$O_{", wheel) + "}$";
    plot_.hinge(O);
    if (is_tiny(wheel))
      name_outside(letters, wheel, {O.x + mm(), O.y});
    else
      plot_.label(letters, O);
  }
  void draw_rotation(int wheel) const {
    const double up = wheel == 1 ? 90 * degree : 270 * degree, down = up + 180 * degree;
    draw_centre(wheel);
    if (is_tiny(wheel)) {
      draw_sense(plot_, pair_, wheel, on_paper(pair_("r_tip_", wheel)) + 10, down, 20 * degree);
    } else {
      draw_sense(plot_, pair_, wheel, std::clamp(0.45 * on_paper(pair_("r_root_", wheel)), 6.0, 16.0), up,
                 35 * degree);
    }
  }

  void draw_centre_distance() const {
    if (pair_.is_rack() || view_ == View::one_whole || !inside(pair_.O(1)) || !inside(pair_.O(2))) return;
    const double offset = on_paper(std::max(outer_radius(pair_, 1), outer_radius(pair_, 2))) + beside;
    const Place &from = pair_.O(pair_.is_ring() ? 2 : 1), &to = pair_.O(pair_.is_ring() ? 1 : 2);
    plot_.mark(drawings::Dimension{plot_.at(from), plot_.at(to), offset,
                                   "$a$ = " + in_mm(pair_.s["centre_distance"]).in(language_)});
    plot_.measures("centre_distance", from, to);
  }

  const Pair& pair_;
  View view_;
  Plot& plot_;
  drawings::Box room_;
  Language language_;
  Teeth teeth_;
};

}  // namespace

// 40 mm of paper for a module.
double WheelsPanel::reach() const { return 25 * pair_.m(); }

drawings::Box WheelsPanel::extent_of(View view, const Scale& scale) const {
  const int first = pair_.of.kind == geometry::PairKind::external && pair_.of.z2 < pair_.of.z1 ? 2 : 1;
  Extent extent;
  for (const int wheel : {first, 3 - first}) {
    if (view == View::one_whole && wheel != first) {
      const double far = 7 * pair_.m() + 12 / scale.mm_per_unit;  // of the other, beyond the pitch point
      extent.include(scale, {0, first == 1 ? far : -far});
    } else if (pair_.is_rack(wheel)) {
      extent.include(scale, {0, pair_.root_at_mesh(wheel).y + pair_.rim()}, air);
    } else {
      const Place& O = pair_.O(wheel);
      const double r = outer_radius(pair_, wheel);
      extent.include(scale, {O.x - r, O.y - r}, air);
      extent.include(scale, {O.x + r, O.y + r}, air);
    }
  }
  drawings::Box box = extent.box();
  if (!pair_.is_rack() && view != View::one_whole) box.low.x -= beside + air;
  return box;
}

void WheelsPanel::choose_view(const drawings::Box& whole_room, const SheetRequest& request) {
  const auto scale_of = [&](View view) -> double {  // 0: it does not fit
    try {
      return fit_lengths(whole_room, request, 1000 / reach(),
                         [&](const Scale& scale) { return extent_of(view, scale); })
          .scale.mm_per_unit;
    } catch (const DoesNotFit&) {
      return 0;
    }
  };
  const double whole = scale_of(View::both_whole), one = scale_of(View::one_whole);
  const bool whole_shows_teeth = whole * pair_.m() >= smallest_module, one_does = one * pair_.m() >= smallest_module;
  view_ = whole_shows_teeth ? View::both_whole : one_does || whole == 0 ? View::one_whole : View::circles;
}

void WheelsPanel::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  WheelsPicture(pair_, view_, plot, room, language).draw_given();
}

std::vector<drawings::Block> WheelsPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  WheelsPicture(pair_, view_, plot, room, language).draw();
  if (view_ == View::both_whole || pair_.is_rack()) return {};
  const Words why =
      view_ == View::one_whole
          ? Words{"The other wheel is shown as far as the sheet reaches: whole, its teeth could not be seen.",
                  "L'altra ruota è mostrata fin dove arriva il foglio: intera, i denti non si vedrebbero."}
          : Words{"At this scale teeth cannot be seen: tip, pitch and root circles stand for them (ISO 2203).",
                  "A questa scala i denti non si vedono: li rappresentano le circonferenze di testa, primitiva e di "
                  "fondo (ISO 2203)."};
  return {drawings::Paragraph{why.in(language)}};
}

}  // namespace epure::gear_pair
