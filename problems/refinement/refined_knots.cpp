// SPDX-License-Identifier: MIT
#include "problems/refinement/refined_knots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "kinematics/laws/free.h"
#include "kinematics/program/segment_merits.h"
#include "optim/crew/crew.h"
#include "optim/search/free_memory.h"
#include "optim/verdict/verdict.h"
#include "problems/fronts/study_worker.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// Highest derivative of a polynomial piece, and its order.
struct Top {
  double value = 0;
  int order = 0;
};

Top top_of(const Piece<double>& piece) {
  double value = 0;
  const int degree = static_cast<int>(piece.polynomial.size()) - 1;
  if (degree >= 0) value = piece.polynomial.back();
  for (int k = 2; k <= degree; ++k) value *= k;
  return {value, degree};
}

const Piece<double>& piece_at(const Law<double>& law, double x) {
  const auto& pieces = law.pieces();
  const auto found = std::find_if(pieces.begin(), pieces.end(),
                                  [&](const Piece<double>& piece) { return x <= piece.end; });
  return found == pieces.end() ? pieces.back() : *found;
}

/// (KN1) How much each span between two knots could gain: the jumps of the highest derivative at
/// its ends, by what they do to the acceleration within it, over that acceleration and the mean
/// one.
std::vector<double> promises(const Law<double>& law, const std::vector<double>& knots) {
  std::vector<double> ends{0};
  ends.insert(ends.end(), knots.begin(), knots.end());
  ends.push_back(1);
  std::vector<Top> tops;
  std::vector<double> accelerations;
  int degree = 0;
  double mean = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i] + ends[i + 1]);
    tops.push_back(top_of(piece_at(law, middle)));
    degree = std::max(degree, tops.back().order);
    accelerations.push_back(std::abs(law(middle).a));
    mean += accelerations.back() / static_cast<double>(ends.size() - 1);
  }
  const auto value = [&](std::size_t i) { return tops[i].order == degree ? tops[i].value : 0; };
  std::vector<double> result(tops.size(), 0.0);
  for (std::size_t i = 0; i < tops.size() && mean > 0; ++i) {
    double jumps = 0;
    if (i > 0) jumps += std::abs(value(i) - value(i - 1));
    if (i + 1 < tops.size()) jumps += std::abs(value(i + 1) - value(i));
    result[i] = jumps * std::pow(ends[i + 1] - ends[i], std::max(1, degree - 2)) /
                (accelerations[i] + mean);
  }
  return result;
}

/// The laws of a design that are free: its own, or those of a program's segments.
std::vector<Law<double>> free_laws(const ProblemStatement& design) {
  const Member& member = design.laws.front();
  if (!member.family->spans) return {member.law()};
  std::vector<Law<double>> laws;
  for (const SegmentMerits& segment : segment_merits(member)) {
    const bool is_free = std::any_of(
        design.variables.begin(), design.variables.end(), [&](const VariableStatement& v) {
          return v.of_law && v.law_parameter == segment.name + "_coefficients";
        });
    if (is_free && segment.law) laws.push_back(*segment.law);
  }
  return laws;
}

/// Of all free laws of a design.
std::vector<double> promises(const ProblemStatement& design, const std::vector<double>& knots) {
  std::vector<double> result(knots.size() + 1, 0.0);
  for (const Law<double>& law : free_laws(design)) {
    const std::vector<double> own = promises(law, knots);
    for (std::size_t i = 0; i < own.size(); ++i) result[i] = std::max(result[i], own[i]);
  }
  return result;
}

constexpr double kShortest = 1.0 / 65536;  // a span: each order of derivatives divides by it

/// Of the spans that are not short those that together promise most of what they all do.
std::vector<bool> chosen_spans(std::vector<double> promise, const std::vector<double>& knots) {
  constexpr double kMost = 0.85;  // the spans with the rest are many and gain little
  double from = 0;
  for (std::size_t i = 0; i < promise.size(); ++i) {
    const double to = i < knots.size() ? knots[i] : 1;
    if (to - from < 2 * kShortest) promise[i] = 0;
    from = to;
  }
  std::vector<std::size_t> order(promise.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return promise[a] > promise[b]; });
  const double all = std::accumulate(promise.begin(), promise.end(), 0.0);
  std::vector<bool> chosen(promise.size(), false);
  double sum = 0;
  for (const std::size_t i : order) {
    if (!(sum < kMost * all)) break;
    sum += promise[i];
    chosen[i] = true;
  }
  return chosen;
}

