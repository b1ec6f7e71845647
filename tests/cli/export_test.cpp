// SPDX-License-Identifier: MIT
// camlaw export, as a user runs it: what is written is read back by other programs than our own.
#include <Eigen/Core>
#include <array>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "output/export/plane_curve.h"
#include "tests/cli/gcode_reader.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::export_test {
namespace {

using Eigen::Vector2d;
using problems::PlaneCurve;

constexpr double kTolerance = 0.01;  // mm

std::string problem(const std::string& name) { return testing::source("problems/") + name; }
const std::string kRoller = problem("cams/roller_least_base.toml");

std::vector<std::string> files_of(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(problem(folder))) {
    if (file.path().extension() == ".toml") names.push_back(file.path().string());
  }
  return names;
}

PlaneCurve exact_curve(const std::string& file, const std::string& option) {
  return problems::cam_curves(problems::read_problem_file(file), option).front();
}

/// Many points of the exact curve in their order.
std::vector<Vector2d> points_of(const PlaneCurve& curve) {
  constexpr int kSteps = 7200;
  std::vector<Vector2d> points;
  for (int i = 0; i <= kSteps; ++i) {
    points.push_back(curve.at(optim::even_place(curve.begin(), curve.end(), kSteps, i)).at);
  }
  return points;
}

/// How far points are from a polyline at most, both in one order: each is looked for near the last,
/// the first on all of it. One that is not looked for far enough seems further away.
double departure(const std::vector<Vector2d>& points, const std::vector<Vector2d>& line) {
  double worst = 0;
  std::size_t near = 0;
  const auto distance = [&](const Vector2d& p, std::size_t i) {
    const Vector2d a = line[i], way = line[i + 1] - a;
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
    return (p - a - share * way).norm();
  };
  const std::size_t count = line.size() - 1;
  std::size_t window = count;
  for (const Vector2d& p : points) {
    double least = 1e9;
    const std::size_t first = near + count - std::min(window, count - 1);
    for (std::size_t k = 0; k < 2 * window; ++k) {
      const std::size_t i = (first + k) % count;
      const double apart = distance(p, i);
      if (apart < least) least = apart, near = i;
    }
    worst = std::max(worst, least);
    window = std::min(count, 8 * count / points.size() + 16);
  }
  return worst;
}

/// An entity as ezdxf reads it.
struct Entity {
  std::string type, layer;
  std::vector<double> numbers;
};

struct Drawing {
  std::map<std::string, std::string> facts;  ///< errors, version, units
  std::vector<Entity> entities;
};

Drawing read_by_ezdxf(const std::string& path) {
  const std::string command =
      "/usr/bin/python3 " + testing::source("tests/independent/read_dxf.py ") + path;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe)) {
    text.append(block.data(), count);
  }
  REQUIRE(pclose(pipe) == 0);
  Drawing drawing;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Entity entity;
    words >> entity.type >> entity.layer;
    if (std::islower(static_cast<unsigned char>(entity.type[0])) != 0) {
      drawing.facts[entity.type] += entity.layer + " ";
      continue;
    }
    for (double number; words >> number;) entity.numbers.push_back(number);
    drawing.entities.push_back(std::move(entity));
  }
  return drawing;
}

/// What an export writes of a design that may violate a limit, or have the first of several laws:
/// then the error stream says so, and a table begins with a line about it.
std::string exported(const Words& words) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return outcome.out;
}

Drawing drawn(const Words& more) {
  const Folder folder;
  Words words{"export"};
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), {"--out", folder / "cam.dxf"});
  exported(words);
  Drawing drawing = read_by_ezdxf(folder / "cam.dxf");
  CHECK(drawing.facts["errors"] == "0 ");
  CHECK(drawing.facts["version"] == "AC1015 ");
  CHECK(drawing.facts["units"] == "4 ");
  return drawing;
}

/// The places of an ARC from its one end to the other.
Vector2d on_arc(const std::vector<double>& n, double share) {
  const double sweep = n[4] > n[3] ? n[4] - n[3] : n[4] - n[3] + 360;
  const double angle = (n[3] + share * sweep) * std::numbers::pi / 180;
  return {n[0] + n[2] * std::cos(angle), n[1] + n[2] * std::sin(angle)};
}

}  // namespace

