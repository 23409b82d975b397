#include "exercises/cli/sweep_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "drawings/files/xml.h"
#include "drawings/paths/grid.h"
#include "drawings/text/text.h"
#include "exercises/cli/html_page.h"
#include "exercises/cli/html_words.h"
#include "exercises/cli/inline_svg.h"
#include "exercises/cli/screen_style.h"
#include "exercises/cli/sweep_html_parts.h"
#include "exercises/cli/sweep_pictures.h"
#include "exercises/cli/sweep_words.h"
#include "exercises/cli/typographic.h"
#include "exercises/kit/panels/results.h"

namespace epure {
namespace {

class SweepPage {
 public:
  SweepPage(const SweepStudy& study, const std::vector<SweptRow>& rows, const SweepChart& chart, Language language)
      : study_(study),
        rows_(rows),
        language_(language),
        charts_(chart.charts()),
        has_faults_(std::any_of(rows.begin(), rows.end(), [](const SweptRow& row) { return !row.faults.empty(); })),
        pictures_(sweep_pictures(study, language)) {}

  std::string text() {
    const std::string title = study_.exercise->about().title.in(language_) + ": " + say({"Sweep", "Variazione"});
    std::string all = "<main class=\"epure\">\n<h1>" + html(title) + "</h1>\n";
    add_values(all);
    all += fmt::format("<div class=\"show{}\">\n", pictures_ ? " both" : "");
    if (pictures_) add_pictures(all);
    add_charts(all);
    all += "</div>\n";
    add_controls(all);
    add_all_positions(all);
    all += script_of_page(script_of_sweep) + "</main>\n";
    return html_page({.language = language_,
                      .title = drawings::plain(title),
                      .style = std::string(style_of_moved_page) + style_of_sweep + style_of_words + print_style() +
                               dark_style(pages()),
                      .body = std::move(all)});
  }

 private:
  std::string say(const Words& words) const { return words.in(language_); }

  // Of the table, the slider and the pictures: each curve from its first point to its last.
  template <class See>
  void in_order_of_curves(See see) const {
    const std::uint64_t points = study_.over.front().size(), curves = study_.size() / points;
    for (std::uint64_t curve = 0; curve < curves; ++curve)
      for (std::uint64_t point = 0; point < points; ++point) see(rows_[point * curves + curve], curve);
  }

  std::vector<drawings::Page> pages() const {
    std::vector<drawings::Page> all{charts_.page};
    if (!pictures_) return all;
    all.push_back(pictures_->scales);
    for (const auto& each : pictures_->positions)
      if (each) all.push_back(*each);
    return all;
  }

  std::string print_style() const {
    const auto size = [](const char* of, const drawings::Page& page) {
      return fmt::format(".{} svg {{ width: {:.5f}mm; height: {:.5f}mm; }}\n", of, page.extent.width(),
                         page.extent.height());
    };
    return "@media print {\n" + size("charts", charts_.page) +
           (pictures_ ? size("pictures", pictures_->scales) : "") + "}\n";
  }

  void add_pictures(std::string& all) {
    all += "<figure class=\"sheet\"><div class=\"pictures\">\n<div class=\"scales\">" + svgs_.add(pictures_->scales) +
           "</div>\n";
    in_order_of_curves([&](const SweptRow& row, std::uint64_t) {
      const auto& picture = pictures_->positions[row.number];
      all += row.number == 0 ? "<div class=\"position shown\">" : "<div class=\"position\">";
      all += picture ? svgs_.add(*picture) : "<p class=\"none\">" + why_no_picture(row) + "</p>";
      all += "</div>\n";
    });
    all += "</div></figure>\n";
  }
  std::string why_no_picture(const SweptRow& row) const {
    if (!row.is_possible()) return drawings::escaped_for_xml(say(reason_in_full(row.quantities.front())));
    return say({"The mechanism cannot be drawn here.", "Qui il meccanismo non si può disegnare."});
  }

  void add_charts(std::string& all) {
    std::string frames;
    for (const drawings::ChartMap& map : charts_.maps)
      frames +=
          fmt::format("{}{:.0f} {:.0f}", frames.empty() ? "" : " ", svg_y(map.frame.high.y), svg_y(map.frame.low.y));
    all += fmt::format("<figure class=\"sheet\"><div class=\"charts\" data-frames=\"{}\">\n{}</div></figure>\n",
                       frames, svgs_.add(charts_.page));
  }

  // In the units of the charts' SVG.
  static constexpr double units_per_mm = drawings::points_per_mm * drawings::steps_per_point;
  double svg_x(double mm) const { return (mm - charts_.page.extent.low.x) * units_per_mm; }
  double svg_y(double mm) const { return (charts_.page.extent.high.y - mm) * units_per_mm; }

