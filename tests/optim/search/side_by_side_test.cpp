// SPDX-License-Identifier: MIT
// One problem's searches in several processes: the same answer to the last bit.
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <new>

#include "optim/crew/crew.h"
#include "optim/problem/deadline.h"
#include "optim/search/combinations.h"
#include "optim/search/search_task.h"
#include "problems/statement/bind.h"
#include "tests/optim/search/search_problems.h"
#include "tests/paths.h"

namespace camlaw::optim::side_by_side_test {
namespace {

using namespace search_tests;
using Catch::Contains;

/// Everything that a search came to, numbers by their bits.
std::string bits(const Optimum& optimum) {
  FromStart start;
  start.trail.found = optimum.found;
  std::vector<std::size_t> counts = optimum.options;
  counts.insert(counts.end(), {optimum.combinations, optimum.solved});
  return encoded(SearchTask{.options = counts, .known = {start}});
}

/// Processes from the first search on, however short it is.
Crew crew_of(int workers) { return Crew({.workers = workers, .at_once = true}); }

void check_same(const ProblemSpace& space, const OptimiseOptions& options = {}) {
  const Optimum expected = optimise(space, options);
  for (const int workers : {1, 2, 3}) {
    INFO(workers);
    Crew crew = crew_of(workers);
    CHECK(bits(optimise(space, options, crew)) == bits(expected));
    CHECK(crew.remark() == "");
  }
}

ProblemSpace shipped(const std::string& file) {
  const std::string path = testing::source("problems/") + file;
  return problems::BoundProblem(problems::read_problem_file(path)).space();
}

/// Ends this process as a fault does: with the usual action, not the test runner's.
void fall() {
  std::signal(SIGKILL, SIG_DFL);
  raise(SIGKILL);
}

/// Two valleys in each of so many rooms, the deeper ones later; something happens there.
ProblemSpace rooms(std::size_t count,
                   std::function<void(std::size_t, std::span<const double>)> at) {
  ProblemSpace space;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("room " + std::to_string(i));
  space.choices = {{"room", "", names, {}, 0}};
  space.problem = [at = std::move(at)](const std::vector<std::size_t>& options) {
    const std::size_t room = options.at(0);
    Problem problem = two_valleys();
    problem.objectives = {least(observed(
        function<Interval>({0, 1},
                           [depth = 0.1 * double(room)](const auto& u) {
                             return square(square(u[0]) - 1.0) + 0.2 * u[0] + square(u[1]) - depth;
                           }),
        [at, room](std::span<const double> u) { at(room, u); }))};
    return problem;
  };
  return space;
}

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

TEST_CASE("starts in several processes lead to the same answer", "[search][workers]") {
  check_same(ProblemSpace::of(two_valleys()));
  check_same(ProblemSpace::of(two_valleys()), {.starts = 5, .seed = 7});
  check_same(ProblemSpace::of(bowl()));
  check_same(shipped("spine_cutter/least_radius.toml"));
  check_same(shipped("cams/roller_least_base.toml"));
}

TEST_CASE("a problem that tells its multipliers is the same from other processes",
          "[search][workers]") {
  // More than 30 variables: sequential programming, whose prices come back without their functions.
  check_same(shipped("servo_axis/cross_sealer.toml"));
  check_same(shipped("free_law/quiet_rise.toml"));
}

TEST_CASE("combinations in several processes lead to the same answer", "[search][workers]") {
  check_same(rooms(5, [](std::size_t, std::span<const double>) {}));
  check_same(shipped("die_press/least_approach.toml"));
  Problem grid = bowl();
  grid.variables[0] = integer("x", -3, 3);
  check_same(ProblemSpace::of(grid));
  grid.variables[0] = integer("x", -3000, 3000);  // by branch and bound
  check_same(ProblemSpace::of(grid));
}

TEST_CASE("laws and rollers in several processes lead to the same answer", "[search][workers]") {
  const std::string path = testing::source("problems/die_press/least_approach.toml");
  std::string text = problems::problem_text(path);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  };
  replace("lower = \"20 mm\"\nupper = \"100 mm\"\nstart = \"50 mm\"",
          "values = [\"50 mm\", \"60 mm\"]\nstart = \"50 mm\"");
  // The laws that have designs: to find that there is none takes long.
  replace(", \"cycloidal\", \"poly-3-4-5\", \"inclined-sinusoid\"", "");
  check_same(problems::BoundProblem(problems::read_problem(text, "press.toml")).space());
}

TEST_CASE("a problem without designs is called so by several processes", "[search][workers]") {
  Problem none = two_valleys();
  none.constraints = {at_least("x", linear({0}, [](const auto& u) { return 1.0 * u[0]; }), 3)};
  check_same(ProblemSpace::of(none));
  none.constraints = {
      at_most("ring",
              function<Interval>(
                  {0, 1}, [](const auto& u) { return square(square(u[0]) - 1.0) + square(u[1]); }),
              -1)};
  check_same(ProblemSpace::of(none));
}

TEST_CASE("what the model throws is the same from several processes", "[search][workers]") {
  check_same(rooms(3, [](std::size_t room, std::span<const double>) {
    if (room == 1) throw std::runtime_error("no such cam");
  }));
}

TEST_CASE("a process that dies leaves its combination open, and the answer says so",
          "[search][workers]") {
  const pid_t parent = getpid();
  const ProblemSpace space = rooms(4, [parent](std::size_t room, std::span<const double>) {
    if (room == 1 && getpid() != parent) fall();
  });
  Crew crew = crew_of(2);
  const Optimum optimum = optimise(space, {}, crew);
  CHECK(optimum.options == std::vector<std::size_t>{3});  // the best of the others
  CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  CHECK_THAT(optimum.found.assessment.reason,
             Contains("killed by signal 9") && Contains("not all of the 4 combinations"));
}

TEST_CASE("where every process dies there is no answer, and the reason says why",
          "[search][workers]") {
  const pid_t parent = getpid();
  Problem problem = two_valleys();
  problem.objectives = {
      least(observed(problem.objectives[0].response.function(), [parent](std::span<const double>) {
        if (getpid() != parent) fall();
      }))};
  Crew crew = crew_of(2);
  const Optimum optimum = optimise(ProblemSpace::of(problem), {}, crew);
  CHECK(optimum.found.assessment.verdict == Verdict::Failed);
  CHECK_THAT(optimum.found.assessment.reason, Contains("killed by signal 9"));
}

TEST_CASE("a stop ends searches in other processes with what they have", "[search][workers]") {
  std::atomic<bool> stop = false;
  const ProblemSpace space = rooms(6, [](std::size_t, std::span<const double>) { usleep(3000); });
  OptimiseOptions options{.stop = &stop};
  options.progress = [&stop](const Progress&) { stop = true; };
  Crew crew = crew_of(2);
  const auto began = std::chrono::steady_clock::now();
  const Optimum optimum = optimise(space, options, crew);
  CHECK(seconds_since(began) < 60);
  CHECK(optimum.found.assessment.verdict != Verdict::Certified);
  CHECK_FALSE(optimum.found.x.empty());
  CHECK_THAT(optimum.found.assessment.reason, Contains("stopped"));
}

TEST_CASE("a time limit holds for searches in other processes", "[search][workers]") {
  const ProblemSpace space = rooms(50, [](std::size_t, std::span<const double>) { usleep(3000); });
  Crew crew = crew_of(2);
  const auto began = std::chrono::steady_clock::now();
  const Optimum optimum = optimise(space, {.time_limit = 0.5}, crew);
  CHECK(seconds_since(began) < 60);
  CHECK_THAT(optimum.found.assessment.reason, Contains("the time limit of 0.5 s was reached"));
  CHECK_FALSE(optimum.found.x.empty());
}

TEST_CASE("short work stays in the calling process, long work does not", "[search][workers]") {
  void* const shared = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  REQUIRE(shared != MAP_FAILED);
  auto* const elsewhere = new (shared) std::atomic<int>(0);
  const pid_t parent = getpid();
  const auto run = [&](useconds_t pause) {
    const ProblemSpace space = rooms(8, [=](std::size_t, std::span<const double>) {
      if (pause > 0) usleep(pause);  // which gives a busy processor to others
      *elsewhere += getpid() != parent;
    });
    Crew crew({.workers = 2});
    const std::string found = bits(optimise(space, {.starts = 2}, crew));
    return std::pair(found, elsewhere->exchange(0) > 0);
  };
  const auto quick = run(0), slow = run(4000);
  CHECK_FALSE(quick.second);
  CHECK(slow.second);
  CHECK(quick.first == slow.first);
  munmap(shared, sizeof(std::atomic<int>));
}

TEST_CASE("behind a start that ends the search no other one is waited for", "[search][workers]") {
  Problem problem = two_valleys();
  // What the deeper valley has, by Newton's method: 4 x (x^2 - 1) + 1/5 = 0.
  double x = -1;
  for (int i = 0; i < 20; ++i) x -= (4 * x * (x * x - 1) + 0.2) / (12 * x * x - 4);
  problem.variables[0].start = x;
  problem.objectives[0].limit = KnownLimit{(x * x - 1) * (x * x - 1) + x / 5, "no design has less"};
  const auto desk = std::make_shared<SearchDesk>(ProblemSpace::of(problem));
  const OptimiseOptions options;
  const Deadline deadline({}, nullptr);
  std::vector<SearchedPart> parts;
  Combinations all(options, deadline, desk,
                   [&](SearchedPart part) { parts.push_back(std::move(part)); });
  const Service service = search_service(desk);
  const auto answer = [&](std::size_t number) {
    all.answered(number, *service(*all.order(number), {}));
  };
  const std::size_t first = *all.next(), second = *all.next(), third = *all.next();
  answer(first);
  CHECK_FALSE(all.order(second));
  CHECK_FALSE(all.order(third));
  const auto rest = all.next();
  REQUIRE(rest);
  answer(*rest);
  CHECK(all.is_done());
  REQUIRE(parts.size() == 1);
  CHECK(parts.front().outcome.found.starts == 1);
  all.answered(second, "of nobody");
}

TEST_CASE("damaged bytes of a search give an answer or none", "[search][workers]") {
  SearchDesk desk(ProblemSpace::of(two_valleys()));
  const Service service = search_service(std::make_shared<SearchDesk>(desk));
  const std::string bytes = *service(encoded(SearchTask{.how = {.starts = 2}}), {});
  REQUIRE(decoded_answer(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_FALSE(decoded_answer(std::string_view(bytes).substr(0, size)));
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x81);
    decoded_answer(damaged);
  }
  CHECK(service("nonsense", {}) == "");
}

}  // namespace camlaw::optim::side_by_side_test
