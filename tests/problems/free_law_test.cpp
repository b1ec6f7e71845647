// SPDX-License-Identifier: MIT
// The free law in problem files: what the file says, and answers that are known from elsewhere.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "kinematics/peaks.h"
#include "machines/follower_train/follower_train.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/paths.h"

namespace camlaw::problems::free_law_test {
namespace {

using Catch::Contains;
using optim::Optimum;
using optim::Verdict;

std::string shipped(const std::string& name) {
  std::ifstream file(testing::source("problems/free_law/") + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

struct Solved {
  BoundProblem bound;
  Optimum optimum;

  double objective() const { return optimum.found.assessment.objective.value; }
  Law<double> law() const { return bound.at(optimum.options, optimum.found.x).laws.front().law(); }
};

Solved solved(const std::string& text) {
  BoundProblem bound(read_problem(text, "f.toml"));
  Optimum optimum = optim::optimise(bound.space());
  return {std::move(bound), std::move(optimum)};
}

Solved globally_solved(const std::string& text) {
  Solved result = solved(text);
  const optim::Assessment& a = result.optimum.found.assessment;
  INFO(a.reason);
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global.has_value());
  return result;
}

const std::string kLaw = "mechanism = 'law'\n[law]\nname = 'free'\n";

}  // namespace

TEST_CASE("Least acceleration for a peak velocity is b^2 / (b - 1)", "[free]") {
  const std::string text = shipped("least_acceleration.toml");
  CHECK(globally_solved(text).objective() == Approx(least_acceleration(1.5)).epsilon(1e-7));
  // With knots that miss the places of the jumps the least is approached from above, as 1 / knots^2
  // or better.
  double before = 1;
  for (const int knots : {15, 63, 255}) {
    const auto other =
        globally_solved(replaced(text, "knots = 98", "knots = " + std::to_string(knots)));
    const double above = other.objective() / least_acceleration(1.5) - 1;
    INFO(knots << " knots");
    CHECK(above > 0);
    CHECK(above < before);
    CHECK(above < 1.0 / knots);
    before = above;
  }
  for (const double b : {1.2, 1.8}) {  // thirds no more
    std::ostringstream bound;
    bound << "upper = " << b;
    const Solved other = globally_solved(replaced(text, "upper = 1.5", bound.str()));
    CHECK(other.objective() >= least_acceleration(b) * (1 - 1e-9));
    CHECK(other.objective() == Approx(least_acceleration(b)).epsilon(2e-3));
  }
}

TEST_CASE("The optimum of a linear problem is judged once, as an answer is", "[free]") {
  const BoundProblem bound(read_problem(
      "mechanism = 'law'\n[law]\nname = 'free'\n[free]\ndegree = 3\nknots = 40\n"
      "[objective]\nminimize = 'C_a'\n[[constraints]]\nresponse = 'C_v'\nupper = 1.6\n",
      "f.toml"));
  int judged = 0;
  optim::OptimiseOptions how;
  how.candidate = [&](const optim::Candidate& candidate) {
    if (!candidate.is_best) return;
    ++judged;
    CHECK(candidate.assessment.verdict == Verdict::Certified);
    CHECK(candidate.assessment.global.has_value());
  };
  const Optimum optimum = optim::optimise(bound.space(), how);
  CHECK(judged == 1);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("Least jerk is 32, at B = 2 and C = 8", "[free]") {
  const Solved least = globally_solved(shipped("least_jerk.toml"));
  CHECK(least.objective() == Approx(32).epsilon(1e-7));
  const auto peak = peaks(least.law());
  CHECK(peak.max_velocity() == Approx(2).epsilon(1e-6));
  CHECK(peak.max_acceleration() == Approx(8).epsilon(1e-6));
}

TEST_CASE("Least acceleration for given velocity and jerk lies on lambda = 1", "[free][heavy]") {
  // 1/B + B/C + C/D = 1 solved for C.
  const double b = 1.6, d = 60;
  const double half = (1 - 1 / b) * d / 2;
  const double limit = half - std::sqrt(half * half - b * d);
  CHECK(limit == Approx(5.7217).epsilon(1e-5));
  const std::string text = shipped("least_acceleration_at_jerk.toml");
  const Solved hundred = globally_solved(text);
  CHECK(hundred.objective() > limit);
  CHECK(hundred.objective() < limit * 1.0015);
  const Solved two_hundred = globally_solved(replaced(text, "knots = 100", "knots = 200"));
  CHECK(two_hundred.objective() > limit);
  CHECK(two_hundred.objective() < limit * 1.0003);
  const auto lambda = limit_index(peaks(two_hundred.law()));
  REQUIRE(lambda);
  CHECK(*lambda < 1);
  CHECK(*lambda > 0.9995);
}

TEST_CASE("The table [free] is read as it says", "[free]") {
  const auto law = [](const std::string& table) {
    return read_problem(kLaw + "[free]\n" + table, "f.toml").laws.front();
  };
  CHECK(read_problem(kLaw, "f.toml").variables.size() == 32 + 4 - 6);
  CHECK(law("knots = 10").law().pieces().size() == 11);
  CHECK(law("degree = 6\nknots = []").law().pieces().size() == 1);
  CHECK(law("knots = [0.25, 0.5, 0.75]").law().pieces()[0].end == 0.25);
  CHECK(law("knots = 10").listed().law().ends() == Ends{});
  CHECK(law("degree = 2\nknots = 10").law().ends() == Ends{End::Reversal, End::Reversal});
  CHECK(law("begin = 'G'\nend = 'U'\nknots = 10").law().ends() ==
        Ends{End::Velocity, End::Reversal});
  CHECK(law("begin = 'B'\nend = 2\nknots = 10").law().ends() == Ends{End::Motion, End::Rest});
  CHECK(law("degree = 5\ncontinuity = 2\nknots = 10").arguments.list(0).size() == 6 + 30 - 6);
  CHECK(law("symmetric = true\nknots = 10").arguments.list(0).size() == 4);
  CHECK(law("start = 'modified-sine'\nknots = 10").arguments.list(0) !=
        law("knots = 10").arguments.list(0));
  const auto problem =
      read_problem(kLaw + "[free]\nknots = 4\nmoving_knots = true\nlower = 0\nupper = 1.5\n" +
                       "[variables.\"coefficients[2]\"]\nlower = 0.4\nupper = 0.6\n",
                   "f.toml");
  REQUIRE(problem.variables.size() == 2 + 4);
  CHECK(problem.variables[0].name == "coefficients[2]");
  CHECK(problem.variables[0].lower == 0.4);
  CHECK(problem.variables[1].name == "coefficients[1]");
  CHECK(problem.variables[1].upper == 1.5);
  CHECK(problem.variables[2].name == "knots[1]");
  CHECK(problem.variables[2].lower == Approx(0.2 * 0.55));
  CHECK(problem.variables[2].upper == Approx(0.2 * 1.45));
}

TEST_CASE("Wrong tables [free] are refused with their place", "[free]") {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      read_problem(text, "f.toml");
      return "accepted";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  const auto of_table = [&](const std::string& table) {
    return complaint(kLaw + "[free]\n" + table);
  };
  CHECK_THAT(of_table("degre = 3"), Contains("f.toml:5: free.degre") && Contains("degree"));
  CHECK_THAT(of_table("degree = -1"), Contains("f.toml:5: free.degree") && Contains("2 .. 25"));
  CHECK_THAT(of_table("degree = 1"), Contains("f.toml:5: free.degree: with 1 the velocity jumps"));
  CHECK_THAT(
      of_table("continuity = 0"),
      Contains("f.toml:5: free.continuity: with 0 the velocity jumps") && Contains("1 .. 2"));
  CHECK_THAT(of_table("degree = 26"), Contains("free.degree"));
  CHECK_THAT(of_table("degree = 2.5"), Contains("free.degree"));
  CHECK_THAT(of_table("knots = -1"), Contains("free.knots"));
  CHECK_THAT(of_table("knots = 'many'"), Contains("free.knots") && Contains("even knots"));
  CHECK_THAT(of_table("knots = [0.5, 0.2]"), Contains("free: ") && Contains("does not come after"));
  CHECK_THAT(of_table("continuity = 3"), Contains("free.continuity"));
  CHECK_THAT(of_table("begin = 'X'"),
             Contains("free.begin: 'X' is not an end") && Contains("R (rest)"));
  CHECK_THAT(of_table("end = 3"), Contains("free: ") && Contains("end: 3 derivatives"));
  CHECK_THAT(of_table("symmetric = 1"), Contains("free.symmetric") && Contains("true or false"));
  CHECK_THAT(of_table("lower = 2\nupper = 2"), Contains("lower 2 is not below upper 2"));
  CHECK_THAT(of_table("lower = -1000"), Contains("free.lower") && Contains("-100 .. 100"));
  CHECK_THAT(of_table("start = 'no-law'"), Contains("free.start") && Contains("no-law"));
  CHECK_THAT(of_table("knots = 0"), Contains("nothing is free"));
  CHECK_THAT(complaint("mechanism = 'law'\n[law]\nname = 'cosine'\n[free]\nknots = 3\n"),
             Contains("f.toml:4: free: no law of the problem is free"));
  CHECK_THAT(complaint("mechanism = 'law'\nfree = 3\n[law]\nname = 'free'\n"),
             Contains("f.toml:2: free") && Contains("[free]"));
}

TEST_CASE("No optimum is certified over a jump of the velocity", "[free][pulse]") {
  // Straight pieces have no acceleration but at the knot.
  const Solved jumping = solved(
      "mechanism = 'law'\n[law]\nname = 'b-spline degree=1 knots=0.5 coefficients=0,0.3,1'\n"
      "[variables.'coefficients[2]']\nlower = 0.2\nupper = 0.4\n[objective]\nminimize = 'C'\n");
  const optim::Assessment& a = jumping.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Failed);
  CHECK_THAT(a.reason, Contains("undefined"));
}

TEST_CASE("Limits that push along whole stretches are looked at closely enough", "[free][long]") {
  // Peak and runs along bounds are pushed by measures spread over stretches: at a few places in
  // each piece the conditions hold to a few ten-millionths only. The bounds are a linear program's.
  const auto certified = [](const std::string& text, double bound) {
    const BoundProblem problem(read_problem(text, "test"));
    const Optimum optimum = optim::optimise(problem.space());
    const auto& answer = optimum.found.assessment;
    INFO(answer.reason);
    CHECK(answer.verdict == Verdict::Certified);
    CHECK(answer.global);
    CHECK(answer.objective.value == Approx(bound).epsilon(1e-5));
  };
  certified(R"(mechanism = "law"
[law]
name = "free"
[free]
degree = 5
knots = [0.082176287107675938, 0.21569992507168775, 0.29838815160281723, 0.41030520753555472,
         0.49174498239436387, 0.72312366079203749]
continuity = 2
[objective]
minimize = "C_a"
[[constraints]]
response = "C_v"
upper = 1.7109375
[[constraints]]
response = "velocity"
lower = 0
)",
            4.79577012622);
  certified(R"(mechanism = "law"
[law]
name = "free"
[free]
degree = 4
knots = [0.11020059132347744, 0.15778866641626355, 0.24346594317665321, 0.3542643277141404,
         0.39247551831572652, 0.43580831116528174, 0.53066909722699918, 0.60421863600600323,
         0.62558356734334153, 0.64545573892701347, 0.72915972465423462, 0.7835214912631534,
         0.86747852416785087, 0.95575846476243909]
continuity = 1
begin = 2
[objective]
minimize = "highest acceleration"
[[constraints]]
response = "C_v"
upper = 1.26953125
[[constraints]]
response = "velocity"
lower = 0
)",
            3.56874488562);
}

