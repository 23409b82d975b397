#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "drawings/sheet/column.h"
#include "drawings/sheet/layout.h"
#include "drawings/sheet/title_block.h"
#include "drawings/text/text.h"
#include "exercises/kit/panels/close_up.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/layout_search.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/problem_sheet.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

// Where a panel's marks may show.
drawings::Box window_of(const PlacedPanel& placed, const SheetRequest& request) {
  return placed.panel->is_cut() ? placed.room : figure_area(request);
}

Plot plot_of(const PlacedPanel& placed, DrawnSheet& onto, const SheetRequest& request) {
  Plot plot(onto, placed.origin, placed.plane());
  plot.vectors_at(placed.vectors);
  plot.keep_within(window_of(placed, request));
  return plot;
}

// The marks drawn last end at this window.
void cut(drawings::Figure& figure, const drawings::Box& window) {
  figure.windows.push_back(window);
  figure.window_of.resize(figure.marks.size(), static_cast<int>(figure.windows.size()) - 1);
}

// What of a figure a panel drew, and the numbers that its steps have on the sheet.
struct PanelPart {
  std::size_t marks_end = 0, labels_end = 0;
  std::vector<int> numbers = {};
  bool has_steps() const { return !numbers.empty(); }
};

// Where the close-up shows what the whole does in a step: there stands its number. None where the whole does better.
std::vector<std::optional<Place>> seen_closer(const std::vector<PanelStep>& steps, const PlacedPanel& whole,
                                              const PlacedPanel& close_up, DrawnSheet& onto,
                                              const SheetRequest& request) {
  constexpr double edge = 8;  // mm: nearer to the border a line only leaves
  const Plot small = plot_of(whole, onto, request), large = plot_of(close_up, onto, request);
  const auto& [low, high] = close_up.room;
  const drawings::Box inner{{low.x + edge, low.y + edge}, {high.x - edge, high.y - edge}},
      seen = seen_in(close_up, whole);
  const std::vector<PanelStep> larger = whole.panel->steps(large, close_up.room);
  std::vector<std::optional<Place>> places(steps.size());
  for (std::size_t k = 0; k < steps.size() && steps.size() == larger.size(); ++k) {
    if (!steps[k].at || !larger[k].at || !is_in(close_up.room, large, *larger[k].at)) continue;
    if (is_in(seen, small, *steps[k].at) || is_in(inner, large, *larger[k].at)) places[k] = larger[k].at;
  }
  return places;
}

// The steps of all panels, numbered through, and their numbers on the pictures: panel by panel, then those that need
// what the others found. What is decided and not drawn stands between them.
std::vector<drawings::Block> number_steps(const std::vector<PlacedPanel>& panels, std::vector<PanelPart>& parts,
                                          DrawnSheet& onto, const SheetRequest& request, bool& is_off_sheet) {
  std::vector<drawings::Block> blocks;
  int number = 1;
  const auto add = [&](std::size_t i, bool needs_all_others) {
    const PlacedPanel& each = panels[i];
    Plot plot = plot_of(each, onto, request);
    const PlacedPanel* const close_up = close_up_of(each, panels);
    const std::vector<PanelStep> steps = each.panel->steps(plot, each.room);
    const std::vector<std::optional<Place>> larger = close_up ? seen_closer(steps, each, *close_up, onto, request)
                                                              : std::vector<std::optional<Place>>(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const PanelStep& step = steps[k];
      if (step.needs_all_others != needs_all_others) continue;
      std::string text = step.text.in(request.language);
      if (!step.at) {
        blocks.push_back(drawings::Paragraph{text});
        continue;
      }
      if (larger[k]) {
        plot_of(*close_up, onto, request).step(number, *larger[k]);
      } else if (is_in(each.room, plot, *step.at)) {
        plot.step(number, *step.at);
      } else {
        text += Words{" (Off the sheet.)", " (Fuori del foglio.)"}.in(request.language);
        is_off_sheet = true;
      }
      auto* const listed = blocks.empty() ? nullptr : std::get_if<drawings::Steps>(&blocks.back());
      if (listed)
        listed->lines.push_back(text);
      else
        blocks.push_back(drawings::Steps{{text}, number});
      parts[i].numbers.push_back(number++);
    }
    if (close_up) parts[static_cast<std::size_t>(close_up - panels.data())].numbers = parts[i].numbers;
  };
  for (const bool needs_all_others : {false, true})
    for (std::size_t i = 0; i < panels.size(); ++i) add(i, needs_all_others);
  return blocks;
}

