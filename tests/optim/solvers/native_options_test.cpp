// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "optim/solvers/solver.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::native_options_test {

using namespace search_tests;

namespace {

Program rosenbrock_program() { return {{{-5, 5, -1.2, 1}, {-5, 5, 1, 1}}, rosenbrock(), 1, 1, {}}; }

Solution solved(const std::string& solver, const NativeOptions& native) {
  return find_solver(solver).solve(rosenbrock_program(),
                                   {.max_evaluations = 2000, .native = native});
}

/// What is said against an option; empty where it is accepted.
std::string complaint(const std::string& solver, const std::string& name,
                      const NativeValue& value) {
  try {
    check_native_options(find_solver(solver), {{name, value}});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an option is refused with its solver, its name and what is accepted", "[solvers]") {
  const std::int64_t two = 2;
  CHECK(complaint("ipopt", "mu_stratgy", "adaptive") ==
        "ipopt has no option 'mu_stratgy'; did you mean mu_strategy, mu_oracle or "
        "pardiso_matching_strategy?");
  CHECK(contains(complaint("ipopt", "zzzzzz", two), "ipopt has no option 'zzzzzz'; it has "));
  CHECK(complaint("ipopt", "mu_strategy", "adaptve") ==
        "ipopt: option mu_strategy: 'adaptve' is not one of monotone, adaptive");
  CHECK(complaint("ipopt", "mu_strategy", two) ==
        "ipopt: option mu_strategy: 2 is not one of monotone, adaptive");
  CHECK(complaint("ipopt", "max_soc", 2.5) ==
        "ipopt: option max_soc: 2.5 is not an integer from 0 to 2147483647");
  CHECK(complaint("ipopt", "max_soc", std::int64_t{1} << 40) ==
        "ipopt: option max_soc: 1099511627776 is not an integer from 0 to 2147483647");
  CHECK(complaint("ipopt", "mu_init", "much") ==
        "ipopt: option mu_init: 'much' is not a number above 0");
  CHECK(complaint("ipopt", "mu_init", 0.0) == "ipopt: option mu_init: 0 is not a number above 0");
  CHECK(complaint("ipopt", "bound_frac", 0.75) ==
        "ipopt: option bound_frac: 0.75 is not a number above 0 and up to 0.5");
  CHECK(complaint("ipopt", "mu_init", kNan) ==
        "ipopt: option mu_init: nan is not a number above 0");
  CHECK(complaint("crs2", "popula", two) ==
        "crs2 has no option 'popula'; did you mean population?");
  CHECK(complaint("crs2", "zzz", two) == "crs2 has no option 'zzz'; use population");
  CHECK(complaint("direct-l", "zzz", two) == "direct-l has no option 'zzz'; it takes none");
  CHECK(complaint("crs2", "population", std::int64_t{0}) ==
        "crs2: option population: 0 is not an integer from 1 to 1000000");
}

TEST_CASE("a number may be given as an integer", "[solvers]") {
  CHECK(complaint("ipopt", "mu_init", std::int64_t{1}) == "");
  CHECK(solved("ipopt", {{"mu_init", std::int64_t{1}}}).status == Status::Solved);
}

TEST_CASE("options that camlaw relies on are refused with the reason", "[solvers]") {
  const std::string standard_output =
      "standard output is reserved for the answer, and a search writes no files";
  CHECK(complaint("ipopt", "print_level", std::int64_t{5}) ==
        "ipopt: option print_level cannot be set: " + standard_output);
  for (const char* name :
       {"print_user_options", "output_file", "sb", "file_print_level", "option_file_name", "tol",
        "max_iter", "max_cpu_time", "acceptable_tol", "nlp_scaling_method", "obj_scaling_factor",
        "hessian_approximation", "limited_memory_max_history", "hessian_constant",
        "warm_start_init_point", "derivative_test", "diverging_iterates_tol",
        "skip_finalize_solution_call"}) {
    INFO(name);
    CHECK(contains(complaint("ipopt", name, "x"), "cannot be set: "));
  }
  for (const char* name : {"dual_tolerance", "log_level", "maximum_iterations", "maximum_seconds",
                           "primal_tolerance"}) {
    CHECK(contains(complaint("clp", name, 1.0), "cannot be set: "));
  }
  for (const std::string& solver : solver_names()) {
    const bool has_none = solver == "interior" || solver == "sequential";
    if (solver == "ipopt" || solver == "clp" || has_none || is_registered(solver)) continue;
    INFO(solver);
    for (const char* name : {"maxeval", "maxtime", "stopval", "ftol_rel", "xtol_rel"}) {
      CHECK(contains(complaint(solver, name, 1.0), "cannot be set: "));
    }
  }
}

TEST_CASE("every name that is reserved is one of Ipopt's", "[solvers]") {
  const auto rules = ipopt_solver().native_rules();
  CHECK(rules.size() > 200);
  const auto reserved = std::count_if(rules.begin(), rules.end(),
                                      [](const NativeRule& r) { return !r.reserved.empty(); });
  CHECK(reserved > 40);
  CHECK(reserved < 80);
}

TEST_CASE("Ipopt's options reach Ipopt", "[solvers]") {
  const Solution plain = solved("ipopt", {});
  CHECK(solved("ipopt", {{"mu_strategy", "monotone"}}).iterations == plain.iterations);
  const Solution adaptive = solved("ipopt", {{"mu_strategy", "adaptive"}});
  CHECK(adaptive.status == Status::Solved);
  CHECK(adaptive.iterations != plain.iterations);
  CHECK(solved("ipopt", {{"alpha_red_factor", 0.3}}).evaluations != plain.evaluations);
}

TEST_CASE("a linear solver that Ipopt cannot find is a failure in words", "[solvers]") {
  for (const char* name : {"ma57", "ma27", "pardiso", "wsmp", "custom"}) {
    INFO(name);
    const Solution s = solved("ipopt", {{"linear_solver", name}});
    if (s.status == Status::Solved) continue;  // it is there
    CHECK(s.status == Status::Failed);
    CHECK(s.message ==
          std::string("this build of Ipopt cannot do what its options ask for, linear_solver ") +
              name);
  }
}

TEST_CASE("Ipopt with relaxed bounds ends outside them, and a search does not", "[solvers]") {
  Program edge({{1, 2, 1.5, 1}}, linear({0}, [](const auto& u) { return 1.0 * u[0]; }), 1, 1, {});
  const Solution s = ipopt_solver().solve(edge, {.native = {{"bound_relax_factor", 1e-6}}});
  REQUIRE(s.y.size() == 1);
  CHECK(s.y[0] < 1 - 1e-7);
  Problem problem;
  problem.variables = {variable("x", 1, 2, 1.5)};
  problem.objectives = {least(linear({0}, [](const auto& u) { return 1.0 * u[0]; }))};
  const Found found =
      optimise(problem, {.solver = "ipopt", .native = {{"ipopt", {{"bound_relax_factor", 1e-6}}}}})
          .found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x == Point{1});
}

TEST_CASE("NLopt's options reach NLopt", "[solvers]") {
  const auto differs = [](const std::string& solver, const NativeOptions& native) {
    INFO(solver);
    const Solution plain = solved(solver, {}), other = solved(solver, native);
    CHECK(other.status != Status::Failed);
    CHECK((other.y != plain.y || other.evaluations != plain.evaluations));
  };
  for (const char* solver : {"crs2", "isres", "esch", "mlsl"}) {
    differs(solver, {{"population", std::int64_t{500}}});
    CHECK(solved(solver, {{"population", std::int64_t{1}}}).status != Status::Failed);
  }
  differs("lbfgs", {{"vector_storage", std::int64_t{2}}});
  differs("mlsl", {{"vector_storage", std::int64_t{1}}});
  for (const char* solver : {"cobyla", "bobyqa"}) {
    differs(solver, {{"initial_step", 0.01}});
    CHECK(solved(solver, {{"initial_step", 1e9}}).status != Status::Failed);  // at most the box
  }
  for (const char* solver : {"mma", "ccsaq"}) differs(solver, {{"inner_maxeval", std::int64_t{1}}});
  for (const char* solver : {"slsqp", "mma", "lbfgs", "cobyla", "bobyqa"}) {
    differs(solver, {{"xtol_abs", 0.1}});
    differs(solver, {{"ftol_abs", 0.5}});
  }
}

TEST_CASE("options have effect where their solver runs, and nowhere else", "[solvers]") {
  const std::map<std::string, NativeOptions> native{{"ipopt", {{"mu_strategy", "adaptive"}}}};
  const Problem problem = valley_of(rosenbrock());
  const auto run = [&](const std::string& solver, bool with) {
    OptimiseOptions options{.solver = solver, .starts = 1};
    if (with) options.native = native;
    return optimise(problem, options);
  };
  CHECK(same_bits(numbers(run("slsqp", true)), numbers(run("slsqp", false))));
  CHECK(run("slsqp", true).found.iterations == run("slsqp", false).found.iterations);
  CHECK(run("ipopt", true).found.evaluations != run("ipopt", false).found.evaluations);
  CHECK(run("ipopt", true).found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("a search refuses options that a solver does not accept", "[solvers]") {
  const auto run = [](std::map<std::string, NativeOptions> native) {
    optimise(bowl(), {.solver = "slsqp", .native = std::move(native)});
  };
  CHECK_THROWS_WITH(run({{"ipopt", {{"max_iter", std::int64_t{3}}}}}),
                    Catch::Contains("ipopt: option max_iter cannot be set"));
  CHECK_THROWS_WITH(run({{"ipot", {}}}), Catch::Contains("'ipot' is not a solver"));
  CHECK_THROWS_AS(solved("slsqp", {{"population", std::int64_t{3}}}), std::invalid_argument);
}

}  // namespace camlaw::optim::native_options_test
