#include "exercises/cli/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/request.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

using drawings::Background;
using drawings::Colour;
using drawings::Inks;

// In millimetres. `option`: which of the two.
double size_asked(const char* option, const std::string& typed, const Options& options) {
  constexpr int largest = 1000;
  Rational size = 0;
  try {
    size = geometry::parse_given(typed, "mm");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage(format_words("{}: {}", "{}: {}", option, unreadable.words()));
  }
  const bool is_positive = size > 0, is_on_paper = size <= largest;
  if (!is_positive || !is_on_paper)
    throw WrongUsage(format_words("{} {}: must be positive and at most {} mm",
                                  "{} {}: dev'essere positiva e al massimo {} mm", option, typed, largest));
  if (options.scale)
    throw WrongUsage(format_words("{} chooses the scale, and --scale names it; choose one of them",
                                  "{} sceglie la scala, e --scale la nomina; scegliere una delle due", option));
  return CGAL::to_double(size);
}

double dots_asked(const std::string& typed, const Options& options) {
  constexpr int fewest = 20, most = 1200;
  if (!is_asked_for(Format::png, options))
    throw WrongUsage("--dpi is for pictures of pixels; add --format png",
                     "--dpi è per le immagini a punti; aggiungere --format png");
  Rational dots = 0;
  try {
    dots = geometry::parse_given(typed, "1");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage("--dpi: " + unreadable.words());
  }
  if (!(dots >= fewest && dots <= most))
    throw WrongUsage(format_words("--dpi {}: must lie between {} and {}", "--dpi {}: dev'essere tra {} e {}", typed,
                                  fewest, most));
  return CGAL::to_double(dots);
}

// "#1e1e2e"
std::optional<Colour> colour_of_digits(const std::string& text) {
  if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdef", 1) != std::string::npos)
    return {};
  const auto part = [&](std::size_t at) { return std::stoi(text.substr(at, 2), nullptr, 16) / 255.0; };
  return Colour{part(1), part(3), part(5), 1};
}

// None: no ground is painted.
std::optional<Colour> background_asked(const std::string& typed) {
  const std::string name = lower_case(typed);
  if (name == "none") return {};
  if (name == "white") return Colour{1, 1, 1, 1};
  if (const auto colour = colour_of_digits(name)) return colour;
  throw WrongUsage(format_words("--background {}: write white, none or a colour such as #1e1e2e",
                                "--background {}: scrivere white, none o un colore come #1e1e2e", typed));
}

Inks inks_asked(const std::string& typed) {
  const std::string name = lower_case(typed);
  if (name == "dark") return Inks::dark;
  if (name == "light") return Inks::light;
  throw WrongUsage(format_words("--ink {}: choose dark or light", "--ink {}: scegliere dark o light", typed));
}

void demand_legible(const Background& background, const Options& options) {
  if (!background.colour) return;
  const bool is_dark = background.inks == Inks::dark;
  const double found = drawings::contrast(*background.colour, is_dark ? Colour{0, 0, 0, 1} : Colour{1, 1, 1, 1});
  if (found >= drawings::legible) return;
  throw WrongUsage(format_words(
      "--ink {} cannot be read on --background {}: its contrast there is at most {}, and letters need {}; choose "
      "--ink {}",
      "--ink {} non si legge su --background {}: il contrasto è al massimo {}, e le lettere ne vogliono {}; "
      "scegliere "
      "--ink {}",
      *options.document.ink, options.document.background.value_or("white"), decimal(fmt::format("{:.1f}", found)),
      decimal(fmt::format("{}", drawings::legible)), is_dark ? "light" : "dark"));
}

std::optional<Background> background_of(const Options& options) {
  const DocumentOptions& asked = options.document;
  if (!asked.background && !asked.ink) return {};
  Background background;
  if (asked.ink) background.inks = inks_asked(*asked.ink);
  if (asked.background) {
    background.colour = background_asked(*asked.background);
    if (background.colour && !asked.ink) background.inks = drawings::inks_for(*background.colour);
  } else if (!is_bare(options)) {  // a sheet is paper
    background.colour = background.inks == Inks::light ? drawings::dark_background : Colour{1, 1, 1, 1};
  }
  demand_legible(background, options);
  return background;
}

}  // namespace

bool is_bare(const Options& options) {
  return options.bare || options.document.width || options.document.height || is_asked_for(Format::tex, options);
}

Looks looks_asked(const Options& options) {
  Looks looks{.background = background_of(options)};
  if (const auto& width = options.document.width) looks.size.width = size_asked("--width", *width, options);
  if (const auto& height = options.document.height) looks.size.height = size_asked("--height", *height, options);
  if (const auto& dots = options.document.dpi) looks.dots_per_inch = dots_asked(*dots, options);
  return looks;
}

void demand_paintable(const drawings::Page& page, double dots_per_inch) {
  const drawings::Pixels size = drawings::pixels(page, dots_per_inch);
  if (size.width <= drawings::most_pixels / size.height) return;
  const double would_do =
      dots_per_inch * std::sqrt(static_cast<double>(drawings::most_pixels) /
                                (static_cast<double>(size.width) * static_cast<double>(size.height)));
  throw WrongUsage(
      format_words("{} at {} dpi has {} x {} pixels, and epure paints at most {} million; --dpi {} would do",
                   "{} a {} dpi ha {} x {} punti, ed epure ne dipinge al massimo {} milioni; andrebbe bene --dpi {}",
                   page.id, decimal(fmt::format("{}", dots_per_inch)), size.width, size.height,
                   drawings::most_pixels / 1'000'000, std::floor(would_do)));
}

}  // namespace epure
