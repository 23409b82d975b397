// The load and its place: eight strips of the pressure, below them their forces, force polygon and funicular polygon.
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/slider_charts.h"
#include "exercises/michell-bearing/along_film.h"
#include "exercises/michell-bearing/exercise.h"
#include "geometry/statics/funicular.h"

namespace epure::michell_bearing {
namespace {

constexpr int strips_of_load = 8;

struct Strip {
  double x, pressure, force;
};
// With many bits: where the walls are nearly parallel doubles lose what the pressure is made of.
std::vector<Strip> strips_of(const Film& film) {
  return deeply([&] {
    std::vector<Strip> all;
    for (int i = 0; i < strips_of_load; ++i) {
      const Rational x = film.l * Rational(2 * i + 1, 2 * strips_of_load);
      const double p = to_double(film.wedge<geometry::Deep>().pressure(geometry::from_rational<geometry::Deep>(x)));
      all.push_back(
          {geometry::from_rational<double>(x), p, p * geometry::from_rational<double>(film.l) / strips_of_load});
    }
    return all;
  });
}

// On paper, in mm from the inlet on the slider's line: forces upwards, above them the pressures at the same scale of
// lengths, strings below, the force polygon at the right.
class FunicularPanel : public Panel {
 public:
  FunicularPanel(const Film& film, const Solution& s)
      : length_(geometry::from_rational<double>(film.l)),
        strips_(strips_of(film)),
        pressure_(along(film, &DeepWedge::pressure)),
        load_(s[of_film("N_funicular")]),
        greatest_(s[of_film("p_max")]),
        x_N_(s[of_film("x_N")]) {}

  double reach() const override { return length_; }
  Vectors vectors() const override { return {"N/m", load_, 100}; }
  std::vector<Scale> own_scales() const override { return {pressures_}; }
  void choose_view(const drawings::Box&, const SheetRequest& request) override {
    constexpr double high = 45;  // mm
    pressures_ = largest_vector_scale(high / greatest_, "Pa", request.language);
  }

  drawings::Box extent(const Scale& scale, const Scale& forces) const override {
    const OnPaper on = on_paper(scale, forces);
    Extent extent;
    extent.include(-6, on.lowest() - 8);
    extent.include(on.load_line + 24,
                   std::max(on.pressures + high() + 10, on.corner(on.polygon.corners.back()).y + 6));
    extent.include(0, on.corner(0).y - 6);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    const double length = length_ * plot.scale().mm_per_unit;
    plot.mark(drawings::Ground{plot.at(from_mm(plot, {length, 0})), plot.at(from_mm(plot, {0, 0}))});
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    const OnPaper on = on_paper(plot.scale(), plot.vector_scale());
    const auto at = [&](const Point& P) { return from_mm(plot, P); };
    plot.in_step(Step::given);
    plot.mark(drawings::Ground{plot.at(at({on.length, 0})), plot.at(at({0, 0}))});
    draw_pressures(plot, on);
    plot.in_step(Step::strips);
    draw_forces(plot, on);
    plot.in_step(Step::load_line);
    draw_force_polygon(plot, on);
    plot.in_step(Step::strings);
    draw_strings(plot, on);
    plot.onto().measurements.push_back({of_film("N_funicular"), plot.at(at(on.corner(0))),
                                        plot.at(at(on.corner(on.polygon.corners.back()))),
                                        1 / plot.vector_scale().mm_per_unit, Measurement::along_y});
    plot.onto().measurements.push_back({of_film("x_N_funicular"), plot.at(at({0, 0})), plot.at(at(on.meet())),
                                        1 / plot.scale().mm_per_unit, Measurement::along_x});
    plot.onto().measurements.push_back({of_film("x_N"), plot.at(at({0, on.pressures})),
                                        plot.at(at({x_N_ * plot.scale().mm_per_unit, on.pressures})),
                                        1 / plot.scale().mm_per_unit, Measurement::along_x});
    return {};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    const OnPaper on = on_paper(plot.scale(), plot.vector_scale());
    const auto beside = [&](const Point& P, double x, double y) { return from_mm(plot, {P.x + x, P.y + y}); };
    const auto& vertices = on.polygon.vertices;
    return {
        {{"Eight strips of the film: each pushes with its width times the pressure in its middle, there.",
          "Otto strisce di meato: ognuna spinge con la sua larghezza per la pressione nel mezzo, lì."},
         beside({on.forces.front().at, on.pressures}, 0, 9)},
        {{"The forces end to end on the load line, their sum $\\it{N}_{f}$ beside it; joined to a pole, of which the "
          "place is free: the last strings meet on one line wherever it stands.",
          "Le forze una dopo l'altra sulla retta dei carichi, accanto la somma $\\it{N}_{f}$; proiettate da un polo "
          "scelto a piacere: dovunque stia, gli ultimi lati si incontrano sulla stessa retta."},
         beside(on.pole(), -5, 0)},
        {{"String after string parallel to the rays, from one line of action to the next.",
          "Lato dopo lato parallelo ai raggi, da una retta d'azione alla successiva."},
         beside(vertices[2], -5, -4)},
        {{"The first string and the last meet on the line of the resultant $\\it{N}_{f}$: its place is $x_{Nf}$.",
          "Il primo lato e l'ultimo si incontrano sulla retta della risultante $\\it{N}_{f}$, di ascissa $x_{Nf}$."},
         beside(on.meet(), 6, -3)}};
  }

