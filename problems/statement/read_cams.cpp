// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/laws/side_by_side.h"
#include "machines/model/shaft.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

/// A problem file with several cams on one shaft. Each is read as a file of its own would be, and
/// what came of it is put together by the names and numbers of the shaft's mechanism.
namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// Each has parameters, responses and a law of its own in the shaft's mechanism.
constexpr std::size_t kMostCams = 40;
constexpr std::size_t kMostMotions = 5000;  // combinations of the cams' laws

struct ReadCam {
  std::string name;
  std::shared_ptr<const Mechanism> mechanism;  ///< without a phase
  ProblemStatement alone;
  FixedNames fixed;
};

/// What a cam has beside what it has in a file of its own.
std::shared_ptr<const Mechanism> with_phase(const Mechanism& mechanism) {
  Mechanism result = mechanism;
  result.parameters.push_back(phase_parameter(kPhase, "the cam"));
  return std::make_shared<const Mechanism>(std::move(result));
}

/// The table of a table, made where there is none.
Entry& table_in(Entry& table, const char* key) {
  const auto found = std::find_if(table.items.begin(), table.items.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  if (found != table.items.end()) return *found;
  Entry made;
  made.place = table.place;
  made.path = table.path + "." + key;
  made.key = key;
  table.items.push_back(std::move(made));
  return table.items.back();
}

/// A cam's table with the speed that the file states for the shaft.
Entry with_speed(const Entry& table, const Entry& file, const Mechanism& mechanism) {
  const auto& all = mechanism.parameters;
  const auto speed = std::find_if(all.begin(), all.end(), [](const MechanismParameter& p) {
    return p.name == kSpeed && p.unit == "rpm";
  });
  if (speed == all.end()) return table;
  const StatedParameter own = stated_parameter(table, *speed);
  if (const Entry* twice = own.fixed != nullptr ? own.fixed : own.varying) {
    refuse(*twice, "the speed is the shaft's; state it once, in the file's own [constants]");
  }
  Entry result = table;
  const StatedParameter stated = stated_parameter(file, *speed);
  const auto give = [&](const Entry* entry, const char* key) {
    if (entry == nullptr) return;
    Entry& in = table_in(result, key);
    expect(in, Kind::Table, fmt::format("a table, [{}.{}]", table.path, key));
    in.items.push_back(*entry);
    in.items.back().key = speed->name;
  };
  give(stated.fixed, "constants");
  give(stated.varying, "variables");
  return result;
}

void check_cam(const Entry& table) {
  check_spelling(table, table.key);
  expect(table, Kind::Table, fmt::format("a table, [cams.{}] with a mechanism", table.key));
  check_keys(table, {"mechanism", "machine", "responses", "constants", "law", "free", "program",
                     "parts", "variables", "buildable"});
  const Entry* buildable = find(table, "buildable");
  if (buildable == nullptr || buildable->kind != Kind::Table) return;
  if (const Entry* require = find(*buildable, "require")) {
    refuse(*require, "it holds for all cams; write it in the file's own [buildable]");
  }
}

/// Whether ranges, variations or load cases of the file give the shaft several speeds.
bool has_several_speeds(const Entry& file) {
  const auto holds = [](const Entry& table) { return find(table, kSpeed) != nullptr; };
  for (const char* key : {"ranges", "variation"}) {
    if (const Entry* table = find(file, key); table != nullptr && holds(*table)) return true;
  }
  const Entry* cases = find(file, "cases");
  return cases != nullptr && std::any_of(cases->items.begin(), cases->items.end(), holds);
}

ReadCam read_cam(const Entry& table, const Entry& file, HeldFiles& files) {
  check_cam(table);
  ReadCam cam{table.key, {}, {}, {}};
  ProblemStatement& alone = cam.alone;
  alone.title = table.key;
  alone.files = std::move(files);
  read_mechanism(table, alone);
  cam.mechanism = alone.mechanism;
  alone.mechanism = with_phase(*cam.mechanism);
  alone.constants.push_back(0);
  const Entry whole = with_speed(table, file, *cam.mechanism);
  read_motion(whole, alone, cam.fixed);
  const bool differs = alone.timing && alone.timing->stays && has_several_speeds(file);
  if (differs || (alone.timing && alone.timing->follows)) {
    refuse(table,
           "its program has times, and the shaft's speed varies: write the speed at which the "
           "times hold in its program, such as times_at = \"60 rpm\"; their angles are then kept "
           "at every speed");
  }
  read_buildable(whole, alone);
  files = std::move(alone.files);
  return cam;
}

/// Names of the cam's law that its machine has too, which are press.law.NAME on the shaft.
std::set<std::string> machine_names(const Mechanism& mechanism) {
  std::set<std::string> names;
  for (const MechanismParameter& p : mechanism.parameters) {
    names.insert(p.name);
    names.insert(p.symbol);
  }
  return names;
}

/// Every combination of the cams' laws, each as one member.
std::vector<Member> combined_laws(const Entry& table, const std::vector<ReadCam>& cams) {
  std::size_t count = 1;
  for (const ReadCam& cam : cams) count *= cam.alone.laws.size();
  if (count > kMostMotions) {
    refuse(table, fmt::format("there are {} combinations of the cams' laws; at most {} are tried",
                              count, kMostMotions));
  }
  std::vector<Member> result;
  for (std::size_t n = 0; n < count; ++n) {
    std::vector<LawBeside> laws;
    std::size_t rest = n;
    for (const ReadCam& cam : cams) {
      const std::size_t options = cam.alone.laws.size();
      laws.push_back(
          {cam.name, cam.alone.laws[rest % options], machine_names(*cam.alone.mechanism)});
      rest /= options;
    }
    result.push_back(side_by_side(laws));
  }
  return result;
}

/// Puts what one cam's table states into the problem.
class Joining {
 public:
  Joining(const ReadCam& cam, const ShaftCam& on_shaft)
      : cam_(cam), on_shaft_(on_shaft), names_(machine_names(*cam.alone.mechanism)) {}

  void add_to(ProblemStatement& problem, FixedNames& fixed) const {
    const ProblemStatement& alone = cam_.alone;
    for (std::size_t i = 0; i < alone.constants.size(); ++i) {
      if (is_speed(i)) continue;
      problem.constants[place(i)] = alone.constants[i];
      if (alone.stated.contains(i)) problem.stated.insert(place(i));
      if (alone.told_by_motion.contains(i)) problem.told_by_motion.insert(place(i));
    }
    for (const VariableStatement& v : alone.variables) {
      if (v.of_law || !is_speed(v.parameter)) problem.variables.push_back(variable(v));
    }
    for (PartStatement part : alone.parts) {
      part.name = before() + part.name;
      for (std::size_t& parameter : part.parameters) parameter = place(parameter);
      for (std::string& input : part.inputs) input = before() + input;
      problem.parts.push_back(std::move(part));
    }
    for (const std::string& name : cam_.fixed) {
      if (name != kSpeed) fixed.insert(before() + name);
    }
    for (const auto& [name, value] : alone.buildable.inputs) {
      problem.buildable.inputs[before() + name] = value;
    }
    add_material(alone.buildable.material, problem.buildable.material);
  }

 private:
  std::string before() const { return cam_.name + "."; }
  bool is_speed(std::size_t own) const {
    return own < on_shaft_.parameters.size() && on_shaft_.parameters[own] == 0;
  }
  std::size_t place(std::size_t own) const {
    return own < on_shaft_.parameters.size() ? on_shaft_.parameters[own] : on_shaft_.phase;
  }
  VariableStatement variable(VariableStatement v) const {
    v.name = before() + v.name;
    if (v.of_law) {
      v.law_parameter =
          before() + (names_.contains(v.law_parameter) ? "law." : "") + v.law_parameter;
    } else {
      v.parameter = place(v.parameter);
    }
    return v;
  }
  void add_material(const std::string& own, std::string& all) const {
    if (own.empty()) return;
    all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", cam_.name, own);
  }

  const ReadCam& cam_;
  const ShaftCam& on_shaft_;
  std::set<std::string> names_;
};

}  // namespace

