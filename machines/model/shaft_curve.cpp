// SPDX-License-Identifier: MIT
#include "machines/model/shaft_curve.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "machines/model/arguments.h"
#include "machines/model/cycle.h"
#include "machines/model/enclosed.h"
#include "machines/model/held_boxes.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/law_binding.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft_row.h"
#include "numerics/formula/expression.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// The design that a binding was made for.
std::vector<double> own_design(const Binding& binding) {
  std::vector<double> x(design_size(binding));
  for (std::size_t k = 0; k < binding.variables.size(); ++k) {
    x[binding.variables[k]] = binding.constants[binding.parameters[k]];
  }
  for (const LawVariable& v : binding.law->variables()) {
    x[v.variable] = binding.law->member().arguments.list(v.parameter)[v.element];
  }
  return x;
}

/// The curve of one design.
class ShaftTrace final : public optim::Trace {
 public:
  ShaftTrace(std::shared_ptr<const ShaftParts> parts, optim::Design x)
      : parts_(std::move(parts)),
        arguments_(parts_->arguments_at(x)),
        plain_(parts_->record.formula, arguments_) {
    for (const ShaftParts::Held& held : parts_->held) {
      phases_.push_back(held.phase_at(x));
      traces_.push_back(held.curve->trace(x));
      own_breaks_.push_back(traces_.back()->breaks());
    }
    find_breaks();
  }

  std::vector<double> breaks() const override { return breaks_; }

  std::array<double, 3> at(optim::Place place) const override {
    std::vector<Series<double, 3>> inputs{
        Series<double, 3>::variable(place.angle * kDegree, kDegree)};
    for (std::size_t k = 0; k < traces_.size(); ++k) {
      const auto d =
          traces_[k]->at(cam_place(place.angle, place.from_left, phases_[k], own_breaks_[k]));
      Series<double, 3> curve(d[0]);
      curve.c[1] = d[1], curve.c[2] = d[2] / 2;
      inputs.push_back(curve);
    }
    const auto f = plain_(std::span<const Series<double, 3>>(inputs));
    return {f.c[0], f.c[1], 2 * f.c[2]};
  }

  std::vector<double> values(std::span<const optim::Place> places) const override {
    std::vector<std::vector<double>> curves;
    for (std::size_t k = 0; k < traces_.size(); ++k) {
      std::vector<optim::Place> own;
      for (const optim::Place& place : places) {
        own.push_back(cam_place(place.angle, place.from_left, phases_[k], own_breaks_[k]));
      }
      curves.push_back(traces_[k]->values(own));
    }
    std::vector<double> result, inputs(1 + traces_.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      inputs[0] = places[i].angle * kDegree;
      for (std::size_t k = 0; k < curves.size(); ++k) inputs[1 + k] = curves[k][i];
      result.push_back(plain_(std::span<const double>(inputs)));
    }
    return result;
  }

  optim::Bounds enclose(double from, double to) const override {
    if (!enclosing_) make_enclosing();
    const double middle = std::midpoint(from, to);
    const double radius = std::max(step_up(to - middle), step_up(middle - from)) + 2 * kShaftMargin;
    const auto value = [&](double angle) { return over<1>(angle, angle, middle).c[0]; };
    return enclosed(
        over<3>(from, to, middle), radius, [&] { return value(from); }, [&] { return value(to); },
        [&] { return over<2>(middle, middle, middle); });
  }

  std::string why_unbounded() const override {
    for (const auto& trace : traces_) {
      if (std::string why = trace->why_unbounded(); !why.empty()) return why;
    }
    return {};
  }

 private:
  PlacedBreaks placed(std::size_t k) const { return {own_breaks_[k], phases_[k]}; }

  void find_breaks() {
    std::vector<PlacedBreaks> all;
    for (std::size_t k = 0; k < traces_.size(); ++k) all.push_back(placed(k));
    breaks_ = breaks_on_shaft(all);
  }

  void make_enclosing() const {
    const std::vector<Interval> exact(arguments_.begin(), arguments_.end());
    enclosing_.emplace(parts_->record.formula, std::span<const Interval>(exact));
    if (parts_->domain) {
      domain_.emplace(parts_->domain->formula, std::span<const Interval>(exact));
    }
  }

