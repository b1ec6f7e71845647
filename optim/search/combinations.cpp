// SPDX-License-Identifier: MIT
#include "optim/search/combinations.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "optim/search/local.h"
#include "optim/search/memory.h"
#include "optim/search/several_starts.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {

/// One problem in the continuous variables; or one whose integer variables a tree is searched for.
struct Combinations::Item {
  struct Start {
    std::optional<FromStart> found = {};
    std::optional<std::size_t> errand = {};  ///< while it is under way
    FirstStart first = FirstStart::Led;      ///< what it was told of the first one

    bool is_open() const { return !found && !errand; }
  };

  SearchTask::Kind kind = SearchTask::Kind::Everywhere;
  std::vector<double> integers = {};
  std::vector<Start> starts = {};  ///< that are planned; empty where no start is an errand
  bool is_given = false;           ///< the rest of the search, when the starts are known
  std::optional<SearchAnswer> answer = {};

  /// How many starts count, from the first on: all that are known, up to one that ends the search.
  std::size_t known() const {
    std::size_t count = 0;
    while (count < starts.size() && starts[count].found) {
      if (ends_search(*starts[count++].found)) break;
    }
    return count;
  }
  bool is_known() const {
    const std::size_t count = known();
    return count == starts.size() || (count > 0 && ends_search(*starts[count - 1].found));
  }
  bool has_start() const {
    return std::any_of(starts.begin(), starts.end(), [](const Start& s) { return bool(s.found); });
  }
  bool is_under_way() const {
    return std::any_of(starts.begin(), starts.end(), [](const Start& s) { return bool(s.errand); });
  }
};

struct Combinations::Part {
  SearchedPart searched;
  SearchTask::Kind kind = SearchTask::Kind::Everywhere;
  std::vector<std::vector<double>> integers;  ///< of its items
  std::size_t next_item = 0;
  std::deque<Item> items = {};  ///< that are under way, in order
};

namespace {

/// The n-th option of a choice, counted from the one it starts with outwards: 5, 6, 4, 7, 3, ...
std::size_t nth_option(const Choice& choice, std::size_t n) {
  const std::size_t count = choice.options.size(), start = std::min(choice.start, count - 1);
  const std::size_t both = std::min(start, count - 1 - start);  // so far there are two sides
  if (n > 2 * both) return start > both ? count - 1 - n : n;
  return n % 2 == 1 ? start + (n + 1) / 2 : start - n / 2;
}

/// Options as digits of a counter, the last fastest; the first combination is the start's.
std::vector<std::size_t> options_at(const std::vector<Choice>& choices, std::size_t count) {
  std::vector<std::size_t> result(choices.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    result[i] = nth_option(choices[i], count % choices[i].options.size());
    count /= choices[i].options.size();
  }
  return result;
}

bool has_integers(const Problem& problem) {
  return std::any_of(problem.variables.begin(), problem.variables.end(),
                     [](const Variable& v) { return v.integer; });
}

void check(const Problem& problem, const OptimiseOptions& options) {
  problem.check();
  if (problem.objectives.size() > 1) {
    throw std::invalid_argument(
        fmt::format("optimise() takes one objective, but this problem has {}; use pareto() to find "
                    "their front",
                    problem.objectives.size()));
  }
  if (options.memory) check_memory(problem, *options.memory);
}

/// What is said of a search whose process has died.
SearchAnswer failed(SearchTask::Kind kind, const std::string& solver, const std::string& why) {
  Found found;
  found.solver = solver;
  found.why_solver = "its process died";
  found.assessment.reason = why;
  if (kind != SearchTask::Kind::Tree) return found;
  IntegerOutcome outcome;
  outcome.found = std::move(found);
  outcome.complete = outcome.bounds_hold = outcome.all_infeasible = outcome.enumerated = false;
  return outcome;
}

}  // namespace

Combinations::Combinations(const OptimiseOptions& options, const Deadline& deadline,
                           std::shared_ptr<SearchDesk> desk, std::function<void(SearchedPart)> take)
    : options_(options),
      deadline_(deadline),
      desk_(std::move(desk)),
      take_(std::move(take)),
      count_(desk_->space().parts()) {}

Combinations::~Combinations() = default;

double Combinations::all_errands() const {
  return static_cast<double>(count_) * static_cast<double>(per_part_) *
         static_cast<double>(per_item_);
}

double Combinations::share() const {
  return std::min(1.0, static_cast<double>(given_) / all_errands());
}

