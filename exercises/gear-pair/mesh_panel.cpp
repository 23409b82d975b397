#include "exercises/gear-pair/mesh_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/faults.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/scale.h"

namespace epure::gear_pair {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
constexpr double letters_room = 9;  // mm around a point
constexpr double tinted_rim = 1.5;  // modules inwards of the root circle
constexpr double off_teeth = 2.7;   // modules from the line of action to what is measured along it

// Shown when what lies between A and E beside them can still be seen.
bool is_near(const Pair& pair, double xi) {
  return std::abs(xi) < 2.5 * (pair.has_contact() ? *pair.E - *pair.A : 5 * pair.m());
}

// From the first to the last place shown of the line of action.
std::pair<double, double> reach_of_action(const Pair& pair) {
  std::pair<double, double> reach{0, 0};
  for (const std::optional<double>& xi : {pair.A, pair.E, std::optional(pair.T1), pair.T2})
    if (xi && is_near(pair, *xi)) reach = {std::min(reach.first, *xi), std::max(reach.second, *xi)};
  return reach;
}

class MeshPicture {
 public:
  MeshPicture(const Pair& pair, Plot& plot, const drawings::Box& room, Language language)
      : pair_(pair), plot_(plot), room_(room), language_(language) {}

  void draw() {
    for (const int wheel : {2, 1}) draw_circles(wheel);
    for (const int wheel : {2, 1}) teeth().tint(plot_, wheel, tinted_rim * pair_.m());
    for (const int wheel : {2, 1}) teeth().draw(plot_, wheel, Meaning::link);
    for (const int wheel : {2, 1}) draw_motion(wheel);
    draw_line_of_centres([](int) { return true; });
    draw_line_of_action();
    if (pair_.has_contact()) draw_contact();
    draw_heights();
    measure_clearances();
    mark_faults(plot_, pair_, teeth(), language_);
  }

  // The centres mostly lie off the sheet, where no compass reaches the reference circles.
  void draw_given() const {
    for (const int wheel : {2, 1}) {
      if (!pair_.is_placed(wheel)) continue;
      if (pair_.is_rack(wheel))
        draw_pitch_line();
      else
        draw_reference_circle(wheel);
    }
    draw_line_of_centres([this](int wheel) { return pair_.is_placed(wheel); });
  }

  std::vector<drawings::Block> missing_outlines() const {
    std::vector<drawings::Block> told;
    for (const int wheel : {1, 2})
      if (!teeth().has(wheel))
        told.push_back(drawings::Paragraph{
            format_words("No outline of wheel {}: the rack that should cut it leaves no such teeth.",
                         "Nessun profilo della ruota {}: la dentiera che dovrebbe tagliarla non lascia denti simili.",
                         wheel)
                .in(language_)});
    return told;
  }

  // Where the flank that touches at ξ cuts its pitch circle: the wheel has turned by ξ/r_b since P0.
  static double turn(const Pair& pair, int wheel, double xi) {
    return pair.up(wheel) * (right_angle + xi / pair("r_base_", wheel));
  }
  static Place end_of_arc(const Pair& pair, int wheel, double xi) {
    if (pair.is_rack(wheel)) return {xi / pair.along.x, 0};
    const double r = pair("r_w_", wheel), angle = turn(pair, wheel, xi);
    return pair.O(wheel) + Arrow2{r * std::cos(angle), r * std::sin(angle)};
  }
  // Paper millimetres from the line of action to the dimension of the base pitch: below, in wheel 1, when its body is
  // wide enough; else above the other two dimensions.
  static double off_base_pitch(const Pair& pair, const Plot& plot) {
    const double off = off_teeth * pair.m() * plot.scale().mm_per_unit;
    return pair("r_root_", 1) > 2.5 * pair.m() ? off : -off - 10;
  }

 private:
  struct Step {  // of the construction, where the teeth touch
    static constexpr int path = 4, flanks = 5, arcs = 6, base_pitch = 7;
  };

  bool inside(const Place& P) const { return is_in(room_, plot_, P); }
  double mm() const { return 1 / plot_.scale().mm_per_unit; }

