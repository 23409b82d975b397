// The verb that binds exercises into one PDF, with a title page and contents.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "drawings/output.h"
#include "drawings/sheet/contents.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/pages.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace {

using drawings::ContentsEntry;

// A sheet of the book, or why it is not in it.
struct BoundSheet {
  const Exercise* exercise;
  std::size_t place;  // among the exercises of the book
  const SheetSpec* spec;
  DrawnSheet drawn = {};
  std::size_t first_page = 0;
  std::vector<drawings::Page> pages = {};
  Words why_not = {};
};

std::filesystem::path path_of(const Options& options) {
  if (options.file && options.folder)
    throw WrongUsage("-o names one file and --out a folder; choose one of them",
                     "-o nomina un file e --out una cartella; scegliere uno dei due");
  if (!options.file) return std::filesystem::path(options.folder.value_or("out")) / "booklet.pdf";
  const std::filesystem::path path = *options.file;
  if (!is_standard_output(options) && path.extension() != ".pdf")
    throw WrongUsage(format_words("\"{}\" is no name of a booklet, which is a PDF; end it in .pdf",
                                  "\"{}\" non è il nome di un fascicolo, che è un PDF; farlo finire in .pdf",
                                  *options.file));
  return path;
}

class Booklet {
 public:
  Booklet(const std::vector<const Exercise*>& exercises, const Options& options)
      : exercises_(exercises), request_(sheet_request(options)), own_title_(request_.titles.title) {
    request_.titles.title.clear();  // of the whole, not of its exercises
    for (std::size_t i = 0; i < exercises.size(); ++i)
      for (const SheetSpec& spec : exercises[i]->about().sheets) sheets_.push_back({exercises[i], i, &spec});
  }

  std::string pdf() {
    draw_all();
    number_pages();
    abreast(sheets_.size(), [&](std::size_t i) {
      if (sheets_[i].why_not.empty()) sheets_[i].pages = pages_of(sheets_[i].drawn);
      sheets_[i].drawn = {};
    });
    drawings::Document document{.title = plain_title(), .author = request_.titles.author};
    std::vector<drawings::Page> pages = front_pages(document.links);
    document.bookmarks.push_back({say({"Contents", "Indice"}), 1});
    for (const ContentsEntry& entry : entries_)
      document.bookmarks.push_back({drawings::plain(entry.title), entry.page, entry.is_within});
    for (BoundSheet& sheet : sheets_)
      for (drawings::Page& page : sheet.pages) pages.push_back(std::move(page));
    return drawings::write_pdf(pages, document);
  }

  std::vector<Words> remarks() const {
    std::vector<Words> all;
    for (const BoundSheet& sheet : sheets_)
      if (!sheet.why_not.empty())
        all.push_back(format_words("{}/{} is not in the booklet: {}", "{}/{} non è nel fascicolo: {}",
                                   sheet.exercise->about().id, sheet.spec->name, sheet.why_not));
    return all;
  }

 private:
  std::string say(const Words& words) const { return words.in(request_.language); }

  void draw_all() {
    std::vector<std::optional<Solution>> solutions(exercises_.size());
    abreast(exercises_.size(),
            [&](std::size_t i) { solutions[i] = exercises_[i]->solution(Givens(exercises_[i]->about().givens)); });
    abreast(sheets_.size(), [&](std::size_t i) {
      BoundSheet& sheet = sheets_[i];
      try {
        sheet.drawn = sheet.exercise->draw(sheet.spec->name, *solutions[sheet.place], request_);
      } catch (const geometry::Undecided& open) {
        sheet.why_not = open.words();
      } catch (const DoesNotFit& why) {
        throw DoesNotFit(sheet.exercise->about().id + "/" + sheet.spec->name + ": " + why.words());
      }
    });
    if (std::all_of(sheets_.begin(), sheets_.end(), [](const auto& sheet) { return !sheet.why_not.empty(); }))
      throw geometry::Undecided(sheets_.front().why_not);
  }

  // The title block of each sheet tells its page, as the contents do.
  void number_pages() {
    const Exercise* above = nullptr;
    for (BoundSheet& sheet : sheets_) {
      if (!sheet.why_not.empty()) continue;
      if (std::exchange(above, sheet.exercise) != sheet.exercise)
        entries_.push_back({sheet.exercise->about().title.in(request_.language), 0, false});
      entries_.push_back({sheet.spec->title.in(request_.language), 0, true});
    }
    std::size_t page = 1 + drawings::count_contents_pages(entries_, request_.paper), entry = 0;
    above = nullptr;
    for (BoundSheet& sheet : sheets_) {
      if (!sheet.why_not.empty()) continue;
      if (std::exchange(above, sheet.exercise) != sheet.exercise) entries_[entry++].page = page;
      entries_[entry++].page = page;
      sheet.drawn.sheet.title_block.number = fmt::format("{}", ++page);
      for (drawings::Sheet& further : sheet.drawn.further) further.title_block.number = fmt::format("{}", ++page);
    }
  }

  std::string title() const {
    return own_title_.empty() ? say({"Graphical constructions of mechanics", "Costruzioni grafiche di meccanica"})
                              : drawings::escaped(own_title_);
  }
  std::string plain_title() const { return drawings::plain(title()); }

  std::vector<drawings::Page> front_pages(std::vector<drawings::Link>& links) const {
    std::vector<std::string> lines{title()};
    for (const std::string& own : {request_.titles.course, request_.titles.author})
      if (!own.empty()) lines.push_back(drawings::escaped(own));
    const auto drawn = static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.end(), [](const ContentsEntry& entry) { return entry.is_within; }));
    lines.push_back(
        say(format_words("Exercises: {}. Sheets: {}.", "Esercizi: {}. Tavole: {}.", entries_.size() - drawn, drawn)));
    lines.push_back("epure " EPURE_VERSION);
    std::vector<drawings::Page> pages{drawings::title_page(lines, request_.paper, request_.language)};
    for (drawings::Page& page :
         drawings::contents_pages(entries_, request_.paper, request_.language, pages.size(), links))
      pages.push_back(std::move(page));
    return pages;
  }

  const std::vector<const Exercise*>& exercises_;
  SheetRequest request_;
  std::string own_title_;
  std::vector<BoundSheet> sheets_;
  std::vector<ContentsEntry> entries_;
};

}  // namespace

Outcome booklet(const Catalogue& exercises, const Options& options) {
  const std::vector<const Exercise*> chosen =
      find_exercises(exercises, options.names.empty() ? std::vector<std::string>{"all"} : options.names);
  const std::filesystem::path path = path_of(options);
  Booklet made(chosen, options);
  Outcome outcome{.text = made.pdf(), .remarks = made.remarks()};
  if (!outcome.remarks.empty()) outcome.exit = Exit::undecided;
  if (is_standard_output(options)) return outcome;
  drawings::write_whole(path, outcome.text);
  outcome.text = shown_whole(path.string()) + "\n";
  return outcome;
}

}  // namespace epure
