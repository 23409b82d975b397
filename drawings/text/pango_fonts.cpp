#include "drawings/text/pango_fonts.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <fmt/format.h>

#include <latch>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "drawings/output.h"
#include "drawings/stopwatch.h"
#include "drawings/text/font_folder.h"

namespace epure::drawings {
namespace {

struct Shipped {
  const char *file, *family;
  PangoStyle style;
  PangoWeight weight;
};
// In the order of Face.
constexpr std::array<Shipped, 4> shipped{{
    {"STIXTwoText-Regular.otf", "STIX Two Text", PANGO_STYLE_NORMAL, PANGO_WEIGHT_NORMAL},
    {"STIXTwoText-Italic.otf", "STIX Two Text", PANGO_STYLE_ITALIC, PANGO_WEIGHT_NORMAL},
    {"STIXTwoText-Bold.otf", "STIX Two Text", PANGO_STYLE_NORMAL, PANGO_WEIGHT_BOLD},
    {"STIXTwoMath-Regular.otf", "STIX Two Math", PANGO_STYLE_NORMAL, PANGO_WEIGHT_NORMAL},
}};

using Description = Held<PangoFontDescription, pango_font_description_free>;

void add_files(FcConfig* known, const std::filesystem::path& folder) {
  for (const Shipped& font : shipped) {
    const std::string path = (folder / font.file).string();
    if (!FcConfigAppFontAddFile(known, reinterpret_cast<const FcChar8*>(path.c_str())))
      throw Unavailable(fmt::format("the font {} is missing or cannot be read", path),
                        fmt::format("il carattere {} manca o non si può leggere", path));
  }
}

// Pango never says that it has no such font: it gives the nearest it knows. So what came is asked for its name.
PangoFont* load(PangoContext* context, const Shipped& wanted) {
  const Description description(pango_font_description_new());
  pango_font_description_set_family_static(description.get(), wanted.family);
  pango_font_description_set_style(description.get(), wanted.style);
  pango_font_description_set_weight(description.get(), wanted.weight);
  pango_font_description_set_absolute_size(description.get(), units_per_em * PANGO_SCALE);
  Held<PangoFont, g_object_unref> font(pango_context_load_font(context, description.get()));
  if (!font)
    throw Unavailable(fmt::format("Pango cannot open the font of {}", wanted.file),
                      fmt::format("Pango non riesce ad aprire il carattere di {}", wanted.file));

  const Description came(pango_font_describe_with_absolute_size(font.get()));
  const bool is_it = std::string_view(pango_font_description_get_family(came.get())) == wanted.family &&
                     pango_font_description_get_style(came.get()) == wanted.style &&
                     pango_font_description_get_weight(came.get()) == wanted.weight;
  if (!is_it) {
    const Held<char, g_free> name(pango_font_description_to_string(came.get()));
    throw Unavailable(
        fmt::format("{} does not hold its font: Pango found {} instead", wanted.file, name.get()),
        fmt::format("{} non contiene il suo carattere: Pango ha trovato invece {}", wanted.file, name.get()));
  }
  hb_face_t* const face = hb_font_get_face(pango_font_get_hb_font(font.get()));
  // Of a file that was there but could not be opened again HarfBuzz makes a face without any glyph.
  if (hb_face_get_glyph_count(face) == 0)
    throw Unavailable(fmt::format("the font {} cannot be read", wanted.file),
                      fmt::format("il carattere {} non si può leggere", wanted.file));
  if (hb_face_get_upem(face) != static_cast<unsigned>(units_per_em))
    throw Unavailable(fmt::format("{} is drawn in other units than {} to the em", wanted.file, units_per_em),
                      fmt::format("{} è disegnato in unità diverse da {} per em", wanted.file, units_per_em));
  return font.release();
}

// Threads want room for their stacks. Where nothing limits it they are not tried: that costs a hundredth of a sheet.
bool is_room_limited() {
  rlimit room = {}, processes = {};
  getrlimit(RLIMIT_AS, &room);
  getrlimit(RLIMIT_NPROC, &processes);
  return room.rlim_cur != RLIM_INFINITY || processes.rlim_cur < 100;
}

// Pango looks for fonts in threads of its own, four at once, and GLib ends the program where one cannot be had, or no
// memory. Drawing all that there is was seen to take 250 MB of addresses beyond those it starts with.
void demand_room() {
  constexpr std::size_t room = 320u << 20;
  void* const all_of_it = mmap(nullptr, room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all_of_it == MAP_FAILED) throw std::bad_alloc();
  munmap(all_of_it, room);
  std::latch go(1);
  std::vector<std::jthread> threads;
  bool all = true;
  try {
    while (threads.size() < 4) threads.emplace_back([&go] { go.wait(); });
  } catch (const std::system_error&) {
    all = false;
  }
  go.count_down();
  if (!all)
    throw Unavailable("too few threads can be had: the fonts need four",
                      "si possono avere troppo pochi thread: i caratteri ne vogliono quattro");
}

}  // namespace

KnownFonts::KnownFonts(const std::filesystem::path& folder) : known_(FcConfigCreate()) {
  add_files(known_.get(), folder);
  // Pango asks fontconfig for the configuration of the machine even when it is given another: that would look through
  // every font there is, and write a cache. Ours takes its place.
  if (!FcConfigSetCurrent(known_.get())) throw std::bad_alloc();
}

PangoFonts::PangoFonts(const KnownFonts& known) : context_(unhinted_context(known.get())) {
  // Set, or it would be the language of the machine.
  pango_context_set_language(context_.get(), pango_language_from_string("en"));
  for (std::size_t i = 0; i < shipped.size(); ++i) fonts_.at(i).reset(load(context_.get(), shipped.at(i)));
}

const PangoFonts& pango_fonts() {
  static const KnownFonts known = [] {
    const Timed timed(Work::fonts);
    if (is_room_limited()) demand_room();
    return KnownFonts(font_folder());
  }();
  thread_local const PangoFonts fonts = [] {
    const Timed timed(Work::fonts);
    return PangoFonts(known);
  }();
  return fonts;
}

}  // namespace epure::drawings
