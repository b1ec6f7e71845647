// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// A system that can be reproduced by name.
struct ReproducibleSystem {
  std::string name;
  /// Throws optim::Interrupted where `stop`, which may be null, is set before the end.
  std::function<SystemReproduction(const std::atomic<bool>* stop)> reproduce;
  std::vector<std::string> files = {};  ///< that are read: the table's, and those of its laws
};
/// Those that the program has: tables that are stated in files (problems/published), and the COPS
/// cam, whose values are optima.
const std::vector<ReproducibleSystem>& reproducible_systems();

/// One of them by its name, or a table's file by its path, which ends in .toml or has a folder.
/// Throws std::invalid_argument with the known names, or for what is wrong in the file.
ReproducibleSystem find_reproducible(const std::string& name_or_path);
/// Whether a name is that of a file.
bool names_table_file(const std::string& name_or_path);

/// Values whose verdict is worse than the one in problems/baseline.csv, each with both; also where
/// a value of the baseline is gone. None as long as nothing that used to reproduce has ceased to,
/// and none of a table that is not the program's.
std::vector<std::string> worsened(const SystemReproduction& result);

}  // namespace camlaw::problems
