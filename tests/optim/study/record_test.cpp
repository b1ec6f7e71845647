// SPDX-License-Identifier: MIT
#include <SQLiteCpp/SQLiteCpp.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "optim/study/checksum.h"
#include "optim/study/recorded_executor.h"
#include "tests/optim/pareto/outcomes.h"
#include "tests/optim/pareto/small_fronts.h"
#include "tests/temporary_folder.h"

namespace camlaw::optim::record_test {

using namespace study_tests;
using namespace front_tests;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

using testing::Folder, testing::read, testing::write;

const StudySettings kSettings{{"problem", "a = 1\n\"ü\"\n"}, {"points", "12"}, {"empty", ""}};

Problem five_variables() {
  Problem problem = two_centres();
  for (const char* name : {"c", "d", "e"}) problem.variables.push_back(variable(name, 0, 1));
  return problem;
}

Task numbered(double bound) {
  Task task;
  task.part = 3;
  task.sought = 1;
  task.bounds = {bound, kInfinity};
  return task;
}

/// What opening a file says; empty where it opens.
std::string complaint(const std::string& path) {
  std::string said[2];
  for (const bool reads : {false, true}) {
    try {
      const StudyRecord record = reads ? StudyRecord::read(path) : StudyRecord::open(path);
    } catch (const std::invalid_argument& error) {
      said[reads] = error.what();
      CHECK_THAT(said[reads], Contains(path));
    }
  }
  CHECK(said[0] == said[1]);
  return said[0];
}

/// Carries out so many tasks and then stops as a study does that is interrupted.
class Interrupted final : public Executor {
 public:
  Interrupted(Executor& executor, std::size_t tasks) : executor_(executor), left_(tasks) {}
  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override {
    std::vector<Task> some(
        tasks.begin(), tasks.begin() + static_cast<std::ptrdiff_t>(std::min(left_, tasks.size())));
    left_ -= some.size();
    Outcomes outcomes = executor_.run(some, on_outcome);
    outcomes.resize(tasks.size());
    return outcomes;
  }

 private:
  Executor& executor_;
  std::size_t left_;
};

ParetoOptions with_points(std::size_t points) {
  ParetoOptions options;
  options.points = points;
  return options;
}

/// Makes a study of two rooms in a file.
std::string made_study(const std::string& path, std::size_t points) {
  const ProblemSpace space = two_rooms();
  const ParetoOptions options = with_points(points);
  StudyRecord record = StudyRecord::create(path, kSettings);
  DirectExecutor direct(space, options.solve);
  RecordedExecutor recorded(space, record, &direct);
  return bits(pareto(space, options, recorded));
}

/// The front of two rooms from a file alone.
std::string read_study(const std::string& path, std::size_t points) {
  const ProblemSpace space = two_rooms();
  StudyRecord record = StudyRecord::read(path);
  RecordedExecutor recorded(space, record, nullptr);
  return bits(pareto(space, with_points(points), recorded));
}

}  // namespace

TEST_CASE("a study keeps settings and outcomes to the last bit", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  Outcome infeasible, failed, long_one = odd_outcome();
  infeasible.infeasible = true;
  failed.failure = "the process was killed; it's 'gone'";
  long_one.points.resize(60, odd_point());
  const std::vector<Outcome> outcomes{odd_outcome(), Outcome{}, infeasible, failed, long_one};
  {
    StudyRecord record = StudyRecord::create(path, kSettings);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      record.add(numbered(double(i)), outcomes[i], five_variables());
    }
    CHECK(record.size() == outcomes.size());
    CHECK(bits(*record.find(numbered(0), five_variables())) == bits(outcomes[0]));
  }
  CHECK(folder.content() == std::set<std::string>{"s.db"});
  for (const bool reads : {true, false}) {
    const StudyRecord record = reads ? StudyRecord::read(path) : StudyRecord::open(path);
    CHECK(record.settings() == kSettings);
    CHECK(record.size() == outcomes.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const auto found = record.find(numbered(double(i)), five_variables());
      REQUIRE(found);
      CHECK(bits(*found) == bits(outcomes[i]));
    }
    CHECK_FALSE(record.find(numbered(0.5), five_variables()));
    Task other = numbered(0);
    other.seed = 2;
    CHECK_FALSE(record.find(other, five_variables()));
  }
  CHECK(folder.content() == std::set<std::string>{"s.db"});
}

