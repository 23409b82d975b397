// The double slider: force triangle, and the link's pole.
#include <memory>

#include "exercises/ideal-statics/sheets.h"
#include "exercises/kit/linkages/loaded_figures.h"

namespace epure::ideal_statics {
namespace {

using Arrow = FreeBodyPanel::Arrow;

// With the load on slider 2, and the sought force on slider 4.
class LoadedSlider : public MechanismFigure {
 public:
  explicit LoadedSlider(const Case& of)
      : link_(double_slider_figure(of, Origin::shown)), A_(of.place("A")), B_(of.place("B")) {}

  void draw(Plot& plot) const override {
    draw_but_driving(plot);
    plot.side("", B_ + length / plot.scale().mm_per_unit * Arrow2{-1, 0}, B_, Meaning::force, driving_letters);
  }
  // Which way the force drives is found.
  void draw_given(Plot& plot) const override {
    draw_but_driving(plot);
    plot.label(driving_letters, B_ + length / plot.scale().mm_per_unit * Arrow2{-1, 0}, B_, Meaning::force);
  }
  void sketch(Plot& plot) const override { link_->sketch(plot); }
  void include(Extent& extent, const Scale& scale) const override {
    link_->include(extent, scale);
    constexpr double letters = 6;  // mm
    for (const Place& P : corners()) extent.include(scale, P, length + letters);
  }
  std::vector<Place> corners() const override { return link_->corners(); }
  double reach() const override { return link_->reach(); }

 private:
  static constexpr double length = 14;  // mm
  static constexpr const char* driving_letters = "$\\vec{\\it{P}}$";

  void draw_but_driving(Plot& plot) const {
    const double units = length / plot.scale().mm_per_unit;
    link_->draw(plot);
    plot.side("", A_, A_ + units * Arrow2{0, -1}, Meaning::force, "$\\vec{\\it{Q}}$");
    plot.segment(B_ + units * Arrow2{-1, 0}, B_ + units * Arrow2{1, 0}, Meaning::construction);
  }