TEST_CASE("A free law is one of several to choose from", "[free]") {
  const Solved best = solved(
      "mechanism = 'law'\n[law]\nname = ['modified-trapezoid', 'free']\n"
      "[free]\nknots = 11\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'D'\n"
      "upper = 70\n");
  const optim::Assessment& a = best.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(best.bound.at(best.optimum.options, best.optimum.found.x).laws.front().family->name ==
        "free");
  CHECK(best.objective() < peaks(find_law("modified-trapezoid").law()).max_acceleration());
}

namespace {

/// Every derivative agrees with differences, and the shapes hold.
optim::DerivativeCheck agreeing_derivatives(const optim::Problem& problem) {
  auto check = optim::check_derivatives(problem, problem.start());
  INFO(check.worst.response << " " << check.worst.variable << " " << check.worst.second);
  CHECK(check.agrees);
  CHECK(check.shapes.empty());
  return check;
}

}  // namespace

TEST_CASE("Derivatives by coefficients and knots are those of differences", "[free][long]") {
  for (const char* table : {"degree = 3\nknots = 5", "degree = 3\nknots = 5\nmoving_knots = true",
                            "degree = 4\nknots = 4\ncontinuity = 2\nsymmetric = true\n"
                            "moving_knots = true",
                            "degree = 3\nbegin = 'G'\nend = 'G'\nknots = 3\nmoving_knots = true"}) {
    INFO(table);
    const BoundProblem bound(read_problem(
        kLaw + "[free]\n" + table +
            "\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'moment'\nupper = 5\n"
            "[[constraints]]\nresponse = 'displacement'\nlower = 0\n",
        "f.toml"));
    const optim::Problem problem = bound.problem({}).alone(0);
    const auto check = agreeing_derivatives(problem);
    CHECK(check.entries > 0);
  }
}

