// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/registry.h"
#include "tests/machines/system_fixture.h"

/// Breaks that move with the design: the places that stand at them move along.
namespace camlaw::problems::joints_test {
namespace {

using testing::check_derivatives, testing::design_of, testing::response_of, testing::TestDesign;

/// The value of a curve at its k-th break from the left, for any design.
double at_break(const optim::Curve& curve, std::size_t k, bool from_left,
                const std::vector<double>& x) {
  const auto trace = curve.trace(x);
  return trace->at({trace->breaks()[k], from_left})[0];
}

/// The row of the place that is tied to a break, beside the curve there, here and a step away.
void check_joint(const optim::Curve& curve, std::size_t k, const std::vector<double>& x) {
  const double angle = curve.trace(x)->breaks()[k];
  for (const bool from_left : {true, false}) {
    INFO("break " << k << (from_left ? " from the left" : " from the right"));
    const optim::Place place = curve.tied({angle, from_left}, x);
    REQUIRE(place.joint >= 0);
    const optim::Function row = curve.at(place);
    const auto joint = curve.joint_angle(place.joint);
    REQUIRE(joint);
    for (const double factor : {1.0, 1.001, 0.98}) {
      std::vector<double> moved = x;
      for (double& value : moved) value *= factor;
      CHECK(row.value(moved) == Approx(at_break(curve, k, from_left, moved)).epsilon(1e-11));
      CHECK(joint->value(moved) == Approx(curve.trace(moved)->breaks()[k]).epsilon(1e-13));
    }
    check_derivatives(row, x);
    check_derivatives(*joint, x);
  }
}

/// A balancing cam whose lift-off varies from a start on.
std::string lift_off_problem(const std::string& start, const std::string& asked) {
  return R"(
mechanism = "balancing-cam"
[constants]
springs = 50
preload_ratio = 1.2
[variables.lift_off]
lower = "5 deg"
upper = "40 deg"
start = ")" +
         start + "\"\n" + asked;
}

optim::Optimum solved(const std::string& text) {
  return optim::optimise(BoundProblem(read_problem(text, "joints")).space());
}

}  // namespace

TEST_CASE("places at a law's joints move with the law", "[joints]") {
  const Mechanism& cutter = find_mechanism("spine-cutter");
  const TestDesign design = design_of(cutter, "scca", {"a", "b"}, {"stroke", "block_speed"});
  const auto response = response_of(cutter, "inertia_force", design.binding);
  const optim::Curve& curve = response.curve();
  const std::size_t pieces = (curve.trace(design.x)->breaks().size() - 1) / 2;
  REQUIRE(pieces > 3);
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}, pieces + 1, pieces + 2}) {
    check_joint(curve, k, design.x);
  }
  // Where the stretches meet nothing moves, and that is known; within a piece there is no joint.
  const optim::Place meeting = curve.tied({180}, design.x);
  REQUIRE(meeting.joint >= 0);
  const auto angle = curve.joint_angle(meeting.joint);
  REQUIRE(angle);
  CHECK(angle->inputs().empty());
  CHECK(angle->value(design.x) == 180);
  CHECK(curve.tied({1.234}, design.x).joint < 0);
}

TEST_CASE("places of a cam's coordinates move with the law's joints, and their own angle with them",
          "[joints]") {
  const Mechanism& cam = find_mechanism("disc-cam-roller");
  const TestDesign design = design_of(cam, "scca", {"a", "b"}, {"base_radius"});
  for (const char* name : {"pitch_x", "profile_y"}) {
    INFO(name);
    const auto response = response_of(cam, name, design.binding);
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
      check_joint(response.curve(), k, design.x);
    }
  }
}

TEST_CASE("places of an elastic train's curves move with the law's joints", "[joints]") {
  const Mechanism& train = find_mechanism("follower-train");
  const TestDesign design = design_of(train, "scca", {"a", "b"}, {"stroke", "stiffness"});
  for (const char* name : {"deviation", "mass_acceleration"}) {
    INFO(name);
    const auto response = response_of(train, name, design.binding);
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
      check_joint(response.curve(), k, design.x);
    }
  }
}

TEST_CASE("places at a mechanism's breaks move with it", "[joints]") {
  const Mechanism& balancing = find_mechanism("balancing-cam");
  TestDesign design = design_of(balancing, "constant-velocity", {}, {"lift_off", "inertia"});
  for (std::size_t k = 0; k < 2; ++k) {
    const bool angle = design.binding.parameters[k] == balancing.parameter("lift_off");
    if (angle) design.x[design.binding.variables[k]] = 17;
  }
  const auto response = response_of(balancing, "residual_torque", design.binding);
  check_joint(response.curve(), 1, design.x);
  // A curve that does not break at the lift-off is not tied to it.
  const auto drive = response_of(balancing, "drive_torque", design.binding);
  CHECK(drive.curve().tied({17, true}, design.x).joint < 0);
}

TEST_CASE("a peak at a break that moves is followed to where the limit is met", "[joints][long]") {
  // The greatest torque stands at the end of the lift-off and rises with it.
  const auto optimum = solved(lift_off_problem("25 deg", R"([objective]
maximize = "lift_off"
[[constraints]]
response = "residual_torque"
upper = "9 N m"
)"));
  const auto& assessment = optimum.found.assessment;
  CHECK(assessment.verdict == optim::Verdict::Certified);
  // Where M_d reaches 9 N m first, by bisection on the drive's torque.
  const Mechanism& balancing = find_mechanism("balancing-cam");
  const TestDesign design = design_of(balancing, "constant-velocity", {}, {});
  const auto drive = response_of(balancing, "drive_torque", design.binding).curve().trace({});
  const double first =
      testing::root([&](double angle) { return drive->at({angle})[0] - 9; }, 5, 30);
  CHECK(optimum.found.x[0] == Approx(first).epsilon(1e-7));
  CHECK(assessment.limits[0].multiplier == Approx(1 / drive->at({first})[1]).epsilon(1e-5));
}

TEST_CASE("the coefficient of balance has its slope where its peak stands at the lift-off",
          "[joints]") {
  const auto optimum = solved(lift_off_problem("20 deg", R"([objective]
maximize = "balancing_coefficient"
)"));
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.assessment.objective.value == Approx(9.12976277).epsilon(1e-8));
}

TEST_CASE("limits of validity are limits of every problem", "[joints]") {
  const std::string text = R"(
mechanism = "balancing-cam"
[variables.springs]
values = [20, 30, 40, 50]
[objective]
minimize = "springs"
)";
  const ProblemStatement open = read_problem(text, "open");
  REQUIRE(open.constraints.size() == 1);
  CHECK(open.constraints[0].response.name == "flattening");
  CHECK(open.constraints[0].upper == 1.0);
  const auto limit = [&](const char* upper) {
    return read_problem(text + "[[constraints]]\nresponse = \"flattening\"\nupper = " + upper, "f")
        .constraints;
  };
  REQUIRE(limit("0.75\n").size() == 1);
  CHECK(limit("0.75\n")[0].upper == 0.75);
  CHECK(limit("1.2\n").size() == 2);
  // Flattening 0.7036 at 50 springs goes with 1 / sqrt(i): 1 at 24.75.
  CHECK(solved(text).found.assessment.objective.value == 30);
}

}  // namespace camlaw::problems::joints_test
