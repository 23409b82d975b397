#include "exercises/crane-welds/throat_panel.h"

#include <numbers>

namespace epure::crane_welds {
namespace {

constexpr double around = 12;  // mm, for dimensions and letters

}  // namespace

Place ThroatPanel::foot() const {
  const double along = throat_ / std::numbers::sqrt2;
  return {corner().x + along, -along};
}

drawings::Box ThroatPanel::extent(const Scale& lengths, const Scale&) const {
  Extent extent;
  extent.include(lengths, {-beside(), -below()}, around);
  extent.include(lengths, {beside(), wall_}, around);
  return extent.box();
}

void ThroatPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const double w = wall_ / 2, b = beside(), d = below();
  const std::vector<Place> flange{{-b, 0}, {b, 0}, {b, wall_}, {-b, wall_}}, web{{-w, -d}, {w, -d}, {w, 0}, {-w, 0}};
  for (const std::vector<Place>& wall : {flange, web}) plot.area(wall, Meaning::plate);
  for (const auto& [from, to] : {std::pair{Place{-b, 0}, Place{b, 0}},
                                 {Place{-b, wall_}, Place{b, wall_}},
                                 {Place{-w, 0}, Place{-w, -d}},
                                 {Place{w, 0}, Place{w, -d}}})
    plot.segment(from, to, Meaning::link);
}

std::vector<drawings::Block> ThroatPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const double w = wall_ / 2, d = below();
  draw_given(plot, room, language);
  for (const double side : {-1.0, 1.0}) {
    const std::vector<Place> fillet{{side * w, 0}, {side * (w + leg_), 0}, {side * w, -leg_}};
    plot.area(fillet, Meaning::force);
    plot.polygon(fillet, Meaning::force);
  }
  plot.mark(drawings::Line{drawings::segment(plot.at(corner()), plot.at(foot())), Meaning::link, "a"});
  plot.right_angle(foot(), corner(), {w + leg_, 0});
  plot.onto().sheet.figure.labels.push_back({.text = "$a$", .at = plot.at(corner()), .to = plot.at(foot())});
  plot.mark(drawings::Dimension{plot.at({w, -leg_}), plot.at({w + leg_, -leg_}), -6, "$b$"});
  plot.segment({w + leg_, 0}, {w + leg_, -leg_}, Meaning::construction);
  plot.mark(drawings::Dimension{plot.at({-w - leg_, 0}), plot.at({-w - leg_, -leg_}), -6, "$b$"});
  plot.segment({-w - leg_, -leg_}, {-w, -leg_}, Meaning::construction);
  plot.mark(drawings::Dimension{plot.at({-w, -d}), plot.at({w, -d}), -6, "$s_{1}$"});
  plot.measures("a", corner(), foot());
  return {};
}

std::vector<PanelStep> ThroatPanel::steps(const Plot&, const drawings::Box&) const {
  return {{{"The legs $b$ of the fillet along web and flange; its face joins their ends.",
            "I lati $b$ del cordone lungo anima e piattabanda; la faccia ne unisce gli estremi."},
           Place{corner().x + leg_, 0}},
          {{"From the corner the perpendicular to the face: the throat $a$ = $b$/√2. On two of them acts $τ_{a}$ = "
            "$q$/(2$a$).",
            "Dallo spigolo la perpendicolare alla faccia: la sezione di gola $a$ = $b$/√2. Su due di esse agisce "
            "$τ_{a}$ = $q$/(2$a$)."},
           foot()}};
}

}  // namespace epure::crane_welds
