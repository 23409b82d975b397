// A figure of random marks and letters, framed or bare: drawn or refused in a sentence, the same bytes twice, and
// readable by parsers that are not ours.
#include <poppler-document.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>

#include "drawings/output.h"
#include "tests/fuzz/bytes.h"

using namespace epure::drawings;
using epure::tests::Bytes;

namespace {

// Parts of a figure.
class Parts : public Bytes {
 public:
  using Bytes::Bytes;
  // On the paper most of the time, to a tenth of a millimetre.
  double length() {
    static constexpr std::array<double, 8> rare{
        0, -1, 1e-300, 1e5, 9.9e9, 1e300, std::numeric_limits<double>::infinity(), -0.0};
    const std::uint8_t high = byte();
    if (high > 247) return rare[high - 248];
    return (256 * (high % 12) + byte()) / 10.0;
  }
  double angle() { return (byte() - 128) / 20.0; }
  Point point() {
    const double x = length();
    return {x, length()};
  }
  Meaning meaning() { return static_cast<Meaning>(byte() % (static_cast<int>(Meaning::text) + 1)); }
  std::string text() {
    static const std::array<std::string, 8> all{"",         "$P_{0}$", "$\\vec{v}_{BA}$ ⊥ BA", "1", "$ω_{3}$", "A′",
                                                "so, said", "€"};
    return all[byte() % all.size()];
  }
  Path path() {
    Path path{point(), {}, byte() % 2 == 0};
    for (int pieces = byte() % 5; pieces > 0; --pieces) {
      const bool straight = byte() % 2 == 0;
      path.pieces.push_back({straight, straight ? Point{} : point(), straight ? Point{} : point(), point()});
    }
    return path;
  }
};

Mark mark(Parts& in) {
  switch (in.byte() % 16) {
    case 0:
      return Line{in.path(), in.meaning(), in.text(), static_cast<LineType>(in.byte() % 5)};
    case 1:
      return Area{in.path(), in.meaning()};
    case 2:
      return Arrow{in.point(), in.point(), in.meaning(), "v_B"};
    case 3:
      return Dot{in.point(), in.meaning()};
    case 4:
      return Cross{in.point(), in.meaning()};
    case 5:
      return DataPoint{in.point(), static_cast<PointShape>(in.byte() % 7), in.meaning()};
    case 6:
      return Hinge{in.point()};
    case 7:
      return FixedHinge{in.point(), in.angle()};
    case 8:
      return Slider{in.point(), in.angle()};
    case 9:
      return Guide{in.point(), in.point()};
    case 10:
      return Slot{in.point(), in.point(), in.length()};
    case 11:
      return Rotation{in.point(), in.length(), in.angle(), in.angle(), in.meaning()};
    case 12:
      return RightAngle{in.point(), in.angle(), in.angle()};
    case 13:
      return AngleMark{in.point(), in.length(), in.angle(), in.angle(), in.meaning()};
    case 14:
      return Dimension{in.point(), in.point(), in.length(), in.text()};
    default:
      return Ground{in.point(), in.point()};
  }
}

Sheet sheet(Parts& in) {
  Sheet sheet;
  sheet.id = "f";
  sheet.bare = in.byte() % 2 == 0;
  while (in.has_more()) {
    const int kind = in.byte() % 6;
    if (kind == 0)
      sheet.figure.labels.push_back({in.text(), in.point(), in.point(), in.meaning()});
    else if (kind == 1)
      sheet.figure.labels.push_back({in.text(), in.point(), {}, in.meaning(), in.point()});
    else if (kind == 2)
      sheet.figure.steps.push_back({static_cast<int>(sheet.figure.steps.size()) + 1, in.point()});
    else
      sheet.figure.marks.push_back(mark(in));
  }
  return sheet;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 400;
  if (count > most) return 0;
  Parts in(bytes, count);
  const Sheet drawn = sheet(in);
  try {
    const std::string as_svg = svg(drawn), as_pdf = pdf({drawn}, "f");
    if (as_svg != svg(drawn) || as_pdf != pdf({drawn}, "f")) std::abort();
    if (!pugi::xml_document().load_buffer(as_svg.data(), as_svg.size())) std::abort();
    const std::unique_ptr<poppler::document> read(
        poppler::document::load_from_raw_data(as_pdf.data(), static_cast<int>(as_pdf.size())));
    if (!read || read->pages() != 1) std::abort();
  } catch (const std::invalid_argument& not_finite) {
    if (std::string(not_finite.what()).empty()) std::abort();
  } catch (const TooFar& too_far) {
    if (too_far.words().english.empty() || too_far.words().italian.empty()) std::abort();
  }
  return 0;
}