std::optional<std::size_t> Combinations::next() {
  for (const auto& part : parts_) {
    for (Item& item : part->items) {
      if (const auto number = next_of(*part, item)) return number;
    }
  }
  while (!(deadline_.passed() && (has_answer_ || !parts_.empty()))) {
    if (!parts_.empty() && open_item(*parts_.back())) {
      return next_of(*parts_.back(), parts_.back()->items.back());
    }
    if (next_part_ == count_) break;
    open_part();
    close_parts();  // one may be without any combination of integers
  }
  return {};
}

void Combinations::open_part() {
  auto part = std::make_unique<Part>();
  SearchedPart& searched = part->searched;
  searched.options = options_at(desk_->space().choices, next_part_);
  searched.problem = desk_->problem(searched.options);
  check(searched.problem, options_);
  is_of_one_ = desk_->space().choices.empty() && !has_integers(searched.problem);
  const auto combinations = integer_combinations(searched.problem);
  if (!is_of_one_) {
    part->kind = combinations ? SearchTask::Kind::Continuous : SearchTask::Kind::Tree;
  }
  part->integers = combinations.value_or(std::vector<std::vector<double>>(1));
  searched.outcome.combinations = part->integers.size();
  if (next_part_++ == 0) per_part_ = std::max<std::size_t>(1, part->integers.size());
  parts_.push_back(std::move(part));
}

bool Combinations::open_item(Part& part) {
  if (part.next_item == part.integers.size()) return false;
  const bool is_first = given_ == 0;
  Item& item = part.items.emplace_back();
  item.kind = part.kind;
  item.integers = part.integers[part.next_item++];
  if (item.kind == SearchTask::Kind::Tree) return true;
  const Problem& whole = part.searched.problem;
  const int planned = item.integers.empty()
                          ? planned_starts(whole, options_)
                          : planned_starts(with_integers(whole, item.integers), options_);
  if (planned > 1) item.starts.resize(static_cast<std::size_t>(planned));
  if (is_first) per_item_ = 1 + item.starts.size();
  return true;
}

std::optional<std::size_t> Combinations::next_of(Part& part, Item& item) {
  if (item.is_given) return {};
  if (!item.is_known()) {
    const bool is_begun = !item.starts.front().is_open();
    const auto open = std::find_if(item.starts.begin(), item.starts.end(),
                                   [](const auto& s) { return s.is_open(); });
    const bool goes_on = !(deadline_.passed() && is_begun) && open != item.starts.end();
    if (goes_on) {
      const auto& first = item.starts.front().found;
      open->first = first ? told_of(*first) : guess_;
      open->errand = hand_out({&part, &item, static_cast<std::size_t>(open - item.starts.begin())});
      return open->errand;
    }
    if (item.is_under_way()) return {};
  }
  const bool is_cut = std::any_of(item.starts.begin(), item.starts.end(), [](const auto& s) {
    return s.found && s.found->end == StartEnd::CutShort;
  });
  if (is_cut && item.is_under_way()) return {};  // the others are about to be cut short too
  item.is_given = true;
  return hand_out({&part, &item, {}});
}

std::size_t Combinations::hand_out(const Errand& errand) {
  errands_.emplace(given_, errand);
  return given_++;
}

SearchTask Combinations::task_of(const Errand& errand) const {
  const Item& item = *errand.item;
  SearchTask task{.kind = errand.start ? SearchTask::Kind::OneStart : item.kind,
                  .options = errand.part->searched.options,
                  .integers = item.integers,
                  .how = options_,
                  .tells_progress = bool(options_.progress),
                  .tells_candidates = bool(options_.candidate)};
  task.how.spent = deadline_.spent();
  if (errand.start) {
    task.start = static_cast<int>(*errand.start);
    task.first = item.starts[*errand.start].first;
    return task;
  }
  for (const Item::Start& start : item.starts) {
    if (!start.found) continue;  // only of a search that is cut short
    task.known.push_back(*start.found);
    if (ends_search(*start.found) && start.found->end != StartEnd::CutShort) break;
  }
  return task;
}

std::optional<std::string> Combinations::order(std::size_t number) {
  const auto at = errands_.find(number);
  if (at == errands_.end()) return {};
  return encoded(task_of(at->second));
}

void Combinations::answered(std::size_t number, const std::string& answer) {
  auto decoded = decoded_answer(answer);
  if (!decoded)
    return lost(number, "the process of this search answered with something that is not an answer");
  const auto at = errands_.find(number);
  if (at == errands_.end()) return;  // what nobody waits for any more
  take(errands_.extract(at).mapped(), std::move(*decoded));
}