/// Neighbouring spans that were halved together, for the `times`-th time in a row.
struct Halved {
  double from, to;
  double promise;  ///< the largest of them
  int times = 1;
};

/// Knots inside (0, 1), and what the last round halved to come to them.
struct DividedKnots {
  std::vector<double> knots;
  std::vector<Halved> last = {};
};

/// The place about which chosen spans are what was halved in the last round, at half its size, and
/// promise as much as it did; none where they are not, or where no knot or end lies there.
std::optional<double> shrunk_about(const Halved& now, const Halved& before,
                                   const std::vector<double>& knots) {
  constexpr double kRounding = 1e-12;  // of sums of knots
  constexpr double kKept = 0.75;       // where all derivatives have limits half of it is left
  if (!(now.promise > kKept * before.promise)) return {};
  const double place = 2 * now.from - before.from;
  if (std::abs(2 * (now.to - now.from) - (before.to - before.from)) > kRounding) return {};
  if (place < now.from - kRounding || place > now.to + kRounding) return {};
  for (const double end : {0.0, 1.0}) {
    if (std::abs(place - end) <= kRounding) return end;
  }
  const auto knot =
      std::ranges::find_if(knots, [&](double k) { return std::abs(place - k) <= kRounding; });
  return knot == knots.end() ? std::nullopt : std::optional(*knot);
}

/// (KN2) Adds a knot in the middle of each span between `ends`, which lie next to one another.
/// Where the last round did the same at twice the size, about a place where a derivative grows
/// without bound, further rounds would repeat that: twice as many of them as at the last time are
/// taken at once.
void halve(const std::vector<double>& ends, double promise, const DividedKnots& divided,
           DividedKnots& result) {
  Halved own{ends.front(), ends.back(), promise};
  std::optional<double> about;
  for (const Halved& before : divided.last) {
    about = shrunk_about(own, before, divided.knots);
    if (!about) continue;
    own.times = 2 * before.times;
    break;
  }
  double shortest = 1;
  for (std::size_t i = 1; i < ends.size(); ++i)
    shortest = std::min(shortest, ends[i] - ends[i - 1]);
  while (own.times > 1 && std::ldexp(shortest, -own.times) < kShortest) --own.times;
  for (int k = 0; k < own.times; ++k) {
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double middle = 0.5 * (ends[i - 1] + ends[i]);
      result.knots.push_back(k == 0 ? middle : *about + std::ldexp(middle - *about, -k));
    }
  }
  if (about) {  // the last of them halved this
    own.from = *about + std::ldexp(own.from - *about, 1 - own.times);
    own.to = *about + std::ldexp(own.to - *about, 1 - own.times);
  }
  result.last.push_back(own);
}

/// Knots with more in each span that promises much, and in its mirror image where the law is
/// symmetric.
DividedKnots with_more(const DividedKnots& divided, std::vector<double> promise, bool symmetric) {
  constexpr double kSame = 1e-12;  // two knots
  const std::size_t last = promise.size() - 1;
  if (symmetric) {
    for (std::size_t i = 0; i <= last / 2; ++i)
      promise[i] = promise[last - i] = std::max(promise[i], promise[last - i]);
  }
  const std::vector<bool> chosen = chosen_spans(promise, divided.knots);
  DividedKnots result{divided.knots};
  std::vector<double> ends;  // of chosen spans next to one another
  double largest = 0;        // of what these promise
  double from = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const double to = i < last ? divided.knots[i] : 1;
    if (chosen[i] || (symmetric && chosen[last - i])) {
      if (ends.empty()) ends.push_back(from);
      ends.push_back(to);
      largest = std::max(largest, promise[i]);
    } else if (!ends.empty()) {
      halve(ends, largest, divided, result);
      ends.clear();
      largest = 0;
    }
    from = to;
  }
  if (!ends.empty()) halve(ends, largest, divided, result);
  std::vector<double>& knots = result.knots;
  std::ranges::sort(knots);
  const auto same = [](double a, double b) { return b - a < kSame; };
  knots.erase(std::unique(knots.begin(), knots.end(), same), knots.end());
  return result;
}

