// SPDX-License-Identifier: MIT
#include "fitting/constants/printed_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fitting/motions/coefficients.h"
#include "optim/cycle/peak_function.h"
#include "optim/cycle/remembered.h"
#include "optim/search/deadline.h"

namespace camlaw::problems {
namespace {

using optim::Function;

/// One constant of a model.
class ConstantKernel final : public optim::Kernel {
 public:
  ConstantKernel(const PrintedModel& model, std::size_t constant)
      : model_(model), constant_(constant) {}
  double value(std::span<const double> u) const override { return model_.value(constant_, u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const auto here = model_.at(u);
    std::copy_n(here->slopes.begin() + static_cast<std::ptrdiff_t>(constant_ * u.size()), u.size(),
                g.begin());
    return here->values[constant_];
  }
  /// Not known: the search goes by first derivatives.
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill(h.begin(), h.end(), std::numeric_limits<double>::quiet_NaN());
    return gradient(u, g);
  }
  bool is_searched() const override { return true; }

 private:
  const PrintedModel& model_;
  std::size_t constant_;
};

Binding bound(const std::vector<double>& constants, std::shared_ptr<const LawBinding> law) {
  Binding result;
  result.constants = constants;
  result.law = std::move(law);
  return result;
}

}  // namespace

std::vector<Unknown> unknowns_of(const ConstantsQuestion& question, const Member& law) {
  std::vector<Unknown> result;
  for (const VariableStatement& v : question.machine.variables) {
    if (v.of_law) continue;
    result.push_back({v.name, v.unit, false, v.parameter, 0, v.lower, v.upper, v.start});
  }
  for (const Coefficient& c : coefficients_of(law)) {
    result.push_back({c.name, c.unit, true, c.at.parameter, c.at.element, c.low, c.high, c.value});
  }
  return result;
}

PrintedModel::PrintedModel(const ConstantsQuestion& question, Member law)
    : question_(&question), law_(std::move(law)), unknowns_(unknowns_of(question, law_)) {
  std::vector<LawVariable> of_law;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const Unknown& u = unknowns_[i];
    if (u.of_law) of_law.push_back({u.parameter, u.element, i});
  }
  binding_ = std::make_shared<LawBinding>(law_, std::move(of_law));
  Binding machine = bound(question.machine.constants, binding_);
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].of_law) continue;
    machine.parameters.push_back(unknowns_[i].parameter);
    machine.variables.push_back(i);
  }
  // The law's own constants do not see the machine.
  const Binding alone = bound(law_alone().constants, binding_);
  for (const PrintedConstant& c : question.constants) {
    of_law_.push_back(law_constant(c));
    functions_.emplace_back();
    if (of_law_.back()) continue;
    const bool of_machine = c.of == question.machine.mechanism.get();
    const optim::Response response =
        optim::remembered(make_response(*c.of, c.response, of_machine ? machine : alone));
    functions_.back() = response.is_curve()
                            ? optim::peak_function(response, c.response.part, unknowns_.size())
                            : response.function();
  }
}

ConstantsAt PrintedModel::evaluated(std::span<const double> x) const {
  optim::Deadline({}, question_->machine.stop).check();
  ConstantsAt result{std::vector<double>(constants().size()),
                     std::vector<double>(constants().size() * x.size(), 0.0)};
  std::vector<LawConstant> wanted;
  for (const auto& constant : of_law_) {
    if (constant) wanted.push_back(*constant);
  }
  const ConstantsAt peaks = wanted.empty() ? ConstantsAt{} : law_constants(wanted, *binding_, x);
  std::size_t next = 0;
  for (std::size_t c = 0; c < constants().size(); ++c) {
    const std::span<double> slopes(result.slopes.data() + c * x.size(), x.size());
    if (of_law_[c]) {
      result.values[c] = peaks.values[next];
      std::copy_n(peaks.slopes.begin() + static_cast<std::ptrdiff_t>(next * x.size()), x.size(),
                  slopes.begin());
      ++next;
      continue;
    }
    const Function& f = functions_[c];
    std::vector<double> g(f.inputs().size());
    result.values[c] = f.gradient(x, g);
    for (std::size_t i = 0; i < g.size(); ++i) slopes[f.inputs()[i]] = g[i];
  }
  return result;
}

std::shared_ptr<const ConstantsAt> PrintedModel::at(std::span<const double> x) const {
  return recent_.get(x, [&] { return evaluated(x); });
}

bool PrintedModel::agrees(std::size_t constant, std::span<const double> x) const {
  constexpr double kRounding = 1e-9;  // of the interval, which a search may end on the edge of
  const PrintedConstant& c = constants()[constant];
  const double v = value(constant, x);
  if (std::isinf(c.value)) return v == c.value;
  const double room = kRounding * std::max(c.high - c.low, std::abs(c.value));
  return v >= c.low - room && v <= c.high + room;
}

optim::Response PrintedModel::response(std::size_t constant) const {
  std::vector<std::size_t> all(unknowns_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {constants()[constant].name, "1",
          Function(std::move(all), std::make_shared<ConstantKernel>(*this, constant))};
}

std::vector<double> PrintedModel::defaults() const {
  std::vector<double> result;
  for (const Unknown& u : unknowns_) result.push_back(u.default_value);
  return result;
}

Member PrintedModel::law_at(std::span<const double> x) const {
  Member result = law_;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const Unknown& u = unknowns_[i];
    if (u.of_law) result.arguments.values()[u.parameter][u.element] = x[i];
  }
  return result;
}

std::vector<double> PrintedModel::place_of(std::size_t number) const {
  std::vector<double> x = defaults();
  if (number == 0) return x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // Additive recurrence by powers of the plastic constant: even in few dimensions and in many.
    constexpr double kStep = 0.7548776662466927;
    const double power = std::pow(kStep, 1 + static_cast<double>(i));
    const double share = std::fmod(0.5 + static_cast<double>(number) * power, 1.0);
    x[i] = unknowns_[i].lower + share * (unknowns_[i].upper - unknowns_[i].lower);
  }
  return x;
}

const std::vector<PrintedModel::Place>& PrintedModel::places() const {
  constexpr std::size_t kPlaces = 24;
  std::call_once(places_made_, [this] {
    while (places_.size() < kPlaces && !unknowns_.empty()) {
      Place place{place_of(places_.size()), {}};
      place.at = evaluated(place.x);
      places_.push_back(std::move(place));
    }
  });
  return places_;
}

}  // namespace camlaw::problems
