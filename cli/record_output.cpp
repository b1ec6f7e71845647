// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/fit_output.h"
#include "cli/text_table.h"
#include "optim/fit/statistics.h"

namespace camlaw::cli {
namespace {

std::string number(double value) { return in_digits(value, 6); }

const std::string& unit_of(const RecordAnswer& answer) { return answer.record.response.unit; }

/// How to look at the machine that was found: "--set 'mass=1.2 kg'".
std::string settings(const problems::ProblemStatement& machine) {
  std::string text;
  for (const problems::VariableStatement& v : machine.variables) {
    text += fmt::format(" --set '{}={}'", v.name, with_unit(in_digits(v.start), v.unit));
  }
  return text;
}

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
                      answer.record.response.response->along, answer.fit.correlation);
  if (!answer.fit.distrust.empty()) {
    text += fmt::format("not to be trusted: {}\n", answer.fit.distrust);
  }
  return text +
         fmt::format("camlaw evaluate {}{}\n", answer.machine_file, settings(answer.fit.machine));
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
          {"far_off", answer.fit.far_off.samples.size()},
          {"rms", to_json(fit.rms)},
          {"max_residual", to_json(std::abs(fit.residuals[fit.largest]))},
          {"max_residual_at", to_json(answer.record.place[fit.largest])},
          {"residual_unit", unit_of(answer)},
          {"standard_deviation", to_json(fit.sigma)},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"correlation", to_json(answer.fit.correlation)},
          {"criterion",
           to_json(optim::aicc(fit.residuals.size(), fit.parameters.size(), fit.sum_of_squares))},
          {"criterion_name", "AICc"},
          {"ranking", Json::array()},
          {"identifiable", all_identifiable(fit)},
          {"trusted", answer.fit.distrust.empty()},
          {"reason", answer.fit.distrust}};
}

Figure record_figure(const RecordAnswer& answer) {
  constexpr std::size_t kDots = 120, kResiduals = 2000;  // more would hide the curve, be a blot
  const problems::RecordedCurve& record = answer.record;
  const std::size_t count = record.place.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return record.place[a] < record.place[b]; });
  Panel data, left;
  data.title = record.response.name;
  data.x = left.x = {.label = "place", .unit = shown_unit(record.response.response->along)};
  data.y = {.label = "recorded and computed", .unit = shown_unit(unit_of(answer))};
  left.y = {.label = "recorded less computed", .unit = shown_unit(unit_of(answer))};
  Markers dots{.name = "recorded", .colour = "#555555", .filled = false, .size = 2.5};
  Markers residuals{.name = "residuals", .colour = "#0072b2", .size = 1.5};
  Line model{.name = "computed", .colour = "#d55e00"};
  for (std::size_t k = 0; k < count; k += count / kDots + 1) {
    dots.points.push_back({record.place[order[k]], record.value[order[k]]});
  }
  for (std::size_t k = 0; k < count; k += count / kResiduals + 1) {
    const std::size_t i = order[k];
    residuals.points.push_back({record.place[i], -answer.fit.fit.residuals[i]});
    model.x.push_back(record.place[i]);
    model.y.push_back(answer.fit.model[i]);
  }
  data.lines.push_back(std::move(model));
  data.markers.push_back(std::move(dots));
  left.markers.push_back(std::move(residuals));
  Figure figure;
  figure.title = "Machine behind a record";
  figure.columns = 2;
  figure.panel_width = 480;
  figure.panels.push_back(std::move(data));
  figure.panels.push_back(std::move(left));
  return figure;
}

}  // namespace camlaw::cli