TEST_CASE("a drawing's splines run along the exact curves, as ezdxf reads them",
          "[export][heavy]") {
  for (const std::string& file : files_of("cams")) {
    INFO(file);
    const Drawing drawing = drawn({file});
    std::size_t count = 0;
    for (const auto& [option, layer] : {std::pair{"profile", "PROFILE"},
                                        {"second-profile", "SECOND_PROFILE"},
                                        {"pitch", "PITCH_CURVE"},
                                        {"cutter", "CUTTER_PATH"}}) {
      const auto curves = problems::cam_curves(problems::read_problem_file(file), option);
      for (const PlaneCurve& curve : curves) {
        REQUIRE(count < drawing.entities.size());
        const Entity& entity = drawing.entities[count++];
        CHECK(entity.type == "SPLINE");
        CHECK(entity.layer == layer);
        REQUIRE(entity.numbers.size() == 3 * 1201);
        double worst = 0;
        for (std::size_t i = 0; i < entity.numbers.size(); i += 3) {
          const Vector2d p(entity.numbers[i + 1], entity.numbers[i + 2]);
          const double angle = std::clamp(entity.numbers[i], curve.begin(), curve.end());
          worst = std::max(worst, (curve.at({angle, i > 0}).at - p).norm());
        }
        CHECK(worst <= kTolerance);
        CHECK(worst > 0);
      }
    }
    CHECK(count == drawing.entities.size());
  }
}

TEST_CASE("a curve with cusps is drawn as splines that end there", "[export]") {
  const Folder folder;
  const std::string path = folder / "cam.toml";
  std::ofstream(path) << "mechanism = 'disc-cam-oscillating-flat'\n[program]\nsegments = [{name = "
                         "'rise', angle = 100, law = 'poly-3-4-5'}, {name = 'high', angle = 40}, "
                         "{name = 'return', angle = 120, law = 'cycloidal'}, {name = 'low'}]\n";
  const Drawing drawing = drawn({path, "--curve", "profile"});
  const PlaneCurve curve = exact_curve(path, "profile");
  const std::vector<double> turns = problems::cusps(curve);
  REQUIRE(turns.size() >= 2);
  REQUIRE(drawing.entities.size() == turns.size() + 1);
  std::vector<double> ends = turns;
  ends.insert(ends.begin(), curve.begin());
  ends.push_back(curve.end());
  for (std::size_t k = 0; k < drawing.entities.size(); ++k) {
    const Entity& entity = drawing.entities[k];
    CHECK(entity.type == "SPLINE");
    // ezdxf counts the knots of a spline from 0.
    const double first = entity.numbers.front(), last = entity.numbers[entity.numbers.size() - 3];
    Vector2d before(0, 0);
    double worst = 0;
    for (std::size_t i = 0; i < entity.numbers.size(); i += 3) {
      const Vector2d p(entity.numbers[i + 1], entity.numbers[i + 2]);
      const double share = (entity.numbers[i] - first) / (last - first);
      const double angle = std::clamp(std::lerp(ends[k], ends[k + 1], share), ends[k], ends[k + 1]);
      worst = std::max(worst, (curve.at({angle, i > 0}).at - p).norm());
      if (i + 3 >= entity.numbers.size()) continue;
      // Nowhere inside does it turn back.
      const Vector2d way = Vector2d(entity.numbers[i + 4], entity.numbers[i + 5]) - p;
      CHECK(way.dot(before) >= 0);
      before = way;
    }
    CHECK(worst <= kTolerance);
  }
}

