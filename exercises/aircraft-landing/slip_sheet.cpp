// Speeds of aircraft and rim until slip ends; the areas below are the ways.
#include "exercises/aircraft-landing/landing.h"
#include "exercises/aircraft-landing/sheets.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {

PanelSheet slip_sheet(const Solution& s, Language language) {
  return {.panels = panels(ChartPanel({})), .results = {values({"t_s", "v_s", "omega_s"})}, .seen = {"", ""}};
}

}  // namespace epure::aircraft_landing
