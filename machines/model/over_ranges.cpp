// SPDX-License-Identifier: MIT
#include "machines/model/over_ranges.h"

#include <algorithm>
#include <cmath>

#include "machines/model/arguments.h"
#include "machines/model/composed_number.h"
#include "machines/model/kept_parameters.h"
#include "machines/model/range_curve.h"
#include "machines/model/recorded_kernel.h"
#include "machines/model/recorded_response.h"
#include "optim/cycle/peak_function.h"

namespace camlaw::problems {

using optim::Design, optim::Place;

namespace {

/// The binding with what the ranges hold as constants; what a range moves with still varies.
Binding without_ranges(const Binding& binding, const std::vector<TakenRange>& ranges) {
  return keeping(binding, [&](std::size_t parameter) {
    return std::none_of(ranges.begin(), ranges.end(), [&](const TakenRange& range) {
      return range.parameter == parameter && !range.is_offset;
    });
  });
}

/// A binding widened by the ranges of a response.
std::shared_ptr<const Widened> widened_by(const std::vector<TakenRange>& ranges,
                                          const PossibleBy& possible_by, const Binding& binding) {
  return std::make_shared<const Widened>(
      widened(without_ranges(binding, ranges), ranges, possible_by));
}

/// A number that has a value where another one of the same inputs is 0 or above. Its bounds over a
/// box hold wherever it has one (Kernel::range); here nothing bounds it where it may have none.
class WithinDomain final : public optim::Kernel {
 public:
  WithinDomain(optim::Function f, optim::Function domain)
      : f_(std::move(f)), domain_(std::move(domain)) {}

  double value(std::span<const double> u) const override { return f_.value(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return f_.gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return f_.hessian(u, g, h);
  }
  optim::Bounds enclose(std::span<const double> u) const override {
    return is_inside(domain_.enclose(u)) ? f_.enclose(u) : optim::Bounds{};
  }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    optim::BoxRange all = f_.range(box);
    if (is_inside(domain_.range(box).value)) return all;
    all.value = {};
    std::fill(all.slopes.begin(), all.slopes.end(), optim::Bounds{});
    return all;
  }
  bool is_searched() const override { return f_.is_searched(); }
  std::shared_ptr<const optim::Kernel> proved() const override {
    if (!f_.is_searched()) return nullptr;
    return std::make_shared<WithinDomain>(f_.proved(), domain_);
  }
  bool is_enclosed() const override { return f_.is_enclosed(); }
  std::string why_undefined(std::span<const double> u) const override {
    return f_.why_undefined(u);
  }

 private:
  static bool is_inside(const optim::Bounds& condition) {
    // Rounding of the condition at its edge, where the formula still has its value.
    constexpr double kRounding = 1e-12;
    const double size = std::max(std::abs(condition.lower), std::abs(condition.upper));
    return std::isfinite(size) && condition.lower >= -kRounding * size;
  }

  optim::Function f_, domain_;  ///< of the inputs alone
};

/// A number of a mechanism for a binding, which knows where it may have no value.
optim::Function number_within_domain(const MechanismResponse& response, const Binding& binding) {
  const optim::Function f = response.number(binding, optim::Shape::General);
  if (!response.domain || !f.is_enclosed()) return f;
  Recorded domain = recorded_for(binding, response.domain, response.inner.size(), {});
  const optim::Function condition =
      response.inner.empty()
          ? function_of(binding.variables, recorded_kernel(std::move(domain)),
                        optim::Shape::General)
          : composed_number(std::move(domain), binding, response.inner, optim::Shape::General);
  const auto& inputs = f.inputs();
  if (!std::includes(inputs.begin(), inputs.end(), condition.inputs().begin(),
                     condition.inputs().end())) {
    return f;
  }
  return {inputs, std::make_shared<WithinDomain>(f.within(inputs), condition.within(inputs)),
          f.shape()};
}

}  // namespace

void make_plain_number(MechanismResponse& response) {
  response.write = {};
  response.turn = {};
  response.inner = {};
  response.shapes = {};
  response.curve = {};
  response.cycle = {};
  response.along = {};
  response.over_cases = {};
  response.over_ranges = {};
}

bool depends_on(const MechanismResponse& response, const std::vector<TakenRange>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const TakenRange& range) {
    return response.uses.holds(range.parameter) || response.possible_by.holds(range.parameter);
  });
}

