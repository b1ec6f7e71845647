// SPDX-License-Identifier: MIT
#include "numerics/formula/formula.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "numerics/formula/expression.h"
#include "numerics/formula/operations.h"

namespace camlaw {

struct Formula::Data {
  std::size_t inputs = 0;
  std::vector<Step> steps;  ///< the last one is the value
  std::vector<std::size_t> uses;
  std::vector<std::uint32_t> varying;  ///< the steps that an input reaches
  /// Results of the steps that no input reaches.
  std::vector<double> plain;
  std::vector<Dual> dual;
  std::vector<Interval> enclosed;

  void work_out_constants();
  template <class T>
  void start(T* results) const;
};

namespace {

/// Writes steps, equal ones once.
class Recorder {
 public:
  std::uint32_t write(const Step& step) {
    const Key key{step.operation,   step.a,           step.b,          step.c,
                  bits(step.value), bits(step.lower), bits(step.upper)};
    const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(steps_.size()));
    if (is_new) steps_.push_back(step);
    return at->second;
  }
  const Step& at(std::uint32_t step) const { return steps_[step]; }

 private:
  /// Numbers by their bits: so NaN is like itself, and -0 is not 0.
  using Key = std::tuple<Operation, std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t,
                         std::uint64_t, std::uint64_t>;
  static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
  std::vector<Step> steps_;
  std::map<Key, std::uint32_t> known_;
};

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

/// Returns how many earlier steps an operation uses.
std::size_t operands(Operation operation) {
  switch (operation) {
    case Operation::Input:
    case Operation::Constant:
    case Operation::Pi:
      return 0;
    case Operation::Add:
    case Operation::Subtract:
    case Operation::Multiply:
    case Operation::Divide:
    case Operation::Along:
    case Operation::WherePositive:
    case Operation::UnlessZero:
      return 2;
    case Operation::BySide:
      return 3;
    default:
      return 1;
  }
}

/// The steps that the value needs, renumbered.
std::vector<Step> needed(const Recorder& all, std::uint32_t value) {
  std::vector<bool> is_needed(value + std::size_t{1});
  is_needed[value] = true;
  for (std::uint32_t i = value + 1; i-- > 0;) {
    if (!is_needed[i]) continue;
    const Step& step = all.at(i);
    const std::uint32_t from[] = {step.a, step.b, step.c};
    for (std::size_t k = 0; k < operands(step.operation); ++k) is_needed[from[k]] = true;
  }
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

template <class T>
T constant_of(const Step& step) {
  if constexpr (std::is_same_v<T, Interval>) {
    return {step.lower, step.upper};
  } else if constexpr (is_interval_series<T>) {
    return T(Interval(step.lower, step.upper));
  } else {
    return number<T>(step.value);
  }
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
  auto data = std::make_shared<Data>();
  data->inputs = inputs;
  data->steps = needed(recorder, write(given).step());
  for (const Step& step : data->steps) {
    if (step.operation == Operation::Input) data->uses.push_back(step.a);
  }
  std::sort(data->uses.begin(), data->uses.end());
  data->work_out_constants();
  return Formula(std::move(data));
}

std::size_t Formula::inputs() const { return data_->inputs; }
const std::vector<Step>& Formula::steps() const { return data_->steps; }
const std::vector<std::size_t>& Formula::uses() const { return data_->uses; }
bool Formula::depends_on(std::size_t input) const {
  return std::binary_search(uses().begin(), uses().end(), input);
}

void Formula::Data::work_out_constants() {
  std::vector<bool> varies(steps.size());
  plain.resize(steps.size());
  enclosed.resize(steps.size());
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const std::uint32_t from[] = {step.a, step.b, step.c};
    varies[i] = step.operation == Operation::Input;
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      varies[i] = varies[i] || varies[from[k]];
    }
    if (varies[i]) {
      varying.push_back(i);
    } else if (step.operation == Operation::Constant) {
      plain[i] = constant_of<double>(step);
      enclosed[i] = constant_of<Interval>(step);
    } else {
      plain[i] = operate(step.operation, plain[step.a], plain[step.b], plain[step.c]);
      enclosed[i] = operate(step.operation, enclosed[step.a], enclosed[step.b], enclosed[step.c]);
    }
  }
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
    r[i] = step.operation == Operation::Input
               ? u[step.a]
               : operate<T>(step.operation, r[step.a], r[step.b], r[step.c]);
  }
  return r[steps().size() - 1];
}

