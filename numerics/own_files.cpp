// SPDX-License-Identifier: MIT
#include "numerics/own_files.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <vector>

namespace camlaw {
namespace {

namespace fs = std::filesystem;

bool lies_in(const fs::path& path, const fs::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

/// Those that were added.
struct AddedFolders {
  std::mutex mutex;
  std::vector<fs::path> folders;
};
AddedFolders& added() {
  static AddedFolders all;
  return all;
}

std::vector<fs::path> added_folders() {
  const std::lock_guard lock(added().mutex);
  return added().folders;
}

/// Where the program that runs is; none where the system does not tell.
std::optional<fs::path> program_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error || !program.is_absolute()) return std::nullopt;
  return program.parent_path();
}

/// Folders that nobody else can put files into unless the program's own can be replaced.
std::vector<fs::path> own_folders() {
  std::vector<fs::path> folders = added_folders();
  if (const auto folder = program_folder()) {
    const fs::path build = CAMLAW_BUILD_FOLDER;
    folders.push_back(*folder);
    if (lies_in(*folder, build)) folders.push_back(build / "plugins");
    folders.push_back(folder->parent_path() / "libexec/camlaw");
  }
  folders.insert(folders.end(), {CAMLAW_LIBEXEC, CAMLAW_PACKAGE_LIBEXEC});
  return folders;
}

std::optional<std::string> found(const std::string& name, int access_mode) {
  std::error_code ignored;
  for (const fs::path& folder : own_folders()) {
    const fs::path path = folder / name;
    if (fs::is_regular_file(path, ignored) && access(path.c_str(), access_mode) == 0) {
      return path.string();
    }
  }
  return std::nullopt;
}

/// The folders of data that people read too: first those that were added.
std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders = added_folders();
  if (const auto folder = program_folder()) {
    folders.push_back(folder->parent_path() / "share/camlaw");
  }
  folders.insert(folders.end(), {CAMLAW_DATA, CAMLAW_PACKAGE_DATA});
  return folders;
}

}  // namespace

std::optional<std::string> own_data(const std::string& name) {
  std::error_code ignored;
  for (const fs::path& folder : data_folders()) {
    const fs::path path = folder / name;
    if (fs::is_directory(path, ignored)) return path.string();
  }
  return std::nullopt;
}

std::optional<std::string> own_file(const std::string& name) { return found(name, R_OK); }

std::optional<std::string> own_program(const std::string& name) { return found(name, X_OK); }

void add_own_folder(const std::string& folder) {
  const std::lock_guard lock(added().mutex);
  added().folders.emplace_back(folder);
}

}  // namespace camlaw
