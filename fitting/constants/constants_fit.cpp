// SPDX-License-Identifier: MIT
#include "fitting/constants/constants_fit.h"

#include <algorithm>
#include <memory>

#include "fitting/constants/agreement.h"
#include "fitting/motions/same_motion.h"

namespace camlaw::problems {
namespace {

/// Subsets of n with `left_out` elements missing.
std::vector<std::vector<std::size_t>> subsets(std::size_t n, std::size_t left_out) {
  std::vector<std::vector<std::size_t>> result;
  std::vector<bool> out(n, false);
  std::fill(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(left_out), true);
  do {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < n; ++i) {
      if (!out[i]) kept.push_back(i);
    }
    result.push_back(std::move(kept));
  } while (std::prev_permutation(out.begin(), out.end()));
  return result;
}

bool is_better(const ConstantsFit& a, const ConstantsFit& b) {
  return std::pair(a.cost, !a.consistent) < std::pair(b.cost, !b.consistent);
}

/// What a law makes of the prints with some of the constants left out.
class PrintedLaw {
 public:
  explicit PrintedLaw(std::unique_ptr<const PrintedModel> model) : model_(std::move(model)) {}

  std::size_t unknowns() const { return model_->unknowns().size(); }

  /// With the default values, whether the constants agree or not.
  ConstantsFit as_it_is() const { return problems::as_it_is(*model_); }

  /// Explanations of at most `limit` digits that leave out so many constants, none where fewer have
  /// been enough.
  std::vector<ConstantsFit> explanations(std::size_t left_out, double limit) {
    std::vector<ConstantsFit> result;
    if (is_explained_) return result;
    for (const auto& which : subsets(model_->constants().size(), left_out)) {
      if (least_cost(which) > limit) continue;
      const std::vector<AgreeingValues> all = Agreement(*model_, which).solutions();
      for (const AgreeingValues& one : all) {
        is_explained_ = true;
        auto fit = shortest(*model_, which, one, all, limit);
        if (!fit) continue;
        result.push_back(std::move(*fit));
        if (result.back().cost == 0) break;  // nothing explains the prints better
      }
    }
    return result;
  }

 private:
  /// That of the constants left out, and of one digit and its being there where the default
  /// values do not agree with the others.
  double least_cost(const std::vector<std::size_t>& which) const {
    double cost = Agreement(*model_, which).all_agree(model_->defaults()) ? 0 : 2;
    for (std::size_t c = 0; c < model_->constants().size(); ++c) {
      const bool kept = std::find(which.begin(), which.end(), c) != which.end();
      if (!kept) cost += cost_of(model_->constants()[c]);
    }
    return cost;
  }

  std::unique_ptr<const PrintedModel> model_;
  bool is_explained_ = false;
};

/// Whether two explanations are one motion that prints the same constants: with other ends one
/// jumps where the other does not.
bool is_same(const ConstantsFit& a, const ConstantsFit& b) {
  const auto agree_alike =
      std::equal(a.constants.begin(), a.constants.end(), b.constants.begin(), b.constants.end(),
                 [](const auto& one, const auto& other) { return one.agrees == other.agrees; });
  if (!agree_alike) return false;
  const auto of_machine = [](const ConstantsFit& fit) {
    std::vector<double> values;
    for (const FoundNumber& n : fit.numbers) {
      if (!n.of_law) values.push_back(n.value);
    }
    return values;
  };
  return of_machine(a) == of_machine(b) && same_motion(a.law, b.law);
}

/// The best first, each motion once; of a family's member that has a place of its own in the
/// catalogue, and so takes no digits, that which tells the ranges of its coefficients.
std::vector<ConstantsFit> ranked(std::vector<ConstantsFit> fits) {
  std::stable_sort(fits.begin(), fits.end(), is_better);
  std::vector<ConstantsFit> result;
  for (ConstantsFit& fit : fits) {
    const auto known = std::find_if(result.begin(), result.end(),
                                    [&](const ConstantsFit& other) { return is_same(fit, other); });
    if (known == result.end()) {
      result.push_back(std::move(fit));
    } else if (known->law.name() != fit.law.name()) {
      const bool named = std::any_of(known->also.begin(), known->also.end(),
                                     [&](const Member& m) { return m.name() == fit.law.name(); });
      if (!named) known->also.push_back(fit.law);
    } else if (known->numbers.size() < fit.numbers.size()) {
      fit.also = std::move(known->also);
      fit.cost = known->cost;
      *known = std::move(fit);
    }
  }
  return result;
}

}  // namespace