TEST_CASE("a drawing's arcs and lines are one closed, smooth way along the curve", "[export]") {
  for (const char* name : {"cams/roller_least_base.toml", "cams/flat_least_base.toml"}) {
    INFO(name);
    const Drawing drawing = drawn({problem(name), "--as", "arcs", "--curve", "profile"});
    const auto exact = points_of(exact_curve(problem(name), "profile"));
    REQUIRE(drawing.entities.size() > 8);
    std::vector<Vector2d> way, begins, ends;
    for (const Entity& entity : drawing.entities) {
      CHECK(entity.layer == "PROFILE");
      REQUIRE(entity.type == "ARC");  // no part of these cams is straight
      const Vector2d a = on_arc(entity.numbers, 0), b = on_arc(entity.numbers, 1);
      const bool turned = !ends.empty() && (a - ends.back()).norm() > (b - ends.back()).norm();
      begins.push_back(turned ? b : a);
      ends.push_back(turned ? a : b);
      for (int i = 0; i <= 100; ++i) {
        way.push_back(on_arc(entity.numbers, turned ? 1 - i / 100.0 : i / 100.0));
      }
    }
    // The first arc's way is told by the second's.
    if ((begins[0] - begins[1]).norm() < (ends[0] - begins[1]).norm()) {
      std::swap(begins[0], ends[0]);
      std::reverse(way.begin(), way.begin() + 101);
    }
    for (std::size_t i = 0; i < begins.size(); ++i) {
      CHECK((ends[i] - begins[(i + 1) % begins.size()]).norm() < 1e-6);
    }
    CHECK(departure(exact, way) <= kTolerance);
    CHECK(departure(way, exact) <= kTolerance);
    for (std::size_t i = 101; i + 101 <= way.size(); i += 101) {
      const Vector2d before = (way[i - 1] - way[i - 2]).normalized();
      const Vector2d after = (way[i + 1] - way[i]).normalized();
      const double steps = (way[i - 1] - way[i - 2]).norm() + (way[i + 1] - way[i]).norm();
      CHECK((after - before).norm() < steps);  // chords of arcs turn by their curvature alone
    }
  }
}

TEST_CASE("a drawing's polyline is closed and its points are those of the CSV", "[export]") {
  const Words what{kRoller, "--curve", "profile", "--step", "1 deg"};
  const Drawing drawing = drawn(what);
  REQUIRE(drawing.entities.size() == 1);
  const auto& numbers = drawing.entities[0].numbers;
  CHECK(drawing.entities[0].type == "LWPOLYLINE");
  REQUIRE(numbers.size() == 1 + 2 * 360);
  CHECK(numbers[0] == 1);
  Words words{"export", "--format", "csv"};
  words.insert(words.end(), what.begin(), what.end());
  const CsvRows table = csv_of(done(words));
  REQUIRE(table.size() == 362);
  for (std::size_t i = 0; i < 360; ++i) {
    CHECK(std::stod(table[i + 1][2]) == numbers[1 + 2 * i]);
    CHECK(std::stod(table[i + 1][3]) == numbers[2 + 2 * i]);
  }
}

TEST_CASE("a G-code program leads the tool along the exact way and back to its start", "[export]") {
  for (const char* form : {"arcs", "lines"}) {
    INFO(form);
    const std::string text = done({"export", kRoller, "--format", "gcode", "--as", form, "--feed",
                                   "0.24 m/min", "--clearance", "12 mm", "--depth", "3 mm"});
    const GcodeRun run = run_gcode(text);
    CHECK(run.feed == 240);
    CHECK(run.clearance == 12);
    CHECK(run.cut_depth == -3);
    CHECK(run.worst_radius_mismatch < 3e-4);
    CHECK((run.cut.front() - run.cut.back()).norm() == 0);
    const auto exact = points_of(exact_curve(kRoller, "cutter"));
    CHECK(departure(exact, run.cut) <= kTolerance);
    CHECK(departure(run.cut, exact) <= kTolerance);
    CHECK_THAT(text, Contains("tool radius 10 mm") && Contains("within 0.0"));
  }
}

TEST_CASE("the tool of a cam without a tool of its own goes beside the profile", "[export]") {
  const std::string flat = problem("cams/flat_least_base.toml");
  CHECK_THAT(failed({"export", flat, "--format", "gcode"}, 2),
             Contains("no curve 'cutter'") && Contains("--tool '10 mm'"));
  const GcodeRun run = run_gcode(done({"export", flat, "--format", "gcode", "--tool", "6 mm"}));
  const auto profile = points_of(exact_curve(flat, "profile"));
  for (std::size_t i = 0; i < run.cut.size(); i += 10) {
    double least = 1e9;
    for (const Vector2d& p : profile) least = std::min(least, (p - run.cut[i]).norm());
    CHECK(least == Approx(6).margin(kTolerance));
  }
  CHECK_THAT(failed({"export", kRoller, "--format", "gcode", "--tool", "6 mm"}, 2),
             Contains("--set 'cutter_radius=6 mm'"));
}

