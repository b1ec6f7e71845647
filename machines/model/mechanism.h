// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kinematics/peaks.h"
#include "numerics/scalar/interval.h"
#include "optim/problem/problem.h"

namespace camlaw {
class Expression;
template <class T>
class Lazy;
}  // namespace camlaw

/// Mechanisms as problem files and programs see them: parameters and responses by name. The
/// formulas are in the machine's folder too; names, units and ranges are joined to them once.
namespace camlaw::problems {

class LawBinding;
struct UsualProblem;

/// A number that describes the machine.
struct MechanismParameter {
  std::string name, symbol;  ///< "stroke", "S_f": both are understood
  std::string unit;          ///< the one it is listed in, and that problems count in
  std::string stored;        ///< the one that the formulas use
  std::string meaning;
  double default_value;  ///< in the listed unit, as are the ends of the range
  double low, high;      ///< accepted values, ends included
  bool integer = false;
};

/// A load case: values that some parameters have in it, others at rest (load_case.h).
struct LoadCase {
  std::string name;
  double weight = 1;  ///< in a mean over the cases
  /// In listed units, by the index of the parameter, increasing.
  std::vector<std::pair<std::size_t, double>> parameters = {};
};

/// A parameter that may have any value between two, in its listed unit (over_ranges.h).
struct ParameterRange {
  std::size_t parameter;
  double lower, upper;
};

/// The number of a derivation in docs/theory.md, "Declared convexity". There is none without
/// a number: a shape cannot be declared on trust.
class Proof {
 public:
  /// "DS6"; does not compile otherwise.
  consteval Proof(const char* number) : number_(number) {
    if (number_.size() < 3 || !number_.starts_with("DS")) throw "a proof is a number such as DS6";
  }
  constexpr std::string_view number() const { return number_; }

 private:
  std::string_view number_;
};

/// A statement about a response's form that rules do not find: it holds where, of all that the
/// response depends on, nothing varies but what is named. "law" stands for all parameters in which
/// the law is linear.
struct ShapeStatement {
  std::vector<std::string> varying;
  optim::Shape shape;
  Proof proof;
};

/// What of a design varies, and what the rest is: a mechanism and a law bound to design variables.
struct Binding {
  std::vector<double> constants;  ///< of every parameter, in its listed unit; variables overwrite
  std::vector<std::size_t> parameters;  ///< parameters that vary, increasing ...
  std::vector<std::size_t> variables;   ///< ... and the design variable behind each
  std::shared_ptr<const LawBinding> law;
};

/// A response that must not pass a bound: beyond it formulas do not hold, of the whole mechanism or
/// of another response. A problem that they matter to has it among its limits, unless it states a
/// tighter one.
struct ValidityLimit {
  std::string response;
  double upper = optim::kInfinity;  ///< in the listed unit
  double lower = -optim::kInfinity;
  std::string only_with = {};  ///< the parameter that is 0 where there is nothing to hold
};

/// Parameters of a mechanism by their indices, increasing, each once. Those that a formula depends
/// on are found when they are first asked for, since its record takes time; a copy shares them.
class ParameterSet {
 public:
  ParameterSet() = default;  ///< none
  ParameterSet(std::initializer_list<std::size_t> indices);
  explicit ParameterSet(std::vector<std::size_t> indices);  ///< in any order
  explicit ParameterSet(std::function<std::vector<std::size_t>()> find);

  const std::vector<std::size_t>& indices() const;
  bool holds(std::size_t parameter) const;
  auto begin() const { return indices().begin(); }
  auto end() const { return indices().end(); }

