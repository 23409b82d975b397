#include "exercises/gear-pair/pitch_point_text.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/gear-pair/contact_words.h"
#include "exercises/gear-pair/fault_words.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

Words of_tangent_points(const DrawnPair& pair) {
  if (pair.is_rack())
    return {"The perpendicular from $O_{1}$: $T_{1}$ on the base circle.",
            "La perpendicolare da $O_{1}$: $T_{1}$ sul cerchio di base."};
  const bool off = !is_near(pair, pair.T1) || !is_near(pair, *pair.T2);
  return {std::string("Perpendiculars from the centres: $T_{1}$, $T_{2}$ on base circles.") +
              (off ? " Not both lie on the sheet." : ""),
          std::string("Le perpendicolari dai centri: $T_{1}$, $T_{2}$ sui cerchi di base.") +
              (off ? " Non cadono entrambi nel foglio." : "")};
}

// Up to the line of action and the base circles.
std::vector<Words> steps_without_contact(const DrawnPair& pair) {
  const std::string alpha = pair.alpha == pair.alpha_w ? "$α$" : "$α_{w}$";
  return {pair.is_rack() ? Words{"Pitch circle and pitch line touch in $P_{0}$, the pitch point.",
                                 "Primitiva e retta primitiva si toccano in $P_{0}$."}
                         : Words{"The pitch circles touch in $P_{0}$, the pitch point.",
                                 "Le primitive si toccano in $P_{0}$ sulla retta dei centri."},
          {"The line of action there, at " + alpha + " to the common tangent.",
           "La retta d'azione per $P_{0}$, a " + alpha + " dalla tangente comune."},
          of_tangent_points(pair)};
}

Words of_flanks(const DrawnPair& pair) {
  const DrawnPath& path = pair.path;
  if (!path.touches)
    return {"The flanks are involutes of the base circles; these never touch.",
            "I fianchi sono evolventi delle circonferenze di base; questi non si toccano mai."};
  const bool at_P0 = pair.shown_contact() == 0;
  const std::string begin = "$" + path.begins.name + "$", end = "$" + path.ends.name + "$",
                    all = "$" + name_of_path(path) + "$";
  return {"The flanks are involutes of the base circles, here touching " +
              (at_P0 ? "in $P_{0}$" : "in the middle of " + all) + "; dashed, in " + begin + " and in " + end + ".",
          "I fianchi sono evolventi delle circonferenze di base, qui a contatto " +
              (at_P0 ? "in $P_{0}$" : "nel mezzo di " + all) + "; tratteggiati, in " + begin + " e in " + end + "."};
}

Words of_arcs(const DrawnPair& pair) {
  const std::string alpha = pair.alpha == pair.alpha_w ? "$α$" : "$α_{w}$", e = "$e$ = $AE$/cos\u00a0" + alpha + ".";
  if (pair.path.is_whole())
    return {
        "Touching in $A$ and $E$ they cut the pitch circles in $N_{1}$ and $N_{2}$: the arcs of action are equal, " +
            e,
        "A contatto in $A$ e in $E$ tagliano le primitive in $N_{1}$ e $N_{2}$: gli archi di azione sono uguali, " +
            e};
  return {
      "Whole, touching in $A$ and $E$, they would cut the pitch circles in $N_{1}$ and $N_{2}$: the arcs of action "
      "are equal, " +
          e,
      "Interi, a contatto in $A$ e in $E$, taglierebbero le primitive in $N_{1}$ e $N_{2}$: gli archi di azione "
      "sono uguali, " +
          e};
}

std::vector<Words> steps_of_contact(const DrawnPair& pair) {
  const Words whole = pair.path.is_whole() ? Words{} : Words{" of whole flanks", " di fianchi interi"};
  std::vector<Words> steps{
      {"Tip 2 cuts it in $A$, tip 1 in $E$: $AE$ is the path of contact" + whole.english + ".",
       "La tagliano la testa 2 in $A$, la 1 in $E$: $AE$ è la linea di ingranamento" + whole.italian + "."},
      of_flanks(pair),
      of_arcs(pair)};
  const std::string begin = "$" + pair.path.begins.name + "$", end = "$" + pair.path.ends.name + "$";
  if (pair.has_single_contact())
    steps.push_back({"The base pitch $p_{b}$ from " + begin + " gives $D$, from " + end +
                         " gives $B$: between them one pair of teeth carries alone.",
                     "Il passo di base $p_{b}$ da " + begin + " dà $D$, da " + end +
                         " dà $B$: fra questi lavora una sola coppia di denti."});
  return steps;
}

