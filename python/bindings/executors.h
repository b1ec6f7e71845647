// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "optim/crew/parcels.h"
#include "optim/pareto/task.h"
#include "optim/study/record.h"

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
  /// About a problem, as worker_program has it. `carrier` stays alive while this object does.
  PythonTransport(nb::handle carrier, const std::string& problem);

  std::size_t workers() override;
  void send(std::size_t parcel, const std::vector<std::string>& orders) override;
  std::vector<optim::Arrival> wait(double seconds) override;
  void cancel() override;
  double now() const override;
  double least_work() const override { return least_work_; }

 private:
  nb::handle carrier_;
  std::shared_ptr<Arrivals> arrivals_;
  double least_work_ = 0;
};

/// Who carries a study's searches out: processes of this machine, or what `carrier` reaches.
struct Labour {
  int workers = 1;
  nb::handle carrier = nb::none();
};

/// The executor of such labour, for a thread without the interpreter's lock; processes work by
/// `service` or as the program. The options are referred to.
std::unique_ptr<optim::Executor> executor_of(const Labour& labour, optim::Service service,
                                             const optim::WorkerProgram& program,
                                             const optim::OptimiseOptions& options);

/// The same for errands that are no searches of a study.
optim::Hands hands_of(const Labour& labour, const optim::WorkerProgram& program);

/// Throws std::invalid_argument where a study without a record is to be resumed.
void check_resume(bool resume, const std::string& record);

/// The record of a study, which has settings() and check_same(); an empty path: nothing is
/// recorded. Throws as optim::StudyRecord::begin.
template <class Study>
std::optional<optim::StudyRecord> record_of(const std::string& path, const Study& study,
                                            bool resume) {
  if (path.empty()) return {};
  return optim::StudyRecord::begin(
      path, study.settings(), resume,
      [&](const optim::StudyRecord& record) { study.check_same(record); });
}

}  // namespace camlaw::python
