// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "optim/crew/parcels.h"

/// The processes that mpirun has started: rank 0 hands out parcels, the others carry them out.
namespace camlaw::optim {

class MpiRanks final : public Transport {
 public:
  /// Loads the plug-in with MPI and begins. Throws std::runtime_error where there is no plug-in, or
  /// MPI does not begin.
  MpiRanks();
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;
  /// Rank 0 tells the others to end; each waits for all.
  ~MpiRanks() override;

  int rank() const;
  int size() const;

  /// For ranks other than 0: takes the problem, and carries out what arrives until rank 0 ends it.
  /// A problem that `service_of` does not take is refused by this rank's name.
  void serve(const std::function<Service(const std::string& problem)>& service_of);

  /// For rank 0, before the first parcel: what the orders are about. Throws std::runtime_error
  /// where rank 0 is by itself.
  void give(const std::string& problem);
  std::size_t workers() override;
  void send(std::size_t parcel, const std::vector<std::string>& orders) override;
  std::vector<Arrival> wait(double seconds) override;
  void cancel() override;
  double now() const override;

 private:
  struct Plugin;
  std::optional<std::pair<int, std::string>> message();
  void tell(int rank, const std::string& bytes);
  void take(int rank, const std::string& bytes, std::vector<Arrival>& arrived);
  void look_for_the_gone(std::vector<Arrival>& arrived);

  std::unique_ptr<Plugin> plugin_;
  std::vector<std::vector<std::size_t>> under_way_;  ///< of each rank, parcels
  std::vector<double> heard_;                        ///< when each was last heard
};

}  // namespace camlaw::optim
