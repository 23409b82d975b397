#include "exercises/kit/panels/integration_panel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drawings/text/text.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double letters_above = 6, numbers_below = 6;             // mm, of each row
constexpr double left_of_pole = 6, right_of_axis = 13;             // mm
constexpr double least_pole_distance = 14, most_pole_share = 0.4;  // mm; of the width
constexpr double least_width = 60, least_height = 10;              // mm; of a row
constexpr double number_size = 2.5, tick = 1;                      // mm
constexpr double numbers_apart = 5.5, heights_apart = 6;           // mm, of the numbers along the axes
constexpr int curve_points = 100;

// Of the polygon, the curve and what is carried, with zero; 0 to 1 where all is zero.
std::pair<double, double> range(const IntegrationRow& row, const std::vector<double>& ends) {
  double low = 0, high = 0;
  const auto include = [&](double y) {
    low = std::min(low, y);
    high = std::max(high, y);
  };
  for (const double y : row.corners) include(y);
  for (const double y : row.carried) include(y);
  if (row.curve)
    for (int i = 0; i <= curve_points; ++i)
      include(row.curve(ends.front() + (ends.back() - ends.front()) * i / curve_points));
  if (low == high) high = 1;
  return {low, high};
}

// The next smaller standard scale.
Scale smaller(const Scale& scale, Language language) {
  constexpr double less = 0.99;
  return largest_vector_scale(less * scale.mm_per_unit, scale.unit, language);
}

// Steps of 1, 2 or 5 times a power of ten that are at least `mm` long.
double readable_step(const Scale& scale, double mm) {
  const double least = mm / scale.mm_per_unit, decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least) return step * decade;
  return 10 * decade;
}

}  // namespace

IntegrationPanel::IntegrationPanel(IntegrationAbscissa along, std::vector<IntegrationRow> rows, Words mean)
    : along_(std::move(along)), rows_(std::move(rows)), mean_(std::move(mean)) {
  for (const IntegrationRow& row : rows_) ranges_.push_back(range(row, along_.ends));
}

Place IntegrationPanel::at(std::size_t row, double x, double ordinate) const {
  return {(x - along_.ends.front()) * scales_[0].mm_per_unit, axes_[row] + ordinate * scales_[row + 1].mm_per_unit};
}

// That at which the integral comes out at the scale of the next row.
double IntegrationPanel::pole_distance(std::size_t row) const {
  return scales_[row + 1].mm_per_unit / scales_[row + 2].mm_per_unit * scales_[0].mm_per_unit;
}

// Of the standard scales those that make the diagrams largest together, in equal shares of the height or less, with
// poles neither too near nor too far.
void IntegrationPanel::choose_view(const drawings::Box& whole_room, const SheetRequest& request) {
  const double run = along_.ends.back() - along_.ends.front();
  const double width = whole_room.width() - left_of_pole - right_of_axis;
  const double height = whole_room.height() - static_cast<double>(rows_.size()) * (letters_above + numbers_below);
  const auto refuse = [] {
    throw DoesNotFit("the diagrams do not fit the paper at any standard scale",
                     "i diagrammi non stanno sulla carta in alcuna scala normalizzata");
  };
  if (width < least_width || height < static_cast<double>(rows_.size()) * least_height) refuse();
  std::vector<Scale> abscissae{largest_vector_scale(width / run, along_.unit, request.language)};
  for (int i = 0; i < 5; ++i) abscissae.push_back(smaller(abscissae.back(), request.language));

  std::optional<double> best;
  std::vector<Scale> chosen;
  const auto consider = [&] {
    double farthest = 0, merit = 0, taken = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double high = (ranges_[i].second - ranges_[i].first) * scales_[i + 1].mm_per_unit;
      taken += high;
      merit += std::log(high);
      if (i + 1 == rows_.size()) break;
      const double distance = pole_distance(i);
      farthest = std::max(farthest, distance);
      constexpr double costly = 4;  // a pole that is too near or too far is worse than small diagrams
      merit += costly * std::min(0.0, std::log(distance / least_pole_distance));
      merit -= costly * std::max(0.0, std::log(distance / (most_pole_share * width)));
    }
    const double wide = run * scales_[0].mm_per_unit;
    if (wide + farthest > width || taken > height) return;
    merit += static_cast<double>(rows_.size()) * std::log(wide);
    if (best && merit <= *best) return;
    best = merit;
    chosen = scales_;
  };
  // A row may take more than its equal share where others take less.
  const std::function<void(std::size_t)> try_rows = [&](std::size_t row) {
    if (row == rows_.size()) return consider();
    constexpr double most_of_share = 1.6;
    const double share = most_of_share * height / static_cast<double>(rows_.size());
    Scale scale =
        largest_vector_scale(share / (ranges_[row].second - ranges_[row].first), rows_[row].unit, request.language);
    for (int i = 0; i < 6; ++i) {
      scales_.push_back(scale);
      try_rows(row + 1);
      scales_.pop_back();
      scale = smaller(scale, request.language);
    }
  };
  for (const Scale& scale : abscissae) {
    scales_ = {scale};
    try_rows(0);
  }
  if (!best) refuse();
  scales_ = chosen;
  lay_rows(whole_room.height());
}

