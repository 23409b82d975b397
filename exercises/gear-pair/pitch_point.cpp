// Sheet 1: the mesh around the pitch point, with all that the construction leaves on the paper.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/exercise.h"
#include "exercises/gear-pair/fault_marks.h"
#include "exercises/gear-pair/pitch_point_text.h"
#include "exercises/gear-pair/teeth.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
constexpr double letters_room = 9;     // mm around a point
constexpr double largest_module = 40;  // mm of paper
constexpr double tinted_rim = 1.5;     // modules inwards of the root circle
constexpr double off_teeth = 2.7;      // modules from the line of action to what is measured along it

std::vector<double> places_shown(const DrawnPair& pair) {
  std::vector<double> all{0};
  for (const auto& xi : {pair.A, pair.E})
    if (xi && is_near(pair, *xi)) all.push_back(*xi);
  if (is_near(pair, pair.T1)) all.push_back(pair.T1);
  if (pair.T2 && is_near(pair, *pair.T2)) all.push_back(*pair.T2);
  return all;
}

drawings::Box extent_of(const DrawnPair& pair, const Scale& scale) {
  Extent extent;
  for (const double xi : places_shown(pair)) extent.include(scale, pair.at(xi), letters_room);
  const double m = pair.m();
  for (const double side : {-1.0, 1.0}) {
    extent.include(scale, {side * 1.3 * pair.pitch, side * 4 * m});
    extent.include(scale, {-side * 1.3 * pair.pitch, side * 4 * m});
  }
  return extent.box();
}

class PitchPointSheet {
 public:
  PitchPointSheet(DrawnSheet& onto, const DrawnPair& pair, const Fit& fit, const drawings::Box& room)
      : onto_(onto),
        pair_(pair),
        plot_(onto, fit.origin, fit.scale),
        room_(room),
        teeth_(pair, pair.shown_contact(), fit.scale.mm_per_unit) {}

  const Teeth& teeth() const { return teeth_; }

  void draw(Language language) {
    for (const int wheel : {2, 1}) teeth_.draw(plot_, wheel, Meaning::link, tinted_rim * pair_.m());
    draw_circles();
    draw_line_of_centres(language);
    draw_line_of_action(language);
    draw_contact(language);
    draw_heights(language);
    measure_clearances();
    mark_faults(plot_, pair_, teeth_, language);
    number_steps();
  }

 private:
  const DrawnWheel& wheel(int number) const { return number == 1 ? pair_.wheel1 : *pair_.wheel2; }
  const Place& centre(int number) const { return number == 1 ? pair_.O1 : *pair_.O2; }
  // Counter-clockwise from +x, of P0 seen from the centre.
  double upright(int number) const { return number == 2 && !pair_.is_ring() ? -right_angle : right_angle; }

  // The heights are measured from the reference circles even so.
  bool works_off_reference() const { return pair_.alpha != pair_.alpha_w; }

  void draw_circles() {
    for (const int number : {1, 2}) {
      if (number == 2 && pair_.is_rack()) {
        draw_rack_lines();
        continue;
      }
      const geometry::WheelCircles<double>& c = wheel(number).circles;
      const auto circle = [&](double radius, Meaning meaning) {
        plot_.cycle({.centre = centre(number), .radius = radius}, meaning);
      };
      circle(c.r_tip, Meaning::construction);
      circle(c.r_root, Meaning::construction);
      circle(c.r_b, Meaning::second_locus);
      circle(c.r_w, Meaning::axis);
      if (works_off_reference()) circle(c.r, Meaning::construction);
      name_circles(number);
    }
  }

  void draw_rack_lines() {
    const geometry::RackLines lines = geometry::rack_lines(pair_.of);
    const auto line = [&](double y, Meaning meaning) {
      plot_.cycle({.centre = {}, .on_line = Place{0, y}, .along = {1, 0}}, meaning);
    };
    line(CGAL::to_double(lines.tip), Meaning::construction);
    line(CGAL::to_double(lines.root), Meaning::construction);
    line(0, Meaning::axis);
  }

  // Where the circle leaves the room on the side, or none.
  std::optional<Place> at_edge(int number, double radius, bool right) const {
    const drawings::Point O = plot_.at(centre(number));
    const double r = radius * plot_.scale().mm_per_unit, x = (right ? room_.high.x - 9 : room_.low.x + 9) - O.x;
    if (std::abs(x) >= r) return {};
    const double y = O.y + (upright(number) > 0 ? 1 : -1) * std::sqrt((r - x) * (r + x));
    if (y < room_.low.y + 3 || y > room_.high.y - 3) return {};
    return plot_.from_paper({O.x + x, y});
  }

