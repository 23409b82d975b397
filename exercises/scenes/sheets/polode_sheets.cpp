#include "exercises/scenes/sheets/polode_sheets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/named_curve.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/scenes/drive_way.h"
#include "exercises/scenes/kept_by_givens.h"
#include "exercises/scenes/reached.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/in_lines.h"
#include "exercises/scenes/sheets/scene_figure.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using geometry::EveryPlace;
using geometry::Fast;

// They run to infinity: the sheet shows the plane around the mechanism, so many times as wide as it is.
constexpr double widths = 2.4;

// One position of the drive: the centre where it is found, and where tracing paper brings it. None: at infinity.
struct CentreThere {
  std::string number;
  std::optional<Place> in_plane, on_link;
};

std::optional<Place> place_of(const geometry::ProjectivePoint<Fast>& P) {
  if (P.w == 0) return {};
  return Place{P.x / P.w, P.y / P.w};
}

// Where centres go does not hang on how fast the drive moves, nor on whether it does.
geometry::Linkage with_moving_drive(geometry::Linkage linkage) {
  geometry::Drive& drive = linkage.drives.front();
  if (auto* turned = std::get_if<geometry::TurnedLink>(&drive))
    turned->omega = {1, 0};
  else if (auto* slid = std::get_if<geometry::SlidPoint>(&drive))
    slid->velocity = 1;
  else
    std::get<geometry::Stretched>(drive).velocity = 1;
  return linkage;
}

class PolodesOfLink {
 public:
  PolodesOfLink(std::shared_ptr<const Built> built, const Solution& s, int link)
      : built_(std::move(built)),
        link_(link),
        now_(placed(*built_, s, link)),
        plan_(centre_plan_of(*built_)),
        reached_(reached(*built_, moving_point())),
        places_(built_->linkage, built_->steps) {
    const geometry::Arithmetic<Fast> scope;
    const std::vector<There> all = shown_places();
    const geometry::Linkage moving = with_moving_drive(built_->linkage);
    // Where it is now doubles may not tell which lines meet well.
    for (const There& there : all)
      if (!is_found()) plan_ = geometry::centre_plan(moving, there.at);
    if (!is_found())
      throw geometry::Undecided("where the instant centre goes, as no two lines lead to it",
                                "dove va il centro di istantanea rotazione, poiché non vi portano due rette");
    for (const There& there : all) add(there);
  }

  const std::vector<CentreThere>& positions() const { return positions_; }

  geometry::Trace fixed(const Plot& plot, const drawings::Box& room) const { return traced({}, plot, room); }
  geometry::Trace moving(const Plot& plot, const drawings::Box& room) const { return traced(now_, plot, room); }

 private:
  struct There {
    int number;
    geometry::LinkagePosition<Fast> at;
  };
  std::vector<There> shown_places() const {
    const DriveWay way(*built_);
    std::vector<There> all;
    const auto put = [&](int number, const geometry::DriveAt<Fast>& drive) {
      if (const auto at = way.closed_at(drive)) all.push_back({number, *at});
    };
    if (std::holds_alternative<geometry::TurnedLink>(built_->linkage.drives.front())) {
      for (int part = 0; part < shown_directions; ++part) {
        // Within a range at the middles of equal parts: at its ends the mechanism is about to open.
        const double share = (part + (reached_.is_whole() ? 0 : 0.5)) / shown_directions,
                     angle = reached_.is_whole() ? 2 * std::numbers::pi * share
                                                 : reached_.low() + share * (reached_.high() - reached_.low());
        put(part, {0, {std::cos(angle), std::sin(angle)}, 0, places_.turns()});
      }
      return all;
    }
    const double low = way.low(), high = way.high();
    for (int part = 0; part < shown_ways; ++part)
      put(part, DriveWay::at(low + (high - low) * part / (shown_ways - 1)));
    return all;
  }

  geometry::Trace traced(const std::optional<geometry::PlacedLink<double>>& drawn, const Plot& plot,
                         const drawings::Box& room) const {
    geometry::Trace trace =
        places_.polode(plan_, link_, drawn, frame_of(plot, room), curve_tolerance_mm / plot.scale().mm_per_unit);
    reached_.leave_in(trace);
    return trace;
  }
  // The plan may lead to no centre of it: then there are not lines enough.
  bool is_found() const {
    return plan_.permanent_of(0, link_) ||
           std::any_of(plan_.found.begin(), plan_.found.end(),
                       [&](const geometry::FoundCentre& each) { return each.i == 0 && each.j == link_; });
  }
  int moving_point() const {
    const auto& points = built_->linkage.links[index(link_)].points;
    return points.empty() ? std::get<geometry::SlidPoint>(built_->linkage.drives.front()).point
                          : points.front().point;
  }
  void add(const There& there) {
    CentreThere centre{std::to_string(there.number), {}, {}};
    centre.in_plane = place_of(geometry::Centres<Fast>(plan_, built_->linkage, there.at).of(0, link_));
    if (centre.in_plane) {
      const auto& from = there.at.links[index(link_)];
      const Arrow2 v = *centre.in_plane - from.O;
      centre.on_link = now_.at({dot(v, from.x), cross(from.x, v)});
    }
    positions_.push_back(std::move(centre));
  }

