// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "optim/study/record.h"

/// The file that a command which records a study writes.
namespace camlaw::cli {

/// As asked for by --db, else in the folder of --out; none: nothing is recorded. Throws
/// std::invalid_argument for a file without a name, and where there is none to resume.
std::optional<std::string> study_file(const std::optional<std::string>& db,
                                      const std::optional<std::string>& out, bool resume);

/// Throws std::invalid_argument where there is no study to resume.
void check_there(const std::string& study);

/// Throws where one of the files of --out cannot be written or is somebody's work (check_out), and
/// std::invalid_argument where one is also the study, which would be written over when it is done.
void check_outputs(const std::vector<std::filesystem::path>& outputs,
                   const std::optional<std::string>& study);

/// Makes the folder that a study is to stand in; the study says what is wrong with the place.
void make_folder_of(const std::string& study);

/// The record of a study, which has settings() and check_same(), on the file that is asked for,
/// whose folder is made; none: nothing is recorded. Throws as optim::StudyRecord::begin.
template <class Study>
std::optional<optim::StudyRecord> record_of(const std::optional<std::string>& path,
                                            const Study& study, bool resume) {
  if (!path) return {};
  make_folder_of(*path);
  return optim::StudyRecord::begin(
      *path, study.settings(), resume,
      [&](const optim::StudyRecord& record) { study.check_same(record); });
}

}  // namespace camlaw::cli
