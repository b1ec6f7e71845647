// SPDX-License-Identifier: MIT
#include "optim/study/study_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "numerics/file_place.h"

namespace camlaw::optim {

namespace fs = std::filesystem;

namespace {

/// What SQLite adds to a study's name for the files that it keeps beside it.
constexpr std::array kOfSqlite{"-wal", "-journal", "-shm"};

/// Whether a file that SQLite would keep beside a study is none of SQLite's: it begins otherwise.
bool is_not_of_sqlite(const std::string& file, const std::vector<std::string_view>& beginnings) {
  std::error_code ignored;
  if (!fs::exists(file, ignored) || fs::is_empty(file, ignored)) return false;
  std::string head(beginnings.front().size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return std::find(beginnings.begin(), beginnings.end(), head) == beginnings.end();
}

}  // namespace

void refuse_study(const std::string& path, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}: {}", path, why));
}

namespace {

constexpr std::string_view kBeginning = ".camlaw-";
constexpr std::string_view kRandom = "XXXXXX";  // mkdtemp's

int open_folder(const fs::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Whether an open folder still has its name.
bool has_name(int folder, const std::string& name) {
  struct stat opened {
  }, named{};
  return fstat(folder, &opened) == 0 && stat(name.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

constexpr std::string_view kStudy = "study.db";

/// Everything in a folder; nothing where it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> all;
  fs::directory_iterator entry(folder, failed);
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    all.push_back(entry->path());
  }
  return failed ? std::vector<fs::path>() : all;
}

/// Whether a folder holds a study and nothing else: one of that name may be anybody's.
bool holds_study_alone(const fs::path& folder) {
  const std::vector<fs::path> all = entries_of(folder);
  const auto is_own = [](const fs::path& path) {
    const std::string name = path.filename().string();
    const bool is_beside = std::ranges::any_of(
        kOfSqlite, [&](const char* ending) { return name == fmt::format("{}{}", kStudy, ending); });
    std::error_code failed;
    return (name == kStudy || is_beside) && fs::is_regular_file(fs::symlink_status(path, failed));
  };
  return std::ranges::find(all, folder / kStudy) != all.end() && std::ranges::all_of(all, is_own);
}

/// Whether nothing was written in a folder for a minute: a study is begun in less, also by a
/// program of an earlier version, which holds no lock.
bool is_at_rest(const fs::path& folder) {
  std::error_code failed;
  const auto last =
      std::max(fs::last_write_time(folder, failed), fs::last_write_time(folder / kStudy, failed));
  return !failed && fs::file_time_type::clock::now() - last > std::chrono::minutes(1);
}

fs::path folder_of(const fs::path& place) {
  const fs::path folder = place.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

void remove_left_beginnings(const fs::path& place) {
  std::error_code failed;
  for (const fs::path& one : entries_of(folder_of(place))) {
    const std::string name = one.filename().string();
    const bool is_one =
        name.starts_with(kBeginning) && name.size() == kBeginning.size() + kRandom.size();
    const int folder = is_one ? open_folder(one) : -1;
    if (folder < 0) continue;
    const bool is_left =
        flock(folder, LOCK_EX | LOCK_NB) == 0 && holds_study_alone(one) && is_at_rest(one);
    if (is_left) fs::remove_all(one, failed);
    close(folder);
  }
}

StudyBeginning::StudyBeginning(const fs::path& place) {
  // Until it is held, another process that begins a study here may take it for one that was left.
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    folder_ = (folder_of(place) / fmt::format("{}{}", kBeginning, kRandom)).string();
    if (mkdtemp(folder_.data()) == nullptr) throw std::runtime_error(std::strerror(errno));
    held_ = open_folder(folder_);
    if (held_ >= 0) flock(held_, LOCK_EX);
    if (held_ >= 0 && has_name(held_, folder_)) return;
    if (held_ >= 0) close(held_);
  }
  throw std::runtime_error("its folder is removed again and again");
}

std::string StudyBeginning::file() const { return fmt::format("{}/{}", folder_, kStudy); }

StudyBeginning::~StudyBeginning() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  close(held_);
}

bool move_to(const std::string& from, const std::string& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EINVAL || errno == ENOSYS) {  // a file system that cannot tell: a second name can
    if (link(from.c_str(), to.c_str()) == 0) return true;
    if (errno == EPERM || errno == ENOTSUP) {
      fs::rename(from, to);
      return true;
    }
  }
  if (errno == EEXIST) return false;
  throw std::runtime_error(std::strerror(errno));
}

std::string study_place(const std::string& path) {
  std::error_code error;
  const fs::path place = file_place(path, error);
  if (error) refuse_study(path, error.message());
  return place.string();
}

void check_alone(const std::string& path, const std::string& place) {
  for (const char* ending : kOfSqlite) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(place + ending, ignored))) continue;
    if (fs::exists(place, ignored)) return;  // another program has just begun it: its own log
    refuse_study(path,
                 fmt::format("'{}{}' is next to it and may hold the last searches of a study "
                             "that was moved away; put that study back, or move this file away",
                             place, ending));
  }
}

void check_beside(const std::string& path, const std::string& place) {
  using namespace std::string_view_literals;
  const auto check_one = [&](const char* ending, const std::vector<std::string_view>& beginnings) {
    if (!is_not_of_sqlite(place + ending, beginnings)) return;
    refuse_study(path, fmt::format("'{}{}' is not of this study and would be removed; move it away",
                                   place, ending));
  };
  check_one("-wal", {"\x37\x7f\x06\x82"sv, "\x37\x7f\x06\x83"sv});
  check_one("-journal", {"\xd9\xd5\x05\xf9"sv, "\0\0\0\0"sv});
}

bool has_lost_log(const std::string& place) {
  constexpr std::size_t kFormat = 18;  // 2: the study is written with a log
  std::array<char, kFormat + 1> head{};
  std::ifstream(place, std::ios::binary).read(head.data(), head.size());
  std::error_code ignored;
  return head[kFormat] == 2 && !fs::exists(place + "-wal", ignored);
}

std::string why_no_room(const std::string& place) {
  constexpr std::uintmax_t kLeast = 1 << 16;  // what a study takes at once
  std::error_code failed;
  const auto available = fs::space(fs::path(place).parent_path(), failed).available;
  if (!failed && available < kLeast) return "the disk is full";
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  return fmt::format("a file may have {} bytes here, 'ulimit -f'", limit.rlim_cur);
}

}  // namespace camlaw::optim