  void level(double y, Meaning meaning) const {
    plot_.cycle({.centre = {}, .on_line = Place{0, y}, .along = {1, 0}}, meaning);
  }

  // The reference circle, from which the heights are measured, is another one than that of shifted wheels at work.
  void draw_circles(int wheel) const {
    if (pair_.is_rack(wheel)) {
      level(pair_.tip_at_mesh(wheel).y, Meaning::construction);
      level(pair_.root_at_mesh(wheel).y, Meaning::construction);
      return draw_pitch_line();
    }
    draw_circle(wheel, "a", pair_("r_tip_", wheel), Meaning::construction);
    draw_circle(wheel, "f", pair_("r_root_", wheel), Meaning::construction);
    draw_circle(wheel, "b", pair_("r_base_", wheel), Meaning::second_locus);
    if (pair_.is_shifted()) draw_circle(wheel, "w", pair_("r_w_", wheel), Meaning::axis);
    draw_reference_circle(wheel);
  }
  // Where nothing is shifted it is the pitch circle.
  void draw_reference_circle(int wheel) const {
    draw_circle(wheel, "", pair_("r", wheel), pair_.is_shifted() ? Meaning::construction : Meaning::axis);
  }
  void draw_pitch_line() const { level(0, Meaning::axis); }
  void draw_circle(int wheel, const char* index, double radius, Meaning meaning) const {
    plot_.cycle({.centre = pair_.O(wheel), .radius = radius}, meaning);
    name_circle(wheel, index, radius, meaning == Meaning::second_locus ? meaning : Meaning::text);
  }

  // Where it leaves the room on the side, outside of it. Not seen from its centre, which may lie kilometres off the
  // paper.
  void name_circle(int wheel, const char* index, double radius, Meaning ink) const {
    constexpr double from_side = 9, from_border = 3;  // mm
    const drawings::Point O = plot_.at(pair_.O(wheel));
    const double r = radius / mm(), up = pair_.up(wheel);
    const double x = (wheel == 1 ? room_.high.x - from_side : room_.low.x + from_side) - O.x;
    if (std::abs(x) >= r) return;
    const double y = O.y + up * std::sqrt((r - x) * (r + x));
    if (y < room_.low.y + from_border || y > room_.high.y - from_border) return;
    plot_.label(on(std::string("$r_{") + index, wheel) + "}$", plot_.from_paper({O.x + x, y}),
                plot_.from_paper({O.x + x, y - up}), ink);
  }

  // An arc arrow within the body, beside the mesh: of wheel 1 on the left, of wheel 2 on the right.
  void draw_motion(int wheel) const {
    constexpr double in_body = 0.75, widest = 0.9;  // modules, radians
    const double aside = std::min(5.5 * pair_.m(), 62 * mm());
    if (pair_.is_rack(wheel)) {
      const double y = pair_.root_at_mesh(wheel).y + pair_.rim() / 2;
      const Place from{aside, y}, to{from.x - 14 * mm(), y};
      plot_.mark(drawings::Arrow{plot_.at(from), plot_.at(to), Meaning::link, {}});
      return plot_.label("$v$", to);
    }
    const double r_root = pair_("r_root_", wheel), body = (pair_.is_ring(wheel) ? 1 : -1) * in_body * pair_.m();
    const double radius = std::max(r_root + body, r_root / 2), half = std::min(9 * mm() / radius, widest / 2);
    const double side = wheel == 1 ? 1 : -1, away = std::min(aside / radius, widest);
    draw_sense(plot_, pair_, wheel, radius / mm(),
               pair_.up(wheel) > 0 ? right_angle + side * away : -right_angle - side * away, half);
  }

