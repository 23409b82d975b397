// The floor: a program that does nothing but make recorded calls of Cairo and Pango (bench/recording.h) and write
// the two files. `epure bench` holds `epure draw` against it.
//   epure-floor RECORDING FOLDER_OF_FONTS FILE.pdf FILE.svg
// It shares no code with the rest and shapes each run of letters once for both files. The PDF is Cairo's, the SVG is
// written plainly, with the outlines that Cairo gives of each letter once. The fonts are opened and the files are
// written in the way `epure draw` must do it: fonts by name from a folder, files whole or not at all. Exit 0, or 1
// with a sentence.
#include <cairo-pdf.h>
#include <fcntl.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
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

// What both files are made from: the calls one after the other, and the letters, which are shaped when they are met
// first.
class Recording {
 public:
  Recording(const std::string& calls, const Fonts& fonts) : calls_(calls), fonts_(fonts) {}

  void rewind() { at_ = text_ = 0; }
  bool is_at_end() const { return at_ == calls_.size(); }
  char call() { return calls_[at_++]; }
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
  std::vector<double> dashes() {
    std::vector<double> all(static_cast<std::size_t>(number()));
    for (double& length : all) length = number();
    return all;
  }

  struct Letters {
    std::size_t face;
    cairo_scaled_font_t* font;
    double size, x, y;
    const Run& run;
  };
  Letters letters() {
    const auto [face, size, x, y, bytes] = numbers<5>();
    const auto length = static_cast<std::size_t>(bytes), index = static_cast<std::size_t>(face);
    PangoFont* font = fonts_[index];
    if (text_ == runs_.size()) runs_.push_back(shape(font, calls_.substr(at_, length)));
    at_ += length;
    return {index, pango_cairo_font_get_scaled_font(PANGO_CAIRO_FONT(font)), size, x, y, runs_.at(text_++)};
  }

 private:
  const std::string& calls_;
  const Fonts& fonts_;
  std::size_t at_ = 0, text_ = 0;
  std::vector<Run> runs_;
};

class Pdf {
 public:
  Pdf(Recording& recording, cairo_surface_t* surface) : recording_(recording), surface_(surface) {}

  void draw() {
    for (recording_.rewind(); !recording_.is_at_end();) draw(recording_.call());
    cairo_show_page(cr_);
    demand(cairo_status(cr_) == CAIRO_STATUS_SUCCESS, "Cairo failed");
    cairo_destroy(cr_);
    cairo_surface_finish(surface_);
    cairo_surface_destroy(surface_);
  }

 private:
  void page() {
    const auto [width, height] = recording_.numbers<2>();
    if (cr_) cairo_show_page(cr_);
    cairo_pdf_surface_set_size(surface_, width, height);
    if (!cr_) open();
  }

  void open() {
    cr_ = cairo_create(surface_);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cr_, options);
    cairo_font_options_destroy(options);
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
  }

  void draw(char call) {
    switch (call) {
      case 'p':
        return page();
      case 't':
        return show(recording_.letters());
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
        return cairo_set_line_width(cr_, recording_.number());
      case 'd': {
        const std::vector<double> dashes = recording_.dashes();
        return cairo_set_dash(cr_, dashes.data(), static_cast<int>(dashes.size()), 0);
      }
      case 'm': {
        const auto [x, y] = recording_.numbers<2>();
        return cairo_move_to(cr_, x, y);
      }
      case 'l': {
        const auto [x, y] = recording_.numbers<2>();
        return cairo_line_to(cr_, x, y);
      }
      case 'c': {
        const auto [ax, ay, bx, by, x, y] = recording_.numbers<6>();
        return cairo_curve_to(cr_, ax, ay, bx, by, x, y);
      }
      case 'i': {
        const auto [red, green, blue, opacity] = recording_.numbers<4>();
        return cairo_set_source_rgba(cr_, red, green, blue, opacity);
      }
      default:
        throw std::runtime_error("a call that is none");
    }
  }

  void show(const Recording::Letters& letters) {
    std::vector<cairo_glyph_t> glyphs = letters.run.glyphs;
    for (cairo_glyph_t& glyph : glyphs)
      glyph = {glyph.index, letters.x + letters.size * glyph.x, letters.y + letters.size * glyph.y};
    cairo_set_font_face(cr_, cairo_scaled_font_get_font_face(letters.font));
    cairo_set_font_size(cr_, letters.size);
    cairo_show_text_glyphs(cr_, letters.run.letters.data(), static_cast<int>(letters.run.letters.size()),
                           glyphs.data(), static_cast<int>(glyphs.size()), letters.run.clusters.data(),
                           static_cast<int>(letters.run.clusters.size()), cairo_text_cluster_flags_t{});
  }

  Recording& recording_;
  cairo_surface_t* surface_;
  cairo_t* cr_ = nullptr;
};

