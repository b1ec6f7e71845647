// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <fstream>
#include <stdexcept>

#include "problems/statement/statement.h"
#include "tests/problems/complaint.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::statement_errors_test {
namespace {

/// What stands in a file, and what its error must say: place and path first, then fragments.
struct Case {
  std::string text;
  std::string start;
  std::vector<std::string> fragments;
};

using Catch::Contains, testing::complaint;

void check(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    const std::string message = complaint(c.text);
    INFO(c.text << "\n  says: " << message);
    CHECK(message.starts_with("f.toml" + c.start));
    for (const std::string& fragment : c.fragments) {
      INFO("wanted: " << fragment);
      CHECK(message.find(fragment) != std::string::npos);
    }
    CHECK(message.find('\n') == std::string::npos);
  }
}

/// Cases that follow after three lines: mechanism and law. Line 4 is the first of the case.
std::vector<Case> after_law(const std::string& law, std::vector<Case> cases) {
  for (Case& c : cases) {
    c.text = "mechanism = 'spine-cutter'\n[law]\nname = " + law + "\n" + c.text;
  }
  return cases;
}

std::string variable(const std::string& name, const std::string& body) {
  return "[variables." + name + "]\n" + body;
}

/// "b.b.b", so many parts.
std::string nested(const std::string& part, int count) {
  std::string text = part;
  for (int i = 1; i < count; ++i) text += "." + part;
  return text;
}

/// "[1.5,1.5]", so many.
std::string numbers(int count) {
  std::string text = "[1.5";
  for (int i = 1; i < count; ++i) text += ",1.5";
  return text + "]\n";
}

const std::string kAlpha = "'polynomial-5'";
const std::string kBounds = "lower = -5\nupper = 5\n";

}  // namespace

TEST_CASE("text that is not valid TOML is refused with its line", "[statement]") {
  check({
      {"title = 'x'\nmechanism =\n", ":2: ", {"not valid TOML", "expected value"}},
      {"a = 1\na = 2\n", ":2: ", {"cannot redefine", "stated only once"}},
      {"[[constraints]]\n[constraints]\n", ":2: ", {"double brackets: [[constraints]]"}},
      {"title = 'x\nmechanism = 'law'\n", ":1: ", {"close the quotes"}},
      {"title: 'x'\n", ":1: ", {"write name = value"}},
      {"a = ['b' 'c']\n", ":1: ", {"put commas between"}},
      {"{\"format\": 1}\n", ":1: ", {"this looks like JSON"}},
      {"// a disc cam\n", ":1: ", {"a comment begins with #"}},
      {"title = “x”\n", ":1: ", {"straight quotes", "not “"}},
      {"title = 'x'\n[law\n", ":2: ", {"expected ']'"}},
      {"[constants]\nstroke = 40 mm\n", ":2: ", {"in quotes, such as \"40 mm\""}},
      {"mechanism = law\n", ":1: ", {"put a name in quotes"}},
      {"[constants]\nstroke = 4,5\n", ":2: ", {"use a point for the decimals"}},
      {"title = 'x'\nmechanism = '\xff'\n", ":2: ", {"not UTF-8", "save the file as UTF-8"}},
      {"# größe\nname = косинус\n", ":2: ", {"not valid TOML", "in quotes"}},
      {"title = \"\"\"\né\\\"\"\"\"\"\"\" # 'é\nü = 3\n", ":3: ", {"in quotes"}},
      {"title = 'größe' # \"é\"\n'ü' = 3\n", ":2: ü: unknown key", {}},
      {"\xff\xfet\n", ":1: ", {"not UTF-8"}},
      {"a = 1\n[[[a]]]\n", ":2: ", {"not valid TOML"}},
      {"a = 1\n" + nested("b", 33) + " = 1\n", ":2: ", {"a key has more than 32 parts"}},
      {nested("b", 15000) + " = 1\n", ":1: ", {"more than 32 parts"}},
      {nested("'b'", 15000) + " = 1\n", ":1: ", {"more than 32 parts"}},
      {"[" + nested("b", 100000) + "]\nc = 1\n", ":1: ", {"more than 32 parts"}},
      {"a = {" + nested("b ", 40) + " = 1}\n", ":1: ", {"more than 32 parts"}},
      {nested("b", 32) + " = 1\n", ":1: b: unknown key", {}},
      {"title = '" + nested("b", 50) + "' # " + nested("b", 50) + "\nb = " + numbers(50),
       ":2: b: unknown key",
       {}},
      {"a = " + std::string(100000, '['), ":1: ", {"not valid TOML", "depth"}},
      {"", ": the file is empty", {"mechanism", "law"}},
      {"# only a comment\n", ": the file is empty", {}},
  });
}

