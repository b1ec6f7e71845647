// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/fit_program.h"
#include "cli/inputs.h"
#include "cli/progress_line.h"
#include "cli/run_limits.h"
#include "cli/watched_run.h"
#include "cli/workers.h"
#include "fitting/motions/law_fit_service.h"
#include "numerics/tables/assumed_units.h"
#include "output/answers/fit_output.h"
#include "output/answers/next_step.h"
#include "output/document/printing.h"
#include "problems/law_files/law_file.h"
#include "problems/statement/default_machine.h"

namespace camlaw::cli {
namespace {

struct FitCommand {
  std::optional<std::string> data, constants, law, mechanism, response, out, loss, workers;
  std::vector<std::string> set, shifts;
  RunLimits limits;
  std::optional<problems::LawFitOptions::Clock::time_point>
      deadline;  ///< of trying laws, or of the fit to a recorded curve
  bool json = false;
  std::function<void()> answers = [] {};  ///< called when the answer is about to be given
};

optim::Loss loss_of(const FitCommand& options) {
  const std::string name = options.loss.value_or("none");
  for (const auto& [known, loss] :
       {std::pair{"none", optim::Loss::None}, std::pair{"huber", optim::Loss::Huber},
        std::pair{"cauchy", optim::Loss::Cauchy}}) {
    if (name == known) return loss;
  }
  throw std::invalid_argument(
      fmt::format("--loss: '{}' is not a loss; use none, huber or cauchy", name));
}

/// The law of --law; none where every law is tried.
std::optional<Member> law_of(const FitCommand& options) {
  if (!options.law || *options.law == "auto") return {};
  return problems::find_any_law(*options.law);
}

std::vector<Member> laws_of(const FitCommand& options) {
  const auto law = law_of(options);
  return law ? std::vector{*law} : problems::laws_to_try();
}

optim::Crew crew_of(const FitCommand& options) {
  return optim::Crew(
      {.workers = workers_of(options.workers), .program = problems::law_fit_program()});
}

problems::LawFitOptions how_of(const FitCommand& options, ProgressLine& line, optim::Crew& crew) {
  problems::LawFitOptions how;
  how.crew = &crew;
  how.loss = loss_of(options);
  how.deadline = options.deadline;
  how.progress = [&line](double share) {
    line.show(fmt::format("{:.0f} % of the laws tried", std::floor(100 * share)), share);
  };
  return how;
}

problems::ProblemStatement machine_of(const FitCommand& options) {
  problems::ProblemStatement machine;
  try {
    machine = problems::asked_machine(*options.mechanism);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--mechanism: {}", error.what()));
  }
  problems::set_values(machine, options.set);
  keep_inputs(machine);
  return machine;
}

void fit_constants(const FitCommand& options) {
  for (const auto& [name, given] :
       {std::pair{"--loss", options.loss.has_value()}, std::pair{"--out", options.out.has_value()},
        std::pair{"--response", options.response.has_value()},
        std::pair{"--shift", !options.shifts.empty()},
        std::pair{"--workers", options.workers.has_value()},
        std::pair{"--set", !options.set.empty() && !options.mechanism}}) {
    if (!given) continue;
    throw std::invalid_argument(
        fmt::format("{} is for a table of samples, not for --constants", name));
  }
  problems::ConstantsQuestion question{
      options.mechanism ? machine_of(options) : problems::law_alone(), {}};
  question.constants = problems::parse_constants(*options.constants, *question.machine.mechanism);
  std::vector<problems::ConstantsFit> fits;
  if (const auto law = law_of(options)) {
    fits = problems::fit_constants(question, *law);
    if (fits.empty()) {
      throw std::invalid_argument(fmt::format(
          "--law {}: no coefficients were found with which this law has any of these constants",
          *options.law));
    }
  } else {
    fits = problems::rank_laws(question, problems::laws_to_try());
    if (fits.empty()) {
      throw std::invalid_argument(
          "--constants: no law of the catalogue reproduces them from fewer digits than were "
          "printed");
    }
  }
  options.answers();
  print(constants_document(fits), options.json);
}

std::filesystem::path in_out(const FitCommand& options, const char* file) {
  return std::filesystem::path(*options.out) / file;
}

/// Files that not every fit writes: what an earlier run left of them goes.
std::vector<std::filesystem::path> left_behind(const FitCommand& options) {
  return {in_out(options, "law.json"), in_out(options, "program.toml")};
}

/// Before the work is done for them, that these files and fit.json can be written.
void check_files(const FitCommand& options, const std::vector<const char*>& names) {
  if (!options.out) return;
  std::vector<std::filesystem::path> files{in_out(options, "fit.json")};
  for (const char* name : names) files.push_back(in_out(options, name));
  check_out(files, left_behind(options));
}

/// Prints an answer; of a folder the files that an earlier run left and this one has not go.
void give(const FitCommand& options, const Document& answer, std::vector<OutputFile> files) {
  options.answers();
  if (options.out) {
    files.push_back({in_out(options, "fit.json"), json_text(answer)});
  }
  print(answer, options.json);
  if (options.out) write_out(left_behind(options), files, !options.json);
}

void give_samples(const FitCommand& options, const SamplesAnswer& answer,
                  std::vector<OutputFile> files) {
  if (options.out) {
    files.push_back({in_out(options, "law.json"), samples_law(answer).dump(2) + "\n"});
    files.push_back({in_out(options, "fit.svg"), to_svg(samples_figure(answer))});
  }
  give(options, samples_document(answer), std::move(files));
}

bool shifts(const FitCommand& options, const char* what) {
  return std::find(options.shifts.begin(), options.shifts.end(), what) != options.shifts.end();
}

/// Of a motion and of a cam's profile the centre alone can be unknown.
void check_centre_alone(const FitCommand& options) {
  for (const char* other : {"abscissa", "place", "value"}) {
    if (!shifts(options, other)) continue;
    throw std::invalid_argument(
        fmt::format("--shift {} is for a recorded curve with --mechanism FILE; for a motion or a "
                    "cam's profile use --shift centre",
                    other));
  }
}

/// The command that shows what was written to --out: the program, or else the law.
void say_next_of(const FitCommand& options, bool has_program) {
  if (!options.out || options.json) return;
  say_next(has_program ? "evaluate " + shell_word(in_out(options, "program.toml").string())
                       : "law " + shell_word(in_out(options, "law.json").string()));
}

/// A motion; of a lift `machine` is that of its program, null where none was stated.
void fit_samples(const FitCommand& options, const problems::SampleTable& table,
                 const problems::ProblemStatement* machine) {
  if (machine == nullptr && (options.response || !options.set.empty())) {
    throw std::invalid_argument(
        "--response and --set need --mechanism, the problem file or the name of the machine");
  }
  check_centre_alone(options);
  if (problems::goes_round(table)) {
    throw std::invalid_argument(
        "x and y go round as on a cam's profile: state its follower, --mechanism FILE, and the "
        "unit, 'x [mm]'");
  }
  problems::MotionRecord record = problems::motion_record(table);
  check_files(options, {"fit.svg", "law.json", "program.toml"});
  ProgressLine line(!options.json);
  optim::Crew crew = crew_of(options);
  const problems::MotionSamples& read = record.samples;
  SamplesAnswer answer{*options.data, read.lacking, read.each, read.left_out, {}, record.notes};
  answer.fit =
      problems::fit_recorded_motion(std::move(record), laws_of(options),
                                    {how_of(options, line, crew), shifts(options, "centre")});
  line.clear();
  std::vector<OutputFile> files;
  const auto program = program_of_lift(*answer.motion(), machine, options.out, answer.notes);
  if (program) files = program_files(*options.out, *options.data, *program);
  give_samples(options, answer, std::move(files));
  say_next_of(options, program.has_value());
}

void fit_cam(const FitCommand& options, problems::SampleTable table) {
  check_centre_alone(options);
  if (!options.mechanism) {
    throw std::invalid_argument(fmt::format(
        "this is a cam's profile, and its follower must be stated: --mechanism FILE, or one of {}",
        fmt::join(problems::measured_cams(), ", ")));
  }
  const problems::ProblemStatement machine = machine_of(options);
  check_files(options, {"fit.svg", "law.json", "program.toml"});
  std::vector<std::string> notes = problems::assume_profile_units(table);
  ProgressLine line(!options.json);
  const auto laws = laws_of(options);
  optim::Crew crew = crew_of(options);
  const auto how = how_of(options, line, crew);
  problems::CamFit fit = shifts(options, "centre")
                             ? problems::fit_centred_cam(table, machine, laws, how)
                             : problems::fit_cam(problems::measured_cam(table, machine), laws, how);
  const std::size_t lacking = fit.cam.lacking, each = fit.cam.each, outliers = fit.cam.left_out;
  const SamplesAnswer answer{*options.data, lacking,        each,
                             outliers,      std::move(fit), std::move(notes)};
  line.clear();
  std::vector<OutputFile> files;
  if (options.out) {
    files =
        program_files(*options.out, *options.data, problems::found_program(*answer.cam(), machine));
  }
  give_samples(options, answer, std::move(files));
  say_next_of(options, true);
}

void fit_recorded(const FitCommand& options, const problems::SampleTable& table,
                  const problems::ProblemStatement& machine) {
  if (options.law) {
    throw std::invalid_argument(
        "--law is for a motion or a cam's profile; the law of a recorded curve is the machine's "
        "own");
  }
  if (shifts(options, "centre")) {
    throw std::invalid_argument(
        "--shift centre is for a motion or a cam's profile; for a recorded curve use --shift "
        "place,value");
  }
  check_files(options, {"fit.svg"});
  problems::RecordedCurve record =
      problems::recorded_curve(table, *machine.mechanism, options.response);
  problems::RecordFitOptions how;
  how.loss = loss_of(options);
  how.place_shift = shifts(options, "abscissa") || shifts(options, "place");
  how.value_shift = shifts(options, "value");
  if (options.deadline) {
    const std::chrono::duration<double> left =
        *options.deadline - problems::LawFitOptions::Clock::now();
    how.time_limit = time_limit_of(options.limits);  // which the answer names
    how.time_spent = *how.time_limit - left.count();
  }
  const problems::RecordFit fit = problems::fit_record(machine, record, how);
  const RecordAnswer answer{*options.mechanism, record.lacking, std::move(record), fit};
  std::vector<OutputFile> files;
  if (options.out) files.push_back({in_out(options, "fit.svg"), to_svg(record_figure(answer))});
  give(options, record_document(answer), std::move(files));
  if (!options.json) say_next(record_evaluation(answer, options.set));
}

/// What a table is of: a cam's profile, a curve of a machine, or else a motion.
void fit_table(const FitCommand& options) {
  loss_of(options), laws_of(options), workers_of(options.workers);  // wrong options before any work
  keep_input(*options.data);
  options.law ? keep_law(*options.law) : keep_own_laws();
  const problems::SampleTable table = problems::read_samples(*options.data);
  try {
    const bool is_profile =
        problems::shows_profile(table) || (options.mechanism && problems::goes_round(table));
    if (!options.response && is_profile) return fit_cam(options, table);
    if (!options.mechanism) return fit_samples(options, table, nullptr);
    const problems::ProblemStatement machine = machine_of(options);
    const bool is_lift = !options.response && problems::has_lift(table) &&
                         !problems::has_recorded_curve(table, *machine.mechanism);
    is_lift ? fit_samples(options, table, &machine) : fit_recorded(options, table, machine);
  } catch (const RefusedOutput&) {
    throw;  // it is no fault of the table
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.starts_with(*options.data)) throw;
    throw std::invalid_argument(fmt::format("{}: {}", *options.data, what));
  }
}

int run_fit(const FitCommand& options) {
  if (options.constants.has_value() == options.data.has_value()) {
    throw std::invalid_argument(
        "fit: give either a table of samples or printed constants, --constants "
        "\"C_v=1.6125,C_a=4.66\"");
  }
  check_folder(options.out);
  const auto work = [](const FitCommand& own) {
    own.data ? fit_table(own) : fit_constants(own);
    return int{kDone};
  };
  const auto limit = time_limit_of(options.limits);
  if (!limit) return work(options);
  constexpr double kTrying = 0.6;  // of the time: intervals and drawings take the rest
  using Clock = problems::LawFitOptions::Clock;
  const auto began = Clock::now();
  constexpr double kOfLate = 0.45;  // of what it may be late: as much again to be ended in
  const double grace = options.data ? kOfLate * most_late(*limit) : Watch().grace;
  const auto ended = watched({.limit = limit, .grace = grace}, [&](const ChildTeller& teller) {
    FitCommand own = options;
    own.deadline = began + std::chrono::duration_cast<Clock::duration>(
                               std::chrono::duration<double>(kTrying * *limit));
    own.answers = [&teller] { teller.answers(); };
    return work(own);
  });
  if (const auto* unfinished = std::get_if<Unfinished>(&ended)) {
    throw NotSolved(unfinished->why + "; the fit has no answer yet");
  }
  return std::get<int>(ended);
}

}  // namespace