  // With the centres of these wheels, or where they lie.
  template <class IsShown>
  void draw_line_of_centres(const IsShown& is_shown) const {
    constexpr double from_border = 4;  // mm
    const double x = plot_.at({0, 0}).x;
    plot_.segment(plot_.from_paper({x, room_.low.y}), plot_.from_paper({x, room_.high.y}), Meaning::axis);
    std::string off_above, off_below;
    for (const int wheel : {1, 2}) {
      if (pair_.is_rack(wheel) || !is_shown(wheel)) continue;
      const std::string O = on("$O_{", wheel) + "}$";
      if (inside(pair_.O(wheel))) {
        plot_.hinge(pair_.O(wheel));
        plot_.label(O, pair_.O(wheel));
      } else {
        std::string& off = pair_.up(wheel) < 0 ? off_above : off_below;
        off += (off.empty() ? "" : ", ") + O;
      }
    }
    for (const auto& [centres, y] :
         {std::pair{off_above, room_.high.y - from_border}, std::pair{off_below, room_.low.y + from_border}})
      if (!centres.empty())
        plot_.small_label(Words{"to ", "verso "}.in(language_) + centres, plot_.from_paper({x, y}),
                          plot_.from_paper({x - 1, y}));
  }

  void draw_line_of_action() const {
    constexpr double beyond = 10, arc = 30, tangent = 34;  // mm
    const Place P0{0, 0};
    const auto [first, last] = reach_of_action(pair_);
    plot_.long_segment(pair_.at(first), pair_.at(last), beyond, Meaning::construction);
    // The common tangent, from which the pressure angle is drawn.
    plot_.segment({-tangent * mm(), 0}, {tangent / 2 * mm(), 0}, Meaning::construction);
    const double pi = std::numbers::pi, from = pi - std::atan2(pair_.along.y, -pair_.along.x),
                 middle = (from + pi) / 2;
    plot_.mark(drawings::AngleMark{plot_.at(P0), arc, from, pi});
    plot_.label(fmt::format("${}$ = {}°", pair_.is_shifted() ? "α_{w}" : "α",
                            pair_.is_shifted() ? written(pair_.s["working_pressure_angle_deg"]).in(language_)
                                               : short_number(pair_.s["working_pressure_angle_deg"], language_)),
                {arc * mm() * std::cos(middle), arc * mm() * std::sin(middle)}, P0);
    draw_tangent_point(1, pair_.T1);
    if (pair_.T2) draw_tangent_point(2, *pair_.T2);
    plot_.dot(P0);
    plot_.label("$P_{0}$", P0);
  }

  void draw_tangent_point(int wheel, double xi) const {
    const Place T = pair_.at(xi);
    if (!inside(T)) return;
    plot_.segment(T, pair_.O(wheel), Meaning::construction);
    plot_.right_angle(T, {0, 0}, pair_.O(wheel));
    plot_.dot(T);
    plot_.label(on("$T_{", wheel) + "}$", T, pair_.O(wheel));
    if (!pair_.is_ring(wheel))
      plot_.measures(wheel == 1 ? "interference_limit_approach" : "interference_limit_recess", {0, 0}, T);
  }

  void name(double xi, const std::string& letters) const {
    plot_.dot(pair_.at(xi), Meaning::locus);
    plot_.label("$" + letters + "$", pair_.at(xi), {}, Meaning::locus);
  }

  void draw_contact() const {
    draw_path();
    plot_.in_step(Step::path);
    name(*pair_.A, "A");
    name(*pair_.E, "E");
    plot_.measures("path_of_contact", pair_.at(*pair_.A), pair_.at(*pair_.E));
    if (*pair_.A < 0) plot_.measures("path_of_approach", {0, 0}, pair_.at(*pair_.A));
    if (*pair_.E > 0) plot_.measures("path_of_recess", {0, 0}, pair_.at(*pair_.E));
    plot_.in_step(Step::arcs);
    for (const int wheel : {1, 2}) draw_arc(wheel);
    plot_.in_step(Step::base_pitch);
    if (pair_.has_single_contact()) {
      name(pair_.B(), "B");
      name(pair_.D(), "D");
      plot_.measures("base_pitch", pair_.at(pair_.begins.xi), pair_.at(pair_.D()));
    }
    const double off = off_teeth * pair_.m() / mm();
    plot_.in_step(Step::path);
    if (*pair_.A < 0 && *pair_.E > 0) {
      dimension(pair_.at(*pair_.A), {0, 0}, -off, "$P_{0}A$", pair_.s["path_of_approach"]);
      dimension({0, 0}, pair_.at(*pair_.E), -off, "$P_{0}E$", pair_.s["path_of_recess"]);
    }
    plot_.in_step(Step::base_pitch);
    if (pair_.ends.xi > pair_.D())
      dimension(pair_.at(pair_.begins.xi), pair_.at(pair_.D()), off_base_pitch(pair_, plot_), "$p_{b}$",
                pair_.base_pitch);
    plot_.in_step({});
  }
  void dimension(const Place& P, const Place& Q, double offset, const std::string& letters, double length) const {
    plot_.mark(drawings::Dimension{plot_.at(P), plot_.at(Q), offset, letters + " = " + in_mm(length).in(language_)});
  }