  std::shared_ptr<const Built> built_;
  int link_;
  geometry::PlacedLink<double> now_;
  geometry::CentrePlan plan_;
  Reached reached_;
  EveryPlace places_;
  std::vector<CentreThere> positions_;
};

using KeptPolodes = KeptByGivens<PolodesOfLink>;

class PolodesPanel : public Panel {
 public:
  // The built linkage is kept, as the curves are traced when it is known how large.
  PolodesPanel(std::shared_ptr<const Built> built, std::shared_ptr<const PolodesOfLink> polodes, int link,
               std::shared_ptr<const Mechanism> mechanism, std::optional<Place> centre)
      : built_(std::move(built)),
        number_(built_->letters.links[index(link)]),
        mechanism_(std::move(mechanism)),
        polodes_(std::move(polodes)),
        centre_(centre) {}

  double reach() const override { return mechanism_->reach(); }
  bool is_cut() const override { return true; }
  drawings::Box extent(const Scale& lengths, const Scale&) const override {
    Extent extent;
    mechanism_->include(extent, lengths);
    const drawings::Box near = extent.box();
    const drawings::Point middle{(near.low.x + near.high.x) / 2, (near.low.y + near.high.y) / 2};
    const double half = widths / 2 * std::max(near.width(), near.height()), half_high = half / 2;
    return {{middle.x - half, middle.y - std::max(half_high, near.height() / 2)},
            {middle.x + half, middle.y + std::max(half_high, near.height() / 2)}};
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->draw_given(plot); }

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    const geometry::Trace p = polodes_->fixed(plot, room), pi = polodes_->moving(plot, room);
    plot.in_step(Step::curves);
    draw_branches(plot, p, Meaning::locus, "fixed_polode");
    draw_branches(plot, pi, Meaning::second_locus, "moving_polode");
    for (const CentreThere& each : polodes_->positions()) {
      plot.in_step(Step::fixed);
      dot(plot, room, each.number, each.in_plane, Meaning::locus);
      plot.in_step(Step::moving);
      dot(plot, room, each.number + "′", each.on_link, Meaning::second_locus);
    }
    plot.in_step(Step::given);
    mechanism_->draw(plot);
    plot.in_step(Step::curves);
    if (centre_ && is_in(room, plot, *centre_)) {
      plot.cross(*centre_);
      plot.label(letters(), *centre_, middle_of_mechanism(), Meaning::locus);
      plot.measures_coordinates(quantity(), *centre_, {0, 0});
    }
    if (const auto at = middle_of(p, plot, room)) plot.label("$p$", *at, {}, Meaning::locus);
    if (const auto at = middle_of(pi, plot, room)) plot.label("$π$", *at, {}, Meaning::second_locus);
    return told(plot, room, p, pi, language);
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override {
    std::optional<Place> fixed, moving;
    for (const CentreThere& each : polodes_->positions()) {
      if (each.in_plane && is_in(room, plot, *each.in_plane)) fixed = each.in_plane;
      if (each.on_link && is_in(room, plot, *each.on_link)) moving = each.on_link;
    }
    const std::string P = letters();
    return {
        {format_words(
             "In {0} positions of the drive {1} by the lines on which the instant centres lie: points of the fixed "
             "polode $p$.",
             "In {0} posizioni del movente {1} con le rette su cui stanno i centri: punti della polare fissa $p$.",
             polodes_->positions().size(), P),
         fixed},
        {format_words("Each position's link {0} with its {1} on tracing paper, carried back until it covers link {0} "
                      "as it is drawn: {1} marks a point of the moving polode\u00a0$π$.",
                      "Il membro {0} di ogni posizione con il suo {1} su carta da lucido, riportato finché copre il "
                      "membro {0} disegnato: {1} segna un punto della polare mobile\u00a0$π$.",
                      number_, P),
         moving},
        {format_words("The curves through the points. They touch in the {} of now, and roll on each other.",
                      "Le curve per i punti. Si toccano nel {} di ora, e rotolano l'una sull'altra.", P),
         centre_}};
  }

 private:
  struct Step {  // of the construction
    static constexpr int given = 0, fixed = 1, moving = 2, curves = 3;
  };