void read_cams(const Entry& file, ProblemStatement& problem, FixedNames& fixed) {
  const Entry& table = *find(file, "cams");
  expect(table, Kind::Table, "tables, such as [cams.press]");
  for (const char* key : {"mechanism", "machine", "law", "free", "program"}) {
    if (const Entry* other = find(file, key)) {
      refuse(*other, fmt::format("the file has several cams, each with its own {0}; write it in "
                                 "[cams.NAME]",
                                 key));
    }
  }
  if (table.items.empty() || table.items.size() > kMostCams) {
    refuse(table, fmt::format("{} cams; a file may have 1 to {}", table.items.size(), kMostCams));
  }
  std::vector<ReadCam> cams;
  std::vector<NamedCam> named;
  for (const Entry& entry : table.items) {
    cams.push_back(read_cam(entry, file, problem.files));
    named.push_back({entry.key, cams.back().mechanism});
  }
  auto mechanism =
      std::make_shared<Mechanism>(located(table, [&] { return shaft_mechanism(named); }));
  read_stated_responses(file, *mechanism);
  for (const MechanismParameter& p : mechanism->parameters) {
    problem.constants.push_back(p.default_value);
  }
  problem.laws = combined_laws(table, cams);
  for (std::size_t i = 0; i < cams.size(); ++i) {
    Joining(cams[i], mechanism->cams[i]).add_to(problem, fixed);
    for (const LeftOut& left : cams[i].alone.left_out) {
      problem.left_out.push_back({cams[i].name + "." + left.what, left.why});
    }
    problem.cams.push_back(
        {cams[i].name, std::make_shared<const ProblemStatement>(std::move(cams[i].alone))});
  }
  problem.mechanism = std::move(mechanism);
  read_constants(file, problem, fixed);
  read_variables(file, problem, fixed);
}

}  // namespace camlaw::problems
