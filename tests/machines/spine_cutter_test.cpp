// SPDX-License-Identifier: MIT
#include "machines/spine_cutter.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"
#include "problems/published/spine_cutter/study.h"
#include "tests/plain.h"

namespace camlaw::problems::spine_cutter_test {
namespace {

using Catch::Matchers::Contains;
constexpr double kPi = std::numbers::pi;
using Cutter = CutterGivens;
using testing::plain, testing::PlainNumbers;

/// Every result of the mechanism, for B = 1.7, C = 5.5, Cm = 5.4.
std::vector<Expression> formulas(const SpineCutter& c) {
  return {c.chord_of_contact(),      c.contact_angle(),
          c.blades_in_contact(),     c.path_per_revolution(),
          c.angular_velocity(),      c.minimum_cam_radius(1.7),
          c.peak_inertia_force(5.5), c.printed_inertia_force(5.5),
          c.peak_drive_torque(5.4)};
}

std::vector<double> results(const Cutter& givens) {
  const PlainNumbers numbers;
  std::vector<double> values;
  for (const Expression& result : formulas(cutter_of(givens))) values.push_back(plain(result));
  return values;
}

constexpr std::array kFields{&Cutter::cutter_diameter, &Cutter::blades, &Cutter::stroke,
                             &Cutter::block_speed,     &Cutter::depth,  &Cutter::mass,
                             &Cutter::pressure_angle};

/// The results as records of the seven givens.
std::vector<Formula> records() {
  std::vector<Formula> all;
  for (std::size_t k = 0; k < results(Cutter()).size(); ++k) {
    all.push_back(Formula::record(kFields.size(), [k](std::span<const Expression> u) {
      SpineCutter c;
      c.cutter_diameter = u[0], c.blades = u[1], c.stroke = u[2], c.block_speed = u[3];
      c.depth = u[4], c.mass = u[5], c.pressure_angle = u[6];
      return formulas(c)[k];
    }));
  }
  return all;
}
template <class T>
std::vector<T> results_at(const Cutter& givens,
                          const std::function<void(std::vector<T>&)>& change) {
  std::vector<T> u;
  for (const auto field : kFields) u.push_back(T(givens.*field));
  change(u);
  std::vector<T> values;
  for (const Formula& record : records()) values.push_back(record(std::span<const T>(u)));
  return values;
}

/// The stroke over time, numerically: y(t) = S s(2 V t / S_rev) over half a revolution.
struct Simulation {
  double peak_acceleration = 0, peak_slope = 0, peak_torque = 0;

