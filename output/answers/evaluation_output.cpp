// SPDX-License-Identifier: MIT
#include "output/answers/evaluation_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "output/answers/answer_formats.h"
#include "output/answers/buildable_output.h"
#include "output/answers/law_output.h"
#include "output/answers/limit_text.h"
#include "output/answers/segments_output.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "problems/statement/parameters.h"
#include "problems/statement/why_undefined.h"

namespace camlaw::cli {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

/// Numbers, and of curves the extremes.
Table response_table(const std::vector<EvaluatedResponse>& responses) {
  Table table{.columns = {words("response"), numbers("value"), numbers("lowest"), numbers("at"),
                          numbers("highest"), numbers("at"), words("unit"), words("meaning")}};
  for (const EvaluatedResponse& r : responses) {
    // Beside what may be a pole the other extreme is no rounding of 0.
    const double size = std::max(std::abs(r.lowest), std::abs(r.highest));
    const auto own = [&](double extreme) {
      return significant(extreme, r.proved ? size : std::abs(extreme));
    };
    const auto place = [&](double extreme, double at) {
      return std::isnan(extreme) ? "" : place_text(at, r.along);
    };
    if (r.is_curve) {
      table.add({r.name, "", own(r.lowest), place(r.lowest, r.lowest_at), own(r.highest),
                 place(r.highest, r.highest_at), r.unit, r.meaning});
    } else {
      table.add(
          {r.name, significant(r.value, std::abs(r.value)), "", "", "", "", r.unit, r.meaning});
    }
  }
  return table;
}

using Reasons = std::map<std::string, std::string>;

/// Why responses have no finite numbers, by their names, where that is known.
struct NoNumbers {
  Reasons undefined, infinite;
};

NoNumbers reasons_of(const ProblemStatement& statement,
                     const std::vector<EvaluatedResponse>& responses) {
  NoNumbers reasons;
  for (const EvaluatedResponse& r : responses) {
    std::string undefined = problems::why_undefined(statement, r);
    if (!undefined.empty()) reasons.undefined[r.name] = std::move(undefined);
    std::string infinite = problems::why_infinite(statement, r);
    if (!infinite.empty()) reasons.infinite[r.name] = std::move(infinite);
  }
  return reasons;
}

/// Says which numbers are extremes of samples only; empty where intervals prove all of them, or a
/// reason tells why they are infinite.
std::string sampled_text(const std::vector<EvaluatedResponse>& responses, const Reasons& infinite) {
  std::vector<std::string> names;
  for (const EvaluatedResponse& r : responses) {
    const bool number = !std::isnan(r.is_curve ? r.highest - r.lowest : r.value);
    if (!r.proved && number && !infinite.contains(r.name)) names.push_back(r.name);
  }
  if (names.empty()) return {};
  return fmt::format("sampled, not proved over the whole cycle: {}\n", fmt::join(names, ", "));
}

/// Names in a sentence; of many the first.
std::string first_names(std::vector<std::string> names) {
  constexpr std::size_t kMost = 8, kShown = 4;
  if (names.size() > kMost) {
    const std::string rest = fmt::format("{} more", names.size() - kShown);
    names.resize(kShown);
    names.push_back(rest);
  }
  return problems::listed(names);
}

/// A line for each reason, with the responses that it is of in their order.
std::string reasons_text(const std::vector<EvaluatedResponse>& responses, const Reasons& reasons,
                         const std::string& of_one, const std::string& of_several) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  for (const EvaluatedResponse& r : responses) {
    const auto why = reasons.find(r.name);
    if (why == reasons.end()) continue;
    auto line = std::find_if(lines.begin(), lines.end(),
                             [&](const auto& known) { return known.first == why->second; });
    if (line == lines.end()) line = lines.insert(line, {why->second, {}});
    line->second.push_back(r.name);
  }
  std::string text;
  for (const auto& [why, names] : lines) {
    text += fmt::format("{} {}: {}\n", first_names(names), names.size() == 1 ? of_one : of_several,
                        why);
  }
  return text;
}

