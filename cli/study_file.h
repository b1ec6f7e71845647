// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The file that a command which records a study writes.
namespace camlaw::cli {

/// As asked for by --db, else in the folder of --out; none: nothing is recorded. Throws
/// std::invalid_argument for a file without a name, and where there is none to resume.
std::optional<std::string> study_file(const std::optional<std::string>& db,
                                      const std::optional<std::string>& out, bool resume);

/// A study that is also one of the files of --out would be written over when it is done: throws
/// std::invalid_argument.
void keep_apart(const std::string& study, const std::vector<std::filesystem::path>& outputs);

/// Makes the folder that a study is to stand in; the study says what is wrong with the place.
void make_folder_of(const std::string& study);

}  // namespace camlaw::cli
