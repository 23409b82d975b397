// The resisting torque over the turn.
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pump-flywheel/sheets.h"

namespace epure::pump_flywheel {

PanelSheet torque_sheet(const Solution&, Language) {
  return {.panels = panels(ChartPanel({})), .results = {values({"M_r_mean"})}, .seen = {"", ""}};
}

}  // namespace epure::pump_flywheel