  // AE, dashed where no flanks touch, and the flanks at the ends of what is left.
  void draw_path() const {
    const double A = *pair_.A, E = *pair_.E;
    plot_.in_step(Step::path);
    const double from = pair_.touches ? pair_.begins.xi : E, to = pair_.touches ? pair_.ends.xi : E;
    if (from > A) plot_.segment(pair_.at(A), pair_.at(from), Meaning::alternative);
    if (to < E) plot_.segment(pair_.at(to), pair_.at(E), Meaning::alternative);
    if (!pair_.touches) return;
    plot_.segment(pair_.at(from), pair_.at(to), Meaning::locus, pair_.is_whole() ? "AE" : "contact");
    plot_.in_step(Step::flanks);
    for (const PathEnd& end : {pair_.begins, pair_.ends}) {
      for (const int wheel : {1, 2}) teeth().draw_flank(plot_, wheel, end.xi);
      if (end.is_short()) name(end.xi, end.letters());
    }
  }

  // Pitch circle 2 rolls on pitch circle 1: the arcs are equal, and 1/cos α_w of the path. Their ends have their
  // letters on the side away from the other wheel's, with which they must not be taken for one.
  void draw_arc(int wheel) const {
    const double A = *pair_.A, E = *pair_.E;
    const Place N1 = end_of_arc(pair_, wheel, A), N2 = end_of_arc(pair_, wheel, E);
    const std::string arc = on("arc_of_action_", wheel);
    if (pair_.is_rack(wheel)) {
      plot_.segment(N1, N2, Meaning::locus, arc);
      plot_.measures("arc_of_action", N1, N2);
      if (A < 0) plot_.measures("arc_of_approach", N1, {0, 0});
      if (E > 0) plot_.measures("arc_of_recess", {0, 0}, N2);
    } else if (const auto [from, to] = std::minmax({turn(pair_, wheel, A), turn(pair_, wheel, E)}); from < to) {
      plot_.mark(drawings::Line{drawings::arc(plot_.at(pair_.O(wheel)), pair_("r_w_", wheel) / mm(), from, to),
                                Meaning::locus, arc});
    }
    const std::string N = wheel == 1 ? "$N" : "$N'";
    for (const auto& [xi, index] : {std::pair{A, "_{1}$"}, std::pair{E, "_{2}$"}}) {
      const Place end = end_of_arc(pair_, wheel, xi);
      plot_.dot(end, Meaning::locus);
      plot_.label(N + index, end, end_of_arc(pair_, 3 - wheel, xi), Meaning::locus);
    }
  }

  // Addendum and dedendum of wheel 1 along the middle of a space beside the mesh, away from its letters.
  void draw_heights() const {
    if (!teeth().has(1)) return;
    const double side = pair_.is_ring() ? -1 : 1, r = pair_("r", 1), r_tip = pair_("r_tip_", 1);
    const double r_root = pair_("r_root_", 1);
    for (const double space : {2.5 * side, 1.5 * side, -1.5 * side, -2.5 * side}) {
      const Arrow2 out = teeth().direction_of_tooth(1, space);
      const Place tip = pair_.O(1) + r_tip * out, pitch = pair_.O(1) + r * out, root = pair_.O(1) + r_root * out;
      if (out.y < 0.3 || !inside(tip) || !inside(root)) continue;
      dimension(root, pitch, 0, "$h_{f}$", pair_.s["dedendum"]);
      dimension(pitch, tip, 0, "$h_{a}$", pair_.s["addendum"]);
      plot_.measures("dedendum", root, pitch);
      plot_.measures("addendum", pitch, tip);
      return plot_.measures("tooth_height", root, tip);
    }
  }