/// The coefficients of a free law with more knots that moves as a law does; empty where there is no
/// such free law.
std::vector<double> refined(const Family& with_more, const Law<double>& law) {
  return with_more.moving_as ? with_more.moving_as(law).list(0) : std::vector<double>{};
}

/// The same by the names of the parameters that they are: of a law's own, or of a program's
/// segments.
std::map<std::string, std::vector<double>> refined(const Member& with_more, const Member& design) {
  std::map<std::string, std::vector<double>> result;
  if (!design.family->spans) {
    result.emplace("coefficients", refined(*with_more.family, design.law()));
    return result;
  }
  const auto stated = with_more.family->spans(with_more.arguments);
  const auto merits = segment_merits(design);
  for (std::size_t i = 0; i < merits.size(); ++i) {
    if (stated[i].law && merits[i].law)
      result.emplace(merits[i].name + "_coefficients",
                     refined(*stated[i].law->family, *merits[i].law));
  }
  return result;
}

/// Lets a statement with more knots begin at a design with fewer: its free laws move as they do
/// there.
void begin_at(const ProblemStatement& design, ProblemStatement& with_more) {
  const auto coefficients = refined(with_more.laws.front(), design.laws.front());
  for (VariableStatement& variable : with_more.variables) {
    const auto own = coefficients.find(variable.law_parameter);
    double start = variable.start;
    if (variable.of_law && own != coefficients.end()) {
      if (variable.element >= own->second.size()) continue;
      start = own->second[variable.element];
    } else {
      const NamedParameter parameter = find_parameter(design, variable.name);
      start = values_of(design, parameter).at(variable.element);
    }
    variable.start = std::clamp(start, variable.lower, variable.upper);
  }
}

void set_knots(ProblemStatement& statement, const std::vector<double>& knots) {
  set_value(statement, fmt::format("free.knots=[{}]", fmt::join(knots, ", ")));
}

constexpr double kLittle = 1e-5;  // of the objective

/// Whether each of the last two rounds changed the objective by little.
bool changes_little(const std::vector<KnotRound>& rounds) {
  if (rounds.size() < 3) return false;
  const auto is_little = [&](const KnotRound& before, const KnotRound& after) {
    return std::abs(after.objective - before.objective) <= kLittle * std::abs(after.objective);
  };
  return is_little(rounds.end()[-3], rounds.end()[-2]) &&
         is_little(rounds.end()[-2], rounds.end()[-1]);
}

bool is_certified(const optim::Optimum& optimum) {
  return optimum.found.assessment.verdict == optim::Verdict::Certified;
}

/// Whether a round led to a design that is as good as the best before, but for rounding.
bool is_no_worse(const optim::Optimum& fresh, const optim::Optimum& best) {
  constexpr double kRounding = 1e-7;  // of the objective, which is certified to no more (OC5)
  const optim::Assessment &a = fresh.found.assessment, &b = best.found.assessment;
  if (!optim::is_feasible(b)) return true;
  if (!optim::is_feasible(a)) return false;
  const double sign = best.problem.objective().sense == optim::Sense::Minimize ? 1 : -1;
  const double rise = sign * (a.objective.value - b.objective.value);
  return rise <= kRounding * std::abs(b.objective.value);
}

/// What is left to gain where each gain is the same share of the one before.
std::optional<double> left_of(const std::vector<KnotRound>& rounds) {
  if (rounds.size() < 3) return {};
  const double a = rounds.end()[-3].objective, b = rounds.end()[-2].objective,
               c = rounds.end()[-1].objective;
  const double share = (c - b) / (b - a);
  // Of gains that shrink by less the sum has more than ten times the error of one.
  constexpr double kShrinks = 0.9, kNothing = 1e-9;
  if (std::abs(c - b) <= kNothing * std::abs(c)) return 0.0;
  if (!(share > 0 && share < kShrinks)) return {};
  return std::abs(c - b) * share / (1 - share);
}

