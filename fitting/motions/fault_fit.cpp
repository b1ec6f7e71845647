// SPDX-License-Identifier: MIT
#include "fitting/motions/fault_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>

#include "fitting/motions/law_ranking.h"
#include "numerics/linear/dense.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// The samples of one dwell without its ends.
std::vector<std::size_t> inside(const MotionSamples& samples, const FoundSegment& dwell) {
  constexpr double kEnds = 0.1;  // of the dwell, at each end
  const double length = dwell.end - dwell.begin;
  const double low = dwell.begin + kEnds * length, high = dwell.end - kEnds * length;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (in_period(samples.place[i], low, kTurnDegrees) <= high) result.push_back(i);
  }
  return result;
}

/// How far the centre lies off by what moves in the dwells: least squares of a level for each dwell
/// and the centre for all. None where they are too short to tell.
std::optional<Eigen::Vector2d> by_dwells(const WithoutFault& record, const FoundCycle& cycle) {
  // Over a shorter arc (deg) a centre that lies off looks like a slope of the dwell, and fewer
  // samples are mostly noise.
  constexpr double kShortest = 60, kFewest = 20;
  std::vector<std::vector<std::size_t>> dwells;
  double length = 0;
  std::size_t count = 0;
  for (const FoundSegment& segment : cycle.segments) {
    if (segment.kind != SegmentKind::Dwell) continue;
    dwells.push_back(inside(record.samples, segment));
    length += segment.end - segment.begin;
    count += dwells.back().size();
  }
  if (length < kShortest || static_cast<double>(count) < kFewest) return {};
  const auto levels = static_cast<Eigen::Index>(dwells.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), levels + 2);
  Eigen::VectorXd values(static_cast<Eigen::Index>(count));
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < levels; ++k) {
    for (const std::size_t i : dwells[static_cast<std::size_t>(k)]) {
      const double place = record.samples.place[i];
      columns(row, k) = 1;
      columns(row, levels) = record.fault.by[0](place);
      columns(row, levels + 1) = record.fault.by[1](place);
      values[row++] = record.samples.value[i];
    }
  }
  const Eigen::VectorXd found = optim::least_squares(columns, values);
  return Eigen::Vector2d(found[levels], found[levels + 1]);
}

Possible<RankedMotions> ranked(const FoundCycle& cycle, const std::vector<Member>& laws,
                               const LawFitOptions& options) {
  RankedMotions result;
  const auto count = static_cast<double>(cycle.motions.size());
  for (const FoundMotion& motion : cycle.motions) {
    const auto before = static_cast<double>(result.samples.size());
    auto ranking = possible_ranking(motion.samples, laws, motion.guess,
                                    part_of(options, before / count, (before + 1) / count));
    if (!ranking) return ranking.reason();
    result.rankings.push_back(std::move(ranking->fits));
    result.samples.push_back(motion.samples);
    add_names(ranking->untried, result.untried);
  }
  return result;
}

/// The laws that tell the motions best with the fault fitted along, some of each motion; some of
/// them without coefficients, which would follow what a step leaves of a large fault.
std::vector<Member> best_with(const RankedMotions& found, const PossibleFault& fault) {
  // The first order ranks laws only roughly, so that some are fitted; flexible laws come first and
  // must not be the only ones.
  constexpr std::size_t kTried = 3, kPlain = 6;
  std::vector<Member> result;
  std::set<std::string> names;
  for (std::size_t k = 0; k < found.rankings.size(); ++k) {
    std::vector<std::pair<double, const LawFit*>> scores;
    for (const LawFit& fit : found.rankings[k]) {
      scores.emplace_back(test_fault({{fit}}, {found.samples[k]}, fault).score, &fit);
    }
    std::stable_sort(scores.begin(), scores.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t any = 0, plain = 0;
    for (const auto& [score, fit] : scores) {
      const bool is_plain = !fit->has_coefficients();
      if (any >= kTried && !(is_plain && plain < kPlain)) continue;
      ++any;
      if (is_plain) ++plain;
      if (names.insert(fit->law.name()).second) result.push_back(fit->law);
    }
  }
  return result;
}

}  // namespace

