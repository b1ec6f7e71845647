// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <variant>

#include "fitting/cams/found_program.h"
#include "fitting/motions/law_fit_service.h"
#include "numerics/tables/assumed_units.h"
#include "numerics/tables/cells.h"
#include "output/answers/fit_output.h"
#include "output/document/printing.h"
#include "output/report/html.h"
#include "problems/law_files/law_file.h"
#include "problems/statement/default_machine.h"
#include "python/bindings/laws.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

/// Laws and machines behind tables, as 'camlaw fit' finds them.
namespace camlaw::python {
namespace {

using Column = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using problems::SampleTable;

/// One in the last digit that half of the numbers have, written as short as they come back.
double last_digit_of(const std::vector<double>& values) {
  std::map<int, std::size_t> count;
  std::size_t all = 0, so_far = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++count[problems::decimals_of(fmt::format("{}", value))];
    ++all;
  }
  for (const auto& [decimals, many] : count) {
    so_far += many;
    if (2 * so_far >= all) return std::pow(10.0, -decimals);
  }
  return 0;
}

SampleTable table_of(const std::string& source,
                     const std::vector<std::pair<std::string, std::string>>& names,
                     const std::vector<Column>& columns) {
  SampleTable table;
  table.source = source;
  constexpr std::size_t kFewest = 2;
  if (columns.size() < kFewest || columns.front().shape(0) < kFewest) {
    throw std::invalid_argument(source + ": a table needs at least two columns and two rows");
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Column& column = columns[k];
    std::vector<double> values(column.data(), column.data() + column.shape(0));
    for (double& value : values) {
      if (!std::isfinite(value)) value = std::nan("");
    }
    if (values.size() != columns.front().shape(0)) {
      throw std::invalid_argument(fmt::format("{}: {} has {} rows, but {} has {}", source,
                                              names[k].first, values.size(), names.front().first,
                                              columns.front().shape(0)));
    }
    const double digit = last_digit_of(values);
    table.columns.push_back({.name = names[k].first,
                             .unit = names[k].second,
                             .values = std::move(values),
                             .last_digit = digit});
  }
  return table;
}

/// What is asked of a table.
struct FitQuestion {
  std::optional<std::string> law, response;
  std::optional<problems::ProblemStatement> machine;
  optim::Loss loss = optim::Loss::None;
  bool centre = false, place = false, value = false;
  std::optional<double> time_limit;  ///< seconds
  int workers = 1;
};

/// A fit, whatever it is of.
struct FoundFit {
  std::variant<cli::SamplesAnswer, cli::RecordAnswer, std::vector<problems::ConstantsFit>> answer;
  std::optional<problems::ProblemStatement> machine = {};

