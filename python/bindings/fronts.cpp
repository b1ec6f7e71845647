// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "optim/search/free_memory.h"
#include "optim/study/workers.h"
#include "output/answers/front_output.h"
#include "output/answers/front_words.h"
#include "output/answers/tolerance_output.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/fronts/study_worker.h"
#include "problems/results/design_json.h"
#include "problems/results/input_files.h"
#include "problems/results/seal.h"
#include "problems/results/start_settings.h"
#include "python/bindings/executors.h"
#include "python/bindings/front_state.h"
#include "python/bindings/laws.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/results.h"
#include "python/bindings/running.h"

namespace camlaw::python {
namespace {

namespace fs = std::filesystem;
using problems::FrontStudy;

/// A front with its study, which stay where they are: the answer refers to them.
struct FoundFront {
  FrontStudy study;
  problems::StoredFront stored;
  std::string file;  ///< of the record; empty where there is none
  std::unique_ptr<const cli::FrontAnswer> answer = {};

  const optim::Front& front() const { return stored.front; }
  std::size_t point(std::size_t k) const {
    if (k < front().points.size()) return k;
    throw std::invalid_argument(
        fmt::format("point {}: the front has {}, counted from 0", k, front().points.size()));
  }
};
using FrontOwner = std::unique_ptr<FoundFront>;

FrontOwner answered(FrontOwner front) {
  front->answer = std::make_unique<const cli::FrontAnswer>(front->study, front->stored);
  return front;
}

/// Throws optim::Interrupted where the work is stopped meanwhile.
FrontOwner answered(FrontOwner front, const Work& work) {
  const FrontStudy watched = front->study.with_stop(work.stop());
  const cli::FrontAnswer answer(watched, front->stored);
  front->answer = std::make_unique<const cli::FrontAnswer>(front->study, front->front(), answer);
  return front;
}

void search(FoundFront& found, const Labour& labour, bool resume, Work& work) {
  FrontStudy& study = found.study;
  study.options().solve.stop = work.stop();
  study.options().progress = [&work](const optim::StudyProgress& p) {
    const double done = static_cast<double>(p.points) / static_cast<double>(p.wanted);
    work.tell(std::min(done, 1.0), fmt::format("{}, {} searches, hypervolume {:.6g}",
                                               cli::counted_points(p), p.tasks, p.hypervolume));
  };
  auto record = record_of(found.file, study, resume);
  const auto crew = executor_of(labour, optim::study_service(study.space()),
                                problems::worker_program(study), study.options().solve);
  if (!record) {
    found.stored = {.front = study.run(*crew)};
  } else {
    optim::RecordedExecutor recorded(study.space(), *record, crew.get());
    found.stored = {.front = study.run(recorded),
                    .faults = recorded.faults(),
                    .resuming = problems::Resuming::Works};
    found.stored.notes = problems::fault_notes(found.stored.faults, found.front().stopped
                                                                        ? "resuming solves it again"
                                                                        : "it was solved again");
  }
  study.options().progress = {};
  study.options().solve.stop = nullptr;
}

nb::tuple pareto(const StatedProblem& problem, std::size_t points, const std::string& method,
                 std::optional<int> workers, nb::handle carrier, const std::string& record,
                 bool resume, std::optional<double> time_limit, std::optional<double> memory,
                 nb::handle progress) {
  if (points < 2 || points > problems::kMostPoints) {
    throw std::invalid_argument(
        fmt::format("points: {} is outside 2 .. {}", points, problems::kMostPoints));
  }
  Labour labour{workers_of(workers), carrier};
  check_resume(resume, record);
  const problems::ProblemStatement& statement = problem.statement;
  problems::FrontSettings settings{points, problems::parse_method(method),
                                   problems::restated_settings(statement)};
  settings.files = statement.files;
  if (resume && fs::exists(record)) {
    settings.scouts = problems::FrontStudy::settings_of(optim::StudyRecord::read(record)).scouts;
  }
  FrontOwner front(
      new FoundFront{FrontStudy(statement.text, statement.source, settings), {}, record});
  const double allowed = memory.value_or(optim::free_memory());
  front->study.options().solve.memory = allowed;
  const bool interrupted = run_beside(
      [&](Work& work) {
        const optim::ProblemSpace& space = front->study.space();
        labour.workers = optim::workers_with_room(
            labour.workers, space.problem(space.options(0)).alone(0), allowed);
        search(*front, labour, resume, work);
        front = answered(std::move(front));
      },
      progress, time_limit);
  return nb::make_tuple(std::move(front), interrupted);
}

/// The front that a record holds, without a search.
FrontOwner front_file(const std::string& path) {
  return run_whole([&](const Work& work) {
    optim::StudyRecord record = optim::StudyRecord::read(path);
    FrontOwner front(new FoundFront{FrontStudy::of(record), {}, path});
    const FrontStudy watched = front->study.with_stop(work.stop());
    front->stored = problems::stored_front(watched, record);
    return answered(std::move(front), work);
  });
}

/// An answer about the front that may be stopped: of(answer) for one that may.
template <class Of>
auto whole(const FoundFront& found, const Of& of) {
  return run_whole([&](const Work& work) {
    const FrontStudy study = found.study.with_stop(work.stop());
    return of(cli::FrontAnswer(study, found.front(), *found.answer));
  });
}

cli::Document document_of(const FoundFront& found) {
  return whole(found, [](const cli::FrontAnswer& answer) { return cli::front_document(answer); });
}

/// What becomes of a point that is not made as it was meant, as facts, text and HTML.
nb::tuple point_sensitivity_of(const FoundFront& found, std::size_t k,
                               const std::vector<std::string>& tolerances) {
  const optim::FrontPoint& point = found.front().points[found.point(k)];
  const cli::Document document = whole(found, [&](const cli::FrontAnswer& answer) {
    return cli::tolerance_document(answer, point, cli::tolerances_of(answer, point, tolerances));
  });
  return nb::make_tuple(python_of(cli::json_of(document)), cli::unshaded(cli::text_of(document)),
                        cli::html_of(document));
}

/// What a front is pickled as: its study as a record keeps it, how the study is called, the file of
/// the record, the front itself (front_state.h), and what is said of the record.
using FrontOwnState =
    std::tuple<std::map<std::string, std::string>, std::string, std::string, FrontState,
               std::vector<FaultState>, std::vector<std::string>, int>;

FrontOwnState own_state_of(const FoundFront& found) {
  std::vector<FaultState> faults;
  for (const auto& fault : found.stored.faults) {
    faults.emplace_back(fault.task, static_cast<int>(fault.kind), fault.why);
  }
  return {found.study.settings(),
          found.study.bound().statement().source,
          found.file,
          state_of(found.front()),
          std::move(faults),
          found.stored.notes,
          static_cast<int>(found.stored.resuming)};
}

/// The front of a state; what is said of its points is worked out again.
FrontOwner restored(const FrontOwnState& state, const Work& work) {
  const auto& [settings, source, file, front, faults, notes, resuming] = state;
  FrontOwner result(
      new FoundFront{FrontStudy(settings.at("problem"), source, FrontStudy::settings_of(settings)),
                     {.front = front_of(front),
                      .notes = notes,
                      .resuming = static_cast<problems::Resuming>(resuming)},
                     file});
  for (const auto& [task, kind, why] : faults) {
    result->stored.faults.push_back({task, static_cast<optim::RecordFault::Kind>(kind), why});
  }
  return answered(std::move(result), work);
}

/// In place, where Python has room for it, once all is there.
void restore(FoundFront* place, const FrontOwnState& state) {
  FrontOwner made = run_whole([&](const Work& work) { return restored(state, work); });
  new (place) FoundFront{std::move(made->study), std::move(made->stored), std::move(made->file)};
  place->answer =
      std::make_unique<const cli::FrontAnswer>(place->study, place->front(), *made->answer);
}

/// Objectives and variables of each point, as numbers where they are, and its verdict.
nb::list rows_of(const FoundFront& found) {
  nb::list rows;
  for (const optim::FrontPoint& point : found.front().points) {
    nb::dict row;
    for (std::size_t i = 0; i < point.objectives.size(); ++i) {
      row[nb::cast(found.front().objectives[i].name)] = point.objectives[i];
    }
    const std::string law = found.answer->law(point);
    if (!law.empty()) row["law"] = law;
    for (const cli::DesignValue& value : found.answer->values(point)) {
      const nb::object name = nb::cast(value.name);
      if (row.contains(name)) continue;
      row[name] = std::isnan(value.number) ? nb::cast(value.text) : nb::cast(value.number);
    }
    row["verdict"] = std::string(optim::to_string(point.verdict));
    row["global"] = point.is_global;
    rows.append(row);
  }
  return rows;
}

nb::dict units_of(const FoundFront& found) {
  nb::dict units;
  for (const optim::ObjectiveName& objective : found.front().objectives) {
    units[nb::cast(objective.name)] = objective.unit;
  }
  if (found.front().points.empty()) return units;
  for (const cli::DesignValue& value : found.answer->values(found.front().points.front())) {
    const nb::object name = nb::cast(value.name);
    if (!units.contains(name)) units[name] = value.unit;
  }
  return units;
}

std::optional<std::size_t> knee_of(const FoundFront& found) {
  const auto knee =
      optim::knee(found.answer->costs(), found.front().tolerances, found.front().sizes);
  if (!knee) return std::nullopt;
  return knee->point;
}

/// A point as a result that stands alone.
StoredResult result_at(const FoundFront& found, std::size_t k) {
  const std::size_t point = found.point(k);
  const optim::FrontPoint& chosen = found.front().points[point];
  problems::Json object = {{"format", problems::kResultFormat.text()},
                           {"program", cli::short_version()}};
  cli::Document document = cli::point_document(*found.answer, point);
  object.update(cli::json_of(document));
  object["design"] = problems::recorded_design(found.study.bound(),
                                               found.study.space().options(chosen.part), chosen.x);
  problems::ReadDesign design{found.study.bound().statement()};
  design.statement = found.study.design(chosen);
  design.verdict = std::string(optim::to_string(chosen.verdict));
  design.reason = chosen.reason;
  design.global = chosen.is_global;
  StoredResult result = result_of(std::move(object), std::move(design));
  result.say(document);
  return result;
}

}  // namespace

void add_fronts(nb::module_& module) {
  nb::class_<FoundFront>(module, "Front")
      .def_prop_ro("file", [](const FoundFront& f) { return f.file; })
      .def("is_input",
           [](const FoundFront& f, const std::string& path) {
             return without_lock([&] {
               return problems::is_read_by({f.study.bound().statement(), f.file}, path);
             });
           })
      .def_prop_ro("size", [](const FoundFront& f) { return f.front().points.size(); })
      .def_prop_ro("stopped", [](const FoundFront& f) { return f.front().stopped; })
      .def_prop_ro("complete", [](const FoundFront& f) { return f.front().complete; })
      .def_prop_ro("remark", [](const FoundFront& f) { return f.front().remark; })
      .def_prop_ro("hypervolume", [](const FoundFront& f) { return f.front().hypervolume; })
      .def_prop_ro("notes", [](const FoundFront& f) { return f.stored.notes; })
      .def("rows", &rows_of)
      .def("units", &units_of)
      .def("knee", &knee_of)
      .def("compromise",
           [](const FoundFront& f, const std::vector<double>& weights) {
             return optim::compromise(f.answer->costs(), weights, f.front().tolerances,
                                      f.front().sizes);
           })
      .def("result", &result_at, nb::arg("point"))
      .def("design",
           [](const FoundFront& f, std::size_t k) {
             return StatedProblem{f.study.design(f.front().points[f.point(k)])};
           })
      .def("facts", [](const FoundFront& f) { return python_of(cli::json_of(document_of(f))); })
      .def("text", [](const FoundFront& f) { return cli::unshaded(cli::text_of(document_of(f))); })
      .def("html", [](const FoundFront& f) { return cli::html_of(document_of(f)); })
      .def("csv",
           [](const FoundFront& f) {
             return whole(f, [](const cli::FrontAnswer& answer) { return cli::front_csv(answer); });
           })
      .def("figure",
           [](const FoundFront& f) {
             return dict_of(whole(
                 f, [](const cli::FrontAnswer& answer) { return cli::front_figure(answer); }));
           })
      .def("svg",
           [](const FoundFront& f) {
             return whole(f, [](const cli::FrontAnswer& answer) {
               return cli::to_svg(cli::front_figure(answer));
             });
           })
      .def("sensitivity", &point_sensitivity_of, nb::arg("point"), nb::arg("tolerances"))
      .def("report",
           [](const FoundFront& f, const std::string& name) {
             return whole(f, [&](const cli::FrontAnswer& answer) {
               return cli::page_html(cli::front_report(answer, name));
             });
           })
      .def("__getstate__", [](const FoundFront& f) { return own_state_of(f); })
      .def("__setstate__",
           [](FoundFront& front, const FrontOwnState& state) { restore(&front, state); });
  module.def("pareto", &pareto, nb::arg("problem"), nb::arg("points"), nb::arg("method"),
             nb::arg("workers").none(), nb::arg("carrier").none(), nb::arg("record"),
             nb::arg("resume"), nb::arg("time_limit").none(), nb::arg("memory").none(),
             nb::arg("progress").none());
  module.def("front_file", &front_file, nb::arg("path"));
}

}  // namespace camlaw::python
