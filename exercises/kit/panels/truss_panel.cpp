#include "exercises/kit/panels/truss_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawings/text/text.h"
#include "exercises/kit/statement/nth_letter.h"

namespace epure {
namespace {

constexpr double load_arrow = 12, past_support = 10;          // mm: its length; how far off the joint a reaction's is
constexpr double letter_off_outline = 8, region_letters = 4;  // mm; their size
constexpr double small_region = 5,
                 small_letters = 3;   // mm: where a number and a letter have no room beside each other
constexpr double truss_letters = 7;   // mm around all of it
constexpr double least_inside = 2.6;  // mm from the middle of a region to its bars, for a letter to stand there
constexpr int from_beginning = -1;    // of the steps: the truss and its loads are given

Arrow2 unit_vector(const Arrow2& v) { return 1 / magnitude(v) * v; }
Arrow2 towards(double angle) { return {std::cos(angle), std::sin(angle)}; }
double counter_clockwise(double from, double to) {
  const double turn = 2 * std::numbers::pi, by = std::fmod(to - from, turn);
  return by < 0 ? by + turn : by;
}

// Letters with their middle here.
void write_at(Plot& plot, const std::string& text, const drawings::Point& middle, double letters = region_letters) {
  const drawings::TextSize size = drawings::measure(text, letters);
  plot.mark(drawings::Writing{.text = text,
                              .baseline = {middle.x - size.width / 2, middle.y - (size.ascent - size.descent) / 2},
                              .size = letters,
                              .anchor = 0.5});
}

struct InscribedCircle {
  Place centre;
  double radius;
};
InscribedCircle inscribed(const std::vector<Place>& corners) {
  const Place &P = corners[0], &Q = corners[1], &R = corners[2];
  const double p = distance(Q, R), q = distance(R, P), r = distance(P, Q), around = p + q + r;
  return {{(p * P.x + q * Q.x + r * R.x) / around, (p * P.y + q * Q.y + r * R.y) / around},
          std::abs(cross(Q - P, R - P)) / around};
}

}  // namespace

double TrussPanel::reach() const {
  double reach = 0;
  for (const Place& P : figure_->joints)
    for (const Place& Q : figure_->joints) reach = std::max(reach, distance(P, Q));
  return reach;
}

TrussPanel::Opening TrussPanel::outside_of(std::size_t joint) const {
  const auto& outline = figure_->bow.outline;
  const auto start_of = [&](const geometry::BowNotation::Edge& edge) {
    const TrussFigure::Bar& bar = figure_->bars[edge.bar];
    return edge.is_forward ? bar.from : bar.to;
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (start_of(outline[i]) != joint) continue;
    const TrussFigure::Bar &next = figure_->bars[outline[i].bar],
                           &before = figure_->bars[outline[(i + outline.size() - 1) % outline.size()].bar];
    const Place& J = figure_->joints[joint];
    const auto other_end = [&](const TrussFigure::Bar& bar) {
      return figure_->joints[bar.from == joint ? bar.to : bar.from];
    };
    const double from = direction(J, other_end(next));
    return {from, counter_clockwise(from, direction(J, other_end(before)))};
  }
  return {0, 2 * std::numbers::pi};
}

// The way out of the truss: half-way between the two edges there.
Arrow2 TrussPanel::middle_of_outside(std::size_t joint) const {
  const Opening opening = outside_of(joint);
  return towards(opening.from + opening.angle / 2);
}

// The hinge stands on level or upright ground as the roller does, where that is no inside of the truss.
double TrussPanel::hinge_down() const {
  constexpr double quarter = std::numbers::pi / 2;
  const auto upright = [](double angle) { return quarter * std::round(angle / quarter); };
  const Opening opening = outside_of(figure_->outside[0].joint);
  const double as_roller = upright(figure_->roller_down);
  return counter_clockwise(opening.from, as_roller) < opening.angle ? as_roller
                                                                    : upright(opening.from + opening.angle / 2);
}

// Outside of the truss: it ends at the joint or begins there. Of reactions it leaves room for the support.
TrussPanel::OnPaper TrussPanel::arrow_of(std::size_t outside) const {
  const TrussFigure::Outside& force = figure_->outside[outside];
  const Arrow2 u = unit_vector(force.f);
  const bool ends = dot(u, middle_of_outside(force.joint)) < 0;
  const double near = outside < 2 ? past_support : 0, far = near + load_arrow;
  return ends ? OnPaper{-far * u, -near * u} : OnPaper{near * u, far * u};
}

drawings::Box TrussPanel::extent(const Scale& scale, const Scale&) const {
  Extent extent;
  for (const Place& P : figure_->joints) extent.include(scale, P, truss_letters);
  for (std::size_t k = 0; k < figure_->outside.size(); ++k) {
    const Place& J = figure_->joints[figure_->outside[k].joint];
    if (k < 2) extent.include(scale, J, past_support + 2);
    if (magnitude(figure_->outside[k].f) == 0) continue;
    const OnPaper arrow = arrow_of(k);
    for (const Arrow2& end : {arrow.to_tail, arrow.to_tip})
      for (const double air : {-truss_letters, truss_letters})
        extent.include(scale.mm_per_unit * J.x + end.x + air, scale.mm_per_unit * J.y + end.y + air / 2);
  }
  for (const auto& edge : figure_->bow.outline)
    for (const Place& P :
         {figure_->joints[figure_->bars[edge.bar].from], figure_->joints[figure_->bars[edge.bar].to]})
      extent.include(scale, P, letter_off_outline + 3);
  if (funicular_)
    for (const Place& P : funicular_->polygon.vertices) extent.include(scale, P, truss_letters);
  return extent.box();
}

void TrussPanel::draw_supports(Plot& plot) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  const Place &A = figure_->joints[figure_->outside[0].joint], &B = figure_->joints[figure_->outside[1].joint];
  plot.mark(drawings::FixedHinge{plot.at(A), hinge_down()});
  constexpr double depth = 4.2, half_base = 3.2, wheel = 0.9, half_ground = 5.5;  // mm
  const Arrow2 down = mm * towards(figure_->roller_down), side = geometry::quarter_turn(down);
  const Arrow2 foot = depth * down, half = half_base * side, level = (depth + 2 * wheel) * down;
  plot.polygon({B, B + (foot - half), B + (foot + half)}, Meaning::plate);
  for (const double at : {-0.6, 0.6}) plot.circle(B + (foot + wheel * down + at * half), wheel * mm, Meaning::plate);
  const Arrow2 end = half_ground * side;
  plot.mark(drawings::Ground{plot.at(B + (level - end)), plot.at(B + (level + end))});
}

