// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nanobind/stl/tuple.h>

#include <optional>

#include "output/answers/delivery_study.h"
#include "output/answers/reproduction_output.h"
#include "output/answers/study_fronts.h"
#include "output/answers/study_output.h"
#include "output/document/printing.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/published/cam_shape/solve.h"
#include "problems/published/systems.h"
#include "python/bindings/module.h"
#include "python/bindings/reproduction_state.h"
#include "python/bindings/running.h"
#include "python/bindings/values.h"

/// Published tables computed again, and the studies of published machines.
namespace camlaw::python {
namespace {

struct Reproduced {
  problems::SystemReproduction result;
};

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const auto& system : problems::reproducible_systems()) names.push_back(system.name);
  return names;
}

Reproduced reproduce(const std::string& name, nb::handle progress) {
  const problems::ReproducibleSystem system = problems::find_reproducible(name);
  return run_whole([&](const Work& work) { return Reproduced{system.reproduce(work.stop())}; },
                   progress);
}

/// One case of the cam shape, of any size.
nb::dict solve_cam_shape(int n) {
  const problems::CamShapeCase solved =
      run_whole([&](const Work& work) { return problems::solve_cam_shape(n, work.stop()); });
  nb::dict result;
  result["n"] = solved.n;
  result["printed"] = solved.printed;
  result["objective"] = solved.objective;
  result["true_optimum"] = solved.true_optimum;
  result["max_violation"] = solved.max_violation;
  result["verdict"] = solved.verdict;
  result["reason"] = solved.reason;
  result["iterations"] = solved.iterations;
  result["wall_s"] = solved.wall_s;
  return result;
}

std::string report_of(const std::vector<Reproduced>& some) {
  std::vector<problems::SystemReproduction> results;
  for (const Reproduced& one : some) results.push_back(one.result);
  return cli::page_html(cli::reproduction_report(results));
}

/// A study as what it says and what it shows.
struct Study {
  cli::Document answer;
  cli::Figure trade_off;
};

Study studied_cutter(const std::vector<std::string>& settings, bool table, int workers,
                     Work& work) {
  problems::CutterGivens cutter;
  for (const std::string& setting : settings) problems::set_given(cutter, setting);
  const auto study = problems::study_spine_cutter(cutter, work.stop());
  Study result{.answer = {}, .trade_off = cli::trade_off_figure(study)};
  if (!table) {
    const auto fronts = problems::prove_fronts(
        cutter, workers,
        [&work](const std::string& front, double done) { work.tell(done, "front of " + front); },
        work.stop());
    cli::draw_fronts(fronts, result.trade_off.panels.front());
    result.answer.add(cli::fronts_document(fronts));
    result.answer.say("\n");
  }
  result.answer.add(cli::study_document(study));
  return result;
}

Study study(const std::string& system, const std::vector<std::string>& settings, bool table,
            std::optional<int> workers, nb::handle progress) {
  const int crew = workers_of(workers);
  return run_whole(
      [&](Work& work) {
        if (system == "spine-cutter") return studied_cutter(settings, table, crew, work);
        if (system != "sheet-delivery") {
          throw std::invalid_argument(
              fmt::format("there is no study '{}'; use spine-cutter or sheet-delivery", system));
        }
        if (!settings.empty()) {
          throw std::invalid_argument("the study of the sheet delivery has no givens to set");
        }
        const auto choices = problems::trade_off_sheet_delivery(
            {.progress = [&work](double done) { work.tell(done, "slow-downs"); },
             .stop = work.stop()});
        return Study{cli::delivery_document(choices), cli::delivery_figure(choices)};
      },
      progress);
}

}  // namespace

void add_published(nb::module_& module) {
  nb::class_<Reproduced>(module, "Reproduction")
      .def_prop_ro("system", [](const Reproduced& r) { return r.result.system; })
      .def_prop_ro("reproduced", [](const Reproduced& r) { return r.result.reproduced; })
      .def_prop_ro("explained", [](const Reproduced& r) { return r.result.explained; })
      .def_prop_ro("unexplained", [](const Reproduced& r) { return r.result.unexplained; })
      .def_prop_ro("worsened", [](const Reproduced& r) { return problems::worsened(r.result); })
      .def("facts",
           [](const Reproduced& r) {
             return python_of(cli::json_of(cli::reproduction_document(r.result)));
           })
      .def("text",
           [](const Reproduced& r) {
             return cli::unshaded(cli::text_of(cli::reproduction_document(r.result)));
           })
      .def("html",
           [](const Reproduced& r) { return cli::html_of(cli::reproduction_document(r.result)); })
      .def("__getstate__", [](const Reproduced& r) { return state_of(r.result); })
      .def("__setstate__", [](Reproduced& place, const ReproductionState& state) {
        new (&place) Reproduced{reproduction_of(state)};
      });
  nb::class_<Study>(module, "Study")
      .def("facts", [](const Study& s) { return python_of(cli::json_of(s.answer)); })
      .def("text", [](const Study& s) { return cli::unshaded(cli::text_of(s.answer)); })
      .def("html", [](const Study& s) { return cli::html_of(s.answer); })
      .def("figure", [](const Study& s) { return dict_of(s.trade_off); });
  module.def("system_names", &system_names);
  module.def("reproduce", &reproduce, nb::arg("name"), nb::arg("progress").none());
  module.def("solve_cam_shape", &solve_cam_shape, nb::arg("n"));
  module.def("report_of_reproductions", &report_of, nb::arg("reproductions"));
  module.def("study", &study, nb::arg("system"), nb::arg("settings"), nb::arg("table"),
             nb::arg("workers").none(), nb::arg("progress").none());
}

}  // namespace camlaw::python
