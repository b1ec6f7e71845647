// SPDX-License-Identifier: MIT
// The list of all combinations that a search looked at.
#include <catch2/catch.hpp>

#include "optim/verdict/verdict.h"
#include "output/answers/optimum_output.h"

namespace camlaw::cli::combinations_test {
namespace {

using Catch::Contains;

}  // namespace

TEST_CASE("combinations for which there is no time are as the search left them", "[program]") {
  const problems::BoundProblem bound(problems::read_problem(R"(
mechanism = "spine-cutter"
[law]
name = ["cycloidal", "poly-3-4-5", "modified-sine"]
[variables.crossover]
lower = 0.4
upper = 0.6
[objective]
minimize = "peak_inertia_force"
)",
                                                            "laws.toml"));
  const optim::ProblemSpace space = bound.space();
  const optim::Optimum optimum = optim::optimise(space);
  REQUIRE(optim::is_feasible(optimum.found.assessment));
  const Answer answer{bound, space, optimum, "auto", 1};
  const Document judged = combinations_document(answer);
  CHECK(json_of(judged)["not_judged"] == 0);
  CHECK_THAT(text_of(judged), !Contains("as the search left"));
  const Document left = combinations_document(answer, nullptr, optim::Deadline(1, nullptr, 2));
  const Json json = json_of(left);
  CHECK(json["not_judged"] == 2);  // the answer's own row has its verdict
  CHECK_THAT(text_of(left),
             Contains("the time limit of 1 s was reached: 2 of 3 combinations are as "
                      "the search left them"));
  int unproved = 0;
  for (const Json& row : json["table"]) {
    if (row["limits"] != "met, not proved") continue;
    ++unproved;
    CHECK(row["verdict"] == "feasible");
  }
  CHECK(unproved == 2);
}

}  // namespace camlaw::cli::combinations_test
