// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "numerics/text/names.h"

namespace camlaw {
namespace {

using Kind = FormulaTree::Kind;

constexpr int kDeepest = 64;  // the reader calls itself for each level, for which the stack must do
constexpr std::size_t kMostParts = 2000;
constexpr std::array<std::string_view, 3> kPartWords{"peak", "highest", "lowest"};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
/// Letters of any script, and what units have beside them.
bool begins_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalpha(byte) != 0 || c == '_' || byte >= 0x80;
}

/// Reads from left to right; each function takes what it is named for.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  FormulaTree formula() {
    skip_blanks();
    if (at_ == text_.size()) refuse_formula(0, "the formula is empty");
    FormulaTree result = sum();
    if (at_ < text_.size()) refuse_formula(at_, unexpected());
    return result;
  }

 private:
  /// Counts how deep what is being read is nested.
  class Level {
   public:
    explicit Level(Reader& reader) : reader_(reader) {
      if (++reader.depth_ > kDeepest) {
        refuse_formula(reader.at_,
                       fmt::format("the formula is nested deeper than {} levels", kDeepest));
      }
    }
    ~Level() { --reader_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Reader& reader_;
  };

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool takes(char c) {
    if (next() != c) return false;
    ++at_;
    skip_blanks();
    return true;
  }

  std::string unexpected() const {
    if (at_ == text_.size()) return "the formula ends where a number, a name or '(' is expected";
    if (text_.substr(at_).starts_with("**")) return "'**' is not an operator; write ^ for a power";
    if (next() == ',') {
      return "a comma is only for the arguments of a function; decimals have a point";
    }
    if (next() == ')') return "')' closes nothing";
    if (next() == '=') return "a formula is only what is to the right of '='";
    if (begins_name(next()) || is_digit(next()) || next() == '(') {
      return fmt::format("an operator is missing before '{}'; write * for a product",
                         text_.substr(at_, name_length(at_)));
    }
    return fmt::format("'{}' is not part of a formula; use numbers, names, + - * / ^ and ( )",
                       text_.substr(at_, 1));
  }

  /// Of the name or number that begins there; at least 1.
  std::size_t name_length(std::size_t from) const {
    std::size_t length = 0;
    while (from + length < text_.size() &&
           (begins_name(text_[from + length]) || is_digit(text_[from + length]))) {
      ++length;
    }
    return std::max<std::size_t>(length, 1);
  }

  /// The same with what names of machines' parts have before them: press.displacement.
  std::size_t dotted_length(std::size_t from) const {
    std::size_t length = name_length(from);
    while (from + length + 1 < text_.size() && text_[from + length] == '.' &&
           begins_name(text_[from + length + 1])) {
      length += 1 + name_length(from + length + 1);
    }
    return length;
  }

  FormulaTree made(Kind kind, std::size_t at, std::vector<FormulaTree> parts = {}) {
    if (++count_ > kMostParts) {
      refuse_formula(at, fmt::format("the formula has more than {} parts", kMostParts));
    }
    FormulaTree tree;
    tree.kind = kind;
    tree.at = at;
    tree.parts = std::move(parts);
    return tree;
  }
  FormulaTree joined(Kind kind, std::size_t at, FormulaTree left, FormulaTree right) {
    std::vector<FormulaTree> parts;
    parts.push_back(std::move(left));
    parts.push_back(std::move(right));
    return made(kind, at, std::move(parts));
  }

  FormulaTree sum() {
    FormulaTree result = product();
    while (next() == '+' || next() == '-') {
      const std::size_t at = at_;
      const Kind kind = next() == '+' ? Kind::Add : Kind::Subtract;
      takes(next());
      result = joined(kind, at, std::move(result), product());
    }
    return result;
  }

  FormulaTree product() {
    FormulaTree result = signed_power();
    while ((next() == '*' && !text_.substr(at_).starts_with("**")) || next() == '/') {
      const std::size_t at = at_;
      const Kind kind = next() == '*' ? Kind::Multiply : Kind::Divide;
      takes(next());
      result = joined(kind, at, std::move(result), signed_power());
    }
    return result;
  }

  FormulaTree signed_power() {
    const std::size_t at = at_;
    if (next() != '+' && next() != '-') return power();
    const Level level(*this);
    if (takes('+')) return signed_power();
    takes('-');
    std::vector<FormulaTree> parts;
    parts.push_back(signed_power());
    return made(Kind::Negate, at, std::move(parts));
  }

  FormulaTree power() {
    FormulaTree base = primary();
    const std::size_t at = at_;
    if (!takes('^')) return base;
    const Level level(*this);
    return joined(Kind::Power, at, std::move(base), signed_power());
  }

  FormulaTree primary() {
    if (is_digit(next()) || next() == '.') return number();
    if (begins_name(next())) return name();
    if (next() != '(') refuse_formula(at_, unexpected());
    FormulaTree inside = in_parentheses();
    inside.is_closed = true;
    return inside;
  }

  FormulaTree in_parentheses() {
    const Level level(*this);
    const std::size_t at = at_;
    takes('(');
    FormulaTree inside = sum();
    if (!takes(')')) refuse_unclosed(at);
    return inside;
  }

  [[noreturn]] void refuse_unclosed(std::size_t open) const {
    if (at_ < text_.size()) refuse_formula(at_, unexpected());
    refuse_formula(open, "this '(' is not closed");
  }

  FormulaTree number() {
    FormulaTree result = made(Kind::Number, at_);
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), result.number);
    if (error != std::errc{}) refuse_formula(at_, "this number is out of range");
    at_ += static_cast<std::size_t>(end - begin);
    skip_blanks();
    const std::size_t at = at_;
    if (next() == '[') {
      const std::size_t close = text_.find(']', at);
      if (close == std::string_view::npos) refuse_formula(at, "this '[' is not closed");
      result.text = trimmed(text_.substr(at + 1, close - at - 1));
      if (result.text.empty()) refuse_formula(at, "there is no unit in these brackets");
      result.is_closed = true;
      at_ = close + 1;
    } else if (begins_name(next()) || next() == '%') {
      const std::size_t length = name_length(at_);
      result.text = text_.substr(at_, length);
      at_ += length;
      check_whole_unit(at, result.text);
    }
    skip_blanks();
    return result;
  }

  /// Refuses a unit that goes on behind its first name, since "9.81 m/s^2" may mean two things.
  void check_whole_unit(std::size_t at, const std::string& unit) {
    if (next() != '^') return;
    refuse_formula(at, fmt::format("write a unit with powers in brackets, such as [{}^2]", unit));
  }

  FormulaTree name() {
    FormulaTree result = made(Kind::Name, at_);
    const std::size_t length = dotted_length(at_);
    result.text = text_.substr(at_, length);
    at_ += length;
    skip_blanks();
    const bool is_word =
        std::find(kPartWords.begin(), kPartWords.end(), result.text) != kPartWords.end();
    if (is_word && begins_name(next())) {
      result.part = std::exchange(result.text, std::string(text_.substr(at_, dotted_length(at_))));
      at_ += result.text.size();
      skip_blanks();
    } else if (is_word && next() == '(') {
      const FormulaTree inside = in_parentheses();
      if (inside.kind != Kind::Name || !inside.part.empty()) {
        refuse_formula(inside.at,
                       fmt::format("'{}' comes before the name of a curve", result.text));
      }
      result.part = std::exchange(result.text, inside.text);
    } else if (next() == '(') {
      result.kind = Kind::Function;
      result.parts = arguments();
    }
    return result;
  }

  std::vector<FormulaTree> arguments() {
    const Level level(*this);
    const std::size_t open = at_;
    std::vector<FormulaTree> result;
    takes('(');
    if (takes(')')) return result;
    do {
      result.push_back(sum());
    } while (takes(','));
    if (!takes(')')) refuse_unclosed(open);
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0, count_ = 0;
  int depth_ = 0;
};