namespace {

/// Integral of f over [0, 1] by Simpson's rule on n even steps.
template <class F>
double integral(const F& f, int n = 20000) {
  double sum = f(0.0) + f(1.0);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(static_cast<double>(i) / n);
  return sum / (3.0 * n);
}

/// int s''(x) cos(W x) dx and with sin, piece by piece.
std::array<double, 2> driven(const Law<double>& law, double period_ratio) {
  const double W = 2 * std::numbers::pi * period_ratio;
  std::array<double, 2> sum{};
  for (const auto& piece : law.pieces()) {
    const double length = piece.end - piece.begin;
    const int steps = law.pieces().size() > 8 ? 200 : 4000;
    const auto at = [&](double share) { return piece.begin + share * length; };
    const auto a = [&](double share) { return derivatives<3>(piece, at(share))[2]; };
    sum[0] += length * integral([&](double u) { return a(u) * std::cos(W * at(u)); }, steps);
    sum[1] += length * integral([&](double u) { return a(u) * std::sin(W * at(u)); }, steps);
  }
  return sum;
}

/// The least of a convex function between two places, by golden sections.
template <class F>
double least(const F& f, double low, double high) {
  const double share = (std::sqrt(5.0) - 1) / 2;
  double a = high - share * (high - low), b = low + share * (high - low);
  double at_a = f(a), at_b = f(b);
  for (int i = 0; i < 60; ++i) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - share * (high - low), at_a = f(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + share * (high - low), at_b = f(b);
    }
  }
  return std::min(at_a, at_b);
}