// A panel is not there before the first of its steps; but for the first that has some, which shows what is given. One
// without steps is given when it stands before all that have some; else it comes with the next of these, or after the
// last of them with its last step.
int earliest_of(std::size_t part, const std::vector<PanelPart>& parts, int last_of_all) {
  const auto has_steps = [](const PanelPart& each) { return each.has_steps(); };
  const auto here = parts.begin() + static_cast<std::ptrdiff_t>(part);
  if (std::none_of(parts.begin(), here, has_steps)) return 0;
  const auto next = std::find_if(here, parts.end(), has_steps);
  return next == parts.end() ? last_of_all : next->numbers.front();
}

// From steps of the panels to steps of the sheet. A step that has no number, as it is decided and not drawn, is
// missing among them: so what comes with it comes with the last at the latest. Less than 0: from the beginning, also
// on a later panel.
void tell_steps(drawings::Figure& figure, const std::vector<PanelPart>& parts) {
  if (parts.empty()) return;
  int last_of_all = 0;
  for (const PanelPart& part : parts)
    if (part.has_steps()) last_of_all = std::max(last_of_all, part.numbers.back());
  const auto tell = [&](std::vector<drawings::KnownStep>& all, std::size_t begin, std::size_t end,
                        const PanelPart& part, int earliest) {
    const auto on_sheet = [&](int step) {
      if (!part.has_steps()) return std::min(step, last_of_all);
      return part.numbers[std::min(static_cast<std::size_t>(step), part.numbers.size()) - 1];
    };
    for (std::size_t i = begin; i < end; ++i) {
      drawings::KnownStep& known = all[i];
      known.earliest = earliest;
      if (part.has_steps()) {
        known.first = part.numbers.front();
        known.last = part.numbers.back();
      }
      if (!known.number) continue;
      if (*known.number > 0)
        known.number = on_sheet(*known.number);
      else if (*known.number == 0)
        known.number = earliest;
      known.number = std::max(*known.number, 0);
    }
  };
  std::size_t mark = 0, label = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int earliest = earliest_of(i, parts, last_of_all);
    tell(figure.known_of_marks, mark, parts[i].marks_end, parts[i], earliest);
    tell(figure.known_of_labels, label, parts[i].labels_end, parts[i], earliest);
    mark = parts[i].marks_end;
    label = parts[i].labels_end;
  }
}

// Its frame tells its scale.
bool is_close_up_of_polygon(const PlacedPanel& panel) {
  return panel.panel->is_of_vectors() && dynamic_cast<const CloseUp*>(panel.panel) != nullptr;
}

// A student draws no close-up of a polygon.
double times_smaller_in_whole(const PlacedPanel& panel, const std::vector<PlacedPanel>& panels) {
  if (!is_close_up_of_polygon(panel)) return 1;
  const auto whole = std::find_if(panels.begin(), panels.end(),
                                  [&](const PlacedPanel& each) { return close_up_of(each, panels) == &panel; });
  return panel.plane().mm_per_unit / whole->plane().mm_per_unit;
}

// What cannot be drawn well by hand: short vectors, lines that meet at a small angle, what lies off the sheet.
void note_awkwardness(const std::string& sheet, const std::vector<PlacedPanel>& panels,
                      const std::vector<PanelPart>& parts, bool has_steps_off_sheet, DrawnSheet& onto) {
  constexpr double shortest = 10, smallest = 15;  // mm, degrees
  const auto note = [&](const std::string& what, const Words& sentence) {
    onto.awkward.push_back({sheet + "/" + what, sentence});
  };
  const auto& marks = onto.sheet.figure.marks;
  for (std::size_t i = 0, mark = 0; i < panels.size(); ++i) {
    const double smaller = times_smaller_in_whole(panels[i], panels);
    for (; mark < parts[i].marks_end; ++mark)
      if (const auto* arrow = std::get_if<drawings::Arrow>(&marks[mark]); arrow && !arrow->name.empty())
        if (std::hypot(arrow->to.x - arrow->from.x, arrow->to.y - arrow->from.y) < shortest * smaller)
          note(arrow->name, {"a vector shorter than 10 mm", "un vettore più corto di 10 mm"});
  }
  for (std::size_t i = 0; i < panels.size(); ++i)
    for (const double angle : panels[i].panel->crossings())
      if (angle * 180 < smallest * std::numbers::pi)
        note(fmt::format("crossing {}", i),
             {"lines that meet at less than 15°", "rette che si incontrano a meno di 15°"});
  if (has_steps_off_sheet) note("off", {"a step off the sheet", "un passo fuori del foglio"});
}

