// What the exercise takes and reports.
#include "exercises/gear-pair/problem.h"

namespace epure::gear_pair {
namespace {

GivenSpec profile(const std::string& symbol, const Words& meaning, const std::string& stated, Range range,
                  const std::string& letters) {
  return {symbol, meaning, "1", stated, range, letters, {}, symbol != "ha" && symbol != "hf" && symbol != "rho"};
}

Quantity metres(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m", meaning};
}
Quantity pure(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "1", meaning};
}
Quantity degrees(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "deg", meaning};
}

using Specs = std::vector<Quantity>;

Words on_wheel(const Words& what, const std::string& wheel) {
  return {what.english + " of wheel " + wheel, what.italian + " della ruota " + wheel};
}

// One length of either wheel.
Specs both(const std::string& name, const std::string& symbol, const std::string& subscript, const Words& what) {
  Specs pair;
  for (const std::string wheel : {"1", "2"})
    pair.push_back(metres(name + "_" + wheel, "$" + symbol + "_{" + subscript + wheel + "}$", on_wheel(what, wheel)));
  return pair;
}

Specs radii() {
  Specs all{metres("r1", "$r_{1}$", {"pitch radius of wheel 1", "raggio primitivo della ruota 1"}),
            metres("r2", "$r_{2}$", {"pitch radius of wheel 2", "raggio primitivo della ruota 2"})};
  for (const Specs& more :
       {both("r_tip", "r", "a", {"tip radius", "raggio di troncatura esterna"}),
        both("r_root", "r", "f", {"root radius", "raggio di troncatura interna"}),
        both("r_base", "r", "b", {"base radius", "raggio di base"}),
        both("r_w", "r", "w", {"working pitch radius", "raggio della primitiva di funzionamento"})})
    all.insert(all.end(), more.begin(), more.end());
  all.push_back(metres("centre_distance", "$a$", {"centre distance", "interasse"}));
  all.push_back(degrees("working_pressure_angle_deg", "$α_{w}$",
                        {"working pressure angle", "angolo di pressione di funzionamento"}));
  return all;
}

Specs heights() {
  return {
      metres("addendum", "$h_{a1}$", {"addendum of wheel 1", "addendum della ruota 1"}),
      metres("dedendum", "$h_{f1}$", {"dedendum of wheel 1", "dedendum della ruota 1"}),
      metres("addendum_2", "$h_{a2}$", {"addendum of wheel 2", "addendum della ruota 2"}),
      metres("dedendum_2", "$h_{f2}$", {"dedendum of wheel 2", "dedendum della ruota 2"}),
      metres("tooth_height", "$h$", {"height of the teeth", "altezza dei denti"}),
      metres("clearance", "$δ$", {"clearance between tip 1 and root 2", "gioco tra la testa 1 e il fondo 2"}),
      metres("clearance_2", "$δ_{2}$", {"clearance between tip 2 and root 1", "gioco tra la testa 2 e il fondo 1"}),
      pure("z1", "$z_{1}$", {"teeth of wheel 1", "denti della ruota 1"}),
      pure("z2", "$z_{2}$", {"teeth of wheel 2", "denti della ruota 2"}),
      metres("circular_pitch", "$p$", {"circular pitch", "passo circonferenziale"}),
      metres("base_pitch", "$p_{b}$", {"base pitch", "passo di base"})};
}

Specs contact() {
  return {metres("path_of_approach", "$P_{0}A$", {"path of approach", "linea di ingranamento di accesso"}),
          metres("path_of_recess", "$P_{0}E$", {"path of recess", "linea di ingranamento di recesso"}),
          metres("path_of_contact", "$AE$", {"path of contact", "linea di ingranamento"}),
          metres("arc_of_approach", "$e_{a}$", {"arc of approach", "arco di accesso"}),
          metres("arc_of_recess", "$e_{r}$", {"arc of recess", "arco di recesso"}),
          metres("arc_of_action", "$e$", {"arc of action", "arco di azione"}),
          pure("contact_ratio", "$f$", {"contact ratio", "fattore di ricoprimento"}),
          metres("start_of_active_profile_radius_1", "$O_{1}A$",
                 {"radius at which the active profile of wheel 1 begins",
                  "raggio al quale inizia il profilo attivo della ruota 1"}),
          metres("start_of_active_profile_radius_2", "$O_{2}E$",
                 {"radius at which the active profile of wheel 2 begins",
                  "raggio al quale inizia il profilo attivo della ruota 2"})};
}

Specs sliding() {
  const auto specific = [](const std::string& wheel, const std::string& where, const std::string& point) {
    return pure("specific_sliding_" + wheel + "_" + where, "$ζ_{" + wheel + point + "}$",
                {"specific sliding of flank " + wheel + " in " + point,
                 "strisciamento specifico del fianco " + wheel + " in " + point});
  };
  return {
      {"omega_1", "$ω_{1}$", "rad/s", {"angular velocity of wheel 1", "velocità angolare della ruota 1"}},
      {"omega_2",
       "$ω_{2}$",
       "rad/s",
       {"angular velocity of wheel 2, as wheel 1 positive", "velocità angolare della ruota 2, positiva come la 1"}},
      {"omega_relative", "$ω_{r}$", "rad/s", {"relative angular velocity", "velocità angolare relativa"}},
      {"sliding_velocity_approach", "$v_{A}$", "m/s", {"sliding velocity in A", "velocità di strisciamento in A"}},
      {"sliding_velocity_recess", "$v_{E}$", "m/s", {"sliding velocity in E", "velocità di strisciamento in E"}},
      specific("1", "approach", "A"),
      specific("2", "approach", "A"),
      specific("1", "recess", "E"),
      specific("2", "recess", "E")};
}