  // Between tip and root on the line of centres; the letters are in the table.
  void measure_clearances() const {
    for (const int wheel : {1, 2}) {
      const Place tip = pair_.tip_at_mesh(wheel), root = pair_.root_at_mesh(3 - wheel);
      if ((wheel == 1) == (root.y > tip.y)) plot_.measures(wheel == 1 ? "clearance" : "clearance_2", tip, root);
    }
  }

  // To fit their flanks is most of the work, and what is given shows none.
  const Teeth& teeth() const {
    if (!teeth_) teeth_.emplace(pair_, curve_tolerance_mm / plot_.scale().mm_per_unit);
    return *teeth_;
  }

  const Pair& pair_;
  Plot& plot_;
  drawings::Box room_;
  Language language_;
  mutable std::optional<Teeth> teeth_ = {};
};

PanelStep to_tangent_points(const Pair& pair, const Plot& plot, const drawings::Box& room) {
  const Place T1 = pair.at(pair.T1), T2 = pair.at(pair.T2.value_or(pair.T1));
  if (pair.is_rack())
    return {{"The perpendicular from $O_{1}$: $T_{1}$ on the base circle.",
             "La perpendicolare da $O_{1}$: $T_{1}$ sulla circonferenza di base."},
            T1};
  const bool one = is_in(room, plot, T1), other = is_in(room, plot, T2);
  Words text{"Perpendiculars from the centres: $T_{1}$, $T_{2}$ on the base circles.",
             "Le perpendicolari dai centri: $T_{1}$, $T_{2}$ sulle circonferenze di base."};
  if (one != other)
    text =
        text + format_words(" (${}$ off the sheet.)", " (${}$ fuori del foglio.)", point_letters(one ? "T2" : "T1"));
  return {text, one ? T1 : T2};
}

Words of_flanks(const Pair& pair) {
  const Words of_which =
      pair.is_rack()
          ? Words{"The flanks are involutes of the wheel's base circle, and straight on the rack",
                  "I fianchi sono evolventi della circonferenza di base della ruota, e rettilinei sulla dentiera"}
          : Words{"The flanks are involutes of the base circles",
                  "I fianchi sono evolventi delle circonferenze di base"};
  if (!pair.touches) return of_which + Words{"; these never touch.", "; questi non si toccano mai."};
  const Words here = pair.shown_contact() == 0
                         ? Words{"at $P_{0}$", "in $P_{0}$"}
                         : format_words("in the middle of ${}$", "nel mezzo di ${}$", pair.name_of_path());
  return of_which + format_words(", here touching {}; dashed, at ${}$ and at ${}$.",
                                 ", qui a contatto {}; tratteggiati, in ${}$ e in ${}$.", here, pair.begins.letters(),
                                 pair.ends.letters());
}

Words of_arcs(const Pair& pair) {
  const Words would = pair.is_whole()
                          ? Words{"Touching at $A$ and $E$ they cut", "A contatto in $A$ e in $E$ tagliano"}
                          : Words{"Whole flanks, touching at $A$ and $E$, would cut",
                                  "Fianchi interi, a contatto in $A$ e in $E$, taglierebbero"};
  return format_words(
      "{} pitch circle 1 at $N_{{1}}$, $N_{{2}}$, {} at $N'_{{1}}$, $N'_{{2}}$: the arcs of action are equal, $e$ = "
      "$AE$/cos\u00a0{}.",
      "{} la primitiva 1 in $N_{{1}}$, $N_{{2}}$, {} in $N'_{{1}}$, $N'_{{2}}$: gli archi di azione sono uguali, $e$ "
      "= $AE$/cos\u00a0{}.",
      would, pair.is_rack() ? Words{"the pitch line", "la retta primitiva"} : Words{"circle 2", "la 2"},
      std::string(pair.is_shifted() ? "$α_{w}$" : "$α$"));
}

}  // namespace

