// SPDX-License-Identifier: MIT
#include "optim/crew/crew.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <thread>
#include <utility>

#include "optim/crew/child_process.h"
#include "optim/crew/worker_process.h"

namespace camlaw::optim {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

}  // namespace

/// The errands of one run: which wait, which are under way.
class Crew::Run {
 public:
  Run(Crew& crew, Errands& errands, const Service& service)
      : crew_(crew), errands_(errands), service_(service) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  /// Workers that are in the middle of an errand end with it, and copies of this process, which the
  /// next run may find changed.
  ~Run() {
    std::erase_if(crew_.workers_,
                  [](const WorkerProcess& w) { return w.is_busy() || w.is_forked(); });
  }

  void carry_out() {
    if (!crew_.side_by_side_) work_here();
    while (!stopped()) {
      hand_out();
      if (count_of_busy() == 0 || errands_.is_done() || stopped()) break;
      listen();
    }
    if (stopped() && errands_.farewell()) say_farewell(*errands_.farewell());
  }

 private:
  bool stopped() const { return errands_.stop() != nullptr && *errands_.stop(); }

  /// Work that was handed out in vain comes first, in its order.
  std::optional<std::size_t> next() {
    if (returned_.empty()) return errands_.next();
    const std::size_t number = returned_.front();
    returned_.pop_front();
    return number;
  }
  void give_back(std::size_t number) {
    returned_.insert(std::lower_bound(returned_.begin(), returned_.end(), number), number);
  }

  /// Does the work here while it is not seen to be long. An errand that is under way then is left
  /// to a worker, which begins it anew.
  void work_here() {
    while (!stopped()) {
      const auto number = next();
      if (!number) return;
      const auto left = time_here();
      if (!(left && *left <= 0) && do_here(*number, left)) continue;
      crew_.side_by_side_ = true;
      return give_back(*number);
    }
  }

  /// Seconds until the whole work would be long if the errand in hand ended then; none: this
  /// process does it to its end.
  std::optional<double> time_here() const {
    constexpr double kLeast = 0.25;  // of all that is done here: before, a guess is worth nothing
    const bool is_last = errands_.share() >= 1;
    if (crew_.rules_.workers < 2 || is_last || !crew_.can_hire(errands_)) return {};
    const double at = std::max(kLeast, kLongWork * errands_.share());
    return std::max(0.0, at - crew_.spent_here_);
  }

  /// False where the errand was left.
  bool do_here(std::size_t number, std::optional<double> leave_after) {
    const auto order = errands_.order(number);
    if (!order) return true;
    const Bench bench{errands_.stop(),
                      [&](const std::string& news) { errands_.told(number, news); }, leave_after};
    const Clock::time_point began = Clock::now();
    const auto answer = service_(*order, bench);
    crew_.spent_here_ += seconds_since(began);
    if (!answer) return false;
    const bool is_cut_short = stopped() && !errands_.farewell();
    if (!is_cut_short) errands_.answered(number, *answer);
    return true;
  }

  /// Gives waiting errands to workers; where there are none to be had, one is done here.
  void hand_out() {
    while (const auto number = next()) {
      const std::size_t busy = count_of_busy();
      if (busy >= static_cast<std::size_t>(crew_.rules_.workers)) return give_back(*number);
      if (WorkerProcess* worker = crew_.hire(service_, errands_)) {
        const auto order = errands_.order(*number);
        if (order && !worker->give(*number, *order)) give_back(*number);
        continue;
      }
      if (busy > 0) return give_back(*number);
      do_here(*number, {});
      if (stopped()) return;
    }
  }

  std::size_t count_of_busy() const {
    return static_cast<std::size_t>(
        std::count_if(crew_.workers_.begin(), crew_.workers_.end(),
                      [](const WorkerProcess& worker) { return worker.is_busy(); }));
  }

