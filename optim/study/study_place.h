// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

/// Where a study stands on the disk, and what stands beside it.
namespace camlaw::optim {

/// Throws std::invalid_argument: "PATH: WHY".
[[noreturn]] void refuse_study(const std::string& path, const std::string& why);

/// Where a study is begun: in a folder of its own beside its place, in which nobody else's files
/// are. It is gone afterwards, with all that is in it; only a program that is killed meanwhile
/// leaves it, for remove_left_beginnings. Throws std::runtime_error where it cannot be made.
class StudyBeginning {
 public:
  explicit StudyBeginning(const std::filesystem::path& place);
  StudyBeginning(const StudyBeginning&) = delete;
  StudyBeginning& operator=(const StudyBeginning&) = delete;
  ~StudyBeginning();

  std::string file() const;

 private:
  std::string folder_;
  int held_ = -1;  ///< a descriptor with a lock, by which others see that the folder is in use
};

/// Removes the beginnings beside a study's place that programs have left which were killed: folders
/// of such a name that hold a study and nothing else, that no living process holds, and in which
/// nothing was written for a minute. Where the file system has no locks, nothing is removed.
void remove_left_beginnings(const std::filesystem::path& place);

/// Gives a file its name; false where another has come to have it. Throws std::runtime_error.
bool move_to(const std::string& from, const std::string& to);

/// Where a study stands or would stand, links followed. Throws std::invalid_argument where they go
/// in a circle.
std::string study_place(const std::string& path);

/// Throws std::invalid_argument where something stands beside a study that is not there yet: SQLite
/// would take it for its own, and remove it.
void check_alone(const std::string& path, const std::string& place);

/// The same of a study that is there, if what stands beside it does not begin as SQLite's own does.
void check_beside(const std::string& path, const std::string& place);

/// Whether the last who wrote a study was killed, and the log with what was not in the study yet is
/// not beside it: the two were parted.
bool has_lost_log(const std::string& place);

/// Why a study cannot grow, where its disk is full or the size of files is limited; else empty.
std::string why_no_room(const std::string& place);

}  // namespace camlaw::optim
