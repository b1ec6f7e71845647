// SPDX-License-Identifier: MIT
// Sweeps against single runs, and a study against the same study worked out in another order.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "optim/search/optimise.h"
#include "optim/study/recorded_executor.h"
#include "problems/law_files/json_text.h"
#include "problems/sweeps/stored_sweep.h"
#include "problems/sweeps/sweep_worker.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::sweep_test {
namespace {

using Catch::Contains;
using testing::complaint;

const std::string kCam = R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
[variables.base_radius]
lower = "20 mm"
upper = "60 mm"
[objective]
minimize = "base_radius"
[[constraints]]
response = "pressure_angle"
lower = "-30 deg"
upper = "30 deg"
)";

SweepSettings swept(const std::vector<std::string>& settings) {
  SweepSettings result;
  for (const std::string& setting : settings) {
    if (auto axis = parse_axis(setting)) {
      result.axes.push_back(*axis);
    } else {
      result.set.push_back(setting);
    }
  }
  return result;
}

SweptCombinations run(const SweepStudy& study, int workers = 1) {
  optim::ProcessExecutor executor(sweep_service(study), study.options(), workers,
                                  worker_program(study));
  return study.run(executor);
}

/// Every number of the designs, and every reason.
void check_same(const SweptCombinations& a, const SweptCombinations& b) {
  REQUIRE(a.outcomes.size() == b.outcomes.size());
  CHECK(a.is_warm == b.is_warm);
  for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
    REQUIRE(a.outcomes[i].has_value() == b.outcomes[i].has_value());
    if (!a.outcomes[i]) continue;
    const optim::Outcome &p = *a.outcomes[i], &q = *b.outcomes[i];
    CHECK(p.failure == q.failure);
    REQUIRE(p.points.size() == q.points.size());
    if (p.points.empty()) continue;
    const optim::FrontPoint &x = p.points.front(), &y = q.points.front();
    CHECK(x.x == y.x);
    CHECK(x.objectives == y.objectives);
    CHECK(x.verdict == y.verdict);
    for (std::size_t k = 0; k < x.limits.size(); ++k) {
      CHECK(x.limits[k].margin == y.limits[k].margin);
      CHECK(x.limits[k].price == y.limits[k].price);
    }
  }
}

}  // namespace

