// A mechanism of which some joints lie so close together, beside others far away, that they are one blot at the scale
// that shows all, or a polygon of which some corners do: a part of its picture is drawn again, larger, in a frame.
// The whole shows the frame too, and within it lines and joints that stand alone: symbols and letters do not shrink.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exercises/kit/panels/layout_search.h"

namespace epure {

class CloseUp : public Panel {
 public:
  // The part of the plane between these corners, drawn to part these points.
  CloseUp(const Panel& whole, const Place& low, const Place& high, std::vector<Place> parted)
      : whole_(whole), low_(low), high_(high), parted_(std::move(parted)) {}

  const Panel& whole() const { return whole_; }
  const std::vector<Place>& parted() const { return parted_; }
  double reach() const override;
  bool is_of_vectors() const override { return whole_.is_of_vectors(); }
  // Of a polygon the close-up has a scale of its own, as that of a mechanism has.
  std::string scale_group() const override { return is_of_vectors() ? "close-up" : ""; }
  Vectors vectors() const override;
  std::optional<Place> start() const override { return {}; }
  bool is_in_millimetres() const override { return whole_.is_in_millimetres(); }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  bool is_cut() const override { return true; }
  // What lies beyond is told of the whole.
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;

 private:
  const Panel& whole_;
  Place low_, high_;
  std::vector<Place> parted_;
};

// The panels as they are laid out, each close-up after the panel that it is of.
struct LaidOut {
  std::vector<std::unique_ptr<CloseUp>> close_ups;
  std::vector<PlacedPanel> panels;
};
LaidOut laid_out_with_close_ups(const Panels& panels, const drawings::Box& room, const SheetRequest& request);

// The close-up of one of the panels; none.
const PlacedPanel* close_up_of(const PlacedPanel& whole, const std::vector<PlacedPanel>& panels);

// What of the whole is seen in its close-up, in the paper's mm where the whole shows it.
drawings::Box seen_in(const PlacedPanel& close_up, const PlacedPanel& whole);

// How many marks, labels and measurements a drawing has.
struct DrawnSoFar {
  explicit DrawnSoFar(const DrawnSheet& onto)
      : marks(onto.sheet.figure.marks.size()),
        labels(onto.sheet.figure.labels.size()),
        measurements(onto.measurements.size()) {}
  std::size_t marks, labels, measurements;
};
// Of what was drawn of the whole since, the symbols, vectors and letters that its close-up shows are taken away; but
// for joints with no other so near that they could not be told apart, and their letters.
void leave_to_close_up(const PlacedPanel& close_up, const PlacedPanel& whole, const DrawnSoFar& before,
                       DrawnSheet& onto);

// Its frame, of the marks of no step; with its scale in the corner, or empty.
void draw_frame(const drawings::Box& frame, const std::string& scale, DrawnSheet& onto);

}  // namespace epure
