// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/model/shaft_curve.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/scales.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/law_files/json_text.h"
#include "problems/results/design_json.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"
#include "problems/statement/shaft_cams.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"
#include "tests/problems/shaft_fixture.h"

/// Several cams on one shaft.
namespace camlaw::problems::shaft_test {

using Catch::Contains, testing::complaint;

namespace {

/// A cam with a slide, its tables named as those of a file of its own, or of a cam on a shaft.
std::string cam(const std::string& before, const std::string& law, double rise,
                const std::string& constants = "") {
  return fmt::format(
      "[{0}constants]\nstroke = 30\nbase_radius = 60\nroller_radius = 8\nmass = 2\n"
      "spring_rate = 4\nspring_preload = 80\n{3}"
      "[[{0}program.segments]]\nname = 'rise'\nangle = {2}\nlaw = '{1}'\n"
      "[[{0}program.segments]]\nname = 'high'\nangle = 40\n"
      "[[{0}program.segments]]\nname = 'return'\nangle = 110\nlaw = '{1}'\n"
      "[[{0}program.segments]]\nname = 'low'\n",
      before, law, rise, constants);
}

const std::string kRoller = "mechanism = 'disc-cam-roller'\n";

std::string on_shaft(const std::string& name, const std::string& law, double rise,
                     const std::string& constants = "") {
  return "[cams." + name + "]\n" + kRoller + cam("cams." + name + ".", law, rise, constants);
}

const std::string kSpeedOfShaft = "[constants]\nspeed = 200\n";

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

/// The trace of a curve of a statement at its starts.
std::unique_ptr<optim::Trace> trace_of(const ProblemStatement& statement,
                                       const std::string& curve) {
  for (const optim::Response& response : curves_of(statement)) {
    if (response.name == curve) return response.curve().trace({});
  }
  FAIL("no curve " << curve);
  return nullptr;
}

/// The amplitude of a harmonic of a curve over the turn.
double amplitude(const optim::Trace& trace, int harmonic) {
  constexpr int kSteps = 7200;
  double cosine = 0, sine = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 360.0 * (i + 0.5) / kSteps;
    const double turned = harmonic * angle * std::numbers::pi / 180;
    const double value = trace.at({angle})[0];
    cosine += value * std::cos(turned) * 2 / kSteps;
    sine += value * std::sin(turned) * 2 / kSteps;
  }
  return std::hypot(cosine, sine);
}

double in_turn(double angle) { return angle - 360 * std::floor(angle / 360); }

/// Two cams, the second with a phase and sizes that vary, and a distance between their followers.
std::string two_cams(const std::string& variables, const std::string& rest) {
  return kSpeedOfShaft + on_shaft("slide", "modified-sine", 100) +
         on_shaft("bar", "cycloidal", 80, "phase = 140\n") + variables +
         "[responses.gap]\nunit = 'mm'\nformula = 'sqrt((50 mm - slide.displacement)^2 + (40 mm - "
         "bar.displacement)^2)'\n" +
         rest;
}

}  // namespace

TEST_CASE("two equal cams half a turn apart cancel the odd harmonics of the torque", "[shaft]") {
  const ProblemStatement pair = read(kSpeedOfShaft + on_shaft("a", "cycloidal", 90) +
                                     on_shaft("b", "cycloidal", 90, "phase = 180\n"));
  const auto both = trace_of(pair, "shaft_torque"), one = trace_of(pair, "a.drive_torque");
  const double size = amplitude(*one, 1);
  REQUIRE(size > 1);
  for (const int odd : {1, 3, 5, 7, 9}) {
    INFO(odd);
    CHECK(amplitude(*both, odd) < 1e-12 * size);
  }
  for (const int even : {2, 4, 6}) {
    INFO(even);
    CHECK(amplitude(*both, even) == Approx(2 * amplitude(*one, even)).epsilon(1e-12));
  }
}

