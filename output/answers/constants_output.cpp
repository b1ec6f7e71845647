// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/answer_formats.h"
#include "output/answers/fit_output.h"
#include "output/document/formatting.h"

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

/// The numbers of a fit; where there are none people do not read the table.
Table numbers_table(const ConstantsFit& fit) {
  Table table{.key = "parameters",
              .columns = {words("number", "name"), numbers("value", "value"),
                          numbers("from", "low"), numbers("to", "high"), words("unit", "unit"),
                          data("of"), words("determined", "identifiable")},
              .shown = fit.numbers.size()};
  for (const FoundNumber& n : fit.numbers) {
    table.add({n.name,
               {in_digits(n.value), n.value},
               {in_digits(n.low), n.low},
               {in_digits(n.high), n.high},
               {shown_unit(n.unit), n.unit},
               datum(n.of_law ? "law" : "machine"),
               {n.identifiable ? "yes" : "no: other values agree too", n.identifiable}});
  }
  return table;
}

Table prints_table(const ConstantsFit& fit) {
  Table table{
      .key = "constants",
      .columns = {words("constant", "name"), words("printed", "printed"), data("low"), data("high"),
                  numbers("computed", "value"), words("unit", "unit"), words("", "agrees")}};
  for (const AgreeingConstant& c : fit.constants) {
    const std::string& unit = c.printed.response.unit;
    table.add({c.printed.name,
               c.printed.text,
               datum(c.printed.low),
               datum(c.printed.high),
               {in_digits(c.value), c.value},
               {shown_unit(unit), unit},
               {c.agrees ? "agrees" : "does not agree", c.agrees}});
  }
  return table;
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

/// "C_v does", "C_v and C_a do".
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
    line(fmt::format("{} not agree with the rest: {}", that_do(off),
                     best.numbers.empty()
                         ? "this law does not print all of them"
                         : "no values of this law that print all of them were found"));
  }
  std::vector<std::string> loose;
  for (const FoundNumber& n : best.numbers) {
    if (!n.identifiable) loose.push_back(n.name);
  }
  if (!loose.empty()) {
    line(fmt::format(
        "the printed constants do not determine {}: the value shown is one of those that agree",
        fmt::join(loose, ", ")));
  }
  if (!best.also.empty()) {
    line(fmt::format("the same motion: {}", fmt::join(names_of(best.also), "; ")));
  }
  if (const auto equal = as_good(fits); !equal.empty()) {
    line(fmt::format("{} explain{} it with as few digits: more constants or digits would decide",
                     fmt::join(equal, "; "), equal.size() == 1 ? "s" : ""));
  }
  if (off.size() < best.constants.size() && best.cost >= digits_of_print(best)) {
    line("that takes as many digits as were printed, so it does not identify the law");
  }
  return text;
}

double misfit(const AgreeingConstant& c) {
  if (c.value == c.printed.value) return 0;
  return (c.value - c.printed.value) / ((c.printed.high - c.printed.low) / 2);
}

Table ranking_table(const std::vector<ConstantsFit>& fits) {
  Table table{.key = "ranking",
              .columns = {numbers("#"), words("law", "law"), numbers("digits", "criterion"),
                          data("consistent"), data("identifiable"), words("numbers", "parameters"),
                          words("does not agree", "disagrees"), data("same_motion")},
              .shown = fits.size() > 1 ? kRanked : 0};
  for (const ConstantsFit& fit : fits) {
    const std::vector<std::string> off = disagreeing(fit);
    table.add({fmt::format("{}", table.rows.size() + 1),
               {fit.law.family->name, fit.law.name()},
               {fmt::format("{:.0f}", fit.cost), fit.cost},
               datum(fit.consistent),
               datum(fit.identifiable),
               {numbers_text(fit), json_of(numbers_table(fit))},
               {fmt::format("{}", fmt::join(off, ", ")), off},
               datum(names_of(fit.also))});
  }
  return table;
}

/// How far the computed constants are from the printed ones, in half units of the last digit.
void add_misfits(const ConstantsFit& fit, Document& document) {
  double sum = 0, largest = 0;
  for (const AgreeingConstant& c : fit.constants) {
    const double off = misfit(c);
    sum += off * off;
    largest = std::max(largest, std::abs(off));
  }
  document.fact("rms", std::sqrt(sum / static_cast<double>(fit.constants.size())));
  document.fact("max_residual", largest);
  document.fact("residual_unit", "half a unit of the last printed digit");
}

}  // namespace

Document constants_document(const std::vector<ConstantsFit>& fits) {
  const ConstantsFit& best = fits.front();
  Document document;
  document.fact("format", kFitFormat.text());
  document.say(fmt::format("law {}\n", best.law.label()));
  document.fact("law", best.law.name());
  document.add(numbers_table(best));
  document.add(prints_table(best));
  add_misfits(best, document);
  document.fact("criterion", best.cost);
  document.fact("criterion_name", "digits");
  document.fact("criterion_of_print", digits_of_print(best));
  document.fact("same_motion", names_of(best.also));
  document.fact("consistent", best.consistent);
  document.fact("identifiable", best.identifiable);
  document.say(verdict(fits));
  if (fits.size() > 1) {
    document.say(fmt::format(
        "\nexplanations by the digits that they need; the printed constants have {:.0f}\n",
        digits_of_print(best)));
  }
  document.add(ranking_table(fits));
  return document;
}

}  // namespace camlaw::cli
