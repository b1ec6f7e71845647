// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/command.h"
#include "machines/registry.h"
#include "output/answers/mechanism_output.h"
#include "output/document/markdown.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

struct MechanismsOptions {
  std::string name;
  std::optional<std::string> formula;
  bool json = false, markdown = false, formulas = false;
};

/// What is asked for; without a name all of them.
Document asked_for(const MechanismsOptions& options) {
  if (options.name.empty()) return mechanisms_document();
  const problems::Mechanism& mechanism = problems::find_mechanism(options.name);
  return options.formula ? formula_document(mechanism, *options.formula)
                         : mechanism_document(mechanism);
}

int show_mechanisms(const MechanismsOptions& options) {
  if (options.formula && (options.name.empty() || options.markdown)) {
    throw std::invalid_argument("--formula needs a mechanism's NAME, and goes with no page");
  }
  if (options.markdown && !options.name.empty()) {
    throw std::invalid_argument("--markdown: the page has all mechanisms; leave out NAME");
  }
  if (options.formulas && (options.name.empty() || options.formula || options.json)) {
    throw std::invalid_argument(
        "--formulas: the page has the formulas of one mechanism; write NAME --formulas");
  }
  if (options.formulas) {
    print_data(markdown_of(formulas_page(problems::find_mechanism(options.name))));
  } else if (options.markdown) {
    print_data(markdown_of(mechanisms_page()));
  } else {
    print(asked_for(options), options.json);
  }
  return kDone;
}

}  // namespace

Command mechanisms_command() {
  const auto options = std::make_shared<MechanismsOptions>();
  return {
      .name = "mechanisms",
      .help = "List the mechanisms of problem files",
      .options =
          {{"NAME", &options->name, takes::kMechanism,
            "one mechanism, with its parameters and responses"},
           json_switch(options->json),
           {.names = "--markdown",
            .target = &options->markdown,
            .takes = {},
            .help = "print the page docs/mechanisms.md",
            .excludes = "--json"},
           {.names = "--formulas",
            .target = &options->formulas,
            .takes = {},
            .help =
                "print a page of docs/machine-formulas: every formula of the mechanism, in LaTeX",
            .excludes = "--markdown"},
           {.names = "--formula",
            .target = &options->formula,
            .takes = "RESPONSE",
            .help = "print the formula of one response of the mechanism"}},
      .examples = {{"camlaw mechanisms", "the machines that a problem file may name"},
                   {"camlaw mechanisms disc-cam-roller",
                    "its parameters and responses, with units and meanings"},
                   {"camlaw mechanisms die-press --formula running_stress",
                    "how one response is calculated"}},
      .run = [options] { return show_mechanisms(*options); }};
}

}  // namespace camlaw::cli
