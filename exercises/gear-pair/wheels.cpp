// Sheet 2: the whole wheels, or as much of them as shows their teeth, with the data a workshop needs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/contact_words.h"
#include "exercises/gear-pair/exercise.h"
#include "exercises/gear-pair/fault_marks.h"
#include "exercises/gear-pair/fault_words.h"
#include "exercises/gear-pair/teeth.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double smallest_module = 0.8;  // mm of paper: below it teeth are no longer seen
constexpr double outlined_thin = 2.5;    // mm: teeth of smaller modules have thin outlines
constexpr double least_room = 9;         // mm of paper, of a root circle that holds the sense of rotation
constexpr double air = 4;                // mm
constexpr double beside = 10;            // mm from the largest wheel to the dimension of the centre distance

enum class View {
  both_whole,
  one_whole,  // the other would be too large: as much of it as fits
  circles     // whole, without teeth, as ISO 2203 draws gears
};

// The wheel that is shown whole when only one is.
int smaller_wheel(const DrawnPair& pair) {
  return pair.of.kind == geometry::PairKind::external && pair.of.z2 < pair.of.z1 ? 2 : 1;
}

double rim(const DrawnPair& pair) { return 2.5 * pair.m(); }

void include_wheel(Extent& extent, const Scale& scale, const DrawnPair& pair, int number) {
  if (number == 2 && pair.is_rack()) {
    const double top = CGAL::to_double(geometry::rack_lines(pair.of).root) + rim(pair);
    extent.include(scale, {0, top}, air);
    return;
  }
  const DrawnWheel& wheel = number == 1 ? pair.wheel1 : *pair.wheel2;
  const Place& O = number == 1 ? pair.O1 : *pair.O2;
  const double r = number == 2 && pair.is_ring() ? wheel.circles.r_root + rim(pair) : wheel.circles.r_tip;
  extent.include(scale, {O.x - r, O.y - r}, air);
  extent.include(scale, {O.x + r, O.y + r}, air);
}

drawings::Box extent_of(const DrawnPair& pair, View view, const Scale& scale) {
  Extent extent;
  const int first = smaller_wheel(pair);
  include_wheel(extent, scale, pair, first);
  if (view != View::one_whole) include_wheel(extent, scale, pair, 3 - first);
  if (view == View::one_whole) {
    const double far = 7 * pair.m() + 12 / scale.mm_per_unit;  // of the other, beyond the pitch point
    extent.include(scale, {0, first == 1 ? far : -far});
  }
  drawings::Box box = extent.box();
  if (pair.O2 && view != View::one_whole) box.low.x -= beside + air;
  return box;
}

struct Choice {
  View view;
  Fit fit;
};

// Whole wheels when their teeth can be seen, else one whole wheel, else circles.
Choice choose(const DrawnPair& pair, const drawings::Box& room, const SheetRequest& request) {
  const double at_most = 40 / pair.m();
  const auto fit = [&](View view) {
    return fit_lengths(room, request, at_most, [&](const Scale& scale) { return extent_of(pair, view, scale); });
  };
  const auto shows_teeth = [&](const Fit& f) { return f.scale.mm_per_unit * pair.m() >= smallest_module; };
  SheetRequest any_scale = request;
  any_scale.scale.reset();
  std::optional<Choice> whole;
  try {
    whole = Choice{View::both_whole, fit(View::both_whole)};
  } catch (const BadGivens&) {
    if (!request.scale) throw;  // a scale that is too large for both may do for one
  }
  if (whole && shows_teeth(whole->fit)) return *whole;
  if (const Choice one{View::one_whole, fit(View::one_whole)}; shows_teeth(one.fit) || !whole) return one;
  return {View::circles, whole->fit};
}

class WheelsSheet {
 public:
  WheelsSheet(DrawnSheet& onto, const DrawnPair& pair, const Choice& choice, const drawings::Box& room)
      : pair_(pair),
        view_(choice.view),
        plot_(onto, choice.fit.origin, choice.fit.scale),
        room_(room),
        teeth_(pair, pair.shown_contact(), choice.fit.scale.mm_per_unit) {}

  const Teeth& teeth() const { return teeth_; }

