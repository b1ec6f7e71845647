// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "optim/search/free_memory.h"
#include "optim/study/encoding.h"
#include "output/answers/sweep_answer.h"
#include "output/document/printing.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/stored_front.h"
#include "problems/results/input_files.h"
#include "problems/results/start_settings.h"
#include "problems/statement/parameters.h"
#include "problems/sweeps/stored_sweep.h"
#include "problems/sweeps/sweep_worker.h"
#include "python/bindings/executors.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

/// Sweeps: a problem with each combination of some settings.
namespace camlaw::python {
namespace {

using problems::SweepStudy;

struct FoundSweep {
  explicit FoundSweep(SweepStudy of, problems::SweptCombinations found = {},
                      std::vector<std::string> remarks = {})
      : study(std::move(of)), sweep(std::move(found)), notes(std::move(remarks)) {}

  SweepStudy study;
  problems::SweptCombinations sweep;
  std::vector<std::string> notes;

  /// Worked out once, which takes a second where there are some thousand combinations.
  const cli::SweepAnswer& answer() const {
    const std::lock_guard lock(*mutex_);
    if (!answer_) {
      answer_ = std::make_shared<cli::SweepAnswer>(study, sweep);
      answer_->notes.insert(answer_->notes.end(), notes.begin(), notes.end());
    }
    return *answer_;
  }

