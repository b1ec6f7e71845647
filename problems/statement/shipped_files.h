// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The problem files that are installed with the program.
namespace camlaw::problems {

struct ShippedFile {
  std::string name;  ///< "cams/roller_least_base"
  std::filesystem::path path;
  std::string sentence;  ///< the first of the file's first comment
};

/// All of them, by name. Throws std::runtime_error where none are installed.
std::vector<ShippedFile> shipped_files();

/// One by its name, with or without its folder and its ending. Throws std::invalid_argument with
/// near and known names, or with those between which a name without a folder does not decide.
ShippedFile find_shipped(std::string_view name);

/// A problem file and all that it refers to, tables, catalogues and laws, and the data that bear
/// its name: paths relative to its folder, itself first.
std::vector<std::filesystem::path> files_of(const ShippedFile& shipped);

}  // namespace camlaw::problems
