#include "exercises/kit/panels/curvature_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/osculating_arc.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure {
namespace {

constexpr double along_path = 18;  // mm of a path to each side of its point

std::string centre_of(const std::string& letters) { return "$Ω_{" + letters + "}$"; }
std::string primed(const std::string& letters) { return "$" + letters + "'$"; }

std::vector<drawings::Block> told(const OffSheet& off, Language language) {
  const std::string sentence = off.sentence(language);
  if (sentence.empty()) return {};
  return {drawings::Paragraph{sentence}};
}

}  // namespace

RaysPanel::RaysPanel(const Solution& s, std::shared_ptr<const MechanismFigure> mechanism, Curved of)
    : CutPanel(std::move(mechanism)), curved_(std::move(of)) {
  const std::string& prefix = curved_.prefix;
  P0_ = s.point(prefix + curved_.pole);
  J_ = s.point(prefix + "inflection_pole");
  F_ = s.point(prefix + "inflection_centre");
  inflection_ = cycle_of(s, prefix + "inflection_centre", prefix + "inflection_diameter");
  for (const std::string& X : curved_.points)
    points_.push_back({X, point_letters(X), s.place(prefix + X), s.point(prefix + X + "prime")});
}

// Beside a picture of the whole mechanism its own is smaller.
double RaysPanel::reach() const {
  constexpr double smaller = 1.5;
  return (is_overview() ? smaller : 1) * reach_of_overview(inflection_);
}

drawings::Box RaysPanel::covered(const Scale& lengths, double points, double circles) const {
  Extent extent;
  for (const Place& P : mechanism_->corners()) extent.include(lengths, P, 7);
  include(extent, lengths, inflection_, circles);
  include(extent, lengths, P0_, points);
  for (const OnRay& X : points_) include(extent, lengths, X.prime, points);
  return extent.box();
}

// Opposite the mechanism, where it is on the sheet.
void RaysPanel::name_circle(Plot& plot, const drawings::Box& room, Language language) const {
  const double away = direction(middle(), *F_);
  const Place P = *F_ + inflection_.radius * Arrow2{std::cos(away), std::sin(away)};
  if (is_in(room, plot, P))
    plot.small_label(Words{"inflection circle", "circonferenza dei flessi"}.in(language), P, *F_);
}

void RaysPanel::draw_circle(Plot& plot, const drawings::Box& room, Language language) const {
  plot.cycle(inflection_, Meaning::locus);
  if (!P0_ || !J_) return;
  draw_to(plot, room, *P0_, *J_, "$J$", language, Meaning::axis);
  draw_named(plot, J_, "$J$", *P0_);
  draw_named(plot, F_, "$F$", *P0_);
  if (F_) name_circle(plot, room, language);
}

void RaysPanel::draw_rays(Plot& plot, const drawings::Box& room, Language language) const {
  for (const OnRay& X : points_) {
    plot.dot(X.at, Meaning::link);
    if (!P0_ || !X.prime) continue;
    plot.segment(*P0_, X.at, Meaning::construction);
    draw_to(plot, room, X.at, *X.prime, primed(X.letters), language);
    plot.dot(*X.prime, Meaning::locus);
    plot.label(primed(X.letters), *X.prime, *P0_, Meaning::locus);
    plot.measures(curved_.prefix + X.name + "prime_" + X.name, *X.prime, X.at);
    plot.measures_coordinates(curved_.prefix + X.name + "prime", *X.prime, mechanism_->corners().front());
  }
  draw_named(plot, P0_, "$" + point_letters(curved_.pole) + "$", middle());
}

void RaysPanel::note_off(OffSheet& off) const {
  off.point("$" + point_letters(curved_.pole) + "$", P0_);
  for (const OnRay& X : points_) off.point(primed(X.letters), X.prime);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, inflection_);
}

std::vector<drawings::Block> RaysPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  draw_circle(plot, room, language);
  auto& labels = plot.onto().sheet.figure.labels;
  const auto before = static_cast<std::ptrdiff_t>(labels.size());
  mechanism_->sketch(plot);
  // Letters are as large as ever where the mechanism is small: the other picture names its other points.
  if (dwarfs_mechanism(inflection_))
    labels.erase(std::remove_if(labels.begin() + before, labels.end(),
                                [&](const drawings::Label& of) {
                                  return std::none_of(points_.begin(), points_.end(), [&](const OnRay& X) {
                                    return of.text == "$" + X.letters + "$";
                                  });
                                }),
                 labels.end());
  draw_rays(plot, room, language);
  OffSheet off(plot, room);
  note_off(off);
  return told(off, language);
}

