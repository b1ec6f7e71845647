// SPDX-License-Identifier: MIT
#include "optim/crew/telling_hands.h"

#include <utility>

#include "optim/crew/passed_errands.h"

namespace camlaw::optim {
namespace {

class ToldErrands final : public PassedErrands {
 public:
  ToldErrands(Errands& all, const std::function<void(double)>& tell)
      : PassedErrands(all), tell_(tell) {}

  void answered(std::size_t number, const std::string& answer) override {
    all_.answered(number, answer);
    tell_(share());
  }

 private:
  const std::function<void(double)>& tell_;
};

}  // namespace

Hands telling_hands(Hands others, std::function<void(double share)> tell) {
  return [others = std::move(others), tell = std::move(tell)](Errands& errands,
                                                              const Service& service) {
    ToldErrands told(errands, tell);
    others(told, service);
  };
}

}  // namespace camlaw::optim
