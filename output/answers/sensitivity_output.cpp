// SPDX-License-Identifier: MIT
#include "output/answers/sensitivity_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::DesignParameter;
using problems::GlobalSensitivity;
using problems::LocalSensitivity;
using problems::NumberSensitivity;
using problems::Sensitivity;

/// Of each number as many rows are shown to people.
constexpr std::size_t kMostShown = 15;
/// Of Sobol indices those from here on.
constexpr double kLeastShown = 0.0005;

std::string four(double value) { return std::isnan(value) ? "-" : in_digits(value, 4); }

/// Indexes in the order of falling sizes; what is not a number comes last.
template <class Size>
std::vector<std::size_t> by_size(std::size_t count, const Size& size) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) { return std::isnan(size(i)) ? -1.0 : size(i); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  return order;
}

std::string slope_text(const Sensitivity& s) {
  const std::string text =
      s.is_kink() ? fmt::format("{} to {}", four(s.low), four(s.high)) : four(s.slope);
  return s.by_difference ? "~" + text : text;
}

std::string per(const std::string& unit, const std::string& other) {
  if (other == "1") return shown_unit(unit);
  const bool has_parts = other.find_first_of(" /") != std::string::npos;
  return fmt::format("{}/{}", unit == "1" ? "1" : unit, has_parts ? "(" + other + ")" : other);
}

std::vector<Cell> local_cells(const NumberSensitivity& number, const DesignParameter& parameter,
                              const Sensitivity& s) {
  return {number.name,
          {four(number.value), number.value},
          {"", number.unit},
          parameter.name,
          {four(parameter.value), parameter.value},
          {"", parameter.unit},
          {parameter.varies ? "variable" : "constant", parameter.varies},
          {slope_text(s), s.slope},
          per(number.unit, parameter.unit),
          {four(s.elasticity), s.elasticity},
          datum(s.low),
          datum(s.high),
          datum(!s.by_difference)};
}

bool any_of(const LocalSensitivity& local, bool (*is_so)(const Sensitivity&)) {
  return std::any_of(local.numbers.begin(), local.numbers.end(), [&](const NumberSensitivity& n) {
    return std::any_of(n.by.begin(), n.by.end(), is_so);
  });
}

}  // namespace

Table local_sensitivity_table(const LocalSensitivity& local) {
  Table table{
      .key = "derivatives",
      .columns = {names("number", "number"), numbers("value", "value"), data("unit"),
                  names("parameter", "parameter"), numbers("is", "parameter_value"),
                  data("parameter_unit"), words("", "varies"), numbers("derivative", "derivative"),
                  words("in", "derivative_unit"), numbers("% per %", "elasticity"),
                  data("least_derivative"), data("greatest_derivative"), data("exact")}};
  std::vector<std::vector<Cell>> rest;
  for (const NumberSensitivity& number : local.numbers) {
    const auto order = by_size(number.by.size(), [&](std::size_t i) {
      const Sensitivity& s = number.by[i];
      return std::isnan(s.elasticity) ? std::max(std::abs(s.low), std::abs(s.high)) * 1e-300
                                      : std::abs(s.elasticity);
    });
    std::size_t count = 0;
    for (const std::size_t i : order) {
      const Sensitivity& s = number.by[i];
      auto cells = local_cells(number, local.parameters[i], s);
      const bool is_zero = s.low == 0 && s.high == 0;
      if (is_zero || count == kMostShown) {
        rest.push_back(std::move(cells));
      } else {
        table.add(std::move(cells));
        ++count;
      }
    }
  }
  table.shown = table.rows.size();
  for (auto& cells : rest) table.add(std::move(cells));
  return table;
}

std::string local_sensitivity_words(const LocalSensitivity& local) {
  std::string text =
      "derivatives at this design, exact unless marked, and by how many percent each number "
      "changes when the parameter changes by one percent; entries left out are 0\n";
  const auto is_long = [](const NumberSensitivity& n) {
    const auto counts = [](const Sensitivity& s) { return s.low != 0 || s.high != 0; };
    return static_cast<std::size_t>(std::count_if(n.by.begin(), n.by.end(), counts)) > kMostShown;
  };
  if (std::any_of(local.numbers.begin(), local.numbers.end(), is_long)) {
    text +=
        fmt::format("for each number, the {} parameters that matter most are shown\n", kMostShown);
  }
  if (any_of(local, [](const Sensitivity& s) { return s.is_kink(); })) {
    text +=
        "two values: the derivative differs to each side, as where several peaks are equally high; "
        "the percentage is for their mean\n";
  }
  if (any_of(local, [](const Sensitivity& s) { return s.by_difference; })) {
    text +=
        "~: by finite differences, since the extreme lies at a joint of the law that moves, or at "
        "a kink of the formula, where the formula's own derivative holds for one side only\n";
  }
  if (!local.left_out.empty()) text += local.left_out + "\n";
  return text;
}

