// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/law.h"

/// The catalogue of motion laws by name. It is the one list: the program's listing, its JSON and
/// the table in docs/laws.md are printed from it.
namespace camlaw {

/// The parameter that every rest-to-rest family takes beside its own.
inline constexpr const char* kCrossover = "crossover";

/// A parameter of a law family.
struct Parameter {
  std::string name;
  std::string unit;                   ///< as udunits writes it; "1" for a plain number
  double low, high;                   ///< accepted range of each value, ends included
  std::vector<double> default_value;  ///< value(s) used where none is given
  std::string meaning;
  bool list = false;        ///< takes any number of values
  bool structural = false;  ///< shapes the law's data (a degree, an exponent): no derivatives by it
  bool linear = false;      ///< s is affine in all such parameters of the family together
  /// Of a list in which s is affine, where it is known: elements that lie so many places apart move
  /// no piece together. 0: nothing is known.
  std::size_t reach = 0;
  std::string also = {};  ///< an older name that is accepted
  /// The one value at which pieces of the law join that are two at any other.
  std::optional<double> joins_at = {};
  /// Not set by itself: it has the value of that parameter of the machine which the law moves.
  std::optional<std::size_t> given_by = {};

  bool is_called(std::string_view asked) const {
    return asked == name || (!also.empty() && asked == also);
  }
};

/// Values for a family's parameters, in the order of the family's list and in the units named
/// there.
template <class S>
class Arguments {
 public:
  explicit Arguments(std::vector<std::vector<S>> values) : values_(std::move(values)) {}

  const S& scalar(std::size_t i) const { return values_[i].front(); }
  const std::vector<S>& list(std::size_t i) const { return values_[i]; }
  std::vector<std::vector<S>>& values() { return values_; }
  const std::vector<std::vector<S>>& values() const { return values_; }
  std::size_t size() const { return values_.size(); }

  template <class R>
  Arguments<R> as() const {
    std::vector<std::vector<R>> result;
    for (const auto& list : values_) {
      result.emplace_back();
      for (const S& value : list) result.back().push_back(convert<R>(value));
    }
    return Arguments<R>(std::move(result));
  }

 private:
  std::vector<std::vector<S>> values_;
};

/// Something that a family's arguments make, in every scalar, from one generic callable
/// template <class S> Result<S> (const Arguments<S>&).
template <template <class> class Result>
class InEveryScalar {
 public:
  template <class F>
  InEveryScalar(F construct)  // NOLINT: a lambda is meant to become one
      : plain_([construct](const Arguments<double>& a) { return construct(a); }),
        dual_([construct](const Arguments<Dual>& a) { return construct(a); }),
        dual2_([construct](const Arguments<Dual2>& a) { return construct(a); }),
        interval_([construct](const Arguments<Interval>& a) { return construct(a); }) {}

  template <class S>
  Result<S> make(const Arguments<S>& arguments) const {
    static_assert(std::is_same_v<S, double> || std::is_same_v<S, Dual> ||
                      std::is_same_v<S, Dual2> || std::is_same_v<S, Interval>,
                  "the catalogue makes laws of double, Dual, Dual2 and Interval; other scalars go "
                  "through the templates in kinematics/laws");
    if constexpr (std::is_same_v<S, double>) return plain_(arguments);
    if constexpr (std::is_same_v<S, Dual>) return dual_(arguments);
    if constexpr (std::is_same_v<S, Dual2>) return dual2_(arguments);
    if constexpr (std::is_same_v<S, Interval>) return interval_(arguments);
  }

