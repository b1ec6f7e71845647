// SPDX-License-Identifier: MIT
#include "optim/search/interruptible.h"

#include <type_traits>
#include <utility>

#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {
namespace {

/// What a look gives, within the deadline and only if that has not passed.
template <class Look>
std::invoke_result_t<Look> in_time(const Deadline& deadline, const Look& look) {
  const DeadlineScope scope(deadline);
  deadline.check();
  return look();
}

/// A function of its own inputs, in order.
class InterruptibleKernel final : public Kernel {
 public:
  InterruptibleKernel(Function function, const Deadline& deadline)
      : function_(std::move(function)), deadline_(deadline) {}

  double value(std::span<const double> u) const override {
    return in_time(deadline_, [&] { return function_.value(u); });
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return in_time(deadline_, [&] { return function_.gradient(u, g); });
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return in_time(deadline_, [&] { return function_.hessian(u, g, h); });
  }
  Bounds enclose(std::span<const double> u) const override {
    deadline_.check();
    return function_.enclose(u);
  }
  BoxRange range(std::span<const Bounds> box) const override {
    deadline_.check();
    return function_.range(box);
  }
  bool is_searched() const override { return function_.is_searched(); }
  std::shared_ptr<const Kernel> proved() const override {
    if (!is_searched()) return nullptr;
    return std::make_shared<InterruptibleKernel>(function_.proved(), deadline_);
  }
  bool is_enclosed() const override { return function_.is_enclosed(); }
  std::string why_undefined(std::span<const double> u) const override {
    return function_.why_undefined(u);
  }

 private:
  Function function_;
  Deadline deadline_;
};

Function interruptible(const Function& f, const Deadline& deadline) {
  const auto& inputs = f.inputs();
  return {inputs, std::make_shared<InterruptibleKernel>(f.within(inputs), deadline), f.shape()};
}

class InterruptibleTrace final : public Trace {
 public:
  InterruptibleTrace(std::unique_ptr<Trace> trace, const Deadline& deadline)
      : trace_(std::move(trace)), deadline_(deadline) {}

  std::vector<double> breaks() const override { return trace_->breaks(); }
  std::array<double, 3> at(Place place) const override {
    return in_time(deadline_, [&] { return trace_->at(place); });
  }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    return in_time(deadline_, [&] { return trace_->even(from, to, count); });
  }
  std::vector<double> values(std::span<const Place> places) const override {
    return in_time(deadline_, [&] { return trace_->values(places); });
  }
  Bounds enclose(double from, double to) const override {
    return in_time(deadline_, [&] { return trace_->enclose(from, to); });
  }
  std::array<Bounds, 3> expand(double from, double to) const override {
    return in_time(deadline_, [&] { return trace_->expand(from, to); });
  }
  std::string why_unbounded() const override { return trace_->why_unbounded(); }

 private:
  std::unique_ptr<Trace> trace_;
  Deadline deadline_;
};

class InterruptibleCurve final : public ForwardingCurve {
 public:
  InterruptibleCurve(std::shared_ptr<const Curve> curve, const Deadline& deadline)
      : ForwardingCurve(std::move(curve)), deadline_(deadline) {}

  Function at(Place place) const override {
    deadline_.check();
    return is_light() ? curve().at(place) : interruptible(curve().at(place), deadline_);
  }
  double largest(Design x) const override {
    deadline_.check();
    return curve().largest(x);
  }
  std::optional<double> largest_change(const std::vector<double>& scales, int places,
                                       double shortest) const override {
    deadline_.check();
    return curve().largest_change(scales, places, shortest);
  }
  bool is_light() const override { return curve().is_light(); }
  std::vector<double> slope_gradient(Place place, Design x) const override {
    deadline_.check();
    return curve().slope_gradient(place, x);
  }
  std::vector<Rest> rests(double bound, Design x) const override {
    deadline_.check();
    std::vector<Rest> rests = curve().rests(bound, x);
    for (Rest& rest : rests) rest.leading = interruptible(rest.leading, deadline_);
    return rests;
  }
  std::unique_ptr<Trace> trace(Design x) const override {
    return in_time(deadline_, [&] {
      return std::make_unique<InterruptibleTrace>(curve().trace(x), deadline_);
    });
  }

 private:
  Deadline deadline_;
};

}  // namespace

bool is_interruption(const std::exception_ptr& error) {
  if (!error) return false;
  try {
    std::rethrow_exception(error);
  } catch (const Interrupted&) {
    return true;
  } catch (...) {
    return false;
  }
}

Response interruptible(Response response, const Deadline& deadline) {
  if (response.is_curve()) return with_curve<InterruptibleCurve>(response, deadline);
  response.measure = interruptible(response.function(), deadline);
  return response;
}

Problem interruptible(Problem problem, const Deadline& deadline) {
  replace_curves(problem, [&](const std::shared_ptr<const Curve>& curve) {
    return std::make_shared<InterruptibleCurve>(curve, deadline);
  });
  const auto make = [&](Response& response) {
    if (!response.is_curve()) response = interruptible(std::move(response), deadline);
  };
  for (Objective& objective : problem.objectives) make(objective.response);
  for (Constraint& c : problem.constraints) make(c.response);
  return problem;
}

}  // namespace camlaw::optim
