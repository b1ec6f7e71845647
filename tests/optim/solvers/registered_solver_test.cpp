// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "optim/search/exchange.h"
#include "problems/statement/solver_settings.h"
#include "problems/statement/statement.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::registered_solver_test {

using namespace search_tests;

namespace {

using Script = std::function<Solution(const Program&, const SolverOptions&, const WarmStart*)>;

const Solver& slsqp() { return find_solver("slsqp"); }

Script& script() {
  static Script now;
  return now;
}

/// Does what the script says. Without one it is slsqp: solvers stay registered, and other tests go
/// through all that there are.
class Scripted final : public Solver {
 public:
  explicit Scripted(std::string name, bool is_global = false)
      : name_(std::move(name)), is_global_(is_global) {}
  std::string name() const override { return name_; }
  bool is_global() const override { return is_global_; }
  std::optional<std::string> refusal(const Program& program) const override {
    return slsqp().refusal(program);
  }
  std::vector<NativeRule> native_rules() const override {
    return {{.name = "depth", .kind = NativeRule::Kind::Integer, .lower = 1, .upper = 9}};
  }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    if (script()) return script()(program, options, warm);
    SolverOptions common = options;
    common.native.clear();
    return slsqp().solve(program, common, warm);
  }

  std::string name_;
  bool is_global_;
};

/// Registered once, with a script until the end of the test.
class As {
 public:
  explicit As(Script now) {
    if (!is_registered("scripted")) {
      register_solver(std::make_unique<Scripted>("scripted-global", true));
      register_solver(std::make_unique<Scripted>("scripted"));
    }
    script() = std::move(now);
  }
  As(const As&) = delete;
  As& operator=(const As&) = delete;
  ~As() { script() = {}; }
};

Solution at(std::vector<double> y, Status status = Status::Solved) {
  Solution solution;
  solution.status = status;
  solution.message = "as the script says";
  solution.y = std::move(y);
  return solution;
}

/// bowl() with x + y >= 1: with y = 1 - x the slope 4 x - 7 is zero at (7/4, -3/4), where the
/// objective is 9/16 + 1/8 - 21/16 = -5/8.
Problem limited_bowl() {
  Problem problem = bowl();
  problem.constraints = {at_least("sum", sum(), 1)};
  return problem;
}

/// The answer to limited_bowl() where the solver does as the script says: whatever that is, the
/// verdict is true.
Found answer(Script now) {
  const As as(std::move(now));
  const Found found = optimise(limited_bowl(), {.solver = "scripted"}).found;
  const Assessment& a = found.assessment;
  REQUIRE(found.x.size() == 2);
  if (is_feasible(a)) CHECK(found.x[0] + found.x[1] >= 1 - 1e-6);
  CHECK(a.verdict != Verdict::Infeasible);
  if (a.verdict == Verdict::Certified) CHECK(a.objective.value == Approx(-0.625).epsilon(1e-6));
  return found;
}

/// The same of a script that ends at a point always.
Found answer(const Solution& solution) {
  return answer([&](const auto&...) { return solution; });
}

std::string refusal_to_register(std::unique_ptr<const Solver> solver) {
  try {
    register_solver(std::move(solver));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a solver that was registered is known wherever solvers are named", "[solvers]") {
  const As as({});
  CHECK(find_solver("scripted").name() == "scripted");
  CHECK(solver_names().back() == "scripted");
  CHECK(is_registered("scripted"));
  CHECK_FALSE(is_registered("ipopt"));
  CHECK(problems::find_solver_name("Scripted") == "scripted");
  CHECK_THROWS_WITH(find_solver("simplex"), Catch::Contains("scripted"));
  const Found found = optimise(limited_bowl(), {.solver = "scripted"}).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(-0.625).epsilon(1e-6));
  CHECK(found.solver == "scripted");
}

TEST_CASE("a name that is taken or cannot be one is refused", "[solvers]") {
  const As as({});
  const auto refused = [](const std::string& name) {
    return refusal_to_register(std::make_unique<Scripted>(name));
  };
  const std::size_t before = solver_names().size();
  CHECK(refused("scripted") == "a solver is called 'scripted' already");
  CHECK(refused("ipopt") == "a solver is called 'ipopt' already");
  CHECK(refused("auto") == "a solver cannot be called 'auto': the word has a meaning in [solver]");
  CHECK(refused("starts") ==
        "a solver cannot be called 'starts': the word has a meaning in [solver]");
  for (const char* name : {"", "Mine", "my solver", "1st", "-x", "mü", "a.b"}) {
    CHECK(contains(refused(name), "a name has the letters a to z, digits and -"));
  }
  CHECK(refusal_to_register(nullptr) == "no solver was given to register");
  CHECK(solver_names().size() == before);
}

TEST_CASE("solvers are registered and found in several threads at once", "[solvers]") {
  const Solver& before = find_solver("ipopt");
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([t] {
      const std::string name = "thread-" + std::to_string(t);
      for (int i = 0; i < 2; ++i) refusal_to_register(std::make_unique<Scripted>(name));
      for (int i = 0; i < 100; ++i) find_solver(name);
    });
  }
  for (std::thread& thread : threads) thread.join();
  const auto names = solver_names();
  CHECK(std::count_if(names.begin(), names.end(),
                      [](const auto& n) { return n.starts_with("thread-"); }) == 4);
  CHECK(&find_solver("ipopt") == &before);
}

