// SPDX-License-Identifier: MIT
#include <map>

#include "output/answers/cam_export.h"
#include "output/answers/judged_words.h"
#include "output/answers/shop_export.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/results.h"
#include "python/bindings/running.h"

/// Drawings, G-code and tables, as 'camlaw export' writes them.
namespace camlaw::python {
namespace {

cli::ExportOptions options_of(const std::map<std::string, std::string>& told) {
  cli::ExportOptions options;
  const std::map<std::string, cli::ExportOptions::Text*> known{
      {"format", &options.format},
      {"out", &options.out},
      {"curve", &options.curve},
      {"tolerance", &options.tolerance},
      {"step", &options.step},
      {"form", &options.form},
      {"decimals", &options.decimals},
      {"tool", &options.tool},
      {"feed", &options.feed},
      {"clearance", &options.clearance},
      {"depth", &options.depth},
      {"slave", &options.slave},
      {"cam", &options.cam},
      {"zero", &options.zero},
      {"unit", &options.unit},
      {"master", &options.master},
      {"cycle", &options.cycle},
      {"columns", &options.columns},
      {"separator", &options.separator},
      {"lead", &options.lead},
      {"compensation", &options.compensation},
      {"allowances", &options.allowances},
      {"bore", &options.bore},
      {"keyway", &options.keyway},
      {"width", &options.width},
      {"groove", &options.groove},
      {"blank", &options.blank},
      {"form_tolerance", &options.form_tolerance}};
  const std::map<std::string, bool*> switches{{"drawing", &options.drawing},
                                              {"decimal_comma", &options.decimal_comma}};
  for (const auto& [name, text] : told) {
    const auto found = switches.find(name);
    if (found == switches.end()) {
      *known.at(name) = text;
    } else {
      *found->second = true;
    }
  }
  return options;
}

/// The text, and the limits that the design does not meet.
nb::tuple exported(const problems::ReadDesign& read, const std::string& file,
                   const std::map<std::string, std::string>& told) {
  const cli::ExportedText written = run_whole([&](const Work& work) {
    problems::ReadDesign design = read;
    design.problem.stop = design.statement.stop = work.stop();
    cli::ExportOptions options = options_of(told);
    options.file = file;
    const cli::FormatRow& format = cli::format_of(options);
    cli::check_options(options, format);
    const std::vector<std::string> review = design.verdict
                                                ? cli::record_words(design, cli::reviewed(design))
                                                : std::vector<std::string>{};
    cli::take_bore(options, design.statement);
    cli::TakenCam taken =
        cli::take_cam(options.cam, file, "cam=\"{}\"", options.slave, design.statement);
    return cli::exported_text(options, format, std::move(design), review, std::move(taken));
  });
  nb::list unmet;
  for (const std::string& limit : written.unmet) unmet.append(limit);
  return nb::make_tuple(written.text, unmet);
}

}  // namespace

void add_exports(nb::module_& module) {
  module.def(
      "export_result",
      [](const StoredResult& result, const std::map<std::string, std::string>& told) {
        if (!result.design) {
          throw std::invalid_argument("the result has no design: its search found none");
        }
        return exported(*result.design, result.file.empty() ? "result" : result.file, told);
      },
      nb::arg("result"), nb::arg("options"));
  module.def(
      "export_problem",
      [](const StatedProblem& problem, const std::map<std::string, std::string>& told) {
        return exported({problem.statement}, problem.statement.source, told);
      },
      nb::arg("problem"), nb::arg("options"));
}

}  // namespace camlaw::python