// In steps of 1/256 pt, to which Cairo rounds what is drawn.
class Svg {
 public:
  explicit Svg(Recording& recording) : recording_(recording) {
    surface_ = cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr);
    cr_ = cairo_create(surface_);
  }
  ~Svg() {
    cairo_destroy(cr_);
    cairo_surface_destroy(surface_);
  }
  Svg(const Svg&) = delete;
  Svg& operator=(const Svg&) = delete;

  std::string write() {
    for (recording_.rewind(); !recording_.is_at_end();) write(recording_.call());
    demand(cairo_status(cr_) == CAIRO_STATUS_SUCCESS, "Cairo failed");
    return head_ + "<defs>\n" + definitions_ + "</defs>\n" + body_ + "</svg>\n";
  }

 private:
  static void add(std::string& to, double value) {
    std::array<char, 24> digits{};
    to.append(digits.data(), std::to_chars(digits.begin(), digits.end(), std::lround(value)).ptr);
  }
  static void add_length(std::string& to, double points) { add(to, 256 * points); }
  void add_to_path(char letter, int count) {
    path_ += letter;
    for (; count > 0; --count) {
      path_ += ' ';
      add_length(path_, recording_.number());
    }
  }

  void begin() {
    const auto [width, height] = recording_.numbers<2>();
    head_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"";
    add(head_, width);
    head_ += "pt\" height=\"";
    add(head_, height);
    head_ += "pt\" viewBox=\"0 0 ";
    add_length(head_, width);
    head_ += ' ';
    add_length(head_, height);
    head_ += "\">\n";
  }

  void write(char call) {
    switch (call) {
      case 'p':
        return begin();
      case 't':
        return show(recording_.letters());
      case '(':
        return;
      case ')':
        return clip_.clear();
      case 'n':
        return path_.clear();
      case 'z':
        path_ += 'z';
        return;
      case 'k':
        return clip();
      case 'S':
        return mark("fill=\"none\" stroke", line_);
      case 'F':
        return mark("fill", "");
      case 'w':
        line_ = " stroke-width=\"";
        add_length(line_, recording_.number());
        line_ += '"';
        return;
      case 'd':
        return dash();
      case 'm':
        return add_to_path('M', 2);
      case 'l':
        return add_to_path('L', 2);
      case 'c':
        return add_to_path('C', 6);
      case 'i':
        return ink();
      default:
        throw std::runtime_error("a call that is none");
    }
  }

  void dash() {
    line_ += " stroke-dasharray=\"";
    const std::vector<double> dashes = recording_.dashes();
    for (const double dash : dashes) {
      add_length(line_, dash);
      line_ += ' ';
    }
    if (dashes.empty()) line_ += "none";
    line_ += '"';
  }

  void ink() {
    ink_ = "rgb(";
    for (int i = 0; i < 3; ++i) {
      add(ink_, 255 * recording_.number());
      ink_ += i < 2 ? ',' : ')';
    }
    ink_ += "\" opacity=\"";
    add(ink_, 1000 * recording_.number());
    ink_ += "e-3\"";
  }

  void clip() {
    const std::string id = "clip" + std::to_string(clips_++);
    definitions_ += "<clipPath id=\"" + id + "\"><path d=\"" + path_ + "\"/></clipPath>\n";
    clip_ = " clip-path=\"url(#" + id + ")\"";
  }

  void mark(const char* paint, const std::string& line) {
    ((((((((body_ += "<path ") += paint) += "=\"") += ink_) += line) += clip_) += " d=\"") += path_) += "\"/>\n";
  }

  void show(const Recording::Letters& letters) {
    for (const cairo_glyph_t& glyph : letters.run.glyphs) {
      const std::string id = std::to_string(letters.face) + "-" + std::to_string(glyph.index);
      define(id, letters, glyph.index);
      (((body_ += "<use xlink:href=\"#g") += id) += "\" fill=\"") += ink_;
      body_ += " transform=\"translate(";
      add_length(body_, letters.x + letters.size * glyph.x);
      body_ += ' ';
      add_length(body_, letters.y + letters.size * glyph.y);
      body_ += ") scale(";
      add(body_, 256 * letters.size);
      body_ += "e-3)\"/>\n";  // to the em of 1000
    }
  }

  void define(const std::string& id, const Recording::Letters& letters, unsigned long glyph) {
    if (!defined_.insert(id).second) return;
    const cairo_glyph_t at_origin{glyph, 0, 0};
    cairo_set_scaled_font(cr_, letters.font);
    cairo_new_path(cr_);
    cairo_glyph_path(cr_, &at_origin, 1);
    cairo_path_t* outline = cairo_copy_path(cr_);
    definitions_ += "<path id=\"g" + id + "\" d=\"";
    for (int i = 0; i < outline->num_data; i += outline->data[i].header.length) {
      definitions_ += "MLCZ"[outline->data[i].header.type];
      for (int k = 1; k < outline->data[i].header.length; ++k) {
        add(definitions_, outline->data[i + k].point.x);
        definitions_ += ' ';
        add(definitions_, outline->data[i + k].point.y);
        definitions_ += ' ';
      }
    }
    definitions_ += "\"/>\n";
    cairo_path_destroy(outline);
  }

  Recording& recording_;
  cairo_surface_t* surface_ = nullptr;
  cairo_t* cr_ = nullptr;
  std::string head_, definitions_, body_, path_, ink_, line_, clip_;
  std::set<std::string> defined_;
  int clips_ = 0;
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
  Recording made(calls, fonts);
  std::string pdf;
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(keep, &pdf, 72, 72);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "none");
  Pdf(made, surface).draw();
  const std::string svg = Svg(made).write();
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