TEST_CASE("what is swept reads as people write it", "[sweep]") {
  const SweepAxis speed = *parse_axis("speed=60:15:120 rpm");
  CHECK(speed.numbers == std::vector<double>{60, 75, 90, 105, 120});
  CHECK(speed.values.back() == "120 rpm");
  CHECK(parse_axis("x=0:0.1:0.3")->numbers == std::vector<double>{0, 0.1, 0.2, 0.3});
  CHECK(parse_axis("x=3:-1:1")->numbers == std::vector<double>{3, 2, 1});
  CHECK(parse_axis("x=1:2:5")->numbers == std::vector<double>{1, 3, 5});
  const SweepAxis radius = *parse_axis("roller_radius = 10, 12 mm");
  CHECK(radius.values == std::vector<std::string>{"10 mm", "12 mm"});
  CHECK_FALSE(parse_axis("roller=CF 12, CF 16")->is_numeric());
  CHECK_FALSE(parse_axis("stroke=30 mm").has_value());
  const SweepAxis laws = *parse_axis("law=cycloidal, legendre c=1,2");
  CHECK(laws.values == std::vector<std::string>{"cycloidal", "legendre c=1,2"});
  CHECK(parse_axis("rise.law=all")->values.size() > 30);

  CHECK_THAT(complaint([] { parse_axis("speed=60:0:120 rpm"); }), Contains("a step of 0"));
  CHECK_THAT(complaint([] { parse_axis("speed=60:-5:120 rpm"); }), Contains("does not lead"));
  CHECK_THAT(complaint([] { parse_axis("x=1:2:6"); }), Contains("do not meet 6"));
  CHECK(parse_axis("x=10 mm, 2 cm")->numbers == std::vector<double>{1, 2});
  CHECK_THAT(complaint([] { SweepStudy(kCam, "f.toml", swept({"stroke=nan"})); }),
             !Contains("nothing is swept") && Contains("stroke"));
  CHECK_THAT(complaint([] { SweepStudy(kCam, "f.toml", swept({"rise.law=nosuch"})); }),
             !Contains("nothing is swept") && Contains("nosuch"));
  CHECK_THAT(complaint([] { parse_axis("speed=60:120 rpm"); }), Contains("from:step:to"));
  CHECK_THAT(complaint([] { parse_axis("x=1 mm:2 deg:6 mm"); }), Contains("is not a range"));
  for (const char* range :
       {"speed=100-300", "speed=100 - 300 rpm", "speed=100..300", "speed=1 to 3 s"}) {
    INFO(range);
    CHECK_THAT(complaint([&] { parse_axis(range); }),
               Contains("from:step:to, such as speed=60:15:120"));
  }
  // Names of parts that begin with a number, and names in quotes whatever they hold.
  using Names = std::vector<std::string>;
  CHECK_FALSE(parse_axis("roller=608-2RS"));
  for (const Names& names : {Names{"608-2RS", "609-2RS"}, Names{"6200", "608-2RS"},
                             Names{"608-2RS", "6200"}, Names{"608ZZ", "609ZZ"}}) {
    const SweepAxis axis = *parse_axis("roller=" + names[0] + "," + names[1]);
    CHECK(axis.values == names);
    CHECK_FALSE(axis.is_numeric());
  }
  const SweepAxis quoted = *parse_axis(R"(roller="A, long" , "10","1:2:5", plain,"10..20")");
  CHECK(quoted.values == Names{"A, long", "10", "1:2:5", "plain", "10..20"});
  CHECK_FALSE(quoted.is_numeric());
  CHECK_FALSE(parse_axis(R"(roller="A, long")"));
  const SweepAxis doubled = *parse_axis(R"(roller="A ""long"", B", "C"" ")");
  CHECK(doubled.values == Names{R"(A "long", B)", R"(C" )"});
  CHECK_THAT(complaint([] { parse_axis(R"(roller="A"", B)"); }), Contains("no closing quote"));
  const Names odd{"M:1", "A, long", R"(3/8" wide)", "M=1", "10..20", "plain", R"("B")", " C "};
  std::string list;
  for (const std::string& name : odd) list += (list.empty() ? "" : ",") + listed_value(name);
  CHECK(parse_axis("roller=" + list)->values == odd);
  for (const char* plain : {"10 mm", "-3", "plain", "608-2RS"}) CHECK(listed_value(plain) == plain);
  CHECK_THAT(complaint([] { parse_axis("roller=608-2"); }), Contains("roller=\"608-2\""));
  CHECK_THAT(complaint([] { parse_axis("roller=\"A, B"); }), Contains("no closing quote"));
  CHECK_THAT(complaint([] { parse_axis("roller=\"A\" B"); }), Contains("a comma must follow"));
  CHECK(parse_axis("speed=1,2 Hz")->numbers == std::vector<double>{1, 2});
  CHECK_FALSE(parse_axis("x=1e-3 mm"));
  CHECK_FALSE(parse_axis("x=-3"));
  CHECK_FALSE(parse_axis("law=3-4-5"));
  CHECK_THAT(complaint([] { parse_axis("x=1:1e-9:6"); }), Contains("at most"));
  CHECK_THAT(complaint([] { parse_axis("law=cosine,cosine"); }), Contains("twice"));
  CHECK_THAT(complaint([] { parse_axis("speed"); }), Contains("sets nothing"));
  CHECK_THAT(complaint([] { parse_sampled_range("x=3:1 mm"); }), Contains("is not below"));
  CHECK_THAT(complaint([] { parse_sampling("halton 3", 1); }), Contains("sobol"));
}

TEST_CASE("samples fill their ranges evenly", "[sweep]") {
  for (const char* method : {"sobol 64", "lhs 64"}) {
    Sampling sampling = parse_sampling(method, 7);
    sampling.over = {parse_sampled_range("a=10:20 mm"), parse_sampled_range("b=0:1")};
    const auto samples = samples_of(sampling);
    CHECK(samples == samples_of(sampling));
    REQUIRE(samples.size() == 64);
    if (*method == 's') {  // the sequence by hand, after its origin
      CHECK(samples[0] == std::vector<double>{15, 0.5});
      CHECK(samples[1] == std::vector<double>{17.5, 0.25});
      CHECK(samples[2] == std::vector<double>{12.5, 0.75});
      CHECK(samples[3] == std::vector<double>{13.75, 0.375});
    }
    // Of 64 samples eight are in each eighth of a range; Sobol's leaves out its first, the corner,
    // so that one eighth may have one more or one less.
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<int> count(8);
      for (const auto& sample : samples) {
        const double part =
            (sample[k] - sampling.over[k].low) / (sampling.over[k].high - sampling.over[k].low);
        REQUIRE((part >= 0 && part < 1));
        ++count[static_cast<std::size_t>(8 * part)];
      }
      for (const int n : count) CHECK(std::abs(n - 8) <= (*method == 's' ? 1 : 0));
    }
  }
}

TEST_CASE("each combination is in one chain, beside one that differs by a step", "[sweep]") {
  SweepSettings settings = swept({"a=1:1:20", "law=cosine,cycloidal,poly-3-4-5", "b=1,2"});
  const SweepPlan plan(settings);
  REQUIRE(plan.size() == 120);
  std::set<std::size_t> seen;
  for (const auto& chain : plan.chains()) {
    CHECK(chain.size() <= kChain);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      CHECK(seen.insert(chain[i]).second);
      if (i == 0) continue;
      const auto now = plan.values(chain[i]), before = plan.values(chain[i - 1]);
      CHECK(now[0].number == before[0].number + 1);
      CHECK((now[1].text == before[1].text && now[2].text == before[2].text));
    }
  }
  CHECK(seen.size() == 120);
  settings.is_cold = true;
  CHECK(SweepPlan(settings).chains().size() == 120);
  CHECK(to_json(sweep_settings(to_json(settings), {})) == to_json(settings));
  CHECK_THAT(complaint([] { SweepPlan(swept({"a=1,2", "a=3,4"})); }), Contains("swept twice"));
  CHECK_THAT(complaint([] { SweepPlan(swept({"a=1"})); }), Contains("nothing is swept"));
  CHECK_THAT(complaint([] {
               SweepPlan(swept({"a=1:1:400", "b=1:1:400"}));
             }),
             Contains("more than"));
}

TEST_CASE("the ranking of laws by a sweep is that of single runs, bit for bit", "[sweep]") {
  const SweepStudy study(kCam, "cam.toml", swept({"law=ends R-R, continuity >= 2"}));
  const SweptCombinations sweep = run(study);
  REQUIRE(sweep.outcomes.size() > 5);
  for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
    ProblemStatement single = read_problem(kCam, "cam.toml");
    const std::string law = study.plan().values(i).front().text;
    INFO(law);
    try {
      set_value(single, "law=" + law);
    } catch (const std::invalid_argument& refused) {
      CHECK(sweep.outcomes[i]->failure == refused.what());
      continue;
    }
    const optim::Optimum found = optim::optimise(BoundProblem(single).space());
    const optim::Assessment& a = found.found.assessment;
    const optim::Outcome& outcome = *sweep.outcomes[i];
    if (outcome.points.empty()) {
      CHECK(outcome.failure == a.reason);
      continue;
    }
    const optim::FrontPoint& point = outcome.points.front();
    CHECK(point.x == found.found.x);
    CHECK(point.verdict == a.verdict);
    CHECK(point.objectives.front() == a.objective.value);
    for (std::size_t k = 0; k < point.limits.size(); ++k) {
      CHECK(point.limits[k].margin == a.limits[k].margin);
      CHECK(point.limits[k].price == a.limits[k].multiplier);
    }
  }
}

TEST_CASE("a sweep does not depend on workers, nor on a record that was cut short", "[sweep]") {
  const testing::Folder folder;
  // Strokes for which the cam has no room are among them.
  const SweepStudy study(kCam, "cam.toml",
                         swept({"stroke=16:2:40 mm", "rise.law=cycloidal,modified-sine"}));
  const SweptCombinations one = run(study);
  CHECK(one.done() == one.outcomes.size());
  CHECK(std::any_of(one.outcomes.begin(), one.outcomes.end(),
                    [](const auto& o) { return o->infeasible && !o->failure.empty(); }));
  CHECK(std::count(one.is_warm.begin(), one.is_warm.end(), true) > 10);
  check_same(one, run(study, 2));

  const std::string path = folder / "study.db";
  const auto problem_of = [&](std::size_t part, optim::Design x) { return study.problem(part, x); };
  std::atomic<bool> stop{false};
  {  // ended after some tasks
    SweepStudy stopped = study;
    stopped.options().stop = &stop;
    optim::StudyRecord record = optim::StudyRecord::create(path, study.settings());
    optim::ProcessExecutor executor(sweep_service(stopped), stopped.options(), 1, {});
    optim::RecordedExecutor recorded(problem_of, record, &executor);
    const SweptCombinations part =
        stopped.run(recorded, [&](const SweepProgress& p) { stop = p.done >= 7; });
    CHECK(part.done() < one.outcomes.size());
    CHECK(part.done() >= 7);
  }
  {  // what is there is shown
    optim::StudyRecord record = optim::StudyRecord::read(path);
    const StoredSweep stored = stored_sweep(SweepStudy::of(record.settings()), record);
    CHECK(stored.faults.empty());
    CHECK(stored.sweep.done() >= 7);
  }
  {
    study.check_same(optim::StudyRecord::read(path));
    optim::StudyRecord record = optim::StudyRecord::open(path);
    optim::ProcessExecutor executor(sweep_service(study), study.options(), 2, {});
    optim::RecordedExecutor recorded(problem_of, record, &executor);
    check_same(one, study.run(recorded));
    CHECK(recorded.faults().empty());
  }
  optim::StudyRecord record = optim::StudyRecord::read(path);
  check_same(one, stored_sweep(SweepStudy::of(record.settings()), record).sweep);
  const SweepStudy other(kCam, "cam.toml", swept({"stroke=16:2:20 mm"}));
  CHECK_THAT(complaint([&] { other.check_same(record); }), Contains("another sweep"));
}

TEST_CASE("a warm start leads where a single run does", "[sweep]") {
  SweepSettings settings = swept({"stroke=16:1:31 mm"});
  const SweptCombinations warm = run(SweepStudy(kCam, "cam.toml", settings));
  settings.is_cold = true;
  const SweptCombinations cold = run(SweepStudy(kCam, "cam.toml", settings));
  for (std::size_t i = 0; i < warm.outcomes.size(); ++i) {
    REQUIRE(warm.outcomes[i]->points.size() == 1);
    CHECK(warm.outcomes[i]->points[0].verdict == optim::Verdict::Certified);
    CHECK(warm.outcomes[i]->points[0].objectives[0] ==
          Approx(cold.outcomes[i]->points[0].objectives[0]).epsilon(1e-7));
  }
}

TEST_CASE("choices of a combination are recorded with its design", "[sweep]") {
  std::string text = kCam;
  const std::string law = "law = \"modified-sine\"";
  text.replace(text.find(law), law.size(), "law = [\"modified-sine\", \"cycloidal\"]");
  const testing::Folder folder;
  const SweepStudy study(text, "cam.toml", swept({"stroke=20,25 mm"}));
  const std::string path = folder / "study.db";
  optim::StudyRecord record = optim::StudyRecord::create(path, study.settings());
  optim::ProcessExecutor executor(sweep_service(study), study.options(), 1, {});
  optim::RecordedExecutor recorded(
      [&](std::size_t part, optim::Design x) { return study.problem(part, x); }, record, &executor);
  const SweptCombinations sweep = study.run(recorded);
  const optim::FrontPoint& point = sweep.outcomes[1]->points.front();
  const auto variables = study.variables(1, point.x);
  REQUIRE(variables.size() == 2);
  CHECK(variables[0].name == "base_radius");
  const ProblemStatement design = study.design(1, point.x);
  CHECK(design.laws.size() == 1);
  CHECK_THAT(variables[1].words, Contains(design.laws.front().family->name));
  CHECK(design.variables.front().start == point.x.front());
  check_same(sweep, stored_sweep(study, record).sweep);
}

TEST_CASE("designs are evaluated without a search, and each says what it passes", "[sweep]") {
  SweepSettings settings = swept({"stroke=10:10:50 mm"});
  settings.evaluates = true;
  settings.sampling = parse_sampling("sobol 4", 1);
  settings.sampling->over = {parse_sampled_range("base_radius=30:60 mm")};
  const SweepStudy study(kCam, "cam.toml", settings);
  const SweptCombinations sweep = run(study);
  REQUIRE(sweep.outcomes.size() == 20);
  for (std::size_t i = 0; i < 20; ++i) {
    ProblemStatement single = read_problem(kCam, "cam.toml");
    set_values(single, study.plan().assignments(i));
    const auto limits = standing(single);
    const optim::FrontPoint& point = sweep.outcomes[i]->points.at(0);
    CHECK(point.objectives[0] == single.variables[0].start);
    CHECK(point.limits[0].margin == limits[0].margin);
    CHECK(point.limits[0].met == limits[0].met);
  }
}

TEST_CASE("an end of a range that only the command line states is swept with the other one",
          "[sweep]") {
  const std::vector<std::string> asked{"stroke=20 mm", "ranges.speed.lower=100 rpm",
                                       "ranges.speed.upper=200:50:300 rpm"};
  const SweepStudy study(kCam, "cam.toml", swept(asked));
  const SweepStudy recorded = SweepStudy::of(study.settings());
  CHECK(recorded.settings() == study.settings());
  REQUIRE(study.plan().size() == 3);
  for (const SweepStudy* one : {&study, &recorded}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto stated = one->stated(i);
      REQUIRE(stated);
      REQUIRE(stated->ranges.size() == 1);
      CHECK(stated->ranges.front().lower == 100);
      CHECK(stated->ranges.front().upper == 200 + 50 * static_cast<double>(i));
    }
  }
  CHECK(SweepStudy(kCam, "cam.toml", swept({"cases.fast.weight=2", "cases.fast.speed=100,200 rpm"}))
            .stated(1)
            ->cases.front()
            .weight == 2);
  CHECK_THAT(complaint([] {
               SweepStudy(kCam, "cam.toml",
                          swept({"ranges.speed.lowr=1 rpm", "ranges.speed.upper=2,3 rpm"}));
             }),
             Contains("lowr"));
}