double value_of_response(const ProblemStatement& problem, const std::string& name) {
  const auto responses = evaluate(problem);
  const auto found = std::find_if(responses.begin(), responses.end(),
                                  [&](const auto& response) { return response.name == name; });
  REQUIRE(found != responses.end());
  return found->value;
}

ProblemStatement law_alone(const std::string& name, const std::string& constants = "") {
  return read_problem("mechanism = 'law'\n" + constants + "[law]\nname = '" + name + "'\n",
                      "f.toml");
}

}  // namespace

TEST_CASE("Least mean squares are those of the calculus of variations", "[free]") {
  // The fourth derivative is 0 with rest at the ends, and the sixth with s'' = 0 there too.
  const Solved cubic = globally_solved(shipped("least_mean_square_acceleration.toml"));
  CHECK(cubic.objective() == Approx(12).epsilon(1e-8));
  const Solved quintic = globally_solved(shipped("least_mean_square_jerk.toml"));
  CHECK(quintic.objective() == Approx(720).epsilon(1e-8));
  for (double x = 0; x <= 1; x += 1.0 / 64) {
    CHECK(cubic.law()(x).s == Approx(x * x * (3 - 2 * x)).margin(1e-8));
    CHECK(quintic.law()(x).s == Approx(x * x * x * (10 + x * (-15 + 6 * x))).margin(1e-8));
  }
  // Of the velocity it is the straight line, where it may jump at the ends.
  const Solved line = globally_solved(kLaw + "[free]\nbegin = 'B'\nend = 'B'\nknots = 9\n" +
                                      "[objective]\nminimize = 'mean_square_velocity'\n");
  CHECK(line.objective() == Approx(1).epsilon(1e-8));
}

