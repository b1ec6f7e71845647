// SPDX-License-Identifier: MIT
// Work on a problem that is asked to stop.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstring>

#include "optim/problem/deadline.h"
#include "problems/published/cam_shape/solve.h"
#include "problems/published/sheet_delivery/trade_off.h"
#include "problems/published/spine_cutter/study.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/doubtful_limits.h"
#include "tests/paths.h"

namespace camlaw::problems::stopped_test {
namespace {

using optim::Interrupted;

ProblemStatement shipped(const std::string& file, const std::atomic<bool>* stop) {
  ProblemStatement statement = read_problem_file(testing::source("problems/") + file);
  statement.stop = stop;
  return statement;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

const char* const kFiles[] = {"cams/roller_least_base.toml", "spine_cutter/least_force.toml",
                              "own/slider_crank.toml", "follower_train/quiet_rise.toml"};

}  // namespace

TEST_CASE("a problem that may be stopped has the same numbers", "[stop]") {
  std::atomic<bool> stop = false;
  for (const char* file : kFiles) {
    INFO(file);
    const ProblemStatement plain = shipped(file, nullptr), watched = shipped(file, &stop);
    const auto before = evaluate(plain), after = evaluate(watched);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      INFO(before[i].name);
      CHECK(same_bits(before[i].value, after[i].value));
      CHECK(same_bits(before[i].highest, after[i].highest));
      CHECK(same_bits(before[i].lowest_at, after[i].lowest_at));
      CHECK(before[i].proved == after[i].proved);
    }
    const auto curves = curves_of(plain), theirs = curves_of(watched);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const auto trace = curves[k].curve().trace({}), other = theirs[k].curve().trace({});
      const auto breaks = trace->breaks();
      const auto places = optim::even_places(breaks.front(), breaks.back(), 90);
      const auto values = trace->values(places), others = other->values(places);
      CHECK(std::equal(values.begin(), values.end(), others.begin(), same_bits));
    }
    const auto limits = standing(plain), others = standing(watched);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      CHECK(same_bits(limits[i].margin, others[i].margin));
    }
  }
}

TEST_CASE("whatever is worked out of a problem ends once it is stopped", "[stop]") {
  std::atomic<bool> stop = false;
  for (const char* file : kFiles) {
    INFO(file);
    stop = false;
    const ProblemStatement statement = shipped(file, &stop);
    const auto curves = curves_of(statement);
    const BoundProblem bound(statement);
    const ReadDesign design{.problem = statement, .verdict = "certified optimum"};
    CHECK_NOTHROW(evaluate(statement));
    stop = true;
    CHECK_THROWS_AS(evaluate(statement), Interrupted);
    CHECK_THROWS_AS(standing(statement), Interrupted);
    CHECK_THROWS_AS(doubtful_limits(bound), Interrupted);
    CHECK_THROWS_AS(verified(design), Interrupted);
    CHECK_THROWS_AS(differences(design), Interrupted);
    for (const optim::Response& curve : curves) {
      CHECK_THROWS_AS(curve.curve().trace({}), Interrupted);
    }
    // Of a problem that shares its statement but not its flag nothing ends.
    CHECK_NOTHROW(bound.with_stop(nullptr)
                      .space()
                      .problem(std::vector<std::size_t>(bound.choices().size(), 0))
                      .start());
  }
  stop = true;
  CHECK_THROWS_AS(buildability(shipped("cams/smallest_buildable.toml", &stop)), Interrupted);
  CHECK_THROWS_AS(solve_cam_shape(50, &stop), Interrupted);
}

TEST_CASE("studies of published machines tell how far they are, and end once they are stopped",
          "[stop]") {
  std::atomic<bool> stop = true;
  CHECK_THROWS_AS(study_spine_cutter({}, &stop), Interrupted);
  stop = false;
  CHECK_NOTHROW(study_spine_cutter({}, &stop));
  std::vector<double> told;
  const auto stop_at_the_third = [&](double share) {
    told.push_back(share);
    stop = told.size() == 3;
  };
  CHECK_THROWS_AS(trade_off_sheet_delivery({.progress = stop_at_the_third, .stop = &stop}),
                  Interrupted);
  CHECK(told == std::vector{0.0, 0.1, 0.2});
}

}  // namespace camlaw::problems::stopped_test