void check_one_law(const ProblemStatement& statement) {
  if (statement.laws.size() == 1) return;
  throw std::invalid_argument(fmt::format(
      "{}: knots = \"auto\" needs one law, and {} are to be chosen from; state how many knots",
      statement.source, statement.laws.size()));
}

/// Why a round was the last one, in words; empty where another may follow.
std::string reason_to_end(const RefinedKnots& result, const std::vector<KnotRound>& better,
                          const std::function<bool()>& stop) {
  constexpr std::size_t kMostRounds = 24, kMostInVain = 10;  // each with up to twice the knots
  const optim::Found& found = result.optimum.found;
  // Where no design meets the limits, the one of least violation tells where knots may help.
  const bool is_vain = !optim::is_feasible(found.assessment) && result.rounds.size() >= kMostInVain;
  if (is_vain || found.x.size() != result.optimum.problem.variables.size())
    return "the search led to no design within the limits";
  if (is_near_limit(result.optimum.problem, found.assessment) && better.size() > 1)
    return "the objective is within 0.01 % of a bound that no law can beat";
  if (changes_little(better))
    return fmt::format("the last ones changed the objective by less than {:g} of it", kLittle);
  if (result.rounds.size() == kMostRounds) return "the limit of rounds was reached";
  return stop() ? "the search was ended" : "";
}

/// The knots for the next round; none where no more are added, and then why.
std::optional<DividedKnots> more_knots(const ProblemStatement& design, const DividedKnots& divided,
                                       RefinedKnots& result, bool symmetric) {
  constexpr std::size_t kMostKnots = 300;  // at a jerk limit 86 do what 1000 even ones do
  DividedKnots more = with_more(divided, promises(design, divided.knots), symmetric);
  if (more.knots.size() > kMostKnots) {
    result.ended = fmt::format("more than {} would be needed", kMostKnots);
  } else if (more.knots.size() == divided.knots.size()) {
    result.ended = "shorter spans are not divided";
  }
  return result.ended.empty() ? std::optional(std::move(more)) : std::nullopt;
}

/// Whether a round takes the place of the best before, with its knots and its design.
bool is_taken(optim::Optimum& optimum, const ProblemStatement& own, std::vector<double> knots,
              RefinedKnots& result, ProblemStatement& statement) {
  if (!result.knots.empty() && !is_no_worse(optimum, result.optimum)) return false;
  result.knots = std::move(knots);
  result.optimum = std::move(optimum);
  statement = own;
  return true;
}

/// Searches knots from where a design with fewer of them stands; if that leads to nothing better,
/// from all starts.
optim::Optimum searched_from(const ProblemStatement& design, const ProblemStatement& own,
                             const RefinedKnots& result, const SearchOnce& search,
                             const std::function<bool()>& stop) {
  ProblemStatement begun = own;
  begin_at(design, begun);
  optim::Optimum optimum = search(begun, Begin::AtStart);
  const bool is_enough = is_no_worse(optimum, result.optimum) || stop();
  return is_enough ? std::move(optimum) : search(own, Begin::AsStated);
}

/// Searches the best knots once more from all starts that are stated, where their round did with
/// one.
void search_whole(const ProblemStatement& statement, const SearchOnce& search,
                  RefinedKnots& result) {
  ProblemStatement begun = statement;
  begin_at(BoundProblem(statement).at(result.optimum.options, result.optimum.found.x), begun);
  optim::Optimum whole = search(begun, Begin::AsStated);
  const bool is_better = is_certified(whole) || !is_certified(result.optimum);
  if (is_better && is_no_worse(whole, result.optimum)) result.optimum = std::move(whole);
}

/// A round that led to a certified optimum, to come back to.
struct Certified {
  std::vector<double> knots;
  optim::Optimum optimum;
  ProblemStatement statement;
};

