// SPDX-License-Identifier: MIT
// Solids that camlaw export writes as STEP, read back by Open CASCADE from the file alone.
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <numbers>

#include "output/export/bore.h"
#include "output/export/plane_curve.h"
#include "problems/statement/parameters.h"
#include "tests/cli/program_runner.h"
#include "tests/output/swept_groove.h"
#include "tests/paths.h"

namespace camlaw::cli::step_export_test {
namespace {

using Eigen::Vector2d;
using problems::PlaneCurve;

std::string shipped(const std::string& name) { return testing::source("problems/cams/") + name; }
const std::string kRoller = shipped("roller_least_base.toml");
const std::string kGroove = shipped("groove_least_stress.toml");

PlaneCurve exact_curve(const std::string& file, const std::string& option,
                       const std::vector<std::string>& settings = {}) {
  auto statement = problems::read_problem_file(file);
  problems::set_values(statement, settings);
  return problems::cam_curves(statement, option).front();
}

/// A solid as it is read from a file: in mm.
struct ReadSolid {
  TopoDS_Solid solid;
  double volume = 0;
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
};

ReadSolid read_step(const std::string& path) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Reader reader;
  REQUIRE(reader.ReadFile(path.c_str()) == IFSelect_RetDone);
  REQUIRE(reader.TransferRoots() == 1);
  TopExp_Explorer solids(reader.OneShape(), TopAbs_SOLID);
  REQUIRE(solids.More());
  ReadSolid result;
  result.solid = TopoDS::Solid(solids.Current());
  solids.Next();
  CHECK_FALSE(solids.More());
  CHECK(BRepCheck_Analyzer(result.solid).IsValid());
  for (TopExp_Explorer shells(result.solid, TopAbs_SHELL); shells.More(); shells.Next()) {
    CHECK(BRep_Tool::IsClosed(shells.Current()));
  }
  GProp_GProps properties;
  BRepGProp::VolumePropertiesGK(result.solid, properties, 1e-9, false, true);
  result.volume = properties.Mass();
  Bnd_Box box;
  BRepBndLib::AddOptimal(result.solid, box, false, false);
  box.Get(result.low[0], result.low[1], result.low[2], result.high[0], result.high[1],
          result.high[2]);
  return result;
}

ReadSolid exported(Words words) {
  const Folder folder;
  words.insert(words.begin(), "export");
  words.insert(words.end(), {"--out", folder / "cam.step"});
  done(words);
  return read_step(folder / "cam.step");
}

/// The area within a closed curve, by Simpson's rule over (x y' - y x') / 2.
double area_within(const PlaneCurve& curve) {
  constexpr int kSteps = 2000;
  double area = 0;
  for (std::size_t k = 0; k + 1 < curve.breaks().size(); ++k) {
    const double from = curve.breaks()[k], to = curve.breaks()[k + 1];
    for (int i = 0; i <= kSteps; ++i) {
      const auto p = curve.at(optim::even_place(from, to, kSteps, i));
      const double rate = (p.at.x() * p.slope.y() - p.at.y() * p.slope.x()) / 2;
      const double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
      area += weight * rate * (to - from) / (3 * kSteps);
    }
  }
  return std::abs(area);
}

/// The rectangle of a curve, by many points: low and high.
std::pair<Vector2d, Vector2d> box_of(const PlaneCurve& curve) {
  constexpr int kSteps = 36000;
  Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int i = 0; i <= kSteps; ++i) {
    const Vector2d p = curve.at(optim::even_place(curve.begin(), curve.end(), kSteps, i)).at;
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  return {low, high};
}

/// How far points of a curve, at a height z, are from the solid's surface at most.
double departure(const PlaneCurve& curve, double z, const ReadSolid& read) {
  constexpr int kSteps = 120;
  TopExp_Explorer shells(read.solid, TopAbs_SHELL);
  double worst = 0;
  for (int i = 0; i < kSteps; ++i) {
    // Odd shares of the cycle: not where the pieces meet.
    const double share = (i + 0.4142) / kSteps;
    const Vector2d p = curve.at({curve.begin() + share * (curve.end() - curve.begin())}).at;
    const BRepExtrema_DistShapeShape distance(
        BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), z)).Vertex(), shells.Current());
    REQUIRE(distance.IsDone());
    worst = std::max(worst, distance.Value());
  }
  return worst;
}

