#include "exercises/kit/panels/cam_panel.h"

namespace epure {
namespace {

constexpr double beyond = 7, room_for_letters = 12;  // mm

// Where an axis ends, so many millimetres beyond the roller.
Place end_of(const CamFollowerPosition& at, double roller, double mm, const Scale& scale) {
  const Arrow2 v = at.roller - at.foot;
  const double length = magnitude(v);
  return length == 0 ? at.roller : at.roller + ((roller + mm / scale.mm_per_unit) / length) * v;
}

}  // namespace

drawings::Box CamPanel::extent(const Scale& lengths, const Scale&) const {
  Extent extent;
  extent.include(lengths, cam_.A, lengths.mm_per_unit * cam_.disc);
  for (const CamFollowerPosition& at : cam_.positions)
    extent.include(lengths, end_of(at, cam_.roller, room_for_letters, lengths), 2);
  return extent.box();
}

std::vector<drawings::Block> CamPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const double offset = distance(cam_.A0, cam_.positions.front().foot),
               base = distance(cam_.A0, cam_.positions.front().lowest);
  plot.circle(cam_.A, distance(cam_.A, cam_.positions.front().roller), Meaning::locus, "pitch");
  plot.circle(cam_.A0, base, Meaning::construction);
  if (offset > 0) plot.circle(cam_.A0, offset, Meaning::construction);
  for (const CamFollowerPosition& at : cam_.positions) {
    plot.segment(at.foot, end_of(at, cam_.roller, beyond, plot.scale()), Meaning::construction);
    if (cam_.roller > 0) plot.circle(at.roller, cam_.roller, Meaning::alternative);
    plot.segment(at.lowest, at.roller, Meaning::velocity);
    plot.dot(at.roller, Meaning::locus);
    plot.small_label(at.number, end_of(at, cam_.roller, beyond + 2, plot.scale()), cam_.A0);
    if (!at.lift.empty()) plot.measures(at.lift, at.lowest, at.roller);
  }
  draw_given(plot, room, language);
  return {};
}

void CamPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  plot.circle(cam_.A, cam_.disc, Meaning::link, "cam");
  plot.segment(cam_.A0, cam_.A, Meaning::link);
  plot.hinge(cam_.A0);
  plot.dot(cam_.A, Meaning::link);
  const Arrow2 apart = cam_.A - cam_.A0;
  plot.label("$A_{0}$", cam_.A0, cam_.A);
  plot.label("$A$", cam_.A, cam_.A0 + (-1.0) * apart);
}

std::vector<PanelStep> CamPanel::steps(const Plot&, const drawings::Box&) const {
  std::vector<PanelStep> all;
  for (const auto& [text, at] : cam_.steps) all.push_back({text, at});
  return all;
}

}  // namespace epure
