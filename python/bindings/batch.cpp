// SPDX-License-Identifier: MIT
#include "python/bindings/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "problems/statement/parameters.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"

/// Many designs of one problem in one call: names are bound once, values are searched and not
/// proved.
namespace camlaw::python {
namespace {

using Column = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using problems::ProblemStatement;
using problems::VariableStatement;

/// One number of a parameter as a variable that the designs give.
VariableStatement variable_of(const ProblemStatement& statement, const std::string& name) {
  const problems::NamedParameter parameter = problems::find_parameter(statement, name);
  if (parameter.list && !parameter.element) {
    throw std::invalid_argument(
        fmt::format("{}: it is a list; give its elements one by one, {}[1]", name, name));
  }
  const std::size_t element = parameter.element.value_or(0);
  if (const auto known = problems::find_variable(statement, parameter, element)) {
    return statement.variables[*known];
  }
  VariableStatement variable;
  variable.name = parameter.element_name(element);
  variable.unit = parameter.unit;
  variable.of_law = parameter.of_law;
  variable.parameter = parameter.parameter;
  variable.law_parameter = parameter.law_parameter;
  variable.element = element;
  variable.lower = parameter.low;
  variable.upper = parameter.high;
  variable.start = problems::values_of(statement, parameter)[element];
  return variable;
}

}  // namespace

ProblemStatement with_variables(ProblemStatement statement, const std::vector<std::string>& names) {
  std::vector<VariableStatement> variables;
  for (const std::string& name : names) {
    variables.push_back(variable_of(statement, name));
    variables.back().integer = false;
    variables.back().values.clear();
  }
  statement.variables = std::move(variables);
  statement.laws.resize(1, statement.laws.front());
  return statement;
}

namespace {

/// Refuses a design outside what its variables accept, as a design that is set one by one is.
void check_values(const std::vector<VariableStatement>& variables,
                  const std::vector<Column>& columns) {
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const VariableStatement& v = variables[k];
    for (std::size_t i = 0; i < columns[k].shape(0); ++i) {
      const double value = columns[k].data()[i];
      if (value >= v.lower && value <= v.upper) continue;
      throw std::invalid_argument(fmt::format("{}: {} at {} is outside {}", v.name,
                                              problems::with_unit(value, v.unit), i,
                                              problems::range_text(v.lower, v.upper, v.unit)));
    }
  }
}

/// A response of the designs: a number, or the highest and lowest of a curve.
struct BatchColumn {
  std::string name, unit;
  std::vector<double> values;
};

/// A curve of one design, sampled. The samples come from its record in blocks, which is many times
/// faster than its derivatives, place by place.
class SampledCurve {
 public:
  explicit SampledCurve(std::unique_ptr<const optim::Trace> trace) : trace_(std::move(trace)) {
    constexpr int kSamples = 144, kLeast = 8;
    const std::vector<double> breaks = trace_->breaks();
    const double cycle = breaks.back() - breaks.front();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double share = (breaks[k + 1] - breaks[k]) / cycle;
      const int steps = std::max(kLeast, static_cast<int>(kSamples * share));
      const auto here = optim::even_places(breaks[k], breaks[k + 1], steps);
      begins_.push_back(places_.size());
      places_.insert(places_.end(), here.begin(), here.end());
    }
    begins_.push_back(places_.size());
    values_ = trace_->values(places_);
  }

  /// The highest of sign * curve, turned back. Samples tell where it is, Newton's method how high.
  double highest(double sign) const {
    double best = -optim::kInfinity;
    for (const double value : values_) {
      if (std::isnan(value)) return value;
      best = std::max(best, sign * value);
    }
    if (!std::isfinite(best)) return sign * best;
    const double seen = best;
    for (std::size_t k = 0; k + 1 < begins_.size(); ++k) {
      for (std::size_t i = begins_[k]; i < begins_[k + 1]; ++i) {
        if (may_exceed(i, begins_[k], begins_[k + 1] - 1, sign, seen)) {
          best = std::max(best, summit(i, begins_[k], begins_[k + 1] - 1, sign));
        }
      }
    }
    return sign * best;
  }

