// SPDX-License-Identifier: MIT
#include "optim/study/record.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace camlaw::optim {
namespace {

namespace fs = std::filesystem;

/// Marks the file as ours: "caml" as four bytes, and the version of the tables.
constexpr int kApplication = 0x63616d6c;
constexpr int kVersion = 2;

constexpr int kPatience = 2000;  // ms, for another who reads or writes

constexpr const char* kTables = R"(
CREATE TABLE setting (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE task (
  id INTEGER PRIMARY KEY, text TEXT NOT NULL UNIQUE, part INTEGER NOT NULL,
  infeasible INTEGER NOT NULL, evaluations INTEGER NOT NULL, failure TEXT NOT NULL,
  died INTEGER NOT NULL, is_global INTEGER NOT NULL);
CREATE TABLE design (
  id INTEGER PRIMARY KEY, task INTEGER NOT NULL REFERENCES task(id), verdict TEXT NOT NULL,
  reason TEXT NOT NULL, is_global INTEGER NOT NULL, solver TEXT NOT NULL);
CREATE TABLE variable (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, value REAL, PRIMARY KEY (design, place)) WITHOUT ROWID;
CREATE TABLE objective (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, value REAL, cost REAL, weight REAL,
  PRIMARY KEY (design, place)) WITHOUT ROWID;
CREATE TABLE margin (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, margin REAL, angle REAL, met INTEGER NOT NULL, proved INTEGER NOT NULL,
  price REAL, PRIMARY KEY (design, place)) WITHOUT ROWID;
CREATE INDEX design_of_task ON design(task);
)";

double number(const SQLite::Column& column) {
  return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

/// NaN is kept as NULL, which is what SQLite makes of it.
void bind(SQLite::Statement& statement, int index, double value) {
  std::isnan(value) ? statement.bind(index) : statement.bind(index, value);
}

Verdict verdict_of(const std::string& text) {
  for (const Verdict v :
       {Verdict::Certified, Verdict::Feasible, Verdict::Infeasible, Verdict::Failed}) {
    if (to_string(v) == text) return v;
  }
  throw std::runtime_error(fmt::format("'{}' is no verdict", text));
}

/// Throws where a design has not the numbers that the problem asks for.
void check_fits(const Outcome& outcome, const MultiProblem& problem) {
  const std::size_t objectives = problem.objectives.size();
  for (const FrontPoint& p : outcome.points) {
    const bool weighed = p.weights.empty() || p.weights.size() == objectives;
    if (p.x.size() == problem.variables.size() && p.costs.size() == objectives && weighed) continue;
    throw std::runtime_error("a design lacks numbers, or has too many");
  }
}

std::int64_t whole(std::size_t n) { return static_cast<std::int64_t>(n); }

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

constexpr const char* kForeign = "it is no study of camlaw, and is left as it is";

/// Whether the file begins as a study does. Found out without SQLite, which may make files beside
/// it.
bool begins_as_study(const std::string& path) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  constexpr std::size_t kPlace = 68;  // of the application's number, its highest byte first
  std::array<char, kPlace + 4> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (std::string_view(head.data(), kMagic.size()) != kMagic) return false;
  int application = 0;
  for (std::size_t i = kPlace; i < head.size(); ++i) {
    application = application << 8 | static_cast<unsigned char>(head[i]);
  }
  return application == kApplication;
}

/// Where a study is begun: beside its place. What an earlier beginning has left there goes; what
/// is someone else's is not touched.
std::string beginning_of(const std::string& path) {
  std::string begun = path + ".new";
  if (!fs::exists(begun)) return begun;
  const bool is_left =
      fs::is_regular_file(begun) && (fs::is_empty(begun) || begins_as_study(begun));
  if (!is_left) refuse(begun, "it is in the way of the study that is to be made");
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

/// Refuses what is no study, is damaged, or was made by another version.
void check(SQLite::Database& base, const std::string& path) {
  try {
    const int application = base.execAndGet("PRAGMA application_id").getInt();
    const int version = base.execAndGet("PRAGMA user_version").getInt();
    if (application != kApplication) refuse(path, kForeign);
    if (version != kVersion) {
      refuse(path, fmt::format("its tables are of version {}; this program reads version {}",
                               version, kVersion));
    }
    const std::string found = base.execAndGet("PRAGMA integrity_check(1)").getString();
    if (found != "ok") refuse(path, "the file is damaged: " + found);
  } catch (const SQLite::Exception& error) {
    refuse(path, error.getErrorCode() == kNoBase ? kForeign : why(error));
  }
}

}  // namespace

/// The open file. Statements are made when they are needed: a study has few searches a second.
class StudyRecord::File {
 public:
  File(const std::string& path, int flags)
      : path_(path),
        base_(fs::absolute(path).string(), flags),  // some names mean no file to SQLite
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

