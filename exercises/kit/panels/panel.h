// A part of a sheet: a picture at a scale of its own, and what the column tells of it. It draws and tells what the
// solution holds, and computes no value.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/plot.h"

namespace epure {

// One step of the construction: what is done, and where its number stands on the picture. A step whose place is off
// the sheet is told to be so; one without a place says what is decided, and has no number.
struct PanelStep {
  Words text;
  std::optional<Place> at = {};
  bool needs_all_others = false;  // numbered after those of all panels, as it begins with what they found
};

// What a ruler reads off the finished sheet, under a heading of its own.
struct MeasuredTable {
  Words heading;
  std::vector<Comparison> rows;
  Words first, second;  // heads of its two columns of values
};

class Panel {
 public:
  virtual ~Panel() = default;

  // The plane it shows: of lengths in metres, or of vectors; a chart or a table shows neither.
  virtual bool is_of_vectors() const { return false; }
  virtual bool has_scale() const { return true; }
  // Its dimensions are written in millimetres: so is its scale bar.
  virtual bool is_in_millimetres() const { return false; }
  // From end to end, in metres: the largest scale of lengths worth trying makes it a metre of paper.
  virtual double reach() const { return 1; }
  // Panels that name the same group here have one scale of lengths.
  virtual std::string scale_group() const { return {}; }

  // The vectors it shows: all panels of a sheet show those of one unit at one scale.
  struct Vectors {
    std::string unit;               // "m/s"; empty: none
    double longest = 0;             // in the unit; 0 when nothing moves
    double longest_on_paper = 150;  // mm: longer they say no more
  };
  virtual Vectors vectors() const { return {}; }
  // A stage of the vectors that another panel shows whole: all stages count as one picture when scales are chosen.
  virtual bool is_stage() const { return false; }
  // Of these it draws arrows that tell directions only, beside polygons that tell how large they are.
  virtual bool shows_directions_only() const { return false; }
  // Of vectors of another unit, at scales that the panel was given: they have their bars.
  virtual std::vector<Scale> own_scales() const { return {}; }

  // Where it has several views, it chooses one for the room that all panels share.
  virtual void choose_view(const drawings::Box& /*whole_room*/, const SheetRequest&) {}
  // What it covers, letters included, in mm from the plane's origin. (`lengths` is meaningless for a plane of
  // vectors.)
  virtual drawings::Box extent(const Scale& lengths, const Scale& vectors) const = 0;
  // Something may lie so far from the rest that it would make it too small (a pole). It is left off the sheet when
  // the panel would have to be drawn more than so many times smaller to show it; 1: there is nothing of the kind.
  virtual double times_smaller() const { return 1; }
  virtual drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const {
    return extent(lengths, vectors);
  }
  // Returns what is to be told of the drawing itself, in the column: how near a curve is to the true one.
  virtual std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const = 0;
  // Its points under letters, of which a crowd in one place needs a close-up; none where its joints tell that.
  virtual std::vector<Place> lettered() const { return {}; }
  // What a student starts from, at the places that it has on the solved sheet: the mechanism in its position, the
  // axes of a chart. Nothing of what is to be found.
  virtual void draw_given(Plot&, const drawings::Box& /*room*/, Language) const {}
  // Where a polygon begins, which the sheet to be solved marks; none: nothing begins anywhere.
  virtual std::optional<Place> start() const { return is_of_vectors() ? std::optional(Place{0, 0}) : std::nullopt; }
  // Whether it may reach beyond its room, and is cut there.
  virtual bool is_cut() const { return false; }
  // Where on the paper the plane's origin lies: what it covers, of all or near, stands in the middle of the room.
  virtual drawings::Point origin(const drawings::Box& room, const drawings::Box& covered, const Scale&) const {
    return origin_in(room, covered);
  }

  virtual std::vector<drawings::VectorEquation> equations() const { return {}; }
  // The angles (0 to pi/2) between lines that the construction crosses: where they are small, the meeting is unsure.
  virtual std::vector<double> crossings() const { return {}; }
  // Where the panel stands tells where a step's number does: at the tip of a vector, at the room's edge.
  virtual std::vector<PanelStep> steps(const Plot&, const drawings::Box& /*room*/) const { return {}; }
  virtual std::optional<MeasuredTable> measured(const Readings&) const { return {}; }
};

using Panels = std::vector<std::unique_ptr<Panel>>;
template <class... Kinds>
Panels panels(Kinds... of) {
  Panels all;
  (all.push_back(std::make_unique<Kinds>(std::move(of))), ...);
  return all;
}

}  // namespace epure
