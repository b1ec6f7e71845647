// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "output/answers/optimum_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream parts(text);
  for (std::string word; parts >> word;) words.push_back(word);
  return words;
}

std::string key_of(const std::string& word) { return word.substr(0, word.find('=')); }

/// Options by what tells them apart, "rise=cycloidal" of a program: the words whose keys all
/// options have with different values. The options themselves where that does not tell them apart.
std::vector<std::string> told_apart(const std::vector<std::string>& options) {
  std::map<std::string, std::set<std::string>> values;
  std::map<std::string, std::size_t> count;
  for (const std::string& option : options) {
    for (const std::string& word : words_of(option)) {
      values[key_of(word)].insert(word);
      ++count[key_of(word)];
    }
  }
  const auto shortened = [&](const std::string& option, bool all_have_it) {
    std::string text;
    for (const std::string& word : words_of(option)) {
      const std::string key = key_of(word);
      const bool is_common = count[key] == options.size();
      const bool counts = is_common ? values[key].size() > 1 : !all_have_it;
      if (counts) text += (text.empty() ? "" : " ") + word;
    }
    return text;
  };
  std::map<std::string, int> seen;
  for (const std::string& option : options) ++seen[shortened(option, true)];
  std::vector<std::string> result;
  for (const std::string& option : options) {
    const std::string text = shortened(option, true);
    result.push_back(seen[text] == 1 ? text : shortened(option, false));
  }
  const std::set<std::string> different(result.begin(), result.end());
  return different.size() == options.size() ? result : options;
}

std::string limits_words(optim::Verdict verdict) {
  if (verdict == optim::Verdict::Infeasible) return "cannot be met";
  return verdict == optim::Verdict::Failed ? "not solved" : "met";
}

}  // namespace

Document combinations_document(const Answer& answer) {
  const std::vector<optim::Choice>& choices = answer.space.choices;
  Document document;
  std::vector<optim::PartFound> parts = answer.optimum.parts;
  if (choices.empty() || parts.empty()) return document;
  for (optim::PartFound& part : parts) {
    if (part.options != answer.optimum.options) continue;
    part.objective = answer.optimum.found.assessment.objective.value;  // which was solved once more
  }
  const optim::Objective& sought = answer.optimum.problem.objective();
  const std::string& sought_name = answer.bound.statement().objectives.front().response.name;
  const double sense = sought.sense == optim::Sense::Minimize ? 1 : -1;
  const auto has_design = [](const optim::PartFound& part) {
    return part.verdict == optim::Verdict::Certified || part.verdict == optim::Verdict::Feasible;
  };
  std::stable_sort(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    if (has_design(a) != has_design(b)) return has_design(a);
    return has_design(a) && sense * a.objective < sense * b.objective;
  });
  Table table{.key = "table", .columns = {}, .caption = "\nevery combination, the best first\n"};
  for (const optim::Choice& choice : choices)
    table.columns.push_back(words(choice.name, choice.name));
  table.columns.insert(table.columns.end(),
                       {numbers(sought_name, "objective"), words("unit", "unit"),
                        numbers("from the best", "from_best"), words("limits", "limits"),
                        words("held by", "held_by")});
  std::vector<std::vector<std::string>> names;
  for (const optim::Choice& choice : choices) {
    names.push_back(choice.values.empty() ? told_apart(choice.options) : choice.options);
  }
  const double best = parts.front().objective;
  for (const optim::PartFound& part : parts) {
    std::vector<Cell> row;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const std::string& option = names[i][part.options[i]];
      row.push_back(choices[i].values.empty() ? Cell(option)
                                              : Cell(with_unit(option, choices[i].unit),
                                                     choices[i].values[part.options[i]]));
    }
    const bool found = has_design(part);
    const double share = 100 * (part.objective - best) / std::abs(best);
    row.push_back(found
                      ? Cell(significant(part.objective, std::abs(part.objective)), part.objective)
                      : Cell("", std::nan("")));
    row.push_back(sought.response.unit);
    row.push_back(found && std::isfinite(share) ? Cell(fmt::format("{:+.2f} %", share), share)
                                                : Cell("", std::nan("")));
    row.push_back(limits_words(part.verdict));
    row.push_back(fmt::format("{}", fmt::join(part.active, ", ")));
    table.add(std::move(row));
  }
  document.add(table);
  return document;
}

}  // namespace camlaw::cli