TEST_CASE("programs of the two cams of a pair say which of them they are for", "[export]") {
  const auto program = [](const std::string& curve) {
    return done({"export", problem("cams/conjugate_least_distance.toml"), "--format", "gcode",
                 "--curve", curve, "--tool", "5 mm"});
  };
  CHECK_THAT(program("profile"), Contains("(tool radius 5 mm beside the profile;"));
  CHECK_THAT(program("second-profile"), Contains("(tool radius 5 mm beside the second profile;"));
}

TEST_CASE("every format takes every cam", "[export][heavy]") {
  const Folder folder;
  auto files = files_of("cams");
  for (const std::string& file : files_of("balancing_cam")) files.push_back(file);
  for (const std::string& file : files) {
    const bool own = !problems::cam_curves(problems::read_problem_file(file), "cutter").empty();
    const bool balancing = file.find("balancing_cam/") != std::string::npos;
    for (const char* name : {"a.csv", "a.dxf", "a.svg", "a.json", "a.nc"}) {
      INFO(file << " " << name);
      const std::string path = folder / name;
      Words words{"export", file, "--out", path};
      if (!own && path.ends_with(".nc")) words.insert(words.end(), {"--tool", "2 mm"});
      const std::string said = exported(words);
      CHECK_THAT(said, Contains("wrote " + path));
      if (!path.ends_with(".json")) CHECK_THAT(said, Contains("mm of the exact curve"));
      if (!path.ends_with(".json")) CHECK(read(path).find("nan") == std::string::npos);
      if (path.ends_with(".svg")) check_svg(path);
    }
    Words words{"export", file, "--format", "table"};
    if (balancing) words.insert(words.end(), {"--slave", "roller_displacement"});
    CsvRows table = csv_of(exported(words));
    if (table.size() == 363) table.erase(table.begin());
    REQUIRE(table.size() == 362);
    CHECK(table[1][1] == table[361][1]);
  }
}

TEST_CASE("a picture has the cam's real size", "[export][long]") {
  const Folder folder;
  const std::string svg = folder / "cam.svg";
  for (const char* form : {"lines", "arcs", "spline"}) {
    done({"export", kRoller, "--curve", "profile", "--as", form, "--out", svg});
    check_svg(svg);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(svg, tree);
    Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const Vector2d& p : points_of(exact_curve(kRoller, "profile"))) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const auto width = tree.get<std::string>("svg.<xmlattr>.width");
    CHECK(width.ends_with("mm"));
    // Control points of a spline stand out a little.
    CHECK(std::stod(width) == Approx(high.x() - low.x() + 10).margin(0.3));
    CHECK(tree.get<std::string>("svg.<xmlattr>.viewBox").find(std::to_string(std::stod(width))) !=
          std::string::npos);
  }
}

TEST_CASE("a result is exported at the design that was found, with its verdict", "[export]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / ""});
  const std::string result = folder / "result.json";
  const ParsedJson found = ParsedJson::parse(read(result));
  const ParsedJson json = json_of({"export", result, "--format", "json", "--curve", "profile"});
  CHECK(json["provenance"]["verdict"] == found["verdict"]);
  CHECK(json["provenance"]["problem"] == "roller_least_base.toml");
  const ParsedJson& curve = json["curves"][0];
  const double base = found["variables"]["base_radius"];
  double least = 1e9;
  for (std::size_t i = 0; i < curve["x_mm"].size(); ++i) {
    least =
        std::min(least, std::hypot(curve["x_mm"][i].get<double>(), curve["y_mm"][i].get<double>()));
  }
  CHECK(least == Approx(base).margin(1e-5));
  CHECK(curve["worst_deviation_mm"] <= kTolerance);
  CHECK(json["law"]["format"] == "camlaw law 1");
  CHECK(json["motion"]["closed"] == true);
  const ParsedJson set =
      json_of({"export", result, "--format", "json", "--set", "base_radius=60 mm"});
  CHECK(set["provenance"]["set"] == ParsedJson({"base_radius=60 mm"}));
  CHECK(std::hypot(set["curves"][0]["x_mm"][0].get<double>(),
                   set["curves"][0]["y_mm"][0].get<double>()) == Approx(60).margin(1e-5));
}