TEST_CASE("a misspelt value is refused before anything is worked out", "[sweep]") {
  const auto says = [](const std::vector<std::string>& settings) {
    return complaint([&] { SweepStudy(kCam, "cam.toml", swept(settings)); });
  };
  CHECK_THAT(says({"law=cycloidal,modified-sin"}), Contains("modified-sin"));
  CHECK_THAT(says({"stroke=10:5:20 deg"}), Contains("length"));
  CHECK_THAT(says({"strike=10:5:20 mm"}), Contains("did you mean stroke"));
  CHECK_THAT(says({"law=cosine,cycloidal", "strike=3 mm"}), Contains("did you mean stroke"));
  CHECK_THAT(says({"law=harmonic,modified-sin"}), Contains("modified-sin"));
  // Laws whose acceleration jumps at the dwells: all of a list, then one of several.
  CHECK_THAT(says({"law=harmonic,double-harmonic"}), Contains("harmonic") && Contains("jumps"));
  const SweepStudy study(kCam, "cam.toml", swept({"law=cycloidal,harmonic", "stroke=10,20 mm"}));
  CHECK(study.stated(0));
  for (const std::size_t k : {2, 3}) {
    const auto refused = study.stated(k);
    CHECK_FALSE(refused);
    CHECK_THAT(refused.why(), Contains("harmonic") && Contains("jumps"));
  }
  const std::string none = kCam.substr(0, kCam.find("[objective]"));
  CHECK_THAT(complaint([&] { SweepStudy(none, "cam.toml", swept({"stroke=10,20 mm"})); }),
             Contains("states none"));
}