 private:
  struct Step {  // of the construction
    static constexpr int given = 0, strips = 1, load_line = 2, strings = 3, resultant = 4;
  };
  using Point = geometry::Point<double>;

  struct OnPaper {
    double length, load_line, foot, pressures;  // how high the load line begins, and the axis of the pressures
    std::vector<geometry::VerticalForce<double>> forces;
    geometry::FunicularPolygon<double> polygon;

    Point corner(double up) const { return {load_line, foot + up}; }
    Point pole() const { return {load_line - polygon.pole.distance, foot + polygon.pole.height}; }
    Point meet() const { return geometry::finite(geometry::meet(polygon.strings.front(), polygon.strings.back())); }
    double lowest() const { return meet().y; }
    double tallest() const {
      double most = 0;
      for (const auto& force : forces) most = std::max(most, force.up);
      return most;
    }
  };

  OnPaper on_paper(const Scale& scale, const Scale& force_scale) const {
    constexpr double below_slider = 10, beside_slider = 18, pole_height = 0.5,
                     pole_distance = 0.6;  // mm; of the line
    const double length = length_ * scale.mm_per_unit;
    std::vector<geometry::VerticalForce<double>> forces;
    double sum = 0;
    for (const Strip& strip : strips_) {
      forces.push_back({strip.x * scale.mm_per_unit, strip.force * force_scale.mm_per_unit});
      sum += forces.back().up;
    }
    const double distance = pole_distance * sum;
    OnPaper on{length, length + beside_slider + distance,
               0,      0,
               forces, geometry::funicular<double>(forces, {distance, pole_height * sum}, {0, -below_slider})};
    on.foot = (on.tallest() + on.lowest() - sum) / 2;
    constexpr double above_forces = 14;  // mm: room for their numbers, and for the letters of the resultant
    on.pressures = on.tallest() + above_forces;
    return on;
  }

  static Place from_mm(const Plot& plot, const Point& P) {
    return {P.x / plot.scale().mm_per_unit, P.y / plot.scale().mm_per_unit};
  }

  double high() const { return greatest_ * pressures_.mm_per_unit; }

  void draw_pressures(Plot& plot, const OnPaper& on) const {
    const auto at = [&](double x, double p) {
      return from_mm(plot, {x * plot.scale().mm_per_unit, on.pressures + p * pressures_.mm_per_unit});
    };
    const double half = length_ / (2 * strips_of_load);
    plot.in_step(Step::strips);
    for (const Strip& strip : strips_) {
      plot.polygon({at(strip.x - half, 0), at(strip.x - half, strip.pressure), at(strip.x + half, strip.pressure),
                    at(strip.x + half, 0)},
                   Meaning::construction);
      plot.dot(at(strip.x, strip.pressure));
      plot.segment(at(strip.x, 0), from_mm(plot, {strip.x * plot.scale().mm_per_unit, 0}), Meaning::construction);
    }
    plot.in_step(Step::given);
    std::vector<drawings::Point> curve;
    const auto runs = run_of(0, length_, pressure_);
    for (const drawings::Datum& each : runs.front()) curve.push_back(plot.at(at(each.x, each.y)));
    plot.mark(drawings::Line{drawings::polyline(curve, false), Meaning::force, "pressure"});
    plot.segment(at(0, 0), at(length_, 0), Meaning::dimension);
    plot.in_step(Step::resultant);
    constexpr double beyond = 6;  // mm
    const Place top = at(x_N_, (high() + beyond) / pressures_.mm_per_unit);
    plot.segment(at(x_N_, 0), top, Meaning::axis);
    plot.label("$x_{N}$", top, at(x_N_, 0));
    plot.in_step(Step::given);
    plot.label("$p$", at(length_ - half, strips_.back().pressure), at(0, 0), Meaning::force);
  }