  void name_circles(int number) {
    const geometry::WheelCircles<double>& c = wheel(number).circles;
    const auto name = [&](const char* index, double radius, Meaning ink) {
      const auto at = at_edge(number, radius, number == 1);
      if (!at) return;
      // Outside the circle. Not seen from its centre, which may lie kilometres off the paper.
      const drawings::Point p = plot_.at(*at), inwards{p.x, p.y + (upright(number) > 0 ? -1 : 1)};
      onto_.sheet.figure.labels.push_back(
          {.text = fmt::format("$r_{{{}{}}}$", index, number), .at = p, .ink = ink, .away_from = inwards, .size = 3});
    };
    name("a", c.r_tip, Meaning::text);
    name("f", c.r_root, Meaning::text);
    name("b", c.r_b, Meaning::second_locus);
    name(works_off_reference() ? "w" : "", c.r_w, Meaning::text);
    if (works_off_reference()) name("", c.r, Meaning::text);
  }

  void draw_line_of_centres(Language language) {
    const Place above = plot_.from_paper({plot_.at({0, 0}).x, room_.high.y}),
                below = plot_.from_paper({plot_.at({0, 0}).x, room_.low.y});
    plot_.segment(below, above, Meaning::axis);
    std::string off_above, off_below;
    for (const int number : {1, 2}) {
      if (number == 2 && pair_.is_rack()) continue;
      const std::string O = fmt::format("$O_{{{}}}$", number);
      if (inside(centre(number))) {
        plot_.hinge(centre(number));
        plot_.label(O, centre(number));
      } else {
        std::string& off = upright(number) < 0 ? off_above : off_below;
        off += (off.empty() ? "" : ", ") + O;
      }
    }
    constexpr double from_border = 4;  // mm
    point_to(off_above, {plot_.at(above).x, room_.high.y - from_border}, language);
    point_to(off_below, {plot_.at(below).x, room_.low.y + from_border}, language);
  }

  // Names the centres that lie off the paper on this side.
  void point_to(const std::string& centres, drawings::Point end, Language language) {
    if (centres.empty()) return;
    plot_.small_label((language == Language::english ? "to " : "verso ") + centres, plot_.from_paper(end),
                      plot_.from_paper({end.x - 1, end.y}));
  }

  bool inside(const Place& P) const {
    const drawings::Point p = plot_.at(P);
    return p.x >= room_.low.x && p.x <= room_.high.x && p.y >= room_.low.y && p.y <= room_.high.y;
  }

  void draw_line_of_action(Language language) {
    std::vector<double> shown = places_shown(pair_);
    const auto [first, last] = std::minmax_element(shown.begin(), shown.end());
    constexpr double beyond = 10;  // mm
    plot_.long_segment(pair_.at(*first), pair_.at(*last), beyond, Meaning::construction);
    const Place P0{0, 0};
    // The common tangent, from which the pressure angle is drawn.
    const double reach = 34 / plot_.scale().mm_per_unit;
    plot_.segment({-reach, 0}, {reach / 2, 0}, Meaning::construction);
    plot_.mark(drawings::AngleMark{plot_.at(P0), 30, std::numbers::pi - pair_.alpha_w, std::numbers::pi});
    const double middle = std::numbers::pi - pair_.alpha_w / 2;
    plot_.label(pressure_angle(pair_, language),
                plot_.from_paper({plot_.at(P0).x + 30 * std::cos(middle), plot_.at(P0).y + 30 * std::sin(middle)}),
                P0);
    draw_tangent_point(1, pair_.T1);
    if (pair_.T2) draw_tangent_point(2, *pair_.T2);
    plot_.dot(P0);
    plot_.label("$P_{0}$", P0);
  }

  void draw_tangent_point(int number, double xi) {
    const Place T = pair_.at(xi);
    if (!inside(T)) return;
    plot_.segment(T, centre(number), Meaning::construction);
    plot_.right_angle(T, {0, 0}, centre(number));
    plot_.dot(T);
    plot_.label(fmt::format("$T_{{{}}}$", number), T, centre(number));
    if (number == 1 || !pair_.is_ring())
      plot_.measures(number == 1 ? "interference_limit_approach" : "interference_limit_recess", {0, 0}, T);
  }

