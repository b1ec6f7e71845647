// SPDX-License-Identifier: MIT
#include "numerics/formula/formula.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "numerics/formula/expression.h"
#include "numerics/formula/operations.h"
#include "numerics/formula/plain_values.h"
#include "numerics/formula/roots.h"
#include "numerics/formula/steps.h"

namespace camlaw {

struct Formula::Data {
  Data(std::size_t how_many, std::vector<Step> written);

  std::size_t inputs = 0;
  std::vector<Step> steps;  ///< the last one is the value
  std::vector<std::size_t> uses;
  FormulaRoots roots;
  std::vector<std::uint32_t> varying;  ///< the steps that an input reaches, without those in roots
  /// Results of the steps that no input reaches.
  std::vector<double> plain;
  std::vector<Dual> dual;
  std::vector<Interval> enclosed;

  void work_out_constants();
  template <class T>
  void start(T* results) const;
};

namespace {

thread_local Recorder* recording = nullptr;

Recorder& recorder() {
  if (recording == nullptr) throw std::logic_error("no formula is being recorded");
  return *recording;
}

/// Directs this thread's recording to a recorder for as long as it exists.
class Recording {
 public:
  explicit Recording(Recorder& here) : before_(recording) { recording = &here; }
  ~Recording() { recording = before_; }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

 private:
  Recorder* before_;
};

/// The steps that the value needs, renumbered.
std::vector<Step> needed(const Recorder& all, std::uint32_t value) {
  const std::vector<bool> is_needed = needed_for({value}, all.steps());
  std::vector<std::uint32_t> number(is_needed.size());
  std::vector<Step> steps;
  for (std::uint32_t i = 0; i <= value; ++i) {
    if (!is_needed[i]) continue;
    number[i] = static_cast<std::uint32_t>(steps.size());
    Step step = all.at(i);
    std::uint32_t* from[] = {&step.a, &step.b, &step.c};
    for (std::size_t k = 0; k < operands(step.operation); ++k) *from[k] = number[*from[k]];
    steps.push_back(step);
  }
  return steps;
}

/// The results of the other steps, at these first inputs; 0 in place of those that are reached.
template <class T>
std::vector<T> still_results(const std::vector<Step>& steps, const FormulaRoots& roots,
                             const std::vector<bool>& reached, std::span<const T> first) {
  std::vector<T> results(steps.size(), number<T>(0));
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    if (reached[i] || roots.has_inside(i)) continue;
    if (step.operation == Operation::Input) {
      results[i] = first[step.a];
    } else if (step.operation == Operation::Constant) {
      if constexpr (std::is_same_v<T, Interval>) {
        results[i] = {step.lower, step.upper};
      } else {
        results[i] = number<T>(step.value);
      }
    } else if (step.operation == Operation::Root) {
      results[i] = roots.solve(i, results.data());
    } else {
      results[i] = operate<T>(step.operation, results[step.a], results[step.b], results[step.c]);
    }
  }
  return results;
}

}  // namespace

Expression Expression::of(const Step& step) {
  Expression result(0.0);
  result.step_ = recorder().write(step);
  return result;
}

Expression::Expression(double constant) : Expression(constant, constant, constant) {}
Expression::Expression(double constant, double lower, double upper)
    : step_(recorder().write(
          {.operation = Operation::Constant, .value = constant, .lower = lower, .upper = upper})) {}

bool Expression::is_finite_constant() const {
  const Step& step = recorder().at(step_);
  return step.operation == Operation::Constant && std::isfinite(step.value);
}

int Expression::constant_side() const {
  const Step& step = recorder().at(step_);
  if (step.operation != Operation::Constant) return 0;
  return step.lower >= 0 ? 1 : step.upper < 0 ? -1 : 0;
}

bool Expression::is(double c) const {
  const Step& step = recorder().at(step_);
  return step.operation == Operation::Constant && step.lower == c && step.upper == c;
}

Formula Formula::record(std::size_t inputs,
                        const std::function<Expression(std::span<const Expression>)>& write) {
  Recorder recorder;
  const Recording here(recorder);
  std::vector<Expression> given;
  for (std::uint32_t i = 0; i < inputs; ++i) {
    given.push_back(Expression::of({.operation = Operation::Input, .a = i}));
  }
  const std::uint32_t value = write(given).step();
  return Formula(std::make_shared<Data>(inputs, needed(recorder, value)));
}

