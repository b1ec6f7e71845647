// SPDX-License-Identifier: MIT
#include "problems/sensitivity/sensitivity.h"

#include <nanobind/stl/tuple.h>

#include <utility>

#include "optim/study/recorded_hands.h"
#include "output/answers/profile_output.h"
#include "output/answers/sensitivity_output.h"
#include "output/answers/variation_output.h"
#include "output/document/printing.h"
#include "output/report/html.h"
#include "problems/statement/profile_errors.h"
#include "problems/tolerance/profile_loss.h"
#include "problems/tolerance/tolerance.h"
#include "problems/tolerance/tolerance_study.h"
#include "problems/tolerance/tolerance_worker.h"
#include "python/bindings/executors.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

/// How a design depends on its parameters, and what manufacture makes of it.
namespace camlaw::python {
namespace {

/// An answer as facts, words and HTML.
nb::tuple tuple_of(const cli::Document& document) {
  return nb::make_tuple(python_of(cli::json_of(document)), cli::unshaded(cli::text_of(document)),
                        cli::html_of(document));
}

nb::tuple sensitivity_of(const StatedProblem& problem, const std::vector<std::string>& over,
                         std::size_t samples, std::uint64_t seed, nb::handle progress) {
  return tuple_of(run_whole(
      [&](Work& work) {
        const problems::ProblemStatement design = problem.within(work);
        auto ranges = problems::sensitivity_ranges(design, over);
        const problems::LocalSensitivity local = problems::local_sensitivity(design);
        if (ranges.ranges.empty()) return cli::sensitivity_document(local, nullptr);
        optim::SobolOptions sobol{.samples = samples, .seed = seed};
        sobol.progress = [&work](double done) { work.tell(done, "Sobol indices"); };
        const problems::GlobalSensitivity global =
            problems::global_sensitivity(design, std::move(ranges), sobol, work.stop());
        return cli::sensitivity_document(local, &global);
      },
      progress));
}

nb::tuple tolerance_of(const StatedProblem& problem, const std::vector<std::string>& tolerances,
                       std::optional<std::size_t> samples, std::uint64_t seed,
                       std::optional<int> workers, nb::handle carrier, const std::string& record,
                       bool resume, std::optional<double> time_limit, nb::handle progress) {
  check_resume(resume, record);
  const Labour labour{workers_of(workers), carrier};
  return tuple_of(run_whole(
      [&](Work& work) {
        const problems::ProblemStatement design = problems::restated_design(problem.statement);
        const optim::Deadline deadline(time_limit, work.stop());
        const problems::ProfileErrors errors = problems::profile_errors_of(design);
        std::optional<problems::ProfileAnswer> profile;
        if (errors.any()) profile = problems::profile_answer(design, errors);
        if (profile && record.empty() && problems::asked_variations(design, tolerances).empty()) {
          return cli::with_profile(design, *profile);
        }
        const problems::VariedDesign varied = problems::varied_design(
            design, problems::asked_variations(design, tolerances), deadline);
        optim::Hands hands = hands_of(labour, problems::tolerance_program(design, tolerances));
        auto file =
            record.empty()
                ? std::nullopt
                : record_of(record, problems::ToleranceStudy(design, tolerances, samples, seed),
                            resume);
        if (file) hands = optim::recorded_hands(std::move(hands), *file);
        const problems::ToleranceOptions options{
            .samples = samples,
            .seed = seed,
            .hands = [&](optim::Errands& errands, const optim::Service& service) {
              hands(errands, service);
              work.tell(errands.share(), "parts of the yield");
            }};
        cli::Document document =
            cli::variation_document(varied, problems::tolerance_of(varied, options));
        return profile ? cli::with_profile(design, *profile, std::move(document)) : document;
      },
      progress));
}

}  // namespace

void add_sensitivity(nb::module_& module) {
  module.def("sensitivity", &sensitivity_of, nb::arg("problem"), nb::arg("over"),
             nb::arg("samples"), nb::arg("seed"), nb::arg("progress").none());
  module.def("tolerance", &tolerance_of, nb::arg("problem"), nb::arg("tolerances"),
             nb::arg("samples").none(), nb::arg("seed"), nb::arg("workers").none(),
             nb::arg("carrier").none(), nb::arg("record"), nb::arg("resume"),
             nb::arg("time_limit").none(), nb::arg("progress").none());
}

}  // namespace camlaw::python
