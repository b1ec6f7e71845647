// SPDX-License-Identifier: MIT
#include "cli/study_file.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "cli/files.h"
#include "numerics/file_place.h"

namespace camlaw::cli {

namespace fs = std::filesystem;

std::optional<std::string> study_file(const std::optional<std::string>& db,
                                      const std::optional<std::string>& out, bool resume) {
  if (db && db->empty()) throw std::invalid_argument("--db needs a file's name");
  if (db) return db;
  if (out) return (fs::path(*out) / "study.db").string();
  if (resume) throw std::invalid_argument("--resume needs the study's file, --db FILE");
  return {};
}

void check_there(const std::string& study) {
  std::error_code ignored;
  if (fs::exists(study, ignored)) return;
  throw std::invalid_argument(
      fmt::format("--resume: there is no study '{}'; leave out --resume to begin one", study));
}

void check_outputs(const std::vector<fs::path>& outputs, const std::optional<std::string>& study) {
  for (const fs::path& output : outputs) {
    if (!study || file_place(output) != file_place(*study)) continue;
    throw std::invalid_argument(
        fmt::format("--db and --out both write '{}'; the study needs another name", *study));
  }
  check_out(outputs);
}

void make_folder_of(const std::string& study) {
  const fs::path folder = file_place(study).parent_path();
  if (folder.empty()) return;
  std::error_code ignored;
  fs::create_directories(folder, ignored);
}

}  // namespace camlaw::cli