  void draw(Language language) {
    for (const int number : {2, 1}) {
      draw_body(number);
      draw_circles(number);
    }
    draw_line_of_centres();
    draw_line_of_action();
    for (const int number : {1, 2}) {
      if (number == 2 && pair_.is_rack()) continue;
      draw_radii(number, language);
      draw_rotation(number);
    }
    draw_centre_distance(language);
    mark_colliding_tips(plot_, pair_, language);
  }

 private:
  const DrawnWheel& wheel(int number) const { return number == 1 ? pair_.wheel1 : *pair_.wheel2; }
  const Place& centre(int number) const { return number == 1 ? pair_.O1 : *pair_.O2; }
  bool is_rack(int number) const { return number == 2 && pair_.is_rack(); }
  bool is_ring(int number) const { return number == 2 && pair_.is_ring(); }
  double on_paper(double length) const { return length * plot_.scale().mm_per_unit; }

  bool inside(const Place& P) const {
    const drawings::Point p = plot_.at(P);
    return p.x >= room_.low.x && p.x <= room_.high.x && p.y >= room_.low.y && p.y <= room_.high.y;
  }

  void circle(int number, double radius, Meaning meaning) {
    plot_.cycle({.centre = centre(number), .radius = radius}, meaning);
  }
  void level(double y, Meaning meaning) {
    plot_.cycle({.centre = {}, .on_line = Place{0, y}, .along = {1, 0}}, meaning);
  }

  void draw_body(int number) {
    const bool thin = on_paper(pair_.m()) < outlined_thin;
    if (view_ != View::circles && teeth_.has(number))
      teeth_.draw(plot_, number, thin ? Meaning::plate : Meaning::link, INFINITY);
    else if (is_rack(number))
      level(CGAL::to_double(geometry::rack_lines(pair_.of).tip), Meaning::link);
    else
      circle(number, wheel(number).circles.r_tip, Meaning::link);
    if (is_rack(number)) level(CGAL::to_double(geometry::rack_lines(pair_.of).root) + rim(pair_), Meaning::link);
    if (is_ring(number)) circle(2, wheel(2).circles.r_root + rim(pair_), Meaning::link);
  }

  void draw_circles(int number) {
    if (is_rack(number)) return level(0, Meaning::axis);
    const geometry::WheelCircles<double>& c = wheel(number).circles;
    if (view_ == View::circles) circle(number, c.r_root, Meaning::construction);
    if (on_paper(pair_.m()) >= 1.5) circle(number, c.r_b, Meaning::second_locus);
    circle(number, c.r_w, Meaning::axis);
  }

  void draw_line_of_centres() {
    const double x = plot_.at({0, 0}).x;
    plot_.segment(plot_.from_paper({x, room_.low.y}), plot_.from_paper({x, room_.high.y}), Meaning::axis);
  }

  void draw_line_of_action() {
    if (!pair_.has_contact()) return;
    constexpr double beyond = 8;  // mm
    plot_.long_segment(pair_.at(*pair_.A), pair_.at(*pair_.E), beyond, Meaning::construction);
    plot_.segment(pair_.at(*pair_.A), pair_.at(*pair_.E), Meaning::locus, "AE");
    plot_.label("$P_{0}$", {0, 0});
  }

  // From the centre away from the mesh, so that the lines meet no teeth in contact.
  void draw_radii(int number, Language language) {
    const geometry::WheelCircles<double>& c = wheel(number).circles;
    const Place& O = centre(number);
    const bool shifted = pair_.alpha != pair_.alpha_w;
    struct Radius {
      const char *index, *quantity;
      double length, direction;
    };
    const std::array radii{Radius{"a", "r_tip_", c.r_tip, 207}, Radius{"b", "r_base_", c.r_b, 239},
                           Radius{shifted ? "w" : "", shifted ? "r_w_" : "r", c.r_w, 301},
                           Radius{"f", "r_root_", c.r_root, 333}};
    if (inside(O)) plot_.measures(fmt::format("r_w_{}", number), O, {0, 0});
    for (const Radius& radius : radii) {
      const double angle = towards(number, radius.direction) * degree;
      const Place end{O.x + radius.length * std::cos(angle), O.y + radius.length * std::sin(angle)};
      if (!inside(O) || !inside(end)) continue;
      const std::string text =
          fmt::format("$r_{{{}{}}}$ = {}", radius.index, number, figures(1000 * radius.length, 4, language));
      const bool roomy = on_paper(c.r_root) > 36;
      plot_.mark(drawings::Dimension{plot_.at(O), plot_.at(end), 0, roomy ? text : ""});
      if (!roomy) name_outside(text, O, end, c.r_tip);
      plot_.measures(fmt::format("{}{}", radius.quantity, number), O, end);
    }
  }

