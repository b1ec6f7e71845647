// SPDX-License-Identifier: MIT
#include "optim/search/interruptible.h"

#include "optim/cycle/remembered.h"
#include "optim/search/local.h"
#include "optim/search/memory.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::search_tests::interruptible_test {
namespace {

/// (x1 - 3 x4)^2 of four variables: inputs that are not the first ones.
Function slanted() {
  return convex({1, 3}, [](const auto& u) { return square(u[0] - 3.0 * u[1]); });
}

Problem slanted_problem() {
  Problem problem;
  for (int i = 0; i < 4; ++i) problem.variables.push_back(variable("x", -2, 2, 1));
  problem.objectives = {least(slanted())};
  problem.constraints.push_back(
      at_least("x4", linear({3}, [](const auto& u) { return 1.0 * u[0]; }), 0.5));
  return problem;
}

}  // namespace

TEST_CASE("an interruptible problem is the same to the bit until it throws", "[optimise]") {
  std::atomic<bool> stop = false;
  const Deadline deadline({}, &stop);
  const Function plain = slanted();
  const Problem problem = interruptible(slanted_problem(), deadline);
  const Function& guarded = problem.objective().response.function();
  const Point x{0.1, -1.7, 9, 0.3};
  CHECK(guarded.inputs() == plain.inputs());
  CHECK(guarded.shape() == plain.shape());
  CHECK(guarded.value(x) == plain.value(x));
  Point g(2), h(3), own_g(2), own_h(3);
  CHECK(guarded.hessian(x, g, h) == plain.hessian(x, own_g, own_h));
  CHECK(g == own_g);
  CHECK(h == own_h);
  CHECK(guarded.enclose(x).lower == plain.enclose(x).lower);
  const std::vector<Bounds> box(4, {-1, 1});
  CHECK(guarded.range(box).value.upper == plain.range(box).value.upper);
  stop = true;
  CHECK_THROWS_AS(guarded.value(x), Interrupted);
  CHECK_THROWS_AS(guarded.gradient(x, g), Interrupted);
  CHECK_THROWS_AS(guarded.hessian(x, g, h), Interrupted);
  CHECK_THROWS_AS(guarded.enclose(x), Interrupted);
  CHECK_THROWS_AS(guarded.range(box), Interrupted);
  CHECK_THROWS_AS(scales(problem, problem.start()), Interrupted);
}

TEST_CASE("a search whose proof or sizes would go on is ended there too", "[optimise][heavy]") {
  // The flag is set at every number of evaluations in turn: wherever the search is, it comes back
  // with a design, and asks no more of the model than a look at what it has.
  std::atomic<bool> stop = false;
  int count = 0, late = 0, most = std::numeric_limits<int>::max();
  Problem problem = slanted_problem();
  problem.objectives = {least(observed(slanted(), [&](std::span<const double>) {
    late += stop ? 1 : 0;
    if (++count >= most) stop = true;
  }))};
  const auto search = [&] {
    count = late = 0;
    stop = false;
    return optimise(problem, {.stop = &stop}).found;
  };
  const Found free = search();
  CHECK(is_feasible(free.assessment));
  const int whole = count;
  REQUIRE(whole > 10);
  for (most = 1; most < whole; most += std::max(1, whole / 4)) {
    INFO(most << " of " << whole);
    const Found found = search();
    REQUIRE(found.x.size() == 4);
    CHECK(std::isfinite(found.assessment.objective.value));
    // Asked at the very end it may have its answer already.
    const bool done = found.x == free.x && found.assessment.verdict == free.assessment.verdict;
    CHECK((found.assessment.reason.starts_with("stopped") || (done && whole - most < 50)));
    CHECK(late <= 10);
  }
}

TEST_CASE("a design that was cut short is judged by its limits alone", "[optimise]") {
  const Problem problem = slanted_problem();
  const Found met = cut_short(problem, {0, 0, 0, 1}, "the time limit of 2 s was reached");
  CHECK(met.assessment.verdict == Verdict::Feasible);
  CHECK(met.assessment.objective.value == 9);
  CHECK(met.assessment.reason == "the time limit of 2 s was reached; not proved yet");
  const Found broken = cut_short(problem, {0, 0, 0, 0.4}, "stopped");
  CHECK(broken.assessment.verdict == Verdict::Failed);
  CHECK(broken.assessment.reason == "stopped; the design does not meet x4");
}

TEST_CASE("memory is refused by name before it is taken", "[optimise]") {
  // Each of 2000 limits sees all of 400 numbers of a list: 800000 slopes, of which every solver
  // holds at least one copy of 8 bytes.
  Problem problem;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < 400; ++i) {
    problem.variables.push_back(variable("places[" + std::to_string(i + 1) + "]", 0, 1, 0.5));
    all.push_back(i);
  }
  const auto sum = [](const auto& u) {
    auto total = 1.0 * u[0];
    for (std::size_t i = 1; i < u.size(); ++i) total = total + u[i];
    return total;
  };
  problem.objectives = {least(linear(all, sum))};
  for (int i = 0; i < 2000; ++i)
    problem.constraints.push_back(at_least("sum", linear(all, sum), 1));
  const MemoryNeed need = memory_need(problem);
  CHECK(need.bytes > 8 * 2000 * 400);
  CHECK(need.of == "400 variables (400 places) and 2001 rows of limits");
  CHECK_THROWS_WITH(optimise(problem, {.memory = 1e6}),
                    Catch::Contains("may use 1 MB") && Catch::Contains("400 places"));
  Problem half = problem;
  half.constraints.resize(1000);
  CHECK(memory_need(half).bytes < 0.6 * need.bytes);
}

}  // namespace camlaw::optim::search_tests::interruptible_test