  std::shared_ptr<const Mechanism> link_;
  Place A_, B_;
};

PanelSheet sheet(const Solution& s, Language) {
  const Case of(s, "double_slider");
  const Place A = of.place("A"), B = of.place("B");
  const PolygonSide Q = of.load("Q", "⊥ $x$", "$a$"), R_32 = of.sought(force_between(3, 2), "∥ $AB$", "$b$"),
                    R_12 = of.sought(force_between(1, 2), "∥ $x$"), driving = of.sought(P(), "∥ $x$", "$c$"),
                    R_14 = of.sought(force_between(1, 4), "⊥ $x$");
  PolygonSide R_34 = reaction(R_32, force_between(3, 4).arrow(), force_between(3, 2).length().symbol);
  R_34.tip = "$a$";
  FreeBodyPanel on_2 = slider_cut_free(of, "A"), on_4 = slider_cut_free(of, "B");
  on_2.load(Q, A).force(R_32, A, Arrow::ends).force(R_12, A, Arrow::ends);
  on_4.force(R_34, B, Arrow::ends).effort(driving, B, Arrow::ends).force(R_14, B, Arrow::ends);
  on_2.step({"The link is loaded in its hinges only: its forces run along $AB$. On slider 2 $\\vec{\\it{Q}}$, "
             "$\\vec{\\it{R}}_{32}$ and $\\vec{\\it{R}}_{12}$ meet in $A$.",
             "L'asta è caricata solo nelle cerniere: le sue forze corrono lungo $AB$. Sul pattino 2 la "
             "$\\vec{\\it{Q}}$, la $\\vec{\\it{R}}_{32}$ e la $\\vec{\\it{R}}_{12}$ si incontrano in $A$."},
            A);
  ChainedPolygonsPanel polygons(force_polygon("2", {R_12}, {Q, R_32}));
  VectorPolygon of_4 = force_polygon("4", {R_14}, {R_34, driving});
  of_4.origin = "$b$";
  polygons.then(of_4, Q.v + R_32.v);
  FreeBodyPanel whole(double_slider_figure(of, Origin::none));
  whole.load(of.load("Q", "", ""), A).effort(of.known(P(), "", ""), B, Arrow::ends);
  return {.panels = panels(whole, on_2, on_4, polygons),
          .results = {of.results({"P", "R_12", "R_14"}), of.results({"R_32"}),
                      for_comparison(of.results({"v_Q_over_v_P", "P_virtual_work"}))},
          .seen = {"The double slider, its two sliders cut free, and the triangles of their forces",
                   "Il doppio pattino, i suoi due pattini isolati, e i triangoli delle loro forze"},
          .told = of.names({"P", "R_12", "R_14", "R_32"}),
          .without_part = of.without()};
}

// v_B = 1 m/s along P.
PanelSheet virtual_work(const Solution& s, Language) {
  const Case of(s, "double_slider");
  using Where = PolesStep::Where;
  const std::string pole = "$P_{31}$";
  PolesPanel poles(s, std::make_shared<const LoadedSlider>(of), of.pole("P31"), {"A", "B"},
                   {{{"The normals to the two guides, in $A$ and in $B$, meet in " + pole + ", the link's pole.",
                      "Le normali alle due guide, in $A$ e in $B$, si incontrano in " + pole + ", polo dell'asta."},
                     Where::pole},
                    {{"Virtual displacements as distances from it: $v_{Q}$ : $v_{P}$ = $v_{A}$ : $v_{B}$ = $P_{31}A$ "
                      ": $P_{31}B$ = cot $θ$.",
                      "Spostamenti virtuali come distanze da esso: $v_{Q}$ : $v_{P}$ = $v_{A}$ : $v_{B}$ = $P_{31}A$ "
                      ": $P_{31}B$ = cotg $θ$."},
                     Where::tip,
                     "A"},
                    {{"$\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0 gives $\\it{P}$.",
                      "$\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0 dà la $\\it{P}$."},
                     Where::tip,
                     "B"}});
  const VectorPolygon polygon = velocity_polygon(
      {of.moves("A", "∥ $y$", "?")}, {of.moves("B", "∥ $x$", "1 m/s", "$b$"), of.moves("AB", "⊥ $AB$", "?", "$a$")});
  return {
      .panels = panels(poles, PolygonPanel(s, polygon)),
      .results = {of.results({"P31_x", "P31_y"}), of.results({"v_Q_over_v_P"}), of.results({"P_virtual_work"}),
                  for_comparison(of.results({"P"}))},
      .seen = {"The double slider with the pole of its link and the virtual displacements of the sliders, and their "
               "polygon",
               "Il doppio pattino con il polo dell'asta e gli spostamenti virtuali dei pattini, e il loro poligono"},
      .told = of.names({"P31_x", "P31_y", "v_Q_over_v_P", "P_virtual_work"}),
      .without_part = of.without()};
}

}  // namespace

std::vector<SheetMaker> double_slider_sheets() {
  return {{{"double-slider",
            {"Double slider", "Doppio pattino"},
            {"A bar joins two sliders. There is no friction. Find the force (or couple) that balances the load and "
             "all reactions by cutting the bodies free and drawing force polygons.",
             "Un'asta unisce due pattini. Non c'è attrito. Trovare la forza (o la coppia) che equilibra il carico e "
             "tutte le reazioni, isolando i corpi e disegnando i poligoni delle forze."}},
           sheet},
          {{"double-slider-virtual-work",
            {"Double slider: virtual work", "Doppio pattino: lavori virtuali"},
            {"A bar joins two sliders. There is no friction. Find the force (or couple) that balances the load by "
             "virtual work.",
             "Un'asta unisce due pattini. Non c'è attrito. Trovare la forza (o la coppia) che equilibra il carico "
             "con i lavori virtuali."}},
           virtual_work}};
}

}  // namespace epure::ideal_statics
