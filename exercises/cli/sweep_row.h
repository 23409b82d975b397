// One position of a sweep: what is known of each quantity there, and how a line holds it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/sweep_study.h"
#include "exercises/kit/statement/csv_style.h"

namespace epure {

struct SweptQuantity {
  enum class State {
    value,        // with bounds; when there is a reason all the same, these hold several doubles
    absent,       // proved not to exist
    impossible,   // no quantity does at these givens
    undecided,    // no number could tell
    disagreement  // two routes cannot both be right, or no route gives it
  };
  State state;
  geometry::Enclosure enclosure = {};  // of a value, SI
  Words reason = {};
};

struct SweptRow {
  std::uint64_t number;                   // from 0
  std::vector<std::uint64_t> places;      // of the variations
  std::vector<SweptQuantity> quantities;  // in the study's order
  std::vector<Flaw> faults = {};          // of the mechanism itself, though its numbers exist

  bool is_possible() const;
  bool is_undecided() const;  // of something no more is known, or whether there is a fault
  bool has_disagreement() const;
};

// By all routes of the exercise, up the numbers. Of each quantity asked for alone, as far as the routes allow it.
SweptRow swept_row(const SweepStudy& study, std::uint64_t number);

// Plain text: why there is no value, or not one double alone; what is no plain absence says so. Empty: nothing is to
// be said.
Words reason_in_full(const SweptQuantity& quantity);
// Their sentences one behind the other; what may be one says so.
std::string faults_in_line(const std::vector<Flaw>& faults, Language language);

// "phi (deg),v_B (m/s),v_B_lower (m/s),v_B_upper (m/s),v_B_reason", and at the end
// "faults". A given of which a quantity asked for has the name is "mu_given".
std::string csv_header(const SweepStudy& study, const CsvStyle& style);
// The same of a row; what is known otherwise than by a number is empty, with the reason. A position that no decimal
// says is a fraction, for a spreadsheet the nearest double.
std::string csv_line(const SweepStudy& study, const SweptRow& row, const CsvStyle& style, Language language);

// Schema epure.sweep/1: one object, in one line. Its words are English.
std::string json_line(const SweepStudy& study, const SweptRow& row);

}  // namespace epure
