// SPDX-License-Identifier: MIT
#include "kinematics/laws/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>

#include "kinematics/laws/families.h"
#include "kinematics/laws/law_names.h"
#include "numerics/text/names.h"

namespace camlaw {
namespace {

/// Blanks, underscores and hyphens part words alike.
std::string spelling(std::string_view name) {
  std::string result = folded(name);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c == ' ' || c == '_'; }, '-');
  return result;
}

bool is_named(const Family& family, const std::string& wanted) {
  if (spelling(family.name) == wanted) return true;
  return std::any_of(family.aliases.begin(), family.aliases.end(),
                     [&](const std::string& alias) { return spelling(alias) == wanted; });
}

const Family* find_exact(std::string_view name) {
  const std::string wanted = spelling(name);
  for (const Family& family : catalogue()) {
    if (is_named(family, wanted)) return &family;
  }
  return nullptr;
}

}  // namespace

const std::vector<Family>& catalogue() {
  static const std::vector<Family> families = [] {
    std::vector<Family> all;
    for (auto* group : {polynomial_families, harmonic_families, phase_families, curved_families,
                        spline_families}) {
      for (Family& family : group()) all.push_back(std::move(family));
    }
    return all;
  }();
  return families;
}

Arguments<double> Family::defaults() const {
  std::vector<std::vector<double>> values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.default_value);
  return Arguments<double>(std::move(values));
}