  // Wheel 1 shows its radii below its centre, wheel 2 above, as a ring below; wheel 1 in a ring to the sides, where
  // the ring's own do not pass, unless it is so small that these begin far below it.
  double towards(int number, double direction) const {
    if (number == 2) return pair_.is_ring() ? direction : direction - 180;
    if (!pair_.is_ring() || is_tiny(1)) return direction;
    return 180 + (direction < 270 ? (direction - 223) * 0.8 : 180 + (direction - 317) * 0.8);
  }

  // A radius too short for its text is led out beyond the teeth.
  void name_outside(const std::string& text, const Place& O, const Place& end, double r_tip) {
    const drawings::Point o = plot_.at(O), e = plot_.at(end);
    const double length = std::hypot(e.x - o.x, e.y - o.y), out = (on_paper(r_tip) + 5) / length;
    const Place outside = plot_.from_paper({o.x + out * (e.x - o.x), o.y + out * (e.y - o.y)});
    plot_.segment(end, outside, Meaning::dimension);
    plot_.label(text, outside, O);
  }

  void draw_rotation(int number) {
    const Place& O = centre(number);
    if (!inside(O)) return;
    plot_.hinge(O);
    name_centre(number);
    const double r_root = on_paper(wheel(number).circles.r_root);
    if (is_tiny(number))
      draw_sense(number, on_paper(wheel(number).circles.r_tip) + 10, (number == 1 ? 270 : 90) * degree, 20 * degree);
    else
      draw_sense(number, std::clamp(0.45 * r_root, 6.0, 16.0), (number == 1 ? 90 : 270) * degree, 35 * degree);
  }

  // There is no room between the hinge and the teeth.
  bool is_tiny(int number) const { return on_paper(wheel(number).circles.r_root) < least_room; }

  // The centre of a tiny wheel is named beside its teeth, where no radius is drawn.
  void name_centre(int number) {
    const std::string text = fmt::format("$O_{{{}}}$", number);
    const Place& O = centre(number);
    if (is_tiny(number))
      name_outside(text, O, {O.x + 1 / plot_.scale().mm_per_unit, O.y}, wheel(number).circles.r_tip);
    else
      plot_.label(text, O);
  }

  // An arc arrow about the wheel's centre, by its radius in paper millimetres and the angles of its middle and half.
  void draw_sense(int number, double radius, double middle, double half) {
    const bool positive = (number == 1 ? pair_.omega_1 : pair_.omega_2) > 0;
    const drawings::Point O = plot_.at(centre(number));
    plot_.mark(drawings::Rotation{O, radius, positive ? middle - half : middle + half,
                                  positive ? middle + half : middle - half});
    const double named = middle + 0.4 * half;
    plot_.label(fmt::format("$ω_{{{}}}$", number),
                plot_.from_paper({O.x + radius * std::cos(named), O.y + radius * std::sin(named)}), centre(number));
  }

  void draw_centre_distance(Language language) {
    if (!pair_.O2 || view_ == View::one_whole || !inside(pair_.O1) || !inside(*pair_.O2)) return;
    const DrawnWheel& largest = pair_.is_ring() || pair_.of.z2 > pair_.of.z1 ? *pair_.wheel2 : pair_.wheel1;
    const double radius = pair_.is_ring() ? largest.circles.r_root + rim(pair_) : largest.circles.r_tip;
    const double offset = on_paper(radius) + beside;
    const bool up = !pair_.is_ring();
    const Place &from = up ? pair_.O1 : *pair_.O2, &to = up ? *pair_.O2 : pair_.O1;
    plot_.mark(drawings::Dimension{plot_.at(from), plot_.at(to), offset,
                                   fmt::format("$a$ = {}", figures(1000 * pair_.centre_distance, 4, language))});
    plot_.measures("centre_distance", from, to);
  }

  const DrawnPair& pair_;
  View view_;
  Plot plot_;
  drawings::Box room_;
  Teeth teeth_;
};

