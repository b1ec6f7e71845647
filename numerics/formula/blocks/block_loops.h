// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/formula/blocks/block_kernels.h"
#include "numerics/lanes/elementary.h"
#include "numerics/lanes/sine_cosine.h"

/// The loops of BlockKernels for vectors V. Included by the files that are compiled for one
/// instruction set each, and by nothing else. A result may lie where an operand does.
namespace camlaw::block_loops {

using lanes::kWidth, lanes::load, lanes::store;

/// The result at each point i from f(i), for `Together` vectors at a time: as many divisions or
/// roots wait for each other less.
template <class V, std::size_t Together, class F>
void at_each(std::size_t points, double* result, const F& f) {
  for (std::size_t i = 0; i < points; i += Together * kWidth<V>) {
    V part[Together];
#pragma GCC unroll 4
    for (std::size_t k = 0; k < Together; ++k) part[k] = f(i + k * kWidth<V>);
#pragma GCC unroll 4
    for (std::size_t k = 0; k < Together; ++k) store(part[k], result + i + k * kWidth<V>);
  }
}

template <class V>
bool has_large_angle(const double* x, std::size_t points) {
  lanes::Integers<V> large = {};
  for (std::size_t i = 0; i < points; i += kWidth<V>) {
    large |= lanes::size_of(load<V>(x + i)) > lanes::kLargestAngle;
  }
  return lanes::any_high_bit(large);
}

/// The library's result for angles that are too large for the lanes.
template <class V, class Library>
V mended(V result, const V& angle, const Library& library) {
  for (std::size_t l = 0; l < kWidth<V>; ++l) {
    if (__builtin_fabs(angle[l]) > lanes::kLargestAngle) result[l] = library(angle[l]);
  }
  return result;
}

template <class V>
V sine_of(const V& angle, const V& sine) {
  return angle == 0.0 ? angle : sine;  // -0 of -0
}

/// Calls to(i, angle, sine and cosine) for each vector.
template <class V, class To>
void at_angles(const double* x, std::size_t points, const To& to) {
  const bool has_large = has_large_angle<V>(x, points);
  for (std::size_t i = 0; i < points; i += kWidth<V>) {
    const V angle = load<V>(x + i);
    auto [sine, cosine] = lanes::sine_cosine<V>(angle);
    sine = sine_of(angle, sine);
    if (has_large) {
      sine = mended<V>(sine, angle, [](double at) { return __builtin_sin(at); });
      cosine = mended<V>(cosine, angle, [](double at) { return __builtin_cos(at); });
    }
    to(i, sine, cosine);
  }
}

/// One step. Each operation does what numerics/scalar does with a double.
template <class V>
void run_step(const BlockStep& step, const BlockSteps& all, BlockRows rows, std::size_t points) {
  constexpr std::size_t kMany = BlockKernels::kTogether / kWidth<V>;
  double* to = rows.to[step.result];
  const double *a = rows.from[step.a], *b = rows.from[step.b], *c = rows.from[step.c];
  const auto many = [&](const auto& f) { at_each<V, kMany>(points, to, f); };
  const auto one = [&](const auto& f) { at_each<V, 1>(points, to, f); };
  const auto at = [](const double* row, std::size_t i) { return load<V>(row + i); };
  const auto same = [](const double* number) { return *number - V{}; };
  const V none = {};

  switch (step.code) {
    case BlockCode::Copy:
      return many([=](std::size_t i) { return at(a, i); });
    case BlockCode::Fill:
      return many([value = same(a)](std::size_t) { return value; });
    case BlockCode::Add:
      return many([=](std::size_t i) { return at(a, i) + at(b, i); });
    case BlockCode::AddStill:
      return many([=, value = same(b)](std::size_t i) { return at(a, i) + value; });
    case BlockCode::Subtract:
      return many([=](std::size_t i) { return at(a, i) - at(b, i); });
    case BlockCode::SubtractStill:
      return many([=, value = same(b)](std::size_t i) { return at(a, i) - value; });
    case BlockCode::StillSubtract:
      return many([=, value = same(a)](std::size_t i) { return value - at(b, i); });
    case BlockCode::Multiply:
      return many([=](std::size_t i) { return at(a, i) * at(b, i); });
    case BlockCode::MultiplyStill:
      return many([=, value = same(b)](std::size_t i) { return at(a, i) * value; });
    case BlockCode::Divide:
      return many([=](std::size_t i) { return at(a, i) / at(b, i); });
    case BlockCode::DivideStill:
      return many([=, value = same(b)](std::size_t i) { return at(a, i) / value; });
    case BlockCode::StillDivide:
      return many([=, value = same(a)](std::size_t i) { return value / at(b, i); });
    case BlockCode::Negate:
      return many([=](std::size_t i) { return -at(a, i); });
    case BlockCode::Sqrt:
      return many([=](std::size_t i) { return lanes::square_root(at(a, i) + none); });
    case BlockCode::Sin:
      return at_angles<V>(a, points,
                          [=](std::size_t i, const V& sine, const V&) { store(sine, to + i); });
    case BlockCode::Cos:
      return at_angles<V>(a, points,
                          [=](std::size_t i, const V&, const V& cosine) { store(cosine, to + i); });
    case BlockCode::SinCos:
      return at_angles<V>(
          a, points, [=, other = rows.to[step.b]](std::size_t i, const V& sine, const V& cosine) {
            store(sine, to + i);
            store(cosine, other + i);
          });
    case BlockCode::Tan:
      return at_angles<V>(a, points, [=](std::size_t i, const V& sine, const V& cosine) {
        store(sine / cosine, to + i);
      });
    case BlockCode::Asin:
      return one([=](std::size_t i) { return lanes::arcsine(at(a, i)); });
    case BlockCode::Atan:
      return one([=](std::size_t i) { return lanes::arctangent(at(a, i)); });
    case BlockCode::Log:
      return one([=](std::size_t i) { return lanes::logarithm(at(a, i)); });
    case BlockCode::Absolute:
      return many([=](std::size_t i) {
        const V x = at(a, i);
        return x < 0.0 ? -x : x + none;
      });
    case BlockCode::BySide:
      return one([=](std::size_t i) {
        const V force = at(a, i), side = force < 0.0 ? at(c, i) : at(b, i);
        return force == force ? side : force;
      });
    case BlockCode::Along:
      return one([=](std::size_t i) {
        const V way = at(a, i), x = at(b, i), size = x < 0.0 ? -x : x + none;
        const V signed_size = way == 0.0 ? none : (way < 0.0 ? -size : size);
        return way == way ? signed_size : way;
      });
    case BlockCode::WherePositive:
      return one(
          [=](std::size_t i) { return at(a, i) > 0.0 ? at(b, i) : none + __builtin_nan(""); });
    case BlockCode::UnlessZero:
      return one([=](std::size_t i) {
        const V force = at(a, i), value = force == 0.0 ? none : at(b, i);
        return force == force ? value : force;
      });
    case BlockCode::Each:
      for (std::size_t i = 0; i < points; ++i) {
        to[i] = all.operate(step.operation, a[i], b[i], c[i]);
      }
      return;
  }
}

template <class V>
void run(const BlockSteps& all, BlockRows rows, std::size_t points) {
  for (std::size_t k = 0; k < all.count; ++k) run_step<V>(all.steps[k], all, rows, points);
}

template <int Width>
constexpr BlockKernels kernels(const char* instruction_set) {
  return {instruction_set, Width, run<typename lanes::Vector<Width>::Type>};
}

}  // namespace camlaw::block_loops
