// A page to SVG. Its unit is the step of the grid (grid.h), 1/256 pt: the positions of marks are whole numbers, and a
// path may go on from its last point without an error that adds up. Letters are outlines, each drawn once and used at
// every size, so that they look the same where the font is not installed; real letters lie over them unseen, to be
// found, selected and read aloud.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "drawings/files/check_page.h"
#include "drawings/files/svg_colour.h"
#include "drawings/files/xml.h"
#include "drawings/marks/style.h"
#include "drawings/page.h"
#include "drawings/paths/grid.h"
#include "drawings/paths/vectors.h"
#include "drawings/stopwatch.h"
#include "drawings/text/glyph_outline.h"
#include "drawings/text/typeset.h"

namespace epure::drawings {
namespace {

constexpr double steps_per_mm = points_per_mm * steps_per_point;

void add_whole(std::string& to, long value) {
  std::array<char, 24> digits{};
  to.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

// Not negative. No zero before the point and none at the end.
void add_decimal(std::string& to, double value, int decimals) {
  std::array<char, 64> digits{};
  const char* begin = digits.data();
  const char* end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  if (end - begin > 1 && *begin == '0') ++begin;
  to.append(begin, end);
}

void add_attribute(std::string& to, std::string_view name, std::string_view value) {
  ((((to += ' ') += name) += "=\"") += value) += '"';
}

// Whole steps: y downwards.
struct Step {
  long x = 0, y = 0;
};

// The value of a `d`: where the first path starts as it is, then each point from the last one, with as few characters
// as the grammar of SVG permits.
class PathData {
 public:
  explicit PathData(std::string& to) : to_(to) {}

  template <class ToSteps>
  void add(const Path& path, ToSteps to_steps) {
    const Step start = to_steps(path.start);
    command(last_ == 0 ? 'M' : 'm');
    at_ = from_here(start);
    for (const Piece& piece : path.pieces) {
      if (piece.straight) {
        straight(to_steps(piece.end));
      } else {
        command('c');
        from_here(to_steps(piece.first_control));
        from_here(to_steps(piece.second_control));
        at_ = from_here(to_steps(piece.end));
      }
    }
    if (!path.closed) return;
    command('z');
    at_ = start;
  }

 private:
  void straight(Step end) {
    if (end.y == at_.y) {
      command('h');
      number(end.x - at_.x);
    } else if (end.x == at_.x) {
      command('v');
      number(end.y - at_.y);
    } else {
      command('l');
      from_here(end);
    }
    at_ = end;
  }

  Step from_here(Step to) {
    number(to.x - at_.x);
    number(to.y - at_.y);
    return to;
  }

  // A letter holds until the next one, except that m would go on as lines.
  void command(char letter) {
    if (letter == last_ && letter != 'm') return;
    to_ += letter;
    last_ = letter;
  }

  void number(long value) {
    const bool after_digit = to_.back() >= '0' && to_.back() <= '9';
    if (after_digit && value >= 0) to_ += ' ';
    add_whole(to_, value);
  }

  std::string& to_;
  Step at_;
  char last_ = 0;
};

// An id that says what stands behind it: where two drawings in one web page use the same one, either is as good as
// the other. FNV-1a, in a letter and four of 62 characters; that no two outlines of the shipped fonts share an id is
// tested.
std::string content_id(char kind, std::string_view content) {
  std::uint64_t hash = 14695981039346656037u;
  const auto mix = [&](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u; };
  mix(kind);
  for (const char c : content) mix(c);
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ",
                             characters = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string id(1, letters[hash % letters.size()]);
  hash /= letters.size();
  for (int i = 0; i < 4; ++i, hash /= characters.size()) id += characters[hash % characters.size()];
  return id;
}

struct Outline {
  std::string id, data;  // without data: a space
};

// In font units, y downwards.
Outline make_outline(Face face, unsigned glyph) {
  Outline outline;
  PathData data(outline.data);
  const auto units = [](Point p) { return Step{std::lround(p.x), std::lround(-p.y)}; };
  for (const Path& contour : glyph_outline(face, glyph)) data.add(contour, units);
  outline.id = content_id('g', outline.data);
  return outline;
}

// This thread's, made at its first use.
const Outline& outline_of(Face face, unsigned glyph) {
  thread_local std::array<std::unordered_map<unsigned, Outline>, 4> known;
  auto& of_face = known.at(static_cast<std::size_t>(face));
  const auto found = of_face.find(glyph);
  return found != of_face.end() ? found->second : of_face.emplace(glyph, make_outline(face, glyph)).first->second;
}

// A letter of a text, in its units (1000 to the size of its letters), y downwards.
struct Letter {
  const Outline* outline = nullptr;
  double scale = 1;  // smaller in a subscript
  long x = 0, y = 0;
};

// Without spaces. `unit` in mm; `from`: where the text begins (mm, y upwards).
std::vector<Letter> letters_of(const SetText& set, double unit, Point from = {}) {
  std::vector<Letter> letters;
  for (const GlyphRun& run : set.runs)
    for (const SetGlyph& glyph : run.glyphs)
      if (const Outline& outline = outline_of(run.face, glyph.index); !outline.data.empty())
        letters.push_back({&outline, run.size / (unit * units_per_em), std::lround((from.x + glyph.at.x) / unit),
                           std::lround(-(from.y + glyph.at.y) / unit)});
  return letters;
}

// Empty when there is nothing to read.
std::string words_of(const SetText& set) {
  std::string words;
  for (const GlyphRun& run : set.runs)
    for (const SetGlyph& glyph : run.glyphs) words += glyph.text;
  return words.find_first_not_of(' ') == words.npos ? "" : words;
}

// Whether letters of both stand on one square, as cells of one table.
bool share_a_table(const PlacedText& a, const PlacedText& b) {
  return a.row && b.row && a.step == b.step && a.size == b.size && a.weight == b.weight && a.colour == b.colour;
}

bool is_black(const Colour& c) { return c == Colour{}; }

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
bool same(const Piece& a, const Piece& b) {
  return a.straight == b.straight && same(a.end, b.end) &&
         (a.straight || (same(a.first_control, b.first_control) && same(a.second_control, b.second_control)));
}
bool same(const Path& a, const Path& b) {
  return a.closed == b.closed && same(a.start, b.start) &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const Piece& one, const Piece& other) { return same(one, other); });
}

class Writer {
 public:
  explicit Writer(const Page& page) : page_(page), frame_(page.extent) {}

