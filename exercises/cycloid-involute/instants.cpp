#include "exercises/cycloid-involute/instants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

constexpr double polygon_share = 0.26;    // of the room's height
constexpr double title_height = 6;        // mm, above a picture
constexpr double bar_height = 15;         // mm: of a bar beside the title
constexpr double longest_velocity = 0.3;  // of a picture's width
constexpr double longest_acceleration = 0.46;
constexpr double longest_of_involute = 0.58;  // whose tangential part is a small one
constexpr double letters_room = 7;            // mm around a point or a vector's tip
constexpr int step_of_polygon = 4;

struct Column {
  drawings::Box picture, polygon;
};
std::array<Column, 2> columns(const drawings::Box& room, LengthScales how) {
  const double above = how == LengthScales::one ? title_height : bar_height;
  const double across = (room.low.x + room.high.x) / 2, down = room.low.y + polygon_share * room.height();
  const auto column = [&](double from, double to) -> Column {
    return {{{from, down}, {to, room.high.y - above}}, {{from, room.low.y}, {to, down}}};
  };
  return {column(room.low.x, across - 1), column(across + 1, room.high.x)};
}

// a = a^n + a^t, the triangle M M' J turned into accelerations.
VectorPolygon polygon_of(const DrawnInstant& at, std::size_t number) {
  const PolygonSide normal{.quantity = at.names("a_n"),
                           .label = "$\\vec{a}^{n}_{M}$",
                           .direction = "∥ $MP_{0}$",
                           .magnitude = "$ω^{2}$·$MM'$",
                           .v = at.a_n};
  const PolygonSide tangential{.quantity = at.names("a_t"),
                               .label = "$\\vec{a}^{t}_{M}$",
                               .direction = "⊥ $MP_{0}$",
                               .magnitude = "$ω^{2}$·$M'J$",
                               .v = at.a_t};
  const PolygonSide sum{
      .quantity = at.names("a_M"), .label = "$\\vec{a}_{M}$", .direction = "?", .magnitude = "?", .v = at.a};
  return {.meaning = Meaning::acceleration,
          .unit = "m/s²",
          .origin = fmt::format("$O_{{{}}}$", number),
          .left = {sum},
          .right = {normal, tangential}};
}

// Two pictures, with everything that is decided about them.
class TwoInstants {
 public:
  TwoInstants(DrawnSheet& onto, const std::vector<const InstantPicture*>& pictures, LengthScales how,
              const SheetRequest& request)
      : onto_(onto),
        pictures_(pictures),
        how_(how),
        request_(request),
        columns_(columns(room_above_scale_bars(request), how)) {
    choose_scales_of_vectors();
    choose_scales_of_lengths();
  }

  void draw() {
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      pictures_[i]->draw(onto_, origin(i), scales(i), columns_[i].picture);
      write_title(i);
      draw_acceleration(i);
    }
    std::vector<Scale> bars{velocities_, accelerations_};
    if (how_ == LengthScales::one) bars.insert(bars.begin(), lengths_.front());
    add_scale_bars(onto_, bars, request_);
    name_scales_of_lengths();
  }

 private:
  double width() const { return columns_.front().picture.width(); }
  InstantPicture::Scales scales(std::size_t i) const { return {lengths_[i], velocities_, accelerations_}; }

  void choose_scales_of_vectors() {
    double fastest = 0, hardest = 0;
    for (const InstantPicture* picture : pictures_) {
      fastest = std::max(fastest, magnitude(picture->at().v));
      hardest = std::max(hardest, magnitude(picture->at().a));
    }
    const auto scale = [&](double share, double longest, const char* unit) {
      return largest_vector_scale(share * width() / (longest > 0 ? longest : 1), unit, request_.language);
    };
    velocities_ = scale(longest_velocity, fastest, "m/s");
    const double share = how_ == LengthScales::one ? longest_acceleration : longest_of_involute;
    accelerations_ = scale(share, hardest, "m/s²");
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      const Scale fitting =
          fit_polygon(polygon_of(pictures_[i]->at(), 1), columns_[i].polygon, request_.language).scale;
      if (fitting.mm_per_unit < accelerations_.mm_per_unit) accelerations_ = fitting;
    }
  }

  void choose_scales_of_lengths() {
    for (std::size_t i = 0; i < pictures_.size(); ++i)
      lengths_.push_back(
          fit_lengths(columns_[i].picture, request_, width() / pictures_[i]->size(), [&](const Scale& scale) {
            return pictures_[i]->extent({scale, velocities_, accelerations_});
          }).scale);
    if (how_ == LengthScales::each_its_own) return;
    const bool first_is_smaller = lengths_[0].mm_per_unit < lengths_[1].mm_per_unit;
    lengths_.assign(2, lengths_[first_is_smaller ? 0 : 1]);
  }

  drawings::Point origin(std::size_t i) const {
    drawings::Box extent = pictures_[i]->extent(scales(i));
    if (how_ == LengthScales::one) {
      const drawings::Box other = pictures_[1 - i]->extent(scales(1 - i));
      const double low = std::min(extent.low.y, other.low.y), high = std::max(extent.high.y, other.high.y);
      // On one level, when both fit there.
      if (high - low <= columns_[i].picture.height()) extent = {{extent.low.x, low}, {extent.high.x, high}};
    }
    return origin_in(columns_[i].picture, extent);
  }

  void write_title(std::size_t i) {
    const drawings::Box& picture = columns_[i].picture;
    constexpr double size_of_letters = 3.5, indent = 2, above = 1, bar_room = 52, bar_down = 8;  // mm
    const double top = room_above_scale_bars(request_).high.y;
    put(drawings::Writing{
        pictures_[i]->title(), {picture.low.x + indent, top - title_height + above}, size_of_letters});
    if (how_ == LengthScales::each_its_own)
      put(bar(lengths_[i], {picture.high.x - bar_room, top - bar_down}, request_.language));
  }

  void draw_acceleration(std::size_t i) {
    const DrawnInstant& at = pictures_[i]->at();
    const drawings::Box& room = columns_[i].polygon;
    if (at.is_at_cusp) {
      draw_sides_of_cusp(onto_, at, accelerations_, room, request_.language);
    } else {
      VectorPolygon polygon = polygon_of(at, i + 1);
      constexpr double room_for_mark = 6;  // mm
      polygon.right.back().square = magnitude(at.a_t) * accelerations_.mm_per_unit > room_for_mark;
      Plot plot(onto_, origin_in(room, extent_of(polygon, accelerations_)), accelerations_);
      draw_polygon(plot, polygon, {.numbered = false});
      constexpr double along_normal = 0.3;
      plot.step(step_of_polygon, {along_normal * at.a_n.x, along_normal * at.a_n.y});
    }
    clip_none();
  }

  // The title block has no room for all: the scales of vectors stand at their bars.
  void name_scales_of_lengths() {
    std::vector<std::string>& captions = onto_.sheet.title_block.scales;
    captions = {lengths_[0].caption};
    if (lengths_[1].caption != lengths_[0].caption) captions.push_back(lengths_[1].caption);
  }

  void put(drawings::Mark mark) {
    onto_.sheet.figure.marks.push_back(std::move(mark));
    clip_none();
  }
  // What has been drawn since the pictures may stand anywhere.
  void clip_none() { onto_.sheet.figure.window_of.resize(onto_.sheet.figure.marks.size(), -1); }

  DrawnSheet& onto_;
  const std::vector<const InstantPicture*>& pictures_;
  LengthScales how_;
  const SheetRequest& request_;
  std::array<Column, 2> columns_;
  Scale velocities_, accelerations_;
  std::vector<Scale> lengths_;
};

}  // namespace