// From the top down, with the height that is left over between them.
void IntegrationPanel::lay_rows(double height) {
  double left_over = height;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    left_over -= (ranges_[i].second - ranges_[i].first) * scales_[i + 1].mm_per_unit + letters_above + numbers_below;
  constexpr double most_air = 12;
  const double air = std::min(most_air, left_over / static_cast<double>(rows_.size() + 1));
  axes_.clear();
  double top = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    top -= letters_above;
    axes_.push_back(top - ranges_[i].second * scales_[i + 1].mm_per_unit);
    top = axes_.back() + ranges_[i].first * scales_[i + 1].mm_per_unit - numbers_below - air;
  }
}

drawings::Box IntegrationPanel::extent(const Scale&, const Scale&) const {
  double farthest = 0;
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) farthest = std::max(farthest, pole_distance(i));
  const std::size_t last = rows_.size() - 1;
  return {{-farthest - left_of_pole, at(last, along_.ends.front(), ranges_[last].first).y - numbers_below},
          {at(0, along_.ends.back(), 0).x + right_of_axis, 0}};
}

// The abscissae are numbered under the last row, the ordinates at the right, where no ray is in the way.
void IntegrationPanel::draw_axes(Plot& plot, std::size_t row, Language language) const {
  const double first = along_.ends.front(), last = along_.ends.back();
  const auto [low, high] = ranges_[row];
  const bool has_pole = row + 1 < rows_.size();
  constexpr double beyond = 3;
  const Place right{at(row, last, 0).x, axes_[row]};
  plot.segment({has_pole ? -pole_distance(row) : 0, axes_[row]}, right, Meaning::axis);
  // Continuous, over the end of the first strip.
  plot.segment(at(row, first, low), at(row, first, high) + Arrow2{0, beyond}, Meaning::dimension);
  plot.segment(at(row, last, low), at(row, last, high), Meaning::construction);
  const auto write = [&](const std::string& text, Place from) {
    plot.mark(drawings::Writing{text, plot.at(from), number_size});
  };
  const double step = readable_step(scales_[row + 1], heights_apart);
  for (double i = std::ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9); ++i) {
    const Place mark = at(row, last, i * step);
    plot.segment(mark, mark + Arrow2{-tick, 0}, Meaning::construction);
    write(short_number(i * step, language), mark + Arrow2{1, -number_size / 3});
  }
  const auto title = [&](const std::string& letters, const std::string& unit) {
    return letters + (unit.empty() ? "" : " (" + unit + ")");
  };
  // Over the scale that it names; a long one ends where that does.
  constexpr double longest_title = 20;
  const std::string name = title(rows_[row].letters, rows_[row].unit);
  const double begins = std::min(1.0, longest_title - drawings::measure(name, number_size).width);
  write(name, at(row, last, high) + Arrow2{begins, 3.6});
  if (row + 1 < rows_.size()) return;
  // The numbers are those of ticks under the strips, which have other widths: all ticks in one line with their axis.
  const double foot = at(row, first, low).y, below = foot - 4;
  std::vector<drawings::Point> ticks{plot.at({0, foot})};
  const double abscissa_step = readable_step(scales_[0], numbers_apart);
  for (double i = std::ceil(first / abscissa_step - 1e-9); i * abscissa_step <= last + 1e-9 * (last - first); ++i) {
    const std::string text = short_number(i * abscissa_step, language);
    const Place mark{at(row, i * abscissa_step, 0).x, foot};
    for (const double down : {0.0, -tick, 0.0}) ticks.push_back(plot.at(mark + Arrow2{0, down}));
    write(text, {mark.x - drawings::measure(text, number_size).width / 2, below});
  }
  ticks.push_back(plot.at({right.x, foot}));
  plot.mark(drawings::Line{drawings::polyline(ticks, false), Meaning::construction});
  write(title(along_.letters, along_.unit), {right.x + 3, below});
}

void IntegrationPanel::draw_curve(Plot& plot, std::size_t row) const {
  if (!rows_[row].curve) return;
  std::vector<drawings::Point> points;
  for (int i = 0; i <= curve_points; ++i) {
    const double x = along_.ends.front() + (along_.ends.back() - along_.ends.front()) * i / curve_points;
    points.push_back(plot.at(at(row, x, rows_[row].curve(x))));
  }
  const bool is_given = rows_[row].corners.empty();
  plot.mark(drawings::Line{drawings::polyline(points, false), is_given ? rows_[row].meaning : Meaning::alternative});
}