  std::string write() {
    join_letters();
    for (std::size_t i = 0; i < page_.primitives.size(); ++i) {
      const Primitive& primitive = page_.primitives[i];
      const auto* fill = std::get_if<Fill>(&primitive);
      const auto* next = i + 1 < page_.primitives.size() ? std::get_if<Stroke>(&page_.primitives[i + 1]) : nullptr;
      if (fill && next && is_its_outline(*fill, *next)) {
        outlined(*fill, *next);
        ++i;
      } else if (const std::size_t alike = alike_from(i); alike > 1) {
        as_one_path(i, alike);
        i += alike - 1;
      } else if (const std::vector<PlacedText> cells = table_from(i); cells.size() > 1) {
        table(cells);
        i += cells.size() - 1;
      } else {
        std::visit(*this, primitive);
      }
    }
    change_ink("");
    std::string all = head();
    if (!definitions_.empty()) ((all += "<defs>\n") += definitions_) += "</defs>\n";
    all += "<g stroke-linejoin=\"round\" stroke-width=\"";
    add_whole(all, usual_width());
    all += "\" font-family=\"'STIX Two Text',serif\" font-size=\"1000\">\n";
    if (page_.is_paper) all += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    return (all += body_) += "</g>\n</svg>\n";
  }

  void operator()(const Stroke& stroke) {
    take_pen(stroke);
    add_mark(stroke);
  }

  void operator()(const Fill& fill) {
    std::string ink;
    add_fill(ink, fill.colour);
    change_ink(ink);
    add_mark(fill);
  }

  // In a group on a square of its own, as letters are drawn on: 1000 units to the size of the letters.
  void operator()(const PlacedText& text) {
    const SetText& set = typeset(text.text, text.size, text.weight);
    const std::string words = words_of(set);
    if (words.empty()) return;
    begin_letters(text);
    const double unit = text.size / units_per_em;
    const auto joined = rows_.find(&text);
    for (const Placed& each : joined != rows_.end() ? joined->second : row_of(text))
      add_use(body_, elements_[each.element], each.x, each.y);
    if (!set.arrows.empty()) add_arrows(set.arrows, unit);
    add_words(words, {}, std::lround(set.extent.width / unit));
    body_ += "</g>\n";
  }