  void draw_contact(Language language) {
    if (!pair_.has_contact()) return;
    const Place A = pair_.at(*pair_.A), E = pair_.at(*pair_.E), P0{0, 0};
    draw_path();
    for (const auto& [P, name] : {std::pair{A, "$A$"}, std::pair{E, "$E$"}}) {
      plot_.dot(P, Meaning::locus);
      plot_.label(name, P, {}, Meaning::locus);
    }
    plot_.measures("path_of_contact", A, E);
    if (*pair_.A < 0) plot_.measures("path_of_approach", P0, A);
    if (*pair_.E > 0) plot_.measures("path_of_recess", P0, E);
    draw_arcs();
    draw_single_contact();
    draw_dimensions(language);
  }

  // AE, dashed where no flanks touch, and the flanks at the ends of what is left.
  void draw_path() {
    const DrawnPath& path = pair_.path;
    const double from = path.touches ? path.begins.xi : *pair_.E, to = path.touches ? path.ends.xi : *pair_.E;
    if (from > *pair_.A) plot_.segment(pair_.at(*pair_.A), pair_.at(from), Meaning::alternative);
    if (to < *pair_.E) plot_.segment(pair_.at(to), pair_.at(*pair_.E), Meaning::alternative);
    if (!path.touches) return;
    plot_.segment(pair_.at(from), pair_.at(to), Meaning::locus, path.is_whole() ? "AE" : "contact");
    for (const DrawnPath::End& end : {path.begins, path.ends}) {
      for (const int number : {1, 2}) teeth_.draw_flank(plot_, number, end.xi);
      if (end.by == DrawnPath::By::tip) continue;
      plot_.dot(pair_.at(end.xi), Meaning::locus);
      plot_.label("$" + end.name + "$", pair_.at(end.xi), {}, Meaning::locus);
    }
  }

  // Where the flank that touches at ξ cuts its pitch circle: the wheel has turned by ξ/r_b since P0.
  double turn(int number, double xi) const {
    return upright(number) + (upright(number) > 0 ? 1 : -1) * xi / wheel(number).circles.r_b;
  }
  Place arc_end(int number, double xi) const {
    if (number == 2 && pair_.is_rack()) return {-xi / std::cos(pair_.alpha_w), 0};
    const double r = wheel(number).circles.r_w, angle = turn(number, xi);
    return {centre(number).x + r * std::cos(angle), centre(number).y + r * std::sin(angle)};
  }

  // Pitch circle 2 rolls on pitch circle 1: the arcs are equal, and 1/cos α_w of the path.
  void draw_arcs() {
    for (const int number : {1, 2}) {
      const Place N1 = arc_end(number, *pair_.A), N2 = arc_end(number, *pair_.E);
      if (number == 2 && pair_.is_rack()) {
        plot_.segment(N1, N2, Meaning::locus, "arc_of_action_2");
        plot_.measures("arc_of_action", N1, N2);
        if (*pair_.A < 0) plot_.measures("arc_of_approach", N1, {0, 0});
        if (*pair_.E > 0) plot_.measures("arc_of_recess", {0, 0}, N2);
      } else {
        const auto [from, to] = std::minmax({turn(number, *pair_.A), turn(number, *pair_.E)});
        draw_arc(plot_, centre(number), wheel(number).circles.r_w, from, to, Meaning::locus,
                 number == 1 ? "arc_of_action_1" : "arc_of_action_2");
      }
      const std::string prime = number == 1 ? "" : "'";
      // On the side away from the other wheel's N, with which it must not be taken for one.
      for (const auto& [xi, index] : {std::pair{*pair_.A, "1"}, std::pair{*pair_.E, "2"}}) {
        const Place N = arc_end(number, xi);
        plot_.dot(N, Meaning::locus);
        plot_.label("$N" + prime + "_{" + index + "}$", N, arc_end(3 - number, xi), Meaning::locus);
      }
    }
  }

  // Between B and D one pair of teeth carries alone.
  void draw_single_contact() {
    if (!pair_.has_single_contact()) return;
    for (const auto& [xi, name] : {std::pair{pair_.B(), "$B$"}, std::pair{pair_.D(), "$D$"}}) {
      plot_.dot(pair_.at(xi), Meaning::locus);
      plot_.label(name, pair_.at(xi), {}, Meaning::locus);
    }
    plot_.measures("base_pitch", pair_.at(pair_.path.begins.xi), pair_.at(pair_.D()));
  }

