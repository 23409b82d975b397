#include "exercises/kit/panels/circles_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure {
namespace {

// A point of the line nearest to P.
Place foot_on(const DrawnCycle& line, const Place& P) {
  return *line.on_line + dot(P - *line.on_line, line.along) * line.along;
}

bool is_on(const Plot& plot, const Place& P, const Place& Q) {
  constexpr double told_apart = 0.5;  // mm
  return distance(P, Q) * plot.scale().mm_per_unit < told_apart;
}

// A right angle at P, unless two of its points are one on the paper.
void mark_right_angle(Plot& plot, const Place& P, const Place& Q, const Place& R) {
  if (!is_on(plot, P, Q) && !is_on(plot, P, R)) plot.right_angle(P, Q, R);
}

}  // namespace

CirclesPanel::CirclesPanel(const Solution& s, std::shared_ptr<const MechanismFigure> mechanism, const Case& of)
    : CutPanel(std::move(mechanism)), case_(of) {
  const std::string& prefix = of.prefix;
  P0_ = s.point(prefix + of.pole);
  J_ = s.point(prefix + "inflection_pole");
  K_ = s.point(prefix + "K");
  F_ = s.point(prefix + "inflection_centre");
  S_ = s.point(prefix + "stationarity_centre");
  if (P0_ && S_) S_prime_ = *S_ + (*S_ - *P0_);
  inflection_ = cycle_of(s, prefix + "inflection_centre", prefix + "inflection_diameter");
  stationarity_ = cycle_of(s, prefix + "stationarity_centre", prefix + "stationarity_diameter");
  driven_ = builder(s, of.driven);
  other_ = builder(s, of.other);
  if (of.driven_speeds_up)
    A_double_ = s.point(prefix + "Adoubleprime");
  else
    A_double_ = driven_.at;
}

CirclesPanel::Builder CirclesPanel::builder(const Solution& s, const Known& known) const {
  Builder X{.known = known,
            .letters = point_letters(known.point),
            .centre_letters = point_letters(known.centre),
            .at = s.place(case_.prefix + known.point),
            .prime = {}};
  X.prime = X.has_prime() ? s.point(case_.prefix + known.point + "prime") : X.at;
  return X;
}

bool CirclesPanel::needs_detail(double too_large) const {
  return J_ && S_prime_ && inflection_.centre && 2 * inflection_.radius > too_large * mechanism_->reach() &&
         2 * stationarity_.radius < too_large * mechanism_->reach();
}
CirclesPanel& CirclesPanel::detail() {
  shows_ = Shows::detail;
  return *this;
}
CirclesPanel& CirclesPanel::beside_detail() {
  shows_ = Shows::inflection_circle;
  return *this;
}

double CirclesPanel::reach() const {
  constexpr double smaller = 1.5;  // times: in the detail is more to see
  return shows_ == Shows::inflection_circle ? smaller * reach_of_overview(inflection_) : mechanism_->reach();
}

std::string CirclesPanel::pole_letters() const { return point_letters(case_.pole); }

drawings::Box CirclesPanel::covered(const Scale& lengths, double points, double circles) const {
  Extent extent;
  for (const Place& P : mechanism_->corners()) extent.include(lengths, P, 7);
  if (shows_ != Shows::inflection_circle) {
    include(extent, lengths, stationarity_, circles);
    for (const auto& P : {P0_, K_, S_prime_, A_double_}) include(extent, lengths, P, points);
  }
  if (shows_ == Shows::detail) return extent.box();
  include(extent, lengths, inflection_, circles);
  for (const auto& P : {P0_, J_, driven_.prime, other_.prime}) include(extent, lengths, P, points);
  return extent.box();
}