 private:
  // A group on the square of the text's letters.
  void begin_letters(const PlacedText& text) {
    change_ink("");
    body_ += "<g";
    add_step(text.step);
    if (!is_black(text.colour)) add_fill(body_, text.colour);
    const Point at = frame_.unrounded(text.baseline);
    body_ += " transform=\"translate(";
    add_whole(body_, std::lround(at.x * steps_per_point));
    body_ += ' ';
    add_whole(body_, std::lround(at.y * steps_per_point));
    body_ += ") scale(";
    add_decimal(body_, text.size * steps_per_mm / units_per_em, 5);
    body_ += ")\">";
  }

  // Unseen, from `at` on.
  void add_words(const std::string& words, Step at, long length) {
    body_ += "<text opacity=\"0\"";
    add_coordinate(body_, 'x', at.x);
    add_coordinate(body_, 'y', at.y);
    // Another font sets a letter or two nearly as wide; of longer words what is marked would drift off the letters.
    constexpr std::size_t short_of_bytes = 2;
    if (words.size() > short_of_bytes) {
      body_ += " textLength=\"";
      add_whole(body_, length);
      body_ += '"';
    }
    body_ += '>';
    add_escaped(body_, words);
    body_ += "</text>";
  }

  // The cells of one table from this primitive on.
  std::vector<PlacedText> table_from(std::size_t first) const {
    std::vector<PlacedText> cells;
    for (std::size_t i = first; i < page_.primitives.size(); ++i) {
      const auto* text = std::get_if<PlacedText>(&page_.primitives[i]);
      if (!text || !share_a_table(*text, cells.empty() ? *text : cells.front()) || !set(*text).arrows.empty()) break;
      cells.push_back(*text);
    }
    return cells;
  }

  // All cells in one group. Its letters stand in columns, digit below digit, of which the first ones seldom change
  // from row to row: drawn from above to below they take a quarter of what they take cell by cell. Its words are read
  // row by row.
  void table(const std::vector<PlacedText>& cells) {
    begin_letters(cells.front());
    const double unit = cells.front().size / units_per_em;
    std::map<long, Row> columns;  // by x
    for (const PlacedText& cell : cells)
      for (const Letter& letter : letters_of(set(cell), unit, cell.baseline - cells.front().baseline))
        columns[letter.x].push_back({element(letter), 0, letter.y});
    std::vector<Row*> all;
    for (auto& [x, column] : columns) {
      std::stable_sort(column.begin(), column.end(), [](const Placed& a, const Placed& b) { return a.y < b.y; });
      all.push_back(&column);
    }
    join(all);
    for (const auto& [x, column] : columns) {
      if (column.size() == 1) {
        add_use(body_, elements_[column.front().element], x, column.front().y);
        continue;
      }
      body_ += "<g transform=\"translate(";
      add_whole(body_, x);
      body_ += ")\">";
      for (const Placed& each : column) add_use(body_, elements_[each.element], 0, each.y);
      body_ += "</g>\n";
    }
    for (auto row = cells.begin(); row != cells.end();) {
      const auto end = std::find_if(row, cells.end(), [&](const PlacedText& cell) { return cell.row != row->row; });
      add_row(row, end, cells.front().baseline, unit);
      row = end;
    }
    body_ += "</g>\n";
  }

  using Cell = std::vector<PlacedText>::const_iterator;
  void add_row(Cell first, Cell end, Point origin, double unit) {
    std::string words;
    for (Cell cell = first; cell != end; ++cell) words += (cell == first ? "" : " ") + words_of(set(*cell));
    const Point from = first->baseline - origin;
    const double to = (end - 1)->baseline.x - origin.x + set(*(end - 1)).extent.width;
    add_words(words, {std::lround(from.x / unit), std::lround(-from.y / unit)}, std::lround((to - from.x) / unit));
    body_ += '\n';
  }

  static const SetText& set(const PlacedText& text) { return typeset(text.text, text.size, text.weight); }

