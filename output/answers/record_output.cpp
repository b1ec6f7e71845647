// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>

#include "numerics/linear/statistics.h"
#include "output/answers/fit_output.h"
#include "output/answers/next_step.h"
#include "output/document/text_table.h"
#include "output/figure/fit_panels.h"

namespace camlaw::cli {
namespace {

const std::string& unit_of(const RecordAnswer& answer) { return answer.record.response.unit; }

}  // namespace

std::string record_text(const RecordAnswer& answer) {
  const optim::FitResult& fit = answer.fit.fit;
  const std::string& unit = unit_of(answer);
  std::string text = fmt::format("{} of {}, recorded at {} places\n", answer.record.response.name,
                                 answer.fit.machine.mechanism->name, fit.residuals.size());
  if (answer.left_out > 0)
    text += fmt::format("{} rows without a number left out\n", answer.left_out);
  text += condensed_text(answer.record.each, answer.record.left_out) + fitted_table(fit);
  text += fmt::format("rms {}, largest {} at {} {}; neighbouring residuals correlate by {:.2f}\n",
                      with_unit(number(fit.rms), unit),
                      with_unit(number(std::abs(fit.residuals[fit.largest])), unit),
                      number(answer.record.place[fit.largest]),
                      answer.record.response.response->along, answer.fit.left.correlation);
  if (!answer.fit.distrust.empty()) {
    text += fmt::format("not to be trusted: {}\n", answer.fit.distrust);
  }
  return text;
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

Json record_json(const RecordAnswer& answer) {
  const optim::FitResult& fit = answer.fit.fit;
  return {{"response", answer.record.response.name},
          {"mechanism", answer.fit.machine.mechanism->name},
          {"law", answer.fit.machine.laws.empty() ? Json(nullptr)
                                                  : Json(answer.fit.machine.laws.front().name())},
          {"parameters", fitted_json(fit)},
          {"samples", fit.residuals.size()},
          {"left_out", answer.left_out},
          {"rows_each", answer.record.each},
          {"far_rows_left_out", answer.record.left_out},
          {"outliers", answer.fit.outliers.samples.size()},
          {"rms", to_json(fit.rms)},
          {"max_residual", to_json(std::abs(fit.residuals[fit.largest]))},
          {"max_residual_at", to_json(answer.record.place[fit.largest])},
          {"residual_unit", unit_of(answer)},
          {"standard_deviation", to_json(fit.sigma)},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"correlation", to_json(answer.fit.left.correlation)},
          {"criterion",
           to_json(optim::aicc(fit.residuals.size(), fit.parameters.size(), fit.sum_of_squares))},
          {"criterion_name", "AICc"},
          {"ranking", Json::array()},
          {"identifiable", all_identifiable(fit)},
          {"trusted", answer.fit.distrust.empty()},
          {"reason", answer.fit.distrust}};
}

Figure record_figure(const RecordAnswer& answer) {
  const problems::RecordedCurve& record = answer.record;
  constexpr std::size_t kPoints = 2000;
  const std::vector<std::size_t> order = optim::order_of(record.place);
  Line model{.name = "computed"};
  for (std::size_t k = 0; k < order.size(); k += order.size() / kPoints + 1) {
    model.x.push_back(record.place[order[k]]);
    model.y.push_back(answer.fit.model[order[k]]);
  }
  Figure figure;
  figure.title = "Machine behind a record";
  figure.columns = 2;
  figure.panel_width = 480;
  draw({.title = record.response.name,
        .x = {.label = "place", .unit = shown_unit(record.response.response->along)},
        .y = {.label = "recorded and computed", .unit = shown_unit(unit_of(answer))},
        .dots = "recorded",
        .left = "recorded less computed",
        .place = record.place,
        .value = record.value,
        .residual = answer.fit.fit.residuals,
        .model = std::move(model)},
       figure);
  return figure;
}

}  // namespace camlaw::cli