TEST_CASE("An infinite mean square is not a number, and the reason says so", "[free]") {
  // At the start, a straight line, nothing jumps; as soon as a coefficient moves s'' does.
  const std::string text =
      kLaw + "[free]\ndegree = 2\nbegin = 'B'\nend = 'B'\nknots = 4\nstart = 'constant-velocity'\n";
  for (const char* rest : {"[objective]\nminimize = 'mean_square_acceleration'\n[[constraints]]\n"
                           "response = 'mean_square_jerk'\nupper = 1e-6\n",
                           "[objective]\nminimize = 'mean_square_jerk'\n"}) {
    const optim::Assessment a = solved(text + rest).optimum.found.assessment;
    CHECK(a.verdict != Verdict::Feasible);
    CHECK(a.verdict != Verdict::Certified);
    CHECK_THAT(a.reason, Contains("mean_square_jerk") && Contains("it is infinite"));
  }
}

TEST_CASE("Mean squares are those of quadrature, for every kind of law", "[free]") {
  const char* names[] = {"mean_square_velocity", "mean_square_acceleration", "mean_square_jerk"};
  for (const char* law_name : {"poly-3-4-5", "cycloidal", "modified-sine", "modified-trapezoid",
                               "half-ellipse-velocity"}) {
    const Law<double> law = find_law(law_name).law();
    for (std::size_t order = 1; order <= (law.is_data() ? 3U : 1U); ++order) {
      INFO(law_name << ", derivative " << order);
      double sum = 0;
      for (const auto& piece : law.pieces()) {
        const double length = piece.end - piece.begin;
        const auto square = [&](double u) {
          const double d = derivatives<4>(piece, piece.begin + u * length)[order];
          return d * d;
        };
        sum += length * integral(square, 2000);
      }
      CHECK(value_of_response(law_alone(law_name), names[order - 1]) == Approx(sum).epsilon(1e-6));
    }
  }
  // Acceleration jumps inside: infinite, no number.
  CHECK(std::isnan(value_of_response(law_alone("parabolic"), "mean_square_jerk")));
  CHECK(value_of_response(law_alone("parabolic"), "mean_square_acceleration") == Approx(16));
}