void IntegrationPanel::draw_polygon(Plot& plot, std::size_t row) const {
  if (rows_[row].corners.empty()) return;
  std::vector<drawings::Point> points;
  for (std::size_t i = 0; i < along_.ends.size(); ++i)
    points.push_back(plot.at(at(row, along_.ends[i], rows_[row].corners[i])));
  plot.mark(drawings::Line{drawings::polyline(points, false), rows_[row].meaning, rows_[row].id});
}

// Of many strips every fifth has its number, and its ray the same one.
constexpr std::size_t most_numbered = 20;
constexpr std::size_t every_numbered = 5;
bool are_many(std::size_t strips) { return strips > most_numbered; }
bool has_number(std::size_t strip, std::size_t strips) {
  return !are_many(strips) || (strip + 1) % every_numbered == 0;
}

// The numbers of rays stand so far from the axis of ordinates, mm: at it they would be taken for its values.
constexpr double off_axis = 5;

// Whether a number can stand on the ray of this height, on the side away from the pole's, where no other ray comes so
// near. Of several at one height the first has it.
bool is_free(const std::vector<double>& heights, std::size_t ray, double pole_distance) {
  constexpr double room = 3.2, width = 3.2;  // mm
  const double right = 1 - off_axis / pole_distance, left = right - width / pole_distance, own = heights[ray];
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i] == own && i < ray) return false;
    const bool is_beyond = own < 0 ? heights[i] < own : heights[i] > own;
    if (is_beyond && std::abs(heights[i]) * left - std::abs(own) * right < room) return false;
  }
  return true;
}

// The steps of the construction: three a row, of which the last draws the polygon in the next one; what is integrated
// is given.
int step_of_carrying(std::size_t row) { return 3 * static_cast<int>(row) + 1; }
int step_of_rays(std::size_t row) { return 3 * static_cast<int>(row) + 2; }
int step_of_polygon(std::size_t row) { return 3 * static_cast<int>(row); }

// What is carried from the strips, and the rays; as many of these are numbered as find room. The strips are numbered
// under the first diagram; many that are narrower than a number above it, where their lines end.
void IntegrationPanel::carry(Plot& plot, std::size_t row, Language language) const {
  const std::vector<double>& carried = rows_[row].carried;
  if (carried.empty()) return;
  const double digit_height = 0.7 * number_size, apart = 0.7;
  const Place pole{-pole_distance(row), axes_[row]};
  std::vector<double> heights;
  for (const double mean : carried) heights.push_back(mean * scales_[row + 1].mm_per_unit);
  const double foot = at(row, along_.ends.front(), ranges_[row].first).y,
               head = at(row, along_.ends.front(), ranges_[row].second).y;
  const double widest = drawings::measure(std::to_string(carried.size()), number_size).width;
  const bool many = are_many(carried.size());
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const Place mean = at(row, (along_.ends[i] + along_.ends[i + 1]) / 2, carried[i]);
    const Place on_axis{0, mean.y};
    plot.in_step(step_of_carrying(row));
    plot.segment(mean, on_axis, Meaning::construction);
    plot.in_step(step_of_rays(row));
    plot.segment(pole, on_axis, Meaning::construction);
    plot.in_step(step_of_carrying(row));
    plot.dot(mean);
    const std::string number = std::to_string(i + 1);
    const double width = drawings::measure(number, number_size).width;
    const auto write = [&](Place from) { plot.mark(drawings::Writing{number, plot.at(from), number_size}); };
    if (!has_number(i, carried.size())) continue;
    const Place on_ray = on_axis + off_axis / -pole.x * (pole - on_axis);
    if (is_free(heights, i, -pole.x))
      plot.mark(drawings::Writing{
          number, plot.at(on_ray + Arrow2{-width, heights[i] < 0 ? -apart - digit_height : apart}), number_size});
    if (row > 0) continue;
    const double strip = (along_.ends[i + 1] - along_.ends[i]) * scales_[0].mm_per_unit;
    if (strip > (many ? widest : width) + apart)
      write({mean.x - width / 2, foot - apart - digit_height});
    else if (many && every_numbered * strip > widest + apart)
      write({mean.x - width / 2, head + apart});
  }
  plot.in_step(step_of_rays(row));
  plot.dot(pole);
  plot.label(rows_.size() > 2 ? "$O_{" + std::to_string(row + 1) + "}$" : "$O$", pole, Place{0, axes_[row]});
  plot.segment(pole, {pole.x, foot}, Meaning::construction);
  plot.mark(drawings::Dimension{plot.at({pole.x, foot}), plot.at({0, foot}), -3.5,
                                short_number(pole_distance(row), language) + " mm"});
}