TEST_CASE("the law of an export is a law file that can be used", "[export]") {
  const Folder folder;
  const ParsedJson json = json_of({"export", problem("spine_cutter/least_force.toml"), "--format",
                                   "json", "--set", "alpha=-2.5"});
  CHECK(json["curves"].empty());
  CHECK_THAT(json["motion"]["slave"].get<std::string>(), Contains("displacement"));
  std::ofstream(folder / "law.json") << json["law"].dump();
  const ParsedJson law = json_of({"law", folder / "law.json", "--json"});
  const ParsedJson same = json_of({"law", "polynomial-5 alpha=-2.5", "--json"});
  CHECK(law["pieces"] == same["pieces"]);
}

TEST_CASE("tables have any curve as their slave, at any whole division of the cycle", "[export]") {
  const CsvRows table = csv_of(done({"export", kRoller, "--format", "table", "--step", "0.5 deg",
                                     "--decimals", "3", "--slave", "pitch_x"}));
  REQUIRE(table.size() == 722);
  CHECK(table[0] == Words{"cam_angle [deg]", "pitch_x [mm]"});
  CHECK(table[2][0] == "0.500");
  CHECK(table[721][0] == "360.000");
  const PlaneCurve pitch = exact_curve(kRoller, "pitch");
  CHECK(std::stod(table[201][1]) == Approx(pitch.at({100}).at.x()).margin(5.001e-4));
  CHECK_THAT(failed({"export", kRoller, "--format", "table", "--slave", "lift"}, 2),
             Contains("no curve 'lift'; its curves are displacement, velocity"));
  CHECK_THAT(
      failed({"export", problem("geneva/fastest.toml"), "--format", "table"}, 2),
      Contains("geneva has no displacement of its own; name a curve with --slave; its curves are"));
}

TEST_CASE("export refuses what it cannot do in one clear line", "[export]") {
  const Folder folder;
  const auto refused = [&](Words more) {
    more.insert(more.begin(), {"export", kRoller});
    return failed(more, 2);
  };
  CHECK_THAT(refused({}), Contains("--format is missing") && Contains("csv, dxf, step, svg, json"));
  CHECK_THAT(refused({"--out", folder / "cam.prt"}), Contains("--format is missing"));
  CHECK_THAT(refused({"--format", "iges"}), Contains("'iges' is not a format; use one of csv"));
  CHECK_THAT(refused({"--format", "csv", "--curve", "base"}),
             Contains("there is no curve 'base'; use all, profile"));
  CHECK_THAT(refused({"--format", "csv", "--tolerance", "0.01 s"}), Contains("a length is needed"));
  CHECK_THAT(refused({"--format", "csv", "--tolerance", "-1"}), Contains("--tolerance: -1 mm"));
  CHECK_THAT(refused({"--format", "gcode", "--tolerance", "0.1 um"}),
             Contains("too fine for coordinates of 4 decimals; use at least 0.001 mm"));
  CHECK_THAT(refused({"--format", "csv", "--step", "1 deg", "--tolerance", "1 mm"}),
             Contains("--step and --tolerance: give only one of the two"));
  CHECK_THAT(refused({"--format", "dxf", "--step", "1 deg", "--as", "spline"}),
             Contains("takes only --as lines"));
  CHECK_THAT(refused({"--format", "csv", "--step", "7 deg"}),
             Contains("a step of 7 deg does not divide the cycle of 360 deg; 7.2 deg does"));
  CHECK_THAT(refused({"--format", "gcode", "--as", "spline"}),
             Contains("--as spline: gcode takes arcs, lines"));
  CHECK_THAT(refused({"--format", "gcode", "--curve", "all"}), Contains("follows one curve"));
  CHECK_THAT(refused({"--format", "dxf", "--feed", "10"}), Contains("--feed is for gcode"));
  CHECK_THAT(refused({"--format", "gcode", "--slave", "x"}), Contains("--slave is for table"));
  CHECK_THAT(refused({"--format", "table", "--curve", "pitch"}), Contains("--curve is for curves"));
  CHECK_THAT(refused({"--format", "table", "--decimals", "0"}), Contains("--decimals"));
  CHECK_THAT(refused({"--format", "csv", "--set", "nothing=1"}),
             Contains("no parameter 'nothing'"));
  CHECK_THAT(failed({"export", problem("springs/lightest_helical.toml"), "--format", "dxf"}, 2),
             Contains("helical-spring has no profile to export\n"));
  CHECK_THAT(failed({"export", problem("geneva/fastest.toml"), "--format", "json"}, 2),
             Contains("geneva has no profile to export; --format table --slave NAME"));
  CHECK_THAT(failed({"export", problem("spine_cutter/least_force.toml"), "--format", "svg"}, 2),
             Contains("spine-cutter has no profile to export; --format table or json writes"));
  CHECK_THAT(failed({"export", problem("cams/flat_least_base.toml"), "--format", "json", "--curve",
                     "pitch"},
                    2),
             Contains("disc-cam-flat has no curve 'pitch'; it has profile"));
  CHECK_THAT(failed({"export", folder / "none.json", "--format", "dxf"}, 2), Contains("none.json"));
  CHECK_THAT(failed({"export", "study.db", "--format", "dxf"}, 2),
             Contains("'camlaw front study.db --knee --result FILE'"));
  CHECK(folder.content().empty());
}

