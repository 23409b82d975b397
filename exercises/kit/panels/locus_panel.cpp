#include "exercises/kit/panels/locus_panel.h"

#include <algorithm>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/osculating_arc.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr Place plane_origin{0, 0};

void draw_body(Plot& plot, const std::vector<Place>& corners) {
  if (corners.size() > 2)
    plot.polygon(corners, Meaning::construction);
  else
    plot.segment(corners.front(), corners.back(), Meaning::construction);
}

}  // namespace

LocusPanel::LocusPanel(std::shared_ptr<const Mechanism> mechanism, std::string point, std::vector<Position> positions,
                       DrawCurve draw_curve, std::vector<PanelStep> steps)
    : mechanism_(std::move(mechanism)),
      point_(std::move(point)),
      positions_(std::move(positions)),
      draw_curve_(std::move(draw_curve)),
      steps_(std::move(steps)) {}

LocusPanel& LocusPanel::osculated(const std::optional<Place>& centre, const std::string& quantity,
                                  const std::string& letters) {
  centre_ = centre;
  centre_quantity_ = quantity;
  centre_letters_ = letters;
  return *this;
}

void LocusPanel::include_path(Extent& extent, const Scale& scale, double letters) const {
  extent.include(scale, mechanism_->at(point_), letters);
  for (const Position& position : positions_)
    for (const Numbered& point : position.points)
      if (is_on_path(point)) extent.include(scale, point.at, letters);
}

double LocusPanel::size_of_path() const {
  Extent path;
  include_path(path, {.mm_per_unit = 1, .caption = {}, .unit = {}}, 0);
  return std::max(path.box().width(), path.box().height());
}

bool LocusPanel::needs_close_up() const {
  constexpr double small = 0.7;  // of the mechanism
  return size_of_path() < small * mechanism_->reach();
}

// A path that is a point to the eye (of a joint on the frame) is as large as it can be.
double LocusPanel::reach() const {
  constexpr double metre = 1000, longest = 100;  // mm
  const double path = size_of_path();
  return shows_ == Shows::close_up && path > 0 ? std::min(metre / longest * path, mechanism_->reach())
                                               : mechanism_->reach();
}

LocusPanel& LocusPanel::close_up() {
  shows_ = Shows::close_up;
  return *this;
}
LocusPanel& LocusPanel::beside_close_up() {
  shows_ = Shows::whole;
  return *this;
}

drawings::Box LocusPanel::extent(const Scale& scale, const Scale&) const {
  constexpr double letters = 5;  // mm: small ones
  Extent extent;
  if (shows_ == Shows::close_up) {
    include_path(extent, scale, letters);
    return extent.box();
  }
  mechanism_->include(extent, scale);
  for (const Position& position : positions_) {
    for (const Place& corner : position.body) extent.include(scale, corner, 1);
    for (const std::vector<Place>& body : position.others)
      for (const Place& corner : body) extent.include(scale, corner, 1);
    for (const Numbered& point : position.points) extent.include(scale, point.at, letters);
  }
  return extent.box();
}

// Points that the eye cannot tell apart have their numbers together: of a joint that comes by and goes back. The
// path's stand in its close-up, where there is one.
void LocusPanel::draw_positions(Plot& plot) const {
  constexpr double together = 0.8;  // mm
  std::vector<Numbered> all;
  for (const Position& position : positions_) {
    if (shows_ != Shows::close_up) {
      draw_body(plot, position.body);
      for (const std::vector<Place>& body : position.others) draw_body(plot, body);
    }
    for (const Numbered& point : position.points) {
      if (shows_ == Shows::close_up && !is_on_path(point)) continue;
      plot.dot(point.at, point.ink);
      if (shows_ == Shows::whole && is_on_path(point)) continue;
      const auto same = std::find_if(all.begin(), all.end(), [&](const Numbered& other) {
        return other.ink == point.ink && other.series == point.series &&
               distance(other.at, point.at) * plot.scale().mm_per_unit < together;
      });
      if (same == all.end())
        all.push_back(point);
      else if (!point.label.empty())
        same->label += (same->label.empty() ? "" : ", ") + point.label;
    }
  }
  for (const Numbered& point : all)
    if (!point.label.empty()) plot.small_label(point.label, point.at, point.away_from, point.ink);
}

void LocusPanel::draw_point(Plot& plot) const {
  plot.dot(mechanism_->at(point_), Meaning::link);
  plot.label("$" + point_letters(point_) + "$", mechanism_->at(point_));
}

void LocusPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  if (shows_ == Shows::close_up)
    draw_point(plot);
  else
    mechanism_->draw_given(plot);
}

std::vector<drawings::Block> LocusPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  draw_positions(plot);
  const geometry::Trace path = draw_curve_(plot, room);
  const Place& P = mechanism_->at(point_);
  if (shows_ == Shows::close_up)
    draw_point(plot);
  else
    mechanism_->draw(plot);
  plot.measures_coordinates(point_, P, plane_origin);
  if (!shows_centre()) return {};
  const Words sentence =
      format_words("{} Bezier arcs, at most {} mm on this sheet from the true path.",
                   "{} archi di Bézier, su questo foglio a non più di {} mm dalla traiettoria vera.", path.arcs(),
                   figures(path.deviation() * plot.scale().mm_per_unit, 1, language));
  std::vector<drawings::Block> told = draw_osculating(plot, room, language);
  told.emplace_back(drawings::Heading{Words{"The curve", "La curva"}.in(language)});
  told.emplace_back(drawings::Paragraph{sentence.in(language)});
  return told;
}

std::vector<drawings::Block> LocusPanel::draw_osculating(Plot& plot, const drawings::Box& room,
                                                         Language language) const {
  if (!centre_) return {};
  const Place& P = mechanism_->at(point_);
  draw_osculating_arc(plot, P, *centre_);
  if (is_in(room, plot, *centre_)) {
    plot.segment(*centre_, P, Meaning::dimension);
    plot.cross(*centre_);
    plot.label(centre_letters_, *centre_, P, Meaning::locus);
    plot.measures("rho_" + point_, *centre_, P);
    plot.measures_coordinates(centre_quantity_, *centre_, plane_origin);
  } else {
    draw_towards(plot, room, P, *centre_, centre_letters_, language);
  }
  OffSheet off(plot, room);
  off.point(centre_letters_, centre_);
  const std::string sentence = off.sentence(language);
  if (sentence.empty()) return {};
  return {drawings::Paragraph{sentence}};
}

bool LocusPanel::is_centre(const PanelStep& step) const {
  return centre_ && step.at && distance(*step.at, *centre_) == 0;
}

// What leads to the centre stands where it leaves the room; beside a close-up, in that.
std::vector<PanelStep> LocusPanel::steps(const Plot& plot, const drawings::Box& room) const {
  std::vector<PanelStep> all;
  for (PanelStep step : steps_) {
    const bool is_of_path = is_centre(step) || !step.at;
    if ((shows_ == Shows::whole && is_of_path) || (shows_ == Shows::close_up && !is_of_path)) continue;
    if (is_centre(step) && !is_in(room, plot, *centre_))
      step.at = ray_to_edge(plot, room, mechanism_->at(point_), *centre_ - mechanism_->at(point_));
    all.push_back(std::move(step));
  }
  return all;
}

}  // namespace epure
