// Where the rocker's speed is stationary, by both routes, held against angles and ratios that neither made; far from
// change points and beside them.
#include <array>

#include "geometry/analytic/four_bar_extremes.h"
#include "geometry/mechanisms/collineation_axis.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

using namespace epure::geometry;
using epure::tests::exact_decimal;
using epure::tests::narrow;
using epure::tests::overlaps;

namespace {

struct Stationary {
  std::string degrees, ratio;  // of the crank from +x; ω₄/ω₂
};
struct Case {
  std::string what;
  std::array<std::string, 5> lengths;  // A0A, AB, B0B, B0
  std::vector<Stationary> all;         // with B on the left of A -> B0, the least ratio first
};

// Python with mpmath, 300 digits, by bisection on the numerical second derivative of arg(B - B0) by the crank's
// angle, B where the circles meet, from a net of angles that narrows towards the flat positions by powers of ten.
// clang-format off
const std::vector<Case>& cases() {
  static const std::vector<Case> all{
    {"the exercise as stated", {"0.2", "0.5", "0.7", "0.8", "0"}, {{"352.675953327130997404189746684831271682", "-0.3390315913700451929443037389267044498004"}, {"131.4290478982002011381076585746057359693", "0.291883900618739031319285854131798339358"}}},
    {"a drag link", {"0.6", "0.5", "0.7", "0.2", "0"}, {{"219.5166380169491014326262862794859998876", "0.7074610282751956127465564487958828435338"}, {"354.5210538784840179798333471795485201014", "1.507453661251351511034652006576653970218"}}},
    {"a change point missed by 1e-10", {"1", "3", "2.0000000001", "4", "0"}, {{"322.0241826453259878678265567538413673615", "-0.5080666151486303747965245937891627710995"}, {"179.6695557377842480665262871222688558148", "0.6898942664903851608909362992353947611358"}}},
    {"1e-25", {"1", "3", "2.0000000000000000000000001", "4", "0"}, {{"322.0241826431209723375222418892631112577", "-0.5080666151703324592829383791683170688911"}, {"179.9999412375171632100800993072846155297", "0.6898979485565191827433913444082215005615"}}},
    {"1e-40", {"1", "3", "2.0000000000000000000000000000000000000001", "4", "0"}, {{"322.0241826431209723375222396842475808511", "-0.5080666151703324592829384008704015566683"}, {"179.9999999895503886688556269683464956054", "0.6898979485566356196357747569887066914963"}}},
    {"a frame of a millionth of the bars", {"1", "1", "1", "0.000001", "0"}, {{"210.0000763944002504455994951989681652655", "0.9999988453001282861962882652644696940689"}, {"29.99992360565488244394259028007074601035", "1.000001154701205047137047438439234010952"}}},
    {"a parallelogram missed by 1e-20", {"0.2", "0.5", "0.20000000000000000001", "0.5", "0"}, {{"359.9993248013512282691011640820142414831", "-2.333333332613251033669959974300976670461"}, {"90.00000000000000000085943669269623481316", "0.9999999999999999999500000000000000000025"}}},
    {"an extreme at a trapezoid, where the coupler translates", {"1", "4", "4", "5", "0"}, {{"338.0810777868890759271216131908434966456", "-0.2839606478077261784299981430235007486717"}, {"126.8698976458440212968556125590934106576", "0.25"}}},
    {"crank as long as coupler: a root 0 that is no position", {"3", "3", "2", "1", "0"}, {{"253.9134607570738270835233687825329972013", "0.4976317833846998343584430760341517279182"}, {"24.950974596809403978096719180356286962", "1.688224668787459335189091833376288544175"}}},
    {"coupler as long as frame: a root 1 that is no position", {"1", "3", "2", "3", "0"}, {{"335.049025403190596021903280819643713038", "-0.6882246687874593351890918333762885441753"}, {"106.0865392429261729164766312174670027987", "0.5023682166153001656415569239658482720818"}}},
    {"an extreme with the crank on the frame", {"1", "4", "5", "4", "0"}, {{"0", "-0.3333333333333333333333333333333333333333"}, {"147.8982141628569722280548490079198002292", "0.2211599306353892580292078894290980810683"}}},
    {"frame and coupler of 1e8 m between cranks of 1 m", {"1", "100000000.5", "2", "100000000", "0"}, {{"280.8513943871404163760801019878345756572", "-0.5230036261160933528020663121559879555996"}, {"79.14860857493372916034495521963747430101", "0.5230036223508470064198761465464756742351"}}},
    {"a frame of no rational length", {"0.1", "0.4", "0.45", "0.3", "0.5"}, {{"35.60843385261115113359360149931786918717", "-0.235356190795121575801751842073118360496"}, {"187.578398424084331977266994918064650178", "0.2251915140146408178877176049680807384893"}}},
  };
  return all;
}
// clang-format on

FourBarLengths lengths(const Case& of) {
  const auto number = [&](std::size_t i) { return exact_decimal(of.lengths[i]); };
  return {number(0), number(1), number(2), number(3), number(4)};
}

analytic::FourBar analytic_lengths(const FourBarLengths& of) { return {of.A0A, of.AB, of.B0B, of.x_B0, of.y_B0}; }

Vector<Deep> plane(const analytic::Complex<Deep>& z) { return {z.re, z.im}; }

// The direction at `degrees`, within the error of their 40 digits.
bool is_at(const Vector<Deep>& crank, const Rational& degrees) {
  const Vector<Deep> at{cosine<Deep>(Turn{degrees / 360}), sine<Deep>(Turn{degrees / 360})};
  const Deep beside = arc_tangent(cross(at, crank), dot(at, crank)) * Deep(180) / pi<Deep>();
  return overlaps(beside, Rational(0), abs(degrees) * exact_decimal("5e-40"));
}

}  // namespace