TEST_CASE("a file's mechanism must be there and known", "[statement]") {
  check({
      {"title = 'x'", ": mechanism is missing", {"spine-cutter"}},
      {"\nmechanism = 'spine-cuter'", ":2: mechanism: ", {"'spine-cuter'", "spine-cutter"}},
      {"mechanism = 3", ":1: mechanism: ", {"a number is given", "write a text in quotes"}},
      {"mechanism = ' '", ":1: mechanism: ", {"empty"}},
      {"title = 3", ":1: title: a number is given", {}},
      {"title = \"a\\nb\"", ":1: title: it has a control character, U+000A", {"one line"}},
      {"title = \"a\\u001b[31m\"", ":1: title: it has a control character, U+001B", {}},
      {"title = \"a\\u0085\"", ":1: title: it has a control character, U+0085", {}},
  });
}

TEST_CASE("unknown keys are refused with near ones, else all", "[statement]") {
  check({{"mechanism = 'spine-cutter'\nlaws = 3", ":2: laws: unknown key", {"did you mean law?"}},
         {"zzz = 3",
          ":1: zzz: unknown key",
          {"use format, title, mechanism, machine, cams, responses, constants, "
           "law"}}});
  check(after_law(
      kAlpha,
      {{variable("alpha", "lwoer = 1"), ":5: variables.alpha.lwoer: ", {"lower"}},
       {variable("alpha", "zz = 1"), ":5: variables.alpha.zz: ", {"lower, upper, start, scale"}},
       {"[objective]\nminimise = 'R'", ":5: objective.minimise: ", {"did you mean minimize"}},
       {"[[constraints]]\nresponse = 'contact_angle'\nmaximum = 3",
        ":6: constraints[1].maximum: ",
        {"unknown key"}},
       {"[solver]\nseeds = 3", ":5: solver.seeds: ", {"did you mean seed"}},
       {"[variable.alpha]\nlower = 1",
        ":4: variable: ",
        {"did you mean variables, variation or buildable?"}}}));
}

TEST_CASE("a table where a value is expected is refused, and the reverse", "[statement]") {
  check({
      {"mechanism = 'spine-cutter'\nlaw = 'cosine'",
       ":2: law: a text is given",
       {"[law] with name = \"cosine\""}},
      {"mechanism = 'spine-cutter'\nlaw = 'a\"b'",
       ":2: law: a text is given",
       {"[law] with name = \"polynomial-5\""}},
      {"mechanism = 'spine-cutter'", ": law is missing", {"[law]", "name"}},
      {"mechanism = 'spine-cutter'\n[law]\ncrossover = 0.5", ":2: law: name is missing", {}},
  });
  check(after_law(
      kAlpha,
      {{"[constants]\nstroke = true", ":5: constants.stroke: true or false is given", {"1 mm"}},
       {"[constants]\nstroke = [1]", ":5: constants.stroke: a list is given", {"a number"}},
       {"[constants]\nstroke = 2020-01-01", ":5: constants.stroke: a date", {}},
       {"[variables]\nalpha = 3", ":5: variables.alpha: a number is given", {"lower and upper"}},
       {"[[constants]]\nstroke = 3", ":4: constants: a list is given", {"[constants]"}},
       {"[constraints]\nresponse = 'R'", ":4: constraints: a table is given", {"[[constraints]]"}},
       {"[[objective]]\nminimize = 'R'", ":4: objective: a list is given", {"[objective]"}},
       {"[[solver]]\nseed = 1", ":4: solver: a list is given", {"[solver]"}},
       {"[[variables]]\nseed = 1", ":4: variables: a list is given", {"[variables.alpha]"}}}));
}

