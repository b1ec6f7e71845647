// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "optim/crew/crew.h"

/// Errands for workers on other machines: an engine that exists already, such as Dask or MPI,
/// carries parcels of orders to them. What is decided here is how many orders a parcel has, and
/// what becomes of those that do not come back.
namespace camlaw::optim {

/// What came back of a parcel.
struct Arrival {
  std::size_t parcel = 0;
  std::vector<std::string> answers = {};  ///< one for each order, in their order
  double seconds = 0;                     ///< that the worker took for them all
  /// Why there are no answers: the process of the worker ended. Empty where there are.
  std::string died = {};
  int deaths = 1;       ///< how many workers died of the parcel, where it died
  bool shared = false;  ///< another parcel that was under way may be to blame
  /// Why the worker takes no orders, with its name; it is of another version, say.
  std::string refused = {};
};

/// What carries parcels. All functions are called by one thread.
class Transport {
 public:
  virtual ~Transport() = default;
  /// How many orders can be carried out at a time now; workers may come and go.
  virtual std::size_t workers() = 0;
  /// Does not wait.
  virtual void send(std::size_t parcel, const std::vector<std::string>& orders) = 0;
  /// What has arrived; waits for it, `seconds` at most. A parcel may arrive late, twice or never.
  virtual std::vector<Arrival> wait(double seconds) = 0;
  /// Nothing that is under way is needed any more.
  virtual void cancel() = 0;
  /// Seconds from some beginning, of the clock by which wait() waits.
  virtual double now() const = 0;
  /// Seconds of work that a parcel has at least, where the engine takes more of this machine's time
  /// for it than send() does.
  virtual double least_work() const { return 0; }
};

struct ParcelRules {
  /// Work in a parcel, s: `costs` times what it takes to send it (some milliseconds by Dask), but
  /// at least and at most so much, and no less than Transport::least_work(). More where there are
  /// so many workers that the sender would fall behind.
  double seconds = 0.2, least_seconds = 0.02, costs = 150;
  double sending = 0.25;  ///< share of the sender's time that sending may take
  std::size_t most_orders = 1000;
  /// Parcels under way for each worker, so that it does not wait for the next one; of the last
  /// orders one, if an order alone takes as long as a parcel.
  std::size_t ahead = 2;
  /// After so many deaths of an order's workers, when it travelled alone, the order is lost.
  int deaths = 3;
  /// A parcel that takes this long, s, and ten times the longest seen, is sent again, and the first
  /// answer counts: its worker may have stopped answering. After `copies` times each further copy
  /// waits twice as long as the one before.
  double patience = 30;
  int copies = 3;
};

/// Carries errands out by a transport.
///
/// A parcel grows from one order to what workers are measured to do in ParcelRules::seconds, and is
/// never so long that workers would have nothing to do while the last ones are carried out. Where a
/// parcel's worker dies, its orders are sent again one by one, so that those which did no harm are
/// not blamed; an order that has killed three workers alone is lost. Where an engine cannot tell
/// which parcel a worker died of, those in question are carried out at the end, with nothing else
/// under way. What arrives twice counts once. A worker that refuses orders ends the run: throws
/// std::runtime_error that names it.
class ParcelForce {
 public:
  explicit ParcelForce(Transport& transport, const ParcelRules& rules = {});
  /// Until there is nothing left to do, or the work is stopped.
  void run(Errands& errands);
  /// How many orders were sent again, as their workers ended or did not answer. It is no remark:
  /// what was found does not depend on it, and says nothing of it.
  std::size_t sent_again() const { return sent_again_; }

 private:
  class Run;
  Transport& transport_;
  ParcelRules rules_;
  std::size_t parcels_ = 0;       ///< sent so far: their numbers never come again
  double seconds_per_order_ = 0;  ///< as measured; none yet: 0
  double seconds_to_send_ = 0;    ///< a parcel; as measured
  double longest_ = 0;            ///< parcel seen, s from sending to arriving
  std::size_t sent_again_ = 0;    ///< orders
};

}  // namespace camlaw::optim
