// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "machines/model/mechanism.h"
#include "machines/model/response_text.h"
#include "machines/registry.h"
#include "output/answers/law_json.h"
#include "output/document/document.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

using problems::Mechanism;
using problems::MovedBy;

const char* words_of(MovedBy moved_by) {
  switch (moved_by) {
    case MovedBy::Law:
      return "a law, [law]";
    case MovedBy::Program:
      return "a motion program, [program]";
    case MovedBy::Nothing:
      break;
  }
  return "its geometry";
}

const char* part_of(optim::Part part) {
  switch (part) {
    case optim::Part::Highest:
      return "highest";
    case optim::Part::Lowest:
      return "lowest";
    case optim::Part::Magnitude:
      return "peak";
    case optim::Part::Value:
      break;
  }
  return "value";
}

/// "\nits earlier name, disc-cam-knife, is accepted too", as the pattern has it.
std::string accepted_too(const Mechanism& mechanism, const char* pattern) {
  const std::string_view earlier = problems::earlier_name(mechanism);
  return earlier.empty() ? "" : fmt::format(fmt::runtime(pattern), earlier);
}

/// What a check needs that a problem must state: "speed and one of spring_rate, load".
std::string needs_of(const problems::BuildableCheck& check) {
  std::vector<std::string> needs = check.needs;
  if (!check.one_of.empty())
    needs.push_back(fmt::format("one of {}", fmt::join(check.one_of, ", ")));
  if (!check.input.empty()) {
    needs.push_back(fmt::format("{}, else {}", check.input, check.standard));
  }
  return fmt::format("{}", fmt::join(needs, "; "));
}

/// What fails where a check fails, by its response.
std::string asked_by(const problems::BuildableCheck& check) {
  return fmt::format("{} from {}", check.response, check.is_upper ? "above" : "below");
}

void print_checks(const Mechanism& mechanism) {
  if (mechanism.checks.empty()) return;
  Table table{
      .columns = {words("check"), words("limits"), words("needs"), words("where it fails")}};
  for (const auto& check : mechanism.checks) {
    table.add({check.name, asked_by(check), needs_of(check), check.fault});
  }
  print_text("\n" + text_of(table));
  if (mechanism.inputs.empty()) return;
  Table inputs{.columns = {words("of [buildable]"), words("unit"), words("meaning")}};
  for (const auto& input : mechanism.inputs) inputs.add({input.name, input.unit, input.meaning});
  print_text("\n" + text_of(inputs));
}

Json checks_json(const Mechanism& mechanism) {
  Json checks = Json::array();
  for (const auto& check : mechanism.checks) {
    checks.push_back({{"name", check.name},
                      {"response", check.response},
                      {"side", check.is_upper ? "upper" : "lower"},
                      {"needs", check.needs},
                      {"one_of", check.one_of},
                      {"input", check.input.empty() ? Json(nullptr) : Json(check.input)},
                      {"fault", check.fault}});
  }
  return checks;
}

Json inputs_json(const Mechanism& mechanism) {
  Json inputs = Json::array();
  for (const auto& input : mechanism.inputs) {
    inputs.push_back({{"name", input.name}, {"unit", input.unit}, {"meaning", input.meaning}});
  }
  return inputs;
}

void print_mechanism(const Mechanism& mechanism) {
  say("{}: {}\nsource {}; moved by {}{}\n\n", mechanism.name, mechanism.title, mechanism.source,
      words_of(mechanism.moved_by),
      accepted_too(mechanism, "\nits earlier name, {}, is accepted too"));
  if (!mechanism.parameters.empty()) {
    Table parameters{.columns = {words("parameter"), words("symbol"), numbers("default"),
                                 numbers("accepted"), words("unit"), words("meaning")}};
    for (const auto& p : mechanism.parameters) {
      parameters.add({p.name, p.symbol, fmt::format("{:g}", p.default_value),
                      fmt::format("{:g} .. {:g}", p.low, p.high), shown_unit(p.unit), p.meaning});
    }
    say("{}\n", text_of(parameters));
  }
  Table responses{.columns = {words("response"), words("kind"), words("unit"), words("meaning")}};
  for (const auto& r : mechanism.responses) {
    responses.add({r.name, r.curve ? "curve" : "number", shown_unit(r.unit), r.meaning});
  }
  for (const auto& p : mechanism.peaks) {
    responses.add({p.name, fmt::format("{} {}", part_of(p.part), p.curve), "", p.meaning});
  }
  print_text(text_of(responses));
  print_checks(mechanism);
}

Json mechanism_json(const Mechanism& mechanism) {
  Json parameters = Json::array(), responses = Json::array(), peaks = Json::array();
  for (const auto& p : mechanism.parameters) {
    parameters.push_back({{"name", p.name},
                          {"symbol", p.symbol},
                          {"unit", p.unit},
                          {"default", p.default_value},
                          {"lower", p.low},
                          {"upper", p.high},
                          {"integer", p.integer},
                          {"meaning", p.meaning}});
  }
  for (const auto& r : mechanism.responses) {
    Json response = {{"name", r.name},
                     {"unit", r.unit},
                     {"curve", static_cast<bool>(r.curve)},
                     {"meaning", r.meaning}};
    if (r.curve) response["along"] = r.along;
    Json uses = Json::array();
    for (const std::size_t i : r.uses) uses.push_back(mechanism.parameters[i].name);
    response["uses"] = uses;
    responses.push_back(response);
  }
  for (const auto& p : mechanism.peaks) {
    peaks.push_back(
        {{"name", p.name}, {"curve", p.curve}, {"part", part_of(p.part)}, {"meaning", p.meaning}});
  }
  const char* moved_by = mechanism.moved_by == MovedBy::Law       ? "law"
                         : mechanism.moved_by == MovedBy::Program ? "program"
                                                                  : "nothing";
  const std::string earlier{problems::earlier_name(mechanism)};
  return {{"name", mechanism.name},
          {"earlier_name", earlier.empty() ? Json(nullptr) : Json(earlier)},
          {"title", mechanism.title},
          {"source", mechanism.source},
          {"moved_by", moved_by},
          {"parameters", parameters},
          {"responses", responses},
          {"peaks", peaks},
          {"checks", checks_json(mechanism)},
          {"inputs", inputs_json(mechanism)}};
}

