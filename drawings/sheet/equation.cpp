// Vector equations as the course writes them: vectors on the first line, under each its direction and magnitude.
#include <algorithm>
#include <numeric>

#include "drawings/sheet/column.h"
#include "drawings/text/sheet_words.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

using Term = VectorEquation::Term;

struct EquationColumns {
  std::vector<double> operators, terms;  // widths
  double gap = 0;                        // on both sides of an operator, between terms
  double gaps = 0;                       // how many of them
  double width() const {
    return std::accumulate(terms.begin(), terms.end(), 0.0) +
           std::accumulate(operators.begin(), operators.end(), 0.0) + gap * gaps;
  }
};

EquationColumns measure_columns(const VectorEquation& equation, double size) {
  EquationColumns columns;
  columns.gap = 0.75 * size;
  for (const Term& term : equation.terms) {
    columns.operators.push_back(term.before.empty() ? 0 : measure(term.before, size).width);
    columns.terms.push_back(std::max({measure(term.vector, size).width, measure(term.direction, size).width,
                                      measure(term.magnitude, size).width}));
    columns.gaps += (columns.terms.size() > 1 ? 1 : 0) + (term.before.empty() ? 0 : 1);
  }
  return columns;
}

void centred(Galley& galley, const std::string& text, double middle, double baseline, double size) {
  if (!text.empty()) galley.text(text, {middle - measure(text, size).width / 2, baseline}, size);
}

double tallest(const VectorEquation& equation, double size) {
  double height = 0;
  for (const Term& term : equation.terms) height = std::max(height, measure(term.vector, size).ascent);
  return height;
}

}  // namespace

void set_block(Galley& galley, const VectorEquation& equation, Language language) {
  const double size = galley.size(), small = 0.85 * size;
  const std::string &direction = words(language).direction, &magnitude = words(language).magnitude;
  const EquationColumns columns = measure_columns(equation, size);
  const double captions = std::max(measure(direction, small).width, measure(magnitude, small).width) + size;
  if (columns.width() > galley.width())
    galley.complaints.push_back("a vector equation is wider than the column: " +
                                (equation.terms.empty() ? std::string{} : plain(equation.terms.front().vector)));
  // The rows are named where there is room for it.
  const bool named = captions + columns.width() <= galley.width();
  const double row = 1.5 * size;
  galley.down(0.2 * size * galley.air());
  const double first = galley.top() - std::max(tallest(equation, size), 0.76 * size);
  const double rule = first - 0.6 * size, second = rule - 1.15 * size, third = second - row;
  if (named) {
    galley.text(direction, {galley.left(), second}, small, Weight::regular, grey);
    galley.text(magnitude, {galley.left(), third}, small, Weight::regular, grey);
  }
  const double room = galley.width() - (named ? captions : 0);
  double x = galley.right() - room + std::max(0.0, (room - columns.width()) / 2);
  // One rule for the whole line: short ones would turn vectors and directions into fractions.
  galley.rule(rule, named ? galley.left() : x, named ? galley.right() : x + columns.width(), fine);
  for (std::size_t i = 0; i < equation.terms.size(); ++i) {
    const Term& term = equation.terms[i];
    centred(galley, term.before, x + columns.operators[i] / 2, first, size);
    x += columns.operators[i] + (columns.operators[i] > 0 ? columns.gap : 0);
    const double middle = x + columns.terms[i] / 2;
    centred(galley, term.vector, middle, first, size);
    centred(galley, term.direction, middle, second, size);
    centred(galley, term.magnitude, middle, third, size);
    x += columns.terms[i] + columns.gap;
  }
  galley.down(galley.top() - third + (0.5 + 0.75 * galley.air()) * size);
}

}  // namespace epure::drawings
