// SPDX-License-Identifier: MIT
#include "problems/published/table/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "numerics/text/csv_rows.h"

namespace camlaw::problems {

namespace {

/// The double nearest to a printed number, or an integer.
template <class Number>
Number read_number(const std::string& text, const char* column, std::size_t line) {
  Number number{};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc{} || end != last) {
    throw std::invalid_argument(
        fmt::format("line {}: column {}: '{}' is not a number", line, column, text));
  }
  return number;
}

}  // namespace

std::vector<PrintedValue> read_printed_values(std::string_view csv, const std::string& source) {
  try {
    std::vector<PrintedValue> result;
    for (const auto& [line, cells] : csv_rows(
             csv, {"id", "quantity", "law", "condition", "unit", "place", "printed", "decimals"})) {
      result.push_back({.id = cells[0],
                        .quantity = cells[1],
                        .law = cells[2],
                        .condition = cells[3],
                        .number = {},
                        .unit = cells[4],
                        .place = cells[5]});
      result.back().number.value = read_number<double>(cells[6], "printed", line);
      result.back().number.decimals = read_number<int>(cells[7], "decimals", line);
    }
    return result;
  } catch (const std::exception& error) {
    throw std::invalid_argument(fmt::format("{}: {}", source, error.what()));
  }
}

namespace {

std::string departure_name(const optim::Hypothesis& hypothesis, int rank) {
  const std::string& value = hypothesis.alternatives[static_cast<std::size_t>(rank - 1)];
  const std::string stated = hypothesis.unstated ? "not stated" : "stated " + hypothesis.stated;
  return fmt::format("{}: {} ({})", hypothesis.name, value, stated);
}

/// With how many alternatives each was picked from: one among a thousand is a fit, not a proof.
std::vector<std::string> departure_names(const optim::PrintedTable& table,
                                         const optim::Assignment& choice) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < choice.size(); ++i) {
    if (choice[i] == 0) continue;
    result.push_back(fmt::format("{}, one of {} tried",
                                 departure_name(table.hypotheses[i], choice[i]),
                                 table.hypotheses[i].alternatives.size()));
  }
  return result;
}

/// The same of the departures that were found, with how many values need each.
std::vector<std::string> departures_found(const optim::PrintedTable& table,
                                          const optim::Reproduction& found) {
  std::vector<std::string> result = departure_names(table, found.departures);
  std::size_t departed = 0;
  for (std::size_t i = 0; i < found.departures.size(); ++i) {
    if (found.departures[i] == 0) continue;
    const auto values =
        std::count_if(found.rows.begin(), found.rows.end(), [i](const optim::Explanation& row) {
          return std::any_of(row.causes.begin(), row.causes.end(),
                             [i](const auto& cause) { return cause.first == i; });
        });
    result[departed++] += fmt::format(", needed by {} value{}", values, values == 1 ? "" : "s");
  }
  return result;
}

}  // namespace

SystemReproduction reproduce_system(std::string system, std::string title, std::string source,
                                    std::vector<PrintedValue> printed,
                                    const optim::PrintedTable& table) {
  const optim::Reproduction found = optim::reproduce(table);
  SystemReproduction result;
  result.system = std::move(system);
  result.title = std::move(title);
  result.source = std::move(source);
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const optim::Explanation& row = found.rows[i];
    ReproducedValue value{std::move(printed[i]), row.verdict, row.value, row.explained_value, {}};
    for (const auto& [hypothesis, rank] : row.causes) {
      value.causes.push_back(departure_name(table.hypotheses[hypothesis], rank));
    }
    if (row.verdict == optim::Finding::Explained && row.misprint) {
      value.causes.push_back(
          fmt::format("misprinted digit: {} for {}",
                      optim::as_printed(value.printed.number.value, value.printed.number.decimals),
                      optim::as_printed(row.explained_value, value.printed.number.decimals)));
    }
    if (row.broken) value.causes.push_back("does not agree under the departures of the other rows");
    result.values.push_back(std::move(value));
  }
  result.reproduced = found.reproduced;
  result.explained = found.explained;
  result.unexplained = found.unexplained;
  result.departures = departures_found(table, found);
  for (const optim::Assignment& other : found.equals) {
    std::vector<std::string> names = departure_names(table, other);
    const std::size_t misprints = found.departed + found.misprints - names.size();
    if (misprints > 0) {
      names.push_back(fmt::format("{} misprinted digit{}", misprints, misprints == 1 ? "" : "s"));
    }
    result.equals.push_back(std::move(names));
  }
  result.tried = found.tried;
  return result;
}

std::string_view to_string(optim::Finding verdict) {
  switch (verdict) {
    case optim::Finding::Reproduced:
      return "reproduced";
    case optim::Finding::Explained:
      return "explained";
    case optim::Finding::Unexplained:
      return "unexplained";
  }
  return "?";
}

}  // namespace camlaw::problems
