// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/ranks.h"
#include "cli/run_limits.h"
#include "cli/study_file.h"
#include "cli/workers.h"
#include "optim/crew/telling_hands.h"
#include "optim/study/record.h"
#include "optim/study/recorded_hands.h"
#include "output/answers/profile_output.h"
#include "output/answers/variation_output.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"
#include "problems/fronts/stored_front.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/profile_errors.h"
#include "problems/statement/solver_settings.h"
#include "problems/tolerance/profile_loss.h"
#include "problems/tolerance/tolerance.h"
#include "problems/tolerance/tolerance_study.h"
#include "problems/tolerance/tolerance_worker.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

struct ToleranceCommand {
  std::string file;
  std::optional<std::string> point, samples, seed, workers, executor, db;
  std::vector<std::string> settings, tolerances;
  /// Errors of the profile, by their keys.
  std::map<std::string, std::optional<std::string>> profile;
  RunLimits limits;
  bool resume = false, json = false;
};

/// The design of a point of a study's front.
ProblemStatement point_design(const ToleranceCommand& options) {
  optim::StudyRecord record = optim::StudyRecord::read(options.file);
  const problems::FrontStudy study = problems::FrontStudy::of(record);
  keep_recorded(study.bound().statement(), options.file);
  const problems::StoredFront stored = problems::stored_front(study, record);
  const auto& points = stored.front.points;
  if (points.empty()) throw std::invalid_argument(options.file + ": its front has no points");
  const auto number = problems::parse_integer(*options.point, 1,
                                              static_cast<std::int64_t>(points.size()), "--point");
  const optim::FrontPoint& point = points[static_cast<std::size_t>(number - 1)];
  return study.bound().at(study.space().options(point.part), point.x);
}

ProblemStatement design_of(const ToleranceCommand& options) {
  keep_input(options.file);
  if (options.point) {
    ProblemStatement point = point_design(options);
    problems::set_values(point, options.settings);
    return point;
  }
  if (optim::begins_as_study(options.file)) {
    throw std::invalid_argument(
        fmt::format("{0}: a study needs --point, the number of a point of its front; 'camlaw front "
                    "{0}' shows them",
                    options.file));
  }
  const problems::ReadDesign read = problems::read_design_file(options.file);
  keep_inputs(read, options.file);
  ProblemStatement design = read.statement;
  problems::set_in_design(design, read, options.settings);
  return design;
}

/// What the file says of the profile, where the command line does not.
problems::ProfileErrors profile_errors(const ToleranceCommand& options,
                                       const ProblemStatement& design) {
  problems::ProfileErrors errors = problems::profile_errors_of(design);
  problems::set_profile_errors(errors, options.profile);
  problems::check_profile_errors(errors);
  return errors;
}

/// How far the yield is; behind it the tolerances are widened until a limit is broken.
void show_yield(ProgressLine& line, double share) {
  if (share < 1) {
    line.show(fmt::format("yield: {:.0f} % of the parts", std::floor(100 * share)), share);
  } else {
    line.show("how far the tolerances may grow");
  }
}

int run_tolerance(const ToleranceCommand& options) {
  constexpr std::int64_t kMostSamples = 100'000'000;
  const auto ranks = ranks_of(options.executor, options.workers);
  if (has_served(ranks.get())) return kDone;
  const int workers = workers_of(options.workers);
  problems::ToleranceOptions wanted;
  if (options.samples) {
    wanted.samples = static_cast<std::size_t>(
        problems::parse_integer(*options.samples, 32, kMostSamples, "--samples"));
  }
  if (options.seed) {
    wanted.seed = static_cast<std::uint64_t>(
        problems::parse_integer(*options.seed, 0, std::int64_t{1} << 53, "--seed"));
  }
  const std::optional<double> limit = time_limit_of(options.limits);
  const auto path = study_file(options.db, {}, options.resume);
  const ProblemStatement design = problems::restated_design(design_of(options));
  const problems::ProfileErrors errors = profile_errors(options, design);
  ProgressLine line(!options.json);
  std::optional<problems::ProfileAnswer> profile;
  if (errors.any()) line.show("errors of the profile");
  if (errors.any()) profile = problems::profile_answer(design, errors);
  if (profile && !path && problems::asked_variations(design, options.tolerances).empty()) {
    line.clear();
    print(with_profile(design, *profile), options.json);
    return kDone;
  }
  const Interruptible interruptible;
  const optim::Deadline deadline(limit, interruptible.flag());
  const problems::VariedDesign varied = problems::varied_design(
      design, problems::asked_variations(design, options.tolerances), deadline);
  wanted.hands =
      hands_of(problems::tolerance_program(design, options.tolerances), workers, ranks.get());
  auto record = path ? record_of(path,
                                 problems::ToleranceStudy(design, options.tolerances,
                                                          wanted.samples, wanted.seed),
                                 options.resume)
                     : std::nullopt;
  if (record) wanted.hands = optim::recorded_hands(std::move(wanted.hands), *record);
  wanted.hands =
      optim::telling_hands(std::move(wanted.hands), [&, begun = false](double share) mutable {
        if (!begun) line.restart();
        begun = true;
        show_yield(line, share);
      });
  line.show("worst part of each limit");
  const problems::ToleranceAnswer answer = problems::tolerance_of(varied, wanted);
  line.clear();
  Document document = variation_document(varied, answer);
  if (profile) document = with_profile(design, *profile, std::move(document));
  print(document, options.json);
  if (path && !options.json && !is_quiet()) {
    say("study {}\n", *path);
    if (!answer.cut_short.empty()) say("--resume continues it\n");
  }
  return answer.cut_short.empty() ? kDone : kNotSolved;
}

}  // namespace