std::vector<ConstantsFit> fit_constants(const ConstantsQuestion& question, const Member& law) {
  PrintedLaw candidate(std::make_unique<const PrintedModel>(question, law));
  if (candidate.unknowns() == 0) return {candidate.as_it_is()};
  std::vector<ConstantsFit> result;
  for (std::size_t out = 0; out < question.constants.size() && result.empty(); ++out) {
    result = candidate.explanations(out, optim::kInfinity);
  }
  return ranked(std::move(result));
}

namespace {

/// Those with few unknowns first: they are quick. A law with more of them than there are constants
/// is tried with the coefficients that it has.
std::vector<PrintedLaw> printed_laws_of(const ConstantsQuestion& question,
                                        const std::vector<Member>& laws) {
  const std::size_t most = question.constants.size();
  const std::vector<Unknown> of_machine = machine_unknowns_of(question);
  std::vector<std::pair<std::size_t, PrintedLaw>> candidates;
  for (const Member& law : laws) {
    const std::vector<Unknown> all = unknowns_of(question, law);
    const auto& searched = all.size() > most ? of_machine : all;
    if (searched.size() > most) continue;
    candidates.emplace_back(
        all.size(), PrintedLaw(std::make_unique<const PrintedModel>(question, law, searched)));
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PrintedLaw> result;
  for (auto& [unknowns, candidate] : candidates) result.push_back(std::move(candidate));
  return result;
}

/// A law that was tried with the coefficients that it has tells their ranges.
void add_ranges(const ConstantsQuestion& question, std::vector<ConstantsFit>& fits) {
  for (ConstantsFit& fit : fits) {
    const PrintedModel model(question, fit.law);
    if (fit.numbers.size() < model.unknowns().size()) fit = with_ranges(model, std::move(fit));
  }
}

}  // namespace

std::vector<ConstantsFit> rank_laws(const ConstantsQuestion& question,
                                    const std::vector<Member>& laws) {
  std::vector<PrintedLaw> candidates = printed_laws_of(question, laws);
  // All with few constants left out before any with more: what costs more than the best found on
  // the path is not looked for. Of explanations that leave something out only those count that are
  // shorter than the print itself.
  constexpr double kMargin = 3;  // digits: what comes near is worth knowing
  std::vector<ConstantsFit> result;
  double best = optim::kInfinity;
  for (std::size_t out = 0; out < question.constants.size(); ++out) {
    if (out == 1) best = std::min(best, cost_of(question.constants));
    for (PrintedLaw& candidate : candidates) {
      for (ConstantsFit& fit : candidate.explanations(out, best + kMargin)) {
        best = std::min(best, fit.cost);
        result.push_back(std::move(fit));
      }
    }
  }
  result = ranked(std::move(result));
  add_ranges(question, result);
  return result;
}

std::vector<Member> laws_to_try() {
  std::vector<Member> result;
  for (const Family& family : catalogue()) {
    const auto& parameters = family.parameters;
    // A spline or a table is a curve of its own, not a law.
    constexpr std::size_t kFew = 4;
    const bool is_data = std::any_of(parameters.begin(), parameters.end(), [](const Parameter& p) {
      return p.list && p.default_value.size() > kFew;
    });
    if (!is_data) result.push_back({&family, family.defaults()});
  }
  return result;
}

}  // namespace camlaw::problems
