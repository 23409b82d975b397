// Vector equations as the course writes them: vectors on the first line, under each its direction and magnitude.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "drawings/sheet/column.h"
#include "drawings/text/even_lines.h"
#include "drawings/text/sheet_words.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

using Term = VectorEquation::Term;

constexpr double of_caption = 0.85;  // of the letters' size

// One term's place: its operator and itself.
struct TermColumn {
  const Term* term;
  double before, width;  // of the operator, 0 without one; of the widest of vector, direction and magnitude
};
using EquationLine = std::vector<TermColumn>;

// Of the letters, in mm: of the vectors, and of what is known of them; and the room between terms.
struct EquationLetters {
  double size, below, gap;
};

EquationLine measure_columns(const VectorEquation& equation, const EquationLetters& set) {
  EquationLine columns;
  for (const Term& term : equation.terms)
    columns.push_back({&term, term.before.empty() ? 0 : measure(term.before, set.size).width,
                       std::max({measure(term.vector, set.size).width, measure(term.direction, set.below).width,
                                 measure(term.magnitude, set.below).width})});
  return columns;
}

// With `gap` between terms, and between an operator and its term.
double width(const EquationLine& line, double gap) {
  double sum = 0;
  for (const TermColumn& column : line)
    sum += (&column == line.data() ? 0 : gap) + column.before + (column.before > 0 ? gap : 0) + column.width;
  return sum;
}

double widest(const std::vector<EquationLine>& lines, double gap) {
  double most = 0;
  for (const EquationLine& line : lines) most = std::max(most, width(line, gap));
  return most;
}

// Broken before operators, so that no line is wider than `room` if a term is not.
std::vector<EquationLine> filled(const EquationLine& all, double room, double gap) {
  std::vector<EquationLine> lines(1);
  for (const TermColumn& column : all) {
    EquationLine longer = lines.back();
    longer.push_back(column);
    if (lines.back().empty() || width(longer, gap) <= room)
      lines.back() = std::move(longer);
    else
      lines.push_back({column});
  }
  return lines;
}

void centred(Galley& galley, const std::string& text, double middle, double baseline, double size) {
  if (!text.empty()) galley.text(text, {middle - measure(text, size).width / 2, baseline}, size);
}

double tallest(const EquationLine& line, double size) {
  double height = 0;
  for (const TermColumn& column : line) height = std::max(height, measure(column.term->vector, size).ascent);
  return height;
}

// The vectors, a rule, under it their directions and magnitudes, these rows named.
void set_line(Galley& galley, const EquationLine& line, double left, const EquationLetters& set, Language language) {
  const double size = set.size, gap = set.gap, small = of_caption * size, row = 1.5 * size;
  galley.down(0.2 * size * galley.air());
  const double first = galley.top() - std::max(tallest(line, size), 0.76 * size);
  const double rule = first - 0.6 * size, second = rule - 1.15 * size, third = second - row;
  galley.text(words(language).direction, {galley.left(), second}, small, Weight::regular, grey);
  galley.text(words(language).magnitude, {galley.left(), third}, small, Weight::regular, grey);
  // One rule for the whole line: short ones would turn vectors and directions into fractions.
  galley.rule(rule, galley.left(), galley.right(), fine);
  double x = left;
  for (const TermColumn& column : line) {
    centred(galley, column.term->before, x + column.before / 2, first, size);
    x += column.before + (column.before > 0 ? gap : 0);
    const double middle = x + column.width / 2;
    centred(galley, column.term->vector, middle, first, size);
    centred(galley, column.term->direction, middle, second, set.below);
    centred(galley, column.term->magnitude, middle, third, set.below);
    x += column.width + gap;
  }
  galley.down(galley.top() - third + (0.5 + 0.75 * galley.air()) * size);
}

// On one line if it has room there: closer together, then with smaller letters below.
EquationLetters letters_of(const VectorEquation& equation, double size, double room) {
  constexpr std::array gaps{0.75, 0.55, 0.4, 0.28};
  for (const double below : {1.0, 0.92, of_caption})
    for (const double gap : gaps)
      if (const EquationLetters set{size, below * size, gap * size};
          width(measure_columns(equation, set), set.gap) <= room)
        return set;
  return {size, size, gaps.front() * size};
}

}  // namespace

void set_block(Galley& galley, const VectorEquation& equation, Language language) {
  const double size = galley.size(), small = of_caption * size;
  const double captions =
      std::max(measure(words(language).direction, small).width, measure(words(language).magnitude, small).width) +
      size;
  const double room = galley.width() - captions;
  const EquationLetters set = letters_of(equation, size, room);
  const EquationLine columns = measure_columns(equation, set);
  const double gap = set.gap;
  const std::vector<EquationLine> lines = in_even_lines(
      room, [&](double most) { return filled(columns, most, gap); },
      [&](const std::vector<EquationLine>& each) { return widest(each, gap); });
  const double left_over = room - widest(lines, gap);
  if (left_over < 0)
    galley.complaints.push_back("a vector equation is wider than the column: " +
                                plain(equation.terms.front().vector));
  const double left = galley.left() + captions + std::max(0.0, left_over / 2);
  for (const EquationLine& line : lines) set_line(galley, line, left, set, language);
}

}  // namespace epure::drawings