  // What stands in a row of letters, or in a column of them: which of the elements, and where.
  struct Placed {
    std::size_t element;
    long x, y;
  };
  using Row = std::vector<Placed>;
  // Two side by side, and how far the second is from the first.
  struct Two {
    std::size_t first, second;
    long x, y;
    bool operator==(const Two&) const = default;
  };
  struct HashOfTwo {
    std::size_t operator()(const Two& two) const {
      constexpr std::size_t odd = 0x9E3779B97F4A7C15;
      std::size_t hash = two.first;
      for (const std::size_t next : {two.second, static_cast<std::size_t>(two.x), static_cast<std::size_t>(two.y)})
        hash = (hash ^ next) * odd;
      return hash;
    }
  };
  static Two two(const Row& row, std::size_t i) {
    return {row[i].element, row[i + 1].element, row[i + 1].x - row[i].x, row[i + 1].y - row[i].y};
  }

  // Of the elements that often stand side by side, at one distance, each two become one, and so on: words that come
  // again are a part of the bytes that their letters are.
  void join(const std::vector<Row*>& rows) {
    while (join_once(rows)) {
    }
  }
  bool join_once(const std::vector<Row*>& rows) {
    constexpr int often = 3;  // as seldom as it pays
    std::unordered_map<Two, int, HashOfTwo> times;
    for (const Row* row : rows)
      for (std::size_t i = 0; i + 1 < row->size(); ++i) ++times[two(*row, i)];
    bool any = false;
    for (Row* row : rows) {
      Row shorter;
      for (std::size_t i = 0; i < row->size(); ++i) {
        const auto count = [&](std::size_t at) { return at + 1 < row->size() ? times[two(*row, at)] : 0; };
        shorter.push_back((*row)[i]);
        if (count(i) < often || count(i + 1) > count(i)) continue;
        shorter.back().element = element(two(*row, i++));
        any = true;
      }
      *row = std::move(shorter);
    }
    return any;
  }

  // The letters of all texts that are in no table.
  void join_letters() {
    std::vector<Row*> all;
    for (const Primitive& primitive : page_.primitives)
      if (const auto* text = std::get_if<PlacedText>(&primitive); text && !text->row)
        all.push_back(&(rows_[text] = row_of(*text)));
    join(all);
  }
  Row row_of(const PlacedText& text) {
    Row row;
    for (const Letter& letter : letters_of(set(text), text.size / units_per_em))
      row.push_back({element(letter), letter.x, letter.y});
    return row;
  }

  std::size_t element(const Letter& letter) {
    define(*letter.outline);
    return numbered(letter.scale == 1 ? letter.outline->id : scaled_id(letter));
  }
  std::size_t element(const Two& two) {
    const auto [found, is_new] = joined_.try_emplace(two);
    if (!is_new) return found->second;
    std::string content = ">";
    add_use(content, elements_[two.first], 0, 0);
    add_use(content, elements_[two.second], two.x, two.y);
    return found->second = numbered(defined("g", 'p', content += "</g>\n"));
  }
  std::size_t numbered(const std::string& id) {
    const auto [found, is_new] = numbers_.try_emplace(id, elements_.size());
    if (is_new) elements_.push_back(id);
    return found->second;
  }

  std::string head() const {
    const char* language = page_.language == Language::italian ? "it" : "en";
    std::string head =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    add_attribute(head, "id", page_.id);
    const double width = page_.extent.width(), height = page_.extent.height();
    head += " width=\"";
    add_decimal(head, width, 5);
    head += "mm\" height=\"";
    add_decimal(head, height, 5);
    head += "mm\" viewBox=\"0 0 ";
    add_decimal(head, width * steps_per_mm, 5);
    head += ' ';
    add_decimal(head, height * steps_per_mm, 5);
    head += '"';
    add_attribute(head, "lang", language);
    add_attribute(head, "xml:lang", language);
    // What is within an image is not read aloud, and marks that tell something are to be.
    head += page_.told.empty() ? " role=\"img\"" : " role=\"group\"";
    head += ">\n<title>";
    add_escaped(head, page_.title);
    head += "</title>\n";
    if (!page_.description.empty()) {
      head += "<desc>";
      add_escaped(head, page_.description);
      head += "</desc>\n";
    }
    return head;
  }

