// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "machines/model/highest_in_box.h"
#include "machines/model/possible_by.h"

/// Bindings in which ranges of parameters vary as well as the design (docs/theory.md, "Ranges of
/// parameters").
namespace camlaw::problems {

/// A range as a response is taken over it.
struct TakenRange : ParameterRange {
  bool is_offset = false;  ///< its ends are added to the value that the parameter has
};

ParameterSet parameters_of(const std::vector<TakenRange>& ranges);

/// A binding in which the parameters of the ranges vary too: their variables come behind those that
/// it has.
struct Widened {
  Binding binding;
  std::size_t first = 0;  ///< variable of the first range
  Box box;                ///< of a range about a variable what is added to it
  std::vector<std::optional<std::size_t>> about = {};   ///< the variable that a range moves with
  std::shared_ptr<const RecordedMargins> margins = {};  ///< where the ranges decide on machines

  /// The box at a design.
  Box box_at(optim::Design x) const;

  /// A design of the widened binding.
  std::vector<double> design(optim::Design x, const Point& p) const {
    std::vector<double> all(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(first));
    all.insert(all.end(), p.begin(), p.end());
    return all;
  }
  /// What is known of the machines of the ranges at a design: an impossible one by its place in
  /// the ranges.
  MachinesOfBox machines_at(optim::Design x) const;
};

Widened widened(const Binding& binding, const std::vector<TakenRange>& ranges,
                const PossibleBy& possible_by = {});

/// Which variables of a design a function over a widened one depends on.
struct OwnInputs {
  std::vector<std::size_t>
      variables;                    ///< those of the function, and those that its ranges move with
  std::vector<std::size_t> behind;  ///< the function's input behind each of these
  std::vector<std::size_t> moved;   ///< its inputs that are ranges
  std::vector<std::optional<std::size_t>> about;  ///< of each range which of the variables it is
};
OwnInputs own_inputs(const optim::Function& f, const Widened& wide);

/// A place in the ranges, not a number where a range does not change the value there.
Point told(const optim::Function& f, const Widened& wide, optim::Design x, const Point& p);

}  // namespace camlaw::problems