TEST_CASE("constants are known, of their kind, in range and given once", "[statement]") {
  check(after_law(
      kAlpha,
      {{"[constants]\nstrok = 3", ":5: constants.strok: ", {"spine-cutter", "did you mean stroke"}},
       {"[constants]\nalpha = 3", ":5: constants.alpha: ", {"parameter of the law", "[law]"}},
       {"[constants]\nstroke = '30 deg'",
        ":5: constants.stroke: '30 deg' is an angle; a length is needed",
        {"1 mm"}},
       {"[constants]\nstroke = '30 mn'", ":5: constants.stroke: ", {"'mn' is not a unit"}},
       {"[constants]\nstroke = '4,0 cm'", ":5: constants.stroke: '4,0 cm' has a comma", {"point"}},
       {"[constants]\nstroke = -1",
        ":5: constants.stroke: -1 mm is outside",
        {"0.001 .. 10000 mm"}},
       {"[constants]\nstroke = inf", ":5: constants.stroke: inf is not a finite number", {}},
       {"[constants]\nstroke = nan", ":5: constants.stroke: nan is not a finite number", {}},
       {"[constants]\nstroke = 'inf mm'", ":5: constants.stroke: inf is not a finite", {}},
       {"[constants]\nblades = 17.5", ":5: constants.blades: 17.5 is not an integer", {}},
       {"[constants]\nblades = 17\nz = 18", ":6: constants.z: blades is given twice", {}}}));
}

TEST_CASE("laws are known, different and made of accepted values", "[statement]") {
  const std::string head = "mechanism = 'spine-cutter'\n[law]\nname = ";
  check({
      {head + "'cosin'", ":3: law.name: there is no law 'cosin'", {"cosine"}},
      {head + "[]", ":3: law.name: the list is empty", {}},
      {head + "3", ":3: law.name: a number is given", {"a list of names"}},
      {head + "['cosine',\n'cosin']", ":4: law.name[2]: there is no law 'cosin'", {}},
      {head + "['cosine', 'simple harmonic']", ":3: law.name: 'cosine' appears twice", {}},
      {head + "'polynomial-5 alpha=50'", ":3: law.name: 50 is outside -30 .. 30", {"alpha"}},
      {head + "'polynomial-5 beta=5'", ":3: law.name: ", {"no parameter 'beta'", "alpha"}},
      {head + "'inclined-sinusoid angle=5mm'", ":3: law.name: ", {"an angle is needed"}},
      {head + "'scca a=0.9 b=0.9'", ":3: law.name: ", {"scca"}},
      {head + "['polynomial-5 alpha=-3', 'polynomial-5']\n" + variable("alpha", kBounds),
       ":3: law.name: 'polynomial-5 alpha=-3' appears twice",
       {}},
  });
}

TEST_CASE("fixed parameters of the law are known, accepted and given once", "[statement]") {
  check(after_law(
      kAlpha,
      {{"alpa = 3", ":4: law.alpa: ", {"polynomial-5", "did you mean alpha?"}},
       {"stroke = 3", ":4: law.stroke: ", {"parameter of the machine", "[constants]"}},
       {"A = 3", ":4: law.A: law polynomial-5 has no parameter 'A'", {"polynomial-7 has it"}},
       {"alpha = 31", ":4: law.alpha: 31 is outside -30 .. 30", {}},
       {"alpha = '3 mm'", ":4: law.alpha: '3 mm' is a length", {"a plain number"}},
       {"alpha = [1]", ":4: law.alpha: a list is given", {"write a number"}}}));
  for (const char* law : {"'polynomial-5 alpha=-3'", "'polynomial-5 Alpha = -5'"}) {
    check(after_law(law, {{"alpha = -4", ":4: law.alpha: ", {"name gives alpha already"}}}));
  }
  check(
      after_law("'legendre'", {{"'c[1]' = 3", ":4: law.c[1]: ", {"whole list"}},
                               {"c = [1, 'x']", ":4: law.c[2]: 'x' is not a number", {}},
                               {"c = [1, 2000]", ":4: law.c: 2000 is outside -1000 .. 1000", {}}}));
  check(after_law("['scca', 'fourier']", {{"a = 0.3", ":4: law.a: ", {"not the same"}}}));
}