  template <std::size_t N>
  Series<Interval, N> over(double from, double to, double middle) const {
    const Interval degree = pi<Interval>() / Interval(180.0);
    const Interval range(from - kShaftMargin, to + kShaftMargin);
    std::vector<Series<Interval, N>> inputs{Series<Interval, N>::variable(range * degree, degree)};
    for (std::size_t k = 0; k < traces_.size(); ++k) {
      const auto bounds = expand_on_shaft(*traces_[k], placed(k), from, to, middle);
      Series<Interval, N> curve;
      for (std::size_t i = 0; i < N; ++i) curve.c[i] = interval_of(bounds[i]);
      inputs.push_back(curve);
    }
    const auto value = (*enclosing_)(std::span<const Series<Interval, N>>(inputs));
    if (!domain_) return value;
    std::vector<Interval> plain;
    for (const auto& input : inputs) plain.push_back(input.c[0]);
    return known_where((*domain_)(std::span<const Interval>(plain)), value);
  }

  std::shared_ptr<const ShaftParts> parts_;
  std::vector<double> arguments_, phases_;
  FormulaAlong<double> plain_;
  std::vector<std::unique_ptr<optim::Trace>> traces_;
  std::vector<std::vector<double>> own_breaks_;
  std::vector<double> breaks_;
  /// Made when something is first enclosed.
  mutable std::optional<FormulaAlong<Interval>> enclosing_, domain_;
};

/// What of a binding one cam's curve follows.
Binding binding_of(const HeldCurve& held, const Binding& binding) {
  Binding own = narrowed(binding, *held.response);
  if (!held.response->sees_law)
    own.law = std::make_shared<LawBinding>(own.law->member(), std::vector<LawVariable>{});
  return own;
}

ShaftParts::Held held_of(const HeldCurve& curve, const Binding& binding,
                         const std::vector<MechanismParameter>& parameters) {
  const Binding own = binding_of(curve, binding);
  const optim::Shape shape = curve.response->write
                                 ? ruled_shape(*curve.response, own, parameters).shape
                                 : optim::Shape::General;
  ShaftParts::Held held{curve.response->curve(own, shape),
                        curve.phase ? binding.constants[*curve.phase] : 0,
                        {},
                        own.variables,
                        {}};
  for (const LawVariable& v : own.law->variables()) held.variables.push_back(v.variable);
  const auto& varying = binding.parameters;
  const auto phase =
      curve.phase ? std::find(varying.begin(), varying.end(), *curve.phase) : varying.end();
  if (phase != varying.end()) {
    held.phase_variable = binding.variables[static_cast<std::size_t>(phase - varying.begin())];
  }
  if (!curve.phase) held.response = curve.response, held.binding = own;
  if (!held.curve->breaks_move()) held.breaks = held.curve->trace(own_design(binding))->breaks();
  return held;
}

/// The number of a cam's break among those that its curve can tell of: 0 is the cycle's end, then
/// come its breaks, where they are the same at every design, or else its joints.
std::optional<int> own_joint(const ShaftParts::Held& held, optim::Place own,
                             const std::vector<double>& breaks, optim::Design x) {
  if (own.angle == 0 || own.angle == kTurnDegrees) return 0;
  if (held.curve->breaks_move()) {
    const int joint = held.curve->tied(own, x).joint;
    if (joint >= 0 && held.curve->joint_angle(joint)) return 1 + joint;
    return {};
  }
  const auto found = std::find(breaks.begin(), breaks.end(), own.angle);
  if (found == breaks.end()) return {};
  return 1 + static_cast<int>(found - breaks.begin());
}

}  // namespace

bool ShaftParts::phases_vary() const {
  return std::any_of(held.begin(), held.end(),
                     [](const Held& h) { return h.phase_variable.has_value(); });
}

std::vector<double> ShaftParts::arguments_at(optim::Design x) const {
  return problems::arguments_at(arguments, x);
}

std::shared_ptr<const ShaftParts::Traces> ShaftParts::traces_at(optim::Design x) const {
  return recent->get(x, [&] {
    Traces traces{{}, {}, std::make_unique<std::mutex>()};
    for (const Held& h : held) {
      traces.of.push_back(h.curve->trace(x));
      traces.breaks.push_back(traces.of.back()->breaks());
    }
    return traces;
  });
}

ShaftCurve::ShaftCurve(ShaftParts parts, optim::Shape shape)
    : parts_(std::make_shared<const ShaftParts>(std::move(parts))), shape_(shape) {}

optim::Function ShaftCurve::at(optim::Place place) const {
  auto row = std::make_shared<const ShaftRow>(parts_, place);
  return {row->inputs(), row, shape_};
}

std::vector<double> ShaftCurve::slope_gradient(optim::Place place, optim::Design x) const {
  const ShaftRow row(parts_, place, true);
  std::vector<double> u;
  for (const std::size_t input : row.inputs()) u.push_back(x[input]);
  const std::vector<double> own = row.slope_gradient(u);
  std::vector<double> result(x.size(), 0.0);
  for (std::size_t i = 0; i < own.size(); ++i) result[row.inputs()[i]] = own[i];
  return result;
}