TEST_CASE("four-bar extremes: both routes find all of them, to 38 digits", "[extremes]") {
  for (const Case& c : cases()) {
    CAPTURE(c.what);
    const FourBarLengths of = lengths(c);
    const auto by_axis = stationary_positions(of, Side::left);
    const auto by_closure = analytic::stationary_cranks(analytic_lengths(of), analytic::Branch::left);
    REQUIRE(by_axis.size() == c.all.size());
    REQUIRE(by_closure.size() == c.all.size());
    const Arithmetic<Deep> bits(512);
    for (std::size_t i = 0; i < c.all.size(); ++i) {
      CAPTURE(i);
      const Rational degrees = exact_decimal(c.all[i].degrees), ratio = exact_decimal(c.all[i].ratio);
      const Vector<Deep> crank = by_axis[i].crank<Deep>(), other = plane(by_closure[i].direction<Deep>());
      CHECK(is_at(crank, degrees));
      CHECK(is_at(other, degrees));
      const Deep by_centres = velocity_ratio_by_centres(four_bar(of, crank, Side::left));
      for (const Deep& found : {by_centres, by_closure[i].ratio()}) {
        CHECK(narrow(found));
        CHECK(overlaps(found, ratio));
      }
    }
  }
}

// Mirrored in the frame, the other branch does the same.
TEST_CASE("four-bar extremes: the other branch is the mirror image", "[extremes]") {
  const Arithmetic<Deep> bits(256);
  for (const Case& c : cases()) {
    CAPTURE(c.what);
    const FourBarLengths of = lengths(c);
    if (of.y_B0 != 0) continue;
    const auto by_axis = stationary_positions(of, Side::right);
    const auto by_closure = analytic::stationary_cranks(analytic_lengths(of), analytic::Branch::right);
    REQUIRE(by_axis.size() == c.all.size());
    REQUIRE(by_closure.size() == c.all.size());
    for (std::size_t i = 0; i < c.all.size(); ++i)
      for (const Vector<Deep>& crank : {by_axis[i].crank<Deep>(), plane(by_closure[i].direction<Deep>())})
        CHECK(is_at({crank.x, -crank.y}, exact_decimal(c.all[i].degrees)));
  }
}

// A = (1, 0), B = (1, 4), B0 = (4, 0): the coupler is square to the frame, on which the collineation axis lies.
TEST_CASE("four-bar extremes: one at a rational place is a direction for every number", "[extremes]") {
  const FourBarLengths upright{1, 4, 5, 4, 0};
  const Arithmetic<Exact> scope;
  for (const Vector<Exact>& crank : {stationary_positions(upright, Side::left).front().crank<Exact>(), [&] {
                                       const auto z = analytic::stationary_cranks(analytic_lengths(upright),
                                                                                  analytic::Branch::left)
                                                          .front()
                                                          .direction<Exact>();
                                       return Vector<Exact>{z.re, z.im};
                                     }()}) {
    CHECK(sign(crank.y) == Sign::zero);
    CHECK(sign(crank.x - Exact(1)) == Sign::zero);
  }
  CHECK_THROWS_AS(stationary_positions(upright, Side::left).back().crank<Exact>(), Undecided);
}