 private:
  std::function<Result<double>(const Arguments<double>&)> plain_;
  std::function<Result<Dual>(const Arguments<Dual>&)> dual_;
  std::function<Result<Dual2>(const Arguments<Dual2>&)> dual2_;
  std::function<Result<Interval>(const Arguments<Interval>&)> interval_;
};

template <class S>
using PossibleLaw = Possible<Law<S>>;

/// A family's construction: makes a Law, or a Possible<Law> where arguments within their ranges may
/// make none.
using Maker = InEveryScalar<PossibleLaw>;

template <class S>
using Itself = S;

/// What the parameters of a family must leave together, beyond the range of each: the part of the
/// law's length that phases leave to the last one, for instance. Values that leave less than
/// nothing make no law.
struct Room {
  std::string name;            ///< "1 - a - b - c"
  InEveryScalar<Itself> left;  ///< at least 0; a plain number
  bool linear = true;          ///< in the parameters together
  bool is_equal = false;       ///< 0, and neither more nor less
  /// Of one that is not linear in all together, a parameter that multiplies others: it is linear
  /// where this one does not vary, or varies alone.
  std::optional<std::size_t> factor = {};
};

struct Member;

/// A part of a law that has a name, as a segment of a motion program has.
struct NamedSpan {
  std::string name;
  double begin, end;                       ///< of the law's x
  std::shared_ptr<const Member> law = {};  ///< that it follows, as stated; none: a rest or a joint
};

/// One of several laws that a member stands for side by side (kinematics/laws/side_by_side.h).
struct LawPart {
  std::string name;
  std::shared_ptr<const Member> law;  ///< with the arguments that it began with
  std::size_t first;                  ///< of its parameters among those of all
};

/// A law of the catalogue: fixed, or a family with parameters.
struct Family {
  std::string name;
  std::vector<std::string> aliases;  ///< English, German, Ukrainian
  std::string formula;
  std::vector<Parameter> parameters;
  std::string ends;  ///< VDI 2143 pair, "R-R"; "by parameters" where they decide
  int continuity;    ///< class of the default member (shape.h): kSmooth where nothing known jumps
  bool symmetric;    ///< of the default member: s(x) + s(1 - x) = 1
  std::string source;
  Maker maker;
  /// Of a family that is not in the catalogue: the same law as a member of one that is, where there
  /// is such a member.
  std::function<Member(const Arguments<double>&)> listed = {};
  std::vector<Room> rooms = {};  ///< what the parameters must leave together
  /// Of a law that is made of parts with names: where these lie, in their order.
  std::function<std::vector<NamedSpan>(const Arguments<double>&)> spans = {};
  std::vector<LawPart> parts = {};  ///< of several laws side by side; none: it is one law
  /// Of a family of splines on stated knots: the member that moves as a law does. It is the same
  /// motion where the law is such a spline, on these knots or on some of them.
  std::function<Arguments<double>(const Law<double>&)> moving_as = {};

  Arguments<double> defaults() const;
  /// The member for these arguments. Impossible, with the names of law and parameter, for a value
  /// outside its range and a set that makes no law.
  template <class S>
  Possible<Law<S>> possible(const Arguments<S>& arguments) const {
    if (auto fault = bad_arguments(arguments.template as<double>())) return std::move(*fault);
    Possible<Law<S>> law = maker.make(arguments);
    if (!law) return of_this(law.reason());
    return law;
  }
  /// The same for one who asks for it: throws std::invalid_argument where it is impossible.
  template <class S>
  Law<S> make(const Arguments<S>& arguments) const {
    return possible(arguments).value();
  }
  /// Index of a parameter; throws std::invalid_argument listing the known ones.
  std::size_t parameter(std::string_view parameter_name) const;

 private:
  std::optional<Impossible> bad_arguments(const Arguments<double>& arguments) const;
  Impossible of_this(const Impossible& reason) const;  ///< with the law's name
};

/// Every law, in the order of the listing.
const std::vector<Family>& catalogue();

/// A family that a member belongs to: one of the catalogue, or one that is the member's own and
/// lives as long as it does.
class FamilyOf {
 public:
  FamilyOf(const Family* listed)  // NOLINT: an address of the catalogue is meant to become one
      : family_(std::shared_ptr<void>(), listed) {}
  FamilyOf(std::shared_ptr<const Family> own) : family_(std::move(own)) {}  // NOLINT
  const Family* operator->() const { return family_.get(); }
  const Family& operator*() const { return *family_; }
  friend bool operator==(const FamilyOf& a, const FamilyOf& b) { return a.family_ == b.family_; }

 private:
  std::shared_ptr<const Family> family_;
};

/// A law asked for by name, with its arguments: "modified-sine", "polynomial-5 alpha=-3",
/// "fourier a=0.1,-0.05". Aliases count as names; case does not matter.
struct Member {
  FamilyOf family;
  Arguments<double> arguments;

  /// Family name and arguments, as find_law reads them; a crossover left where it is goes without
  /// saying, and so does a list left empty.
  std::string name() const;
  /// The same for people: six digits, long lists cut short.
  std::string label() const;
  /// The same law as a member of the catalogue, where its family tells; else this one.
  Member listed() const;
  /// As Family::make and Family::possible.
  template <class S = double>
  Law<S> law() const {
    return family->make(arguments.as<S>());
  }
  template <class S = double>
  Possible<Law<S>> possible_law() const {
    return family->possible(arguments.as<S>());
  }
};

/// Reads one value of a parameter, in the parameter's unit; `what` names it in errors.
using ValueReader = double (*)(std::string_view text, const Parameter& parameter,
                               const std::string& what);
/// The reader for plain numbers. Throws std::invalid_argument for anything else.
double read_plain_number(std::string_view text, const Parameter& parameter,
                         const std::string& what);

/// Finds a family by name or alias; throws std::invalid_argument with the nearest known names.
const Family& find_family(std::string_view name);
/// Sets a parameter from "name=value", or "name=v1,v2,..." for a list; spaces do not matter.
void set_argument(Member& member, std::string_view assignment,
                  ValueReader reader = read_plain_number);
/// Reads "name k=v k=v".
Member find_law(std::string_view text, ValueReader reader = read_plain_number);

}  // namespace camlaw