  std::string letters() const {
    return "$P_{1" + std::string(number_ < 10 ? "" : ",") + std::to_string(number_) + "}$";
  }
  std::string quantity() const { return instant_centre(1, number_).name; }
  Place middle_of_mechanism() const { return mechanism_->at(built_->letters.points.front()); }

  // Of the moving polode with a prime: both have such numbers.
  static void dot(Plot& plot, const drawings::Box& room, const std::string& number, const std::optional<Place>& at,
                  Meaning ink) {
    if (!at || !is_in(room, plot, *at)) return;
    plot.dot(*at, ink);
    plot.small_label(number, *at, {}, ink);
  }

  std::vector<drawings::Block> told(const Plot& plot, const drawings::Box& room, const geometry::Trace& p,
                                    const geometry::Trace& pi, Language language) const {
    std::string off_p, off_pi;
    const auto look_at = [&](const CentreThere& each, const std::optional<Place>& at, std::string& off) {
      if (!at || !is_in(room, plot, *at)) off += (off.empty() ? "" : ", ") + each.number;
    };
    for (const CentreThere& each : polodes_->positions()) {
      look_at(each, each.in_plane, off_p);
      look_at(each, each.on_link, off_pi);
    }
    Words off;
    if (!off_p.empty())
      off = off_p + (off_p == off_pi ? Words{" of $p$ and of $π$", " di $p$ e di $π$"} : Words{" of $p$", " di $p$"});
    if (!off_pi.empty() && off_pi != off_p)
      off = off + (off.empty() ? "" : "; ") + off_pi + Words{" of $π$", " di $π$"};
    std::vector<drawings::Block> all;
    if (!off.empty())
      all.emplace_back(drawings::Paragraph{
          format_words("Off the sheet, or at infinity: {}.", "Fuori del foglio, o all'infinito: {}.", off)
              .in(language)});
    const auto in_mm = [&](const geometry::Trace& t) {
      return figures(t.deviation() * plot.scale().mm_per_unit, 1, language);
    };
    all.emplace_back(drawings::Heading{Words{"The curves", "Le curve"}.in(language)});
    all.emplace_back(drawings::Paragraph{
        format_words(
            "$p$: {} Bezier arcs, at most {} mm from the true curve. $π$: {} arcs, at most {} mm.",
            "$p$: {} archi di Bézier, a non più di {} mm dalla curva vera. $π$: {} archi, a non più di {} mm.",
            p.arcs(), in_mm(p), pi.arcs(), in_mm(pi))
            .in(language)});
    return all;
  }

  std::shared_ptr<const Built> built_;
  int number_;
  std::shared_ptr<const Mechanism> mechanism_;
  std::shared_ptr<const PolodesOfLink> polodes_;
  std::optional<Place> centre_;
};

PanelSheet polode_sheet(const Scene& scene, const Solution& s, std::size_t which, Language language,
                        KeptPolodes& kept) {
  const auto built = std::make_shared<const Built>(scene.built(s.givens()));
  const int link = built->polodes.at(which), number = built->letters.links[index(link)];
  const std::string P = instant_centre(1, number).name;
  PanelSheet sheet;
  sheet.panels =
      panels(PolodesPanel(built, kept.of(s.givens(), [&] { return PolodesOfLink(built, s, link); }), link,
                          std::make_shared<const Mechanism>(figure_of(*built, s).with_open_blocks()), s.point(P)));
  const std::string letters = "$P_{1" + std::string(number < 10 ? "" : ",") + std::to_string(number) + "}$";
  sheet.results = {table({from_origin(*built, language), "$x$ (m)", "$y$ (m)"}, {{letters, {P + "_x", P + "_y"}}})};
  sheet.seen =
      format_words("The fixed and the moving polode of link {}, with its instant centre in several positions",
                   "La polare fissa e la polare mobile del membro {}, con il suo centro in più posizioni", number);
  sheet.told = {P + "_x", P + "_y"};
  return sheet;
}

}  // namespace

std::vector<SheetMaker> polode_sheets(const std::shared_ptr<const Scene>& scene) {
  const Built built = scene->built(Givens(scene->givens()));
  std::vector<SheetMaker> sheets;
  for (std::size_t i = 0; i < built.polodes.size(); ++i) {
    const std::string number = std::to_string(built.letters.links[index(built.polodes[i])]);
    sheets.push_back({{built.polodes.size() == 1 ? "polodes" : "polodes-" + number,
                       format_words("Polodes of link {}", "Polari del membro {}", number)},
                      [scene, i, kept = std::make_shared<KeptPolodes>()](const Solution& s, Language language) {
                        return polode_sheet(*scene, s, i, language, *kept);
                      }});
  }
  return sheets;
}

}  // namespace epure::scenes
