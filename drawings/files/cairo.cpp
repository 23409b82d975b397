// Pages painted by Cairo. The only file that knows it.
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "drawings/files/check_page.h"
#include "drawings/files/flattened.h"
#include "drawings/files/pdf_language.h"
#include "drawings/files/pdf_objects.h"
#include "drawings/files/resolution.h"
#include "drawings/libraries.h"
#include "drawings/output.h"
#include "drawings/page.h"
#include "drawings/paths/grid.h"
#include "drawings/paths/vectors.h"
#include "drawings/stopwatch.h"
#include "drawings/text/glyph_outline.h"
#include "drawings/text/memory_watch.h"
#include "drawings/text/release.h"
#include "drawings/text/shipped_fonts.h"
#include "drawings/text/typeset.h"

namespace epure::drawings {
namespace {

using Surface = Held<cairo_surface_t, cairo_surface_destroy>;
using Context = Held<cairo_t, cairo_destroy>;
using FontOptions = Held<cairo_font_options_t, cairo_font_options_destroy>;

void demand(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status == CAIRO_STATUS_FILE_NOT_FOUND || status == CAIRO_STATUS_READ_ERROR)  // it reads nothing but fonts
    throw Unavailable(fmt::format("a font cannot be read: {}", cairo_status_to_string(status)),
                      fmt::format("un carattere non si può leggere: {}", cairo_status_to_string(status)));
  if (status == CAIRO_STATUS_TEMP_FILE_ERROR || status == CAIRO_STATUS_WRITE_ERROR)  // of EPS, beside /tmp
    throw CannotWrite("Cairo puts EPS together in a temporary file in /tmp, which cannot be written",
                      "Cairo compone l'EPS in un file temporaneo in /tmp, che non si può scrivere");
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(fmt::format("Cairo: {}", cairo_status_to_string(status)));
}

// Where Cairo puts the document. Cairo 1.16 reports success even after its stream has failed, so the flag is ours.
struct Memory {
  std::string bytes;
  bool failed = false;
};
cairo_status_t keep(void* memory, const unsigned char* data, unsigned length) {
  auto& kept = *static_cast<Memory*>(memory);
  try {
    kept.bytes.append(reinterpret_cast<const char*>(data), length);
  } catch (const std::bad_alloc&) {
    kept.failed = true;
    return CAIRO_STATUS_WRITE_ERROR;
  }
  return CAIRO_STATUS_SUCCESS;
}

// By the name of its file, which Cairo opens where it needs it, once for all threads.
cairo_font_face_t* open_font(Face face) {
  const Held<FcPattern, FcPatternDestroy> pattern(FcPatternCreate());
  const std::string file = file_of(face).string();
  if (!pattern || !FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(file.c_str())) ||
      !FcPatternAddInteger(pattern.get(), FC_INDEX, 0))
    throw std::bad_alloc();
  cairo_font_face_t* const font = cairo_ft_font_face_create_for_pattern(pattern.get());
  demand(cairo_font_face_status(font));
  return font;
}

cairo_font_face_t* font_face(Face face) {
  using Font = Held<cairo_font_face_t, cairo_font_face_destroy>;
  static const std::array<Font, 4> fonts = [] {
    const Timed timed(Work::fonts);
    return std::array<Font, 4>{Font(open_font(Face::regular)), Font(open_font(Face::italic)),
                               Font(open_font(Face::bold)), Font(open_font(Face::mathematics))};
  }();
  return fonts.at(static_cast<std::size_t>(face)).get();
}

// A picture takes the outlines: Cairo before 1.18 would move each letter to a whole pixel.
enum class Letters { text, outlines };

class Painter {
 public:
  Painter(cairo_t* context, const Box& extent, Letters letters)
      : context_(context), frame_(extent), letters_(letters) {}

  void operator()(const Stroke& stroke) {
    cairo_save(context_);
    clip(stroke.clip);
    trace(stroke.path);
    ink(stroke.colour);
    cairo_set_line_width(context_, stroke.width * points_per_mm);
    std::vector<double> dashes = stroke.dashes;
    for (double& dash : dashes) dash *= points_per_mm;
    cairo_set_dash(context_, dashes.data(), static_cast<int>(dashes.size()), 0);
    cairo_stroke(context_);
    cairo_restore(context_);
  }