std::vector<PanelStep> RaysPanel::steps(const Plot& plot, const drawings::Box& room) const {
  const std::string P = point_letters(curved_.pole);
  std::vector<PanelStep> steps;
  if (P0_ && J_)
    steps.push_back({format_words("The inflection circle, of diameter ${}J$, from sheet\u00a0{}.",
                                  "La circonferenza dei flessi, di diametro ${}J$, dalla tavola\u00a0{}.", P,
                                  curved_.circles_sheet),
                     seen_end(plot, room, *P0_, *J_)});
  bool is_first = true;
  for (const OnRay& X : points_) {
    if (!X.prime) continue;
    const Words text = std::exchange(is_first, false)
                           ? format_words("The ray ${1}{0}$ meets the circle again at ${0}'$.",
                                          "Il raggio ${1}{0}$ la incontra ancora in ${0}'$.", X.letters, P)
                           : format_words("Likewise ${0}'$ on the ray ${1}{0}$.",
                                          "Analogamente ${0}'$ sul raggio ${1}{0}$.", X.letters, P);
    steps.push_back({text, seen_end(plot, room, X.at, *X.prime)});
  }
  return steps;
}

OsculatingPanel::OsculatingPanel(const Solution& s, std::shared_ptr<const MechanismFigure> mechanism, Curved of,
                                 DrawPath draw_path)
    : CutPanel(std::move(mechanism)), curved_(std::move(of)), draw_path_(std::move(draw_path)) {
  const std::string& prefix = curved_.prefix;
  P0_ = s.point(prefix + curved_.pole);
  for (const std::string& X : curved_.points)
    points_.push_back({X, point_letters(X), s.place(prefix + X), s.point(prefix + "curvature_centre_" + X),
                       s.value(prefix + curved_.pole + X) == 0.0});
}

// The mechanism, and the points with a piece of their paths.
drawings::Box OsculatingPanel::covered(const Scale& lengths, double points, double circles) const {
  Extent extent;
  for (const OnPath& X : points_) {
    constexpr double needed = 17;  // mm of the path
    extent.include(lengths, X.at, needed);
    include(extent, lengths, X.centre, points);
  }
  include(extent, lengths, P0_, points);
  mechanism_->include(extent, lengths);
  if (rays_) {
    const drawings::Box of_rays = rays_->covered(lengths, points, circles);
    extent.include(of_rays.low.x, of_rays.low.y);
    extent.include(of_rays.high.x, of_rays.high.y);
  }
  return extent.box();
}

void OsculatingPanel::draw_centre(Plot& plot, const drawings::Box& room, const OnPath& X, Language language) const {
  if (!X.centre) return;
  draw_osculating_arc(plot, X.at, *X.centre);
  if (!is_in(room, plot, *X.centre)) {
    draw_towards(plot, room, X.at, *X.centre, centre_of(X.letters), language);
    return;
  }
  plot.segment(*X.centre, X.at, Meaning::dimension, "rho_" + X.name);
  draw_named(plot, X.centre, centre_of(X.letters), X.at);
  plot.measures(curved_.prefix + "rho_" + X.name, *X.centre, X.at);
  plot.measures_coordinates(curved_.prefix + "curvature_centre_" + X.name, *X.centre, mechanism_->corners().front());
}

// What else of the path the tracer found is cut off.
void OsculatingPanel::draw_piece_of_path(Plot& plot, const drawings::Box& room, const OnPath& X) const {
  const drawings::Point at = plot.at(X.at);
  const drawings::Box around{{at.x - along_path, at.y - along_path}, {at.x + along_path, at.y + along_path}};
  if (!drawings::contains(room, at)) return;
  drawings::Figure& figure = plot.onto().sheet.figure;
  const auto cut = [&](const drawings::Box& window) {
    figure.windows.push_back(window);
    figure.window_of.resize(figure.marks.size(), static_cast<int>(figure.windows.size()) - 1);
  };
  cut(room);
  draw_path_(plot, X.name, around);
  cut(drawings::intersection(room, around));
}