 private:
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  mutable std::shared_ptr<cli::SweepAnswer> answer_ = nullptr;
};
using SweepOwner = std::unique_ptr<FoundSweep>;

/// What is swept, as `--set`, `--sample` and `--over` say it.
struct SweepWords {
  std::vector<std::string> set, over;
  std::optional<std::string> sample;
  std::int64_t seed = 1;
  bool evaluates = false, is_cold = false;
};

problems::SweepSettings asked_settings(const SweepWords& words,
                                       const std::vector<std::string>& set_before) {
  problems::SweepSettings settings{.evaluates = words.evaluates, .is_cold = words.is_cold};
  settings.set = set_before;
  problems::add_settings(settings, words.set);
  if (words.sample) {
    settings.sampling = problems::stated_sampling(
        *words.sample, static_cast<std::uint64_t>(words.seed), words.over);
  } else if (!words.over.empty()) {
    throw std::invalid_argument(
        "over: samples are drawn from these ranges; say how many, such as sample=\"sobol 64\"");
  }
  problems::check_set_or_swept(settings, words.set);
  return settings;
}

void search(FoundSweep& found, const Labour& labour, const std::string& path, bool resume,
            Work& work) {
  SweepStudy& study = found.study;
  study.options().stop = work.stop();
  const std::string unit = study.statement().objectives.front().response.unit;
  const auto show = [&work, &unit](const problems::SweepProgress& p) {
    std::string words = fmt::format("{} of {} combinations", p.done, p.all);
    if (p.best) words += ", best " + problems::with_unit(*p.best, unit);
    work.tell(static_cast<double>(p.done) / static_cast<double>(p.all), std::move(words));
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
    found.notes = problems::fault_notes(recorded.faults(), "it was solved again");
  }
  if (!found.sweep.remark.empty()) found.notes.push_back(found.sweep.remark);
  study.options().stop = nullptr;
}

nb::tuple sweep(const StatedProblem& problem, const std::vector<std::string>& set,
                std::optional<std::string> sample, std::int64_t seed,
                const std::vector<std::string>& over, bool evaluates, bool is_cold,
                std::optional<int> workers, nb::handle carrier, const std::string& record,
                bool resume, std::optional<double> time_limit, std::optional<double> memory,
                nb::handle progress) {
  const Labour labour{workers_of(workers), carrier};
  check_resume(resume, record);
  const problems::ProblemStatement& statement = problem.statement;
  const SweepWords words{set, over, std::move(sample), seed, evaluates, is_cold};
  SweepOwner found(new FoundSweep{
      SweepStudy(statement.text, statement.source,
                 asked_settings(words, problems::restated_settings(statement)), statement.files)});
  found->study.options().memory = memory.value_or(optim::free_memory());
  const bool interrupted = run_beside(
      [&](Work& work) { search(*found, labour, record, resume, work); }, progress, time_limit);
  return nb::make_tuple(std::move(found), interrupted);
}

/// The design of a combination as a problem, counted from 0.
StatedProblem swept_design_of(const FoundSweep& found, std::size_t k) {
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

/// The sweep that a record holds, without a search.
SweepOwner sweep_file(const std::string& path) {
  return run_whole([&](const Work& work) {
    optim::StudyRecord record = optim::StudyRecord::read(path);
    if (!SweepStudy::is_sweep(record.settings())) {
      const std::string_view kind = problems::kind_of_study(record.settings());
      throw std::invalid_argument(
          fmt::format("{}: the study is {}, not a sweep; {} reads it", path, kind,
                      kind == "a front" ? "Front.load" : "tolerance with resume"));
    }
    SweepOwner found(new FoundSweep{SweepStudy::of(record.settings())});
    found->study.options().stop = work.stop();
    problems::StoredSweep stored = problems::stored_sweep(found->study, record);
    found->study.options().stop = nullptr;
    found->sweep = std::move(stored.sweep);
    found->notes = std::move(stored.notes);
    return found;
  });
}

/// What a sweep is pickled as: its study as a record keeps it, what came of each combination as
/// processes tell each other, whether each began at a neighbour's design, remark and notes.
using SweepState =
    std::tuple<std::map<std::string, std::string>, std::vector<std::optional<nb::bytes>>,
               std::vector<bool>, std::string, std::vector<std::string>>;

SweepState sweep_state_of(const FoundSweep& found) {
  std::vector<std::optional<nb::bytes>> outcomes;
  for (const auto& outcome : found.sweep.outcomes) {
    outcomes.emplace_back();
    if (!outcome) continue;
    const std::string bytes = optim::encoded(*outcome);
    outcomes.back() = nb::bytes(bytes.data(), bytes.size());
  }
  return {found.study.settings(), std::move(outcomes), found.sweep.is_warm, found.sweep.remark,
          found.notes};
}

FoundSweep sweep_from(const SweepState& state) {
  const auto& [settings, outcomes, is_warm, remark, notes] = state;
  FoundSweep found{without_lock([&] { return SweepStudy::of(settings); }),
                   {.outcomes = {}, .is_warm = is_warm, .remark = remark},
                   notes};
  for (const auto& bytes : outcomes) {
    found.sweep.outcomes.emplace_back();
    if (!bytes) continue;
    found.sweep.outcomes.back() = optim::decoded({bytes->c_str(), bytes->size()});
    if (!found.sweep.outcomes.back()) {
      throw std::invalid_argument("the pickled sweep is damaged, or of another version of camlaw");
    }
  }
  return found;
}

}  // namespace

void add_sweeps(nb::module_& module) {
  nb::class_<FoundSweep>(module, "Sweep")
      .def("facts",
           [](const FoundSweep& f) {
             return python_of(
                 without_lock([&] { return cli::json_of(cli::sweep_document(f.answer())); }));
           })
      .def("text",
           [](const FoundSweep& f) {
             return without_lock(
                 [&] { return cli::unshaded(cli::text_of(cli::sweep_document(f.answer()))); });
           })
      .def("html",
           [](const FoundSweep& f) {
             return without_lock([&] { return cli::html_of(cli::sweep_document(f.answer())); });
           })
      .def("csv",
           [](const FoundSweep& f) {
             return without_lock([&] { return cli::csv_of(cli::combinations_table(f.answer())); });
           })
      .def("report",
           [](const FoundSweep& f, const std::string& name) {
             return without_lock(
                 [&] { return cli::page_html(cli::sweep_report(f.answer(), name)); });
           })
      .def("notes",
           [](const FoundSweep& f) { return without_lock([&] { return f.answer().notes; }); })
      .def("is_input",
           [](const FoundSweep& f, const std::string& path, const std::string& record) {
             return without_lock([&] {
               return problems::is_read_by({f.study.statement(), record}, path);
             });
           })
      .def("design", &swept_design_of, nb::arg("combination"))
      .def("__getstate__", &sweep_state_of)
      .def("__setstate__", [](FoundSweep& place, const SweepState& state) {
        new (&place) FoundSweep(sweep_from(state));
      });
  module.def("sweep", &sweep, nb::arg("problem"), nb::arg("set"), nb::arg("sample").none(),
             nb::arg("seed"), nb::arg("over"), nb::arg("evaluates"), nb::arg("is_cold"),
             nb::arg("workers").none(), nb::arg("carrier").none(), nb::arg("record"),
             nb::arg("resume"), nb::arg("time_limit").none(), nb::arg("memory").none(),
             nb::arg("progress").none());
  module.def("sweep_file", &sweep_file, nb::arg("path"));
  module.def("listed_value", &problems::listed_value, nb::arg("value"));
}

}  // namespace camlaw::python
