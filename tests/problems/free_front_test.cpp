// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "optim/study/workers.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/ruler.h"
#include "tests/paths.h"

/// Fronts of the free law against the limit that no law passes.
namespace camlaw::problems::free_front_test {
namespace {

struct Solved {
  FrontStudy study;
  optim::Front front;
};

Solved solved(const char* file, std::size_t points) {
  const std::string path = testing::source("problems/spine_cutter/") + file;
  FrontStudy study(problem_text(path), path, {points, optim::ParetoMethod::Sweep});
  optim::ProcessExecutor workers(study.space(), study.options().solve, 2);
  optim::Front front = study.run(workers);
  return {std::move(study), std::move(front)};
}

/// The front's hypervolume as a share of that of the limit's points at the same radii: what is lost
/// between the points does not count.
double share_at_same_radii(const Solved& s) {
  const auto ruler = front_ruler(s.study.bound().statement());
  REQUIRE(ruler);
  std::vector<optim::Costs> found, limit;
  for (const optim::FrontPoint& point : s.front.points) {
    const double least = ruler->least(point.costs[0]);
    CHECK(point.costs[1] >= least * (1 - 1e-9));
    found.push_back(point.costs);
    limit.push_back({point.costs[0], least});
  }
  return optim::hypervolume(found, s.front.reference) /
         optim::hypervolume(limit, s.front.reference);
}

void check_certified(const optim::Front& front) {
  CHECK(front.complete);
  CHECK(front.failures.empty());
  for (const optim::FrontPoint& point : front.points) {
    CHECK(point.verdict == optim::Verdict::Certified);
  }
}

}  // namespace

TEST_CASE("64 even knots come within a thousandth of the limit's front, each point global",
          "[fronts][free][heavy]") {
  const Solved even = solved("free_front.toml", 12);
  check_certified(even.front);
  for (const auto& point : even.front.points) CHECK(point.is_global);
  CHECK(share_at_same_radii(even) > 0.999);
  // What lies between the points is known from both sides.
  REQUIRE(even.front.hypervolume_of_mixtures);
  const double most =
      front_ruler(even.study.bound().statement())->hypervolume(even.front.reference);
  CHECK(*even.front.hypervolume_of_mixtures > even.front.hypervolume);
  CHECK(*even.front.hypervolume_of_mixtures < *even.front.hypervolume_at_most);
  CHECK(*even.front.hypervolume_of_mixtures < most);
  CHECK(*even.front.hypervolume_at_most < 1.005 * most);
}

TEST_CASE("searches along a front begin with the peaks of their neighbours",
          "[fronts][free][heavy]") {
  const std::string path = testing::source("problems/spine_cutter/free_front.toml");
  const FrontStudy study(problem_text(path), path,
                         {12, optim::ParetoMethod::Sweep, {"free.degree=5"}});
  const optim::Front front = optim::pareto(study.space(), study.options());
  check_certified(front);
  // One evaluation for each program; it was 8.4 of them for each search.
  CHECK(front.evaluations < 7.5 * static_cast<double>(front.tasks));
}

TEST_CASE("few knots that move come within a ten-thousandth", "[fronts][free][heavy]") {
  const Solved moving = solved("moving_front.toml", 8);
  check_certified(moving.front);
  CHECK(share_at_same_radii(moving) > 0.9999);
}

TEST_CASE("fronts of machines stay where they are with twice as many points", "[fronts][long]") {
  const char* file = GENERATE("die_press/front.toml", "sheet_delivery/front.toml");
  INFO(file);
  const std::string path = testing::source("problems/") + file;
  const auto front_with = [&](std::size_t points) {
    const FrontStudy study(problem_text(path), path, {points, optim::ParetoMethod::Sweep});
    optim::ProcessExecutor workers(study.space(), study.options().solve, 2);
    return study.run(workers);
  };
  const optim::Front few = front_with(6), many = front_with(12);
  check_certified(few);
  check_certified(many);
  CHECK(many.points.size() == 12);
  // No point of either lies below the other by more than the searches' tolerance.
  const auto none_beaten = [](const optim::Front& a, const optim::Front& b) {
    for (const auto& p : a.points) {
      for (const auto& q : b.points) {
        bool beaten = true;
        for (std::size_t i = 0; i < 2; ++i) {
          const double range = a.nadir[i] - a.ideal[i];
          beaten = beaten && q.costs[i] < p.costs[i] - 1e-4 * range;
        }
        CHECK_FALSE(beaten);
      }
    }
  };
  none_beaten(few, many);
  none_beaten(many, few);
}

}  // namespace camlaw::problems::free_front_test
