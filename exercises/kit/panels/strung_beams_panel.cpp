#include "exercises/kit/panels/strung_beams_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double between_rows = 11, between_beams = 13, strung_letters = 7;  // mm
constexpr double tallest_moment = 17, tallest_weight = 24;                   // mm

// How far a row reaches above and below its level, in the unit of its values.
struct Heights {
  double above = 0, below = 0;
  void include(double value) {
    above = std::max(above, value);
    below = std::max(below, -value);
  }
  double most() const { return std::max(above, below); }
};

// Positive moments are laid off downwards, where the fibres are in tension.
Heights heights_of_moments(const std::vector<StrungBeam>& beams) {
  Heights all;
  for (const StrungBeam& beam : beams)
    for (const double moment : beam.moments) all.include(-moment);
  return all;
}
Heights heights_of_weights(const std::vector<StrungBeam>& beams) {
  Heights all;
  for (const StrungBeam& beam : beams) {
    all.include(beam.weights[0]);
    all.include(beam.weights[0] + beam.weights[1]);
  }
  return all;
}
Heights heights_of_corners(const std::vector<StrungBeam>& beams) {  // mm
  Heights all;
  for (const StrungBeam& beam : beams)
    for (const Place& corner : beam.corners) all.include(1000 * corner.y);
  return all;
}

}  // namespace

StrungBeamsPanel::StrungBeamsPanel(std::vector<StrungBeam> beams, std::array<Words, 4> told, Language language)
    : beams_(std::move(beams)),
      told_(std::move(told)),
      moments_(largest_vector_scale(tallest_moment / heights_of_moments(beams_).most(), "N m", language)),
      weights_(largest_vector_scale(tallest_weight / heights_of_weights(beams_).most(), "rad", language)) {}

double StrungBeamsPanel::reach() const {
  double sum = 0;
  for (const StrungBeam& beam : beams_) sum += beam.length;
  return sum;
}

namespace {

// The steps of the construction.
constexpr int weighed = 1, joined_to_pole = 2, strung = 3, read_off = 4;

}  // namespace

Panel::Vectors StrungBeamsPanel::vectors() const {
  constexpr double longest_on_paper = 32;  // mm
  return {"mm", heights_of_corners(beams_).most(), longest_on_paper};
}

// 1 rad at the scale of the weights, with the slope that the two other scales give it.
double StrungBeamsPanel::pole_distance(double mm_per_metre, double mm_per_mm) const {
  return weights_.mm_per_unit * mm_per_metre / (1000 * mm_per_mm);
}

StrungBeamsPanel::Places StrungBeamsPanel::places(double mm_per_metre, double mm_per_mm) const {
  const Heights moments = heights_of_moments(beams_), corners = heights_of_corners(beams_),
                weights = heights_of_weights(beams_);
  Places at{corners.above * mm_per_mm + between_rows + moments.below * moments_.mm_per_unit,
            -(corners.below * mm_per_mm + between_rows + weights.above * weights_.mm_per_unit),
            {}};
  double x = 0;
  for (const StrungBeam& beam : beams_) {
    at.begin.push_back(x);
    x += std::max(beam.length * mm_per_metre, pole_distance(mm_per_metre, mm_per_mm)) + between_beams;
  }
  return at;
}

drawings::Box StrungBeamsPanel::extent(const Scale& lengths, const Scale& vectors) const {
  const Places at = places(lengths.mm_per_unit, vectors.mm_per_unit);
  const double right = at.begin.back() + std::max(beams_.back().length * lengths.mm_per_unit,
                                                  pole_distance(lengths.mm_per_unit, vectors.mm_per_unit));
  return {{-strung_letters, at.poles - heights_of_weights(beams_).below * weights_.mm_per_unit - strung_letters - 6},
          {right + strung_letters + 2,
           at.diagrams + heights_of_moments(beams_).above * moments_.mm_per_unit + strung_letters}};
}

// Letters as numbers of strings and rays; a weight that is zero makes none.
void StrungBeamsPanel::draw_diagram(Plot& plot, const StrungBeam& beam, double level, double begin,
                                    Language language) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  const auto at = [&](double along, double up) { return Place{begin * mm + along, (level + up) * mm}; };
  const std::array<Place, 2> tips{at(0, -beam.moments[0] * moments_.mm_per_unit),
                                  at(beam.length, -beam.moments[1] * moments_.mm_per_unit)};
  const std::array<Place, 2> feet{at(0, 0), at(beam.length, 0)};
  plot.area({feet[0], feet[1], tips[1], tips[0]}, Meaning::force);
  plot.polygon({feet[0], feet[1], tips[1], tips[0]}, Meaning::force);
  plot.segment(feet[0], feet[1], Meaning::link);
  const std::array<std::string, 2> letters{beam.from, beam.to};
  for (int i : {0, 1}) {
    const double away = beam.moments[i] > 0 ? mm : -mm;
    plot.label(letters[i], feet[i], feet[i] + Arrow2{i == 0 ? 2 * mm : -2 * mm, -away});
    if (beam.moments[i] != 0)
      plot.small_label(figures(beam.moments[i], 4, language) + unit_after_number("N m", language), tips[i], feet[i],
                       Meaning::force);
  }
  for (int i : {0, 1}) {
    if (beam.weights[i] == 0) continue;
    const Place& corner = beam.corners[i + 1];
    const double there = -beam.moments[i] * moments_.mm_per_unit / 3;
    const Place centroid = at(corner.x, there);
    plot.segment(centroid, Place{begin * mm + corner.x, corner.y * plot.vector_scale().mm_per_unit * 1000 * mm},
                 Meaning::axis);
    plot.dot(centroid, Meaning::force);
    plot.small_label(beam.weight, centroid, centroid + Arrow2{mm, 0}, Meaning::force);
  }
}

