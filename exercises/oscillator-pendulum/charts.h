// What the charts and tables of both exercises share.
#pragma once

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/oscillator-pendulum/drawn_curves.h"

namespace epure::oscillator_pendulum {

using drawings::Datum;
using Line = std::vector<Datum>;

std::string at(const std::string& of, const std::string& instant);

constexpr int smooth = 400;  // points of a curve
// Points of Euler's polygon are marked one by one where they do not run into each other.
constexpr std::size_t most_marked = 60;

// As few of them as look like the curve; all that are shown stay on it.
template <class Points>
Points thinned(const Points& all, std::size_t most) {
  const std::size_t every = all.size() / most + 1;
  Points some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  return some;
}
Line over_time(const std::vector<Moving>& all);
Line in_phase_plane(const std::vector<Moving>& all);

// The ends of an axis that shows all these, with air; never a point.
struct Ends {
  double low, high;
};
Ends ends_of(const Line& line, double Datum::*along, double air);
drawings::Axis axis(const std::string& quantity, const std::string& unit, const Ends& ends);

// Of both routes of a point of a chart, where it has a value.
void read(std::vector<ChartPanel::Read>& onto, const Solution& s, double x, const std::string& along_x,
          const std::string& along_y);
double seconds(const std::string& name);

// Beside points of a chart: "300".
std::string in_milliseconds(const std::string& name);
// Rows of a table begin with a whole number, of seconds or of milliseconds.
std::vector<Row> rows(const std::vector<std::string>& instants_told, int units_of_a_second,
                      const std::string& case_name, const std::vector<std::string>& columns);
std::vector<Row> rows_of_pendulum(const std::vector<std::string>& columns);

// Quantities of the pendulum.
std::string pen(const std::string& name);
std::vector<std::string> all_pen(const std::vector<std::string>& names);

}  // namespace epure::oscillator_pendulum