std::size_t Family::parameter(std::string_view parameter_name) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    const bool is_older = !p.also.empty() && folded(p.also) == folded(parameter_name);
    if (is_older || folded(p.name) == folded(parameter_name)) return i;
    known.push_back(parameters[i].name);
  }
  throw std::invalid_argument(
      fmt::format("law '{}' has no parameter '{}'; it accepts {}", name, parameter_name,
                  known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

std::optional<Impossible> Family::bad_arguments(const Arguments<double>& arguments) const {
  if (arguments.size() != parameters.size()) {
    return Impossible{fmt::format("law '{}' takes {} parameters, but {} are given", name,
                                  parameters.size(), arguments.size())};
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    const auto& values = arguments.list(i);
    if (!p.list && values.size() != 1) {
      return Impossible{fmt::format("law '{}': parameter {} takes one value, but {} are given",
                                    name, p.name, values.size())};
    }
    for (const double value : values) {
      if (!(value >= p.low && value <= p.high)) {
        return Impossible{fmt::format("law '{}': parameter {} = {:.6g} is outside {:.6g} .. {:.6g}",
                                      name, p.name, value, p.low, p.high)};
      }
      if (p.structural && !p.list && value != std::floor(value)) {
        return Impossible{
            fmt::format("law '{}': parameter {} = {:.6g} must be an integer", name, p.name, value)};
      }
    }
  }
  return {};
}

Impossible Family::of_this(const Impossible& reason) const {
  return {fmt::format("law '{}': {}", name, reason.why)};
}

namespace {

/// A member's name, its values printed by `print`.
template <class Print>
std::string member_name(const Member& member, Print print) {
  std::string result = member.family->name;
  for (std::size_t i = 0; i < member.family->parameters.size(); ++i) {
    const Parameter& parameter = member.family->parameters[i];
    const auto& values = member.arguments.list(i);
    const bool untold = values.empty() || parameter.name == kCrossover;
    if (untold && values == parameter.default_value) continue;
    result += fmt::format(" {}={}", parameter.name, print(values));
  }
  return result;
}

}  // namespace

std::string Member::name() const {
  return member_name(*this,
                     [](const auto& values) { return fmt::format("{}", fmt::join(values, ",")); });
}

std::string Member::label() const {
  constexpr std::size_t kShown = 6;
  return member_name(*this, [](const std::vector<double>& values) {
    if (values.size() <= kShown) return fmt::format("{:.6g}", fmt::join(values, ","));
    return fmt::format("{:.6g},... ({} values)", fmt::join(values.begin(), values.begin() + 3, ","),
                       values.size());
  });
}

Member Member::listed() const { return family->listed ? family->listed(arguments) : *this; }

const Family& find_family(std::string_view name) {
  if (const Family* family = find_exact(name)) return *family;
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> near;
  std::set<const Family*> named;  // each by the likest of its names
  while (near.size() < kNamed) {
    std::vector<std::string> known;
    for (const Family& family : catalogue()) {
      if (named.contains(&family)) continue;
      known.push_back(family.name);
      known.insert(known.end(), family.aliases.begin(), family.aliases.end());
    }
    const std::vector<std::string> likest = near_names(name, known);
    if (likest.empty()) break;
    const Family* const family = find_exact(likest.front());
    named.insert(family);
    near.push_back(likest.front() == family->name
                       ? family->name
                       : fmt::format("{} ({})", likest.front(), family->name));
  }
  throw std::invalid_argument(fmt::format("there is no law '{}'; {}'camlaw laws' lists all", name,
                                          near.empty() ? "" : did_you_mean(near) + " "));
}

double read_plain_number(std::string_view text, const Parameter&, const std::string& what) {
  double value = 0;
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw std::invalid_argument(fmt::format("{}: '{}' is not a number", what, text));
  }
  return value;
}

void set_argument(Member& member, std::string_view assignment, ValueReader reader) {
  const Family& family = *member.family;
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw std::invalid_argument(
        fmt::format("law '{}': '{}' sets nothing; write name=value", family.name, assignment));
  }
  const std::size_t index = family.parameter(trimmed(assignment.substr(0, equals)));
  const Parameter& parameter = family.parameters[index];
  const std::string what = fmt::format("law '{}': parameter {}", family.name, parameter.name);
  std::string_view rest = trimmed(assignment.substr(equals + 1));
  std::vector<double> values;
  while (!(parameter.list && rest.empty())) {
    const std::size_t comma = rest.find(',');
    values.push_back(reader(trimmed(rest.substr(0, comma)), parameter, what));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  member.arguments.values()[index] = std::move(values);
}

namespace {

/// Whether a text begins with "name =": the value before it is empty.
bool begins_assignment(std::string_view text) {
  const std::size_t end = text.find_first_of(" ,=");
  const std::size_t next = text.find_first_not_of(' ', end);
  return end != 0 && next != std::string_view::npos && text[next] == '=';
}

/// Without the spaces that do not part words: those beside an equals sign, except before another
/// assignment, and those after a comma.
std::string without_loose_spaces(std::string_view text) {
  std::string joined;
  while (!text.empty()) {
    const char c = text.front();
    while (c == '=' && !joined.empty() && joined.back() == ' ') joined.pop_back();
    const char last = joined.empty() ? ' ' : joined.back();
    const bool loose =
        c == ' ' && (last == ',' || (last == '=' && !begins_assignment(trimmed(text))));
    if (!loose) joined += c;
    text.remove_prefix(1);
  }
  return joined;
}

/// Where the first assignment behind a place starts: at the last space before its equals sign. The
/// text's end where there is none; npos where no space comes before.
std::size_t assignment_start(std::string_view text, std::size_t from) {
  const std::size_t equals = text.find('=', from);
  return equals == std::string_view::npos ? text.size() : text.rfind(' ', equals);
}

}  // namespace

bool names_catalogue_law(std::string_view given) {
  const std::string joined = without_loose_spaces(trimmed(given));
  const std::string_view text = joined;
  return find_exact(text) != nullptr ||
         find_exact(trimmed(text.substr(0, text.find(' ')))) != nullptr ||
         find_exact(trimmed(text.substr(0, assignment_start(text, 0)))) != nullptr;
}

Member find_law(std::string_view given, ValueReader reader) {
  const std::string joined = without_loose_spaces(trimmed(given));
  const std::string_view text = joined;
  // A whole text may be a name itself ("polynomial-5 alpha=-3" is one); else words "k=v" follow.
  if (const Family* family = find_exact(text)) return {family, family->defaults()};
  std::size_t start = assignment_start(text, 0);
  if (start == std::string_view::npos) {
    throw std::invalid_argument(fmt::format("'{}' names no law: write NAME k=v ...", text));
  }
  const Family& family = find_family(trimmed(text.substr(0, start)));
  Member member{&family, family.defaults()};
  std::set<std::string> seen;
  while (start < text.size()) {
    const std::size_t next = assignment_start(text, text.find('=', start) + 1);
    const std::string_view name = trimmed(text.substr(start, text.find('=', start) - start));
    if (!seen.insert(folded(name)).second) {
      throw std::invalid_argument(
          fmt::format("law '{}': parameter {} is given twice", family.name, name));
    }
    set_argument(member, trimmed(text.substr(start, next - start)), reader);
    start = next;
  }
  return member;
}

}  // namespace camlaw