TEST_CASE("the help of export explains every option", "[export]") {
  const std::string help = done({"export", "--help"});
  for (const char* option :
       {"--format",       "--out",      "--curve",     "--tolerance", "--step",
        "--as",           "--decimals", "--tool",      "--feed",      "--clearance",
        "--depth",        "--slave",    "--set",       "--unit",      "--master",
        "--cycle",        "--columns",  "--separator", "--lead",      "--allowances",
        "--compensation", "--drawing",  "--bore",      "--keyway",    "--form-tolerance"}) {
    std::size_t at = help.find(std::string("  ") + option + " ");
    if (at == std::string::npos) at = help.find(std::string(",") + option + " ");  // "-o,--out"
    REQUIRE(at != std::string::npos);
    CHECK(help.find("\n  -", at) > at + 50);
  }
  CHECK_THAT(help, Contains("--format {csv,dxf,step,svg,json,gcode,inspection,table,"
                            "beckhoff-points") &&
                       Contains("--curve {all,profile,second-profile,pitch,cutter}") &&
                       Contains("--as {lines,arcs,spline}"));
}

TEST_CASE("a cam that jumps is drawn with a note, and not cut", "[export]") {
  const Folder folder;
  const std::string path = folder / "jump.toml";
  std::ofstream(path) << "mechanism = 'disc-cam-flat'\n[program]\nmatched = 'displacement'\n"
                         "segments = [{name = 'rise', angle = 120, law = 'constant-velocity'},"
                         "{name = 'return', law = 'cycloidal'}]\n";
  const std::string said = done({"export", path, "--out", folder / "cam.dxf"});
  CHECK_THAT(said, Contains("the profile jumps by") && Contains("mm at 120 deg") &&
                       Contains("mm at 360 deg"));
  CHECK(read_by_ezdxf(folder / "cam.dxf").facts["errors"] == "0 ");
  // The face leaves the flank backwards where its velocity falls.
  CHECK_THAT(failed({"export", path, "--format", "gcode", "--curve", "profile"}, 2),
             Contains("the profile turns back near 120 deg"));
}