Command fit_command() {
  const auto options = std::make_shared<FitCommand>();
  return {
      .name = "fit",
      .help = "Find the law behind measured samples or printed constants",
      .options =
          {{"DATA", &options->data, takes::kFile,
            "table with a header: \"angle [deg], lift [mm]\" of a motion, \"angle [deg], radius "
            "[mm]\" or \"x [mm], y [mm]\" of a cam, or a machine's curve, such as \"angle [deg], "
            "drive_torque [N m]\""},
           {"--constants", &options->constants, "NAME=VALUE,...",
            "the printed constants, with all their digits: \"C_v=1.6125, C_a=4.66\""},
           {"--law", &options->law, takes::kLaw, "the law to fit; auto tries every law"},
           {"--mechanism", &options->mechanism, takes::kMechanism,
            "a problem file or a mechanism's name: the follower of a measured cam, the machine "
            "that a "
            "lift is for, or the machine whose curve was recorded, with the unknown variables"},
           {"--set", &options->set, takes::kSetting,
            "a value of the machine, such as 'mass=1.2 kg'"},
           {"--response", &options->response, "NAME",
            "the recorded curve, if several columns could be it"},
           {.names = "--shift",
            .target = &options->shifts,
            .takes = "{centre,abscissa,value}",
            .help = "what else is unknown and fitted too, separated by commas: centre (of a motion "
                    "or a cam's profile), the zeros of abscissa and value (of a machine's curve)",
            .words = {"centre", "abscissa", "value", "place"}},
           {"--loss", &options->loss, "{none,huber,cauchy}",
            "how the weight of outliers is limited: none (not at all), huber or cauchy"},
           workers_option(options->workers),
           time_limit_option(options->limits, "what is known"),
           json_switch(options->json),
           {"-o,--out", &options->out, takes::kFolder,
            "folder for fit.json, fit.svg, law.json (the law's own file) and program.toml (of a "
            "cam)"}},
      .examples = {{"camlaw fit problems/cams/worn_cam.csv --mechanism disc-cam-roller "
                    "--set 'roller_radius=8 mm' --out results/worn",
                    "the motion program behind a worn cam, dwells and laws, as files"},
                   {"camlaw fit problems/cams/recorded_torque.csv --mechanism "
                    "problems/cams/recorded_torque.toml",
                    "a machine's unknown sizes, from the torque that was recorded"},
                   {"camlaw fit --constants \"C_v=1.6125, C_a=4.66\" --law polynomial-5",
                    "the coefficient behind printed constants"}},
      .run = [options] { return run_fit(*options); }};
}

}  // namespace camlaw::cli
