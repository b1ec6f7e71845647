// SPDX-License-Identifier: MIT
#include "machines/model/mean_slopes.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "machines/model/cycle_mean.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kMotion = 4;  // s, v, a, j

std::vector<Formula> formulas_of(std::span<const Recorded> integrands) {
  std::vector<Formula> formulas;
  for (const Recorded& one : integrands) formulas.push_back(one.formula);
  return formulas;
}

std::vector<double> places_of(std::span<const MeanStep<double>> steps) {
  std::vector<double> places;
  places.reserve(steps.size() * kMeanPoints);
  at_each_place(
      steps, [](std::size_t, double x) { return x; }, [&](double x) { places.push_back(x); });
  return places;
}

/// The parts of a law within which an integrand is smooth.
std::vector<PlainMean::Section> sections_of(const Law<double>& law,
                                            std::span<const std::vector<Decision>> in_pieces) {
  std::vector<PlainMean::Section> sections;
  for (std::size_t p = 0; p < law.pieces().size(); ++p) {
    const Piece<double>& piece = law.pieces()[p];
    PlainMean::Edge begin{piece.begin};
    for (const Decision& decision : counted(in_pieces[p], piece.end - piece.begin)) {
      const PlainMean::Edge end{decision.place, decision};
      sections.push_back({p, begin, end});
      begin = end;
    }
    sections.push_back({p, begin, {piece.end}});
  }
  return sections;
}

/// How the middle and the half length of a step follow the ends of its section (docs/theory.md,
/// (R6)).
struct Shares {
  double middle, half;  ///< of the section's length, from its begin on
};

Shares shares_of(const MeanStep<double>& step, const PlainMean::Section& section) {
  const double begin = section.begin.place, length = section.end.place - begin;
  if (!(length > 0)) return {0, 0};  // counted() leaves no two places that close
  return {(step.middle - begin) / length, step.half / length};
}

}  // namespace

PlainMean plain_mean(
    const Law<double>& law, std::span<const std::vector<Decision>> in_pieces,
    const std::function<std::vector<double>(const std::vector<double>&)>& integrand) {
  PlainMean mean{sections_of(law, in_pieces), {}, 0};
  std::vector<MeanStep<double>> steps;
  for (std::size_t k = 0; k < mean.sections.size(); ++k) {
    const auto& [piece, begin, end] = mean.sections[k];
    detail::add_steps(law.pieces()[piece], begin.place, end.place, k, steps);
  }
  const auto evaluate = [&](std::span<const MeanStep<double>> at, const auto& take) {
    for (const double value : integrand(places_of(at))) take(value);
  };
  const Quadrature<double> quadrature(steps, evaluate);
  for (const auto& one : quadrature.steps()) mean.steps.push_back(one.step);
  mean.value = quadrature.sum();
  return mean;
}

bool MeanSlopes::knows(std::span<const Recorded> integrands, std::span<const Decisions> decisions) {
  const auto all_known = [](const Decisions& one) {
    for (std::size_t k = 0; k < one.size(); ++k) {
      if (!FormulaSlopes::knows(one.decider(k))) return false;
    }
    return true;
  };
  return std::ranges::all_of(decisions, all_known) &&
         std::ranges::all_of(integrands, FormulaSlopes::knows, &Recorded::formula);
}

MeanSlopes::MeanSlopes(std::span<const Recorded> integrands, std::span<const Decisions> decisions)
    : decisions_(decisions.begin(), decisions.end()),
      deciders_(decisions.size()),
      integrands_(formulas_of(integrands), integrands.front().arguments) {
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    for (std::size_t k = 0; k < decisions[i].size(); ++k) {
      deciders_[i].emplace_back(decisions[i].decider(k));
    }
  }
}

/// Whether two integrands are taken over the same steps, whose ends move alike.
bool MeanSlopes::same_sections(std::size_t i, std::size_t k, const Pass& pass) const {
  const auto same_step = [](const auto& a, const auto& b) {
    return a.middle == b.middle && a.half == b.half && a.section == b.section;
  };
  const auto same_edge = [&](const PlainMean::Edge& a, const PlainMean::Edge& b) {
    if (a.place != b.place || a.decision.has_value() != b.decision.has_value()) return false;
    return !a.decision || decisions_[i].decider(a.decision->decider).steps() ==
                              decisions_[k].decider(b.decision->decider).steps();
  };
  const PlainMean &one = pass.means[i], &other = pass.means[k];
  return std::ranges::equal(one.steps, other.steps, same_step) &&
         std::ranges::equal(one.sections, other.sections, [&](const auto& a, const auto& b) {
           return a.piece == b.piece && same_edge(a.begin, b.begin) && same_edge(a.end, b.end);
         });
}

