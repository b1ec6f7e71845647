// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/search/options_bytes.h"
#include "optim/search/search_task.h"

namespace camlaw::optim {

/// What came of one combination of choices.
struct SearchedPart {
  std::vector<std::size_t> options;
  Problem problem;
  IntegerOutcome outcome;
};

/// All searches of a space as errands: from each start of each combination of choices and integer
/// values by itself, then the rest of the search in that combination. What they are, and in which
/// order their answers count, follows from the space and from the answers, never from who was done
/// first: so the answer is the same however many carry them out.
class Combinations final : public Errands {
 public:
  /// `take` gets the parts one after the other, each as soon as those before it are there. Throws,
  /// as next() does, std::invalid_argument for problems that cannot be searched.
  Combinations(const OptimiseOptions& options, const Deadline& deadline,
               std::shared_ptr<SearchDesk> desk, std::function<void(SearchedPart)> take);
  ~Combinations() override;

  std::optional<std::size_t> next() override;
  std::optional<std::string> order(std::size_t number) override;
  void answered(std::size_t number, const std::string& answer) override;
  void lost(std::size_t number, const std::string& why) override;
  void told(std::size_t number, const std::string& news) override;
  double share() const override;
  const std::atomic<bool>* stop() const override { return options_.stop; }
  std::string confined() const override { return why_confined(options_); }
  std::optional<double> farewell() const override { return kFarewell; }
  bool is_done() const override { return parts_.empty() && next_part_ == count_; }

  /// After the run: ends in haste what was cut short, so that there is one answer at least.
  void end_here();

  /// Whether there is nothing to choose, so that the only part is the answer.
  bool is_of_one() const { return is_of_one_; }
  /// Parts that were not begun.
  std::size_t not_looked_at() const { return count_ - next_part_; }
  /// How the last process died that did; empty while none has.
  const std::string& lost() const { return lost_; }

 private:
  static constexpr double kFarewell = 0.25;  // s: a search looks at its stop flag all the time

  struct Item;
  struct Part;
  /// The search from a start, or all the rest of an item.
  struct Errand {
    Part* part;
    Item* item;
    std::optional<std::size_t> start;
  };

  double all_errands() const;
  void open_part();
  bool open_item(Part& part);
  std::optional<std::size_t> next_of(Part& part, Item& item);
  std::size_t hand_out(const Errand& errand);
  SearchTask task_of(const Errand& errand) const;
  void take(const Errand& errand, SearchAnswer answer);
  void take_start(Item& item, std::size_t start, FromStart found);
  void leave_later_starts(Item& item, std::size_t number);
  void close_items(Part& part);
  void close_parts();

  const OptimiseOptions& options_;
  const Deadline& deadline_;
  std::shared_ptr<SearchDesk> desk_;
  std::function<void(SearchedPart)> take_;
  std::size_t count_, next_part_ = 0;
  bool is_of_one_ = false;
  std::deque<std::unique_ptr<Part>> parts_;  ///< that are under way, in order
  std::map<std::size_t, Errand> errands_;    ///< that are under way
  std::size_t given_ = 0;                    ///< errands that were handed out so far
  std::size_t per_item_ = 1, per_part_ = 1;  ///< errands and items of the first one
  std::size_t ended_ = 0;                    ///< errands
  bool has_answer_ = false;                  ///< of one item at least
  /// What a first start is taken to lead to until it is known: what the last one has, as its
  /// neighbours often do. A wrong guess costs time alone.
  FirstStart guess_ = FirstStart::Led;
  std::string lost_;
  std::optional<Assessment> best_told_;  ///< of the candidates
};

}  // namespace camlaw::optim
