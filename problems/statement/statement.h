// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/laws/catalogue.h"
#include "machines/model/mechanism.h"
#include "optim/solvers/native_options.h"

/// A design problem as a person states it: a file that names a mechanism, a law, what may vary,
/// what is wanted and what must hold. Reading it checks every name, unit and range; after that no
/// string is looked at again.
namespace camlaw::problems {

/// What one of a variable is in another unit.
struct Measure {
  double one;
  std::string unit;
};

/// A variable: a parameter of the mechanism or of the law. Numbers are in the listed unit.
struct VariableStatement {
  std::string name;  ///< as reported: "alpha", "blades", "c[2]"; "law.v" if the machine has v too
  std::string unit;
  bool of_law = false;
  std::size_t parameter = 0;  ///< of the mechanism; 0 for a law's: there its name counts
  std::string law_parameter;  ///< "c"; at least one of the laws has it
  std::size_t element = 0;    ///< of a list, from 0
  double lower = 0, upper = 0, start = 0;
  std::optional<double> scale;
  bool integer = false;
  std::vector<double> values;  ///< one of these, where not empty; lower and upper are their ends
  std::optional<Measure> measure = {};  ///< of a displacement whose tolerance is stated with a unit
};

/// One row of a catalogue.
struct PartItem {
  std::string name;
  std::vector<double> values;       ///< of PartStatement::parameters, in their listed units
  std::string source = {};          ///< where the row was read
  std::vector<double> inputs = {};  ///< of PartStatement::inputs, in their listed units
};

/// A part of the machine from a catalogue: one, or several to choose from, each with several of the
/// machine's numbers at once, or of what [buildable] states of it.
struct PartStatement {
  std::string name;                     ///< "roller"
  std::string catalogue = {};           ///< as the file names it
  std::vector<std::size_t> parameters;  ///< of the mechanism
  std::vector<PartItem> items;
  std::size_t start = 0;
  std::vector<std::string> inputs = {};  ///< of the mechanism's checks: "allowable_pressure"

  bool is_chosen() const { return items.size() > 1; }
};

/// What is taken of a response that differs between load cases.
enum class OverCases : char { Worst, Mean };

struct Robust;         // robust.h
struct Variations;     // variation.h
struct ProfileErrors;  // profile_errors.h

struct ObjectiveStatement {
  ResponseName response;
  optim::Sense sense = optim::Sense::Minimize;
  std::optional<double> tolerance;
  std::optional<double> reference = {};  ///< of a front: what its hypervolume is measured from
  /// Of one over load cases, whose response is none of the mechanism's.
  std::optional<OverCases> over = {};
  std::shared_ptr<const MechanismResponse> of_cases = {};
  ResponseName one_case = {};                               ///< what the file names
  std::shared_ptr<const MechanismResponse> of_ranges = {};  ///< of one over ranges
  ResponseName one_value = {};                              ///< what it is of
  /// What is taken of the values that manufacture makes of it; none: the worst.
  std::shared_ptr<const Robust> robust = {};
};

struct ConstraintStatement {
  ResponseName response;
  std::optional<double> lower, upper, tolerance;
  /// Of a limit that the file does not state, but a law has (Room): the response, which is none of
  /// the mechanism's.
  std::shared_ptr<const MechanismResponse> of_law = {};
  std::shared_ptr<const MechanismResponse> of_range = {};  ///< of one over ranges of parameters
  bool is_size = false;  ///< of one over ranges: a side of a limit on the largest size of a curve
  /// The probability with which it must hold, whatever manufacture does; none: always.
  std::optional<double> reliability = {};
  /// Of one with a reliability: the load cases in which a part must hold it at once; none where its
  /// response is the same in all.
  std::vector<std::string> in_cases = {};
  ResponseName one_value = {};  ///< of a quantile over parts: what each part must hold
  /// The share that a search asks of its few parts in place of the reliability, so that enough of
  /// all parts hold it (tolerance/reliable_search.h).
  std::optional<double> searched_share = {};
  bool of_check = false;  ///< of a check of the mechanism, which [buildable] requires to hold
  /// Of a limit that the file does not state: the response that has a meaning only while it is met,
  /// or "the mechanism".
  std::optional<std::string> required_by = {};
};

/// What a problem says of whether its machine can be built.
struct BuildableStatement {
  bool require = false;  ///< the checks that can be made are limits
  std::map<std::string, double, std::less<>> inputs = {};  ///< of checks, in their listed units
  std::string material = {};  ///< what allowable_pressure is of, and who says so
};

/// How to solve, where the file says so.
struct SolverStatement {
  std::optional<std::string> name;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  std::optional<double> time_limit;  ///< seconds
  /// Options that one solver alone has, by its name: [solver.ipopt].
  std::map<std::string, optim::NativeOptions> native;
};

/// A turn, and what takes a stated time of it. A cam that is cut has angles: a time becomes one
/// once, when the file is read, by how long a turn takes then.
struct ProgramTiming {
  struct Segment {
    std::string name;
    double time;  ///< s
  };