  // An area and the line around it, as one element: half the bytes. With names of their own they stay apart.
  static bool is_its_outline(const Fill& fill, const Stroke& stroke) {
    return fill.name.empty() && fill.step == stroke.step && fill.clip.has_value() == stroke.clip.has_value() &&
           (!fill.clip || (same(fill.clip->low, stroke.clip->low) && same(fill.clip->high, stroke.clip->high))) &&
           same(fill.path, stroke.path);
  }
  void outlined(const Fill& fill, const Stroke& stroke) {
    std::string ink;
    add_fill(ink, fill.colour);
    add_stroke(ink, stroke);
    change_ink(ink);
    add_mark(stroke);
  }

  void take_pen(const Stroke& stroke) {
    std::string ink = " fill=\"none\"";
    add_stroke(ink, stroke);
    change_ink(ink);
  }
  // Marks in the same ink that follow each other share a group; one alone bears its ink itself.
  void change_ink(const std::string& ink) {
    if (ink == ink_) return;
    if (!ink_.empty()) end_ink();
    ink_at_ = body_.size();
    if (!ink.empty()) ((body_ += group_begins) += ink) += group_opened;
    ink_ = ink;
  }
  static constexpr std::string_view group_begins = "<g", group_opened = ">\n";
  void end_ink() {
    const std::size_t marks = ink_at_ + group_begins.size() + ink_.size() + group_opened.size();
    if (std::count(body_.begin() + static_cast<std::ptrdiff_t>(marks), body_.end(), '\n') > 1) {
      body_ += "</g>\n";
      return;
    }
    constexpr std::string_view path = "<path";
    body_.replace(ink_at_, marks + path.size() - ink_at_, std::string(path) + ink_);
  }

  auto steps() const {
    return [this](Point p) { return on_page(p); };
  }

  template <class Mark>
  void add_mark(const Mark& mark) {
    body_ += "<path";
    if (!mark.name.empty()) add_attribute(body_, "id", mark_id(mark.name));
    add_step(mark.step);
    if (const auto told = page_.told.find(mark.name); told != page_.told.end()) add_told(told->second);
    if (mark.clip) add_attribute(body_, "clip-path", "url(#" + clip_id(*mark.clip) + ")");
    add_path([&](PathData& data) { data.add(mark.path, steps()); });
  }

  template <class AddTo>
  void add_path(AddTo add_to) {
    body_ += " d=\"";
    PathData data(body_);
    add_to(data);
    body_ += "\"/>\n";
  }

  // How many strokes from this primitive on may be one path: alike, and nothing is to be known of them apart, as of
  // the ticks along an axis. (Where what is seen through crosses itself, one path is lighter than two.)
  std::size_t alike_from(std::size_t first) const {
    const auto stroke = [&](std::size_t i) {
      const auto* found = i < page_.primitives.size() ? std::get_if<Stroke>(&page_.primitives[i]) : nullptr;
      return found && found->name.empty() && !found->clip && found->colour.opacity == 1 ? found : nullptr;
    };
    const Stroke* const one = stroke(first);
    std::size_t end = first;
    for (const Stroke* next = one; next && next->width == one->width && next->dashes == one->dashes &&
                                   next->colour == one->colour && next->step == one->step;)
      next = stroke(++end);
    return end - first;
  }
  void as_one_path(std::size_t first, std::size_t count) {
    const auto stroke = [&](std::size_t i) -> const Stroke& { return std::get<Stroke>(page_.primitives[i]); };
    take_pen(stroke(first));
    body_ += "<path";
    add_step(stroke(first).step);
    add_path([&](PathData& data) {
      for (std::size_t i = first; i < first + count; ++i) data.add(stroke(i).path, steps());
    });
  }

  // By which style sheets and scripts find what a step draws.
  void add_step(int step) {
    if (step != 0) add_attribute(body_, "class", "step-" + std::to_string(step));
  }

  // Reached by the keyboard too, and read aloud.
  void add_told(const std::string& words) {
    body_ += " tabindex=\"0\" role=\"img\"";
    add_attribute(body_, "aria-label", escaped_for_attribute(words));
  }

  // Of most lines: said once.
  static long usual_width() { return std::lround(fine * steps_per_mm); }