TEST_CASE("variables are known, used by a law, and stated once", "[statement]") {
  check(after_law(
      kAlpha,
      {{variable("alpa", kBounds), ":4: variables.alpa: ", {"spine-cutter", "did you mean alpha"}},
       {variable("A", kBounds), ":4: variables.A: ", {"no parameter 'A'", "polynomial-7 has it"}},
       {variable("law.stroke", kBounds), ":4: variables.law.stroke: ", {"no parameter 'stroke'"}},
       {variable("machine.alpha", kBounds), ":4: variables.machine.alpha: ", {"spine-cutter"}},
       {variable("'alpha[1]'", kBounds), ":4: variables.alpha[1]: ", {"single number"}},
       {"alpha = -3\n" + variable("alpha", kBounds), ":5: variables.alpha: ", {"fixed value too"}},
       {"[constants]\nz = 3\n" + variable("blades", kBounds),
        ":6: variables.blades: ",
        {"under [constants]"}},
       {variable("stroke", "values = [1, 2]\n") + variable("S_f", "values = [1, 2]"),
        ":6: variables.S_f: stroke varies already",
        {}}}));
  check(after_law("'table v=0,0,0 x=0,.5,1 s=0,.5,1'",
                  {{variable("v", kBounds),
                    ":4: variables.v: both the machine and the law have",
                    {"machine.v", "law.v"}}}));
}

TEST_CASE("bounds are there, finite, in order and in the accepted range", "[statement]") {
  check(after_law(
      kAlpha,
      {{variable("alpha", "lower = -10\nupper = -20"),
        ":5: variables.alpha: lower -10 exceeds upper -20",
        {}},
       {variable("stroke", "upper = 3\n\nlower = '5 mm'"),
        ":7: variables.stroke: lower 5 mm exceeds upper 3 mm",
        {}},
       {variable("alpha", "lower = -10"), ":4: variables.alpha: upper is missing", {"values"}},
       {variable("alpha", ""), ":4: variables.alpha: lower is missing", {"lower and upper"}},
       {variable("alpha", "lower = -inf\nupper = 0"), ":5: variables.alpha.lower: -inf is not", {}},
       {variable("alpha", "lower = 0\nupper = 'inf'"), ":6: variables.alpha.upper: inf is not", {}},
       {variable("alpha", "lower = -40\nupper = 0"),
        ":5: variables.alpha.lower: -40 is outside -30 .. 30",
        {"alpha accepts"}},
       {variable("stroke", "lower = 0\nupper = 5"),
        ":5: variables.stroke.lower: 0 mm is outside",
        {"0.001 .. 10000 mm"}},
       {variable("stroke", "lower = '1 s'\nupper = 5"),
        ":5: variables.stroke.lower: '1 s' is a time",
        {"a length is needed"}},
       {variable("alpha", kBounds + "start = 6"),
        ":7: variables.alpha.start: 6 is outside the bounds -5 .. 5",
        {}},
       {variable("alpha", kBounds + "scale = 0"), ":7: variables.alpha.scale: 0 is not above", {}},
       {variable("alpha", kBounds + "type = 'whole'"),
        ":7: variables.alpha.type: 'whole' is not a type",
        {"integer or continuous"}}}));
}