Specs teeth_of(const std::string& wheel) {
  const auto thickness = [&](const std::string& where, const std::string& index, const Words& on) {
    return metres("tooth_thickness_" + where + "_" + wheel, "$s_{" + index + wheel + "}$",
                  {"tooth thickness on the " + on.english + " of wheel " + wheel,
                   "spessore del dente sulla circonferenza " + on.italian + " della ruota " + wheel});
  };
  return {thickness("pitch", "", {"pitch circle", "primitiva"}),
          thickness("working", "w", {"working pitch circle", "primitiva di funzionamento"}),
          thickness("base", "b", {"base circle", "di base"}),
          thickness("tip", "a", {"tip circle", "di troncatura esterna"}),
          degrees("tip_pressure_angle_" + wheel + "_deg", "$α_{a" + wheel + "}$",
                  on_wheel({"pressure angle at the tip", "angolo di pressione in testa"}, wheel))};
}

Specs limits() {
  return {metres("interference_limit_approach", "$P_{0}T_{1}$",
                 {"longest path of approach without interference", "massima linea di accesso senza interferenza"}),
          metres("interference_limit_recess", "$P_{0}T_{2}$",
                 {"longest path of recess without interference", "massima linea di recesso senza interferenza"}),
          metres("max_tip_radius_2_without_interference", "$O_{2}T_{1}$",
                 {"tip radius of wheel 2 at which interference begins",
                  "raggio di testa della ruota 2 al quale inizia l'interferenza"}),
          metres("max_tip_radius_1_without_interference", "$O_{1}T_{2}$",
                 {"tip radius of wheel 1 at which interference begins",
                  "raggio di testa della ruota 1 al quale inizia l'interferenza"}),
          metres("undercut_limit_addendum_1", "$h_{lim1}$",
                 {"largest addendum of the rack that does not undercut wheel 1",
                  "massimo addendum della dentiera che non sottotaglia la ruota 1"}),
          pure("undercut_limit_teeth", "$z_{lim}$",
               {"limit of undercut by the rack, in teeth of wheel 1",
                "limite di sottotaglio con la dentiera, in denti della ruota 1"}),
          pure("minimum_teeth_no_undercut_rack", "$z_{min}$",
               {"least teeth of wheel 1 without undercut by the rack",
                "minimo numero di denti della ruota 1 senza sottotaglio"}),
          pure("interference_limit_teeth", "$z_{int}$",
               {"limit of interference at this ratio, in teeth of wheel 1",
                "limite di interferenza con questo rapporto, in denti della ruota 1"}),
          pure("minimum_teeth_pinion_for_this_ratio", "$z_{1min}$",
               {"least teeth of wheel 1 without interference at this ratio",
                "minimo numero di denti della ruota 1 senza interferenza con questo rapporto"})};
}

}  // namespace

std::vector<GivenSpec> givens() {
  return {
      {"m", {"module", "modulo"}, "mm", "10", Range::positive, "$m$"},
      {"z1",
       {"teeth of wheel 1, which drives", "denti della ruota 1, motrice"},
       "1",
       "20",
       Range::positive,
       "$z_{1}$"},
      {"z2", {"teeth of wheel 2", "denti della ruota 2"}, "1", "40", Range::positive, "$z_{2}$"},
      {"alpha", {"pressure angle", "angolo di pressione"}, "deg", "22", Range::positive, "$α$"},
      profile("x1", {"profile shift of wheel 1, over m", "spostamento del profilo della ruota 1, su m"}, "0",
              Range::any, "$x_{1}$"),
      profile("x2", {"profile shift of wheel 2, over m", "spostamento del profilo della ruota 2, su m"}, "0",
              Range::any, "$x_{2}$"),
      profile("ha", {"addendum of the rack, over m", "addendum della dentiera, su m"}, "1", Range::positive,
              "$h_{a}^{*}$"),
      profile("hf", {"dedendum of the rack, over m", "dedendum della dentiera, su m"}, "1.25", Range::positive,
              "$h_{f}^{*}$"),
      profile("k", {"shortening of the tips, over m", "raccorciamento delle teste, su m"}, "0", Range::any, "$k$"),
      profile("rho", {"rounding of the cutter's tip, over m", "raccordo di testa dell'utensile, su m"}, "0.25",
              Range::not_negative, "$ρ^{*}$"),
      {"j",
       {"backlash on the pitch circles", "gioco sulle primitive"},
       "mm",
       "0",
       Range::not_negative,
       "$j$",
       {},
       true},
      {"n1", {"speed of wheel 1", "velocità della ruota 1"}, "rpm", "150", Range::positive, "$n_{1}$"},
      {.symbol = "kind",
       .meaning = {"kind of pair", "tipo di coppia"},
       .unit = "1",
       .stated = "external",
       .range = Range::any,
       .letters = {},
       .choices = {{"external", {"external wheels", "ruote esterne"}},
                   {"internal", {"wheel 2 is a ring", "la ruota 2 è interna"}},
                   {"rack", {"wheel 2 is a rack", "la ruota 2 è una dentiera"}}},
       .beyond_source = true}};
}

std::vector<Quantity> quantities() {
  Specs all = radii();
  for (const Specs& more : {heights(), contact(), sliding(), teeth_of("1"), teeth_of("2"), limits()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace epure::gear_pair