  void make(const StudySettings& settings) {
    SQLite::Transaction all(base_);
    base_.exec(fmt::format("PRAGMA application_id = {}", kApplication));
    base_.exec(fmt::format("PRAGMA user_version = {}", kVersion));
    base_.exec(kTables);
    insert(settings);
    all.commit();
  }

  void put(const StudySettings& settings) {
    SQLite::Transaction all(base_);
    insert(settings);
    all.commit();
  }

  void insert(const StudySettings& settings) {
    for (const auto& [name, value] : settings) {
      SQLite::Statement insert(base_, "INSERT OR REPLACE INTO setting VALUES (?, ?)");
      insert.bind(1, name);
      insert.bind(2, value);
      insert.exec();
    }
  }

  /// Whatever ends the program, what was written whole is there; no wait for the disk each time.
  void prepare() { base_.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"); }

  SQLite::Database& base() { return base_; }
  const std::string& path() const { return path_; }

  std::optional<Outcome> find(const std::string& text, std::size_t part) {
    SQLite::Statement task(base_,
                           "SELECT id, infeasible, evaluations, failure, died, is_global FROM task "
                           "WHERE text = ?");
    task.bind(1, text);
    if (!task.executeStep()) return {};
    Outcome outcome;
    outcome.infeasible = task.getColumn(1).getInt() != 0;
    outcome.evaluations = task.getColumn(2).getInt64();
    outcome.failure = task.getColumn(3).getString();
    outcome.died = task.getColumn(4).getInt() != 0;
    outcome.is_global = task.getColumn(5).getInt() != 0;
    SQLite::Statement design(base_,
                             "SELECT id, verdict, reason, is_global, solver FROM design "
                             "WHERE task = ? ORDER BY id");
    design.bind(1, task.getColumn(0).getInt64());
    while (design.executeStep()) {
      FrontPoint point;
      point.part = part;
      point.verdict = verdict_of(design.getColumn(1).getString());
      point.reason = design.getColumn(2).getString();
      point.is_global = design.getColumn(3).getInt() != 0;
      point.solver = design.getColumn(4).getString();
      fill(point, design.getColumn(0).getInt64());
      outcome.points.push_back(std::move(point));
    }
    return outcome;
  }

  void add(const Task& task, const Outcome& outcome, const MultiProblem& problem) {
    SQLite::Transaction all(base_);
    SQLite::Statement before(base_, "DELETE FROM task WHERE text = ? AND died = 1");
    before.bind(1, task.text());
    before.exec();
    SQLite::Statement insert(base_,
                             "INSERT OR IGNORE INTO task (text, part, infeasible, evaluations, "
                             "failure, died, is_global) VALUES (?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, task.text());
    insert.bind(2, whole(task.part));
    insert.bind(3, outcome.infeasible);
    insert.bind(4, static_cast<std::int64_t>(outcome.evaluations));
    insert.bind(5, outcome.failure);
    insert.bind(6, outcome.died);
    insert.bind(7, outcome.is_global);
    if (insert.exec() == 1) {
      const std::int64_t id = base_.getLastInsertRowid();
      for (const FrontPoint& point : outcome.points) add_design(id, point, problem);
    }
    all.commit();
  }

 private:
  void fill(FrontPoint& point, std::int64_t design) {
    const auto rows = [&](const char* query) {
      SQLite::Statement statement(base_, query);
      statement.bind(1, design);
      return statement;
    };
    auto variable = rows("SELECT value FROM variable WHERE design = ? ORDER BY place");
    while (variable.executeStep()) point.x.push_back(number(variable.getColumn(0)));
    auto objective =
        rows("SELECT value, cost, weight FROM objective WHERE design = ? ORDER BY place");
    while (objective.executeStep()) {
      point.objectives.push_back(number(objective.getColumn(0)));
      point.costs.push_back(number(objective.getColumn(1)));
      if (!objective.getColumn(2).isNull()) {
        point.weights.push_back(objective.getColumn(2).getDouble());
      }
    }
    auto margin = rows(
        "SELECT name, unit, margin, angle, met, proved, price FROM margin WHERE design = ? "
        "ORDER BY place");
    while (margin.executeStep()) {
      Standing limit;
      limit.name = margin.getColumn(0).getString();
      limit.unit = margin.getColumn(1).getString();
      limit.margin = number(margin.getColumn(2));
      if (!margin.getColumn(3).isNull()) limit.angle = margin.getColumn(3).getDouble();
      limit.met = margin.getColumn(4).getInt() != 0;
      limit.proved = margin.getColumn(5).getInt() != 0;
      limit.price = number(margin.getColumn(6));
      point.limits.push_back(std::move(limit));
    }
  }

  void add_design(std::int64_t task, const FrontPoint& point, const MultiProblem& problem) {
    SQLite::Statement design(base_,
                             "INSERT INTO design (task, verdict, reason, is_global, solver) "
                             "VALUES (?, ?, ?, ?, ?)");
    design.bind(1, task);
    design.bind(2, std::string(to_string(point.verdict)));
    design.bind(3, point.reason);
    design.bind(4, point.is_global);
    design.bind(5, point.solver);
    design.exec();
    const std::int64_t id = base_.getLastInsertRowid();
    add_variables(id, point, problem);
    add_objectives(id, point, problem);
    add_margins(id, point);
  }

  void add_variables(std::int64_t design, const FrontPoint& point, const MultiProblem& problem) {
    SQLite::Statement insert(base_, "INSERT INTO variable VALUES (?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < point.x.size(); ++i) {
      insert.bind(1, design);
      insert.bind(2, whole(i));
      insert.bind(3, problem.variables.at(i).name);
      insert.bind(4, problem.variables.at(i).unit);
      bind(insert, 5, point.x[i]);
      insert.exec();
      insert.reset();
    }
  }

  void add_objectives(std::int64_t design, const FrontPoint& point, const MultiProblem& problem) {
    SQLite::Statement insert(base_, "INSERT INTO objective VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < point.costs.size(); ++i) {
      insert.bind(1, design);
      insert.bind(2, whole(i));
      insert.bind(3, problem.objectives.at(i).response.name);
      insert.bind(4, problem.objectives.at(i).response.unit);
      bind(insert, 5, point.objectives[i]);
      bind(insert, 6, point.costs[i]);
      point.weights.empty() ? insert.bind(7) : bind(insert, 7, point.weights[i]);
      insert.exec();
      insert.reset();
    }
  }

  void add_margins(std::int64_t design, const FrontPoint& point) {
    SQLite::Statement insert(base_, "INSERT INTO margin VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < point.limits.size(); ++i) {
      const Standing& limit = point.limits[i];
      insert.bind(1, design);
      insert.bind(2, whole(i));
      insert.bind(3, limit.name);
      insert.bind(4, limit.unit);
      bind(insert, 5, limit.margin);
      limit.angle ? insert.bind(6, *limit.angle) : insert.bind(6);
      insert.bind(7, limit.met);
      insert.bind(8, limit.proved);
      bind(insert, 9, limit.price);
      insert.exec();
      insert.reset();
    }
  }

  std::string path_;
  SQLite::Database base_;
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
    File(begun, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).make(settings);
    move_to(begun, path);
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
    return StudyRecord(std::move(file));
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove(begun, ignored);
    throw std::runtime_error(fmt::format("{}: it cannot be written: {}", path, error.what()));
  }
}

StudyRecord StudyRecord::open(const std::string& path) {
  read(path);  // first without a hand on it
  try {
    auto file = std::make_unique<File>(path, SQLite::OPEN_READWRITE);
    file->prepare();
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
    return StudyRecord(std::move(file));
  } catch (const SQLite::Exception& error) {
    refuse(path, fmt::format("it cannot be read: {}", error.what()));
  }
}

StudySettings StudyRecord::settings() const {
  try {
    StudySettings result;
    SQLite::Statement rows(file_->base(), "SELECT name, value FROM setting");
    while (rows.executeStep()) {
      result[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    }
    return result;
  } catch (const SQLite::Exception& error) {
    refuse(file_->path(), why(error));
  }
}

void StudyRecord::put(const StudySettings& settings) {
  try {
    file_->put(settings);
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}: the study cannot be written: {}", file_->path(), error.what()));
  }
}

std::optional<Outcome> StudyRecord::find(const Task& task, const MultiProblem& problem) const {
  try {
    std::optional<Outcome> outcome = file_->find(task.text(), task.part);
    if (outcome) check_fits(*outcome, problem);
    return outcome;
  } catch (const SQLite::Exception& error) {
    refuse(file_->path(), why(error));
  } catch (const std::exception& error) {
    refuse(file_->path(), fmt::format("the file is damaged: {}", error.what()));
  }
}

void StudyRecord::add(const Task& task, const Outcome& outcome, const MultiProblem& problem) {
  try {
    file_->add(task, outcome, problem);
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}: the study cannot be written: {}; what was written before is kept",
                    file_->path(), error.what()));
  }
}