TEST_CASE("an outcome that is there already stays", "[study]") {
  const Folder folder;
  StudyRecord record = StudyRecord::create(folder / "s.db", {});
  record.add(numbered(1), odd_outcome(), five_variables());
  record.add(numbered(1), Outcome{}, five_variables());
  CHECK(record.size() == 1);
  CHECK(bits(*record.find(numbered(1), five_variables())) == bits(odd_outcome()));
}

TEST_CASE("settings can be set anew", "[study]") {
  const Folder folder;
  {
    StudyRecord record = StudyRecord::create(folder / "s.db", kSettings);
    record.put({{"points", "50"}, {"method", "sweep"}});
  }
  StudySettings expected = kSettings;
  expected["points"] = "50";
  expected["method"] = "sweep";
  CHECK(StudyRecord::read(folder / "s.db").settings() == expected);
}

TEST_CASE("a study that is begun touches no file but its own", "[study]") {
  const Folder folder;
  { const StudyRecord record = StudyRecord::create(folder / "s.db.new", kSettings); }
  write(folder / "s.db.new-journal", "mine");
  const std::string before = read(folder / "s.db.new");
  { const StudyRecord record = StudyRecord::create(folder / "s.db", kSettings); }
  CHECK(read(folder / "s.db.new") == before);
  CHECK(read(folder / "s.db.new-journal") == "mine");
  CHECK(folder.content() == std::set<std::string>{"s.db", "s.db.new", "s.db.new-journal"});
}

TEST_CASE("what SQLite would take for its own beside a study stays", "[study]") {
  const Folder folder;
  for (const std::string ending : {"-wal", "-journal", "-shm"}) {
    write(folder / "s.db" + ending, "mine");
    CHECK_THROWS_AS(StudyRecord::create(folder / "s.db", kSettings), std::invalid_argument);
    CHECK_THROWS_WITH(StudyRecord::create(folder / "s.db", kSettings),
                      Contains("s.db" + ending + "' is next to it"));
    CHECK(read(folder / "s.db" + ending) == "mine");
    CHECK(folder.content() == std::set<std::string>{"s.db" + ending});
    fs::remove(folder / "s.db" + ending);
  }
  { const StudyRecord record = StudyRecord::create(folder / "s.db", kSettings); }
  for (const std::string ending : {"-wal", "-journal"}) {
    write(folder / "s.db" + ending, "mine, and long");
    CHECK_THAT(complaint(folder / "s.db"), Contains("s.db" + ending + "' is not of this study"));
    CHECK(read(folder / "s.db" + ending) == "mine, and long");
    fs::remove(folder / "s.db" + ending);
  }
  CHECK(complaint(folder / "s.db").empty());
}

TEST_CASE("a study and the log of a killed writer that were parted are known", "[study]") {
  const Folder folder;
  {
    StudyRecord record = StudyRecord::create(folder / "s.db", kSettings);
    record.add(numbered(1), odd_outcome(), five_variables());
    fs::copy(folder / "s.db", folder / "alone.db");  // as they are when it is killed now
    fs::copy(folder / "s.db", folder / "both.db");
    fs::copy(folder / "s.db-wal", folder / "both.db-wal");
    fs::copy(folder / "s.db-wal", folder / "log.db-wal");
  }
  CHECK_FALSE(StudyRecord::read(folder / "s.db").lost_log());
  CHECK_FALSE(StudyRecord::read(folder / "both.db").lost_log());
  CHECK(StudyRecord::read(folder / "both.db").size() == 1);
  CHECK(StudyRecord::read(folder / "alone.db").lost_log());
  const std::string log = read(folder / "log.db-wal");
  CHECK_THROWS_WITH(StudyRecord::create(folder / "log.db", kSettings),
                    Contains("log.db-wal") && Contains("the last searches"));
  CHECK(read(folder / "log.db-wal") == log);
}

