// Sheet 4: the path of C by the transport method: the triangle ABC of the instant carried onto the AB of each
// position.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/linkages/slider_crank_mechanism.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-velocity/loci.h"

namespace epure::slider_crank_velocity {
namespace {

class CouplerCurvePanel : public Panel {
 public:
  CouplerCurvePanel(const Solution& solution, const SliderCrankInstant& instant)
      : instant_(instant),
        mechanism_(slider_crank_mechanism(solution, instant)),
        positions_(divided_positions(instant)) {}

  double reach() const override { return CGAL::to_double(instant_.lengths.r + instant_.lengths.l); }

  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    mechanism_->include(extent, scale);
    for (const Position& at : positions_) {
      extent.include(scale, at.B, 1);
      extent.include(scale, at.C, 7);
    }
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    for (const Position& at : positions_) {
      plot.in_step(Step::slider);
      compass_arc(plot, at.A, at.B, found_by);
      plot.in_step(Step::triangle);
      plot.segment(at.B, at.C, Meaning::construction);
      plot.in_step(Step::crank);
      plot.dot(at.A, Meaning::construction);
      plot.in_step(Step::slider);
      plot.dot(at.B, Meaning::construction);
      plot.in_step(Step::triangle);
      plot.dot(at.C, Meaning::locus);
      plot.in_step(Step::crank);
      if (!shares_A(at, positions_)) plot.small_label(at.label, at.A, mechanism_->at("A0"));
      plot.in_step(Step::triangle);
      plot.small_label(at.label, at.C, Place{(at.A.x + at.B.x) / 2, (at.A.y + at.B.y) / 2});
    }
    plot.in_step(Step::slider);
    if (!has_two_series()) number_B(plot);
    plot.in_step(Step::curve);
    const geometry::Arithmetic<geometry::Bounded> scope;
    const Reference reference = reference_of(instant_);
    const auto curve = [&](const geometry::SliderCrankLoop<geometry::Bounded>& loop) {
      return geometry::CouplerCurve<geometry::Bounded>{loop, reference.coupler, reference.C};
    };
    const geometry::Trace path = draw_loci(plot, instant_, curve, room, Meaning::locus, "path_of_C");
    plot.in_step(Step::given);
    mechanism_->draw(plot);
    plot.measures_coordinates("C", mechanism_->at("C"), mechanism_->at("A0"));
    const Words sentence{"{} Bezier arcs, at most {} mm on this sheet from the true path.",
                         "{} archi di Bézier, su questo foglio a non più di {} mm dalla traiettoria vera."};
    return {drawings::Heading{Words{"The curve", "La curva"}.in(language)},
            drawings::Paragraph{fmt::format(fmt::runtime(sentence.in(language)), path.arcs(),
                                            figures(path.deviation() * plot.scale().mm_per_unit, 1, language))}};
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    const Words slider{"The slider: each $B$ on the guide by the arc of radius $l$ about its $A$.",
                       "Il piede di biella: ogni $B$ sulla guida con l'arco di raggio $l$ dal suo $A$."};
    const Words numbered{" Its number is that of the $C$ which the segment $BC$ leads to.",
                         " Il suo numero è quello del $C$ a cui porta il segmento $BC$."};
    return {{{division_in_words(instant_, Language::english), division_in_words(instant_, Language::italian)},
             position(5).A},
            {has_two_series() ? slider + numbered : slider, position(3).B},
            {{"The triangle $ABC$ on tracing paper, carried forth until its $AB$ covers that of each position: $C$ "
              "marks a point.",
              "Il triangolo $ABC$ su carta da lucido, portato finché il suo $AB$ copre quello di ogni posizione: $C$ "
              "segna un punto."},
             position(4).C},
            {{"The curve through the points: the path of $C$.", "La curva per i punti: la traiettoria di $C$."},
             position(8).C}};
  }

 private:
  struct Step {  // of the construction
    static constexpr int given = 0, crank = 1, slider = 2, triangle = 3, curve = 4;
  };

  static constexpr double found_by = 4;  // mm of the arcs on either side

  // B ahead of A and behind it: the numbers of both along one guide would hide the figure.
  bool has_two_series() const { return circuit_of(instant_) == Circuit::both; }

  // Two positions of the crank, as a rule, have one B: it bears both their numbers.
  void number_B(Plot& plot) const {
    constexpr double below = 10, half_guide = 14, hatched = 6;  // mm
    const double mm = plot.scale().mm_per_unit;
    std::vector<std::pair<Place, std::string>> each;
    for (const Position& at : positions_) each.emplace_back(at.B, at.label);
    for (const auto& [B, numbers] : numbered_together(plot, each)) {
      const bool is_on_guide = distance(B, mechanism_->at("B")) * mm < half_guide;  // below its hatching then
      plot.small_label(numbers, is_on_guide ? B + Arrow2{0, -hatched / mm} : B, B + Arrow2{0, below / mm},
                       Meaning::construction);
    }
  }

  // Where there is room; a swinging crank does not reach every position.
  const Position& position(int number) const {
    for (const Position& at : positions_)
      if (at.number == number) return at;
    return positions_[static_cast<std::size_t>(number) % positions_.size()];
  }

  SliderCrankInstant instant_;
  std::shared_ptr<const Mechanism> mechanism_;
  std::vector<Position> positions_;
};

}  // namespace

PanelSheet coupler_curve_sheet(const Solution& s, Language) {
  return {.panels = panels(CouplerCurvePanel(s, slider_crank_instant(s.givens()))),
          .seen = {"The path of the coupler point C by the transport method, in twelve positions; C now",
                   "La traiettoria del punto di biella C col metodo del trasporto, in dodici posizioni; C ora"},
          .told = {"C_x", "C_y"}};
}

}  // namespace epure::slider_crank_velocity
