// What `epure bench` measures, as plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epure::bench {

// A result that came out worst: what was told, and what is true.
struct WorstResult {
  std::string name;  // "CASE: RESULT"
  double told = 0, truth = 0;
};

// One family with one number, over its whole corpus.
//
// Relative errors and bounds are those of results that have a value other than zero, where the number settled it:
//   fast      gave a number
//   bounded   gave an enclosure whose half width is less than the true value
//   deep      gave an enclosure with half a width of at most 1e-30 of the true value, at 128, 256, ... or 2048 bits
//   exact     gave a value in the tower of quadratic fields
// All others are handed over, deep ones (to more bits) already when 128 are too few for their case, exact ones to
// Calcium. A number that settles nothing has no error.
//
// Times of fast and bounded begin with the givens as numbers (in roulettes and gears, whose constructions take exact
// givens, with these); those of deep and exact with exact givens, because a precision or tower serves one case.
struct FamilyResult {
  std::string family, number;  // "fast", "bounded", "deep", "exact"
  double ns_per_result = 0;    // over the cases that the number settles, all results having values
  double max_relative_error = 0, median_relative_error = 0;
  std::optional<double> max_relative_bound = {};  // none: nothing was promised
  double handed_over = 0;                         // share of the results

  std::size_t results = 0;
  // fast: a number for what is zero or does not exist, or no number for what has one. The others: an enclosure
  // without the truth in it, a sign proved for a zero, a proof that what exists does not.
  std::size_t wrong = 0;
  WorstResult worst = {};

  bool settled_any() const { return max_relative_bound || number == "fast"; }
};

// The questions of a family (is it a dead centre; which side of it?) over its whole corpus, with whichever number
// proves the answer.
struct DecisionResult {
  std::string family;
  std::size_t asked = 0, undecided = 0;
  std::size_t by_bounded = 0, by_deep = 0;  // proved
  std::size_t otherwise = 0;                // by exact numbers, on the rationals, or because nothing exists there
  double slowest_ms = 0;
  std::string slowest = {};  // "CASE: QUESTION"
};

// One position of a mechanism after the other, velocities and accelerations too (many_positions.h).
struct PositionResult {
  std::string mechanism, number;
  double ns = 0;  // for one position
  double max_relative_error = 0;
  std::optional<double> max_relative_bound = {};  // none: nothing was promised
};

// A curve drawn to a tolerance, by Bezier arcs of proved deviation and by points at equal steps joined by lines.
struct CurveResult {
  std::string curve;
  double tolerance = 0;  // of the unit of the curve, as all lengths here
  double proved = 0;     // deviation promised
  double verified = 0;   // largest distance of a dense row of true points from the arcs
  std::size_t arcs = 0;
  double ms = 0;
  std::size_t bytes = 0;          // that the curve adds to a PDF
  std::size_t uniform_lines = 0;  // lines between points at equal steps that deviate as little; 0: too many
  double uniform_ms = 0;
  std::size_t uniform_bytes = 0;
};

// A whole sheet as a process of its own: epure, and the floor (bench/floor/floor.cpp). Milliseconds of processor
// time, the least of some runs.
struct SheetResult {
  std::string sheet;
  double epure_ms = 0, floor_ms = 0;
  std::vector<double> parts_ms = {};  // by drawings::Work
};

struct Machine {
  std::string processor, compiler;
  unsigned cores = 1;
};

struct Report {
  Machine machine;
  std::vector<FamilyResult> families;
  std::vector<DecisionResult> decisions;
  std::vector<PositionResult> positions;
  std::vector<CurveResult> curves;
  std::vector<SheetResult> sheets;
  std::string no_sheets = {};  // why none were measured
};

}  // namespace epure::bench
