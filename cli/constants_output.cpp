// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/fit_output.h"
#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

using problems::AgreeingConstant;
using problems::ConstantsFit;
using problems::FoundNumber;

constexpr std::size_t kRanked = 12;

/// The numbers of a fit: "alpha = -3".
std::string numbers_text(const ConstantsFit& fit) {
  std::vector<std::string> parts;
  for (const FoundNumber& n : fit.numbers) {
    parts.push_back(fmt::format("{} = {}", n.name, with_unit(in_digits(n.value), n.unit)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> disagreeing(const ConstantsFit& fit) {
  std::vector<std::string> names;
  for (const AgreeingConstant& c : fit.constants) {
    if (!c.agrees) names.push_back(c.printed.name);
  }
  return names;
}

std::string found_text(const ConstantsFit& fit) {
  if (fit.numbers.empty()) return "";
  TextTable table({{"number", TextTable::Align::Left},
                   {"value"},
                   {"from"},
                   {"to"},
                   {"unit", TextTable::Align::Left},
                   {"determined", TextTable::Align::Left}});
  for (const FoundNumber& n : fit.numbers) {
    table.add({n.name, in_digits(n.value), in_digits(n.low), in_digits(n.high), shown_unit(n.unit),
               n.identifiable ? "yes" : "no: other values agree as well"});
  }
  return table.text();
}

std::string prints_text(const ConstantsFit& fit) {
  TextTable table({{"constant", TextTable::Align::Left},
                   {"printed", TextTable::Align::Left},
                   {"computed"},
                   {"unit", TextTable::Align::Left},
                   {"", TextTable::Align::Left}});
  for (const AgreeingConstant& c : fit.constants) {
    table.add({c.printed.name, c.printed.text, in_digits(c.value),
               shown_unit(c.printed.response.unit), c.agrees ? "agrees" : "does not agree"});
  }
  return table.text();
}

/// Between fits that cost as much the print does not decide.
std::size_t as_good(const std::vector<ConstantsFit>& fits) {
  return static_cast<std::size_t>(
      std::count_if(fits.begin(), fits.end(), [&](const ConstantsFit& fit) {
        return fit.cost == fits.front().cost && fit.consistent == fits.front().consistent;
      }));
}

double misfit(const AgreeingConstant& c) {
  if (c.value == c.printed.value) return 0;
  return (c.value - c.printed.value) / ((c.printed.high - c.printed.low) / 2);
}

Json numbers_json(const ConstantsFit& fit) {
  Json result = Json::array();
  for (const FoundNumber& n : fit.numbers) {
    result.push_back({{"name", n.name},
                      {"value", to_json(n.value)},
                      {"low", to_json(n.low)},
                      {"high", to_json(n.high)},
                      {"unit", n.unit},
                      {"of", n.of_law ? "law" : "machine"},
                      {"identifiable", n.identifiable}});
  }
  return result;
}

}  // namespace

std::string constants_text(const std::vector<ConstantsFit>& fits) {
  const ConstantsFit& best = fits.front();
  std::string text = fmt::format("law {}\n", best.law.label());
  text += found_text(best) + prints_text(best);
  if (const auto names = disagreeing(best); !names.empty()) {
    text += fmt::format("{} {} not agree with the rest: no values of this law print all of them\n",
                        fmt::join(names, ", "), names.size() == 1 ? "does" : "do");
  }
  if (!best.identifiable) text += "the prints do not determine every number\n";
  if (const std::size_t equal = as_good(fits); equal > 1) {
    text +=
        fmt::format("{} explanations are as good as this one: more digits would tell\n", equal - 1);
  }
  if (fits.size() == 1) return text;
  TextTable table({{"#"},
                   {"law", TextTable::Align::Left},
                   {"digits"},
                   {"numbers", TextTable::Align::Left},
                   {"does not agree", TextTable::Align::Left}});
  for (std::size_t i = 0; i < std::min(fits.size(), kRanked); ++i) {
    table.add({fmt::format("{}", i + 1), fits[i].law.family->name,
               fmt::format("{:.0f}", fits[i].cost), numbers_text(fits[i]),
               fmt::format("{}", fmt::join(disagreeing(fits[i]), ", "))});
  }
  return text +
         fmt::format("\nexplanations by the digits that they take, the best of {}\n", fits.size()) +
         table.text();
}

Json constants_json(const std::vector<ConstantsFit>& fits) {
  const ConstantsFit& best = fits.front();
  Json constants = Json::array(), ranking = Json::array();
  double sum = 0, largest = 0;
  for (const AgreeingConstant& c : best.constants) {
    const double off = misfit(c);
    sum += off * off;
    largest = std::max(largest, std::abs(off));
    constants.push_back({{"name", c.printed.name},
                         {"printed", c.printed.text},
                         {"low", to_json(c.printed.low)},
                         {"high", to_json(c.printed.high)},
                         {"unit", c.printed.response.unit},
                         {"value", to_json(c.value)},
                         {"agrees", c.agrees}});
  }
  for (const ConstantsFit& fit : fits) {
    ranking.push_back({{"law", fit.law.name()},
                       {"criterion", fit.cost},
                       {"consistent", fit.consistent},
                       {"identifiable", fit.identifiable},
                       {"parameters", numbers_json(fit)},
                       {"disagrees", disagreeing(fit)}});
  }
  return {{"law", best.law.name()},
          {"parameters", numbers_json(best)},
          {"constants", std::move(constants)},
          {"rms", to_json(std::sqrt(sum / static_cast<double>(best.constants.size())))},
          {"max_residual", to_json(largest)},
          {"residual_unit", "half a unit of the last printed digit"},
          {"criterion", best.cost},
          {"criterion_name", "digits"},
          {"consistent", best.consistent},
          {"identifiable", best.identifiable},
          {"ranking", std::move(ranking)}};
}

}  // namespace camlaw::cli