// The ray from the pole, X' on it, and there the perpendicular that leads to J. Where X is the pole its ray is that
// of its path, square to P₀J.
void CirclesPanel::draw_builder(Plot& plot, const drawings::Box& room, const Builder& X, Language language) const {
  if (!X.prime) return;
  if (!X.known.is_pole) plot.segment(*P0_, X.at, Meaning::construction);
  if (X.has_prime()) draw_to(plot, room, X.at, *X.prime, "$" + X.letters + "'$", language);
  if (X.has_prime()) {
    plot.dot(*X.prime, Meaning::locus);
    plot.label("$" + X.letters + "'$", *X.prime, X.at, Meaning::locus);
  }
  if (!J_) return;
  draw_to(plot, room, *X.prime, *J_, "$J$", language);
  const Arrow2 to_J = *J_ - *X.prime;
  mark_right_angle(plot, *X.prime, X.known.is_pole ? *X.prime + Arrow2{-to_J.y, to_J.x} : *P0_, *J_);
}

// On the circle where it is farthest from the mechanism, of places that are on the sheet.
void CirclesPanel::name_circle(Plot& plot, const drawings::Box& room, const DrawnCycle& circle, const Words& name,
                               Language language) const {
  if (!circle.centre) return;
  constexpr int places = 16;
  std::optional<Place> best;
  for (int i = 0; i < places; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / places;
    const Place P = *circle.centre + circle.radius * Arrow2{std::cos(turn), std::sin(turn)};
    if (is_in(room, plot, P) && (!best || distance(P, middle()) > distance(*best, middle()))) best = P;
  }
  if (best) plot.small_label(name.in(language), *best, *circle.centre);
}

void CirclesPanel::draw_inflection_circle(Plot& plot, const drawings::Box& room, Language language) const {
  plot.cycle(inflection_, Meaning::locus, "inflection_circle");
  if (translates() || !J_ || !F_) return;
  if (shows_ == Shows::detail) return draw_to(plot, room, *P0_, *J_, "$J$", language, Meaning::axis);
  for (const Builder* X : {&driven_, &other_}) draw_builder(plot, room, *X, language);
  draw_to(plot, room, *P0_, *J_, "$J$", language, Meaning::axis);
  draw_named(plot, J_, "$J$", *P0_);
  draw_named(plot, F_, "$F$", *P0_);
  name_circle(plot, room, inflection_, {"inflection circle", "circonferenza dei flessi"}, language);
  const Place O = mechanism_->corners().front();
  plot.measures(case_.prefix + "inflection_diameter", *P0_, *J_);
  plot.measures_coordinates(case_.prefix + "inflection_pole", *J_, O);
  plot.measures_coordinates(case_.prefix + "inflection_centre", *F_, O);
}

void CirclesPanel::draw_stationarity_circle(Plot& plot, const drawings::Box& room, Language language) const {
  plot.cycle(stationarity_, Meaning::second_locus, "stationarity_circle");
  if (!P0_ || !S_prime_) return;
  draw_to(plot, room, *P0_, *S_prime_, "$S'$", language, Meaning::axis);
  draw_named(plot, S_, "$S$", *P0_, Meaning::second_locus);
  draw_named(plot, S_prime_, "$S'$", *P0_, Meaning::second_locus);
  name_circle(plot, room, stationarity_, {"stationarity circle", "circonferenza di stazionarietà"}, language);
  plot.measures(case_.prefix + "stationarity_diameter", *P0_, *S_prime_);
  plot.measures_coordinates(case_.prefix + "stationarity_centre", *S_, mechanism_->corners().front());
  if (A_double_) {
    draw_to(plot, room, driven_.at, *A_double_, "$A''$", language);
    draw_to(plot, room, *A_double_, *S_prime_, "$S'$", language);
    mark_right_angle(plot, *A_double_, *P0_, *S_prime_);
    if (!is_on(plot, *A_double_, driven_.at)) {
      plot.dot(*A_double_, Meaning::second_locus);
      plot.label("$" + driven_.letters + "''$", *A_double_, driven_.at, Meaning::second_locus);
    }
  }
  if (!J_ || !K_) return;
  mark_right_angle(plot, *P0_, *P0_ + (*P0_ - *J_), *S_prime_);  // away from the right angles at the rays
  constexpr double told_from = 8;                                // mm beyond K: a stub at the border tells no more
  if (distance(*K_, seen_end(plot, room, *S_prime_, *J_)) * plot.scale().mm_per_unit > told_from)
    draw_to(plot, room, *S_prime_, *J_, "$J$", language);
  else
    plot.segment(*S_prime_, *J_, Meaning::construction);
  draw_to(plot, room, *P0_, *K_, "$K$", language);
  mark_right_angle(plot, *K_, *P0_, *S_prime_);
}

