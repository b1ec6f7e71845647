// SPDX-License-Identifier: MIT
#include "machines/model/over_ranges.h"

#include <algorithm>

#include "machines/model/kept_parameters.h"
#include "machines/model/range_curve.h"
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
      return std::pair(response.number(wide->binding, optim::Shape::General), wide);
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

std::shared_ptr<const MechanismResponse> number_over_ranges(
    std::shared_ptr<const Mechanism> mechanism, const ResponseName& name,
    std::vector<TakenRange> ranges, bool highest) {
  if (!name.response->curve) return over_ranges(*name.response, std::move(ranges), highest);
  auto result = std::make_shared<MechanismResponse>(*name.response);
  make_plain_number(*result);
  result->possible_by.ranges = parameters_of(ranges);
  result->number = [mechanism = std::move(mechanism), name, ranges = std::move(ranges),
                    of = std::make_shared<const MechanismResponse>(*name.response),
                    sign = highest ? 1.0 : -1.0](const Binding& binding, optim::Shape) {
    ResponseName own = name;
    own.response = of.get();
    const auto wide = widened_by(ranges, of->possible_by, binding);
    const optim::Response curve = make_response(*mechanism, own, wide->binding);
    return highest_of(optim::peak_function(curve, own.part, wide->first + ranges.size()), wide,
                      sign);
  };
  return result;
}

}  // namespace camlaw::problems
