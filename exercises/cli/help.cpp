#include "exercises/cli/help.h"

namespace epure {

std::string help_of_program() {
  return "The graphical constructions of applied mechanics, carried out exactly, drawn to scale, and checked.";
}

std::string examples_of_program() {
  return R"(Examples:
  epure list
  epure draw all
  epure check all
  epure draw --help

Exit code: 0 good, 1 a check fails, 2 wrong usage or impossible givens, 3 cannot write,
70 an internal error: please report it.)";
}

std::string examples_of_list() {
  return R"(Examples:
  epure list
  epure list slider-crank-velocity
  epure list slider-crank-velocity --lang it)";
}

std::string examples_of_draw() {
  return R"(draw ID writes out/ID.pdf with a page a sheet, and out/ID-SHEET.svg for each sheet;
draw ID/SHEET writes that sheet alone in both formats. Files appear whole or not at all.
A value is a number such as 0.25, 1/4 or 2.5e-1, with or without a unit (25cm).

Examples:
  epure draw slider-crank-velocity
  epure draw slider-crank-velocity --set r=25cm --set n=400rpm --paper a3
  epure draw slider-crank-velocity/poles --scale 1:10 -o poles.pdf
  epure draw slider-crank-velocity/poles --bare --format svg -o - > poles.svg)";
}

std::string examples_of_check() {
  return R"(A quantity passes when all its routes agree within proved bounds, and when its drawing, as the file holds it,
shows it. A measured number passes when it is within reading: --reading times the scale of its drawing; for a
quantity that is not drawn, half a unit of the last digit given. A number without a sign is a magnitude.
fast gives numbers without bounds, so its routes cannot be compared.

Examples:
  epure check all
  epure check slider-crank-velocity --set r=25cm
  epure check slider-crank-velocity --measured v_B=5.1m/s --measured omega_3=13
  epure check slider-crank-velocity --json)";
}

std::string examples_of_bench() {
  return R"(Every family of constructions, at and beside its special positions, with every number: fast (doubles),
bounded (intervals), deep (as many bits as 30 digits take), exact. Errors are those made against references of at least
110 digits; handed over is what a number leaves to the next one, for deep what takes more than 128 bits; wrong counts
what doubles call a number though it is zero or does not exist. Times are of the cases that a number settles, those of
four-bar-second-order by fast and bounded of a sweep. Then which number proves each decision, curves drawn to a
tolerance, and where the time of whole sheets goes. Writes out/bench.pdf and out/bench-*.svg; what it measures next
goes to standard error.

Examples:
  epure bench
  epure bench --json > bench.json
  epure bench --seconds 5 --out bench)";
}

}  // namespace epure