  cli::Document document() const {
    return std::visit(
        [](const auto& is) {
          using Is = std::decay_t<decltype(is)>;
          if constexpr (std::is_same_v<Is, cli::SamplesAnswer>) return samples_document(is);
          if constexpr (std::is_same_v<Is, cli::RecordAnswer>) return record_document(is);
          if constexpr (std::is_same_v<Is, std::vector<problems::ConstantsFit>>) {
            return cli::constants_document(is);
          }
        },
        answer);
  }
  const cli::SamplesAnswer* samples() const { return std::get_if<cli::SamplesAnswer>(&answer); }
  const cli::RecordAnswer* record() const { return std::get_if<cli::RecordAnswer>(&answer); }
};

std::vector<Member> laws_of(const FitQuestion& asked) {
  if (!asked.law || *asked.law == "auto") return problems::laws_to_try();
  return {problems::find_any_law(*asked.law)};
}

optim::Crew crew_of(const FitQuestion& asked) {
  return optim::Crew({.workers = asked.workers, .program = problems::law_fit_program()});
}

problems::LawFitOptions options_of(const FitQuestion& asked, Work& work, optim::Crew& crew) {
  problems::LawFitOptions how;
  how.crew = &crew;
  how.loss = asked.loss;
  how.stop = work.stop();
  how.progress = [&work](double share) { work.tell(share, "fitting laws"); };
  if (asked.time_limit) {
    constexpr double kTrying = 0.6;  // of the time: intervals take the rest
    how.deadline = problems::LawFitOptions::Clock::now() +
                   std::chrono::duration_cast<problems::LawFitOptions::Clock::duration>(
                       std::chrono::duration<double>(kTrying * *asked.time_limit));
  }
  return how;
}

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

FoundFit fitted_motion(const FitQuestion& asked, const SampleTable& table, Work& work) {
  if (asked.response)
    refuse("response: it names a recorded curve of a machine; give mechanism too");
  if (asked.place || asked.value) {
    refuse("shift: a motion or a cam's profile accepts centre alone");
  }
  if (problems::goes_round(table)) {
    refuse(
        "x and y go round as on a cam's profile: give mechanism, which says what runs on it, and "
        "the unit, 'x [mm]'");
  }
  problems::MotionRecord record = problems::motion_record(table);
  const problems::MotionSamples& read = record.samples;
  cli::SamplesAnswer answer{table.source, read.lacking, read.each, read.left_out, {}, record.notes};
  optim::Crew crew = crew_of(asked);
  answer.fit = problems::fit_recorded_motion(std::move(record), laws_of(asked),
                                             {options_of(asked, work, crew), asked.centre});
  return {std::move(answer)};
}

FoundFit fitted_cam(const FitQuestion& asked, SampleTable table, Work& work) {
  if (asked.place || asked.value) {
    refuse("shift: a motion or a cam's profile accepts centre alone");
  }
  if (!asked.machine) {
    refuse(
        fmt::format("the table is a cam's profile: give mechanism, which says what runs on it, a "
                    "problem or one of {}",
                    fmt::join(problems::measured_cams(), ", ")));
  }
  std::vector<std::string> notes = problems::assume_profile_units(table);
  const auto laws = laws_of(asked);
  optim::Crew crew = crew_of(asked);
  const auto how = options_of(asked, work, crew);
  problems::CamFit fit =
      asked.centre ? problems::fit_centred_cam(table, *asked.machine, laws, how)
                   : problems::fit_cam(problems::measured_cam(table, *asked.machine), laws, how);
  const std::size_t lacking = fit.cam.lacking, each = fit.cam.each, far_rows = fit.cam.left_out;
  return {
      cli::SamplesAnswer{table.source, lacking, each, far_rows, std::move(fit), std::move(notes)},
      asked.machine};
}

FoundFit fitted_record(const FitQuestion& asked, const SampleTable& table, const Work& work) {
  if (asked.law) {
    refuse(
        "law: a recorded curve does not take it, as the law is the machine's own; a motion or a "
        "cam's profile does");
  }
  if (asked.centre) {
    refuse(
        "shift: a recorded curve accepts abscissa and value, whose zeros may be unknown, but not "
        "centre");
  }
  problems::RecordedCurve record =
      problems::recorded_curve(table, *asked.machine->mechanism, asked.response);
  const problems::RecordFitOptions how{.loss = asked.loss,
                                       .place_shift = asked.place,
                                       .value_shift = asked.value,
                                       .time_limit = asked.time_limit,
                                       .stop = work.stop()};
  problems::RecordFit fit = problems::fit_record(*asked.machine, record, how);
  const std::size_t lacking = record.lacking;
  return {cli::RecordAnswer{asked.machine->source, lacking, std::move(record), std::move(fit)},
          asked.machine};
}

/// What a table is of: a cam's profile, a curve of a machine, or else a motion.
FoundFit fitted(const FitQuestion& asked, const SampleTable& table, Work& work) {
  try {
    const bool is_profile =
        problems::shows_profile(table) || (asked.machine && problems::goes_round(table));
    if (!asked.response && is_profile) return fitted_cam(asked, table, work);
    return asked.machine ? fitted_record(asked, table, work) : fitted_motion(asked, table, work);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.starts_with(table.source)) throw;
    refuse(fmt::format("{}: {}", table.source, what));
  }
}

