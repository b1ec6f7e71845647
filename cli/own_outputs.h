// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/files.h"

/// Which files of an --out folder are camlaw's own. The folder's record, ".camlaw.json", lists each
/// file that was written there with the SHA-256 of its content. A file that the record does not
/// list, or that has another content now, is somebody's work: no run replaces or removes it.
namespace camlaw::cli {

/// The record of one folder, as it stands on the disk.
class OwnOutputs {
 public:
  /// Where the record of a folder is.
  static std::filesystem::path record_of(const std::filesystem::path& folder);
  /// Reads the record; a folder without one has no file of camlaw.
  explicit OwnOutputs(const std::filesystem::path& folder);

  /// Throws RefusedOutput that names each of these files that stands there and is not
  /// camlaw's own: one that was changed since it was written, or, of `replaced`, one that the
  /// record does not list. Empty files, and what is not a regular file, hold no work. A JSON object
  /// whose own checksum fits (problems/results/seal.h) is camlaw's own without a record.
  void check(const std::vector<std::filesystem::path>& replaced,
             const std::vector<std::filesystem::path>& removed = {}) const;

  /// Of these files those that stand there and are listed.
  std::vector<std::filesystem::path> listed(const std::vector<std::filesystem::path>& files) const;

  /// The record's file after these files were written and those removed.
  OutputFile after(const std::vector<OutputFile>& written,
                   const std::vector<std::filesystem::path>& removed) const;

 private:
  /// What was written to a file.
  struct Written {
    std::uint64_t bytes;
    std::string sha256;
  };
  std::string name_of(const std::filesystem::path& file) const;

  std::filesystem::path folder_, record_;
  std::map<std::string, Written> files_;  ///< by their names in the folder
  bool is_foreign_ = false;               ///< what stands in the record's place is no record
};

}  // namespace camlaw::cli
