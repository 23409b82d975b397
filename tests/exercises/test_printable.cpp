// What a message shows of what was typed.
#include <string>

#include "exercises/cli/printable.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

TEST_CASE("letters of every script are shown as they are") {
  for (const std::string text :
       {"", "ω₃ = 5,1 m/s²", "\u20ac \u4e2d\u6587 \U0001F600 a\u0301", "tra \u2018virgolette\u2019"})
    CHECK(printable(text) == text);
}

TEST_CASE("what a terminal obeys, what is not seen and what is no UTF-8 becomes a question mark") {
  for (const std::string text :
       {"\n",     "\t",     "\x1b",   "\x7f",   "\u0085", "\u009b", "\u00ad", "\u061c", "\u200b", "\u200e",
        "\u2028", "\u202a", "\u202e", "\u2060", "\u2066", "\u2069", "\ufeff", "\xff",   "\x9b",   "\xc3"}) {
    CAPTURE(text);
    CHECK(printable("a" + text + "b") == "a?b");
  }
  CHECK(printable("\xe2\x82") == "??");            // cut off
  CHECK(printable("\xc0\xaf") == "??");            // a slash in two bytes
  CHECK(printable("\xed\xa0\x80") == "???");       // half of a pair
  CHECK(printable("\xf4\x90\x80\x80") == "????");  // beyond Unicode
  CHECK(printable(std::string("a\0b", 3)) == "a?b");
}

TEST_CASE("a path is shown to its end, without what a terminal obeys") {
  const std::string path = "out/" + std::string(300, 'a') + ".svg";
  CHECK(shown_whole(path) == path);
  CHECK(shown_whole("\u202eout/a\x1b.svg") == "?out/a?.svg");
}

TEST_CASE("what is far too long is cut in its middle") {
  const std::string word(100000, 'a');
  CHECK(printable("say " + word + " again") ==
        "say " + std::string(60, 'a') + "..." + std::string(19, 'a') + " again");
  CHECK(printable(std::string(119, 'a') + " b") == std::string(119, 'a') + " b");
  std::string sentence;
  for (int i = 0; i < 10000; ++i) sentence += "ω ";
  CHECK(printable(sentence).size() < 3000);
  CHECK(printable(sentence).starts_with("ω ω "));
}

TEST_CASE("every message is fit for a terminal") {
  const std::string bad = "a\u202e\x9b\xff\u009b2J";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{bad},
                                             {"draw", bad},
                                             {"draw", "triangle/" + bad},
                                             {"draw", "triangle", "--format", bad},
                                             {"draw", "triangle", "--scale", bad},
                                             {"draw", "triangle", "-o", bad},
                                             {"draw", "triangle", "--" + bad},
                                             {"check", "triangle", "--set", bad},
                                             {"check", "triangle", "--set", "a=" + bad},
                                             {"check", "triangle", "--measured", bad + "=1"},
                                             {"check", "triangle", "--measured", "c=" + bad}}) {
    const Ran ran = run(words);
    CAPTURE(ran.err);
    CHECK(ran.exit == 2);
    CHECK(printable(ran.err.substr(0, ran.err.size() - 1)) + "\n" == ran.err);
    CHECK(ran.err.find("a?") != std::string::npos);
  }
  CHECK(run({"draw", std::string(100000, 'a')}).err.size() < 300);
}

TEST_CASE("names of files that a terminal would obey are refused") {
  for (const char* option : {"--out", "-o"}) {
    const Ran ran = run({"draw", "triangle", option, "a\x1b[31mb"});
    CAPTURE(option, ran.err);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("a?[31mb\": a name with control characters is refused") != std::string::npos);
  }
  CHECK(commands_a_terminal("a\xc2\x9b"));
  CHECK_FALSE(commands_a_terminal("più \xff"));
}
