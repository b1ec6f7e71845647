// SPDX-License-Identifier: MIT
#include "fitting/records/record_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/tables/turn.h"
#include "optim/fit/residuals.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

/// The values of the fit's own parameters, behind those of the design.
struct Shifts {
  std::optional<std::size_t> place, value;
};

class RecordResiduals final : public optim::Residuals {
 public:
  RecordResiduals(const RecordedCurve& record, const optim::Curve& curve, std::size_t variables,
                  Shifts shifts)
      : record_(record), curve_(curve), variables_(variables), shifts_(shifts) {}

  std::size_t count() const override { return record_.place.size(); }

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    const optim::Design x = p.first(variables_);
    const std::unique_ptr<optim::Trace> trace = curve_.trace(x);
    const std::vector<double> breaks = trace->breaks();
    const double begin = breaks.front(), length = breaks.back() - begin;
    for (std::size_t i = 0; i < count(); ++i) {
      double at = record_.place[i] - (shifts_.place ? p[*shifts_.place] : 0);
      if (length == kTurnDegrees) at = in_period(at, begin, kTurnDegrees);
      const optim::Place place{at, at >= breaks.back(), -1};
      const std::span<double> row =
          jacobian.empty() ? jacobian : jacobian.subspan(i * p.size(), p.size());
      const double value = value_at(place, x, row) + (shifts_.value ? p[*shifts_.value] : 0);
      if (!std::isfinite(value)) return false;
      r[i] = value - record_.value[i];
      if (row.empty()) continue;
      if (shifts_.place) row[*shifts_.place] = -trace->at(place)[1];
      if (shifts_.value) row[*shifts_.value] = 1;
    }
    return true;
  }

 private:
  double value_at(optim::Place place, optim::Design x, std::span<double> row) const {
    const optim::Function f = curve_.at(place);
    if (row.empty()) return f.value(x);
    std::fill(row.begin(), row.end(), 0.0);
    std::vector<double> gradient(f.inputs().size());
    const double value = f.gradient(x, gradient);
    for (std::size_t k = 0; k < gradient.size(); ++k) row[f.inputs()[k]] = gradient[k];
    return value;
  }

  const RecordedCurve& record_;
  const optim::Curve& curve_;
  std::size_t variables_;
  Shifts shifts_;
};

std::vector<optim::FitParameter> variables_of(const ProblemStatement& machine) {
  if (machine.variables.empty()) {
    throw std::invalid_argument(
        "the problem file has no [variables]; state what is to be fitted, with bounds");
  }
  std::vector<optim::FitParameter> result;
  for (const VariableStatement& v : machine.variables) {
    if (v.integer || !v.values.empty()) {
      throw std::invalid_argument(fmt::format(
          "variable '{}' is chosen from values; only continuous variables can be fitted", v.name));
    }
    result.push_back({v.name, v.unit, v.lower, v.upper, v.start, v.scale});
  }
  return result;
}

Shifts add_shifts(std::vector<optim::FitParameter>& parameters, const RecordedCurve& record,
                  const RecordFitOptions& options) {
  Shifts shifts;
  const double infinity = optim::kInfinity;
  if (options.place_shift) {
    shifts.place = parameters.size();
    // Half a turn leads to any place of it; a wrong zero of an encoder is about a degree off.
    constexpr double kMost = 180, kTypical = 1;
    parameters.push_back(
        {"place_shift", record.response.response->along, -kMost, kMost, 0, kTypical});
  }
  if (options.value_shift) {
    shifts.value = parameters.size();
    double size = 0;
    for (const double v : record.value) size = std::max(size, std::abs(v));
    parameters.push_back({"value_shift", record.response.unit, -infinity, infinity, 0, size});
  }
  return shifts;
}