  /// Waits a little for what workers have to say.
  void listen() {
    constexpr int kMilliseconds = 100;  // after which an interrupt is looked for
    std::vector<pollfd> files;
    for (const WorkerProcess& worker : crew_.workers_) {
      // Of one that is not busy nothing is to be heard, not even that it has ended.
      files.push_back({worker.is_busy() ? worker.socket() : -1, POLLIN, 0});
    }
    if (poll(files.data(), files.size(), kMilliseconds) < 0) return;
    std::vector<std::pair<std::size_t, WorkerProcess::News>> heard;
    for (std::size_t i = 0; i < files.size(); ++i) {
      WorkerProcess& worker = crew_.workers_[i];
      if (!worker.is_busy()) continue;
      const std::size_t number = worker.errand();
      WorkerProcess::News news = files[i].revents != 0 ? worker.read() : worker.late();
      if (news.failed_to_start.empty()) {
        heard.emplace_back(number, std::move(news));
      } else {
        crew_.stay_here(news.failed_to_start);
        give_back(number);
      }
    }
    std::erase_if(crew_.workers_, [](const WorkerProcess& worker) { return worker.has_ended(); });
    for (const auto& [number, news] : heard) take(number, news);
  }

  void take(std::size_t number, const WorkerProcess::News& news) {
    for (const std::string& told : news.told) errands_.told(number, told);
    if (news.answer) errands_.answered(number, *news.answer);
    if (!news.died.empty()) errands_.lost(number, news.died);
  }

  /// Workers answer with what they have, if they do so in time.
  void say_farewell(double seconds) {
    for (const WorkerProcess& worker : crew_.workers_) {
      if (worker.is_busy()) worker.ask_to_end();
    }
    const Clock::time_point began = Clock::now();
    while (count_of_busy() > 0 && seconds_since(began) < seconds) listen();
    crew_.workers_.clear();  // those that were asked to end would cut the next errand short too
  }

  Crew& crew_;
  Errands& errands_;
  const Service& service_;
  std::deque<std::size_t> returned_;  ///< in order
};

int usual_workers() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
}

Crew::Crew(CrewRules rules) : rules_(std::move(rules)), side_by_side_(rules_.at_once) {
  if (rules_.workers < 1) throw std::invalid_argument("workers: at least one is needed");
}

Crew::Crew(Crew&&) noexcept = default;
Crew::~Crew() = default;

void Crew::stay_here(const std::string& why) {
  rules_.program.reset();
  remark_ = fmt::format("searched in the calling process, one search at a time: {}", why);
}

bool Crew::can_hire(const Errands& errands) const {
  return (rules_.program && errands.confined().empty()) || has_one_thread();
}

/// Those that are there go on where no more can be had.
WorkerProcess* Crew::forked(const Service& service) {
  try {
    return &workers_.emplace_back(WorkerProcess::forked(service, workers_));
  } catch (const std::runtime_error& error) {
    is_full_ = true;
    remark_ = workers_.empty() ? fmt::format("in the calling process alone: {}", error.what())
                               : fmt::format("by fewer workers than asked for: {}", error.what());
    return nullptr;
  }
}

WorkerProcess* Crew::hire(const Service& service, const Errands& errands) {
  std::erase_if(workers_, [](const WorkerProcess& w) { return !w.is_busy() && !w.is_idle(); });
  for (WorkerProcess& worker : workers_) {
    if (worker.is_idle()) return &worker;
  }
  if (is_full_) return nullptr;
  if (has_one_thread()) return forked(service);
  if (!rules_.program) {
    if (remark_.empty()) stay_here("it has several threads, and the problem is not sent as data");
    return nullptr;
  }
  if (const std::string why = errands.confined(); !why.empty()) {
    stay_here("it has several threads, and " + why);
    return nullptr;
  }
  try {
    return &workers_.emplace_back(WorkerProcess::started(*rules_.program));
  } catch (const std::runtime_error& error) {
    stay_here(error.what());
    return nullptr;
  }
}

void Crew::run(Errands& errands, const Service& service) {
  Run(*this, errands, service).carry_out();
}

}  // namespace camlaw::optim