void CirclesPanel::draw_poles(Plot& plot) const {
  const Place O = mechanism_->corners().front();
  draw_named(plot, P0_, "$" + pole_letters() + "$", middle());
  if (P0_ && shows_ != Shows::detail) plot.measures_coordinates(case_.prefix + case_.pole, *P0_, O);
  if (shows_ == Shows::inflection_circle) return;
  draw_named(plot, K_, "$K$", middle(), Meaning::acceleration);
  if (K_) plot.measures_coordinates(case_.prefix + "K", *K_, O);
}

std::string CirclesPanel::left_out(const Plot& plot, const drawings::Box& room, Language language) const {
  if (shows_ == Shows::detail) return {};
  OffSheet off(plot, room);
  for (const Builder* X : {&driven_, &other_})
    if (X->has_prime()) off.point("$" + X->letters + "'$", X->prime);
  if (case_.driven_speeds_up) off.point("$" + driven_.letters + "''$", A_double_);
  for (const auto& [letters, P] : {std::pair{"$" + pole_letters() + "$", P0_}, std::pair{std::string("$J$"), J_},
                                   std::pair{std::string("$K$"), K_}, std::pair{std::string("$F$"), F_},
                                   std::pair{std::string("$S$"), S_}, std::pair{std::string("$S'$"), S_prime_}})
    off.point(letters, P);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, inflection_);
  if (shows_ == Shows::all)
    off.circle({"part of the stationarity circle", "parte della circonferenza di stazionarietà"}, stationarity_);
  return off.sentence(language);
}

// Beside its detail, which names all of it, it is small: only the points from which the construction starts are
// named.
void CirclesPanel::sketch_mechanism(Plot& plot) const {
  std::vector<drawings::Label>& labels = plot.onto().sheet.figure.labels;
  const auto before = static_cast<std::ptrdiff_t>(labels.size());
  mechanism_->sketch(plot);
  if (shows_ != Shows::inflection_circle) return;
  const auto is_of_detail = [&](const drawings::Label& label) {
    return label.text != "$" + driven_.letters + "$" && label.text != "$" + other_.letters + "$";
  };
  labels.erase(std::remove_if(labels.begin() + before, labels.end(), is_of_detail), labels.end());
}

std::vector<drawings::Block> CirclesPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  draw_inflection_circle(plot, room, language);
  if (shows_ != Shows::inflection_circle) draw_stationarity_circle(plot, room, language);
  sketch_mechanism(plot);
  draw_poles(plot);
  const std::string off = left_out(plot, room, language);
  if (off.empty()) return {};
  return {drawings::Paragraph{off}};
}

PanelStep CirclesPanel::step_to_prime(const Plot& plot, const drawings::Box& room, const Builder& X) const {
  const std::string P = pole_letters();
  return {format_words("${0}'$ on the ray ${1}{0}$, by Euler-Savary: ${1}{0}^{{2}}$ = ${2}{0}$·${0}'{0}$, on the "
                       "side of ${2}$ seen from ${0}$.",
                       "${0}'$ sul raggio ${1}{0}$, con Euler-Savary: ${1}{0}^{{2}}$ = ${2}{0}$·${0}'{0}$, dalla "
                       "parte di ${2}$ rispetto a{3} ${0}$.",
                       X.letters, P, X.centre_letters, std::string(X.letters.starts_with("A") ? "d" : "")),
          X.prime ? std::optional(seen_end(plot, room, X.at, *X.prime)) : X.at};
}

