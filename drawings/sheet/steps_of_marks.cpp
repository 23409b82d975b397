#include "drawings/sheet/steps_of_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "drawings/marks/canvas.h"
#include "drawings/marks/symbols.h"
#include "drawings/output.h"
#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/sheet/layout.h"
#include "drawings/text/text.h"

namespace epure::drawings {
namespace {

// What ends at the same point of the paper was put there by other arithmetic, and curves are looked at as chords.
// Less than a line is wide.
constexpr double same_place = 0.1;  // mm
// Lines of construction run on so far beyond the points they join.
constexpr double runs_on = 9;  // mm

bool is_same(Point a, Point b) { return distance(a, b) < same_place; }

double distance_to(Point p, Point from, Point to) {
  const Point way = to - from;
  const double square = dot(way, way);
  const double t = square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0;
  return distance(p, between(from, to, t));
}

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

// What both sheets were given is drawn at the same numbers.
bool is_equal(Point a, Point b) { return a.x == b.x && a.y == b.y; }
bool is_equal(const Path& a, const Path& b) {
  const auto same = [](const Piece& p, const Piece& q) {
    return p.straight == q.straight && is_equal(p.end, q.end) &&
           (p.straight ||
            (is_equal(p.first_control, q.first_control) && is_equal(p.second_control, q.second_control)));
  };
  return a.closed == b.closed && is_equal(a.start, b.start) &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(), same);
}
bool is_equal(const Stroke& a, const Stroke& b) {
  return a.width == b.width && a.dashes == b.dashes && a.colour == b.colour && is_equal(a.path, b.path);
}
bool is_equal(const Fill& a, const Fill& b) { return a.colour == b.colour && is_equal(a.path, b.path); }
bool is_equal(const PlacedText& a, const PlacedText& b) {
  return a.text == b.text && a.size == b.size && is_equal(a.baseline, b.baseline);
}
bool is_equal(const Primitive& a, const Primitive& b) {
  return a.index() == b.index() &&
         std::visit([&](const auto& p) { return is_equal(p, std::get<std::decay_t<decltype(p)>>(b)); }, a);
}

// Nothing of what is off the paper, or cannot be drawn: that is refused where it is.
std::vector<Primitive> ink_of(const Mark& mark) {
  Canvas canvas(paper_box(Paper::a3));  // the largest
  try {
    draw(canvas, mark);
  } catch (const std::invalid_argument&) {
    return {};
  } catch (const TooFar&) {
    return {};
  }
  return canvas.take();
}

// The marks and letters of the sheet to be solved.
class GivenInk {
 public:
  explicit GivenInk(const Figure& figure) : labels_(figure.labels) {
    for (const Mark& mark : figure.marks) inks_.push_back(ink_of(mark));
  }
  bool has(const Mark& mark) const {
    const std::vector<Primitive> ink = ink_of(mark);
    return std::any_of(inks_.begin(), inks_.end(), [&](const std::vector<Primitive>& given) {
      return std::equal(given.begin(), given.end(), ink.begin(), ink.end(),
                        [](const Primitive& a, const Primitive& b) { return is_equal(a, b); });
    });
  }
  bool has(const Label& label) const {
    return std::any_of(labels_.begin(), labels_.end(), [&](const Label& given) {
      return given.text == label.text && is_equal(given.at, label.at) && given.to.has_value() == label.to.has_value();
    });
  }

 private:
  std::vector<std::vector<Primitive>> inks_;
  const std::vector<Label>& labels_;
};

class Finder {
 public:
  Finder(const Figure& figure, const std::vector<Block>& column, const Figure& given) : figure_(figure) {
    const GivenInk givens(given);
    for (const Mark& mark : figure.marks) is_given_mark_.push_back(givens.has(mark));
    for (const Label& label : figure.labels) is_given_label_.push_back(givens.has(label));
    for (const Block& block : column)
      if (const auto* steps = std::get_if<Steps>(&block))
        for (std::size_t i = 0; i < steps->lines.size(); ++i)
          words_.push_back({steps->first + static_cast<int>(i), symbols(steps->lines[i]), steps->lines[i]});
    for (std::size_t i = 0; i < figure.marks.size(); ++i)
      if (is_given_mark_[i]) std::visit([this](const auto& m) { note_given(m); }, figure.marks[i]);
  }