  Simulation(const Cutter& c, const Law<double>& law, double radius) {
    constexpr int kSteps = 8000;
    const double time = kPi * (c.cutter_diameter - 2 * c.depth) / (2 * c.block_speed);
    const double omega = kPi / time, dt = time / kSteps;
    const auto y = [&](int i) { return c.stroke * law(double(i) / kSteps).s; };
    for (int i = 1; i < kSteps; ++i) {
      const double velocity = (y(i + 1) - y(i - 1)) / (2 * dt);
      const double acceleration = (y(i + 1) - 2 * y(i) + y(i - 1)) / (dt * dt);
      peak_acceleration = std::max(peak_acceleration, std::abs(acceleration));
      // The cam unrolled: while it turns by omega dt, its rim moves by radius omega dt.
      peak_slope = std::max(peak_slope, std::abs(velocity) / (radius * omega));
      peak_torque = std::max(peak_torque, std::abs(c.mass * acceleration * velocity) / omega);
    }
  }
};

}  // namespace

TEST_CASE("the givens are the paper's", "[spine-cutter]") {
  const Cutter c;
  CHECK(results(c).size() == 9);
  const std::vector<double> expected{50, 17, 40, 0.3, 0.4, 2.4, 30};
  const auto listed = givens(c);
  REQUIRE(listed.size() == expected.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    INFO(listed[i].name);
    CHECK(listed[i].value == Approx(expected[i]).epsilon(1e-14));
  }
}

TEST_CASE("chord, angle and blades agree with other forms of (1) to (3)", "[spine-cutter]") {
  for (const double h : {1e-4, 4e-4, 6e-4, 8e-4, 1e-3, 5e-3, 0.024}) {
    INFO("h = " << h);
    const PlainNumbers numbers;
    SpineCutter c;
    c.depth = h;
    const double r = plain(c.cutter_diameter) / 2;
    // As printed, by Pythagoras; and the half angle whose cosine is (r - h) / r.
    CHECK(plain(c.chord_of_contact()) ==
          Approx(2 * std::sqrt(r * r - (r - h) * (r - h))).epsilon(1e-12));
    const double angle = 2 * std::acos(1 - 2 * h / plain(c.cutter_diameter));
    CHECK(plain(c.contact_angle()) == Approx(angle).epsilon(1e-11));
    CHECK(plain(c.blades_in_contact()) ==
          Approx(angle / (2 * kPi / plain(c.blades))).epsilon(1e-11));
  }
}

TEST_CASE("path and angular velocity agree: a revolution takes 2 pi / omega", "[spine-cutter]") {
  const PlainNumbers numbers;
  SpineCutter c;
  c.block_speed = 1.2;
  CHECK(plain(c.angular_velocity()) == Approx(1.2 / (0.025 - 0.0004)).epsilon(1e-14));
  CHECK(plain(c.path_per_revolution()) ==
        Approx(plain(c.block_speed) * 2 * kPi / plain(c.angular_velocity())).epsilon(1e-14));
}

TEST_CASE("radius, force and torque agree with the simulated motion", "[spine-cutter]") {
  for (const char* name : {"modified-sine", "poly-3-4-5", "cycloidal", "cosine"}) {
    INFO(name);
    Cutter c;
    c.depth = 1e-3;
    c.pressure_angle = 0.4;
    const Law<double> law = find_law(name).law();
    const Peaks<double> peak = peaks(law);
    const PlainNumbers numbers;
    const SpineCutter machine = cutter_of(c);
    const Simulation simulated(c, law, plain(machine.minimum_cam_radius(peak.max_velocity())));
    CHECK(simulated.peak_slope == Approx(std::tan(0.4)).epsilon(1e-6));
    CHECK(c.mass * simulated.peak_acceleration ==
          Approx(plain(machine.peak_inertia_force(peak.max_acceleration()))).epsilon(1e-5));
    CHECK(simulated.peak_torque ==
          Approx(plain(machine.peak_drive_torque(peak.max_dynamic_moment()))).epsilon(1e-5));
  }
}

TEST_CASE("the printed force is half the physical one", "[spine-cutter]") {
  const PlainNumbers numbers;
  const SpineCutter c;
  const double path = kPi * (0.050 - 2 * 0.0004);
  CHECK(plain(c.printed_inertia_force(6)) ==
        Approx(2.4 * 6 * 2 * 0.040 * 0.3 * 0.3 / (path * path)).epsilon(1e-14));
  CHECK(plain(c.peak_inertia_force(6)) ==
        Approx(2 * plain(c.printed_inertia_force(6))).epsilon(1e-15));
}

TEST_CASE("duals carry the gradient by every given", "[spine-cutter]") {
  for (std::size_t field = 0; field < kFields.size(); ++field) {
    const auto exact = results_at<Dual>(Cutter(), [field](auto& u) { u[field].v[0] = 1; });
    const auto moved = [&](double by) {
      Cutter c;
      c.*kFields[field] += by;
      return results(c);
    };
    const double step = 1e-3 * Cutter{}.*kFields[field];
    const auto up = moved(step), down = moved(-step), up2 = moved(2 * step),
               down2 = moved(-2 * step);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      INFO("result " << i << " by given " << field);
      // Central differences with Richardson: error of fourth order.
      const double slope = (8 * (up[i] - down[i]) - (up2[i] - down2[i])) / (12 * step);
      CHECK(exact[i].a == Approx(moved(0)[i]).epsilon(1e-14));
      CHECK(exact[i].v[0] == Approx(slope).epsilon(1e-8).margin(1e-12));
      CHECK(exact[i].v[1] == 0);
    }
  }
}

TEST_CASE("intervals enclose the results over a range of depths", "[spine-cutter]") {
  const auto point = results_at<Interval>(Cutter(), [](auto&) {});
  const auto exact = results(Cutter());
  for (std::size_t i = 0; i < point.size(); ++i) {
    INFO("result " << i);
    CHECK(boost::numeric::in(exact[i], point[i]));
    CHECK(boost::numeric::width(point[i]) < 1e-13 * std::abs(exact[i]));
  }
  const auto range =
      results_at<Interval>(Cutter(), [](auto& u) { u[4] = Interval(0.0004, 0.001); });
  for (int step = 0; step <= 20; ++step) {
    Cutter c;
    c.depth = std::lerp(0.0004, 0.001, step / 20.0);
    const auto values = results(c);
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(boost::numeric::in(values[i], range[i]));
  }
}

