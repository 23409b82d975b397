#include "exercises/cli/run.h"

#include <filesystem>
#include <new>
#include <ostream>

#include "drawings/output.h"
#include "exercises/cli/kept_inputs.h"
#include "exercises/cli/options.h"
#include "exercises/cli/print.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "exercises/cli/with_scenes.h"
#include "exercises/scenes/file/text_tree.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

std::string benchmark(const Catalogue& exercises, const Options& options, std::ostream& err, const Bench& bench) {
  demand_sensible_output(options);
  language(options);
  sheet_request(options);
  seconds_of(options);
  return bench(exercises, options, err);
}

Outcome outcome_of(const Catalogue& exercises, const Options& options, std::ostream& out, std::ostream& err,
                   const Surroundings& surroundings) {
  switch (options.verb) {
    case Options::Verb::list:
      return {list(exercises, options)};
    case Options::Verb::draw:
      return draw(exercises, options, err);
    case Options::Verb::bench:
      return {benchmark(exercises, options, err, surroundings.bench)};
    case Options::Verb::sweep:
      return sweep(exercises, options, out, err, surroundings);
    case Options::Verb::make_class:
      return make_class(exercises, options, err, surroundings);
    case Options::Verb::mark:
      return mark(exercises, options);
    case Options::Verb::report:
      return report(exercises, options);
    case Options::Verb::import_text:
      return import_text(options);
    case Options::Verb::booklet:
      return booklet(exercises, options);
    case Options::Verb::check:
      break;
  }
  return check(exercises, options);
}

// The names of files are printed, also on terminals.
void demand_no_commands(const std::string& name) {
  if (commands_a_terminal(name))
    throw WrongUsage(format_words("\"{}\": a name with control characters is refused, as a terminal obeys them",
                                  "\"{}\": un nome con caratteri di controllo è rifiutato, poiché un terminale vi "
                                  "obbedisce",
                                  name));
}

Outcome run(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out,
            std::ostream& err, const Surroundings& surroundings) {
  auto [options, text] = parse_options(exercises, arguments, surroundings.language);
  options.colours = surroundings.colours;
  for (const auto& written : {options.file, options.chart})
    if (written) demand_not_read(*written, options);
  for (const auto& named : {options.folder, options.file, options.chart})
    if (named) demand_no_commands(*named);
  demand_no_commands(options.class_set.seed);
  if (!text && options.verb != Options::Verb::import_text && names_scenes(options)) {
    const Scenes scenes = read_scenes(options);
    Outcome outcome = outcome_of(scenes.exercises, scenes.options, out, err, surroundings);
    if (options.verb == Options::Verb::check || options.verb == Options::Verb::draw)
      for (Words& remark : remarks(scenes)) outcome.remarks.push_back(std::move(remark));
    return outcome;
  }
  return text ? Outcome{*text} : outcome_of(exercises, options, out, err, surroundings);
}

}  // namespace

int run_cli(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out,
            std::ostream& err, const Surroundings& surroundings) {
  const Language language = language_of_messages(arguments, surroundings.language);
  const auto complain = [&](Exit code, const Words& why) {
    err << "epure: " << printable(why.in(language)) << '\n' << std::flush;
    return static_cast<int>(code);
  };
  try {
    const Outcome outcome = run(exercises, arguments, out, err, surroundings);
    print(out, outcome.text);
    for (const Words& note : outcome.notes) complain(outcome.exit, note);
    for (const Words& remark : outcome.remarks) complain(outcome.exit, remark);
    return static_cast<int>(outcome.exit);
  } catch (const drawings::CannotWrite& error) {
    return complain(Exit::cannot_write, error.words());
  } catch (const geometry::Undecided& error) {  // one rung alone may be unable to say anything
    return complain(Exit::undecided, format_words("cannot be decided: {}", "non si può decidere: {}", error.words()));
  } catch (const WrongUsage& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const scenes::BadScene& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const drawings::TooFar& error) {  // by its scale or its givens
    return complain(Exit::wrong_usage, error.words());
  } catch (const BadGivens& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const geometry::BadGiven& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const geometry::Impossible& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const drawings::Unavailable& error) {
    return complain(Exit::cannot_write, error.words());
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(Exit::cannot_write, format_words("cannot read {}: {}", "non si può leggere {}: {}",
                                                     error.path1().string(), error.code().message()));
  } catch (const std::bad_alloc&) {
    return complain(Exit::cannot_write, {"there is not enough memory for this", "la memoria non basta"});
  } catch (const std::exception& error) {  // nothing a user should be able to bring about
    return complain(Exit::internal_error,
                    format_words("internal error: {}; please report it with the command that led to it",
                                 "errore interno: {}; si prega di segnalarlo con il comando che l'ha provocato",
                                 std::string(error.what())));
  }
}

}  // namespace epure
