// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "optim/search/optimise.h"
#include "optim/search/plan.h"
#include "problems/statement/bind.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

/// Responses and machines that a problem file states.
namespace camlaw::problems::own_formulas_test {
namespace {

using Catch::Matchers::Contains;

ProblemStatement read(const std::string& toml) { return read_problem(toml, "own.toml"); }

EvaluatedResponse evaluated(const ProblemStatement& problem, const std::string& name) {
  for (const EvaluatedResponse& response : evaluate(problem)) {
    if (response.name == name) return response;
  }
  throw std::logic_error("there is no " + name);
}

std::string refusal(const std::string& toml) {
  try {
    read(toml);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

/// A response of a mechanism, built in and as a formula of the file's.
struct Twin {
  const char* mechanism;
  const char* moved;  ///< [law] or [program]
  const char* built_in;
  const char* unit;
  const char* formula;
};
constexpr const char* kLaw = "[law]\nname = \"polynomial-5\"\n";
constexpr const char* kProgram =
    "[[program.segments]]\nname = \"rise\"\nangle = \"100 deg\"\nlaw = \"modified-sine\"\n"
    "[[program.segments]]\nname = \"high\"\nangle = \"50 deg\"\n"
    "[[program.segments]]\nname = \"return\"\nangle = \"120 deg\"\nlaw = \"cycloidal\"\n"
    "[[program.segments]]\nname = \"low\"\n";
const Twin kTwins[] = {
    {"die-press", kLaw, "running_force", "N",
     "mass * stroke * (speed / pi)^2 * a + spring_rate * stroke * s + spring_preload"},
    {"die-press", kLaw, "running_stress", "MPa",
     "0.42 * sqrt(E * (1 / R1 + 1 / R2) * (mass * stroke * (speed / pi)^2 * a + spring_rate * "
     "stroke * s "
     "+ spring_preload) / face_width)"},
    {"helical-spring", "", "rate", "N/mm", "G * d^4 / (8 * D^3 * n)"},
    {"helical-spring", "", "active_mass", "kg",
     "density * pi * wire_diameter^2 / 4 * pi * mean_diameter * active_coils"},
    {"disc-cam-roller", kProgram, "pressure_angle", "deg",
     "atan((stroke * v / (2 * pi) - offset) / (stroke * s + sqrt((base_radius + roller_radius)^2 - "
     "offset^2)))"},
    {"disc-cam-roller", kProgram, "acceleration", "m/s2", "stroke * (speed / (2 * pi))^2 * a"},
};

}  // namespace

TEST_CASE("a formula of the file's gives the built-in numbers", "[formula][problems]") {
  std::mt19937_64 random(3);
  for (const Twin& twin : kTwins) {
    INFO(twin.mechanism << " " << twin.built_in);
    const ProblemStatement problem =
        read(fmt::format("mechanism = \"{}\"\n{}[responses.own]\nformula = \"{}\"\nunit = \"{}\"\n",
                         twin.mechanism, twin.moved, twin.formula, twin.unit));
    const EvaluatedResponse built_in = evaluated(problem, twin.built_in);
    const EvaluatedResponse own = evaluated(problem, "own");
    REQUIRE(own.is_curve == built_in.is_curve);
    CHECK(own.proved);
    CHECK(own.value == Approx(built_in.value).epsilon(1e-13));
    CHECK(own.highest == Approx(built_in.highest).epsilon(1e-13));
    CHECK(own.lowest == Approx(built_in.lowest).epsilon(1e-13));
    CHECK(own.along == built_in.along);
  }
}

TEST_CASE("a formula of the file's has the built-in derivatives and bounds",
          "[formula][problems]") {
  const ProblemStatement problem = read(R"(
mechanism = "die-press"
[law]
name = "polynomial-5"
[responses.own]
formula = "mass * stroke * (speed / pi)^2 * a + spring_rate * stroke * s + spring_preload"
unit = "N"
[variables.alpha]
lower = -8
upper = 0
[variables.stroke]
lower = "20 mm"
upper = "60 mm"
[variables.speed]
lower = 60
upper = 200
[objective]
minimize = "peak own"
[[constraints]]
response = "running_force"
lower = 0
)");
  const optim::Problem bound = BoundProblem(problem).problem({});
  const auto& own = bound.objectives.front().response.curve();
  const auto& built_in = bound.constraints.front().response.curve();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 50; ++i) {
    const std::vector<double> x{-8 * share(random), 20 + 40 * share(random),
                                60 + 140 * share(random)};
    const optim::Place place{360 * share(random)};
    const optim::Function f = own.at(place), g = built_in.at(place);
    REQUIRE(f.inputs() == g.inputs());
    std::vector<double> df(3), dg(3), hf(6), hg(6);
    const double scale = std::abs(g.hessian(x, dg, hg)) + 1000;
    CHECK(f.hessian(x, df, hf) == Approx(g.value(x)).margin(1e-12 * scale));
    for (std::size_t k = 0; k < 3; ++k) CHECK(df[k] == Approx(dg[k]).margin(1e-12 * scale));
    for (std::size_t k = 0; k < 6; ++k) CHECK(hf[k] == Approx(hg[k]).margin(1e-12 * scale));
    const auto trace = own.trace(x), other = built_in.trace(x);
    const double from = 360 * share(random), to = std::min(360.0, from + 5);
    if (std::floor(from / 180) != std::floor(to / 180)) continue;
    const optim::Bounds over = trace->enclose(from, to), wanted = other->enclose(from, to);
    CHECK(over.lower == Approx(wanted.lower).margin(1e-9 * scale));
    CHECK(over.upper == Approx(wanted.upper).margin(1e-9 * scale));
    const auto at = trace->at(place), same = other->at(place);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(at[k] == Approx(same[k]).epsilon(1e-11).margin(1e-10 * scale));
  }
}

TEST_CASE("formulas hold peaks, searched numbers and one another", "[formula][problems]") {
  const ProblemStatement problem = read(R"(
mechanism = "die-press"
[law]
name = "polynomial-5"
[responses.swing]
formula = "highest running_force - least_force"
unit = "kN"
[responses.twice]
formula = "2 * swing + peak own"
unit = "N"
[responses.own]
formula = "running_force / 2"
unit = "N"
)");
  const EvaluatedResponse force = evaluated(problem, "running_force");
  CHECK(evaluated(problem, "swing").value ==
        Approx((force.highest - force.lowest) / 1000).epsilon(1e-12));
  CHECK(evaluated(problem, "twice").value ==
        Approx(2 * (force.highest - force.lowest) + force.highest / 2).epsilon(1e-12));
}

TEST_CASE("formulas hold curves over a shaft's turn, and what those search for",
          "[formula][problems]") {
  const ProblemStatement problem = read(R"toml(
mechanism = "balancing-cam"
[constants]
lift_off = "15 deg"
[responses.own]
formula = "residual_torque / mean_torque - 1 + surplus_range / surplus_range"
[responses.place]
formula = "angle / (1 deg) / 360 - x + select(angle - lift_off, 0, 1)"
[responses.even]
formula = "peak own"
)toml");
  const EvaluatedResponse torque = evaluated(problem, "residual_torque");
  const EvaluatedResponse own = evaluated(problem, "own");
  const double mean = evaluated(problem, "mean_torque").value;
  // The torque jumps at the lift-off, where it is greatest: the formula has the same sections.
  CHECK(own.highest == Approx(torque.highest / mean).epsilon(1e-12));
  CHECK(own.highest_at == torque.highest_at);
  CHECK(own.proved);
  CHECK(evaluated(problem, "even").value == Approx(own.highest).epsilon(1e-12));
  for (const optim::Response& curve : curves_of(problem)) {
    if (curve.name != "place") continue;
    CHECK(curve.curve().trace({})->at({10})[0] == Approx(1));
    CHECK(curve.curve().trace({})->at({200})[0] == Approx(0).margin(1e-14));
  }
}

TEST_CASE("a formula looks for the root of a condition", "[formula][problems]") {
  // The angle at which a rod of length l over a crank of radius r stands square to it.
  const ProblemStatement problem = read(R"toml([machine]
[machine.parameters.r]
unit = "mm"
default = 30
lower = 1
[machine.parameters.l]
unit = "mm"
default = 90
lower = 1
[responses.square]
formula = "root(y, 0, 90 deg, l * cos(y) - r * sin(y))"
unit = "deg"
)toml");
  const double angle = std::atan2(90, 30);
  CHECK(evaluated(problem, "square").value ==
        Approx(angle * 180 / std::numbers::pi).epsilon(1e-13));
}

TEST_CASE("the angle of a formula is that of the whole cycle", "[formula][problems]") {
  const ProblemStatement problem = read(fmt::format(R"toml(
mechanism = "die-press"
{}[responses.wave]
formula = "sin(angle)"
[responses.place]
formula = "x * angle"
unit = "rad"
)toml",
                                                    kLaw));
  // The press runs its law forth in one half of the turn and back in the other.
  for (const optim::Response& curve : curves_of(problem)) {
    for (const double degrees : {10.0, 100.0, 190.0, 350.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      const double at = curve.curve().trace({})->at({degrees})[0];
      if (curve.name == "wave") CHECK(at == Approx(std::sin(angle)).margin(1e-13));
      if (curve.name == "place") CHECK(at == Approx(degrees / 360 * angle).epsilon(1e-13));
    }
  }
}

TEST_CASE("a machine of the file's own is worked out as its closed forms", "[formula][problems]") {
  const ProblemStatement problem =
      read_problem_file(testing::source("problems/own/slider_crank.toml"));
  const double r = 0.04, l = 0.16, omega = 120 * std::numbers::pi / 30;
  const EvaluatedResponse angle = evaluated(problem, "rod_angle");
  CHECK(angle.highest == Approx(std::asin(r / l) * 180 / std::numbers::pi).epsilon(1e-12));
  CHECK(angle.highest_at == Approx(90).margin(1e-4));
  CHECK(evaluated(problem, "displacement").highest == Approx(80).epsilon(1e-12));
  // At the top dead centre the acceleration is r omega^2 (1 + r / l).
  const EvaluatedResponse acceleration = evaluated(problem, "acceleration");
  CHECK(acceleration.highest == Approx(r * omega * omega * (1 + r / l)).epsilon(1e-12));
  // The acceleration is the second derivative of the displacement.
  for (const optim::Response& curve : curves_of(problem)) {
    if (curve.name != "displacement") continue;
    const double per_degree = curve.curve().trace({})->at({77})[2];
    const double by_time = per_degree * 1e-3 * std::pow(omega * 180 / std::numbers::pi, 2);
    for (const optim::Response& other : curves_of(problem)) {
      if (other.name == "acceleration") {
        CHECK(other.curve().trace({})->at({77})[0] == Approx(by_time).epsilon(1e-10));
      }
    }
  }
}

TEST_CASE("a curve with a pole is not said to have proved ends", "[formula][problems]") {
  for (const char* formula :
       {"(angle - 1)^-1", "1 / (angle - 1)", "(angle^2 - 1)^-3", "tan(angle)",
        "(log(angle + 1) - 0.5)^-1", "max((angle - 1)^-1, 0)", "1 / (angle - 1) / abs(angle)"}) {
    INFO(formula);
    const ProblemStatement problem =
        read(fmt::format("[machine]\n[responses.own]\nformula = \"{}\"\n", formula));
    const EvaluatedResponse own = evaluated(problem, "own");
    const bool is_known = std::isinf(own.highest) || std::isinf(own.lowest);
    CHECK((is_known || !own.proved));
    if (own.proved) CHECK((std::isinf(own.highest) || own.highest > 1e6));
  }
}

TEST_CASE("what is wrong with responses and machines of a file is said", "[formula][problems]") {
  const std::string die = "mechanism = \"die-press\"\n" + std::string(kLaw);
  const auto of = [&](const std::string& name, const std::string& rest) {
    return refusal(die + "[responses." + name + "]\n" + rest);
  };
  CHECK_THAT(of("own", "unit = \"N\"\n"), Contains("responses.own: formula is missing"));
  CHECK_THAT(
      of("own", "formula = \"mass\"\n"),
      Contains("responses.own.formula: the formula is a mass (kg), but its unit 1 is a plain"));
  CHECK_THAT(
      of("own", "formula = \"mas\"\nunit = \"kg\"\n"),
      Contains("own.toml:5: responses.own.formula: at character 1: die-press has no response "
               "or parameter 'mas'; did you mean mass"));
  CHECK_THAT(of("mass", "formula = \"1\"\n"), Contains("die-press has a parameter of this name"));
  CHECK_THAT(of("load", "formula = \"1\"\n"), Contains("die-press has a response of this name"));
  CHECK_THAT(of("least_force", "formula = \"1\"\n"), Contains("has a response of this name"));
  CHECK_THAT(of("a", "formula = \"1\"\n"), Contains("'a' means something else in problem files"));
  CHECK_THAT(of("\"two words\"", "formula = \"1\"\n"), Contains("is not a name for formulas"));
  CHECK_THAT(of("own", "formula = \"own\"\n"), Contains("own refers to itself"));
  CHECK_THAT(of("x1", "formula = \"x2\"\n[responses.x2]\nformula = \"x1\"\n"),
             Contains("refer to one another in a circle: x1, x2, x1"));
  CHECK_THAT(of("own", "formula = \"running_force + peak running_force\"\nunit = \"N\"\n"),
             Contains("the formula of a curve cannot use a number that is found by a search"));
  CHECK_THAT(of("own", "formula = \"1\"\nunit = \"furlong/blink\"\n"), Contains("is not a unit"));
  CHECK_THAT(of("own", "formul = \"1\"\n"), Contains("unknown key; did you mean formula?"));
  CHECK_THAT(refusal("[machine]\nmoved_by = \"law\"\n" + std::string(kLaw)),
             Contains("the machine has no responses"));
  CHECK_THAT(refusal("mechanism = \"law\"\n[machine]\n"),
             Contains("the file names a mechanism too"));
  CHECK_THAT(refusal("[machine]\nname = \"die-press\"\n"),
             Contains("is a mechanism of this program"));
  CHECK_THAT(refusal("[machine.parameters.r]\nunit = \"mm\"\n[responses.own]\nformula = \"1\"\n"),
             Contains("machine.parameters.r: default is missing"));
  CHECK_THAT(refusal("[machine]\n[machine.parameters.r]\ndefault = 5\nupper = 4\n"),
             Contains("is not within"));
  CHECK_THAT(refusal("[machine]\n[machine.parameters.r]\nunit = \"mm\"\ndefault = 5\nlower = 6\n"
                     "upper = 4\n"),
             Contains("machine.parameters.r: lower 6 mm exceeds upper 4 mm"));
  CHECK_THAT(refusal("[machine]\n[responses.own]\nformula = \"s + angle\"\n"),
             Contains("is moved by its geometry and has no law, so there is no s"));
  CHECK_THAT(refusal("[machine]\nmoved_by = \"law\"\n[responses.own]\nformula = \"angle\"\n" +
                     std::string(kLaw)),
             Contains("run over x, the law's abscissa from 0 to 1, not over an angle"));
}

TEST_CASE("formulas of formulas are bounded in work", "[formula][problems]") {
  // Each holds the two before it: worked out one by one they would take 1.6^40 steps.
  std::string file =
      "[machine]\n[responses.f0]\nformula = \"angle\"\n[responses.f1]\nformula = \"angle\"\n";
  for (int i = 2; i < 40; ++i) {
    file += fmt::format("[responses.f{}]\nformula = \"f{} + f{}\"\n", i, i - 1, i - 2);
  }
  CHECK(evaluated(read(file), "f39").highest > 1e8);
}

TEST_CASE("rules find the shapes of formulas", "[formula][problems]") {
  const auto shape = [](const std::string& formula, const std::string& varying) {
    std::string file = "[machine]\n";
    for (const char* name : {"b", "c", "d"}) {
      file += fmt::format("[machine.parameters.{}]\ndefault = 1\nlower = {}\nupper = 10\n", name,
                          *name == 'd' ? -10.0 : 0.1);
    }
    file += "[responses.own]\nformula = \"" + formula + "\"\n";
    for (const char name : varying) {
      file += fmt::format("[variables.{}]\nlower = 0.5\nupper = 2\n", name);
    }
    file += "[objective]\nminimize = \"own\"\n";
    return BoundProblem(read(file)).problem({}).objectives.front().response.shape();
  };
  using S = optim::Shape;
  CHECK(shape("b + 2 * c - d", "bcd") == S::Linear);
  CHECK(shape("b * c", "b") == S::Linear);
  CHECK(shape("b * c", "bc") == S::Quasiconcave);
  CHECK(shape("b * d", "bd") == S::General);
  CHECK(shape("d^2 + abs(d - b)", "bd") == S::Convex);
  CHECK(shape("-(d^2)", "d") == S::Concave);
  CHECK(shape("d * d", "d") == S::Convex);
  CHECK(shape("b^2", "b") == S::Quasilinear);
  CHECK(shape("d^3", "d") == S::Quasilinear);
  CHECK(shape("1 / b + 1 / c", "bc") == S::Convex);
  CHECK(shape("(b + d) / (b + c)", "bcd") == S::Quasilinear);
  CHECK(shape("b / d", "bd") == S::General);
  CHECK(shape("sqrt(b + c)", "bc") == S::Quasilinear);
  CHECK(shape("sqrt(b) + log(c)", "bc") == S::Concave);
  CHECK(shape("exp(b - c) + max(b, c, d)", "bcd") == S::Convex);
  CHECK(shape("min(b, c - 1, 2)", "bc") == S::Concave);
  CHECK(shape("max(d, 0)^2", "d") == S::Convex);
  CHECK(shape("sin(d)", "d") == S::General);
  CHECK(shape("sqrt(d^2 - 1)", "d") == S::General);
  CHECK(shape("log(b - d)", "bd") == S::Quasilinear);
  CHECK(shape("asin(d)", "d") == S::Quasilinear);
  CHECK(shape("asin(d^2 - 1)", "d") == S::General);
  CHECK(shape("b + 0 * sqrt(d^2 - 1)", "d") == S::General);
  CHECK(shape("b * exp(b)", "b") == S::Convex);
  CHECK(shape("b - 1 / b", "b") == S::Concave);
  CHECK(shape("b + 1 / b", "b") == S::Convex);
  CHECK(shape("c", "c") == S::Linear);
}

TEST_CASE("samples do not refute the shapes that rules find", "[formula][problems]") {
  std::mt19937_64 random(8);
  const char* parts[] = {"b", "c", "d", "2", "b", "c"};
  const char* patterns[] = {"({} + {})", "({} - {})",   "({} * {})",
                            "({} / {})", "max({}, {})", "min({}, {})"};
  const char* singles[] = {"sqrt({})", "exp({})",  "abs({})", "({})^2", "({})^3",
                           "({})^-1",  "({})^0.5", "log({})", "-({})",  "atan({})"};
  const auto grown = [&](auto&& self, int depth) -> std::string {
    if (depth == 0) return parts[random() % std::size(parts)];
    if (random() % 3 == 0) {
      return fmt::format(fmt::runtime(singles[random() % std::size(singles)]),
                         self(self, depth - 1));
    }
    const char* pattern = patterns[random() % std::size(patterns)];
    const std::string left = self(self, depth - 1);
    return fmt::format(fmt::runtime(pattern), left, self(self, depth - 1));
  };
  int known = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string formula = grown(grown, 1 + static_cast<int>(random() % 3));
    std::string file = "[machine]\n";
    for (const char* name : {"b", "c", "d"}) {
      file += fmt::format(
          "[machine.parameters.{}]\ndefault = 1\nlower = {}\nupper = 3\n"
          "[variables.{}]\nlower = {}\nupper = 3\n",
          name, *name == 'd' ? -3.0 : 0.2, name, *name == 'd' ? -3.0 : 0.2);
    }
    file += "[responses.own]\nformula = \"" + formula + "\"\n[objective]\nminimize = \"own\"\n";
    const optim::Problem problem = BoundProblem(read(file)).problem({});
    const optim::Response& response = problem.objectives.front().response;
    const optim::Shape shape = response.shape();
    if (shape == optim::Shape::General) continue;
    ++known;
    INFO(formula << ", shape " << static_cast<int>(shape));
    std::uniform_real_distribution<double> positive(0.2, 3), any(-3, 3), share(0, 1);
    for (int k = 0; k < 40; ++k) {
      std::vector<double> p{positive(random), positive(random), any(random)};
      std::vector<double> q{positive(random), positive(random), any(random)};
      const double t = share(random);
      std::vector<double> m(3);
      for (std::size_t n = 0; n < 3; ++n) m[n] = (1 - t) * p[n] + t * q[n];
      const double fp = response.function().value(p), fq = response.function().value(q);
      const double fm = response.function().value(m);
      if (!std::isfinite(fp) || !std::isfinite(fq)) continue;
      REQUIRE(std::isfinite(fm));  // where it has values is convex as well
      const double e = 1e-9 * (std::abs(fp) + std::abs(fq) + std::abs(fm));
      if (optim::is_convex(shape)) CHECK(fm <= (1 - t) * fp + t * fq + e);
      if (optim::is_concave(shape)) CHECK(fm >= (1 - t) * fp + t * fq - e);
      if (optim::convex_below(shape)) CHECK(fm <= std::max(fp, fq) + e);
      if (optim::convex_above(shape)) CHECK(fm >= std::min(fp, fq) - e);
    }
  }
  CHECK(known > 300);
}

TEST_CASE("linear problems go to Clp by their shapes alone", "[formulas]") {
  const auto solver_of = [](const std::string& toml) {
    const optim::Problem problem = BoundProblem(read(toml)).space().problem({});
    return optim::plan(problem, "auto").solvers.front()->name();
  };
  // A formula of the file's own; a coefficient of a polynomial family, whose curves it enters
  // linearly.
  const std::string own =
      "[machine]\nname = 'mix'\n[machine.parameters.p]\ndefault = '1'\nlower = 0\nupper = 9\n"
      "meaning = 'a part'\n[machine.parameters.q]\ndefault = '1'\nlower = 0\nupper = 9\n"
      "meaning = 'another'\n[responses.cost]\nformula = '2 * p + q'\nmeaning = 'what it costs'\n"
      "[responses.more]\nformula = '2 * p + q^2'\nmeaning = 'what it costs else'\n"
      "[responses.worth]\nformula = 'p + 3 * q'\nmeaning = 'what it is worth'\n"
      "[variables.p]\nlower = 0\nupper = 9\n[variables.q]\nlower = 0\nupper = 9\n"
      "[[constraints]]\nresponse = 'worth'\nlower = 4\n[objective]\n";
  CHECK(solver_of(own + "minimize = 'cost'\n") == "clp");
  CHECK(solver_of(own + "minimize = 'more'\n") == "slsqp");
  const std::string family =
      "mechanism = 'spine-cutter'\n[law]\nname = 'polynomial-5'\n[variables.alpha]\nlower = -9\n"
      "upper = 3\n[objective]\nminimize = ";
  CHECK(solver_of(family + "'peak_inertia_force'\n") == "interior");
}

}  // namespace camlaw::problems::own_formulas_test
