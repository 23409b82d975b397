#include "tests/golden/before_and_after.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace epure::golden {
namespace {

using namespace drawings;

constexpr std::size_t in_a_picture = 2;
constexpr double sheet_width = 297, sheet_height = 210, caption = 8, shown = 0.5;
constexpr Colour only_before{0.85, 0, 0, 1}, only_after{0, 0.25, 0.95, 1};

// Half as large, with its lower left corner moved there.
class Reduced {
 public:
  explicit Reduced(Point corner) : corner_(corner) {}

  Primitive operator()(Stroke stroke) const {
    stroke.path = (*this)(std::move(stroke.path));
    stroke.width *= shown;
    for (double& dash : stroke.dashes) dash *= shown;
    stroke.clip = (*this)(stroke.clip);
    stroke.name.clear();
    return stroke;
  }
  Primitive operator()(Fill fill) const {
    fill.path = (*this)(std::move(fill.path));
    fill.clip = (*this)(fill.clip);
    fill.name.clear();
    return fill;
  }
  Primitive operator()(PlacedText text) const {
    text.baseline = (*this)(text.baseline);
    text.size *= shown;
    return text;
  }

 private:
  Point operator()(Point p) const { return {corner_.x + shown * p.x, corner_.y + shown * p.y}; }
  std::optional<Box> operator()(const std::optional<Box>& box) const {
    if (!box) return {};
    return Box{(*this)(box->low), (*this)(box->high)};
  }
  Path operator()(Path path) const {
    path.start = (*this)(path.start);
    for (Piece& piece : path.pieces)
      piece = {piece.straight, (*this)(piece.first_control), (*this)(piece.second_control), (*this)(piece.end)};
    return path;
  }

  Point corner_;
};

// White covers what lies below, and stays white.
void colour(Primitive& primitive, const Colour& colour) {
  const Fill* fill = std::get_if<Fill>(&primitive);
  if (!fill || !(fill->colour == Colour{1, 1, 1, 1}))
    std::visit([&](auto& each) { each.colour = colour; }, primitive);
}

void draw(Page& page, const Lines& lines, const Lines& others, const Colour& only_here, Point corner) {
  std::multiset<std::string> there(others.begin(), others.end());
  for (const std::string& line : lines) {
    auto primitive = primitive_of(line);
    if (!primitive) continue;
    if (const auto same = there.find(line); same != there.end())
      there.erase(same);
    else
      colour(*primitive, only_here);
    page.primitives.push_back(std::visit(Reduced(corner), *primitive));
  }
}

void write(Page& page, const std::string& text, Point at) {
  page.primitives.push_back(PlacedText{.text = text, .baseline = at, .size = 4, .colour = {}});
}

// Five letters that follow from all that changes.
std::string word_of(const std::vector<Change>& changes) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  const auto add = [&hash](const std::string& text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  };
  for (const Change& change : changes) {
    add(change.exercise + '/' + change.sheet + '\n');
    for (const std::string& line : change.after) add(line + '\n');
  }
  const std::string letters = "abcdefghjkmnpqrstuvwxyz";
  std::string word;
  for (int i = 0; i < 5; ++i, hash /= letters.size()) word += letters[hash % letters.size()];
  return word;
}

Picture picture_of(std::vector<Change> changes) {
  const double row = shown * sheet_height + caption, height = static_cast<double>(changes.size()) * row;
  Picture picture{.changes = {}, .word = word_of(changes), .page = {}};
  picture.page.id = "before-and-after";
  picture.page.extent = {{0, 0}, {sheet_width, height}};
  picture.page.is_paper = true;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Change& change = changes[i];
    const double low = height - static_cast<double>(i + 1) * row;
    draw(picture.page, change.before, change.after, only_before, {0, low});
    draw(picture.page, change.after, change.before, only_after, {shown * sheet_width, low});
    const double top = low + shown * sheet_height + 2;
    write(picture.page, change.exercise + "/" + change.sheet + (change.before.empty() ? ": new" : ": before"),
          {3, top});
    write(picture.page, change.after.empty() ? "gone" : "after", {shown * sheet_width + 3, top});
  }
  write(picture.page, picture.word, {sheet_width - 20, height - 6});
  picture.changes = std::move(changes);
  return picture;
}

}  // namespace

std::vector<Picture> pictures_of(const std::vector<Change>& changes) {
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < changes.size(); i += in_a_picture) {
    const auto begin = changes.begin() + static_cast<std::ptrdiff_t>(i);
    const auto count = static_cast<std::ptrdiff_t>(std::min(in_a_picture, changes.size() - i));
    pictures.push_back(picture_of({begin, begin + count}));
  }
  return pictures;
}

}  // namespace epure::golden