bool ShaftCurve::breaks_move() const {
  return parts_->phases_vary() ||
         std::any_of(parts_->held.begin(), parts_->held.end(),
                     [](const ShaftParts::Held& h) { return h.curve->breaks_move(); });
}

optim::Place ShaftCurve::tied(optim::Place place, optim::Design x) const {
  if (!breaks_move()) return place;
  const auto traces = parts_->traces_at(x);
  for (std::size_t k = 0; k < parts_->held.size(); ++k) {
    const ShaftParts::Held& held = parts_->held[k];
    const std::vector<double>& breaks = traces->breaks[k];
    const optim::Place own = cam_place(place.angle, place.from_left, held.phase_at(x), breaks);
    const std::optional<int> joint = own_joint(held, own, breaks, x);
    if (!joint) continue;
    place.joint = parts_->joint_of(k, *joint);
    return place;
  }
  return place;
}

std::vector<double> ShaftCurve::jump_motion(optim::Place place, optim::Design x) const {
  const auto traces = parts_->traces_at(x);
  for (std::size_t k = 0; k < parts_->held.size(); ++k) {
    const ShaftParts::Held& held = parts_->held[k];
    const optim::Place own =
        cam_place(place.angle, place.from_left, held.phase_at(x), traces->breaks[k]);
    std::vector<double> motion = optim::jump_motion(*held.curve, own, x);
    if (motion.empty()) continue;
    if (held.phase_variable) motion[*held.phase_variable] += 1;
    return motion;
  }
  return {};
}

std::unique_ptr<optim::Trace> ShaftCurve::trace(optim::Design x) const {
  return std::make_unique<ShaftTrace>(parts_, x);
}

std::unique_ptr<OverBoxes> ShaftCurve::over_boxes(const Widened& wide, optim::Design x,
                                                  TraceAt /*at*/) const {
  return held_over_boxes(parts_, wide, x);
}

double ShaftCurve::memory() const {
  double bytes = 0;
  for (const ShaftParts::Held& h : parts_->held) bytes += h.curve->memory();
  return bytes;
}

RuledShape shape_on_shaft(const MechanismResponse& response, const Binding& binding,
                          const std::vector<MechanismParameter>& parameters) {
  std::vector<RuledInput> inputs;
  for (const std::size_t i : binding.parameters) {
    inputs.push_back({Varies::Linearly, Interval(parameters[i].low, parameters[i].high)});
  }
  inputs.push_back({Varies::Not, Interval(0, 7)});  // the angle, rad: the place stays
  for (const HeldCurve& held : response.held) {
    const Binding own = binding_of(held, binding);
    const bool turns = held.phase && std::binary_search(binding.parameters.begin(),
                                                        binding.parameters.end(), *held.phase);
    const bool stays = own.parameters.empty() && own.law->variables().empty();
    const bool is_linear =
        !turns && !stays && held.response->write &&
        ruled_shape(*held.response, own, parameters).shape == optim::Shape::Linear;
    const Varies varies = turns       ? Varies::Otherwise
                          : stays     ? Varies::Not
                          : is_linear ? Varies::Linearly
                                      : Varies::Otherwise;
    inputs.push_back({varies, Interval::whole()});
  }
  const std::size_t others = 1 + response.held.size();
  return shape_by_rules(recorded_for(binding, response.write, others, {}).formula, inputs);
}

MechanismResponse shaft_curve_response(MechanismResponse response,
                                       const std::vector<MechanismParameter>& parameters) {
  response.along = "deg";
  response.cycle = std::make_shared<Cycle>(Cycle{"deg", {{0, kTurnDegrees}}});
  const std::size_t others = 1 + response.held.size();
  std::vector<ParameterSet> used{used_parameters(response.write, parameters.size(), others)};
  for (const HeldCurve& held : response.held) {
    used.push_back(held.response->uses);
    if (held.phase) used.push_back({*held.phase});
    response.sees_law = response.sees_law || held.response->sees_law;
  }
  response.uses = united(std::move(used));
  response.curve = [write = response.write, write_domain = response.domain, held = response.held,
                    parameters, others](const Binding& binding, optim::Shape shape) {
    ShaftParts parts{.record = recorded_for(binding, write, others, {}),
                     .domain = {},
                     .kernel = {},
                     .arguments = binding.variables,
                     .held = {},
                     .recent = std::make_shared<Recent<ShaftParts::Traces>>()};
    if (write_domain) parts.domain = recorded_for(binding, write_domain, others, {});
    parts.kernel = recorded_kernel(parts.record);
    for (const HeldCurve& curve : held) parts.held.push_back(held_of(curve, binding, parameters));
    return std::make_shared<ShaftCurve>(std::move(parts), shape);
  };
  return response;
}

}  // namespace camlaw::problems
