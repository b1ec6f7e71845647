// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "numerics/formula/unit_factor.h"
#include "numerics/text/names.h"

namespace camlaw {
namespace {

using Kind = FormulaTree::Kind;

thread_local std::vector<Expression>* conditions = nullptr;

/// Whether a formula has a value where its condition is 0.
enum class Edge : char { Closed, Open };

/// Notes that a formula has a value only where x is above 0 or, where the edge is closed, is 0.
void has_value_where(const Expression& x, Edge edge) {
  if (conditions == nullptr) return;
  const bool is_open = edge == Edge::Open;
  conditions->push_back(is_open ? by_side(-x, Expression(-1.0), Expression(1.0)) : x);
}
using Quantities = std::vector<WrittenQuantity>;

WrittenQuantity plain(const Expression& value) { return {value, {}}; }

/// Does what knows nothing of the formula's text; its errors get the place.
template <class Action>
auto at_place(const FormulaTree& tree, Action action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    refuse_formula(tree.at, error.what());
  }
}

/// Refuses to add or compare quantities of different kinds.
void check_alike(const FormulaTree& tree, const std::string& what, const WrittenQuantity& a,
                 const WrittenQuantity& b) {
  if (a.is_zero || b.is_zero || a.dimension == b.dimension) return;
  refuse_formula(tree.at, fmt::format("{} {} and {}, which are of different kinds", what,
                                      to_string(a.dimension), to_string(b.dimension)));
}

void check_plain(const FormulaTree& tree, const std::string& what, const WrittenQuantity& x) {
  if (x.dimension.is_plain()) return;
  refuse_formula(tree.at, fmt::format("{} is {}; it must be a plain number or an angle", what,
                                      to_string(x.dimension)));
}

/// Whether a formula consists of numbers without units alone, and of functions of them.
bool is_of_numbers(const FormulaTree& tree) {
  if (tree.kind == Kind::Name || (tree.kind == Kind::Number && !tree.text.empty())) return false;
  return std::all_of(tree.parts.begin(), tree.parts.end(), is_of_numbers);
}

/// The value of a formula of numbers alone; none of another one.
std::optional<double> constant_of(const FormulaTree& tree) {
  if (!is_of_numbers(tree)) return {};
  // It is recorded apart, without conditions on the formula that it is a part of.
  struct Apart {
    std::vector<Expression>* outer = std::exchange(conditions, nullptr);
    ~Apart() { conditions = outer; }
  } const apart;
  const Formula formula = Formula::record(0, [&](std::span<const Expression>) {
    return write_formula(tree, [](const FormulaTree&) { return WrittenQuantity{}; }).value;
  });
  return formula(std::span<const double>());
}

/// A number's unit. A name there that is not one may be a factor whose sign was forgotten.
WrittenUnit unit_of(const FormulaTree& tree) {
  try {
    return written_unit(tree.text);
  } catch (const std::invalid_argument& error) {
    if (tree.is_closed) throw;
    throw std::invalid_argument(
        fmt::format("{}; for a product write {:g} * {}", error.what(), tree.number, tree.text));
  }
}

WrittenQuantity written_number(const FormulaTree& tree) {
  // A decimal fraction such as 0.1 is the number that is written, not the double beside it.
  const double x = tree.number;
  const bool is_exact = x == std::floor(x) && std::abs(x) < 1e15;
  const double wide = is_exact ? 0 : std::numeric_limits<double>::epsilon() * std::abs(x);
  const Expression value(x, x - wide, x + wide);
  if (tree.text.empty()) return {value, {}, x == 0};
  return at_place(tree, [&]() -> WrittenQuantity {
    const WrittenUnit unit = unit_of(tree);
    const UnitFactor factor(unit.spelled, unit.si.unit);
    return {factor.as<Expression>() * value, unit.si.dimension};
  });
}

/// Refuses 9.81 m/s, where s is a second to one reader and the motion's displacement to the next.
void check_unit_ends(const FormulaTree& tree) {
  const FormulaTree* factor = &tree.parts[0];
  while ((factor->kind == Kind::Multiply || factor->kind == Kind::Divide) && !factor->is_closed) {
    factor = &factor->parts[1];
  }
  const FormulaTree& left = *factor;
  const FormulaTree* right = &tree.parts[1];
  std::string exponent;
  if (right->kind == Kind::Power) {
    if (const auto power = constant_of(right->parts[1])) exponent = fmt::format("^{:g}", *power);
    right = &right->parts[0];
  }
  if (left.kind != Kind::Number || left.text.empty() || left.is_closed) return;
  if (right->kind != Kind::Name || !right->part.empty()) return;
  try {
    written_unit(right->text);
  } catch (const std::invalid_argument&) {
    return;
  }
  const char sign = tree.kind == Kind::Divide ? '/' : '*';
  refuse_formula(left.at,
                 fmt::format("'{0:g} {1} {2} {3}{4}' can be read in two ways; write the unit as "
                             "{0:g} [{1}{2}{3}{4}], or ({0:g} {1}) {2} {3}{4}",
                             left.number, left.text, sign, right->text, exponent));
}

/// b^p of a p that may vary, exp(p log b). It has a value where b is above 0, and where b is 0 if p
/// is above 0: that value is 0, and where p is above 1 so are its slopes, which the logarithm has
/// not. Of the exponential of -p log 0, which is infinite, it is none.
Expression varying_power(const Expression& base, const Expression& exponent) {
  const Expression one(1.0), none(-1.0);
  has_value_where(by_side(-base, by_side(-exponent, none, base), one), Edge::Closed);
  const Expression value = exp(exponent * log(base));
  const Expression from_zero = by_side(one - exponent, value, unless_zero(base, value));
  const Expression above_zero = exp(exponent * log(where_positive(base, base)));
  return by_side(-exponent, above_zero, from_zero);
}

WrittenQuantity written_power(const FormulaTree& tree, const WrittenQuantity& base,
                              const FindQuantity& find) {
  if (const auto exponent = constant_of(tree.parts[1])) {
    constexpr double kLargest = 100;  // docs/formulas.md
    if (!(std::abs(*exponent) <= kLargest)) {
      refuse_formula(tree.parts[1].at, "an exponent lies within -100 and 100");
    }
    const bool is_root = *exponent != std::floor(*exponent);
    if (is_root) has_value_where(base.value, *exponent < 0 ? Edge::Open : Edge::Closed);
    if (*exponent == 0) return plain(Expression(1.0) + Expression(0.0) * base.value);
    const bool is_above_zero = is_root && *exponent < 0;  // not infinite at 0
    const Expression of = is_above_zero ? where_positive(base.value, base.value) : base.value;
    return {power(of, *exponent), power(base.dimension, *exponent)};
  }
  const WrittenQuantity exponent = write_formula(tree.parts[1], find);
  check_plain(tree.parts[1], "the exponent", exponent);
  if (!base.dimension.is_plain()) {
    refuse_formula(tree.at, fmt::format("{} has powers with a plain number as the exponent alone",
                                        to_string(base.dimension)));
  }
  return plain(varying_power(base.value, exponent.value));
}

Expression quarter_less(const Expression& angle) {
  return ScalarTraits<Expression>::pi() / Expression(2.0) - angle;
}

/// 2 atan(y / (sqrt(x^2 + y^2) + x)): within a half turn; it has no value where y is 0 and x is 0
/// or below.
/// By half the angle, of which no digits are lost: beside the negative x axis radius + x would.
Expression two_argument_arctangent(const Expression& y, const Expression& x) {
  const Expression radius = sqrt(power(x, 2) + power(y, 2));
  return Expression(2.0) * by_side(x, atan(y / (radius + x)), atan((radius - x) / y));
}

/// Functions of plain numbers that give one.
struct PlainFunction {
  const char* name;
  Expression (*of)(const Expression&);
};
constexpr PlainFunction kPlainFunctions[] = {
    {"sin", sin},
    {"cos", cos},
    {"tan", tan},
    {"asin", asin},
    {"acos", [](const Expression& x) { return quarter_less(asin(x)); }},
    {"atan", atan},
    {"exp", exp},
    {"log", log},
    {"ln", log},
    {"log10", [](const Expression& x) { return log(x) / log(Expression(10.0)); }}};

/// Functions of quantities of any kind.
constexpr const char* kOtherFunctions[] = {"sqrt",        "abs",   "sign",   "min",
                                           "max",         "atan2", "select", "where_positive",
                                           "unless_zero", "along", "root"};

void check_count(const FormulaTree& tree, std::size_t wanted) {
  const std::size_t given = tree.parts.size();
  if (given == wanted) return;
  refuse_formula(tree.at, fmt::format("{} takes {} argument{}; {} {} given", tree.text, wanted,
                                      wanted == 1 ? "" : "s, with commas between them", given,
                                      given == 1 ? "is" : "are"));
}

/// The least or the greatest of several.
WrittenQuantity extreme(const FormulaTree& tree, const Quantities& of) {
  if (of.size() < 2) {
    refuse_formula(tree.at, fmt::format("{} compares two arguments or more", tree.text));
  }
  WrittenQuantity result = of.front();
  for (std::size_t i = 1; i < of.size(); ++i) {
    check_alike(tree.parts[i], tree.text + " compares", result, of[i]);
    result.value = tree.text == "min" ? lesser_of(result.value, of[i].value)
                                      : greater_of(result.value, of[i].value);
    if (result.is_zero) result.dimension = of[i].dimension;
    result.is_zero = result.is_zero && of[i].is_zero;
  }
  return result;
}

bool is_decision(const std::string& name) {
  return name == "select" || name == "where_positive" || name == "unless_zero" || name == "along";
}

/// What the sign of the first argument decides; its size and unit do not matter.
WrittenQuantity decision(const FormulaTree& tree, const Quantities& of) {
  check_count(tree, tree.text == "select" ? 3 : 2);
  const Expression& by = of[0].value;
  const WrittenQuantity& x = of[1];
  if (tree.text == "select") {
    check_alike(tree, "select chooses between", x, of[2]);
    return {by_side(by, x.value, of[2].value), x.is_zero ? of[2].dimension : x.dimension,
            x.is_zero && of[2].is_zero};
  }
  if (tree.text == "where_positive") has_value_where(by, Edge::Open);
  const Expression value = tree.text == "where_positive" ? where_positive(by, x.value)
                           : tree.text == "unless_zero"  ? unless_zero(by, x.value)
                                                         : along(by, x.value);
  return {value, x.dimension, x.is_zero};
}

/// root(NAME, low, high, f) or root(NAME, low, high, f, level), with the name in f and level alone.
WrittenQuantity written_root(const FormulaTree& tree, const FindQuantity& find) {
  const std::size_t given = tree.parts.size();
  if (!tree.is_root() || given < 4 || given > 5) {
    refuse_formula(tree.at,
                   "root takes the name of the unknown, the two ends of its range, the expression "
                   "that is 0 there and, if that may happen at several places, an expression that "
                   "is highest at the right one");
  }
  const WrittenQuantity low = write_formula(tree.parts[1], find);
  const WrittenQuantity high = write_formula(tree.parts[2], find);
  check_alike(tree, "root looks between", low, high);
  const Dimension dimension = low.is_zero ? high.dimension : low.dimension;
  // Conditions inside the root would hold at the places that it tries alone.
  std::vector<Expression>* const outer = std::exchange(conditions, nullptr);
  const auto part = [&](std::size_t i) {
    return [&, i](const Expression& unknown) {
      if (i == given) return Expression(0.0);
      return write_formula(tree.parts[i],
                           [&](const FormulaTree& name) {
                             const bool is_unknown = name.full_name() == tree.parts[0].full_name();
                             return is_unknown ? WrittenQuantity{unknown, dimension} : find(name);
                           })
          .value;
    };
  };
  const Expression value = root_of(low.value, high.value, part(3), part(4));
  conditions = outer;
  return {value, dimension};
}

WrittenQuantity written_function(const FormulaTree& tree, const FindQuantity& find) {
  const std::string& name = tree.text;
  const auto known = formula_functions();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    at_place(tree, [&] { refuse_name("there is no function", name, known); });
  }
  if (name == "root") return written_root(tree, find);
  Quantities arguments;
  for (const FormulaTree& part : tree.parts) arguments.push_back(write_formula(part, find));
  if (name == "min" || name == "max") return extreme(tree, arguments);
  if (is_decision(name)) return decision(tree, arguments);
  check_count(tree, name == "atan2" ? 2 : 1);
  const WrittenQuantity& x = arguments[0];
  if (name == "sqrt") {
    has_value_where(x.value, Edge::Closed);
    return {sqrt(x.value), power(x.dimension, 0.5)};
  }
  if (name == "abs") return {absolute(x.value), x.dimension};
  if (name == "sign") return plain(along(x.value, Expression(1.0)));
  if (name == "atan2") {
    check_alike(tree, "atan2 compares", x, arguments[1]);
    return plain(two_argument_arctangent(x.value, arguments[1].value));
  }
  check_plain(tree.parts[0], fmt::format("the argument of {}", name), x);
  if (name == "asin" || name == "acos") {
    // An enclosure of 1 is a few units of the last place wider than 1: that much is no hole.
    constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
    has_value_where(Expression(1.0 + kRounding) - absolute(x.value), Edge::Closed);
  }
  if (name == "log" || name == "ln" || name == "log10") has_value_where(x.value, Edge::Open);
  const auto* const function = std::find_if(std::begin(kPlainFunctions), std::end(kPlainFunctions),
                                            [&](const PlainFunction& f) { return f.name == name; });
  return plain(function->of(x.value));
}

