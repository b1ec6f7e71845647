// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machines/model/highest_kernel.h"
#include "optim/verdict/variation.h"

/// What is taken of the values that manufacture makes of a response, as a number of the mechanism
/// like any other: over parts that are the same every time (docs/theory.md, TV6 and TV7).
namespace camlaw::problems {

/// mean + factor * standard deviation, or the value below which a share of all parts lies.
struct Robust {
  bool is_quantile = false;
  double factor = 0;  ///< of the deviation
  double share = 0;   ///< of the quantile
  /// Of a quantile the share that the number of parts is for; none: its own.
  std::optional<double> parts_for = {};

  /// "mean + 3 sigma", "quantile 0.99".
  std::string text() const;
  /// Parts that it is taken over: 32 of a mean, of a quantile so many that four lie beyond it.
  std::size_t parts() const;
};

/// Reads "mean", "mean + 3 sigma", "mean - 2 sigma", "quantile 0.99". Throws std::invalid_argument
/// with what is accepted.
Robust parse_robust(std::string_view text);
/// Shares of quantiles lie between these, both sides.
inline constexpr double kLargestShare = 0.999;

/// A parameter that varies, about the value that it has.
struct VaryingParameter {
  std::size_t parameter;
  optim::Variation off;
};

/// Of a number, or of a part of a curve such as its peak. Its name is that of the response.
std::shared_ptr<const MechanismResponse> robust_number(std::shared_ptr<const Mechanism> mechanism,
                                                       const ResponseName& of,
                                                       const std::vector<VaryingParameter>& varying,
                                                       const Robust& robust);

}  // namespace camlaw::problems