  void operator()(const Fill& fill) {
    cairo_save(context_);
    clip(fill.clip);
    trace(fill.path);
    ink(fill.colour);
    cairo_fill(context_);
    cairo_restore(context_);
  }

  void operator()(const PlacedText& text) {
    const SetText& set = typeset(text.text, text.size, text.weight);
    ink(text.colour);
    for (const GlyphRun& run : set.runs) show(run, text.baseline);
    for (const Path& arrow : set.arrows) {
      cairo_new_path(context_);
      add(arrow, [&](Point p) { return frame_.unrounded(text.baseline + p); });
      cairo_fill(context_);
    }
  }

 private:
  void ink(const Colour& c) { cairo_set_source_rgba(context_, c.red, c.green, c.blue, c.opacity); }

  void trace(const Path& path) {
    cairo_new_path(context_);
    add(path, [this](Point p) { return frame_.rounded(p); });
  }

  template <class ToPage>
  void add(const Path& path, ToPage to_page) {
    const Point start = to_page(path.start);
    cairo_move_to(context_, start.x, start.y);
    for (const Piece& piece : path.pieces) {
      const Point end = to_page(piece.end);
      if (piece.straight) {
        cairo_line_to(context_, end.x, end.y);
      } else {
        const Point a = to_page(piece.first_control), b = to_page(piece.second_control);
        cairo_curve_to(context_, a.x, a.y, b.x, b.y, end.x, end.y);
      }
    }
    if (path.closed) cairo_close_path(context_);
  }

  void clip(const std::optional<Box>& box) {
    if (!box) return;
    trace(polyline({box->low, {box->high.x, box->low.y}, box->high, {box->low.x, box->high.y}}, true));
    cairo_clip(context_);
  }

  // As text, with the characters each glyph stands for, so that the document can be searched.
  void show(const GlyphRun& run, Point baseline) {
    cairo_set_font_face(context_, font_face(run.face));
    cairo_set_font_size(context_, run.size * points_per_mm);
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    std::string letters;
    for (const SetGlyph& glyph : run.glyphs) {
      const Point at = frame_.unrounded(baseline + glyph.at);
      glyphs.push_back({glyph.index, at.x, at.y});
      if (glyph.text.empty() && !clusters.empty())
        ++clusters.back().num_glyphs;
      else
        clusters.push_back({static_cast<int>(glyph.text.size()), 1});
      letters += glyph.text;
    }
    if (letters_ == Letters::outlines) {
      cairo_new_path(context_);
      cairo_glyph_path(context_, glyphs.data(), static_cast<int>(glyphs.size()));
      cairo_fill(context_);
      return;
    }
    cairo_show_text_glyphs(context_, letters.data(), static_cast<int>(letters.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()),
                           cairo_text_cluster_flags_t{});
  }

  cairo_t* context_;
  Frame frame_;
  Letters letters_;
};

// Metrics and outlines as designed, at every size.
FontOptions unhinted() {
  FontOptions options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  return options;
}

Context open(cairo_surface_t* surface) {
  Context context(cairo_create(surface));
  cairo_set_font_options(context.get(), unhinted().get());
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  return context;
}

void paint(cairo_t* context, const Page& page, Letters letters) {
  Painter painter(context, page.extent, letters);
  for (const Primitive& primitive : page.primitives) {
    const MemoryWatch memory;
    std::visit(painter, primitive);
    memory.demand();
  }
  demand(cairo_status(context));
}

// Pages that are led to have a name: Cairo before 1.18 finds no page by its number before it is painted.
std::string name_of_page(std::size_t page) { return fmt::format("page{}", page + 1); }

