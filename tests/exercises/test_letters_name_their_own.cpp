// Letters stand nearer to what they name than to anything else of its kind, or a leader tells whose they are. Looked
// at on the composed page, from outside: without the code that placed them.
#include <algorithm>
#include <optional>

#include "drawings/labels/obstacles.h"
#include "drawings/paths/clip.h"
#include "exercises/kit/proof/solution.h"
#include "tests/drawings/probe.h"
#include "tests/exercises/tried_givens.h"

using namespace epure;
using namespace epure::tests;
using namespace epure::drawings;

namespace {

constexpr double same = 0.5;  // mm: nearer than this two marks are one to the eye

struct PlacedLabel {
  const Label* label;
  Box box;
  bool has_leader;
};

bool is_leader_to(const Primitive& primitive, Box box) {
  const Stroke* stroke = std::get_if<Stroke>(&primitive);
  return stroke && stroke->name.empty() && stroke->path.pieces.size() == 1 &&
         distance(stroke->path.start, nearest_in(box, stroke->path.start)) < 0.75;
}

// Backwards: the labels are the last of a bare page but for dimensions and the numbers of steps.
std::vector<PlacedLabel> placed(const Sheet& sheet, const Page& page) {
  std::vector<PlacedLabel> found;
  std::size_t end = page.primitives.size();
  for (auto label = sheet.figure.labels.rbegin(); label != sheet.figure.labels.rend(); ++label)
    for (std::size_t i = end; i-- > 0;) {
      const PlacedText* text = std::get_if<PlacedText>(&page.primitives[i]);
      if (!text || text->text != label->text || text->size != label->size) continue;
      const Box box = probe::text_box(*text);
      found.push_back({&*label, box, i > 0 && is_leader_to(page.primitives[i - 1], box)});
      end = i;
      break;
    }
  return found;
}

struct Shown {
  Point from, to;
  Meaning meaning;
};

double off(Point p, const Shown& mark) { return gap(Box{p, p}, mark.from, mark.to); }

std::optional<Point> marked_point(const Mark& mark) {
  if (const auto* dot = std::get_if<Dot>(&mark)) return dot->at;
  if (const auto* cross = std::get_if<Cross>(&mark)) return cross->at;
  if (const auto* hinge = std::get_if<Hinge>(&mark)) return hinge->at;
  if (const auto* hinge = std::get_if<FixedHinge>(&mark)) return hinge->at;
  return {};
}

struct Marks {
  std::vector<Shown> arrows, lines, points, labelled;
};

// As far as it shows.
void add(std::vector<Shown>& to, Point p, Point q, Meaning meaning, Box window) {
  if (const auto seen = clip_segment(p, q, window)) to.push_back({seen->first, seen->second, meaning});
}

void add_lines(std::vector<Shown>& to, const Line& line, Box window) {
  Point at = line.path.start;
  std::vector<Piece> pieces = line.path.pieces;
  if (line.path.closed) pieces.push_back({true, {}, {}, at});
  for (const Piece& piece : pieces) {
    if (piece.straight) add(to, at, piece.end, line.meaning, window);
    at = piece.end;
  }
}

Marks marks_of(const Sheet& sheet) {
  const Figure& figure = sheet.figure;
  const Box area = drawing_area(sheet.paper);
  Marks all;
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const int window = i < figure.window_of.size() ? figure.window_of[i] : -1;
    const Box seen = window < 0 ? area : intersection(area, figure.windows[static_cast<std::size_t>(window)]);
    const Mark& mark = figure.marks[i];
    if (const auto* arrow = std::get_if<Arrow>(&mark)) add(all.arrows, arrow->from, arrow->to, arrow->meaning, seen);
    if (const auto* line = std::get_if<Line>(&mark)) add_lines(all.lines, *line, seen);
    if (const auto point = marked_point(mark)) add(all.points, *point, *point, Meaning::text, seen);
  }
  for (const Label& label : figure.labels)
    if (!label.to) add(all.labelled, label.at, label.at, Meaning::text, area);
  return all;
}

enum class Kind { vector, line, point };

// What the label names and what else it could be taken to name.
struct Named {
  Kind kind;
  Shown own;
  std::vector<Shown> others;
};

const Shown* lies_on(const std::vector<Shown>& marks, Point from, Point to) {
  for (const Shown& each : marks)
    if (off(from, each) < 0.05 && off(to, each) < 0.05) return &each;
  return nullptr;
}

Named named(const Label& label, const Marks& marks) {
  const Point at = label.at, to = label.to.value_or(label.at);
  Named result{Kind::point, {at, to, Meaning::text}, {}};
  std::vector<Shown> of_kind;
  if (const Shown* vector = label.to ? lies_on(marks.arrows, at, to) : nullptr) {
    result = {Kind::vector, {at, to, vector->meaning}, {}};
    of_kind = marks.arrows;
  } else if (const Shown* line =
                 label.to || !lies_on(marks.points, at, at) ? lies_on(marks.lines, at, to) : nullptr) {
    result = {Kind::line, label.to ? Shown{at, to, line->meaning} : *line, {}};
    of_kind = marks.lines;
  } else if (!label.to) {
    of_kind = marks.points;
    of_kind.insert(of_kind.end(), marks.labelled.begin(), marks.labelled.end());
  }
  const Point here = drawings::between(at, to, 0.5);
  for (const Shown& each : of_kind)
    if (each.meaning == result.own.meaning && off(here, each) > same &&
        off(drawings::between(each.from, each.to, 0.5), result.own) > same)
      result.others.push_back(each);
  return result;
}

// "'v_B' stands nearer to another vector"
std::vector<std::string> strays(const Sheet& sheet, int& seen) {
  const Page page = compose(sheet);
  const Marks marks = marks_of(sheet);
  std::vector<std::string> found;
  for (const PlacedLabel& each : placed(sheet, page)) {
    ++seen;
    if (each.has_leader) continue;
    const Named about = named(*each.label, marks);
    const double own = gap(each.box, about.own.from, about.own.to);
    if (std::any_of(about.others.begin(), about.others.end(),
                    [&](const Shown& other) { return gap(each.box, other.from, other.to) < own; }))
      found.push_back("'" + plain(each.label->text) + "' stands nearer to another " +
                      (about.kind == Kind::vector ? "vector"
                       : about.kind == Kind::line ? "line"
                                                  : "point"));
  }
  return found;
}

}  // namespace

TEST_CASE("letters stand nearest to what they name, or have a leader") {
  int seen = 0;
  std::vector<std::string> as_stated, at_changed_givens;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    const bool is_stated = tried.assignments.empty();
    for (const Language language : {Language::english, Language::italian}) {
      if (!is_stated && language == Language::italian) continue;
      const auto found =
          strays(tried.exercise.draw(name, tried.solution, {.language = language, .bare = true}).sheet, seen);
      for (const std::string& stray : found)
        (is_stated ? as_stated : at_changed_givens).push_back(tried.id + " " + name + ": " + stray);
    }
  });
  CHECK(seen > 15000);
  // Where marks are too dense for a leader as well: of 464 that there were in English while a label's place did not
  // count what else it could be taken to name. (Of 2 and 15 they became 4 and 24 when givens, numbers of divisions
  // and names of positions were lettered that no sheet had told; 25 when levers with friction stood on their frame.)
  CAPTURE(as_stated, at_changed_givens);
  CHECK(as_stated.size() <= 4);
  CHECK(at_changed_givens.size() <= 25);
}
