// SPDX-License-Identifier: MIT
// From printed constants back to the law: what is printed is an interval.
#include "fitting/constants/constants_fit.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "fitting/motions/same_motion.h"
#include "fitting/motions/simplest.h"
#include "kinematics/peaks.h"
#include "machines/registry.h"
#include "tests/kinematics/reference_data.h"

namespace camlaw::problems::constants_fit_test {
namespace {

using Catch::Contains;

ProblemStatement cutter() {
  return read_problem(
      "mechanism = 'spine-cutter'\n[law]\nname = 'cubic'\n[constants]\ndepth = '1 mm'\n",
      "cutter.toml");
}

ConstantsQuestion question_of(ProblemStatement machine, const std::string& constants) {
  ConstantsQuestion question{std::move(machine), {}};
  question.constants = parse_constants(constants, *question.machine.mechanism);
  return question;
}

ConstantsFit first_of(ProblemStatement machine, const std::string& constants) {
  const auto fits = rank_laws(question_of(std::move(machine), constants), laws_to_try());
  REQUIRE_FALSE(fits.empty());
  return fits.front();
}

/// "B=1.875, C=5.774, ...": peak constants in so many digits, those that the law has.
std::string printed(const Member& law, int digits) {
  const auto its = peaks(law.law());
  std::string text;
  for (const auto& [name, value] :
       {std::pair{"C_v", its.max_velocity()}, std::pair{"C_a", its.max_acceleration()},
        std::pair{"C_j", its.max_jerk()}, std::pair{"C_Mdyn", its.max_dynamic_moment()}}) {
    if (std::isnan(value)) continue;
    text += text.empty() ? "" : ", ";
    text += std::isinf(value) ? fmt::format("{}=inf", name)
                              : fmt::format("{}={:.{}g}", name, value, digits);
  }
  return text;
}

std::vector<std::string> disagreeing(const ConstantsFit& fit) {
  std::vector<std::string> result;
  for (const auto& c : fit.constants) {
    if (!c.agrees) result.push_back(c.printed.name);
  }
  return result;
}

}  // namespace

TEST_CASE("a printed number is an interval by its digits", "[constants]") {
  const Mechanism& law = find_mechanism("law");
  const Mechanism& machine = find_mechanism("spine-cutter");
  struct Case {
    std::string text;
    double low, high;
    int digits;
  };
  for (const Case& c : std::vector<Case>{{"B=1.6125", 1.61245, 1.61255, 5},
                                         {"C = 4.66", 4.655, 4.665, 3},
                                         {"C=4.660", 4.6595, 4.6605, 4},
                                         {"C=5", 4.5, 5.5, 1},
                                         {"C=1.5e1", 14.5, 15.5, 2},
                                         {"C=0.05", 0.045, 0.055, 1},
                                         {"C=4.66 +- 0.1", 4.56, 4.76, 2}}) {
    INFO(c.text);
    const auto constants = parse_constants(c.text, law);
    REQUIRE(constants.size() == 1);
    CHECK(constants[0].low == Approx(c.low).epsilon(1e-14));
    CHECK(constants[0].high == Approx(c.high).epsilon(1e-14));
    CHECK(constants[0].digits == c.digits);
  }
  // In the unit that it is printed in, and by a word that only one name has.
  const auto mm = parse_constants("minimum_cam_radius = 35.56 mm", machine);
  const auto cm = parse_constants("minimum_cam_radius=3.556 cm, peak_inertia_force=3.54N", machine);
  CHECK(mm[0].low == Approx(35.555));
  CHECK(cm[0].low == Approx(35.555));
  CHECK(cm[1].high == Approx(3.545));
  CHECK(std::isinf(parse_constants("D=inf", law)[0].value));
}

TEST_CASE("constants that are none are refused by name", "[constants]") {
  const Mechanism& machine = find_mechanism("spine-cutter");
  const auto complaint = [&](const std::string& text) -> std::string {
    try {
      parse_constants(text, machine);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(complaint(""), Contains("name=value"));
  CHECK_THAT(complaint("C_v"), Contains("'C_v'") && Contains("name=value"));
  CHECK_THAT(complaint("C_v=much"), Contains("'C_v'") && Contains("much"));
  CHECK_THAT(complaint("minimum_cam_radius=3 N"), Contains("minimum_cam_radius"));
  CHECK_THAT(complaint("minimum_cam_radios=3"), Contains("minimum_cam_radius"));
  CHECK_THAT(complaint("C_v=2,C_v=2"), Contains("'C_v'") && Contains("twice"));
  CHECK_THAT(complaint("stroke=40 mm"), Contains("size of the machine"));
  CHECK_THAT(complaint("inertia_force=3"), Contains("peak inertia_force"));
  CHECK_THAT(complaint("B=1.6 +- -1"), Contains("above zero"));
}

TEST_CASE("the simplest number between two", "[constants]") {
  struct Case {
    double low, high, value;
    int digits;
  };
  for (const Case& c : std::vector<Case>{{-3.0003, -2.9991, -3, 1},
                                         {47.6, 48.3, 48, 2},
                                         {0.16661, 0.16673, 1.0 / 6, 2},
                                         {0.1249, 0.1252, 0.125, 2},
                                         {-1, 1, 0, 1},
                                         {1234.1, 1234.9, 1234.5, 5},
                                         {5.1e-7, 5.9e-7, 5.5e-7, 2},
                                         {99.5, 100.7, 100, 1}}) {
    INFO(c.low << " to " << c.high);
    const SimpleNumber found = simplest_between(c.low, c.high);
    CHECK(found.value == Approx(c.value).epsilon(1e-12));
    CHECK(found.digits == c.digits);
    CHECK(found.value >= c.low);
    CHECK(found.value <= c.high);
  }
  CHECK(simplest_between(0.1, 0.1).value == 0.1);
}

TEST_CASE("the laws behind the spine cutter's table, from radius and force", "[constants]") {
  struct Row {
    std::string law, radius, force;
  };
  for (const Row& row : std::vector<Row>{{"polynomial-5 alpha=-3", "35.56", "3.54"},
                                         {"polynomial-5 alpha=-5", "37.21", "3.63"},
                                         {"cubic", "33.08", "4.56"},
                                         {"polynomial-7 A=48", "37.21", "4.33"}}) {
    INFO(row.law);
    // The printed forces are half the physical ones (reference: the study's notes).
    const std::string force = fmt::format("{} +- 0.01", 2 * std::stod(row.force));
    const ConstantsFit fit =
        first_of(cutter(), "minimum_cam_radius=" + row.radius + ", peak_inertia_force=" + force);
    CHECK(fit.consistent);
    CHECK(fit.law.name() == row.law);
  }
}

TEST_CASE("a family's coefficient with the interval that the digits leave", "[constants]") {
  for (const auto& [alpha, printed] :
       {std::pair{-3.0, "B=1.6125, C=4.66"}, std::pair{-5.0, "B=1.6875, C=4.782"}}) {
    const auto fits = fit_constants(question_of(law_alone(), printed), find_law("polynomial-5"));
    REQUIRE_FALSE(fits.empty());
    const ConstantsFit& fit = fits.front();
    CHECK(fit.consistent);
    CHECK(fit.identifiable);
    REQUIRE(fit.numbers.size() == 1);
    const FoundNumber& found = fit.numbers.front();
    CHECK(found.value == alpha);
    CHECK(found.low <= alpha);
    CHECK(found.high >= alpha);
    CHECK(found.high - found.low < 0.01);
    // At its ends, and not beyond, both constants agree.
    const double B_low = fit.constants[0].printed.low, B_high = fit.constants[0].printed.high;
    for (const double edge : {found.low, found.high}) {
      Member law = find_law("polynomial-5");
      const double beyond = edge + (edge - alpha) * 0.2;
      law.arguments.values()[0][0] = edge;
      const double B = peaks(law.law()).max_velocity();
      CHECK((B > B_low - 1e-9 && B < B_high + 1e-9));
      law.arguments.values()[0][0] = beyond;
      const auto out = peaks(law.law());
      const bool agrees = out.max_velocity() > B_low && out.max_velocity() < B_high &&
                          out.max_acceleration() > fit.constants[1].printed.low &&
                          out.max_acceleration() < fit.constants[1].printed.high;
      CHECK_FALSE(agrees);
    }
  }
}

TEST_CASE("where the print contradicts itself the constant that does is named", "[constants]") {
  // The sixth row of the table: radius 46.86 mm belongs to A = 6; the force is off a 20-step grid.
  const auto fits = fit_constants(
      question_of(cutter(), "minimum_cam_radius=46.86, peak_inertia_force=10.68 +- 0.01"),
      find_law("polynomial-7"));
  REQUIRE_FALSE(fits.empty());
  CHECK_FALSE(fits.front().consistent);
  CHECK(fits.front().numbers.at(0).value == 6);
  CHECK(disagreeing(fits.front()) == std::vector<std::string>{"peak_inertia_force"});
}

TEST_CASE("what the prints do not determine is said", "[constants]") {
  const auto fits =
      fit_constants(question_of(law_alone(), "B=1.6"), find_law("trapezoidal-velocity"));
  REQUIRE_FALSE(fits.empty());
  CHECK(fits.front().consistent);
  CHECK_FALSE(fits.front().identifiable);
  for (const FoundNumber& n : fits.front().numbers) CHECK_FALSE(n.identifiable);
}

TEST_CASE("a family as it is in the catalogue is tried however few the constants are",
          "[constants]") {
  struct Case {
    std::string law, constants;
  };
  for (const Case& c : std::vector<Case>{
           {"universal", "C_v=1.88, C_a_max=7.24, C_a_min=-4.13"},
           {"universal", "C_v=1.8772, C_a_max=7.2436, C_a_min=-4.1290, C_j_max=113.78"},
           {"scca", "C_v=1.667, C_a=5.728"},
           {"scca", "C_v=1.67, C_a=5.73"}}) {
    INFO(c.constants);
    const ConstantsFit fit = first_of(law_alone(), c.constants);
    CHECK(same_motion(fit.law, find_law(c.law)));
    CHECK(fit.cost == 0);
    CHECK(fit.consistent);
    // More numbers than constants: some are not determined, and the ranges hold the defaults.
    CHECK_FALSE(fit.identifiable);
    REQUIRE(fit.numbers.size() == find_law(c.law).family->parameters.size() - 1);
    for (const FoundNumber& n : fit.numbers) {
      INFO(n.name);
      CHECK(n.low <= n.value);
      CHECK(n.value <= n.high);
      CHECK(n.high > n.low);
    }
  }
}

TEST_CASE("a family that is held still leaves the machine its unknowns", "[constants]") {
  const Member law = find_law("scca");
  const auto its = peaks(law.law());
  ProblemStatement machine = read_problem(
      "mechanism = 'spine-cutter'\n[law]\nname = 'cubic'\n[constants]\ndepth = '1 mm'\n"
      "[variables.stroke]\nlower = '30 mm'\nupper = '50 mm'\nstart = '40 mm'\n",
      "cutter.toml");
  const auto fits =
      rank_laws(question_of(machine, fmt::format("C_v={:.5g}, C_a={:.5g}", its.max_velocity(),
                                                 its.max_acceleration())),
                {law});
  REQUIRE_FALSE(fits.empty());
  CHECK(fits.front().consistent);
  REQUIRE(fits.front().numbers.size() == 4);
  CHECK_FALSE(fits.front().numbers[0].of_law);
  CHECK_FALSE(fits.front().numbers[0].identifiable);
}

TEST_CASE("explanations stand by their digits, and members with a place in the catalogue take none",
          "[constants]") {
  for (const char* constants : {"C_v=1.69", "C_v=1.7", "C_v=2", "C_v=1.875, C_a=5.77"}) {
    INFO(constants);
    const auto fits = rank_laws(question_of(law_alone(), constants), laws_to_try());
    for (std::size_t i = 1; i < fits.size(); ++i) {
      INFO(fits[i - 1].law.name() << ", " << fits[i].law.name());
      CHECK(fits[i - 1].cost <= fits[i].cost);
    }
    for (const char* name : {"polynomial-5 alpha=-5", "polynomial-7 A=48"}) {
      for (const ConstantsFit& fit : fits) {
        if (fit.law.name() == name) CHECK(fit.cost == 0);
      }
    }
  }
  const auto fits = rank_laws(question_of(law_alone(), "C_v=1.69"), laws_to_try());
  REQUIRE(fits.size() > 1);
  CHECK(fits[0].law.name() == "polynomial-5 alpha=-5");
  CHECK(fits[0].numbers.size() == 1);  // the family's, with its range
  CHECK(fits[1].cost == 0);
}

TEST_CASE("rounded constants of every law of the reference name that law first",
          "[constants][heavy]") {
  for (auto& row : testing::read_table("problems/laws/motion_laws.csv")) {
    for (const int digits : {4, 6}) {
      const Member law = find_law(row["law"]);
      const std::string text = printed(law, digits);
      INFO(row["law"] << ": " << text);
      const auto fits = rank_laws(question_of(law_alone(), text), laws_to_try());
      REQUIRE_FALSE(fits.empty());
      CHECK(fits.front().law.name() == law.name());
      CHECK(fits.front().consistent);
      // No other motion explains the print as shortly: none is first by its place in a list alone.
      if (fits.size() > 1) CHECK(fits[1].cost > fits[0].cost);
    }
  }
}

TEST_CASE("members of families by their rounded constants", "[constants][heavy]") {
  // A trapezoid of velocity run backwards has the same sizes: this one is its own mirror image.
  for (const char* name :
       {"polynomial-5 alpha=-4", "polynomial-7 A=37", "trapezoidal-velocity t1=0.3 t2=0.3",
        "trapezoidal-acceleration ramp=0.1 constant=0.3", "elliptic n=1.3",
        "inclined-sinusoid angle=77", "scca a=0.2 b=0.4 c=0.3"}) {
    const Member law = find_law(name);
    const std::string text = printed(law, 6);
    INFO(name << ": " << text);
    const ConstantsFit fit = first_of(law_alone(), text);
    CHECK(fit.consistent);
    CHECK(same_motion(fit.law, law));
    for (const FoundNumber& n : fit.numbers) {
      CHECK(n.low <= n.value);
      CHECK(n.value <= n.high);
    }
  }
}

TEST_CASE("laws that print the same are both named", "[constants]") {
  // A trapezoid of velocity and the same run backwards: C = max |s''| does not tell which ramp is
  // the steeper one, its highest and lowest value do.
  const Member law = find_law("trapezoidal-velocity t1=0.2 t2=0.5");
  const Member family = find_law("trapezoidal-velocity");
  const auto fits = fit_constants(question_of(law_alone(), printed(law, 6)), family);
  REQUIRE(fits.size() == 2);
  CHECK(fits[0].cost == fits[1].cost);
  CHECK(fits[0].numbers[0].value == fits[1].numbers[1].value);
  CHECK(fits[0].numbers[1].value == fits[1].numbers[0].value);
  const auto told =
      fit_constants(question_of(law_alone(), "B=1.53846, C_max=7.69231, C_min=-3.07692"), family);
  REQUIRE(told.size() == 1);
  CHECK(same_motion(told[0].law, law));
}

TEST_CASE("a motion that has several names is one explanation", "[constants]") {
  const auto fits = rank_laws(question_of(law_alone(), "B=1.6125, C=4.66"), laws_to_try());
  REQUIRE_FALSE(fits.empty());
  // s' = q (4.2 + 9 q) of the catalogue's own member, with the range of its family's coefficient;
  // the Legendre series of degree five with c = (-1.8, 0) is the same polynomial.
  CHECK(fits[0].law.name() == "polynomial-5 alpha=-3");
  REQUIRE(fits[0].numbers.size() == 1);
  CHECK(fits[0].numbers[0].value == -3);
  REQUIRE(fits[0].also.size() == 1);
  CHECK(fits[0].also[0].family->name == "legendre");
  for (std::size_t i = 1; i < fits.size(); ++i) {
    CHECK_FALSE(same_motion(fits[0].law, fits[i].law));
  }
  CHECK(same_motion(find_law("poly-3-4-5"), find_law("polynomial-5 alpha=-10")));
  CHECK_FALSE(same_motion(find_law("poly-3-4-5"), find_law("polynomial-5 alpha=-9.999")));
}

TEST_CASE("an unknown size of the machine: the load factor behind the die press' table",
          "[constants]") {
  const auto factor = [](double cam, double spring, const std::string& printed) {
    const ProblemStatement machine = read_problem(
        fmt::format(
            "mechanism = 'die-press'\n[law]\nname = 'cubic'\n[constants]\ncam_force = {}\n"
            "spring_force = {}\n[variables.load_factor]\nlower = 0\nupper = 2\nstart = 0.5\n",
            cam, spring),
        "press.toml");
    return fit_constants(question_of(machine, printed), find_law("cubic"));
  };
  // Three rows were computed with 0.8 of the spring's force, the others with less and more, for
  // which there is no reason (reference: die_press.csv).
  struct Row {
    double cam, spring;
    std::string stress;
    double factor;
  };
  for (const Row& row : std::vector<Row>{{1967.35, 715.97, "267.766", 0.8003},
                                         {889.11, 386.19, "183.886", 0.8},
                                         {815.48, 354.08, "176.099", 0.8},
                                         {750.06, 306.92, "164.148", 0.667},
                                         {737.33, 340.28, "172.318", 0.925}}) {
    INFO(row.stress);
    const auto fits = factor(row.cam, row.spring, "contact_stress=" + row.stress);
    REQUIRE_FALSE(fits.empty());
    REQUIRE(fits.front().numbers.size() == 1);
    const FoundNumber& found = fits.front().numbers.front();
    CHECK(fits.front().consistent);
    CHECK(found.identifiable);
    CHECK(found.low < row.factor + 5e-4);
    CHECK(found.high > row.factor - 5e-4);
    CHECK(found.high - found.low < 1e-3);
  }
}

}  // namespace camlaw::problems::constants_fit_test