std::vector<drawings::Block> OsculatingPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const Place O = mechanism_->corners().front();
  if (rays_) rays_->draw_circle(plot, room, language);
  for (const OnPath& X : points_) {
    if (!P0_) continue;
    if (!rays_) draw_to(plot, room, X.at, *P0_, "$" + point_letters(curved_.pole) + "$", language);
    plot.measures(curved_.prefix + curved_.pole + X.name, *P0_, X.at);
  }
  if (!rays_) draw_named(plot, P0_, "$" + point_letters(curved_.pole) + "$", middle());
  if (P0_) plot.measures_coordinates(curved_.prefix + curved_.pole, *P0_, O);
  mechanism_->draw(plot);
  OffSheet off(plot, room);
  if (rays_) {
    rays_->draw_rays(plot, room, language);
    rays_->note_off(off);
  }
  for (const OnPath& X : points_) {
    draw_centre(plot, room, X, language);
    off.point(centre_of(X.letters), X.centre);
    draw_piece_of_path(plot, room, X);  // over the arc, which it nearly covers
  }
  return told(off, language);
}

Words OsculatingPanel::step_to(const OnPath& X, bool is_first) const {
  const std::string P = point_letters(curved_.pole);
  if (X.is_pole)
    return format_words(
        "${0}$ is the pole: its path has a cusp there or goes back on itself, and no ray leads to a centre of "
        "curvature.",
        "${0}$ è il polo: lì la sua traiettoria ha una cuspide o torna su sé stessa, e nessun raggio porta a un "
        "centro di curvatura.",
        X.letters);
  if (!X.centre)
    return format_words(
        "${0}$ lies on the inflection circle: its path is straight to the second order.",
        "${0}$ sta sulla circonferenza dei flessi: la sua traiettoria è rettilinea al secondo ordine.", X.letters);
  if (!P0_)
    return format_words(
        "$Ω_{{{0}}}$ on the normal to $\\vec{{v}}_{{{0}}}$, at $ρ_{{{0}}}$ = $v^{{2}}_{{{0}}}$ / $a^{{n}}_{{{0}}}$.",
        "$Ω_{{{0}}}$ sulla normale a $\\vec{{v}}_{{{0}}}$, a $ρ_{{{0}}}$ = $v^{{2}}_{{{0}}}$ / $a^{{n}}_{{{0}}}$.",
        X.letters);
  if (!is_first)
    return format_words("Likewise $Ω_{{{0}}}$: ${1}{0}^{{2}}$ = $Ω_{{{0}}}{0}$·${0}'{0}$.",
                        "Analogamente $Ω_{{{0}}}$: ${1}{0}^{{2}}$ = $Ω_{{{0}}}{0}$·${0}'{0}$.", X.letters, P);
  return format_words(
      "Euler-Savary: ${1}{0}^{{2}}$ = $Ω_{{{0}}}{0}$·${0}'{0}$ gives $Ω_{{{0}}}$ on the ray, on the same side of "
      "${0}$ as ${0}'$. The thin arc about it osculates the path of ${0}$, of which a piece is drawn.",
      "Euler-Savary: ${1}{0}^{{2}}$ = $Ω_{{{0}}}{0}$·${0}'{0}$ dà $Ω_{{{0}}}$ sul raggio, dalla stessa parte di "
      "${0}'$ rispetto a ${0}$. L'arco sottile di questo centro oscula la traiettoria di ${0}$, della quale è "
      "disegnato un tratto.",
      X.letters, P);
}

std::vector<PanelStep> OsculatingPanel::steps(const Plot& plot, const drawings::Box& room) const {
  std::vector<PanelStep> steps;
  if (rays_) steps = rays_->steps(plot, room);
  bool is_first = true;
  for (const OnPath& X : points_) {
    steps.push_back({step_to(X, is_first)});
    if (!X.centre) continue;
    steps.back().at = seen_end(plot, room, X.at, *X.centre);
    is_first = false;
  }
  return steps;
}

Panels curvature_panels(const Solution& s, const std::shared_ptr<const MechanismFigure>& mechanism, const Curved& of,
                        const OsculatingPanel::DrawPath& draw_path) {
  OsculatingPanel osculating(s, mechanism, of, draw_path);
  if (!s.point(of.prefix + of.pole)) return panels(std::move(osculating));
  RaysPanel rays(s, mechanism, of);
  if (!rays.is_overview()) return panels(std::move(osculating.with_rays(std::move(rays))));
  return panels(std::move(rays), std::move(osculating));
}

}  // namespace epure
