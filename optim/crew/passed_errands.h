// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "optim/crew/crew.h"

namespace camlaw::optim {

/// Errands that pass everything on to others: a base for those that change a part of it.
class PassedErrands : public Errands {
 public:
  explicit PassedErrands(Errands& all) : all_(all) {}

  std::optional<std::size_t> next() override { return all_.next(); }
  std::optional<std::string> order(std::size_t number) override { return all_.order(number); }
  void answered(std::size_t number, const std::string& answer) override {
    all_.answered(number, answer);
  }
  bool is_answer(std::size_t number, const std::string& answer) const override {
    return all_.is_answer(number, answer);
  }
  void lost(std::size_t number, const std::string& why) override { all_.lost(number, why); }
  void told(std::size_t number, const std::string& news) override { all_.told(number, news); }
  double share() const override { return all_.share(); }
  const std::atomic<bool>* stop() const override { return all_.stop(); }
  bool is_done() const override { return all_.is_done(); }
  std::optional<double> farewell() const override { return all_.farewell(); }
  std::string confined() const override { return all_.confined(); }

 protected:
  Errands& all_;
};

}  // namespace camlaw::optim
