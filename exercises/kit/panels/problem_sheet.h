// What stands beside the figure of a sheet that is to be solved.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure {

// What a sheet to be solved asks for, and what it would ask for at other givens.
struct AskedOnSheet {
  std::vector<Result::Asked> asked;
  std::vector<std::string> without_value, off_sheet;  // quantities: it does not exist; its point is not on the paper
};

// The quantities, each once, in the order in which the solved sheet tells them. A sheet without results asks for what
// its other sections tell, and one that tells all in words of its own for what it tells somebody who does not see it.
// Only what the exercise reports: nothing else can be marked. What does not exist nobody can find; and of a point
// that `is_off_sheet` nobody measures a coordinate or distance.
AskedOnSheet asked_on(const Description& about, const Solution& solution, const PanelSheet& shown,
                      const std::function<bool(const std::string& quantity, const Place&)>& is_off_sheet);

std::vector<std::string> names_of(const std::vector<Result::Asked>& asked);

// The sheet's own question; of a sheet without one which part of the exercise's it is, and that question. Rich text.
Words question_of(const Description& about, const std::string& sheet);

// The question, a table of what the sheet asks for with the units in which it is told, which senses are positive, and
// a place for name, number and date: to the column of givens. In the table stands what each of them is, where the
// column has room for all that; else what tells apart those that have one symbol. `origin`: a letter.
void add_problem(DrawnSheet& onto, const Words& question, const Solution& solution, const AskedOnSheet& asked,
                 const std::string& origin, const SheetRequest& request);

// That a sheet does not ask for these is awkward for a class, whose other students it does ask.
void note_not_asked(const std::string& sheet, const AskedOnSheet& asked, std::vector<Awkwardness>& awkward);
// The quantity of such a note; none of another.
std::optional<std::string> quantity_not_asked(const Awkwardness& noted);
// "Not asked, as they lie off the sheet: ..." of the symbols of quantities; nothing when there is none.
std::vector<Words> sentences_of_not_asked(const std::vector<std::string>& without_value,
                                          const std::vector<std::string>& off_sheet);

// The letter from which the solved sheet measures coordinates among these quantities; empty: it measures none, or
// from where no letter stands.
std::string letter_of_origin(const std::vector<std::string>& quantities, const Solution& solution,
                             const DrawnSheet& solved);

// "Positive sense: counter-clockwise; x to the right, y upwards; coordinates from A0.", of what turns or lies along
// an axis among these; empty: nothing does. Rich text.
Words positive_senses(const std::vector<std::string>& quantities, const Solution& solution,
                      const std::string& origin);

// What tells each of these meanings apart from the others, which begin as it does: "with 600 kg" of "weight of the
// boat, with 600 kg"; empty of the one that goes no further.
std::vector<std::string> cases_of(const std::vector<std::string>& meanings);

// A small cross where a polygon begins, with its letter if it has one.
void mark_start(Plot& plot, const Place& at, const std::string& letter);

}  // namespace epure
