#include "exercises/friction-efficiency/sheets.h"

namespace epure::friction_efficiency {

std::vector<SheetMaker> sheets() {
  return {
      {{"wedge",
        {"Wedge and collar", "Cuneo e collare"},
        {"A wedge lifts a rod in its collar. All pairs rub. Find the driving force in direct motion, the force that "
         "holds back in retrograde motion by force polygons, and both efficiencies.",
         "Un cuneo solleva un'asta nel suo collare. In tutte le coppie c'è attrito. Trovare con i poligoni delle "
         "forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       wedge},
      {{"two-forces",
        {"Collar with two forces", "Collare con due forze"},
        {"A wedge lifts a rod in its collar, which answers with two forces. All pairs rub. Find the driving force in "
         "direct motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Un cuneo solleva un'asta nel suo collare, che risponde con due forze. In tutte le coppie c'è attrito. "
         "Trovare con i poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto "
         "retrogrado, e i due rendimenti."}},
       two_forces},
      {{"double-slider",
        {"Double slider", "Doppio pattino"},
        {"A bar joins two sliders. All pairs rub. Find the driving force in direct motion, the force that holds back "
         "in retrograde motion by force polygons, and both efficiencies.",
         "Un'asta unisce due pattini. In tutte le coppie c'è attrito. Trovare con i poligoni delle forze la forza "
         "motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       double_slider},
      {{"levers",
        {"Sliding levers, Q on lever 3", "Leve striscianti, Q sulla leva 3"},
        {"One lever slides on another, with the load on lever 3. All pairs rub. Find the driving force in direct "
         "motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Una leva striscia sull'altra, con il carico sulla leva 3. In tutte le coppie c'è attrito. Trovare con i "
         "poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i "
         "due rendimenti."}},
       [](const Solution& s, Language language) { return levers(s, "sliding_levers", 3, language); }},
      {{"levers-Q-on-2",
        {"Sliding levers, Q on lever 2", "Leve striscianti, Q sulla leva 2"},
        {"One lever slides on another, with the load on lever 2. All pairs rub. Find the driving force in direct "
         "motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Una leva striscia sull'altra, con il carico sulla leva 2. In tutte le coppie c'è attrito. Trovare con i "
         "poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i "
         "due rendimenti."}},
       [](const Solution& s, Language language) { return levers(s, "sliding_levers_Q_on_2", 2, language); }},
      {{"fairbairn",
        {"Fairbairn's mechanism", "Guida di Fairbairn"},
        {"Fairbairn's mechanism carries its load. All pairs rub. Find the driving force in direct motion, the force "
         "that holds back in retrograde motion by force polygons, and both efficiencies.",
         "La guida di Fairbairn porta il suo carico. In tutte le coppie c'è attrito. Trovare con i poligoni delle "
         "forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       [](const Solution& s, Language language) { return fairbairn(s, "fairbairn", language); }},
      {{"fairbairn-short-lever",
        {"Fairbairn's mechanism, shorter lever", "Guida di Fairbairn, leva più corta"},
        {"Fairbairn's mechanism with the shorter lever carries its load. All pairs rub. Find the driving force in "
         "direct motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "La guida di Fairbairn con la leva più corta porta il suo carico. In tutte le coppie c'è attrito. Trovare "
         "con i poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, "
         "e i due rendimenti."}},
       [](const Solution& s, Language language) { return fairbairn(s, "fairbairn_short_lever", language); }},
      {{"efficiencies",
        {"Efficiency and friction angle", "Rendimento e angolo d'attrito"},
        {"All pairs of the mechanisms rub. Find how the efficiencies depend on the friction angle, and at "
         "which one self-locking and jamming begin.",
         "In tutte le coppie dei meccanismi c'è attrito. Trovare come i rendimenti dipendono dall'angolo "
         "d'attrito, e a quale iniziano l'arresto spontaneo e l'impuntamento."}},
       over_friction_angle}};
}

}  // namespace epure::friction_efficiency
