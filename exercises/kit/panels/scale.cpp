#include "exercises/kit/panels/scale_bar.h"

#include <array>
#include <cmath>

#include "drawings/text/sheet_words.h"

namespace epure {
namespace {

// The largest  step * 10^k  that is not larger than x > 0.
template <std::size_t N>
double largest_below(double x, const std::array<double, N>& ascending_steps) {
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  double best = decade;
  for (const double step : ascending_steps) {
    if (step * decade <= x) best = step * decade;
  }
  return best;
}

}  // namespace

std::string short_number(double x, Language language) {
  if (x == 0) return "0";
  if (std::abs(x) >= 1e6 || std::abs(x) < 1e-3) {
    const double decade = std::pow(10.0, std::floor(std::log10(std::abs(x)) + 1e-9));
    const bool is_one_figure = std::abs(std::round(x / decade) * decade - x) <= 1e-9 * std::abs(x);
    return drawings::number(x, is_one_figure ? 1 : 2, language);
  }
  if (x < 0) return "−" + short_number(-x, language);
  for (int figures = 1; figures < 6; ++figures) {
    const double grain = std::pow(10.0, std::floor(std::log10(x)) - figures + 1);
    if (std::abs(std::round(x / grain) * grain - x) > 1e-9 * x) continue;
    const int decimals = static_cast<int>(std::max(0.0, -std::floor(std::log10(grain) + 1e-9)));
    std::string text = std::to_string(static_cast<long long>(std::llround(x * std::pow(10.0, decimals))));
    if (decimals == 0) return text;
    while (static_cast<int>(text.size()) <= decimals) text.insert(0, "0");
    return text.insert(text.size() - static_cast<std::size_t>(decimals), language == Language::italian ? "," : ".");
  }
  return drawings::number(x, 6, language);
}

Scale length_scale(const Rational& ratio) {
  const double paper_over_nature = CGAL::to_double(ratio);
  return {.mm_per_unit = 1000 * paper_over_nature,
          .caption = paper_over_nature >= 1 ? short_number(paper_over_nature, Language::english) + " : 1"
                                            : "1 : " + short_number(1 / paper_over_nature, Language::english),
          .unit = "m"};
}

Scale largest_length_scale(double mm_per_metre) {
  const double ratio = largest_below(mm_per_metre / 1000, std::array{1.0, 2.0, 5.0});
  return length_scale(ratio < 1 ? Rational(1) / Rational(std::round(1 / ratio)) : Rational(std::round(ratio)));
}

Scale largest_vector_scale(double mm_per_unit, const std::string& unit, Language language) {
  // In units per centimetre the scale is rounded up, so the inverse is rounded down: 1/5, 1/2.5, 1/2, 1.
  const double per_cm = 10 / mm_per_unit;
  const double decade = std::pow(10.0, std::floor(std::log10(per_cm)));
  double chosen = 10 * decade;
  for (const double step : {5.0, 2.5, 2.0, 1.0}) {
    if (step * decade >= per_cm) chosen = step * decade;
  }
  return {
      .mm_per_unit = 10 / chosen, .caption = "1 cm ≙ " + short_number(chosen, language) + " " + unit, .unit = unit};
}

Scale in_millimetres(Scale scale) {
  scale.mm_per_unit /= 1000;
  scale.unit = "mm";
  return scale;
}

drawings::ScaleBar bar(const Scale& scale, drawings::Point at, Language language) {
  constexpr double longest = 45;  // mm: reads well beside a figure and leaves room for a second bar
  return bar(scale, at, longest, language);
}

drawings::ScaleBar bar(const Scale& scale, drawings::Point at, double longest, Language language) {
  const double whole = largest_below(longest / scale.mm_per_unit, std::array{1.0, 2.0, 4.0, 5.0});
  const double leading = whole / std::pow(10.0, std::floor(std::log10(whole) + 1e-9));
  const int divisions = leading > 4.5 ? 5 : leading > 1.5 ? 4 : 5;
  drawings::ScaleBar mark{
      .at = at, .length = whole * scale.mm_per_unit, .divisions = divisions, .caption = scale.caption, .ticks = {}};
  constexpr double room_for_three = 35;  // mm: numbers on a shorter bar would touch
  for (int i = 0; i <= divisions; ++i) {
    const bool labelled = i == 0 || i == divisions || (divisions == 4 && i == 2 && longest >= room_for_three);
    std::string tick = i == 0 ? "0" : labelled ? short_number(whole * i / divisions, language) : "";
    mark.ticks.push_back(i == divisions ? tick + " " + scale.unit : tick);
  }
  return mark;
}

}  // namespace epure