void IntegrationPanel::draw_readings(Plot& plot, std::size_t row) const {
  for (const IntegrationRow::Read& read : rows_[row].read) {
    const Place foot = at(row, read.at, 0), tip = at(row, read.at, read.value);
    // The letters of a short one stand above the diagram, of the last one at its tip: beside it are the axis'
    // numbers.
    constexpr double short_one = 8, aside = 10;  // mm
    const bool is_last = read.at == along_.ends.back(), is_short = std::abs(tip.y - foot.y) < short_one;
    plot.side("", foot, tip, rows_[row].meaning, is_last || is_short ? "" : read.label,
              Place{foot.x - aside, foot.y});
    const bool is_upwards = tip.y > foot.y;
    if (is_short && !is_last)
      plot.label(read.label, is_upwards ? tip : foot, is_upwards ? foot : tip, rows_[row].meaning);
    if (is_last) plot.label(read.label, tip, Place{tip.x - aside, 2 * foot.y - tip.y}, rows_[row].meaning);
    if (!read.quantity.empty() && plot.shows(foot) && plot.shows(tip))
      plot.onto().measurements.push_back(
          {read.quantity, plot.at(foot), plot.at(tip), read.si / scales_[row + 1].mm_per_unit, Measurement::along_y});
  }
}

// The strips, the axes, and of the curves the one that is integrated.
void IntegrationPanel::draw_given(Plot& plot, const drawings::Box&, Language language) const {
  const std::size_t last = rows_.size() - 1;
  for (const double end : along_.ends)
    plot.segment(at(0, end, ranges_[0].second), at(last, end, ranges_[last].first), Meaning::construction);
  for (std::size_t i = 0; i < rows_.size(); ++i) draw_axes(plot, i, language);
  draw_curve(plot, 0);
}

std::vector<drawings::Block> IntegrationPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  plot.in_step(0);
  draw_given(plot, room, language);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    carry(plot, i, language);
    plot.in_step(step_of_polygon(i));
    if (i > 0) draw_curve(plot, i);
    draw_polygon(plot, i);
    draw_readings(plot, i);
  }
  return {};
}

std::vector<PanelStep> IntegrationPanel::steps(const Plot&, const drawings::Box&) const {
  std::vector<PanelStep> all;
  const std::size_t middle = (along_.ends.size() - 2) / 2;  // strip
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const IntegrationRow &row = rows_[i], &next = rows_[i + 1];
    const double x = (along_.ends[middle] + along_.ends[middle + 1]) / 2;
    const std::string pole = rows_.size() > 2 ? "$O_{" + std::to_string(i + 1) + "}$" : "$O$";
    const Words of = i == 0 ? mean_
                            : Words{"the ordinate of the polygon in the middle of each strip",
                                    "l'ordinata del poligono a metà di ogni striscia"};
    const Words dashed{" Dashed, where it can be told apart, the true one.",
                       " Tratteggiata, dove se ne distingue, la curva esatta."};
    // Whose number a ray has.
    const Words numbered =
        i > 0 ? Words{}
        : are_many(row.carried.size())
            ? Words{" Every fifth strip has its number, and its ray the same where it finds room.",
                    " Una striscia su cinque ha il suo numero, e così il suo raggio dove c'è posto."}
            : Words{" The rays that have room for it have their strip's number.",
                    " I raggi che ne hanno lo spazio portano il numero della loro striscia."};
    all.push_back({format_words("{}: {} is carried to the axis of ordinates.",
                                "{}: {} si riporta sull'asse delle ordinate.", row.letters, of),
                   at(i, x, row.carried[middle])});
    all.push_back(
        {format_words(
             "From there rays run to the pole {}, at the distance that is drawn: in centimetres the scale of "
             "{} (units per cm), divided by those of {} and of {}.",
             "Da lì i raggi vanno al polo {}, alla distanza quotata: in centimetri la scala di {} (unità per "
             "cm), divisa per quelle di {} e di {}.",
             pole, next.letters, along_.letters, row.letters) +
             numbered,
         Place{-pole_distance(i) / 2, axes_[i]}});
    all.push_back(
        {format_words("{}: in each strip parallel to its ray, from corner to corner.",
                      "{}: in ogni striscia parallela al suo raggio, di vertice in vertice.", next.letters) +
             (i > 0 ? Words{} : dashed),
         // Among many strips a number's leader would cross the axis' numbers: it stands where the polygon begins.
         are_many(along_.ends.size() - 1) ? at(i + 1, along_.ends.front(), next.corners.front())
                                          : at(i + 1, x, (next.corners[middle] + next.corners[middle + 1]) / 2)});
  }
  return all;
}

}  // namespace epure
