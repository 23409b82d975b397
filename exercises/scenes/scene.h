// A mechanism from a file: its links as plates with letters, its givens, what drives it, on which side its joints
// lie. docs/scenes.md teaches the format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exercises/kit/statement/description.h"
#include "exercises/scenes/file/formula.h"
#include "exercises/scenes/file/text_tree.h"
#include "geometry/linkages/assur_groups.h"
#include "geometry/linkages/loads.h"

namespace epure::scenes {

// The numbers of points, lines and links as places in lists.
inline std::size_t index(int number) { return static_cast<std::size_t>(number); }

// The letters of a linkage, in the order of its numbers.
struct Letters {
  std::vector<std::string> points, lines;
  std::vector<int> links;  // as the file numbers them; the frame, 1, first
};

// How far a point is left of a line, under a name.
struct PointOffset {
  std::string name;
  int point, line;
};

// What a load is called: after the given that it is, or after where it acts.
struct LoadName {
  std::string name;       // "F", "Q_P"
  std::string symbol;     // "$F$", rich text
  bool is_given;          // and so not reported
  std::string direction;  // of a force: as a side of a polygon has it (polygon_picture.h)
};

// The weight and the inertia of a link.
struct MassName {
  std::string mass, inertia;  // letters of the givens that they are, rich text: "$\\it{m}$"; or "$m_{3}$", "$J_{3}$"
};

// How much friction there is, as the file has it.
struct FrictionName {
  Words amount;  // "0.15", "8°", or letters of the given that it is: "$\\it{f}$"
};

// A linkage at certain givens, and the order in which it is constructed.
struct Built {
  geometry::Linkage linkage;
  std::vector<geometry::Step> steps;
  Letters letters;
  std::vector<PointOffset> offsets = {};
  std::vector<int> paths = {};                                // the points whose paths are asked for
  std::vector<int> polodes = {};                              // the links whose polodes are
  std::optional<geometry::Loads> loads = {};                  // where forces are asked for
  std::vector<LoadName> force_names = {}, couple_names = {};  // as the loads
  std::vector<MassName> mass_names = {};                      // as their masses
  std::vector<FrictionName> friction_names = {};              // as the frictions
  std::vector<FrictionName> hinge_friction_names = {};        // as those of hinges
  std::vector<Words> pressure_angles = {};  // of the linkage's gears: "20°", or the given's letters
  std::string gravity = {};                 // its letters; empty: nothing weighs
  std::vector<Words> in_place = {};  // numbers that are no givens: "$m_{3}$ = 1.2 kg", "speed of link 2 = 60 rpm"
};

// The link's point at this place of its own axes; none: `nothing`.
inline int point_at(const Built& built, int link, const geometry::Own& at) {
  for (const geometry::LinkPoint& p : built.linkage.links[index(link)].points)
    if (p.at.x == at.x && p.at.y == at.y) return p.point;
  return geometry::nothing;
}

class Scene {
 public:
  // Reads all of it, and builds it once at the stated givens. Throws BadScene. `file` is the name that messages give
  // it.
  Scene(std::string file, std::string_view bytes);

  const std::string& id() const { return id_; }
  const Words& title() const { return title_; }
  const Words& source() const { return source_; }
  const std::vector<GivenSpec>& givens() const { return givens_; }

  // Those of the sheets that the file asks for, in its order; all where it does not say. Throws BadScene for a name
  // that is none of them.
  std::vector<std::size_t> chosen_sheets(const std::vector<std::string>& names) const;

  // Throws BadScene where two of all that is found have one name.
  void demand_one_meaning(const std::vector<Quantity>& quantities) const;

  // The numbers that a book printed, and where.
  const std::vector<Printed>& printed() const { return printed_; }
  // Throws BadScene where one of them is of none of these quantities, or in a unit of something else.
  void demand_printed(const std::vector<Quantity>& quantities) const;

  // The quantities that are asked for over all places of the drive, chart by chart; what extremes are asked of has
  // its chart.
  const std::vector<std::vector<std::string>>& charts() const { return charts_; }
  // Throws BadScene where one of them is none of these, or two of a chart have different units.
  void demand_charts(const std::vector<Quantity>& quantities) const;

  // The quantities whose greatest and least over a turn of the drive are asked for.
  const std::vector<std::string>& extremes() const { return extremes_; }

  // At these givens. Throws BadScene where they make a length zero, or a formula divide by zero.
  Built built(const Givens& givens) const;

 private:
  std::string file_;
  TextTree root_;
  std::string id_;
  Words title_, source_;
  std::vector<GivenSpec> givens_;
  std::vector<Printed> printed_;
  std::vector<std::vector<std::string>> charts_;
  std::vector<std::string> extremes_;
};

}  // namespace epure::scenes
