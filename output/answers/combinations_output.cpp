// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "optim/cycle/scales.h"
#include "optim/problem/interrupted.h"
#include "optim/search/discrete.h"
#include "optim/search/interruptible.h"
#include "optim/search/told.h"
#include "optim/verdict/verdict.h"
#include "output/answers/free_limit.h"
#include "output/answers/optimum_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

/// The words of an option: "x=0,1,2,... (11 values)" is one.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream parts(text);
  for (std::string word; parts >> word;) {
    const bool is_new = words.empty() || word.find('=') != std::string::npos;
    if (is_new) {
      words.push_back(word);
    } else {
      words.back() += " " + word;
    }
  }
  return words;
}

std::string key_of(const std::string& word) { return word.substr(0, word.find('=')); }

/// An option by its words, of which some are always told.
struct WordedOption {
  std::vector<std::string> words;
  std::set<std::string> always;
  std::string group;  ///< options with the same name, which their other words must tell apart
};

/// Of each option the words that are always told, and those that not all of its group have.
std::vector<std::string> told_apart(const std::vector<WordedOption>& options) {
  std::map<std::string, std::size_t> size;
  std::map<std::pair<std::string, std::string>, std::size_t> sharing;
  for (const WordedOption& option : options) {
    ++size[option.group];
    for (const std::string& word : option.words) ++sharing[{option.group, word}];
  }
  std::vector<std::string> result;
  for (const WordedOption& option : options) {
    std::vector<std::string> told;
    for (const std::string& word : option.words) {
      const bool is_shared = sharing[{option.group, word}] == size[option.group];
      if (option.always.contains(word) || !is_shared) told.push_back(word);
    }
    result.push_back(fmt::format("{}", fmt::join(told, " ")));
  }
  return result;
}

/// Programs by what tells them apart, "rise=cycloidal" of those that have another law there. Of a
/// law's parameters those that tell apart programs of the same laws.
std::vector<std::string> program_names(const std::vector<std::string>& options) {
  std::map<std::string, std::set<std::string>> values;
  std::map<std::string, std::size_t> count;
  std::vector<WordedOption> worded;
  for (const std::string& option : options) {
    worded.push_back({.words = words_of(option), .always = {}, .group = ""});
    for (const std::string& word : worded.back().words) {
      values[key_of(word)].insert(word);
      ++count[key_of(word)];
    }
  }
  for (WordedOption& option : worded) {
    for (const std::string& word : option.words) {
      const std::string key = key_of(word);
      if (count[key] != options.size() || values[key].size() < 2) continue;
      option.always.insert(word);
      option.group += word + " ";
    }
  }
  return told_apart(worded);
}

/// Laws by their names, and by the parameters that are not at their defaults or tell apart laws of
/// one name: --set takes these names.
std::vector<std::string> law_names(const std::vector<std::string>& options,
                                   const std::vector<Member>& laws) {
  std::vector<WordedOption> worded;
  for (std::size_t i = 0; i < options.size(); ++i) {
    WordedOption option{words_of(options[i]), {}, laws[i].family->name};
    option.always.insert(option.words.begin(), option.words.end());
    const Member usual{laws[i].family, laws[i].family->defaults()};
    for (const std::string& word : words_of(usual.label())) {
      if (word != option.group) option.always.erase(word);
    }
    worded.push_back(std::move(option));
  }
  return told_apart(worded);
}

/// What a table calls the options of a choice: names that --set takes, while of a program, the
/// first choice if there are several, each option is named by the laws of its segments.
std::vector<std::string> option_names(const Answer& answer, std::size_t choice) {
  const std::vector<std::string>& options = answer.space.choices[choice].options;
  const problems::ProblemStatement& statement = answer.bound.statement();
  if (choice > 0 || !statement.chooses_law()) return options;
  const auto names = statement.mechanism->moved_by == problems::MovedBy::Law
                         ? law_names(options, statement.laws)
                         : program_names(options);
  const std::set<std::string> different(names.begin(), names.end());
  return different.size() == options.size() ? names : options;
}

/// A combination, and how its design stands to each limit; none where it has no design.
struct JudgedPart {
  optim::PartFound found;
  std::vector<optim::LimitReport> limits = {};
  bool is_broken = false;  ///< its search took it for a design within the limits, which it is not
  bool is_left = false;    ///< there was no time to judge it
};

std::string limits_words(const JudgedPart& part) {
  if (part.found.verdict == optim::Verdict::Infeasible) return "cannot be met";
  if (part.is_broken) return "not met";
  if (part.is_left) return "met, not proved";
  return part.found.verdict == optim::Verdict::Failed ? "not solved" : "met";
}

