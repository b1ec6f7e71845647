// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/files.h"
#include "fitting/cams/found_program.h"

/// The motion program that a fit writes to its --out folder.
namespace camlaw::cli {

/// The files of a program: program.toml and the laws that it names. `source` is the table.
std::vector<OutputFile> program_files(const std::filesystem::path& folder,
                                      const std::string& source,
                                      const problems::FoundProgram& program);

/// The program of a lift, where it is written to a folder: for `machine`, or, without one, for a
/// usual one, which a note says. None where no program follows from the record. Throws
/// std::invalid_argument where `machine` cannot have the motion.
std::optional<problems::FoundProgram> program_of_lift(const problems::RecordedMotion& motion,
                                                      const problems::ProblemStatement* machine,
                                                      const std::optional<std::string>& out,
                                                      std::vector<std::string>& notes);

}  // namespace camlaw::cli
