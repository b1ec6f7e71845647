// SPDX-License-Identifier: MIT
#include "python/bindings/executors.h"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fitting/motions/law_fit_service.h"
#include "optim/crew/hands.h"
#include "optim/study/parcel_executor.h"
#include "optim/study/workers.h"
#include "python/bindings/module.h"
#include "python/bindings/running.h"

namespace camlaw::python {
namespace {

/// A worker's side: what carries orders out about one problem, as a sender had it.
class Desk {
 public:
  explicit Desk(const nb::bytes& problem)
      : service_(problems::service_of_worker_or_fits({problem.c_str(), problem.size()})) {}

  /// The answers, one for each order. Other threads of Python go on meanwhile.
  nb::list carry_out(const nb::list& orders) const {
    std::vector<std::string> texts;
    for (const nb::handle order : orders) {
      const auto bytes = nb::cast<nb::bytes>(order);
      texts.emplace_back(bytes.c_str(), bytes.size());
    }
    {
      const Unlocked released;
      for (std::string& text : texts) text = service_(text, {}).value_or("");
    }
    nb::list answers;
    for (const std::string& text : texts) answers.append(nb::bytes(text.data(), text.size()));
    return answers;
  }

 private:
  optim::Service service_;
};

void put(Arrivals& arrivals, std::size_t parcel, const nb::list& answers, double seconds,
         const std::string& died, int deaths, bool shared, const std::string& refused) {
  optim::Arrival arrival{.parcel = parcel,
                         .seconds = seconds,
                         .died = died,
                         .deaths = deaths,
                         .shared = shared,
                         .refused = refused};
  for (const nb::handle answer : answers) {
    const auto bytes = nb::cast<nb::bytes>(answer);
    arrival.answers.emplace_back(bytes.c_str(), bytes.size());
  }
  arrivals.put(std::move(arrival));
}

/// A transport with the executor that uses it.
class CarriedExecutor final : public optim::Executor {
 public:
  CarriedExecutor(nb::handle carrier, const std::string& problem,
                  const optim::OptimiseOptions& options)
      : transport_(carrier, problem), parcels_(options, transport_) {}
  optim::Outcomes run(const std::vector<optim::Task>& tasks,
                      const optim::OnOutcome& on_outcome) override {
    return parcels_.run(tasks, on_outcome);
  }

 private:
  PythonTransport transport_;
  optim::ParcelExecutor parcels_;
};

}  // namespace

void Arrivals::put(optim::Arrival arrival) {
  const std::lock_guard lock(mutex_);
  arrived_.push_back(std::move(arrival));
  changed_.notify_one();
}

std::vector<optim::Arrival> Arrivals::take(double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [this] { return !arrived_.empty(); });
  return std::exchange(arrived_, {});
}

PythonTransport::PythonTransport(nb::handle carrier, const std::string& problem)
    : carrier_(carrier), arrivals_(std::make_shared<Arrivals>()) {
  const nb::gil_scoped_acquire held;
  carrier_.attr("begin")(arrivals_, nb::bytes(problem.data(), problem.size()));
  least_work_ = nb::cast<double>(carrier_.attr("least_work")());
}

std::size_t PythonTransport::workers() {
  const nb::gil_scoped_acquire held;
  return nb::cast<std::size_t>(carrier_.attr("workers")());
}

void PythonTransport::send(std::size_t parcel, const std::vector<std::string>& orders) {
  const nb::gil_scoped_acquire held;
  nb::list list;
  for (const std::string& order : orders) list.append(nb::bytes(order.data(), order.size()));
  carrier_.attr("send")(parcel, list);
}

std::vector<optim::Arrival> PythonTransport::wait(double seconds) {
  std::vector<optim::Arrival> arrived = arrivals_->take(seconds);
  const nb::gil_scoped_acquire held;
  carrier_.attr("check")();  // raises what broke the executor
  return arrived;
}

void PythonTransport::cancel() {
  const nb::gil_scoped_acquire held;
  carrier_.attr("cancel")();
}

double PythonTransport::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::unique_ptr<optim::Executor> executor_of(const Labour& labour, optim::Service service,
                                             const optim::WorkerProgram& program,
                                             const optim::OptimiseOptions& options) {
  if (!labour.carrier.is_none()) {
    return std::make_unique<CarriedExecutor>(labour.carrier, program.problem, options);
  }
  return std::make_unique<optim::ProcessExecutor>(std::move(service), options, labour.workers,
                                                  program);
}

optim::Hands hands_of(const Labour& labour, const optim::WorkerProgram& program) {
  if (labour.carrier.is_none()) {
    return optim::hands_of_crew({.workers = labour.workers, .program = program});
  }
  return optim::hands_beyond(std::make_shared<PythonTransport>(labour.carrier, program.problem));
}

void check_resume(bool resume, const std::string& record) {
  if (!resume || !record.empty()) return;
  throw std::invalid_argument("resume: it needs record, the file of the study");
}

void add_executors(nb::module_& module) {
  nb::class_<Arrivals>(module, "Arrivals")
      .def("put", &put, nb::arg("parcel"), nb::arg("answers") = nb::list(),
           nb::arg("seconds") = 0.0, nb::arg("died") = "", nb::arg("deaths") = 1,
           nb::arg("shared") = false, nb::arg("refused") = "");
  nb::class_<Desk>(module, "Desk")
      .def(nb::init<const nb::bytes&>(), nb::arg("problem"))
      .def("carry_out", &Desk::carry_out, nb::arg("orders"));
}

}  // namespace camlaw::python