TEST_CASE("integer parameters and those that shape a law do not vary continuously", "[statement]") {
  check(after_law(
      kAlpha,
      {{variable("blades", "lower = 10\nupper = 30"),
        ":4: variables.blades: ",
        {"type = \"integer\"", "values"}},
       {variable("blades", "lower = 10\nupper = 30\ntype = 'continuous'"),
        ":4: variables.blades: ",
        {"type = \"integer\""}},
       {variable("blades", "lower = 10.5\nupper = 30\ntype = 'integer'"),
        ":5: variables.blades.lower: 10.5 is not an integer",
        {}},
       {variable("stroke", "lower = 10.5\nupper = 30\ntype = 'integer'"),
        ":5: variables.stroke.lower: 10.5 is not an integer",
        {"type is integer"}},
       {variable("stroke", "lower = 10\nupper = 30\ntype = 'integer'\nstart = 10.5"),
        ":8: variables.stroke.start: 10.5 is not an integer",
        {}},
       {variable("blades", "values = [10, 10.5]"), ":5: variables.blades.values[2]: 10.5", {}}}));
  check(after_law("'b-spline'", {{variable("degree", "lower = 3\nupper = 6"),
                                  ":4: variables.degree: degree cannot vary continuously",
                                  {"integer", "values"}}}));
  check(after_law("'stoddart'", {{variable("'exponents[3]'", "lower = 5\nupper = 6"),
                                  ":4: variables.exponents[3]: ",
                                  {"cannot vary continuously"}}}));
}

TEST_CASE("listed values are there, accepted, different and stand alone", "[statement]") {
  check(after_law(
      kAlpha,
      {{variable("stroke", "values = []"), ":5: variables.stroke.values: the list is empty", {}},
       {variable("stroke", "values = 3"),
        ":5: variables.stroke.values: a number is given",
        {"a list"}},
       {variable("stroke", "values = [40,\n'4 cm']"),
        ":6: variables.stroke.values[2]: 40 mm is listed twice",
        {}},
       {variable("stroke", "values = [40, -1]"),
        ":5: variables.stroke.values[2]: -1 mm is outside",
        {}},
       {variable("stroke", "values = [40, inf]"), ":5: variables.stroke.values[2]: inf", {}},
       {variable("stroke", "values = [40, 50]\nlower = 3"),
        ":6: variables.stroke.lower: values",
        {}},
       {variable("stroke", "values = [40, 50]\nscale = 3"),
        ":6: variables.stroke.scale: values",
        {}},
       {variable("stroke", "values = [40, 50]\nstart = 45"),
        ":6: variables.stroke.start: 45 mm is not one of 40 and 50 mm",
        {}}}));
}

TEST_CASE("lists vary whole or by elements that they have", "[statement]") {
  check(after_law(
      "'legendre c=1,2'",
      {{variable("c", kBounds) + variable("'c[2]'", kBounds),
        ":7: variables.c[2]: ",
        {"c[2] varies already"}},
       {variable("'c[2]'", kBounds) + variable("c", kBounds),
        ":7: variables.c: ",
        {"c[2] varies already"}},
       {variable("'c[3]'", kBounds), ":4: variables.c[3]: no element 3", {"legendre has 2 values"}},
       {variable("'c[0]'", kBounds), ":4: variables.c[0]: ", {"c[1], c[2]"}},
       {variable("'c[x]'", kBounds), ":4: variables.c[x]: ", {"names no element"}},
       {variable("c", kBounds + "start = 3"),
        ":7: variables.c.start: a number is given",
        {"a list"}},
       {variable("c", kBounds + "start = []"), ":7: variables.c.start: the list is empty", {}},
       {variable("c", "lower = [1, 2, 3]\nupper = 5"),
        ":5: variables.c.lower: 3 values",
        {"for the 2 of c"}},
       {variable("c", "lower = [-1, 7]\nupper = 5"),
        ":5: variables.c: lower 7 exceeds upper 5",
        {}},
       {variable("c", kBounds + "start = [1, 6]"), ":7: variables.c.start[2]: 6 is outside", {}}}));
  check(after_law(
      "'legendre c='",
      {{variable("c", kBounds), ":4: variables.c: start is missing", {"says how long"}}}));
}

TEST_CASE("starts must make a law", "[statement]") {
  check(after_law(
      "'scca'",
      {{variable("a", "lower = 0.5\nupper = 1\nstart = 0.9"), ":3: law.name: law 'scca'", {}}}));
}