  double extreme(optim::Part part) const {
    if (part == optim::Part::Highest) return highest(1);
    if (part == optim::Part::Lowest) return highest(-1);
    const double up = highest(1), down = highest(-1);
    return std::max(std::abs(up), std::abs(down));
  }

 private:
  double at(std::size_t i, double sign) const { return sign * values_[i]; }

  /// Whether a sample is a local maximum from which the curve may rise to what was seen: a parabola
  /// through it and its neighbours rises by no more than an eighth of their second difference.
  bool may_exceed(std::size_t i, std::size_t first, std::size_t last, double sign,
                  double seen) const {
    const std::size_t before = i == first ? i + 1 : i - 1, after = i == last ? i - 1 : i + 1;
    const double here = at(i, sign), left = at(before, sign), right = at(after, sign);
    if (here < left || here < right) return false;
    const bool level = here == left && here == right;
    return !level && here + 0.5 * std::abs(left - 2 * here + right) >= seen;
  }

  double summit(std::size_t i, std::size_t first, std::size_t last, double sign) const {
    constexpr int kSteps = 40;
    constexpr double kClose = 1e-9;  // of the bracket: the value is then right to its square
    double left = places_[i == first ? i : i - 1].angle;
    double right = places_[i == last ? i : i + 1].angle;
    const double close = kClose * (right - left);
    optim::Place place = places_[i];
    double best = -optim::kInfinity;
    for (int step = 0; step < kSteps; ++step) {
      const auto f = trace_->at(place);
      best = std::max(best, sign * f[0]);
      const double slope = sign * f[1], bend = sign * f[2];
      const bool ends = (place.angle <= left && slope <= 0) || (place.angle >= right && slope >= 0);
      if (ends || !(std::abs(slope) > 0)) break;
      (slope > 0 ? left : right) = place.angle;
      const double newton = place.angle - slope / bend;
      const bool inside = bend < 0 && newton > left && newton < right;
      const double next = inside ? newton : std::midpoint(left, right);
      if (std::abs(next - place.angle) <= close) break;
      place = {next};
    }
    return best;
  }

  std::unique_ptr<const optim::Trace> trace_;
  std::vector<optim::Place> places_;
  std::vector<std::size_t> begins_;  ///< of the stretches among the places, and the end
  std::vector<double> values_;
};

/// The values of responses and limits at many designs.
class Batch {
 public:
  Batch(const ProblemStatement& statement, const std::vector<std::string>& names,
        const std::optional<std::vector<std::string>>& responses)
      : statement_(with_variables(statement, names)),
        bound_(statement_, true),
        binding_(bound_.binding({})) {
    for (const std::string& name : responses.value_or(all_names())) {
      const auto asked = problems::find_response(*statement_.mechanism, name);
      asked_.push_back({asked.name, asked.unit, asked.part, place_of(asked)});
    }
    for (const problems::ConstraintStatement& c : statement_.constraints) {
      problems::ResponseName whole = c.response;
      if (c.of_law) whole.response = c.of_law.get();
      limits_.push_back(
          {c.response.name, c.response.unit, c.response.part, place_of(whole), c.lower, c.upper});
    }
  }

  const std::vector<VariableStatement>& variables() const { return bound_.statement().variables; }

  /// All columns, with room for so many designs.
  std::vector<BatchColumn> columns(std::size_t count) const {
    std::vector<BatchColumn> result;
    const auto add = [&](const std::string& name, const std::string& unit) {
      result.push_back({name, unit, std::vector<double>(count)});
    };
    for (const Asked& asked : asked_) {
      if (is_whole(asked)) {
        add("lowest " + asked.name, asked.unit), add("highest " + asked.name, asked.unit);
      } else {
        add(asked.name, asked.unit);
      }
    }
    for (const Limit& limit : limits_) add("margin of " + limit.name, limit.unit);
    return result;
  }

