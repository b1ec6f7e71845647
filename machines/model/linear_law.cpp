// SPDX-License-Identifier: MIT
#include "machines/model/linear_law.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace camlaw::problems {
namespace {

constexpr std::size_t kLanes = kDualWidth;
using Parts = std::vector<std::vector<LinearLaw::Part>>;

bool changes(const Dual& c) { return !c.v.isZero(0); }

/// Whether the terms of a piece that are not its polynomial change with the parameters of its
/// lanes. Of a law that is linear in them breaks, frequencies and shapes do not.
bool moves_beside_polynomial(const Piece<Dual>& piece) {
  return std::any_of(piece.harmonics.begin(), piece.harmonics.end(),
                     [](const auto& h) { return changes(h.sine) || changes(h.cosine); }) ||
         std::any_of(piece.curves.begin(), piece.curves.end(),
                     [](const auto& c) { return changes(c.amplitude); });
}

/// Whether anything of a piece does.
bool moves(const Piece<Dual>& piece) {
  return std::any_of(piece.polynomial.begin(), piece.polynomial.end(), changes) ||
         moves_beside_polynomial(piece);
}

/// A law for each kLanes parameters, as few as move a piece kept of each.
Parts parts_by_blocks(const LawBinding& binding, const std::vector<double>& own) {
  const std::vector<Law<Dual>> laws = binding.first_laws(own);
  Parts parts;
  if (laws.empty()) return parts;
  parts.resize(laws.front().pieces().size());
  for (std::size_t piece = 0; piece < parts.size(); ++piece) {
    for (std::size_t block = 0; block < laws.size(); ++block) {
      const Piece<Dual>& its = laws[block].pieces()[piece];
      const bool is_last_hope = block + 1 == laws.size() && parts[piece].empty();
      if (!moves(its) && !is_last_hope) continue;
      LinearLaw::Part part{{}, std::min(kLanes, own.size() - block * kLanes), its};
      for (std::size_t k = 0; k < part.count; ++k) part.inputs[k] = block * kLanes + k;
      parts[piece].push_back(std::move(part));
    }
  }
  return parts;
}

/// The one list that varies, of which elements far from each other move no piece together.
struct LocalList {
  std::size_t reach;
  std::vector<std::size_t> elements;  ///< of each varying parameter
};

std::optional<LocalList> local_list(const LawBinding& binding) {
  const auto& variables = binding.variables();
  const std::size_t parameter = variables.front().parameter;
  LocalList list{binding.member().family->parameters[parameter].reach, {}};
  for (const LawVariable& v : variables) {
    if (v.parameter != parameter) return {};
    list.elements.push_back(v.element);
  }
  // Few parameters are as quick one by one.
  if (list.reach == 0 || variables.size() <= 2 * list.reach) return {};
  return list;
}

/// One number of a piece by two lanes, of which the second counts each parameter by its number.
struct Told {
  double slope, counted;
};

/// The parameter that moves a piece in a pair of lanes, from 0 on, by its largest number; none
/// where none does. -1 where more than one may.
std::optional<std::ptrdiff_t> told_by(const std::vector<Told>& numbers) {
  // A slope that is 1e-9 of the largest still tells the index to 1e-7.
  constexpr double kSame = 1e-6, kCounts = 1e-9;
  double largest = 0, count = 0;
  for (const Told& number : numbers) {
    if (std::abs(number.slope) <= largest) continue;
    largest = std::abs(number.slope);
    count = number.counted / number.slope;
  }
  if (largest == 0) return {};
  const double whole = std::round(count);
  const bool alone = std::all_of(numbers.begin(), numbers.end(), [&](const Told& number) {
    return std::abs(number.slope) <= kCounts * largest ||
           std::abs(number.counted / number.slope - whole) <= kSame * whole;
  });
  return alone && whole >= 1 ? static_cast<std::ptrdiff_t>(whole) - 1 : -1;
}

/// The numbers of a piece, by how much they count within it.
std::vector<Told> numbers_of(const Piece<Dual>& piece, int lane) {
  const double length = value_of(piece.end) - value_of(piece.begin);
  std::vector<Told> numbers;
  double power = 1;
  for (const Dual& c : piece.polynomial) {
    numbers.push_back({c.v[lane] * power, c.v[lane + 1] * power});
    power *= length;
  }
  return numbers;
}

/// Takes the slopes by one parameter, from a lane of a piece.
void take(std::size_t input, const Piece<Dual>& from, int lane,
          std::vector<LinearLaw::Part>& parts) {
  if (parts.empty() || parts.back().count == kLanes) {
    LinearLaw::Part fresh{{}, 0, from};
    for (Dual& c : fresh.piece.polynomial) c.v.setZero();
    parts.push_back(std::move(fresh));
  }
  LinearLaw::Part& part = parts.back();
  const int own = static_cast<int>(part.count);
  part.inputs[part.count++] = input;
  if (part.piece.polynomial.size() < from.polynomial.size())
    part.piece.polynomial.resize(from.polynomial.size(), Dual(0.0));
  for (std::size_t k = 0; k < from.polynomial.size(); ++k) {
    part.piece.polynomial[k].v[own] = from.polynomial[k].v[lane];
  }
}

/// Many parameters at a time, those that are far from each other: each piece tells which of them
/// moves it (Curtis, Powell and Reid 1974). None where some piece is moved by two of them.
std::optional<Parts> parts_by_colours(const LawBinding& binding, const std::vector<double>& own,
                                      const LocalList& list) {
  constexpr std::size_t kPairs = kLanes / 2;
  Parts parts;
  for (std::size_t first = 0; first < list.reach; first += kPairs) {
    std::vector<Dual> values(own.begin(), own.end());
    for (std::size_t i = 0; i < own.size(); ++i) {
      const std::size_t colour = list.elements[i] % list.reach;
      if (colour < first || colour >= first + kPairs) continue;
      const int lane = static_cast<int>(2 * (colour - first));
      values[i].v[lane] = 1;
      values[i].v[lane + 1] = static_cast<double>(i + 1);
    }
    const auto law = binding.possible_law_of<Dual>(std::span<const Dual>(values));
    if (!law || std::any_of(law->pieces().begin(), law->pieces().end(), moves_beside_polynomial))
      return {};
    parts.resize(law->pieces().size());
    for (std::size_t piece = 0; piece < parts.size(); ++piece) {
      const Piece<Dual>& its = law->pieces()[piece];
      for (std::size_t pair = 0; pair < kPairs; ++pair) {
        const int lane = static_cast<int>(2 * pair);
        const auto input = told_by(numbers_of(its, lane));
        if (!input) continue;
        if (*input < 0 || static_cast<std::size_t>(*input) >= own.size()) return {};
        take(static_cast<std::size_t>(*input), its, lane, parts[piece]);
      }
      const bool is_last = first + kPairs >= list.reach;
      if (!is_last || !parts[piece].empty()) continue;
      LinearLaw::Part still{{}, 0, its};
      for (Dual& c : still.piece.polynomial) c.v.setZero();
      parts[piece].push_back(std::move(still));
    }
  }
  return parts;
}

Parts parts_of(const LawBinding& binding, const std::vector<double>& own) {
  if (const auto list = local_list(binding)) {
    if (auto parts = parts_by_colours(binding, own, *list)) return std::move(*parts);
  }
  return parts_by_blocks(binding, own);
}

std::vector<double> own_values_of(const LawBinding& binding) {
  std::vector<double> values;
  for (const LawVariable& v : binding.variables()) {
    values.push_back(binding.member().arguments.list(v.parameter)[v.element]);
  }
  return values;
}

}  // namespace

LinearLaw::LinearLaw(const LawBinding& binding)
    : own(own_values_of(binding)), parts(parts_of(binding, own)) {
  if (!parts.empty()) law = binding.member().law();
}

}  // namespace camlaw::problems