void StrungBeamsPanel::draw_pole(Plot& plot, const StrungBeam& beam, double level, double begin,
                                 Language language) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  const double distance = pole_distance(plot.scale().mm_per_unit, plot.vector_scale().mm_per_unit);
  const auto at = [&](double along, double up) { return Place{(begin + along) * mm, (level + up) * mm}; };
  const Place pole = at(0, 0);
  double up = 0;
  int ray = 1;
  const auto draw_ray = [&] {
    plot.segment(pole, at(distance, up), Meaning::construction);
    plot.small_label(std::to_string(ray), at(0.6 * distance, 0.6 * up), at(0.6 * distance, 0.6 * up - 1));
    ++ray;
  };
  draw_ray();
  for (const double weight : beam.weights) {
    if (weight == 0) continue;
    const double before = up;
    up += weight * weights_.mm_per_unit;
    plot.side("", at(distance, before), at(distance, up), Meaning::force, beam.weight, pole);
    draw_ray();
  }
  plot.dot(pole);
  plot.label("$\\it{Q}$", pole, at(3, 0));
  const bool is_up = up > 0;
  plot.mark(drawings::Dimension{plot.at(pole), plot.at(at(distance, 0)), is_up ? -4.0 : 4.0,
                                "$h$ = " + short_number(distance, language) + " mm"});
}

void StrungBeamsPanel::draw_polygon(Plot& plot, const StrungBeam& beam, double begin) const {
  const double mm = 1 / plot.scale().mm_per_unit, risen = 1000 * plot.vector_scale().mm_per_unit * mm;
  const auto at = [&](const Place& P) { return Place{begin * mm + P.x, risen * P.y}; };
  const auto& corners = beam.corners;
  const Place level{begin * mm + beam.length, 0};
  plot.in_step(strung);
  plot.segment(at(corners[0]), level, Meaning::construction);
  std::vector<Place> vertices{at(corners[0])};
  for (int i : {0, 1})
    if (beam.weights[i] != 0) vertices.push_back(at(corners[i + 1]));
  vertices.push_back(at(corners[3]));
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    plot.segment(vertices[i - 1], vertices[i], Meaning::construction);
    const Place middle = geometry::midpoint(vertices[i - 1], vertices[i]);
    plot.small_label(std::to_string(i), middle, middle + Arrow2{0, beam.counts_down ? -mm : mm});
  }
  plot.mark(drawings::Line{
      {plot.at(at(corners[0])), {{false, plot.at(at(corners[1])), plot.at(at(corners[2])), plot.at(at(corners[3]))}}},
      Meaning::locus});
  plot.in_step(read_off);
  plot.side("", level, at(corners[3]), Meaning::velocity, beam.letters, at(corners[0]));
  const Place &from = beam.counts_down ? at(corners[3]) : level, &to = beam.counts_down ? level : at(corners[3]);
  plot.onto().measurements.push_back({beam.quantity, plot.at(from), plot.at(to),
                                      1 / (1000 * plot.vector_scale().mm_per_unit), Measurement::along_y});
}

void StrungBeamsPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const Places at = places(plot.scale().mm_per_unit, plot.vector_scale().mm_per_unit);
  const double mm = 1 / plot.scale().mm_per_unit;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Place from{at.begin[i] * mm, at.diagrams * mm}, to = from + Arrow2{beams_[i].length, 0};
    plot.segment(from, to, Meaning::link);
    plot.label(beams_[i].from, from, from + Arrow2{2 * mm, 0});
    plot.label(beams_[i].to, to, to + Arrow2{-2 * mm, 0});
  }
}

std::vector<drawings::Block> StrungBeamsPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  const Places at = places(plot.scale().mm_per_unit, plot.vector_scale().mm_per_unit);
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    plot.in_step(weighed);
    draw_diagram(plot, beams_[i], at.diagrams, at.begin[i], language);
    draw_polygon(plot, beams_[i], at.begin[i]);
    plot.in_step(joined_to_pole);
    draw_pole(plot, beams_[i], at.poles, at.begin[i], language);
  }
  return {};
}

// Beside the first beam.
std::vector<PanelStep> StrungBeamsPanel::steps(const Plot& plot, const drawings::Box&) const {
  const double mm = 1 / plot.scale().mm_per_unit, risen = 1000 * plot.vector_scale().mm_per_unit * mm;
  const Places at = places(plot.scale().mm_per_unit, plot.vector_scale().mm_per_unit);
  const StrungBeam& first = beams_.front();
  const std::array<Place, 4> where{Place{first.length / 2, at.diagrams * mm}, Place{0, at.poles * mm},
                                   Place{first.length / 3, 0}, Place{first.length, risen * first.corners[3].y}};
  std::vector<PanelStep> all;
  for (std::size_t i = 0; i < told_.size(); ++i) all.push_back({told_[i], where[i]});
  return all;
}

}  // namespace epure