TEST_CASE("givens are set by name or symbol, with or without unit", "[spine-cutter][givens]") {
  Cutter c;
  for (const char* text : {"cutter_diameter=60 mm", "z=21", "S_f=2 cm", "block_speed=72 m/min",
                           "h=1.0 mm", "mass=2500 g", "v=0.5 rad"}) {
    set_given(c, text);
  }
  const std::array expected{0.060, 21.0, 0.020, 1.2, 0.001, 2.5, 0.5};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(c.*kFields[i] == Approx(expected[i]).epsilon(1e-14));
  }
  set_given(c, "h=0.8");
  set_given(c, "pressure_angle=45");
  CHECK(c.depth == Approx(0.0008).epsilon(1e-14));
  CHECK(c.pressure_angle == Approx(kPi / 4).epsilon(1e-14));
}

TEST_CASE("what is listed of a given sets the same given again", "[spine-cutter][givens]") {
  Cutter from, to;
  from.stroke = 0.0371;
  from.pressure_angle = 0.61;
  for (const auto& given : givens(from)) {
    const std::string value = std::to_string(given.value);
    set_given(to, given.symbol + "=" + value + (given.unit == "1" ? "" : " " + given.unit));
  }
  for (const auto field : kFields) {
    CHECK(to.*field == Approx(from.*field).epsilon(1e-6));
  }
}

TEST_CASE("a bad given is refused, named, and changes nothing", "[spine-cutter][givens]") {
  struct Case {
    const char *text, *says, *accepts;
  };
  const Case cases[] = {{"depht=1 mm", "'depht'", "depth (h)"},
                        {"=1 mm", "''", "stroke (S_f)"},
                        {"h", "'h'", "name=value"},
                        {"", "''", "name=value"},
                        {"h=1 deg", "depth", "a length is needed"},
                        {"z=17 deg", "blades", "a plain number is needed"},
                        {"v=3 mm", "pressure_angle", "an angle is needed"},
                        {"h=", "depth", "mm"},
                        {"h=deep", "depth", "mm"},
                        {"h=0", "depth", "1e-06 .. 10000 mm"},
                        {"h=-1 mm", "depth", "1e-06 .. 10000 mm"},
                        {"v=90", "pressure_angle", "0.1 .. 89.9 deg"},
                        {"z=0.5", "blades", "1 .. 10000"},
                        {"m=nan", "mass", "kg"},
                        {"V=inf", "block_speed", "m/s"},
                        {"V=-inf m/s", "block_speed", "m/s"}};
  for (const Case& bad : cases) {
    INFO(bad.text);
    Cutter c;
    CHECK_THROWS_AS(set_given(c, bad.text), std::invalid_argument);
    CHECK_THROWS_WITH(set_given(c, bad.text), Contains(bad.says) && Contains(bad.accepts));
    for (const auto field : kFields) CHECK(c.*field == Cutter{}.*field);
  }
}

// --- The study -----------------------------------------------------------------------------------

namespace {

const SpineCutterStudy& default_study() {
  static const SpineCutterStudy study = study_spine_cutter(Cutter{});
  return study;
}

const StudyRow& row_of(const SpineCutterStudy& study, const std::string& law) {
  const auto found = std::find_if(study.rows.begin(), study.rows.end(),
                                  [&](const StudyRow& row) { return row.law == law; });
  INFO(law);
  REQUIRE(found != study.rows.end());
  return *found;
}

/// The flag by its definition: no row is as good in both and better in one (to 1e-9).
bool stands(const SpineCutterStudy& study, const StudyRow& row, bool smooth_only) {
  constexpr double kMore = 1 + 1e-9;
  if (smooth_only && !row.smooth) return false;
  return std::none_of(study.rows.begin(), study.rows.end(), [&](const StudyRow& other) {
    if (smooth_only && !other.smooth) return false;
    const bool no_worse = other.cam_radius <= row.cam_radius * kMore &&
                          other.inertia_force <= row.inertia_force * kMore;
    return no_worse && (other.cam_radius * kMore < row.cam_radius ||
                        other.inertia_force * kMore < row.inertia_force);
  });
}

}  // namespace

