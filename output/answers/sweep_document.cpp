// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/answer_formats.h"
#include "output/answers/sweep_answer.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

constexpr std::size_t kShown = 60;  // rows that people read in a terminal

std::string named(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

/// Names that any row has, in the order in which they first appear.
template <class NamesOf>
std::vector<std::string> union_of(const SweepAnswer& answer, NamesOf names_of) {
  std::vector<std::string> all;
  for (const SweepRow& row : answer.rows) {
    for (const std::string& name : names_of(row)) {
      if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    }
  }
  return all;
}

/// Of variables: an objective, and the start that is swept, may have the same name.
std::string design_column(const problems::SweptVariable& v) {
  return named("design " + v.name, v.unit);
}

std::vector<std::string> variables_of(const SweepRow& row) {
  std::vector<std::string> names;
  for (const auto& v : row.variables) names.push_back(design_column(v));
  return names;
}

std::vector<std::string> margins_of(const SweepRow& row) {
  std::vector<std::string> names;
  for (const auto& limit : row.limits) {
    names.push_back(named("margin of " + limit.name, limit.unit));
  }
  return names;
}

Cell variable_cell(const SweepRow& row, const std::string& name) {
  for (const auto& v : row.variables) {
    if (design_column(v) != name) continue;
    return std::isnan(v.number) ? Cell(v.words, v.words) : datum(v.number);
  }
  return {};
}

Cell margin_cell(const SweepRow& row, const std::string& name) {
  for (const auto& limit : row.limits) {
    if (named("margin of " + limit.name, limit.unit) == name) return datum(limit.margin);
  }
  return {};
}

/// The limits that are not met, where the design is looked at and not searched for.
std::string violated(const SweepRow& row) {
  std::vector<std::string> names;
  for (const auto& limit : row.limits) {
    if (!limit.met) names.push_back(limit.name);
  }
  return names.empty() ? "" : fmt::format("violates {}", fmt::join(names, ", "));
}

/// Sentences that are too long for a table's cell stand below it once.
constexpr std::size_t kLongestReason = 48;

bool has_long_reason(const SweepRow& row) {
  return row.state != SweepState::Passes && row.state != SweepState::Design &&
         row.reason.size() > kLongestReason;
}

/// Each long reason of the rows that people read, once.
std::vector<std::string> long_reasons(const SweepAnswer& answer) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < std::min(kShown, answer.rows.size()); ++i) {
    const SweepRow& row = answer.rows[i];
    if (!has_long_reason(row) || std::count(all.begin(), all.end(), row.reason) > 0) continue;
    all.push_back(row.reason);
  }
  return all;
}

/// "(a)", "(b)", ..., "(aa)".
std::string mark_of(std::size_t reason) {
  constexpr std::size_t kLetters = 26;
  std::string letters;
  for (std::size_t left = reason + 1; left > 0; left = (left - 1) / kLetters) {
    letters.insert(letters.begin(), static_cast<char>('a' + (left - 1) % kLetters));
  }
  return "(" + letters + ")";
}

std::string held_text(const SweepRow& row, const std::vector<std::string>& reasons) {
  if (row.state == SweepState::Passes) return violated(row);
  if (row.state == SweepState::Design) return fmt::format("{}", fmt::join(row.active, ", "));
  const auto below = std::find(reasons.begin(), reasons.end(), row.reason);
  return below == reasons.end()
             ? row.reason
             : "see " + mark_of(static_cast<std::size_t>(below - reasons.begin()));
}

