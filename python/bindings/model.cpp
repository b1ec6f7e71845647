// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "optim/cycle/maxima_at.h"
#include "python/bindings/batch.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

/// A problem as plain functions with exact derivatives, for other people's optimisers.
namespace camlaw::python {
namespace {

using Matrix = nb::ndarray<nb::numpy, double, nb::ndim<2>>;
using Designs = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Point = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

Matrix matrix_of(std::vector<double> values, std::size_t rows, std::size_t columns) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  std::vector<double>* const numbers = owned.get();
  const nb::capsule owner(owned.release(),
                          [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return Matrix(numbers->data(), {rows, columns}, owner);
}

std::vector<std::string> names_of(const problems::ProblemStatement& statement) {
  std::vector<std::string> names;
  for (const problems::VariableStatement& v : statement.variables) names.push_back(v.name);
  return names;
}

/// One output: a response, or of a curve the highest of sign * curve, less a bound.
struct Output {
  std::string name, unit;
  optim::Response response;
  optim::Part part;
  double sign = 1;   ///< of the output by the response's value
  double shift = 0;  ///< added to it
};

/// Objectives to be made small, and margins that must not be below zero.
class Model {
 public:
  explicit Model(const problems::ProblemStatement& statement)
      : bound_(with_variables(statement, names_of(statement)), true),
        integers_(statement.variables.size()) {
    const problems::Binding binding = bound_.binding({});
    const problems::ProblemStatement& own = bound_.statement();
    for (std::size_t i = 0; i < integers_.size(); ++i) {
      integers_[i] = statement.variables[i].integer || !statement.variables[i].values.empty();
    }
    for (const problems::ObjectiveStatement& o : own.objectives) {
      const bool least = o.sense == optim::Sense::Minimize;
      outputs_.push_back({o.response.name, o.response.unit,
                          problems::make_response(*own.mechanism, o.response, binding),
                          o.response.part, least ? 1.0 : -1.0});
    }
    objectives_ = outputs_.size();
    for (const optim::Constraint& limit : problems::constraints_of(own, binding)) add(limit);
  }

  std::size_t size() const { return bound_.statement().variables.size(); }
  std::size_t objectives() const { return objectives_; }
  const std::vector<Output>& outputs() const { return outputs_; }
  const std::vector<problems::VariableStatement>& variables() const {
    return bound_.statement().variables;
  }
  const std::vector<bool>& integers() const { return integers_; }

  /// All outputs at a design.
  void values(optim::Design x, std::span<double> out) const {
    optim::MaximaAt maxima(x);
    for (std::size_t k = 0; k < outputs_.size(); ++k) out[k] = value(outputs_[k], x, maxima);
  }

  /// Derivatives of all outputs by the variables, row by row. A peak is followed with its place
  /// held, which is exact where the curve is smooth there, and where it stands at a joint that the
  /// curve knows.
  void jacobian(optim::Design x, std::span<double> out) const {
    std::fill(out.begin(), out.end(), 0.0);
    optim::MaximaAt maxima(x);
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      const Output& output = outputs_[k];
      double sign = output.sign;
      optim::Function function;
      if (output.response.is_curve()) {
        const optim::Curve& curve = output.response.curve();
        const optim::Extreme extreme = maxima.extreme_of(curve, output.part);
        function = curve.at(curve.tied(extreme.place, x));
        if (output.part == optim::Part::Magnitude && extreme.value < 0) sign = -sign;
      } else {
        function = output.response.function();
      }
      std::vector<double> gradient(function.inputs().size());
      function.gradient(x, gradient);
      for (std::size_t i = 0; i < gradient.size(); ++i) {
        out[k * size() + function.inputs()[i]] = sign * gradient[i];
      }
    }
  }

 private:
  /// A limit from above and one from below are a margin each.
  void add(const optim::Constraint& limit) {
    const auto part = [&](optim::Part of_curve) {
      return limit.response.is_curve() ? of_curve : optim::Part::Value;
    };
    if (limit.upper) {
      outputs_.push_back({limit.response.name + " upper", limit.response.unit, limit.response,
                          part(optim::Part::Highest), -1, *limit.upper});
    }
    if (limit.lower) {
      outputs_.push_back({limit.response.name + " lower", limit.response.unit, limit.response,
                          part(optim::Part::Lowest), 1, -*limit.lower});
    }
  }

  static double value(const Output& output, optim::Design x, optim::MaximaAt& maxima) {
    const optim::Response& response = output.response;
    double plain = 0;
    if (response.is_curve()) {
      plain = maxima.extreme_of(response.curve(), output.part).value;
      if (output.part == optim::Part::Magnitude) plain = std::abs(plain);
    } else {
      plain = response.function().value(x);
    }
    return output.sign * plain + output.shift;
  }

  problems::BoundProblem bound_;
  std::vector<bool> integers_;
  std::vector<Output> outputs_;
  std::size_t objectives_ = 0;
};

void check_size(std::size_t given, const Model& model) {
  if (given == model.size()) return;
  throw std::invalid_argument("a design has " + std::to_string(model.size()) + " numbers, not " +
                              std::to_string(given));
}

Matrix values_at(const Model& model, const Designs& x) {
  check_size(x.shape(1), model);
  const std::size_t rows = x.shape(0), columns = model.outputs().size();
  std::vector<double> result(rows * columns);
  const auto look = [&](std::size_t i) {
    model.values({x.data() + i * model.size(), model.size()},
                 std::span(result).subspan(i * columns, columns));
  };
  if (rows == 1) {  // an optimiser asks for thousands in turn: none is worth a thread of its own
    const Unlocked released;
    look(0);
  } else {
    run_whole([&](const Work& work) {
      const optim::Deadline deadline({}, work.stop());
      for (std::size_t i = 0; i < rows; ++i) {
        deadline.check();
        look(i);
      }
      return true;
    });
  }
  return matrix_of(std::move(result), rows, columns);
}

Matrix jacobian_at(const Model& model, const Point& x) {
  check_size(x.shape(0), model);
  std::vector<double> result(model.outputs().size() * model.size());
  {
    const Unlocked released;
    model.jacobian({x.data(), model.size()}, result);
  }
  return matrix_of(std::move(result), model.outputs().size(), model.size());
}

nb::list model_variables_of(const Model& model) {
  nb::list result;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const problems::VariableStatement& v = model.variables()[i];
    result.append(
        nb::make_tuple(v.name, v.unit, v.lower, v.upper, v.start, bool(model.integers()[i])));
  }
  return result;
}

}  // namespace

void add_model(nb::module_& module) {
  nb::class_<Model>(module, "Model")
      .def("__init__",
           [](Model* self, const StatedProblem& problem) {
             const Unlocked released;
             new (self) Model(problem.statement);
           })
      .def_prop_ro("objectives", &Model::objectives)
      .def("variables", &model_variables_of)
      .def("outputs",
           [](const Model& model) {
             nb::list result;
             for (const Output& output : model.outputs()) {
               result.append(nb::make_tuple(output.name, output.unit, output.sign));
             }
             return result;
           })
      .def("values", &values_at, nb::arg("x"))
      .def("jacobian", &jacobian_at, nb::arg("x"));
}

}  // namespace camlaw::python