void print_all() {
  Table table{.columns = {words("mechanism"), words("moved by"), numbers("parameters"),
                          numbers("responses"), words("title")}};
  for (const Mechanism& m : problems::mechanisms()) {
    table.add({m.name, words_of(m.moved_by), fmt::format("{}", m.parameters.size()),
               fmt::format("{}", m.responses.size() + m.peaks.size()), m.title});
  }
  say("{}\n'camlaw mechanisms NAME' lists one mechanism's parameters and responses.\n",
      text_of(table));
}

void print_markdown(const Mechanism& mechanism) {
  say("\n## {}\n\n{}. Moved by {}. Source: {}.{}\n", mechanism.name, mechanism.title,
      words_of(mechanism.moved_by), mechanism.source,
      accepted_too(mechanism, " Its earlier name, `{}`, is accepted too."));
  if (!mechanism.parameters.empty()) {
    say("\n| parameter | symbol | default | accepted | unit | meaning |\n"
        "|---|---|--:|---|---|---|\n");
  }
  for (const auto& p : mechanism.parameters) {
    say("| `{}` | {} | {:g} | {:g} .. {:g}{} | {} | {} |\n", p.name, markdown_cell(p.symbol),
        p.default_value, p.low, p.high, p.integer ? ", integer" : "", shown_unit(p.unit),
        markdown_cell(p.meaning));
  }
  say("\n| response | kind | unit | meaning |\n|---|---|---|---|\n");
  for (const auto& r : mechanism.responses) {
    say("| `{}` | {} | {} | {} |\n", r.name, r.curve ? "curve" : "number", shown_unit(r.unit),
        markdown_cell(r.meaning));
  }
  for (const auto& p : mechanism.peaks) {
    say("| `{}` | {} `{}` | | {} |\n", p.name, part_of(p.part), p.curve, markdown_cell(p.meaning));
  }
  if (mechanism.checks.empty()) return;
  say("\n| check | limits | needs | where it fails |\n|---|---|---|---|\n");
  for (const auto& check : mechanism.checks) {
    say("| `{}` | {} | {} | {} |\n", check.name, asked_by(check), needs_of(check), check.fault);
  }
}

/// The page docs/mechanisms.md.
void print_mechanism_page() {
  say("# Mechanisms of problem files\n\nPrinted by `camlaw mechanisms --markdown` from the code. A "
      "file names one, sets or varies its\nparameters and asks about its responses "
      "([problem-files.md](problem-files.md)). A curve is asked about as\n`peak`, `highest` or "
      "`lowest` of it.\n");
  for (const Mechanism& m : problems::mechanisms()) print_markdown(m);
}

struct MechanismsOptions {
  std::string name;
  std::optional<std::string> formula;
  bool json = false, markdown = false;
};

/// The formula of one response.
void print_formula(const Mechanism& mechanism, const std::string& asked) {
  const problems::ResponseName name = find_response(mechanism, asked);
  if (name.response == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} is a parameter of {}, which has no formula", asked, mechanism.name));
  }
  say("{}\nin {}; the formula counts in the units of the SI and in rad\n",
      formula_text(mechanism, *name.response), shown_unit(name.response->unit));
}

int show_mechanisms(const MechanismsOptions& options) {
  if (options.formula) {
    if (options.name.empty() || options.json || options.markdown) {
      throw std::invalid_argument("--formula: name the mechanism too, and no other format");
    }
    print_formula(problems::find_mechanism(options.name), *options.formula);
    return kDone;
  }
  if (options.markdown && !options.name.empty()) {
    throw std::invalid_argument("--markdown: the page has all mechanisms; leave out NAME");
  }
  if (options.markdown) {
    print_mechanism_page();
  } else if (options.json) {
    Json all = Json::array();
    for (const Mechanism& m : problems::mechanisms()) all.push_back(mechanism_json(m));
    const Json wanted =
        options.name.empty() ? all : mechanism_json(problems::find_mechanism(options.name));
    print_data(wanted.dump(2) + "\n");
  } else if (options.name.empty()) {
    print_all();
  } else {
    print_mechanism(problems::find_mechanism(options.name));
  }
  return kDone;
}

}  // namespace

Command mechanisms_command() {
  const auto options = std::make_shared<MechanismsOptions>();
  return {.name = "mechanisms",
          .help = "List the mechanisms of problem files",
          .options = {{"NAME", &options->name, takes::kMechanism,
                       "one mechanism, with its parameters and responses"},
                      json_switch(options->json),
                      {.names = "--markdown",
                       .target = &options->markdown,
                       .takes = {},
                       .help = "print the page docs/mechanisms.md",
                       .excludes = "--json"},
                      {.names = "--formula",
                       .target = &options->formula,
                       .takes = "RESPONSE",
                       .help = "print the formula of one response of the mechanism"}},
          .examples = {{"camlaw mechanisms", "what a problem file may be about"},
                       {"camlaw mechanisms disc-cam-roller",
                        "its parameters and responses, with units and meanings"},
                       {"camlaw mechanisms die-press --formula running_stress",
                        "how one response is worked out"}},
          .run = [options] { return show_mechanisms(*options); }};
}

}  // namespace camlaw::cli
