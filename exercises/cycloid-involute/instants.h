// A sheet with two instants side by side: each above in its place, below the polygon of its acceleration, or at a
// cusp the acceleration just before and just after.
#pragma once

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/fit.h"

namespace epure::cycloid_involute {

// One instant as it is drawn in its place.
class InstantPicture {
 public:
  // `head` names the instant in a table, `title` above the picture; both rich text.
  InstantPicture(DrawnInstant at, std::string head, std::string title)
      : at_(std::move(at)), head_(std::move(head)), title_(std::move(title)) {}
  virtual ~InstantPicture() = default;

  // At a scale of lengths and one of velocities and accelerations each.
  struct Scales {
    Scale lengths, velocities, accelerations;
  };
  drawings::Box extent(const Scales& scales) const;
  void draw(DrawnSheet& onto, drawings::Point origin, const Scales& scales, const drawings::Box& window) const;

  const DrawnInstant& at() const { return at_; }
  const std::string& head() const { return head_; }
  const std::string& title() const { return title_; }
  // A length that the picture is some times as large as.
  virtual double size() const = 0;

 protected:
  // Bodies and path, below the points and vectors.
  virtual void draw_bodies(Plot& plot) const = 0;
  virtual void include_bodies(Extent& extent, const Scale& scale) const = 0;
  // Points and lines of the construction, with the numbers of the steps 1 to 3.
  virtual void draw_construction(Plot& plot) const = 0;

 private:
  DrawnInstant at_;
  std::string head_, title_;
};

// With one scale of lengths the pictures stand on one level.
enum class LengthScales { one, each_its_own };
void draw_two_instants(DrawnSheet& onto, const std::vector<const InstantPicture*>& pictures, LengthScales how,
                       const SheetRequest& request);

// Below an instant at a cusp.
void draw_sides_of_cusp(DrawnSheet& onto, const DrawnInstant& at, const Scale& accelerations,
                        const drawings::Box& room, Language language);

// v, a and its parts, ρ, instant by instant.
drawings::Table instants_table(const std::vector<const InstantPicture*>& pictures, Language language);

}  // namespace epure::cycloid_involute
