// SPDX-License-Identifier: MIT
#include "problems/sweeps/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "numerics/sampling/sobol_points.h"
#include "numerics/text/dimension.h"
#include "numerics/text/names.h"
#include "numerics/text/quotes.h"
#include "numerics/text/unit_spelling.h"
#include "numerics/text/units.h"
#include "problems/statement/assignment.h"
#include "problems/statement/law_names.h"
#include "problems/statement/restated.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::problems {
namespace {

constexpr std::string_view kSweepExample = "speed=60:15:120 rpm";

std::vector<std::string> texts(std::string_view text, char mark) {
  const auto parts = parted(text, mark);
  return {parts.begin(), parts.end()};
}

struct Quantity {
  double number;
  std::string unit;
};

/// A number and what stands behind it; none where no number begins the text.
std::optional<Quantity> quantity(std::string_view text) {
  double number = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return Quantity{number, std::string(trimmed(text))};
}

/// Whether what stands behind a number is a unit, or nothing. "-2RS" of a bearing's name is none.
bool is_unit_or_nothing(const std::string& text) {
  if (text.empty() || ambiguous(text) || counts_turns(spelled_out(text))) return true;
  try {
    written_unit(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// The numbers of texts whose unit the last one says for all; none where they are no such numbers.
std::optional<std::vector<Quantity>> in_one_unit(const std::vector<std::string>& texts) {
  std::vector<Quantity> all;
  for (const std::string& text : texts) {
    const auto one = quantity(text);
    if (!one) return {};
    all.push_back(*one);
  }
  const std::string unit = all.back().unit;
  if (!is_unit_or_nothing(unit)) return {};
  for (Quantity& one : all) {
    if (one.unit.empty()) one.unit = unit;
    if (one.unit != unit) return {};
  }
  return all;
}

/// As many digits as people write: 0.1 + 0.2 is 0.3.
double rounded(double number, int digits) {
  double result = number;
  const std::string text = fmt::format("{:.{}g}", number, digits);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

SweepAxis stepped(const std::string& name, const std::string& text) {
  const auto parts = in_one_unit(texts(text, ':'));
  if (!parts || parts->size() != 3) {
    throw std::invalid_argument(fmt::format(
        "{}: '{}' is not a range; write from:step:to with one unit, such as 60:15:120 rpm", name,
        text));
  }
  constexpr double kRounding = 1e-9;  // of a step: 0:0.1:0.3 has four values
  constexpr int kDigits = 12;  // significant: 0.1 + 0.2 is 0.3, and what a user writes has fewer
  const double from = (*parts)[0].number, step = (*parts)[1].number, to = (*parts)[2].number;
  const double steps = (to - from) / step;
  if (!(steps >= 0) || !std::isfinite(steps)) {
    throw std::invalid_argument(
        fmt::format("{}: a step of {:g} does not lead from {:g} to {:g}", name, step, from, to));
  }
  if (steps >= kMostSwept) {
    throw std::invalid_argument(fmt::format("{}: {:.0f} values; at most {} combinations are swept",
                                            name, steps + 1, kMostSwept));
  }
  SweepAxis axis{.name = name, .unit = parts->back().unit, .values = {}};
  const auto count = static_cast<std::size_t>(std::floor(steps + kRounding)) + 1;
  const auto whole = static_cast<double>(count - 1);
  if (steps - whole > kRounding) {
    const double last = rounded(from + whole * step, kDigits);
    throw std::invalid_argument(fmt::format(
        "{}: steps of {:g} from {:g} end at {:g} and do not meet {:g}; write {:g}:{:g}:{:g}, or a "
        "step that divides the range",
        name, step, from, last, to, from, step, last));
  }
  for (std::size_t i = 0; i < count; ++i) {
    axis.numbers.push_back(rounded(from + static_cast<double>(i) * step, kDigits));
    axis.values.push_back(swept_value(axis.numbers.back(), axis.unit));
  }
  return axis;
}

/// "100-300 rpm", "100..300": two numbers as people write a range, which is no value.
bool looks_like_range(std::string_view text) {
  const auto are_numbers = [](std::string_view first, std::string_view second) {
    const auto to = quantity(trimmed(second, " ."));
    return quantity(first) && to && is_unit_or_nothing(to->unit);
  };
  if (const std::size_t dots = text.find(".."); dots != std::string_view::npos) {
    return are_numbers(text.substr(0, dots), text.substr(dots));
  }
  const auto first = quantity(text);
  if (!first) return false;
  for (const std::string_view mark : {"-", "–", "to "}) {
    if (!first->unit.starts_with(mark)) continue;
    return are_numbers(text, std::string_view(first->unit).substr(mark.size()));
  }
  return false;
}

/// The laws of a list of names, classes among them.
SweepAxis laws_of(const std::string& name, const std::string& text) {
  SweepAxis axis{.name = name, .values = {}};
  for (const std::string& one : law_list(text)) {
    Entry entry;
    entry.kind = Entry::Kind::Text;
    entry.place = name;
    entry.path = name;
    entry.text = one;
    const auto all = read_law_class(entry);
    if (!all) {
      axis.values.push_back(one);
      continue;
    }
    axis.is_class = true;
    for (const Member& law : *all) axis.values.push_back(law.name());
  }
  return axis;
}

/// Numbers of which some have another unit than the last, each in its own: "10 mm, 2 cm".
std::optional<std::vector<Quantity>> in_units_of_the_last(const std::vector<std::string>& texts) {
  std::vector<Quantity> all;
  for (const std::string& text : texts) {
    const auto one = quantity(text);
    if (!one || one->unit.empty()) return {};
    all.push_back(*one);
  }
  const std::string unit = all.back().unit;
  if (!is_unit_or_nothing(unit)) return {};
  try {
    for (Quantity& one : all) {
      if (one.unit != unit) one.number = rounded(one.number * unit_as_written(one.unit, unit), 12);
      one.unit = unit;
    }
  } catch (const std::invalid_argument&) {
    return {};
  }
  return all;
}

SweepAxis listed(const std::string& name, const std::string& text) {
  SweepAxis axis{.name = name, .values = texts(text, ',')};
  auto numbers = in_one_unit(axis.values);
  if (!numbers) numbers = in_units_of_the_last(axis.values);
  if (!numbers) return axis;
  axis.unit = numbers->back().unit;
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    axis.numbers.push_back((*numbers)[i].number);
    const auto written = quantity(axis.values[i]);
    const bool is_said = written->unit == axis.unit && written->number == axis.numbers.back();
    if (!is_said) axis.values[i] = swept_value(axis.numbers.back(), axis.unit);
  }
  return axis;
}

/// The words of a list. In double quotes a word may hold commas, colons, doubled quotes and what
/// reads as a number.
std::vector<std::string> quoted_words(const std::string& name, std::string_view text) {
  std::vector<std::string> words;
  for (std::string_view rest = trimmed(text);; rest = trimmed(rest.substr(1))) {
    const bool is_quoted = rest.starts_with('"');
    const std::size_t end = is_quoted ? end_of_quoted(rest) : std::min(rest.find(','), rest.size());
    if (end == std::string_view::npos) {
      throw std::invalid_argument(fmt::format("{}: {} has no closing quote", name, rest));
    }
    words.push_back(without_quotes(trimmed(rest.substr(0, end))));
    rest = trimmed(rest.substr(end));
    if (rest.empty()) return words;
    if (!rest.starts_with(',')) {
      throw std::invalid_argument(
          fmt::format("{}: a comma must follow \"{}\"", name, words.back()));
    }
  }
}

void check_different(const SweepAxis& axis) {
  std::vector<std::string> sorted = axis.values;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return;
  throw std::invalid_argument(fmt::format("{}: '{}' is among the values twice", axis.name, *twice));
}

std::vector<std::vector<double>> sobol(const Sampling& sampling) {
  SobolPoints sequence(sampling.over.size(), std::nullopt);
  std::vector<std::vector<double>> parts(sampling.count, std::vector<double>(sampling.over.size()));
  for (auto& sample : parts) sequence.next(sample);
  return parts;
}

/// Each range is cut into `count` slices, which are shuffled (Fisher and Yates); a sample is in the
/// middle of its slice.
std::vector<std::vector<double>> latin_hypercube(const Sampling& sampling) {
  std::mt19937_64 engine(sampling.seed);
  const std::size_t n = sampling.count;
  std::vector<std::vector<double>> parts(n, std::vector<double>(sampling.over.size()));
  for (std::size_t k = 0; k < sampling.over.size(); ++k) {
    std::vector<std::size_t> slices(n);
    std::iota(slices.begin(), slices.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) std::swap(slices[i - 1], slices[engine() % i]);
    for (std::size_t i = 0; i < n; ++i) {
      parts[i][k] = (static_cast<double>(slices[i]) + 0.5) / static_cast<double>(n);
    }
  }
  return parts;
}

}  // namespace

std::string swept_value(double number, const std::string& unit) {
  return unit.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, unit);
}

std::string listed_value(const std::string& value) {
  const bool reads_as_more = value.find_first_of(",:\"") != std::string::npos ||
                             looks_like_range(value) || trimmed(value).size() != value.size();
  return reads_as_more ? in_quotes(value) : value;
}

std::optional<SweepAxis> parse_axis(const std::string& assignment) {
  const auto [written_name, written_text] = parse_assignment(assignment, kSweepExample);
  const std::string name(written_name), text(written_text);
  if (text.empty()) throw std::invalid_argument(fmt::format("{}: give a value", name));
  const bool is_law = is_law_setting(name), is_quoted = text.find('"') != std::string::npos;
  if (!is_law && !is_quoted && looks_like_range(text)) {
    throw std::invalid_argument(fmt::format(
        "{}: '{}' is not a value; write a range as from:step:to, such as {}=60:15:120, or list the "
        "values, {}=60,90,120; a name goes in quotes, {}=\"{}\"",
        name, text, name, name, name, text));
  }
  SweepAxis axis = is_law      ? laws_of(name, text)
                   : is_quoted ? SweepAxis{.name = name, .values = quoted_words(name, text)}
                   : text.find(':') != std::string::npos ? stepped(name, text)
                                                         : listed(name, text);
  check_different(axis);
  const bool is_single = axis.values.size() == 1 && !axis.is_class;
  return is_single ? std::nullopt : std::optional(std::move(axis));
}

SampledRange parse_sampled_range(const std::string& assignment) {
  const auto [written_name, written_text] = parse_assignment(assignment, kSweepExample);
  const std::string name(written_name), text(written_text);
  const auto parts = in_one_unit(texts(text, ':'));
  if (!parts || parts->size() != 2) {
    throw std::invalid_argument(
        fmt::format("--over: '{}' is not a range; write name=low:high with one unit, such as "
                    "base_radius=30:60 mm",
                    assignment));
  }
  const SampledRange range{name, parts->back().unit, parts->front().number, parts->back().number};
  if (!(range.low < range.high)) {
    throw std::invalid_argument(
        fmt::format("--over: {}: {:g} is not below {:g}", name, range.low, range.high));
  }
  return range;
}

Sampling parse_sampling(const std::string& text, std::uint64_t seed) {
  const std::string_view all = trimmed(text);
  const std::size_t space = all.find_first_of(" :");
  const std::string_view method = all.substr(0, space);
  if ((method != "sobol" && method != "lhs") || space == std::string_view::npos) {
    throw std::invalid_argument(fmt::format(
        "--sample: '{}' is not known; write sobol 64 or lhs 64, the method and how many "
        "samples",
        text));
  }
  Sampling sampling;
  sampling.method = method == "lhs" ? SampleMethod::LatinHypercube : SampleMethod::Sobol;
  sampling.seed = seed;
  sampling.count = static_cast<std::size_t>(
      parse_integer(trimmed(all.substr(space + 1)), 1, kMostSwept, "--sample"));
  return sampling;
}

std::string to_string(SampleMethod method) {
  return method == SampleMethod::Sobol ? "sobol" : "lhs";
}

std::vector<std::vector<double>> samples_of(const Sampling& sampling) {
  constexpr int kDigits = 8;  // significant: they tell 100 000 samples apart and can still be read
  if (sampling.over.empty()) return {};
  auto samples =
      sampling.method == SampleMethod::Sobol ? sobol(sampling) : latin_hypercube(sampling);
  for (auto& sample : samples) {
    for (std::size_t k = 0; k < sample.size(); ++k) {
      const SampledRange& range = sampling.over[k];
      const double value = range.low + sample[k] * (range.high - range.low);
      sample[k] = std::clamp(rounded(value, kDigits), range.low, range.high);
    }
  }
  return samples;
}

}  // namespace camlaw::problems
