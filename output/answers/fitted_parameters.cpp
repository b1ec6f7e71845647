// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/answers/fit_output.h"
#include "output/document/text_table.h"

namespace camlaw::cli {

std::string number(double value) {
  return std::isnan(value) ? "-" : in_digits(value, 6);  // what was not computed
}

std::string fitted_table(const optim::FitResult& fit) {
  TextTable table({{"number", TextTable::Align::Left},
                   {"value"},
                   {"from"},
                   {"to"},
                   {"unit", TextTable::Align::Left},
                   {"", TextTable::Align::Left}});
  for (const optim::FittedParameter& p : fit.parameters) {
    table.add({p.name, number(p.value), number(p.low), number(p.high), shown_unit(p.unit),
               !p.identifiable ? "not determined"
               : p.at_bound    ? "at its bound"
                               : ""});
  }
  return table.text();
}

std::string condensed_text(std::size_t each, std::size_t left_out) {
  if (each == 1) return "";
  return fmt::format(
      "{} neighbouring rows each are taken as their mean; {} rows far off left out\n", each,
      left_out);
}

Json fitted_json(const optim::FitResult& fit) {
  Json result = Json::array();
  for (const optim::FittedParameter& p : fit.parameters) {
    result.push_back({{"name", p.name},
                      {"value", to_json(p.value)},
                      {"low", to_json(p.low)},
                      {"high", to_json(p.high)},
                      {"standard_deviation", to_json(p.standard_deviation)},
                      {"unit", p.unit},
                      {"identifiable", p.identifiable},
                      {"at_bound", p.at_bound}});
  }
  return result;
}

bool all_identifiable(const optim::FitResult& fit) {
  return std::all_of(fit.parameters.begin(), fit.parameters.end(),
                     [](const auto& p) { return p.identifiable; });
}

}  // namespace camlaw::cli