void add_links(cairo_t* context, const Box& extent, std::size_t number, const std::vector<Link>& links) {
  const bool is_led_to =
      std::any_of(links.begin(), links.end(), [&](const Link& link) { return link.to_page == number; });
  if (is_led_to) {
    cairo_tag_begin(context, CAIRO_TAG_DEST, fmt::format("name='{}' x=0 y=0", name_of_page(number)).c_str());
    cairo_tag_end(context, CAIRO_TAG_DEST);
  }
  for (const Link& link : links) {
    if (link.on_page != number) continue;
    const double x = (link.area.low.x - extent.low.x) * points_per_mm,
                 y = (extent.high.y - link.area.high.y) * points_per_mm;
    cairo_tag_begin(context, CAIRO_TAG_LINK,
                    fmt::format("dest='{}' rect=[{:.2f} {:.2f} {:.2f} {:.2f}]", name_of_page(link.to_page), x, y,
                                link.area.width() * points_per_mm, link.area.height() * points_per_mm)
                        .c_str());
    cairo_tag_end(context, CAIRO_TAG_LINK);
  }
  demand(cairo_status(context));
}

// `number`: of the page in its document, from 0.
void paint_sheet_of_document(cairo_surface_t* surface, const Page& page, std::size_t number = 0,
                             const std::vector<Link>& links = {}) {
  const Context context = open(surface);
  paint(context.get(), page, Letters::text);
  if (!links.empty()) add_links(context.get(), page.extent, number, links);
  const MemoryWatch memory;
  cairo_show_page(context.get());
  memory.demand();
  demand(cairo_status(context.get()));
}

// Closes the document, whose bytes are in `memory`.
std::string finish(cairo_surface_t* surface, Memory& memory) {
  cairo_surface_finish(surface);
  if (memory.failed) throw std::bad_alloc();
  demand(cairo_surface_status(surface));
  return std::move(memory.bytes);
}

void set_metadata(cairo_surface_t* surface, const Document& document) {
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, document.title.c_str());
  if (!document.author.empty())
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_AUTHOR, document.author.c_str());
  if (!document.subject.empty())
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, document.subject.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "epure " EPURE_VERSION);
  // Cairo writes the present time unless it is given a date; one it cannot read makes it write none. The same
  // drawing is then the same file.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "none");
}

void add_bookmarks(cairo_surface_t* surface, const std::vector<Bookmark>& bookmarks) {
  int above = CAIRO_PDF_OUTLINE_ROOT;
  for (const Bookmark& each : bookmarks) {
    const int parent = each.is_within ? above : CAIRO_PDF_OUTLINE_ROOT;
    const int id =
        cairo_pdf_surface_add_outline(surface, parent, each.title.c_str(),
                                      fmt::format("page={}", each.page + 1).c_str(), CAIRO_PDF_OUTLINE_FLAG_OPEN);
    if (!each.is_within) above = id;
  }
}

void check(const Document& document, std::size_t pages) {
  check_plain_text(document.title, "the title of the document");
  check_plain_text(document.author, "the author of the document");
  check_plain_text(document.subject, "the subject of the document");
  for (const Bookmark& each : document.bookmarks) {
    check_plain_text(each.title, "a bookmark");
    if (each.title.empty() || each.page >= pages)
      throw std::invalid_argument(fmt::format("bookmark '{}' to page {} of {}", each.title, each.page + 1, pages));
  }
  for (const Link& each : document.links)
    if (each.on_page >= pages || each.to_page >= pages)
      throw std::invalid_argument(
          fmt::format("a link from page {} to page {} of {}", each.on_page + 1, each.to_page + 1, pages));
}

// Cairo's y points down, and after a contour it moves once more to where that began.
std::vector<Path> contours(const cairo_path_t& path) {
  const auto point = [&](int i) { return Point{path.data[i].point.x, -path.data[i].point.y}; };
  std::vector<Path> found;
  for (int i = 0; i < path.num_data; i += path.data[i].header.length) switch (path.data[i].header.type) {
      case CAIRO_PATH_MOVE_TO:
        found.push_back({point(i + 1), {}, true});
        break;
      case CAIRO_PATH_LINE_TO:
        found.back().pieces.push_back({true, {}, {}, point(i + 1)});
        break;
      case CAIRO_PATH_CURVE_TO:
        found.back().pieces.push_back({false, point(i + 1), point(i + 2), point(i + 3)});
        break;
      case CAIRO_PATH_CLOSE_PATH:
        break;
    }
  std::erase_if(found, [](const Path& contour) { return contour.pieces.empty(); });
  return found;
}

}  // namespace