std::shared_ptr<const MechanismResponse> over_ranges(const MechanismResponse& response,
                                                     std::vector<TakenRange> ranges, bool highest) {
  std::erase_if(ranges, [&](const TakenRange& range) { return !depends_on(response, {range}); });
  const double sign = highest ? 1 : -1;
  auto result = std::make_shared<MechanismResponse>(response);
  result->write = {};
  result->turn = {};
  result->inner = {};
  result->shapes = {};
  result->possible_by.ranges = parameters_of(ranges);
  auto over = std::make_shared<OverRanges>();
  over->ranges = ranges;
  over->of = std::make_shared<MechanismResponse>(response);
  over->all_possible = [ranges, by = response.possible_by](const Binding& binding, Design x) {
    return widened_by(ranges, by, binding)->machines_at(x).all_possible;
  };
  if (response.curve) {
    result->curve = [response, ranges, sign](const Binding& binding, optim::Shape) {
      return range_curve(response, ranges, sign, without_ranges(binding, ranges));
    };
    over->worst = [response, ranges, sign](const Binding& binding, Design x, const Place* place) {
      const Binding own = without_ranges(binding, ranges);
      return range_curve(response, ranges, sign, own)->worst(*place, x);
    };
    over->left = [response, ranges, sign](const Binding& binding, Design x,
                                          const optim::Bounds* stretch) {
      const Binding own = without_ranges(binding, ranges);
      return range_curve(response, ranges, sign, own)->left(stretch->lower, stretch->upper, x);
    };
  } else {
    const auto kernel = [response, ranges](const Binding& binding) {
      const auto wide = widened_by(ranges, response.possible_by, binding);
      return std::pair(number_within_domain(response, wide->binding), wide);
    };
    result->number = [kernel, sign](const Binding& binding, optim::Shape) {
      const auto [f, wide] = kernel(binding);
      return highest_of(f, wide, sign);
    };
    over->worst = [kernel, sign](const Binding& binding, Design x, const Place*) {
      const auto [f, wide] = kernel(binding);
      const HighestKernel own = HighestKernel(f, wide, sign).asking_proof();
      std::vector<double> u;
      for (const std::size_t input : own.own_inputs()) u.push_back(x[input]);
      return told(f, *wide, x, own.worst(u));
    };
    over->left = [kernel, sign](const Binding& binding, Design x, const optim::Bounds*) {
      const auto [f, wide] = kernel(binding);
      const HighestKernel own(f, wide, sign);
      std::vector<double> u;
      for (const std::size_t input : own.own_inputs()) u.push_back(x[input]);
      return f.is_enclosed() ? own.left(u) : Box{};
    };
  }
  result->over_ranges = std::move(over);
  return result;
}

namespace {

/// The named part of a curve as a number of a design in which ranges vary too.
struct WidePeak {
  std::shared_ptr<const Mechanism> mechanism;
  ResponseName name;
  std::vector<TakenRange> ranges;
  std::shared_ptr<const MechanismResponse> of;

  std::pair<optim::Function, std::shared_ptr<const Widened>> operator()(
      const Binding& binding) const {
    ResponseName own = name;
    own.response = of.get();
    auto wide = widened_by(ranges, of->possible_by, binding);
    const optim::Response curve = make_response(*mechanism, own, wide->binding);
    return {optim::peak_function(curve, own.part, wide->first + ranges.size()), std::move(wide)};
  }
};

std::shared_ptr<MechanismResponse> number_of(const WidePeak& peak, double sign) {
  auto result = std::make_shared<MechanismResponse>(*peak.of);
  make_plain_number(*result);
  result->possible_by.ranges = parameters_of(peak.ranges);
  result->number = [peak, sign](const Binding& binding, optim::Shape) {
    const auto [f, wide] = peak(binding);
    return highest_of(f, wide, sign);
  };
  return result;
}

}  // namespace

std::shared_ptr<const MechanismResponse> number_over_ranges(
    std::shared_ptr<const Mechanism> mechanism, const ResponseName& name,
    std::vector<TakenRange> ranges, bool highest) {
  if (!name.response->curve) return over_ranges(*name.response, std::move(ranges), highest);
  auto of = std::make_shared<const MechanismResponse>(*name.response);
  return number_of({std::move(mechanism), name, std::move(ranges), std::move(of)},
                   highest ? 1.0 : -1.0);
}

std::shared_ptr<const MechanismResponse> peak_over_ranges(
    std::shared_ptr<const Mechanism> mechanism, const ResponseName& name,
    std::vector<TakenRange> ranges, bool highest) {
  std::erase_if(ranges, [&](const auto& range) { return !depends_on(*name.response, {range}); });
  if (!name.response->curve) return over_ranges(*name.response, std::move(ranges), highest);
  const double sign = highest ? 1 : -1;
  const WidePeak peak{std::move(mechanism), name, ranges,
                      std::make_shared<const MechanismResponse>(*name.response)};
  const auto result = number_of(peak, sign);
  auto over = std::make_shared<OverRanges>();
  over->ranges = std::move(ranges);
  over->of = peak.of;
  over->all_possible = [peak](const Binding& binding, Design x) {
    return widened_by(peak.ranges, peak.of->possible_by, binding)->machines_at(x).all_possible;
  };
  over->worst = [peak, sign](const Binding& binding, Design x, const Place*) {
    const auto [f, wide] = peak(binding);
    const HighestKernel own(f, wide, sign);
    std::vector<double> u;
    for (const std::size_t input : own.own_inputs()) u.push_back(x[input]);
    return told(f, *wide, x, own.worst(u));
  };
  result->over_ranges = std::move(over);
  return result;
}

}  // namespace camlaw::problems
