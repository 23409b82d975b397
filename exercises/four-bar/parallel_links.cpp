// Crank and rocker parallel, in the same sense or in opposite senses: the position of the drawn branch with its
// polygon of accelerations, and the numbers of both branches.
#include <array>

#include "exercises/four-bar/linkage.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::four_bar {
namespace {

using geometry::Sense;

// The position and how it is found: Q, where A comes to lie when the coupler is carried along until B lies on B₀.
class ParallelPanel : public MechanismPanel {
 public:
  ParallelPanel(const Solution& s, const Problem& of, std::shared_ptr<const Mechanism> mechanism, Sense sense)
      : MechanismPanel(mechanism),
        of_(of),
        mechanism_(std::move(mechanism)),
        prefix_(parallel_links(sense, true).prefix),
        sense_(sense),
        Q_(s.place(prefix_ + "Q")),
        v_(s.vector(prefix_ + "v_A")) {}

  Vectors vectors() const override { return {.unit = "m/s", .longest = magnitude(v_), .longest_on_paper = 25}; }

  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override {
    Extent extent;
    const drawings::Box mechanism = MechanismPanel::extent(lengths, vectors);
    extent.include(mechanism.low.x, mechanism.low.y);
    extent.include(mechanism.high.x, mechanism.high.y);
    extent.include(lengths, Q_, compass_ + 1);
    for (const char* X : points_of_coupler) {
      const double x = lengths.mm_per_unit * at(X).x + vectors.mm_per_unit * v_.x,
                   y = lengths.mm_per_unit * at(X).y + vectors.mm_per_unit * v_.y;
      extent.include(x - 7, y - 7);
      extent.include(x + 7, y + 7);
    }
    return extent.box();
  }

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    draw_construction(plot);
    mechanism_->draw(plot);
    plot.dot(Q_);
    plot.label("$Q$", Q_, at("B0"));
    for (const auto& [P, R, heads] :
         {std::tuple{at("A0"), at("A"), 2}, {at("B0"), at("B"), 2}, {at("A"), at("B"), 1}, {Q_, at("B0"), 1}})
      plot.mark(drawings::ParallelMark{plot.at(P + along_link * (R - P)), direction(P, R), heads});
    for (const char* letter : points_of_coupler) {
      plot.vector_on(prefix_ + velocity(letter).name, at(letter), v_, Meaning::velocity, velocity(letter).arrow());
      plot.measures_coordinates(prefix_ + letter, at(letter), at("A0"));
    }
    return {};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    return {
        {step_to_Q(), Q_},
        {step_to_A(), at("A")},
        {{"$P_{31}$ is at infinity, $ω_{3}$ = 0: all points of the coupler have $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = "
          "$\\vec{v}_{C}$; |$ω_{4}$| = |$ω_{2}$|·$A_{0}A$ / $B_{0}B$. But $α_{3}$ is not zero: it comes from the "
          "polygon of accelerations.",
          "$P_{31}$ è all'infinito, $ω_{3}$ = 0: tutti i punti della biella hanno $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = "
          "$\\vec{v}_{C}$; |$ω_{4}$| = |$ω_{2}$|·$A_{0}A$ / $B_{0}B$. Ma $α_{3}$ non è nulla: la dà il poligono "
          "delle accelerazioni."},
         plot.tip(at("B"), v_)}};
  }

 private:
  static constexpr double along_link = 0.62;  // clear of its number
  static constexpr double compass_ = 8;       // mm of an arc to either side of Q

  static constexpr std::array<const char*, 3> points_of_coupler{"A", "B", "C"};

  const Place& at(const std::string& name) const { return mechanism_->at(name); }

  // Of the two points where the circles meet the other is that of the other branch: its mirror image in A₀B₀.
  Words step_to_Q() const {
    const Words left{"left", "sinistra"}, right{"right", "destra"};
    return format_words(
        "$Q$: of the two points where the circle of radius {0} about $A_{{0}}$ meets that of radius $AB$ about "
        "$B_{{0}}$, that on the {1} of $A_{{0}}$ → $B_{{0}}$. Crank and rocker lie along $A_{{0}}Q$, {2}.",
        "$Q$: dei due punti in cui la circonferenza di raggio {0} e centro $A_{{0}}$ incontra quella di raggio "
        "$AB$ e centro $B_{{0}}$, quello a {1} di $A_{{0}}$ → $B_{{0}}$. Manovella e bilanciere sono lungo "
        "$A_{{0}}Q$, {2}.",
        std::string(sense_ == Sense::same ? "|$B_{0}B$\u00a0−\u00a0$A_{0}A$|" : "$B_{0}B$\u00a0+\u00a0$A_{0}A$"),
        is_Q_left() ? left : right,
        sense_ == Sense::same ? Words{"in the same sense", "concordi"} : Words{"in opposite senses", "discordi"});
  }
  Words step_to_A() const {
    const Words where = sense_ == Sense::opposite ? Words{"between $A_{0}$ and ", "fra $A_{0}$ e "}
                        : is_rocker_longer()      ? Words{"beyond $A_{0}$, seen from ", "oltre $A_{0}$, visto da "}
                                                  : Words{"beyond ", "oltre "};
    return format_words(
        "$A$ at $A_{{0}}A$ from $A_{{0}}$ on that line, {0}$Q$. The coupler $QB_{{0}}$, carried along it to $A$, is "
        "$AB$.",
        "$A$ ad $A_{{0}}A$ da $A_{{0}}$ su quella retta, {0}$Q$. La biella $QB_{{0}}$, traslata lungo di essa fino "
        "ad "
        "$A$, è $AB$.",
        where);
  }
  bool is_rocker_longer() const { return of_.instant.lengths.B0B > of_.instant.lengths.A0A; }
  // With A at t from A₀ towards Q, B lies on the side of A → B₀ that Q has of A₀ → B₀ where t > 1, else on the other.
  bool is_Q_left() const {
    const bool is_A_beyond_Q = sense_ == Sense::same && !is_rocker_longer();
    return (of_.instant.side == geometry::Side::left) == is_A_beyond_Q;
  }