TEST_CASE("the shaft's torque is the sum of what files of single cams say", "[shaft]") {
  const std::string speed = "speed = 200\n";
  const auto slide = read(kRoller + cam("", "modified-sine", 100, speed));
  const auto bar = read(kRoller + cam("", "cycloidal", 80, speed));
  const ProblemStatement shaft = read(two_cams("", ""));
  const auto of_slide = trace_of(slide, "drive_torque"), of_bar = trace_of(bar, "drive_torque");
  const auto torque = trace_of(shaft, "shaft_torque"), power = trace_of(shaft, "shaft_power");
  std::vector<optim::Place> places;
  std::vector<double> sums;
  for (double angle = 0.13; angle < 360; angle += 0.7137) {
    const auto a = of_slide->at({angle}), b = of_bar->at({in_turn(angle - 140)});
    const auto sum = torque->at({angle});
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(sum[k] == Approx(a[k] + b[k]).epsilon(1e-12).margin(1e-12));
    }
    const double omega = 200 * 2 * std::numbers::pi / 60;
    CHECK(power->at({angle})[0] == Approx(omega * sum[0]).epsilon(1e-12).margin(1e-12));
    places.push_back({angle});
    sums.push_back(sum[0]);
  }
  const std::vector<double> many = torque->values(places);
  for (std::size_t i = 0; i < sums.size(); ++i) CHECK(many[i] == Approx(sums[i]).margin(1e-10));
}

TEST_CASE("what a cam has on the shaft is what it has alone", "[shaft]") {
  const auto bar = read(kRoller + cam("", "cycloidal", 80, "speed = 200\nface_width = 15\n"));
  const ProblemStatement shaft =
      read(kSpeedOfShaft + on_shaft("slide", "modified-sine", 100) +
           on_shaft("bar", "cycloidal", 80, "phase = 140\nface_width = 15\n"));
  const auto all = evaluate(shaft);
  for (const EvaluatedResponse& own : evaluate(bar)) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& r) { return r.name == "bar." + own.name; });
    INFO(own.name);
    REQUIRE(found != all.end());
    if (std::isnan(own.value) || std::isnan(own.highest)) continue;
    CHECK(found->value == own.value);
    CHECK(found->highest == own.highest);
    CHECK(found->lowest_at == own.lowest_at);
    CHECK(found->proved == own.proved);
  }
  const ProblemStatement alone = cam_alone(shaft, find_cam(shaft, "bar"));
  CHECK(evaluate_response(alone, *find_response(*alone.mechanism, "torque_rms").response).value ==
        evaluate_response(bar, *find_response(*bar.mechanism, "torque_rms").response).value);
}

TEST_CASE("the ripple is what the torque ranges over, and both are proved", "[shaft]") {
  const auto all = evaluate(read(two_cams("", "")));
  const auto of = [&](const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
  };
  CHECK(of("shaft_torque").proved);
  CHECK(of("gap").proved);
  CHECK(of("torque_ripple").proved);
  CHECK(of("torque_ripple").value ==
        Approx(of("shaft_torque").highest - of("shaft_torque").lowest).epsilon(1e-8));
}

TEST_CASE("derivatives by phases and sizes of several cams agree with differences", "[shaft]") {
  const std::string variables =
      "[cams.slide.variables.phase]\nlower = -60\nupper = 60\nstart = 11.3\n"
      "[cams.slide.variables.load]\nlower = 0\nupper = 90\nstart = 40\n"
      "[cams.bar.variables.offset]\nlower = -5\nupper = 9\nstart = 2\n"
      "[cams.bar.variables.rise_angle]\nlower = 60\nupper = 100\nstart = 81\n"
      "[variables.speed]\nlower = 50\nupper = 400\nstart = 200\n";
  std::string text = two_cams(variables, "");
  text.erase(text.find("[constants]\nspeed = 200\n"),
             std::string("[constants]\nspeed = 200\n").size());
  const BoundProblem bound(read(text));
  const Binding binding = bound.binding({});
  std::vector<double> x;
  for (const VariableStatement& v : bound.statement().variables) x.push_back(v.start);
  for (const std::string name : {"shaft_torque", "gap", "shaft_power"}) {
    const optim::Response response =
        response_of(bound.statement(), find_response(*bound.statement().mechanism, name), binding);
    CHECK(response.curve().breaks_move());
    for (const double angle : {5.7, 63.1, 133.9, 161.3, 200.2, 290.5, 333.3}) {
      INFO(name << " at " << angle);
      testing::check_derivatives(response.curve().at({angle}), x, 1e-5, 1e-5);
      const std::vector<double> slopes = response.curve().slope_gradient({angle}, x);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double by = 1e-4 * std::max(0.1, std::abs(x[i]));
        const double difference = testing::slope(
            [&](double t) {
              std::vector<double> y = x;
              y[i] += t;
              return response.curve().trace(y)->at({angle})[1];
            },
            by);
        CHECK(slopes[i] == Approx(difference).epsilon(1e-5).margin(1e-6));
      }
    }
  }
}

