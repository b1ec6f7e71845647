// SPDX-License-Identifier: MIT
#include "optim/study/record.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "optim/study/study_tables.h"

namespace camlaw::optim {

namespace fs = std::filesystem;

bool begins_as_study(const std::string& path) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  constexpr std::size_t kPlace = 68;  // of the application's number, its highest byte first
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return false;
  std::array<char, kPlace + 4> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (std::string_view(head.data(), kMagic.size()) != kMagic) return false;
  int application = 0;
  for (std::size_t i = kPlace; i < head.size(); ++i) {
    application = application << 8 | static_cast<unsigned char>(head[i]);
  }
  return application == kStudyApplication;
}

namespace {

constexpr int kPatience = 60000;  // ms, for another who reads or writes

/// Whether every design has the numbers that the problem asks for.
bool fits(const Outcome& outcome, const Problem& problem) {
  const std::size_t objectives = problem.objectives.size();
  return std::all_of(outcome.points.begin(), outcome.points.end(), [&](const FrontPoint& p) {
    const bool weighed = p.weights.empty() || p.weights.size() == objectives;
    return p.x.size() == problem.variables.size() && p.costs.size() == objectives && weighed;
  });
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}: {}", path, why));
}

// SQLITE_ERROR, _READONLY, _CORRUPT, _NOTADB
constexpr int kError = 1, kReadOnly = 8, kCorrupt = 11, kNoBase = 26;

/// What an error in reading means.
std::string why(const SQLite::Exception& error) {
  const bool damaged = error.getErrorCode() == kCorrupt || error.getErrorCode() == kNoBase ||
                       error.getErrorCode() == kError;  // such as a table that is not there
  return fmt::format("{}: {}", damaged ? "the file is damaged" : "it cannot be read", error.what());
}

constexpr const char* kForeign = "it is not a camlaw study; it was left unchanged";

/// Where a study is begun: beside its place. What an earlier beginning has left there goes; what
/// is someone else's is not touched.
std::string beginning_of(const std::string& path) {
  std::string begun = path + ".new";
  if (!fs::exists(begun)) return begun;
  const bool is_left =
      fs::is_regular_file(begun) && (fs::is_empty(begun) || begins_as_study(begun));
  if (!is_left) refuse(begun, "a study is prepared under this name; move the file away");
  fs::remove(begun);
  return begun;
}

/// Gives a file its name, unless another has come to have it.
void move_to(const std::string& from, const std::string& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) throw std::runtime_error(std::strerror(errno));
  fs::rename(from, to);  // a file system that cannot tell
}

/// Whether a writer that was killed has left a journal beside the file that must be rolled back
/// before anything can be read, which a connection that only reads may not do.
bool needs_recovery(SQLite::Database& base) {
  try {
    base.execAndGet("PRAGMA user_version");
  } catch (const SQLite::Exception& error) {
    return (error.getErrorCode() & 0xff) == kReadOnly;
  }
  return false;
}

/// Rolls back what a writer that was killed had not finished.
void recover(const std::string& path) {
  try {
    SQLite::Database base(fs::absolute(path).string(), SQLite::OPEN_READWRITE);
    base.setBusyTimeout(kPatience);
    base.execAndGet("PRAGMA user_version");
  } catch (const SQLite::Exception& error) {
    refuse(path, fmt::format("a program that wrote it was interrupted, and what it left must be "
                             "tidied up first; make the file and its folder writable ({})",
                             error.what()));
  }
}

/// Whether the file ends before its last page does. While someone writes, pages may be in the log.
bool is_cut_off(SQLite::Database& base, const std::string& path) {
  if (base.execAndGet("PRAGMA journal_mode").getString() == "wal") return false;
  const auto pages = base.execAndGet("PRAGMA page_count").getInt64();
  const auto size = base.execAndGet("PRAGMA page_size").getInt64();
  return static_cast<std::int64_t>(fs::file_size(path)) < pages * size;
}

/// Refuses what is not a study, is damaged, or was made by another version.
void check(SQLite::Database& base, const std::string& path) {
  try {
    const int application = base.execAndGet("PRAGMA application_id").getInt();
    const int version = base.execAndGet("PRAGMA user_version").getInt();
    if (application != kStudyApplication) refuse(path, kForeign);
    if (version < kOldestStudy || version > kStudyVersion) {
      refuse(path, fmt::format("its tables are of version {}; this program, which is {}, writes "
                               "version {} and reads version {} too",
                               version, version > kStudyVersion ? "older" : "newer", kStudyVersion,
                               kOldestStudy));
    }
    const std::string sealed =
        "SELECT count(*) FROM pragma_table_info('task') WHERE name = 'checksum'";
    if ((base.execAndGet(sealed).getInt() > 0) != (version >= kWithChecksums)) {
      refuse(path, "the file is damaged: its version does not fit its tables");
    }
    if (is_cut_off(base, path)) refuse(path, "the file is damaged: it was cut off");
    const std::string found = base.execAndGet("PRAGMA integrity_check(1)").getString();
    if (found != "ok") refuse(path, "the file is damaged: " + found);
  } catch (const SQLite::Exception& error) {
    refuse(path, error.getErrorCode() == kNoBase ? kForeign : why(error));
  }
}

}  // namespace

/// The open file.
class StudyRecord::File {
 public:
  File(const std::string& path, int flags)
      : path_(path),
        base_(fs::absolute(path).string(), flags),  // some names mean no file to SQLite
        tables_(base_),
        writes_((flags & SQLite::OPEN_READWRITE) != 0) {
    base_.setBusyTimeout(kPatience);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (!writes_) return;
    try {
      base_.exec("PRAGMA journal_mode = DELETE");  // one file again, to be read from anywhere
    } catch (const SQLite::Exception&) {           // the next who opens it does that
    }
  }

