// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Real functions of a design, the parts that every problem is made of.
namespace camlaw::optim {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A design: the value of each variable, in the variable's unit.
using Design = std::span<const double>;

/// What is known of a function's form over the whole box of its variables. Quasiconvex: every set
/// {f <= c} is convex. Quasilinear: those and {f >= c} too (a quotient of linear functions with a
/// positive divisor, or anything monotone of it).
enum class Shape { General, Quasiconvex, Quasiconcave, Quasilinear, Convex, Concave, Linear };

/// Whether f is convex (concave).
bool is_convex(Shape shape);
bool is_concave(Shape shape);
/// Whether every set {f <= c} ({f >= c}) is convex.
bool convex_below(Shape shape);
bool convex_above(Shape shape);
/// The shape of -f.
Shape negated(Shape shape);

/// Numbers between which a value is proved to lie; infinite where nothing is known.
struct Bounds {
  double lower = -kInfinity;
  double upper = kInfinity;
};

/// What is proved of a function over a box of its inputs: numbers between which its values lie,
/// wherever it has one, and its slopes by each input likewise (of a kink the difference quotients).
struct BoxRange {
  Bounds value;
  std::vector<Bounds> slopes;
};

/// A formula in a few inputs u with its exact derivatives. Pure: equal u, equal bits, also where
/// threads that share a problem ask at once. Undefined inputs give NaN.
class Kernel {
 public:
  virtual ~Kernel() = default;
  virtual double value(std::span<const double> u) const = 0;
  /// Returns the value; g[i] = df/du_i.
  virtual double gradient(std::span<const double> u, std::span<double> g) const = 0;
  /// The same, and the second derivatives: h[packed(i, j)] = d2f/(du_i du_j) for j <= i.
  virtual double hessian(std::span<const double> u, std::span<double> g,
                         std::span<double> h) const = 0;
  /// Numbers that the exact value at u is proved to lie between, rounding included. Infinite bounds
  /// where a formula comes without an enclosure.
  virtual Bounds enclose(std::span<const double> u) const;
  /// The same over a box of finite bounds, and of the slopes. Bounds close on the value as the box
  /// shrinks; infinite where nothing is known.
  virtual BoxRange range(std::span<const Bounds> box) const;
  /// Whether the value comes from a search that may miss something, such as a peak over the cycle:
  /// then it holds as far as the enclosure proves it.
  virtual bool is_searched() const { return false; }
  /// Of a searched value the same number worked out from what a proof finds: it misses nothing, and
  /// takes longer. None where the value is not searched, or cannot be proved.
  virtual std::shared_ptr<const Kernel> proved() const { return nullptr; }
  /// Whether the formula comes with an enclosure: then a value counts as far as that proves it.
  virtual bool is_enclosed() const { return false; }
  /// Why the value at u is not a number, in words, where more is known than that; else empty.
  virtual std::string why_undefined(std::span<const double>) const { return {}; }
};

/// Place of (i, j), j <= i, in the lower triangle of a symmetric matrix stored row by row.
constexpr std::size_t packed(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }
constexpr std::size_t packed_size(std::size_t n) { return n * (n + 1) / 2; }

/// A kernel applied to some variables of the design. A copy shares the kernel.
class Function {
 public:
  /// The function that is zero everywhere.
  Function();
  /// `inputs` are the variables' indexes, increasing. Throws std::invalid_argument where they are
  /// not.
  Function(std::vector<std::size_t> inputs, std::shared_ptr<const Kernel> kernel,
           Shape shape = Shape::General);

  const std::vector<std::size_t>& inputs() const { return inputs_; }
  Shape shape() const { return shape_; }

  double value(Design x) const;
  /// Returns the value; g[k] is the derivative by inputs()[k].
  double gradient(Design x, std::span<double> g) const;
  /// The same, and second derivatives by the inputs, packed.
  double hessian(Design x, std::span<double> g, std::span<double> h) const;
  Bounds enclose(Design x) const;
  /// Kernel::range over a box of the design; slopes by inputs().
  BoxRange range(std::span<const Bounds> box) const;
  bool is_searched() const { return kernel_->is_searched(); }
  /// Kernel::proved of the kernel; this function where there is none.
  Function proved() const;
  bool is_enclosed() const { return kernel_->is_enclosed(); }
  std::string why_undefined(Design x) const;
  /// The same of designs that hold these variables alone, increasing, all inputs among them.
  Function within(const std::vector<std::size_t>& variables) const;

 private:
  std::vector<std::size_t> inputs_;
  std::shared_ptr<const Kernel> kernel_;
  Shape shape_;
};

/// One variable of the design as a function.
Function variable_function(std::size_t variable);

}  // namespace camlaw::optim