TEST_CASE("an objective is one number that can be improved", "[statement]") {
  const auto objective = [](const std::string& body) { return "[objective]\n" + body; };
  check(after_law(
      kAlpha,
      {{objective("minimize = 'inertia_forc'"), ":5: objective.minimize: ", {"inertia_force"}},
       {objective("minimize = 'alpha'"),
        ":5: objective.minimize: alpha is a parameter of the law, which is not a response",
        {"[variables.alpha]"}},
       {objective("minimize = 3"), ":5: objective.minimize: a number is given", {"a text"}},
       {objective("minimize = 'peak contact_angle'"),
        ":5: objective.minimize: ",
        {"contact_angle"}},
       {objective("minimize = 'contact_angle'\nmaximize = 'contact_angle'"),
        ":4: objective: ",
        {"minimize and maximize", "one"}},
       {objective("tolerance = 3"), ":4: objective: ", {"neither minimize nor maximize"}},
       {objective("minimize = 'inertia_force'"),
        ":5: objective.minimize: inertia_force is a curve",
        {"\"peak inertia_force\"", "\"highest inertia_force\"", "\"lowest inertia_force\""}},
       {objective("maximize = 'peak inertia_force'"), ":5: objective.maximize: ", {"minimised"}},
       {objective("maximize = 'peak_inertia_force'"), ":5: objective.maximize: ", {"minimised"}},
       {objective("maximize = 'highest inertia_force'"), ":5: objective.maximize: ", {"minimised"}},
       {objective("minimize = 'lowest inertia_force'"), ":5: objective.minimize: ", {"maximised"}},
       {objective("minimize = 'contact_angle'\ntolerance = 0"),
        ":6: objective.tolerance: 0 deg is not",
        {"above zero"}},
       {objective("minimize = 'contact_angle'\ntolerance = '1 mm'"),
        ":6: objective.tolerance: ",
        {"an angle is needed"}},
       {objective("minimize = 'cam_radius'\n") + variable("alpha", kBounds),
        ":5: objective.minimize: cam_radius is a constant here",
        {"[variables.cam_radius]"}}}));
}

TEST_CASE("a constraint bounds what can be bounded", "[statement]") {
  const auto constraint = [](const std::string& response, const std::string& body) {
    return "[[constraints]]\nresponse = '" + response + "'\n" + body;
  };
  check(after_law(
      kAlpha,
      {{constraint("contact_angl", "upper = 3"),
        ":5: constraints[1].response: ",
        {"contact_angle"}},
       {constraint("alpha", "upper = 3"), ":5: constraints[1].response: alpha is a parameter", {}},
       {"[[constraints]]\nupper = 3", ":4: constraints[1]: response is missing", {}},
       {"constraints = [3]", ":4: law.constraints: ", {}},
       {constraint("contact_angle", "upper = 3\n") + "[[constraints]]\nupper = 3",
        ":7: constraints[2]: response is missing",
        {}},
       {constraint("contact_angle", ""),
        ":4: constraints[1]: there is no bound",
        {"lower", "upper", "equals"}},
       {constraint("contact_angle", "lower = 3\nequals = 3"),
        ":7: constraints[1].equals: ",
        {"drop one"}},
       {constraint("contact_angle", "lower = 3\nupper = 2"),
        ":6: constraints[1]: lower 3 deg exceeds upper 2 deg",
        {}},
       {constraint("contact_angle", "lower = -inf"), ":6: constraints[1].lower: -inf is not", {}},
       {constraint("contact_angle", "upper = '3 mm'"),
        ":6: constraints[1].upper: '3 mm' is a length",
        {"an angle is needed"}},
       {constraint("contact_angle", "upper = 3\ntolerance = -1"),
        ":7: constraints[1].tolerance: -1 deg is not above zero",
        {"above zero"}},
       {constraint("inertia_force", "equals = 3"), ":6: constraints[1].equals: a curve cannot", {}},
       {constraint("inertia_force", "lower = 3\nupper = 3"),
        ":6: constraints[1]: a curve cannot",
        {"the same"}},
       {constraint("peak_inertia_force", "equals = 3"), ":6: constraints[1].equals: a peak", {}},
       {constraint("peak inertia_force", "lower = 3"),
        ":6: constraints[1].lower: a peak",
        {"from above only", "response = \"inertia_force\""}},
       {constraint("minimum_cam_radius", "lower = 3"),
        ":6: constraints[1].lower: a peak",
        {"response = \"required_cam_radius\""}},
       {constraint("peak inertia_force", "upper = -5"),
        ":6: constraints[1].upper: peak inertia_force is the largest size of the curve",
        {"above zero instead of -5 N"}},
       {constraint("peak_inertia_force", "upper = 0"), ":6: constraints[1].upper: ", {"0 N"}},
       {constraint("highest inertia_force", "lower = 3"), ":6: constraints[1].lower: a peak", {}},
       {constraint("lowest inertia_force", "upper = 3"),
        ":6: constraints[1].upper: ",
        {"from below only"}}}));
}

