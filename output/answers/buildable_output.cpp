// SPDX-License-Identifier: MIT
#include "output/answers/buildable_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "output/answers/limit_text.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

using problems::Buildability, problems::BuildableAnswer, problems::Built;

/// The answer, on pages as a badge.
Cell answer_cell(Built built) {
  const std::string word{problems::to_string(built)};
  const bool fails = built == Built::Fails, holds = built == Built::Holds;
  Cell cell{fails ? "FAILS" : word, word};
  cell.badge = fails ? "bad" : holds ? "good" : "unsure";
  return cell;
}

/// What is missing, what it is that fails, or where the bound is from.
std::string remark_of(const BuildableAnswer& answer) {
  if (answer.built == Built::NotChecked) return answer.why;
  if (answer.built == Built::Holds) return answer.note;
  return answer.check->fault + (answer.note.empty() ? "" : fmt::format(" ({})", answer.note));
}

std::vector<Cell> unchecked_cells(const BuildableAnswer& answer) {
  const Json none = nullptr;
  return {{plain_name(answer.check->name), answer.check->name},
          answer_cell(answer.built),
          answer.check->response,
          {"", none},
          {"", none},
          datum(answer.check->is_upper ? "upper" : "lower"),
          {"", none},
          {"", none},
          {"", none},
          remark_of(answer)};
}

std::vector<Cell> checked_cells(const BuildableAnswer& answer) {
  std::vector<Cell> cells{{plain_name(answer.check->name), answer.check->name},
                          answer_cell(answer.built),
                          answer.report.name};
  for (Cell& cell : limit_cells(answer.report, answer.limit)) cells.push_back(std::move(cell));
  cells.push_back(remark_of(answer));
  return cells;
}

}  // namespace

Headline headline(const std::string& verdict, const Buildability& found) {
  if (!found.fails()) return {verdict, false};
  return {fmt::format("{} within the limits stated; {}", verdict, failure_text(found)), true};
}

std::string buildable_words(const Buildability& found) {
  if (found.checks.empty()) return "";
  const int holds = found.count(Built::Holds), fails = found.count(Built::Fails);
  const int open = found.count(Built::NotChecked);
  std::vector<std::string> parts{fmt::format("{} check{}", holds, holds == 1 ? " holds" : "s hold"),
                                 fmt::format("{} fail{}", fails, fails == 1 ? "s" : ""),
                                 fmt::format("{} {} not checked", open, open == 1 ? "is" : "are")};
  return fmt::format("buildable: {}{}", fmt::join(parts, ", "),
                     found.required ? "; the checked ones count as limits" : "");
}

std::string buildable_in_short(const Buildability& found) {
  for (const Built built : {Built::Fails, Built::NotChecked}) {
    std::vector<std::string> names;
    for (const BuildableAnswer& answer : found.checks) {
      if (answer.built == built) names.push_back(plain_name(answer.check->name));
    }
    if (names.empty()) continue;
    return fmt::format("{}: {}", problems::to_string(built), fmt::join(names, ", "));
  }
  return found.checks.empty() ? "" : std::string(problems::to_string(Built::Holds));
}

Table buildable_table(const Buildability& found) {
  Table table{.key = "checks",
              .columns = {words("check", "check"), words("answer", "answer"),
                          names("response", "response"), numbers("value", "value"),
                          numbers("bound", "bound"), data("side"), numbers("margin", "margin"),
                          words("unit", "unit"), numbers("at", "at"), words("", "remark")}};
  for (const BuildableAnswer& answer : found.checks) {
    const bool has_numbers = answer.limit.of_check && answer.built != Built::NotChecked;
    table.add(has_numbers ? checked_cells(answer) : unchecked_cells(answer));
  }
  return table;
}

Json buildable_json(const Buildability& found) {
  if (found.checks.empty()) return nullptr;
  return {{"holds", found.count(Built::Holds)},
          {"fails", found.count(Built::Fails)},
          {"not_checked", found.count(Built::NotChecked)},
          {"required", found.required},
          {"summary", failure_text(found)},
          {"checks", json_of(buildable_table(found))}};
}

Document buildable_document(const Buildability& found) {
  Document document;
  document.fact("buildable", buildable_json(found));
  if (found.checks.empty()) return document;
  const std::string line = buildable_words(found);
  document.say("\n" + (found.fails() ? shaded(line, Shade::Unsure) : line) + "\n");
  Table table = buildable_table(found);
  table.key.clear();
  document.add(std::move(table));
  return document;
}

}  // namespace camlaw::cli
