// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/search/discrete.h"
#include "optim/search/trail.h"

/// The searches that an answer is made of. A task is plain data, and what it comes to follows from
/// it and the space alone, to the last bit: so it does not matter in which process, when and beside
/// what it is carried out.
namespace camlaw::optim {

struct SearchTask {
  enum class Kind {
    OneStart,    ///< the search from one start: FromStart
    Continuous,  ///< that in the continuous variables, not proved: Found
    Everywhere,  ///< that of the only problem, with a look everywhere: Found
    Tree,        ///< branch and bound over the integer variables: IntegerOutcome
  };
  Kind kind = Kind::Everywhere;
  std::vector<std::size_t> options = {};  ///< the option taken of each choice
  std::vector<double> integers = {};      ///< at which the integer variables are held
  int start = 0;                          ///< of OneStart
  FirstStart first = FirstStart::Led;     ///< as search_one_start() takes it
  std::vector<FromStart> known = {};      ///< starts that need not be searched from again
  OptimiseOptions how = {};
  bool tells_progress = false, tells_candidates = false;
};

using SearchAnswer = std::variant<FromStart, Found, IntegerOutcome>;

/// What is told on the way: how far a search is, or a design that it came to.
using SearchNews = std::variant<Progress, Candidate>;

std::string encoded(const SearchTask& task);
/// None where the bytes are not those of one answer, and of one news.
std::optional<SearchAnswer> decoded_answer(std::string_view bytes);
std::optional<SearchNews> decoded_news(std::string_view bytes);

/// The problems of a space, as whoever searches in it needs them.
class SearchDesk {
 public:
  explicit SearchDesk(ProblemSpace space) : space_(std::move(space)) {}

  const ProblemSpace& space() const { return space_; }
  /// Made once for tasks of the same options that follow one another.
  const Problem& problem(const std::vector<std::size_t>& options);
  SearchAnswer carry_out(const SearchTask& task, const Deadline& deadline);

 private:
  ProblemSpace space_;
  std::vector<std::size_t> options_;
  std::optional<Problem> problem_;
};

/// Carries out tasks as a worker does.
Service search_service(std::shared_ptr<SearchDesk> desk);

}  // namespace camlaw::optim