drawings::Table lengths_of_mesh(const DrawnPair& pair, Language language) {
  const auto mm = [&](double metres) { return figures(1000 * metres, 4, language); };
  drawings::Table table{{"mm", "", Words{"at most", "al più"}.in(language)}, {}};
  const auto row = [&](const Words& name, double value, const std::string& limit = "") {
    table.rows.push_back({name.in(language), mm(value), limit});
  };
  if (pair.has_contact()) {
    const double cosine = std::cos(pair.alpha_w);
    row({"path of approach $P_{0}A$", "linea di accesso $P_{0}A$"}, -*pair.A, mm(-pair.T1));
    row({"path of recess $P_{0}E$", "linea di recesso $P_{0}E$"}, *pair.E,
        pair.T2 && !pair.is_ring() ? mm(*pair.T2) : "∞");
    row({"path of contact $AE$", "linea di ingranamento $AE$"}, *pair.E - *pair.A);
    row({"arc of approach", "arco di accesso"}, -*pair.A / cosine);
    row({"arc of recess", "arco di recesso"}, *pair.E / cosine);
    row({"arc of action $e$", "arco di azione $e$"}, (*pair.E - *pair.A) / cosine);
  }
  row({"circular pitch $p$", "passo $p$"}, pair.pitch);
  row({"base pitch $p_{b}$", "passo di base $p_{b}$"}, pair.base_pitch);
  row({"clearance tip 1, root 2", "gioco testa 1, fondo 2"}, pair.root_at_mesh(2).y - pair.tip_at_mesh(1).y);
  row({"clearance tip 2, root 1", "gioco testa 2, fondo 1"}, pair.tip_at_mesh(2).y - pair.root_at_mesh(1).y);
  return table;
}

void add_missing_outlines(DrawnSheet& onto, const Teeth& teeth, Language language) {
  for (const int wheel : {1, 2})
    if (!teeth.has(wheel))
      onto.sheet.column.push_back(drawings::Paragraph{
          fmt::format("{} {}: {}.", Words{"No outline of wheel", "Nessun profilo della ruota"}.in(language), wheel,
                      Words{"the rack that should cut it leaves no such teeth",
                            "la dentiera che dovrebbe tagliarla non lascia denti simili"}
                          .in(language))});
}

// On working circles that are not the reference circles the pitch is not p: then by the line of action.
std::string contact_ratio(const DrawnPair& pair, Language language) {
  const char* quotient = pair.alpha == pair.alpha_w ? "$e$/$p$" : "$AE$/$p_{b}$";
  return fmt::format("{} $f$ = {} = {}{}.", Words{"Contact ratio", "Fattore di ricoprimento"}.in(language), quotient,
                     figures(pair.contact_ratio(), 4, language),
                     pair.path.is_whole() ? "" : Words{" of whole flanks", " di fianchi interi"}.in(language));
}

}  // namespace

std::string pressure_angle(const DrawnPair& pair, Language language) {
  if (pair.alpha != pair.alpha_w)
    return fmt::format("$α_{{w}}$ = {}°", figures(pair.alpha_w * 180 / std::numbers::pi, 4, language));
  return fmt::format("$α$ = {}°", short_number(degrees(pair.of.alpha), language));
}

bool is_near(const DrawnPair& pair, double xi) {
  const double path = pair.has_contact() ? *pair.E - *pair.A : 5 * CGAL::to_double(pair.of.m);
  return std::abs(xi) < 2.5 * path;
}

void add_text(DrawnSheet& onto, const DrawnPair& pair, const Teeth& teeth, Language language) {
  auto& column = onto.sheet.column;
  add_faults(onto, pair, language);
  add_missing_outlines(onto, teeth, language);
  column.push_back(drawings::Heading{Words{"Construction", "Costruzione"}.in(language)});
  drawings::Steps steps;
  for (const Words& step : steps_without_contact(pair)) steps.lines.push_back(step.in(language));
  if (pair.has_contact())
    for (const Words& step : steps_of_contact(pair)) steps.lines.push_back(step.in(language));
  column.push_back(steps);
  column.push_back(drawings::Heading{Words{"Results", "Risultati"}.in(language)});
  column.push_back(lengths_of_mesh(pair, language));
  std::vector<Value> values{{"p_b", pair.base_pitch, "m"}};
  if (pair.has_contact()) {
    column.push_back(drawings::Paragraph{contact_ratio(pair, language)});
    const bool whole = pair.path.is_whole();
    if (!whole)
      column.push_back(drawings::Paragraph{about_path(
          pair, {"Paths and arcs are of whole flanks", "Linee e archi sono di fianchi interi"}, language)});
    values.insert(
        values.begin(),
        {{"P0A", -*pair.A, "m"}, {"P0E", *pair.E, "m"}, {whole ? "f" : "AE/p_b", pair.contact_ratio(), ""}});
    if (!whole && pair.path.known && pair.path.touches)
      values.push_back(
          {plain_name(pair.path.begins) + plain_name(pair.path.ends) + "/p_b", pair.true_contact_ratio(), ""});
  }
  onto.sheet.description = in_words(
      {"Both wheels around the pitch point with their circles, the line of action, the path of contact AE and "
       "a pair of teeth in contact",
       "Le due ruote intorno al punto P0 con le circonferenze, la retta d'azione, la linea di ingranamento AE "
       "e una coppia di denti a contatto"},
      values, language);
}

}  // namespace epure::gear_pair
