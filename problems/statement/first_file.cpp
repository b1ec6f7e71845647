// SPDX-License-Identifier: MIT
#include "problems/statement/first_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "machines/model/known_names.h"
#include "machines/model/usual_problem.h"
#include "problems/statement/problem_format.h"

namespace camlaw::problems {
namespace {

using Parameters = std::set<std::string, std::less<>>;

constexpr const char* kOptional = "#";  ///< before a line that may be left out
constexpr const char* kFixed = "";

/// A comment of one line: a sentence.
std::string sentence(std::string words) {
  if (words.empty()) return "";
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return fmt::format("# {}{}\n", words, words.back() == '.' ? "" : ".");
}

/// "\"40 mm\"", of a plain number "0.8".
std::string value_text(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.9g}", value) : fmt::format("\"{:.9g} {}\"", value, unit);
}

std::string assignment(const char* mark, std::string_view key, double value,
                       const std::string& unit) {
  return fmt::format("{}{} = {}\n", mark, key, value_text(value, unit));
}

const MechanismParameter& parameter_of(const Mechanism& mechanism, std::string_view name) {
  return mechanism.parameters[mechanism.parameter(name)];
}

/// "0.001 to 100000 mm", "any value".
std::string range_words(const MechanismParameter& p) {
  constexpr double kAny = 1e5;  // what stands for no end of a range that has both signs
  if (p.low <= -kAny && p.high >= kAny) return "any value";
  return fmt::format("{:g} to {:g}{}{}", p.low, p.high, p.unit == "1" ? "" : " " + p.unit,
                     p.integer ? ", an integer" : "");
}

/// What a parameter is, and what it may be.
std::string words_on(const MechanismParameter& p) {
  const std::string symbol = p.symbol.empty() || p.symbol == p.name ? "" : p.symbol + "; ";
  return sentence(fmt::format("{} ({}{})", p.meaning, symbol, range_words(p)));
}

/// What a response is.
std::string words_on(const Mechanism& mechanism, const ResponseName& name) {
  for (const NamedPeak& peak : mechanism.peaks) {
    if (peak.name == name.name) return peak.meaning;
  }
  if (name.response == nullptr) return mechanism.parameters[name.parameter].meaning;
  const std::string& meaning = name.response->meaning;
  switch (name.part) {
    case optim::Part::Highest:
      return "the highest value of this curve: " + meaning;
    case optim::Part::Lowest:
      return "the lowest value of this curve: " + meaning;
    case optim::Part::Magnitude:
      return "the largest size of this curve: " + meaning;
    case optim::Part::Value:
      break;
  }
  return meaning;
}

Parameters variables_of(const UsualProblem& usual) {
  Parameters names;
  for (const auto& variable : usual.variables) names.emplace(variable.parameter);
  return names;
}

/// The parameters that matter to what the problem asks, or that its checks must have stated.
Parameters used_by(const Mechanism& mechanism, const UsualProblem& usual) {
  Parameters names;
  const auto add = [&](const char* response) {
    const ResponseName name = find_response(mechanism, response);
    if (name.response == nullptr) return;
    for (const std::size_t i : name.response->uses) names.insert(mechanism.parameters[i].name);
  };
  add(usual.objective);
  for (const auto& limit : usual.limits) add(limit.response);
  for (const auto& constant : usual.constants) names.emplace(constant.parameter);
  for (const BuildableCheck& check : mechanism.checks) {
    for (const std::string& need : check.needs) {
      const auto p = std::find_if(mechanism.parameters.begin(), mechanism.parameters.end(),
                                  [&](const auto& q) { return q.name == need; });
      // A spring or load of 0 is there for those who need it.
      if (p != mechanism.parameters.end() && p->default_value != 0) names.insert(need);
    }
  }
  return names;
}

double value_of(const MechanismParameter& p, const UsualProblem& usual) {
  for (const auto& constant : usual.constants) {
    if (p.name == constant.parameter) return constant.value;
  }
  return p.default_value;
}

std::string head_part(const Mechanism& mechanism) {
  return sentence(fmt::format("a problem file about {}: {}", mechanism.name, mechanism.title)) +
         fmt::format(
             "# It works as it is. Save it as my.toml, change the numbers above the line of equals "
             "signs, and try\n"
             "#   camlaw check my.toml\n"
             "#   camlaw optimize my.toml\n"
             "# Units are in quotes: \"20 mm\", \"2 cm\".\n\n"
             "format = \"{1}\"\ntitle = \"My first {0}\"\nmechanism = \"{0}\"\n",
             mechanism.name, kProblemFormat.text());
}