std::string write_pdf(const std::vector<Page>& pages, const Document& document) {
  const Timed timed(Work::pdf);
  if (pages.empty()) throw std::invalid_argument("a document needs at least one page");
  check(document, pages.size());
  for (const Page& page : pages) check(page);

  Memory memory;
  const Surface surface(cairo_pdf_surface_create_for_stream(keep, &memory, 72, 72));
  demand(cairo_surface_status(surface.get()));
  set_metadata(surface.get(), document);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const Box& extent = pages[i].extent;
    cairo_pdf_surface_set_size(surface.get(), extent.width() * points_per_mm, extent.height() * points_per_mm);
    paint_sheet_of_document(surface.get(), pages[i], i, document.links);
  }
  const MemoryWatch watch;
  add_bookmarks(surface.get(), document.bookmarks);
  std::string bytes = finish(surface.get(), memory);
  watch.demand();
  return without_missing_objects(in_language(std::move(bytes), pages.front().language));
}

std::string write_eps(const Page& page) {
  check(page);
  Memory memory;
  const Surface surface(cairo_ps_surface_create_for_stream(keep, &memory, page.extent.width() * points_per_mm,
                                                           page.extent.height() * points_per_mm));
  demand(cairo_surface_status(surface.get()));
  cairo_ps_surface_set_eps(surface.get(), 1);
  paint_sheet_of_document(surface.get(), flattened(page));
  const MemoryWatch watch;
  std::string bytes = finish(surface.get(), memory);
  watch.demand();
  // Until then Cairo keeps the page in a temporary file, and does not look whether the system took the last of it.
  if (bytes.find("\nshowpage\n%%Trailer\n") == bytes.npos) demand(CAIRO_STATUS_TEMP_FILE_ERROR);
  return without_date(std::move(bytes));
}

std::string write_png(const Page& page, double dots_per_inch) {
  check(page);
  const Pixels size = pixels(page, dots_per_inch);
  if (size.width < 1 || size.height < 1 || size.width > most_pixels / size.height)
    throw std::invalid_argument(fmt::format("page '{}' of {} x {} pixels", page.id, size.width, size.height));
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(size.width), static_cast<int>(size.height)));
  demand(cairo_surface_status(surface.get()));
  const Context context = open(surface.get());
  cairo_scale(context.get(), dots_per_inch / points_per_inch, dots_per_inch / points_per_inch);
  if (page.is_paper) {
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
  }
  paint(context.get(), page, Letters::outlines);
  Memory memory;
  const MemoryWatch watch;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), keep, &memory);
  if (memory.failed) throw std::bad_alloc();
  demand(status);
  watch.demand();
  return with_resolution(std::move(memory.bytes), dots_per_inch);
}

std::vector<Path> glyph_outline(Face face, unsigned glyph) {
  // Paths are only kept here, nothing is painted.
  thread_local const Surface nowhere(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr));
  const Context context(cairo_create(nowhere.get()));
  const MemoryWatch memory;
  cairo_set_font_options(context.get(), unhinted().get());
  cairo_set_font_face(context.get(), font_face(face));
  cairo_set_font_size(context.get(), units_per_em);  // a unit of Cairo's is one of the font's
  const cairo_glyph_t at_origin{glyph, 0, 0};
  cairo_glyph_path(context.get(), &at_origin, 1);
  demand(cairo_status(context.get()));
  memory.demand();
  const Held<cairo_path_t, cairo_path_destroy> kept(cairo_copy_path(context.get()));
  demand(kept->status);
  return contours(*kept);
}

Libraries libraries() { return {{"Cairo", cairo_version_string()}, {"HarfBuzz", hb_version_string()}}; }

}  // namespace epure::drawings