/// A bore of radius r and its keyway of half width h to the height t above the centre: the circle,
/// and what the groove adds above the circle's arc.
double bore_area(double r, double h, double t) {
  const double under_arc = h * std::sqrt(r * r - h * h) + r * r * std::asin(h / r);
  return std::numbers::pi * r * r + 2 * h * t - under_arc;
}

}  // namespace

TEST_CASE("a disc cam with bore and keyway is read back as a solid of its area times its width",
          "[export][step]") {
  const ReadSolid read = exported({kRoller, "--width", "15 mm", "--bore", "25 mm", "--keyway",
                                   "8 x 3.3 mm", "--tolerance", "0.0001 mm"});
  const PlaneCurve profile = exact_curve(kRoller, "profile");
  const double area = area_within(profile) - bore_area(12.5, 4, 15.8);
  CHECK(read.volume == Approx(15 * area).epsilon(2e-6));
  const auto [low, high] = box_of(profile);
  for (int i = 0; i < 2; ++i) {
    CHECK(read.low[i] == Approx(low[i]).margin(2e-4));
    CHECK(read.high[i] == Approx(high[i]).margin(2e-4));
  }
  CHECK(read.low[2] == Approx(0).margin(1e-6));
  CHECK(read.high[2] == Approx(15).margin(1e-6));
  CHECK(departure(profile, 7.5, read) <= 0.0001 + 1e-7);
}

TEST_CASE("a solid stays as near to the exact profile as it says", "[export][step]") {
  const Folder folder;
  const ParsedJson json = json_of({"export", kRoller, "--width", "15 mm", "--tolerance", "0.05 mm",
                                   "--json", "--out", folder / "cam.step"});
  const double stated = json["curves"][0]["worst_deviation_mm"];
  CHECK(json["curves"][0]["proved"] == true);
  CHECK(stated <= 0.05);
  const ReadSolid read = read_step(folder / "cam.step");
  const double met = departure(exact_curve(kRoller, "profile"), 3, read);
  CHECK(met <= stated + 1e-7);
  CHECK(met > stated / 4);
  CHECK(json["solid"]["volume_mm3"] == Approx(read.volume).epsilon(1e-9));
  CHECK(json["solid"]["faces"] == 11);  // two ends, the bore, and eight stretches of the profile
}

TEST_CASE("a solid in inches is the same solid", "[export][step]") {
  const ReadSolid mm = exported({kRoller, "--width", "25.4 mm", "--tolerance", "0.0254 mm"});
  const ReadSolid inch =
      exported({kRoller, "--width", "1", "--unit", "inch", "--tolerance", "0.001"});
  CHECK(inch.volume == Approx(mm.volume).epsilon(1e-9));
  CHECK(inch.high[2] == Approx(25.4));
  CHECK(inch.high[0] == Approx(mm.high[0]).epsilon(1e-9));
}

TEST_CASE("a grooved cam is a disc with a groove as wide as the roller and as deep as it is told",
          "[export][step]") {
  const std::vector<std::string> settings{"roller_radius=10 mm"};
  const ReadSolid read =
      exported({kGroove, "--set", settings[0], "--width", "20 mm", "--groove", "12 mm", "--blank",
                "150 mm", "--bore", "16 mm", "--tolerance", "0.0001 mm"});
  const PlaneCurve inner = exact_curve(kGroove, "profile", settings),
                   pitch = exact_curve(kGroove, "pitch", settings);
  const double outwards = problems::outside_is_left(inner) ? 10 : -10;
  const PlaneCurve outer = pitch.beside("outer profile", outwards);
  const double disc = std::numbers::pi * (75 * 75 - 8 * 8);
  CHECK(read.volume ==
        Approx(20 * disc - 12 * (area_within(outer) - area_within(inner))).epsilon(2e-6));
  for (int i = 0; i < 2; ++i) {
    CHECK(read.low[i] == Approx(-75).margin(1e-5));
    CHECK(read.high[i] == Approx(75).margin(1e-5));
  }
  for (const PlaneCurve* flank : {&inner, &outer}) {
    CHECK(departure(*flank, 14, read) <= 0.0001 + 1e-7);
  }
  // The groove is as wide as the roller: a parallel strip along the pitch curve.
  const double angle = 35, away = (outer.at({angle}).at - inner.at({angle}).at).norm();
  CHECK(away == Approx(20));
}

