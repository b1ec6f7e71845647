// SPDX-License-Identifier: MIT
// Fronts of three objectives and more: even, complete, and as large as NSGA-II's.
#include <algorithm>
#include <atomic>

#include "optim/study/recorded_executor.h"
#include "tests/optim/pareto/evenness.h"
#include "tests/optim/pareto/outcomes.h"
#include "tests/optim/pareto/small_fronts.h"
#include "tests/temporary_folder.h"

namespace camlaw::optim::even_front_test {

using namespace front_tests;
using namespace even_tests;
using study_tests::bits;

namespace {

struct Case {
  std::string name;
  std::size_t objectives, points;
  double covered;  ///< how far the front may be from the points, in mean distances to the nearest
};

void check_even(const Case& c) {
  INFO(c.name << ", " << c.objectives << " objectives, " << c.points << " points");
  const sets::KnownSurface surface = sets::known_surface(c.name, c.objectives);
  ParetoOptions options;
  options.points = c.points;
  const Front front = pareto(surface.problem, options);
  CHECK(front.points.size() == c.points);
  CHECK(front.certified() == c.points);
  CHECK(front.complete);
  CHECK(front.failures.empty());
  REQUIRE(front.largest_gap);
  CHECK(*front.largest_gap <= 2.5);
  const std::vector<Costs> samples = samples_of(surface, 8000);
  const std::vector<Costs> all = costs_of(front);
  const std::vector<Costs> places = by_range(all, samples);
  const Even even = evenness_of(places);
  // Of a front in pieces the largest is between them.
  if (surface.is_connected) CHECK(even.gap <= 2.5);
  CHECK(even.nearest <= 2.5);
  CHECK(even.crowded >= 0.2);
  CHECK(farthest(by_range(samples, samples), places) <= c.covered * even.mean_nearest);
  constexpr std::size_t kGenerations = 100;
  const ProblemSpace space = ProblemSpace::of(surface.problem);
  CHECK(front.hypervolume >= 0.995 * best_of_nsga2(space, c.points, kGenerations, front.reference));
  // Searches of fronts of one combination: what must be more than points are ends, and what is
  // looked for beyond them.
  CHECK(front.tasks <= 2 * c.points);
}

}  // namespace

TEST_CASE("fronts of three objectives are even", "[front][heavy]") {
  check_even({"sphere", 3, 40, 1.5});
  check_even({"centres", 3, 40, 1.7});
  check_even({"inverted", 3, 40, 1.5});
  check_even({"curve", 3, 40, 1.2});
  check_even({"patches", 3, 40, 1.8});
}

TEST_CASE("fronts of four objectives are even", "[front][heavy]") {
  check_even({"sphere", 4, 100, 1.7});
  check_even({"centres", 4, 100, 1.9});
  check_even({"inverted", 4, 100, 1.7});
  check_even({"patches", 4, 100, 4.5});
}

TEST_CASE("fronts of five objectives are even", "[front][heavy]") {
  check_even({"sphere", 5, 100, 2});
  check_even({"centres", 5, 100, 2});
  check_even({"inverted", 5, 100, 1.7});
  check_even({"curve", 5, 100, 1.2});
}

TEST_CASE("a cost that is the same all along the front does not disturb it", "[front]") {
  Problem problem = two_centres();
  problem.objectives.push_back(
      cost("f3", linear({0}, [](const auto& u) { return 0.0 * u[0] + 7.0; })));
  ParetoOptions options;
  options.points = 20;
  const Front front = pareto(problem, options);
  CHECK(front.points.size() == 20);
  CHECK(front.complete);
  for (const FrontPoint& p : front.points) {
    const double r = std::sqrt(std::max(p.costs[0], 0.0));
    CHECK(p.costs[1] == Approx((1 - r) * (1 - r)).margin(1e-4));
    CHECK(p.costs[2] == 7);
  }
  const std::vector<Costs> all = costs_of(front);
  CHECK(evenness_of(by_range(all, all)).gap <= 2.5);
  CHECK(front.tasks <= 60);
}

TEST_CASE("three objectives of which two agree have the front of two", "[front]") {
  Problem problem = two_centres();
  problem.objectives.push_back(problem.objectives[1]);
  ParetoOptions options;
  options.points = 20;
  const Front front = pareto(problem, options);
  CHECK(front.points.size() == 20);
  CHECK(front.complete);
  for (const FrontPoint& p : front.points) CHECK(p.costs[1] == p.costs[2]);
}

TEST_CASE("a front that was stopped or is uneven is not complete", "[front]") {
  const sets::KnownSurface surface = sets::known_surface("centres", 3);
  std::atomic<bool> stop = false;
  ParetoOptions options;
  options.points = 40;
  options.solve.stop = &stop;
  options.progress = [&](const StudyProgress& progress) {
    if (progress.tasks >= 12) stop = true;
  };
  const Front stopped = pareto(surface.problem, options);
  CHECK(stopped.stopped);
  CHECK_FALSE(stopped.complete);
  // Searches that find nothing leave gaps that are not known to be empty.
  class Deaf final : public Executor {
   public:
    explicit Deaf(const ProblemSpace& space) : direct_(space, options_) {}
    Outcomes run(const std::vector<Task>& tasks, const OnOutcome& told) override {
      Outcomes outcomes = direct_.run(tasks, told);
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        // All that would lie near the middle of the front fails.
        if (tasks[i].kind != Task::Kind::Toward || outcomes[i]->points.empty()) continue;
        const Costs& c = outcomes[i]->points.front().costs;
        if (*std::max_element(c.begin(), c.end()) > 0.9) continue;
        outcomes[i] = Outcome{};
        outcomes[i]->failure = "no answer";
      }
      return outcomes;
    }

   private:
    OptimiseOptions options_;
    DirectExecutor direct_;
  };
  const ProblemSpace space = ProblemSpace::of(surface.problem);
  Deaf deaf(space);
  ParetoOptions few;
  few.points = 60;
  const Front holed = pareto(space, few, deaf);
  CHECK_FALSE(holed.stopped);
  CHECK_FALSE(holed.failures.empty());
  const std::vector<Costs> all = costs_of(holed);
  CHECK(holed.complete == (*holed.largest_gap <= 2.5));
  CHECK(*holed.largest_gap == Approx(evenness_of(by_range(all, all)).gap).epsilon(0.05));
}

TEST_CASE("three objectives: a study that is resumed gives the same bits", "[front]") {
  const ProblemSpace space = ProblemSpace::of(three_centres());
  ParetoOptions options;
  options.points = 24;
  const std::string whole = bits(pareto(space, options));
  CHECK(bits(pareto(space, options)) == whole);
  const testing::Folder folder;
  StudyRecord record = StudyRecord::create(folder / "study.db", {});
  {
    std::atomic<bool> stop = false;
    ParetoOptions first = options;
    first.solve.stop = &stop;
    first.progress = [&](const StudyProgress& progress) {
      if (progress.tasks >= 20) stop = true;
    };
    DirectExecutor direct(space, first.solve);
    RecordedExecutor executor(space, record, &direct);
    CHECK_FALSE(pareto(space, first, executor).complete);
  }
  DirectExecutor direct(space, options.solve);
  RecordedExecutor executor(space, record, &direct);
  CHECK(bits(pareto(space, options, executor)) == whole);
}

}  // namespace camlaw::optim::even_front_test
