// SPDX-License-Identifier: MIT
#include "optim/study/record.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "optim/study/study_place.h"
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

// SQLITE_ERROR, _READONLY, _CORRUPT, _NOTADB
constexpr int kError = 1, kReadOnly = 8, kCorrupt = 11, kNoBase = 26;

/// What an error in reading means.
std::string why(const SQLite::Exception& error) {
  const bool damaged = error.getErrorCode() == kCorrupt || error.getErrorCode() == kNoBase ||
                       error.getErrorCode() == kError;  // such as a table that is not there
  return fmt::format("{}: {}", damaged ? "the file is damaged" : "it cannot be read", error.what());
}

constexpr const char* kThere = "the file exists already; resume its study, or name another file";
constexpr const char* kForeign = "it is not a camlaw study; it was left unchanged";

/// What an error in writing means.
std::string why_not_written(const std::exception& error, const std::string& path) {
  const auto* const of_sqlite = dynamic_cast<const SQLite::Exception*>(&error);
  constexpr int kInput = 10, kKind = 0xff;  // SQLITE_IOERR, which has many kinds
  const bool is_of_disk = of_sqlite != nullptr && (of_sqlite->getErrorCode() & kKind) == kInput;
  const std::string room = is_of_disk ? why_no_room(study_place(path)) : "";
  return room.empty() ? error.what() : fmt::format("{} ({})", error.what(), room);
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
    refuse_study(path,
                 fmt::format("a program that wrote it was interrupted, and what it left must be "
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
    if (application != kStudyApplication) refuse_study(path, kForeign);
    if (version < kOldestStudy || version > kStudyVersion) {
      refuse_study(path,
                   fmt::format("its tables are of version {}; this program, which is {}, writes "
                               "version {} and reads version {} too",
                               version, version > kStudyVersion ? "older" : "newer", kStudyVersion,
                               kOldestStudy));
    }
    const std::string sealed =
        "SELECT count(*) FROM pragma_table_info('task') WHERE name = 'checksum'";
    if ((base.execAndGet(sealed).getInt() > 0) != (version >= kWithChecksums)) {
      refuse_study(path, "the file is damaged: its version does not fit its tables");
    }
    if (is_cut_off(base, path)) refuse_study(path, "the file is damaged: it was cut off");
    const std::string found = base.execAndGet("PRAGMA integrity_check(1)").getString();
    if (found != "ok") refuse_study(path, "the file is damaged: " + found);
  } catch (const SQLite::Exception& error) {
    refuse_study(path, error.getErrorCode() == kNoBase ? kForeign : why(error));
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
  void lose_log() { lost_log_ = true; }
  bool lost_log() const { return lost_log_; }

 private:
  std::string path_;
  SQLite::Database base_;
  StudyTables tables_;
  bool writes_;
  bool lost_log_ = false;
};

StudyRecord::StudyRecord(std::unique_ptr<File> file) : file_(std::move(file)) {}
StudyRecord::StudyRecord(StudyRecord&&) noexcept = default;
StudyRecord::~StudyRecord() = default;

StudyRecord StudyRecord::create(const std::string& path, const StudySettings& settings) {
  if (path.empty()) throw std::invalid_argument("the study's file needs a name");
  const std::string place = study_place(path);
  std::error_code ignored;
  if (fs::exists(place, ignored)) refuse_study(path, kThere);
  check_alone(path, place);
  remove_left_beginnings(place);
  // Whatever ends the program, there is a whole study in its place or none; none of this one where
  // another process was faster.
  const auto begin = [&]() -> std::unique_ptr<File> {
    const StudyBeginning begun(place);
    File(begun.file(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).tables().make(settings);
    if (!move_to(begun.file(), place)) return nullptr;
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
    file->tables().look();
    return file;
  };
  try {
    if (auto file = begin()) return StudyRecord(std::move(file));
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: it cannot be written: {}", path, why_not_written(error, path)));
  }
  refuse_study(path, kThere);
}

StudyRecord StudyRecord::begin(const std::string& path, const StudySettings& settings, bool resume,
                               const std::function<void(const StudyRecord&)>& check) {
  std::error_code ignored;
  if (!resume || !fs::exists(study_place(path), ignored)) return create(path, settings);
  remove_left_beginnings(study_place(path));
  check(read(path));
  StudyRecord record = open(path);
  if (record.settings() != settings) record.put(settings);
  return record;
}

StudyRecord StudyRecord::open(const std::string& path) {
  if (!read(path).has_checksums()) {  // first without a hand on it
    refuse_study(
        path,
        "it was made by an earlier version, whose rows have no checksums: 'camlaw front' and "
        "'camlaw report' show it; to go on, begin it again in another file");
  }
  try {
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
    file->tables().look();
    return StudyRecord(std::move(file));
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}: it cannot be opened: {}", path, why_not_written(error, path)));
  }
}

StudyRecord StudyRecord::read(const std::string& path) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) refuse_study(path, "there is no such study");
  if (!begins_as_study(path)) refuse_study(path, kForeign);
  const std::string place = study_place(path);
  check_beside(path, place);
  const bool lost_log = has_lost_log(place);
  try {
    auto file = std::make_unique<File>(path, SQLite::OPEN_READONLY);
    if (needs_recovery(file->base())) {
      file.reset();
      recover(path);
      file = std::make_unique<File>(path, SQLite::OPEN_READONLY);
    }
    check(file->base(), path);
    file->tables().look();
    if (lost_log) file->lose_log();
    return StudyRecord(std::move(file));
  } catch (const SQLite::Exception& error) {
    refuse_study(path, why(error));
  }
}

template <class Does>
auto StudyRecord::reading(Does does) const {
  try {
    return does(file_->tables());
  } catch (const SQLite::Exception& error) {
    refuse_study(file_->path(), why(error));
  } catch (const std::runtime_error& error) {
    refuse_study(file_->path(), fmt::format("the file is damaged: {}", error.what()));
  }
}

template <class Does>
void StudyRecord::writing(Does does) {
  try {
    does(file_->tables());
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}: the study cannot be written: {}; what was written before is kept",
                    file_->path(), why_not_written(error, file_->path())));
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

bool StudyRecord::lost_log() const { return file_->lost_log(); }

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