std::size_t StudyRecord::size() const {
  return static_cast<std::size_t>(file_->base().execAndGet("SELECT count(*) FROM task").getInt64());
}

std::vector<Outcome> RecordedExecutor::run(const std::vector<Task>& tasks,
                                           const OnOutcome& on_outcome) {
  std::vector<std::optional<Outcome>> outcomes;
  std::vector<Task> missing;
  std::map<std::size_t, MultiProblem> problems;
  for (const Task& task : tasks) {
    const auto known = problems.find(task.part);
    const MultiProblem& problem =
        known != problems.end()
            ? known->second
            : problems.emplace(task.part, space_.problem(space_.options(task.part))).first->second;
    outcomes.push_back(record_.find(task, problem));
    // A process that died may have been killed: it is not the task's outcome for good.
    if (outcomes.back() && outcomes.back()->died && others_ != nullptr) outcomes.back().reset();
    if (!outcomes.back()) {
      missing.push_back(task);
    } else if (on_outcome) {
      on_outcome(task, *outcomes.back());
    }
  }
  std::vector<Outcome> fresh;
  if (others_ != nullptr && !missing.empty()) {
    fresh = others_->run(missing, [&](const Task& task, const Outcome& outcome) {
      record_.add(task, outcome, problems.at(task.part));
      if (on_outcome) on_outcome(task, outcome);
    });
  }
  std::vector<Outcome> in_order;
  auto next = fresh.begin();
  for (auto& outcome : outcomes) {
    if (!outcome && next == fresh.end()) break;
    in_order.push_back(outcome ? std::move(*outcome) : std::move(*next++));
  }
  return in_order;
}

std::string sqlite_version() { return fmt::format("sqlite {}", SQLite::getLibVersion()); }

}  // namespace camlaw::optim
