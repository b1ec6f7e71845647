// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Files that take their places together or not at all.
namespace camlaw::cli {

/// A long content: hands its pieces over to what takes them, one after the other, as long as that
/// wants more.
using Pieces = std::function<void(const std::function<bool(std::string_view)>& take)>;

/// Throws std::runtime_error: "cannot write 'PATH': REASON".
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason);

/// New contents of files. Each is written to a file of its own beside its place, under a name that
/// nobody can foresee (it is opened only where there is none, and no link is followed), and flushed
/// to the disk. commit() then renames all of them into place; where that fails for one, those
/// before it get their old contents back. Without commit() nothing has changed. Requests to end the
/// program wait meanwhile; when it is killed all the same, only a file ".camlaw-XXXXXX" may be
/// left, and of several files some may be old and some new.
class Replacing {
 public:
  Replacing();
  Replacing(const Replacing&) = delete;
  Replacing& operator=(const Replacing&) = delete;
  ~Replacing();

  /// `more` follows the content. `target` with its links followed; `named` as the user knows it,
  /// for errors. Missing folders are made. An old file keeps its permissions. Throws
  /// std::runtime_error.
  void add(const std::filesystem::path& target, std::string_view content,
           const std::filesystem::path& named, const Pieces& more = {});
  /// Throws std::runtime_error, with everything as it was.
  void commit();

 private:
  struct File {
    std::filesystem::path target, named, fresh, old;  ///< old: a second name of what was there
    bool in_place = false;
  };
  void keep_old(File& file);
  void put_back();

  std::vector<File> files_;
  std::vector<std::filesystem::path> folders_;
  sigset_t signals_{};  ///< that were held back before
  bool done_ = false;
};

}  // namespace camlaw::cli