void MeanSlopes::add(std::span<const PlainMean> means, std::span<const double> by_means,
                     const Law<double>& law, std::span<const double> machine,
                     std::span<double> by_machine, LawSlopes& by_law) const {
  const Pass pass{means, by_means, law, machine, by_machine, by_law};
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (by_means[i] == 0) continue;
    const auto group = std::ranges::find_if(
        groups, [&](const auto& one) { return same_sections(one.front(), i, pass); });
    if (group == groups.end()) {
      groups.push_back({i});
    } else {
      group->push_back(i);
    }
  }
  for (const auto& group : groups) add_group(group, pass);
}

/// (R6) Of integrands over the same steps.
void MeanSlopes::add_group(const std::vector<std::size_t>& group, const Pass& pass) const {
  const MeanRule& rule = mean_rule();
  const PlainMean& mean = pass.means[group.front()];
  const std::vector<double> x = places_of(mean.steps);
  std::vector<std::vector<double>> weights(pass.means.size()), values(pass.means.size());
  for (const std::size_t i : group) {
    values[i].resize(x.size());
    for (const MeanStep<double>& step : mean.steps) {
      for (const double weight : rule.weights) {
        weights[i].push_back(pass.by_means[i] * step.half * weight);
      }
    }
  }
  const auto motion = motion_rows(pass.law, x);
  std::array<std::vector<double>, kMotion> by_motion;
  for (auto& row : by_motion) row.resize(x.size());
  const std::vector<std::span<const double>> others(motion.begin(), motion.end()),
      weight_rows(weights.begin(), weights.end());
  const std::vector<std::span<double>> slope_rows(by_motion.begin(), by_motion.end()),
      value_rows(values.begin(), values.end());
  integrands_(pass.machine, {others, weight_rows}, {pass.by_machine, slope_rows, value_rows});

  std::vector<double> by_begin(mean.sections.size()), by_end(mean.sections.size());
  std::size_t n = 0;
  for (const MeanStep<double>& step : mean.steps) {
    const PlainMean::Section& section = mean.sections[step.section];
    const Piece<double>& piece = pass.law.pieces()[section.piece];
    double by_middle = 0, by_half = 0;
    for (std::size_t k = 0; k < kMeanPoints; ++k, ++n) {
      const std::array<double, kMotion> slopes{by_motion[0][n], by_motion[1][n], by_motion[2][n],
                                               by_motion[3][n]};
      pass.by_law.add_motion(section.piece, x[n], slopes);
      const auto rates = derivatives<kMotion + 1>(piece, x[n]);
      const double along = std::inner_product(slopes.begin(), slopes.end(), rates.begin() + 1, 0.0);
      by_middle += along;
      by_half += rule.places[k] * along;
      for (const std::size_t i : group) {
        by_half += pass.by_means[i] * rule.weights[k] * values[i][n];
      }
    }
    const Shares share = shares_of(step, section);
    by_begin[step.section] += (1 - share.middle) * by_middle - share.half * by_half;
    by_end[step.section] += share.middle * by_middle + share.half * by_half;
  }
  for (std::size_t k = 0; k < mean.sections.size(); ++k) {
    const PlainMean::Section& section = mean.sections[k];
    add_edge(group.front(), section.piece, section.begin, false, by_begin[k], pass);
    add_edge(group.front(), section.piece, section.end, true, by_end[k], pass);
  }
}

/// From the slope by the place of an edge: a decision moves with the machine and with the law.
void MeanSlopes::add_edge(std::size_t integrand, std::size_t piece, const PlainMean::Edge& edge,
                          bool is_end, double slope, const Pass& pass) const {
  if (!edge.decision) return pass.by_law.add_end({piece, is_end}, slope);
  const Piece<double>& its = pass.law.pieces()[piece];
  const Formula& decider = decisions_[integrand].decider(edge.decision->decider);
  const std::size_t arguments = pass.machine.size();
  const auto at = [&](double place) {
    std::vector<double> u(pass.machine.begin(), pass.machine.end());
    const auto motion = derivatives<kMotion>(its, place);
    u.insert(u.end(), motion.begin(), motion.end());
    return u;
  };
  std::vector<double> slopes(arguments + kMotion);
  const std::vector<double> u = at(edge.place);
  deciders_[integrand][edge.decision->decider](std::span<const double>(u),
                                               std::span<double>(slopes));
  const std::span<const double> by_motion = std::span<const double>(slopes).subspan(arguments);
  const auto rates = derivatives<kMotion + 1>(its, edge.place);
  const double rate =
      std::inner_product(by_motion.begin(), by_motion.end(), rates.begin() + 1, 0.0);
  const auto value_at = [&](double place) {
    const std::vector<double> taken = at(place);
    return decider(std::span<const double>(taken));
  };
  if (!moving_place<double>(value_at, rate, edge.place, its.end - its.begin)) return;
  const double factor = -slope / rate;
  for (std::size_t k = 0; k < arguments; ++k) pass.by_machine[k] += factor * slopes[k];
  std::array<double, kMotion> handed;
  for (std::size_t m = 0; m < kMotion; ++m) handed[m] = factor * by_motion[m];
  pass.by_law.add_motion(piece, edge.place, handed);
}

}  // namespace camlaw::problems
