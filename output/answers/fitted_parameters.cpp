// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/answers/fit_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {

std::string number(double value) {
  return std::isnan(value) ? "-" : in_digits(value, 6);  // what was not computed
}

Cell number_cell(double value) { return {number(value), value}; }

namespace {

/// A fitted number and the ends of its interval: to two digits of half the interval, as further
/// ones are not known.
std::string worth(double value, const optim::FittedParameter& p) {
  constexpr int kKnown = 2, kMost = 6;
  const double half = (p.high - p.low) / 2;
  if (!std::isfinite(value) || !std::isfinite(half) || !(half > 0)) return number(value);
  const double least = std::floor(std::log10(half)) - (kKnown - 1);  // power of the last digit
  const double quantum = std::pow(10, least);
  if (std::abs(value) < quantum / 2) return "0";
  const double rounded = std::round(value / quantum) * quantum;
  const auto digits = static_cast<int>(std::floor(std::log10(std::abs(rounded))) - least) + 1;
  return in_digits(value, std::clamp(digits, 1, kMost));
}

Cell worth_cell(double value, const optim::FittedParameter& p) { return {worth(value, p), value}; }

}  // namespace

Table fitted_table(const optim::FitResult& fit) {
  Table table{
      .key = "parameters",
      .columns = {words("number", "name"), numbers("value", "value"), numbers("95 % from", "low"),
                  numbers("to", "high"), data("standard_deviation"), words("unit", "unit"),
                  words(""), data("identifiable"), data("at_bound")}};
  for (const optim::FittedParameter& p : fit.parameters) {
    table.add({p.name,
               worth_cell(p.value, p),
               worth_cell(p.low, p),
               worth_cell(p.high, p),
               datum(p.standard_deviation),
               {shown_unit(p.unit), p.unit},
               !p.identifiable ? "not determined"
               : p.at_bound    ? "at its bound"
                               : "",
               datum(p.identifiable),
               datum(p.at_bound)});
  }
  return table;
}

void add_condensed(std::size_t each, std::size_t left_out, Document& document) {
  if (each > 1) {
    document.say(
        fmt::format("{} neighbouring rows each are taken as their mean; {} rows far off left out\n",
                    each, left_out));
  }
  document.fact("rows_each", each);
  document.fact("outliers_left_out", left_out);
}

void add_left_out(std::size_t rows, Document& document) {
  if (rows > 0) document.say(fmt::format("{} rows without a number left out\n", rows));
  document.fact("left_out", rows);
}

void add_trust(const std::string& distrust, Document& document) {
  if (!distrust.empty()) document.say(fmt::format("not to be trusted: {}\n", distrust));
  document.fact("trusted", distrust.empty());
  document.fact("reason", distrust);
}

bool all_identifiable(const optim::FitResult& fit) {
  return std::all_of(fit.parameters.begin(), fit.parameters.end(),
                     [](const auto& p) { return p.identifiable; });
}

}  // namespace camlaw::cli