TEST_CASE("a number that a machine does not take is a row that says why", "[sweep]") {
  const struct {
    const char *file, *axis, *why;
    std::size_t refused;
  } examples[] = {
      {"index_drives/parallel_eight", "rollers=4,8,16", "whole number of pitches", 0},
      {"index_drives/parallel_eight", "plates=2,3,9", "plates accepts", 2},
      {"index_drives/barrel_eight", "roller_radius=-1:9:8 mm", "roller_radius accepts", 0},
      {"index_drives/globoidal_eight", "index_angle=200,400 deg", "400 deg", 1},
      {"cams/roller_least_base", "base_radius=50,500 mm", "outside the bounds", 1},
      {"cams/roller_least_base", "pressure_angle.upper=-50,30 deg", "would not be below", 0},
      {"servo_axis/pick_and_place", "gear_ratio=0,2", "gear_ratio", 0},
      {"geneva/fastest", "slots=2,6", "slots", 0},
      {"springs/lightest_helical", "active_coils=-3,6", "active_coils", 0}};
  for (const auto& [file, axis, why, refused] : examples) {
    const auto path = testing::source(std::string("problems/") + file + ".toml");
    SweepSettings settings = swept({axis});
    settings.evaluates = true;
    const SweepStudy study(testing::read(path), path, settings);
    const SweptCombinations sweep = run(study);
    for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
      INFO(file << ": " << axis << ", " << i);
      REQUIRE(sweep.outcomes[i]);
      CHECK(sweep.outcomes[i]->points.empty() == (i == refused));
      if (i == refused) CHECK_THAT(sweep.outcomes[i]->failure, Contains(why));
    }
  }
}

}  // namespace camlaw::problems::sweep_test
