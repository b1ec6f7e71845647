// SPDX-License-Identifier: MIT
// What camlaw export writes for the workshop: drawings with their dimensions, leads, roughing
// passes, compensation, inches, inspection tables, and results that were changed by hand.
#include <cmath>
#include <numbers>

#include "output/answers/cam_export.h"
#include "output/export/plane_curve.h"
#include "output/export/solid/step_file.h"
#include "tests/cli/dxf_reader.h"
#include "tests/cli/gcode_reader.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::shop_export_test {
namespace {

using Eigen::Vector2d;
using problems::PlaneCurve;

const std::string kRoller = testing::source("problems/cams/roller_least_base.toml");

PlaneCurve exact_curve(const std::string& option) {
  return problems::cam_curves(problems::read_problem_file(kRoller), option).front();
}

/// The least distance of points from a curve, mm.
double nearest(const std::vector<Vector2d>& points, const PlaneCurve& curve) {
  constexpr int kSteps = 3600;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    const Vector2d q = curve.at(optim::even_place(curve.begin(), curve.end(), kSteps, i)).at;
    for (const Vector2d& p : points) least = std::min(least, (p - q).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("a drawing for the shop has bore, keyway, follower, sense of rotation and title block",
          "[export][shop]") {
  const Folder folder;
  done({"export", kRoller, "--drawing", "--bore", "25 mm", "--keyway", "8 x 3.3 mm", "--out",
        folder / "cam.dxf"});
  const std::string text = read_by_ezdxf(folder / "cam.dxf");
  CHECK_THAT(text, Contains("errors 0\n") && Contains("units 4\n"));
  // The title block to the right of the cam is within the drawing's extent.
  const std::string raw = read(folder / "cam.dxf"), extent = "$EXTMAX\n 10\n";
  REQUIRE(raw.find(extent) != std::string::npos);
  const double right = std::stod(raw.substr(raw.find(extent) + extent.size()));
  for (const auto& line : entities(text, "LINE TITLE")) {
    CHECK(std::max(line[0], line[2]) <= right + 1e-9);
  }
  for (const char* layer :
       {"SHAFT", "CENTRE", "ZERO_MARK", "FOLLOWER", "ROTATION", "TITLE", "PROFILE"}) {
    CHECK_THAT(text, Contains(std::string("layer ") + layer + " "));
  }
  // The bore's arc ends where the keyway begins: half its width from the middle.
  const auto bore = entities(text, "ARC SHAFT");
  REQUIRE(bore.size() == 1);
  CHECK(bore[0][2] == Approx(12.5));
  const double end = bore[0][3] * std::numbers::pi / 180;
  CHECK(12.5 * std::cos(end) == Approx(-4).margin(1e-6));
  const auto key = entities(text, "LINE SHAFT");
  REQUIRE(key.size() == 3);
  CHECK(key[1][1] == Approx(12.5 + 3.3));
  // The roller touches the profile at cam angle 0.
  const auto statement = problems::read_problem_file(kRoller);
  const auto roller = entities(text, "CIRCLE FOLLOWER");
  REQUIRE(roller.size() == 1);
  const Vector2d centre(roller[0][0], roller[0][1]);
  CHECK((centre - exact_curve("pitch").at({0}).at).norm() < 1e-6);
  CHECK((centre - exact_curve("profile").at({0}).at).norm() == Approx(roller[0][2]).margin(1e-6));
  CHECK_THAT(text, Contains("TEXT TITLE") && Contains("turns counterclockwise as drawn") &&
                       Contains("bore 25.0000 mm in diameter") &&
                       Contains("keyway 8.0000 mm wide, 3.3000 mm deep"));
  // In the cam's axes the contact goes round against the cam's own turn.
  const Vector2d early = exact_curve("pitch").at({1}).at, first = exact_curve("pitch").at({0}).at;
  CHECK(first.x() * early.y() - first.y() * early.x() < 0);
  const auto refused = [&](Words more) {
    Words words{"export", kRoller, "--format", "dxf", "--drawing"};
    words.insert(words.end(), more.begin(), more.end());
    return failed(words, 2);
  };
  CHECK_THAT(refused({"--bore", "300 mm"}), Contains("reaches the profile"));
  CHECK_THAT(refused({"--bore", "25 mm", "--keyway", "26 x 3 mm"}),
             Contains("too large for a bore"));
  CHECK_THAT(refused({"--bore", "25 mm", "--keyway", "8 mm"}), Contains("width x depth"));
  CHECK_THAT(failed({"export", kRoller, "--format", "svg", "--drawing"}, 2), Contains("for dxf"));
  CHECK_THAT(failed({"export", kRoller, "--format", "dxf", "--bore", "25 mm"}, 2),
             Contains("dxf with --drawing"));
}

TEST_CASE("the title block stands clear of cam and follower", "[export][shop]") {
  const Folder folder;
  for (const char* name : {"oscillating_flat_least_base", "leading_least_base", "roller_least_base",
                           "oscillating_end_least_radius"}) {
    INFO(name);
    done({"export", testing::source("problems/cams/") + name + ".toml", "--drawing", "--out",
          folder / "cam.dxf"});
    const std::string text = read_by_ezdxf(folder / "cam.dxf");
    double left = 1e9, right = -1e9;
    for (const auto& line : entities(text, "LINE TITLE")) {
      left = std::min({left, line[0], line[2]});
    }
    for (const char* layer : {"LINE FOLLOWER", "LINE ROTATION", "LINE CENTRE"}) {
      for (const auto& line : entities(text, layer)) right = std::max({right, line[0], line[2]});
    }
    for (const auto& circle : entities(text, "CIRCLE FOLLOWER")) {
      right = std::max(right, circle[0] + circle[2]);
    }
    CHECK(left > right + 10);
  }
}

TEST_CASE("the wall is judged with the bore and the keyway that are drawn", "[export][shop]") {
  const Folder folder;
  // The wall is what the base circle leaves, and must be a quarter of the bore's radius.
  const Words cam{"export", testing::source("problems/cams/roller_least_base.toml"),
                  "--set",  "base_radius=70 mm",
                  "--set",  "bore_radius=20 mm"};
  const auto drawn = [&](Words more) {
    more.insert(more.begin(), cam.begin(), cam.end());
    more.insert(more.end(), {"--drawing", "--out", folder / "cam.dxf"});
    const std::string said = done(more);
    return said + read(folder / "cam.dxf");
  };
  const std::string sound = drawn({});
  CHECK_THAT(sound, !Contains("cannot be built"));
  // 70 - 60 mm are less than a quarter of 60 mm.
  const std::string wide = drawn({"--bore", "120 mm"});
  CHECK_THAT(wide, Contains("cannot be built: wall 10 mm at 0 deg") && Contains("1 fails") &&
                       Contains("bore_radius=60 mm") && Contains("bore_radius 60.0000 mm"));
  // sqrt(64.9^2 + 6^2) - 20 = 45.1768 mm, and a quarter of 20 mm more is above 70 - 20 mm.
  const std::string deep = drawn({"--keyway", "12 x 44.9 mm"});
  CHECK_THAT(deep,
             Contains("cannot be built: wall 50 mm at 0 deg") && Contains("keyway_depth=45.1767"));
  CHECK_THAT(drawn({"--keyway", "12 x 44.7 mm"}), !Contains("cannot be built"));
  CHECK_THAT(drawn({"--bore", "4.724409449 in"}), Contains("cannot be built: wall 10 mm"));
  // Of solids as of drawings, and of a cam on a shaft.
  const std::string shaft = testing::source("problems/shaft/two_cams.toml");
  const auto of_shaft = [&](Words more) {
    more.insert(more.begin(), {"export", shaft, "--cam", "infeed", "--drawing", "--json", "--out",
                               folder / "cam.dxf"});
    return json_of(more);
  };
  const auto wall = [](const ParsedJson& said) {
    for (const auto& check : said["buildable"]["checks"]) {
      if (check["check"] == "wall") return check;
    }
    return ParsedJson();
  };
  CHECK(wall(of_shaft({}))["answer"] == "not checked");
  const ParsedJson big = wall(of_shaft({"--bore", "140 mm", "--keyway", "12 x 3 mm"}));
  CHECK(big["answer"] == "fails");
  CHECK(big["value"].get<double>() == Approx(10));
  CHECK(big["bound"].get<double>() == Approx(70.0 / 4 + std::hypot(73, 6) - 70));
}

TEST_CASE("the keyway that the shipped cam is drawn with is the one that its wall is counted from",
          "[export][shop]") {
  const Folder folder;
  const std::string file = testing::source("problems/cams/smallest_buildable.toml");
  done({"export", file, "--drawing", "--keyway", "12 x 3.3 mm", "--out", folder / "cam.dxf"});
  const auto key = entities(read_by_ezdxf(folder / "cam.dxf"), "LINE SHAFT");
  REQUIRE(key.size() == 3);
  const auto statement = problems::read_problem_file(file);
  const auto parameter = statement.mechanism->parameter("bore_radius");
  const double bore = statement.constants[parameter];
  const double corner = std::hypot(key[1][0], key[1][1]);
  CHECK(corner - bore == Approx(std::hypot(20 + 3.3, 6.0) - 20).margin(1e-4));
  // Which the file states to the hundredth, rounded up.
  const std::string stated = "keyway_depth = \"", text = read(file);
  const double depth = std::stod(text.substr(text.find(stated) + stated.size()));
  CHECK(depth >= corner - bore);
  CHECK(depth < corner - bore + 0.01);
}

TEST_CASE("a keyway points to the zero mark, also where that is not on the y axis",
          "[export][shop]") {
  const Folder folder;
  done({"export", testing::source("problems/cams/leading_least_base.toml"), "--drawing", "--bore",
        "6 mm", "--keyway", "2 x 1 mm", "--out", folder / "cam.dxf"});
  const std::string text = read_by_ezdxf(folder / "cam.dxf");
  const auto key = entities(text, "LINE SHAFT"), mark = entities(text, "LINE ZERO_MARK");
  REQUIRE(key.size() == 3);
  REQUIRE(mark.size() == 1);
  const Vector2d bottom(key[1][0] + key[1][2], key[1][1] + key[1][3]), zero(mark[0][2], mark[0][3]);
  CHECK(zero.x() > 1);
  CHECK((bottom / 2 - 4 * zero.normalized()).norm() < 1e-6);
}

TEST_CASE("drawings and programs in inches are those in millimetres, 25.4 times as small",
          "[export][shop][long]") {
  const Folder folder;
  done({"export", kRoller, "--unit", "inch", "--drawing", "--as", "lines", "--curve", "profile",
        "--step", "1 deg", "--out", folder / "cam.dxf"});
  const std::string text = read_by_ezdxf(folder / "cam.dxf");
  CHECK_THAT(text, Contains("errors 0\n") && Contains("units 1\n"));
  const auto profile = entities(text, "LWPOLYLINE PROFILE");
  REQUIRE(profile.size() == 1);
  const PlaneCurve exact = exact_curve("profile");
  for (int i = 0; i < 360; i += 17) {
    const auto k = static_cast<std::size_t>(i);
    const Vector2d at(profile[0][1 + 2 * k], profile[0][2 + 2 * k]);
    CHECK((25.4 * at - exact.at({static_cast<double>(i)}).at).norm() < 3e-5);
  }
  const std::string program = done({"export", kRoller, "--format", "gcode", "--unit", "inch",
                                    "--depth", "0.5", "--feed", "10", "--tolerance", "0.0005"});
  CHECK_THAT(program,
             Contains("\nG20 G17 G90 G40 G94\n") && Contains(" in of the exact curve, proved"));
  const GcodeRun run = run_gcode(program);
  CHECK(run.in_inches);
  CHECK(run.cut_depth == -0.5);
  CHECK(run.feed == 10);
  const PlaneCurve cutter = exact_curve("cutter");
  double worst = 0;
  for (int i = 0; i < 360; i += 7) {
    const Vector2d p = cutter.at({static_cast<double>(i)}).at / 25.4;
    double least = 1e9;
    for (std::size_t k = 1; k < run.cut.size(); ++k) {
      const Vector2d a = run.cut[k - 1], way = run.cut[k] - a;
      const double length = way.squaredNorm();
      const double t = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
      least = std::min(least, (p - a - t * way).norm());
    }
    worst = std::max(worst, least);
  }
  CHECK(worst <= 0.0005);
  const ParsedJson json = json_of({"export", kRoller, "--format", "json", "--unit", "inch"});
  CHECK(json["curves"][0].contains("x_in"));
  CHECK(json["motion"]["slave"] == "displacement [in]");
  CHECK_THAT(done({"export", kRoller, "--format", "svg", "--unit", "inch"}),
             Contains("in\" height="));
  CHECK_THAT(done({"export", kRoller, "--format", "csv", "--unit", "inch"}), Contains("x [in]"));
}

TEST_CASE("the tool comes to its path and leaves it outside the profile, tangent to the path",
          "[export][shop][long]") {
  const GcodeRun run = run_gcode(done({"export", kRoller, "--format", "gcode", "--lead", "6 mm",
                                       "--allowances", "0.5, 0.1 mm", "--depth", "3 mm"}));
  REQUIRE(run.passes.size() == 3);
  const auto statement = problems::read_problem_file(kRoller);
  const PlaneCurve cutter = exact_curve("cutter"), profile = exact_curve("profile");
  const double tool = (cutter.at({0}).at - profile.at({0}).at).norm();
  const double left[] = {0.5, 0.1, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = run.passes[i] + 1, to = i + 1 < 3 ? run.passes[i + 1] : run.cut.size();
    const std::vector<Vector2d> pass(run.cut.begin() + static_cast<std::ptrdiff_t>(from),
                                     run.cut.begin() + static_cast<std::ptrdiff_t>(to));
    CHECK(nearest(pass, profile) == Approx(tool + left[i]).margin(0.012));
  }
  // The last pass ends 6 mm beside the path, where its lead out ends.
  CHECK(nearest({run.cut.back()}, cutter) > 3);
  CHECK_THAT(failed({"export", kRoller, "--format", "gcode", "--allowances", "0.1, 0.5 mm"}, 2),
             Contains("less than the one before"));
}

TEST_CASE("a controller's compensation begins before the lead and ends behind it",
          "[export][shop][long]") {
  const std::string text = done({"export", kRoller, "--format", "gcode", "--curve", "profile",
                                 "--lead", "12 mm", "--compensation", "3"});
  const GcodeRun run = run_gcode(text);
  // The profile runs clockwise, as the pitch curve does, and its outside is to the left.
  CHECK(run.compensation == std::vector<int>{41, 40});
  CHECK_THAT(text, Contains("G1 G41 D3 X"));
  const auto refused = [](Words more) {
    Words words{"export", kRoller, "--format", "gcode", "--compensation", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return failed(words, 2);
  };
  CHECK_THAT(refused({}), Contains("--curve profile"));
  CHECK_THAT(refused({"--lead", "12 mm", "--curve", "pitch"}), Contains("--curve profile"));
  // The tool's centre, 10 mm beside, has no arc inside a lead of 10 mm; the file says what has one.
  for (const char* lead : {"5 mm", "10 mm"}) {
    CHECK_THAT(refused({"--lead", lead, "--curve", "profile", "--set", "cutter_radius=10 mm"}),
               Contains("is not larger than the tool's radius, cutter_radius = 10 mm"));
  }
  CHECK_THAT(text,
             Contains("compensate for the tool, whose radius must be below the lead's 12 mm"));
  // A path that is beside the profile already is not to be compensated again.
  CHECK_THAT(refused({"--lead", "12 mm", "--curve", "profile", "--tool", "10 mm"}),
             Contains("without --tool"));
  // The tangent where this cam's rise begins crosses the rise: a circle of 500 mm cuts into it, one
  // of 12 mm does not.
  const auto lead = [](const std::string& radius) {
    return Words{"export",  kRoller,  "--format", "gcode", "--curve",
                 "profile", "--lead", radius,     "--set", "base_radius=30 mm"};
  };
  CHECK_THAT(done_unmet(lead("12 mm")), Contains("G2 "));
  CHECK_THAT(failed(lead("500 mm"), 2), Contains("use a smaller lead"));
}

namespace {

/// A cam whose profile has a hollow: a short stroke between two dwells over few degrees.
std::string hollow_cam(const Folder& folder) {
  const std::string file = folder / "hollow.toml";
  std::ofstream(file) << R"toml(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
base_radius = "25 mm"
roller_radius = "6 mm"
offset = "4 mm"
cutter_radius = "5 mm"
[[program.segments]]
name = "rise"
angle = "70 deg"
law = "modified-sine"
[[program.segments]]
name = "return"
angle = "80 deg"
law = "poly-3-4-5"
[[program.segments]]
name = "low"
)toml";
  return file;
}

/// How deep a tool beside a closed profile of many points cuts into it, by the points alone: each
/// is tried against all others.
double gouge(const std::vector<Vector2d>& profile, double radius) {
  const std::size_t n = profile.size();
  double deepest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d along = (profile[(i + 1) % n] - profile[(i + n - 1) % n]).normalized();
    Vector2d out(-along.y(), along.x());
    if (out.dot(profile[i]) < 0) out = -out;
    const Vector2d centre = profile[i] + radius * out;
    for (const Vector2d& p : profile) deepest = std::max(deepest, radius - (p - centre).norm());
  }
  return deepest;
}

}  // namespace

// EX9
TEST_CASE("a program along the profile says how large a compensated tool may be",
          "[export][shop]") {
  const Folder folder;
  const std::string file = hollow_cam(folder);
  const PlaneCurve exact =
      problems::cam_curves(problems::read_problem_file(file), "profile").front();
  constexpr int kSteps = 2880;
  std::vector<Vector2d> points;
  for (int i = 0; i < kSteps; ++i) {
    points.push_back(exact.at({exact.begin() + (exact.end() - exact.begin()) * i / kSteps}).at);
  }
  const Words along{"export", file, "--format", "gcode", "--curve", "profile"};
  const auto with = [&](Words more) {
    Words words = along;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  for (const Words& more : {Words{}, Words{"--lead", "36 mm", "--compensation", "1"}}) {
    const std::string text = done(with(more));
    const std::string begin = "whose radius must be below ";
    REQUIRE(text.find(begin) != std::string::npos);
    const double bound = std::stod(text.substr(text.find(begin) + begin.size()));
    CHECK(bound < 36);
    CHECK(gouge(points, bound) < 2e-3);
    CHECK(gouge(points, 1.2 * bound) > 2e-2);
    CHECK_THAT(text, Contains("or it cuts into the profile near"));
    Words words = with(more);
    words.insert(words.end(), {"--out", folder / "cam.nc", "--json"});
    const ParsedJson told = json_of(words).at("tool_bound");
    CHECK(told.at("radius_mm").get<double>() == Approx(bound).epsilon(1e-3));
    CHECK(told.at("proved") == true);
  }
  // A lead that is smaller than every hollow is the bound, as before.
  CHECK_THAT(done(with({"--lead", "9 mm"})), Contains("must be below the lead's 9 mm"));
  // The machine's own tool is known.
  CHECK_THAT(
      failed(with({"--lead", "36 mm", "--compensation", "1", "--set", "cutter_radius=26 mm"}), 2),
      Contains("cut"));
}

TEST_CASE("a program along the pitch curve is for a tool as large as the roller",
          "[export][shop]") {
  const Folder folder;
  const std::string file = hollow_cam(folder);
  const std::string text = done({"export", file, "--format", "gcode", "--curve", "pitch"});
  CHECK_THAT(text, Contains("a tool as large as the roller, radius 6 mm: no compensation") &&
                       !Contains("curve itself"));
  CHECK_THAT(failed({"export", file, "--format", "gcode", "--curve", "pitch", "--tool", "5 mm"}, 2),
             Contains("--curve cutter"));
}

TEST_CASE("a tool's radius without a unit is in the unit of the file", "[export][shop]") {
  const std::string flat = testing::source("problems/cams/flat_least_base.toml");
  CHECK_THAT(done({"export", flat, "--format", "gcode", "--unit", "inch", "--tool", "0.25"}),
             Contains("tool radius 0.25 in"));
  CHECK_THAT(done({"export", flat, "--format", "gcode", "--tool", "0.25 in"}),
             Contains("tool radius 6.35 mm"));
}

TEST_CASE("an inspection table has nominal points, normals and the tolerance", "[export][shop]") {
  const std::string text = done({"export", kRoller, "--format", "inspection", "--step", "10 deg",
                                 "--form-tolerance", "0.03 mm"});
  std::istringstream lines(text);
  std::size_t rows = 0;
  const PlaneCurve profile = exact_curve("profile");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    if (line.starts_with("point")) {
      CHECK(line == "point,cam_angle [deg],x [mm],y [mm],z [mm],i,j,k,lower [mm],upper [mm]");
      continue;
    }
    std::vector<double> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(std::stod(cell));
    REQUIRE(cells.size() == 10);
    CHECK((Vector2d(cells[2], cells[3]) - profile.at({cells[1]}).at).norm() < 1e-6);
    CHECK(std::hypot(cells[5], cells[6]) == Approx(1).margin(1e-8));
    CHECK(cells[2] * cells[5] + cells[3] * cells[6] > 0);
    CHECK(cells[8] == -0.03);
    CHECK(cells[9] == 0.03);
    ++rows;
  }
  CHECK(rows == 36);
  // A tolerance finer than the coordinates stays what it is, and no curve asks for more decimals.
  CHECK_THAT(done({"export", kRoller, "--format", "inspection", "--decimals", "2",
                   "--form-tolerance", "0.005 mm"}),
             Contains(",-0.005000,0.005000\n"));
  CHECK_THAT(failed({"export", kRoller, "--format", "inspection", "--curve", "pitch"}, 2),
             Contains("takes profile or second-profile"));
}

TEST_CASE("a result that was changed by hand is judged before it is written",
          "[export][shop][long]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / ""});
  const std::string path = folder / "result.json";
  ParsedJson result = ParsedJson::parse(read(path));
  const Outcome sound = run({"export", path, "--format", "gcode"});
  CHECK(sound.status == 0);
  CHECK(sound.out.find("judged again") == std::string::npos);
  // A smaller cam than the pressure angle allows.
  result["design"]["variables"]["base_radius"] = 45.0;
  std::ofstream(folder / "changed.json") << result.dump(2);
  const Outcome changed = run({"export", folder / "changed.json", "--format", "gcode"});
  CHECK(changed.status == 4);
  CHECK_THAT(changed.out, Contains("(judged again: the design does not meet its limits)") &&
                              Contains("pressure_angle is 32.8") && Contains("at most 30 deg"));
  // One that is larger meets them, and is not the least.
  result["design"]["variables"]["base_radius"] = 60.0;
  std::ofstream(folder / "larger.json") << result.dump(2);
  const Outcome larger = run({"export", folder / "larger.json", "--format", "gcode"});
  CHECK_THAT(larger.out, Contains("(judged again: feasible)"));
}

TEST_CASE("every export of a design past its limits names them in the file and on the terminal",
          "[export][shop]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / ""});
  const std::string result = folder / "result.json", small = "base_radius=45 mm";
  const std::string note = "limit not met: pressure_angle is 32.8",
                    bound = "must be at most 30 deg";
  for (const cli::FormatRow& format : cli::export_formats()) {
    INFO(format.name);
    const bool is_solid = format.format == ExportFormat::Step;
    if (is_solid && !problems::has_step()) continue;
    const std::string out = folder / "cam";
    const auto words = [&](Words more) {
      more.insert(more.begin(), {"export", result, "--format", format.name});
      if (is_solid) more.insert(more.end(), {"--width", "15 mm"});
      return more;
    };
    const std::string said = done(words({"--set", small, "--out", out}));
    CHECK_THAT(said, Contains(note) && Contains(bound));
    std::string written = read(out);
    if (is_solid) std::erase(written, '\n');  // its lines are short, texts go on in the next
    CHECK_THAT(written, Contains(note) && Contains(bound));
    if (is_solid) continue;  // which takes long, and is shown as the others are
    const Outcome shown = run(words({"--set", small}));
    CHECK_THAT(shown.err, Contains(note) && Contains(bound));
    const Outcome met = run(words({}));
    CHECK(met.err.empty());
    CHECK(met.out.find("limit not met") == std::string::npos);
  }
}

TEST_CASE("a build without STEP says how to get it", "[export][shop]") {
  if (problems::has_step()) return;
  CHECK_THAT(failed({"export", kRoller, "--format", "step", "--width", "15 mm"}, 2),
             Contains("this build has no STEP") && Contains("packages-step.txt") &&
                 Contains("-DCAMLAW_STEP=ON"));
}

TEST_CASE("an export refuses steps whose chords cut deep into the cam", "[export][shop]") {
  for (const char* format : {"csv", "dxf", "svg", "gcode"}) {
    INFO(format);
    CHECK_THAT(failed({"export", kRoller, "--format", format, "--step", "90 deg"}, 2),
               Contains("--step 90 deg: lines between these points deviate from the exact ") &&
                   Contains("more than a thousandth of its size") &&
                   Contains("or a step such as "));
    done({"export", kRoller, "--format", format, "--step", "4.5 deg"});
  }
  CHECK_THAT(failed({"export", kRoller, "--format", "lenze", "--step", "90 deg"}, 2),
             Contains("more than a hundredth of its range"));
}

}  // namespace camlaw::cli::shop_export_test