double Centre::x_error() const { return std::sqrt(covariance(0, 0)); }
double Centre::y_error() const { return std::sqrt(covariance(1, 1)); }

std::size_t RankedMotions::count() const {
  std::size_t result = 0;
  for (const MotionSamples& motion : samples) result += motion.place.size();
  return result;
}

Possible<FaultFit> fit_fault(const TakeOut& take_out, Eigen::VectorXd start,
                             const std::vector<Member>& laws, const LawFitOptions& options,
                             const RankedMotions* first) {
  // Gauss-Newton's steps settle in a few; each fits all laws to the record anew.
  constexpr int kSteps = 8;
  constexpr double kSettled = 0.05;  // of its standard error
  constexpr double kFirst = 0.8;     // of the work
  FaultFit fit{std::move(start), {}};
  std::vector<Member> tried = laws;
  for (int step = 0; step < kSteps; ++step) {
    const auto record = take_out(fit.size);
    if (!record) return record.reason();
    const auto done = [](int steps) {
      return steps == 0 ? 0 : kFirst + (1 - kFirst) * (steps - 1) / (kSteps - 1);
    };
    const auto part = part_of(options, done(step), done(step + 1));
    const auto about = [&]() -> Possible<RankedMotions> {
      if (step == 0 && first != nullptr) return *first;
      const auto cycle = possible_motions(record->samples);
      if (!cycle) return cycle.reason();
      return ranked(*cycle, tried, part);
    };
    const auto found = about();
    if (!found) return found.reason();
    const FaultTest test = test_fault(found->rankings, found->samples, record->fault);
    if (!test.covariance.allFinite()) {
      return Impossible{"the samples do not determine the fault"};
    }
    fit.covariance = test.covariance;
    fit.score = test.score;
    fit.count = found->count();
    add_names(found->untried, fit.untried);
    fit.size += test.size;
    if (test.size.norm() < kSettled * std::sqrt(test.covariance.trace())) break;
    if (step == 0) tried = best_with(*found, record->fault);
  }
  return fit;
}

FaultTest followed(const FaultTest& test, const RankedMotions& motions, const TakeOut& take_out,
                   const LawFitOptions& options) {
  RankedMotions plain = motions;
  for (std::vector<LawFit>& ranking : plain.rankings) {
    std::erase_if(ranking, [](const LawFit& fit) { return fit.has_coefficients(); });
  }
  FaultTest result = test;
  result.gain = 0;
  const auto unknowns = static_cast<Eigen::Index>(test.fault.by.size());
  const auto fit = fit_fault(take_out, Eigen::VectorXd::Zero(unknowns), {}, options, &plain);
  if (!fit) return result;  // the follower cannot follow, or nothing determines it
  // Scores are sums over the samples, of which a few more or less may lie off.
  const double share = static_cast<double>(motions.count()) / static_cast<double>(fit->count);
  result.gain = test.score + test.gain - share * fit->score;
  result.size = fit->size;
  result.covariance = fit->covariance;
  constexpr double kBeyondChance = 5;  // deviations
  const double squares = fit->size.dot(optim::solve_ldlt(fit->covariance, fit->size));
  result.with_plain_laws = squares > kBeyondChance * kBeyondChance;
  return result;
}

Centre find_centre(const TakeOut& take_out, const std::vector<Member>& laws,
                   const LawFitOptions& options) {
  // The centre is linear in the dwells but for what it turns the angles by.
  constexpr int kDwellSteps = 8;
  constexpr double kSettled = 0.05;  // of the noise
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(2);
  for (int step = 0; step < kDwellSteps; ++step) {
    const WithoutFault record = take_out(centre).value();
    const FoundCycle cycle = find_motions(record.samples);
    const auto by = by_dwells(record, cycle);
    if (!by) break;
    centre += *by;
    if (by->norm() < kSettled * cycle.noise) break;
  }
  const FaultFit fit = fit_fault(take_out, centre, laws, options).value();
  return {{fit.size[0], fit.size[1]}, fit.covariance, fit.untried};
}

}  // namespace camlaw::problems