std::vector<Place> TrussPanel::corners_of(std::size_t step) const {
  std::vector<Place> corners;
  for (const std::size_t joint : figure_->bow.corners[step]) corners.push_back(figure_->joints[joint]);
  return corners;
}

// Where regions beside a bar are small its weight alone tells what is pressed.
bool TrussPanel::has_room_for_sign(std::size_t bar, const Scale& scale) const {
  if (regions_ != Regions::lettered) return true;
  const auto& [left, right] = figure_->bow.sides[bar];
  for (std::size_t k = 0; k < figure_->bow.steps.size(); ++k)
    if (const std::size_t region = figure_->bow.steps[k].region;
        (region == left || region == right) && inscribed(corners_of(k)).radius * scale.mm_per_unit < small_region)
      return false;
  return true;
}

// Outside beside the middle of the region's part of the outline, inside in the middle of the region.
void TrussPanel::letter_regions(Plot& plot) const {
  const geometry::BowNotation& bow = figure_->bow;
  for (std::size_t region = 0; region < bow.regions_outside(); ++region) {
    double length = 0;
    std::vector<std::pair<Place, Place>> edges;
    for (const auto& edge : bow.outline) {
      if (edge.region != region) continue;
      const Place &P = figure_->joints[figure_->bars[edge.bar].from],
                  &Q = figure_->joints[figure_->bars[edge.bar].to];
      edges.push_back(edge.is_forward ? std::pair{P, Q} : std::pair{Q, P});
      length += distance(P, Q);
    }
    double left = length / 2;
    for (const auto& [P, Q] : edges) {
      const double here = distance(P, Q);
      if (left > here) {
        left -= here;
        continue;
      }
      // Where the middle falls on a joint or near it, the edge's own middle is as good.
      const double part = edges.size() == 1 || left < 0.3 * here || left > 0.7 * here ? 0.5 : left / here;
      const Arrow2 out = letter_off_outline / plot.scale().mm_per_unit * geometry::quarter_turn(unit_vector(Q - P));
      write_at(plot, "$" + nth_letter(region) + "$", plot.at(P + part * (Q - P) + out));
      break;
    }
  }
  for (std::size_t k = 0; k < bow.steps.size(); ++k) {
    const InscribedCircle within = inscribed(corners_of(k));
    const std::string letter = "$" + nth_letter(bow.steps[k].region) + "$";
    const double radius = within.radius * plot.scale().mm_per_unit;
    if (radius >= least_inside)
      write_at(plot, letter, plot.at(within.centre), radius < small_region ? small_letters : region_letters);
    else
      plot.label(letter, within.centre);
  }
}

