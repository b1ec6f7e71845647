// SPDX-License-Identifier: MIT
#include "optim/study/recorded_hands.h"

#include <map>
#include <string>
#include <utility>

#include "optim/crew/passed_errands.h"

namespace camlaw::optim {
namespace {

/// Errands but for those whose answers are known.
class Unrecorded final : public PassedErrands {
 public:
  Unrecorded(Errands& all, StudyRecord& record) : PassedErrands(all), record_(record) {}

  std::optional<std::size_t> next() override {
    while (const auto number = all_.next()) {
      auto order = all_.order(*number);
      const auto known = order ? record_.answer(*order) : std::nullopt;
      if (known && all_.is_answer(*number, *known)) {
        all_.answered(*number, *known);
        continue;
      }
      if (order) orders_[*number] = std::move(*order);
      return number;
    }
    return {};
  }
  std::optional<std::string> order(std::size_t number) override {
    const auto at = orders_.find(number);
    return at == orders_.end() ? std::nullopt : std::optional(at->second);
  }
  void answered(std::size_t number, const std::string& answer) override {
    const auto at = orders_.find(number);
    if (at != orders_.end() && all_.is_answer(number, answer)) {
      record_.put_answer(at->second, answer);
    }
    orders_.erase(number);
    all_.answered(number, answer);
  }
  void lost(std::size_t number, const std::string& why) override {
    orders_.erase(number);
    all_.lost(number, why);
  }

 private:
  StudyRecord& record_;
  std::map<std::size_t, std::string> orders_;  ///< under way
};

}  // namespace

Hands recorded_hands(Hands others, StudyRecord& record) {
  return [others = std::move(others), &record](Errands& errands, const Service& service) {
    Unrecorded left(errands, record);
    others(left, service);
  };
}

}  // namespace camlaw::optim