bool has_lengths(const PlacedPanel& panel) { return !panel.panel->is_of_vectors() && panel.panel->has_scale(); }

// Which of two figures has which scale.
std::string position(const PlacedPanel& panel, const PlacedPanel& other, Language language) {
  const auto middle = [](const drawings::Box& box) {
    return drawings::Point{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  };
  const drawings::Point here = middle(panel.room), there = middle(other.room);
  const bool beside = std::abs(here.x - there.x) >= std::abs(here.y - there.y);
  const Words words = beside ? (here.x < there.x ? Words{" left", " a sinistra"} : Words{" right", " a destra"})
                             : (here.y > there.y ? Words{" above", " sopra"} : Words{" below", " sotto"});
  return words.in(language);
}

// Whether all figures of the one scale lie on the same side of all those of the other.
bool stand_apart(const std::vector<PlacedPanel>& panels, const PlacedPanel& panel, const PlacedPanel& other) {
  const std::string side = position(panel, other, Language::english);
  for (const PlacedPanel& one : panels)
    for (const PlacedPanel& another : panels)
      if (has_lengths(one) && has_lengths(another) && one.lengths.caption == panel.lengths.caption &&
          another.lengths.caption == other.lengths.caption && position(one, another, Language::english) != side)
        return false;
  return true;
}
std::string size_word(const PlacedPanel& panel, const PlacedPanel& other, Language language) {
  return (panel.lengths.mm_per_unit > other.lengths.mm_per_unit ? Words{" close-ups", " ingrandimenti"}
                                                                : Words{" whole", " d'insieme"})
      .in(language);
}

// Where a sheet shows vectors of one unit at two scales, as it does forces, or beside some without any: whose this
// one is.
std::string whose(const PlacedPanel& panel, const std::vector<PlacedPanel>& panels, Language language) {
  const std::string unit = panel.panel->vectors().unit;
  const auto other = std::find_if(panels.begin(), panels.end(), [&](const PlacedPanel& each) {
    return each.panel->vectors().unit == unit && each.vectors.caption != panel.vectors.caption &&
           !is_close_up_of_polygon(each);
  });
  const bool is_polygon = panel.panel->is_of_vectors();
  const Words of_polygons{" polygons", " poligoni"};
  if (other == panels.end()) {
    const bool has_others = std::any_of(panels.begin(), panels.end(),
                                        [](const PlacedPanel& each) { return each.panel->shows_directions_only(); });
    return has_others && is_polygon ? of_polygons.in(language) : "";
  }
  if (other->panel->is_of_vectors() == is_polygon) return position(panel, *other, language);
  return (is_polygon ? of_polygons : Words{" on the bodies", " sui corpi"}).in(language);
}

// Only close-ups have this scale: their frames tell it.
bool is_told_in_frames(const Scale& scale, const std::vector<PlacedPanel>& panels) {
  return std::all_of(panels.begin(), panels.end(), [&](const PlacedPanel& each) {
    return !has_lengths(each) || each.lengths.caption != scale.caption ||
           dynamic_cast<const CloseUp*>(each.panel) != nullptr;
  });
}

// Which of two figures that differ in scale it is.
std::string which_figure(const PlacedPanel& figure, const std::vector<const PlacedPanel*>& figures,
                         const std::vector<PlacedPanel>& panels, Language language) {
  if (figures.size() != 2) return {};
  const PlacedPanel& other = *figures[&figure == figures[0] ? 1 : 0];
  return stand_apart(panels, figure, other) ? position(figure, other, language) : size_word(figure, other, language);
}

// Of more than two each has its scale below it.
void write_scale_below(const PlacedPanel& figure, DrawnSheet& onto) {
  constexpr double letters = 2.7, above_edge = 3;  // mm
  const drawings::Box covered = figure.panel->extent_of_near(figure.lengths, figure.vectors);
  const double middle = figure.origin.x + (covered.low.x + covered.high.x) / 2,
               low = std::max(figure.origin.y + covered.low.y, figure.room.low.y + above_edge);
  onto.sheet.figure.labels.push_back({.text = figure.lengths.caption,
                                      .at = {middle, low},
                                      .away_from = drawings::Point{middle, low + 1},
                                      .size = letters});
}

bool is_close_up(const PlacedPanel& panel) { return dynamic_cast<const CloseUp*>(panel.panel) != nullptr; }

// One bar for each scale: of lengths, with the figure it is of where they differ; then of vectors.
void add_bars(const std::vector<PlacedPanel>& panels, DrawnSheet& onto, const SheetRequest& request) {
  std::vector<const PlacedPanel*> figures;
  for (const PlacedPanel& each : panels)
    if (has_lengths(each) && std::none_of(figures.begin(), figures.end(), [&](const PlacedPanel* figure) {
          return figure->lengths.caption == each.lengths.caption;
        }))
      figures.push_back(&each);
  std::vector<const PlacedPanel*> told_apart = figures;
  if (figures.size() > 2)
    std::erase_if(told_apart, [&](const PlacedPanel* each) { return is_told_in_frames(each->lengths, panels); });
  // Words tell the whole from what is larger; where some part is smaller than the whole they cannot.
  const bool is_part_smaller = told_apart.size() == 2 && !stand_apart(panels, *told_apart[0], *told_apart[1]) &&
                               told_apart[0]->lengths.mm_per_unit > told_apart[1]->lengths.mm_per_unit;
  if (told_apart.size() > 2 || is_part_smaller)
    for (const PlacedPanel& each : panels)
      if (has_lengths(each) && !is_close_up(each)) write_scale_below(each, onto);
  if (is_part_smaller) told_apart.clear();
  std::vector<Scale> bars;
  std::vector<std::string> captions;  // the title block has no room for the words
  for (const PlacedPanel* figure : figures) {
    bars.push_back(figure->panel->is_in_millimetres() ? in_millimetres(figure->lengths) : figure->lengths);
    captions.push_back(figure->lengths.caption);
    if (std::find(told_apart.begin(), told_apart.end(), figure) != told_apart.end())
      bars.back().caption += which_figure(*figure, told_apart, panels, request.language);
  }
  for (const PlacedPanel& each : panels) {
    std::vector<Scale> of_vectors = each.panel->own_scales();
    of_vectors.push_back(each.vectors);
    for (const Scale& scale : of_vectors) {
      if (scale.caption.empty() || std::find(captions.begin(), captions.end(), scale.caption) != captions.end())
        continue;
      captions.push_back(scale.caption);
      if (is_close_up_of_polygon(each)) continue;
      bars.push_back(scale);
      if (scale.caption == each.vectors.caption) bars.back().caption += whose(each, panels, request.language);
    }
  }
  add_scale_bars(onto, bars, request);
  if (captions.empty()) captions = {"–"};
  onto.sheet.title_block.scales = captions;
}

// The strip of the scale bars is left free where there are some.
drawings::Box room_for(const Panels& panels, const SheetRequest& request) {
  if (std::any_of(panels.begin(), panels.end(), [](const auto& panel) { return panel->has_scale(); }))
    return room_above_scale_bars(request);
  constexpr double air = 4;  // mm
  const drawings::Box area = figure_area(request);
  return {{area.low.x + air, area.low.y + air}, {area.high.x - air, area.high.y - air}};
}

void add_section(const Solution& solution, const Section& section, DrawnSheet& onto, Language language) {
  std::vector<drawings::Block> blocks;
  for (const Result& result : section.lines)
    if (auto block = result(solution, language)) blocks.push_back(std::move(*block));
  if (blocks.empty()) return;
  onto.sheet.column.push_back(drawings::Heading{section.heading.in(language)});
  for (drawings::Block& block : blocks) onto.sheet.column.push_back(std::move(block));
}

// The letter that the solved sheet has there; empty: none.
std::string letter_at(const drawings::Point& at, const PlacedPanel& placed, const DrawnSheet& onto,
                      const SheetRequest& request) {
  DrawnSheet solved = onto;
  solved.sheet.figure.labels.clear();
  Plot plot = plot_of(placed, solved, request);
  placed.panel->draw(plot, placed.room, request.language);
  const auto& labels = solved.sheet.figure.labels;
  const auto found = std::find_if(labels.begin(), labels.end(), [&](const drawings::Label& each) {
    return !each.to && each.at.x == at.x && each.at.y == at.y;
  });
  return found == labels.end() ? "" : found->text;
}

// The sheet to be solved lies under the solved one point by point.
void draw_what_is_given(const PlacedPanel& placed, DrawnSheet& onto, const SheetRequest& request) {
  Plot plot = plot_of(placed, onto, request);
  placed.panel->draw_given(plot, placed.room, request.language);
  if (const auto start = placed.panel->start())
    mark_start(plot, *start, letter_at(plot.at(*start), placed, onto, request));
}

// What a ruler reads on the sheet as it now is.
void add_measured(const PanelSheet& shown, DrawnSheet& onto, Language language) {
  const Readings readings(onto);
  for (const auto& panel : shown.panels) {
    const auto table = panel->measured(readings);
    if (!table || table->rows.empty()) continue;
    if (!table->heading.empty()) onto.sheet.column.push_back(drawings::Heading{table->heading.in(language)});
    onto.sheet.column.push_back(comparison_table(table->rows, table->first, table->second, language));
  }
}

// Whether the point is beyond where the marks of every panel that shows lengths may be; never where none shows any.
bool is_off_sheet(const Place& P, const std::vector<PlacedPanel>& panels, DrawnSheet& onto,
                  const SheetRequest& request) {
  bool shows_lengths = false;
  for (const PlacedPanel& each : panels) {
    if (each.panel->is_of_vectors() || !each.panel->has_scale()) continue;
    shows_lengths = true;
    if (is_in(window_of(each, request), plot_of(each, onto, request), P)) return false;
  }
  return shows_lengths;
}

// The solved sheet's figure, which the sheet to be solved lies under: what a ruler reads on it, and its letters.
DrawnSheet solved_figure(const std::vector<PlacedPanel>& panels, const DrawnSheet& onto,
                         const SheetRequest& request) {
  DrawnSheet solved = onto;
  if (!request.blank) return solved;
  for (const PlacedPanel& each : panels) {
    Plot plot = plot_of(each, solved, request);
    each.panel->draw(plot, each.room, request.language);
  }
  return solved;
}

// Of the close-up, and of what it shows in the whole.
void draw_frames(const PlacedPanel& close_up, const PlacedPanel& whole, DrawnSheet& onto,
                 const SheetRequest& request) {
  draw_frame(seen_in(close_up, whole), {}, onto);
  draw_frame(close_up.room, close_up.plane().caption, onto);
  cut(onto.sheet.figure, figure_area(request));
}

double size_of_letters(const DrawnSheet& sheet) {
  const drawings::Layout parts = drawings::layout(sheet.sheet.paper, drawings::title_block_height(sheet.sheet));
  double largest = 0;
  for (const drawings::Primitive& each :
       drawings::set_column(sheet.sheet.column, parts.column, sheet.sheet.language, nullptr))
    if (const auto* text = std::get_if<drawings::PlacedText>(&each)) largest = std::max(largest, text->size);
  return largest;
}

// What the letters of the givens mean: told under them in the first of these ways that leaves the column's letters as
// large as they are. The column is complete but for that.
void add_legend(const Solution& solution, const PanelSheet& shown, DrawnSheet& onto) {
  std::vector<drawings::Block>& column = onto.sheet.column;
  constexpr std::ptrdiff_t under_givens = 2;  // their heading and they
  if (shown.legend.empty() || std::ssize(column) < under_givens) return;
  const double size = size_of_letters(onto);
  for (const Result& way : shown.legend) {
    const auto block = way(solution, onto.sheet.language);
    if (!block) continue;
    const auto at = column.insert(column.begin() + under_givens, *block);
    // In small letters already it takes no more room than it must.
    const bool is_shortest = &way == &shown.legend.back();
    if (size_of_letters(onto) == size && (size >= drawings::column_size || is_shortest)) return;
    column.erase(at);
  }
}

std::string description(const Solution& solution, const PanelSheet& shown, Language language) {
  std::vector<Value> values;
  for (const std::string& name : shown.told)
    if (const auto value = solution.value(name))
      values.push_back({name, *value, written_unit(solution.described(name).unit, language)});
  return in_words(shown.seen, values, language);
}

}  // namespace