TEST_CASE("a place that is tied to a cam's break turns with the cam's phase", "[shaft]") {
  const std::string variables =
      "[cams.bar.variables.phase]\nlower = 60\nupper = 300\nstart = 141.7\n";
  std::string text = two_cams(variables, "");
  text.erase(text.find("phase = 140\n"), std::string("phase = 140\n").size());
  const BoundProblem bound(read(text));
  const optim::Response torque =
      response_of(bound.statement(), find_response(*bound.statement().mechanism, "shaft_torque"),
                  bound.binding({}));
  const std::vector<double> x{141.7};
  for (const double own : {0.0, 80.0, 120.0, 230.0}) {
    for (const bool from_left : {true, false}) {
      INFO(own << " " << from_left);
      const double angle = in_turn(own + x[0]);
      const optim::Place place = torque.curve().tied({angle, from_left}, x);
      REQUIRE(place.joint >= 0);
      const optim::Function row = torque.curve().at(place);
      CHECK(row.value(x) == Approx(torque.curve().trace(x)->at({angle, from_left})[0]));
      // The slide goes on turning below the break.
      const double moved = testing::slope(
          [&](double t) {
            const std::vector<double> y{x[0] + t};
            return torque.curve().trace(y)->at({in_turn(own + y[0]), from_left})[0];
          },
          1e-3);
      std::vector<double> g(1);
      row.gradient(x, g);
      CHECK(g[0] == Approx(moved).epsilon(1e-7).margin(1e-7));
    }
  }
}

TEST_CASE("a place that is tied to a cam's joint goes with the joint and with the phase",
          "[shaft]") {
  std::string text = two_cams(
      "[cams.bar.variables.phase]\nlower = 60\nupper = 300\nstart = 141.7\n"
      "[cams.bar.variables.rise_angle]\nlower = 60\nupper = 100\nstart = 81\n"
      "[cams.slide.variables.rise_angle]\nlower = 60\nupper = 120\nstart = 97\n"
      "[cams.slide.variables.load]\nlower = 0\nupper = 90\nstart = 40\n",
      "[responses.turned]\nunit = 'mm'\n"
      "formula = 'slide.displacement * cos(angle) + 2 * bar.displacement'\n");
  text.erase(text.find("phase = 140\n"), std::string("phase = 140\n").size());
  const BoundProblem bound(read(text));
  std::vector<double> x;
  for (const VariableStatement& v : bound.statement().variables) x.push_back(v.start);
  const auto of = [&](const std::string& name, const std::vector<double>& at) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (bound.statement().variables[i].name == name) return at[i];
    }
    throw std::out_of_range(name);
  };
  // Each break of each cam, in its own turn, and where it is on the shaft.
  struct Break {
    std::string cam;
    double behind_rise;
    bool is_zero = false;
  };
  const auto angle_of = [&](const Break& b, const std::vector<double>& at) {
    const double own = b.is_zero ? 0 : of(b.cam + ".rise_angle", at) + b.behind_rise;
    return in_turn(own + (b.cam == "bar" ? of("bar.phase", at) : 0));
  };
  for (const std::string name : {"turned", "gap"}) {
    const optim::Response response = response_of(
        bound.statement(), find_response(*bound.statement().mechanism, name), bound.binding({}));
    const optim::Curve& curve = response.curve();
    for (const Break& b :
         {Break{"bar", 0, true}, Break{"bar", 0}, Break{"bar", 40}, Break{"bar", 150},
          Break{"slide", 0}, Break{"slide", 40}, Break{"slide", 150}}) {
      for (const bool from_left : {true, false}) {
        INFO(name << ", " << b.cam << " " << b.behind_rise << " " << from_left);
        const optim::Place place = curve.tied({angle_of(b, x), from_left}, x);
        REQUIRE(place.joint >= 0);
        const optim::Function row = curve.at(place);
        for (const double factor : {1.0, 1.001, 0.99}) {
          std::vector<double> moved = x;
          for (double& value : moved) value *= factor;
          const double there = curve.trace(moved)->at({angle_of(b, moved), from_left})[0];
          CHECK(row.value(moved) == Approx(there).epsilon(1e-9).margin(1e-12));
        }
        testing::check_derivatives(row, x, 1e-5, 1e-5);
      }
    }
  }
}

