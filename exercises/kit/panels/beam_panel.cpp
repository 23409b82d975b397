#include "exercises/kit/panels/beam_panel.h"

#include <algorithm>
#include <cmath>

namespace epure {
namespace {

constexpr double between_diagrams = 9, diagram_names = 9, beam_letters = 8;  // mm
constexpr double load_length = 13;                                           // mm

struct Reach {
  double low = 0, high = 0;
};
// In mm from the axis.
Reach reach_of(const BeamDiagram& diagram, double mm) {
  Reach all;
  const auto include = [&](double y) {
    all.low = std::min(all.low, y);
    all.high = std::max(all.high, y);
  };
  for (const BeamDiagram::Run& run : diagram.runs)
    for (const Place& P : run.points) include(mm * P.y);
  for (const BeamDiagram::Ordinate& each : diagram.ordinates) include(mm * each.to);
  if (!diagram.loads.empty()) include(-load_length - beam_letters / 2);
  return all;
}

}  // namespace

std::vector<double> BeamPanel::axes(double mm_of_lengths, double mm_of_vectors) const {
  std::vector<double> all;
  double end = 0;
  for (const BeamDiagram& diagram : diagrams_) {
    const Reach reach = reach_of(diagram, diagram.of_vectors ? mm_of_vectors : mm_of_lengths);
    all.push_back(all.empty() ? 0 : end - between_diagrams - reach.high);
    end = all.back() + reach.low;
  }
  all.push_back(end);
  return all;
}

drawings::Box BeamPanel::extent(const Scale& lengths, const Scale& vectors) const {
  double aside = 0;
  for (const BeamDiagram& diagram : diagrams_)
    for (const BeamDiagram::Ordinate& each : diagram.ordinates) aside = std::max(aside, each.aside);
  const double high =
      reach_of(diagrams_.front(), diagrams_.front().of_vectors ? vectors.mm_per_unit : lengths.mm_per_unit).high;
  return {{-std::max(diagram_names, beam_letters),
           axes(lengths.mm_per_unit, vectors.mm_per_unit).back() - beam_letters / 2},
          {lengths.mm_per_unit * length_ + aside + beam_letters, high + beam_letters / 2}};
}

Place BeamPanel::place(const Plot& plot, std::size_t diagram, const Place& at) const {
  const double lengths = plot.scale().mm_per_unit, vectors = plot.vector_scale().mm_per_unit;
  const double mm = axes(lengths, vectors)[diagram] + (diagrams_[diagram].of_vectors ? vectors : lengths) * at.y;
  return {at.x, mm / lengths};
}

void BeamPanel::draw(Plot& plot, std::size_t diagram) const {
  const BeamDiagram& of = diagrams_[diagram];
  const auto at = [&](const Place& P) { return place(plot, diagram, P); };
  auto& figure = plot.onto().sheet.figure;
  for (const BeamDiagram::Run& run : of.runs) {
    std::vector<Place> points;
    for (const Place& P : run.points) points.push_back(at(P));
    if (run.is_area) plot.area(points, Meaning::plate);
    if (run.is_cubic) {
      const drawings::Piece arc{false, plot.at(points[1]), plot.at(points[2]), plot.at(points[3])};
      plot.mark(drawings::Line{{plot.at(points[0]), {arc}, false}, run.meaning, {}});
    } else {
      std::vector<drawings::Point> corners;
      for (const Place& P : points) corners.push_back(plot.at(P));
      plot.mark(drawings::Line{drawings::polyline(corners, run.is_area), run.meaning, {}});
    }
    if (run.letter.empty()) continue;
    drawings::Label letter{
        .text = run.letter, .at = plot.at(points.front()), .to = plot.at(points.back()), .size = 3};
    if (run.away_from) letter.away_from = plot.at(at(*run.away_from));
    figure.labels.push_back(letter);
  }
  draw_axis(plot, diagram);
  for (const BeamDiagram::Ordinate& each : of.ordinates) draw_ordinate(plot, diagram, each);
  for (const BeamDiagram::Load& load : of.loads) draw_load(plot, diagram, load);
  draw_letters(plot, diagram);
}

void BeamPanel::draw_ordinate(Plot& plot, std::size_t diagram, const BeamDiagram::Ordinate& each) const {
  constexpr double short_one = 5;  // mm: beside it its letters would be those of what is above or below
  const double mm = diagrams_[diagram].of_vectors ? plot.vector_scale().mm_per_unit : plot.scale().mm_per_unit;
  const Arrow2 aside{each.aside / plot.scale().mm_per_unit, 0};
  const Place from = place(plot, diagram, {each.at, each.from}) + aside,
              to = place(plot, diagram, {each.at, each.to}) + aside;
  if (each.aside != 0)
    for (const Place& end : {from, to}) plot.segment(end + -1.0 * aside, end, Meaning::construction);
  if (each.is_arrow)
    plot.mark(drawings::Arrow{plot.at(from), plot.at(to), each.meaning, each.quantity});
  else
    plot.mark(drawings::Line{drawings::segment(plot.at(from), plot.at(to)), each.meaning, each.quantity});
  const bool is_short =
      mm * std::abs(each.to - each.from)<short_one, ends_outside = std::abs(each.to)> std::abs(each.from);
  if (is_short && !each.label.empty())
    plot.label(each.label, ends_outside ? to : from, ends_outside ? from : to, each.meaning);
  else if (!each.label.empty())
    plot.onto().sheet.figure.labels.push_back(
        {.text = each.label, .at = plot.at(from), .to = plot.at(to), .ink = each.meaning});
  if (!each.quantity.empty() && plot.shows(from) && plot.shows(to))
    plot.onto().measurements.push_back(
        {each.quantity, plot.at(from), plot.at(to), each.worth / mm, Measurement::along_y});
}

void BeamPanel::draw_load(Plot& plot, std::size_t diagram, const BeamDiagram::Load& load) const {
  // All hang below the axis: upward ones press on it, downward ones pull.
  const drawings::Point on_axis = plot.at(place(plot, diagram, {load.at, 0})),
                        below{on_axis.x, on_axis.y - load_length};
  const auto [tail, tip] = load.sense > 0 ? std::pair{below, on_axis} : std::pair{on_axis, below};
  plot.mark(drawings::Arrow{tail, tip, Meaning::force, {}});
  plot.onto().sheet.figure.labels.push_back({.text = load.label, .at = tail, .to = tip, .ink = Meaning::force});
}

void BeamPanel::draw_letters(Plot& plot, std::size_t diagram) const {
  for (const BeamDiagram::Letter& letter : diagrams_[diagram].letters)
    plot.label(letter.text, place(plot, diagram, letter.at), place(plot, diagram, letter.away_from));
}

void BeamPanel::draw_axis(Plot& plot, std::size_t diagram) const {
  const BeamDiagram& of = diagrams_[diagram];
  const auto at = [&](const Place& P) { return place(plot, diagram, P); };
  plot.segment(at({0, 0}), at({length_, 0}), of.is_beam ? Meaning::link : Meaning::axis);
  plot.label(of.name, at({0, 0}), at({length_ / 2, 0}));
}

void BeamPanel::draw_lines(Plot& plot) const {
  const double lengths = plot.scale().mm_per_unit;
  const double end = axes(lengths, plot.vector_scale().mm_per_unit).back() / lengths;
  for (const double x : lines_) plot.segment({x, 0}, {x, end}, Meaning::construction);
}

void BeamPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  draw_lines(plot);
  for (std::size_t i = 0; i < diagrams_.size(); ++i) {
    draw_axis(plot, i);
    for (const BeamDiagram::Load& load : diagrams_[i].loads)
      if (load.is_given) draw_load(plot, i, load);
    draw_letters(plot, i);
  }
}

std::vector<drawings::Block> BeamPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  draw_lines(plot);
  for (std::size_t i = 0; i < diagrams_.size(); ++i) draw(plot, i);
  return {};
}

std::vector<PanelStep> BeamPanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all;
  for (const Step& step : steps_)
    all.push_back({step.text, place(plot, step.diagram, step.at), step.needs_all_others});
  return all;
}

}  // namespace epure