optim::Loss loss_of(const std::string& name) {
  for (const auto& [known, loss] :
       {std::pair{"none", optim::Loss::None}, std::pair{"huber", optim::Loss::Huber},
        std::pair{"cauchy", optim::Loss::Cauchy}}) {
    if (name == known) return loss;
  }
  refuse(fmt::format("loss: '{}' is not a loss; none, huber and cauchy are accepted", name));
}

FitQuestion question_of(std::optional<std::string> law, const StatedProblem* machine,
                        std::optional<std::string> response, const std::vector<std::string>& shift,
                        const std::string& loss, std::optional<double> time_limit,
                        std::optional<int> workers) {
  FitQuestion asked;
  asked.law = std::move(law);
  asked.response = std::move(response);
  if (machine != nullptr) asked.machine = machine->statement;
  asked.loss = loss_of(loss);
  for (const std::string& what : shift) {
    bool* const known = what == "centre"                        ? &asked.centre
                        : what == "abscissa" || what == "place" ? &asked.place
                        : what == "value"                       ? &asked.value
                                                                : nullptr;
    if (known == nullptr) {
      refuse(fmt::format("shift: '{}' is not accepted; centre, abscissa and value are", what));
    }
    *known = true;
  }
  if (time_limit && !(*time_limit > 0)) {
    refuse(fmt::format("time_limit: {} s is not above zero", *time_limit));
  }
  asked.time_limit = time_limit;
  asked.workers = workers_of(workers);
  return asked;
}

nb::tuple fit_table(const SampleTable& table, const FitQuestion& asked, nb::handle progress) {
  std::optional<FoundFit> result;
  const bool interrupted = run_beside(
      [&](Work& work) {
        try {
          result = fitted(asked, table, work);
        } catch (const optim::Interrupted&) {
          if (!work.is_stopped()) throw;
        }
      },
      progress);
  if (!result) return nb::make_tuple(nb::none(), true);
  return nb::make_tuple(std::move(*result), interrupted);
}

FoundFit constants_fitted(const std::string& constants, const StatedProblem* machine,
                          const std::optional<std::string>& law, const Work& work) {
  problems::ConstantsQuestion question{
      machine != nullptr ? machine->within(work) : problems::law_alone(), {}};
  question.machine.stop = work.stop();
  question.constants = problems::parse_constants(constants, *question.machine.mechanism);
  std::vector<problems::ConstantsFit> fits;
  if (law && *law != "auto") {
    fits = problems::fit_constants(question, problems::find_any_law(*law));
    if (fits.empty()) {
      refuse(fmt::format(
          "law {}: no coefficients were found with which it has any of these constants", *law));
    }
  } else {
    fits = problems::rank_laws(question, problems::laws_to_try());
    if (fits.empty()) {
      refuse("constants: no law of the catalogue gives them from fewer digits than were printed");
    }
  }
  return {std::move(fits)};
}

FoundFit fit_constants(const std::string& constants, const StatedProblem* machine,
                       const std::optional<std::string>& law) {
  return run_whole(
      [&](const Work& work) { return constants_fitted(constants, machine, law, work); });
}

/// The law of the largest motion; of a recorded curve the machine's own; of printed constants that
/// which explains them best, with the simplest coefficients.
std::optional<MemberLaw> law_of(const FoundFit& fit) {
  if (const auto* printed = std::get_if<std::vector<problems::ConstantsFit>>(&fit.answer)) {
    return MemberLaw(printed->front().law);
  }
  if (const auto* samples = fit.samples()) {
    return MemberLaw(problems::read_law_text(cli::samples_law(*samples).dump(), "fitted law"));
  }
  if (const auto* record = fit.record()) {
    if (record->fit.machine.laws.empty()) return std::nullopt;
    return MemberLaw(record->fit.machine.laws.front());
  }
  return std::nullopt;
}

