// SPDX-License-Identifier: MIT
#include "output/answers/rulers.h"

#include <atomic>
#include <catch2/catch.hpp>

namespace camlaw::cli::rulers_test {
namespace {

using Catch::Contains;

/// A problem and its answer.
struct Answered {
  problems::BoundProblem bound;
  optim::ProblemSpace space;
  optim::Optimum optimum;

  explicit Answered(const std::string& text)
      : bound(problems::read_problem(text, "f.toml")),
        space(bound.space()),
        optimum(optim::optimise(space)) {}
  Answer answer() const { return {bound, space, optimum, "auto", 1}; }
};

const std::string kFree = "mechanism = 'law'\n[law]\nname = 'free'\n[free]\ndegree = 2\n";
const std::string kLeast = "[objective]\nminimize = 'C'\n";

}  // namespace

TEST_CASE("a stopped search for rivals keeps what else is measured", "[rulers]") {
  const Answered answered(kFree + "knots = 6\n" + kLeast);
  const std::atomic<bool> stop = true;
  for (const optim::OptimiseOptions& search :
       {optim::OptimiseOptions{.stop = &stop}, optim::OptimiseOptions{.time_limit = -0.1}}) {
    const auto measured = rulers(answered.answer(), search);
    REQUIRE(measured);
    CHECK_FALSE(measured->finished);
    CHECK_FALSE(measured->best);
    CHECK(measured->least_acceleration);
    CHECK_THAT(text_of(rulers_document(answered.answer(), *measured)),
               Contains("figures of merit not finished"));
    CHECK(json_of(rulers_document(answered.answer(), *measured))["finished"] == false);
  }
  const auto measured = rulers(answered.answer(), {});
  REQUIRE(measured);
  CHECK(measured->finished);
  CHECK(measured->best);
  CHECK_THAT(text_of(rulers_document(answered.answer(), *measured)), !Contains("not finished"));
}

TEST_CASE("the least acceleration is told of laws from rest to rest alone", "[rulers]") {
  const Answered open(kFree + "knots = 6\nbegin = 'B'\nend = 'B'\n" + kLeast);
  const auto of_open = rulers(open.answer(), {});
  REQUIRE(of_open);
  CHECK_FALSE(of_open->least_acceleration);
  CHECK_THAT(text_of(rulers_document(open.answer(), *of_open)), !Contains("the least for"));
  CHECK(json_of(rulers_document(open.answer(), *of_open))["least_C_a_for_C_v"].is_null());
  const Answered rest(kFree + "knots = 6\n" + kLeast);
  Rulers of_rest = *rulers(rest.answer(), {});
  CHECK(of_rest.least_acceleration);
  REQUIRE(of_rest.least_moment);
  CHECK(*of_rest.least_moment >= 2.25 * (1 - 1e-12));
  CHECK(of_rest.peaks.max_dynamic_moment() >= *of_rest.least_moment * (1 - 1e-9));
  CHECK_THAT(text_of(rulers_document(rest.answer(), of_rest)), Contains("the least for"));
  of_rest.peaks.highest[0].value = 2.5;
  CHECK_THAT(text_of(rulers_document(rest.answer(), of_rest)),
             Contains("the least for a velocity of at most C_v"));
}

TEST_CASE("choices of the answer stay where they would make too many combinations", "[rulers]") {
  std::string values;
  for (int i = 0; i < 150; ++i) values += (i == 0 ? "'" : ", '") + std::to_string(400 + i) + " mm'";
  // Ten times as large: the listed cutters are none, but every one is possible.
  const Answered answered(
      "mechanism = 'spine-cutter'\n[law]\nname = 'free'\n[free]\ndegree = 2\nknots = 2\n"
      "[variables.cutter_diameter]\nvalues = [" +
      values + "]\n[objective]\nminimize = 'peak_inertia_force'\n");
  const auto measured = rulers(answered.answer(), {});
  REQUIRE(measured);
  CHECK(measured->held);
  CHECK(measured->best);
  CHECK_THAT(text_of(rulers_document(answered.answer(), *measured)),
             Contains("choices as in the answer"));
}

}  // namespace camlaw::cli::rulers_test
