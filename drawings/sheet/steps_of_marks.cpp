#include "drawings/sheet/steps_of_marks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {
namespace {

// What ends at the same point of the paper was put there by other arithmetic, and curves are looked at as chords.
// Less than a line is wide.
constexpr double same_place = 0.1;  // mm
// Lines of construction run on so far beyond the points they join.
constexpr double runs_on = 9;  // mm

bool is_same(Point a, Point b) { return distance(a, b) < same_place; }

double distance_to(Point p, Point from, Point to) { return distance(p, nearest_on(from, to, p)); }

// The symbols of rich text's mathematics, without arrows and styles: "$\vec{v}_{BA}$ ⊥ $P_{0}A'$" has v_{BA}, P_{0},
// A'.
class Symbols {
 public:
  explicit Symbols(std::string_view rich) : rest_(rich) {
    bool is_mathematics = false;
    while (!rest_.empty()) {
      if (rest_.front() == '$') {
        is_mathematics = !is_mathematics;
        rest_.remove_prefix(1);
        all_.emplace_back();  // what stands in one formula does not go on in the next
      } else if (is_mathematics) {
        take();
      } else {
        rest_.remove_prefix(1);
      }
    }
    std::erase(all_, std::string{});
  }
  std::vector<std::string> all() && { return std::move(all_); }

 private:
  void take() {
    if (rest_.front() == '\\') {
      rest_.remove_prefix(std::min(rest_.find('{'), rest_.size()));
      all_.push_back(group());
    } else if (rest_.front() == '_' || rest_.front() == '^') {
      std::string script(1, rest_.front());
      rest_.remove_prefix(1);
      add_to_last(script += group());
    } else if (const std::string letter = one(); letter == "'" || letter == "′") {
      add_to_last("'");
    } else if (letter != " ") {
      all_.push_back(letter);
    }
  }
  void add_to_last(const std::string& more) {
    if (all_.empty()) all_.emplace_back();
    all_.back() += more;
  }
  // What stands between the braces here, or the letter.
  std::string group() {
    if (rest_.empty() || rest_.front() != '{') return one();
    const auto end = std::min(rest_.find('}'), rest_.size());
    std::string inside(rest_.substr(1, end - 1));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return inside;
  }
  // A letter of UTF-8.
  std::string one() {
    std::size_t length = 1;
    while (length < rest_.size() && (static_cast<unsigned char>(rest_[length]) & 0xC0) == 0x80) ++length;
    std::string letter(rest_.substr(0, std::min(length, rest_.size())));
    rest_.remove_prefix(letter.size());
    return letter;
  }

  std::string_view rest_;
  std::vector<std::string> all_;
};

std::vector<std::string> symbols(const std::string& rich) { return Symbols(rich).all(); }

// Where a path is straight from end to end.
std::optional<std::pair<Point, Point>> straight(const Path& path) {
  if (path.closed || path.pieces.size() != 1 || !path.pieces.front().straight) return {};
  return std::pair{path.start, path.pieces.front().end};
}

class Finder {
 public:
  Finder(const Figure& figure, const std::vector<Block>& column) : figure_(figure) {
    for (const Block& block : column)
      if (const auto* steps = std::get_if<Steps>(&block))
        for (std::size_t i = 0; i < steps->lines.size(); ++i)
          words_.push_back({steps->first + static_cast<int>(i), symbols(steps->lines[i]), steps->lines[i]});
    for (const Mark& mark : figure.marks) std::visit([this](const auto& m) { note_given(m); }, mark);
  }