// To a thousandth of a millimetre.
std::string to_micrometre(double metres, Language language) {
  const double mm = 1000 * metres;
  const int whole = mm == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(mm)))) + 1;
  return figures(mm, std::clamp(whole + 3, 1, 9), language);
}

std::string exactly(const Rational& x, Language language) { return short_number(CGAL::to_double(x), language); }

// Both wheels column by column; a rack has what a wheel has but circles.
drawings::Table gear_data(const DrawnPair& pair, Language language) {
  const geometry::PairData& of = pair.of;
  const bool rack = pair.is_rack();
  drawings::Table table{{"mm", "1", "2"}, {}};
  const std::string none = "–";
  const auto row = [&](const std::string& name, const std::string& of_1, const std::string& of_2) {
    table.rows.push_back({name, of_1, of_2});
  };
  const auto lengths = [&](const std::string& name,
                           const std::function<std::optional<double>(const DrawnWheel&)>& of_wheel) {
    const auto written = [&](const std::optional<double>& length) {
      return length ? to_micrometre(*length, language) : none;
    };
    row(name, written(of_wheel(pair.wheel1)), pair.wheel2 ? written(of_wheel(*pair.wheel2)) : none);
  };
  row("$z$", std::to_string(of.z1), rack ? "∞" : std::to_string(of.z2));
  row("$x$", exactly(of.x1, language), rack ? none : exactly(of.x2, language));
  lengths("$d$", [](const DrawnWheel& w) { return 2 * w.circles.r; });
  if (pair.alpha != pair.alpha_w) lengths("$d_{w}$", [](const DrawnWheel& w) { return 2 * w.circles.r_w; });
  lengths("$d_{b}$", [](const DrawnWheel& w) { return 2 * w.circles.r_b; });
  lengths("$d_{a}$", [](const DrawnWheel& w) { return 2 * w.circles.r_tip; });
  lengths("$d_{f}$", [](const DrawnWheel& w) { return 2 * w.circles.r_root; });
  const auto thickness = [&](const std::string& name, const std::optional<double>& of_1,
                             const std::optional<double>& of_2) {
    const auto written = [&](const std::optional<double>& s) { return s ? to_micrometre(*s, language) : none; };
    row(name, written(of_1), written(of_2));
  };
  const double at_tip = 2 * CGAL::to_double(of.m * (of.ha - of.k)) * std::tan(pair.alpha);
  const double of_rack = pair.pitch / 2 - CGAL::to_double(of.j) / 2;
  thickness("$s$", pair.wheel1.thickness, pair.wheel2 ? pair.wheel2->thickness : of_rack);
  thickness("$s_{a}$", pair.wheel1.tip_thickness, pair.wheel2 ? pair.wheel2->tip_thickness : of_rack - at_tip);
  const double height = CGAL::to_double(of.m * (of.ha + of.hf - of.k));
  thickness("$h$", height, height);
  lengths("$W_{k}$", [](const DrawnWheel& w) -> std::optional<double> {
    if (!w.base_tangent) return {};
    return w.base_tangent->length;
  });
  const auto teeth = [&](const DrawnWheel& w) {
    return w.base_tangent ? std::to_string(w.base_tangent->teeth) : none;
  };
  row("$k$", teeth(pair.wheel1), pair.wheel2 ? teeth(*pair.wheel2) : none);
  return table;
}

// What the letters of the table stand for.
std::string legend(const DrawnPair& pair, Language language) {
  const bool shifted = pair.alpha != pair.alpha_w;
  if (language == Language::english)
    return fmt::format(
        "$d$ reference, {}$d_{{b}}$ base, $d_{{a}}$ tip, $d_{{f}}$ root diameter; tooth thickness $s$ on "
        "$d$, $s_{{a}}$ at the tip; height $h$; $W_{{k}}$ base tangent length over $k$ teeth.",
        shifted ? "$d_{w}$ working pitch, " : "");
  return fmt::format(
      "Diametri $d$ primitivo, {}$d_{{b}}$ di base, $d_{{a}}$ di testa, $d_{{f}}$ di fondo; spessore $s$ "
      "su $d$, $s_{{a}}$ in testa; altezza $h$; $W_{{k}}$ scartamento su $k$ denti.",
      shifted ? "$d_{w}$ di funzionamento, " : "");
}