/// With proofs, as an answer is judged: a search for the best of many combinations has none. Throws
/// optim::Interrupted where the deadline has passed.
void judge(const Answer& answer, const optim::Deadline& deadline, JudgedPart& part) {
  const std::vector<double>& x = part.found.x;
  deadline.check();
  const optim::Problem problem = optim::interruptible(
      optim::with_integers_fixed(answer.space.problem(part.found.options), x), deadline);
  const optim::Scales scales = optim::scales(problem, x);
  optim::Assessment a =
      optim::assess(problem, scales, x, true, optim::teller_at(problem, scales, x));
  part.found.objective = a.objective.value;
  const bool is_local = a.verdict == optim::Verdict::Certified && !part.found.is_settled;
  part.found.verdict = is_local ? optim::Verdict::Feasible : a.verdict;
  part.found.active = std::move(a.active);
  part.limits = std::move(a.limits);
  part.is_broken = !has_design(part.found);
}

/// The same in the time that there is; else the design stays as its search has left it, which has
/// proved nothing.
void judge_in_time(const Answer& answer, const optim::Deadline& deadline, JudgedPart& part) {
  JudgedPart judged = part;
  try {
    judge(answer, deadline, judged);
    part = std::move(judged);
  } catch (const optim::Interrupted&) {
    part.found.verdict = optim::Verdict::Feasible;
    part.is_left = true;
  }
}

/// The combinations that were looked at, each judged; that of the answer, which was solved once
/// more, as the answer has it.
std::vector<JudgedPart> judged_parts(const Answer& answer, const optim::Deadline& deadline) {
  std::vector<JudgedPart> parts;
  const optim::Assessment& own = answer.optimum.found.assessment;
  for (const optim::PartFound& found : answer.optimum.parts) {
    JudgedPart part{found};
    if (has_design(found) && found.options == answer.optimum.options) {
      part.found.objective = own.objective.value;
      part.found.x = answer.optimum.found.x;
      part.found.verdict = own.verdict;
      part.limits = own.limits;
      part.is_broken = !has_design(part.found);
      // That other combinations are not settled is not said of this one.
      if (own.verdict == optim::Verdict::Feasible) judge_in_time(answer, deadline, part);
    } else if (has_design(found)) {
      judge_in_time(answer, deadline, part);
    }
    part.limits = problems::as_stated(answer.bound.statement(), std::move(part.limits));
    parts.push_back(std::move(part));
  }
  return parts;
}

/// How far within each limit; null where there is no design.
Json margins_json(const std::vector<optim::LimitReport>& limits, bool has_design) {
  if (!has_design) return nullptr;
  Json margins = Json::array();
  for (const optim::LimitReport& limit : limits) {
    margins.push_back({{"name", limit.name},
                       {"side", limit.is_upper ? "upper" : "lower"},
                       {"margin", to_json(limit.margin)},
                       {"unit", limit.unit}});
  }
  return margins;
}

/// A limit's margin as a share of its bound, by which limits in different units are compared; of a
/// bound of zero as a share of the value.
double share_of_bound(const optim::LimitReport& limit) {
  const double size =
      std::abs(limit.bound) > 1e3 * limit.tolerance ? std::abs(limit.bound) : std::abs(limit.value);
  return size > 0 ? limit.margin / size : 0;
}

/// The limit that a design is nearest to; null where there is none. Equations have no margin.
const optim::LimitReport* nearest(const std::vector<optim::LimitReport>& limits) {
  const optim::LimitReport* least = nullptr;
  for (const optim::LimitReport& limit : limits) {
    if (limit.is_equation || !std::isfinite(limit.margin)) continue;
    if (least == nullptr || share_of_bound(limit) < share_of_bound(*least)) least = &limit;
  }
  return least;
}

/// "0.012 deg of pressure_angle", with the margin as its number.
Cell least_margin(const std::vector<optim::LimitReport>& limits) {
  const optim::LimitReport* least = nearest(limits);
  if (least == nullptr) return Cell("", std::nan(""));
  const double shown = std::abs(least->margin) <= least->tolerance ? 0 : least->margin;
  return Cell(
      fmt::format("{} of {}", with_unit(fmt::format("{:.3g}", shown), least->unit), least->name),
      least->margin);
}

/// How far one objective is from another, in percent of this.
Cell share_from(double objective, double other) {
  constexpr double kShown = 0.005;  // below which it is written as 0
  const double share = 100 * (objective - other) / std::abs(other);
  const double shown = std::abs(share) < kShown ? 0 : share;
  return std::isfinite(share) ? Cell(fmt::format("{:+.2f} %", shown), share)
                              : Cell("", std::nan(""));
}