  StepsOfMarks find() {
    found_.marks.assign(figure_.marks.size(), 0);
    found_.labels.assign(figure_.labels.size(), 0);
    found_.lines.assign(figure_.steps.size(), std::nullopt);
    if (words_.empty()) return found_;
    for (std::size_t i = 0; i < figure_.marks.size(); ++i) {
      const KnownStep known = known_of_mark(i);
      found_.marks[i] = known.number.value_or(known.earliest);
    }
    for_each<Arrow>([this](const Arrow& arrow) { return of(arrow); });
    for_each<Line>([this](const Line& line) { return of(line); });
    for_each<RightAngle>([this](const RightAngle& a) { return between_lines(a.at, a.first, a.second); });
    for_each<AngleMark>(
        [this](const AngleMark& a) { return std::max(beside(a), between_lines(a.at, a.from, a.to)); });
    for_each<Rotation>([this](const Rotation& r) { return of_point(r.centre).value_or(beside(r)); });
    for (std::size_t i = 0; i < figure_.labels.size(); ++i)
      found_.labels[i] = as_known(known_in(figure_.known_of_labels, i), [&] { return of(figure_.labels[i]); });
    for_each<Area>([this](const Area& area) { return area.meaning == Meaning::plate ? 0 : of_curve(area.path); });
    for_each<Dot>([this](const Dot& dot) { return of_point(dot.at).value_or(earliest_through(dot.at)); });
    for_each<Cross>([this](const Cross& cross) { return of_point(cross.at).value_or(earliest_through(cross.at)); });
    for_each<DataPoint>([this](const DataPoint& p) { return of_point(p.at).value_or(earliest_through(p.at)); });
    for_each<ParallelMark>([this](const ParallelMark& mark) { return earliest_through(mark.at); });
    for_each<Dimension>([this](const Dimension& dimension) {
      const int told = first_to_speak_of(dimension.text);
      return told > 0 ? told : std::max(of_point(dimension.from).value_or(0), of_point(dimension.to).value_or(0));
    });
    for (std::size_t i = 0; i < figure_.steps.size(); ++i) found_.lines[i] = line_under(figure_.steps[i]);
    return found_;
  }

 private:
  struct Told {
    int number;
    std::vector<std::string> symbols;
    std::string words;
  };

  template <class Kind, class Find>
  void for_each(Find find) {
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (const auto* mark = std::get_if<Kind>(&figure_.marks[i]))
        found_.marks[i] = as_known(known_of_mark(i), [&] { return find(*mark); });
  }

  static KnownStep known_in(const std::vector<KnownStep>& all, std::size_t i) {
    return i < all.size() ? all[i] : KnownStep{};
  }
  KnownStep known_of_mark(std::size_t i) const { return known_in(figure_.known_of_marks, i); }

  // What is known goes before what is found.
  template <class Find>
  int as_known(const KnownStep& known, Find find) {
    if (known.number) return *known.number;
    heard_ = known;
    return std::max(find(), known.earliest);
  }

  // Points of the mechanism.
  void note_given(const Hinge& hinge) { given_.push_back(hinge.at); }
  void note_given(const FixedHinge& hinge) { given_.push_back(hinge.at); }
  void note_given(const Slider& slider) {
    given_.push_back(slider.at);
    blocks_.push_back(slider.at);
  }
  void note_given(const Line& line) {
    if (!is_of_mechanism(line)) return;
    given_.push_back(line.path.start);
    for (const Piece& piece : line.path.pieces) given_.push_back(piece.end);
  }
  template <class Other>
  void note_given(const Other&) {}
  // Where links stand for what they bear, as in the plan of a truss, each has its name.
  static bool is_of_mechanism(const Line& line) {
    return (line.meaning == Meaning::link && line.name.empty()) || line.meaning == Meaning::ground;
  }

  bool is_given(Point p) const {
    return std::any_of(given_.begin(), given_.end(), [&](Point g) { return is_same(g, p); });
  }

  // A slider's letters stand at a corner of its block.
  bool is_on_block(Point p) const {
    constexpr double to_corner = 5.9;  // mm: of 10 mm x 6 mm
    return std::any_of(blocks_.begin(), blocks_.end(), [&](Point b) { return distance(b, p) < to_corner; });
  }

  // The first step whose words have these letters; 0: none has.
  int first_to_speak_of(std::string text) const {
    constexpr std::size_t shortest_word = 3;  // the number of a link stands in many words
    if (!are_letters(text) && text.size() < shortest_word) return 0;
    text = text.substr(0, text.find(" = "));
    if (text.find('$') != text.npos && std::count(text.begin(), text.end(), '$') % 2 != 0) text += '$';
    const std::vector<std::string> wanted = are_letters(text) ? symbols(text) : std::vector<std::string>{};
    for (const Told& step : words_) {
      if (heard_.last > 0 && (step.number < heard_.first || step.number > heard_.last)) continue;
      const bool has = wanted.empty() ? !text.empty() && step.words.find(text) != text.npos
                                      : std::search(step.symbols.begin(), step.symbols.end(), wanted.begin(),
                                                    wanted.end()) != step.symbols.end();
      if (has) return step.number;
    }
    return 0;
  }