/// The machine's numbers: those that matter, and those that may be left for later.
struct ConstantsPart {
  std::string fixed, optional;
};

ConstantsPart constants_part(const Mechanism& mechanism, const UsualProblem& usual) {
  const Parameters varied = variables_of(usual), used = used_by(mechanism, usual);
  ConstantsPart part;
  for (const MechanismParameter& p : mechanism.parameters) {
    if (varied.contains(p.name)) continue;
    const double value = value_of(p, usual);
    // What is absent by default, such as an offset of 0, may be added later.
    const bool is_absent = value == 0 && p.default_value == 0;
    if (used.contains(p.name) && !is_absent) {
      part.fixed += sentence(p.meaning) + assignment(kFixed, p.name, value, p.unit);
    } else {
      part.optional += words_on(p) + assignment(kOptional, p.name, value, p.unit);
    }
  }
  // What follows the line is of the same table.
  part.fixed = "\n# The machine: what stays the same while the program searches.\n[constants]\n" +
               part.fixed;
  if (!part.optional.empty()) {
    part.optional =
        "\n# More numbers of the machine. It has these values even while '#' stands before "
        "them.\n" +
        part.optional;
  }
  return part;
}

/// Where a designer may stop reading.
std::string line_part() {
  return "\n# ======================================================================\n"
         "# What follows may be left for later. A line that begins with '#' and no space is a "
         "setting:\n"
         "# remove the '#' to change it.\n";
}

std::string law_part(const UsualProblem& usual) {
  if (usual.law == nullptr) return "";
  std::string text = fmt::format(
      "\n# The law that moves the machine; 'camlaw laws' lists all of them. A list of names lets "
      "the\n"
      "# program choose, \"free\" lets it find the best law as a spline.\n[law]\nname = \"{}\"\n",
      usual.law);
  if (std::string_view(usual.law) == "free") {
    text +=
        "\n# The degree of the spline's pieces, and how many knots join them.\n"
        "[free]\ndegree = 3\nknots = 40\n";
  }
  return text;
}

std::string program_part(const UsualProblem& usual) {
  if (usual.segments.empty()) return "";
  std::string text =
      "\n# The motion over one turn. A segment with a law moves; a segment without one dwells. The "
      "last\n# takes what is left of 360 deg. To choose among laws: law = [\"cycloidal\", "
      "\"modified-sine\"].\n";
  for (const auto& segment : usual.segments) {
    text += fmt::format("[[program.segments]]\nname = \"{}\"\n", segment.name);
    if (&segment != &usual.segments.back())
      text += assignment(kFixed, "angle", segment.angle, "deg");
    if (segment.law != nullptr) text += fmt::format("law = \"{}\"\n", segment.law);
    text += "\n";
  }
  text.pop_back();
  return text;
}

/// A segment's angle as a variable that may be added: from three quarters to five quarters of it.
std::string segment_variable(const UsualProblem& usual) {
  const auto moving = std::find_if(usual.segments.begin(), usual.segments.end(),
                                   [](const auto& segment) { return segment.law != nullptr; });
  if (moving == usual.segments.end()) return "";
  return fmt::format("\n# The angle of a segment may vary too.\n#[variables.{}_angle]\n",
                     moving->name) +
         assignment(kOptional, "lower", 0.75 * moving->angle, "deg") +
         assignment(kOptional, "upper", 1.25 * moving->angle, "deg");
}

std::string variables_part(const Mechanism& mechanism, const UsualProblem& usual) {
  std::string text;
  if (!usual.variables.empty()) {
    text = "\n# What may vary: the search begins at start and stays between lower and upper.\n";
  }
  for (const auto& variable : usual.variables) {
    const MechanismParameter& p = parameter_of(mechanism, variable.parameter);
    text += sentence(p.meaning) + fmt::format("[variables.{}]\n", p.name);
    if (p.integer) text += "type = \"integer\"\n";
    text += assignment(kFixed, "lower", variable.lower, p.unit) +
            assignment(kFixed, "upper", variable.upper, p.unit) +
            assignment(kFixed, "start", variable.start, p.unit) + "\n";
  }
  if (!text.empty()) text.pop_back();
  return text;
}

