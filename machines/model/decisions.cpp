// SPDX-License-Identifier: MIT
#include "machines/model/decisions.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kinematics/curve.h"
#include "machines/model/sign_brackets.h"
#include "numerics/formula/deciders.h"

namespace camlaw::problems {
namespace {

/// Of a piece's length, increasing: even ones, and closer and closer to the ends.
const std::vector<double>& sampled_shares() {
  // The nearest place is 4e-6 of a piece beside its end, where a motion's forces change sign.
  constexpr int kSamples = 256, kNearer = 10;
  static const std::vector<double> all = [] {
    std::vector<double> shares;
    for (int k = kNearer; k >= 1; --k) shares.push_back(std::ldexp(1.0 / kSamples, -k));
    for (int i = 1; i < kSamples; ++i) shares.push_back(static_cast<double>(i) / kSamples);
    for (int k = 1; k <= kNearer; ++k) shares.push_back(1 - std::ldexp(1.0 / kSamples, -k));
    return shares;
  }();
  return all;
}

/// Where g changes its sign in a bracket, to the last place; none where it jumps. Of places in a
/// row at which it is 0 the first.
template <class G>
std::optional<double> root_in(const SignBracket& bracket, const G& g, double size) {
  constexpr double kJump = 1e-6;         // of the size
  constexpr std::uintmax_t kMost = 300;  // looks: a jump is halved down to, three for each halving
  const auto& [low, high, at_low, at_high] = bracket;
  const double beyond = std::copysign(std::numeric_limits<double>::min(), at_high);
  const auto turned = [&](double place) {
    const double value = g(place);
    return value == 0 ? beyond : value;
  };
  const auto is_close = [](double a, double b) { return !(std::nextafter(a, b) < b); };
  std::uintmax_t looks = kMost;
  const auto [before, after] =
      boost::math::tools::toms748_solve(turned, low, high, at_low, at_high, is_close, looks);
  if (!(std::abs(g(after) - g(before)) <= kJump * size)) return std::nullopt;
  return before;
}

/// Where decider k changes its sign, of its values at increasing x; inputs(place) has what it
/// takes.
template <class Inputs>
void add_decisions(const Formula& decider, std::size_t k, std::span<const double> machine,
                   std::span<const double> x, std::span<const double> values, const Inputs& inputs,
                   std::vector<Decision>& found) {
  const double size = largest_size(values);
  for (const SignBracket& bracket : sign_brackets(x, values, size)) {
    const FormulaAlong<double> along(decider, machine);
    const auto at = [&](double place) {
      const auto taken = inputs(place);
      return along(std::span<const double>(taken));
    };
    if (const auto root = root_in(bracket, at, size)) found.push_back({k, *root});
  }
}

}  // namespace

std::array<std::vector<double>, 4> motion_rows(const Law<double>& law, std::span<const double> x) {
  std::array<std::vector<double>, 4> rows;
  for (std::vector<double>& row : rows) row.resize(x.size());
  evaluate(law, x, {rows[0], rows[1], rows[2], rows[3]});
  return rows;
}

std::vector<std::vector<double>> value_rows(const FormulaBlocks& formulas, std::size_t count,
                                            std::span<const double> machine,
                                            std::span<const std::vector<double>> inputs) {
  std::vector<std::vector<double>> values(count, std::vector<double>(inputs.front().size()));
  const std::vector<std::span<const double>> others(inputs.begin(), inputs.end());
  const std::vector<std::span<double>> rows(values.begin(), values.end());
  formulas(machine, others, rows);
  return values;
}

std::vector<Decision> counted(std::span<const Decision> in_section, double length) {
  constexpr double kSame = 1e-9;  // of the length
  std::vector<Decision> all;
  for (const Decision& decision : in_section) {
    const bool is_known = std::ranges::any_of(all, [&](const Decision& known) {
      return std::abs(known.place - decision.place) <= kSame * length;
    });
    if (!is_known) all.push_back(decision);
  }
  std::ranges::sort(all, {}, &Decision::place);
  return all;
}

Decisions::Decisions(const Recorded& record)
    : deciders_(moving(deciders(record.formula), record.arguments)) {
  if (!deciders_.empty()) together_.emplace(deciders_, record.arguments);
}

bool Decisions::same_as(const Decisions& other) const {
  return std::ranges::equal(deciders_, other.deciders_, [](const Formula& a, const Formula& b) {
    return a.steps() == b.steps();
  });
}

std::vector<std::vector<Decision>> Decisions::in_pieces(const Law<double>& law,
                                                        std::span<const double> machine) const {
  std::vector<std::vector<Decision>> found(law.pieces().size());
  if (!together_) return found;
  const std::vector<double>& shares = sampled_shares();
  std::vector<double> x;
  for (const Piece<double>& piece : law.pieces()) {
    for (const double share : shares) x.push_back(std::lerp(piece.begin, piece.end, share));
  }
  const auto values = value_rows(*together_, deciders_.size(), machine, motion_rows(law, x));
  for (std::size_t p = 0; p < found.size(); ++p) {
    const Piece<double>& piece = law.pieces()[p];
    const auto of_piece = [&](const std::vector<double>& row) {
      return std::span(row).subspan(p * shares.size(), shares.size());
    };
    for (std::size_t k = 0; k < deciders_.size(); ++k) {
      add_decisions(
          deciders_[k], k, machine, of_piece(x), of_piece(values[k]),
          [&](double place) { return derivatives<4>(piece, place); }, found[p]);
    }
  }
  return found;
}

std::vector<std::vector<Decision>> Decisions::in_sections(
    std::span<const std::pair<double, double>> sections, std::span<const double> machine,
    const InputsAt& inputs) const {
  std::vector<std::vector<Decision>> found(sections.size());
  if (!together_) return found;
  for (std::size_t p = 0; p < found.size(); ++p) {
    std::vector<double> x;
    std::vector<std::vector<double>> rows;
    for (const double share : sampled_shares()) {
      x.push_back(std::lerp(sections[p].first, sections[p].second, share));
      const std::vector<double> taken = inputs(p, x.back());
      rows.resize(taken.size());
      for (std::size_t i = 0; i < taken.size(); ++i) rows[i].push_back(taken[i]);
    }
    const auto values = value_rows(*together_, deciders_.size(), machine, rows);
    for (std::size_t k = 0; k < deciders_.size(); ++k) {
      add_decisions(
          deciders_[k], k, machine, x, values[k], [&](double place) { return inputs(p, place); },
          found[p]);
    }
  }
  return found;
}

}  // namespace camlaw::problems
