#include "exercises/pin-in-slot/relative_pole_panel.h"

#include <cmath>

#include "exercises/kit/panels/edge.h"

namespace epure::pin_in_slot {

RelativePolePanel::RelativePolePanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism)
    : mechanism_(std::move(mechanism)),
      normal_(-geometry::quarter_turn(solution.vector("slot"))),
      speed_(std::abs(geometry::to_double(solution.givens().angle("omega")))) {
  if (const auto x = solution.value("P23_x")) pole_ = Place{*x, mechanism_->at("O").y};
}

drawings::Box RelativePolePanel::extent(const Scale& lengths, const Scale& vectors) const {
  constexpr double letters = 7;  // mm
  const drawings::Box near = extent_of_near(lengths, vectors);
  Extent extent;
  extent.include(near.low.x, near.low.y);
  extent.include(near.high.x, near.high.y);
  if (pole_) extent.include(lengths, *pole_, letters);
  return extent.box();
}

drawings::Box RelativePolePanel::extent_of_near(const Scale& lengths, const Scale&) const {
  Extent extent;
  mechanism_->include(extent, lengths);
  return extent.box();
}

void RelativePolePanel::draw_given(Plot& plot, const drawings::Box&, Language) const { mechanism_->draw_given(plot); }

std::vector<drawings::Block> RelativePolePanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const Place &O = mechanism_->at("O"), &B = mechanism_->at("B"), &D = mechanism_->at("D");
  constexpr double beyond = 4;  // mm
  if (pole_ && is_in(room, plot, *pole_)) {
    plot.long_segment(B, *pole_, beyond, Meaning::construction);
    plot.long_segment(D, *pole_, beyond, Meaning::axis);
    plot.cross(*pole_);
    plot.label("$P_{23}$", *pole_, B, Meaning::locus);
    plot.measures_abscissa("P23_x", *pole_, O);
  } else {
    draw_towards(plot, room, B, B + normal_, "$P_{23}$", language);
  }
  mechanism_->draw(plot);
  plot.right_angle(B, B + normal_, B + geometry::quarter_turn(normal_));  // over the slot, which would hide it
  plot.measures_abscissa("B_x", D, O);
  return {};
}

std::vector<PanelStep> RelativePolePanel::steps(const Plot& plot, const drawings::Box& room) const {
  const Place &B = mechanism_->at("B"), &D = mechanism_->at("D");
  const bool is_drawn = pole_ && is_in(room, plot, *pole_);
  const Place on_normal = is_drawn ? B + 0.5 * (*pole_ - B) : ray_to_edge(plot, room, B, normal_);
  PanelStep meeting{{"The normal to the slot at $B$ meets the guide at $P_{23}$, the pole of disc and lever: one "
                     "velocity on both, $ω_{3}$·$DP_{23}$ = $ω_{2}$·$OP_{23}$.",
                     "La normale al glifo in $B$ incontra la guida in $P_{23}$, polo del moto relativo di disco e "
                     "glifo: una sola velocità, $ω_{3}$·$DP_{23}$ = $ω_{2}$·$OP_{23}$."},
                    on_normal};
  if (!pole_)
    meeting.text = {
        "The normal to the slot at $B$ is parallel to the guide: $P_{23}$, the pole of disc and lever, is at "
        "infinity, so $ω_{3}$ = $ω_{2}$.",
        "La normale al glifo in $B$ è parallela alla guida: $P_{23}$, polo del moto relativo di disco e glifo, è "
        "all'infinito, e $ω_{3}$ = $ω_{2}$."};
  return {meeting,
          {{"The disc rolls: $D$ is its pole $P_{13}$, and $v_{B}$ = −$ω_{3}$·$\\it{R}$.",
            "Il disco rotola: $D$ è il suo polo $P_{13}$, e $v_{B}$ = −$ω_{3}$·$\\it{R}$."},
           D}};
}

std::optional<MeasuredTable> RelativePolePanel::measured(const Readings& read) const {
  if (!read.has("P23_x") || !read.has("B_x") || !read.is_unit("v_B")) return {};
  const double DP23 = read["P23_x"] - read["B_x"];
  if (!read.is_unit(DP23, "P23_x")) return {};
  return MeasuredTable{{},
                       {{"|$ω_{3}$| (rad/s)", read["v_B"] / mechanism_->at("B").y, speed_ * read["P23_x"] / DP23}},
                       {"polygon", "poligono"},
                       {"poles", "poli"}};
}

}  // namespace epure::pin_in_slot
