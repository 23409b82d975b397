// The floor: a program that does nothing but make recorded calls of Cairo and Pango (drawings/recording.h) and write
// the two files. `epure bench` holds `epure draw` against it.
//   epure-floor RECORDING FOLDER_OF_FONTS FILE.pdf FILE.svg
// It shares no code with the rest, shapes each run of letters once for both files, and leaves the SVG as Cairo made
// it. The fonts are opened and the files are written in the way `epure draw` must do it: fonts by name from a folder,
// files whole or not at all. Exit 0, or 1 with a sentence.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fcntl.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double em = 1000;  // at which letters are shaped

void demand(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

std::string contents(const char* path) {
  std::ifstream in(path, std::ios::binary);
  demand(in.good(), "the recording cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

class Fonts {
 public:
  explicit Fonts(const std::string& folder) {
    FcConfig* known = FcConfigCreate();
    for (const char* file :
         {"STIXTwoText-Regular", "STIXTwoText-Italic", "STIXTwoText-Bold", "STIXTwoMath-Regular"}) {
      const std::string path = folder + "/" + file + ".otf";
      demand(FcConfigAppFontAddFile(known, reinterpret_cast<const FcChar8*>(path.c_str())) != 0, "a font is missing");
    }
    FcConfigSetCurrent(known);
    PangoFontMap* map = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
    pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map), known);
    PangoContext* context = pango_font_map_create_context(map);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context, options);
    pango_context_set_language(context, pango_language_from_string("en"));
    for (std::size_t i = 0; i < names_.size(); ++i) {
      PangoFontDescription* wanted = pango_font_description_from_string(names_[i]);
      pango_font_description_set_absolute_size(wanted, em * PANGO_SCALE);
      fonts_[i] = pango_context_load_font(context, wanted);
      demand(fonts_[i] != nullptr, "a font cannot be opened");
      pango_font_description_free(wanted);
    }
  }
  PangoFont* operator[](std::size_t face) const { return fonts_.at(face); }

 private:
  static constexpr std::array<const char*, 4> names_{"STIX Two Text", "STIX Two Text Italic", "STIX Two Text Bold",
                                                     "STIX Two Math"};
  std::array<PangoFont*, 4> fonts_{};
};

// A run of letters, shaped; the glyphs stand from (0, 0) on, in parts of the size of the letters.
struct Run {
  std::string letters;
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
};

Run shape(PangoFont* font, std::string letters) {
  PangoAnalysis analysis{};
  analysis.font = font;
  analysis.script = PANGO_SCRIPT_LATIN;
  analysis.language = pango_language_from_string("en");
  PangoGlyphString* shaped = pango_glyph_string_new();
  const int length = static_cast<int>(letters.size());
  pango_shape_full(letters.data(), length, letters.data(), length, &analysis, shaped);
  Run run{std::move(letters), {}, {}};
  double pen = 0;
  for (int i = 0; i < shaped->num_glyphs; ++i) {
    const PangoGlyphInfo& glyph = shaped->glyphs[i];
    const auto part = [](int units) { return units / (em * PANGO_SCALE); };
    run.glyphs.push_back({glyph.glyph, pen + part(glyph.geometry.x_offset), part(glyph.geometry.y_offset)});
    pen += part(glyph.geometry.width);
    const int next = i + 1 < shaped->num_glyphs ? shaped->log_clusters[i + 1] : length;
    run.clusters.push_back({next - shaped->log_clusters[i], 1});
  }
  pango_glyph_string_free(shaped);
  return run;
}

class Replay {
 public:
  Replay(const std::string& calls, const Fonts& fonts) : calls_(calls), fonts_(fonts) {}

  // On a PDF each page begins a page of its size; the first page's size is that of an SVG.
  void on(cairo_surface_t* surface, bool is_pdf) {
    cr_ = nullptr;
    std::size_t text = 0;
    for (at_ = 0; at_ < calls_.size();) {
      const char call = calls_[at_++];
      if (call == 'p') {
        const double width = number(), height = number();
        if (cr_) cairo_show_page(cr_);
        if (is_pdf) cairo_pdf_surface_set_size(surface, width, height);
        if (!cr_) open(surface);
      } else if (call == 't') {
        show(text++);
      } else {
        draw(call);
      }
    }
    cairo_show_page(cr_);
    demand(cairo_status(cr_) == CAIRO_STATUS_SUCCESS, "Cairo failed");
    cairo_destroy(cr_);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
  }

  std::array<double, 2> size() {
    at_ = 1;
    const double width = number();
    return {width, number()};
  }