TEST_CASE("Least dynamic moment is 9/4", "[free][heavy]") {
  // A moment of at most M leaves s' at most sqrt(2 M min(x, 1 - x)), whose integral must be 1.
  const auto root = [](double x) { return std::sqrt(2 * 2.25 * std::min(x, 1 - x)); };
  // x = u^2 / 2 makes the first half smooth.
  CHECK(2 * integral([&](double u) { return root(u * u / 2) * u; }) == Approx(1).epsilon(1e-9));
  const std::string text = shipped("least_moment.toml");
  const Solved fine = solved(text);
  const optim::Assessment& a = fine.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  CHECK(fine.objective() > 2.25);
  CHECK(fine.objective() < 2.25 * (1 + 1e-4));
  const Law<double> law = fine.law();
  for (double x = 0.02; x < 1; x += 0.02) CHECK(law(x).v == Approx(root(x)).epsilon(2e-3));
  const std::size_t from = text.find("knots = ["), to = text.find(']', from) + 1;
  const Solved coarse = solved(replaced(text, text.substr(from, to - from), "knots = 9"));
  CHECK(coarse.objective() > fine.objective());
}

TEST_CASE("A quiet rise leaves no vibration, with the least acceleration", "[free]") {
  const std::string text = shipped("quiet_rise.toml");
  const Solved three = globally_solved(text);
  for (const double ratio : {2.0, 3.0, 3.5}) {
    INFO(ratio);
    for (const double part : driven(three.law(), ratio)) CHECK(std::abs(part) < 1e-8);
    CHECK(residual_vibration(three.law(), ratio, 0.0) < 1e-9);
  }
  CHECK(residual_vibration(three.law(), 2.5, 0.0) > 1e-4);
  // Two whole ratios: of all laws with an acceleration of at most C that do it, by duality 1 / C is
  // the least of int |1/2 - x - p sin 4 pi x - q sin 6 pi x| dx; even parts do not help.
  const auto distance = [](double p, double q) {
    const double pi = std::numbers::pi;
    return integral(
        [=](double x) {
          return std::abs(0.5 - x - p * std::sin(4 * pi * x) - q * std::sin(6 * pi * x));
        },
        2000);
  };
  const double inner =
      least([&](double p) { return least([&](double q) { return distance(p, q); }, -0.5, 0.5); },
            -0.5, 0.5);
  const std::size_t third = text.find("[[constraints]]\nresponse = \"residual_cosine_3\"");
  const Solved two = globally_solved(text.substr(0, third));
  CHECK(two.objective() > (1 - 1e-5) / inner);
  CHECK(two.objective() < 1.0005 / inner);
  CHECK(three.objective() > two.objective());
}

TEST_CASE("The residual numbers of the law alone agree with quadrature", "[free]") {
  for (const char* name : {"cycloidal", "poly-3-4-5", "modified-sine"}) {
    const auto problem = law_alone(
        name, "[constants]\nperiod_ratio = 1.3\nperiod_ratio_2 = 2.6\nperiod_ratio_3 = 7.7\n");
    const Law<double> law = find_law(name).law();
    const std::string ends[] = {"", "_2", "_3"};
    const double ratios[] = {1.3, 2.6, 7.7};
    for (std::size_t i = 0; i < 3; ++i) {
      INFO(name << " at " << ratios[i]);
      const double W = 2 * std::numbers::pi * ratios[i];
      const auto parts = driven(law, ratios[i]);
      const auto value = [&](const char* what) {
        return value_of_response(problem, what + ends[i]);
      };
      CHECK(value("residual_cosine") == Approx(parts[0] / W).margin(1e-9));
      CHECK(value("residual_sine") == Approx(parts[1] / W).margin(1e-9));
      const double amplitude = std::hypot(parts[0], parts[1]) / W;
      CHECK(value("residual_amplitude") == Approx(amplitude).margin(1e-9));
    }
  }
}

