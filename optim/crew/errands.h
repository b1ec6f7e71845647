// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

/// Work as numbered orders, and whoever carries them out: processes of this machine (crew.h) or of
/// others (parcels.h).
namespace camlaw::optim {

/// What whoever carries out an order is told, and may tell.
struct Bench {
  const std::atomic<bool>* stop = nullptr;  ///< set where the order is to end with what it has
  std::function<void(const std::string& news)> tell = {};  ///< takes news on the way; may be empty
  /// Seconds after which the order may be left, as another process takes it up from its beginning.
  std::optional<double> leave_after = {};
};

/// Carries out an order and returns the answer, which follows from the order alone; none where it
/// was left.
using Service = std::function<std::optional<std::string>(const std::string& order, const Bench&)>;

/// What a crew is to do. Errands have numbers, and are handed out in the order of next().
class Errands {
 public:
  virtual ~Errands() = default;
  /// The next one; none while all that can be handed out is: answers may bring more.
  virtual std::optional<std::size_t> next() = 0;
  /// None where it is not needed any more.
  virtual std::optional<std::string> order(std::size_t number) = 0;
  virtual void answered(std::size_t number, const std::string& answer) = 0;
  /// The process that had it died.
  virtual void lost(std::size_t number, const std::string& why) = 0;
  virtual void told(std::size_t, const std::string& /*news*/) {}
  /// What share of the whole work those are that next() has given so far, about.
  virtual double share() const { return 1; }
  /// Set where the work is to stop; may be null.
  virtual const std::atomic<bool>* stop() const { return nullptr; }
  /// Whether nothing that is under way is needed any more.
  virtual bool is_done() const { return false; }
  /// Seconds that workers get on a stop to answer with what they have; none: what is cut short is
  /// dropped.
  virtual std::optional<double> farewell() const { return {}; }
  /// Why this process and copies of it alone can do the work; empty where others can.
  virtual std::string confined() const { return {}; }
};

/// Carries errands out. Whoever does the work, the answers are the same: each follows from its
/// order alone.
class Workforce {
 public:
  virtual ~Workforce() = default;
  /// Until there is nothing left to do, or the work is stopped. `service` is how an order is
  /// carried out in this process or a copy of it; programs elsewhere have their own.
  virtual void run(Errands& errands, const Service& service) = 0;
  /// What a user should know of how errands were carried out; empty: nothing.
  virtual std::string remark() const { return {}; }
};

}  // namespace camlaw::optim
