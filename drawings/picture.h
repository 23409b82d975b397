// A drawing as plain data: marks in paper millimetres, each with a meaning.
//
// Paper coordinates: millimetres, x to the right, y upwards, origin in the lower left corner of the sheet.
// A mark says what it *means*; one table (style.h) turns the meaning into line type, width and colour.
// Nothing here knows mechanics or a file format.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "words/words.h"

namespace epure::drawings {

struct Point {
  double x = 0, y = 0;
};

struct Box {
  Point low, high;
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

enum class Meaning {
  link,          // bodies of the mechanism
  ground,        // the frame: guides, its hatching
  plate,         // the area of a rigid plate (a light fill)
  axis,          // axes, lines of centres, paths of cranks: long dash dot
  construction,  // what ruler and compass leave behind
  alternative,   // other positions of the mechanism: dashed
  locus,         // fixed polode, coupler curve, inflection circle
  second_locus,  // the locus that must be told apart from the first: moving polode, stationarity circle
  velocity,
  acceleration,
  force,
  dimension,
  text,  // letters without a colour of their own
};

// A run of straight pieces and cubic Bezier arcs.
struct Piece {
  bool straight = true;
  Point first_control, second_control;  // meaningless when straight
  Point end;
};
struct Path {
  Point start;
  std::vector<Piece> pieces;
  bool closed = false;
};
Path segment(Point from, Point to);
Path polyline(const std::vector<Point>& corners, bool closed);
// Counter-clockwise from angle `from` to angle `to` (radians, to > from); a full turn is closed. Arcs of at most 45°.
Path arc(Point centre, double radius, double from, double to);
Path circle(Point centre, double radius);

// The dashes of a line. Curves of one meaning on one chart are told apart by them, also in black and white.
enum class LineType { of_its_meaning, continuous, dashed, dash_dotted, dotted };

// `name` is the mark's id in the SVG (made unique to the drawing); empty: none. It is the ASCII name of the
// quantity the mark shows ("v_B", "P0A"), so that a drawn mark can be found and measured.
struct Line {  // a stroked path
  Path path;
  Meaning meaning = Meaning::construction;
  std::string name = {};
  LineType type = LineType::of_its_meaning;
};
struct Area {  // a filled path
  Path path;
  Meaning meaning = Meaning::plate;
  std::string name = {};
};
struct Arrow {  // a vector: shaft and filled head, the tip exactly at `to`; shorter than its head: a dot
  Point from, to;
  Meaning meaning = Meaning::velocity;
  std::string name = {};
};
struct Dot {  // a small filled circle: a constructed point
  Point at;
  Meaning meaning = Meaning::construction;
  std::string name = {};
};
struct Cross {  // a small cross: a point found (pole, K)
  Point at;
  Meaning meaning = Meaning::locus;
  std::string name = {};
};
enum class PointShape { dot, ring, square, diamond, triangle, cross, plus };
struct DataPoint {  // a point of a chart; ring, square, diamond and triangle are outlines, white inside
  Point at;
  PointShape shape = PointShape::dot;
  Meaning meaning = Meaning::locus;
  std::string name = {};
};
// ISO 3952 symbols. Angles in radians.
struct Hinge {  // a small white circle over the links
  Point at;
};
struct FixedHinge {  // hinge on a hatched support that stands on the side `down` points to (radians)
  Point at;
  double down = -1.5707963267948966;
};
struct Slider {  // block of 10 mm x 6 mm on a guide or in a slot, `along` is the direction of sliding, any angle
  Point at;
  double along = 0;
  bool is_open = false;  // its outline alone, where curves pass beneath
};
struct Guide {  // the fixed line a block slides on, hatched on the right of from -> to, offset by half the block
  Point from, to;
};
struct Ground {  // the frame's surface exactly on from-to, hatched on the right of from -> to: what a wheel rolls on
  Point from, to;
};
struct Slot {  // the opening of a slotted link, white inside: from and to are the centres of its round ends
  Point from, to;
  double width = 6;  // mm; 6 takes a Slider, 3.5 a Hinge as its pin
};
struct Rotation {  // arc arrow that shows a sense of rotation about `centre`; from > to is clockwise
  Point centre;
  double radius = 8;
  double from = 0, to = 1;
  Meaning meaning = Meaning::link;
};
struct RightAngle {  // small square at `at`, between the directions `first` and `second` (radians)
  Point at;
  double first = 0, second = 0;
};
struct ParallelMark {  // `heads` open arrow heads on a line: lines with as many are parallel
  Point at;
  double along = 0;
  int heads = 1;
};
struct AngleMark {  // arc between two directions at a vertex, counter-clockwise from -> to
  Point at;
  double radius = 8;
  double from = 0, to = 1;
  Meaning meaning = Meaning::dimension;
};
struct Dimension {  // dimension line parallel to from-to at `offset` (positive: left), with its text
  Point from, to;
  double offset = 8;
  std::string text;
};
struct Writing {  // letters at a fixed place, which labels keep clear of: the numbers along an axis
  std::string text;
  Point baseline;  // its left end
  double size = 2.7;
  Meaning ink = Meaning::text;
  std::optional<std::size_t> row = {};  // of a table, which it is a cell of; its cells follow each other row by row
  double anchor = 0;                    // where it stays in other letters: 0 at its left end, 1 at its right end
};
struct ScaleBar {  // a graduated bar: `length` mm long in `divisions` parts; captions are rich text
  Point at;        // left end
  double length = 40;
  int divisions = 4;
  std::string caption;             // above: "1 : 5", "1 cm ≙ 2.5 m/s"
  std::vector<std::string> ticks;  // divisions + 1 numbers below the ticks, unit in the last
};

using Mark = std::variant<Line, Area, Arrow, Dot, Cross, DataPoint, Hinge, FixedHinge, Slider, Guide, Ground, Slot,
                          Rotation, RightAngle, ParallelMark, AngleMark, Dimension, Writing, ScaleBar>;

// Rich text: plain UTF-8; between dollar signs mathematics: Latin lower case and Greek letters are italic, capitals
// and digits upright, `_{..}` and `^{..}` lower and raise (their content upright), `\vec{..}` sets an arrow above,
// `\it{..}` sets capitals italic, which are quantities and not points.
// "$\vec{v}_{BA}$ ⊥ BA", "$P_{0}$", "$ω_{3}$", "$\it{M}_{1}g$".
struct Label {
  std::string text;
  Point at;                      // what the label belongs to: a point ...
  std::optional<Point> to = {};  // ... or the segment at-to, whose middle the label stands beside
  Meaning ink = Meaning::text;
  std::optional<Point> away_from = {};  // prefer the side that points away from here
  double size = 3.5;                    // mm, height of the letters' body (nominal size)
};
struct StepNumber {  // the circled number of a construction step, placed like a label near where it happens
  int number = 1;
  Point at;
};

// What is known of the step with which a mark or letters come; the rest is found (sheet/steps_of_marks.h).
struct KnownStep {
  std::optional<int> number = {};  // 0: it was there before the first; none: not known
  int earliest = 0;                // it comes no sooner
  int first = 0, last = 0;         // of the steps whose words may speak of it; 0: those of all may
};

struct Figure {
  std::vector<Mark> marks;  // drawn in this order, hinges and points last
  std::vector<Label> labels;
  std::vector<StepNumber> steps;
  std::vector<Box> windows = {};  // marks[i] is clipped to windows[window_of[i]]; no entry: to the drawing area
  std::vector<int> window_of = {};
  std::vector<KnownStep> known_of_marks = {}, known_of_labels = {};  // of marks[i], labels[i]; no entry: nothing
};

// The column beside the figure.
struct Heading {
  std::string text;
};
struct Paragraph {
  std::string text;
};
struct Steps {  // numbered from `first`
  std::vector<std::string> lines;
  int first = 1;
};
// A vector equation as the course writes it: under each vector its direction, then its magnitude ("?": unknown).
struct VectorEquation {
  struct Term {
    std::string vector, direction, magnitude;
    std::string before;  // "", "=", "+"
  };
  std::vector<Term> terms;
};
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  bool to_fill_in = false;  // rows are high enough to write in by hand, with a rule below each
};
using Block = std::variant<Heading, Paragraph, Steps, VectorEquation, Table>;

enum class Paper { a4, a3 };  // landscape
using epure::Language;

struct TitleBlock {
  std::string exercise, sheet, source;
  std::vector<std::string> scales;
  int page = 1, pages = 1;
  std::string heading = {};  // above all: the course, the author
  std::string number = {};   // instead of "page/pages"
};

struct Sheet {
  std::string id;           // "slider-crank-velocity-poles": prefix of every id in the SVG
  std::string title;        // plain text, for the metadata
  std::string description;  // plain text: what is seen, with the values; SVG <desc>
  Paper paper = Paper::a4;
  Language language = Language::english;
  bool bare = false;  // no frame, column or title block; cropped to the figure
  Figure figure;
  std::vector<Block> column;
  TitleBlock title_block;
};

// Where an exercise may put its marks on a framed sheet of this paper (mm); the column stands to its right.
Box drawing_area(Paper paper);

// The position a file holds for `p`: PDF and SVG both keep 1/256 pt, counted from the lower left corner of the paper.
// Distances measured on the sheet are distances between such positions. Error at most file_resolution / 2 (0.69 µm)
// per coordinate. An SVG counts in these steps, so it holds the position itself; of a PDF Cairo prints three decimals
// of a point, which hides at most another 0.18 µm from a reader of its text.
inline constexpr double file_resolution = 25.4 / 72 / 256;  // mm
Point as_filed(Point p, Paper paper);

}  // namespace epure::drawings