 private:
  std::shared_ptr<const Lazy<std::vector<std::size_t>>> found_;
};

/// The parameters that are in any of the sets.
ParameterSet united(std::vector<ParameterSet> sets);

/// A number that a formula holds as a whole, for it is searched for: the peak of a curve, an
/// integral over the cycle.
struct InnerNumber {
  std::string name, unit;
  ParameterSet uses;  ///< the parameters that it depends on
  std::function<optim::Function(const Binding&)> number;
};

struct Cycle;

/// Writes a formula of all parameters, in listed units, and some other inputs into the one that is
/// being recorded (numerics/formula).
using Write = std::function<Expression(std::span<const Expression> parameters,
                                       std::span<const Expression> others)>;

/// Whether there is such a machine, of values of its parameters. None: always.
using IsPossible = std::function<bool(std::span<const double>)>;

/// A condition of there being a machine, as how far it is from being broken.
struct Margin {
  Write write;                                              ///< above 0 where the condition holds
  bool may_be_zero = false;                                 ///< it holds at 0 too
  std::function<Interval(std::size_t parameter)> accepted;  ///< what a parameter may be, as listed
};

/// What decides whether there is a machine: a response is a number only where there is
/// (machines/model/possible_by.h).
struct PossibleBy {
  ParameterSet parameters = {};  ///< that decide, whatever the others are
  std::vector<Margin> margins = {};
  /// Parameters that vary besides those of a binding: ranges that a response is taken over.
  ParameterSet ranges = {};

