// SPDX-License-Identifier: MIT
#include "output/answers/mechanism_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "machines/model/response_text.h"
#include "machines/registry.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::Mechanism, problems::MovedBy;

/// What moves a mechanism, for people and for programs.
Cell mover_of(const Mechanism& mechanism) {
  switch (mechanism.moved_by) {
    case MovedBy::Law:
      return {"a law, [law]", "law"};
    case MovedBy::Program:
      return {"a motion program, [program]", "program"};
    case MovedBy::Nothing:
      break;
  }
  return {"its geometry", "nothing"};
}

const char* word_of(optim::Part part) {
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

/// A table that stands apart from what is before it; people do not see one without rows.
void add_apart(Table table, Document& document) {
  table.caption = "\n";
  table.shown = table.rows.size();
  document.add(std::move(table));
}

Table mechanism_parameters(const Mechanism& mechanism) {
  Table table{
      .key = "parameters",
      .columns = {names("parameter", "name"), words("symbol", "symbol"),
                  numbers("default", "default"), numbers("accepted"), data("lower"), data("upper"),
                  data("integer"), words("unit", "unit"), words("meaning", "meaning")}};
  for (const auto& p : mechanism.parameters) {
    table.add({p.name,
               p.symbol,
               {fmt::format("{:g}", p.default_value), p.default_value},
               fmt::format("{:g} .. {:g}{}", p.low, p.high, p.integer ? ", integer" : ""),
               datum(p.low),
               datum(p.high),
               datum(p.integer),
               {shown_unit(p.unit), p.unit},
               p.meaning});
  }
  return table;
}

Table mechanism_responses(const Mechanism& mechanism) {
  Table table{.key = "responses",
              .columns = {names("response", "name"), words("kind", "curve"), data("along"),
                          data("uses"), words("unit", "unit"), words("meaning", "meaning")}};
  for (const auto& r : mechanism.responses) {
    const bool is_curve = static_cast<bool>(r.curve);
    std::vector<std::string> uses;
    for (const std::size_t i : r.uses) uses.push_back(mechanism.parameters[i].name);
    table.add({r.name,
               {is_curve ? "curve" : "number", is_curve},
               datum(is_curve ? Json(r.along) : Json(nullptr)),
               datum(uses),
               {shown_unit(r.unit), r.unit},
               r.meaning});
  }
  return table;
}

Table mechanism_peaks(const Mechanism& mechanism) {
  Table table{.key = "peaks",
              .columns = {names("response", "name"), words("is the", "part"), names("of", "curve"),
                          words("meaning", "meaning")}};
  for (const auto& p : mechanism.peaks) table.add({p.name, word_of(p.part), p.curve, p.meaning});
  return table;
}

/// What a check needs that a problem must state: "speed and one of spring_rate, load".
std::string needs_of(const problems::BuildableCheck& check) {
  std::vector<std::string> needs = check.needs;
  if (!check.one_of.empty()) {
    needs.push_back(fmt::format("one of {}", fmt::join(check.one_of, ", ")));
  }
  if (!check.input.empty()) {
    needs.push_back(fmt::format("{}, else {}", check.input, check.standard));
  }
  return fmt::format("{}", fmt::join(needs, "; "));
}

Table mechanism_checks(const Mechanism& mechanism) {
  Table table{.key = "checks",
              .columns = {names("check", "name"), words("limits", "response"), data("side"),
                          words("needs", "needs"), data("one_of"), data("input"), data("only_with"),
                          data("only_without"), words("where it fails", "fault")}};
  for (const auto& check : mechanism.checks) {
    const std::string without =
        check.only_without.empty() ? "" : fmt::format(", without {}", check.only_without);
    table.add(
        {check.name,
         {fmt::format("{} from {}{}", check.response, check.is_upper ? "above" : "below", without),
          check.response},
         datum(check.is_upper ? "upper" : "lower"),
         {needs_of(check), check.needs},
         datum(check.one_of),
         datum(check.input.empty() ? Json(nullptr) : Json(check.input)),
         datum(check.only_with.empty() ? Json(nullptr) : Json(check.only_with)),
         datum(check.only_without.empty() ? Json(nullptr) : Json(check.only_without)),
         check.fault});
  }
  return table;
}

Table mechanism_inputs(const Mechanism& mechanism) {
  Table table{.key = "inputs",
              .columns = {names("of [buildable]", "name"), words("unit", "unit"),
                          words("meaning", "meaning")}};
  for (const auto& input : mechanism.inputs) table.add({input.name, input.unit, input.meaning});
  return table;
}

/// A page's list of its headings, each a link; the anchor of a heading is in small letters.
std::string contents_of(const std::vector<std::string>& headings) {
  std::string contents;
  for (const std::string& heading : headings) {
    std::string anchor = heading;
    for (char& c : anchor) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    contents +=
        fmt::format("{}[{}](#{})", contents.empty() ? "\n**Contents:** " : " ·\n", heading, anchor);
  }
  return contents + "\n";
}

}  // namespace

