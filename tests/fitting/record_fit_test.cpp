// SPDX-License-Identifier: MIT
// A machine's sizes from a curve that was recorded: curves computed for known sizes, with noise.
#include "fitting/records/record_fit.h"

#include <fmt/format.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/registry.h"
#include "optim/problem/deadline.h"
#include "problems/statement/bind.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::record_fit_test {
namespace {

using Catch::Contains;
using testing::Random;

/// A cam whose spring, mass and guide are unknown.
const char* const kCam = R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "30 mm"
speed = "250 rpm"
[[program.segments]]
angle = "90 deg"
law = "modified-sine"
[[program.segments]]
angle = "60 deg"
[[program.segments]]
angle = "120 deg"
law = "cycloidal"
[[program.segments]]
[variables.mass]
lower = "0.1 kg"
upper = "20 kg"
start = "1 kg"
[variables.spring_rate]
lower = "0 N/mm"
upper = "50 N/mm"
start = "5 N/mm"
[variables.guide_friction]
lower = 0
upper = 0.5
start = 0.01
)";

ProblemStatement cam() { return read_problem(kCam, "cam.toml"); }

/// The sizes that the record was made with.
ProblemStatement true_cam() {
  ProblemStatement machine = cam();
  for (const char* value : {"mass=2.4 kg", "spring_rate=8 N/mm", "guide_friction=0.12"}) {
    set_value(machine, value);
  }
  return machine;
}

RecordedCurve recorded(const std::string& response, int n, double noise, unsigned seed,
                       double turns = 1) {
  const ProblemStatement machine = true_cam();
  RecordedCurve record{find_response(*machine.mechanism, response), {}, {}};
  for (const optim::Response& curve : curves_of(machine)) {
    if (curve.name != response) continue;
    const auto trace = curve.curve().trace({});
    Random random(seed);
    for (int i = 0; i < n; ++i) {
      const double place = 360 * turns * (i + 0.5) / n;
      record.place.push_back(place);
      record.value.push_back(trace->at({std::fmod(place, 360)})[0] + noise * random.normal());
    }
  }
  return record;
}

struct True {
  std::size_t parameter;
  double value;
};
const std::vector<True> kTrue{{0, 2.4}, {1, 8}, {2, 0.12}};

}  // namespace

TEST_CASE("mass, stiffness and friction come back from force and torque", "[record]") {
  for (const char* response : {"contact_force", "drive_torque"}) {
    INFO(response);
    const RecordFit exact = fit_record(cam(), recorded(response, 360, 0, 1));
    CHECK(exact.distrust.empty());
    for (const auto& [k, value] : kTrue) {
      CHECK(exact.fit.parameters[k].value == Approx(value).epsilon(1e-7));
      CHECK(exact.fit.parameters[k].identifiable);
    }
    const std::vector<double> constants = true_cam().constants;
    for (std::size_t i = 0; i < constants.size(); ++i) {
      CHECK(exact.machine.constants[i] == Approx(constants[i]).epsilon(1e-7));
    }
  }
}

TEST_CASE("intervals of a machine's sizes hold what they say", "[record]") {
  int within = 0, count = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const RecordFit fit = fit_record(cam(), recorded("drive_torque", 360, 0.05, seed));
    CHECK(fit.distrust.empty());
    CHECK(fit.fit.sigma == Approx(0.05).epsilon(0.2));
    for (const auto& [k, value] : kTrue) {
      const auto& p = fit.fit.parameters[k];
      within += p.low <= value && value <= p.high;
      ++count;
    }
  }
  // 95 % of 180, less and more 3 deviations of that count.
  CHECK(within >= 171 - 9);
  CHECK(within <= 171 + 9);
}

TEST_CASE("a fit to a record keeps its time, and ends where it is stopped", "[record]") {
  const RecordedCurve record = recorded("drive_torque", 20000, 0.05, 1);
  const RecordFit cut = fit_record(cam(), record, {.time_limit = 1e-3});
  CHECK_THAT(cut.distrust, Contains("the time limit of 0.001 s was reached"));
  CHECK(cut.model.size() == record.place.size());
  const RecordFit left = fit_record(cam(), record, {.time_limit = 60.0, .time_spent = 60.0});
  CHECK_THAT(left.distrust, Contains("the time limit of 60 s was reached"));
  std::atomic<bool> stop = true;
  CHECK_THROWS_AS(fit_record(cam(), record, {.stop = &stop}), optim::Interrupted);
  stop = false;
  const RecordFit watched = fit_record(cam(), recorded("drive_torque", 360, 0.05, 1),
                                       {.time_limit = 1000, .stop = &stop});
  const RecordFit plain = fit_record(cam(), recorded("drive_torque", 360, 0.05, 1));
  for (const auto& [k, value] : kTrue) {
    CHECK(watched.fit.parameters[k].value == plain.fit.parameters[k].value);
  }
  CHECK(watched.machine.stop == nullptr);
}