  // "$v_{X}$" for "$v_{B}$": words may tell of all points at once.
  static std::string of_any_point(std::string text) {
    const auto from = text.find("_{");
    if (from != text.npos) text.replace(from, text.find('}', from) - from, "_{X");
    return text;
  }

  // Of a point or a quantity; what begins otherwise are words: "∥ $AB$".
  static bool are_letters(const std::string& text) { return text.starts_with('$'); }

  // The first number that stands on it, at no point with letters of its own; or at any.
  template <class DistanceTo>
  int numbered(DistanceTo distance_of, bool at_points) const {
    int first = 0;
    for (const StepNumber& step : figure_.steps)
      if (distance_of(step.at) < same_place && (at_points || !is_named(step.at)) &&
          (first == 0 || step.number < first))
        first = step.number;
    return first;
  }

  bool is_named(Point p) const {
    return is_given(p) || std::any_of(figure_.labels.begin(), figure_.labels.end(),
                                      [&](const Label& label) { return !label.to && is_same(label.at, p); });
  }

  bool is_point(Point p) const {
    return is_named(p) || std::any_of(figure_.marks.begin(), figure_.marks.end(), [&](const Mark& mark) {
             const auto* dot = std::get_if<Dot>(&mark);
             const auto* cross = std::get_if<Cross>(&mark);
             return (dot && is_same(dot->at, p)) || (cross && is_same(cross->at, p));
           });
  }

  // When a point was there; none: nothing tells.
  std::optional<int> of_point(Point p) const {
    if (is_given(p)) return 0;
    int first = numbered([&](Point at) { return distance(at, p); }, true);
    const bool is_numbered = first > 0;
    const auto maybe = [&](int step) {
      if (step > 0 && (first == 0 || step < first)) first = step;
    };
    if (first == 0)
      for (const Label& label : figure_.labels)
        if (!label.to && is_same(label.at, p) && are_letters(label.text)) maybe(first_to_speak_of(label.text));
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (const auto* arrow = std::get_if<Arrow>(&figure_.marks[i]); arrow && is_same(arrow->to, p))
        maybe(found_.marks[i]);
    if (!is_numbered) first = std::max(first, of_crossing(p));
    if (first == 0) return {};
    return first;
  }

  // A point that is found where two lines cross is not there before the second of them, though the words of the first
  // speak of it: "P₃₁ lies on A₀A". 0: none is known to cross there.
  int of_crossing(Point p) const {
    const auto is_at_p = [&](const Mark& mark) {
      const auto* cross = std::get_if<Cross>(&mark);
      return cross && is_same(cross->at, p);
    };
    if (std::none_of(figure_.marks.begin(), figure_.marks.end(), is_at_p)) return 0;
    std::set<int> lines;
    for (const Mark& mark : figure_.marks) {
      const auto* line = std::get_if<Line>(&mark);
      if (!line) continue;
      const std::vector<Point> chords = flatten(line->path);
      const auto distance_of = [&](Point at) { return distance_to_chords(at, chords); };
      if (distance_of(p) < same_place)
        if (const int step = numbered(distance_of, false)) lines.insert(step);
    }
    return lines.size() < 2 ? 0 : *std::next(lines.begin());
  }

  // A vector lies on its line before its length is known; so it comes with the line that ends it.
  int of(const Arrow& arrow) const {
    int step = numbered_on(arrow.from, arrow.to);
    for (const Label& label : figure_.labels)
      if (step == 0 && label.to && is_same(label.at, arrow.from) && is_same(*label.to, arrow.to))
        step = first_to_speak_of(label.text);
    if (step == 0) step = numbered([&](Point p) { return distance(p, arrow.to); }, true);
    for (const Label& label : figure_.labels)
      if (step == 0 && label.to && is_same(label.at, arrow.from) && is_same(*label.to, arrow.to))
        step = first_to_speak_of(of_any_point(label.text));
    if (step == 0) return of_letters_at(is_given(arrow.from) ? arrow.from : arrow.to);
    bool has_line = false;
    for (const Mark& mark : figure_.marks)
      if (const auto line = line_of_construction(mark))
        has_line = has_line || (is_on(arrow.from, *line) && is_on(arrow.to, *line));
    if (!has_line) return step;
    return std::max(ended_at(arrow.from, arrow, step), ended_at(arrow.to, arrow, step));
  }

