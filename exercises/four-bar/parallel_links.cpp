// Crank and rocker parallel, in the same sense and in opposite senses: the two positions of the drawn branch, and the
// numbers of all four.
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
  ParallelPanel(const Solution& s, const Problem& of, std::shared_ptr<const Mechanism> mechanism, Sense sense,
                bool tells_all)
      : MechanismPanel(mechanism),
        of_(of),
        mechanism_(std::move(mechanism)),
        prefix_(parallel_links(sense, true).prefix),
        sense_(sense),
        tells_all_(tells_all),
        Q_letters_(sense == Sense::same ? "Q" : "Q'"),
        Q_(s.place(prefix_ + "Q")),
        v_A_(s.vector(prefix_ + "v_A")),
        v_B_(s.vector(prefix_ + "v_B")) {}

  Vectors vectors() const override {
    return {.unit = "m/s", .longest = std::max(magnitude(v_A_), magnitude(v_B_)), .longest_on_paper = 40};
  }

  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override {
    Extent extent;
    const drawings::Box mechanism = MechanismPanel::extent(lengths, vectors);
    extent.include(mechanism.low.x, mechanism.low.y);
    extent.include(mechanism.high.x, mechanism.high.y);
    extent.include(lengths, Q_, compass_ + 1);
    for (const auto& [X, v] : {std::pair{at("A"), v_A_}, {at("B"), v_B_}}) {
      const double x = lengths.mm_per_unit * X.x + vectors.mm_per_unit * v.x,
                   y = lengths.mm_per_unit * X.y + vectors.mm_per_unit * v.y;
      extent.include(x - 7, y - 7);
      extent.include(x + 7, y + 7);
    }
    drawings::Box box = extent.box();
    box.high.y += title_;
    return box;
  }

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override {
    draw_construction(plot);
    mechanism_->draw(plot);
    plot.dot(Q_);
    plot.label("$" + Q_letters_ + "$", Q_, at("B0"));
    for (const auto& [P, R, heads] :
         {std::tuple{at("A0"), at("A"), 2}, {at("B0"), at("B"), 2}, {at("A"), at("B"), 1}, {Q_, at("B0"), 1}})
      plot.mark(drawings::ParallelMark{plot.at(P + along_link * (R - P)), direction(P, R), heads});
    for (const auto& [letter, v] : {std::pair{"A", v_A_}, {"B", v_B_}}) {
      plot.vector_on("", at(letter), v, Meaning::velocity, velocity(letter).arrow());
      plot.measures_coordinates(prefix_ + letter, at(letter), at("A0"));
    }
    const Words title =
        sense_ == Sense::same ? Words{"Same sense", "Concordi"} : Words{"Opposite senses", "Discordi"};
    const drawings::Box box = extent(plot.scale(), plot.vector_scale());
    const drawings::Point O = plot.at({0, 0});
    plot.mark(drawings::Writing{title.in(language), {O.x + box.low.x, O.y + box.high.y - title_ + 1}, 3.5});
    return {};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    std::vector<PanelStep> all{{step_to_Q(), Q_}, {step_to_A(), at("A")}};
    if (!tells_all_) return all;
    all.push_back(
        {{"$P_{31}$ is at infinity, $ω_{3}$ = 0: all points of the coupler have $\\vec{v}_{A}$ = $\\vec{v}_{B}$; "
          "|$ω_{4}$| = |$ω_{2}$|·$A_{0}A$ / $B_{0}B$. But $α_{3}$ is not zero: by a polygon as on sheet 3, drawn for "
          "this position.",
          "$P_{31}$ è all'infinito, $ω_{3}$ = 0: tutti i punti della biella hanno $\\vec{v}_{A}$ = $\\vec{v}_{B}$; "
          "|$ω_{4}$| = |$ω_{2}$|·$A_{0}A$ / $B_{0}B$. Ma $α_{3}$ non è nulla: con un poligono come nella tavola 3, "
          "per questa posizione."},
         plot.tip(at("B"), v_B_)});
    return all;
  }

 private:
  static constexpr double along_link = 0.62;  // clear of its number
  static constexpr double title_ = 6;         // mm
  static constexpr double compass_ = 8;       // mm of an arc to either side of Q

  const Place& at(const std::string& name) const { return mechanism_->at(name); }

  // Of the two points where the circles meet the other is that of the other branch: its mirror image in A₀B₀.
  Words step_to_Q() const {
    const Words left{"left", "sinistra"}, right{"right", "destra"};
    return format_words(
        "${0}$: of the two points where the circle of radius {1} about $A_{{0}}$ meets that of radius $AB$ about "
        "$B_{{0}}$, that on the {2} of $A_{{0}}$ → $B_{{0}}$. Crank and rocker lie along $A_{{0}}{0}$, {3}.",
        "${0}$: dei due punti in cui la circonferenza di raggio {1} e centro $A_{{0}}$ incontra quella di raggio "
        "$AB$ e centro $B_{{0}}$, quello a {2} di $A_{{0}}$ → $B_{{0}}$. Manovella e bilanciere sono lungo "
        "$A_{{0}}{0}$, {3}.",
        Q_letters_,
        std::string(sense_ == Sense::same ? "|$B_{0}B$\u00a0−\u00a0$A_{0}A$|" : "$B_{0}B$\u00a0+\u00a0$A_{0}A$"),
        is_Q_left() ? left : right,
        sense_ == Sense::same ? Words{"in the same sense", "concordi"} : Words{"in opposite senses", "discordi"});
  }
  Words step_to_A() const {
    const Words where = sense_ == Sense::opposite ? Words{"between $A_{0}$ and ", "fra $A_{0}$ e "}
                        : is_rocker_longer()      ? Words{"beyond $A_{0}$, seen from ", "oltre $A_{0}$, visto da "}
                                                  : Words{"beyond ", "oltre "};
    return format_words(
        "$A$ at $A_{{0}}A$ from $A_{{0}}$ on that line, {1}${0}$. The coupler ${0}B_{{0}}$, carried along it to $A$, "
        "is $AB$.",
        "$A$ ad $A_{{0}}A$ da $A_{{0}}$ su quella retta, {1}${0}$. La biella ${0}B_{{0}}$, traslata lungo di essa "
        "fino ad $A$, è $AB$.",
        Q_letters_, where);
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
  bool tells_all_;
  std::string Q_letters_;
  Place Q_;
  Arrow2 v_A_, v_B_;
};

