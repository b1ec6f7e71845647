// SPDX-License-Identifier: MIT
#include "fitting/constants/printed_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/motions/coefficients.h"
#include "kinematics/laws/build.h"
#include "optim/cycle/peak_function.h"
#include "optim/cycle/remembered.h"
#include "optim/problem/deadline.h"

namespace camlaw::problems {
namespace {

using optim::Function;

Binding bound(const std::vector<double>& constants, std::shared_ptr<const LawBinding> law) {
  Binding result;
  result.constants = constants;
  result.law = std::move(law);
  return result;
}

}  // namespace

std::vector<Unknown> machine_unknowns_of(const ConstantsQuestion& question) {
  std::vector<Unknown> result;
  for (const VariableStatement& v : question.machine.variables) {
    if (v.of_law) continue;
    result.push_back({v.name, v.unit, false, v.parameter, 0, v.lower, v.upper, v.start});
  }
  return result;
}

std::vector<Unknown> unknowns_of(const ConstantsQuestion& question, const Member& law) {
  std::vector<Unknown> result = machine_unknowns_of(question);
  for (const Coefficient& c : coefficients_of(law)) {
    result.push_back({c.name, c.unit, true, c.at.parameter, c.at.element, c.low, c.high, c.value});
  }
  return result;
}

PrintedModel::PrintedModel(const ConstantsQuestion& question, Member law)
    : PrintedModel(question, law, unknowns_of(question, law)) {}

PrintedModel::PrintedModel(const ConstantsQuestion& question, Member law,
                           std::vector<Unknown> unknowns)
    : question_(&question), law_(std::move(law)), unknowns_(std::move(unknowns)) {
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
  const auto& rooms = law_.family->rooms;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    // Printed numbers need not leave exactly nothing: a law of them takes as much.
    constexpr double kInside = 0.99;  // for rounding
    const double room = rooms[i].is_equal ? kInside * kPrintedSum : 0;
    rooms_.push_back({i, -room, rooms[i].is_equal ? room : optim::kInfinity});
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
  add_rooms(x, result);
  return result;
}

void PrintedModel::add_rooms(std::span<const double> x, ConstantsAt& result) const {
  if (rooms_.empty()) return;
  const std::vector<double> values = binding_->values_at(x);
  std::vector<Dual> seeded(values.begin(), values.end());
  for (const LawRoom& room : rooms_) {
    const auto& left = law_.family->rooms[room.number].left;
    result.values.push_back(left.make(binding_->arguments_of<double>(values)));
    result.slopes.resize(result.slopes.size() + x.size(), 0.0);
    double* slopes = &result.slopes[result.slopes.size() - x.size()];
    for (std::size_t first = 0; first < seeded.size(); first += kDualWidth) {
      const std::size_t end = std::min<std::size_t>(first + kDualWidth, seeded.size());
      for (std::size_t i = first; i < end; ++i) seeded[i].v[static_cast<int>(i - first)] = 1;
      const Dual value = left.make(binding_->arguments_of<Dual>(seeded));
      for (std::size_t i = first; i < end; ++i) {
        slopes[binding_->variables()[i].variable] = value.v[static_cast<int>(i - first)];
        seeded[i] = Dual(values[i]);
      }
    }
  }
}

std::shared_ptr<const ConstantsAt> PrintedModel::at(std::span<const double> x) const {
  return recent_.get(x, [&] { return evaluated(x); });
}

bool PrintedModel::all_agree(std::span<const std::size_t> constants,
                             std::span<const double> x) const {
  return std::all_of(constants.begin(), constants.end(),
                     [&](std::size_t c) { return agrees(c, x); });
}

bool PrintedModel::agrees(std::size_t constant, std::span<const double> x) const {
  constexpr double kRounding = 1e-9;  // of the interval, which a search may end on the edge of
  const PrintedConstant& c = constants()[constant];
  const double v = value(constant, x);
  if (std::isinf(c.value)) return v == c.value;
  const double room = kRounding * std::max(c.high - c.low, std::abs(c.value));
  return v >= c.low - room && v <= c.high + room;
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

/// The least change after which a constant may be twice as large or nothing, as far as slopes lead.
void PrintedModel::find_scales() const {
  const auto here = at(defaults());
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const Unknown& u = unknowns_[i];
    const double range = u.upper - u.lower;
    double size = range;
    for (std::size_t c = 0; c < constants().size(); ++c) {
      const double change = std::abs(here->values[c] / here->slopes[c * unknowns_.size() + i]);
      if (std::isfinite(change)) size = std::min(size, change);
    }
    // Of the range: a constant that changes without end is no scale.
    constexpr double kLeast = 1e-6;
    scales_.push_back({u.lower, u.upper, u.default_value, std::max(size, kLeast * range)});
  }
}

const std::vector<SearchScale>& PrintedModel::scales() const {
  std::call_once(scales_found_, [this] { find_scales(); });
  return scales_;
}

const std::vector<PrintedModel::Place>& PrintedModel::places() const {
  std::call_once(places_made_, [this] {
    const auto of_law = std::count_if(unknowns_.begin(), unknowns_.end(),
                                      [](const Unknown& u) { return u.of_law; });
    const std::size_t first = unknowns_.size() - static_cast<std::size_t>(of_law);
    const auto limit = of_law > 0 ? limit_of(law_) : std::nullopt;
    for (std::vector<double>& x : search_places(scales(), limit, first)) {
      Place place{std::move(x), {}, {}};
      for (std::size_t i = 0; i < place.x.size(); ++i) {
        place.coordinates.push_back(scales()[i].coordinate(place.x[i]));
      }
      place.at = evaluated(place.x);
      places_.push_back(std::move(place));
    }
  });
  return places_;
}

const Stretches& PrintedModel::stretches(std::size_t constant) const {
  std::call_once(stretches_found_, [this] {
    std::vector<const Place*> order;
    for (const Place& place : places()) order.push_back(&place);
    std::sort(order.begin(), order.end(),
              [](const Place* a, const Place* b) { return a->x[0] < b->x[0]; });
    for (std::size_t c = 0; c < constants().size(); ++c) {
      std::vector<SlopedValue> places;
      for (const Place* place : order) {
        if (!places.empty() && place->x[0] == places.back().x) continue;
        places.push_back({place->x[0], place->at.values[c], place->at.slopes[c]});
      }
      const auto f = [&](double x) {
        const auto here = at(std::span(&x, 1));
        return SlopedValue{x, here->values[c], here->slopes[c]};
      };
      const PrintedConstant& printed = constants()[c];
      stretches_.push_back(std::isfinite(printed.value)
                               ? stretches_between(f, places, printed.low, printed.high)
                               : Stretches{});
    }
  });
  return stretches_[constant];
}

}  // namespace camlaw::problems
