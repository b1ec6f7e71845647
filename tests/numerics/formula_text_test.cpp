// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "numerics/formula/formula_lines.h"
#include "numerics/formula/formula_writer.h"

namespace camlaw {
namespace {

/// Lengths x and y, in m, a mass m and plain numbers p and q.
struct Name {
  const char* name;
  double value;
  const char* unit;
};
constexpr Name kNames[] = {
    {"x", 0.7, "m"}, {"y", -1.3, "m"}, {"m", 2.5, "kg"}, {"p", 0.4, "1"}, {"q", -3, "1"}};

Formula recorded(const std::string& text) {
  const FormulaTree tree = parse_formula(text);
  return Formula::record(std::size(kNames), [&](std::span<const Expression> u) {
    return write_formula(tree,
                         [&](const FormulaTree& name) -> WrittenQuantity {
                           for (std::size_t i = 0; i < u.size(); ++i) {
                             if (name.full_name() == kNames[i].name) {
                               return {u[i], si_unit(kNames[i].unit).dimension};
                             }
                           }
                           throw std::invalid_argument("unknown: " + name.full_name());
                         })
        .value;
  });
}

double value_of_text(const std::string& text) {
  std::vector<double> u;
  for (const Name& name : kNames) u.push_back(name.value);
  return recorded(text)(std::span<const double>(u));
}

std::string refusal(const std::string& text) {
  try {
    recorded(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("formulas are read as people read them", "[formula]") {
  const auto check = [](const char* text, double wanted) {
    INFO(text);
    CHECK(value_of_text(text) == Approx(wanted).epsilon(1e-14));
  };
  check("1 + 2 * 3", 7);
  check("2 * 3 - 4 / 5 / 2", 5.6);
  check("-p^2", -0.16);
  check("(-p)^2", 0.16);
  check("2^3^2", 512);
  check("2^-1", 0.5);
  check("q^2^1", 9);
  check("q^(4 / 2)", 9);
  check("q^0", 1);
  check("+p - -q", 0.4 - 3);
  check("  ( ( p ) ) ", 0.4);
  check("q^3", -27);
  check("p^0.5", std::sqrt(0.4));
  check("p^(1/3)", std::cbrt(0.4));
  check("p^p", std::pow(0.4, 0.4));
  check("q^-2", 1.0 / 9);
  check("q^sqrt(4)", 9);
  check("q^min(3, 2 + sqrt(4))", -27);
  // Of -0, whose reciprocal is -infinity, root and size are 0.
  check("atan(1 / abs(-(p - p)))", std::numbers::pi / 2);
  check("atan(1 / sqrt(-(p - p)))", std::numbers::pi / 2);
  check("atan(1 / along(p, -(p - p)))", std::numbers::pi / 2);
  check(".5 + 1e-3 + 2.", 2.501);
  check("30 deg", std::numbers::pi / 6);
  check("30°", std::numbers::pi / 6);
  check("1 rpm * 1 [s]", std::numbers::pi / 30);
  check("9.81 [m/s^2] * m / (1 N)", 9.81 * 2.5);
  check("5 %", 0.05);
  check("x / (1 mm)", 700);
  check("sqrt(x^2 + y^2) / (1 m)", std::hypot(0.7, 1.3));
  check("abs(y) / (1 m)", 1.3);
  check("sign(q) + sign(p) + sign(0)", 0);
  check("min(p, q, 2) + 10 * max(p, q, 2)", 17);
  check("max(0, x) / x", 1);
  check("min(y, 0) / (1 m)", -1.3);
  check("exp(p) + log(p) - ln(p) + log10(1000)", std::exp(0.4) + 3);
  check("sin(p)^2 + cos(p)^2 + tan(p) - sin(p) / cos(p)", 1);
  check("asin(p) + acos(p)", std::numbers::pi / 2);
  check("atan(q)", std::atan(-3));
  check("atan2(p, q)", std::atan2(0.4, -3));
  check("atan2(x, y)", std::atan2(0.7, -1.3));
  check("pi", std::numbers::pi);
  check("select(q, 1, 2) + select(p, 10, 20)", 12);
  check("along(q, p) + where_positive(p, 1) + unless_zero(q, 2)", 2.6);
  check("root(z, 0, 3, z^2 - 2)", std::sqrt(2.0));
  check("root(z, 0 m, 5 m, z^2 - x * (2 m)) / (1 m)", std::sqrt(1.4));
  check("root(z, 0, 10, sin(z), z) + root(z, 1, 10, sin(z))", 4 * std::numbers::pi);
  check("root(p, 0, 3, p - root(z, 0, 3, z - 0.5 * p) - 0.3)", 0.6);
}

TEST_CASE("a part of a formula that has no value leaves the whole without one", "[formula]") {
  for (const char* text :
       {"sqrt(q)", "min(1, sqrt(q))", "max(sqrt(q), 1)", "sign(log(q))", "q^0.5",
        "where_positive(q, 1)", "select(log(q), 1, 1)", "0 * log(q)", "unless_zero(sqrt(q), 5)",
        "sqrt(q)^0", "1^sqrt(q)", "atan((p - p)^(-p))", "atan((p - p)^-0.5)",
        "root(z, 0, 3, z^2 + 1)", "root(z, 0, 3, z - sqrt(q))"}) {
    INFO(text);
    CHECK(std::isnan(value_of_text(text)));
  }
}

TEST_CASE("what is wrong with a formula is said with its place", "[formula]") {
  const std::pair<const char*, const char*> cases[] = {
      {"x + m",
       "at character 3: '+' adds a length (m) and a mass (kg), which are of different kinds"},
      {"x - 1", "at character 3: '-' subtracts a length (m) and a plain number, which are of"},
      {"sin(x)",
       "at character 5: the argument of sin is a length (m); it must be a plain number or an "
       "angle"},
      {"max(p, x)", "at character 8: max compares a plain number and a length (m)"},
      {"x^p", "at character 2: a length (m) has powers with a plain number as the exponent alone"},
      {"2^x", "at character 3: the exponent is a length (m)"},
      {"2^1000", "at character 3: an exponent lies within -100 and 100"},
      {"foo(1)", "at character 1: there is no function 'foo'"},
      {"sine(1)", "did you mean sin"},
      {"sin(1, 2)", "at character 1: sin takes 1 argument; 2 are given"},
      {"select(1)", "select takes 3 arguments, with commas between them; 1 is given"},
      {"min(1)", "min compares two arguments or more"},
      {"root(z, 0, 1)", "at character 1: root takes the name of the unknown, the two ends"},
      {"root(1, 0, 1, p)", "at character 1: root takes the name of the unknown"},
      {"root(z, 0, x, z - p)", "'-' subtracts a length (m) and a plain number"},
      {"root(z, p, x, z)", "root looks between a plain number and a length (m)"},
      {"root(z, 0, 1, z) + z", "unknown: z"},
      {"root(a, 0, 1, root(b, 0, 1, root(c, 0, 1, c - a - b)))", "more than 2 deep"},
      {"", "the formula is empty"},
      {"  ", "the formula is empty"},
      {"1 +", "at character 4: the formula ends where a number, a name or '(' is expected"},
      {"(1", "at character 1: this '(' is not closed"},
      {"sin(1", "at character 4: this '(' is not closed"},
      {"1)", "at character 2: ')' closes nothing"},
      {"1 2", "at character 3: an operator is missing before '2'"},
      {"p q", "at character 3: an operator is missing before 'q'"},
      {"2 p", "at character 1: 'p' is not a unit; for a product write 2 * p"},
      {"2(p)", "at character 2: an operator is missing before '('"},
      {"p**2", "'**' is not an operator; write ^ for a power"},
      {"1,5", "a comma is only for the arguments of a function"},
      {"p = 2", "a formula is only what is to the right of '='"},
      {"p # 2", "at character 3: '#' is not part of a formula"},
      {"9.81 m/s^2", "write the unit as 9.81 [m/s^2], or (9.81 m) / s^2"},
      {"1 mm^2", "write a unit with powers in brackets, such as [mm^2]"},
      {"1 [furlongs per]", "is not a unit"},
      {"1 []", "there is no unit in these brackets"},
      {"1 [mm", "this '[' is not closed"},
      {"1 [degC]", "has a scale of its own"},
      {"1 Hz", "may or may not mean revolutions"},
      {"1e999", "this number is out of range"},
      {"peak(1)", "'peak' comes before the name of a curve"}};
  for (const auto& [text, words] : cases) {
    INFO(text);
    CHECK_THAT(refusal(text), Catch::Contains(words));
  }
}

TEST_CASE("formulas are bounded in depth and in size", "[formula]") {
  const std::string open(65, '(');
  CHECK_THAT(refusal(open + "1" + std::string(65, ')')), Catch::Contains("deeper than 64 levels"));
  CHECK_THAT(refusal(std::string(5000, '-') + "1"), Catch::Contains("deeper than 64 levels"));
  std::string power = "1", sum = "1";
  for (int i = 0; i < 3000; ++i) power += "^1", sum += "+1";
  CHECK_THAT(refusal(power), Catch::Contains("deeper than 64 levels"));
  CHECK_THAT(refusal(sum), Catch::Contains("more than 2000 parts"));
}

TEST_CASE("a decimal fraction is enclosed, an integer is exact", "[formula]") {
  const std::vector<Interval> u(std::size(kNames), Interval(1.0));
  const Interval tenth = recorded("0.1")(std::span<const Interval>(u));
  CHECK(tenth.lower() < 0.1);
  CHECK(0.1 < tenth.upper());
  const Interval three = recorded("3")(std::span<const Interval>(u));
  CHECK((three.lower() == 3 && three.upper() == 3));
}

TEST_CASE("powers and exponentials have exact derivatives and enclosures", "[formula]") {
  for (const char* text : {"q^2", "q^3", "p^1.5", "p^-2", "exp(p * q)", "p^q", "q^-3"}) {
    INFO(text);
    const Formula formula = recorded(text);
    std::vector<double> u;
    std::vector<Dual> seeded;
    std::vector<Series<Interval, 2>> boxes;
    for (std::size_t i = 0; i < std::size(kNames); ++i) {
      u.push_back(kNames[i].value);
      seeded.emplace_back(u[i]);
      seeded[i].v[static_cast<int>(i) % 4] += 1;
      boxes.push_back(Series<Interval, 2>::variable(Interval(u[i] - 1e-3, u[i] + 1e-3),
                                                    Interval(i == 3 ? 1.0 : 0.0)));
    }
    const Dual exact = formula(std::span<const Dual>(seeded));
    const auto over = formula(std::span<const Series<Interval, 2>>(boxes));
    const auto at = [&](double p) {
      std::vector<double> moved = u;
      moved[3] = p;
      return formula(std::span<const double>(moved));
    };
    const double slope = (at(0.4 + 1e-6) - at(0.4 - 1e-6)) / 2e-6;
    CHECK(exact.v[3] == Approx(slope).epsilon(1e-7).margin(1e-7));
    for (const double p : {0.3995, 0.4, 0.4009}) {
      CHECK(over.c[0].lower() <= at(p));
      CHECK(at(p) <= over.c[0].upper());
    }
    CHECK(over.c[1].lower() <= slope + 1e-6);
    CHECK(slope - 1e-6 <= over.c[1].upper());
  }
}

TEST_CASE("an even power of an interval about 0 is not negative", "[formula]") {
  std::vector<Interval> u(std::size(kNames), Interval(-1, 2));
  const Interval square = recorded("q^2")(std::span<const Interval>(u));
  CHECK(square.lower() == 0);
  CHECK(square.upper() == Approx(4));
}

TEST_CASE("over a pole or an edge nothing is said of the slope of a power", "[formula]") {
  for (const char* text :
       {"q^-1", "q^-2", "q^-3", "q^0.5", "q^-0.5", "q^1.5", "1 / q", "min(q^-1, 3)"}) {
    INFO(text);
    std::vector<Series<Interval, 2>> boxes(
        std::size(kNames), Series<Interval, 2>::variable(Interval(-1, 2), Interval(1.0)));
    const auto over = recorded(text)(std::span<const Series<Interval, 2>>(boxes));
    CHECK(std::isinf(over.c[1].lower()));
    CHECK(std::isinf(over.c[1].upper()));
  }
}

TEST_CASE("a formula is printed as it can be read again", "[formula]") {
  const auto name_of = [](const Step& step) -> std::optional<std::string> {
    if (step.operation == Operation::Input) return kNames[step.a].name;
    return {};
  };
  for (const char* text : {"p - (q - 1) - -p", "p / (q / 2) / (p * q)", "-(p + q)^2", "(-p)^3",
                           "2^-p", "sqrt(p) * (p + q) / max(p, q)", "p * p * p + (p + q) * (p + q)",
                           "-p * -q", "p^(-2)", "select(p, q, -q)", "(p / q) * (q / p) * 3",
                           "root(z, p, 3, z^2 - (p - q)) + root(z, 0, 9, sin(z) * p, (p - q) * z)",
                           "root(z, 0, 3, z - root(y, 0, 3, y - z / 2 - p))"}) {
    INFO(text);
    const Formula formula = recorded(text);
    const auto last = static_cast<std::uint32_t>(formula.steps().size() - 1);
    const FormulaLines lines = lines_of(formula, last, name_of);
    std::string whole = lines.lines.back().text;
    for (std::size_t i = lines.lines.size() - 1; i-- > 0;) {
      const auto& [name, meaning] = lines.lines[i];
      for (std::size_t at = 0; (at = whole.find(name, at)) != std::string::npos;) {
        whole.replace(at, name.size(), "(" + meaning + ")");
        at += meaning.size() + 2;
      }
    }
    INFO(whole);
    CHECK(value_of_text(whole) == Approx(value_of_text(text)).epsilon(1e-14));
  }
}

TEST_CASE("units are known by their dimension and their size in the SI", "[units]") {
  const auto is = [](const char* unit, const char* kind, const char* si) {
    INFO(unit);
    CHECK(to_string(si_unit(unit).dimension) == kind);
    CHECK(to_string(si_unit(si).dimension) == kind);
  };
  is("N/mm", "a spring rate (N/m)", "N/m");
  is("rpm", "a frequency (1/s)", "rad/s");
  is("MPa", "a stress (Pa)", "N/m2");
  is("deg", "a plain number", "1");
  is("kg mm2", "a moment of inertia (kg m2)", "kg m2");
  CHECK(to_string(power(si_unit("kg").dimension, 0.5)) == "a quantity in kg^0.5");
}

}  // namespace camlaw