TEST_CASE("every row's numbers follow from its peaks and the givens", "[study]") {
  Cutter c;
  c.depth = 0.0008;
  c.mass = 3.1;
  c.block_speed = 0.9;
  const SpineCutterStudy study = study_spine_cutter(c);
  const double time = kPi * (0.050 - 2 * 0.0008) / (2 * 0.9), omega = kPi / time;
  for (const StudyRow& row : study.rows) {
    INFO(row.law);
    const double B = row.peaks.max_velocity(), C = row.peaks.max_acceleration();
    CHECK(row.cam_radius == Approx(0.040 * B / kPi * std::sqrt(3.0)).epsilon(1e-12));
    CHECK(row.drive_torque == Approx(3.1 * row.peaks.max_dynamic_moment() * 0.040 * 0.040 /
                                     (time * time * time) / omega));
    if (std::isinf(C)) {
      CHECK(std::isinf(row.inertia_force));
      CHECK(std::isinf(row.above_limit));
      continue;
    }
    CHECK(row.inertia_force == Approx(3.1 * C * 0.040 / (time * time)).epsilon(1e-12));
    CHECK(row.printed_inertia_force == Approx(row.inertia_force / 2).epsilon(1e-14));
    const double least = B < 2 ? B * B / (B - 1) : 4;
    CHECK(row.above_limit == Approx(C / least - 1).margin(1e-12));
    CHECK(row.above_limit >= 0);
    CHECK(row.inertia_force >= least_inertia_force(c, row.cam_radius) * (1 - 1e-12));
  }
}

TEST_CASE("every row's peaks bound its law tightly and its name finds it", "[study]") {
  std::set<std::string> names;
  for (const StudyRow& row : default_study().rows) {
    INFO(row.law);
    CHECK(names.insert(row.law).second);
    CHECK(find_law(row.law).name() == row.law);
    const Law<double> law = find_law(row.law).law();
    double B = 0, C = 0;
    for (int i = 1; i < 4000; ++i) {
      B = std::max(B, std::abs(law(i / 4000.0).v));
      C = std::max(C, std::abs(law(i / 4000.0).a));
    }
    CHECK(B <= row.peaks.max_velocity() * (1 + 1e-12));
    CHECK(B >= row.peaks.max_velocity() * (1 - 1e-4));
    CHECK(C <= row.peaks.max_acceleration() * (1 + 1e-12));
    CHECK(law(0.0).v == Approx(0).margin(1e-9));
    CHECK(law(1.0, Side::Left).v == Approx(0).margin(1e-9));
    if (row.smooth) CHECK(std::abs(law(0.0).a + law(1.0, Side::Left).a) < 1e-6);
  }
}

TEST_CASE("rows come by radius and then force, and the fronts are those of the definition",
          "[study]") {
  const SpineCutterStudy& study = default_study();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    INFO(row.law);
    CHECK(row.non_dominated == stands(study, row, false));
    CHECK(row.smooth_non_dominated == stands(study, row, true));
    if (i == 0) continue;
    const StudyRow& before = study.rows[i - 1];
    CHECK(std::pair(before.cam_radius, before.inertia_force) <=
          std::pair(row.cam_radius, row.inertia_force));
  }
}

TEST_CASE("trapezoidal velocity and the parabola lie on the limit curve", "[study]") {
  const SpineCutterStudy& study = default_study();
  int met = 0;
  for (const StudyRow& row : study.rows) {
    const bool on_limit = row.law == "parabolic" || row.law.starts_with("trapezoidal-velocity");
    INFO(row.law);
    CHECK((row.above_limit == 0) == on_limit);
    if (!on_limit) continue;
    ++met;
    CHECK(row.non_dominated);
    CHECK_FALSE(row.smooth);  // acceleration jumps within the stroke
    CHECK(least_inertia_force(study.cutter, row.cam_radius) ==
          Approx(row.inertia_force).epsilon(1e-12));
  }
  CHECK(met >= 3);
  CHECK(std::isinf(least_inertia_force(study.cutter, minimum_cam_radius(study.cutter, 1))));
}

TEST_CASE("the paper's six laws are there with its radii and, at 1 mm depth, its forces",
          "[study]") {
  Cutter c;
  c.depth = 0.001;
  const SpineCutterStudy study = study_spine_cutter(c);
  struct Published {
    const char* law;
    double radius, force;
  };
  // Table 2, but where it is known wrong: the cosine's radius (B = pi / 2), and the force of A = 6,
  // which the paper read off a grid. With C = 7.092512 it is 5.390.
  const Published table[] = {{"polynomial-7 A=6", 46.86, 5.39},
                             {"polynomial-7 A=48", 37.21, 4.33},
                             {"cosine", 34.64, 3.75},
                             {"cubic", 33.08, 4.56},
                             {"polynomial-5 alpha=-3", 35.56, 3.54},
                             {"polynomial-5 alpha=-5", 37.21, 3.63}};
  REQUIRE(published_laws().size() == std::size(table));
  for (std::size_t i = 0; i < std::size(table); ++i) {
    CHECK(published_laws()[i] == table[i].law);
    const StudyRow& row = row_of(study, table[i].law);
    CHECK(row.published);
    CHECK(std::abs(row.cam_radius * 1e3 - table[i].radius) <= 0.0051);
    CHECK(std::abs(row.printed_inertia_force - table[i].force) <= 0.0051);
  }
  CHECK(std::count_if(study.rows.begin(), study.rows.end(),
                      [](const StudyRow& row) { return row.published; }) == 6);
}

