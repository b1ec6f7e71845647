// SPDX-License-Identifier: MIT
#include "kinematics/laws/catalogue.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "numerics/scalar/dual.h"

namespace camlaw::catalogue_test {
namespace {

using Catch::Contains;

TEST_CASE("a law that is near by several of its names is suggested once", "[catalogue]") {
  for (const char* typed : {"modsine", "modified sinus", "cicloidal"}) {
    INFO(typed);
    std::string said;
    try {
      find_family(typed);
    } catch (const std::invalid_argument& error) {
      said = error.what();
    }
    const std::string suggested = said.substr(said.find("did you mean"));
    std::set<std::string> families;
    int count = 0;
    for (const Family& family : catalogue()) {
      std::set<std::string> names{family.name};
      names.insert(family.aliases.begin(), family.aliases.end());
      for (const std::string& name : names) {
        const std::string own = name == family.name ? name : name + " (" + family.name + ")";
        const bool is_there = suggested.find(" " + own + ",") != std::string::npos ||
                              suggested.find(" " + own + " or") != std::string::npos ||
                              suggested.find(" " + own + "?") != std::string::npos;
        if (!is_there) continue;
        families.insert(family.name);
        ++count;
      }
    }
    CHECK(count == 3);
    CHECK(families.size() == 3);
  }
}

TEST_CASE("Names and aliases of the catalogue are unique", "[catalogue]") {
  std::map<std::string, std::string> owner;
  for (const Family& family : catalogue()) {
    std::vector<std::string> names = family.aliases;
    names.push_back(family.name);
    for (const std::string& name : names) {
      CAPTURE(name, family.name, owner[name]);
      CHECK(owner[name].empty());
      owner[name] = family.name;
      CHECK(&find_family(name) == &family);
      CHECK_FALSE(name.empty());
    }
  }
  CHECK(catalogue().size() > 30);
}

TEST_CASE("Parameter names are unique in a family and default values in range", "[catalogue]") {
  for (const Family& family : catalogue()) {
    for (std::size_t i = 0; i < family.parameters.size(); ++i) {
      const Parameter& p = family.parameters[i];
      CAPTURE(family.name, p.name);
      CHECK(family.parameter(p.name) == i);
      CHECK(p.low < p.high);
      CHECK_FALSE(p.meaning.empty());
      CHECK_FALSE(p.unit.empty());
      CHECK((p.list || p.default_value.size() == 1));
      for (const double x : p.default_value) CHECK((x >= p.low && x <= p.high));
    }
  }
}

TEMPLATE_TEST_CASE("Default arguments make every law in every scalar", "[catalogue]", double, Dual,
                   Dual2, Interval) {
  for (const Family& family : catalogue()) {
    CAPTURE(family.name);
    const Law<TestType> law = family.make(family.defaults().as<TestType>());
    CHECK(std::abs(value_of(law(0.0).s)) <= 1e-12);
    CHECK(std::abs(value_of(law(1.0).s) - 1) <= 1e-12);
    if (family.ends != "by parameters") CHECK(to_string(law.ends()) == family.ends);
  }
}

TEST_CASE("A law is found however the words of its name are parted", "[catalogue]") {
  for (const char* name : {"modified sine", "Modified_Sine", "MODIFIED-SINE", "MS", "ms"}) {
    CHECK(find_law(name).family->name == "modified-sine");
  }
  for (const char* name : {"3-4-5", "poly 3 4 5", "poly_3_4_5", "3-4-5 polynomial"}) {
    CHECK(find_law(name).family->name == "poly-3-4-5");
  }
  CHECK(find_law("MT").family->name == "modified-trapezoid");
  CHECK(find_law("Bestehorn").family->name == "cycloidal");
  CHECK(find_law("modified sine crossover=0.4").arguments.scalar(0) == 0.4);
}

TEST_CASE("A law is found by its aliases in any case", "[catalogue]") {
  const std::pair<const char*, const char*> cases[] = {{"Cycloidal", "cycloidal"},
                                                       {"BESTEHORN-SINOIDE", "cycloidal"},
                                                       {"Косинусоїда", "cosine"},
                                                       {"синусоїда", "cycloidal"},
                                                       {"СО", "cycloidal"},
                                                       {"Modifizierte SINUSLINIE", "modified-sine"},
                                                       {"mcv50", "modified-sine-cv50"},
                                                       {"0000", "cubic"},
                                                       {"Polynom 5. Grades", "poly-3-4-5"},
                                                       {"поліном 5-ї степені", "polynomial-5"},
                                                       {"нахилена Синусоїда", "inclined-sinusoid"}};
  for (const auto& [typed, name] : cases) {
    CAPTURE(typed);
    CHECK(find_family(typed).name == name);
    CHECK(find_law(typed).family->name == name);
  }
}

TEST_CASE("Ukrainian capitals of every letter are folded", "[catalogue]") {
  CHECK(find_family("КОСИНУСОЇДА").name == "cosine");              // Ї
  CHECK(find_family("ПІВЕЛІПС").name == "half-ellipse-velocity");  // І
  CHECK(find_family("ПОЛІНОМ 7-Ї СТЕПЕНІ").name == "polynomial-7");
}

TEST_CASE("A law is asked for by name with its arguments", "[catalogue]") {
  const Member five = find_law("polynomial-5 alpha=-3");
  CHECK(five.law()(0.0).a == Approx(6 - 0.6 * 3).epsilon(1e-14));
  const Member other = find_law("polynomial-5 alpha=-7.5");
  CHECK(other.law()(0.0).a == Approx(6 - 0.6 * 7.5).epsilon(1e-14));
  const Member moved = find_law("polynomial-5   ALPHA=-3 crossover=0.4 ");
  CHECK(moved.family->name == "polynomial-5");
  CHECK(moved.arguments.scalar(1) == 0.4);
  const Member series = find_law("fourier a=0.1,-0.05");
  CHECK(series.arguments.list(0) == std::vector<double>{0.1, -0.05});
  // s' = 1 - sum a_n cos(2 pi n x), a_1 = 1 - 0.05: at x = 1/2 1 + 0.95 - 0.1 - 0.05.
  CHECK(series.law()(0.5).v == Approx(1.8).epsilon(1e-14));
  CHECK(find_law("Polynom 5. Grades mit Randwerten v0=0.5").law()(0.0).v == 0.5);
  CHECK(find_law("s-curve C=7 B=1.5").arguments.scalar(1) == 7);
  CHECK(find_law("stoddart exponents=3,5,7").law()(0.5).s ==
        Approx((35 / 8.0 - 42 / 32.0 + 15 / 128.0) / 8).epsilon(1e-14));
}

TEST_CASE("Angles are taken in the unit that the parameter names", "[catalogue]") {
  const Family& inclined = find_family("inclined-sinusoid");
  CHECK(inclined.parameters[0].unit == "deg");
  // B = 2 / (1 + cot(angle)): cot 90 = 0.
  CHECK(find_law("inclined-sinusoid angle=90").law()(0.5).v == Approx(2).epsilon(1e-14));
  CHECK(find_law("inclined-sinusoid angle=60").law()(0.5).v ==
        Approx(2 / (1 + 1 / std::sqrt(3.0))).epsilon(1e-13));
}

TEST_CASE("Unknown names are refused with the near ones", "[catalogue]") {
  CHECK_THROWS_AS(find_law("modifed-sine"), std::invalid_argument);
  CHECK_THROWS_WITH(find_law("modifed-sine"),
                    Contains("modifed-sine") && Contains("modified-sine"));
  CHECK_THROWS_WITH(find_law("cycloid4l"), Contains("cycloidal"));
  CHECK_THROWS_WITH(find_law("modified"), Contains("did you mean") && Contains("modified-"));
  CHECK_THROWS_WITH(find_law("zzzzqqqq"), Contains("camlaw laws") && !Contains("did you mean"));
  CHECK_THROWS_AS(find_law(""), std::invalid_argument);
  CHECK_THROWS_AS(find_law("alpha=3"), std::invalid_argument);
  CHECK_THROWS_AS(find_law("cubic 3"), std::invalid_argument);
}

TEST_CASE("Unknown parameters are refused with the known ones", "[catalogue]") {
  CHECK_THROWS_WITH(find_law("polynomial-5 beta=1"), Contains("polynomial-5") && Contains("beta") &&
                                                         Contains("alpha") &&
                                                         Contains("crossover"));
  CHECK_THROWS_WITH(find_law("constant-velocity x=1"), Contains("none"));
  CHECK_THROWS_WITH(find_law("polynomial-5 alpha=1 nonsense"),
                    Contains("polynomial-5") && Contains("nonsense"));
}

TEST_CASE("A value out of range is refused with law, parameter, value and range", "[catalogue]") {
  CHECK_THROWS_WITH(find_law("polynomial-5 alpha=31").law(),
                    Contains("polynomial-5") && Contains("alpha = 31") && Contains("-30 .. 30"));
  CHECK_THROWS_WITH(find_law("fourier a=0.1,99").law(), Contains("fourier") && Contains("99"));
  CHECK_THROWS_AS(find_law("polynomial-5 alpha=nan").law(), std::invalid_argument);
  CHECK_THROWS_AS(find_law("polynomial-5 alpha=inf").law(), std::invalid_argument);
  CHECK_THROWS_WITH(find_law("polynomial-5 alpha=1,2").law(), Contains("one value"));
  CHECK_THROWS_WITH(find_law("b-spline degree=2.5").law(), Contains("an integer"));
  CHECK_NOTHROW(find_law("polynomial-5 alpha=30").law());
}

TEST_CASE("What is not a number is refused with law, parameter and text", "[catalogue]") {
  for (const char* typed : {"polynomial-5 alpha=x", "polynomial-5 alpha=1x", "polynomial-5 alpha=",
                            "polynomial-5 alpha=1,", "polynomial-5 alpha=1e999"}) {
    CAPTURE(typed);
    CHECK_THROWS_WITH(find_law(typed),
                      Contains("polynomial-5") && Contains("alpha") && Contains("not a number"));
  }
}

TEST_CASE("A set of arguments that makes no law is refused with the law's name", "[catalogue]") {
  CHECK_THROWS_WITH(find_law("scca a=0.9 b=0.9").law(),
                    Contains("law 'scca'") && Contains("add up"));
  CHECK_THROWS_WITH(find_law("stoddart exponents=3,3").law(), Contains("law 'stoddart'"));
  CHECK_THROWS_WITH(find_law("triple-harmonic h1=3").law(), Contains("law 'triple-harmonic'"));
  CHECK_THROWS_WITH(find_law("table s=0,1").law(), Contains("law 'table'"));
  const Family& family = find_family("polynomial-5");
  const Arguments<double> one(std::vector<std::vector<double>>{{1.0}});
  CHECK_THROWS_WITH(family.make(one), Contains("2 parameters"));
}

TEST_CASE("What makes no law is told by value in the sentence that is thrown", "[catalogue]") {
  for (const char* name :
       {"polynomial-5 alpha=31", "scca a=0.9 b=0.9", "scca a=0 b=0 c=0", "universal d1=0.9",
        "trapezoidal-velocity t1=0.6 t2=0.6", "trapezoidal-acceleration ramp=0.2 constant=0.2",
        "s-curve B=2 C=8 D=16", "s-curve B=2 C=8 D=32,64", "stoddart exponents=3,3",
        "triple-harmonic h1=3", "b-spline knots=0.5", "b-spline degree=2.5", "table s=0,1",
        "table x=0,0.5,0.4,1 s=0,0.1,0.2,1"}) {
    const Member member = find_law(name);
    const auto law = member.possible_law();
    CAPTURE(name);
    REQUIRE_FALSE(law);
    CHECK_THAT(law.why(), Contains("law '" + member.family->name + "'"));
    CHECK_THROWS_WITH(member.law(), Catch::Matchers::Equals(law.why()));
    CHECK_FALSE(member.possible_law<Dual>());
    CHECK_FALSE(member.possible_law<Interval>());
  }
}

TEST_CASE("A mistake in a family's formula is not taken for arguments without a law",
          "[catalogue]") {
  Family family = find_family("cubic");
  family.maker = []<class S>(const Arguments<S>& a) -> Law<S> {
    if (a.size() == 1) throw std::invalid_argument("a mistake");
    return find_law("cubic").law<S>();
  };
  CHECK_THROWS_WITH(family.possible(family.defaults()), Catch::Matchers::Equals("a mistake"));
}

TEST_CASE("An S-curve takes one jerk at most", "[catalogue]") {
  CHECK_THROWS_AS(find_law("s-curve B=2 C=8 D=32,64").law(), std::invalid_argument);
}

TEST_CASE("A member's name reads back as the member", "[catalogue]") {
  CHECK(find_law("cubic").name() == "cubic");
  CHECK(find_law("0000").name() == "cubic");
  CHECK(find_law("polynomial-5 alpha=-4.5").name() == "polynomial-5 alpha=-4.5");
  CHECK(find_law("polynomial-5 crossover=0.4 alpha=-4.5").name() ==
        "polynomial-5 alpha=-4.5 crossover=0.4");
  CHECK(find_law("fourier a=0.1,-0.05").name() == "fourier a=0.1,-0.05");
  CHECK(find_law("scca a=0.2").name() == "scca a=0.2 b=0.2 c=0.3");
  CHECK(find_law("elliptic crossover=0.5").name() == "elliptic n=1.2");
  CHECK(find_law("s-curve").name() == "s-curve C_v=1.6 C_a=5.8");
  for (const char* typed :
       {"polynomial-7 A=0.1", "s-curve C_a=7 C_v=1.5", "universal d1=0.123456789012345",
        "polynomial-5 alpha=-3 crossover=0.25", "elliptic n=3e-1"}) {
    const Member member = find_law(typed), again = find_law(member.name());
    CAPTURE(typed, member.name());
    CHECK(again.family == member.family);
    CHECK(again.arguments.values() == member.arguments.values());
  }
}

TEST_CASE("A list emptied of its default values has a name that reads back", "[catalogue]") {
  Member member = find_law("fourier");
  member.arguments.values()[0].clear();
  const Member again = find_law(member.name());
  CHECK(again.arguments.list(0).empty());
}

}  // namespace
}  // namespace camlaw::catalogue_test
