#include "exercises/kit/panels/mohr_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double mohr_letters = 9, mohr_longest = 120;  // mm

}  // namespace

Place MohrPanel::tip() const { return {centre().x, std::numbers::sqrt3 * radius()}; }

std::vector<Place> MohrPanel::lettered() const {
  return {{of_.sigma, of_.tau}, {0, -of_.tau}, {of_.sigma, -of_.tau}, {of_.sigma_I, 0}, {of_.sigma_II, 0}, {0, 0}};
}

Panel::Vectors MohrPanel::vectors() const { return {of_.unit, of_.sigma_I - of_.sigma_II, mohr_longest}; }

drawings::Box MohrPanel::extent(const Scale&, const Scale& vectors) const {
  Extent extent;
  extent.include(vectors, {of_.sigma_II, -radius()}, mohr_letters);
  extent.include(vectors, {of_.sigma_I, radius()}, mohr_letters);
  extent.include(vectors, {0, 0}, mohr_letters);
  extent.include(vectors, tip(), mohr_letters);
  return extent.box();
}

void MohrPanel::measure(Plot& plot, const std::string& name, const Place& from, const Place& to,
                        Measurement::Kind kind) const {
  if (name.empty() || !plot.shows(from) || !plot.shows(to)) return;
  plot.onto().measurements.push_back({name, plot.at(from), plot.at(to), of_.si / plot.scale().mm_per_unit, kind});
}

void MohrPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const Place O{0, 0};
  const double mm = plot.scale().mm_per_unit, high = radius();
  plot.long_segment({std::min(0.0, of_.sigma_II), 0}, {of_.sigma_I, 0}, 7, Meaning::axis);
  plot.long_segment({0, -high}, {0, high}, 5, Meaning::axis);
  plot.label("$σ$", {of_.sigma_I + 8 / mm, 0}, O);
  plot.label("$τ$", {0, high + 6 / mm}, O);
}

// The face on which σ_I acts, drawn on beyond the circle, and how far it is turned from the face across.
void MohrPanel::draw_direction(Plot& plot, const Place& X, const Place& pole, const Place& I) const {
  constexpr double beyond = 30, at_end = 4;  // mm
  const double to_I = distance(pole, I);
  if (to_I == 0 || distance(pole, X) == 0) return;
  const double mm = plot.scale().mm_per_unit, along = direction(pole, I), across = direction(pole, X);
  plot.segment(pole, pole + (1 + beyond / (to_I * mm)) * (I - pole), Meaning::construction);
  if (of_.direction_letters.empty()) return;
  const double radius = to_I * mm + beyond - at_end, middle = (along + across) / 2;
  plot.segment(X, pole + radius / (distance(pole, X) * mm) * (X - pole), Meaning::construction);
  plot.mark(drawings::AngleMark{plot.at(pole), radius, std::min(along, across), std::max(along, across)});
  plot.small_label(of_.direction_letters, pole + radius / mm * Arrow2{std::cos(middle), std::sin(middle)}, pole);
}

std::vector<drawings::Block> MohrPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const Place O{0, 0}, X{of_.sigma, of_.tau}, Y{0, -of_.tau}, pole{of_.sigma, -of_.tau}, C = centre();
  const Place I{of_.sigma_I, 0}, II{of_.sigma_II, 0};
  draw_given(plot, room, language);
  plot.circle(C, radius(), Meaning::locus);
  plot.segment(X, Y, Meaning::construction);
  draw_direction(plot, X, pole, I);
  plot.segment(pole, X, Meaning::construction);
  plot.segment(II, tip(), Meaning::construction);
  plot.segment(I, tip(), Meaning::construction);
  plot.mark(drawings::Line{drawings::segment(plot.at(O), plot.at(tip())), Meaning::force, of_.equivalent_name});
  plot.onto().sheet.figure.labels.push_back(
      {.text = "$σ_{eq}$", .at = plot.at(O), .to = plot.at(tip()), .ink = Meaning::force});
  for (const Place& P : {X, Y, C, pole}) plot.dot(P);
  for (const Place& P : {I, II}) plot.cross(P, Meaning::force);
  plot.label("$X$", X, C);
  plot.label("$Y$", Y, C);
  plot.label("$c$", C, tip());
  plot.label("$\\it{P}$", pole, C);
  plot.label("$σ_{I}$", I, C, Meaning::force);
  plot.label("$σ_{II}$", II, C, Meaning::force);
  measure(plot, of_.sigma_name, O, {of_.sigma, 0}, Measurement::along_x);
  measure(plot, of_.tau_name, {of_.sigma, 0}, X, Measurement::along_y);
  measure(plot, of_.sigma_I_name, O, I, Measurement::along_x);
  measure(plot, of_.sigma_II_name, O, II, Measurement::along_x);
  measure(plot, of_.centre_name, O, C, Measurement::along_x);
  measure(plot, of_.radius_name, C, X, Measurement::length);
  measure(plot, of_.equivalent_name, O, tip(), Measurement::length);
  return {};
}

std::vector<PanelStep> MohrPanel::steps(const Plot&, const drawings::Box&) const {
  const Words state = decimal("$X$: " + of_.sigma_letters + ", " + of_.tau_letters + "; $Y$: 0, −" + of_.tau_letters);
  return {{Words{"The faces across and along the beam: ", "Le facce trasversale e longitudinale della trave: "} +
               state + Words{". $XY$ is a diameter.", ". $XY$ è un diametro."},
           Place{of_.sigma, of_.tau}},
          {{"Where the circle crosses the axis of $σ$: $σ_{I}$ and $σ_{II}$.",
            "Dove il cerchio incontra l'asse delle $σ$: $σ_{I}$ e $σ_{II}$."},
           Place{of_.sigma_I, 0}},
          {{"The pole $\\it{P}$: through $X$ the parallel to the face across. From $\\it{P}$ to $σ_{I}$: the face on "
            "which $σ_{I}$ acts.",
            "Il polo $\\it{P}$: da $X$ la parallela alla faccia trasversale. Da $\\it{P}$ a $σ_{I}$: la giacitura su "
            "cui agisce la $σ_{I}$."},
           Place{of_.sigma, -of_.tau}},
          {{"The equilateral triangle over $σ_{II}σ_{I}$: its tip is $σ_{eq}$ from the origin, "
            "$σ_{eq}^{2}$ = $σ_{I}^{2}$ − $σ_{I}σ_{II}$ + $σ_{II}^{2}$ (von Mises).",
            "Il triangolo equilatero su $σ_{II}σ_{I}$: il vertice dista dall'origine $σ_{eq}$, "
            "$σ_{eq}^{2}$ = $σ_{I}^{2}$ − $σ_{I}σ_{II}$ + $σ_{II}^{2}$ (von Mises)."},
           tip()}};
}

}  // namespace epure