TEST_CASE("enclosures of a shaft's curves hold what the curves are", "[shaft]") {
  const ProblemStatement shaft = read(two_cams("", ""));
  for (const std::string name : {"shaft_torque", "gap"}) {
    const auto trace = trace_of(shaft, name);
    const std::vector<double> breaks = trace->breaks();
    CHECK(breaks.front() == 0);
    CHECK(breaks.back() == 360);
    CHECK(std::is_sorted(breaks.begin(), breaks.end()));
    for (const auto& part : shaft_fixture::enclosed_parts(*trace, {1.0, 0.3, 0.01, 1e-4})) {
      const auto& [share, length, from, to, bounds, least, most] = part;
      INFO(name << " from " << from << " to " << to);
      CHECK(bounds.lower <= least);
      CHECK(bounds.upper >= most);
      // Of second order: what they add shrinks as the square of the stretch does.
      CHECK(bounds.upper - bounds.lower <= most - least + 0.3 * share * length * share * length);
    }
  }
}

TEST_CASE("a clearance between followers is proved, and found broken where it is", "[shaft]") {
  const std::string limit = "[[constraints]]\nresponse = 'gap'\nlower = ";
  const auto least = [](const ProblemStatement& statement) {
    const auto trace = trace_of(statement, "gap");
    optim::Extreme found{{}, 1e9};
    for (int i = 0; i <= 36000; ++i) {
      const double value = trace->at({i / 100.0, i == 36000})[0];
      if (value < found.value) found = {{i / 100.0}, value};
    }
    return found;
  };
  const optim::Extreme nearest = least(read(two_cams("", "")));
  for (const double by : {-0.01, 0.01}) {
    const ProblemStatement stated =
        read(two_cams("", limit + fmt::format("{:.9g}\n", nearest.value + by)));
    const optim::LimitReport report = standing(stated).front();
    CHECK(report.met == (by < 0));
    CHECK(report.value == Approx(nearest.value).epsilon(1e-5));
    if (by < 0) CHECK(report.proved);
    if (by > 0) CHECK(*report.worst_angle == Approx(nearest.place.angle).margin(1));
  }
}

TEST_CASE("the shipped pair of cams is certified, and no phase on a grid is better", "[shaft]") {
  const BoundProblem bound(read_problem_file(testing::source("problems/shaft/two_cams.toml")));
  const optim::ProblemSpace space = bound.space();
  const auto best = optim::optimise(space);
  REQUIRE(best.found.assessment.verdict == optim::Verdict::Certified);
  const double value = best.found.assessment.objective.value;
  int feasible = 0;
  for (double phase = 240; phase <= 270; phase += 3) {
    for (double push = 105; push <= 150; push += 5) {
      ProblemStatement moved = bound.statement();
      set_values(moved, std::vector{fmt::format("press.phase={}", phase),
                                    fmt::format("infeed.push_angle={}", push)});
      const auto gap = trace_of(moved, "clearance"), torque = trace_of(moved, "shaft_torque");
      double nearest = 1e9, peak = 0;
      for (int i = 0; i <= 720; ++i) {
        nearest = std::min(nearest, gap->at({i / 2.0, i == 720})[0]);
        peak = std::max(peak, std::abs(torque->at({i / 2.0, i == 720})[0]));
      }
      if (nearest < 28) continue;
      ++feasible;
      INFO(phase << " " << push);
      CHECK(peak >= value * (1 - 1e-3));
    }
  }
  CHECK(feasible > 10);
}

TEST_CASE("a design of several cams is recorded and read back", "[shaft]") {
  const BoundProblem bound(read_problem_file(testing::source("problems/shaft/two_cams.toml")));
  const std::vector<double> x{131, 251};
  const Json design = recorded_design(bound, {}, x);
  const ReadDesign read =
      read_result(Json{{"verdict", "feasible"}, {"design", design}}.dump(), "r.json");
  CHECK(read.statement.constants == bound.at({}, x).constants);
  REQUIRE(held_problem(read));
  CHECK(held_problem(read)->x == x);
}

