// SPDX-License-Identifier: MIT
// What camlaw export writes of an end cam with an arm: a curve that is open, in every format.
#include <cmath>
#include <numbers>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::developed_export_test {
namespace {

std::string end_cam(const Folder& folder) {
  const std::string path = folder / "arm.toml";
  std::ofstream(path) << "mechanism = 'end-cam-oscillating'\n[program]\nsegments = ["
                         "{angle = 120, law = 'poly-3-4-5'}, {law = 'poly-3-4-5'}]\n";
  return path;
}

}  // namespace

TEST_CASE("an end cam with an arm is exported as an open curve", "[export]") {
  const Folder folder;
  const std::string file = end_cam(folder), out = folder / "cam.json";
  for (const char* radius : {"radius=50 mm", "radius=76 mm", "radius=77 mm"}) {
    INFO(radius);
    const std::string said =
        done({"export", file, "--set", radius, "--curve", "pitch", "--out", out});
    CHECK_THAT(said, Contains("open") && !Contains("closed") && !Contains("jumps"));
    CHECK_FALSE(ParsedJson::parse(read(out))["curves"][0]["closed"].get<bool>());
  }
  // The last of even steps is a circumference behind the first: 2 pi 50 mm.
  const CsvRows rows =
      csv_of(done({"export", file, "--format", "csv", "--curve", "pitch", "--step", "1 deg"}));
  const double first = std::stod(rows[rows.size() - 361][2]), last = std::stod(rows.back()[2]);
  CHECK(std::stod(rows.back()[1]) == 360);
  CHECK(last - first == Approx(100 * std::numbers::pi).margin(2e-6));
  CHECK(rows.back()[3] == rows[rows.size() - 361][3]);
}

TEST_CASE("an end cam with an arm is cut, measured and drawn as what it is", "[export]") {
  const Folder folder;
  const std::string file = end_cam(folder);
  CHECK_THAT(done({"export", file, "--format", "gcode", "--out", folder / "cam.nc"}),
             Contains("open"));
  CHECK_THAT(done({"export", file, "--format", "inspection"}), Contains("point,cam_angle [deg]"));
  done({"export", file, "--drawing", "--out", folder / "cam.dxf"});
  const std::string drawing = read(folder / "cam.dxf");
  const std::string entities = drawing.substr(drawing.find("\nENTITIES\n"));
  CHECK_THAT(entities, Contains("\nPITCH_CURVE\n") && Contains("\nROTATION\n") &&
                           !Contains("\nCENTRE\n") && !Contains("radius of the profile"));
  CHECK_THAT(failed({"export", file, "--format", "dxf", "--bore", "10 mm", "--drawing"}, 2),
             Contains("--bore and --keyway are for disc cams"));
}

TEST_CASE("a drawing in inches has its notes in inches", "[export]") {
  const Folder folder;
  const std::string path = folder / "jump.toml";
  std::ofstream(path) << "mechanism = 'disc-cam-roller'\n[constants]\nstroke = 60\n[program]\n"
                         "matched = 'displacement'\nsegments = ["
                         "{name = 'rise', angle = 60, law = 'constant-velocity'},"
                         "{name = 'back', law = 'cycloidal'}]\n";
  const std::string said =
      done({"export", path, "--unit", "inch", "--curve", "profile", "--out", folder / "cam.dxf"});
  CHECK_THAT(said, Contains(" in at 60 deg") && !Contains(" mm at 60 deg"));
}

}  // namespace camlaw::cli::developed_export_test