drawings::Box InstantPicture::extent(const Scales& scales) const {
  Extent extent;
  include_bodies(extent, scales.lengths);
  extent.include(scales.lengths, at_.M, letters_room);
  for (const auto& [v, scale] : {std::pair{at_.v, scales.velocities}, std::pair{at_.a, scales.accelerations}}) {
    const double x = scales.lengths.mm_per_unit * at_.M.x + scale.mm_per_unit * v.x;
    const double y = scales.lengths.mm_per_unit * at_.M.y + scale.mm_per_unit * v.y;
    extent.include(x - letters_room / 2, y - letters_room / 2);
    extent.include(x + letters_room / 2, y + letters_room / 2);
  }
  return extent.box();
}

void InstantPicture::draw(DrawnSheet& onto, drawings::Point origin, const Scales& scales,
                          const drawings::Box& window) const {
  drawings::Figure& figure = onto.sheet.figure;
  Plot plot(onto, origin, scales.lengths);
  figure.windows.push_back(window);
  draw_bodies(plot);
  figure.window_of.resize(figure.marks.size(), static_cast<int>(figure.windows.size()) - 1);
  draw_construction(plot);
  if (!at_.is_at_cusp) {
    plot.vectors_at(scales.velocities);
    plot.vector_on(at_.names("v_M"), at_.M, at_.v, Meaning::velocity, "$\\vec{v}_{M}$");
  }
  plot.vectors_at(scales.accelerations);
  plot.vector_on("", at_.M, at_.a, Meaning::acceleration, "$\\vec{a}_{M}$");
  figure.window_of.resize(figure.marks.size(), -1);
}

void draw_two_instants(DrawnSheet& onto, const std::vector<const InstantPicture*>& pictures, LengthScales how,
                       const SheetRequest& request) {
  TwoInstants(onto, pictures, how, request).draw();
}

drawings::Table instants_table(const std::vector<const InstantPicture*>& pictures, Language language) {
  const auto num = [&](double x) { return x == 0 ? "0" : figures(x, 4, language); };
  drawings::Table table{{""}, {}};
  for (const InstantPicture* picture : pictures) table.head.push_back(picture->head());
  const auto row = [&](const std::string& name, const auto& of) {
    std::vector<std::string> cells{name};
    for (const InstantPicture* picture : pictures) cells.push_back(of(picture->at()));
    table.rows.push_back(cells);
  };
  row("$φ$ (rad)", [&](const DrawnInstant& at) { return num(at.phi); });
  row("$v_{M}$ (m/s)", [&](const DrawnInstant& at) { return num(magnitude(at.v)); });
  row("$ρ$ (m)", [&](const DrawnInstant& at) { return num(at.rho); });
  row("$a^{n}_{M}$ (m/s²)", [&](const DrawnInstant& at) { return num(magnitude(at.a_n)); });
  row("$a^{t}_{M}$ (m/s²)",
      [&](const DrawnInstant& at) { return at.is_at_cusp ? "±" + num(at.along_after) : num(at.along_after); });
  row("$a_{M}$ (m/s²)", [&](const DrawnInstant& at) { return num(magnitude(at.a)); });
  return table;
}

}  // namespace epure::cycloid_involute
