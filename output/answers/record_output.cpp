// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>

#include "numerics/linear/statistics.h"
#include "output/answers/answer_formats.h"
#include "output/answers/fit_output.h"
#include "output/answers/next_step.h"
#include "output/document/formatting.h"
#include "output/figure/fit_panels.h"

namespace camlaw::cli {
namespace {

const std::string& unit_of(const RecordAnswer& answer) { return answer.record.response.unit; }

}  // namespace

Document record_document(const RecordAnswer& answer) {
  const optim::FitResult& fit = answer.fit.fit;
  const problems::ProblemStatement& machine = answer.fit.machine;
  const std::string &name = answer.record.response.name, &unit = unit_of(answer);
  const double largest = std::abs(fit.residuals[fit.largest]);
  const double largest_at = answer.record.place[fit.largest];
  Document document;
  document.fact("format", kFitFormat.text());
  document.say(fmt::format("{} of {}, recorded at {} places\n", name, machine.mechanism->name,
                           fit.residuals.size()));
  document.fact("response", name);
  document.fact("mechanism", machine.mechanism->name);
  document.fact("law", machine.laws.empty() ? Json(nullptr) : Json(machine.laws.front().name()));
  document.fact("samples", fit.residuals.size());
  add_left_out(answer.left_out, document);
  add_condensed(answer.record.each, answer.record.left_out, document);
  document.add(fitted_table(fit));
  document.say(fmt::format(
      "rms {}, largest {} at {} {}; neighbouring residuals correlate by {:.2f}\n",
      with_unit(number(fit.rms), unit), with_unit(number(largest), unit), number(largest_at),
      answer.record.response.response->along, answer.fit.left.correlation));
  document.fact("outliers", answer.fit.outliers.samples.size());
  document.fact("rms", fit.rms);
  document.fact("max_residual", largest);
  document.fact("max_residual_at", largest_at);
  document.fact("residual_unit", unit);
  document.fact("standard_deviation", fit.sigma);
  document.fact("degrees_of_freedom", fit.degrees_of_freedom);
  document.fact("correlation", answer.fit.left.correlation);
  document.fact("criterion",
                optim::aicc(fit.residuals.size(), fit.parameters.size(), fit.sum_of_squares));
  document.fact("criterion_name", "AICc");
  document.fact("ranking", Json::array());
  document.fact("identifiable", all_identifiable(fit));
  add_trust(answer.fit.distrust, document);
  return document;
}

std::string record_evaluation(const RecordAnswer& answer,
                              const std::vector<std::string>& settings) {
  std::string command = "evaluate " + shell_word(answer.machine_file);
  const auto& variables = answer.fit.machine.variables;
  for (const std::string& setting : settings) {
    const std::string name = boost::algorithm::trim_copy(setting.substr(0, setting.find('=')));
    const bool is_found = std::any_of(variables.begin(), variables.end(),
                                      [&](const auto& v) { return v.name == name; });
    if (!is_found) command += " --set " + shell_word(setting);
  }
  for (const problems::VariableStatement& v : answer.fit.machine.variables) {
    command += fmt::format(" --set '{}={}'", v.name, with_unit(in_digits(v.start), v.unit));
  }
  return command;
}

Figure record_figure(const RecordAnswer& answer) {
  const problems::RecordedCurve& record = answer.record;
  constexpr std::size_t kPoints = 2000;  // more points than a figure has pixels
  const std::vector<std::size_t> order = optim::order_of(record.place);
  Line model{.name = "computed"};
  for (std::size_t k = 0; k < order.size(); k += order.size() / kPoints + 1) {
    model.x.push_back(record.place[order[k]]);
    model.y.push_back(answer.fit.model[order[k]]);
  }
  Figure figure;
  figure.title = "Machine behind a recorded curve";
  figure.columns = 2;
  figure.panel_width = 480;
  draw({.title = record.response.name,
        .x = {.label = "abscissa", .unit = shown_unit(record.response.response->along)},
        .y = {.label = "recorded and computed", .unit = shown_unit(unit_of(answer))},
        .dots = "recorded",
        .left = "recorded minus computed",
        .place = record.place,
        .value = record.value,
        .residual = answer.fit.fit.residuals,
        .model = std::move(model)},
       figure);
  return figure;
}

}  // namespace camlaw::cli