/// What the free law reaches, as a sentence and as facts; or why that is not known.
Document free_limit_document(const std::string& objective, const std::string& unit,
                             const FreeLimit& free) {
  Document document;
  Json fact = {{"objective", free.objective ? to_json(*free.objective) : Json(nullptr)},
               {"unit", unit},
               {"verdict", free.verdict.empty() ? Json(nullptr) : Json(free.verdict)},
               {"law", free.law.empty() ? Json(nullptr) : Json(free.law)},
               {"why_none", free.why_none.empty() ? Json(nullptr) : Json(free.why_none)}};
  document.fact("free_law", fact);
  if (free.objective) {
    document.say(fmt::format("\na free law, {}, reaches {} = {}{} ({})\n", free.law, objective,
                             significant(*free.objective, std::abs(*free.objective)),
                             unit == "1" ? "" : " " + unit, free.verdict));
  } else {
    document.say(fmt::format("\nthe distance from a free law is not known: {}\n", free.why_none));
  }
  return document;
}

}  // namespace

bool has_design(const optim::PartFound& part) {
  return part.verdict == optim::Verdict::Certified || part.verdict == optim::Verdict::Feasible;
}

Document combinations_document(const Answer& answer, const FreeLimit* free,
                               const optim::Deadline& deadline) {
  const std::vector<optim::Choice>& choices = answer.space.choices;
  Document document;
  if (choices.empty() || answer.optimum.parts.empty()) return document;
  std::vector<JudgedPart> parts = judged_parts(answer, deadline);
  const optim::Objective& sought = answer.optimum.problem.objective();
  const std::string& sought_name = answer.bound.statement().objectives.front().response.name;
  const double sense = sought.sense == optim::Sense::Minimize ? 1 : -1;
  std::stable_sort(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    const bool has_one = has_design(a.found);
    if (has_one != has_design(b.found)) return has_one;
    return has_one && sense * a.found.objective < sense * b.found.objective;
  });
  Table table{.key = "table", .columns = {}, .caption = "\nevery combination, the best first\n"};
  for (const optim::Choice& choice : choices)
    table.columns.push_back(words(choice.name, choice.name));
  table.columns.insert(table.columns.end(),
                       {numbers(sought_name, "objective"), words("unit", "unit"),
                        numbers("from the best", "from_best")});
  if (free != nullptr) {
    Column from_free = numbers("from the free law", "from_free_law");
    from_free.in_text = from_free.on_page = free->objective.has_value();
    table.columns.push_back(from_free);
  }
  table.columns.insert(table.columns.end(), {words("verdict", "verdict"), words("limits", "limits"),
                                             words("least margin", "least_margin"),
                                             words("held by", "held_by"), data("margins")});
  std::vector<std::vector<std::string>> names;
  for (std::size_t i = 0; i < choices.size(); ++i) names.push_back(option_names(answer, i));
  const double best = parts.front().found.objective;
  for (const JudgedPart& judged : parts) {
    const optim::PartFound& part = judged.found;
    std::vector<Cell> row;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const std::string& option = names[i][part.options[i]];
      row.push_back(choices[i].values.empty() ? Cell(option)
                                              : Cell(with_unit(option, choices[i].unit),
                                                     choices[i].values[part.options[i]]));
    }
    const bool found = has_design(part);
    row.push_back(found
                      ? Cell(significant(part.objective, std::abs(part.objective)), part.objective)
                      : Cell("", std::nan("")));
    row.push_back(sought.response.unit);
    row.push_back(share_from(found ? part.objective : std::nan(""), best));
    if (free != nullptr) {
      row.push_back(share_from(found ? part.objective : std::nan(""),
                               free->objective.value_or(std::nan(""))));
    }
    row.push_back(std::string(to_string(part.verdict)));
    row.push_back(limits_words(judged));
    row.push_back(least_margin(judged.limits));
    row.push_back(fmt::format("{}", fmt::join(part.active, ", ")));
    row.push_back(datum(margins_json(judged.limits, !judged.limits.empty() || found)));
    table.add(std::move(row));
  }
  document.add(table);
  const bool has_feasible = std::any_of(parts.begin(), parts.end(), [](const auto& part) {
    return part.found.verdict == optim::Verdict::Feasible;
  });
  if (has_feasible) {
    document.say(
        "feasible: this design meets the limits, but is not shown to be the best of its "
        "combination\n");
  }
  const auto left = std::ranges::count_if(parts, [](const auto& part) { return part.is_left; });
  document.fact("not_judged", left);
  if (left > 0) {
    document.say(fmt::format(
        "{}: {} of {} combinations {} as the search left {}; by samples alone, {} the limits\n",
        deadline.reason(), left, parts.size(), left == 1 ? "is" : "are", left == 1 ? "it" : "them",
        left == 1 ? "it meets" : "they meet"));
  }
  if (free != nullptr) document.add(free_limit_document(sought_name, sought.response.unit, *free));
  return document;
}

}  // namespace camlaw::cli