Command tolerance_command() {
  const auto options = std::make_shared<ToleranceCommand>();
  return {
      .name = "tolerance",
      .help =
          "Show what manufacturing tolerances do to a design: worst case, yield, how far they may "
          "grow",
      .options =
          {{.names = "FILE",
            .target = &options->file,
            .takes = takes::kFile,
            .help =
                "a problem file, a result, or with --point a study; its tables [variation.NAME] "
                "state the tolerances",
            .required = true},
           {"--point", &options->point, takes::kNumber,
            "the point with this number of a study's front"},
           {"--tolerance", &options->tolerances, takes::kSetting,
            "a tolerance to either side, name=value, in place of the file's variations"},
           set_option(options->settings),
           {"--waviness", &options->profile["waviness"], "LENGTH",
            "amplitude of the profile's waves, such as '2 um'; needs either --waves or "
            "--wavelength"},
           {"--waves", &options->profile["waves"], takes::kNumber, "number of waves in a turn"},
           {"--wavelength", &options->profile["wavelength"], "LENGTH",
            "length of a wave along the profile, such as '3 mm', in place of --waves"},
           {"--form", &options->profile["form"], "LENGTH",
            "width of the profile's tolerance zone (ISO 1101), such as '0.02 mm'"},
           {"--chord", &options->profile["chord"], "LENGTH",
            "the profile is cut as chords deviating by no more than this, such as '5 um'"},
           {"--chord-step", &options->profile["chord_step"], "ANGLE",
            "the profile is cut as chords of this cam angle, such as '0.5 deg', in place of "
            "--chord"},
           {"--loss", &options->profile["loss"], "SHARE",
            "find the tolerance the shop must hold if the peaks of acceleration, force and contact "
            "stress may grow by this share, such as '10 %'"},
           {"--samples", &options->samples, takes::kNumber,
            "number of parts from which the yield is estimated (100000; fewer if a limit needs "
            "a search for each part)"},
           {"--seed", &options->seed, takes::kNumber, "seed of the samples (1)"},
           workers_option(options->workers),
           executor_option(options->executor),
           {"--db", &options->db, takes::kFile,
            "record in this file which parts of the yield have been counted"},
           {"--resume", &options->resume, takes::kNothing,
            "resume the study of --db; damaged parts are counted again"},
           time_limit_option(options->limits, "what is known"),
           json_switch(options->json)},
      .examples =
          {{"camlaw tolerance problems/cams/tolerances.toml",
            "the worst case with its proof, and the yield"},
           {"camlaw tolerance problems/cams/roller_least_base.toml --tolerance "
            "base_radius='0.1 mm' --tolerance roller_radius='0.02 mm' --samples 10000",
            "the same for a file that states no variations"},
           {"camlaw tolerance problems/cams/roller_least_base.toml --waviness '2 um' "
            "--waves 40 --loss '10 %'",
            "what a wavy profile does, and which amplitude costs a tenth more acceleration, force "
            "and contact stress"},
           {"camlaw tolerance problems/cams/tolerances.toml --samples 50000000 --db "
            "results/yield.db",
            "with a record, from which --resume continues after an interruption"}},
      .run = [options] { return run_tolerance(*options); }};
}

}  // namespace camlaw::cli