DrawnSheet arrange(const Description& about, const std::string& sheet, const Solution& solution,
                   const PanelSheet& shown, const SheetRequest& request) {
  const Language language = request.language;
  DrawnSheet onto = blank_sheet(about, sheet, solution.givens(), request, shown.without_part);
  if (!shown.title.empty() && request.titles.title.empty()) {
    drawings::TitleBlock& block = onto.sheet.title_block;
    block.exercise = shown.title.in(language);
    onto.sheet.title = drawings::plain(block.exercise + ": " + block.sheet);
  }
  const drawings::Box whole_room = room_for(shown.panels, request);
  for (const auto& panel : shown.panels) panel->choose_view(whole_room, request);
  const LaidOut laid = laid_out_with_close_ups(shown.panels, whole_room, request);
  const std::vector<PlacedPanel>& panels = laid.panels;
  std::vector<drawings::Block> of_drawings;
  std::vector<PanelPart> parts;
  for (const PlacedPanel& each : panels) {
    const DrawnSoFar before(onto);
    const PlacedPanel* const close_up = close_up_of(each, panels);
    if (request.blank) {
      draw_what_is_given(each, onto, request);
    } else {
      Plot plot = plot_of(each, onto, request);
      for (drawings::Block& block : each.panel->draw(plot, each.room, language))
        of_drawings.push_back(std::move(block));
      plot.in_step({});
    }
    if (close_up) leave_to_close_up(*close_up, each, before, onto);
    parts.push_back({onto.sheet.figure.marks.size(), onto.sheet.figure.labels.size()});
    cut(onto.sheet.figure, window_of(each, request));
    if (close_up) draw_frames(*close_up, each, onto, request);
  }
  add_bars(panels, onto, request);

  auto& column = onto.sheet.column;
  AskedOnSheet asked;
  std::string origin;
  if (request.for_class || request.blank) {
    const DrawnSheet solved = solved_figure(panels, onto, request);
    std::set<std::string> measured;
    for (const Measurement& each : solved.measurements) measured.insert(each.quantity);
    asked = asked_on(about, solution, shown, [&](const std::string& quantity, const Place& P) {
      return !measured.contains(quantity) && is_off_sheet(P, panels, onto, request);
    });
    origin = letter_of_origin(names_of(asked.asked), solution, solved);
  }
  if (request.for_class) onto.asked = names_of(asked.asked);
  if (request.blank) {
    const Words question = question_of(about, sheet);
    add_problem(onto, question, solution, asked, origin, request);
    add_legend(solution, shown, onto);
    onto.sheet.description = drawings::plain(question.in(language));
    return onto;
  }
  for (const Section& section : shown.first) add_section(solution, section, onto, language);
  for (const auto& panel : shown.panels)
    for (const drawings::VectorEquation& equation : panel->equations()) column.push_back(equation);
  bool has_steps_off_sheet = false;
  std::vector<drawings::Block> steps = number_steps(panels, parts, onto, request, has_steps_off_sheet);
  tell_steps(onto.sheet.figure, parts);
  if (request.for_class) {
    note_awkwardness(sheet, panels, parts, has_steps_off_sheet, onto);
    note_not_asked(sheet, asked, onto.awkward);
  }
  if (!steps.empty()) column.push_back(drawings::Heading{Words{"Construction", "Costruzione"}.in(language)});
  for (drawings::Block& block : steps) column.push_back(std::move(block));
  for (drawings::Block& block : of_drawings) column.push_back(std::move(block));
  for (const Section& section : shown.theory) add_section(solution, section, onto, language);
  add_section(solution, {{"Results", "Risultati"}, shown.results}, onto, language);
  add_measured(shown, onto, language);
  add_legend(solution, shown, onto);
  onto.sheet.description = description(solution, shown, language);
  return onto;
}

}  // namespace epure