TEST_CASE("of those who begin one study at once one does, and the others are told why not",
          "[study]") {
  constexpr int kTimes = 20, kAtOnce = 4;
  for (int i = 0; i < kTimes; ++i) {
    const Folder folder;
    const std::string path = folder / "s.db";
    std::vector<std::string> said(kAtOnce);
    std::vector<std::thread> all;
    for (std::string& mine : said) {
      all.emplace_back([&path, &mine] {
        try {
          const StudyRecord record = StudyRecord::create(path, kSettings);
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
        } catch (const std::invalid_argument& error) {
          mine = error.what();
        } catch (const std::exception& error) {
          mine = std::string("failed: ") + error.what();
        }
      });
    }
    for (std::thread& one : all) one.join();
    CHECK(std::count(said.begin(), said.end(), "") == 1);
    const std::string why =
        path + ": the file exists already; resume its study, or name another file";
    CHECK(std::count(said.begin(), said.end(), why) == kAtOnce - 1);
    CHECK(folder.content() == std::set<std::string>{"s.db"});
    CHECK(StudyRecord::read(path).settings() == kSettings);
  }
}

TEST_CASE("a study is made through links, and not where they go in a circle", "[study]") {
  const Folder folder;
  fs::create_directory(folder / "made");
  fs::create_symlink("made/new.db", folder / "link.db");
  { const StudyRecord record = StudyRecord::create(folder / "link.db", kSettings); }
  CHECK(fs::is_symlink(folder / "link.db"));
  CHECK(StudyRecord::read(folder / "made/new.db").settings() == kSettings);
  fs::create_symlink("loop.db", folder / "loop.db");
  CHECK_THROWS_WITH(StudyRecord::create(folder / "loop.db", kSettings),
                    Contains("loop.db: Too many levels of symbolic links"));
  CHECK_THAT(complaint(folder / "loop.db"), Contains("there is no such study"));
}

TEST_CASE("tasks that differ in the last bit of anything are different", "[study]") {
  Task task = numbered(0.1);
  task.origin = {1, 2};
  task.starts = {{1, 2}, {3}};
  const std::string text = task.text();
  const auto differs = [&](auto change) {
    Task other = task;
    change(other);
    return other.text() != text;
  };
  CHECK(differs([](Task& t) { t.bounds[0] = std::nextafter(t.bounds[0], 1); }));
  CHECK(differs([](Task& t) { t.bounds[1] = -kInfinity; }));
  CHECK(differs([](Task& t) { t.sought = 0; }));
  CHECK(differs([](Task& t) { t.part = 4; }));
  CHECK(differs([](Task& t) { t.seed = 2; }));
  CHECK(differs([](Task& t) { t.kind = Task::Kind::Toward; }));
  CHECK(differs([](Task& t) { t.starts = {{1}, {2, 3}}; }));
  CHECK(differs([](Task& t) { std::swap(t.origin, t.direction); }));
  Task scout = task;
  scout.kind = Task::Kind::Scout;
  Task longer = scout;
  longer.generations = 7;
  CHECK(scout.text() != longer.text());
}

TEST_CASE("a study is not made over a file that is there", "[study]") {
  const Folder folder;
  write(folder / "notes.txt", "mine");
  for (const std::string& path : {folder / "notes.txt", folder / ""}) {
    CHECK_THROWS_AS(StudyRecord::create(path, kSettings), std::invalid_argument);
    CHECK_THROWS_WITH(StudyRecord::create(path, kSettings),
                      Contains(path) && Contains("exists already"));
  }
  CHECK(read(folder / "notes.txt") == "mine");
  CHECK(folder.content() == std::set<std::string>{"notes.txt"});
}

TEST_CASE("where no file can be made a study cannot be", "[study]") {
  const Folder folder;
  write(folder / "plain", "");
  for (const std::string& path : {folder / "plain/s.db", folder / "none/s.db",
                                  std::string("/proc/s.db"), std::string("/dev/full/s.db")}) {
    CHECK_THROWS_WITH(StudyRecord::create(path, kSettings),
                      Contains(path) && Contains("cannot be written"));
    CHECK_THROWS_AS(StudyRecord::create(path, kSettings), std::runtime_error);
  }
  CHECK(folder.content() == std::set<std::string>{"plain"});
}