void Combinations::lost(std::size_t number, const std::string& why) {
  const auto at = errands_.find(number);
  if (at == errands_.end()) return;
  lost_ = why;
  const Errand errand = errands_.extract(at).mapped();
  if (!errand.start) return take(errand, failed(errand.item->kind, options_.solver, why));
  FromStart none;
  none.trail.thrown = why;
  take(errand, std::move(none));
}

void Combinations::take(const Errand& errand, SearchAnswer answer) {
  ++ended_;
  Item& item = *errand.item;
  if (errand.start) return take_start(item, *errand.start, std::get<FromStart>(std::move(answer)));
  item.answer = std::move(answer);
  has_answer_ = true;
  std::erase_if(errands_, [&](const auto& entry) { return entry.second.item == &item; });
  close_parts();
}

/// Behind a start that ends the search none is needed. Where the search is cut short, what others
/// have found counts.
void Combinations::leave_later_starts(Item& item, std::size_t number) {
  if (item.starts[number].found->end == StartEnd::CutShort) return;
  for (std::size_t i = number + 1; i < item.starts.size(); ++i) {
    if (item.starts[i].errand) errands_.erase(*item.starts[i].errand);
  }
  item.starts.resize(number + 1);
}

void Combinations::take_start(Item& item, std::size_t number, FromStart found) {
  Item::Start& start = item.starts[number];
  start.found = std::move(found);
  start.errand.reset();
  if (ends_search(*start.found)) return leave_later_starts(item, number);
  if (number > 0) return;
  guess_ = told_of(*start.found);
  // Those that were begun before that was known, and were told otherwise, begin anew.
  for (std::size_t i = 1; i < item.starts.size(); ++i) {
    Item::Start& other = item.starts[i];
    if (other.first == told_of(*start.found)) continue;
    if (other.errand) errands_.erase(*other.errand);
    other = {};
  }
}

void Combinations::told(std::size_t number, const std::string& news) {
  const auto at = errands_.find(number);
  auto decoded = decoded_news(news);
  if (at == errands_.end() || !decoded) return;
  if (auto* progress = std::get_if<Progress>(&*decoded)) {
    progress->done =
        static_cast<double>(ended_) / std::max(all_errands(), 1.0 + static_cast<double>(ended_));
    if (options_.progress) options_.progress(*progress);
    return;
  }
  Candidate& candidate = std::get<Candidate>(*decoded);
  const Problem& problem = at->second.part->searched.problem;
  candidate.is_best =
      candidate.is_best && (!best_told_ || better(problem, candidate.assessment, *best_told_));
  if (candidate.is_best) best_told_ = candidate.assessment;
  if (options_.candidate) options_.candidate(candidate);
}

void Combinations::close_items(Part& part) {
  IntegerOutcome& outcome = part.searched.outcome;
  for (; !part.items.empty() && part.items.front().answer; part.items.pop_front()) {
    Item& item = part.items.front();
    if (auto* tree = std::get_if<IntegerOutcome>(&*item.answer)) {
      outcome = std::move(*tree);
      continue;
    }
    Found& found = std::get<Found>(*item.answer);
    if (item.kind == SearchTask::Kind::Everywhere) {
      outcome.solved = 1;
      outcome.found = std::move(found);
    } else {
      const Problem& whole = part.searched.problem;
      outcome.add_combination(item.integers.empty() ? whole : with_integers(whole, item.integers),
                              found);
    }
  }
}

void Combinations::close_parts() {
  while (!parts_.empty()) {
    Part& part = *parts_.front();
    close_items(part);
    if (!part.items.empty() || part.next_item < part.integers.size()) return;
    take_(std::move(part.searched));
    parts_.pop_front();
  }
}

void Combinations::end_here() {
  if (!has_answer_ && parts_.empty() && next_part_ < count_) open_part();
  if (!has_answer_ && !parts_.empty() && parts_.front()->items.empty()) open_item(*parts_.front());
  for (const auto& part : parts_) {
    for (Item& item : part->items) {
      if (item.answer || (has_answer_ && !item.has_start())) continue;
      item.answer = desk_->carry_out(task_of({part.get(), &item, {}}), deadline_);
      has_answer_ = true;
    }
    const bool is_whole = part->next_item == part->integers.size() &&
                          std::all_of(part->items.begin(), part->items.end(),
                                      [](const Item& item) { return bool(item.answer); });
    std::erase_if(part->items, [](const Item& item) { return !item.answer; });
    part->next_item = part->integers.size();
    if (!is_whole) part->searched.outcome.complete = false;
  }
  errands_.clear();
  close_parts();
}

}  // namespace camlaw::optim
