// An exercise checked: every quantity by all its routes, held against each other, against the drawing and against the
// source.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/proof/verdict.h"

namespace epure {

// A quantity as its sheet shows it, end points as the file holds them.
struct OnSheet {
  std::string sheet;
  double value = 0;
  double resolution = 0;      // how far from the true value it may lie and still be drawn right
  double per_mm = 1;          // SI per mm of paper
  bool signed_value = false;  // measured along an axis; else a length, to be compared with the magnitude
};

// A number a reader measured, and what a ruler allows.
struct Measured {
  std::string text;
  double value = 0;
  std::optional<double> difference = {}, difference_percent = {};  // none when there is no value to compare with
  double allowed = 0;
  Words allowed_by;  // "0.5 mm on sheet poles", "half a unit of its last digit"
  bool within = false;
};

struct CheckedQuantity {
  Quantity spec;
  geometry::Settled settled;  // of the route that knows most
  std::vector<RouteValue> routes;
  std::vector<OnSheet> on_sheets = {};
  std::vector<PrintedVerdict> printed = {};
  std::vector<Measured> measured = {};
};

// What is wrong or open, in one sentence. Of a quantity it begins with the name.
struct Complaint {
  enum class About { quantity, sheet, mechanism } about = About::quantity;
  std::string quantity;  // none of the others
  Words sentence;
};

struct CheckedExercise {
  const Description& about;
  Givens givens;
  std::vector<CheckedQuantity> quantities;
  std::vector<Complaint> failures = {};
  std::vector<Complaint> undecided = {};  // what no number could decide, by one route or by all
  std::vector<Complaint> not_drawn = {};  // sheets for which the numbers are too far apart, with the reason
  std::vector<TableAudit> audits = {};    // of the source's tables
  bool passed() const { return failures.empty() && undecided.empty() && not_drawn.empty(); }
};

// All that failed, then all that is undecided, in English.
std::vector<std::string> complaints(const CheckedExercise& checked);

// The scales of lengths at which sheets were drawn (1/5 for 1 : 5), by name: those of a class share one.
using SheetScales = std::map<std::string, Rational>;

// On rung fast nothing has bounds, so routes are not compared; on the others their enclosures must meet. Only the
// climb demands that every quantity is settled, by at least two routes. Sheets are measured at these scales; others,
// and those for which no paper has room, at the largest that fits. Throws what the exercise throws.
CheckedExercise check(const Exercise& exercise, const Givens& givens, Rung rung, const SheetScales& scales = {});

// Adds a measured number to a quantity, with a failure when it is beyond what can be read (measured.h). Throws
// geometry::BadGiven for an unreadable text.
struct Ruler;
void add_measured(CheckedExercise& checked, CheckedQuantity& quantity, const std::string& text, const Ruler& ruler);

// The sheet's value of a measurement.
OnSheet measure(const Measurement& measurement, const std::string& sheet, drawings::Paper paper);

// Whether the sheet shows the value, as nearly as a file can hold it.
bool is_within_resolution(const OnSheet& shown, double value);

// Of the sheets that show a quantity the one that misses the value most, in units of its resolution; null when none
// shows it.
const OnSheet* farthest_on_sheet(const CheckedQuantity& quantity);

}  // namespace epure