 private:
  void open(cairo_surface_t* surface) {
    cr_ = cairo_create(surface);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cr_, options);
    cairo_font_options_destroy(options);
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
  }

  double number() {
    double value = 0;
    std::memcpy(&value, calls_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  template <std::size_t count>
  std::array<double, count> numbers() {
    std::array<double, count> values{};
    for (double& value : values) value = number();
    return values;
  }

  void draw(char call) {
    switch (call) {
      case '(':
        return cairo_save(cr_);
      case ')':
        return cairo_restore(cr_);
      case 'n':
        return cairo_new_path(cr_);
      case 'z':
        return cairo_close_path(cr_);
      case 'k':
        return cairo_clip(cr_);
      case 'S':
        return cairo_stroke(cr_);
      case 'F':
        return cairo_fill(cr_);
      case 'w':
        return cairo_set_line_width(cr_, number());
      case 'd':
        return dash();
      case 'm': {
        const auto [x, y] = numbers<2>();
        return cairo_move_to(cr_, x, y);
      }
      case 'l': {
        const auto [x, y] = numbers<2>();
        return cairo_line_to(cr_, x, y);
      }
      case 'c': {
        const auto [ax, ay, bx, by, x, y] = numbers<6>();
        return cairo_curve_to(cr_, ax, ay, bx, by, x, y);
      }
      case 'i': {
        const auto [red, green, blue, opacity] = numbers<4>();
        return cairo_set_source_rgba(cr_, red, green, blue, opacity);
      }
      default:
        throw std::runtime_error("a call that is none");
    }
  }

  void dash() {
    std::vector<double> dashes(static_cast<std::size_t>(number()));
    for (double& length : dashes) length = number();
    cairo_set_dash(cr_, dashes.data(), static_cast<int>(dashes.size()), 0);
  }

  // Text number `index` of the recording: shaped when it is met first.
  void show(std::size_t index) {
    const auto [face, size, x, y, bytes] = numbers<5>();
    const auto length = static_cast<std::size_t>(bytes);
    PangoFont* font = fonts_[static_cast<std::size_t>(face)];
    if (index == runs_.size()) runs_.push_back(shape(font, calls_.substr(at_, length)));
    at_ += length;
    const Run& run = runs_.at(index);
    std::vector<cairo_glyph_t> glyphs = run.glyphs;
    for (cairo_glyph_t& glyph : glyphs) glyph = {glyph.index, x + size * glyph.x, y + size * glyph.y};
    cairo_scaled_font_t* scaled = pango_cairo_font_get_scaled_font(PANGO_CAIRO_FONT(font));
    cairo_set_font_face(cr_, cairo_scaled_font_get_font_face(scaled));
    cairo_set_font_size(cr_, size);
    cairo_show_text_glyphs(cr_, run.letters.data(), static_cast<int>(run.letters.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), run.clusters.data(),
                           static_cast<int>(run.clusters.size()), cairo_text_cluster_flags_t{});
  }

  const std::string& calls_;
  const Fonts& fonts_;
  std::size_t at_ = 0;
  cairo_t* cr_ = nullptr;
  std::vector<Run> runs_;
};

cairo_status_t keep(void* memory, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(memory)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void sync_folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  const int folder = ::open(slash == path.npos ? "." : path.substr(0, slash).c_str(), O_RDONLY | O_DIRECTORY);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void write_whole(const std::string& path, const std::string& bytes) {
  const std::string draft = path + ".part";
  const int file = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  demand(file >= 0 && ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()) &&
             ::fsync(file) == 0 && ::close(file) == 0 && std::rename(draft.c_str(), path.c_str()) == 0,
         "a file cannot be written");
  sync_folder_of(path);
}

void run(const char* recording, const char* folder_of_fonts, const char* pdf_path, const char* svg_path) {
  const std::string calls = contents(recording);
  const Fonts fonts(folder_of_fonts);
  Replay replay(calls, fonts);
  std::string pdf, svg;
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(keep, &pdf, 72, 72);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "none");
  replay.on(surface, true);
  const auto [width, height] = replay.size();
  replay.on(cairo_svg_surface_create_for_stream(keep, &svg, width, height), false);
  write_whole(pdf_path, pdf);
  write_whole(svg_path, svg);
}

}  // namespace

int main(int count, char** words) {
  try {
    demand(count == 5, "usage: epure-floor RECORDING FOLDER_OF_FONTS FILE.pdf FILE.svg");
    run(words[1], words[2], words[3], words[4]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "epure-floor: %s\n", error.what());
    return 1;
  }
}
