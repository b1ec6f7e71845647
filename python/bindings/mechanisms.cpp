// SPDX-License-Identifier: MIT
#include "python/bindings/mechanisms.h"

#include "machines/registry.h"
#include "output/answers/mechanism_output.h"
#include "output/document/markdown.h"
#include "problems/statement/first_file.h"
#include "problems/statement/shipped_files.h"
#include "python/bindings/module.h"
#include "python/bindings/running.h"

namespace camlaw::python {

std::string formula_of(const problems::Mechanism& mechanism, const std::string& response) {
  const Unlocked released;
  return cli::json_of(cli::formula_document(mechanism, response))["formula"].get<std::string>();
}

nb::dict dict_of(const problems::Mechanism& mechanism) {
  nb::list parameters, responses, peaks;
  for (const problems::MechanismParameter& p : mechanism.parameters) {
    nb::dict row;
    row["parameter"] = p.name;
    row["symbol"] = p.symbol;
    row["default"] = p.default_value;
    row["lower"] = p.low;
    row["upper"] = p.high;
    row["unit"] = p.unit;
    row["integer"] = p.integer;
    row["meaning"] = p.meaning;
    parameters.append(row);
  }
  for (const problems::MechanismResponse& r : mechanism.responses) {
    nb::dict row;
    row["response"] = r.name;
    row["kind"] = r.curve ? "curve" : "number";
    row["unit"] = r.unit;
    row["meaning"] = r.meaning;
    responses.append(row);
  }
  for (const problems::NamedPeak& p : mechanism.peaks) {
    nb::dict row;
    row["response"] = p.name;
    row["kind"] = "peak of " + p.curve;
    row["unit"] = "";
    row["meaning"] = p.meaning;
    responses.append(row);
  }
  nb::dict result;
  result["name"] = mechanism.name;
  result["title"] = mechanism.title;
  result["source"] = mechanism.source;
  result["parameters"] = parameters;
  result["responses"] = responses;
  return result;
}

namespace {

/// The problem files that are installed with the library, and what each is about.
std::vector<std::pair<std::string, std::string>> example_names() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const problems::ShippedFile& file : problems::shipped_files()) {
    result.emplace_back(file.name, file.sentence);
  }
  return result;
}

std::vector<std::string> mechanism_names() {
  std::vector<std::string> names;
  for (const problems::Mechanism& mechanism : problems::mechanisms()) {
    names.push_back(mechanism.name);
  }
  return names;
}

}  // namespace

void add_mechanisms(nb::module_& module) {
  module.def(
      "first_file",
      [](const std::string& mechanism) {
        return without_lock(
            [&] { return problems::first_file(problems::find_mechanism(mechanism)); });
      },
      nb::arg("mechanism"));
  module.def("examples", &example_names);
  module.def("mechanism_names", &mechanism_names);
  module.def("formula", [](const std::string& mechanism, const std::string& response) {
    return formula_of(problems::find_mechanism(mechanism), response);
  });
  module.def("formulas_page", [](const std::string& mechanism) {
    return without_lock(
        [&] { return cli::markdown_of(cli::formulas_page(problems::find_mechanism(mechanism))); });
  });
  module.def("mechanism",
             [](const std::string& name) { return dict_of(problems::find_mechanism(name)); });
}

}  // namespace camlaw::python
