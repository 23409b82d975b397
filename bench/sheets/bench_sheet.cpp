#include "bench/sheets/bench_sheet.h"

namespace epure::bench {

using drawings::Heading;
using drawings::Paragraph;
using drawings::Sheet;

Sheet Drawn::blank(int page, const std::string& id, const Words& title, const Words& description) const {
  Sheet sheet;
  sheet.id = "bench-" + id;
  sheet.paper = paper;
  sheet.language = language;
  sheet.title_block.exercise = say({"Speed against error", "Velocità ed errore"});
  sheet.title_block.sheet = say(title);
  sheet.title_block.source =
      say({"epure bench, measured on this machine", "epure bench, misurato su questa macchina"});
  sheet.title_block.page = page;
  sheet.title_block.pages = 4;
  sheet.title = sheet.title_block.exercise + ": " + sheet.title_block.sheet;
  sheet.description = say(description);
  const Machine& on = report.machine;
  sheet.column.push_back(Heading{say({"Machine", "Macchina"})});
  sheet.column.push_back(
      Paragraph{fmt::format("{}, {} {}; {}", on.processor, on.cores, say({"cores", "processori"}), on.compiler)});
  return sheet;
}

void Drawn::explain(Sheet& sheet, const std::vector<Words>& steps) const {
  sheet.column.push_back(Heading{say({"Reading", "Lettura"})});
  drawings::Steps said;
  for (const Words& step : steps) said.lines.push_back(say(step));
  sheet.column.push_back(std::move(said));
}

std::vector<Sheet> sheets_of(const Report& report, Language language, drawings::Paper paper) {
  const Drawn drawn{report, language, paper};
  return {speed_against_error(drawn), worst_errors(drawn), curves(drawn), whole_sheets(drawn)};
}

}  // namespace epure::bench
