#include "exercises/cycloid-involute/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace cycloid_involute {
namespace {

Description description() {
  return {.id = "cycloid-involute",
          .title = {"Cycloid and involute", "Cicloide ed evolvente"},
          .document = "sapienza",
          .item = "N.9",
          .source = {"Sapienza, Esercitazione N.9", "Sapienza, Esercitazione N.9"},
          .givens = given_specs(),
          .sheets = {{"cycloid", {"Cycloid by twelve divisions", "Cicloide per dodici divisioni"}},
                     {"cycloid-instants", {"Cycloid: two instants", "Cicloide: due istanti"}},
                     {"cycloid-travel", {"Cycloid: arc travelled", "Cicloide: spazi percorsi"}},
                     {"involute", {"Involute by twelve divisions", "Evolvente per dodici divisioni"}},
                     {"involute-instants", {"Involute: two instants", "Evolvente: due istanti"}},
                     {"involute-travel", {"Involute: arc travelled", "Evolvente: spazi percorsi"}}},
          .quantities = quantity_specs(),
          .printed = printed_by_the_source()};
}

class CycloidInvolute : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return solved(problem_of(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Problem problem = problem_of(givens);
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "cycloid") draw_cycloid(onto, problem, request);
    if (sheet == "cycloid-instants") draw_cycloid_instants(onto, problem, request);
    if (sheet == "cycloid-travel") draw_cycloid_travel(onto, problem, request);
    if (sheet == "involute") draw_involute(onto, problem, request);
    if (sheet == "involute-instants") draw_involute_instants(onto, problem, request);
    if (sheet == "involute-travel") draw_involute_travel(onto, problem, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace

Problem problem_of(const Givens& givens) {
  return {.r = givens["d"] / 2,
          .omega_1 = givens.angle("omega_1"),
          .phi = givens.angle("phi"),
          .s = givens["s"],
          .r_0 = givens["d_0"] / 2,
          .omega_2 = givens.angle("omega_2"),
          .phi_1 = givens.angle("phi_1"),
          .phi_2 = givens.angle("phi_2")};
}

}  // namespace cycloid_involute

std::unique_ptr<Exercise> make_cycloid_involute() { return std::make_unique<cycloid_involute::CycloidInvolute>(); }

}  // namespace epure
