// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "optim/tables/hypotheses.h"

/// Published tables and what becomes of them when they are computed again.
namespace camlaw::problems {

/// A number as a source prints it.
struct PrintedValue {
  std::string id, quantity, law, condition;
  optim::PrintedNumber number;
  std::string unit, place;
};

/// Reads values from CSV with the columns id, quantity, law, condition, printed, unit, decimals,
/// place (others are left alone). Throws std::invalid_argument naming `source` and the line.
std::vector<PrintedValue> read_printed_values(std::string_view csv, const std::string& source);

/// One printed value beside ours.
struct ReproducedValue {
  PrintedValue printed;
  optim::Finding verdict;
  double stated_value;     ///< with the inputs as the source states them; NaN where it does not say
  double explained_value;  ///< under the departures found
  std::vector<std::string> causes;  ///< the departures that this value needs
};

/// A system's table computed again.
struct SystemReproduction {
  std::string system, title, source;
  std::vector<ReproducedValue> values;
  std::size_t reproduced = 0, explained = 0, unexplained = 0;
  std::vector<std::string>
      departures;  ///< the smallest set of changes that explains the most digits
  std::vector<std::vector<std::string>> equals;  ///< other sets as small that explain as many
  std::size_t tried = 0;
  std::vector<std::string> notes = {};  ///< what else there is to say
  bool is_shipped = false;              ///< one of the program's tables, whose baseline is kept
};

/// Runs the hypothesis search for a system. `table` is in the order of `printed`.
SystemReproduction reproduce_system(std::string system, std::string title, std::string source,
                                    std::vector<PrintedValue> printed,
                                    const optim::PrintedTable& table);

/// "reproduced", "explained", "unexplained".
std::string_view to_string(optim::Finding verdict);

}  // namespace camlaw::problems
