// What follows from the kind of a quantity. The letters are those of the exercises' sources.
#include "exercises/kit/statement/quantity.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

void is(const Quantity& quantity, const std::string& name, const std::string& symbol, const std::string& unit,
        const Words& meaning) {
  CHECK(quantity.name == name);
  CHECK(quantity.symbol == symbol);
  CHECK(quantity.unit == unit);
  CHECK(quantity.meaning.english == meaning.english);
  CHECK(quantity.meaning.italian == meaning.italian);
}

}  // namespace

TEST_CASE("quantity: a vector has two components and a length") {
  is(velocity("B").x(), "v_B_x", "$v_{Bx}$", "m/s", {"velocity of B, along x", "velocità di B, lungo x"});
  is(velocity("B").length(), "v_B", "$v_{B}$", "m/s", {"speed of B", "velocità di B"});
  is(velocity("BA").length(), "v_BA", "$v_{BA}$", "m/s", {"speed of B relative to A", "velocità di B rispetto ad A"});
  is(acceleration("G3").y(), "a_G3_y", "$a_{G3y}$", "m/s^2",
     {"acceleration of G3, along y", "accelerazione di G3, lungo y"});
  is(normal_acceleration("G3A").length(), "a_G3A_n", "$a^{n}_{G3A}$", "m/s^2",
     {"normal part of the acceleration of G3 relative to A", "parte normale dell'accelerazione di G3 rispetto ad A"});
  CHECK(tangential_acceleration("BA").arrow() == "$\\vec{a}^{t}_{BA}$");
  CHECK(velocity("A").arrow() == "$\\vec{v}_{A}$");
  CHECK(VectorQuantity{"R_23", "\\it{{R}}_{{{}}}", "23", "N", {}, {}}.arrow() == "$\\vec{\\it{R}}_{23}$");
}

TEST_CASE("quantity: points, distances, rates") {
  is(point("A").y(), "A_y", "$y_{A}$", "m", {"ordinate of A", "ordinata di A"});
  is(pole("P31").x(), "P31_x", "$x_{P31}$", "m", {"abscissa of the pole", "ascissa del polo"});
  is(distance("P0", "A"), "P0A", "$P_{0}A$", "m", {"distance of A from P0", "distanza di A da P0"});
  is(angular_velocity(3), "omega_3", "$ω_{3}$", "rad/s",
     {"angular velocity of link 3, counter-clockwise", "velocità angolare del membro 3, antioraria"});
  is(angular_acceleration(4), "alpha_4", "$α_{4}$", "rad/s^2",
     {"angular acceleration of link 4, counter-clockwise", "accelerazione angolare del membro 4, antioraria"});
  CHECK(point_letters("P31") == "P_{31}");
  CHECK(point_letters("Cprime") == "C'");
  CHECK(point_letters("K") == "K");
}
