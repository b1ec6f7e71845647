// SPDX-License-Identifier: MIT
// The cams of a parallel index drive as they are drawn: each point of a flank is where a roller of
// the cam's own ring touches it, as the turret's motion alone places the roller.
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "problems/statement/parameters.h"
#include "tests/cli/dxf_reader.h"

namespace camlaw::cli::index_export_test {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

const std::string kDrive = testing::source("problems/index_drives/parallel_eight.toml");

/// The turret of a drive whose index is a modified sine of 200 deg after a dwell of 80 deg, with
/// nothing of the model but where its rollers are.
struct Turret {
  double distance = 170, radius = 120, roller = 8;
  int rollers = 8, plates = 3;
  Law<double> law = find_law("modified-sine").law();

  double step() const { return 2 * kPi / (rollers * plates); }
  /// rad, by the cam's angle, deg, which may lie in the next cycle.
  double turned(double angle) const {
    const double cycle = std::floor(angle / 360), within = angle - 360 * cycle;
    const double x = std::clamp((within - 80) / 200, 0.0, 1.0);
    return 2 * kPi / 8 * (cycle + law(x).s);
  }
  /// The least distance from the surfaces of the rollers of a cam's ring, mm; at rest one of the
  /// first ring stands (plates - 1) / 2 steps beyond the line of centres.
  double gap(const Complex& point, int plate, double angle) const {
    double least = 1e9;
    for (int k = 0; k < rollers; ++k) {
      const double psi =
          (0.5 * (plates - 1) - plate) * step() + 2 * kPi * k / rollers + turned(angle);
      const Complex centre =
          (distance - std::polar(radius, -psi)) * std::polar(1.0, -angle * kDegree);
      least = std::min(least, std::abs(point - centre) - roller);
    }
    return least;
  }
};

/// Points of each curve of a CSV, with their angles, deg.
std::map<std::string, std::vector<std::pair<double, Complex>>> curves_of_csv(
    const std::string& text) {
  std::map<std::string, std::vector<std::pair<double, Complex>>> curves;
  for (const auto& row : csv_of(text)) {
    if (row.size() < 4 || row[0] == "curve" || row[0].starts_with("#")) continue;
    curves[row[0]].emplace_back(std::stod(row[1]), Complex(std::stod(row[2]), std::stod(row[3])));
  }
  return curves;
}

/// The distance of a point from the lines between others, mm.
double distance_to(const Complex& point, const std::vector<std::pair<double, Complex>>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Complex from = line[i - 1].second, way = line[i].second - from;
    const double share =
        std::clamp(std::real((point - from) * std::conj(way)) / std::norm(way), 0.0, 1.0);
    least = std::min(least, std::abs(point - from - share * way));
  }
  return least;
}