/// The named law with its fitted coefficients, where a law was named.
std::optional<MemberLaw> named_law_of(const FoundFit& fit) {
  const auto* samples = fit.samples();
  if (samples == nullptr) return law_of(fit);
  const auto& fits = samples->cycle().fits;
  const auto largest = std::max_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
    return std::abs(a.best().to - a.best().from) < std::abs(b.best().to - b.best().from);
  });
  if (largest->smooth) return law_of(fit);
  return MemberLaw(largest->best().law);
}

std::optional<StatedProblem> machine_of(const FoundFit& fit) {
  if (const auto* record = fit.record()) return StatedProblem{record->fit.machine};
  return std::nullopt;
}

/// The motion program of a measured cam: the text of a problem file, and the law files that it
/// needs by name.
nb::object program_of(const FoundFit& fit) {
  const auto* samples = fit.samples();
  if (samples == nullptr || samples->cam() == nullptr) return nb::none();
  const problems::FoundProgram program =
      without_lock([&] { return problems::found_program(*samples->cam(), *fit.machine); });
  nb::dict files;
  for (const problems::ProgramLaw& law : program.laws) {
    const problems::Json provenance{{"fitted_to", samples->source}, {"law", "smoothing spline"}};
    files[nb::cast(law.name)] = problems::law_text(law.law, law.title, provenance.dump());
  }
  return nb::make_tuple(program.problem, files);
}

cli::Figure figure_of(const FoundFit& fit) {
  if (const auto* samples = fit.samples()) return cli::samples_figure(*samples);
  if (const auto* record = fit.record()) return cli::record_figure(*record);
  refuse("a fit to printed constants has no figure");
}

}  // namespace

void add_fits(nb::module_& module) {
  nb::class_<SampleTable>(module, "SampleTable");
  module.def("sample_table", &table_of, nb::arg("source"), nb::arg("names"), nb::arg("columns"));
  module.def(
      "sample_file",
      [](const std::string& path) {
        return without_lock([&] { return problems::read_samples(path); });
      },
      nb::arg("path"));
  nb::class_<FoundFit>(module, "Fit")
      .def("facts",
           [](const FoundFit& f) {
             return python_of(cli::json_of(without_lock([&] { return f.document(); })));
           })
      .def("json_text", [](const FoundFit& f) { return cli::json_text(f.document()); })
      .def("text", [](const FoundFit& f) { return cli::unshaded(cli::text_of(f.document())); })
      .def("html", [](const FoundFit& f) { return cli::html_of(f.document()); })
      .def("law", &named_law_of)
      .def("law_text",
           [](const FoundFit& f) -> std::optional<std::string> {
             if (f.samples() == nullptr) return std::nullopt;
             return cli::samples_law(*f.samples()).dump(2) + "\n";
           })
      .def("machine", &machine_of)
      .def("program", &program_of)
      .def("figure",
           [](const FoundFit& f) { return dict_of(without_lock([&] { return figure_of(f); })); });
  module.def(
      "fit",
      [](const SampleTable& table, std::optional<std::string> law, const StatedProblem* machine,
         std::optional<std::string> response, const std::vector<std::string>& shift,
         const std::string& loss, std::optional<double> time_limit, std::optional<int> workers,
         nb::handle progress) {
        return fit_table(table,
                         question_of(std::move(law), machine, std::move(response), shift, loss,
                                     time_limit, workers),
                         progress);
      },
      nb::arg("table"), nb::arg("law").none(), nb::arg("machine").none(),
      nb::arg("response").none(), nb::arg("shift"), nb::arg("loss"), nb::arg("time_limit").none(),
      nb::arg("workers").none(), nb::arg("progress").none());
  module.def("fit_constants", &fit_constants, nb::arg("constants"), nb::arg("machine").none(),
             nb::arg("law").none());
  module.def(
      "machine",
      [](const std::string& name) { return StatedProblem{problems::asked_machine(name)}; },
      nb::arg("name"));
}

}  // namespace camlaw::python