  void add_values(std::string& all) const {
    all += fmt::format(
        "<section class=\"values\" aria-live=\"polite\" aria-label=\"{}\">\n<p class=\"name\">{}</p>\n"
        "<table><tbody>\n",
        say({"Values at this position", "Valori in questa posizione"}), position(rows_.front()));
    for (std::size_t i = 0; i < study_.quantities.size(); ++i) {
      const Quantity& quantity = study_.quantities[i];
      all += fmt::format("<tr><th scope=\"row\">{}, {}</th><td class=\"value\">{}</td></tr>\n", html(quantity.symbol),
                         html(quantity.meaning.in(language_)), value(rows_.front(), i));
    }
    all += "</tbody></table>\n";
    if (has_faults_) all += "<p class=\"fault\">" + faults(rows_.front()) + "</p>\n";
    all += "</section>\n";
  }

  std::string faults(const SweptRow& row) const {
    return drawings::escaped_for_xml(faults_in_line(row.faults, language_));
  }
  std::string position(const SweptRow& row) const { return html(position_in_words(study_, row.places, language_)); }

  // "5.103 m/s" with all digits, and below it between which bounds; or why there is none.
  std::string value(const SweptRow& row, std::size_t quantity) const {
    const SweptQuantity& found = row.quantities[quantity];
    std::string text;
    if (found.state == SweptQuantity::State::value) {
      const geometry::Enclosure& known = found.enclosure;
      text = number(known.value) + html(unit_after_number(study_.quantities[quantity].unit, language_)) +
             "<span class=\"bounds\">" +
             (known.lower == known.upper ? say({"exactly", "esattamente"})
                                         : number(known.lower) + " … " + number(known.upper)) +
             "</span>";
    }
    const Words reason = reason_in_full(found);
    return reason.empty() ? text
                          : text + "<span class=\"none\">" + drawings::escaped_for_xml(say(reason)) + "</span>";
  }
  std::string number(double value) const { return html(typographic(say(all_digits(value)))); }

  void add_controls(std::string& all) const {
    all += fmt::format(
        "<div class=\"controls\" role=\"group\" aria-label=\"{0}\" hidden=\"\">\n<div class=\"moves\">\n"
        "<button type=\"button\" class=\"play\" data-play=\"{1}\" data-pause=\"{2}\">{1}</button>\n"
        "<button type=\"button\" class=\"previous\">{3}</button>\n"
        "<input type=\"range\" class=\"slider\" min=\"0\" max=\"{4}\" step=\"1\" value=\"0\" aria-label=\"{5}\"/>\n"
        "<button type=\"button\" class=\"next\">{6}</button>\n</div>\n</div>\n",
        say({"Movement", "Movimento"}), say({"Play", "Avvia"}), say({"Pause", "Ferma"}),
        say({"Previous", "Indietro"}), rows_.size() - 1, say({"Position", "Posizione"}), say({"Next", "Avanti"}));
  }

  void add_all_positions(std::string& all) const {
    all += "<details class=\"all\"><summary>" + say({"All positions", "Tutte le posizioni"}) +
           "</summary>\n<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr><th scope=\"col\">" +
           say({"position", "posizione"}) + "</th>";
    for (const Quantity& each : study_.quantities) all += "<th scope=\"col\">" + html(each.symbol) + "</th>";
    if (has_faults_) all += "<th scope=\"col\">" + say({"faults", "difetti"}) + "</th>";
    all += "</tr></thead>\n<tbody>\n";
    in_order_of_curves([&](const SweptRow& row, std::uint64_t curve) {
      const std::string words = position_in_words(study_, row.places, language_);
      all += fmt::format("<tr data-name=\"{}\" data-x=\"{:.0f}\" data-curve=\"{}\"><th scope=\"row\">{}</th>",
                         drawings::escaped_for_attribute(drawings::plain(words)), svg_x(abscissa(row)), curve,
                         html(words));
      for (std::size_t i = 0; i < row.quantities.size(); ++i)
        all += "<td class=\"value\"" + ordinate(row, i) + ">" + value(row, i) + "</td>";
      if (has_faults_) all += "<td class=\"faults\">" + faults(row) + "</td>";
      all += "</tr>\n";
    });
    all += "</tbody></table></div></details>\n";
  }

  // On the paper of the charts. All axes stand above each other, of one given.
  double abscissa(const SweptRow& row) const {
    return charts_.maps.front().x.at(study_.over.front().number(row.places.front()));
  }
  // Nothing of what is not on its chart.
  std::string ordinate(const SweptRow& row, std::size_t quantity) const {
    if (row.quantities[quantity].state != SweptQuantity::State::value) return {};
    const drawings::ChartMap& map = charts_.maps[charts_.chart_of[quantity]];
    const double y = map.y.at(row.quantities[quantity].enclosure.value);
    if (y < map.frame.low.y || y > map.frame.high.y) return {};
    return fmt::format(" data-y=\"{:.0f}\"", svg_y(y));
  }

  const SweepStudy& study_;
  const std::vector<SweptRow>& rows_;
  Language language_;
  SweepChart::Charts charts_;
  bool has_faults_;
  std::optional<SweepPictures> pictures_;
  InlineSvgs svgs_;
};

}  // namespace

std::string sweep_html(const SweepStudy& study, const std::vector<SweptRow>& rows, const SweepChart& chart,
                       Language language) {
  return SweepPage(study, rows, chart, language).text();
}

}  // namespace epure