  // Both circles near Q, and the coupler carried along the line of the crank.
  void draw_construction(Plot& plot) const {
    for (const char* centre : {"A0", "B0"}) compass_arc(plot, at(centre), Q_, compass_);
    plot.long_segment(at("A0"), Q_, 6, Meaning::construction);
    plot.segment(at("A"), Q_, Meaning::construction);
    plot.segment(Q_, at("B0"), Meaning::alternative);
  }

  Problem of_;
  std::shared_ptr<const Mechanism> mechanism_;
  std::string prefix_;
  Sense sense_;
  Place Q_;
  Arrow2 v_;  // of all points of the coupler
};

// No larger than leaves room to the linkage.
class AccelerationsBeside : public PolygonPanel {
 public:
  explicit AccelerationsBeside(PolygonPanel panel) : PolygonPanel(std::move(panel)) {}
  Vectors vectors() const override {
    constexpr double longest = 75;  // mm
    Vectors shown = PolygonPanel::vectors();
    shown.longest_on_paper = longest;
    return shown;
  }
};

bool is_parallelogram(const geometry::FourBarLengths& of) {
  return of.A0A == of.B0B && of.AB * of.AB == of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0;
}

}  // namespace

PanelSheet parallel_links_sheet(const Solution& s, Language language, Sense sense) {
  const Problem of = problem(s.givens());
  const bool same = sense == Sense::same;
  PanelSheet sheet{.seen = {"The four-bar linkage with crank and rocker parallel, and the polygon of accelerations",
                            "Il quadrilatero articolato con manovella e bilanciere paralleli, e il poligono delle "
                            "accelerazioni"},
                   .without_part = without({"t", "phi"})};
  std::vector<Row> turning, moving;
  for (const bool of_this_branch : {true, false}) {
    const std::string prefix = parallel_links(sense, of_this_branch).prefix;
    const std::string name = (of_this_branch ? Words{"drawn", "disegnata"} : Words{"other", "altra"}).in(language);
    turning.push_back({name, {prefix + "crank_angle_deg", prefix + "omega_4", prefix + "alpha_3"}, "–"});
    moving.push_back({name, {prefix + "alpha_4", prefix + "a_B", prefix + "a_C"}, "–"});
  }
  sheet.results = {table({"", "$φ$ (°)", "$ω_{4}$ (rad/s)", "$α_{3}$ (rad/s²)"}, turning),
                   table({"", "$α_{4}$ (rad/s²)", "$a_{B}$ (m/s²)", "$a_{C}$ (m/s²)"}, moving),
                   remark(Words{"The other branch has $B$ on the other side of $AB_{0}$.",
                                "L'altra posizione ha $B$ dall'altra parte di $AB_{0}$."}
                              .in(language))};
  if (same && is_parallelogram(of.instant.lengths))
    sheet.results.push_back(
        remark(Words{"Opposite links are as long as each other: while the linkage is a parallelogram, crank and "
                     "rocker are parallel in the same sense throughout.",
                     "Le aste opposte sono lunghe uguali: finché il meccanismo è un parallelogramma, manovella e "
                     "bilanciere sono sempre paralleli e concordi."}
                   .in(language)));
  const std::string here = parallel_links(sense, true).prefix;
  if (s.value(here + "A_x")) {
    const auto mechanism = std::make_shared<const Mechanism>(four_bar_mechanism(s, sign_of(of.instant.n), here));
    sheet.panels =
        panels(ParallelPanel(s, of, mechanism, sense), AccelerationsBeside(acceleration_panel(s, here, "'")));
    for (const char* told : {"omega_4", "alpha_3", "a_B", "a_C"}) sheet.told.push_back(here + told);
    return sheet;
  }
  const Words how = same ? Words{"in the same sense", "concordi"} : Words{"in opposite senses", "discordi"};
  sheet.panels = panels(MechanismPanel(linkage(s)));
  sheet.results.push_back(
      remark(format_words(
                 "On this branch crank and rocker are never parallel {} but at change points. Drawn: the linkage at "
                 "its instant.",
                 "Su questo ramo manovella e bilanciere non sono mai paralleli e {}, se non in punti di "
                 "cambiamento. È disegnato il meccanismo all'istante dato.",
                 how)
                 .in(language)));
  sheet.without_part = without();
  return sheet;
}

}  // namespace epure::four_bar