TEST_CASE("Numbers of the whole law have exact derivatives and the shapes they state", "[free]") {
  const BoundProblem bound(read_problem(
      kLaw + "[free]\ndegree = 4\nknots = 6\n[objective]\nminimize = 'mean_square_jerk'\n" +
          "[[constraints]]\nresponse = 'mean_square_acceleration'\nupper = 100\n" +
          "[[constraints]]\nresponse = 'residual_sine'\nequals = 0\n" +
          "[[constraints]]\nresponse = 'residual_amplitude_2'\nupper = 0.01\n",
      "f.toml"));
  const optim::Problem problem = bound.problem({}).alone(0);
  agreeing_derivatives(problem);
  // The quadratic form, put together piece by piece, lies in the enclosure of the law's own number.
  const double form = problem.objective().response.function().value(problem.start());
  const auto proved = problem.objective().response.function().enclose(problem.start());
  CHECK(proved.lower <= form * (1 + 1e-12));
  CHECK(proved.upper >= form * (1 - 1e-12));
  CHECK(proved.upper - proved.lower < 1e-6 * form);
  const Optimum optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.assessment.global);
}

TEST_CASE("The free law of the spine cutter is near the limit of all laws", "[free]") {
  const Solved free = globally_solved(shipped("spine_cutter.toml"));
  // The force is C times a scale: the limit is the force with C = B^2 / (B - 1).
  const auto peak = peaks(free.law());
  const double limit =
      free.objective() * least_acceleration(peak.max_velocity()) / peak.max_acceleration();
  CHECK(free.objective() > limit);
  CHECK(free.objective() < limit * 1.0005);
}

TEST_CASE("Knots that move make the law better, and stay in order", "[free]") {
  const std::string text = replaced(shipped("spine_cutter.toml"), "knots = 64", "knots = 8");
  const Solved even = globally_solved(text);
  const Solved moving = solved(replaced(text, "knots = 8", "knots = 8\nmoving_knots = true") +
                               "\n[solver]\nstarts = 1\n");
  CHECK(moving.optimum.found.assessment.verdict == Verdict::Certified);
  CHECK_FALSE(moving.optimum.found.assessment.global);
  CHECK(moving.objective() < even.objective());
  const auto peak = peaks(moving.law());
  CHECK(peak.max_acceleration() == Approx(least_acceleration(peak.max_velocity())).epsilon(1e-3));
  const Law<double> law = moving.law();
  CHECK(law.pieces().size() == 9);
  for (const auto& piece : law.pieces()) CHECK(piece.end - piece.begin > 0.099 / 9);
}

TEST_CASE("Segments of a program take free laws", "[free]") {
  // Rise and return of 120 deg at 5 turns a second: 0.45 m/s is B = 1.5, so that the least
  // acceleration is 4.5 strokes over the segment's time squared.
  const std::string text =
      "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '20 mm'\nspeed = '300 rpm'\n"
      "[program]\nmatched = 'velocity'\n"
      "[[program.segments]]\nname = 'rise'\nangle = 120\nlaw = 'free'\n"
      "[[program.segments]]\nangle = 30\n"
      "[[program.segments]]\nname = 'return'\nangle = 120\nlaw = ['free', 'parabolic']\n"
      "[[program.segments]]\nname = 'low'\n"
      "[free]\ndegree = 2\nknots = 11\n[objective]\nminimize = 'peak acceleration'\n"
      "[[constraints]]\nresponse = 'peak velocity'\nupper = '0.45 m/s'\n";
  const Solved cam = solved(text);
  const optim::Assessment& a = cam.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  const double time = 120.0 / 360 / 5;
  CHECK(a.objective.value == Approx(4.5 * 0.02 / (time * time)).epsilon(1e-6));
  const auto& variables = cam.bound.statement().variables;
  CHECK(variables.size() == 20);
  CHECK(variables.front().name == "rise_coefficients[1]");
  CHECK(variables.back().name == "return_coefficients[10]");
  const Member found = cam.bound.at(cam.optimum.options, cam.optimum.found.x).laws.front();
  const Member listed = found.listed();
  CHECK_THAT(listed.name(), Contains("rise=b-spline") && Contains("return=b-spline"));
  for (const double x : {0.1, 0.3, 0.5, 0.9}) {
    CHECK(listed.law()(x).s == Approx(found.law()(x).s).margin(1e-14));
  }
}

}  // namespace camlaw::problems::free_law_test
