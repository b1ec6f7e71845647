// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "problems/results/recorded_design.h"

/// What this run reads. No output takes the place of an input: write_files and check_writable
/// refuse it, and no clearing up removes it.
namespace camlaw::cli {

/// Names a file that is read; "-" and what is not a file yet are none.
void keep_input(const std::filesystem::path& path);
/// Names the file of a law, where what is asked for by this name is one.
void keep_law(const std::string& name, const std::string& folder = "");
/// Names all law files of one's own folder.
void keep_own_laws();
/// Names the file of a problem and the law files that it names.
void keep_inputs(const problems::ProblemStatement& statement);
/// The same of the problem of a design that was read from `file`. A result stands alone, but what
/// its problem was read from is somebody's work all the same (problems/results/input_files.h).
void keep_inputs(const problems::ReadDesign& read, const std::string& file);
/// The same of the problem that a study holds.
void keep_recorded(const problems::ProblemStatement& problem, const std::string& study);

/// Begins a problem at the design of a result, which is an input then.
void begin_with(problems::ProblemStatement& statement, const std::string& result);

/// What is set of a problem file that begins at a result's design: `set`, then that design.
std::vector<std::string> settings_from(const std::string& file, const std::vector<std::string>& set,
                                       const std::string& result);

/// That a study of a problem file, of which this is set, began at a result's design: throws
/// std::invalid_argument where it did not, for its searches would not begin there now either.
void check_began_at(const std::string& file, const std::vector<std::string>& set,
                    const std::string& result);

/// Whether a path leads to an input, by whatever name or link, or holds what a record's problem was
/// read from.
bool is_input(const std::filesystem::path& path);

}  // namespace camlaw::cli