  double speed = 0;               ///< at which the times hold, rpm
  std::vector<Segment> segments;  ///< those that the file states in time
  /// Whether the times stay where the machine's speed is set to another value, and the angles
  /// change: of an electronic cam whose file has no times_at.
  bool stays = false;
  /// They stay, and the speed varies or differs between load cases: the program's parameters are
  /// times in place of angles, and the machine gives it its speed.
  bool follows = false;

  /// A turn, s: 60 s / (speed in rpm).
  double turn() const { return 60 / speed; }
  /// Of the cam, deg.
  double angle_of(double time) const { return time / turn() * 360; }
};

/// What a problem's text does not hold itself, by the names that it has for it: laws of files, and
/// the texts of tables.
struct HeldFiles {
  std::map<std::string, Member> laws = {};
  std::map<std::string, std::string> tables = {};
};

struct ProblemStatement;

/// One of the cams on a shaft as its own table states it: without objectives and limits.
struct CamStatement {
  std::string name;
  std::shared_ptr<const ProblemStatement> alone;
};

/// Programs that a class of laws such as "all" would make, and that there are not.
struct LeftOut {
  std::string what;  ///< "rise = harmonic"
  std::string why;
};

/// Constants and laws hold the starts of what varies, so that they make the design to begin with.
struct ProblemStatement {
  std::string title;
  std::shared_ptr<const Mechanism> mechanism;  ///< one of the registry's, or the file's own
  std::vector<double> constants;               ///< of every mechanism parameter, in its listed unit
  std::set<std::size_t> stated = {};           ///< of them, those that are not left to defaults
  /// One, or a list to choose from; all different. A variable of laws may be missing in some.
  std::vector<Member> laws;
  bool chooses_law() const { return laws.size() > 1; }
  std::vector<LeftOut> left_out = {};   ///< of the classes of laws that the file names
  std::optional<ProgramTiming> timing;  ///< where a program speaks of time
  /// The machine's stroke, where the motion is stated in its unit: it is not set beside it.
  std::set<std::size_t> told_by_motion = {};
  std::vector<PartStatement> parts = {};  ///< from catalogues
  std::vector<VariableStatement> variables;
  /// One, or for a front two or more; `evaluate` does without.
  std::vector<ObjectiveStatement> objectives;
  std::vector<ConstraintStatement> constraints;
  SolverStatement solver;
  /// Load cases; all of them set the same parameters. The mechanism has what differs in each.
  std::vector<LoadCase> cases = {};
  std::shared_ptr<const Mechanism> without_cases = {};  ///< the mechanism, where there are cases
  std::vector<ParameterRange> ranges = {};              ///< parameters that take any value within
  std::shared_ptr<const Variations> variation = {};     ///< what manufacture does; none: nothing
  BuildableStatement buildable = {};
  std::shared_ptr<const ProfileErrors> profile = {};  ///< what the shop makes of it; none: nothing
  std::string source = {};         ///< the file, for what is found out about the problem as a whole
  std::string text = {};           ///< as it was read
  bool finds_knots = false;        ///< [free] knots = "auto": refinement/refined_knots
  bool free_is_symmetric = false;  ///< [free] symmetric
  std::vector<std::string> settings = {};  ///< what set_values has changed since, in its own words
  HeldFiles files = {};                    ///< those that were read with it
  std::vector<CamStatement> cams = {};     ///< of several on one shaft, in the mechanism's order
  /// Set where whatever is being worked out of the problem is to end: its responses throw
  /// optim::Interrupted then. It must outlive all that is made of them.
  const std::atomic<bool>* stop = nullptr;
};

/// Reads a problem from TOML text; `source` names it in errors. Format: docs/problem-files.md.
/// Throws std::invalid_argument with the line, the key and what is accepted:
/// "cutter.toml:12: variables.alpha: lower -10 exceeds upper -20". Files that are known already are
/// not looked for on the disk.
ProblemStatement read_problem(std::string_view toml, const std::string& source);
ProblemStatement read_problem(std::string_view toml, const std::string& source, HeldFiles known);
/// Reads a file of at most 16 MiB. Throws std::invalid_argument too where it cannot be read.
ProblemStatement read_problem_file(const std::string& path);
/// The text of such a file.
std::string problem_text(const std::string& path);
/// The text of a file that is a `what`, "problem file or a result". Throws std::invalid_argument as
/// file_text does, and for a study.
std::string text_of_file(const std::string& path, const std::string& what);

/// Sets a variable's start, a constant or a law's fixed parameter: "blades=21", "stroke=30 mm",
/// "alpha=-3", "c=-1.8,0.2", "c[2]=0.2". For the values at which a design is looked at. Throws
/// std::invalid_argument, and leaves the problem as it is, for unknown names and for values outside
/// the variable's bounds or the parameter's range.
void set_value(ProblemStatement& problem, const std::string& assignment);
/// Several at once: a law must be possible with all of them, not after each.
void set_values(ProblemStatement& problem, std::span<const std::string> assignments);

/// The problem in sentences.
std::string in_words(const ProblemStatement& problem);

}  // namespace camlaw::problems
