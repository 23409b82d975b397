#include "exercises/scenes/file/sections.h"

#include <algorithm>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/demand_few.h"
#include "exercises/scenes/file/greek.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;

// offsets:, paths:, polodes:.
class QuestionsReader : SectionReader {
 public:
  using SectionReader::SectionReader;

  // offsets: {e: P from g}.
  void offsets() {
    const Tree* all = root_.find("offsets");
    if (!all) return;
    file_.map(*all, {"offsets: {e: P from g}, how far a point is left of a line",
                     "offsets: {e: P from g}, quanto un punto sta a sinistra di una retta"});
    for (const auto& [key, value] : all->entries) {
      const std::string name = spelled_out(key.text);
      demand_letter(key, name);
      if (of_.known.contains(name))
        refuse(key, format_words("\"{}\" is a given already", "\"{}\" è già un dato", key.text));
      const Words what{"an offset reads: P from g", "uno scostamento si scrive: P from g"};
      const std::vector<std::string> words = parted(file_.text(value, what));
      if (words.size() != 3 || words[1] != "from") refuse(value, what);
      built_.offsets.push_back({name, point(value, words[0]), line(value, words[2])});
    }
  }
  // paths: [P, Q].
  void paths() {
    const Tree* all = root_.find("paths");
    if (!all) return;
    const Words what{"paths: [P, Q], the points whose paths are asked for",
                     "paths: [P, Q], i punti di cui si chiede la traiettoria"};
    file_.demand(*all, Tree::Kind::list, what);
    demand_few(file_, *all, all->items.size());
    for (const Tree& item : all->items) {
      const int P = point(item, file_.text(item, what));
      if (built_.linkage.links_at(P).front() == 0)
        refuse(item,
               format_words("{} is of the frame: it has no path", "{} è del telaio: non ha traiettoria", letter(P)));
      if (std::find(built_.paths.begin(), built_.paths.end(), P) != built_.paths.end())
        refuse(item, format_words("{} stands here twice", "{} sta qui due volte", letter(P)));
      built_.paths.push_back(P);
    }
    if (!built_.paths.empty() && built_.linkage.drives.size() != 1)
      refuse(*all, format_words("with {} drives a point has no one path",
                                "con {} moventi un punto non ha una sola traiettoria", built_.linkage.drives.size()));
  }
  // polodes: [3].
  void polodes() {
    const Tree* all = root_.find("polodes");
    if (!all) return;
    const Words what{"polodes: [3], the links whose polodes are asked for",
                     "polodes: [3], i membri di cui si chiedono le polari"};
    file_.demand(*all, Tree::Kind::list, what);
    demand_few(file_, *all, all->items.size());
    for (const Tree& item : all->items) {
      const int link = moving_link_of_number(item, file_.text(item, what));
      if (built_.linkage.hinge_of(0, link) != nothing)
        refuse(item, format_words("link {0} turns about {1}: both of its polodes are that point",
                                  "il membro {0} ruota attorno a {1}: le sue polari sono quel punto", item.text,
                                  letter(built_.linkage.hinge_of(0, link))));
      if (built_.linkage.links[static_cast<std::size_t>(link)].points.empty())
        refuse(item, format_words("link {} has no point to be drawn by: give it one",
                                  "il membro {} non ha un punto con cui disegnarlo: dargliene uno", item.text));
      for (const LineOnLine& block : built_.linkage.blocks)
        if (const int one = built_.linkage.link_of_line(block.moving),
            other = built_.linkage.link_of_line(block.guide);
            (one == 0 && other == link) || (one == link && other == 0))
          refuse(item, format_words("link {} is led along {} and does not turn: it has no polodes",
                                    "il membro {} scorre lungo {} e non ruota: non ha polari", item.text,
                                    built_.letters.lines[static_cast<std::size_t>(block.guide)]));
      if (std::find(built_.polodes.begin(), built_.polodes.end(), link) != built_.polodes.end())
        refuse(item, format_words("{} stands here twice", "{} sta qui due volte", item.text));
      built_.polodes.push_back(link);
    }
    if (!built_.polodes.empty() && built_.linkage.drives.size() != 1)
      refuse(*all, format_words("with {} drives a link has no polodes", "con {} moventi un membro non ha polari",
                                built_.linkage.drives.size()));
  }
};

}  // namespace

void read_questions(FileReading& of) {
  QuestionsReader reader(of);
  reader.offsets();
  reader.paths();
  reader.polodes();
}

}  // namespace epure::scenes