TEST_CASE("a barrel cam is read back with the groove that its roller sweeps", "[export][step]") {
  const std::string barrel = shipped("end_rise_share.toml");
  const Folder folder;
  const ParsedJson json = json_of({"export", barrel, "--width", "60 mm", "--groove", "12 mm",
                                   "--bore", "30 mm", "--json", "--out", folder / "cam.step"});
  const ReadSolid read = read_step(folder / "cam.step");
  const PlaneCurve pitch = exact_curve(barrel, "pitch");
  // The roller's track, 60 mm from the axis, is in the middle of the groove's depth.
  const double round = std::numbers::pi * (66 * 66 - 15 * 15) * 60;
  CHECK(read.volume == Approx(round - testing::swept_volume(pitch, 10, 54, 66)).epsilon(2e-6));
  for (int i = 0; i < 2; ++i) {
    CHECK(read.low[i] == Approx(-66).margin(1e-4));
    CHECK(read.high[i] == Approx(66).margin(1e-4));
  }
  // The stroke of 25 mm is in the middle.
  CHECK(read.low[2] == Approx(-17.5).margin(1e-3));
  CHECK(read.high[2] == Approx(42.5).margin(1e-3));
  REQUIRE(json["solid"]["flanks"].size() == 2);
  TopExp_Explorer shells(read.solid, TopAbs_SHELL);
  for (int k = 0; k < 2; ++k) {
    const auto& flank = json["solid"]["flanks"][k];
    CHECK(flank["proved"] == true);
    const double stated = flank["worst_deviation_mm"];
    CHECK(stated <= 0.01);
    for (int i = 0; i < 24; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.4142) / 24, q = 54.5 + 11 * i / 23.0;
      const double z = testing::reach_of_roller(pitch, 10, angle, q, k == 0 ? -1 : 1);
      const gp_Pnt at(q * std::cos(angle), q * std::sin(angle), z);
      const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(at).Vertex(),
                                                shells.Current());
      REQUIRE(distance.IsDone());
      CHECK(distance.Value() <= stated + 1e-6);
    }
  }
}

TEST_CASE("two runs write the same STEP file, which names camlaw and no time of day",
          "[export][step]") {
  const Words words{"export", kRoller, "--format", "step", "--width", "12 mm"};
  const std::string text = done(words);
  CHECK(text == done(words));
  CHECK(text.starts_with("ISO-10303-21;\nHEADER;\n"));
  CHECK(text.ends_with("END-ISO-10303-21;\n"));
  CHECK_THAT(text, Contains("'camlaw 0.1.0'") && Contains("'1970-01-01T00:00:00'") &&
                       Contains("AUTOMOTIVE_DESIGN") && Contains("MANIFOLD_SOLID_BREP") &&
                       Contains("SI_UNIT(.MILLI.,.METRE.)"));
  CHECK_THAT(done({"export", kRoller, "--format", "step", "--width", "0.5", "--unit", "inch"}),
             Contains("CONVERSION_BASED_UNIT('INCH'"));
}

TEST_CASE("a title with apostrophes and other letters is a text of the STEP file too",
          "[export][step]") {
  const Folder folder;
  std::string problem = read(kRoller);
  const std::string title = "title = \"";
  problem.insert(problem.find(title) + title.size(), "O'Neill's /* Größe ");
  std::ofstream(folder / "cam.toml") << problem;
  done({"export", folder / "cam.toml", "--width", "12 mm", "--out", folder / "cam.stp"});
  CHECK_THAT(read(folder / "cam.stp"), Contains("O''Neill''s /* Gr??e Least"));
  CHECK(read_step(folder / "cam.stp").volume > 1e4);
}