/// Where the last knots led to no certified optimum, the last ones that did.
void come_back(std::optional<Certified> certified, ProblemStatement& statement,
               RefinedKnots& result) {
  if (!certified || is_certified(result.optimum)) return;
  result.ended += fmt::format("; with {} the optimum is not certified", result.knots.size());
  result.knots = std::move(certified->knots);
  result.optimum = std::move(certified->optimum);
  statement = std::move(certified->statement);
}

}  // namespace

RefinedKnots refine_knots(ProblemStatement& statement, const SearchOnce& search,
                          const std::function<bool()>& stop) {
  constexpr int kAtFirst = 39;  // as many variables as are searched by sparse methods
  check_one_law(statement);
  const ProblemStatement stated = statement;
  RefinedKnots result;
  std::vector<KnotRound> better;           // rounds that were
  std::optional<ProblemStatement> design;  // to begin the next one at
  int starts = 1;                          // of a whole search
  std::optional<Certified> certified;
  for (std::optional tried(DividedKnots{even_knots(kAtFirst)}); tried;) {
    const std::vector<double>& knots = tried->knots;
    ProblemStatement own = stated;
    set_knots(own, knots);
    optim::Optimum optimum =
        design ? searched_from(*design, own, result, search, stop) : search(own, Begin::AsStated);
    starts = std::max(starts, optimum.found.planned_starts);
    const optim::Assessment& a = optimum.found.assessment;
    const KnotRound round{knots.size(), a.objective.value, a.verdict};
    result.rounds.push_back(round);
    if (!is_taken(optimum, own, knots, result, statement)) {
      const char* why = "led to nothing better";
      if (stop()) why = "was ended before it led to anything better";
      result.ended = fmt::format("the search with {} {}", knots.size(), why);
      break;
    }
    const optim::Found& found = result.optimum.found;
    if (is_certified(result.optimum)) certified = {result.knots, result.optimum, statement};
    if (optim::is_feasible(found.assessment)) better.push_back(round);
    result.ended = reason_to_end(result, better, stop);
    if (!result.ended.empty()) break;
    const ProblemStatement at = BoundProblem(statement).at(result.optimum.options, found.x);
    tried = more_knots(at, *tried, result, statement.free_is_symmetric);
    design = optim::is_feasible(found.assessment) ? std::optional(at) : std::nullopt;
  }
  const bool is_whole = result.optimum.found.planned_starts == starts;
  if (!is_whole && !result.optimum.found.assessment.global && !stop())
    search_whole(statement, search, result);
  come_back(std::move(certified), statement, result);
  result.left = left_of(better);
  return result;
}

RefinedKnots find_knots(ProblemStatement& statement, const optim::OptimiseOptions& search,
                        int workers, const std::function<double()>& spent,
                        const std::function<void(const std::string& stage)>& begins) {
  int round = 0;
  // Of the rounds that are followed by a search from all starts.
  std::string method = search.solver, why_method;
  const auto once = [&](const ProblemStatement& stated, Begin begin) {
    if (begins) begins(fmt::format("knots, round {}", ++round));
    optim::OptimiseOptions how = search;
    how.spent = spent();
    if (begin == Begin::AtStart) {
      how.starts = 1;
      how.solver = method;
    }
    const BoundProblem bound(stated);
    const optim::ProblemSpace space = bound.space();
    const int room = search.memory ? optim::workers_with_room(
                                         workers, space.problem(space.options(0)), *search.memory)
                                   : workers;
    optim::Crew crew({.workers = room, .program = worker_program(stated)});
    optim::Optimum optimum = optim::optimise(space, how, crew);
    const bool has_starts = begin == Begin::AsStated && optimum.found.planned_starts > 1;
    if (has_starts && !optimum.found.solver.empty()) method = optimum.found.solver;
    if (begin == Begin::AsStated) why_method = optimum.found.why_solver;
    optimum.found.why_solver = why_method;
    return optimum;
  };
  const auto stop = [&] {
    const bool late = search.time_limit && spent() >= *search.time_limit;
    return late || (search.stop != nullptr && *search.stop);
  };
  return refine_knots(statement, once, stop);
}

}  // namespace camlaw::problems