  void draw_forces(Plot& plot, const OnPaper& on) const {
    for (std::size_t i = 0; i < on.forces.size(); ++i) {
      const auto& force = on.forces[i];
      const Place foot = from_mm(plot, {force.at, 0}), tip = from_mm(plot, {force.at, force.up});
      plot.mark(drawings::Arrow{plot.at(foot), plot.at(tip), Meaning::force, {}});
      plot.segment(foot, from_mm(plot, on.polygon.vertices[i]), Meaning::construction);
      plot.small_label(std::to_string(i + 1), tip, foot);
    }
  }
  void draw_force_polygon(Plot& plot, const OnPaper& on) const {
    const auto& corners = on.polygon.corners;
    const Place pole = from_mm(plot, on.pole());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      plot.segment(pole, from_mm(plot, on.corner(corners[i])), Meaning::construction);
      if (i == 0) continue;
      const Place from = from_mm(plot, on.corner(corners[i - 1])), to = from_mm(plot, on.corner(corners[i]));
      plot.mark(drawings::Arrow{plot.at(from), plot.at(to), Meaning::force, {}});
      plot.small_label(std::to_string(i),
                       from_mm(plot, {on.load_line, (on.corner(corners[i - 1]).y + on.corner(corners[i]).y) / 2}),
                       pole);
    }
    constexpr double beside = 10;  // mm, of the sum
    const auto sum_at = [&](double up) { return from_mm(plot, {on.load_line + beside, on.corner(up).y}); };
    plot.mark(drawings::Arrow{plot.at(sum_at(corners.front())), plot.at(sum_at(corners.back())), Meaning::force,
                              "N_funicular"});
    plot.label("$\\it{N}_{f}$", sum_at((corners.front() + corners.back()) / 2), pole, Meaning::force);
    plot.dot(pole);
    plot.label("$O$", pole, from_mm(plot, on.corner(corners.front())));
  }
  void draw_strings(Plot& plot, const OnPaper& on) const {
    const auto& vertices = on.polygon.vertices;
    const Place meet = from_mm(plot, on.meet());
    std::vector<Point> all{{0, geometry::ordinate(on.polygon.strings.front(), 0.0)}};
    all.insert(all.end(), vertices.begin(), vertices.end());
    all.push_back({on.length, geometry::ordinate(on.polygon.strings.back(), on.length)});
    for (std::size_t i = 1; i < all.size(); ++i)
      plot.segment(from_mm(plot, all[i - 1]), from_mm(plot, all[i]), Meaning::dimension);
    plot.in_step(Step::resultant);
    plot.segment(from_mm(plot, vertices.front()), meet, Meaning::construction);
    plot.segment(from_mm(plot, vertices.back()), meet, Meaning::construction);
    const Place above = from_mm(plot, {on.meet().x, on.tallest() + 6});
    plot.segment(meet, above, Meaning::axis);
    plot.dot(meet, Meaning::force);
    plot.label("$\\it{N}_{f}$", above, meet, Meaning::force);
  }

  double length_;
  std::vector<Strip> strips_;
  std::function<double(double)> pressure_;
  double load_, greatest_, x_N_;
  Scale pressures_;
};

}  // namespace

PanelSheet load_sheet(const Solution& s, Language language) {
  return {.panels = panels(FunicularPanel(Problem(s.givens()).film, s)),
          .theory = {{{"Exactly", "Soluzione esatta"},
                      {remark("$\\it{N}$ = $\\it{A}$ $μ$ $\\it{V}$ $l^{2}$/$h_{2}^{2}$, $n$ = $h_{1}$/$h_{2}$"),
                       remark(slider_formulas()[1]), remark(slider_formulas()[0])}}},
          .results = {told({"By the strips, by Bezout's table, and exactly:",
                            "Con le strisce, con la tabella di Bezout, ed esattamente:"},
                           language),
                      values({of_film("N_funicular"), of_film("x_N_funicular")}),
                      values({of_film("N_bezout"), of_film("x_N_bezout")}), values({of_film("N"), of_film("x_N")}),
                      values({of_film("A"), of_film("p_mean"), of_film("p_max_over_p_mean")})},
          .seen = {"The pressure in eight strips, their forces with the force polygon and the funicular polygon, and "
                   "the line of the resultant",
                   "La pressione in otto strisce, le loro forze con il poligono delle forze e il poligono "
                   "funicolare, e la retta della risultante"},
          .told = {of_film("N_funicular"), of_film("x_N_funicular"), of_film("N"), of_film("x_N")},
          .without_part = {"P", "speed", "pads", "r_m", "l_pad", "b", "x_N", "mu_pad", "h_ref", "dx", "x_1", "x_3"}};
}

}  // namespace epure::michell_bearing