  using Ends = std::pair<Point, Point>;
  static bool is_on(Point p, const Ends& ends) { return distance_to(p, ends.first, ends.second) < same_place; }
  static std::optional<Ends> line_of_construction(const Mark& mark) {
    const auto* line = std::get_if<Line>(&mark);
    return line && line->meaning == Meaning::construction ? straight(line->path) : std::nullopt;
  }
  int numbered_on(Point from, Point to) const {
    return numbered([&](Point p) { return distance_to(p, from, to); }, false);
  }

  // The end of a vector whose line is drawn in `step`: there already when another line or vector passed through it
  // before, else there with the next one that does.
  int ended_at(Point end, const Arrow& of, int step) const {
    int next = 0;
    for (const Mark& mark : figure_.marks) {
      auto ends = line_of_construction(mark);
      if (const auto* arrow = std::get_if<Arrow>(&mark)) ends = Ends{arrow->from, arrow->to};
      if (!ends || !is_on(end, *ends) || (is_on(of.from, *ends) && is_on(of.to, *ends))) continue;
      const int other = numbered_on(ends->first, ends->second);
      if (other > 0 && other < step) return step;
      if (other > step && (next == 0 || other < next)) next = other;
    }
    return std::max(step, next);
  }

  int of_letters_at(Point p) const {
    if (is_given(p)) return 0;
    for (const Label& label : figure_.labels)
      if (!label.to && is_same(label.at, p)) return first_to_speak_of(label.text);
    return 0;
  }

  int of(const Line& line) const {
    if (is_of_mechanism(line) || line.meaning == Meaning::dimension) return 0;
    const auto ends = straight(line.path);
    if (!ends) return of_curve(line.path, line.name);
    const auto& [from, to] = *ends;
    const auto distance_of = [&a = from, &b = to](Point p) { return distance_to(p, a, b); };
    if (const int step = numbered(distance_of, false)) return step;
    const auto first = of_end(from, to), second = of_end(to, from);
    if (first && second) return std::max(*first, *second);
    if (const int step = numbered(distance_of, true)) return step;
    if (const int step = of_letters_on(line.path)) return step;
    return std::max(first.value_or(0), second.value_or(0));
  }

  // Of the point that a line from `end` to `other` joins there: the nearest to its end that is known.
  std::optional<int> of_end(Point end, Point other) const {
    std::optional<int> step;
    double nearest = runs_on;
    const auto look_at = [&](Point p) {
      if (distance_to(p, end, other) >= same_place || distance(p, end) >= nearest ||
          distance(p, end) > distance(p, other))
        return;
      if (const auto found = of_point(p)) {
        step = found;
        nearest = distance(p, end);
      }
    };
    for (const Point given : given_) look_at(given);
    for (const Label& label : figure_.labels)
      if (!label.to) look_at(label.at);
    for (const StepNumber& number : figure_.steps) look_at(number.at);
    return step;
  }

  // A curve has its name beside it, or a number on it.
  int of_curve(const Path& path, std::string name = {}) const {
    if (const int step = of_letters_on(path)) return step;
    const std::vector<Point> chords = flatten(path);
    const auto distance_of = [&](Point p) { return distance_to_chords(p, chords); };
    if (const int step = numbered(distance_of, false)) return step;
    if (const int step = numbered(distance_of, true)) return step;
    std::replace(name.begin(), name.end(), '_', ' ');
    return first_to_speak_of(name);
  }
  static double distance_to_chords(Point p, const std::vector<Point>& chords) {
    double nearest = INFINITY;
    for (std::size_t i = 1; i < chords.size(); ++i)
      nearest = std::min(nearest, distance_to(p, chords[i - 1], chords[i]));
    return nearest;
  }
  // Of letters that stand on it, not at a point that is named for itself.
  int of_letters_on(const Path& path) const {
    const std::vector<Point> chords = flatten(path);
    for (const Label& label : figure_.labels)
      if (!label.to && !are_letters(label.text) && distance_to_chords(label.at, chords) < same_place)
        if (const int step = first_to_speak_of(label.text)) return step;
    return 0;
  }