  /// Whatever ends the program, what was written whole is there; no wait for the disk each time.
  void prepare() { base_.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"); }

  SQLite::Database& base() { return base_; }
  StudyTables& tables() { return tables_; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  SQLite::Database base_;
  StudyTables tables_;
  bool writes_;
};

StudyRecord::StudyRecord(std::unique_ptr<File> file) : file_(std::move(file)) {}
StudyRecord::StudyRecord(StudyRecord&&) noexcept = default;
StudyRecord::~StudyRecord() = default;

StudyRecord StudyRecord::create(const std::string& path, const StudySettings& settings) {
  if (path.empty()) throw std::invalid_argument("the study's file needs a name");
  if (fs::exists(path)) {
    refuse(path, "the file exists already; resume the study, or name another file");
  }
  // Made beside its place: whatever ends the program, there is a whole study there or none.
  const std::string begun = beginning_of(path);
  try {
    File(begun, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).tables().make(settings);
    move_to(begun, path);
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
    file->tables().look();
    return StudyRecord(std::move(file));
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove(begun, ignored);
    throw std::runtime_error(fmt::format("{}: it cannot be written: {}", path, error.what()));
  }
}

StudyRecord StudyRecord::begin(const std::string& path, const StudySettings& settings, bool resume,
                               const std::function<void(const StudyRecord&)>& check) {
  if (!resume || !fs::exists(path)) return create(path, settings);
  check(read(path));
  StudyRecord record = open(path);
  if (record.settings() != settings) record.put(settings);
  return record;
}

StudyRecord StudyRecord::open(const std::string& path) {
  if (!read(path).has_checksums()) {  // first without a hand on it
    refuse(path,
           "it was made by an earlier version, whose rows have no checksums: 'camlaw front' and "
           "'camlaw report' show it; to go on, begin it again in another file");
  }
  try {
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
    file->tables().look();
    return StudyRecord(std::move(file));
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(fmt::format("{}: it cannot be opened: {}", path, error.what()));
  }
}

StudyRecord StudyRecord::read(const std::string& path) {
  if (!fs::is_regular_file(path)) refuse(path, "there is no such study");
  if (!begins_as_study(path)) refuse(path, kForeign);
  try {
    auto file = std::make_unique<File>(path, SQLite::OPEN_READONLY);
    if (needs_recovery(file->base())) {
      file.reset();
      recover(path);
      file = std::make_unique<File>(path, SQLite::OPEN_READONLY);
    }
    check(file->base(), path);
    file->tables().look();
    return StudyRecord(std::move(file));
  } catch (const SQLite::Exception& error) {
    refuse(path, why(error));
  }
}

template <class Does>
auto StudyRecord::reading(Does does) const {
  try {
    return does(file_->tables());
  } catch (const SQLite::Exception& error) {
    refuse(file_->path(), why(error));
  } catch (const std::runtime_error& error) {
    refuse(file_->path(), fmt::format("the file is damaged: {}", error.what()));
  }
}

template <class Does>
void StudyRecord::writing(Does does) {
  try {
    does(file_->tables());
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}: the study cannot be written: {}; what was written before is kept",
                    file_->path(), error.what()));
  }
}

StudySettings StudyRecord::settings() const {
  return reading([](StudyTables& tables) { return tables.settings(); });
}

void StudyRecord::put(const StudySettings& settings) {
  writing([&](StudyTables& tables) { tables.put(settings); });
}

bool StudyRecord::has_checksums() const { return file_->tables().has_checksums(); }

std::optional<Outcome> StudyRecord::find(const Task& task, const Problem& problem) const {
  return reading([&](StudyTables& tables) {
    const std::string text = task.text();
    std::optional<Outcome> outcome = tables.find(text, task.part);
    if (outcome && !fits(*outcome, problem)) {
      tables.doubt(text);
      outcome.reset();
    }
    return outcome;
  });
}

std::optional<Outcome> StudyRecord::find(const Task& task) const {
  return reading([&](StudyTables& tables) { return tables.find(task.text(), task.part); });
}

std::optional<std::int64_t> StudyRecord::number(const Task& task) const {
  return file_->tables().number(task.text());
}

std::vector<std::int64_t> StudyRecord::damaged() const { return file_->tables().damaged(); }

std::vector<std::int64_t> StudyRecord::lost() const { return file_->tables().lost(); }

std::vector<RecordedTask> StudyRecord::whole() const {
  return reading([](StudyTables& tables) { return tables.whole(); });
}

void StudyRecord::forget(const std::vector<std::int64_t>& numbers) {
  if (numbers.empty()) return;
  writing([&](StudyTables& tables) { tables.forget(numbers); });
}

void StudyRecord::add(const Task& task, const Outcome& outcome, const Problem& problem) {
  writing([&](StudyTables& tables) { tables.add(task, outcome, problem); });
}

std::optional<std::string> StudyRecord::answer(const std::string& order) const {
  return reading([&](StudyTables& tables) { return tables.answer(order); });
}

void StudyRecord::put_answer(const std::string& order, const std::string& answer) {
  writing([&](StudyTables& tables) { tables.put_answer(order, answer); });
}

std::size_t StudyRecord::size() const {
  return reading([&](StudyTables&) {
    return static_cast<std::size_t>(
        file_->base().execAndGet("SELECT count(*) FROM task").getInt64());
  });
}

std::optional<bool> StudyRecord::scouted() const {
  if (size() == 0) return {};
  return reading([&](StudyTables&) {
    return file_->base()
               .execAndGet("SELECT count(*) FROM task WHERE text LIKE 'scout %'")
               .getInt64() > 0;
  });
}

std::string sqlite_version() { return fmt::format("sqlite {}", SQLite::getLibVersion()); }

}  // namespace camlaw::optim
