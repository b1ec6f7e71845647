// SPDX-License-Identifier: MIT
#include "output/answers/law_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <iterator>
#include <memory>

#include "kinematics/peaks.h"
#include "kinematics/shape.h"
#include "optim/problem/problem.h"
#include "output/document/formatting.h"
#include "output/figure/law_figure.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::cli {
namespace {

using optim::Part;

/// A peak of a law as people and programs call it.
struct LawPeak {
  const char *title, *key;
  Quantity quantity;
  Part part;
  int decimals;  ///< in the list of laws
};
constexpr std::array<LawPeak, 6> kLawPeaks{
    {{"C_v", "C_v", Quantity::Velocity, Part::Magnitude, 4},
     {"C_a+", "C_a_max", Quantity::Acceleration, Part::Highest, 4},
     {"C_a-", "C_a_min", Quantity::Acceleration, Part::Lowest, 4},
     {"C_j+", "C_j_max", Quantity::Jerk, Part::Highest, 3},
     {"C_j-", "C_j_min", Quantity::Jerk, Part::Lowest, 3},
     {"C_Mdyn", "C_Mdyn", Quantity::Moment, Part::Magnitude, 4}}};

template <class T>
Peak<T> peak_of(const Peaks<T>& all, const LawPeak& asked) {
  if (asked.part == Part::Magnitude) return all.absolute(asked.quantity);
  return asked.part == Part::Highest ? all.high(asked.quantity) : all.low(asked.quantity);
}

/// What `value` makes of each peak, by its key.
template <class Value>
Json by_peak(const Value& value) {
  Json object = Json::object();
  for (const LawPeak& peak : kLawPeaks) object[peak.key] = value(peak);
  return object;
}

Json law_parameters_json(const Member& member) {
  Json list = Json::array();
  for (std::size_t i = 0; i < member.family->parameters.size(); ++i) {
    const Parameter& p = member.family->parameters[i];
    const auto& values = member.arguments.list(i);
    list.push_back({{"name", p.name},
                    {"unit", p.unit},
                    {"low", to_json(p.low)},
                    {"high", to_json(p.high)},
                    {"default", p.list ? to_json(p.default_value) : to_json(p.default_value[0])},
                    {"value", p.list ? to_json(values) : to_json(values.front())},
                    {"list", p.list},
                    {"meaning", p.meaning}});
  }
  return list;
}

/// A family's own parameters in short, and on pages each on a line with its range.
std::vector<Cell> parameter_cells(const Member& member) {
  std::vector<std::string> names, ranges;
  for (const Parameter& p : member.family->parameters) {
    if (p.name == kCrossover) continue;
    names.push_back(p.list ? p.name + "..."
                           : fmt::format("{}={:.4g}", p.name, p.default_value.front()));
    ranges.push_back(fmt::format("`{}`{} {}: {}", p.name, p.list ? " (list)" : "",
                                 with_unit(fmt::format("{:g} .. {:g}", p.low, p.high), p.unit),
                                 p.meaning));
  }
  return {{fmt::format("{}", fmt::join(names, " ")), law_parameters_json(member)},
          fmt::format("{}", fmt::join(ranges, "\n"))};
}

std::vector<Cell> law_cells(const Member& member) {
  const Family& family = *member.family;
  const Law<double> law = member.law();
  const auto all = peaks(law);
  const auto lambda = limit_index(all);
  const int smooth = continuity(law);
  const std::vector<Cell> parameters = parameter_cells(member);
  std::vector<Cell> cells{family.name,
                          datum(member.name()),
                          {fmt::format("{}", fmt::join(family.aliases, ", ")), family.aliases},
                          family.formula,
                          parameters[0],
                          parameters[1],
                          to_string(law.ends()),
                          {class_name(smooth), smooth == kSmooth ? Json("smooth") : Json(smooth)}};
  for (const LawPeak& peak : kLawPeaks) {
    const double value = peak_of(all, peak).value;
    cells.push_back(shown_cell(value, peak.decimals));
    cells.back().html = shown(value, peak.decimals + 2);
  }
  const std::vector<Cell> last{
      {lambda ? shown(*lambda, 3) : "-", lambda},
      datum(all.jerk_inside_highest.value),
      datum(all.jerk_inside_lowest.value),
      datum(by_peak([&](const LawPeak& peak) { return to_json(peak_of(all, peak).position); })),
      datum(is_symmetric(law)),
      datum(law.is_data()),
      family.source};
  cells.insert(cells.end(), last.begin(), last.end());
  return cells;
}

/// The parameters of a law as they are set, a line each.
std::string set_parameters(const Member& member) {
  std::string text = member.family->parameters.empty() ? "" : "parameters\n";
  for (std::size_t i = 0; i < member.family->parameters.size(); ++i) {
    const Parameter& p = member.family->parameters[i];
    text +=
        fmt::format("  {} = {}  ({:g} .. {:g}; {})\n", p.name,
                    with_unit(fmt::format("{}", fmt::join(member.arguments.list(i), ",")), p.unit),
                    p.low, p.high, p.meaning);
  }
  return text;
}

/// How far from its printed value a peak may be.
double proved_to(double value, const Interval& enclosure) {
  return std::max(enclosure.upper() - value, value - enclosure.lower());
}

/// The peaks, where they are, and how far from the value printed the true one may be.
Table peaks_table(const Peaks<double>& all, const Peaks<Interval>& proof) {
  Table table{.columns = {words("peak"), numbers("value"), words("at x"), words("proved to")},
              .caption = "\n"};
  for (const LawPeak& asked : kLawPeaks) {
    const auto& [value, position] = peak_of(all, asked);
    const Interval enclosure = peak_of(proof, asked).value;
    table.add({asked.title, in_digits(value, 13), in_digits(position, 13),
               std::isfinite(value) ? fmt::format("{:.0e}", proved_to(value, enclosure)) : ""});
  }
  return table;
}

}  // namespace