TEST_CASE("a cam's list of laws is a choice beside those of the others", "[shaft]") {
  std::string text = two_cams("", "[objective]\nminimize = 'peak bar.drive_torque'\n");
  text.replace(text.find("law = 'cycloidal'"), std::string("law = 'cycloidal'").size(),
               "law = ['cycloidal', 'modified-sine']");
  const BoundProblem bound(read(text));
  REQUIRE(bound.choices().size() == 1);
  REQUIRE(bound.choices().front().options.size() == 2);
  const auto peak = [&](std::size_t option) {
    return optim::objective_value(bound.problem({option}).objective(), {});
  };
  const auto plain = read(two_cams("", "[objective]\nminimize = 'peak bar.drive_torque'\n"));
  CHECK(peak(0) ==
        Approx(optim::objective_value(BoundProblem(plain, true).problem({}).objective(), {})));
  CHECK(peak(0) != Approx(peak(1)));
}

TEST_CASE("windows and checks are those of the cam that they are of", "[shaft]") {
  const std::string text =
      kSpeedOfShaft + on_shaft("a", "cycloidal", 90) +
      "[cams.a.buildable]\nmaterial = 'C45'\nallowable_pressure = 900\n" +
      on_shaft("b", "cycloidal", 60, "phase = 77\n") +
      "[[constraints]]\nresponse = 'peak b.pressure_angle'\nover = 'return'\nupper = 30\n";
  const ProblemStatement shaft = read(text);
  const std::string alone =
      kRoller + cam("", "cycloidal", 60, "speed = 200\n") +
      "[[constraints]]\nresponse = 'peak pressure_angle'\nover = 'return'\nupper = 30\n";
  CHECK(standing(shaft).front().value == standing(read(alone)).front().value);
  const auto built = buildability(shaft);
  const auto single = buildability(read(alone));
  CHECK(built.checks.size() == 2 * single.checks.size());
  CHECK(built.count(Built::Holds) == 2 * single.count(Built::Holds));
  CHECK_THAT(in_words(shaft), Contains("a.allowable_pressure = 900 MPa") &&
                                  Contains("The motions are a: rise 90 deg"));
}

TEST_CASE("a file of several cams says in words what it does not accept", "[shaft]") {
  const std::string a = on_shaft("a", "cycloidal", 90), b = on_shaft("b", "cycloidal", 60);
  CHECK_THAT(complaint(kSpeedOfShaft + on_shaft("a", "cycloidal", 90, "speed = 100\n")),
             Contains("cams.a.constants.speed: the speed is the shaft's"));
  CHECK_THAT(complaint(kRoller + a), Contains("the file has several cams"));
  CHECK_THAT(complaint("[cams.law]\n" + kRoller), Contains("'law' means something else"));
  CHECK_THAT(complaint("[cams.a]\nmechanism = 'disc-cam-rolle'\n"), Contains("disc-cam-roller"));
  CHECK_THAT(complaint(a + "[cams.a.objective]\nminimize = 'base_radius'\n"),
             Contains("objective"));
  const std::string formula = "[responses.r]\nunit = 'mm'\nformula = ";
  CHECK_THAT(complaint(a + formula + "'s * 3 mm'\n"), Contains("there are several motions"));
  CHECK_THAT(complaint(a + formula + "'angle * 3 mm'\n"), Contains("uses a curve of a cam"));
  CHECK_THAT(complaint(a + formula + "'a.displacment'\n"), Contains("a.displacement"));
  CHECK_THAT(complaint(a + "[[constraints]]\nresponse = 'a.pressure_angle'\nover = 'rest'\n"),
             Contains("there is no segment 'rest'"));
  CHECK_THAT(complaint("[cams]\n"), Contains("0 cams; a file may have 1 to 40"));
  ProblemStatement pair = read(a + b);
  CHECK_THAT(complaint([&] { set_value(pair, "a.base_radus=3"); }), Contains("a.base_radius"));
  set_value(pair, "b.base_radius=41 mm");
  CHECK(constant_of(pair, "b.base_radius") == 41);
  CHECK_THAT(complaint([&] { find_cam(pair, "c"); }),
             Contains("there is no cam on the shaft named"));
}

}  // namespace camlaw::problems::shaft_test
