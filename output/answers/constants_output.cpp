// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/fit_output.h"
#include "output/document/text_table.h"

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
               n.identifiable ? "yes" : "no: others make up for it"});
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

/// Between explanations that take as many digits the print does not decide: those beside the first.
std::vector<std::string> as_good(const std::vector<ConstantsFit>& fits) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < fits.size(); ++i) {
    const bool equal =
        fits[i].cost == fits.front().cost && fits[i].consistent == fits.front().consistent;
    if (equal) names.push_back(fits[i].law.label());
  }
  return names;
}

double digits_of_print(const ConstantsFit& fit) {
  double sum = 0;
  for (const AgreeingConstant& c : fit.constants) sum += problems::cost_of(c.printed);
  return sum;
}

std::vector<std::string> names_of(const std::vector<Member>& laws) {
  std::vector<std::string> names;
  for (const Member& law : laws) names.push_back(law.name());
  return names;
}

/// "B does", "B and C do".
std::string that_do(const std::vector<std::string>& names) {
  return fmt::format("{} {}", fmt::join(names, ", "), names.size() == 1 ? "does" : "do");
}

/// What the tables do not say by themselves, a line each.
std::string verdict(const std::vector<ConstantsFit>& fits) {
  const ConstantsFit& best = fits.front();
  std::string text;
  const auto line = [&text](std::string words) { text += std::move(words) + "\n"; };
  const auto off = disagreeing(best);
  if (off.empty()) {
    line("every constant agrees in all digits that are printed");
  } else if (off.size() == best.constants.size()) {
    line("no constant agrees");
  } else {
    line(fmt::format("{} not agree with the rest: no values of this law print all of them",
                     that_do(off)));
  }
  std::vector<std::string> loose;
  for (const FoundNumber& n : best.numbers) {
    if (!n.identifiable) loose.push_back(n.name);
  }
  if (!loose.empty()) {
    line(fmt::format("the print does not determine {}: the value shown is one of many",
                     fmt::join(loose, ", ")));
  }
  if (!best.also.empty()) {
    line(fmt::format("the same motion: {}", fmt::join(names_of(best.also), "; ")));
  }
  if (const auto equal = as_good(fits); !equal.empty()) {
    line(fmt::format("{} explain{} it as shortly: more constants or digits would tell",
                     fmt::join(equal, "; "), equal.size() == 1 ? "s" : ""));
  }
  if (off.size() < best.constants.size() && best.cost >= digits_of_print(best)) {
    line("that takes as many digits as the print has: it does not tell which law it is");
  }
  return text;
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
  text += verdict(fits);
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
         fmt::format("\nexplanations by the digits that they take; the print itself takes {:.0f}\n",
                     digits_of_print(best)) +
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
                       {"disagrees", disagreeing(fit)},
                       {"same_motion", names_of(fit.also)}});
  }
  return {{"law", best.law.name()},
          {"parameters", numbers_json(best)},
          {"constants", std::move(constants)},
          {"rms", to_json(std::sqrt(sum / static_cast<double>(best.constants.size())))},
          {"max_residual", to_json(largest)},
          {"residual_unit", "half a unit of the last printed digit"},
          {"criterion", best.cost},
          {"criterion_name", "digits"},
          {"criterion_of_print", digits_of_print(best)},
          {"same_motion", names_of(best.also)},
          {"consistent", best.consistent},
          {"identifiable", best.identifiable},
          {"ranking", std::move(ranking)}};
}

}  // namespace camlaw::cli
