#include "exercises/kit/panels/pad_section_panel.h"

#include <numbers>

#include "exercises/kit/panels/film_chart.h"

namespace epure {
namespace {

// mm; the origin lies on the runner, under the leading edge.
constexpr double pad_length = 25, film_inlet = 7, pad_thickness = 8, runner_thickness = 7, runner_beyond = 5;
constexpr double beside_film = 4, below_runner = 4, below_each_other = 6;  // dimension lines
constexpr double word_size = 2.7;

void write_inside(Plot& plot, const Words& word, const Place& P, Language language) {
  plot.mark(drawings::Writing{word.in(language), plot.at(P), word_size});
}

}  // namespace

double PadSectionPanel::outlet() const { return film_inlet * section_.h_2 / section_.h_1; }

drawings::Box PadSectionPanel::extent(const Scale&, const Scale&) const {
  constexpr double beside = 10, support = 10, letters = 4;
  return {{-beside, -runner_thickness - below_runner - below_each_other - letters},
          {pad_length + beside, film_inlet + pad_thickness + support}};
}

void PadSectionPanel::draw_given(Plot& plot, const drawings::Box&, Language language) const {
  const double low = -runner_thickness, left = -runner_beyond, right = pad_length + runner_beyond;
  plot.area({{left, 0}, {right, 0}, {right, low}, {left, low}}, Meaning::plate);
  plot.segment({left, 0}, {right, 0}, Meaning::link, "runner");
  plot.segment({left, low}, {right, low}, Meaning::link);
  constexpr double tail = -2, long_on_paper = 9;
  const Place from{tail, low / 2}, tip{tail + long_on_paper, low / 2};
  plot.mark(drawings::Arrow{plot.at(from), plot.at(tip), Meaning::velocity, "runner_speed"});
  plot.label(section_.speed_letters, tip, from, Meaning::velocity);
  write_inside(plot, {"runner", "ralla"}, {0.6 * pad_length, low / 2 - word_size / 3}, language);
}

void PadSectionPanel::draw_pad(Plot& plot, Language language) const {
  const std::vector<Place> corners{{0, film_inlet},
                                   {pad_length, outlet()},
                                   {pad_length, outlet() + pad_thickness},
                                   {0, film_inlet + pad_thickness}};
  plot.area(corners, Meaning::plate);
  plot.polygon(corners, Meaning::link);
  const auto top = [&](double share) {
    return Place{share * pad_length, film_inlet + share * (outlet() - film_inlet) + pad_thickness};
  };
  plot.mark(drawings::FixedHinge{plot.at(top(section_.pivot)), std::numbers::pi / 2});
  // The word stands level in the middle of the slope.
  constexpr double word_from = 2, word_about = 0.3;
  write_inside(plot, {"pad", "pattino"}, {word_from, top(word_about).y - pad_thickness / 2 - word_size / 3},
               language);
}

void PadSectionPanel::dimension(Plot& plot) const {
  const auto add = [&](const Place& from, const Place& to, double offset, const std::string& letters) {
    plot.mark(drawings::Dimension{plot.at(from), plot.at(to), offset, letters});
  };
  add({0, 0}, {0, film_inlet}, beside_film, "$h_{1}$");
  add({pad_length, outlet()}, {pad_length, 0}, beside_film, "$h_{2}$");
  const auto add_below = [&](double x, double offset, const std::string& letters) {
    add({x, -runner_thickness}, {0, -runner_thickness}, offset, letters);
  };
  add_below(section_.pivot * pad_length, below_runner, section_.pivot_letters);
  add_below(pad_length, below_runner + below_each_other, section_.length_letters);
  const auto read = [&](const std::string& quantity, double x, double high) {
    plot.onto().measurements.push_back(
        {quantity, plot.at({x, 0}), plot.at({x, high}), section_.h_1 / film_inlet, Measurement::along_y});
  };
  read(section_.inlet_quantity, 0, film_inlet);
  read(section_.outlet_quantity, pad_length, outlet());
}

std::vector<drawings::Block> PadSectionPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  plot.area({{0, 0}, {pad_length, 0}, {pad_length, outlet()}, {0, film_inlet}}, Meaning::velocity);
  draw_given(plot, room, language);
  draw_pad(plot, language);
  dimension(plot);
  return {drawings::Paragraph{
      film_exaggeration(film_inlet / section_.h_1 / (pad_length / section_.length)).in(language)}};
}

std::vector<PanelStep> PadSectionPanel::steps(const Plot&, const drawings::Box&) const {
  return {{{"Pad and runner cut along the mean circle: the runner drags the oil into the film, which narrows in the "
            "sense of the motion, as the pad tilts on its pivot.",
            "Pattino e ralla sezionati lungo la circonferenza media: la ralla trascina l'olio nel meato, che si "
            "stringe nel verso del moto, perché il pattino s'inclina sulla cerniera."},
           Place{pad_length / 4, film_inlet / 3}}};
}

}  // namespace epure