TEST_CASE("every shipped disc cam is a valid solid", "[export][step][long]") {
  const Folder folder;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(testing::source("problems/cams"))) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != ".toml") continue;
    const auto statement = problems::read_problem_file(file);
    const PlaneCurve profile = problems::cam_curves(statement, "profile").front();
    if (!profile.is_closed() || file == kGroove) continue;
    INFO(file);
    const std::string out = folder / "cam.step";
    const Outcome outcome =
        run({"export", file, "--width", "12 mm", "--tolerance", "0.001 mm", "--out", out});
    REQUIRE(outcome.status == 0);
    const ReadSolid solid = read_step(out);
    double area = area_within(profile);
    if (const auto bore = problems::bore_of(statement, {}, {})) {
      area -= std::numbers::pi * bore->radius * bore->radius;
    }
    CHECK(solid.volume == Approx(12 * area).epsilon(5e-5));
    ++count;
  }
  CHECK(count > 15);
}

TEST_CASE("a solid is refused where the profile is undercut or its sizes do not go together",
          "[export][step]") {
  const auto refused = [](Words more) {
    Words words{"export", more.front(), "--format", "step"};
    words.insert(words.end(), more.begin() + 1, more.end());
    return failed(words, 2);
  };
  CHECK_THAT(
      refused({shipped("flat_least_base.toml"), "--set", "base_radius=15 mm", "--width", "12 mm"}),
      Contains("a solid cannot be built: the profile turns back near"));
  CHECK_THAT(refused({kRoller}), Contains("--width is missing"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--bore", "300 mm"}),
             Contains("reaches the profile"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--keyway", "90 x 3.3 mm"}),
             Contains("too large for a bore"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--as", "lines"}),
             Contains("step takes spline"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--curve", "pitch"}),
             Contains("takes profile or second-profile"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--step", "1 deg"}), Contains("--step is for"));
  CHECK_THAT(refused({kRoller, "--width", "12 mm", "--blank", "200 mm"}),
             Contains("--blank is for step with --groove"));
  CHECK_THAT(refused({kGroove, "--width", "12 mm"}), Contains("the roller runs in a groove"));
  CHECK_THAT(refused({kGroove, "--width", "12 mm", "--groove", "8 mm"}),
             Contains("--blank is missing"));
  CHECK_THAT(refused({kGroove, "--width", "12 mm", "--groove", "12 mm", "--blank", "200 mm"}),
             Contains("goes through a cam"));
  CHECK_THAT(refused({kGroove, "--width", "12 mm", "--groove", "8 mm", "--blank", "100 mm"}),
             Contains("does not hold"));
  CHECK_THAT(refused({shipped("flat_least_base.toml"), "--width", "12 mm", "--groove", "8 mm",
                      "--blank", "300 mm"}),
             Contains("has no roller"));
  const std::string barrel = shipped("end_rise_share.toml");
  CHECK_THAT(refused({barrel, "--width", "60 mm"}), Contains("such as --groove"));
  CHECK_THAT(
      refused({barrel, "--width", "60 mm", "--groove", "12 mm", "--curve", "second-profile"}),
      Contains("has no such second-profile"));
  CHECK_THAT(refused({barrel, "--width", "40 mm", "--groove", "12 mm"}),
             Contains("--width: the groove takes"));
  CHECK_THAT(refused({barrel, "--width", "60 mm", "--groove", "12 mm", "--set", "radius=22 mm"}),
             Contains("turns back near"));
  CHECK_THAT(refused({barrel, "--width", "60 mm", "--groove", "12 mm", "--bore", "120 mm"}),
             Contains("reaches the groove's floor"));
  CHECK_THAT(refused({shipped("oscillating_end_least_radius.toml"), "--width", "60 mm", "--groove",
                      "12 mm"}),
             Contains("has no such profile"));
  CHECK_THAT(refused({shipped("linear_least_travel.toml"), "--width", "12 mm"}),
             Contains("whose profile is closed"));
  CHECK_THAT(failed({"export", kRoller, "--format", "dxf", "--width", "12 mm"}, 2),
             Contains("--width is for step"));
}

TEST_CASE("a stated face width is the width of the solid", "[export][step]") {
  CHECK(exported({kRoller, "--set", "face_width=18 mm"}).high[2] == Approx(18));
}

}  // namespace camlaw::cli::step_export_test
