// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "optim/crew/parcels.h"

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

}  // namespace camlaw::python