template double Formula::operator()(std::span<const double>) const;
template Dual Formula::operator()(std::span<const Dual>) const;
template Dual2 Formula::operator()(std::span<const Dual2>) const;
template Interval Formula::operator()(std::span<const Interval>) const;
template Series<Interval, 1> Formula::operator()(std::span<const Series<Interval, 1>>) const;
template Series<Interval, 2> Formula::operator()(std::span<const Series<Interval, 2>>) const;

// ---------------------------------------------------------------------------------------------

template <class T>
FormulaAlong<T>::FormulaAlong(Formula formula, std::span<const T> first)
    : formula_(std::move(formula)) {
  const auto& steps = formula_.steps();
  std::vector<bool> moves(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    still_.push_back(number<T>(0));
    if (step.operation == Operation::Input) {
      moves[i] = step.a >= first.size();
      if (!moves[i]) still_[i] = first[step.a];
    } else if (step.operation == Operation::Constant) {
      still_[i] = constant_of<T>(step);
    } else {
      const std::size_t count = operands(step.operation);
      moves[i] = (count > 0 && moves[step.a]) || (count > 1 && moves[step.b]) ||
                 (count > 2 && moves[step.c]);
      if (!moves[i]) {
        still_[i] = operate<T>(step.operation, still_[step.a], still_[step.b], still_[step.c]);
      }
    }
    if (!moves[i]) continue;
    Moving moving{step.operation, false,  false,  false,
                  step.a,         step.b, step.c, static_cast<std::uint32_t>(i)};
    if (step.operation == Operation::Input) {
      moving.a = step.a - static_cast<std::uint32_t>(first.size());
    } else {
      const std::size_t count = operands(step.operation);
      moving.a_moves = moves[step.a];
      moving.b_moves = count > 1 && moves[step.b];
      moving.c_moves = count > 2 && moves[step.c];
    }
    moving_.push_back(moving);
  }
  moves_ = moves.back();
}

template <class T>
T FormulaAlong<T>::operator()(std::span<const T> others) const {
  if (!moves_) return still_.back();
  thread_local std::vector<T> results;
  results = still_;
  T* r = results.data();
  for (const Moving& m : moving_) {
    r[m.result] = m.operation == Operation::Input ? others[m.a]
                                                  : operate<T>(m.operation, r[m.a], r[m.b], r[m.c]);
  }
  return results.back();
}

template <class T>
template <std::size_t N>
Series<T, N> FormulaAlong<T>::operator()(std::span<const Series<T, N>> others) const {
  using X = Series<T, N>;
  if (!moves_) return X(still_.back());
  thread_local std::vector<X> results;
  results.resize(std::max(results.size(), still_.size()));
  X* r = results.data();
  const T* still = still_.data();
  for (const Moving& m : moving_) {
    if (m.operation == Operation::Input) {
      r[m.result] = others[m.a];
    } else if (m.a_moves && (m.b_moves || is_unary(m.operation))) {
      r[m.result] = operate<X>(m.operation, r[m.a], r[m.b],
                               m.operation != Operation::BySide ? r[m.a]
                               : m.c_moves                      ? r[m.c]
                                                                : X(still[m.c]));
    } else if (is_arithmetic(m.operation)) {
      r[m.result] = m.a_moves ? arithmetic<X>(m.operation, r[m.a], still[m.b])
                              : arithmetic<X>(m.operation, still[m.a], r[m.b]);
    } else {
      const auto lifted = [&](bool moves, std::uint32_t from) {
        return moves ? r[from] : X(still[from]);
      };
      r[m.result] = operate<X>(m.operation, lifted(m.a_moves, m.a), lifted(m.b_moves, m.b),
                               lifted(m.c_moves, m.c));
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

}  // namespace camlaw