Words with(const std::vector<std::string>& more) {
  Words words{"export", kDrive};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("flanks of an index drive are written where its rollers touch them",
          "[export][index-drives]") {
  const Folder folder;
  const std::string path = folder / "flanks.csv";
  run(with({"--out", path}));
  const auto curves = curves_of_csv(read(path));
  REQUIRE(curves.size() == 6);
  const Turret turret;
  double covered = 0;
  for (int plate = 0; plate < 3; ++plate) {
    for (const char* const kind : {"driving", "holding"}) {
      const std::string name = fmt::format("cam {} {} profile", plate + 1, kind);
      INFO(name);
      REQUIRE(curves.contains(name));
      const auto& points = curves.at(name);
      REQUIRE(points.size() > 20);
      for (std::size_t i = 0; i < points.size(); ++i) {
        // The rollers of this ring touch it there, and none stands in it.
        CHECK(std::abs(turret.gap(points[i].second, plate, points[i].first)) < 1e-4);
        if (i > 0) CHECK(points[i].first > points[i - 1].first);
      }
      covered += points.back().first - points.front().first;
      // Between the points the flank is within the tolerance of the lines.
      for (std::size_t i = 1; i < points.size(); ++i) {
        const Complex middle = 0.5 * (points[i - 1].second + points[i].second);
        const double angle = 0.5 * (points[i - 1].first + points[i].first);
        CHECK(turret.gap(middle, plate, angle) > -0.05);
      }
    }
  }
  CHECK(covered == Approx(720).margin(1e-5));  // one drives and one holds, all over the cycle
}

TEST_CASE("a drawing of an index drive has a layer for each flank, as ezdxf reads it",
          "[export][index-drives]") {
  const Folder folder;
  for (const char* const form : {"spline", "arcs", "lines"}) {
    run(with({"--as", form, "--out", folder / "cams.dxf"}));
    const std::string seen = read_by_ezdxf(folder / "cams.dxf");
    CHECK_THAT(seen, Contains("errors 0"));
    for (const char* const layer : {"CAM_1_DRIVING_PROFILE", "CAM_3_HOLDING_PROFILE"}) {
      CHECK_THAT(seen, Contains(std::string("layer ") + layer));
    }
    if (std::string(form) != "spline") continue;
    run(with({"--out", folder / "flanks.csv"}));
    const auto curves = curves_of_csv(read(folder / "flanks.csv"));
    for (int plate = 0; plate < 3; ++plate) {
      for (const auto& [kind, word] : {std::pair{"DRIVING", "driving"}, {"HOLDING", "holding"}}) {
        const auto found = entities(seen, fmt::format("SPLINE CAM_{}_{}_PROFILE", plate + 1, kind));
        REQUIRE(found.size() == 1);
        const auto& points = curves.at(fmt::format("cam {} {} profile", plate + 1, word));
        for (std::size_t i = 0; i + 2 < found[0].size(); i += 3) {
          const Complex point(found[0][i + 1], found[0][i + 2]);
          CHECK(distance_to(point, points) < 0.02);
        }
      }
    }
  }
  run(with({"--drawing", "--out", folder / "shop.dxf"}));
  const std::string shop = read_by_ezdxf(folder / "shop.dxf");
  CHECK_THAT(shop, Contains("errors 0") && Contains(" SHAFT "));
}

TEST_CASE("a cam with several flanks of a kind numbers them", "[export][index-drives]") {
  const ParsedJson json = ParsedJson::parse(
      run(with({"--set", "rollers=16", "--set", "plates=2", "--format", "json"})).out);
  std::vector<std::string> names;
  for (const auto& curve : json.at("curves")) names.push_back(curve.at("name"));
  CHECK(names ==
        std::vector<std::string>{"cam 1 first driving profile", "cam 1 second driving profile",
                                 "cam 1 first holding profile", "cam 1 second holding profile",
                                 "cam 2 first driving profile", "cam 2 second driving profile",
                                 "cam 2 first holding profile", "cam 2 second holding profile"});
}

TEST_CASE("an export says where a roller cuts into a flank of an index drive",
          "[export][index-drives]") {
  const auto notes = [](const std::vector<std::string>& more) {
    const Folder folder;
    std::vector<std::string> words{"--out", folder / "flanks.dxf"};
    words.insert(words.end(), more.begin(), more.end());
    return run(with(words)).out;
  };
  CHECK_THAT(notes({}), !Contains("a roller cuts"));
  // 1 + 4 pi / (4 + pi) 45 / 200 = 1.396 times R_t / a: the rollers run far ahead of the cams.
  CHECK_THAT(notes({"--set", "turret_radius=150 mm"}),
             Contains("a roller cuts") && Contains("the flank is not whole"));
}

TEST_CASE("what is of one closed curve is refused for an index drive", "[export][index-drives]") {
  // Whatever else is asked for, the answer names no option that leads to another refusal.
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--curve", "profile"}, {"--tool", "10 mm"}}) {
    std::vector<std::string> words = with({"--format", "gcode"});
    words.insert(words.end(), more.begin(), more.end());
    CHECK_THAT(failed(words, 2), Contains("--format gcode does not apply to parallel-index-cam") &&
                                     Contains("a gcode program follows one curve") &&
                                     !Contains("--tool"));
  }
  CHECK_THAT(failed(with({"--format", "inspection"}), 2), Contains("is of one curve"));
  for (const char* const format : {"csv", "dxf", "svg", "json"}) {
    CHECK_THAT(failed(with({"--format", format, "--step", "1 deg"}), 2),
               Contains("--step does not apply to parallel-index-cam") &&
                   Contains("a step divides a whole cycle"));
  }
  CHECK(run(with({"--format", "dxf", "--tolerance", "0.02 mm"})).status == 0);
  CHECK_THAT(failed(with({"--curve", "pitch", "--format", "csv"}), 2),
             Contains("has no curve 'pitch'; it has profile, second-profile"));
  CHECK_THAT(failed({"export", testing::source("problems/index_drives/barrel_eight.toml"),
                     "--format", "csv"},
                    2),
             Contains("has no profile to export"));
}

}  // namespace camlaw::cli::index_export_test