  bool holds(std::size_t parameter) const { return parameters.holds(parameter); }
};

/// What makes a curve over the turn of a shaft that no law moves.
struct ShaftTurn {
  /// Where the sections meet in which it is smooth, rad, increasing; they have no other inputs.
  std::vector<Write> breaks;
  /// The formula. The other inputs are the angle, rad, and for each break a number that is below 0
  /// before it and 0 or above from it on.
  Write sided;
};

/// Of a response in a load case: the case, what the response is called in any, and what the case
/// sets.
struct InCase {
  std::string name, response;
  std::vector<std::pair<std::size_t, double>> parameters = {};
};

struct OverRanges;
struct MechanismResponse;

/// The part of the cycle that a limit or an objective is about.
struct CycleWindow {
  std::string segment;      ///< of the motion program; empty: the places follow
  double from = 0, to = 0;  ///< in the curve's own unit
};

/// A response asked for by name: one of the mechanism's, a named peak, "peak X", "highest X" or
/// "lowest X" of a curve X, or a parameter of the mechanism (a number that the design holds).
struct ResponseName {
  std::string name;                             ///< as asked for
  const MechanismResponse* response = nullptr;  ///< null for a parameter
  std::size_t parameter = 0;                    ///< where response is null
  optim::Part part = optim::Part::Value;        ///< of a curve; Value: the curve itself, everywhere
  std::string unit;                             ///< listed
  std::optional<CycleWindow> window = {};       ///< of a curve; none: the whole cycle
};

/// A curve that the formula of another curve holds: of one of the cams on a shaft, at the phase of
/// its cam, or of the machine itself, at the same angle.
struct HeldCurve {
  std::size_t cam = 0;
  std::optional<std::size_t> phase = {};  ///< the parameter that it is; none: of the machine itself
  std::shared_ptr<const MechanismResponse> response;
};

struct MechanismResponse {
  std::string name;
  std::string unit;  ///< listed
  std::string meaning;
  std::vector<ShapeStatement> shapes = {};
  ParameterSet uses = {};  ///< the parameters that it depends on
  PossibleBy possible_by = {};
  IsPossible is_possible = {};  ///< of all parameters, in their listed units
  std::string along = {};       ///< of a curve: the unit of its places, "deg" of cam angle
  std::shared_ptr<const Cycle> cycle = {};  ///< of a curve that follows the law
  bool sees_law = false;                    ///< whether the law, or the program, matters to it
  std::optional<Quantity> of_law = {};      ///< of a curve that is the law's own: which
  std::vector<ValidityLimit> defined_while = {};  ///< where it is a number
  /// The formula in its listed unit. The other inputs are for a curve s, v, a, j and x, for one
  /// over a turn the angle, for a number the inner numbers. None where the response is not a
  /// formula.
  Write write = {};
  /// An expression that is 0 or above where the formula has a value, where that is not said by
  /// defined_while.
  Write domain = {};
  std::shared_ptr<const ShaftTurn> turn = {};  ///< of a curve that no law moves
  std::vector<InnerNumber> inner = {};
  std::optional<std::size_t> cam = {};  ///< of several on one shaft the cam that it is of
  bool is_coordinate = false;           ///< of a point of a curve of the cam, such as its profile
  /// Of a curve over the turn of such a shaft, or of one that is made of the machine's own curves:
  /// its formula's other inputs are the angle, rad, and these.
  std::vector<HeldCurve> held = {};
  /// One of the two makes the response for a binding, in which only what it uses, and what it is
  /// possible by, varies.
  std::function<optim::Function(const Binding&, optim::Shape)> number = {};
  std::function<std::shared_ptr<const optim::Curve>(const Binding&, optim::Shape)> curve = {};
  std::optional<InCase> in_case = {};  ///< load_case.h
  /// Of the worst or the mean of load cases: the response in each.
  std::vector<ResponseName> over_cases = {};
  std::shared_ptr<const OverRanges> over_ranges = {};  ///< over_ranges.h
};

/// A name for a part of a curve: "peak_inertia_force" is the magnitude of "inertia_force".
struct NamedPeak {
  std::string name, curve;
  optim::Part part;
  std::string meaning;
};

/// What a mechanism's follower takes its motion from.
enum class MovedBy {
  Law,      ///< a law, run once in each stretch of the mechanism's own cycle
  Program,  ///< a motion program over the whole cycle
  Nothing,  ///< it moves as its geometry makes it; x is the driving side's uniform progress
};

/// How a machine is built: which picture shows it, and how a measured cam of it is read.
enum class Form : char {
  Other,
  DiscRoller,          ///< a disc cam and a follower that slides
  DiscKnifeEdge,       ///< the same, with a knife edge
  DiscFlat,            ///< the same, with a flat face
  DiscConjugate,       ///< two discs, each with a roller of the same follower
  DiscTrailingRoller,  ///< a disc cam and a roller on an arm that it pulls
  DiscLeadingRoller,   ///< the same, the arm pushed
  DiscFlatArm,         ///< a disc cam and a flat face on an arm
  EndRoller,           ///< an end or barrel cam and a roller that slides
  EndArm,              ///< the same, the roller on an arm
  Plate,               ///< a plate that moves along a line
  BalancingCam,        ///< a cam between springs, on a shaft
  Geneva,
  SphericalGeneva,
  SignatureFeeder,
  ParallelIndex,  ///< disc cams that turn a turret by stations
  BarrelIndex,    ///< a barrel cam and a turret whose rollers are parallel to its axis
  RollerGear,     ///< a globoidal cam and a turret with radial rollers
  LawAlone,       ///< a law by itself, no machine
  Shaft,          ///< several cams on one shaft
};

/// Says of the responses of these names where they are numbers.
void set_defined_while(std::vector<MechanismResponse>& responses,
                       const std::vector<std::string>& names, const ValidityLimit& limit);

/// A number that checks need and the machine's formulas do not. It has no default: where a problem
/// does not state it, what needs it is not checked.
struct BuildableInput {
  std::string name, unit, meaning;
  double usual;  ///< of the right size, to be changed, in a file to begin with
};

/// How a follower is kept on its cam.
enum class Closure : char {
  Any,
  Force,  ///< by a spring or a load
  Form,   ///< in a groove
};

/// A stated number by the name of its parameter or input; none where the problem does not state it.
using StatedNumber = std::function<std::optional<double>(std::string_view)>;

/// A limit on a response that every design of the machine is looked at by. At the bound it holds.
struct BuildableCheck {
  std::string name;      ///< "wall"
  std::string fault;     ///< "the wall round the bore is too thin": what it is that fails
  std::string response;  ///< of the mechanism, or one of its named peaks
  bool is_upper;         ///< whether the bound is one from above
  /// In the response's listed unit, of what the check needs and, if it is stated, its input.
  std::function<double(const StatedNumber&)> bound;
  std::vector<std::string> needs = {};   ///< parameters and inputs that the problem must state
  std::vector<std::string> one_of = {};  ///< ... and one of these
  /// An input that replaces a standard, and that standard in words.
  std::string input = {}, standard = {};
  Closure closure = Closure::Any;       ///< the followers that it is made for
  std::vector<std::string> after = {};  ///< checks that must hold for this one to mean something
  /// The check is made where a parameter is stated and above 0, or only where another one is not.
  /// The two may have one name: a design has one of them.
  std::string only_with = {}, only_without = {};
  std::vector<std::pair<std::size_t, double>> in_case = {};  ///< parameters that its load case sets
};

/// Of a machine whose motion does not return: an index drive.
struct AdvancingCycle {
  double advance = 1;  ///< how far a cycle gets, in strokes, where a program does not say
  /// The parameters that decide whether the machine meets the next cycle as it met this one. They
  /// do not vary in a search.
  std::vector<std::string> by = {};
  /// Of all parameters, in their listed units, and the advance: why it does not, in words; empty
  /// where it does.
  std::function<std::string(std::span<const double>, double)> why_open = {};
};

struct Mechanism;

/// One of the cams on a shaft. Of the shaft's mechanism it has everything with its name and a dot
/// before its own names, but for the speed, which is the shaft's.
struct ShaftCam {
  std::string name;
  std::shared_ptr<const Mechanism> mechanism;
  std::vector<std::size_t> parameters;  ///< of the shaft, for each of its own
  std::size_t phase;  ///< of the shaft's parameters: where on the shaft its own zero stands, deg
};

struct Mechanism {
  std::string name, title, source;
  std::vector<MechanismParameter> parameters;
  std::vector<MechanismResponse> responses;
  std::vector<NamedPeak> peaks;
  MovedBy moved_by = MovedBy::Law;
  std::shared_ptr<const Cycle> cycle = {};      ///< of the curves of a machine that a file states
  std::optional<AdvancingCycle> advances = {};  ///< none: its motion returns, or it does not matter
  bool keeps_times = false;  ///< times of its program stay at another speed, and its angles change
  std::vector<ValidityLimit> validity = {};
  Form form = Form::Other;
  std::vector<BuildableCheck> checks = {};  ///< of whether it can be made and run
  std::vector<BuildableInput> inputs = {};  ///< of these checks
  /// The condition that a machine of these values, in their listed units, does not meet, in the
  /// names of its parameters; empty where it meets all. None of a machine that names no conditions.
  std::function<std::string(std::span<const double>)> why_impossible = {};
  std::shared_ptr<const UsualProblem> usual =
      {};                           ///< what is usually asked of it (usual_problem.h)
  std::vector<ShaftCam> cams = {};  ///< of several on one shaft (machines/model/shaft.h)