// 40 mm of paper for a module.
double MeshPanel::reach() const { return 25 * pair_.m(); }

drawings::Box MeshPanel::extent(const Scale& scale, const Scale&) const {
  Extent extent;
  const auto [first, last] = reach_of_action(pair_);
  for (const double xi : {first, 0.0, last}) extent.include(scale, pair_.at(xi), letters_room);
  for (const double x : {-1.3, 1.3})
    for (const double y : {-4.0, 4.0}) extent.include(scale, {x * pair_.pitch, y * pair_.m()});
  return extent.box();
}

void MeshPanel::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  MeshPicture(pair_, plot, room, language).draw_given();
}

std::vector<drawings::Block> MeshPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  MeshPicture picture(pair_, plot, room, language);
  picture.draw();
  return picture.missing_outlines();
}

// Around P0 there is little room: the line of action and the base pitch have their numbers where they come out of the
// mesh, the flanks where they part.
std::vector<PanelStep> MeshPanel::steps(const Plot& plot, const drawings::Box& room) const {
  const double mm = 1 / plot.scale().mm_per_unit, last = reach_of_action(pair_).second;
  const double beyond = pair_.has_contact() ? std::max(*pair_.E + 12 * mm, (*pair_.E + last) / 2) : 14 * mm;
  std::vector<PanelStep> steps{
      {pair_.is_rack() ? Words{"Pitch circle and pitch line touch at $P_{0}$, the pitch point.",
                               "Primitiva e retta primitiva si toccano in $P_{0}$."}
                       : Words{"The pitch circles touch at $P_{0}$, the pitch point, on the line of centres.",
                               "Le primitive si toccano in $P_{0}$ sulla retta dei centri."},
       Place{0, 0}},
      {format_words("The line of action there, at {} to the common tangent.",
                    "La retta d'azione per $P_{{0}}$, a {} dalla tangente comune.",
                    std::string(pair_.is_shifted() ? "$α_{w}$" : "$α$")),
       pair_.at(beyond)},
      to_tangent_points(pair_, plot, room)};
  if (!pair_.has_contact()) return steps;
  const Words whole = pair_.is_whole() ? Words{} : Words{" of whole flanks", " di fianchi interi"};
  const Words tip_2 = pair_.is_rack() ? Words{"The rack's tip line", "La retta di testa della dentiera"}
                                      : Words{"Tip circle 2", "La circonferenza di testa 2"};
  const Words tip_1{"tip circle 1", pair_.is_rack() ? "la circonferenza di testa 1" : "la 1"};
  steps.push_back({format_words("{} cuts it at $A$, {} at $E$: $AE$ is the path of contact{}.",
                                "{} taglia la retta d'azione in $A$, {} in $E$: $AE$ è la linea di ingranamento{}.",
                                tip_2, tip_1, whole),
                   pair_.at(*pair_.A)});
  steps.push_back({of_flanks(pair_), pair_.at(pair_.touches ? pair_.ends.xi : 0)});
  steps.push_back({of_arcs(pair_), MeshPicture::end_of_arc(pair_, 1, *pair_.A)});
  if (!pair_.has_single_contact()) return steps;
  const drawings::Point D = plot.at(pair_.at(pair_.D()));
  const double off = MeshPicture::off_base_pitch(pair_, plot);
  steps.push_back(
      {format_words(
           "The base pitch $p_{{b}}$ from ${}$ gives $D$, from ${}$ gives $B$: between them one pair of teeth "
           "carries alone.",
           "Il passo di base $p_{{b}}$ da ${}$ dà $D$, da ${}$ dà $B$: fra questi lavora una sola coppia di denti.",
           pair_.begins.letters(), pair_.ends.letters()),
       plot.from_paper({D.x - off * pair_.along.y, D.y + off * pair_.along.x})});
  return steps;
}

}  // namespace epure::gear_pair