TEST_CASE("a cam that is undercut is drawn with a note, and not cut", "[export]") {
  const Folder folder;
  // Below 19.36 mm its radius of curvature, least at 77.5 deg, is below 0.
  const Words cam{"export", problem("cams/flat_least_base.toml"), "--curve", "profile", "--set"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), cam.begin(), cam.end());
    return more;
  };
  const std::string out = folder / "cam.svg";
  CHECK_THAT(done(with({"base_radius=15 mm", "--out", out})), Contains("profile turns back near"));
  CHECK_THAT(read(out), Contains("profile turns back near"));
  CHECK_THAT(failed(with({"base_radius=15 mm", "--format", "gcode"}), 2),
             Contains("the profile turns back near"));
  CHECK_THAT(done(with({"base_radius=20 mm", "--out", out})), !Contains("turns back"));
  // The way of a tool as large as the roller is the pitch curve, which is smooth all the same.
  const Words roller{"export",   kRoller,
                     "--set",    "base_radius=10 mm",
                     "--set",    "stroke=40 mm",
                     "--set",    "roller_radius=40 mm",
                     "--set",    "cutter_radius=40 mm",
                     "--format", "gcode"};
  CHECK_THAT(failed(roller, 2), Contains("the profile turns back near"));
}

TEST_CASE("a cam of which a stretch runs backwards as a whole is not cut", "[export]") {
  const Folder folder;
  // Where the acceleration jumps from one end of the stretch to the other, nothing turns within it.
  const auto cam =
      [&](const std::string& name, const std::string& follower) {
        std::ofstream(folder / name)
            << "mechanism = '" << follower << "'\n[constants]\nstroke = '30 mm'\n"
            << (follower == "disc-cam-flat"
                    ? "base_radius = '20 mm'\n"
                    : "base_radius = '5 mm'\nroller_radius = '45 mm'\ncutter_radius = '45 mm'\n")
            << "[program]\nmatched = 'velocity'\nsegments = ["
               "{name = 'rise', angle = 60, law = 'parabolic'}, {name = 'high', angle = 60}, "
               "{name = 'return', angle = 60, law = 'parabolic'}, {name = 'low'}]\n";
        return folder / name;
      };
  const std::string out = folder / "cam.nc";
  const std::string flat = cam("flat.toml", "disc-cam-flat");
  const std::string roller = cam("roller.toml", "disc-cam-roller");
  // r_b + s + s'' is below 0 in the second half of the rise: s'' = -4 S / beta^2.
  const double angle = std::numbers::pi / 3, bend = 4 * 30 / (angle * angle);
  REQUIRE(20 + 30 - bend < 0);
  CHECK_THAT(failed({"export", flat, "--curve", "profile", "--out", out}, 2),
             Contains("the profile turns back near"));
  CHECK_THAT(failed({"export", flat, "--tool", "2 mm", "--out", out}, 2),
             Contains("turns back near") && !Contains("velocity"));
  CHECK_THAT(failed({"export", roller, "--out", out}, 2), Contains("the profile turns back near"));
  CHECK(!fs::exists(out));
  CHECK_THAT(
      done({"export", flat, "--set", "base_radius=100 mm", "--curve", "profile", "--out", out}),
      !Contains("turns back"));
}

TEST_CASE("a verdict is that of the design it was passed on", "[export][long]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / ""});
  const std::string result = folder / "result.json";
  const Words changed{"export", result, "--set", "base_radius=40 mm", "--format"};
  const auto in = [&](const char* format) {
    Words words = changed;
    words.push_back(format);
    return done_unmet(words);
  };
  const ParsedJson json = ParsedJson::parse(in("json"));
  CHECK(json["provenance"]["verdict"].is_null());
  CHECK(json["law"]["provenance"]["verdict"].is_null());
  CHECK_THAT(in("svg"), Contains("before the changes: certified optimum"));
  CHECK_THAT(done({"export", result, "--format", "svg"}),
             Contains("\ncertified optimum") && !Contains("before the changes"));
}