/// Refuses places where the curve is not, and a shift of one that does not repeat.
void check_places(const RecordedCurve& record, const optim::Curve& curve, optim::Design x,
                  const RecordFitOptions& options) {
  const std::vector<double> breaks = curve.trace(x)->breaks();
  if (breaks.back() - breaks.front() == kTurnDegrees) return;
  if (options.place_shift) {
    throw std::invalid_argument(
        "the zero of the abscissa can be fitted only if the curve covers whole turns");
  }
  for (const double place : record.place) {
    if (place >= breaks.front() && place <= breaks.back()) continue;
    throw std::invalid_argument(
        fmt::format("the record reaches {:.6g}, but {} is defined from {:.6g} to {:.6g}", place,
                    record.response.name, breaks.front(), breaks.back()));
  }
}

/// As many places as unknowns are met whatever the machine is.
void check_enough(const RecordedCurve& record, std::size_t unknowns) {
  if (record.place.size() > unknowns) return;
  throw std::invalid_argument(
      fmt::format("{} rows of numbers cannot determine {} unknowns; at least {} are needed",
                  record.place.size(), unknowns, unknowns + 1));
}

/// Values that drew a fit in which all count alike.
std::string drawn_by(const RecordFit& fit, const RecordedCurve& record) {
  const std::size_t worst = fit.outliers.samples.front();
  return fmt::format(
      "{} of {} values lie farther off than chance explains and distort the fit, by up to {:.3g} "
      "{} at {:.6g} {}; --loss huber or --loss cauchy limits their weight",
      fit.outliers.samples.size(), fit.model.size(), std::abs(fit.fit.residuals[worst]),
      record.response.unit, record.place[worst], record.response.response->along);
}

std::string distrust_of(const RecordFit& fit, const RecordedCurve& record,
                        const RecordFitOptions& options) {
  std::string why = fit.fit.reason;
  const auto add = [&](const std::string& more) { why += (why.empty() ? "" : "; ") + more; };
  if (fit.left.is_curve) {
    add(
        fmt::format("the machine as stated does not follow the record: the residuals are not noise "
                    "(neighbouring residuals have a correlation of {:.2f})",
                    fit.left.correlation));
  }
  if (options.loss == optim::Loss::None && draws(fit.outliers, fit.fit.residuals)) {
    add(drawn_by(fit, record));
  }
  return why;
}

}  // namespace

RecordFit fit_record(const ProblemStatement& machine, const RecordedCurve& record,
                     const RecordFitOptions& options) {
  std::vector<optim::FitParameter> parameters = variables_of(machine);
  const std::size_t variables = parameters.size();
  const BoundProblem bound = BoundProblem(machine).with_stop(options.stop);
  if (!bound.choices().empty()) {
    throw std::invalid_argument(
        "there is a list of laws to choose from; state the one that the machine has");
  }
  const optim::Response response =
      response_of(bound.statement(), record.response, bound.binding({}));
  std::vector<double> start;
  for (const auto& p : parameters) start.push_back(p.start);
  check_places(record, response.curve(), start, options);
  const Shifts shifts = add_shifts(parameters, record, options);
  check_enough(record, parameters.size());
  const RecordResiduals residuals(record, response.curve(), variables, shifts);
  optim::FitOptions how;
  how.loss = options.loss;
  how.confidence = options.confidence;
  how.time_limit = options.time_limit;
  how.time_spent = options.time_spent;
  how.stop = options.stop;
  RecordFit result{optim::fit(parameters, residuals, how), machine, {}, {}, {}, ""};
  std::vector<double> x;
  for (const auto& p : result.fit.parameters) x.push_back(p.value);
  result.machine = bound.at({}, optim::Design(x).first(variables));
  result.machine.stop = machine.stop;
  double size = 0;
  for (std::size_t i = 0; i < record.value.size(); ++i) {
    result.model.push_back(record.value[i] + result.fit.residuals[i]);
    size = std::max(size, std::abs(record.value[i]));
  }
  const std::vector<double>& r = result.fit.residuals;
  result.left = optim::residual_pattern(record.place, optim::counted_residuals(result.fit));
  constexpr double kRounding = 1e-9;  // of the values: the model's own rounding
  result.outliers = find_outliers(record.place, r, result.fit.rank, kRounding * size);
  const bool exact = result.fit.rms < kRounding * size;
  result.distrust = exact ? result.fit.reason : distrust_of(result, record, options);
  return result;
}

}  // namespace camlaw::problems