/// For each value of a name that has words: what is best with it.
Table best_table(const SweepAnswer& answer, std::size_t axis) {
  const problems::SweepAxis& swept = answer.study.plan().settings().axes[axis];
  const auto& o = answer.study.statement().objectives.front().response;
  struct Line {
    std::string value;
    std::optional<std::size_t> best;
    std::size_t designs = 0, all = 0;
  };
  std::vector<Line> lines;
  for (const std::string& value : swept.values) {
    Line line{value, answer.best_with(axis, value)};
    for (const SweepRow& row : answer.rows) {
      if (row.values[axis].text != value) continue;
      ++line.all;
      line.designs += row.state == SweepState::Design;
    }
    lines.push_back(line);
  }
  const auto objective = [&](const Line& line) {
    return line.best ? answer.rows[*line.best].objectives.front() : std::nan("");
  };
  const bool is_least = answer.study.statement().objectives.front().sense == optim::Sense::Minimize;
  const auto cost = [&](const Line& line) {
    return line.best ? (is_least ? objective(line) : -objective(line)) : optim::kInfinity;
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const Line& a, const Line& b) { return cost(a) < cost(b); });
  Table table{
      .key = "best_by_" + swept.name,
      .columns = {names(swept.name, "value"), numbers(named(o.name, o.unit), "objective"),
                  numbers("designs", "designs"), numbers("of", "combinations"), words("at", "at")},
      .shown = kShown,
      .caption = fmt::format("\nbest for each {}:\n", swept.name)};
  for (const Line& line : lines) {
    const double value = objective(line);
    table.add({line.value,
               {line.best ? in_digits(value) : "-", value},
               {fmt::format("{}", line.designs), line.designs},
               {fmt::format("{}", line.all), line.all},
               line.best ? combination_text(answer, *line.best) : ""});
  }
  return table;
}

std::string counts_text(const SweepAnswer& answer) {
  const bool evaluates = answer.study.plan().settings().evaluates;
  std::vector<std::string> parts;
  const auto add = [&](SweepState state, const char* what) {
    const std::size_t count = answer.count(state);
    if (count > 0) parts.push_back(fmt::format("{} {}", count, what));
  };
  if (!evaluates) {
    const auto certified =
        std::count_if(answer.rows.begin(), answer.rows.end(), [](const SweepRow& row) {
          return row.state == SweepState::Design &&
                 row.verdict == to_string(optim::Verdict::Certified);
        });
    if (certified > 0) parts.push_back(fmt::format("{} certified", certified));
    const auto feasible = static_cast<std::ptrdiff_t>(answer.count(SweepState::Design)) - certified;
    if (feasible > 0) parts.push_back(fmt::format("{} feasible", feasible));
  } else {
    add(SweepState::Design,
        answer.count(SweepState::Design) == 1 ? "meets every limit" : "meet every limit");
    add(SweepState::Passes,
        answer.count(SweepState::Passes) == 1 ? "violates a limit" : "violate a limit");
  }
  add(SweepState::NoDesign, "without a design");
  add(SweepState::Failed, "failed");
  add(SweepState::NotDone, "not done");
  return fmt::format("{} combinations: {}\n", answer.rows.size(), fmt::join(parts, ", "));
}

/// Names that are swept, but are what the search varies.
Document starts_document(const SweepAnswer& answer) {
  Document document;
  Json starts = Json::array();
  for (const problems::SweptName& name : answer.study.plan().names()) {
    if (!answer.study.is_start(name)) continue;
    document.say(fmt::format(
        "{} is a variable of the search: only its start is swept (--evaluate takes it as it is)\n",
        name.name));
    starts.push_back(name.name);
  }
  document.fact("only_start_swept", std::move(starts));
  return document;
}

}  // namespace