TEST_CASE("names that SQLite reads as something else are names of files", "[study]") {
  const Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  for (const std::string name : {":memory:", "file:s.db?mode=memory"}) {
    { const StudyRecord record = StudyRecord::create(name, kSettings); }
    CHECK(fs::exists(name));
    CHECK(StudyRecord::read(name).settings() == kSettings);
  }
  CHECK_THROWS_AS(StudyRecord::create("", kSettings), std::invalid_argument);
  fs::current_path(before);
}

TEST_CASE("what is not a study is refused and left as it is", "[study]") {
  const Folder folder;
  CHECK_THAT(complaint(folder / "none.db"), Contains("no such study"));
  CHECK_THAT(complaint(folder / ""), Contains("no such study"));
  CHECK_THAT(complaint("/dev/null"), Contains("no such study"));
  write(folder / "empty.db", "");
  write(folder / "text.db", std::string(5000, 'x') + "\n");
  write(folder / "short.db", "SQLite format 3");
  for (const bool wal : {false, true}) {
    SQLite::Database base(folder / (wal ? "wal.db" : "foreign.db"),
                          SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    if (wal) base.exec("PRAGMA journal_mode = WAL");
    base.exec("CREATE TABLE task (text TEXT); INSERT INTO task VALUES ('mine')");
  }
  const auto names = folder.content();
  for (const std::string name : {"empty.db", "text.db", "short.db", "foreign.db", "wal.db"}) {
    INFO(name);
    const std::string bytes = read(folder / name);
    CHECK_THAT(complaint(folder / name), Contains("not a camlaw study"));
    CHECK(read(folder / name) == bytes);
  }
  CHECK(folder.content() == names);
}

TEST_CASE("a study of another version is refused with both versions", "[study]") {
  const Folder folder;
  made_study(folder / "s.db", 4);
  { SQLite::Database(folder / "s.db", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7"); }
  const std::string bytes = read(folder / "s.db");
  CHECK_THAT(complaint(folder / "s.db"),
             Contains("version 7") && Contains("version 3") && Contains("version 2"));
  CHECK(read(folder / "s.db") == bytes);
}

TEST_CASE("a study that was cut off says so", "[study]") {
  const Folder folder;
  made_study(folder / "s.db", 8);
  const std::string bytes = read(folder / "s.db");
  for (std::size_t size = 0; size < bytes.size(); size += 1000) {
    write(folder / "t.db", bytes.substr(0, size));
    INFO(size << " of " << bytes.size());
    const std::string said = complaint(folder / "t.db");
    CHECK_FALSE(said.empty());
    CHECK(read(folder / "t.db").size() == size);
  }
}

TEST_CASE("a damaged study is refused, or read as far as it goes", "[study]") {
  const Folder folder;
  const std::string whole = made_study(folder / "s.db", 8);
  const std::string bytes = read(folder / "s.db");
  std::size_t refused = 0, taken = 0;
  const auto check = [&](std::string damaged) {
    write(folder / "t.db", damaged);
    try {
      read_study(folder / "t.db", 8);
      ++taken;
    } catch (const std::exception& error) {
      CHECK_FALSE(std::string(error.what()).empty());
      ++refused;
    }
    CHECK(read(folder / "t.db") == damaged);
  };
  for (std::size_t at = 100; at < bytes.size(); at += 197) {
    INFO("byte " << at);
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    check(damaged);
  }
  for (std::size_t at = 4096; at < bytes.size(); at += 1024) {
    INFO("stretch from " << at);
    std::string damaged = bytes;
    for (std::size_t i = at; i < std::min(at + 64, bytes.size()); ++i) damaged[i] = '\xa5';
    check(damaged);
  }
  CHECK(refused > 10);
  CHECK(taken > 10);
}

TEST_CASE("the checksum is the CRC-64/XZ of the catalogues", "[study]") {
  Checksum checksum;
  checksum.add(std::string_view("123456789"));
  CHECK(checksum.value() == 0x995dc9bbdf1939fa);
  // The same step by step, without a table.
  std::uint64_t crc = ~std::uint64_t{0};
  for (const char c : std::string("caml\0w", 6)) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xc96c5795d7870f42 : 0);
  }
  Checksum other;
  other.add(std::string_view("caml\0w", 6));
  CHECK(other.value() == ~crc);
}

TEST_CASE("rows that are not as they were written are damage, and named", "[study]") {
  const Folder folder;
  const std::string whole = made_study(folder / "s.db", 8);
  const std::string bytes = read(folder / "s.db");
  for (const std::string change :
       {"DELETE FROM objective WHERE place = 1", "DELETE FROM objective",
        "DELETE FROM variable WHERE place = 0", "DELETE FROM variable",
        "INSERT INTO objective SELECT id, 2, 'f', 'N', 0, 0, 1 FROM design",
        "INSERT INTO variable SELECT id, 2, 'z', '1', 0 FROM design",
        "UPDATE objective SET weight = NULL WHERE place = 0",
        "UPDATE objective SET name = 'other' WHERE design = 3",
        "UPDATE variable SET value = value + 1e-15 WHERE design = 3 AND place = 0",
        "UPDATE task SET text = text || ' ' WHERE id = 4",
        "UPDATE task SET is_global = 2 WHERE id = 5", "UPDATE design SET task = 2 WHERE task = 3",
        "DELETE FROM design WHERE task = 3", "UPDATE design SET verdict = 'splendid'"}) {
    INFO(change);
    write(folder / "t.db", bytes);
    { SQLite::Database(folder / "t.db", SQLite::OPEN_READWRITE).exec(change); }
    CHECK_FALSE(StudyRecord::read(folder / "t.db").damaged().empty());
    CHECK(read_study(folder / "t.db", 8) != whole);
    // Solved again it is what it was.
    const ProblemSpace space = two_rooms();
    const ParetoOptions options = with_points(8);
    DirectExecutor direct(space, options.solve);
    {
      StudyRecord record = StudyRecord::open(folder / "t.db");
      RecordedExecutor recorded(space, record, &direct);
      CHECK(bits(pareto(space, options, recorded)) == whole);
      CHECK_FALSE(recorded.faults().empty());
    }
    CHECK(StudyRecord::read(folder / "t.db").damaged().empty());
    CHECK(read_study(folder / "t.db", 8) == whole);
  }
  write(folder / "t.db", bytes);
  CHECK(read_study(folder / "t.db", 8) == whole);
}

TEST_CASE("a setting that is not as it was written is named", "[study]") {
  const Folder folder;
  made_study(folder / "s.db", 4);
  {
    SQLite::Database base(folder / "s.db", SQLite::OPEN_READWRITE);
    base.exec("UPDATE setting SET value = '13' WHERE name = 'points'");
  }
  CHECK_THROWS_AS(StudyRecord::read(folder / "s.db").settings(), std::invalid_argument);
  CHECK_THROWS_WITH(StudyRecord::read(folder / "s.db").settings(), Contains("'points'"));
}

namespace {

/// Makes of a study one of version 2, as earlier programs wrote it.
void make_older(const std::string& path) {
  SQLite::Database base(path, SQLite::OPEN_READWRITE);
  base.exec(
      "ALTER TABLE task DROP COLUMN checksum; ALTER TABLE setting DROP COLUMN checksum; "
      "PRAGMA user_version = 2");
}

}  // namespace

TEST_CASE("a study of the version before is read, and not gone on with", "[study]") {
  const Folder folder;
  const std::string whole = made_study(folder / "s.db", 8);
  make_older(folder / "s.db");
  CHECK_FALSE(StudyRecord::read(folder / "s.db").has_checksums());
  CHECK(read_study(folder / "s.db", 8) == whole);
  CHECK_THROWS_WITH(StudyRecord::open(folder / "s.db"), Contains("earlier version"));
  // What its designs are not is found without a checksum.
  {
    SQLite::Database base(folder / "s.db", SQLite::OPEN_READWRITE);
    base.exec("UPDATE objective SET value = 0.99 * value, cost = 0.99 * cost WHERE design = 2");
  }
  const ProblemSpace space = two_rooms();
  StudyRecord record = StudyRecord::read(folder / "s.db");
  RecordedExecutor recorded(space, record, nullptr);
  pareto(space, with_points(8), recorded);
  recorded.believed();
  REQUIRE(recorded.faults().size() == 1);
  CHECK(recorded.faults().front().kind == RecordFault::Kind::Wrong);
  CHECK_THAT(recorded.faults().front().why, Contains("evaluates to"));
}

namespace {

/// Says of the design of its third task that it costs less than it does.
class Lying final : public Executor {
 public:
  explicit Lying(Executor& executor) : executor_(executor) {}
  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override {
    Outcomes outcomes = executor_.run(tasks, {});
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (++count_ == 3 && !outcomes[i]->points.empty()) {
        FrontPoint& point = outcomes[i]->points.front();
        point.objectives[1] *= 0.99;
        point.costs[1] *= 0.99;
      }
      on_outcome(tasks[i], *outcomes[i]);
    }
    return outcomes;
  }

 private:
  Executor& executor_;
  int count_ = 0;
};

}  // namespace

