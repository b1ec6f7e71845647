// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace camlaw {
namespace {

using Kind = FormulaTree::Kind;

/// How firmly a text holds together, as in "a + b" below "a b" below "-a" below "a^2" below "a".
enum Tightness { kLoosest, kJoined, kSigned, kRaised, kAlone };

struct Set {
  std::string text;
  Tightness tightness;
};

constexpr std::string_view kGreek[] = {
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu",
    "nu",    "xi",   "rho",   "sigma", "tau",     "phi",  "chi", "psi",   "omega", "pi"};
/// Functions that LaTeX has a word for.
constexpr std::pair<std::string_view, std::string_view> kFunctions[] = {
    {"sin", "\\sin"},     {"cos", "\\cos"},     {"tan", "\\tan"}, {"asin", "\\arcsin"},
    {"acos", "\\arccos"}, {"atan", "\\arctan"}, {"exp", "\\exp"}, {"log", "\\ln"},
    {"ln", "\\ln"},       {"min", "\\min"},     {"max", "\\max"}};

std::string in_parentheses(const std::string& text) { return "\\left(" + text + "\\right)"; }

class Setter {
 public:
  explicit Setter(const LatexOfName& latex_of_name) : latex_of_name_(latex_of_name) {}

  Set set(const FormulaTree& tree) const {
    const auto& parts = tree.parts;
    switch (tree.kind) {
      case Kind::Number:
        return number(tree);
      case Kind::Name:
        return {latex_of_name_(tree.full_name()), kAlone};
      case Kind::Function:
        return function(tree);
      case Kind::Negate:
        return {"-" + inside(parts[0], kSigned), kSigned};
      case Kind::Add:
        return {inside(parts[0], kLoosest) + " + " + factor(parts[1]), kLoosest};
      case Kind::Subtract:
        return {inside(parts[0], kLoosest) + " - " + factor(parts[1]), kLoosest};
      case Kind::Multiply:
        return product(inside(parts[0], kJoined), factor(parts[1]));
      case Kind::Divide:
        return {fmt::format("\\frac{{{}}}{{{}}}", set(parts[0]).text, set(parts[1]).text), kRaised};
      case Kind::Power:
        return {fmt::format("{}^{{{}}}", inside(parts[0], kAlone), set(parts[1]).text), kRaised};
    }
    return {};
  }

 private:
  std::string inside(const FormulaTree& tree, Tightness least) const {
    const Set part = set(tree);
    return part.tightness < least ? in_parentheses(part.text) : part.text;
  }

  /// To the right of a product another product goes on, but not a sign.
  std::string factor(const FormulaTree& tree) const {
    const Set part = set(tree);
    const bool apart = part.tightness < kJoined || part.tightness == kSigned;
    return apart ? in_parentheses(part.text) : part.text;
  }

  static Set number(const FormulaTree& tree) {
    std::string text = fmt::format("{}", tree.number);
    if (const std::size_t e = text.find('e'); e != std::string::npos) {
      text = fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1)));
    }
    if (tree.text.empty()) return {text, text.find(' ') == std::string::npos ? kAlone : kJoined};
    return {fmt::format("{}\\,\\mathrm{{{}}}", text, tree.text), kJoined};
  }

  /// A dot stands where two numbers would run together.
  static Set product(const std::string& left, const std::string& right) {
    const bool digits = std::isdigit(static_cast<unsigned char>(right.front())) != 0;
    return {left + (digits ? " \\cdot " : "\\,") + right, kJoined};
  }

  std::string list(const FormulaTree& tree) const {
    std::string text;
    for (const FormulaTree& part : tree.parts) text += (text.empty() ? "" : ", ") + set(part).text;
    return text;
  }

  Set function(const FormulaTree& tree) const {
    const std::string& name = tree.text;
    const auto part = [&](std::size_t i) { return set(tree.parts[i]).text; };
    if (name == "sqrt") return {fmt::format("\\sqrt{{{}}}", part(0)), kAlone};
    if (name == "abs") return {fmt::format("\\left|{}\\right|", part(0)), kAlone};
    if (name == "where_positive") {
      return {fmt::format("\\left[{}\\right]_{{{} > 0}}", part(1), part(0)), kAlone};
    }
    if (name == "select") {
      return {fmt::format("\\begin{{cases}} {1} & {0} \\ge 0 \\\\ {2} & {0} < 0 \\end{{cases}}",
                          part(0), part(1), part(2)),
              kLoosest};
    }
    const auto* const known = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                           [&](const auto& f) { return f.first == name; });
    const std::string word = known != std::end(kFunctions)
                                 ? std::string(known->second)
                                 : fmt::format("\\operatorname{{{}}}", latex_text(name));
    return {word + in_parentheses(list(tree)), kAlone};
  }

  static std::string latex_text(std::string_view name) {
    std::string text;
    for (const char c : name) text += c == '_' ? std::string("\\_") : std::string(1, c);
    return text;
  }

  const LatexOfName& latex_of_name_;
};

/// A part of a symbol: a Greek letter, one letter, or a word set upright.
std::string letter(const std::string& part) {
  if (std::find(std::begin(kGreek), std::end(kGreek), part) != std::end(kGreek)) return "\\" + part;
  const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
  return part.size() > 1 && !is_number ? fmt::format("\\mathrm{{{}}}", part) : part;
}

}  // namespace

std::string latex_of(const FormulaTree& tree, const LatexOfName& latex_of_name) {
  return Setter(latex_of_name).set(tree).text;
}

std::string latex_symbol(const std::string& symbol) {
  std::string base = symbol.substr(0, symbol.find('_')), below;
  if (base.size() < symbol.size()) below = symbol.substr(base.size() + 1);
  while (below.empty() && base.size() > 1 &&
         std::isdigit(static_cast<unsigned char>(base.back()))) {
    const std::size_t digits = base.find_first_of("0123456789");
    below = base.substr(digits);
    base.resize(digits);
  }
  std::string index;
  for (std::size_t begin = 0; begin < below.size();) {
    const std::size_t end = std::min(below.find('_', begin), below.size());
    index += (index.empty() ? "" : ",") + letter(below.substr(begin, end - begin));
    begin = end + 1;
  }
  return index.empty() ? letter(base) : fmt::format("{}_{{{}}}", letter(base), index);
}

}  // namespace camlaw
