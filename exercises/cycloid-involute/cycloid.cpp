// The cycloid as a student draws it: wheel and guide in twelve parts, each point by two arcs. The whole arch, and one
// point of it, larger.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/rolling/rolling_picture.h"
#include "geometry/motion/roulette_divisions.h"

namespace epure::cycloid_involute {
namespace {

using geometry::Deep;

constexpr int explained_part = 4;

// The eleven points within the arch. The twelfth division is the end of the arch: there the arcs touch.
std::vector<Division> parts_of(const Rational& r, double arch_base) {
  return deeply([&] {
    std::vector<Division> found;
    for (int i = 1; i < divisions; ++i) {
      const auto at = geometry::cycloid_division<Deep>(r, {Rational(i, divisions)});
      found.push_back({to_double(at.on_line), to_double(at.on_wheel), to_double(at.M)});
    }
    const Place end{arch_base, 0};
    found.push_back({end, {0, 0}, end});
    return found;
  });
}

// The wheel where it stands at the start, on the origin P₀.
class WheelPanel : public Panel {
 public:
  explicit WheelPanel(const Solution& s)
      : of_(s.givens()), r_(CGAL::to_double(of_.r)), parts_(parts_of(of_.r, s["cycloid.arch_base"])) {}
  double reach() const override { return r_; }

 protected:
  struct Step {  // of the construction
    static constexpr int given = 0, wheel = 1, guide = 2, first_arc = 3, second_arc = 4, meeting = 5;
  };

  const Division& part(int number) const { return parts_[static_cast<std::size_t>(number - 1)]; }
  Place C() const { return {0, r_}; }
  static void draw_guide(Plot& plot, double from, double to) {
    plot.mark(drawings::Ground{plot.at({from, 0}), plot.at({to, 0})});
  }

  Problem of_;
  double r_;
  std::vector<Division> parts_;  // 1..12
  const Place P0_{0, 0};
};

class ArchPanel : public WheelPanel {
 public:
  using WheelPanel::WheelPanel;

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    constexpr double below = 13, above = 5, beside = 1.5;  // mm for letters
    extent.include(-r_ * scale.mm_per_unit - beside, -below);
    extent.include(part(divisions).on_line.x * scale.mm_per_unit + beside, 2 * r_ * scale.mm_per_unit + above);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    draw_guide(plot, -r_, part(divisions).on_line.x);
    plot.circle(C(), r_, Meaning::link);
    plot.cross(C(), Meaning::text);
    plot.label("$C$", C(), P0_);
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override {
    const Place end = part(divisions).on_line;
    plot.in_step(Step::meeting);
    const double deviation = draw_path(plot, {of_.wheel(), {}, {}, {}}, {0, 2 * std::numbers::pi});
    plot.in_step(Step::given);
    draw_guide(plot, -r_, end.x);
    draw_parts(plot);
    plot.in_step(Step::guide);
    // Below the numbers, from P₀ to 12.
    constexpr double below = 11.5;  // mm
    plot.mark(drawings::Dimension{plot.at(P0_), plot.at(end), -below, "$πd$"});
    plot.small_label("XII ≡ 12", end, {end.x, r_});
    plot.in_step(Step::given);
    plot.circle(C(), r_, Meaning::link);
    plot.cross(C(), Meaning::text);
    plot.label("$C$", C(), P0_);
    plot.label("$P_{0}$ ≡ 12′", P0_, C());
    plot.measures("cycloid.arch_base", P0_, end);
    return told_of_curve({"cycloid", "cicloide"},
                         {"$x$ = $r$ ($φ$ − sin $φ$),  $y$ = $r$ (1 − cos $φ$),  $φ$ = $ωt$",
                          "$x$ = $r$ ($φ$ − sen $φ$),  $y$ = $r$ (1 − cos $φ$),  $φ$ = $ωt$"},
                         deviation, language);
  }