  StepsOfMarks find() {
    found_.marks.assign(figure_.marks.size(), 0);
    found_.labels.assign(figure_.labels.size(), 0);
    if (words_.empty()) return found_;
    for_each<Arrow>([this](const Arrow& arrow) { return of(arrow); });
    for_each<Line>([this](const Line& line) { return of(line); });
    for_each<RightAngle>([this](const RightAngle& a) { return between_lines(a.at, a.first, a.second); });
    for_each<AngleMark>(
        [this](const AngleMark& a) { return std::max(beside(a), between_lines(a.at, a.from, a.to)); });
    for_each<Rotation>([this](const Rotation& r) { return of_point(r.centre).value_or(beside(r)); });
    for (std::size_t i = 0; i < figure_.labels.size(); ++i)
      if (!is_given_label_[i]) found_.labels[i] = of(figure_.labels[i]);
    for_each<Area>([this](const Area& area) { return of_curve(area.path); });
    for_each<Dot>([this](const Dot& dot) { return of_point(dot.at).value_or(earliest_through(dot.at)); });
    for_each<Cross>([this](const Cross& cross) { return of_point(cross.at).value_or(earliest_through(cross.at)); });
    for_each<DataPoint>([this](const DataPoint& p) { return of_point(p.at).value_or(earliest_through(p.at)); });
    for_each<ParallelMark>([this](const ParallelMark& mark) { return earliest_through(mark.at); });
    for_each<Dimension>([this](const Dimension& dimension) {
      const int told = first_to_speak_of(dimension.text);
      return told > 0 ? told : std::max(of_point(dimension.from).value_or(0), of_point(dimension.to).value_or(0));
    });
    show_the_rest_late();
    return found_;
  }

 private:
  // What is drawn alike is mostly drawn together: the twelve positions of a mechanism, of which one has the number.
  // Where nothing tells, a mark comes with the last of its kind, and where nothing of it is known with the last step.
  void show_the_rest_late() {
    using Kind = std::tuple<std::size_t, int, bool, bool>;
    const auto kind_of = [](const Mark& mark) {
      const auto* line = std::get_if<Line>(&mark);
      return Kind{mark.index(), line ? static_cast<int>(line->meaning) : 0, line && line->path.closed,
                  line && straight(line->path)};
    };
    std::map<Kind, int> last_of_kind;
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (int& last = last_of_kind[kind_of(figure_.marks[i])]; found_.marks[i] > last) last = found_.marks[i];
    const int last_step = words_.back().number;
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (!is_given_mark_[i] && found_.marks[i] == 0) {
        const int last = last_of_kind[kind_of(figure_.marks[i])];
        found_.marks[i] = last > 0 ? last : last_step;
      }
    for (std::size_t i = 0; i < figure_.labels.size(); ++i)
      if (!is_given_label_[i] && found_.labels[i] == 0) found_.labels[i] = last_step;
  }

  struct Told {
    int number;
    std::vector<std::string> symbols;
    std::string words;
  };

  template <class Kind, class Find>
  void for_each(Find find) {
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (const auto* mark = std::get_if<Kind>(&figure_.marks[i]); mark && !is_given_mark_[i])
        found_.marks[i] = find(*mark);
  }

  // Points of the mechanism.
  void note_given(const Hinge& hinge) { given_.push_back(hinge.at); }
  void note_given(const FixedHinge& hinge) { given_.push_back(hinge.at); }
  void note_given(const Slider& slider) { given_.push_back(slider.at); }
  void note_given(const Line& line) {
    if (line.meaning != Meaning::link && line.meaning != Meaning::ground) return;
    given_.push_back(line.path.start);
    for (const Piece& piece : line.path.pieces) given_.push_back(piece.end);
  }
  template <class Other>
  void note_given(const Other&) {}
  bool is_given(Point p) const {
    return std::any_of(given_.begin(), given_.end(), [&](Point g) { return is_same(g, p); });
  }

  // The first step whose words have these letters; 0: none has.
  int first_to_speak_of(std::string text) const {
    constexpr std::size_t shortest_word = 3;  // the number of a link stands in many words
    if (!are_letters(text) && text.size() < shortest_word) return 0;
    text = text.substr(0, text.find(" = "));
    if (text.find('$') != text.npos && std::count(text.begin(), text.end(), '$') % 2 != 0) text += '$';
    const std::vector<std::string> wanted = are_letters(text) ? symbols(text) : std::vector<std::string>{};
    for (const Told& step : words_) {
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

  // When a point was there; none: nothing tells.
  std::optional<int> of_point(Point p) const {
    if (is_given(p)) return 0;
    int first = numbered([&](Point at) { return distance(at, p); }, true);
    const auto maybe = [&](int step) {
      if (step > 0 && (first == 0 || step < first)) first = step;
    };
    if (first == 0)
      for (const Label& label : figure_.labels)
        if (!label.to && is_same(label.at, p) && are_letters(label.text)) maybe(first_to_speak_of(label.text));
    for (std::size_t i = 0; i < figure_.marks.size(); ++i)
      if (const auto* arrow = std::get_if<Arrow>(&figure_.marks[i]); arrow && is_same(arrow->to, p))
        maybe(found_.marks[i]);
    if (first == 0) return {};
    return first;
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
    constexpr double beside = 1.6;  // mm
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
  std::vector<bool> is_given_mark_, is_given_label_;
  StepsOfMarks found_;
};

}  // namespace

StepsOfMarks steps_of_marks(const Figure& figure, const std::vector<Block>& column, const Figure& given) {
  return Finder(figure, column, given).find();
}

}  // namespace epure::drawings
