#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/kit/statement/given_number.h"

#include "exercises/kit/statement/decimal.h"

namespace epure::oscillator_pendulum {
namespace {

void demand_steps(const std::string& symbol, const Rational& dt, const Rational& least, int last) {
  require(dt >= least,
          format_words("{} = {} s: the table would have more than {} rows up to t = {} s, the step is at least {} s",
                       "{} = {} s: la tabella avrebbe più di {} righe fino a t = {} s, il passo è almeno {} s",
                       symbol, told_value(dt), told_value(Rational(last) / least), last, told_value(least)));
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  const auto both = [](const char* of, const char* italian) { return Words{of, italian}; };
  return {
      {"zeta", both("damping ratio of the oscillator", "fattore di smorzamento dell'oscillatore"), "1", "1.5",
       Range::not_negative, "$ζ$"},
      {"m", both("mass of the oscillator", "massa dell'oscillatore"), "kg", "5", Range::positive, "$m$"},
      {"omega_n", both("natural circular frequency", "pulsazione naturale"), "rad/s", "0.2", Range::positive,
       "$ω_{n}$"},
      {"v_0", both("velocity at t = 0, in x = 0", "velocità per t = 0, in x = 0"), "m/s", "0.015", Range::any,
       "$v_{0}$"},
      {"dt", both("step of Euler's method", "passo del metodo di Eulero"), "s", "0.5", Range::positive, "Δ$t$"},
      {"m_p", both("mass of the pendulum", "massa del pendolo"), "kg", "5", Range::positive, "$m_{p}$"},
      {"I_G", both("moment of inertia about G", "momento d'inerzia baricentrico"), "kg m^2", "0.05",
       Range::not_negative, "$\\it{I}_{G}$"},
      {"r", both("distance A0G", "distanza A0G"), "m", "0.05", Range::not_negative, "$r$"},
      {"g", both("gravity", "accelerazione di gravità"), "m/s^2", "9.81", Range::positive, "$g$"},
      {"theta_0",
       both("angle of A0G from the downward vertical when let go", "angolo di A0G dalla verticale al rilascio"),
       "deg", "90", Range::any, "$θ_{0}$"},
      {"dt_p", both("step of the pendulum's table", "passo della tabella del pendolo"), "s", "0.01", Range::positive,
       "Δ$t_{p}$"},
  };
}

int Pendulum::against(int degrees) const {
  const Angle size = Rational(sign_of(theta_0)) * theta_0;
  return sign_of(size - Angle{Rational(degrees, 360)});
}

Problem::Problem(const Givens& givens)
    : oscillator{.zeta = givens["zeta"],
                 .m = givens["m"],
                 .v_0 = givens["v_0"],
                 .dt = givens["dt"],
                 .omega = givens.angle("omega_n")},
      pendulum{.m = givens["m_p"],
               .I_G = givens["I_G"],
               .r = givens["r"],
               .g = givens["g"],
               .dt = givens["dt_p"],
               .theta_0 = givens.angle("theta_0")} {
  const Words angle = told_degrees(pendulum.theta_0);
  require(oscillator.v_0 != 0, {"v_0 = 0 m/s: the mass stays in x = 0, as nothing sets it off",
                                "v_0 = 0 m/s: la massa resta in x = 0, nulla la mette in moto"});
  require(pendulum.r != 0,
          {"r = 0 m: hinged in its centre of mass the body has no moment of weight, and does not swing",
           "r = 0 m: incernierato nel baricentro il corpo non ha momento del peso, e non oscilla"});
  require(sign_of(pendulum.theta_0) != 0, {"theta_0 = 0 deg: let go at its lowest place the pendulum stays there",
                                           "theta_0 = 0 deg: lasciato nel punto più basso il pendolo vi resta"});
  require(pendulum.against(180) != 0,
          format_words(
              "theta_0 = {} deg: at rest in the upper equilibrium the pendulum stays there, and has no period",
              "theta_0 = {} deg: in quiete nell'equilibrio superiore il pendolo vi resta, e non ha periodo", angle));
  require(pendulum.against(180) < 0,
          format_words("theta_0 = {} deg must lie between -180 and 180: a pendulum let go at rest makes no full turn",
                       "theta_0 = {} deg deve stare tra -180 e 180: un pendolo lasciato fermo non fa giri completi",
                       angle));
  demand_steps("dt", oscillator.dt, Rational(1, 20), 20);
  demand_steps("dt_p", pendulum.dt, Rational(1, 1000), 1);
}

}  // namespace epure::oscillator_pendulum