Document mechanism_document(const Mechanism& mechanism) {
  const std::string earlier{problems::earlier_name(mechanism)};
  const Cell mover = mover_of(mechanism);
  Document document;
  document.add(Heading{mechanism.name});
  document.say(fmt::format("{}.\nMoved by {}. Source: {}.\n", mechanism.title, mover.text,
                           mechanism.source));
  if (!earlier.empty()) {
    document.say(fmt::format("Its earlier name, {}, is accepted too.\n", earlier));
  }
  document.fact("name", mechanism.name);
  document.fact("earlier_name", earlier.empty() ? Json(nullptr) : Json(earlier));
  document.fact("title", mechanism.title);
  document.fact("source", mechanism.source);
  document.fact("moved_by", mover.value);
  add_apart(mechanism_parameters(mechanism), document);
  add_apart(mechanism_responses(mechanism), document);
  add_apart(mechanism_peaks(mechanism), document);
  add_apart(mechanism_checks(mechanism), document);
  add_apart(mechanism_inputs(mechanism), document);
  return document;
}

Document mechanisms_document() {
  Document document;
  Table table{.columns = {words("mechanism"), words("moved by"), numbers("parameters"),
                          numbers("responses"), words("title")}};
  for (const Mechanism& m : problems::mechanisms()) {
    table.add({m.name, mover_of(m), fmt::format("{}", m.parameters.size()),
               fmt::format("{}", m.responses.size() + m.peaks.size()), m.title});
  }
  document.add(std::move(table));
  document.take_list([] {
    Json list = Json::array();
    for (const Mechanism& m : problems::mechanisms())
      list.push_back(json_of(mechanism_document(m)));
    return list;
  });
  document.say("\n'camlaw mechanisms NAME' lists one mechanism's parameters and responses.\n");
  return document;
}

Document first_files_document() {
  Document document;
  Table table{.columns = {words("mechanism"), words("what it is")}};
  Json list = Json::array();
  for (const Mechanism& m : problems::mechanisms()) {
    table.add({m.name, m.title});
    list.push_back({{"name", m.name}, {"title", m.title}});
  }
  document.add(std::move(table));
  document.take_list([list = std::move(list)] { return list; });
  document.say("\n'camlaw new NAME > my.toml' writes a problem file about one of them.\n");
  return document;
}

Document mechanisms_page() {
  Document page;
  page.add(Heading{"Mechanisms of problem files", 1});
  page.say(
      "Printed by `camlaw mechanisms --markdown` from the code. A file names one, sets or varies "
      "its\nparameters and limits or optimises its responses "
      "([problem-files.md](problem-files.md)). A file asks for the\n`peak`, `highest` or "
      "`lowest` value of a curve. The formulas of each are in "
      "[machine-formulas](machine-formulas).\n");
  std::vector<std::string> headings;
  for (const Mechanism& m : problems::mechanisms()) headings.push_back(m.name);
  page.say(contents_of(headings));
  for (const Mechanism& m : problems::mechanisms()) page.add(mechanism_document(m));
  return page;
}

Document formulas_page(const Mechanism& mechanism) {
  Document page;
  page.add(Heading{fmt::format("Formulas of {}", mechanism.name), 1});
  page.say(fmt::format(
      "Printed by `camlaw mechanisms {0} --formulas` from the formulas that are computed. "
      "Quantities are in SI "
      "units and\nangles in rad; a response is then given in the unit below its name. The symbols "
      "are those of\n[mechanisms.md](../mechanisms.md#{0}). $s$ is the displacement in strokes "
      "over the cycle $x$ from 0 to 1, $\\varphi$ the angle of\na shaft. $[\\dots]_{{y > 0}}$ has "
      "a value only where $y$ is positive.\n",
      mechanism.name));
  std::vector<std::string> headings;
  Document formulas;
  for (const auto& response : mechanism.responses) {
    if (!response.write) continue;
    headings.push_back(response.name);
    formulas.add(Heading{response.name});
    formulas.say(
        fmt::format("{}: {}\n\n$$\n{}\n$$\n",
                    response.unit == "1" ? "A plain number" : fmt::format("In {}", response.unit),
                    response.meaning, formula_latex(mechanism, response)));
  }
  page.say(contents_of(headings));
  page.add(std::move(formulas));
  return page;
}

Document formula_document(const Mechanism& mechanism, const std::string& asked) {
  const problems::ResponseName name = find_response(mechanism, asked);
  if (name.response == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} is a parameter of {}, which has no formula", asked, mechanism.name));
  }
  const std::string formula = formula_text(mechanism, *name.response);
  Document document;
  document.say(fmt::format("{}\nin {}; the formula uses SI units and rad\n", formula,
                           shown_unit(name.response->unit)));
  document.fact("mechanism", mechanism.name);
  document.fact("response", name.response->name);
  document.fact("unit", name.response->unit);
  document.fact("formula", formula);
  document.fact("latex", formula_latex(mechanism, *name.response));
  return document;
}

}  // namespace camlaw::cli