/// How more may vary.
std::string more_variables(const Mechanism& mechanism, const UsualProblem& usual) {
  std::string text;
  if (!usual.variables.empty()) {
    text =
        "\n# To let a number of [constants] vary, move it to a table of its own, like those of "
        "[variables]\n# above; to fix a variable, move it to [constants].\n";
  }
  if (parameter_called(mechanism, known::kSpeed)) {
    text +=
        "\n# A limit can hold over a whole range of speeds: [ranges.speed] with lower and upper.\n";
  }
  return text + segment_variable(usual);
}

std::string objective_part(const Mechanism& mechanism, const UsualProblem& usual) {
  const ResponseName name = find_response(mechanism, usual.objective);
  const bool is_variable = name.response == nullptr;  // which has been described
  return "\n# The objective.\n" + (is_variable ? "" : sentence(words_on(mechanism, name))) +
         fmt::format("[objective]\n{} = \"{}\"\n",
                     usual.sense == optim::Sense::Minimize ? "minimize" : "maximize",
                     usual.objective);
}

std::string limits_part(const Mechanism& mechanism, const UsualProblem& usual) {
  std::string text = "\n# The limits that must hold, over the whole cycle.\n";
  for (const auto& limit : usual.limits) {
    const ResponseName name = find_response(mechanism, limit.response);
    text += sentence(words_on(mechanism, name)) +
            fmt::format("[[constraints]]\nresponse = \"{}\"\n", limit.response);
    if (limit.lower) text += assignment(kFixed, "lower", *limit.lower, name.unit);
    if (limit.upper) text += assignment(kFixed, "upper", *limit.upper, name.unit);
    text += "\n";
  }
  text.pop_back();
  return text;
}

std::string buildable_part(const Mechanism& mechanism) {
  if (mechanism.checks.empty()) return "";
  std::string text =
      "\n# The checks of whether the machine can be built become limits too. Some need numbers "
      "that\n"
      "# the machine's formulas do not have; what is not stated is not checked.\n"
      "[buildable]\nrequire = true\n";
  for (const BuildableInput& input : mechanism.inputs) {
    text += sentence(input.meaning) + assignment(kOptional, input.name, input.usual, input.unit);
  }
  return text;
}

std::string solver_part() {
  return "\n# How to search; without these lines the program decides.\n"
         "#[solver]\n#starts = 8\n#time_limit = \"1 min\"\n";
}

/// What else limits and objectives may name: what is asked for often, and where the rest is listed.
std::string other_responses(const Mechanism& mechanism, const UsualProblem& usual) {
  Parameters named = {usual.objective};
  for (const auto& limit : usual.limits) named.emplace(limit.response);
  const Parameters often(usual.others.begin(), usual.others.end());
  std::string text =
      "\n# Other responses that a limit or the objective may name. Of a curve, \"peak NAME\",\n"
      "# \"highest NAME\" and \"lowest NAME\" are numbers.\n";
  if (!often.empty()) {
    text += fmt::format("# These are often used; all: camlaw mechanisms {}\n", mechanism.name);
  }
  const auto add = [&](const std::string& name, const std::string& unit,
                       const std::string& meaning) {
    if (named.contains(name) || (!often.empty() && !often.contains(name))) return;
    text += fmt::format("#   {}{}: {}\n", name, unit == "1" ? "" : ", " + unit, meaning);
  };
  for (const MechanismResponse& r : mechanism.responses) add(r.name, r.unit, r.meaning);
  for (const NamedPeak& peak : mechanism.peaks) {
    add(peak.name, find_response(mechanism, peak.name).unit, peak.meaning);
  }
  return text;
}

}  // namespace

std::string first_file(const Mechanism& mechanism) {
  const UsualProblem& usual = *mechanism.usual;
  const ConstantsPart constants = constants_part(mechanism, usual);
  return head_part(mechanism) + law_part(usual) + program_part(usual) +
         variables_part(mechanism, usual) + objective_part(mechanism, usual) +
         limits_part(mechanism, usual) + constants.fixed + line_part() + constants.optional +
         more_variables(mechanism, usual) + buildable_part(mechanism) + solver_part() +
         other_responses(mechanism, usual);
}

}  // namespace camlaw::problems