Json responses_json(const std::vector<EvaluatedResponse>& responses, const NoNumbers& reasons) {
  Json values = Json::object();
  for (const EvaluatedResponse& r : responses) {
    if (r.is_curve) {
      values[r.name] = {{"lowest", to_json(r.lowest)},
                        {"lowest_at", r.lowest_at},
                        {"highest", to_json(r.highest)},
                        {"highest_at", r.highest_at},
                        {"unit", r.unit},
                        {"along", r.along},
                        {"proved", r.proved}};
    } else {
      values[r.name] = {{"value", to_json(r.value)}, {"unit", r.unit}};
      if (!r.proved) values[r.name]["proved"] = false;
    }
    const auto why = reasons.undefined.find(r.name), infinite = reasons.infinite.find(r.name);
    if (why != reasons.undefined.end()) values[r.name]["why_undefined"] = why->second;
    if (infinite != reasons.infinite.end()) values[r.name]["why_infinite"] = infinite->second;
  }
  return values;
}

Json constants_json(const ProblemStatement& statement) {
  Json constants = Json::object();
  const auto& parameters = statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    constants[parameters[i].name] = {{"value", statement.constants[i]},
                                     {"unit", parameters[i].unit}};
  }
  return constants;
}

/// The parts that come from catalogues.
void add_parts(const ProblemStatement& statement, Document& document) {
  if (statement.parts.empty()) return;
  Json parts = Json::object();
  for (const problems::PartStatement& part : statement.parts) {
    const problems::PartItem& item = part.items[part.start];
    document.say(fmt::format("{} {}, of {}\n", part.name, item.name, part.catalogue));
    parts[part.name] = {
        {"name", item.name}, {"catalogue", part.catalogue}, {"source", item.source}};
  }
  document.fact("parts", std::move(parts));
}

}  // namespace

Document evaluation_document(const ProblemStatement& statement,
                             const std::vector<EvaluatedResponse>& responses,
                             const std::vector<optim::LimitReport>& limits,
                             const ClaimReview& review) {
  Document document;
  if (!statement.title.empty()) document.say(statement.title + "\n");
  document.fact("format", kEvaluationFormat.text());
  document.fact("title", statement.title);
  document.fact("mechanism", statement.mechanism->name);
  const problems::MovedBy moved_by = statement.mechanism->moved_by;
  const bool moved = moved_by != problems::MovedBy::Nothing;
  const bool is_program = moved_by == problems::MovedBy::Program;
  if (moved) {
    const std::string words = law_in_words(statement.laws.front(), moved_by);
    document.say(fmt::format("{} {}\n", is_program ? "motion:" : "law", words));
    if (is_program) document.fact("motion", words);
  }
  document.fact("law", moved ? Json(statement.laws.front().name()) : Json(nullptr));
  add_parts(statement, document);
  document.fact("constants", constants_json(statement));
  document.say("\n");
  document.add(response_table(responses));
  const auto reasons = reasons_of(statement, responses);
  document.say(sampled_text(responses, reasons.infinite));
  document.say(reasons_text(responses, reasons.undefined, "is undefined", "are undefined"));
  document.say(reasons_text(responses, reasons.infinite, "becomes infinite", "become infinite"));
  document.fact("responses", responses_json(responses, reasons));
  if (moved) add_segments(statement.laws.front(), document);
  if (!limits.empty()) document.say("\n");
  document.add(limits_document(limits, statement));
  document.add(buildable_document(problems::buildability(statement)));
  const Warnings warnings = warnings_of(statement);
  document.say(warnings_text(warnings));
  document.fact("warnings", warnings);
  document.say(record_text(review.words()));
  document.fact("record", review_json(review));
  return document;
}

}  // namespace camlaw::cli