TEST_CASE("the solver's settings are known and of use", "[statement]") {
  check(after_law(
      kAlpha,
      {{"[solver]\nname = 'ipot'",
        ":5: solver.name: ",
        {"'ipot'", "did you mean ipopt", "Use one of auto, "}},
       {"[solver]\nstarts = 0", ":5: solver.starts: 0 is outside 1 .. 1000000", {}},
       {"[solver]\nstarts = 1.5", ":5: solver.starts: a number is given", {"an integer"}},
       {"[solver]\nseed = -1", ":5: solver.seed: -1 is outside", {}},
       {"[solver]\ntime_limit = 0", ":5: solver.time_limit: 0 s is not above zero", {}},
       {"[solver]\ntime_limit = '10 mm'", ":5: solver.time_limit: ", {"a time is needed"}}}));
}

TEST_CASE("options of one solver are those that it has", "[statement][solvers]") {
  check(after_law(
      kAlpha,
      {{"[solver.ipot]\nmu_init = 1", ":4: solver.ipot: unknown key", {"did you mean ipopt"}},
       {"[solver.auto]\nmu_init = 1", ":4: solver.auto: unknown key", {}},
       {"[solver]\nipopt = 'fast'", ":5: solver.ipopt: a text", {"a table, [solver.ipopt]"}},
       {"[solver.ipopt]\nmu_stratgy = 'adaptive'",
        ":5: solver.ipopt.mu_stratgy: ipopt has no option 'mu_stratgy'",
        {"did you mean mu_strategy"}},
       {"[solver.ipopt]\nmu_strategy = 'adaptve'",
        ":5: solver.ipopt.mu_strategy: ipopt: option mu_strategy: 'adaptve' is not ",
        {"monotone, adaptive"}},
       {"[solver.ipopt]\nmax_soc = 1.5", ":5: solver.ipopt.max_soc: ", {"an integer from 0"}},
       {"[solver.ipopt]\nmu_init = inf", ":5: solver.ipopt.mu_init: ", {"a number above 0"}},
       {"[solver.ipopt]\nmu_init = true", ":5: solver.ipopt.mu_init: true or false is given", {}},
       {"[solver.ipopt]\nprint_level = 5",
        ":5: solver.ipopt.print_level: ",
        {"cannot be set", "standard output"}},
       {"[solver]\nname = 'slsqp'\n[solver.crs2]\npopulation = 0",
        ":7: solver.crs2.population: ",
        {"an integer from 1"}}}));
}

TEST_CASE("a file of another kind is called what it is", "[statement]") {
  const testing::Folder folder;
  const auto said = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return complaint([&] { read_problem_file(folder / name); });
  };
  CHECK_THAT(said("r.json", "{\n \"format\": \"camlaw result 1\"}"),
             Contains("it is a result, not a problem file; 'camlaw evaluate ") &&
                 Contains("camlaw verify "));
  CHECK_THAT(said("r.json", "{\"a\": 1}"), Contains("it is JSON, not a problem file"));
  CHECK_THAT(said("p.html", "<!doctype html>\n"), Contains("it is a page (HTML or XML)"));
  CHECK_THAT(said("lift.csv", "angle [deg], lift [mm]\n0, 0\n"),
             Contains("it is a table, not a problem file; 'camlaw fit "));
  CHECK(said("p.toml", "mechanism = 'disc-cam-roller'\n").find("not a problem file") ==
        std::string::npos);
}

}  // namespace camlaw::problems::statement_errors_test