WrittenQuantity written_pair(const FormulaTree& tree, const WrittenQuantity& a,
                             const WrittenQuantity& b) {
  switch (tree.kind) {
    case Kind::Multiply:
      return {a.value * b.value, a.dimension * b.dimension, a.is_zero || b.is_zero};
    case Kind::Divide:
      return {a.value / b.value, a.dimension / b.dimension};
    default:
      break;
  }
  const bool adds = tree.kind == Kind::Add;
  check_alike(tree, adds ? "'+' adds" : "'-' subtracts", a, b);
  return {adds ? a.value + b.value : a.value - b.value, a.is_zero ? b.dimension : a.dimension,
          a.is_zero && b.is_zero};
}

}  // namespace

WrittenDomain::WrittenDomain() : before_(conditions) { conditions = &all_; }
WrittenDomain::~WrittenDomain() { conditions = before_; }

Expression WrittenDomain::least() const {
  Expression result(1.0);
  for (const Expression& condition : all_) result = lesser_of(result, condition);
  return result;
}

std::vector<std::string> formula_functions() {
  std::vector<std::string> names;
  for (const PlainFunction& f : kPlainFunctions) names.emplace_back(f.name);
  names.insert(names.end(), std::begin(kOtherFunctions), std::end(kOtherFunctions));
  return names;
}