PanelStep CirclesPanel::step_to_J(const Plot& plot, const drawings::Box& room) const {
  const std::string P = pole_letters(), X = driven_.letters, Y = other_.letters;
  const std::optional<Place> at = J_ ? std::optional(seen_end(plot, room, *P0_, *J_)) : P0_;
  if (other_.known.is_pole) {
    const Words along =
        other_.is_straight()
            ? format_words("on the line of the path of ${0}$", "sulla retta della traiettoria di ${0}$", Y)
            : format_words("on the perpendicular to ${1}{0}$ at ${0}$", "sulla normale a ${1}{0}$ in ${0}$", Y,
                           other_.centre_letters);
    const Words touched = other_.is_straight() ? Words{"the normal to the path", "alla normale alla traiettoria"}
                                               : format_words("${0}{1}$", "alla ${0}{1}$", other_.centre_letters, Y);
    return {
        format_words(
            "Dead centre: ${0}$ is ${1}$. $J$ {2}, where the perpendicular to ${0}{3}$ at ${3}'$ meets it. The "
            "inflection circle has the diameter ${0}J$ and the centre $F$: it touches {4} at ${1}$ and passes "
            "through ${3}'$.",
            "Punto morto: ${0}$ è ${1}$. $J$ {2}, dove la incontra la normale a ${0}{3}$ in ${3}'$. La circonferenza "
            "dei flessi ha il diametro ${0}J$ e il centro $F$: è tangente in ${1}$ {4} e passa per ${3}'$.",
            P, Y, along, X, touched),
        at};
  }
  const Words where = other_.is_straight()
                          ? format_words("${0}'$, and to ${1}{2}$ at ${2}$, whose path is straight,",
                                         "${0}'$, e a ${1}{2}$ in ${2}$, la cui traiettoria è retta,", X, P, Y)
                          : format_words("${0}'$ and ${1}'$", "${0}'$ e ${1}'$", X, Y);
  return {format_words("The perpendiculars to the rays at {0} meet at the inflection pole $J$. The inflection circle "
                       "has the diameter ${1}J$ and the centre $F$.",
                       "Le normali ai raggi in {0} si incontrano nel polo dei flessi $J$. La circonferenza dei "
                       "flessi ha il diametro ${1}J$ e il centro $F$.",
                       where, P),
          at};
}

PanelStep CirclesPanel::step_to_S(const Plot& plot, const drawings::Box& room) const {
  const std::string P = pole_letters(), X = driven_.letters;
  if (is_steady())
    return {format_words("$α_{{3}}$ = 0: the stationarity circle is the line ${}J$.",
                         "$α_{{3}}$ = 0: la circonferenza di stazionarietà è la retta ${}J$.", P),
            P0_};
  const Words A_double = case_.driven_speeds_up
                             ? format_words(
                                   "${0}''$ on the ray ${1}{0}$, where the acceleration along the path is zero: "
                                   "${0}''{0}$ = |$a^{{t}}_{{{0}}}$ / $α_{{3}}$|. ",
                                   "${0}''$ sul raggio ${1}{0}$, dove l'accelerazione lungo la traiettoria è nulla: "
                                   "${0}''{0}$ = |$a^{{t}}_{{{0}}}$ / $α_{{3}}$|. ",
                                   X, P)
                             : format_words("The acceleration of ${0}$ is all normal. ",
                                            "L'accelerazione di ${0}$ è tutta normale. ", X);
  const std::string Q = case_.driven_speeds_up ? X + "''" : X;
  return {A_double +
              format_words("The perpendicular to the ray at ${1}$ meets the pole tangent (at ${0}$, perpendicular to "
                           "${0}J$) at $S'$. The stationarity circle has the diameter ${0}S'$ and the centre $S$.",
                           "La normale al raggio in ${1}$ incontra la tangente polare (in ${0}$, normale a ${0}J$) "
                           "in $S'$. La circonferenza di stazionarietà ha il diametro ${0}S'$ e il centro $S$.",
                           P, Q),
          S_prime_ ? std::optional(seen_end(plot, room, *P0_, *S_prime_)) : P0_};
}

