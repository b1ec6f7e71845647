// SPDX-License-Identifier: MIT
#include "python/bindings/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "problems/statement/parameters.h"
#include "python/bindings/curve_blocks.h"
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
        fmt::format("{} is a list; give its elements one by one, such as {}[1]", name, name));
  }
  const std::size_t element = parameter.element.value_or(0);
  if (const auto known = problems::find_variable(statement, parameter, element)) {
    return statement.variables[*known];
  }
  VariableStatement variable = problems::new_variable(parameter, element);
  variable.lower = parameter.low;
  variable.upper = parameter.high;
  variable.start = problems::values_of(statement, parameter)[element];
  return variable;
}

/// Whether a law has all of the variables by these names that are of laws.
bool has_variables(const ProblemStatement& statement, const Member& law,
                   const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const auto known = std::find_if(statement.variables.begin(), statement.variables.end(),
                                    [&](const VariableStatement& v) { return v.name == name; });
    return known == statement.variables.end() || !known->of_law ||
           problems::index_in(*law.family, known->law_parameter);
  });
}

}  // namespace

ProblemStatement with_variables(ProblemStatement statement, const std::vector<std::string>& names) {
  // Of several laws the first that has all the names moves the machine: they are looked up in it.
  if (statement.laws.size() > 1) {
    const auto found =
        std::find_if(statement.laws.begin(), statement.laws.end(),
                     [&](const Member& law) { return has_variables(statement, law, names); });
    const Member chosen = found == statement.laws.end() ? statement.laws.front() : *found;
    statement.laws = std::vector<Member>{chosen};
  }
  std::vector<VariableStatement> variables;
  for (const std::string& name : names) {
    variables.push_back(variable_of(statement, name));
    variables.back().integer = false;
    variables.back().values.clear();
  }
  statement.variables = std::move(variables);
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
      throw std::invalid_argument(fmt::format("{}: {}, number {} counted from 0, is outside {}",
                                              v.name, problems::with_unit(value, v.unit), i,
                                              problems::range_text(v.lower, v.upper, v.unit)));
    }
  }
}

/// A response of the designs: a number, or the highest and lowest of a curve.
struct BatchColumn {
  std::string name, unit;
  std::vector<double> values;
};

/// A curve of one design, sampled by itself.
class SampledCurve {
 public:
  explicit SampledCurve(std::unique_ptr<const optim::Trace> trace)
      : trace_(std::move(trace)),
        places_(trace_->breaks()),
        values_(trace_->values(places_.places)) {}

  double extreme(optim::Part part) const {
    const auto at = [&](optim::Place place, std::size_t) { return trace_->at(place); };
    return Summits(places_, values_, at).extreme(part);
  }

 private:
  std::unique_ptr<const optim::Trace> trace_;
  SampledPlaces places_;
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
    // Which names them apart where there are several of one response.
    const std::vector<optim::Constraint> named = problems::constraints_of(statement_, binding_);
    for (std::size_t i = 0; i < statement_.constraints.size(); ++i) {
      const problems::ConstraintStatement& c = statement_.constraints[i];
      problems::ResponseName whole = c.response;
      if (c.of_law) whole.response = c.of_law.get();
      limits_.push_back({named.at(i).response.name, c.response.unit, c.response.part,
                         place_of(whole), c.lower, c.upper});
    }
    gather();
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
    const Curves curves(*this, x);
    std::size_t column = 0;
    const auto put = [&](double value) { columns[column++].values[row] = value; };
    for (const Asked& asked : asked_) {
      if (!responses_[asked.response].is_curve()) {
        put(responses_[asked.response].function().value(x));
      } else if (is_whole(asked)) {
        put(curves.extreme(asked.response, optim::Part::Lowest));
        put(curves.extreme(asked.response, optim::Part::Highest));
      } else {
        put(curves.extreme(asked.response, asked.part));
      }
    }
    for (const Limit& limit : limits_) {
      const optim::Response& response = responses_[limit.response];
      const auto at = [&](optim::Part part) {
        if (!response.is_curve()) return response.function().value(x);
        return curves.extreme(limit.response, limit.part == optim::Part::Value ? part : limit.part);
      };
      double least = optim::kInfinity;
      const auto keep = [&](double margin) {
        if (std::isnan(margin) || margin < least) least = margin;
      };
      if (limit.upper) keep(*limit.upper - at(optim::Part::Highest));
      if (limit.lower && !std::isnan(least)) keep(at(optim::Part::Lowest) - *limit.lower);
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

  /// The curves of one design: together, as far as they can be, else each by itself.
  class Curves {
   public:
    Curves(const Batch& batch, optim::Design x)
        : batch_(batch), x_(x), single_(batch.responses_.size()) {
      if (batch.blocks_) together_ = batch.blocks_->at(x);
    }

    double extreme(std::size_t k, optim::Part part) const {
      const std::optional<std::size_t>& block = batch_.in_blocks_[k];
      if (together_ && block) {
        if (const auto found = together_->extreme(*block, part)) return *found;
      }
      if (!single_[k]) single_[k].emplace(batch_.responses_[k].curve().trace(x_));
      return single_[k]->extreme(part);
    }

   private:
    const Batch& batch_;
    optim::Design x_;
    std::optional<CurveBlocks::At> together_;
    mutable std::vector<std::optional<SampledCurve>> single_;
  };

  /// Which curves are worked out together.
  void gather() {
    std::vector<const problems::MechanismResponse*> curves;
    in_blocks_.resize(responses_.size());
    for (std::size_t k = 0; k < responses_.size(); ++k) {
      if (known_[k] == nullptr || !CurveBlocks::takes(*known_[k])) continue;
      in_blocks_[k] = curves.size();
      curves.push_back(known_[k]);
    }
    blocks_ = CurveBlocks::of(binding_, curves);
  }

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
  std::vector<std::optional<std::size_t>> in_blocks_;  ///< of each response, where it is there
  std::unique_ptr<const CurveBlocks> blocks_;
  std::vector<Asked> asked_;
  std::vector<Limit> limits_;
};

/// A column for each response and each limit's margin, as (name, unit, values).
nb::list evaluate_many(const StatedProblem& problem, const std::vector<std::string>& names,
                       const std::vector<Column>& values,
                       const std::optional<std::vector<std::string>>& responses) {
  if (names.empty() || values.size() != names.size()) {
    throw std::invalid_argument("values: give an array for at least one variable or constant");
  }
  const std::size_t count = values.front().shape(0);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (values[k].shape(0) == count) continue;
    throw std::invalid_argument(
        fmt::format("{} has {} values, but {} has {}; all arrays must be of one length", names[k],
                    values[k].shape(0), names.front(), count));
  }
  std::vector<BatchColumn> columns = run_whole([&](const Work& work) {
    const optim::Deadline deadline({}, work.stop());
    const Batch batch(problem.statement, names, responses);
    check_values(batch.variables(), values);
    std::vector<BatchColumn> result = batch.columns(count);
    std::vector<double> x(names.size());
    for (std::size_t row = 0; row < count; ++row) {
      deadline.check();
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = values[k].data()[row];
      batch.look(x, row, result);
    }
    return result;
  });
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