  /// Index by name or symbol; throws std::invalid_argument with near and known names.
  std::size_t parameter(std::string_view parameter_name) const;
};

/// "peak torque": a part of a curve as it is asked for.
std::string part_name(optim::Part part, const std::string& curve);

/// Throws std::invalid_argument with near and known names, and where a part is asked of a number.
ResponseName find_response(const Mechanism& mechanism, std::string_view name);

/// The binding as a response sees it: nothing varies that it does not depend on, and of several
/// laws side by side it has that of the response's cam.
Binding narrowed(const Binding& binding, const MechanismResponse& response);

/// Makes, when it is called, the margins that decide whether there is a machine, as functions of
/// the design; none where nothing that varies decides and there is a machine of the constants.
std::function<std::vector<optim::Function>()> margins_that_decide(const Mechanism& mechanism,
                                                                  const Binding& binding);

/// The shape of a response in what varies of a binding: the strongest that the mechanism declares,
/// and what machines/model/shape_rules.h finds. Neither where what varies decides which machines
/// are possible and these are not known to be a convex set.
struct KnownShape {
  optim::Shape declared = optim::Shape::General, ruled = optim::Shape::General;
  bool by_enclosure = false;  ///< how the second was found; else by rules
  std::string proof = {};     ///< of the first: "DS6"
  bool of_possible = false;   ///< what varies decides on which machines are possible
  /// The stronger one, the declared one where they are as strong.
  optim::Shape best() const;
  /// How the best one is known: "rules", "enclosure", "theory.md (DS6)", and behind it ", possible
  /// machines by rules" where these matter; empty where none is.
  std::string reason() const;
};
KnownShape known_shape(const Mechanism& mechanism, const ResponseName& name,
                       const Binding& binding);

/// The response over a binding's design variables, of the best known shape. A curve is given whole,
/// whatever the part.
optim::Response make_response(const Mechanism& mechanism, const ResponseName& name,
                              const Binding& binding);

}  // namespace camlaw::problems