// The pole is at infinity: both circles are lines, or nothing at all.
std::vector<PanelStep> CirclesPanel::steps_to_lines() const {
  const std::string P = pole_letters(), X = driven_.letters, Y = other_.letters;
  std::vector<PanelStep> steps{
      {format_words("${}$ is at infinity and $ω_{{3}}$ = 0: every point has the velocity of ${}$.",
                    "${}$ è all'infinito e $ω_{{3}}$ = 0: ogni punto ha la velocità di ${}$.", P, X)}};
  if (!inflection_.on_line || !stationarity_.on_line) return steps;
  const Words through_Y =
      other_.is_straight()
          ? format_words("through ${0}$, whose path is straight", "per ${0}$, la cui traiettoria è retta", Y)
          : format_words("at the distance $a^{{n}}_{{{0}}}$ / |$α_{{3}}$| from ${0}$",
                         "alla distanza $a^{{n}}_{{{0}}}$ / |$α_{{3}}$| da ${0}$", X);
  const Words through_X = case_.driven_speeds_up
                              ? format_words("at the distance |$a^{{t}}_{{{0}}}$ / $α_{{3}}$| from ${0}$",
                                             "alla distanza |$a^{{t}}_{{{0}}}$ / $α_{{3}}$| da ${0}$", X)
                              : format_words("through ${0}$, whose acceleration is all normal",
                                             "per ${0}$, la cui accelerazione è tutta normale", X);
  steps.push_back(
      {format_words("The inflection circle becomes a line perpendicular to the velocity, {}.",
                    "La circonferenza dei flessi diventa una retta normale alla velocità, {}.", through_Y),
       foot_on(inflection_, middle())});
  steps.push_back(
      {format_words("The stationarity circle becomes a line along the velocity, {}.",
                    "La circonferenza di stazionarietà diventa una retta lungo la velocità, {}.", through_X),
       foot_on(stationarity_, middle())});
  if (K_) steps.push_back({{"The two lines meet at $K$.", "Le due rette si incontrano in $K$."}, K_});
  return steps;
}

std::vector<PanelStep> CirclesPanel::steps(const Plot& plot, const drawings::Box& room) const {
  if (translates()) return steps_to_lines();
  std::vector<PanelStep> steps;
  if (shows_ != Shows::detail) {
    for (const Builder* X : {&driven_, &other_})
      if (X->has_prime()) steps.push_back(step_to_prime(plot, room, *X));
    steps.push_back(step_to_J(plot, room));
  }
  if (shows_ == Shows::inflection_circle) return steps;
  steps.push_back(step_to_S(plot, room));
  if (!K_) return steps;
  const std::string P = pole_letters();
  steps.push_back(
      {is_steady()
           ? Words{"The line meets the inflection circle again at $J$: $K$ is $J$.",
                   "La retta incontra ancora la circonferenza dei flessi in $J$: $K$ è $J$."}
           : format_words("$K$, where the circles meet again: the foot of the perpendicular from ${}$ to $JS'$.",
                          "$K$, dove le due si incontrano ancora: il piede della normale da ${}$ a $JS'$.", P),
       K_});
  return steps;
}

// In the picture of the whole inflection circle they stand together, and apart in the detail.
std::vector<Place> CirclesPanel::lettered() const {
  if (shows_ == Shows::inflection_circle) return {};
  std::vector<Place> all = mechanism_->corners();
  const auto add = [&](const std::optional<Place>& P) {
    if (P) all.push_back(*P);
  };
  for (const auto& P : {P0_, K_, S_, S_prime_, A_double_}) add(P);
  if (shows_ == Shows::all)
    for (const auto& P : {J_, F_, driven_.prime, other_.prime}) add(P);
  return all;
}

std::vector<std::pair<std::string, std::string>> CirclesPanel::points(const std::string& pole,
                                                                      const std::string& prefix) {
  return {{"$" + point_letters(pole) + "$", prefix + pole},
          {"$J$", prefix + "inflection_pole"},
          {"$K$", prefix + "K"},
          {"$F$", prefix + "inflection_centre"},
          {"$S$", prefix + "stationarity_centre"}};
}

}  // namespace epure