TEST_CASE("several turns, wrong zeros and outliers", "[record][long]") {
  RecordedCurve record = recorded("drive_torque", 1500, 0.02, 4, 3);
  for (double& place : record.place) place += 2.5;
  for (double& value : record.value) value -= 0.4;
  const RecordFit plain = fit_record(cam(), record);
  CHECK_THAT(plain.distrust, Contains("not noise"));
  RecordFitOptions options{.place_shift = true, .value_shift = true};
  const RecordFit shifted = fit_record(cam(), record, options);
  CHECK(shifted.distrust.empty());
  const auto& p = shifted.fit.parameters;
  CHECK(p[3].value == Approx(2.5).margin(0.05));
  CHECK(p[4].value == Approx(-0.4).margin(0.01));
  for (const auto& [k, value] : kTrue) CHECK(p[k].value == Approx(value).epsilon(0.02));
  for (std::size_t i = 0; i < record.value.size(); i += 10) record.value[i] += 30;
  CHECK_THAT(fit_record(cam(), record, options).distrust,
             Contains("distort the fit") && Contains("by up to"));
  options.loss = optim::Loss::Cauchy;
  const RecordFit robust = fit_record(cam(), record, options);
  for (const auto& [k, value] : kTrue) {
    CHECK(robust.fit.parameters[k].value == Approx(value).epsilon(0.03));
  }
}

TEST_CASE("sizes that the record does not show are said not to be determined", "[record]") {
  // The torque's statics do not tell the mass from the density of nothing that moves.
  const ProblemStatement machine = read_problem(
      std::string(kCam) + "[variables.density]\nlower = '1000 kg/m3'\nupper = '9000 kg/m3'\n",
      "cam.toml");
  const RecordFit fit = fit_record(machine, recorded("drive_torque", 360, 0.01, 1));
  CHECK_FALSE(fit.fit.parameters[3].identifiable);
  CHECK(fit.fit.parameters[0].identifiable);
  CHECK_THAT(fit.distrust, Contains("density"));
}

TEST_CASE("the recorded column is found by its curve's name", "[record]") {
  const Mechanism& roller = find_mechanism("disc-cam-roller");
  const auto table = [](const std::string& header) {
    return parse_samples(header + "\n0,1,2\n90,3,4\n", "record.csv");
  };
  const RecordedCurve torque =
      recorded_curve(table("Cam_Angle [rad], Drive torque [N mm], force [N]"), roller);
  CHECK(torque.response.name == "drive_torque");
  CHECK(torque.place[1] == Approx(90 * 180 / 3.14159265358979));
  CHECK(torque.value[1] == Approx(3e-3));
  const auto said = [&](const std::string& header, std::optional<std::string> name = {}) {
    return testing::complaint([&] { recorded_curve(table(header), roller, name); });
  };
  CHECK_THAT(said("angle [deg], torque [N m], lift [mm]"),
             Contains("record.csv") && Contains("drive_torque"));
  CHECK_THAT(said("angle [deg], drive_torque [N m], follower_force [N]"),
             Contains("--response") && Contains("follower_force"));
  CHECK_THAT(said("angle [deg], drive_torque [mm], b"), Contains("'drive_torque'"));
  CHECK_THAT(said("angle [deg], drive_torque [N m], b", "power"), Contains("'power'"));
  CHECK_THAT(said("angle [deg], mass [kg], b", "mass"), Contains("is not a curve"));
  CHECK(recorded_curve(table("angle [deg], drive_torque [N m], follower_force [N]"), roller,
                       "follower_force")
            .response.name == "follower_force");
}

TEST_CASE("machines that cannot be fitted are refused by what is missing", "[record]") {
  const RecordedCurve record = recorded("drive_torque", 100, 0, 1);
  const std::string text = kCam;
  const auto said = [&](const std::string& toml, const RecordedCurve& of) {
    return testing::complaint([&] { fit_record(read_problem(toml, "cam.toml"), of); });
  };
  CHECK_THAT(said(text.substr(0, text.find("[variables")), record), Contains("[variables]"));
  CHECK_THAT(said(text, recorded("drive_torque", 3, 0, 1)),
             Contains("3 rows") && Contains("at least 4"));
  std::string listed = text;
  listed.replace(listed.find("lower = \"0.1 kg\"\nupper = \"20 kg\"\nstart = \"1 kg\""), 47,
                 "values = ['1 kg', '2 kg']");
  CHECK_THAT(said(listed, record), Contains("'mass'") && Contains("continuous"));
}

}  // namespace camlaw::problems::record_fit_test