 private:
  void draw_parts(Plot& plot) const {
    constexpr double crossing = 2.5;                       // mm of arc on both sides of a point
    constexpr double room_for_letters = 18, for_some = 5;  // mm: on a smaller wheel the quarters are named, or none
    const double radius = r_ * plot.scale().mm_per_unit;
    for (int i = 1; i < divisions; ++i) {
      const Division& at = part(i);
      const bool is_explained = i == explained_part;
      plot.in_step(Step::wheel);
      plot.segment(C(), at.on_body, Meaning::construction);
      plot.in_step(Step::meeting);
      plot.segment(at.on_line, at.M, Meaning::construction);
      plot.in_step(is_explained ? Step::first_arc : Step::meeting);
      compass_arc(plot, P0_, at.M, crossing);
      plot.in_step(is_explained ? Step::second_arc : Step::meeting);
      compass_arc(plot, at.on_line, at.M, crossing);
      plot.in_step(Step::wheel);
      plot.dot(at.on_body, Meaning::construction);
      plot.in_step(Step::guide);
      plot.dot(at.on_line, Meaning::construction);
      plot.in_step(Step::meeting);
      plot.dot(at.M, Meaning::locus);
      if (radius < for_some) continue;
      plot.small_label(roman[static_cast<std::size_t>(i - 1)], at.M, at.on_line);
      plot.in_step(Step::guide);
      plot.small_label(std::to_string(i), at.on_line, {at.on_line.x, r_});
      plot.in_step(Step::wheel);
      if (radius >= room_for_letters || i % 3 == 0) plot.small_label(fmt::format("{}′", i), at.on_body, C());
    }
    plot.in_step(Step::meeting);
    plot.dot(part(divisions).M, Meaning::locus);
  }
};

// One division: 4′ on the wheel, 4 on the guide.
class DivisionPanel : public WheelPanel {
 public:
  using WheelPanel::WheelPanel;

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    const Division& at = part(explained_part);
    Extent extent;
    extent.include(-0.3 * r_ * scale.mm_per_unit, -8);
    extent.include(at.on_line.x * scale.mm_per_unit + 12, at.M.y * scale.mm_per_unit + 9);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    draw_guide(plot, -0.3 * r_, part(explained_part).on_line.x + 10 / plot.scale().mm_per_unit);
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    const Division& at = part(explained_part);
    constexpr double quarter = std::numbers::pi / 2;
    plot.in_step(Step::given);
    draw_guide(plot, -0.3 * r_, at.on_line.x + 10 / plot.scale().mm_per_unit);
    // Of the wheel what rolls on the way to 4.
    const double to = direction(C(), at.on_body);
    plot.mark(drawings::Line{
        drawings::arc(plot.at(C()), r_ * plot.scale().mm_per_unit, -quarter - 0.3, to + 0.15), Meaning::link, {}});
    plot.cross(C(), Meaning::text);
    for (int i = 1; i <= explained_part; ++i) {
      plot.in_step(Step::wheel);
      plot.dot(part(i).on_body);
      plot.label(fmt::format("{}′", i), part(i).on_body, C());
      plot.in_step(Step::guide);
      plot.dot(part(i).on_line);
      plot.label(std::to_string(i), part(i).on_line, at.M);
    }
    constexpr double swung = 14;  // mm: as long as the compass is swung to be sure of the crossing
    plot.in_step(Step::first_arc);
    plot.segment(at.on_body, at.on_line, Meaning::dimension);
    plot.segment(P0_, at.M, Meaning::construction);
    compass_arc(plot, P0_, at.M, swung);
    plot.in_step(Step::second_arc);
    plot.segment(P0_, at.on_body, Meaning::dimension);
    plot.segment(at.on_line, at.M, Meaning::construction);
    compass_arc(plot, at.on_line, at.M, swung);
    plot.in_step(Step::meeting);
    plot.dot(at.M, Meaning::locus);
    plot.label("IV", at.M, at.on_line, Meaning::locus);
    plot.in_step(Step::given);
    plot.label("$P_{0}$", P0_, C());
    plot.label("$C$", C(), at.on_line);
    return {};
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    const Division& at = part(explained_part);
    return {
        {{"The wheel, in its position at the start, in twelve parts: 1′, 2′, ... 12′.",
          "La ruota, nella posizione iniziale, in dodici parti: 1′, 2′, ... 12′."},
         part(2).on_body},
        {{"On the guide as many parts, each as long as an arc of the wheel, $πd$/12: 1, 2, ... 12. When 4′ has come "
          "to 4, $P_{0}$ has come to IV.",
          "Sulla guida altrettante parti, lunghe come un archetto della ruota, $πd$/12: 1, 2, ... 12. Quando 4′ "
          "viene in 4, $P_{0}$ è andato in IV."},
         part(2).on_line},
        {{"About $P_{0}$ an arc with the radius 4 4′.", "Con centro $P_{0}$ un arco di raggio 4 4′."},
         at.on_body + 0.45 * (at.on_line - at.on_body)},
        {{"About 4 an arc with the chord $P_{0}$ 4′.", "Con centro 4 un arco di raggio pari alla corda $P_{0}$ 4′."},
         P0_ + 0.6 * (at.on_body - P0_)},
        {{"They meet at IV; so all the others. XII is 12 itself: there the arcs touch.",
          "Si incontrano in IV; così tutti gli altri. XII è 12 stesso: lì gli archi si toccano."},
         at.M}};
  }
};

}  // namespace

PanelSheet cycloid_sheet(const Solution& s, Language) {
  return {.panels = panels(ArchPanel(s), DivisionPanel(s)),
          .seen = {"The wheel in twelve parts, the guide in as many, the twelve points of the cycloid by two arcs "
                   "each, and the curve through them",
                   "La ruota in dodici parti, la guida in altrettante, i dodici punti della cicloide per due archi "
                   "ciascuno, e la curva che li unisce"},
          .told = {"cycloid.arch_base"},
          .without_part = givens_of_involute};
}

}  // namespace epure::cycloid_involute
