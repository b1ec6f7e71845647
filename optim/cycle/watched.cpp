// SPDX-License-Identifier: MIT
#include "optim/cycle/watched.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {
namespace {

class WatchedTrace final : public Trace {
 public:
  WatchedTrace(std::unique_ptr<Trace> trace, const std::vector<double>& angles)
      : trace_(std::move(trace)), breaks_(trace_->breaks()) {
    constexpr double kSame = 1e-12;  // of the cycle: rounding moves one angle by no more
    const double first = breaks_.front(), last = breaks_.back();
    for (const double angle : angles) {
      const bool stands = std::any_of(breaks_.begin(), breaks_.end(), [&](double known) {
        return std::abs(known - angle) <= kSame * (last - first);
      });
      if (!stands && angle > first && angle < last) breaks_.push_back(angle);
    }
    std::sort(breaks_.begin(), breaks_.end());
  }

  std::vector<double> breaks() const override { return breaks_; }
  std::array<double, 3> at(Place place) const override { return trace_->at(place); }
  Bounds enclose(double from, double to) const override { return trace_->enclose(from, to); }

 private:
  std::unique_ptr<Trace> trace_;
  std::vector<double> breaks_;
};

class WatchedCurve final : public ForwardingCurve {
 public:
  WatchedCurve(std::shared_ptr<const Curve> curve, std::vector<double> angles)
      : ForwardingCurve(std::move(curve)), angles_(std::move(angles)) {}

  std::unique_ptr<Trace> trace(Design x) const override {
    return std::make_unique<WatchedTrace>(curve().trace(x), angles_);
  }
  double largest(Design x) const override { return curve().largest(x); }
  std::optional<double> largest_change(const std::vector<double>& scales, int places,
                                       double shortest) const override {
    return curve().largest_change(scales, places, shortest);
  }
  bool is_light() const override { return curve().is_light(); }

 private:
  std::vector<double> angles_;
};

}  // namespace

Response watched(const Response& response, std::vector<double> angles) {
  return with_curve<WatchedCurve>(response, std::move(angles));
}

}  // namespace camlaw::optim