/// `unknown` has the names that roots give to what they look for.
void collect_names(const FormulaTree& tree, std::vector<std::string>& unknown,
                   std::vector<FormulaTree>& names) {
  if (tree.kind == Kind::Name) {
    const std::string name = tree.full_name();
    const bool is_known = std::find(unknown.begin(), unknown.end(), name) != unknown.end() ||
                          std::any_of(names.begin(), names.end(), [&](const FormulaTree& known) {
                            return known.full_name() == name;
                          });
    if (!is_known) names.push_back(tree);
  }
  const bool is_root = tree.is_root();
  for (std::size_t i = is_root ? 1 : 0; i < tree.parts.size(); ++i) {
    if (is_root && i == 3) unknown.push_back(tree.parts[0].full_name());
    collect_names(tree.parts[i], unknown, names);
  }
  if (is_root && tree.parts.size() > 3) unknown.pop_back();
}

}  // namespace

void refuse_formula(std::size_t at, const std::string& why) {
  throw std::invalid_argument(fmt::format("at character {}: {}", at + 1, why));
}

FormulaTree parse_formula(std::string_view text) { return Reader(text).formula(); }

std::vector<FormulaTree> names_in(const FormulaTree& tree) {
  std::vector<FormulaTree> names;
  std::vector<std::string> unknown;
  collect_names(tree, unknown, names);
  return names;
}

}  // namespace camlaw