std::vector<Member> catalogue_laws() {
  std::vector<Member> laws;
  for (const Family& family : catalogue()) laws.push_back({&family, family.defaults()});
  return laws;
}

Table laws_table(const std::vector<Member>& laws) {
  Table table{.columns = {words("law", "name"), data("member"),
                          words("also called", "aliases").only_on_page(),
                          words("formula", "formula").only_on_page(),
                          words("parameters", "parameters").only_in_text(),
                          words("parameters").only_on_page(), words("ends", "ends"),
                          words("class", "continuity")}};
  for (const LawPeak& peak : kLawPeaks) table.columns.push_back(numbers(peak.title, peak.key));
  for (Column column : {numbers("lambda", "lambda").only_in_text(), data("C_j_inside_max"),
                        data("C_j_inside_min"), data("positions"), data("symmetric"), data("data"),
                        words("source", "source").only_on_page()}) {
    table.columns.push_back(std::move(column));
  }
  for (const Member& law : laws) table.add(law_cells(law));
  return table;
}

Document laws_document(const std::vector<Member>& laws) {
  Document document;
  Table table = laws_table(laws);
  document.take_list([table] { return json_of(table); });
  document.add(std::move(table));
  document.say(
      fmt::format("\nConstants are those of the default parameters. Every R-R law also takes "
                  "crossover=c.\n'camlaw law NAME' tells more about one law. Law files in the "
                  "folder that {} names are laws too.\n",
                  problems::kOwnLaws));
  return document;
}

Document laws_page() {
  Document page;
  page.add(Heading{"Motion laws", 1});
  page.say(
      "Printed by `camlaw laws --markdown` from the catalogue in the code. Constants are those of "
      "the default\nparameters; every R-R law also takes `crossover` (0.02 .. 0.98), where its "
      "acceleration changes sign.\n");
  page.add(laws_table(catalogue_laws()));
  return page;
}

Document law_document(const Member& member) {
  const Family& family = *member.family;
  const Law<double> law = member.law();
  const auto all = peaks(law);
  const auto proof = peaks(member.law<Interval>());
  Document document;
  document.take_facts(json_of(laws_table({member})).front());
  document.say(fmt::format(
      "{}{}\n  {}\n  ends {}, continuity {}, {}; {}\n", member.name(),
      family.aliases.empty() ? "" : fmt::format("  ({})", fmt::join(family.aliases, "; ")),
      family.formula, to_string(law.ends()), class_name(continuity(law)),
      is_symmetric(law) ? "symmetric" : "not symmetric", family.source));
  document.say(set_parameters(member));
  document.add(peaks_table(all, proof));
  document.fact("enclosures", by_peak([&](const LawPeak& peak) {
                  const Interval value = peak_of(proof, peak).value;
                  return to_json(std::vector<double>{value.lower(), value.upper()});
                }));
  document.fact("proved_to", by_peak([&](const LawPeak& peak) {
                  const double value = peak_of(all, peak).value;
                  return std::isfinite(value)
                             ? to_json(proved_to(value, peak_of(proof, peak).value))
                             : Json();
                }));
  if (std::isinf(all.max_jerk()) && std::isfinite(all.jerk_inside_highest.value) &&
      std::isfinite(all.jerk_inside_lowest.value)) {
    document.say(fmt::format(
        "{} jumps; between jumps jerk is {:.8g} .. {:.8g}\n",
        std::isinf(all.max_acceleration()) && jumps(law).velocity ? "velocity" : "acceleration",
        all.jerk_inside_lowest.value, all.jerk_inside_highest.value));
  }
  if (const auto lambda = limit_index(all)) {
    document.say(fmt::format("lambda = {:.6f}\n", *lambda));
  }
  document.fact("pieces", problems::pieces_to_json(law));
  return document;
}

LongList law_samples(const Law<double>& law, int count) {
  const auto samples = std::make_shared<EvenSamples>(law, count);
  return {"samples", static_cast<std::size_t>(count), [samples](std::size_t i) {
            const auto [x, m] = samples->at(static_cast<int>(i));
            return Json{{"x", x},
                        {"s", to_json(m.s)},
                        {"v", to_json(m.v)},
                        {"a", to_json(m.a)},
                        {"j", to_json(m.j)}};
          }};
}

std::string law_in_words(const Member& law, problems::MovedBy moved) {
  return moved == problems::MovedBy::Program ? law.listed().family->formula : law.label();
}

}  // namespace camlaw::cli