bool is_parallelogram(const geometry::FourBarLengths& of) {
  return of.A0A == of.B0B && of.AB * of.AB == of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0;
}

}  // namespace

PanelSheet parallel_links_sheet(const Solution& s, Language language) {
  const Problem of = problem(s.givens());
  PanelSheet sheet{.seen = {"The four-bar linkage with crank and rocker parallel, in the same and in opposite senses",
                            "Il quadrilatero articolato con manovella e bilanciere paralleli, concordi e discordi"},
                   .without_part = without({"t", "phi", "AC", "C_side"})};
  std::vector<Row> angles, rates;
  for (const bool of_this_branch : {true, false})
    for (const Sense sense : {Sense::same, Sense::opposite}) {
      const std::string prefix = parallel_links(sense, of_this_branch).prefix;
      const std::string name = (sense == Sense::same ? "↑↑ " : "↑↓ ") +
                               (of_this_branch ? Words{"drawn", "disegnata"} : Words{"other", "altra"}).in(language);
      angles.push_back({name, {prefix + "crank_angle_deg", prefix + "omega_4"}, "–"});
      rates.push_back({name, {prefix + "alpha_3", prefix + "alpha_4"}, "–"});
      if (!of_this_branch || !s.value(prefix + "A_x")) continue;
      // The crank turns in one sense in both pictures: said where there is room for it.
      const double sense_of_crank = sheet.panels.empty() ? sign_of(of.instant.n) : 0;
      const auto mechanism = std::make_shared<const Mechanism>(four_bar_mechanism(s, sense_of_crank, prefix));
      sheet.panels.push_back(std::make_unique<ParallelPanel>(s, of, mechanism, sense, sheet.panels.empty()));
      sheet.told.push_back(prefix + "omega_4");
    }
  sheet.results = {
      table({"", "$φ$ (°)", "$ω_{4}$ (rad/s)"}, angles), table({"", "$α_{3}$ (rad/s²)", "$α_{4}$ (rad/s²)"}, rates),
      remark(Words{"↑↑ same sense, ↑↓ opposite senses; the other branch has $B$ on the other side of $AB_{0}$.",
                   "↑↑ concordi, ↑↓ discordi; l'altra posizione ha $B$ dall'altra parte di $AB_{0}$."}
                 .in(language))};
  if (is_parallelogram(of.instant.lengths))
    sheet.results.push_back(
        remark(Words{"Opposite links are as long as each other: while the linkage is a parallelogram, crank and "
                     "rocker are parallel in the same sense throughout.",
                     "Le aste opposte sono lunghe uguali: finché il meccanismo è un parallelogramma, manovella e "
                     "bilanciere sono sempre paralleli e concordi."}
                   .in(language)));
  if (!sheet.panels.empty()) return sheet;
  sheet.panels.push_back(std::make_unique<MechanismPanel>(linkage(s)));
  sheet.results.push_back(remark(Words{
      "On this branch crank and rocker are never parallel but at change points. Drawn: the linkage at its instant.",
      "Su questo ramo manovella e bilanciere non sono mai paralleli, se non in punti di cambiamento. È disegnato il "
      "meccanismo all'istante dato."}
                                     .in(language)));
  sheet.without_part = without({"AC", "C_side"});
  return sheet;
}

}  // namespace epure::four_bar
