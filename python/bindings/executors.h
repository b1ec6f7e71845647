// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "optim/crew/parcels.h"
#include "optim/study/workers.h"

/// Work of a study sent through an executor of Python, such as Dask's.
namespace camlaw::python {

namespace nb = nanobind;

/// Where parcels arrive: filled by any thread of Python, emptied by the one that searches.
class Arrivals {
 public:
  void put(optim::Arrival arrival);
  /// Waits for something, `seconds` at most. The interpreter's lock must not be held.
  std::vector<optim::Arrival> take(double seconds);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<optim::Arrival> arrived_;
};

/// Parcels carried by a camlaw.executors.Carrier, in Python. Its functions are called by a thread
/// without the interpreter's lock; what Python raises in them is thrown as nb::python_error.
class PythonTransport final : public optim::Transport {
 public:
  /// `carrier` stays alive while this object does.
  explicit PythonTransport(nb::handle carrier);

  std::size_t workers() override;
  void send(std::size_t parcel, const std::vector<std::string>& orders) override;
  std::vector<optim::Arrival> wait(double seconds) override;
  void cancel() override;
  double now() const override;

 private:
  nb::handle carrier_;
  std::shared_ptr<Arrivals> arrivals_;
};

/// Who carries a study's searches out: processes of this machine, or what `carrier` reaches.
struct Labour {
  int workers = 1;
  nb::handle carrier = nb::none();

  /// Tells a carrier what the orders are about. The interpreter's lock is held.
  void tell_about(const optim::WorkerProgram& program) const;
};

/// Searches through a carrier.
class CarriedExecutor final : public optim::Executor {
 public:
  CarriedExecutor(const optim::OptimiseOptions& options, nb::handle carrier)
      : transport_(carrier), force_(transport_), tasks_(options, force_) {}
  std::vector<optim::Outcome> run(const std::vector<optim::Task>& tasks,
                                  const optim::OnOutcome& on_outcome) override {
    return tasks_.run(tasks, on_outcome);
  }

 private:
  PythonTransport transport_;
  optim::ParcelForce force_;
  optim::WorkforceExecutor tasks_;
};

}  // namespace camlaw::python