// That of the table of results, and where flanks are not whole what is left of it.
std::string both_contact_ratios(const DrawnPair& pair, Language language) {
  const std::string whole = figures(pair.contact_ratio(), 4, language);
  if (pair.path.is_whole()) return fmt::format("$f$ = {}", whole);
  const std::string of_whole =
      fmt::format("{} {}", whole, Words{"of whole flanks", "di fianchi interi"}.in(language));
  if (!pair.path.known || !pair.path.touches) return "$f$ = " + of_whole;
  return fmt::format("{} ({})", true_contact_ratio(pair, language), of_whole);
}

std::string of_the_pair(const DrawnPair& pair, Language language) {
  const bool english = language == Language::english;
  std::string text;
  const auto add = [&](const std::string& line) { text += (text.empty() ? "" : ", ") + line; };
  add(fmt::format("$m$ = {}\u00a0mm", exactly(1000 * pair.of.m, language)));
  add(fmt::format("$α$ = {}°", short_number(degrees(pair.of.alpha), language)));
  if (pair.O2) add(fmt::format("$a$ = {}\u00a0mm", to_micrometre(pair.centre_distance, language)));
  if (pair.alpha != pair.alpha_w) add(fmt::format("$α_{{w}}$ = {}°", figures(pair.alpha_w / degree, 6, language)));
  if (pair.has_contact()) add(both_contact_ratios(pair, language));
  add(english ? fmt::format("backlash $j$ = {}\u00a0mm", exactly(1000 * pair.of.j, language))
              : fmt::format("gioco $j$ = {}\u00a0mm", exactly(1000 * pair.of.j, language)));
  return text + ".";
}

std::string of_the_cutter(const DrawnPair& pair, Language language) {
  const auto factor = [&](const Rational& x) { return exactly(x, language); };
  const geometry::PairData& of = pair.of;
  return fmt::format("{} $h_{{a}}^{{*}}$ = {}, $h_{{f}}^{{*}}$ = {}, $ρ^{{*}}$ = {}{}.",
                     language == Language::english ? "Basic rack:" : "Dentiera di riferimento:", factor(of.ha),
                     factor(of.hf), factor(of.rho),
                     of.k == 0 ? std::string() : fmt::format(", $k$ = {}", factor(of.k)));
}

std::string about_view(View view, Language language) {
  const bool english = language == Language::english;
  switch (view) {
    case View::one_whole:
      return english ? "The other wheel is shown as far as the sheet reaches: whole, its teeth could not be seen."
                     : "L'altra ruota è mostrata fin dove arriva il foglio: intera, i denti non si vedrebbero.";
    case View::circles:
      return english
                 ? "At this scale teeth cannot be seen: tip, pitch and root circles stand for them (ISO 2203)."
                 : "A questa scala i denti non si vedono: li rappresentano le circonferenze di testa, primitiva e "
                   "di fondo (ISO 2203).";
    default:
      return {};
  }
}

void fill_column(DrawnSheet& onto, const DrawnPair& pair, View view, Language language) {
  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  add_faults(onto, pair, language);
  column.push_back(drawings::Heading{english ? "Gear data" : "Dati delle dentature"});
  column.push_back(gear_data(pair, language));
  column.push_back(drawings::Paragraph{legend(pair, language)});
  column.push_back(drawings::Paragraph{of_the_pair(pair, language)});
  column.push_back(drawings::Paragraph{of_the_cutter(pair, language)});
  if (view != View::both_whole && !pair.is_rack()) column.push_back(drawings::Paragraph{about_view(view, language)});
}

}  // namespace

void draw_wheels(DrawnSheet& onto, const DrawnPair& pair, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const Choice choice = choose(pair, room, request);
  WheelsSheet sheet(onto, pair, choice, room);
  sheet.draw(request.language);
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {choice.fit.scale}, request);
  fill_column(onto, pair, choice.view, request.language);
  std::vector<Value> values{{"z1", static_cast<double>(pair.of.z1), ""}};
  if (pair.wheel2) values.push_back({"z2", static_cast<double>(pair.of.z2), ""});
  if (pair.O2) values.push_back({"a", pair.centre_distance, "m"});
  onto.sheet.description =
      in_words({"The wheels with their teeth in mesh, their circles and radii, and the gear data",
                "Le ruote con i denti in presa, le circonferenze coi raggi, e i dati delle "
                "dentature"},
               values, request.language);
}

}  // namespace epure::gear_pair