TEST_CASE("smooth means continuous acceleration through both turns", "[study]") {
  const SpineCutterStudy& study = default_study();
  // A cosine goes on as a cosine; a cycloid stands still with no acceleration; the double harmonic
  // turns with acceleration at one end only; a parabola jumps in the middle.
  for (const char* law :
       {"cosine", "harmonic", "cycloidal", "poly-3-4-5", "cubic", "elliptic n=1.1"}) {
    CHECK(row_of(study, law).smooth);
  }
  for (const char* law : {"double-harmonic", "rothbart-8", "parabolic", "half-ellipse-velocity"}) {
    CHECK_FALSE(row_of(study, law).smooth);
  }
}

TEST_CASE("the recommendation names rows of the smooth front, each the best of its kind",
          "[study]") {
  const SpineCutterStudy& study = default_study();
  const StudyRow& smallest = study.rows.at(study.smallest_cam);
  const StudyRow& calmest = study.rows.at(study.least_force);
  const StudyRow& middle = study.rows.at(study.compromise);
  for (const StudyRow* named : {&smallest, &calmest, &middle}) {
    CHECK(named->smooth_non_dominated);
    CHECK_THAT(study.recommendation, Contains(named->label + " (R "));
  }
  for (const StudyRow& row : study.rows) {
    if (!row.smooth) continue;
    INFO(row.law);
    CHECK(smallest.cam_radius <= row.cam_radius * (1 + 1e-9));
    CHECK(calmest.inertia_force <= row.inertia_force * (1 + 1e-9));
    CHECK(middle.cam_radius * middle.inertia_force <=
          row.cam_radius * row.inertia_force * (1 + 1e-9));
  }
}

TEST_CASE("the study of other givens scales as the machine does", "[study]") {
  struct Scaling {
    const char* set;
    double radius, force, torque;
  };
  // tan 45 / tan 30 = sqrt 3 for the radius; half the path per revolution, 4 times the force.
  const Scaling scalings[] = {{"V=0.6 m/s", 1, 4, 4},
                              {"S_f=80 mm", 2, 2, 4},
                              {"m=7.2 kg", 1, 3, 3},
                              {"z=21", 1, 1, 1},
                              {"v=45 deg", 1 / std::sqrt(3.0), 1, 1},
                              {"D_f=25.4 mm", 1, 4, 4}};
  const SpineCutterStudy& before = default_study();
  for (const auto& [set, radius, force, torque] : scalings) {
    Cutter c;
    set_given(c, set);
    const SpineCutterStudy after = study_spine_cutter(c);
    CHECK(after.rows.size() == before.rows.size());
    for (const StudyRow& row : after.rows) {
      INFO(set << ", " << row.law);
      const StudyRow& old = row_of(before, row.law);
      CHECK(row.cam_radius == Approx(old.cam_radius * radius).epsilon(1e-12));
      if (std::isfinite(old.inertia_force)) {
        CHECK(row.inertia_force == Approx(old.inertia_force * force).epsilon(1e-12));
      }
      CHECK(row.drive_torque == Approx(old.drive_torque * torque).epsilon(1e-12));
      CHECK(row.smooth_non_dominated == old.smooth_non_dominated);
      CHECK(row.non_dominated == old.non_dominated);
    }
  }
}

TEST_CASE("a depth of half the diameter or more is refused", "[study]") {
  for (const double depth : {0.025, 0.026, 0.05}) {
    Cutter c;
    c.depth = depth;
    CHECK_THROWS_AS(study_spine_cutter(c), std::invalid_argument);
    CHECK_THROWS_WITH(study_spine_cutter(c), Contains("depth") && Contains("25 mm"));
  }
  Cutter deep;
  deep.depth = 0.0249;
  CHECK_NOTHROW(study_spine_cutter(deep));
}

}  // namespace camlaw::problems::spine_cutter_test
