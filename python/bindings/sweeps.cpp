// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "output/answers/sweep_answer.h"
#include "output/document/printing.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/fronts/stored_front.h"
#include "problems/sweeps/sweep_worker.h"
#include "python/bindings/executors.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

/// Sweeps: a problem with each combination of some settings.
namespace camlaw::python {
namespace {

namespace fs = std::filesystem;
using problems::SweepStudy;

struct FoundSweep {
  SweepStudy study;
  problems::Sweep sweep = {};
  std::vector<std::string> notes = {};

  cli::SweepAnswer answer() const {
    cli::SweepAnswer result(study, sweep);
    result.notes = notes;
    return result;
  }
};
using SweepOwner = std::unique_ptr<FoundSweep>;

/// What is swept, as `--set`, `--sample` and `--over` say it.
struct SweepWords {
  std::vector<std::string> set, over;
  std::optional<std::string> sample;
  std::int64_t seed = 1;
  bool evaluates = false, is_cold = false;
};

problems::SweepSettings settings_of(const SweepWords& words,
                                    const std::vector<std::string>& set_before) {
  problems::SweepSettings settings{.evaluates = words.evaluates, .is_cold = words.is_cold};
  settings.set = set_before;
  problems::add_settings(settings, words.set);
  if (words.sample) {
    settings.sampling = problems::stated_sampling(
        *words.sample, static_cast<std::uint64_t>(words.seed), words.over);
  } else if (!words.over.empty()) {
    throw std::invalid_argument(
        "over: it is a range that samples are drawn from; say how many, sample=\"sobol 64\"");
  }
  return settings;
}

void search(FoundSweep& found, const Labour& labour, const std::string& path, bool resume,
            Work& work) {
  SweepStudy& study = found.study;
  study.options().stop = work.stop();
  const auto show = [&work](const problems::SweepProgress& p) {
    work.tell(static_cast<double>(p.done) / static_cast<double>(p.all),
              fmt::format("{} of {} combinations", p.done, p.all));
  };
  auto record = record_of(path, study, resume);
  const auto workers = executor_of(labour, problems::sweep_service(study),
                                   problems::worker_program(study), study.options());
  if (!record) {
    found.sweep = study.run(*workers, show);
  } else {
    optim::RecordedExecutor recorded(
        [&](std::size_t part, optim::Design x) { return study.problem(part, x); }, *record,
        workers.get());
    found.sweep = study.run(recorded, show);
    for (const optim::RecordFault& fault : recorded.faults()) {
      found.notes.push_back(problems::fault_words(fault, "it was solved again"));
    }
  }
  if (!found.sweep.remark.empty()) found.notes.push_back(found.sweep.remark);
  study.options().stop = nullptr;
}

nb::tuple sweep(const StatedProblem& problem, const std::vector<std::string>& set,
                std::optional<std::string> sample, std::int64_t seed,
                const std::vector<std::string>& over, bool evaluates, bool is_cold,
                std::optional<int> workers, nb::handle carrier, const std::string& record,
                bool resume, std::optional<double> time_limit, nb::handle progress) {
  const Labour labour{workers_of(workers), carrier};
  if (resume && record.empty()) throw std::invalid_argument("resume: name the record");
  const problems::ProblemStatement& statement = problem.statement;
  const SweepWords words{set, over, std::move(sample), seed, evaluates, is_cold};
  SweepOwner found(new FoundSweep{SweepStudy(
      statement.text, statement.source, settings_of(words, statement.settings), statement.files)});
  const bool interrupted = run_beside(
      [&](Work& work) { search(*found, labour, record, resume, work); }, progress, time_limit);
  return nb::make_tuple(std::move(found), interrupted);
}

/// The design of a combination as a problem, counted from 0.
StatedProblem design_of(const FoundSweep& found, std::size_t k) {
  const auto& outcomes = found.sweep.outcomes;
  if (k >= outcomes.size()) {
    throw std::invalid_argument(
        fmt::format("combination {}: there are {}, counted from 0", k, outcomes.size()));
  }
  const auto& outcome = outcomes[k];
  if (!outcome || outcome->points.empty()) {
    throw std::invalid_argument(
        fmt::format("combination {} has no design: {}", k, found.answer().rows[k].verdict));
  }
  return {found.study.design(k, outcome->points.front().x)};
}

}  // namespace

void add_sweeps(nb::module_& module) {
  nb::class_<FoundSweep>(module, "Sweep")
      .def("facts",
           [](const FoundSweep& f) {
             return python_of(cli::json_of(cli::sweep_document(f.answer())));
           })
      .def("text",
           [](const FoundSweep& f) {
             return cli::unshaded(cli::text_of(cli::sweep_document(f.answer())));
           })
      .def("html",
           [](const FoundSweep& f) { return cli::html_of(cli::sweep_document(f.answer())); })
      .def("csv",
           [](const FoundSweep& f) { return cli::csv_of(cli::combinations_table(f.answer())); })
      .def("report",
           [](const FoundSweep& f, const std::string& name) {
             return cli::page_html(cli::sweep_report(f.answer(), name));
           })
      .def("design", &design_of, nb::arg("combination"));
  module.def("sweep", &sweep, nb::arg("problem"), nb::arg("set"), nb::arg("sample").none(),
             nb::arg("seed"), nb::arg("over"), nb::arg("evaluates"), nb::arg("is_cold"),
             nb::arg("workers").none(), nb::arg("carrier").none(), nb::arg("record"),
             nb::arg("resume"), nb::arg("time_limit").none(), nb::arg("progress").none());
}

}  // namespace camlaw::python
