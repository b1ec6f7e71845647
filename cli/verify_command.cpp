// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "output/answers/buildable_output.h"
#include "output/answers/claim_output.h"
#include "output/answers/law_json.h"
#include "output/answers/limit_text.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "problems/results/judged_design.h"

namespace camlaw::cli {
namespace {

using problems::ReadDesign, problems::VerifiedDesign;

struct VerifyOptions {
  std::string file;
  bool json = false;
};

std::string verdict_text(const ReadDesign& read, const VerifiedDesign& verified) {
  const optim::Assessment& found = verified.found;
  const auto& objective = read.statement.objectives.front().response;
  std::string text = read.statement.title.empty() ? "" : read.statement.title + "\n";
  text += fmt::format("claimed: {}{}\n", *read.verdict, read.global ? ", global" : "");
  text += fmt::format("found:   {}: {}\n", to_string(found.verdict), found.reason);
  if (found.global) text += fmt::format("global:  {}\n", *found.global);
  if (!verified.whole) {
    text += "judged with the choices and integer variables held at what the search chose\n";
  }
  const bool alone = read.statement.objectives.size() == 1;
  if (alone) {
    text += fmt::format("\n{} = {}\n", objective.name,
                        with_unit(fmt::format("{:.10g}", found.objective.value), objective.unit));
  }
  for (std::size_t i = 0; i < verified.limits.size(); ++i) {
    const optim::LimitReport& limit = verified.limits[i];
    const LimitText words = limit_text(limit, read.statement.constraints[i]);
    text += fmt::format("{} {} = {} {}{}\n",
                        limit.met ? shaded("met", Shade::Good) : shaded("NOT met", Shade::Bad),
                        limit.name, words.value, with_unit(words.bound, limit.unit),
                        limit.proved ? "" : "  (not proved)");
  }
  text += text_of(buildable_document(problems::buildability(read.statement)));
  text += warnings_text(warnings_of(read.statement)) + "\n";
  text += record_text(problems::record_notes(read, short_version()));
  for (const std::string& what : verified.not_judged) text += fmt::format("not judged: {}\n", what);
  if (verified.disagreements.empty()) return text + "the claim holds\n";
  text += "the claim does not hold\n";
  for (const std::string& what : verified.disagreements) text += fmt::format("  {}\n", what);
  return text;
}

Json verdict_json(const ReadDesign& read, const VerifiedDesign& verified) {
  const optim::Assessment& found = verified.found;
  return {{"title", read.statement.title},
          {"claimed", *read.verdict},
          {"claimed_global", read.global},
          {"claimed_objective", read.objective ? to_json(*read.objective) : Json(nullptr)},
          {"verdict", to_string(found.verdict)},
          {"reason", found.reason},
          {"warnings", warnings_of(read.statement)},
          {"buildable", buildable_json(problems::buildability(read.statement))},
          {"global", found.global ? Json(*found.global) : Json(nullptr)},
          {"best_possible", found.best_possible ? to_json(*found.best_possible) : Json(nullptr)},
          {"objective", to_json(found.objective.value)},
          {"kkt_residual", to_json(found.kkt_residual)},
          {"choices_held", !verified.whole},
          {"disagreements", verified.disagreements},
          {"not_judged", verified.not_judged},
          {"record", problems::record_notes(read, short_version())},
          {"holds", verified.disagreements.empty()}};
}

int run_verify(const VerifyOptions& options) {
  const ReadDesign read = problems::read_design_file(options.file);
  const VerifiedDesign verified = [&] {
    try {
      return problems::verified(read);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", options.file, error.what()));
    }
  }();
  if (options.json) {
    print_data(verdict_json(read, verified).dump(2) + "\n");
  } else {
    print_text(verdict_text(read, verified));
  }
  return verified.disagreements.empty() ? kDone : kNotSolved;
}

}  // namespace

Command verify_command() {
  const auto options = std::make_shared<VerifyOptions>();
  return {.name = "verify",
          .help = "Judge the design of a result and its claim again: verdict, bound, margins",
          .options = {{.names = "FILE",
                       .target = &options->file,
                       .takes = takes::kFile,
                       .help = "the result.json of a search, or what --json prints",
                       .required = true},
                      json_switch(options->json)},
          .examples = {{"camlaw optimize problems/cams/roller_least_base.toml --out "
                        "results/disc_cam; camlaw verify results/disc_cam/result.json",
                        "the verdict once more, from the design alone: no search, nothing "
                        "believed"}},
          .run = [options] { return run_verify(*options); }};
}

}  // namespace camlaw::cli
