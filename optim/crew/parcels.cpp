// SPDX-License-Identifier: MIT
#include "optim/crew/parcels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <stdexcept>
#include <unordered_set>
#include <utility>

namespace camlaw::optim {
namespace {

/// Seconds after which an interrupt is looked for.
constexpr double kLook = 0.1;

/// Seconds between looks for parcels that are overdue.
constexpr double kLookForOverdue = 1;

/// How many times the longest parcel seen one may take before it is sent a second time.
constexpr double kOverdue = 10;

}  // namespace

/// The errands of one run: which wait, which are under way.
class ParcelForce::Run {
 public:
  Run(ParcelForce& force, Errands& errands)
      : force_(force), transport_(force.transport_), rules_(force.rules_), errands_(errands) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() = default;

  void carry_out() {
    while (!stopped()) {
      send_all();
      if (open_.empty() || errands_.is_done()) break;
      for (const Arrival& arrival : transport_.wait(kLook)) take(arrival);
      look_for_overdue();
    }
    if (!parcels_.empty()) transport_.cancel();
  }

 private:
  struct Parcel {
    std::vector<std::size_t> numbers;
    double sent = 0;
    bool is_overdue = false;
    bool was_by_itself = true;  ///< nothing else was under way at any time
  };

  bool stopped() const { return errands_.stop() != nullptr && *errands_.stop(); }
  std::size_t workers() const { return std::max<std::size_t>(1, transport_.workers()); }

  /// Parcels until each worker has some ahead.
  void send_all() {
    const std::size_t count = workers();
    while (parcels_.size() - overdue_ < count * ahead(count)) {
      std::vector<std::size_t> numbers = next(count);
      if (numbers.empty()) return;
      send({.numbers = std::move(numbers)});
    }
  }

  /// Parcels under way for each worker. Of the last orders, where each takes long, none waits
  /// behind another while other workers have nothing to do.
  std::size_t ahead(std::size_t workers) const {
    const bool are_last = next_is_none_ && waiting_.size() < workers && alone_.empty();
    return are_last && force_.seconds_per_order_ > work_of_parcel() ? 1 : rules_.ahead;
  }

  /// The numbers of the next parcel; empty: there is nothing to send now.
  std::vector<std::size_t> next(std::size_t workers) {
    while (!alone_.empty()) {
      const std::size_t number = alone_.front();
      alone_.pop_front();
      if (open_.contains(number)) return {number};
    }
    const std::size_t most = usual_size(workers);
    while (waiting_.size() < workers * rules_.ahead * most) {
      const auto number = errands_.next();
      next_is_none_ = !number;
      if (!number) break;
      waiting_.push_back(*number);
      open_.insert(*number);
    }
    // Half of a worker's part of what is left, so that all end at about the same time.
    const std::size_t part = (waiting_.size() + 2 * workers - 1) / (2 * workers);
    std::vector<std::size_t> numbers;
    for (std::size_t left = std::min(most, part); left > 0; --left) {
      numbers.push_back(waiting_.front());
      waiting_.pop_front();
    }
    while (numbers.empty() && parcels_.empty() && !suspects_.empty()) {
      if (open_.contains(suspects_.front())) numbers.push_back(suspects_.front());
      suspects_.pop_front();
    }
    return numbers;
  }

  /// Seconds, where the sender does not fall behind.
  double work_of_parcel() const {
    const double least = std::max(rules_.least_seconds, transport_.least_work());
    return std::clamp(rules_.costs * force_.seconds_to_send_, least,
                      std::max(least, rules_.seconds));
  }

  /// How many orders a worker is measured to carry out in the time that a parcel should take.
  std::size_t usual_size(std::size_t workers) const {
    if (force_.seconds_per_order_ <= 0) return 1;
    const double pace = static_cast<double>(workers) * force_.seconds_to_send_ / rules_.sending;
    const double count = std::floor(std::max(work_of_parcel(), pace) / force_.seconds_per_order_);
    return static_cast<std::size_t>(
        std::clamp(count, 1.0, static_cast<double>(rules_.most_orders)));
  }

  void send(Parcel parcel) {
    std::vector<std::string> orders;
    std::erase_if(parcel.numbers, [&](std::size_t number) {
      auto order = errands_.order(number);
      if (order) orders.push_back(std::move(*order));
      if (!order) open_.erase(number);
      return !order;
    });
    if (orders.empty()) return;
    parcel.sent = transport_.now();
    parcel.was_by_itself = parcels_.empty();
    if (parcels_.size() == 1) parcels_.begin()->second.was_by_itself = false;
    const std::size_t name = force_.parcels_++;
    transport_.send(name, orders);
    learn(force_.seconds_to_send_, transport_.now() - parcel.sent);
    parcels_.emplace(name, std::move(parcel));
  }