WrittenQuantity write_formula(const FormulaTree& tree, const FindQuantity& find) {
  switch (tree.kind) {
    case Kind::Number:
      return written_number(tree);
    case Kind::Name:
      if (tree.full_name() == "pi") return plain(ScalarTraits<Expression>::pi());
      return find(tree);
    case Kind::Function:
      return written_function(tree, find);
    case Kind::Negate: {
      WrittenQuantity x = write_formula(tree.parts[0], find);
      x.value = -x.value;
      return x;
    }
    case Kind::Power:
      return written_power(tree, write_formula(tree.parts[0], find), find);
    default:
      break;
  }
  // Sums and products of many terms are deep on the left.
  std::vector<const FormulaTree*> pairs{&tree};
  const auto is_pair = [](const FormulaTree& part) {
    return part.kind == Kind::Add || part.kind == Kind::Subtract || part.kind == Kind::Multiply ||
           part.kind == Kind::Divide;
  };
  while (is_pair(pairs.back()->parts[0])) pairs.push_back(&pairs.back()->parts[0]);
  WrittenQuantity result = write_formula(pairs.back()->parts[0], find);
  for (; !pairs.empty(); pairs.pop_back()) {
    const FormulaTree& pair = *pairs.back();
    if (pair.kind == Kind::Multiply || pair.kind == Kind::Divide) check_unit_ends(pair);
    result = written_pair(pair, result, write_formula(pair.parts[1], find));
  }
  return result;
}

}  // namespace camlaw