  static void add_stroke(std::string& to, const Stroke& stroke) {
    to += " stroke=\"";
    add_colour(to, stroke.colour);
    to += '"';
    add_opacity(to, "stroke-opacity", stroke.colour);
    if (const long width = std::lround(stroke.width * steps_per_mm); width != usual_width()) {
      to += " stroke-width=\"";
      add_whole(to, width);
      to += '"';
    }
    if (stroke.dashes.empty()) return;
    to += " stroke-dasharray=\"";
    for (const double dash : stroke.dashes) {
      add_whole(to, std::lround(dash * steps_per_mm));
      to += ' ';
    }
    to.back() = '"';
  }

  static void add_fill(std::string& to, const Colour& colour) {
    to += " fill=\"";
    add_colour(to, colour);
    to += '"';
    add_opacity(to, "fill-opacity", colour);
  }

  static void add_opacity(std::string& to, std::string_view attribute, const Colour& colour) {
    if (colour.opacity == 1) return;
    ((to += ' ') += attribute) += "=\"";
    add_decimal(to, colour.opacity, 5);
    to += '"';
  }

  static void add_use(std::string& to, std::string_view id, long x, long y) {
    ((to += "<use xlink:href=\"#") += id) += '"';
    add_coordinate(to, 'x', x);
    add_coordinate(to, 'y', y);
    to += "/>";
  }

  static void add_coordinate(std::string& to, char name, long value) {
    if (value == 0) return;
    ((to += ' ') += name) += "=\"";
    add_whole(to, value);
    to += '"';
  }

  void add_arrows(const std::vector<Path>& arrows, double unit) {
    body_ += "<path d=\"";
    PathData data(body_);
    for (const Path& arrow : arrows)
      data.add(arrow, [&](Point p) { return Step{std::lround(p.x / unit), std::lround(-p.y / unit)}; });
    body_ += "\"/>";
  }

  void define(const Outline& outline) {
    if (!defined_.insert(outline.id).second) return;
    definitions_ += "<path";
    add_attribute(definitions_, "id", outline.id);
    add_attribute(definitions_, "d", outline.data);
    definitions_ += "/>\n";
  }

  // A letter at another size than the text it stands in.
  std::string scaled_id(const Letter& letter) {
    std::string content = " transform=\"scale(";
    add_decimal(content, letter.scale, 5);
    ((content += ")\" xlink:href=\"#") += letter.outline->id) += "\"/>\n";
    return defined("use", 's', content);
  }

  // The id of a definition that goes on so after its id.
  std::string defined(std::string_view element, char kind, const std::string& content) {
    std::string id = content_id(kind, content);
    if (defined_.insert(id).second) {
      (definitions_ += '<') += element;
      add_attribute(definitions_, "id", id);
      definitions_ += content;
    }
    return id;
  }

  std::string clip_id(const Box& box) {
    const Step corner = on_page({box.low.x, box.high.y}), opposite = on_page({box.high.x, box.low.y});
    std::string content = "><rect";
    const auto add = [&](std::string_view name, long value) { add_attribute(content, name, std::to_string(value)); };
    add("x", corner.x);
    add("y", corner.y);
    add("width", opposite.x - corner.x);
    add("height", opposite.y - corner.y);
    return defined("clipPath", 'c', content += "/></clipPath>\n");
  }

  // Found by it in CSS and scripts; nothing in the drawing refers to it.
  std::string mark_id(const std::string& name) {
    std::string id = page_.id + "-" + name;
    for (int count = 2; !marks_.insert(id).second; ++count) id = page_.id + "-" + name + "-" + std::to_string(count);
    return id;
  }

  Step on_page(Point p) const {
    const Point points = frame_.rounded(p);
    return {std::lround(points.x * steps_per_point), std::lround(points.y * steps_per_point)};
  }

  const Page& page_;
  Frame frame_;
  std::string definitions_, body_;
  std::string ink_;         // of the open group; empty: none is open
  std::size_t ink_at_ = 0;  // where it begins in the body
  std::unordered_set<std::string> defined_, marks_;
  std::vector<std::string> elements_;                     // that letters are drawn with: their ids
  std::unordered_map<std::string, std::size_t> numbers_;  // in elements_
  std::unordered_map<Two, std::size_t, HashOfTwo> joined_;
  std::unordered_map<const PlacedText*, Row> rows_;
};

}  // namespace

std::string write_svg(const Page& page) {
  const Timed timed(Work::svg);
  check(page);
  return Writer(page).write();
}

}  // namespace epure::drawings
