// An exercise: what it says of itself, what it finds, and the sheets it draws.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawings/picture.h"
#include "exercises/kit/statement/description.h"
#include "exercises/kit/statement/long_table.h"
#include "geometry/numbers/climb.h"

namespace epure {

// How a number is to be computed: with the climb; on one rung to show what that rung is worth; with the 256 bits that
// drawings are made with; or not at all, where only the names of what would be found are asked for.
enum class Rung { names, fast, bounded, climb, drawing };

// One quantity by one route, with what its exercise says of it (nothing where that is listed apart, or of what only a
// drawing needs).
struct RouteValue {
  std::string quantity, route;
  geometry::Settled settled;
  std::optional<Quantity> described = {};
};

// A quantity as drawn: two points of the sheet, and what a millimetre between them is worth.
struct Measurement {
  std::string quantity;
  drawings::Point from, to;                              // mm
  double per_mm = 1;                                     // SI per mm of paper
  enum Kind { length, along_x, along_y } kind = length;  // along_*: signed, from -> to
};

// What a teacher writes into the title block instead of what stands there; empty: nothing. Plain text.
struct OwnTitles {
  std::string course, title, sheet_number, author;
};
// Who is to solve the sheet; empty: left for a pen. Plain text.
struct Solver {
  std::string name, number;
};
struct SheetRequest {
  drawings::Paper paper = drawings::Paper::a4;
  Language language = Language::english;
  bool bare = false;
  std::optional<double> room_width = {}, room_height = {};  // mm: a bare figure's panels share no larger room
  std::optional<Rational> scale = {};  // 1/5 for 1 : 5; none: the largest standard scale that fits
  bool blank = false;                  // the sheet to be solved: what is given, and what is asked
  bool for_class = false;              // tells what is asked and what is awkward, which lots are drawn by
  OwnTitles titles = {};
  Solver solver = {};
};
// Something wrong with the mechanism itself, though its numbers exist: teeth that interfere. Rich text.
struct Flaw {
  Words sentence;
  bool undecided = false;
};
// Something that ruler and compass can hardly draw: a vector too short, lines that meet at too small an angle.
struct Awkwardness {
  std::string what;  // the same at other givens
  Words sentence;
};
struct DrawnSheet {
  drawings::Sheet sheet;
  std::vector<Measurement> measurements;
  std::vector<drawings::Sheet> further = {};  // pages after the first, of a table that is too long for one
  // Of a sheet for a class alone.
  std::vector<std::string> asked = {};    // the quantities that the sheet to be solved asks for
  std::vector<Awkwardness> awkward = {};  // of the solved sheet
};

class Solution;

class Exercise {
 public:
  virtual ~Exercise() = default;
  virtual const Description& about() const = 0;

  // Every quantity by every route, grouped as they come. Throws BadGivens when the givens are impossible.
  virtual std::vector<RouteValue> solve(const Givens& givens, Rung rung) const = 0;

  // What is wrong with the mechanism; nothing where nothing can be. Throws as solve.
  virtual std::vector<Flaw> flaws(const Givens&) const { return {}; }

  // What its sheets draw and print. Throws as solve.
  virtual Solution solution(const Givens& givens) const;

  // Every number that a sheet tells must be one of the solution's quantities: check demands it.
  // `sheet` is one of about().sheets. Throws BadGivens as above, or when a requested scale does not fit the paper.
  virtual DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const = 0;
  DrawnSheet draw(const std::string& sheet, const Givens& givens, const SheetRequest& request) const;

  // What a sheet shows over as many pages as it takes, and a spreadsheet reads; none: the sheet holds no long table.
  virtual std::optional<LongTable> long_table(const std::string& /*sheet*/, const Solution&) const { return {}; }
};

// An exercise in a catalogue. It is made when it is first asked for, which two threads must not do at once: its
// description is long, and drawing one needs none of the others.
class Listed {
 public:
  Listed(std::string id, std::unique_ptr<Exercise> (*make)()) : id_(std::move(id)), make_(make) {}
  explicit Listed(std::unique_ptr<Exercise> made) : id_(made->about().id), made_(std::move(made)) {}

  const std::string& id() const { return id_; }
  const Exercise& operator*() const {
    if (!made_) made_ = make_();
    return *made_;
  }
  const Exercise* operator->() const { return &**this; }

 private:
  std::string id_;
  std::unique_ptr<Exercise> (*make_)() = nullptr;
  mutable std::unique_ptr<Exercise> made_;
};

using Catalogue = std::vector<Listed>;

// All exercises, in the order of the folders' names. The list is generated by the build.
const Catalogue& catalogue();

}  // namespace epure