namespace {

std::string interval_text(const optim::SobolEstimate& e) {
  return fmt::format("{} .. {}", shown(e.low, 3), shown(e.high, 3));
}

std::vector<Cell> global_cells(const GlobalSensitivity& global, std::size_t n, std::size_t p) {
  const problems::SensitivityRange& range = global.over.ranges[p];
  const optim::SobolIndices& indices = global.indices[n];
  const auto &first = indices.first[p], &total = indices.total[p];
  return {global.numbers[n].name,
          range.parameter.name,
          {four(range.lower), range.lower},
          {four(range.upper), range.upper},
          {shown_unit(range.parameter.unit), range.parameter.unit},
          {shown(first.value, 3), first.value},
          interval_text(first),
          {shown(total.value, 3), total.value},
          interval_text(total),
          datum(first.low),
          datum(first.high),
          datum(total.low),
          datum(total.high)};
}

Table spread_of_numbers(const GlobalSensitivity& global) {
  Table table{.key = "numbers",
              .columns = {names("number", "number"), numbers("mean", "mean"),
                          numbers("standard deviation", "deviation"), numbers("lowest", "lowest"),
                          numbers("highest", "highest"), words("unit", "unit"), data("samples"),
                          data("undefined")}};
  for (std::size_t n = 0; n < global.numbers.size(); ++n) {
    const optim::SobolIndices& i = global.indices[n];
    table.add({global.numbers[n].name,
               {four(i.mean), i.mean},
               {four(i.deviation), i.deviation},
               {four(i.lowest), i.lowest},
               {four(i.highest), i.highest},
               {shown_unit(global.numbers[n].unit), global.numbers[n].unit},
               datum(i.samples),
               datum(i.undefined)});
  }
  return table;
}

}  // namespace

Table global_sensitivity_table(const GlobalSensitivity& global) {
  Table table{.key = "indices",
              .columns = {names("number", "number"), names("parameter", "parameter"),
                          numbers("from", "lower"), numbers("to", "upper"), words("unit", "unit"),
                          numbers("first order", "first"), words("its 95 %"),
                          numbers("total", "total"), words("its 95 %"), data("first_low"),
                          data("first_high"), data("total_low"), data("total_high")}};
  std::vector<std::vector<Cell>> rest;
  for (std::size_t n = 0; n < global.numbers.size(); ++n) {
    const auto& total = global.indices[n].total;
    for (const std::size_t p :
         by_size(total.size(), [&](std::size_t i) { return total[i].value; })) {
      if (std::isnan(total[p].value)) continue;
      const bool is_shown =
          std::max(total[p].value, std::abs(global.indices[n].first[p].value)) >= kLeastShown;
      (is_shown ? table.rows : rest).push_back(global_cells(global, n, p));
    }
  }
  table.shown = table.rows.size();
  for (auto& cells : rest) table.add(std::move(cells));
  return table;
}

std::string global_sensitivity_words(const GlobalSensitivity& global) {
  using problems::RangesFrom;
  const char* ranges = global.over.from == RangesFrom::Stated ? "the stated ranges"
                       : global.over.from == RangesFrom::File
                           ? "the ranges of the problem"
                           : "1 % to either side of each parameter, as no ranges are stated";
  std::size_t undefined = 0, samples = 0;
  for (const optim::SobolIndices& i : global.indices) {
    undefined = std::max(undefined, i.undefined);
    samples = std::max(samples, i.samples + i.undefined);
  }
  std::string text = fmt::format(
      "Sobol indices over {}: the share of a number's variance that a parameter makes alone (first "
      "order) and with others (total), from {} samples of {} points, with 95 % intervals from "
      "resampling; entries left out round to 0\n",
      ranges, samples, global.over.ranges.size() + 2);
  if (undefined > 0) {
    text += fmt::format("up to {} of the samples have no value somewhere and do not count\n",
                        undefined);
  }
  for (std::size_t n = 0; n < global.numbers.size(); ++n) {
    const auto& total = global.indices[n].total;
    const bool is_constant =
        std::all_of(total.begin(), total.end(), [](const auto& e) { return std::isnan(e.value); });
    if (is_constant) text += fmt::format("{} is the same everywhere\n", global.numbers[n].name);
  }
  return text;
}

Document sensitivity_document(const LocalSensitivity& local, const GlobalSensitivity* global) {
  Document own;
  own.say(local_sensitivity_words(local));
  own.add(local_sensitivity_table(local));
  if (!local.left_out.empty()) own.fact("left_out", local.left_out);
  if (global != nullptr) {
    Document indices;
    indices.say("\n" + global_sensitivity_words(*global));
    indices.add(spread_of_numbers(*global));
    indices.say("\n");
    indices.add(global_sensitivity_table(*global));
    indices.fact("ranges_from", global->over.from == problems::RangesFrom::Stated ? "stated"
                                : global->over.from == problems::RangesFrom::File ? "file"
                                                                                  : "hundredths");
    own.add("sobol", std::move(indices));
  }
  Document document;
  document.add("sensitivity", std::move(own));
  return document;
}

}  // namespace camlaw::cli