Formula::Data::Data(std::size_t how_many, std::vector<Step> written)
    : inputs(how_many), steps(std::move(written)), roots(steps) {
  for (const Step& step : steps) {
    if (step.operation == Operation::Input) uses.push_back(step.a);
  }
  std::sort(uses.begin(), uses.end());
  work_out_constants();
}

std::size_t Formula::inputs() const { return data_->inputs; }
const std::vector<Step>& Formula::steps() const { return data_->steps; }
const std::vector<std::size_t>& Formula::uses() const { return data_->uses; }
const FormulaRoots& Formula::roots() const { return data_->roots; }
bool Formula::depends_on(std::size_t input) const {
  return std::binary_search(uses().begin(), uses().end(), input);
}

void Formula::Data::work_out_constants() {
  const std::vector<bool> varies = reached_from(0, steps);
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (varies[i] && !roots.has_inside(i)) varying.push_back(i);
  }
  plain = still_results<double>(steps, roots, varies, {});
  enclosed = still_results<Interval>(steps, roots, varies, {});
  dual = std::vector<Dual>(plain.begin(), plain.end());
}

template <class T>
void Formula::Data::start(T* results) const {
  if constexpr (std::is_same_v<T, double>) {
    std::copy(plain.begin(), plain.end(), results);
  } else if constexpr (std::is_same_v<T, Dual>) {
    std::copy(dual.begin(), dual.end(), results);
  } else if constexpr (std::is_same_v<T, Interval> || is_interval_series<T>) {
    std::transform(enclosed.begin(), enclosed.end(), results,
                   [](const Interval& x) { return T(x); });
  } else {
    std::transform(dual.begin(), dual.end(), results, [](const Dual& x) { return T(x); });
  }
}

template <class T>
T Formula::operator()(std::span<const T> u) const {
  thread_local std::vector<T> results;
  results.resize(std::max(results.size(), steps().size()));
  T* r = results.data();
  data_->start(r);
  for (const std::uint32_t i : data_->varying) {
    const Step& step = steps()[i];
    if (step.operation == Operation::Input) {
      r[i] = u[step.a];
    } else if (step.operation == Operation::Root) {
      r[i] = data_->roots.solve(i, r);
    } else {
      r[i] = operate<T>(step.operation, r[step.a], r[step.b], r[step.c]);
    }
  }
  return r[steps().size() - 1];
}

template double Formula::operator()(std::span<const double>) const;
template Dual Formula::operator()(std::span<const Dual>) const;
template Dual2 Formula::operator()(std::span<const Dual2>) const;
template Interval Formula::operator()(std::span<const Interval>) const;
template Series<Interval, 1> Formula::operator()(std::span<const Series<Interval, 1>>) const;
template Series<Interval, 2> Formula::operator()(std::span<const Series<Interval, 2>>) const;
template Series<Interval, 3> Formula::operator()(std::span<const Series<Interval, 3>>) const;

// ---------------------------------------------------------------------------------------------

PlainValues::PlainValues()
    : recorder_(std::make_unique<Recorder>()), before_(std::exchange(recording, recorder_.get())) {}
PlainValues::~PlainValues() { recording = before_; }

double PlainValues::operator()(const Expression& x) const {
  if (recording != recorder_.get()) throw std::logic_error("another formula is being recorded");
  go_on();
  if (unknowns_[x.step()] != 0) throw std::logic_error("an expression depends on an unknown");
  return results_[x.step()];
}

void PlainValues::go_on() const {
  for (auto i = static_cast<std::uint32_t>(results_.size()); i < recorder_->steps().size(); ++i) {
    const Step& step = recorder_->at(i);
    if (step.operation == Operation::Input) throw std::logic_error("a plain number has no inputs");
    const std::uint32_t from[] = {step.a, step.b, step.c};
    std::uint32_t unknowns = 0;
    for (std::size_t k = 0; k < operands(step.operation); ++k) unknowns |= unknowns_[from[k]];
    double result = 0;
    if (step.operation == Operation::Unknown) {
      unknowns |= 1u << step.c;
    } else if (step.operation == Operation::Root) {
      unknowns &= ~(1u << recorder_->at(step.a).c);
      if (unknowns == 0) {
        const std::vector<Step> steps = needed(*recorder_, i);
        const std::vector<bool> none(steps.size());
        result = still_results<double>(steps, FormulaRoots(steps), none, {}).back();
      }
    } else if (step.operation == Operation::Constant) {
      result = step.value;
    } else if (unknowns == 0) {
      result =
          operate<double>(step.operation, results_[step.a], results_[step.b], results_[step.c]);
    }
    results_.push_back(result);
    unknowns_.push_back(unknowns);
  }
}