  void draw_dimensions(Language language) {
    const double off = off_teeth * pair_.m() * plot_.scale().mm_per_unit;
    const auto dimension = [&](double from, double to, double offset, const std::string& name) {
      plot_.mark(drawings::Dimension{plot_.at(pair_.at(from)), plot_.at(pair_.at(to)), offset,
                                     fmt::format("{} = {}", name, figures(1000 * (to - from), 4, language))});
    };
    if (*pair_.A < 0 && *pair_.E > 0) {
      dimension(*pair_.A, 0, -off, "$P_{0}A$");
      dimension(0, *pair_.E, -off, "$P_{0}E$");
    }
    if (pair_.true_contact_ratio() <= 1) return;
    dimension(pair_.path.begins.xi, pair_.D(), off_base_pitch(), "$p_{b}$");
  }

  // Paper millimetres from the line of action to the dimension of the base pitch: below, in wheel 1, when its body is
  // wide enough; else above the other two dimensions.
  double off_base_pitch() const {
    const double off = off_teeth * pair_.m() * plot_.scale().mm_per_unit;
    return pair_.wheel1.circles.r_root > 2.5 * pair_.m() ? off : -off - 10;
  }

  // Addendum and dedendum of wheel 1 along the middle of a space beside the mesh.
  void draw_heights(Language language) {
    if (!teeth_.has(1)) return;
    const geometry::WheelCircles<double>& c = pair_.wheel1.circles;
    const double side = pair_.is_ring() ? -1 : 1;  // away from the letters of the mesh
    for (const double space : {2.5 * side, 1.5 * side, -1.5 * side, -2.5 * side}) {
      const Arrow2 out = teeth_.direction_of_tooth(1, space);
      const auto at = [&](double r) -> Place { return {pair_.O1.x + r * out.x, pair_.O1.y + r * out.y}; };
      if (out.y < 0.3 || !inside(at(c.r_tip)) || !inside(at(c.r_root))) continue;
      const auto height = [&](double from, double to, const std::string& name, const std::string& quantity) {
        plot_.mark(drawings::Dimension{plot_.at(at(from)), plot_.at(at(to)), 0,
                                       fmt::format("{} = {}", name, figures(1000 * (to - from), 4, language))});
        plot_.measures(quantity, at(from), at(to));
      };
      height(c.r_root, c.r, "$h_{f}$", "dedendum");
      height(c.r, c.r_tip, "$h_{a}$", "addendum");
      plot_.measures("tooth_height", at(c.r_root), at(c.r_tip));
      return;
    }
  }

  // Between tip and root on the line of centres; the letters are in the table.
  void measure_clearances() {
    for (const int number : {1, 2}) {
      const Place tip = pair_.tip_at_mesh(number), root = pair_.root_at_mesh(3 - number);
      if ((number == 1) == (root.y > tip.y)) plot_.measures(number == 1 ? "clearance" : "clearance_2", tip, root);
    }
  }

  // The numbers of the steps in the column. Around P0 there is little room: the line of action and the base pitch
  // have theirs where they come out of the mesh.
  void number_steps() {
    plot_.step(1, {0, 0});
    plot_.step(2, pair_.at(beyond_mesh()));
    if (inside(pair_.at(pair_.T1))) plot_.step(3, pair_.at(pair_.T1));
    if (!pair_.has_contact()) return;
    plot_.step(4, pair_.at(*pair_.A));
    plot_.step(5, pair_.at(pair_.shown_contact()));
    plot_.step(6, arc_end(1, *pair_.A));
    if (!pair_.has_single_contact()) return;
    const drawings::Point D = plot_.at(pair_.at(pair_.D()));
    const double off = off_base_pitch();
    plot_.step(7, plot_.from_paper({D.x - off * pair_.along.y, D.y + off * pair_.along.x}));
  }

  // On the line of action: half-way from E to where it ends, which is T2 when that is on the sheet.
  double beyond_mesh() const {
    const double mm = 1 / plot_.scale().mm_per_unit;
    if (!pair_.has_contact()) return 14 * mm;
    const std::vector<double> shown = places_shown(pair_);
    return std::max(*pair_.E + 12 * mm, (*pair_.E + *std::max_element(shown.begin(), shown.end())) / 2);
  }

  DrawnSheet& onto_;
  const DrawnPair& pair_;
  Plot plot_;
  drawings::Box room_;
  Teeth teeth_;
};

}  // namespace

void draw_pitch_point(DrawnSheet& onto, const DrawnPair& pair, const Differences& differences,
                      const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const Fit fit = fit_lengths(room, request, largest_module / pair.m(),
                              [&](const Scale& scale) { return extent_of(pair, scale); });
  PitchPointSheet sheet(onto, pair, fit, room);
  sheet.draw(request.language);
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {fit.scale}, request);
  add_text(onto, pair, sheet.teeth(), request.language);
  add_differences(onto, differences, {"path_of_approach"}, request.language);
}

}  // namespace epure::gear_pair
