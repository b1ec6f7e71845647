// SPDX-License-Identifier: MIT
#include "optim/study/recorded_hands.h"

#include <utility>

namespace camlaw::optim {
namespace {

/// Errands but for those whose answers are known.
class Unrecorded final : public Errands {
 public:
  Unrecorded(Errands& all, StudyRecord& record) : all_(all), record_(record) {}

  std::optional<std::size_t> next() override {
    while (const auto number = all_.next()) {
      const auto order = all_.order(*number);
      const auto known = order ? record_.answer(*order) : std::nullopt;
      if (!known) return number;
      all_.answered(*number, *known);
    }
    return {};
  }
  std::optional<std::string> order(std::size_t number) override { return all_.order(number); }
  void answered(std::size_t number, const std::string& answer) override {
    // One that is empty was cut short.
    const auto order = answer.empty() ? std::nullopt : all_.order(number);
    if (order) record_.put_answer(*order, answer);
    all_.answered(number, answer);
  }
  void lost(std::size_t number, const std::string& why) override { all_.lost(number, why); }
  void told(std::size_t number, const std::string& news) override { all_.told(number, news); }
  double share() const override { return all_.share(); }
  const std::atomic<bool>* stop() const override { return all_.stop(); }
  bool is_done() const override { return all_.is_done(); }
  std::optional<double> farewell() const override { return all_.farewell(); }
  std::string confined() const override { return all_.confined(); }

 private:
  Errands& all_;
  StudyRecord& record_;
};

}  // namespace

Hands recorded_hands(Hands others, StudyRecord& record) {
  return [others = std::move(others), &record](Errands& errands, const Service& service) {
    Unrecorded left(errands, record);
    others(left, service);
  };
}

}  // namespace camlaw::optim
