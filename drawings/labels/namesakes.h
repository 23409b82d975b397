// What letters name on a figure, and what else of its kind they could be taken to name.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "drawings/labels/labels.h"

namespace epure::drawings {

class Namesakes {
 public:
  // Of the marks as far as they show, in their window and in `area`, and of the points that labels are given.
  Namesakes(const Figure& figure, const std::vector<Label>& labels, Box area);

  // A label of a segment names the vector or line it lies on, one of a point what is drawn there, or else the line
  // or the arc through it. The others are the vectors or lines of that meaning, or points, as far as letters `width`
  // mm wide beside their own can come near them; none of them is what the eye cannot tell from its own, nor a line
  // through its point. Where a shorter vector lies along another, that one is what goes on beyond it.
  Naming of(const Label& label, double width) const;

 private:
  // `seen`: as far as it shows, and beyond what is shorter along it.
  struct Shown {
    Segment whole, seen;
    Meaning meaning = Meaning::text;
  };
  using Kind = std::vector<Shown>;
  static Segment clear_of_shorter(const Kind& vectors, const Shown& vector);
  static void add(Kind& kind, Point from, Point to, Meaning meaning, Box window);
  static const Shown* on_one(const Kind& kind, Point at, Point to);
  static void add_others(Naming& naming, const Kind& kind, const Label& label, const Shown& own, double reach);

  // Those, of one meaning or of all, that pass a point near enough to lie between it and its letters.
  static void add_passing(Naming& naming, const Kind& kind, std::optional<Meaning> of, Point at, double reach);

  // Of angles and senses of turning: by their chords.
  struct Arc {
    Point centre;
    double radius, from, to;
  };
  static bool is_on(const Arc& arc, Point at);
  // What letters at a point of an arc name, and the other arcs near it. Whether there is one.
  bool add_arcs(Naming& naming, Point at, double reach) const;

  Kind vectors_, lines_, points_, labelled_points_;
  std::vector<Arc> arcs_;
};

}  // namespace epure::drawings
