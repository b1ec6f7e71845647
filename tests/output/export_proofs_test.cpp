// SPDX-License-Identifier: MIT
// What is proved of an exported curve, against many places of the curve itself; circles that cut.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "output/export/arcs.h"
#include "output/export/chords.h"
#include "output/export/cubics.h"
#include "output/export/inspection.h"
#include "output/export/interference.h"
#include "output/export/tool_path.h"
#include "tests/paths.h"

namespace camlaw::problems::export_proofs_test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Eigen::Vector2d;

ProblemStatement shipped(const std::string& name) {
  return read_problem_file(testing::source("problems/") + name);
}

std::vector<std::string> cam_files() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(testing::source("problems/cams"))) {
    if (file.path().extension() == ".toml")
      names.push_back("cams/" + file.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Every curve of a cam, and what runs beside its profile.
std::vector<PlaneCurve> all_curves(const std::string& file) {
  std::vector<PlaneCurve> curves = cam_curves(shipped(file), "all");
  curves.push_back(path_of_tool(cam_curves(shipped(file), "profile").front(), 3));
  return curves;
}

/// x(phi) and y(phi) given by a function, exact as numbers: nothing of it is enclosed.
class FormulaCurve final : public optim::Curve {
 public:
  using Formula = std::function<std::array<double, 3>(double)>;
  explicit FormulaCurve(Formula formula) : formula_(std::move(formula)) {}

  optim::Function at(optim::Place) const override { throw std::logic_error("nobody asks"); }
  std::unique_ptr<optim::Trace> trace(optim::Design) const override {
    return std::make_unique<FormulaTrace>(formula_);
  }
  optim::Shape shape() const override { return optim::Shape::General; }

 private:
  class FormulaTrace final : public optim::Trace {
   public:
    explicit FormulaTrace(Formula formula) : formula_(std::move(formula)) {}
    std::vector<double> breaks() const override { return {0, 360}; }
    std::array<double, 3> at(optim::Place place) const override { return formula_(place.angle); }
    optim::Bounds enclose(double, double) const override { return {}; }

   private:
    Formula formula_;
  };
  Formula formula_;
};

/// A circle about a centre, once round, angles in degrees.
PlaneCurve circle(const std::string& name, const Vector2d& centre, double radius) {
  const auto response = [&](double middle, double phase) {
    constexpr double kRate = std::numbers::pi / 180;
    optim::Response made;
    made.measure = std::make_shared<const FormulaCurve>([=](double angle) {
      const double a = kRate * angle + phase;
      return std::array{middle + radius * std::cos(a), -kRate * radius * std::sin(a),
                        -kRate * kRate * radius * std::cos(a)};
    });
    return made;
  };
  return {name, response(centre.x(), 0), response(centre.y(), -std::numbers::pi / 2),
          CurveEnd::Returns};
}

}  // namespace

TEST_CASE("What is proved of a stretch of a curve holds at every place of it",
          "[exports][proofs]") {
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> share(0, 1);
  for (const std::string& file : cam_files()) {
    for (const PlaneCurve& curve : all_curves(file)) {
      INFO(file << " " << curve.name());
      double tightest = 1e9;
      for (int trial = 0; trial < 40; ++trial) {
        const auto& breaks = curve.breaks();
        const std::size_t k = random() % (breaks.size() - 1);
        const double length = (breaks[k + 1] - breaks[k]) * std::pow(10.0, -3 * share(random));
        const double from = breaks[k] + share(random) * (breaks[k + 1] - breaks[k] - length);
        const CurveStretch stretch = curve.stretch(from, from + length);
        if (!std::isfinite(stretch.bow)) continue;
        for (int i = 0; i <= 50; ++i) {
          const double t = i / 50.0;
          const Vector2d p = curve.at({from + t * length, i == 50}).at;
          CHECK((p - stretch.a - t * (stretch.b - stretch.a)).norm() <= stretch.bow);
        }
        if (length < 1) tightest = std::min(tightest, stretch.bow / (length * length));
      }
      CHECK(tightest < 1);  // it closes on the curve as the square of the stretch
    }
  }
}

TEST_CASE("Every shipped cam's deviations are proved, and none is exceeded", "[exports][proofs]") {
  constexpr double kTolerance = 0.01;
  for (const std::string& file : cam_files()) {
    for (const PlaneCurve& curve : cam_curves(shipped(file), "all")) {
      INFO(file << " " << curve.name());
      CHECK(chords_within(curve, kTolerance, 6).proved);
      CHECK(arcs_within(curve, kTolerance).proved);
      CHECK(cubics_within(curve, kTolerance).proved);
      CHECK(chords_at_steps(curve, 5, 6).proved);
    }
  }
}

TEST_CASE("A curve that nothing encloses is measured, and not called proved", "[exports][proofs]") {
  const PlaneCurve round = circle("profile", {0, 0}, 30);
  const Chords chords = chords_within(round, 0.01, 6);
  CHECK_FALSE(chords.proved);
  CHECK(chords.worst == Approx(0.01).epsilon(0.9));
  CHECK_FALSE(arcs_within(round, 0.01).proved);
  CHECK_FALSE(turning(round).proved);
  CHECK_FALSE(turning(round).angle);
}

TEST_CASE("In inches a curve is 25.4 times as small, and its deviations too", "[exports][proofs]") {
  const PlaneCurve curve = cam_curves(shipped("cams/roller_least_base.toml"), "profile").front();
  const PlaneCurve inches = curve.in(kInch);
  for (double angle = 0; angle < 360; angle += 13) {
    CHECK((25.4 * inches.at({angle}).at - curve.at({angle}).at).norm() < 1e-12);
    CHECK((25.4 * inches.at({angle}).slope - curve.at({angle}).slope).norm() < 1e-12);
  }
  const Chords a = chords_within(curve, 0.0254, 8), b = chords_within(inches, 0.001, 8);
  CHECK(a.points.size() == b.points.size());
  CHECK(25.4 * b.worst == Approx(a.worst).epsilon(1e-4));
}

TEST_CASE("That a profile turns back nowhere is proved for every shipped cam",
          "[exports][proofs]") {
  for (const std::string& file : cam_files()) {
    for (const char* option : {"profile", "second-profile", "cutter"}) {
      for (const PlaneCurve& curve : cam_curves(shipped(file), option)) {
        INFO(file << " " << option);
        const Turning found = turning(curve);
        if (!found.angle) CHECK(found.proved);
      }
    }
  }
}

TEST_CASE("A circle along a curve cuts as far as circles tell", "[exports][proofs]") {
  // Centres on a circle of radius 10 about the origin, the profile one of radius 12 about (1, 0):
  // the least distance is 12 - 10 - 1.
  const PlaneCurve centre = circle("cutter path", {0, 0}, 10);
  const PlaneCurve profile = circle("profile", {1, 0}, 12);
  const Interference found = interference(followed(centre), followed(profile), 2.5);
  CHECK(found.depth == Approx(1.5).margin(2 * found.certain));
  CHECK(found.certain <= 1.1e-3);
  CHECK(interference(followed(centre), followed(profile), 0.9).depth <= found.certain);
  CHECK(even_distance(centre, circle("profile", {0, 0}, 12)) == Approx(2));
  CHECK_FALSE(even_distance(centre, profile));
}

TEST_CASE("A tool that fits nowhere is refused although its path never turns back",
          "[exports][proofs]") {
  // Beside a circle of radius 1.5, 2 mm inwards: every point lies on the other side of the centre,
  // and the curve runs evenly. The tool at one place cuts all that it left at others.
  const PlaneCurve path = circle("cutter path", {0, 0}, 1.5);
  const PlaneCurve profile = path.beside("profile", 2);
  CHECK_FALSE(turns_back(profile));
  const auto words = cuts_into_profiles({profile, path});
  REQUIRE(words.size() == 1);
  CHECK_THAT(words.front(), Contains("the tool, 2 mm in radius, cuts 1 mm into the profile"));
}

TEST_CASE("Tools that do not cut into a shipped cam are not said to", "[exports][proofs]") {
  for (const std::string& file : cam_files()) {
    INFO(file);
    const auto curves = cam_curves(shipped(file), "all");
    if (std::none_of(curves.begin(), curves.end(),
                     [](const PlaneCurve& c) { return turns_back(c).has_value(); })) {
      CHECK(cuts_into_profiles(curves).empty());
    }
  }
}

TEST_CASE("Inspection points lie on the profile, and their normals across it",
          "[exports][proofs]") {
  for (const std::string& file : cam_files()) {
    INFO(file);
    const PlaneCurve profile = cam_curves(shipped(file), "profile").front();
    if (turns_back(profile)) continue;
    const auto points = inspection_points(profile, 5);
    REQUIRE(!points.empty());
    for (const InspectionPoint& p : points) {
      CHECK((p.at - profile.at({p.angle, p.angle == profile.end()}).at).norm() == 0);
      CHECK(p.normal.norm() == Approx(1).epsilon(1e-12));
      const double h = 1e-3;
      if (p.angle < h || p.angle > profile.end() - h) continue;
      const Vector2d chord = profile.at({p.angle + h}).at - profile.at({p.angle - h}).at;
      CHECK(std::abs(chord.normalized().dot(p.normal)) < 1e-3);
      // A little along the normal is away from the centre, or up.
      const Vector2d out = p.at + 0.01 * p.normal;
      const PlaneCurve tool = path_of_tool(profile, 0.01);
      CHECK((out - tool.at({p.angle}).at).norm() < 1e-9);
    }
  }
}

}  // namespace camlaw::problems::export_proofs_test
