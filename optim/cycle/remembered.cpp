// SPDX-License-Identifier: MIT
#include "optim/cycle/remembered.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "optim/cycle/extremes.h"
#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {
namespace {

using Values = std::vector<std::array<double, 3>>;

/// One design's trace, the samples taken of it and the maxima found among them.
struct Memory {
  struct Stretch {
    double from, to;
    int count;
    Values values;
  };
  std::vector<double> x;
  std::unique_ptr<Trace> trace;
  std::vector<double> breaks;
  std::vector<Stretch> stretches;
  std::size_t next = 0;  ///< a stretch that is likely to be asked for: stretches come in turn
  struct Maxima {
    double sign;
    int samples;
    std::vector<Extreme> found;
  };
  std::vector<Maxima> maxima;
  /// Bounds of stretches, which objective and limits on either side ask for. Kept of light curves
  /// alone: those of others sharpen as they are asked again.
  std::map<std::pair<double, double>, Bounds> bounds;
  bool keeps_bounds = false;
};

class RememberedTrace final : public Trace, public RemembersMaxima {
 public:
  explicit RememberedTrace(std::shared_ptr<Memory> memory) : memory_(std::move(memory)) {}

  std::vector<double> breaks() const override { return memory_->breaks; }
  std::array<double, 3> at(Place place) const override { return memory_->trace->at(place); }
  Bounds enclose(double from, double to) const override {
    if (!memory_->keeps_bounds) return memory_->trace->enclose(from, to);
    const auto [at, is_fresh] = memory_->bounds.try_emplace({from, to});
    if (is_fresh) at->second = memory_->trace->enclose(from, to);
    return at->second;
  }
  Values even(double from, double to, int count) const override {
    auto& known = memory_->stretches;
    const auto is_asked_for = [&](const Memory::Stretch& s) {
      return s.from == from && s.to == to && s.count == count;
    };
    std::size_t at = memory_->next < known.size() ? memory_->next : 0;
    if (at >= known.size() || !is_asked_for(known[at])) {
      at = static_cast<std::size_t>(std::find_if(known.begin(), known.end(), is_asked_for) -
                                    known.begin());
    }
    memory_->next = at + 1;
    if (at < known.size()) return known[at].values;
    known.push_back({from, to, count, memory_->trace->even(from, to, count)});
    return known.back().values;
  }
  const std::vector<Extreme>& maxima(double sign, int samples) const override {
    for (const Memory::Maxima& known : memory_->maxima) {
      if (known.sign == sign && known.samples == samples) return known.found;
    }
    memory_->maxima.push_back({sign, samples, searched_maxima(*this, sign, samples)});
    return memory_->maxima.back().found;
  }

 private:
  std::shared_ptr<Memory> memory_;
};

class RememberedCurve final : public ForwardingCurve {
 public:
  using ForwardingCurve::ForwardingCurve;

  double largest(Design x) const override { return curve().largest(x); }
  std::optional<double> largest_change(const std::vector<double>& scales, int places,
                                       double shortest) const override {
    return curve().largest_change(scales, places, shortest);
  }
  bool is_light() const override { return curve().is_light(); }

  Function at(Place place) const override {
    if (is_light()) return curve().at(place);
    const auto key = std::tuple(place.angle, place.from_left, place.joint);
    const auto found = functions_.find(key);
    if (found != functions_.end()) return found->second;
    return functions_.emplace(key, curve().at(place)).first->second;
  }

  std::vector<Rest> rests(double bound, Design x) const override {
    if (!std::ranges::equal(x, rested_)) {
      rested_.assign(x.begin(), x.end());
      rests_.clear();
    }
    const auto known = rests_.find(bound);
    if (known != rests_.end()) return known->second;
    return rests_.emplace(bound, curve().rests(bound, x)).first->second;
  }

  std::unique_ptr<Trace> trace(Design x) const override {
    if (!latest_ || !std::equal(x.begin(), x.end(), latest_->x.begin(), latest_->x.end())) {
      auto fresh = std::make_shared<Memory>();
      fresh->x.assign(x.begin(), x.end());
      fresh->trace = curve().trace(fresh->x);
      fresh->breaks = fresh->trace->breaks();
      fresh->keeps_bounds = is_light();
      latest_ = std::move(fresh);
    }
    return std::make_unique<RememberedTrace>(latest_);
  }

 private:
  mutable std::shared_ptr<Memory> latest_;
  mutable std::vector<double> rested_;                 ///< the design that the rests are of
  mutable std::map<double, std::vector<Rest>> rests_;  ///< by bound
  mutable std::map<std::tuple<double, bool, int>, Function> functions_;
};

}  // namespace

Response remembered(const Response& response) {
  return response.is_curve() ? with_curve<RememberedCurve>(response) : response;
}

Problem remembered(Problem problem) {
  replace_curves(problem, [](const std::shared_ptr<const Curve>& curve) {
    return std::make_shared<RememberedCurve>(curve);
  });
  return problem;
}

}  // namespace camlaw::optim
