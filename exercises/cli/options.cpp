#include "exercises/cli/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/help.h"
#include "exercises/kit/suggest.h"

namespace epure {
namespace {

// An option that may be repeated and takes one value each time, so that what follows the value is a name again.
void add_repeatable(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                    const std::string& meaning, const std::string& value) {
  verb.add_option(name, values, meaning)->allow_extra_args(false)->type_name(value);
}

void add_givens(CLI::App& verb, Options& options) {
  add_repeatable(verb, "--set", options.assignments, "another value for a given", "SYMBOL=VALUE[UNIT]");
}

void add_language(CLI::App& verb, Options& options) {
  verb.add_option("--lang", options.language, "en (default) or it")->type_name("LANGUAGE");
}

void add_list(CLI::App& verb, Options& options) {
  verb.add_option("ID", options.names, "an exercise: show its sheets, givens and quantities")->type_name("");
  add_language(verb, options);
}

void add_draw(CLI::App& verb, Options& options) {
  verb.add_option("NAME", options.names, "exercises or single sheets: ID, ID/SHEET or all")->type_name("");
  verb.add_option("--format", options.format, "pdf, svg or both (default: pdf,svg)")->type_name("FORMATS");
  verb.add_option("--out", options.folder, "folder to write to (default: out)")->type_name("DIR");
  verb.add_option("-o", options.file, "write one file instead; - is standard output")->type_name("FILE");
  add_givens(verb, options);
  verb.add_option("--paper", options.paper, "a4 (default) or a3, landscape")->type_name("PAPER");
  verb.add_option("--scale", options.scale, "scale of lengths, such as 1:5 (default: the largest standard one)")
      ->type_name("SCALE");
  add_language(verb, options);
  verb.add_flag("--bare", options.bare, "the figure alone: no frame, no column, no title block");
  verb.add_flag("--times", options.times, "say on standard error where the time went");
}

void add_check(CLI::App& verb, Options& options) {
  verb.add_option("ID", options.names, "exercises, or all")->type_name("");
  add_givens(verb, options);
  add_repeatable(verb, "--measured", options.measured, "a number you measured, held against the true one",
                 "NAME=VALUE[UNIT]");
  verb.add_option("--reading", options.reading, "how well you read a ruler (default: 0.5mm)")->type_name("LENGTH");
  verb.add_flag("--json", options.json, "print the report as JSON (schema epure.check/1)");
  verb.add_option("--arithmetic", options.arithmetic,
                  "fast (doubles), bounded (intervals) or exact (default: as many digits as it takes)")
      ->type_name("KIND");
}

void add_bench(CLI::App& verb, Options& options) {
  verb.add_flag("--json", options.json, "print the results as JSON (schema epure.bench/1)");
  verb.add_option("--seconds", options.seconds, "about how long to measure (default: 60)")->type_name("TIME");
  verb.add_option("--out", options.folder, "folder to write the sheets to (default: out)")->type_name("DIR");
  verb.add_option("--format", options.format, "pdf, svg or both (default: pdf,svg)")->type_name("FORMATS");
  verb.add_option("--paper", options.paper, "a4 (default) or a3, landscape")->type_name("PAPER");
  add_language(verb, options);
}

struct Parser {
  Options options;
  CLI::App app{help_of_program(), "epure"};
  CLI::App* list = app.add_subcommand("list", "Show the exercises, or all about one of them.");
  CLI::App* draw = app.add_subcommand("draw", "Draw exercises to scale, as PDF and SVG.");
  CLI::App* check = app.add_subcommand(
      "check", "Check every quantity: route against route, against the drawing, against the printed number.");
  CLI::App* bench = app.add_subcommand("bench", "Measure speed against error, and draw it.");

  Parser() {
    app.set_help_flag("--help,-h", "print this help");
    app.set_version_flag("--version", "epure " EPURE_VERSION, "print the version");
    app.footer(examples_of_program());
    app.require_subcommand(0, 1);  // none is answered here, in our own words
    add_list(*list, options);
    add_draw(*draw, options);
    add_check(*check, options);
    add_bench(*bench, options);
    list->footer(examples_of_list());
    draw->footer(examples_of_draw());
    check->footer(examples_of_check());
    bench->footer(examples_of_bench());
    for (CLI::App* verb : {list, draw, check, bench}) {
      verb->set_help_flag("--help,-h", "print this help");
      verb->get_formatter()->column_width(34);
    }
  }
};

// CLI11 speaks of arguments in capitals and several lines; a user gets one sentence.
std::string one_sentence(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
  if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z' && message.size() > 1 && message[1] >= 'a')
    message[0] = static_cast<char>(message[0] - 'A' + 'a');
  return message;
}

// The word where the verb should be.
void demand_verb(const std::vector<std::string>& arguments) {
  const std::vector<std::string> verbs = {"list", "draw", "check", "bench"};
  if (arguments.empty()) throw WrongUsage("say what to do: list, draw, check or bench (epure --help explains)");
  const std::string& first = arguments.front();
  const bool is_option = first.starts_with('-');
  if (!is_option && std::find(verbs.begin(), verbs.end(), first) == verbs.end())
    throw WrongUsage("\"" + first + "\" is nothing epure can do; " + did_you_mean(first, verbs));
}

}  // namespace

Language language_of_messages(const std::vector<std::string>& arguments, const std::string& otherwise) {
  const std::string option = "--lang";
  std::string asked = otherwise;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == option && i + 1 < arguments.size()) asked = arguments[i + 1];
    if (arguments[i].starts_with(option + "=")) asked = arguments[i].substr(option.size() + 1);
  }
  return asked == "it" ? Language::italian : Language::english;
}

Parsed parse_options(const std::vector<std::string>& arguments, const std::string& language) {
  demand_verb(arguments);
  Parser parser;
  if (!language.empty()) parser.options.language = language;
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    parser.app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = parser.app.get_subcommands();
    return {parser.options, chosen.empty() ? parser.app.help() : chosen.front()->help("epure")};
  } catch (const CLI::CallForVersion& version) {
    return {parser.options, std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw WrongUsage(one_sentence(error.what()) + " (epure --help explains)");
  }
  if (parser.app.get_subcommands().empty()) demand_verb({});
  parser.options.verb = *parser.list    ? Options::Verb::list
                        : *parser.draw  ? Options::Verb::draw
                        : *parser.check ? Options::Verb::check
                                        : Options::Verb::bench;
  return {parser.options};
}

}  // namespace epure