void TrussPanel::draw_truss(Plot& plot, bool is_solved) const {
  constexpr double number_size = 2.5;  // mm
  plot.in_step(from_beginning);
  draw_supports(plot);
  for (std::size_t i = 0; i < figure_->bars.size(); ++i) {
    const TrussFigure::Bar& bar = figure_->bars[i];
    const Place &P = figure_->joints[bar.from], &Q = figure_->joints[bar.to];
    // Heavy is compressed: where the reactions are found nothing is said of that.
    const Meaning weight = is_solved ? TrussFigure::meaning(bar.force) : funicular_ ? Meaning::plate : Meaning::link;
    plot.in_step(from_beginning);
    // Beside the plan every bar is thin until that says what is pressed.
    if (is_solved && regions_ == Regions::lettered && weight == Meaning::link) {
      plot.segment(P, Q, Meaning::plate);
      plot.in_step(figure_->step_of_bar(i));
    }
    plot.segment(P, Q, weight, "bar_" + std::to_string(i + 1));
    if (funicular_) continue;               // the numbers there are the strings'
    plot.in_step(figure_->step_of_bar(i));  // with its number, what the plan says of it
    const bool has_sign = is_solved && has_room_for_sign(i, plot.scale());
    plot.onto().sheet.figure.labels.push_back(
        {.text = std::to_string(i + 1) + (has_sign ? TrussFigure::sign(bar.force) : ""),
         .at = plot.at(P),
         .to = plot.at(Q),
         .size = number_size});
  }
  plot.in_step(from_beginning);
  for (std::size_t i = 0; i < figure_->joints.size(); ++i) {
    if (i != figure_->outside[0].joint) plot.hinge(figure_->joints[i]);
    plot.label("$" + figure_->letters[i] + "$", figure_->joints[i]);
  }
  if (regions_ == Regions::lettered) letter_regions(plot);
}

void TrussPanel::draw_force(Plot& plot, std::size_t outside) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  const TrussFigure::Outside& force = figure_->outside[outside];
  if (magnitude(force.f) == 0) return;
  const OnPaper arrow = arrow_of(outside);
  const Place& J = figure_->joints[force.joint];
  plot.side("", J + mm * arrow.to_tail, J + mm * arrow.to_tip, Meaning::force, force.label);
}

// The lines of the forces as far as the strings that meet on them.
void TrussPanel::draw_strings(Plot& plot) const {
  const std::vector<Place>& vertices = funicular_->polygon.vertices;
  const Place& A = figure_->joints[figure_->outside[0].joint];
  const auto string = [&](const Place& from, const Place& to, const std::string& letters) {
    plot.segment(from, to, Meaning::construction);
    plot.label(letters, from + 0.5 * (to - from));
  };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    plot.in_step(i + 1 < vertices.size() ? 1 : 2);
    const std::size_t k = i < funicular_->loads.size() ? funicular_->loads[i] : 1;
    plot.segment(figure_->joints[figure_->outside[k].joint], vertices[i], Meaning::axis);
    string(i == 0 ? A : vertices[i - 1], vertices[i], std::to_string(i + 1) + "′");
    plot.dot(vertices[i]);
  }
  string(vertices.back(), A, "$c′$");
}

std::vector<PanelStep> TrussPanel::steps(const Plot&, const drawings::Box&) const {
  if (!funicular_) return {};
  const std::string A = "$" + figure_->letters[figure_->outside[0].joint] + "$",
                    B = "$" + figure_->letters[figure_->outside[1].joint] + "$";
  const std::string last = std::to_string(funicular_->loads.size() + 1);
  const Place& end = funicular_->polygon.vertices.back();
  return {{Words{"Of the hinge's force only the point " + A +
                     " is known: there begins the string 1′, parallel to the ray 1, to the line of the first load; "
                     "2′ parallel to 2 to the next, and so on.",
                 "Della reazione della cerniera è noto solo il punto " + A +
                     ": da lì il lato 1′, parallelo al raggio 1, fino alla retta del primo carico; 2′ parallelo a 2 "
                     "fino alla successiva, e così via."},
           funicular_->polygon.vertices.front()},
          {Words{last + "′ ends on the line of the roller's force through " + B +
                     "; the closing line $c′$ joins it with " + A + ".",
                 last + "′ finisce sulla retta della reazione del carrello per " + B +
                     "; la chiudente $c′$ la unisce ad " + A + "."},
           end}};
}

// Without the reactions.
void TrussPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  draw_truss(plot, false);
  for (std::size_t k = 2; k < figure_->outside.size(); ++k) draw_force(plot, k);
}

std::vector<drawings::Block> TrussPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  constexpr int closed = 2;  // the last step on the truss: its reactions are found
  if (funicular_) draw_strings(plot);
  draw_truss(plot, !funicular_);
  for (std::size_t k = 0; k < figure_->outside.size(); ++k) {
    if (funicular_) plot.in_step(k < 2 ? closed : from_beginning);
    draw_force(plot, k);
  }
  std::size_t signed_bars = 0;
  for (std::size_t i = 0; i < figure_->bars.size(); ++i) signed_bars += has_room_for_sign(i, plot.scale()) ? 1 : 0;
  if (signed_bars == figure_->bars.size()) return {};
  const Words of_some{"Beside some bars", "Accanto ad alcune aste"}, of_all{"Beside the bars", "Accanto alle aste"};
  const Words no_room{" there is no room for + and −: they stand on the next sheet.",
                      " non c'è posto per + e −: sono nella tavola che segue."};
  return {drawings::Paragraph{((signed_bars > 0 ? of_some : of_all) + no_room).in(language)}};
}

}  // namespace epure
