// SPDX-License-Identifier: MIT
#include "output/answers/verified_output.h"

#include <fmt/format.h>

#include "output/answers/buildable_output.h"
#include "output/answers/claim_output.h"
#include "output/answers/limit_text.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/short_version.h"

namespace camlaw::cli {
namespace {

using problems::ReadDesign, problems::VerifiedDesign;

void add_verdicts(const ReadDesign& read, const VerifiedDesign& verified, Document& document) {
  const optim::Assessment& found = verified.found;
  if (!read.statement.title.empty()) document.say(read.statement.title + "\n");
  document.say(fmt::format("claimed: {}{}\nfound:   {}: {}\n", *read.verdict,
                           read.global ? ", global" : "", to_string(found.verdict), found.reason));
  if (found.global) document.say(fmt::format("global:  {}\n", *found.global));
  if (!verified.whole) {
    document.say("judged with the choices and integer variables fixed at what the search chose\n");
  }
  document.fact("title", read.statement.title);
  document.fact("claimed", *read.verdict);
  document.fact("claimed_global", read.global);
  document.fact("claimed_objective", read.objective);
  document.fact("verdict", to_string(found.verdict));
  document.fact("reason", found.reason);
  document.fact("global", found.global);
  document.fact("best_possible", found.best_possible);
  document.fact("objective", found.objective.value);
  document.fact("kkt_residual", found.kkt_residual);
  document.fact("choices_held", !verified.whole);
}

}  // namespace

Document verified_document(const ReadDesign& read, const VerifiedDesign& verified) {
  Document document;
  add_verdicts(read, verified, document);
  if (read.statement.objectives.size() == 1) {
    const auto& objective = read.statement.objectives.front().response;
    document.say(
        fmt::format("\n{} = {}\n", objective.name,
                    with_unit(in_digits(verified.found.objective.value, 10), objective.unit)));
  }
  document.add(limits_document(verified.limits, read.statement));
  document.add(buildable_document(problems::buildability(read.statement)));
  const Warnings warnings = warnings_of(read.statement);
  document.say(warnings_text(warnings) + "\n");
  document.fact("warnings", warnings);
  const auto record = problems::record_notes(read, short_version());
  document.say(record_text(record));
  document.fact("record", record);
  for (const std::string& what : verified.not_judged) {
    document.say(fmt::format("not judged: {}\n", what));
  }
  document.fact("not_judged", verified.not_judged);
  const bool holds = verified.disagreements.empty();
  document.say(holds ? "the claim holds\n" : "the claim does not hold\n");
  for (const std::string& what : verified.disagreements) document.say("  " + what + "\n");
  document.fact("disagreements", verified.disagreements);
  document.fact("holds", holds);
  return document;
}

}  // namespace camlaw::cli
