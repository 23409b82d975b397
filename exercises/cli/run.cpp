#include "exercises/cli/run.h"

#include <cerrno>
#include <cstring>
#include <ostream>

#include "drawings/output.h"
#include "exercises/cli/options.h"
#include "exercises/cli/verbs.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// A text as typed may hold anything; the sentence must stay one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

void print(std::ostream& out, const std::string& text) {
  errno = 0;
  out << text << std::flush;
  if (out) return;
  throw drawings::CannotWrite("cannot write to standard output" +
                              (errno == 0 ? std::string() : std::string(": ") + std::strerror(errno)));
}

Exit run(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
         const Surroundings& surroundings) {
  const auto [options, text] = parse_options(arguments, surroundings.language);
  if (text) {
    print(out, *text);
    return Exit::success;
  }
  switch (options.verb) {
    case Options::Verb::list:
      print(out, list(exercises, options));
      return Exit::success;
    case Options::Verb::draw:
      print(out, draw(exercises, options, err));
      return Exit::success;
    case Options::Verb::bench:
      print(out, benchmark(exercises, options, err));
      return Exit::success;
    case Options::Verb::check:
      break;
  }
  const CheckOutcome outcome = check(exercises, options);
  print(out, outcome.report);
  return outcome.passed ? Exit::success : Exit::failed_check;
}

}  // namespace

int run_cli(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out,
            std::ostream& err, const Surroundings& surroundings) {
  const Language language = language_of_messages(arguments, surroundings.language);
  const auto complain = [&](Exit code, const Words& why) {
    err << "epure: " << one_line(why.in(language)) << '\n' << std::flush;
    return static_cast<int>(code);
  };
  try {
    return static_cast<int>(run(exercises, arguments, out, err, surroundings));
  } catch (const drawings::CannotWrite& error) {
    return complain(Exit::cannot_write, error.words());
  } catch (const geometry::Undecided& error) {  // one rung alone may be unable to say anything
    return complain(Exit::failed_check,
                    format_words("cannot be decided: {}", "non si può decidere: {}", error.words()));
  } catch (const WrongUsage& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const drawings::TooFar& error) {  // by its scale or its givens
    return complain(Exit::wrong_usage, error.words());
  } catch (const BadGivens& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const geometry::BadGiven& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const geometry::Impossible& error) {
    return complain(Exit::wrong_usage, error.words());
  } catch (const std::exception& error) {  // nothing a user should be able to bring about
    return complain(Exit::internal_error,
                    format_words("internal error: {}; please report it with the command that led to it",
                                 "errore interno: {}; si prega di segnalarlo con il comando che l'ha provocato",
                                 std::string(error.what())));
  }
}

}  // namespace epure