  int of(const Label& label) const {
    if (label.to) {
      for (std::size_t i = 0; i < figure_.marks.size(); ++i)
        if (joins(figure_.marks[i], label.at, *label.to)) return found_.marks[i];
      return std::max(first_to_speak_of(label.text),
                      std::max(of_point(label.at).value_or(0), of_point(*label.to).value_or(0)));
    }
    if (is_on_block(label.at)) return 0;
    if (const auto step = of_arc_beside(label)) return *step;
    if (const auto step = of_point(label.at)) return *step;
    if (const int step = earliest_through(label.at)) return step;
    return first_to_speak_of(label.text);
  }

  static bool joins(const Mark& mark, Point from, Point to) {
    if (const auto* arrow = std::get_if<Arrow>(&mark)) return is_same(arrow->from, from) && is_same(arrow->to, to);
    const auto* line = std::get_if<Line>(&mark);
    const auto ends = line ? straight(line->path) : std::nullopt;
    return ends && is_same(ends->first, from) && is_same(ends->second, to);
  }

  // Of the lines through a point that steps drew, when the first was; 0: none, or one was there before.
  int earliest_through(Point p) const {
    int first = 0;
    for (std::size_t i = 0; i < figure_.marks.size(); ++i) {
      const int step = found_.marks[i];
      const auto chords = chords_of(figure_.marks[i]);
      if (chords.empty() || distance_to_chords(p, chords) >= same_place) continue;
      if (step == 0) return 0;
      if (first == 0 || step < first) first = step;
    }
    return first;
  }
  static std::vector<Point> chords_of(const Mark& mark) {
    if (const auto* arrow = std::get_if<Arrow>(&mark)) return {arrow->from, arrow->to};
    if (const auto* line = std::get_if<Line>(&mark)) return flatten(line->path);
    return {};
  }

  // A line or a vector; none for a number that stands at a point, where others may meet.
  std::optional<std::size_t> line_under(const StepNumber& step) const {
    if (is_point(step.at)) return {};
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (found_.marks[i] == step.number && distance_to_chords(step.at, chords_of(figure_.marks[i])) < same_place)
        return i;
    return {};
  }

  // Of a symbol between the lines that leave a point in two directions.
  int between_lines(Point at, double first, double second) const {
    constexpr double a_little = 1.5;  // mm
    return std::max(earliest_through(at + a_little * direction(first)),
                    earliest_through(at + a_little * direction(second)));
  }

  // Of an arc with letters beside it.
  template <class Arc>
  int beside(const Arc& arc) const {
    for (const Label& label : figure_.labels)
      if (is_beside(label, arc))
        if (const int step = first_to_speak_of(label.text)) return step;
    return 0;
  }
  static Point centre_of(const AngleMark& arc) { return arc.at; }
  static Point centre_of(const Rotation& arc) { return arc.centre; }
  template <class Arc>
  bool is_beside(const Label& label, const Arc& arc) const {
    constexpr double beside = 2.5;  // mm: letters of arcs stand as far out
    if (label.to || is_given(label.at)) return false;
    const Point from_centre = label.at - centre_of(arc), middle = direction((arc.from + arc.to) / 2);
    return std::abs(length(from_centre) - arc.radius) < beside && dot(from_centre, middle) > 0;
  }

  std::optional<int> of_arc_beside(const Label& label) const {
    for (std::size_t i = 0; i < figure_.marks.size(); ++i) {
      const auto* angle = std::get_if<AngleMark>(&figure_.marks[i]);
      const auto* rotation = std::get_if<Rotation>(&figure_.marks[i]);
      if ((angle && is_beside(label, *angle)) || (rotation && is_beside(label, *rotation))) return found_.marks[i];
    }
    return {};
  }

  const Figure& figure_;
  std::vector<Told> words_;
  std::vector<Point> given_;
  std::vector<Point> blocks_;  // of sliders: their middles
  KnownStep heard_ = {};       // of what is being looked for: whose words count
  StepsOfMarks found_;
};

}  // namespace

StepsOfMarks steps_of_marks(const Figure& figure, const std::vector<Block>& column) {
  return Finder(figure, column).find();
}

}  // namespace epure::drawings