Table combinations_table(const SweepAnswer& answer) {
  const auto& swept = answer.study.plan().names();
  const auto& objectives = answer.study.statement().objectives;
  Table table{.key = "combinations", .columns = {}, .shown = kShown};
  for (std::size_t k = 0; k < swept.size(); ++k) {
    const std::string title = named(answer.swept_title(k), swept[k].unit);
    table.columns.push_back(swept[k].is_numeric ? numbers(title, title) : names(title, title));
  }
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    const std::string title = answer.objective_title(i);
    const bool is_swept = std::any_of(table.columns.begin(), table.columns.end(),
                                      [&](const Column& column) { return column.key == title; });
    table.columns.push_back(numbers(title, is_swept ? "objective " + title : title));
  }
  table.columns.insert(table.columns.end(),
                       {words("verdict", "verdict"), data("global"), words("held by", ""),
                        data("active"), data("reason"), data("start"), data("evaluations")});
  const auto variables = union_of(answer, variables_of), margins = union_of(answer, margins_of);
  for (const auto* more : {&variables, &margins}) {
    for (const std::string& name : *more) table.columns.push_back(data(name));
  }
  const std::vector<std::string> reasons = long_reasons(answer);
  for (const SweepRow& row : answer.rows) {
    std::vector<Cell> cells;
    for (std::size_t k = 0; k < swept.size(); ++k) {
      const problems::SweptValue& value = row.values[k];
      cells.push_back(swept[k].is_numeric ? Cell(in_digits(value.number), value.number)
                                          : Cell(value.text));
    }
    for (std::size_t i = 0; i < objectives.size(); ++i) {
      cells.push_back(row.objectives.empty()
                          ? Cell("-", std::nan(""))
                          : Cell(in_digits(row.objectives[i]), row.objectives[i]));
    }
    cells.insert(cells.end(),
                 {Cell(row.verdict), datum(row.is_global), Cell(held_text(row, reasons)),
                  datum(fmt::format("{}", fmt::join(row.active, "; "))), datum(row.reason),
                  datum(std::string(row.state == SweepState::NotDone ? ""
                                    : row.is_warm                    ? "neighbour"
                                                                     : "own")),
                  datum(row.evaluations)});
    for (const std::string& name : variables) cells.push_back(variable_cell(row, name));
    for (const std::string& name : margins) cells.push_back(margin_cell(row, name));
    table.add(std::move(cells));
  }
  return table;
}

std::vector<Table> best_tables(const SweepAnswer& answer) {
  std::vector<Table> tables;
  const auto& axes = answer.study.plan().settings().axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!axes[k].is_numeric()) tables.push_back(best_table(answer, k));
  }
  return tables;
}

Document sweep_document(const SweepAnswer& answer) {
  const auto& plan = answer.study.plan();
  const problems::ProblemStatement& stated = answer.study.statement();
  Document document;
  document.fact("format", kSweepFormat.text());
  if (!stated.title.empty()) document.say(stated.title + "\n");
  document.say(counts_text(answer));
  document.fact("title", stated.title);
  document.fact("evaluated", plan.settings().evaluates);
  document.fact("finished", !answer.is_stopped);
  document.fact("count", answer.rows.size());
  document.fact("designs", answer.count(SweepState::Design));
  if (const auto best = answer.best()) {
    const SweepRow& row = answer.rows[*best];
    document.say(fmt::format(
        "best {} at {}\n",
        with_unit(in_digits(row.objectives.front()), stated.objectives.front().response.unit),
        combination_text(answer, *best)));
    document.fact("best", *best + 1);
  } else {
    document.fact("best", Json(nullptr));
  }
  document.add(starts_document(answer));
  for (const std::string& note : answer.notes) document.say(note + "\n");
  document.say("\n");
  document.add(combinations_table(answer));
  const std::vector<std::string> reasons = long_reasons(answer);
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    document.say(fmt::format("{} {}\n", mark_of(i), reasons[i]));
  }
  if (answer.rows.size() > kShown) {
    document.say(fmt::format("the first {} of {} combinations; --out writes all of them\n", kShown,
                             answer.rows.size()));
  }
  if (answer.has_warm()) {
    document.say(
        "rows whose search began at a neighbour's design may miss a better one elsewhere; --cold "
        "searches each combination on its own\n");
  }
  for (Table& table : best_tables(answer)) document.add(std::move(table));
  return document;
}

}  // namespace camlaw::cli
