// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Work as numbered orders, and who carries them out: processes of this machine, or of others
/// (parcels.h). Orders go out and answers come back, as bytes.
namespace camlaw::optim {

class WorkerProcess;

/// How long a program that was started may take to say that it is a worker. It says so before it
/// does anything else, within some milliseconds: what takes longer is another program.
inline constexpr std::chrono::milliseconds kGreetingPatience{5000};

/// How a program is started that carries out orders.
struct WorkerProgram {
  std::string path;     ///< of the program, which calls serve_as_program on its standard input
  std::string problem;  ///< what the orders are about, as the program takes it
  std::chrono::milliseconds patience = kGreetingPatience;
};

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
  /// Whether it is an answer to this errand: only such a one is recorded, and believed of a record.
  virtual bool is_answer(std::size_t /*number*/, const std::string& answer) const {
    return !answer.empty();
  }
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

/// How a crew works.
struct CrewRules {
  int workers = 1;  ///< processes at a time
  /// What is started where this process has several threads; none: the work is done here then.
  std::optional<WorkerProgram> program = {};
  /// Whether processes are begun at once, be it one, so that this process does nothing that could
  /// end it. Else they are begun once the work is seen to be long (kLongWork), two at least.
  bool at_once = false;
};

/// Seconds of work below which it stays in the calling process.
inline constexpr double kLongWork = 3;

inline constexpr int kMostWorkers = 256;
/// How many processes work side by side where nobody says: the cores, eight at most.
int usual_workers();

/// Processes that carry out errands. One that dies takes its errand with it and nothing else.
///
/// Where this process has one thread, workers are copies of it (fork). Where it has several they
/// are started afresh from a program; without one, or where it cannot be started, errands are
/// carried out here, one after the other, and remark() says so. A crew is one thread's at a time;
/// several threads may have one each.
class Crew {
 public:
  /// Throws std::invalid_argument for no workers at all.
  explicit Crew(CrewRules rules);
  Crew(Crew&&) noexcept;
  ~Crew();

  /// Until there is nothing left to do, or the work is stopped.
  void run(Errands& errands, const Service& service);
  /// Why errands were not carried out side by side; empty: they could be.
  const std::string& remark() const { return remark_; }

 private:
  class Run;
  bool can_hire(const Errands& errands) const;
  /// One that waits for an errand; null where none can be had, and remark_ says why.
  WorkerProcess* hire(const Service& service, const Errands& errands);
  void stay_here(const std::string& why);
  WorkerProcess* forked(const Service& service);

  CrewRules rules_;
  std::string remark_;
  bool is_full_ = false;                ///< no further worker is to be had
  std::vector<WorkerProcess> workers_;  ///< those started afresh stay from run to run
  bool side_by_side_;                   ///< else the work is done here as yet
  double spent_here_ = 0;               ///< s
};

/// Carries errands out, whoever that is: a crew, or workers on other machines (parcels.h), which
/// have a service of their own.
using Hands = std::function<void(Errands&, const Service&)>;

}  // namespace camlaw::optim