  /// Works one design out.
  void look(optim::Design x, std::size_t row, std::vector<BatchColumn>& columns) const {
    std::vector<std::optional<SampledCurve>> curves(responses_.size());
    const auto curve = [&](std::size_t k) -> const SampledCurve& {
      if (!curves[k]) curves[k].emplace(responses_[k].curve().trace(x));
      return *curves[k];
    };
    std::size_t column = 0;
    const auto put = [&](double value) { columns[column++].values[row] = value; };
    for (const Asked& asked : asked_) {
      if (!responses_[asked.response].is_curve()) {
        put(responses_[asked.response].function().value(x));
      } else if (is_whole(asked)) {
        put(curve(asked.response).highest(-1));
        put(curve(asked.response).highest(1));
      } else {
        put(curve(asked.response).extreme(asked.part));
      }
    }
    for (const Limit& limit : limits_) {
      const optim::Response& response = responses_[limit.response];
      const auto at = [&](optim::Part part) {
        if (!response.is_curve()) return response.function().value(x);
        return curve(limit.response).extreme(limit.part == optim::Part::Value ? part : limit.part);
      };
      double least = optim::kInfinity;
      if (limit.upper) least = std::min(least, *limit.upper - at(optim::Part::Highest));
      if (limit.lower) least = std::min(least, at(optim::Part::Lowest) - *limit.lower);
      put(least);
    }
  }

 private:
  /// A response, by its place among those that are worked out.
  struct Asked {
    std::string name, unit;
    optim::Part part;
    std::size_t response;
  };
  struct Limit : Asked {
    Limit(std::string n, std::string u, optim::Part p, std::size_t r, std::optional<double> low,
          std::optional<double> high)
        : Asked{std::move(n), std::move(u), p, r}, lower(low), upper(high) {}
    std::optional<double> lower, upper;
  };

  std::vector<std::string> all_names() const {
    std::vector<std::string> names;
    for (const auto& response : statement_.mechanism->responses) names.push_back(response.name);
    for (const auto& peak : statement_.mechanism->peaks) names.push_back(peak.name);
    return names;
  }

  bool is_whole(const Asked& asked) const {
    return responses_[asked.response].is_curve() && asked.part == optim::Part::Value;
  }

  /// Where the response is; each is made once, however often it is asked for.
  std::size_t place_of(const problems::ResponseName& name) {
    for (std::size_t k = 0; k < known_.size(); ++k) {
      if (name.response != nullptr && known_[k] == name.response && !name.window) return k;
    }
    responses_.push_back(problems::make_response(*statement_.mechanism, name, binding_));
    known_.push_back(name.window ? nullptr : name.response);
    return responses_.size() - 1;
  }

  ProblemStatement statement_;
  problems::BoundProblem bound_;
  problems::Binding binding_;
  std::vector<optim::Response> responses_;
  std::vector<const problems::MechanismResponse*> known_;
  std::vector<Asked> asked_;
  std::vector<Limit> limits_;
};

/// A column for each response and each limit's margin, as (name, unit, values).
nb::list evaluate_many(const StatedProblem& problem, const std::vector<std::string>& names,
                       const std::vector<Column>& values,
                       const std::optional<std::vector<std::string>>& responses) {
  if (names.empty() || values.size() != names.size()) {
    throw std::invalid_argument("evaluate_many: name the variables, each with its values");
  }
  const std::size_t count = values.front().shape(0);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (values[k].shape(0) == count) continue;
    throw std::invalid_argument(fmt::format("{}: {} values, where {} has {}", names[k],
                                            values[k].shape(0), names.front(), count));
  }
  std::vector<BatchColumn> columns;
  {
    const nb::gil_scoped_release released;
    const Batch batch(problem.statement, names, responses);
    check_values(batch.variables(), values);
    columns = batch.columns(count);
    std::vector<double> x(names.size());
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = values[k].data()[row];
      batch.look(x, row, columns);
    }
  }
  nb::list result;
  for (BatchColumn& column : columns) {
    result.append(nb::make_tuple(column.name, column.unit, array_of(std::move(column.values))));
  }
  return result;
}

}  // namespace

void add_batch(nb::module_& module) {
  module.def("evaluate_many", &evaluate_many, nb::arg("problem"), nb::arg("names"),
             nb::arg("values"), nb::arg("responses").none());
}

}  // namespace camlaw::python