TEST_CASE("what was written wrong is found though its checksum fits, and is solved again",
          "[study]") {
  const Folder folder;
  const std::string whole = made_study(folder / "s.db", 8);
  const ProblemSpace space = two_rooms();
  const ParetoOptions options = with_points(8);
  DirectExecutor direct(space, options.solve);
  {
    StudyRecord record = StudyRecord::create(folder / "t.db", kSettings);
    Lying lying(direct);
    RecordedExecutor recorded(space, record, &lying);
    pareto(space, options, recorded);
  }
  StudyRecord record = StudyRecord::open(folder / "t.db");
  CHECK(record.damaged().empty());
  RecordedExecutor recorded(space, record, &direct);
  CHECK(bits(pareto(space, options, recorded)) == whole);
  REQUIRE(recorded.faults().size() == 1);
  CHECK(recorded.faults().front().kind == RecordFault::Kind::Wrong);
  CHECK(read_study(folder / "t.db", 8) == whole);
}

TEST_CASE("a study whose number of version does not fit its tables is damaged", "[study]") {
  const Folder folder;
  made_study(folder / "s.db", 4);
  { SQLite::Database(folder / "s.db", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 2"); }
  CHECK_THAT(complaint(folder / "s.db"), Contains("does not fit its tables"));
}

TEST_CASE("a study that was interrupted after any task goes on to the same front", "[study]") {
  const Folder folder;
  const ProblemSpace space = two_rooms();
  const ParetoOptions options = with_points(6);
  const Front undisturbed = pareto(space, options);
  for (std::size_t tasks = 0; tasks <= undisturbed.tasks; ++tasks) {
    INFO("after " << tasks);
    const std::string path = folder / (std::to_string(tasks) + ".db");
    DirectExecutor direct(space, options.solve);
    {
      StudyRecord record = StudyRecord::create(path, kSettings);
      Interrupted interrupted(direct, tasks);
      RecordedExecutor recorded(space, record, &interrupted);
      const Front front = pareto(space, options, recorded);
      CHECK(front.complete == (tasks >= undisturbed.tasks));
      CHECK(record.size() == tasks);
    }
    StudyRecord record = StudyRecord::open(path);
    RecordedExecutor recorded(space, record, &direct);
    CHECK(bits(pareto(space, options, recorded)) == bits(undisturbed));
  }
}

TEST_CASE("a study can be asked for more points, which what is there serves", "[study]") {
  const Folder folder;
  const ProblemSpace space = two_rooms();
  made_study(folder / "s.db", 6);
  const ParetoOptions options = with_points(20);
  const Front afresh = pareto(space, options);
  StudyRecord record = StudyRecord::open(folder / "s.db");
  const std::size_t before = record.size();
  DirectExecutor direct(space, options.solve);
  RecordedExecutor recorded(space, record, &direct);
  const Front extended = pareto(space, options, recorded);
  CHECK(extended.complete);
  CHECK(extended.points.size() >= 20);
  CHECK(extended.hypervolume == Approx(afresh.hypervolume).epsilon(0.02));
  CHECK(record.size() >= before);
  CHECK(bits(pareto(space, options, recorded)) == bits(extended));
  // Now it is all there.
  CHECK(read_study(folder / "s.db", 20) == bits(extended));
}

TEST_CASE("without others a study stops at the first task that is not there", "[study]") {
  const Folder folder;
  const ProblemSpace space = two_rooms();
  StudyRecord record = StudyRecord::create(folder / "s.db", kSettings);
  RecordedExecutor recorded(space, record, nullptr);
  const Front front = pareto(space, with_points(5), recorded);
  CHECK_FALSE(front.complete);
  CHECK(front.points.empty());
  CHECK(front.tasks == 0);
}

TEST_CASE("a study can be read while it is written", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  StudyRecord writer = StudyRecord::create(path, kSettings);
  for (int i = 0; i < 20; ++i) {
    writer.add(numbered(i), odd_outcome(), five_variables());
    const StudyRecord reader = StudyRecord::read(path);
    CHECK(reader.settings() == kSettings);
    CHECK(reader.size() == static_cast<std::size_t>(i) + 1);
    CHECK(reader.find(numbered(i), five_variables()).has_value());
    writer.add(numbered(i), odd_outcome(), five_variables());  // with a reader there
  }
}

TEST_CASE("what was written whole outlives a writer that is killed", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  const pid_t child = fork();
  if (child == 0) {
    StudyRecord record = StudyRecord::create(path, kSettings);
    for (int i = 0; i < 5; ++i) record.add(numbered(i), odd_outcome(), five_variables());
    _exit(0);  // without closing anything
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(status == 0);
  CHECK(StudyRecord::read(path).size() == 5);
  const StudyRecord record = StudyRecord::open(path);
  CHECK(record.size() == 5);
  for (int i = 0; i < 5; ++i)
    CHECK(bits(*record.find(numbered(i), five_variables())) == bits(odd_outcome()));
}

namespace {

/// Begins to write over a study and is killed while it does so, when pages are on the disk
/// already: what they held is in a journal beside the file.
void leave_hot_journal(const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    SQLite::Database base(path, SQLite::OPEN_READWRITE);
    base.exec("PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; BEGIN; DELETE FROM setting");
    for (int i = 0; i < 200; ++i) {
      base.exec("INSERT INTO setting VALUES ('" + std::to_string(i) + "', '" +
                std::string(1000, 'x') + "', 0)");
    }
    _exit(0);  // without an end of the transaction
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(status == 0);
  REQUIRE(fs::file_size(path + "-journal") > 512);
}

}  // namespace

TEST_CASE("a study whose writer was killed while it wrote its journal is read as it was",
          "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  {
    StudyRecord record = StudyRecord::create(path, kSettings);
    for (int i = 0; i < 5; ++i) record.add(numbered(i), odd_outcome(), five_variables());
  }
  const std::string before = read(path);
  for (const bool reads : {true, false}) {
    leave_hot_journal(path);
    REQUIRE(read(path) != before);
    const StudyRecord record = reads ? StudyRecord::read(path) : StudyRecord::open(path);
    CHECK(record.settings() == kSettings);
    CHECK(record.size() == 5);
    for (int i = 0; i < 5; ++i)
      CHECK(bits(*record.find(numbered(i), five_variables())) == bits(odd_outcome()));
    CHECK(!fs::exists(path + "-journal"));
  }
  CHECK(folder.content() == std::set<std::string>{"s.db"});
}

TEST_CASE("a journal that cannot be rolled back is said to be the reason", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  StudyRecord::create(path, kSettings);
  leave_hot_journal(path);
  const fs::path place = fs::path(path).parent_path();
  using fs::perms;
  const perms may_read = perms::owner_read | perms::group_read | perms::others_read;
  const perms may_enter = perms::owner_exec | perms::group_exec | perms::others_exec;
  fs::permissions(path, may_read);
  fs::permissions(path + "-journal", may_read);
  fs::permissions(place, may_read | may_enter);
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && setuid(65534) != 0) _exit(2);  // root may write anywhere
    std::string said;
    try {
      StudyRecord::read(path);
    } catch (const std::invalid_argument& error) {
      said = error.what();
    }
    const bool names_cause = said.find("was interrupted") != std::string::npos &&
                             said.find("writable") != std::string::npos;
    _exit(names_cause ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  fs::permissions(place, perms::owner_all);
  CHECK(status == 0);
}

}  // namespace camlaw::optim::record_test