// ---------------------------------------------------------------------------------------------

template <class T>
FormulaAlong<T>::FormulaAlong(const Formula& formula, std::span<const T> first)
    : formula_(formula) {
  const auto& steps = formula.steps();
  const std::vector<bool>& moves = moves_ = reached_from(first.size(), steps);
  still_ = still_results(steps, formula.roots(), moves, first);
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (!moves[i] || formula.roots().has_inside(i)) continue;
    const Step& step = steps[i];
    Moving moving{step.operation, {step.a, step.b, step.c}, {}, true, i};
    if (step.operation == Operation::Input) {
      moving.from[0] -= static_cast<std::uint32_t>(first.size());
    }
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      moving.moves[k] = moves[moving.from[k]];
      moving.all_move = moving.all_move && moving.moves[k];
    }
    moving_.push_back(moving);
  }
}

template <class T>
T FormulaAlong<T>::operator()(std::span<const T> others) const {
  thread_local std::vector<T> results;
  results = still_;
  T* r = results.data();
  for (const Moving& m : moving_) {
    if (m.operation == Operation::Input) {
      r[m.result] = others[m.from[0]];
    } else if (m.operation == Operation::Root) {
      r[m.result] = formula_.roots().solve(m.result, r);
    } else {
      r[m.result] = operate<T>(m.operation, r[m.from[0]], r[m.from[1]], r[m.from[2]]);
    }
  }
  return results.back();
}

template <class T>
template <std::size_t N>
Series<T, N> FormulaAlong<T>::operator()(std::span<const Series<T, N>> others) const {
  using X = Series<T, N>;
  if (moving_.empty()) return X(still_.back());
  thread_local std::vector<X> results;
  results.resize(std::max(results.size(), still_.size()));
  X* r = results.data();
  for (const Moving& m : moving_) {
    const auto [a, b, c] = m.from;
    const auto lifted = [&](std::size_t k) {
      return m.moves[k] ? r[m.from[k]] : X(still_[m.from[k]]);
    };
    if (m.operation == Operation::Input) {
      r[m.result] = others[a];
    } else if (m.operation == Operation::Root) {
      formula_.roots().for_each_operand(m.result, [&](std::uint32_t i) {
        if (!moves_[i]) r[i] = X(still_[i]);
      });
      r[m.result] = formula_.roots().solve(m.result, r);
    } else if (m.all_move) {
      r[m.result] = operate<X>(m.operation, r[a], r[b], r[c]);
    } else if (is_arithmetic(m.operation)) {
      r[m.result] = m.moves[0] ? arithmetic<X>(m.operation, r[a], still_[b])
                               : arithmetic<X>(m.operation, still_[a], r[b]);
    } else {
      r[m.result] = operate<X>(m.operation, lifted(0), lifted(1), lifted(2));
    }
  }
  return r[still_.size() - 1];
}

template class FormulaAlong<double>;
template class FormulaAlong<Dual>;
template class FormulaAlong<Dual2>;
template class FormulaAlong<Interval>;
template Series<double, 3> FormulaAlong<double>::operator()(
    std::span<const Series<double, 3>>) const;
template Series<Interval, 1> FormulaAlong<Interval>::operator()(
    std::span<const Series<Interval, 1>>) const;
template Series<Interval, 2> FormulaAlong<Interval>::operator()(
    std::span<const Series<Interval, 2>>) const;
template Series<Interval, 3> FormulaAlong<Interval>::operator()(
    std::span<const Series<Interval, 3>>) const;
template Series<Interval, 7> FormulaAlong<Interval>::operator()(
    std::span<const Series<Interval, 7>>) const;

}  // namespace camlaw
