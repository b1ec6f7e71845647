// SPDX-License-Identifier: MIT
// 'camlaw tolerance --db': a yield that goes on where it was cut short.
#include <csignal>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::tolerance_record_test {
namespace {

const std::string kFile = testing::source("problems/cams/tolerances.toml");

/// A yield of the file's tolerances without its errors of the profile, which take longer.
class Yield {
 public:
  Yield() {
    const std::string text = read(kFile);
    std::ofstream(file_) << text.substr(0, text.find("[profile]"));
  }
  const std::string& file() const { return file_; }
  Words operator()(const Words& more) const {
    Words words{"tolerance", file(), "--samples", "400000", "--workers", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

 private:
  Folder folder_;
  std::string file_ = folder_ / "tolerances.toml";
};

}  // namespace

TEST_CASE("a yield that was cut short goes on where it stood", "[program][study]") {
  const Folder folder;
  const Yield yield;
  const std::string db = folder / "yield.db";
  const std::string expected = done(yield({"--json"}));
  const Outcome cut = run(yield({"--db", db, "--time-limit", "0.2"}));
  if (cut.status != 0) {  // on a quick machine it is done by then
    CHECK_THAT(cut.out, Contains("stopped early"));
    CHECK_THAT(cut.out, Contains("--resume continues it"));
  }
  CHECK(done(yield({"--db", db, "--resume", "--json"})) == expected);
  CHECK(done(yield({"--db", db, "--resume", "--json"})) == expected);  // from the record alone
  CHECK(folder.content() == std::set<std::string>{"yield.db"});
}

TEST_CASE("a yield whose program was killed goes on with what is recorded", "[program][study]") {
  const Folder folder;
  const Yield yield;
  const std::string db = folder / "yield.db";
  const Running running(yield({"--db", db, "--json"}));
  REQUIRE(has_made(running.id(), db));
  usleep(50'000);
  kill(running.id(), SIGKILL);
  running.wait();
  CHECK(done(yield({"--db", db, "--resume", "--json"})) == done(yield({"--json"})));
}

TEST_CASE("the record of another yield, or of none, is refused", "[program][study]") {
  const Folder folder;
  const std::string db = folder / "yield.db";
  const Yield yield;
  const std::string& own = yield.file();
  const auto small = [&](const Words& more) {
    Words words{"tolerance", own, "--db", db};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  done(small({"--samples", "1000"}));
  const std::string before = read(db);
  CHECK_THAT(failed(small({"--samples", "1000"}), 2), Contains("the file exists already"));
  CHECK_THAT(failed(small({"--samples", "2000", "--resume"}), 2),
             Contains("it was begun with --samples 1000"));
  CHECK_THAT(failed(small({"--samples", "1000", "--seed", "2", "--resume"}), 2),
             Contains("it was made with seed 1, now it is 2"));
  CHECK_THAT(failed(small({"--samples", "1000", "--set", "speed=150 rpm", "--resume"}), 2),
             Contains("other values are set"));
  CHECK_THAT(
      failed(small({"--samples", "1000", "--tolerance", "base_radius=0.1 mm", "--resume"}), 2),
      Contains("its tolerances were stated otherwise"));
  CHECK_THAT(failed({"tolerance", testing::source("problems/cams/robust_force.toml"), "--samples",
                     "1000", "--db", db, "--resume"},
                    2),
             Contains("the problem file is not the one"));
  CHECK_THAT(failed({"front", db}, 2), Contains("is a yield, not a front"));
  CHECK_THAT(failed({"sweep", kFile, "--set", "speed=100,150 rpm", "--db", db, "--resume"}, 2),
             Contains("is a yield, not a sweep") && Contains("'camlaw tolerance "));
  CHECK_THAT(failed({"sweep", kFile, "--db", db, "--resume"}, 2),
             Contains("is a yield, not a sweep") && !Contains("nothing is swept"));
  CHECK_THAT(
      failed({"pareto", testing::source("problems/cams/roller_front.toml"), "--db", db, "--resume"},
             2),
      Contains("is a yield, not a front"));
  CHECK(read(db) == before);
  CHECK_THAT(failed({"tolerance", kFile, "--resume"}, 2), Contains("--db FILE"));
  // As a job does that is submitted again and again: it begins where there is no record yet.
  done({"tolerance", own, "--samples", "1000", "--db", folder / "new.db", "--resume"});
  CHECK(fs::exists(folder / "new.db"));
}

}  // namespace camlaw::cli::tolerance_record_test