TEST_CASE("a result that does not meet its limits is exported with a note of it",
          "[export][long]") {
  const Folder folder;
  std::string text = read(kRoller);
  text.replace(text.find("[[constraints]]"), 0,
               "[[constraints]]\nresponse = 'base_radius'\nupper = '20 mm'\n\n");
  std::ofstream(folder / "tight.toml") << text;
  run({"optimize", folder / "tight.toml", "--out", folder / "out"});
  const std::string result = folder / "out/result.json";
  REQUIRE(ParsedJson::parse(read(result))["verdict"] == "infeasible");
  const std::string note = "the design does not meet its limits";
  CHECK_THAT(done({"export", result, "--out", folder / "cam.nc"}), Contains(note));
  CHECK_THAT(read(folder / "cam.nc"), Contains(note));
  CHECK(ParsedJson::parse(done_unmet({"export", result, "--format", "json"}))["notes"][0] == note);
}

TEST_CASE("a G-code program of a nearly straight way is as near as it says", "[export]") {
  const Folder folder;
  const std::string path = folder / "long.toml", out = folder / "long.nc";
  std::ofstream(path) << "mechanism = 'linear-cam'\n[constants]\nstroke = '6 mm'\n"
                         "travel = '4000 mm'\nroller_radius = '20 mm'\ncutter_radius = '20 mm'\n"
                         "[program]\nsegments = [{name = 'rise', angle = 180, law = 'cycloidal'},"
                         "{name = 'return', law = 'poly-3-4-5'}]\n";
  const std::string said = done({"export", path, "--out", out, "--tolerance", "2 um"});
  const double stated = std::stod(said.substr(said.find("within ") + 7));
  CHECK(stated <= 0.002);
  const GcodeRun run = run_gcode(read(out));
  CHECK(departure(points_of(exact_curve(path, "cutter")), run.cut) <= stated + 2e-5);
}

TEST_CASE("an export does not go over its own input", "[export]") {
  const Folder folder;
  const std::string path = folder / "cam.json", text = read(kRoller);
  std::ofstream(path) << text;
  CHECK_THAT(failed({"export", path, "--out", path}, 2), Contains("is an input of this run"));
  CHECK(read(path) == text);
  CHECK_THAT(done({"export", path, "--out", folder / "CAM.SVG"}), Contains("wrote "));
  check_svg(folder / "CAM.SVG");
}

TEST_CASE("no table or picture takes the place of a problem file or a study", "[export]") {
  const Folder folder;
  const std::string other = folder / "other.toml", study = folder / "study.db";
  std::ofstream(other) << "mechanism = 'law'\n";
  std::ofstream(study) << "kept";
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"export", kRoller, "--format", "csv", "--out", other},
        Words{"law", "cycloidal", "--csv", other}, Words{"laws", "--csv", study},
        Words{"evaluate", kRoller, "--svg", other},
        Words{"evaluate", kRoller, "--curves", study}}) {
    INFO(words.front());
    CHECK_THAT(failed(words, 2), Contains("the output needs another name"));
  }
  CHECK(read(other) == "mechanism = 'law'\n");
  CHECK(read(study) == "kept");
}

TEST_CASE("an export says which of several laws it takes", "[export]") {
  const std::string file = problem("cams/law_for_a_rise.toml");
  const Outcome first = run({"export", file, "--format", "json"});
  CHECK_THAT(first.err, Contains("laws to choose from") && Contains("--set takes another"));
  CHECK_THAT(run({"evaluate", file}).err, Contains("laws to choose from"));
  const Outcome named = run({"export", file, "--format", "json", "--set", "rise.law=cycloidal"});
  CHECK_THAT(named.err, !Contains("laws to choose from"));
}

TEST_CASE("a picture is well-formed whatever the title and the file's name", "[export]") {
  const Folder folder;
  const std::string text = read(problem("cams/flat_least_base.toml"));
  std::ofstream(folder / "odd\xff.toml") << "title = \"]]> <b> & ' \\\"\"\n"
                                         << text.substr(text.find("mechanism"));
  done({"export", folder / "odd\xff.toml", "--out", folder / "odd.svg"});
  check_svg(folder / "odd.svg");
  const std::string svg = read(folder / "odd.svg");
  CHECK_THAT(svg, Contains("<title>]]&gt; &lt;b&gt; &amp; &apos; &quot;</title>"));
  CHECK_THAT(svg, Contains("odd?.toml") && !Contains("\xff"));
}

}  // namespace camlaw::cli::export_test