  void take(const Arrival& arrival) {
    const auto place = parcels_.find(arrival.parcel);
    if (place == parcels_.end()) return;  // it was here before
    const Parcel parcel = std::move(place->second);
    parcels_.erase(place);
    overdue_ -= parcel.is_overdue;
    if (!arrival.refused.empty()) {
      transport_.cancel();
      throw std::runtime_error(arrival.refused);
    }
    if (!arrival.died.empty()) return mourn(parcel, arrival);
    if (arrival.answers.size() != parcel.numbers.size()) {
      return mourn(parcel, {.died = fmt::format("a worker gave {} answers to {} orders",
                                                arrival.answers.size(), parcel.numbers.size())});
    }
    learn(force_.seconds_per_order_, arrival.seconds / static_cast<double>(arrival.answers.size()));
    force_.longest_ = std::max(force_.longest_, transport_.now() - parcel.sent);
    for (std::size_t i = 0; i < parcel.numbers.size(); ++i) {
      if (open_.erase(parcel.numbers[i]) == 0) continue;
      errands_.answered(parcel.numbers[i], arrival.answers[i]);
    }
  }

  static void learn(double& mean, double latest) {
    constexpr double kNew = 0.1;  // weight of the latest
    mean = mean > 0 ? mean + kNew * (latest - mean) : latest;
  }

  /// A worker died of the parcel, or of one of its orders.
  void mourn(const Parcel& parcel, const Arrival& arrival) {
    const bool is_to_blame = !arrival.shared || parcel.was_by_itself;
    for (const std::size_t number : parcel.numbers) {
      if (!open_.contains(number)) continue;
      ++force_.sent_again_;
      if (parcel.numbers.size() > 1) {
        alone_.push_back(number);
      } else if (!is_to_blame) {
        suspects_.push_back(number);
      } else if ((deaths_[number] += arrival.deaths) < rules_.deaths) {
        (arrival.shared ? suspects_ : alone_).push_back(number);
      } else {
        --force_.sent_again_;
        open_.erase(number);
        errands_.lost(number, arrival.died);
      }
    }
  }

  /// What has been under way for too long is sent again, and its worker not counted on.
  void look_for_overdue() {
    if (overdue_ > 0) forget_answered();
    if (transport_.now() < next_look_) return;
    next_look_ = transport_.now() + kLookForOverdue;
    const double patience = patience_ * std::max(rules_.patience, kOverdue * force_.longest_);
    bool is_stuck = !parcels_.empty() && waiting_.empty() && alone_.empty();
    for (auto& [name, parcel] : parcels_) {
      if (parcel.is_overdue) continue;
      if (transport_.now() - parcel.sent < patience) {
        is_stuck = false;
        continue;
      }
      parcel.is_overdue = true;
      ++overdue_;
      for (const std::size_t number : parcel.numbers) {
        if (!open_.contains(number) || ++copies_[number] >= rules_.copies) continue;
        alone_.push_back(number);
        ++force_.sent_again_;
        is_stuck = false;
      }
    }
    if (is_stuck) try_anew();
  }

  /// Every copy of what is left is overdue: it may have gone to workers that do not answer. Each is
  /// sent once more, and gets twice the time.
  void try_anew() {
    patience_ *= 2;
    for (const std::size_t number : open_) {
      alone_.push_back(number);
      ++force_.sent_again_;
    }
    std::sort(alone_.begin(), alone_.end());
  }

  /// Parcels of which another copy has brought every answer.
  void forget_answered() {
    std::erase_if(parcels_, [&](const auto& entry) {
      const auto& numbers = entry.second.numbers;
      const bool is_answered =
          std::none_of(numbers.begin(), numbers.end(),
                       [&](std::size_t number) { return open_.contains(number); });
      overdue_ -= is_answered && entry.second.is_overdue;
      return is_answered;
    });
  }

  ParcelForce& force_;
  Transport& transport_;
  const ParcelRules& rules_;
  Errands& errands_;
  std::deque<std::size_t> waiting_;       ///< handed out to us, not sent yet
  std::deque<std::size_t> alone_;         ///< to be sent again, one by one
  std::deque<std::size_t> suspects_;      ///< to be sent when nothing else is under way
  std::unordered_set<std::size_t> open_;  ///< handed out to us and neither answered nor lost
  std::map<std::size_t, int> deaths_;
  std::map<std::size_t, Parcel> parcels_;  ///< under way
  std::size_t overdue_ = 0;                ///< of them
  bool next_is_none_ = false;              ///< as far as is known: answers may bring more
  std::map<std::size_t, int> copies_;      ///< of orders that were sent again unanswered
  double patience_ = 1;                    ///< times what it is by the rules
  double next_look_ = 0;                   ///< for parcels that are overdue
};

ParcelForce::ParcelForce(Transport& transport, const ParcelRules& rules)
    : transport_(transport), rules_(rules) {}

void ParcelForce::run(Errands& errands) { Run(*this, errands).carry_out(); }

}  // namespace camlaw::optim