TEST_CASE("a registered solver gets its own options, checked", "[solvers]") {
  NativeOptions got;
  const As as([&](const Program& program, const SolverOptions& options, const WarmStart*) {
    got = options.native;
    return slsqp().solve(program, {});
  });
  const auto run = [](const NativeOptions& native) {
    optimise(bowl(), {.solver = "scripted", .native = {{"scripted", native}}});
  };
  run({{"depth", std::int64_t{3}}});
  CHECK(got == NativeOptions{{"depth", std::int64_t{3}}});
  CHECK_THROWS_WITH(run({{"depth", std::int64_t{10}}}),
                    "scripted: option depth: 10 is not an integer from 1 to 9");
  CHECK_THROWS_WITH(run({{"dept", std::int64_t{1}}}),
                    "scripted has no option 'dept'; did you mean depth?");
}

TEST_CASE("a solver that claims an optimum where a limit is passed is not believed", "[solvers]") {
  const Found found = answer(at({0, 0}));
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.solver != "scripted");
}

TEST_CASE("a solver that claims an optimum where there is none is not believed", "[solvers]") {
  const Found found = answer(at({2, 2}));
  CHECK(is_feasible(found.assessment));
  CHECK(found.assessment.verdict == Verdict::Feasible);
}

TEST_CASE("a solver that comes back with what is not a number is not believed", "[solvers]") {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    const Found found = answer(at({0.5, bad}));
    CHECK(found.solver != "scripted");
    CHECK(is_feasible(found.assessment));
  }
}

TEST_CASE("a solver that comes back with too few or too many numbers is not believed",
          "[solvers]") {
  for (const std::vector<double>& y : std::vector<std::vector<double>>{{}, {1}, {1, 1, 1}}) {
    CHECK(is_feasible(answer(at(y)).assessment));
  }
}

TEST_CASE("a solver that leaves the box is drawn back into it", "[solvers]") {
  const Found found = answer(at({1e6, 1e6}));
  for (const double x : found.x) CHECK(std::abs(x) <= 3);
}

TEST_CASE("multipliers that cannot be some are dropped", "[solvers]") {
  int calls = 0;
  const Found found = answer([&](const Program& program, const SolverOptions&, const WarmStart* w) {
    CHECK((w == nullptr || w->rows.size() == program.rows()));
    Solution solution = slsqp().solve(program, {});
    solution.rows.assign(static_cast<std::size_t>(++calls) % 5, 1.0);
    solution.lower = {kNan};
    solution.iterations = calls % 2 == 0 ? -7 : std::numeric_limits<int>::max();
    solution.evaluations = -1;
    return solution;
  });
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.iterations >= 0);
}

TEST_CASE("a solver that throws ends no search but its own", "[solvers]") {
  const Found found = answer(
      [](const auto&...) -> Solution { throw std::runtime_error("no memory for my tables"); });
  CHECK(is_feasible(found.assessment));
  CHECK_NOTHROW(answer([](const auto&...) -> Solution { throw 3; }));
}

TEST_CASE("a solver that claims that nothing can be met, or that all falls, is not believed",
          "[solvers]") {
  for (const Status status : {Status::Infeasible, Status::Unbounded, Status::NonFiniteStart,
                              Status::Failed, Status::Stopped, Status::TimeLimit}) {
    INFO(to_string(status));
    const Found found = answer(at({0, 0}, status));
    CHECK(is_feasible(found.assessment));
    CHECK(found.assessment.verdict != Verdict::Failed);
  }
}

TEST_CASE("what the model throws through a solver is told", "[solvers]") {
  const As as([](const Program& program, const SolverOptions&, const WarmStart*) {
    program.objective(program.start());
    return Solution{};
  });
  bool armed = false;
  const Problem problem = valley_of(observed(rosenbrock(), [&](std::span<const double>) {
    if (armed) throw std::runtime_error("the table ends here");
  }));
  armed = true;
  const Found found = optimise(problem, {.solver = "scripted"}).found;
  CHECK(found.assessment.verdict == Verdict::Failed);
  CHECK(contains(found.assessment.reason, "the table ends here"));
}

TEST_CASE("a global solver that lies is not believed either", "[solvers]") {
  for (const Solution& lie :
       {at({0, 0}), at({kNan, 1}), at({1}), at({1e9, 1e9}), at({0, 0}, Status::Unbounded)}) {
    const As as([&](const auto&...) { return lie; });
    const Found found = optimise(limited_bowl(), {.solver = "scripted-global"}).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.assessment.objective.value == Approx(-0.625).epsilon(1e-6));
  }
}

TEST_CASE("a problem file names a registered solver and its options", "[solvers]") {
  const As as({});
  const std::string file =
      "mechanism = 'spine-cutter'\n[law]\nname = 'cosine'\n"
      "[solver]\nname = 'scripted'\n[solver.scripted]\ndepth = ";
  const auto solver = problems::read_problem(file + "3", "f.toml").solver;
  CHECK(solver.name == "scripted");
  CHECK(solver.native.at("scripted") == NativeOptions{{"depth", std::int64_t{3}}});
  CHECK_THROWS_WITH(problems::read_problem(file + "'deep'", "f.toml"),
                    "f.toml:7: solver.scripted.depth: scripted: option depth: 'deep' is not an "
                    "integer from 1 to 9");
}

TEST_CASE("the time limit ends a solver that lets the model's exceptions through", "[solvers]") {
  const As as([](const Program& program, const SolverOptions&, const WarmStart*) -> Solution {
    while (true) program.objective(program.start());
  });
  const Optimum optimum = optimise(bowl(), {.solver = "scripted", .time_limit = 0.2});
  CHECK(optimum.wall_s < 60);  // the solver itself would never end
  CHECK(optimum.found.assessment.verdict != Verdict::Certified);
}

}  // namespace camlaw::optim::registered_solver_test
